// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Collects faces with a subject and an expression each, then saves them as one safetensors file: vertices f32 [s,
    /// n, 3], subject i32 [s], expression i32 [s], triangles u32 [m, 3]. Externally synchronized.</summary>
    public sealed unsafe class DatasetWriter : NativeObject
    {
        internal DatasetWriter(IntPtr owned) : base(owned, at => Functions.mien_dataset_writer_release(at)) { }

        /// <summary>Starts a dataset in the topology of a mesh.</summary>
        /// <param name="topology">its triangles and vertex count hold for all faces.</param>
        /// <param name="expressionNames">expression_count UTF-8 names. One should be "neutral".</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_dataset_writer_create()</remarks>
        public static DatasetWriter Create(Session session, Mesh topology, IReadOnlyList<string> expressionNames)
        {
            using (var call = new Call())
            {
                call.Required(expressionNames, "expression_names");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var topologyAt = call.Use(topology);
                var expressionCount = call.Rows(expressionNames, 1, "expression_names");
                var expressionNamesAt = call.Texts(expressionNames);
                var outAt = call.Room(8);
                call.Check(Functions.mien_dataset_writer_create(sessionAt, topologyAt, expressionNamesAt, (uint)expressionCount, outAt, call.Error));
                return call.Keep(new DatasetWriter(call.Pointer(outAt)));
            }
        }

        /// <summary>Adds one face; its positions are copied.</summary>
        /// <param name="positions">#V x 3, F32 or F64, mm.</param>
        /// <param name="subject">any number that names the person.</param>
        /// <param name="expression">index into the expression names.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not
        /// finite), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_dataset_writer_add()</remarks>
        public void Add(Values positions, int subject, int expression)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var writerAt = call.Use(this);
                var positionsAt = call.View(positions, 3, "positions");
                call.Check(Functions.mien_dataset_writer_add(writerAt, positionsAt, subject, expression, call.Error));
            }
        }

        /// <summary>Writes all faces added so far. Atomic; more may be added and saved again.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no face), MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_dataset_writer_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                call.Lock(this);
                var sessionAt = call.Use(session);
                var writerAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_dataset_writer_save(sessionAt, writerAt, pathAt, call.Error));
            }
        }
    }
}

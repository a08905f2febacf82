// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Mean and deviation of each measurement over the people of a dataset. Immutable: share freely.</summary>
    public sealed unsafe class Norms : NativeObject
    {
        internal Norms(IntPtr owned) : base(owned, at => Functions.mien_norms_release(at)) { }

        /// <summary>Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset and
        /// for faces in its topology: the same landmark lies elsewhere on another template.</summary>
        /// <param name="datasetPath">faces of ten people or more.</param>
        /// <param name="landmarks">vertices of the dataset's faces.</param>
        /// <param name="options">may be left out; progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are no vertices),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its landmarks),
        /// MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_norms_create()</remarks>
        public static Norms Create(Session session, string datasetPath, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var landmarksAt = call.Use(landmarks);
                var optionsAt = (options ?? new AnthropometryOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_norms_create(sessionAt, datasetPathAt, landmarksAt, optionsAt, outAt, call.Error));
                return call.Keep(new Norms(call.Pointer(outAt)));
            }
        }

        /// <summary>Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset and
        /// for faces in its topology: the same landmark lies elsewhere on another template.</summary>
        /// <param name="datasetPath">faces of ten people or more.</param>
        /// <param name="landmarks">vertices of the dataset's faces.</param>
        /// <param name="options">may be left out; progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are no vertices),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its landmarks),
        /// MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_norms_create()</remarks>
        public static Task<Norms> CreateAsync(Session session, string datasetPath, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Create(session, datasetPath, landmarks, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Reads norms that mien_norms_save() wrote, or that a host wrote from the literature: {"norms": {"n-gn": {"mean":
        /// 121.3, "sd": 6.8, "people": 109}}}.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a norm of fewer than ten people, or given twice), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_norms_load()</remarks>
        public static Norms Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_norms_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Norms(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes norms as JSON. Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_norms_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var normsAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_norms_save(sessionAt, normsAt, pathAt, call.Error));
            }
        }

        /// <summary>The norms as JSON text, as mien_norms_save() writes it.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_norms_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var normsAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_norms_get_json(normsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}

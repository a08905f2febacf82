// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A trained representation of faces: numbers for learning, with their exact inverse. Immutable: share freely.</summary>
    public sealed unsafe class Representation : NativeObject
    {
        internal Representation(IntPtr owned) : base(owned, at => Functions.mien_representation_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Representation Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_representation_retain(at);
                return new Representation(at);
            }
        }

        /// <summary>mien_representation_train_with_options() without progress and cancel.</summary>
        /// <param name="datasetPath">a dataset file.</param>
        /// <param name="kind">MIEN_FEATURES_...</param>
        /// <param name="neutralOnly">1: only the faces marked neutral; 0: all.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind, neutral_only), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_train()</remarks>
        public static Representation Train(Session session, string datasetPath, Features kind, int neutralOnly)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_train(sessionAt, datasetPathAt, (int)kind, neutralOnly, outAt, call.Error));
                return call.Keep(new Representation(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.</summary>
        /// <param name="datasetPath">a dataset file.</param>
        /// <param name="kind">MIEN_FEATURES_...</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind, neutral_only), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_representation_train_with_options()</remarks>
        public static Representation TrainWithOptions(Session session, string datasetPath, Features kind, RepresentationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new RepresentationOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_train_with_options(sessionAt, datasetPathAt, (int)kind, optionsAt, outAt, call.Error));
                return call.Keep(new Representation(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.</summary>
        /// <param name="datasetPath">a dataset file.</param>
        /// <param name="kind">MIEN_FEATURES_...</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind, neutral_only), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_representation_train_with_options()</remarks>
        public static Task<Representation> TrainWithOptionsAsync(Session session, string datasetPath, Features kind, RepresentationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => TrainWithOptions(session, datasetPath, kind, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Opens a representation file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_load()</remarks>
        public static Representation Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Representation(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a representation file (safetensors). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var representationAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_representation_save(sessionAt, representationAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and of features a vertex.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_representation_get_counts()</remarks>
        public RepresentationCounts GetCounts()
        {
            using (var call = new Call())
            {
                var representationAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var channelCountAt = call.Room(8);
                call.Check(Functions.mien_representation_get_counts(representationAt, vertexCountAt, channelCountAt, call.Error));
                return new RepresentationCounts(*(ulong*)vertexCountAt, *(ulong*)channelCountAt);
            }
        }

        /// <summary>The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count only.</summary>
        /// <param name="face">#V vertices, mm, anywhere.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_encode()</remarks>
        public RepresentationEncode Encode(Session session, Mesh face)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var representationAt = call.Use(this);
                var faceAt = call.Use(face);
                var motionAt = call.Room(12 * 8);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity((long)this.GetCounts().ChannelCount * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * (long)this.GetCounts().ChannelCount * 8);
                } while ((capacity = call.More(Functions.mien_representation_encode(sessionAt, representationAt, faceAt, motionAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new RepresentationEncode(call.ReadDoubles(motionAt, 12), call.ReadDoubles(dstAt, rows * (long)this.GetCounts().ChannelCount));
            }
        }

        /// <summary>The face that has these features.</summary>
        /// <param name="features">row_count x channel_count row-major float64.</param>
        /// <param name="motion">may be left out: the mean's frame; 12 float64 of mien_representation_encode(), which is undone.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid), MIEN_E_MISMATCH (row_count),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_decode()</remarks>
        public Mesh Decode(Session session, double[] features, double[] motion = null)
        {
            using (var call = new Call())
            {
                call.Required(features, "features");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var representationAt = call.Use(this);
                var rowCount = call.Rows(features, (long)this.GetCounts().ChannelCount, "features");
                var featuresAt = call.Array(features);
                call.Agree("motion", call.Rows(motion, 1, "motion"), 12);
                var motionAt = call.Array(motion);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_decode(sessionAt, representationAt, featuresAt, (ulong)rowCount, motionAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }
}

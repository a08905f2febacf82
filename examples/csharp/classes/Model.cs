// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A template with its modes of deformation: u(x) = mean(x) + sum_j basis_j(x) a_j + sum_k mode_k(x) c_k, a and c
    /// standard normal; basis_j are scalar and serve x, y and z, mode_k come from faces. Built or loaded once.
    /// Immutable: share freely between threads.</summary>
    public sealed unsafe class Model : NativeObject
    {
        internal Model(IntPtr owned) : base(owned, at => Functions.mien_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Model Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_model_retain(at);
                return new Model(at);
            }
        }

        /// <summary>Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean and the
        /// principal modes of its faces.</summary>
        /// <param name="templateMesh">#V x 3, mm, with triangles for the surface kernels.</param>
        /// <param name="options">may be left out: geodesic kernel of 20 mm, 999 modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not symmetric),
        /// MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_build()</remarks>
        public static Model Build(Session session, Mesh templateMesh, ModelOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var templateMeshAt = call.Use(templateMesh);
                var optionsAt = (options ?? new ModelOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_build(sessionAt, templateMeshAt, optionsAt, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean and the
        /// principal modes of its faces.</summary>
        /// <param name="templateMesh">#V x 3, mm, with triangles for the surface kernels.</param>
        /// <param name="options">may be left out: geodesic kernel of 20 mm, 999 modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not symmetric),
        /// MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_build()</remarks>
        public static Task<Model> BuildAsync(Session session, Mesh templateMesh, ModelOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Build(session, templateMesh, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Loads a model file through a memory map and checks all of it: structure, hash, finite values.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_load()</remarks>
        public static Model Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a model from the bytes of a model file that the host holds in memory, e.g. as a resource of its program.
        /// They are copied and checked like a file.</summary>
        /// <param name="data">size bytes, any alignment; not read after the call.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_load_memory()</remarks>
        public static Model LoadMemory(Session session, byte[] data)
        {
            using (var call = new Call())
            {
                call.Required(data, "data");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var size = call.Rows(data, 1, "data");
                var dataAt = call.Array(data);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_load_memory(sessionAt, dataAt, (ulong)size, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a model file that the host trusts: its structure is checked, its hash and values are not.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION,
        /// MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_load_trusted()</remarks>
        public static Model LoadTrusted(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_load_trusted(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a model file (safetensors). Atomic: a full disk or a crash leaves an old file whole.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and modes.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_model_get_counts()</remarks>
        public ModelCounts GetCounts()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var scalarModesAt = call.Room(8);
                var vectorModesAt = call.Room(8);
                call.Check(Functions.mien_model_get_counts(modelAt, vertexCountAt, scalarModesAt, vectorModesAt, call.Error));
                return new ModelCounts(*(ulong*)vertexCountAt, *(ulong*)scalarModesAt, *(ulong*)vectorModesAt);
            }
        }

        /// <summary>What the model is: counts, kernel and its settings, rank, variance explained, largest pointwise variance error,
        /// clipped negative mass, names of landmarks and zones. As JSON text by the two-call protocol.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_model_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_model_get_json(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Prior variance of each coordinate of each vertex, #V x 3 float64, mm^2, modes of both kinds together.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_get_variance()</remarks>
        public double[] GetVariance()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_model_get_variance(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * 3);
            }
        }

        /// <summary>A random face: the template moved by the mean and `strength` times a draw from the prior. Face `index` of `seed`
        /// is the same whatever else was drawn; strength 0 gives the mean.</summary>
        /// <param name="seed">any number.</param>
        /// <param name="index">any number.</param>
        /// <param name="strength">&gt;= 0; 1: the prior itself.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_sample()</remarks>
        public Mesh Sample(Session session, ulong seed, ulong index, double strength)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_sample(sessionAt, modelAt, seed, index, strength, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The posterior model: what the template may still do once landmarks were seen. It is a model like any other, with
        /// a mean of its own, and may be conditioned again.</summary>
        /// <param name="observations">observation_count of them.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (name), MIEN_E_UNSUPPORTED_OPTION (mirror
        /// correlation), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_condition()</remarks>
        public Model Condition(Session session, IReadOnlyList<LandmarkObservation> observations)
        {
            using (var call = new Call())
            {
                call.Required(observations, "observations");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var observationCount = call.Rows(observations, 1, "observations");
                var observationsAt = call.Records(observations, sizeof(Native.LandmarkObservation));
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_condition(sessionAt, modelAt, observationsAt, (ulong)observationCount, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of levels
        /// that is asked for, and reports what is left.</summary>
        /// <param name="templateMesh">#V x 3, mm.</param>
        /// <param name="dataset">UTF-8 path of a dataset in the template's correspondence, its faces may cover only the template's first
        /// vertices.</param>
        /// <param name="options">sigmas_mm at least.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_tune()</remarks>
        public static Tuning Tune(Session session, Mesh templateMesh, string dataset, TuneOptions options, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var templateMeshAt = call.Use(templateMesh);
                var datasetAt = call.Text(dataset);
                var optionsAt = call.Required(options, "options").Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_tune(sessionAt, templateMeshAt, datasetAt, optionsAt, outAt, call.Error));
                return call.Keep(new Tuning(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of levels
        /// that is asked for, and reports what is left.</summary>
        /// <param name="templateMesh">#V x 3, mm.</param>
        /// <param name="dataset">UTF-8 path of a dataset in the template's correspondence, its faces may cover only the template's first
        /// vertices.</param>
        /// <param name="options">sigmas_mm at least.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_tune()</remarks>
        public static Task<Tuning> TuneAsync(Session session, Mesh templateMesh, string dataset, TuneOptions options, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Tune(session, templateMesh, dataset, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The template.</summary>
        /// <exception cref="MienException">none; null for a null or wrong handle</exception>
        /// <remarks>C: mien_model_mesh()</remarks>
        public Mesh GetMesh()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var lent = Functions.mien_model_mesh(modelAt);
                Functions.mien_mesh_retain(lent);
                return new Mesh(lent);
            }
        }

        /// <summary>The landmarks of a model: names and vertices of its template.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_get_landmarks()</remarks>
        public Landmarks GetLandmarks()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_get_landmarks(modelAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>The zones of a model: names and vertices of its template.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_get_zones()</remarks>
        public Zones GetZones()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_get_zones(modelAt, outAt, call.Error));
                return call.Keep(new Zones(call.Pointer(outAt)));
            }
        }

        /// <summary>The coefficients that bring the template nearest to a face in its correspondence: least squares, weighted per
        /// vertex, with a ridge.</summary>
        /// <param name="target">mm, in the template's frame unless options.align; the vertices of the template, or its first ones.</param>
        /// <param name="options">may be left out: no weights, a ridge of 1 mm^2, all modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertices, weights), MIEN_E_INVALID_MESH,
        /// MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_fit()</remarks>
        public double[] Fit(Session session, Mesh target, ModelFitOptions options = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var targetAt = call.Use(target);
                var optionsAt = call.Record(options, sizeof(Native.ModelFitOptions), true, "options");
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_model_fit(sessionAt, modelAt, targetAt, optionsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>The face that has these coefficients: the template moved by the mean and the modes.</summary>
        /// <param name="coefficients">coefficient_count finite values</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (coefficient_count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_synthesize()</remarks>
        public Mesh Synthesize(Session session, double[] coefficients = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var coefficientCount = call.Rows(coefficients, 1, "coefficients");
                var coefficientsAt = call.Array(coefficients);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_synthesize(sessionAt, modelAt, coefficientsAt, (ulong)coefficientCount, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }
}

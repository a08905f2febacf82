// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A trained score: partial least squares on displacement and curvature. Immutable: share freely.</summary>
    public sealed unsafe class ScoreModel : NativeObject
    {
        internal ScoreModel(IntPtr owned) : base(owned, at => Functions.mien_score_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public ScoreModel Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_score_model_retain(at);
                return new ScoreModel(at);
            }
        }

        /// <summary>Learns a score from graded faces in correspondence.</summary>
        /// <param name="datasetPath">a dataset file, faces of one subject share a fold.</param>
        /// <param name="grades">grade_count values, one per face, NaN: not graded.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces), MIEN_E_MISMATCH (counts,
        /// zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_score_model_train()</remarks>
        public static ScoreModel Train(Session session, string datasetPath, double[] grades, ScoreOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(grades, "grades");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var gradeCount = call.Rows(grades, 1, "grades");
                var gradesAt = call.Array(grades);
                var optionsAt = (options ?? new ScoreOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_score_model_train(sessionAt, datasetPathAt, gradesAt, (ulong)gradeCount, optionsAt, outAt, call.Error));
                return call.Keep(new ScoreModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns a score from graded faces in correspondence.</summary>
        /// <param name="datasetPath">a dataset file, faces of one subject share a fold.</param>
        /// <param name="grades">grade_count values, one per face, NaN: not graded.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces), MIEN_E_MISMATCH (counts,
        /// zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_score_model_train()</remarks>
        public static Task<ScoreModel> TrainAsync(Session session, string datasetPath, double[] grades, ScoreOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Train(session, datasetPath, grades, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Reads a score model file, which is treated as hostile.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_load()</remarks>
        public static ScoreModel Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_score_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new ScoreModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a score model as a safetensors file, atomically.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_score_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>The score of a face with its 95 % prediction interval.</summary>
        /// <param name="face">in the model's topology, mm, anywhere in space.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_predict()</remarks>
        public ScorePrediction Predict(Session session, Mesh face)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var faceAt = call.Use(face);
                var outAt = call.Sized(sizeof(Native.ScorePrediction));
                call.Check(Functions.mien_score_model_predict(sessionAt, modelAt, faceAt, outAt, call.Error));
                return ScorePrediction.Read(call, outAt);
            }
        }

        /// <summary>The face as it would look with another score.</summary>
        /// <param name="target">the score wanted, finite.</param>
        /// <param name="face">may be left out: the training's mean face.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_simulate()</remarks>
        public Mesh Simulate(Session session, double target, Mesh face = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var faceAt = call.UseOrNull(face);
                var outAt = call.Room(8);
                call.Check(Functions.mien_score_model_simulate(sessionAt, modelAt, faceAt, target, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A latent variable on the template: how far each vertex moves, mm, at one standard deviation of it. Component -1:
        /// per unit of score.</summary>
        /// <param name="component">0 .. components - 1, or -1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such component)</exception>
        /// <remarks>C: mien_score_model_get_latent()</remarks>
        public double[] GetLatent(int component)
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_score_model_get_latent(modelAt, component, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>What was learned as JSON: components, cross-validated errors, held-out predictions and focus_places (how many
        /// places the focus takes a face for; 0: none), which are not kept in files.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_get_json()</remarks>
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
                } while ((capacity = call.More(Functions.mien_score_model_get_json(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}

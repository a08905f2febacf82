// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Predicts one expression of a person from the neutral face. Immutable: share freely.</summary>
    public sealed unsafe class BlendshapeModel : NativeObject
    {
        internal BlendshapeModel(IntPtr owned) : base(owned, at => Functions.mien_blendshape_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public BlendshapeModel Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_blendshape_model_retain(at);
                return new BlendshapeModel(at);
            }
        }

        /// <summary>Learns to predict one expression from the neutral face, on every subject of a dataset that has both.</summary>
        /// <param name="datasetPath">a dataset file whose names include "neutral".</param>
        /// <param name="expression">a name of the dataset.</param>
        /// <param name="options">may be left out.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge), MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_train()</remarks>
        public static BlendshapeModel Train(Session session, string datasetPath, string expression, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var expressionAt = call.Text(expression);
                var optionsAt = (options ?? new BlendshapeOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_train(sessionAt, datasetPathAt, expressionAt, optionsAt, outAt, call.Error));
                return call.Keep(new BlendshapeModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns to predict one expression from the neutral face, on every subject of a dataset that has both.</summary>
        /// <param name="datasetPath">a dataset file whose names include "neutral".</param>
        /// <param name="expression">a name of the dataset.</param>
        /// <param name="options">may be left out.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge), MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_train()</remarks>
        public static Task<BlendshapeModel> TrainAsync(Session session, string datasetPath, string expression, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Train(session, datasetPath, expression, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Opens a blendshape model file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_load()</remarks>
        public static BlendshapeModel Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new BlendshapeModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a blendshape model file (safetensors). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_blendshape_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>The mean of the neutral training faces, centred: the mesh that a basis for this model is built on.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_get_mean()</remarks>
        public Mesh GetMean()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_get_mean(modelAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A person's expression from the neutral face, in its frame.</summary>
        /// <param name="k">low frequencies from the coordinates' prediction, high ones from the deformations'; 0 to the basis' modes, #V or
        /// more: coordinates alone.</param>
        /// <param name="neutral">#V vertices, mm.</param>
        /// <param name="basis">may be left out: then k = 0 gives the deformations' prediction, any other k the coordinates'.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_predict()</remarks>
        public Mesh Predict(Session session, ulong k, Mesh neutral, SpectralBasis basis = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var basisAt = call.UseOrNull(basis);
                var neutralAt = call.Use(neutral);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_predict(sessionAt, modelAt, basisAt, k, neutralAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Tries values of k on a dataset's subjects that the model was not trained on.</summary>
        /// <param name="datasetPath">subjects with a neutral face and the expression.</param>
        /// <param name="candidates">candidate_count values of k; above the basis' modes: coordinates alone.</param>
        /// <param name="options">may be left out; its ridge is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression), MIEN_E_MISMATCH, MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_search()</remarks>
        public BandChoice[] Search(Session session, SpectralBasis basis, string datasetPath, string expression, ulong[] candidates, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(candidates, "candidates");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var basisAt = call.Use(basis);
                var datasetPathAt = call.Text(datasetPath);
                var expressionAt = call.Text(expression);
                var candidateCount = call.Rows(candidates, 1, "candidates");
                var candidatesAt = call.Array(candidates);
                var optionsAt = (options ?? new BlendshapeOptions()).Write(call, progress, cancellationToken);
                var choicesAt = call.Room(candidateCount * sizeof(Native.BandChoice));
                call.Check(Functions.mien_blendshape_model_search(sessionAt, modelAt, basisAt, datasetPathAt, expressionAt, candidatesAt, (uint)candidateCount, optionsAt, choicesAt, call.Error));
                return call.ReadRecords(choicesAt, candidateCount, sizeof(Native.BandChoice), BandChoice.Read);
            }
        }

        /// <summary>Tries values of k on a dataset's subjects that the model was not trained on.</summary>
        /// <param name="datasetPath">subjects with a neutral face and the expression.</param>
        /// <param name="candidates">candidate_count values of k; above the basis' modes: coordinates alone.</param>
        /// <param name="options">may be left out; its ridge is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression), MIEN_E_MISMATCH, MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_search()</remarks>
        public Task<BandChoice[]> SearchAsync(Session session, SpectralBasis basis, string datasetPath, string expression, ulong[] candidates, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Search(session, basis, datasetPath, expression, candidates, options, progress, cancellationToken), cancellationToken);
        }
    }
}

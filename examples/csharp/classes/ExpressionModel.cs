// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What was learned of faces and expressions: an identity subspace, an expression subspace, a prior of both.
    /// Immutable: share freely between threads.</summary>
    public sealed unsafe class ExpressionModel : NativeObject
    {
        internal ExpressionModel(IntPtr owned) : base(owned, at => Functions.mien_expression_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public ExpressionModel Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_expression_model_retain(at);
                return new ExpressionModel(at);
            }
        }

        /// <summary>Loads a model file. The file is treated as hostile; the modes stay in the mapped file.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_load()</remarks>
        public static ExpressionModel Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a model from the bytes of a model file that the host holds in memory. They are copied and checked like a
        /// file.</summary>
        /// <param name="data">size bytes, any alignment; not read after the call.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_load_memory()</remarks>
        public static ExpressionModel LoadMemory(Session session, byte[] data)
        {
            using (var call = new Call())
            {
                call.Required(data, "data");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var size = call.Rows(data, 1, "data");
                var dataAt = call.Array(data);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_load_memory(sessionAt, dataAt, (ulong)size, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a model file (safetensors, kind "mien-expression-model"). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_expression_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and modes.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_expression_model_get_counts()</remarks>
        public ExpressionModelCounts GetCounts()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var identityModesAt = call.Room(8);
                var expressionModesAt = call.Room(8);
                call.Check(Functions.mien_expression_model_get_counts(modelAt, vertexCountAt, identityModesAt, expressionModesAt, call.Error));
                return new ExpressionModelCounts(*(ulong*)vertexCountAt, *(uint*)identityModesAt, *(uint*)expressionModesAt);
            }
        }

        /// <summary>What the model is, and after training how the training went, as a JSON object: sizes, expressions, noise levels,
        /// iterations, orthogonality score per number of components, explained shares.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_expression_model_get_json()</remarks>
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
                } while ((capacity = call.More(Functions.mien_expression_model_get_json(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>A face made from coordinates: mean + identity modes x identity + expression modes x expression.</summary>
        /// <param name="identity">count identity_modes, F32 or F64, mm; count 0 (or null): the mean identity.</param>
        /// <param name="expression">count expression_modes, F32 or F64, mm; count 0 (or null): neutral.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_synthesize()</remarks>
        public Mesh Synthesize(Session session, Values identity = null, Values expression = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var identityAt = call.ViewOrNull(identity, 1, "identity");
                var expressionAt = call.ViewOrNull(expression, 1, "expression");
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_synthesize(sessionAt, modelAt, identityAt, expressionAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A random face of the model: identity coordinates from their Gaussian, expression coordinates from the prior of
        /// one expression.</summary>
        /// <param name="seed">any number; the same seed gives the same face on every machine.</param>
        /// <param name="expression">name of an expression of the model, "neutral", "any" (all expressions together), or null: neutral without any
        /// expression.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_sample()</remarks>
        public Mesh Sample(Session session, ulong seed, string expression = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var expressionAt = call.TextOrNull(expression);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_sample(sessionAt, modelAt, seed, expressionAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Puts the expression of one neutralized face onto another one's neutral face.</summary>
        /// <param name="source">whose expression is taken.</param>
        /// <param name="target">whose neutral face receives it.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (another model), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_transfer()</remarks>
        public Mesh Transfer(Session session, Neutralization source, Neutralization target)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var sourceAt = call.Use(source);
                var targetAt = call.Use(target);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_transfer(sessionAt, modelAt, sourceAt, targetAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The faces are
        /// read through a memory map in blocks, so the file may be larger than memory. Subjects without a neutral face are
        /// left out; missing expressions and repeated captures are fine.</summary>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn), MIEN_E_UNSUPPORTED_OPTION (a method
        /// that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_expression_model_train()</remarks>
        public static ExpressionModel Train(Session session, string datasetPath, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new TrainOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_train(sessionAt, datasetPathAt, optionsAt, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The faces are
        /// read through a memory map in blocks, so the file may be larger than memory. Subjects without a neutral face are
        /// left out; missing expressions and repeated captures are fine.</summary>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn), MIEN_E_UNSUPPORTED_OPTION (a method
        /// that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_expression_model_train()</remarks>
        public static Task<ExpressionModel> TrainAsync(Session session, string datasetPath, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Train(session, datasetPath, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut its
        /// rank.</summary>
        /// <param name="shardPaths">shard_count UTF-8 paths.</param>
        /// <param name="options">may be left out: defaults. stable_vertices must be empty: the shards' own count.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different topologies, expression
        /// names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards)</exception>
        /// <remarks>C: mien_expression_model_merge()</remarks>
        public static ExpressionModel Merge(Session session, IReadOnlyList<string> shardPaths, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(shardPaths, "shard_paths");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var shardCount = call.Rows(shardPaths, 1, "shard_paths");
                var shardPathsAt = call.Texts(shardPaths);
                var optionsAt = (options ?? new TrainOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_merge(sessionAt, shardPathsAt, (uint)shardCount, optionsAt, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut its
        /// rank.</summary>
        /// <param name="shardPaths">shard_count UTF-8 paths.</param>
        /// <param name="options">may be left out: defaults. stable_vertices must be empty: the shards' own count.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different topologies, expression
        /// names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards)</exception>
        /// <remarks>C: mien_expression_model_merge()</remarks>
        public static Task<ExpressionModel> MergeAsync(Session session, IReadOnlyList<string> shardPaths, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Merge(session, shardPaths, options, progress, cancellationToken), cancellationToken);
        }
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * What was learned of faces and expressions: an identity subspace, an expression subspace, a prior of both.
 * Immutable: share freely between threads.
 */
public final class ExpressionModel extends NativeObject {
    ExpressionModel(long owned) { super(owned, Raw.GET::mien_expression_model_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public ExpressionModel share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_expression_model_retain(at);
            return new ExpressionModel(at);
        }
    }

    /**
     * Loads a model file. The file is treated as hostile; the modes stay in the mapped file. C:
     * mien_expression_model_load().
     * @throws MienException MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION,
     * MIEN_E_CORRUPT, MIEN_E_NO_MEMORY
     */
    public static ExpressionModel load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new ExpressionModel(call.pointer(outAt)));
        }
    }

    /**
     * Loads a model from the bytes of a model file that the host holds in memory. They are copied and checked
     * like a file. C: mien_expression_model_load_memory().
     * @param data size bytes, any alignment; not read after the call.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
     * MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static ExpressionModel loadMemory(Session session, byte[] data) {
        try (Call call = new Call()) {
            call.required(data, "data");
            call.lock(session);
            var sessionAt = call.use(session);
            var size = call.rows(data, 1, "data");
            var dataAt = call.array(data);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_load_memory(Memory.address(sessionAt), Memory.address(dataAt), size, Memory.address(outAt), call.error()));
            return call.keep(new ExpressionModel(call.pointer(outAt)));
        }
    }

    /**
     * Writes a model file (safetensors, kind "mien-expression-model"). Atomic. C: mien_expression_model_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_expression_model_save(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Numbers of vertices and modes. C: mien_expression_model_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public ExpressionModelCounts counts() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var vertexCountAt = call.room(8);
            var identityModesAt = call.room(8);
            var expressionModesAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_get_counts(Memory.address(modelAt), Memory.address(vertexCountAt), Memory.address(identityModesAt), Memory.address(expressionModesAt), call.error()));
            return new ExpressionModelCounts(vertexCountAt.bytes.getLong(0), identityModesAt.bytes.getInt(0), expressionModesAt.bytes.getInt(0));
        }
    }

    /**
     * What the model is, and after training how the training went, as a JSON object: sizes, expressions, noise
     * levels, iterations, orthogonality score per number of components, explained shares. C:
     * mien_expression_model_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public String json() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_expression_model_get_json(Memory.address(modelAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * A face made from coordinates: mean + identity modes x identity + expression modes x expression. C:
     * mien_expression_model_synthesize().
     * @param identity count identity_modes, F32 or F64, mm; count 0 (or null): the mean identity.
     * @param expression count expression_modes, F32 or F64, mm; count 0 (or null): neutral.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts),
     * MIEN_E_NO_MEMORY
     */
    public Mesh synthesize(Session session, Values identity, Values expression) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var identityAt = call.viewOrNull(identity, 1, "identity");
            var expressionAt = call.viewOrNull(expression, 1, "expression");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_synthesize(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(identityAt), Memory.address(expressionAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * A face made from coordinates: mean + identity modes x identity + expression modes x expression. All else as
     * by default.
     */
    public Mesh synthesize(Session session) {
        return synthesize(session, null, null);
    }

    /**
     * A random face of the model: identity coordinates from their Gaussian, expression coordinates from the prior
     * of one expression. C: mien_expression_model_sample().
     * @param seed any number; the same seed gives the same face on every machine.
     * @param expression name of an expression of the model, "neutral", "any" (all expressions together), or null:
     * neutral without any expression.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY
     */
    public Mesh sample(Session session, long seed, String expression) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var expressionAt = call.textOrNull(expression);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_sample(Memory.address(sessionAt), Memory.address(modelAt), seed, Memory.address(expressionAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * A random face of the model: identity coordinates from their Gaussian, expression coordinates from the prior
     * of one expression. All else as by default.
     */
    public Mesh sample(Session session, long seed) {
        return sample(session, seed, null);
    }

    /**
     * Puts the expression of one neutralized face onto another one's neutral face. C:
     * mien_expression_model_transfer().
     * @param source whose expression is taken.
     * @param target whose neutral face receives it.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (another model), MIEN_E_NO_MEMORY
     */
    public Mesh transfer(Session session, Neutralization source, Neutralization target) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var sourceAt = call.use(source);
            var targetAt = call.use(target);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_transfer(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(sourceAt), Memory.address(targetAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The
     * faces are read through a memory map in blocks, so the file may be larger than memory. Subjects without a
     * neutral face are left out; missing expressions and repeated captures are fine. C:
     * mien_expression_model_train().
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn),
     * MIEN_E_UNSUPPORTED_OPTION (a method that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED
     */
    public static ExpressionModel train(Session session, String datasetPath, TrainOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var datasetPathAt = call.text(datasetPath);
            var optionsAt = (options == null ? new TrainOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_train(Memory.address(sessionAt), Memory.address(datasetPathAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new ExpressionModel(call.pointer(outAt)));
        }
    }

    /**
     * Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The
     * faces are read through a memory map in blocks, so the file may be larger than memory. Subjects without a
     * neutral face are left out; missing expressions and repeated captures are fine. All else as by default.
     */
    public static ExpressionModel train(Session session, String datasetPath) {
        return train(session, datasetPath, null, null, null);
    }

    /**
     * Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The
     * faces are read through a memory map in blocks, so the file may be larger than memory. Subjects without a
     * neutral face are left out; missing expressions and repeated captures are fine. All else as by default.
     */
    public static ExpressionModel train(Session session, String datasetPath, TrainOptions options) {
        return train(session, datasetPath, options, null, null);
    }

    /**
     * Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut
     * its rank. C: mien_expression_model_merge().
     * @param shardPaths shard_count UTF-8 paths.
     * @param options may be left out: defaults. stable_vertices must be empty: the shards' own count.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of
     * different topologies, expression names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards)
     */
    public static ExpressionModel merge(Session session, java.util.List<String> shardPaths, TrainOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(shardPaths, "shard_paths");
            call.lock(session);
            var sessionAt = call.use(session);
            var shardCount = call.rows(shardPaths, 1, "shard_paths");
            var shardPathsAt = call.texts(shardPaths);
            var optionsAt = (options == null ? new TrainOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_expression_model_merge(Memory.address(sessionAt), Memory.address(shardPathsAt), (int) shardCount, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new ExpressionModel(call.pointer(outAt)));
        }
    }

    /**
     * Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut
     * its rank. All else as by default.
     */
    public static ExpressionModel merge(Session session, java.util.List<String> shardPaths) {
        return merge(session, shardPaths, null, null, null);
    }

    /**
     * Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut
     * its rank. All else as by default.
     */
    public static ExpressionModel merge(Session session, java.util.List<String> shardPaths, TrainOptions options) {
        return merge(session, shardPaths, options, null, null);
    }
}

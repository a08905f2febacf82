package mien;

// Written by abi/generate_bindings.py.
/** Predicts one expression of a person from the neutral face. Immutable: share freely. */
public final class BlendshapeModel extends NativeObject {
    BlendshapeModel(long owned) { super(owned, Raw.GET::mien_blendshape_model_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public BlendshapeModel share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_blendshape_model_retain(at);
            return new BlendshapeModel(at);
        }
    }

    /**
     * Learns to predict one expression from the neutral face, on every subject of a dataset that has both. C:
     * mien_blendshape_model_train().
     * @param datasetPath a dataset file whose names include "neutral".
     * @param expression a name of the dataset.
     * @param options may be left out.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge),
     * MIEN_E_NOT_FOUND (expression), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static BlendshapeModel train(Session session, String datasetPath, String expression, BlendshapeOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var datasetPathAt = call.text(datasetPath);
            var expressionAt = call.text(expression);
            var optionsAt = (options == null ? new BlendshapeOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_blendshape_model_train(Memory.address(sessionAt), Memory.address(datasetPathAt), Memory.address(expressionAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new BlendshapeModel(call.pointer(outAt)));
        }
    }

    /**
     * Learns to predict one expression from the neutral face, on every subject of a dataset that has both. All
     * else as by default.
     */
    public static BlendshapeModel train(Session session, String datasetPath, String expression) {
        return train(session, datasetPath, expression, null, null, null);
    }

    /**
     * Learns to predict one expression from the neutral face, on every subject of a dataset that has both. All
     * else as by default.
     */
    public static BlendshapeModel train(Session session, String datasetPath, String expression, BlendshapeOptions options) {
        return train(session, datasetPath, expression, options, null, null);
    }

    /**
     * Opens a blendshape model file. C: mien_blendshape_model_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
     */
    public static BlendshapeModel load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_blendshape_model_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new BlendshapeModel(call.pointer(outAt)));
        }
    }

    /**
     * Writes a blendshape model file (safetensors). Atomic. C: mien_blendshape_model_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_blendshape_model_save(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * The mean of the neutral training faces, centred: the mesh that a basis for this model is built on. C:
     * mien_blendshape_model_get_mean().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public Mesh mean() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_blendshape_model_get_mean(Memory.address(modelAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * A person's expression from the neutral face, in its frame. C: mien_blendshape_model_predict().
     * @param k low frequencies from the coordinates' prediction, high ones from the deformations'; 0 to the
     * basis' modes, #V or more: coordinates alone.
     * @param neutral #V vertices, mm.
     * @param basis may be left out: then k = 0 gives the deformations' prediction, any other k the coordinates'.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts),
     * MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public Mesh predict(Session session, long k, Mesh neutral, SpectralBasis basis) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var basisAt = call.useOrNull(basis);
            var neutralAt = call.use(neutral);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_blendshape_model_predict(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(basisAt), k, Memory.address(neutralAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /** A person's expression from the neutral face, in its frame. All else as by default. */
    public Mesh predict(Session session, long k, Mesh neutral) {
        return predict(session, k, neutral, null);
    }

    /**
     * Tries values of k on a dataset's subjects that the model was not trained on. C:
     * mien_blendshape_model_search().
     * @param datasetPath subjects with a neutral face and the expression.
     * @param candidates candidate_count values of k; above the basis' modes: coordinates alone.
     * @param options may be left out; its ridge is not read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression),
     * MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public java.util.List<BandChoice> search(Session session, SpectralBasis basis, String datasetPath, String expression, long[] candidates, BlendshapeOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(candidates, "candidates");
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var basisAt = call.use(basis);
            var datasetPathAt = call.text(datasetPath);
            var expressionAt = call.text(expression);
            var candidateCount = call.rows(candidates, 1, "candidates");
            var candidatesAt = call.array(candidates);
            var optionsAt = (options == null ? new BlendshapeOptions() : options).write(call, progress, cancel);
            var choicesAt = call.room(candidateCount * 40);
            call.check(Raw.GET.mien_blendshape_model_search(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(basisAt), Memory.address(datasetPathAt), Memory.address(expressionAt), Memory.address(candidatesAt), (int) candidateCount, Memory.address(optionsAt), Memory.address(choicesAt), call.error()));
            return call.readRecords(choicesAt, candidateCount, 40, BandChoice::read);
        }
    }

    /** Tries values of k on a dataset's subjects that the model was not trained on. All else as by default. */
    public java.util.List<BandChoice> search(Session session, SpectralBasis basis, String datasetPath, String expression, long[] candidates) {
        return search(session, basis, datasetPath, expression, candidates, null, null, null);
    }

    /** Tries values of k on a dataset's subjects that the model was not trained on. All else as by default. */
    public java.util.List<BandChoice> search(Session session, SpectralBasis basis, String datasetPath, String expression, long[] candidates, BlendshapeOptions options) {
        return search(session, basis, datasetPath, expression, candidates, options, null, null);
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** A trained score: partial least squares on displacement and curvature. Immutable: share freely. */
public final class ScoreModel extends NativeObject {
    ScoreModel(long owned) { super(owned, Raw.GET::mien_score_model_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public ScoreModel share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_score_model_retain(at);
            return new ScoreModel(at);
        }
    }

    /**
     * Learns a score from graded faces in correspondence. C: mien_score_model_train().
     * @param datasetPath a dataset file, faces of one subject share a fold.
     * @param grades grade_count values, one per face, NaN: not graded.
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces),
     * MIEN_E_MISMATCH (counts, zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static ScoreModel train(Session session, String datasetPath, double[] grades, ScoreOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(grades, "grades");
            call.lock(session);
            var sessionAt = call.use(session);
            var datasetPathAt = call.text(datasetPath);
            var gradeCount = call.rows(grades, 1, "grades");
            var gradesAt = call.array(grades);
            var optionsAt = (options == null ? new ScoreOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_score_model_train(Memory.address(sessionAt), Memory.address(datasetPathAt), Memory.address(gradesAt), gradeCount, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new ScoreModel(call.pointer(outAt)));
        }
    }

    /** Learns a score from graded faces in correspondence. All else as by default. */
    public static ScoreModel train(Session session, String datasetPath, double[] grades) {
        return train(session, datasetPath, grades, null, null, null);
    }

    /** Learns a score from graded faces in correspondence. All else as by default. */
    public static ScoreModel train(Session session, String datasetPath, double[] grades, ScoreOptions options) {
        return train(session, datasetPath, grades, options, null, null);
    }

    /**
     * Reads a score model file, which is treated as hostile. C: mien_score_model_load().
     * @throws MienException MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION,
     * MIEN_E_CORRUPT, MIEN_E_NO_MEMORY
     */
    public static ScoreModel load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_score_model_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new ScoreModel(call.pointer(outAt)));
        }
    }

    /**
     * Writes a score model as a safetensors file, atomically. C: mien_score_model_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_score_model_save(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * The score of a face with its 95 % prediction interval. C: mien_score_model_predict().
     * @param face in the model's topology, mm, anywhere in space.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology),
     * MIEN_E_NO_MEMORY
     */
    public ScorePrediction predict(Session session, Mesh face) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var faceAt = call.use(face);
            var outAt = call.sized(40);
            call.check(Raw.GET.mien_score_model_predict(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(faceAt), Memory.address(outAt), call.error()));
            return ScorePrediction.read(call, outAt, 0);
        }
    }

    /**
     * The face as it would look with another score. C: mien_score_model_simulate().
     * @param target the score wanted, finite.
     * @param face may be left out: the training's mean face.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology),
     * MIEN_E_NO_MEMORY
     */
    public Mesh simulate(Session session, double target, Mesh face) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var faceAt = call.useOrNull(face);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_score_model_simulate(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(faceAt), target, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /** The face as it would look with another score. All else as by default. */
    public Mesh simulate(Session session, double target) {
        return simulate(session, target, null);
    }

    /**
     * A latent variable on the template: how far each vertex moves, mm, at one standard deviation of it.
     * Component -1: per unit of score. C: mien_score_model_get_latent().
     * @param component 0 .. components - 1, or -1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such component)
     */
    public double[] latent(int component) {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_score_model_get_latent(Memory.address(modelAt), component, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * What was learned as JSON: components, cross-validated errors, held-out predictions and focus_places (how
     * many places the focus takes a face for; 0: none), which are not kept in files. C:
     * mien_score_model_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public String json() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_score_model_get_json(Memory.address(modelAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

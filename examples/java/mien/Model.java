package mien;

// Written by abi/generate_bindings.py.
/**
 * A template with its modes of deformation: u(x) = mean(x) + sum_j basis_j(x) a_j + sum_k mode_k(x) c_k, a
 * and c standard normal; basis_j are scalar and serve x, y and z, mode_k come from faces. Built or loaded
 * once. Immutable: share freely between threads.
 */
public final class Model extends NativeObject {
    Model(long owned) { super(owned, Raw.GET::mien_model_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Model share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_model_retain(at);
            return new Model(at);
        }
    }

    /**
     * Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean
     * and the principal modes of its faces. C: mien_model_build().
     * @param templateMesh #V x 3, mm, with triangles for the surface kernels.
     * @param options may be left out: geodesic kernel of 20 mm, 999 modes.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles,
     * not symmetric), MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static Model build(Session session, Mesh templateMesh, ModelOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var templateMeshAt = call.use(templateMesh);
            var optionsAt = (options == null ? new ModelOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_build(Memory.address(sessionAt), Memory.address(templateMeshAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Model(call.pointer(outAt)));
        }
    }

    /**
     * Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean
     * and the principal modes of its faces. All else as by default.
     */
    public static Model build(Session session, Mesh templateMesh) {
        return build(session, templateMesh, null, null, null);
    }

    /**
     * Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean
     * and the principal modes of its faces. All else as by default.
     */
    public static Model build(Session session, Mesh templateMesh, ModelOptions options) {
        return build(session, templateMesh, options, null, null);
    }

    /**
     * Loads a model file through a memory map and checks all of it: structure, hash, finite values. C:
     * mien_model_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
     * MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY
     */
    public static Model load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Model(call.pointer(outAt)));
        }
    }

    /**
     * Loads a model from the bytes of a model file that the host holds in memory, e.g. as a resource of its
     * program. They are copied and checked like a file. C: mien_model_load_memory().
     * @param data size bytes, any alignment; not read after the call.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
     * MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Model loadMemory(Session session, byte[] data) {
        try (Call call = new Call()) {
            call.required(data, "data");
            call.lock(session);
            var sessionAt = call.use(session);
            var size = call.rows(data, 1, "data");
            var dataAt = call.array(data);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_load_memory(Memory.address(sessionAt), Memory.address(dataAt), size, Memory.address(outAt), call.error()));
            return call.keep(new Model(call.pointer(outAt)));
        }
    }

    /**
     * Loads a model file that the host trusts: its structure is checked, its hash and values are not. C:
     * mien_model_load_trusted().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
     * MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY
     */
    public static Model loadTrusted(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_load_trusted(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Model(call.pointer(outAt)));
        }
    }

    /**
     * Writes a model file (safetensors). Atomic: a full disk or a crash leaves an old file whole. C:
     * mien_model_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_model_save(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Numbers of vertices and modes. C: mien_model_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public ModelCounts counts() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var vertexCountAt = call.room(8);
            var scalarModesAt = call.room(8);
            var vectorModesAt = call.room(8);
            call.check(Raw.GET.mien_model_get_counts(Memory.address(modelAt), Memory.address(vertexCountAt), Memory.address(scalarModesAt), Memory.address(vectorModesAt), call.error()));
            return new ModelCounts(vertexCountAt.bytes.getLong(0), scalarModesAt.bytes.getLong(0), vectorModesAt.bytes.getLong(0));
        }
    }

    /**
     * What the model is: counts, kernel and its settings, rank, variance explained, largest pointwise variance
     * error, clipped negative mass, names of landmarks and zones. As JSON text by the two-call protocol. C:
     * mien_model_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public String json() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_model_get_json(Memory.address(modelAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Prior variance of each coordinate of each vertex, #V x 3 float64, mm^2, modes of both kinds together. C:
     * mien_model_get_variance().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public double[] variance() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3 * 8);
            } while ((capacity = call.more(Raw.GET.mien_model_get_variance(Memory.address(modelAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows * 3);
        }
    }

    /**
     * A random face: the template moved by the mean and `strength` times a draw from the prior. Face `index` of
     * `seed` is the same whatever else was drawn; strength 0 gives the mean. C: mien_model_sample().
     * @param seed any number.
     * @param index any number.
     * @param strength &gt;= 0; 1: the prior itself.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public Mesh sample(Session session, long seed, long index, double strength) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_sample(Memory.address(sessionAt), Memory.address(modelAt), seed, index, strength, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The posterior model: what the template may still do once landmarks were seen. It is a model like any other,
     * with a mean of its own, and may be conditioned again. C: mien_model_condition().
     * @param observations observation_count of them.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (name),
     * MIEN_E_UNSUPPORTED_OPTION (mirror correlation), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public Model condition(Session session, java.util.List<LandmarkObservation> observations) {
        try (Call call = new Call()) {
            call.required(observations, "observations");
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var observationCount = call.rows(observations, 1, "observations");
            var observationsAt = call.records(observations, 48);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_condition(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(observationsAt), observationCount, Memory.address(outAt), call.error()));
            return call.keep(new Model(call.pointer(outAt)));
        }
    }

    /**
     * Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of
     * levels that is asked for, and reports what is left. C: mien_model_tune().
     * @param templateMesh #V x 3, mm.
     * @param dataset UTF-8 path of a dataset in the template's correspondence, its faces may cover only the
     * template's first vertices.
     * @param options sigmas_mm at least.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND
     * (expression), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static Tuning tune(Session session, Mesh templateMesh, String dataset, TuneOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var templateMeshAt = call.use(templateMesh);
            var datasetAt = call.text(dataset);
            var optionsAt = call.required(options, "options").write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_tune(Memory.address(sessionAt), Memory.address(templateMeshAt), Memory.address(datasetAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Tuning(call.pointer(outAt)));
        }
    }

    /**
     * Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of
     * levels that is asked for, and reports what is left. All else as by default.
     */
    public static Tuning tune(Session session, Mesh templateMesh, String dataset, TuneOptions options) {
        return tune(session, templateMesh, dataset, options, null, null);
    }

    /**
     * The template. C: mien_model_mesh().
     * @throws MienException none; null for a null or wrong handle
     */
    public Mesh mesh() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var lent = Raw.GET.mien_model_mesh(Memory.address(modelAt));
            Raw.GET.mien_mesh_retain(lent);
            return new Mesh(lent);
        }
    }

    /**
     * The landmarks of a model: names and vertices of its template. C: mien_model_get_landmarks().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public Landmarks landmarks() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_get_landmarks(Memory.address(modelAt), Memory.address(outAt), call.error()));
            return call.keep(new Landmarks(call.pointer(outAt)));
        }
    }

    /**
     * The zones of a model: names and vertices of its template. C: mien_model_get_zones().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public Zones zones() {
        try (Call call = new Call()) {
            var modelAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_get_zones(Memory.address(modelAt), Memory.address(outAt), call.error()));
            return call.keep(new Zones(call.pointer(outAt)));
        }
    }

    /**
     * The coefficients that bring the template nearest to a face in its correspondence: least squares, weighted
     * per vertex, with a ridge. C: mien_model_fit().
     * @param target mm, in the template's frame unless options.align; the vertices of the template, or its first
     * ones.
     * @param options may be left out: no weights, a ridge of 1 mm^2, all modes.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertices, weights),
     * MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public double[] fit(Session session, Mesh target, ModelFitOptions options) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var targetAt = call.use(target);
            var optionsAt = call.record(options, 56, false, "options");
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_model_fit(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(targetAt), Memory.address(optionsAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * The coefficients that bring the template nearest to a face in its correspondence: least squares, weighted
     * per vertex, with a ridge. All else as by default.
     */
    public double[] fit(Session session, Mesh target) {
        return fit(session, target, null);
    }

    /**
     * The face that has these coefficients: the template moved by the mean and the modes. C:
     * mien_model_synthesize().
     * @param coefficients coefficient_count finite values
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (coefficient_count),
     * MIEN_E_NO_MEMORY
     */
    public Mesh synthesize(Session session, double[] coefficients) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(this);
            var coefficientCount = call.rows(coefficients, 1, "coefficients");
            var coefficientsAt = call.array(coefficients);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_model_synthesize(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(coefficientsAt), coefficientCount, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /** The face that has these coefficients: the template moved by the mean and the modes. All else as by default. */
    public Mesh synthesize(Session session) {
        return synthesize(session, null);
    }
}

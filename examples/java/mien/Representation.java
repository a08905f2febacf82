package mien;

// Written by abi/generate_bindings.py.
/** A trained representation of faces: numbers for learning, with their exact inverse. Immutable: share freely. */
public final class Representation extends NativeObject {
    Representation(long owned) { super(owned, Raw.GET::mien_representation_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Representation share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_representation_retain(at);
            return new Representation(at);
        }
    }

    /**
     * mien_representation_train_with_options() without progress and cancel. C: mien_representation_train().
     * @param datasetPath a dataset file.
     * @param kind MIEN_FEATURES_... See Features.
     * @param neutralOnly 1: only the faces marked neutral; 0: all.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
     * neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
     * MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Representation train(Session session, String datasetPath, int kind, int neutralOnly) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var datasetPathAt = call.text(datasetPath);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_representation_train(Memory.address(sessionAt), Memory.address(datasetPathAt), kind, neutralOnly, Memory.address(outAt), call.error()));
            return call.keep(new Representation(call.pointer(outAt)));
        }
    }

    /**
     * Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel. C:
     * mien_representation_train_with_options().
     * @param datasetPath a dataset file.
     * @param kind MIEN_FEATURES_... See Features.
     * @param options may be left out: all faces.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
     * neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
     * MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static Representation trainWithOptions(Session session, String datasetPath, int kind, RepresentationOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var datasetPathAt = call.text(datasetPath);
            var optionsAt = (options == null ? new RepresentationOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_representation_train_with_options(Memory.address(sessionAt), Memory.address(datasetPathAt), kind, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Representation(call.pointer(outAt)));
        }
    }

    /**
     * Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel. All else as by
     * default.
     */
    public static Representation trainWithOptions(Session session, String datasetPath, int kind) {
        return trainWithOptions(session, datasetPath, kind, null, null, null);
    }

    /**
     * Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel. All else as by
     * default.
     */
    public static Representation trainWithOptions(Session session, String datasetPath, int kind, RepresentationOptions options) {
        return trainWithOptions(session, datasetPath, kind, options, null, null);
    }

    /**
     * Opens a representation file. C: mien_representation_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
     */
    public static Representation load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_representation_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Representation(call.pointer(outAt)));
        }
    }

    /**
     * Writes a representation file (safetensors). Atomic. C: mien_representation_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var representationAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_representation_save(Memory.address(sessionAt), Memory.address(representationAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Numbers of vertices and of features a vertex. C: mien_representation_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public RepresentationCounts counts() {
        try (Call call = new Call()) {
            var representationAt = call.use(this);
            var vertexCountAt = call.room(8);
            var channelCountAt = call.room(8);
            call.check(Raw.GET.mien_representation_get_counts(Memory.address(representationAt), Memory.address(vertexCountAt), Memory.address(channelCountAt), call.error()));
            return new RepresentationCounts(vertexCountAt.bytes.getLong(0), channelCountAt.bytes.getLong(0));
        }
    }

    /**
     * The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count only. C:
     * mien_representation_encode().
     * @param face #V vertices, mm, anywhere.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
     * MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public RepresentationEncode encode(Session session, Mesh face) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var representationAt = call.use(this);
            var faceAt = call.use(face);
            var motionAt = call.room(12 * 8);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(this.counts().channelCount() * 8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * this.counts().channelCount() * 8);
            } while ((capacity = call.more(Raw.GET.mien_representation_encode(Memory.address(sessionAt), Memory.address(representationAt), Memory.address(faceAt), Memory.address(motionAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return new RepresentationEncode(call.readDoubles(motionAt, 12), call.readDoubles(dstAt, rows * this.counts().channelCount()));
        }
    }

    /**
     * The face that has these features. C: mien_representation_decode().
     * @param features row_count x channel_count row-major float64.
     * @param motion may be left out: the mean's frame; 12 float64 of mien_representation_encode(), which is
     * undone.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
     * MIEN_E_MISMATCH (row_count), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public Mesh decode(Session session, double[] features, double[] motion) {
        try (Call call = new Call()) {
            call.required(features, "features");
            call.lock(session);
            var sessionAt = call.use(session);
            var representationAt = call.use(this);
            var rowCount = call.rows(features, this.counts().channelCount(), "features");
            var featuresAt = call.array(features);
            call.agree("motion", call.rows(motion, 1, "motion"), 12);
            var motionAt = call.array(motion);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_representation_decode(Memory.address(sessionAt), Memory.address(representationAt), Memory.address(featuresAt), rowCount, Memory.address(motionAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /** The face that has these features. All else as by default. */
    public Mesh decode(Session session, double[] features) {
        return decode(session, features, null);
    }
}

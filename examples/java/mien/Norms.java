package mien;

// Written by abi/generate_bindings.py.
/** Mean and deviation of each measurement over the people of a dataset. Immutable: share freely. */
public final class Norms extends NativeObject {
    Norms(long owned) { super(owned, Raw.GET::mien_norms_release); }

    /**
     * Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset
     * and for faces in its topology: the same landmark lies elsewhere on another template. C:
     * mien_norms_create().
     * @param datasetPath faces of ten people or more.
     * @param landmarks vertices of the dataset's faces.
     * @param options may be left out; progress and cancel are read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that
     * are no vertices), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its
     * landmarks), MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static Norms create(Session session, String datasetPath, Landmarks landmarks, AnthropometryOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var datasetPathAt = call.text(datasetPath);
            var landmarksAt = call.use(landmarks);
            var optionsAt = (options == null ? new AnthropometryOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_norms_create(Memory.address(sessionAt), Memory.address(datasetPathAt), Memory.address(landmarksAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Norms(call.pointer(outAt)));
        }
    }

    /**
     * Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset
     * and for faces in its topology: the same landmark lies elsewhere on another template. All else as by
     * default.
     */
    public static Norms create(Session session, String datasetPath, Landmarks landmarks) {
        return create(session, datasetPath, landmarks, null, null, null);
    }

    /**
     * Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset
     * and for faces in its topology: the same landmark lies elsewhere on another template. All else as by
     * default.
     */
    public static Norms create(Session session, String datasetPath, Landmarks landmarks, AnthropometryOptions options) {
        return create(session, datasetPath, landmarks, options, null, null);
    }

    /**
     * Reads norms that mien_norms_save() wrote, or that a host wrote from the literature: {"norms": {"n-gn":
     * {"mean": 121.3, "sd": 6.8, "people": 109}}}. C: mien_norms_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a norm of fewer than ten people, or
     * given twice), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Norms load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_norms_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Norms(call.pointer(outAt)));
        }
    }

    /**
     * Writes norms as JSON. Atomic. C: mien_norms_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var normsAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_norms_save(Memory.address(sessionAt), Memory.address(normsAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * The norms as JSON text, as mien_norms_save() writes it. C: mien_norms_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public String json() {
        try (Call call = new Call()) {
            var normsAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_norms_get_json(Memory.address(normsAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

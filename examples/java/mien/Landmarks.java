package mien;

// Written by abi/generate_bindings.py.
/** A list of named landmarks: places on a scan, or vertices of a template. Immutable: share freely. */
public final class Landmarks extends NativeObject {
    Landmarks(long owned) { super(owned, Raw.GET::mien_landmarks_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Landmarks share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_landmarks_retain(at);
            return new Landmarks(at);
        }
    }

    /**
     * Reads a landmark file, told by its content: this project's JSON ({"points": ...} or {"vertices": ...}), 3D
     * Slicer's .mrk.json and .fcsv (coordinates come out as LPS), MeshLab's .pp, .pts, menpo's .ljson, tables
     * name,x,y,z or name,vertex, and vertex numbers alone. What was not picked (null, not a number, "not
     * defined", a repeated placeholder such as 0 0 0) is kept as such. Landmarks without a name are called by
     * their number, from "1". C: mien_landmarks_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Landmarks load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Landmarks(call.pointer(outAt)));
        }
    }

    /**
     * Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not picked. C:
     * mien_landmarks_create().
     * @param landmarks landmark_count of them; null allowed when that is 0. Names must differ.
     * @throws MienException MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public static Landmarks create(java.util.List<ScanLandmark> landmarks) {
        try (Call call = new Call()) {
            var landmarkCount = call.rows(landmarks, 1, "landmarks");
            var landmarksAt = call.records(landmarks, 32);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_create(Memory.address(landmarksAt), landmarkCount, Memory.address(outAt), call.error()));
            return call.keep(new Landmarks(call.pointer(outAt)));
        }
    }

    /**
     * Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not picked. All
     * else as by default.
     */
    public static Landmarks create() {
        return create(null);
    }

    /**
     * The landmarks under the names that a model has for them. Case, separators and leading zeros do not count;
     * numbers alone are read as iBUG-68 (from 0 or 1) or MediaPipe (468 or 478), where the model has the 68 names
     * of that scheme. What the model does not know is left out and listed in the JSON of the result. C:
     * mien_landmarks_match().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (two names mean one landmark, numbers
     * fit two schemes), MIEN_E_NOT_FOUND (none is known; the message gives examples of known names),
     * MIEN_E_NO_MEMORY
     */
    public Landmarks match(Model model) {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var modelAt = call.use(model);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_match(Memory.address(landmarksAt), Memory.address(modelAt), Memory.address(outAt), call.error()));
            return call.keep(new Landmarks(call.pointer(outAt)));
        }
    }

    /**
     * The landmarks as places: vertex numbers become the vertices' places on a mesh, places stay as they are. C:
     * mien_landmarks_on_mesh().
     * @param mesh has the numbered vertices.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (a number that the
     * mesh does not have), MIEN_E_NO_MEMORY
     */
    public Landmarks onMesh(Mesh mesh) {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var meshAt = call.use(mesh);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_on_mesh(Memory.address(landmarksAt), Memory.address(meshAt), Memory.address(outAt), call.error()));
            return call.keep(new Landmarks(call.pointer(outAt)));
        }
    }

    /**
     * Writes a landmark file by its extension: .json, .mrk.json and .fcsv (both LPS), .pp, .pts, .ljson, .csv.
     * Vertex numbers go into .json and .csv. Atomic. C: mien_landmarks_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var landmarksAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_landmarks_save(Memory.address(sessionAt), Memory.address(landmarksAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * How many landmarks there are, and how many of them are a place or a vertex. C: mien_landmarks_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public LandmarksCounts counts() {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var countAt = call.room(8);
            var pickedCountAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_get_counts(Memory.address(landmarksAt), Memory.address(countAt), Memory.address(pickedCountAt), call.error()));
            return new LandmarksCounts(countAt.bytes.getLong(0), pickedCountAt.bytes.getLong(0));
        }
    }

    /**
     * The name of one landmark. C: mien_landmarks_get_name().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
     */
    public String name(long index) {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_landmarks_get_name(Memory.address(landmarksAt), index, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * What is known of one landmark. C: mien_landmarks_get_mark().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (misaligned), MIEN_E_NOT_FOUND (index)
     */
    public LandmarksMark mark(long index) {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var whereAt = call.room(8);
            var positionAt = call.room(8);
            var vertexAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_get_mark(Memory.address(landmarksAt), index, Memory.address(whereAt), Memory.address(positionAt), Memory.address(vertexAt), call.error()));
            return new LandmarksMark(whereAt.bytes.getInt(0), positionAt.bytes.getDouble(0), vertexAt.bytes.getInt(0));
        }
    }

    /**
     * What the list is, as JSON text by the two-call protocol: format, system (LPS or RAS as the file says it),
     * unit_to_mm (null: not told), count, picked, not_picked (names), and after mien_landmarks_match() scheme and
     * unknown (names). C: mien_landmarks_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public String json() {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_landmarks_get_json(Memory.address(landmarksAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * The landmarks of a template and, beside them, those of its profile that its shape defines by itself:
     * glabella, nasion, columella, sublabiale and pogonion, where they are not among the given ones. Every face
     * in the template's topology has them at the same vertices. C: mien_landmarks_add_profile().
     * @param templateMesh symmetric about its plane x = 0, +y up, +z forward (mien_model_mesh()).
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (a landmark that the
     * search starts from), MIEN_E_MISMATCH (vertex), MIEN_E_INVALID_MESH (not symmetric, no midline),
     * MIEN_E_NO_MEMORY
     */
    public Landmarks addProfile(Mesh templateMesh) {
        try (Call call = new Call()) {
            var landmarksAt = call.use(this);
            var templateMeshAt = call.use(templateMesh);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_landmarks_add_profile(Memory.address(landmarksAt), Memory.address(templateMeshAt), Memory.address(outAt), call.error()));
            return call.keep(new Landmarks(call.pointer(outAt)));
        }
    }
}

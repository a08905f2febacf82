package mien;

// Written by abi/generate_bindings.py.
/**
 * Collects faces with a subject and an expression each, then saves them as one safetensors file: vertices f32
 * [s, n, 3], subject i32 [s], expression i32 [s], triangles u32 [m, 3]. Externally synchronized.
 */
public final class DatasetWriter extends NativeObject {
    DatasetWriter(long owned) { super(owned, Raw.GET::mien_dataset_writer_release); }

    /**
     * Starts a dataset in the topology of a mesh. C: mien_dataset_writer_create().
     * @param topology its triangles and vertex count hold for all faces.
     * @param expressionNames expression_count UTF-8 names. One should be "neutral".
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public static DatasetWriter create(Session session, Mesh topology, java.util.List<String> expressionNames) {
        try (Call call = new Call()) {
            call.required(expressionNames, "expression_names");
            call.lock(session);
            var sessionAt = call.use(session);
            var topologyAt = call.use(topology);
            var expressionCount = call.rows(expressionNames, 1, "expression_names");
            var expressionNamesAt = call.texts(expressionNames);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_dataset_writer_create(Memory.address(sessionAt), Memory.address(topologyAt), Memory.address(expressionNamesAt), (int) expressionCount, Memory.address(outAt), call.error()));
            return call.keep(new DatasetWriter(call.pointer(outAt)));
        }
    }

    /**
     * Adds one face; its positions are copied. C: mien_dataset_writer_add().
     * @param positions #V x 3, F32 or F64, mm.
     * @param subject any number that names the person.
     * @param expression index into the expression names.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
     * MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_MEMORY
     */
    public void add(Values positions, int subject, int expression) {
        try (Call call = new Call()) {
            call.lock(this);
            var writerAt = call.use(this);
            var positionsAt = call.view(positions, 3, "positions");
            call.check(Raw.GET.mien_dataset_writer_add(Memory.address(writerAt), Memory.address(positionsAt), subject, expression, call.error()));
        }
    }

    /**
     * Writes all faces added so far. Atomic; more may be added and saved again. C: mien_dataset_writer_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no face), MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            call.lock(this);
            var sessionAt = call.use(session);
            var writerAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_dataset_writer_save(Memory.address(sessionAt), Memory.address(writerAt), Memory.address(pathAt), call.error()));
        }
    }
}

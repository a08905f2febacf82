package mien;

// Written by abi/generate_bindings.py.
/** Levels of a template with maps between them. Immutable: share freely. */
public final class Hierarchy extends NativeObject {
    Hierarchy(long owned) { super(owned, Raw.GET::mien_hierarchy_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Hierarchy share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_hierarchy_retain(at);
            return new Hierarchy(at);
        }
    }

    /**
     * Levels by quadric edge collapse, with barycentric maps up and selections down. C:
     * mien_hierarchy_build_quadric().
     * @param mesh an orientable manifold.
     * @param levelCount levels below the mesh itself, 1 to 32; fewer when no collapse is legal.
     * @param factor vertices are divided by this from level to level; above 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Hierarchy buildQuadric(Session session, Mesh mesh, int levelCount, double factor) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(mesh);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_hierarchy_build_quadric(Memory.address(sessionAt), Memory.address(meshAt), levelCount, factor, Memory.address(outAt), call.error()));
            return call.keep(new Hierarchy(call.pointer(outAt)));
        }
    }

    /**
     * Levels sampled from the connectivity alone. C: mien_hierarchy_build_connectivity().
     * @param levelCount levels below the mesh itself, 1 to 32.
     * @param stride least distance of kept vertices in edges, at least 1.
     * @param radius edges over which the maps reach, stride - 1 to 64.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public static Hierarchy buildConnectivity(Session session, Mesh mesh, int levelCount, int stride, int radius) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(mesh);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_hierarchy_build_connectivity(Memory.address(sessionAt), Memory.address(meshAt), levelCount, stride, radius, Memory.address(outAt), call.error()));
            return call.keep(new Hierarchy(call.pointer(outAt)));
        }
    }

    /**
     * Opens a hierarchy file. C: mien_hierarchy_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
     */
    public static Hierarchy load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_hierarchy_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Hierarchy(call.pointer(outAt)));
        }
    }

    /**
     * Writes a hierarchy file (safetensors; maps as compressed rows). Atomic. C: mien_hierarchy_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var hierarchyAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_hierarchy_save(Memory.address(sessionAt), Memory.address(hierarchyAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Number of levels, the finest included. C: mien_hierarchy_get_level_count().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public int levelCount() {
        try (Call call = new Call()) {
            var hierarchyAt = call.use(this);
            var levelCountAt = call.room(8);
            call.check(Raw.GET.mien_hierarchy_get_level_count(Memory.address(hierarchyAt), Memory.address(levelCountAt), call.error()));
            return levelCountAt.bytes.getInt(0);
        }
    }

    /**
     * The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no triangles. C:
     * mien_hierarchy_get_level().
     * @param level 0 to level_count - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY
     */
    public Mesh level(int level) {
        try (Call call = new Call()) {
            var hierarchyAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_hierarchy_get_level(Memory.address(hierarchyAt), level, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Applies a map to values on vertices: dst = map values. C: mien_hierarchy_apply().
     * @param level 1 to level_count - 1: the coarser level of the map.
     * @param direction MIEN_MAP_DOWN or MIEN_MAP_UP. See MapKind.
     * @param values row_count x channel_count row-major float64.
     * @param channelCount values a vertex, 1 to 4096.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION
     * (direction), MIEN_E_MISMATCH (row_count), MIEN_E_NO_MEMORY
     */
    public double[] apply(int level, int direction, double[] values, long channelCount) {
        try (Call call = new Call()) {
            call.required(values, "values");
            var hierarchyAt = call.use(this);
            var rowCount = call.rows(values, channelCount, "values");
            var valuesAt = call.array(values);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(channelCount * 8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * channelCount * 8);
            } while ((capacity = call.more(Raw.GET.mien_hierarchy_apply(Memory.address(hierarchyAt), level, direction, Memory.address(valuesAt), rowCount, channelCount, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows * channelCount);
        }
    }

    /**
     * A map as a sparse matrix: its entries by rows, ascending, each row adding up to one. With all arrays null
     * and capacity 0: the counts only. C: mien_hierarchy_get_map().
     * @param level 1 to level_count - 1: the coarser level of the map.
     * @param direction MIEN_MAP_DOWN or MIEN_MAP_UP. See MapKind.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction)
     */
    public HierarchyMap map(int level, int direction) {
        try (Call call = new Call()) {
            var hierarchyAt = call.use(this);
            var rowCountAt = call.room(8);
            var columnCountAt = call.room(8);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory rowsAt;
            Memory columnsAt;
            Memory valuesAt;
            do {
                rowsAt = call.room(capacity * 4);
                columnsAt = call.room(capacity * 4);
                valuesAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_hierarchy_get_map(Memory.address(hierarchyAt), level, direction, Memory.address(rowsAt), Memory.address(columnsAt), Memory.address(valuesAt), capacity, Memory.address(countAt), Memory.address(rowCountAt), Memory.address(columnCountAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return new HierarchyMap(call.readInts(rowsAt, rows), call.readInts(columnsAt, rows), call.readDoubles(valuesAt, rows), rowCountAt.bytes.getLong(0), columnCountAt.bytes.getLong(0));
        }
    }
}

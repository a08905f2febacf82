package mien;

// Written by abi/generate_bindings.py.
/** A list of named sets of vertices. Immutable: share freely. */
public final class Zones extends NativeObject {
    Zones(long owned) { super(owned, Raw.GET::mien_zones_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Zones share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_zones_retain(at);
            return new Zones(at);
        }
    }

    /**
     * Reads a zone file {"zones": {name: [vertex, ...]}}; further lists of vertices beside "zones", such as
     * "lips", are zones too. C: mien_zones_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Zones load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_zones_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Zones(call.pointer(outAt)));
        }
    }

    /**
     * Makes a list of zones from the host's. C: mien_zones_create().
     * @param zones zone_count of them, each of at most 16777216 vertices; null allowed when that is 0. Names must
     * differ.
     * @throws MienException MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public static Zones create(java.util.List<Zone> zones) {
        try (Call call = new Call()) {
            var zoneCount = call.rows(zones, 1, "zones");
            var zonesAt = call.records(zones, 24);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_zones_create(Memory.address(zonesAt), zoneCount, Memory.address(outAt), call.error()));
            return call.keep(new Zones(call.pointer(outAt)));
        }
    }

    /** Makes a list of zones from the host's. All else as by default. */
    public static Zones create() {
        return create(null);
    }

    /**
     * Writes a zone file. Atomic. C: mien_zones_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var zonesAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_zones_save(Memory.address(sessionAt), Memory.address(zonesAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * How many zones there are. C: mien_zones_get_count().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public long count() {
        try (Call call = new Call()) {
            var zonesAt = call.use(this);
            var countAt = call.room(8);
            call.check(Raw.GET.mien_zones_get_count(Memory.address(zonesAt), Memory.address(countAt), call.error()));
            return countAt.bytes.getLong(0);
        }
    }

    /**
     * The name of one zone. C: mien_zones_get_name().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
     */
    public String name(long index) {
        try (Call call = new Call()) {
            var zonesAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_zones_get_name(Memory.address(zonesAt), index, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * The vertices of one zone. With dst null and capacity 0: their number only. C: mien_zones_get_vertices().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
     */
    public int[] vertices(long index) {
        try (Call call = new Call()) {
            var zonesAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 4);
            } while ((capacity = call.more(Raw.GET.mien_zones_get_vertices(Memory.address(zonesAt), index, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readInts(dstAt, rows);
        }
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** A neutralized face. Immutable: share freely between threads. */
public final class Neutralization extends NativeObject {
    Neutralization(long owned) { super(owned, Raw.GET::mien_neutralization_release); }

    /**
     * The neutral face with the triangles, colours and texture of the input, borrowed. C:
     * mien_neutralization_mesh().
     * @throws MienException none (null for a null or released handle)
     */
    public Mesh mesh() {
        try (Call call = new Call()) {
            var neutralizationAt = call.use(this);
            var lent = Raw.GET.mien_neutralization_mesh(Memory.address(neutralizationAt));
            Raw.GET.mien_mesh_retain(lent);
            return new Mesh(lent);
        }
    }

    /**
     * Numbers of vertices of the neutral face and of coordinates of mien_neutralization_get_coordinates(). C:
     * mien_neutralization_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public NeutralizationCounts counts() {
        try (Call call = new Call()) {
            var neutralizationAt = call.use(this);
            var vertexCountAt = call.room(8);
            var identityModesAt = call.room(8);
            var expressionModesAt = call.room(8);
            call.check(Raw.GET.mien_neutralization_get_counts(Memory.address(neutralizationAt), Memory.address(vertexCountAt), Memory.address(identityModesAt), Memory.address(expressionModesAt), call.error()));
            return new NeutralizationCounts(vertexCountAt.bytes.getLong(0), identityModesAt.bytes.getInt(0), expressionModesAt.bytes.getInt(0));
        }
    }

    /**
     * Coordinates of the face in the model, mm along the unit modes. mien_neutralization_get_counts() says how
     * many. C: mien_neutralization_get_coordinates().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public NeutralizationCoordinates coordinates() {
        try (Call call = new Call()) {
            var neutralizationAt = call.use(this);
            var identityAt = call.room(this.counts().identityModes() * 8);
            var expressionAt = call.room(this.counts().expressionModes() * 8);
            call.check(Raw.GET.mien_neutralization_get_coordinates(Memory.address(neutralizationAt), Memory.address(identityAt), Memory.address(expressionAt), call.error()));
            return new NeutralizationCoordinates(call.readDoubles(identityAt, this.counts().identityModes()), call.readDoubles(expressionAt, this.counts().expressionModes()));
        }
    }

    /**
     * Deviation per vertex of the neutral face that comes from not knowing the expression, mm. C:
     * mien_neutralization_get_uncertainty().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without
     * a prior)
     */
    public double[] uncertainty() {
        try (Call call = new Call()) {
            var neutralizationAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_neutralization_get_uncertainty(Memory.address(neutralizationAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * How a treated zone is read, both ways: treatments of lips, brows and the corners of the mouth can look like
     * expressions. C: mien_neutralization_get_reading().
     * @param reading MIEN_READING_*. See Reading.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (reading),
     * MIEN_E_NOT_FOUND (nothing was treated)
     */
    public ZoneReading reading(int reading) {
        try (Call call = new Call()) {
            var neutralizationAt = call.use(this);
            var outAt = call.sized(32);
            call.check(Raw.GET.mien_neutralization_get_reading(Memory.address(neutralizationAt), reading, Memory.address(outAt), call.error()));
            return ZoneReading.read(call, outAt, 0);
        }
    }

    /**
     * The report as a JSON object: expression found, its probability and the others', displacement, residual,
     * coordinates; with options.treated both readings of the zone. C: mien_neutralization_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public String json() {
        try (Call call = new Call()) {
            var neutralizationAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_neutralization_get_json(Memory.address(neutralizationAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and texture of the
     * scan stay. Parts far from the template move rigidly with their neighbourhood. C:
     * mien_neutralization_apply_to_scan().
     * @param scan in the frame of the face.
     * @param maxDistanceMm how far from the fitted face a vertex takes its displacement; 0: 6 mm.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public Mesh applyToScan(Session session, Mesh scan, double maxDistanceMm) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var neutralizationAt = call.use(this);
            var scanAt = call.use(scan);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_neutralization_apply_to_scan(Memory.address(sessionAt), Memory.address(neutralizationAt), Memory.address(scanAt), maxDistanceMm, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }
}

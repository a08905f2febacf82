package mien;

// Written by abi/generate_bindings.py.
/** What was measured: numbers per zone and values per vertex. Immutable: share freely. */
public final class Measurement extends NativeObject {
    Measurement(long owned) { super(owned, Raw.GET::mien_measurement_release); }

    /**
     * How many zones were measured. C: mien_measurement_get_zones().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public MeasurementZones zones() {
        try (Call call = new Call()) {
            var measurementAt = call.use(this);
            var zoneCountAt = call.room(8);
            var zonesDisjointAt = call.room(8);
            call.check(Raw.GET.mien_measurement_get_zones(Memory.address(measurementAt), Memory.address(zoneCountAt), Memory.address(zonesDisjointAt), call.error()));
            return new MeasurementZones(zoneCountAt.bytes.getInt(0), zonesDisjointAt.bytes.getInt(0));
        }
    }

    /**
     * The volume of a zone. C: mien_measurement_get_volume().
     * @param zone 0 .. zone_count - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no
     * volume in it)
     */
    public ZoneVolume volume(int zone) {
        try (Call call = new Call()) {
            var measurementAt = call.use(this);
            var outAt = call.sized(80);
            call.check(Raw.GET.mien_measurement_get_volume(Memory.address(measurementAt), zone, Memory.address(outAt), call.error()));
            return ZoneVolume.read(call, outAt, 0);
        }
    }

    /**
     * The distances of a zone. C: mien_measurement_get_distance().
     * @param zone 0 .. zone_count - 1 or MIEN_ZONE_WHOLE.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no
     * distance in it)
     */
    public ZoneDistance distance(int zone) {
        try (Call call = new Call()) {
            var measurementAt = call.use(this);
            var outAt = call.sized(80);
            call.check(Raw.GET.mien_measurement_get_distance(Memory.address(measurementAt), zone, Memory.address(outAt), call.error()));
            return ZoneDistance.read(call, outAt, 0);
        }
    }

    /**
     * Copies a field with one float64 per vertex of the before face; NaN where there was no partner. C:
     * mien_measurement_get_field().
     * @param field MIEN_FIELD_*. See Field.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (this measurement has no such field)
     */
    public double[] field(int field) {
        try (Call call = new Call()) {
            var measurementAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_measurement_get_field(Memory.address(measurementAt), field, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * The whole measurement as JSON text. C: mien_measurement_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public String json() {
        try (Call call = new Call()) {
            var measurementAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_measurement_get_json(Memory.address(measurementAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * The mirror plane of a comparison of left and right. C: mien_measurement_get_mirror_plane().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (another
     * measurement)
     */
    public MirrorPlane mirrorPlane() {
        try (Call call = new Call()) {
            var measurementAt = call.use(this);
            var outAt = call.sized(104);
            call.check(Raw.GET.mien_measurement_get_mirror_plane(Memory.address(measurementAt), Memory.address(outAt), call.error()));
            return MirrorPlane.read(call, outAt, 0);
        }
    }
}

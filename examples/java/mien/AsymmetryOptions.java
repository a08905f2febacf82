package mien;

// Written by abi/generate_bindings.py.
/** mien_asymmetry_options of the C interface. */
public final class AsymmetryOptions implements Record_ {
    private int plane;
    private java.util.List<Zone> zones;
    private Landmarks landmarks;
    private Values normalSd;
    private double correlationLengthMm;

    /** With the library's defaults. */
    public AsymmetryOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(96);
            int offset = 0;
            Raw.GET.mien_asymmetry_options_init(at.address, 96);
            plane = at.bytes.getInt(offset + 4);
            correlationLengthMm = at.bytes.getDouble(offset + 64);
        }
    }

    /** MIEN_MIRROR_BY_*; default by the surface See MirrorBy. */
    public AsymmetryOptions plane(int value) {
        plane = value;
        return this;
    }
    public int plane() { return plane; }

    /** zone_count zones of either side; null: the whole side only */
    public AsymmetryOptions zones(java.util.List<Zone> value) {
        zones = value;
        return this;
    }
    public java.util.List<Zone> zones() { return zones; }

    /** of the template, vertices; may be left out unless the plane is found by them */
    public AsymmetryOptions landmarks(Landmarks value) {
        landmarks = value;
        return this;
    }
    public Landmarks landmarks() { return landmarks; }

    /**
     * #V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count
     * 0: not known, and no interval
     */
    public AsymmetryOptions normalSd(Values value) {
        normalSd = value;
        return this;
    }
    public Values normalSd() { return normalSd; }

    /** over which errors of the surface go together; default 4 */
    public AsymmetryOptions correlationLengthMm(double value) {
        correlationLengthMm = value;
        return this;
    }
    public double correlationLengthMm() { return correlationLengthMm; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_asymmetry_options_init(at.address + offset, 96);
        at.bytes.putInt(offset + 4, plane);
        call.matrix(at, offset + 32, normalSd, 1, "normal_sd");
        at.bytes.putDouble(offset + 64, correlationLengthMm);
        at.bytes.putLong(offset + 8, Memory.address(call.records(zones, 24)));
        at.bytes.putLong(offset + 16, call.rows(zones, 1, "zones"));
        at.bytes.putLong(offset + 24, Memory.address(call.useOrNull(landmarks)));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(96);
        fill(call, at, 0);
        at.bytes.putLong(72, call.progressFunction(progress));
        at.bytes.putLong(80, call.progressUser());
        at.bytes.putLong(88, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

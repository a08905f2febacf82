package mien;

// Written by abi/generate_bindings.py.
/** mien_geodesic_options of the C interface. */
public final class GeodesicOptions implements Record_ {
    private int heatBoundary;
    private double heatTimeFactor;

    /** With the library's defaults. */
    public GeodesicOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(40);
            int offset = 0;
            Raw.GET.mien_geodesic_options_init(at.address, 40);
            heatBoundary = at.bytes.getInt(offset + 4);
            heatTimeFactor = at.bytes.getDouble(offset + 8);
        }
    }

    /** MIEN_HEAT_..., default NEUMANN See Heat. */
    public GeodesicOptions heatBoundary(int value) {
        heatBoundary = value;
        return this;
    }
    public int heatBoundary() { return heatBoundary; }

    /** heat time in units of (mean edge)^2, 0.01 to 10000, default 4 */
    public GeodesicOptions heatTimeFactor(double value) {
        heatTimeFactor = value;
        return this;
    }
    public double heatTimeFactor() { return heatTimeFactor; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_geodesic_options_init(at.address + offset, 40);
        at.bytes.putInt(offset + 4, heatBoundary);
        at.bytes.putDouble(offset + 8, heatTimeFactor);
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(40);
        fill(call, at, 0);
        at.bytes.putLong(16, call.progressFunction(progress));
        at.bytes.putLong(24, call.progressUser());
        at.bytes.putLong(32, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

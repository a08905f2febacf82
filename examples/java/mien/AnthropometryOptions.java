package mien;

// Written by abi/generate_bindings.py.
/** mien_anthropometry_options of the C interface. */
public final class AnthropometryOptions implements Record_ {
    private Values placeSd;
    private Values normalSd;
    private double slideCorrelationMm;
    private double normalCorrelationMm;
    private Norms norms;

    /** With the library's defaults. */
    public AnthropometryOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(120);
            int offset = 0;
            Raw.GET.mien_anthropometry_options_init(at.address, 120);
            slideCorrelationMm = at.bytes.getDouble(offset + 72);
            normalCorrelationMm = at.bytes.getDouble(offset + 80);
        }
    }

    /**
     * #V, mm: deviation of each vertex' place per axis, as MIEN_REGISTRATION_STANDARD_DEVIATION_MM tells it;
     * count 0: not known, and no deviation
     */
    public AnthropometryOptions placeSd(Values value) {
        placeSd = value;
        return this;
    }
    public Values placeSd() { return placeSd; }

    /** #V, mm: along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: as place_sd */
    public AnthropometryOptions normalSd(Values value) {
        normalSd = value;
        return this;
    }
    public Values normalSd() { return normalSd; }

    /** over which a template slides together along the skin; default 15 */
    public AnthropometryOptions slideCorrelationMm(double value) {
        slideCorrelationMm = value;
        return this;
    }
    public double slideCorrelationMm() { return slideCorrelationMm; }

    /** over which it errs together across the skin; default 4 */
    public AnthropometryOptions normalCorrelationMm(double value) {
        normalCorrelationMm = value;
        return this;
    }
    public double normalCorrelationMm() { return normalCorrelationMm; }

    /** may be left out: no z-scores */
    public AnthropometryOptions norms(Norms value) {
        norms = value;
        return this;
    }
    public Norms norms() { return norms; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_anthropometry_options_init(at.address + offset, 120);
        call.matrix(at, offset + 8, placeSd, 1, "place_sd");
        call.matrix(at, offset + 40, normalSd, 1, "normal_sd");
        at.bytes.putDouble(offset + 72, slideCorrelationMm);
        at.bytes.putDouble(offset + 80, normalCorrelationMm);
        at.bytes.putLong(offset + 88, Memory.address(call.useOrNull(norms)));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(120);
        fill(call, at, 0);
        at.bytes.putLong(96, call.progressFunction(progress));
        at.bytes.putLong(104, call.progressUser());
        at.bytes.putLong(112, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** mien_neutralize_options of the C interface. */
public final class NeutralizeOptions implements Record_ {
    private int method;
    private int maxSweeps;
    private int uncertainty;
    private int pose;
    private double toleranceMm;
    private double noiseMm2;
    private double decayMm;
    private Values weights;
    private int[] treated;
    private double treatedMarginMm;

    /** With the library's defaults. */
    public NeutralizeOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(128);
            int offset = 0;
            Raw.GET.mien_neutralize_options_init(at.address, 128);
            method = at.bytes.getInt(offset + 4);
            maxSweeps = at.bytes.getInt(offset + 8);
            uncertainty = at.bytes.getInt(offset + 12);
            pose = at.bytes.getInt(offset + 16);
            toleranceMm = at.bytes.getDouble(offset + 24);
            noiseMm2 = at.bytes.getDouble(offset + 32);
            decayMm = at.bytes.getDouble(offset + 40);
            treatedMarginMm = at.bytes.getDouble(offset + 120);
        }
    }

    /** MIEN_FIT_..., default MIEN_FIT_MIXTURE See Fit. */
    public NeutralizeOptions method(int value) {
        method = value;
        return this;
    }
    public int method() { return method; }

    /** alternating; 1 to 100000, default 200 */
    public NeutralizeOptions maxSweeps(int value) {
        maxSweeps = value;
        return this;
    }
    public int maxSweeps() { return maxSweeps; }

    /** 1: compute the deviation per vertex; default 0 */
    public NeutralizeOptions uncertainty(int value) {
        uncertainty = value;
        return this;
    }
    public int uncertainty() { return uncertainty; }

    /** MIEN_POSE_..., default MIEN_POSE_AUTO See Pose. */
    public NeutralizeOptions pose(int value) {
        pose = value;
        return this;
    }
    public int pose() { return pose; }

    /** alternating: stop when a sweep moves less; default 1e-6 */
    public NeutralizeOptions toleranceMm(double value) {
        toleranceMm = value;
        return this;
    }
    public double toleranceMm() { return toleranceMm; }

    /** 0 (default): the model's own */
    public NeutralizeOptions noiseMm2(double value) {
        noiseMm2 = value;
        return this;
    }
    public double noiseMm2() { return noiseMm2; }

    /** how far a displacement reaches beyond the model's rim; default 25 */
    public NeutralizeOptions decayMm(double value) {
        decayMm = value;
        return this;
    }
    public double decayMm() { return decayMm; }

    /** #V x 1, &gt;= 0: 0 where the scan had no data; count 0: all one */
    public NeutralizeOptions weights(Values value) {
        weights = value;
        return this;
    }
    public Values weights() { return weights; }

    /**
     * treated_count vertices where the person may have been changed: no witness of expression or pose, so that
     * filler in a lip stays on the face and is not taken for a rolled lip; null: none. Since 0.2
     */
    public NeutralizeOptions treated(int[] value) {
        treated = value;
        return this;
    }
    public int[] treated() { return treated; }

    /** around them, no witness either; treatments spread; 0 to 100, default 10 */
    public NeutralizeOptions treatedMarginMm(double value) {
        treatedMarginMm = value;
        return this;
    }
    public double treatedMarginMm() { return treatedMarginMm; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_neutralize_options_init(at.address + offset, 128);
        at.bytes.putInt(offset + 4, method);
        at.bytes.putInt(offset + 8, maxSweeps);
        at.bytes.putInt(offset + 12, uncertainty);
        at.bytes.putInt(offset + 16, pose);
        at.bytes.putDouble(offset + 24, toleranceMm);
        at.bytes.putDouble(offset + 32, noiseMm2);
        at.bytes.putDouble(offset + 40, decayMm);
        call.matrix(at, offset + 48, weights, 1, "weights");
        at.bytes.putDouble(offset + 120, treatedMarginMm);
        at.bytes.putLong(offset + 104, Memory.address(call.array(treated)));
        at.bytes.putLong(offset + 112, call.rows(treated, 1, "treated"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(128);
        fill(call, at, 0);
        at.bytes.putLong(80, call.progressFunction(progress));
        at.bytes.putLong(88, call.progressUser());
        at.bytes.putLong(96, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

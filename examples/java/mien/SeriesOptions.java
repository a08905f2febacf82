package mien;

// Written by abi/generate_bindings.py.
/** mien_series_options of the C interface. */
public final class SeriesOptions implements Record_ {
    private int method;
    private int pose;
    private double scanNoiseShare;
    private double noiseMm2;
    private int[] changingVertices;
    private double expectedChangeMm;
    private Values weights;

    /** With the library's defaults. */
    public SeriesOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(112);
            int offset = 0;
            Raw.GET.mien_series_options_init(at.address, 112);
            method = at.bytes.getInt(offset + 4);
            pose = at.bytes.getInt(offset + 8);
            scanNoiseShare = at.bytes.getDouble(offset + 16);
            noiseMm2 = at.bytes.getDouble(offset + 24);
            expectedChangeMm = at.bytes.getDouble(offset + 48);
        }
    }

    /** MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP See Fit. */
    public SeriesOptions method(int value) {
        method = value;
        return this;
    }
    public int method() { return method; }

    /** MIEN_POSE_..., default MIEN_POSE_AUTO See Pose. */
    public SeriesOptions pose(int value) {
        pose = value;
        return this;
    }
    public int pose() { return pose; }

    /** what differs between scans beyond the model, as a share of the noise variance; default 0.01 */
    public SeriesOptions scanNoiseShare(double value) {
        scanNoiseShare = value;
        return this;
    }
    public double scanNoiseShare() { return scanNoiseShare; }

    /** noise variance; 0 (default): the model's own */
    public SeriesOptions noiseMm2(double value) {
        noiseMm2 = value;
        return this;
    }
    public double noiseMm2() { return noiseMm2; }

    /** where the identity may change between scans; null: nowhere */
    public SeriesOptions changingVertices(int[] value) {
        changingVertices = value;
        return this;
    }
    public int[] changingVertices() { return changingVertices; }

    /** &gt; 0, default 5; without effect since 0.2: what lies there is no witness of the expression at all */
    public SeriesOptions expectedChangeMm(double value) {
        expectedChangeMm = value;
        return this;
    }
    public double expectedChangeMm() { return expectedChangeMm; }

    /** face_count x #V, face by face, &gt;= 0: 0 where a scan had no data; count 0: all one. */
    public SeriesOptions weights(Values value) {
        weights = value;
        return this;
    }
    public Values weights() { return weights; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_series_options_init(at.address + offset, 112);
        at.bytes.putInt(offset + 4, method);
        at.bytes.putInt(offset + 8, pose);
        at.bytes.putDouble(offset + 16, scanNoiseShare);
        at.bytes.putDouble(offset + 24, noiseMm2);
        at.bytes.putDouble(offset + 48, expectedChangeMm);
        call.matrix(at, offset + 80, weights, 1, "weights");
        at.bytes.putLong(offset + 32, Memory.address(call.array(changingVertices)));
        at.bytes.putLong(offset + 40, call.rows(changingVertices, 1, "changing_vertices"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(112);
        fill(call, at, 0);
        at.bytes.putLong(56, call.progressFunction(progress));
        at.bytes.putLong(64, call.progressUser());
        at.bytes.putLong(72, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** mien_visits_options of the C interface. */
public final class VisitsOptions implements Record_ {
    private int pose;
    private double normalNoiseMm2;
    private double tangentialNoiseMm2;
    private int[] treatedVertices;
    private Values weights;

    /** With the library's defaults. */
    public VisitsOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(96);
            int offset = 0;
            Raw.GET.mien_visits_options_init(at.address, 96);
            pose = at.bytes.getInt(offset + 4);
            normalNoiseMm2 = at.bytes.getDouble(offset + 8);
            tangentialNoiseMm2 = at.bytes.getDouble(offset + 16);
        }
    }

    /** MIEN_POSE_..., default MIEN_POSE_AUTO See Pose. */
    public VisitsOptions pose(int value) {
        pose = value;
        return this;
    }
    public int pose() { return pose; }

    /** variance of a fitted vertex along the skin's normal, with what no mode explains; default 0.3 */
    public VisitsOptions normalNoiseMm2(double value) {
        normalNoiseMm2 = value;
        return this;
    }
    public double normalNoiseMm2() { return normalNoiseMm2; }

    /** along the skin: fits slide; default 30 */
    public VisitsOptions tangentialNoiseMm2(double value) {
        tangentialNoiseMm2 = value;
        return this;
    }
    public double tangentialNoiseMm2() { return tangentialNoiseMm2; }

    /** where the person may have changed: no witness of the expression; null: nowhere */
    public VisitsOptions treatedVertices(int[] value) {
        treatedVertices = value;
        return this;
    }
    public int[] treatedVertices() { return treatedVertices; }

    /** face_count x #V, face by face, &gt;= 0: 0 where a scan had no data; count 0: all one */
    public VisitsOptions weights(Values value) {
        weights = value;
        return this;
    }
    public Values weights() { return weights; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_visits_options_init(at.address + offset, 96);
        at.bytes.putInt(offset + 4, pose);
        at.bytes.putDouble(offset + 8, normalNoiseMm2);
        at.bytes.putDouble(offset + 16, tangentialNoiseMm2);
        call.matrix(at, offset + 40, weights, 1, "weights");
        at.bytes.putLong(offset + 24, Memory.address(call.array(treatedVertices)));
        at.bytes.putLong(offset + 32, call.rows(treatedVertices, 1, "treated_vertices"));
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

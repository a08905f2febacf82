package mien;

// Written by abi/generate_bindings.py.
/** mien_evaluate_options of the C interface. */
public final class EvaluateOptions implements Record_ {
    private int method;
    private int maxSweeps;
    private int againstMethod;
    private int againstMaxSweeps;
    private ExpressionModel against;
    private int[] zoneVertices;
    private int[] stableVertices;
    private java.util.List<Zone> volumeZones;

    /** With the library's defaults. */
    public EvaluateOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(104);
            int offset = 0;
            Raw.GET.mien_evaluate_options_init(at.address, 104);
            method = at.bytes.getInt(offset + 4);
            maxSweeps = at.bytes.getInt(offset + 8);
            againstMethod = at.bytes.getInt(offset + 12);
            againstMaxSweeps = at.bytes.getInt(offset + 16);
        }
    }

    /** MIEN_FIT_..., default MIEN_FIT_MIXTURE See Fit. */
    public EvaluateOptions method(int value) {
        method = value;
        return this;
    }
    public int method() { return method; }

    /** of the method; default 200 */
    public EvaluateOptions maxSweeps(int value) {
        maxSweeps = value;
        return this;
    }
    public int maxSweeps() { return maxSweeps; }

    /** MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING See Fit. */
    public EvaluateOptions againstMethod(int value) {
        againstMethod = value;
        return this;
    }
    public int againstMethod() { return againstMethod; }

    /** default 3 */
    public EvaluateOptions againstMaxSweeps(int value) {
        againstMaxSweeps = value;
        return this;
    }
    public int againstMaxSweeps() { return againstMaxSweeps; }

    /** second model to compare with; may be left out */
    public EvaluateOptions against(ExpressionModel value) {
        against = value;
        return this;
    }
    public ExpressionModel against() { return against; }

    /** measure on these vertices only; null: all */
    public EvaluateOptions zoneVertices(int[] value) {
        zoneVertices = value;
        return this;
    }
    public int[] zoneVertices() { return zoneVertices; }

    /** align every face rigidly to its target on these first; null: not */
    public EvaluateOptions stableVertices(int[] value) {
        stableVertices = value;
        return this;
    }
    public int[] stableVertices() { return stableVertices; }

    /** absolute volumes to the neutral face are measured in these, too; null: none. Since 0.2 */
    public EvaluateOptions volumeZones(java.util.List<Zone> value) {
        volumeZones = value;
        return this;
    }
    public java.util.List<Zone> volumeZones() { return volumeZones; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_evaluate_options_init(at.address + offset, 104);
        at.bytes.putInt(offset + 4, method);
        at.bytes.putInt(offset + 8, maxSweeps);
        at.bytes.putInt(offset + 12, againstMethod);
        at.bytes.putInt(offset + 16, againstMaxSweeps);
        at.bytes.putLong(offset + 24, Memory.address(call.useOrNull(against)));
        at.bytes.putLong(offset + 32, Memory.address(call.array(zoneVertices)));
        at.bytes.putLong(offset + 40, call.rows(zoneVertices, 1, "zone_vertices"));
        at.bytes.putLong(offset + 48, Memory.address(call.array(stableVertices)));
        at.bytes.putLong(offset + 56, call.rows(stableVertices, 1, "stable_vertices"));
        at.bytes.putLong(offset + 88, Memory.address(call.records(volumeZones, 24)));
        at.bytes.putLong(offset + 96, call.rows(volumeZones, 1, "volume_zones"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(104);
        fill(call, at, 0);
        at.bytes.putLong(64, call.progressFunction(progress));
        at.bytes.putLong(72, call.progressUser());
        at.bytes.putLong(80, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** mien_score_options of the C interface. */
public final class ScoreOptions implements Record_ {
    private int method;
    private int numComponents;
    private int maxComponents;
    private int folds;
    private long seed;
    private double curvatureShare;
    private double curvatureRadiusMm;
    private double lowest;
    private double highest;
    private int[] zoneVertices;
    private int[] stableVertices;
    private int focus;
    private int features;

    /** With the library's defaults. */
    public ScoreOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(136);
            int offset = 0;
            Raw.GET.mien_score_options_init(at.address, 136);
            method = at.bytes.getInt(offset + 4);
            numComponents = at.bytes.getInt(offset + 8);
            maxComponents = at.bytes.getInt(offset + 12);
            folds = at.bytes.getInt(offset + 16);
            seed = at.bytes.getLong(offset + 24);
            curvatureShare = at.bytes.getDouble(offset + 32);
            curvatureRadiusMm = at.bytes.getDouble(offset + 40);
            lowest = at.bytes.getDouble(offset + 48);
            highest = at.bytes.getDouble(offset + 56);
            focus = at.bytes.getInt(offset + 120);
            features = at.bytes.getInt(offset + 128);
        }
    }

    /** MIEN_PLS_*; default NIPALS See Pls. */
    public ScoreOptions method(int value) {
        method = value;
        return this;
    }
    public int method() { return method; }

    /** 0 (default): by cross-validation and the one-standard-error rule */
    public ScoreOptions numComponents(int value) {
        numComponents = value;
        return this;
    }
    public int numComponents() { return numComponents; }

    /** tried in cross-validation, 1 to 50; default 10 */
    public ScoreOptions maxComponents(int value) {
        maxComponents = value;
        return this;
    }
    public int maxComponents() { return maxComponents; }

    /** over subjects; 0: leave one subject out; default 10 */
    public ScoreOptions folds(int value) {
        folds = value;
        return this;
    }
    public int folds() { return folds; }

    /** of the folds; default 1 */
    public ScoreOptions seed(long value) {
        seed = value;
        return this;
    }
    public long seed() { return seed; }

    /** total variance of the curvature features over that of the displacements; 0: none; default 0.1 */
    public ScoreOptions curvatureShare(double value) {
        curvatureShare = value;
        return this;
    }
    public double curvatureShare() { return curvatureShare; }

    /** of the fits that estimate curvature; default 8 */
    public ScoreOptions curvatureRadiusMm(double value) {
        curvatureRadiusMm = value;
        return this;
    }
    public double curvatureRadiusMm() { return curvatureRadiusMm; }

    /** range that predictions are cut to */
    public ScoreOptions lowest(double value) {
        lowest = value;
        return this;
    }
    public double lowest() { return lowest; }

    /** equal (default): none */
    public ScoreOptions highest(double value) {
        highest = value;
        return this;
    }
    public double highest() { return highest; }

    /** of interest; null: all */
    public ScoreOptions zoneVertices(int[] value) {
        zoneVertices = value;
        return this;
    }
    public int[] zoneVertices() { return zoneVertices; }

    /** faces are aligned on these; null: on all, robustly */
    public ScoreOptions stableVertices(int[] value) {
        stableVertices = value;
        return this;
    }
    public int[] stableVertices() { return stableVertices; }

    /**
     * 1 (default): vertices count by how far they move with the score, found anew in each fold; 0: by their area
     * alone
     */
    public ScoreOptions focus(int value) {
        focus = value;
        return this;
    }
    public int focus() { return focus; }

    /** MIEN_SCORE_FEATURES_*; default displacement and curvature. Since 0.2 See ScoreFeatures. */
    public ScoreOptions features(int value) {
        features = value;
        return this;
    }
    public int features() { return features; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_score_options_init(at.address + offset, 136);
        at.bytes.putInt(offset + 4, method);
        at.bytes.putInt(offset + 8, numComponents);
        at.bytes.putInt(offset + 12, maxComponents);
        at.bytes.putInt(offset + 16, folds);
        at.bytes.putLong(offset + 24, seed);
        at.bytes.putDouble(offset + 32, curvatureShare);
        at.bytes.putDouble(offset + 40, curvatureRadiusMm);
        at.bytes.putDouble(offset + 48, lowest);
        at.bytes.putDouble(offset + 56, highest);
        at.bytes.putInt(offset + 120, focus);
        at.bytes.putInt(offset + 128, features);
        at.bytes.putLong(offset + 64, Memory.address(call.array(zoneVertices)));
        at.bytes.putLong(offset + 72, call.rows(zoneVertices, 1, "zone_vertices"));
        at.bytes.putLong(offset + 80, Memory.address(call.array(stableVertices)));
        at.bytes.putLong(offset + 88, call.rows(stableVertices, 1, "stable_vertices"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(136);
        fill(call, at, 0);
        at.bytes.putLong(96, call.progressFunction(progress));
        at.bytes.putLong(104, call.progressUser());
        at.bytes.putLong(112, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

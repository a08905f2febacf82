package mien;

// Written by abi/generate_bindings.py.
/** mien_train_options of the C interface. */
public final class TrainOptions implements Record_ {
    private int method;
    private int identityModes;
    private int expressionModes;
    private int maxIterations;
    private int passes;
    private double lambda;
    private double lambdaFactor;
    private double angleToleranceRad;
    private double noiseMm2;
    private int[] stableVertices;

    /** With the library's defaults. */
    public TrainOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(96);
            int offset = 0;
            Raw.GET.mien_train_options_init(at.address, 96);
            method = at.bytes.getInt(offset + 4);
            identityModes = at.bytes.getInt(offset + 8);
            expressionModes = at.bytes.getInt(offset + 12);
            maxIterations = at.bytes.getInt(offset + 16);
            passes = at.bytes.getInt(offset + 20);
            lambda = at.bytes.getDouble(offset + 24);
            lambdaFactor = at.bytes.getDouble(offset + 32);
            angleToleranceRad = at.bytes.getDouble(offset + 40);
            noiseMm2 = at.bytes.getDouble(offset + 48);
        }
    }

    /** MIEN_TRAIN_..., default MIEN_TRAIN_JPCA See Train. */
    public TrainOptions method(int value) {
        method = value;
        return this;
    }
    public int method() { return method; }

    /**
     * 1 to 4000; 0 (default since 0.2, 50 before): of 25, 50, 75 and 100 the fewest that serve people left out of
     * the training
     */
    public TrainOptions identityModes(int value) {
        identityModes = value;
        return this;
    }
    public int identityModes() { return identityModes; }

    /** 1 to 4000; 0 (default): as above */
    public TrainOptions expressionModes(int value) {
        expressionModes = value;
        return this;
    }
    public int expressionModes() { return expressionModes; }

    /** QOJPCA; default 1000 */
    public TrainOptions maxIterations(int value) {
        maxIterations = value;
        return this;
    }
    public int maxIterations() { return maxIterations; }

    /** over the data, 1 to 50, default 4 */
    public TrainOptions passes(int value) {
        passes = value;
        return this;
    }
    public int passes() { return passes; }

    /** QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX' */
    public TrainOptions lambda(double value) {
        lambda = value;
        return this;
    }
    public double lambda() { return lambda; }

    /** default 10 */
    public TrainOptions lambdaFactor(double value) {
        lambdaFactor = value;
        return this;
    }
    public double lambdaFactor() { return lambdaFactor; }

    /** QOJPCA stops when no subspace turns farther; default 0.001 */
    public TrainOptions angleToleranceRad(double value) {
        angleToleranceRad = value;
        return this;
    }
    public double angleToleranceRad() { return angleToleranceRad; }

    /** noise variance of the fits; 0 (default): by cross-validation */
    public TrainOptions noiseMm2(double value) {
        noiseMm2 = value;
        return this;
    }
    public double noiseMm2() { return noiseMm2; }

    /**
     * posture: every face is aligned rigidly on these vertices (forehead, nose bridge), in training and in every
     * fit; null: faces as they lie
     */
    public TrainOptions stableVertices(int[] value) {
        stableVertices = value;
        return this;
    }
    public int[] stableVertices() { return stableVertices; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_train_options_init(at.address + offset, 96);
        at.bytes.putInt(offset + 4, method);
        at.bytes.putInt(offset + 8, identityModes);
        at.bytes.putInt(offset + 12, expressionModes);
        at.bytes.putInt(offset + 16, maxIterations);
        at.bytes.putInt(offset + 20, passes);
        at.bytes.putDouble(offset + 24, lambda);
        at.bytes.putDouble(offset + 32, lambdaFactor);
        at.bytes.putDouble(offset + 40, angleToleranceRad);
        at.bytes.putDouble(offset + 48, noiseMm2);
        at.bytes.putLong(offset + 56, Memory.address(call.array(stableVertices)));
        at.bytes.putLong(offset + 64, call.rows(stableVertices, 1, "stable_vertices"));
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

package mien;

// Written by abi/generate_bindings.py.
/** mien_tune_options of the C interface. */
public final class TuneOptions implements Record_ {
    private int kernel;
    private double[] sigmasMm;
    private double scaleMm;
    private double nu;
    private double rho;
    private int levels;
    private int numModes;
    private java.util.List<String> expressions;
    private int maxSubjects;
    private double[] scalesMm;
    private int[] levelCounts;

    /** With the library's defaults. */
    public TuneOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(128);
            int offset = 0;
            Raw.GET.mien_tune_options_init(at.address, 128);
            kernel = at.bytes.getInt(offset + 4);
            scaleMm = at.bytes.getDouble(offset + 24);
            nu = at.bytes.getDouble(offset + 32);
            rho = at.bytes.getDouble(offset + 40);
            levels = at.bytes.getInt(offset + 48);
            numModes = at.bytes.getInt(offset + 52);
            maxSubjects = at.bytes.getInt(offset + 68);
        }
    }

    /** MIEN_KERNEL_..., not NONE; default GEODESIC_SE See KernelKind. */
    public TuneOptions kernel(int value) {
        kernel = value;
        return this;
    }
    public int kernel() { return kernel; }

    /** sigma_count length scales to try, each &gt; 0 */
    public TuneOptions sigmasMm(double[] value) {
        sigmasMm = value;
        return this;
    }
    public double[] sigmasMm() { return sigmasMm; }

    /** &gt; 0, default 1 */
    public TuneOptions scaleMm(double value) {
        scaleMm = value;
        return this;
    }
    public double scaleMm() { return scaleMm; }

    /** default 2 */
    public TuneOptions nu(double value) {
        nu = value;
        return this;
    }
    public double nu() { return nu; }

    /** weight of the prior in the fits, &gt;= 0, default 5 */
    public TuneOptions rho(double value) {
        rho = value;
        return this;
    }
    public double rho() { return rho; }

    /** 1 to 12, default 1 */
    public TuneOptions levels(int value) {
        levels = value;
        return this;
    }
    public int levels() { return levels; }

    /** deformation modes, &gt;= 3, default 999 */
    public TuneOptions numModes(int value) {
        numModes = value;
        return this;
    }
    public int numModes() { return numModes; }

    /** expression_count names: these faces only; null: all */
    public TuneOptions expressions(java.util.List<String> value) {
        expressions = value;
        return this;
    }
    public java.util.List<String> expressions() { return expressions; }

    /** of the dataset's order; 0 (default): all */
    public TuneOptions maxSubjects(int value) {
        maxSubjects = value;
        return this;
    }
    public int maxSubjects() { return maxSubjects; }

    /** scale_count scales to try with each sigma, each &gt; 0; null: scale_mm alone */
    public TuneOptions scalesMm(double[] value) {
        scalesMm = value;
        return this;
    }
    public double[] scalesMm() { return scalesMm; }

    /** level_count numbers of levels to try with each of those, each 1 to 12; null: `levels` alone */
    public TuneOptions levelCounts(int[] value) {
        levelCounts = value;
        return this;
    }
    public int[] levelCounts() { return levelCounts; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_tune_options_init(at.address + offset, 128);
        at.bytes.putInt(offset + 4, kernel);
        at.bytes.putDouble(offset + 24, scaleMm);
        at.bytes.putDouble(offset + 32, nu);
        at.bytes.putDouble(offset + 40, rho);
        at.bytes.putInt(offset + 48, levels);
        at.bytes.putInt(offset + 52, numModes);
        at.bytes.putInt(offset + 68, maxSubjects);
        call.required(sigmasMm, "sigmas_mm");
        at.bytes.putLong(offset + 8, Memory.address(call.array(sigmasMm)));
        at.bytes.putLong(offset + 16, call.rows(sigmasMm, 1, "sigmas_mm"));
        at.bytes.putLong(offset + 56, Memory.address(call.texts(expressions)));
        at.bytes.putInt(offset + 64, (int) call.rows(expressions, 1, "expressions"));
        at.bytes.putLong(offset + 96, Memory.address(call.array(scalesMm)));
        at.bytes.putLong(offset + 104, call.rows(scalesMm, 1, "scales_mm"));
        at.bytes.putLong(offset + 112, Memory.address(call.array(levelCounts)));
        at.bytes.putLong(offset + 120, call.rows(levelCounts, 1, "level_counts"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(128);
        fill(call, at, 0);
        at.bytes.putLong(72, call.progressFunction(progress));
        at.bytes.putLong(80, call.progressUser());
        at.bytes.putLong(88, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

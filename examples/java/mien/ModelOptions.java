package mien;

// Written by abi/generate_bindings.py.
/** mien_model_options of the C interface. */
public final class ModelOptions implements Record_ {
    private int kernel;
    private double sigmaMm;
    private double scaleMm;
    private double nu;
    private int levels;
    private int numModes;
    private java.util.List<Kernel> kernels;
    private double tolerance;
    private int numControlPoints;
    private int mirrorSymmetric;
    private double mirrorCorrelation;
    private double eigenvalueThreshold;
    private double heatTimeFactor;
    private int heatBoundary;
    private int pcaModes;
    private String pcaDataset;
    private double pcaVariance;
    private int pcaAllExpressions;
    private int pcaAlign;
    private Values scalePerVertex;
    private java.util.List<Landmark> landmarks;
    private java.util.List<Zone> zones;

    /** With the library's defaults. */
    public ModelOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(216);
            int offset = 0;
            Raw.GET.mien_model_options_init(at.address, 216);
            kernel = at.bytes.getInt(offset + 4);
            sigmaMm = at.bytes.getDouble(offset + 8);
            scaleMm = at.bytes.getDouble(offset + 16);
            nu = at.bytes.getDouble(offset + 24);
            levels = at.bytes.getInt(offset + 32);
            numModes = at.bytes.getInt(offset + 36);
            tolerance = at.bytes.getDouble(offset + 56);
            numControlPoints = at.bytes.getInt(offset + 64);
            mirrorSymmetric = at.bytes.getInt(offset + 68);
            mirrorCorrelation = at.bytes.getDouble(offset + 72);
            eigenvalueThreshold = at.bytes.getDouble(offset + 80);
            heatTimeFactor = at.bytes.getDouble(offset + 88);
            heatBoundary = at.bytes.getInt(offset + 96);
            pcaModes = at.bytes.getInt(offset + 100);
            pcaVariance = at.bytes.getDouble(offset + 112);
            pcaAllExpressions = at.bytes.getInt(offset + 120);
            pcaAlign = at.bytes.getInt(offset + 124);
        }
    }

    /** MIEN_KERNEL_..., default GEODESIC_SE See KernelKind. */
    public ModelOptions kernel(int value) {
        kernel = value;
        return this;
    }
    public int kernel() { return kernel; }

    /** length scale; full width for BSPLINE; &gt; 0, default 20 */
    public ModelOptions sigmaMm(double value) {
        sigmaMm = value;
        return this;
    }
    public double sigmaMm() { return sigmaMm; }

    /** standard deviation of a displacement's coordinate; &gt; 0, default 3 */
    public ModelOptions scaleMm(double value) {
        scaleMm = value;
        return this;
    }
    public double scaleMm() { return scaleMm; }

    /** smoothness of SURFACE_MATERN, 0.1 to 20, default 2 */
    public ModelOptions nu(double value) {
        nu = value;
        return this;
    }
    public double nu() { return nu; }

    /** 1 to 12, default 1: sum of kernels with sigma, 2 sigma, 4 sigma, ... */
    public ModelOptions levels(int value) {
        levels = value;
        return this;
    }
    public int levels() { return levels; }

    /** deformation modes at most, 3 per scalar mode; &gt;= 3, default 999 */
    public ModelOptions numModes(int value) {
        numModes = value;
        return this;
    }
    public int numModes() { return numModes; }

    /** kernel_count kernels added to the one above; may be left out */
    public ModelOptions kernels(java.util.List<Kernel> value) {
        kernels = value;
        return this;
    }
    public java.util.List<Kernel> kernels() { return kernels; }

    /** &gt; 0: stop once this share of the variance is left; default 0 */
    public ModelOptions tolerance(double value) {
        tolerance = value;
        return this;
    }
    public double tolerance() { return tolerance; }

    /** default 0: max(1000, num_modes), never more than #V */
    public ModelOptions numControlPoints(int value) {
        numControlPoints = value;
        return this;
    }
    public int numControlPoints() { return numControlPoints; }

    /** 1: modes purely even or odd about the plane x = 0; default 0 */
    public ModelOptions mirrorSymmetric(int value) {
        mirrorSymmetric = value;
        return this;
    }
    public int mirrorSymmetric() { return mirrorSymmetric; }

    /** 0 to 1: how much both sides are expected to move alike; default 0 */
    public ModelOptions mirrorCorrelation(double value) {
        mirrorCorrelation = value;
        return this;
    }
    public double mirrorCorrelation() { return mirrorCorrelation; }

    /**
     * eigenvalues among the control points below this share of the largest are dropped; 0 &lt; x &lt; 1, default
     * 0.0001
     */
    public ModelOptions eigenvalueThreshold(double value) {
        eigenvalueThreshold = value;
        return this;
    }
    public double eigenvalueThreshold() { return eigenvalueThreshold; }

    /** heat time in units of (mean edge)^2, 0.01 to 10000, default 4 */
    public ModelOptions heatTimeFactor(double value) {
        heatTimeFactor = value;
        return this;
    }
    public double heatTimeFactor() { return heatTimeFactor; }

    /** MIEN_HEAT_..., default NEUMANN See Heat. */
    public ModelOptions heatBoundary(int value) {
        heatBoundary = value;
        return this;
    }
    public int heatBoundary() { return heatBoundary; }

    /** default 0: as many as pca_variance asks for */
    public ModelOptions pcaModes(int value) {
        pcaModes = value;
        return this;
    }
    public int pcaModes() { return pcaModes; }

    /**
     * UTF-8 path of a dataset of registered faces, or null: adds their mean and principal modes; the kernel then
     * stands for what they leave over: of three people or more, for what they leave of people left out (info
     * pca_left_out_mm of the model's JSON)
     */
    public ModelOptions pcaDataset(String value) {
        pcaDataset = value;
        return this;
    }
    public String pcaDataset() { return pcaDataset; }

    /** share of the faces' variance kept, 0 to 1, default 0.999 */
    public ModelOptions pcaVariance(double value) {
        pcaVariance = value;
        return this;
    }
    public double pcaVariance() { return pcaVariance; }

    /** 1 (default): all faces, 0: neutral ones */
    public ModelOptions pcaAllExpressions(int value) {
        pcaAllExpressions = value;
        return this;
    }
    public int pcaAllExpressions() { return pcaAllExpressions; }

    /** 1: move each face rigidly onto the template first; default 0 */
    public ModelOptions pcaAlign(int value) {
        pcaAlign = value;
        return this;
    }
    public int pcaAlign() { return pcaAlign; }

    /** #V x 1 factors &gt;= 0 of scale_mm; count 0: one everywhere */
    public ModelOptions scalePerVertex(Values value) {
        scalePerVertex = value;
        return this;
    }
    public Values scalePerVertex() { return scalePerVertex; }

    /** landmark_count; may be left out */
    public ModelOptions landmarks(java.util.List<Landmark> value) {
        landmarks = value;
        return this;
    }
    public java.util.List<Landmark> landmarks() { return landmarks; }

    /** zone_count; may be left out */
    public ModelOptions zones(java.util.List<Zone> value) {
        zones = value;
        return this;
    }
    public java.util.List<Zone> zones() { return zones; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_model_options_init(at.address + offset, 216);
        at.bytes.putInt(offset + 4, kernel);
        at.bytes.putDouble(offset + 8, sigmaMm);
        at.bytes.putDouble(offset + 16, scaleMm);
        at.bytes.putDouble(offset + 24, nu);
        at.bytes.putInt(offset + 32, levels);
        at.bytes.putInt(offset + 36, numModes);
        at.bytes.putDouble(offset + 56, tolerance);
        at.bytes.putInt(offset + 64, numControlPoints);
        at.bytes.putInt(offset + 68, mirrorSymmetric);
        at.bytes.putDouble(offset + 72, mirrorCorrelation);
        at.bytes.putDouble(offset + 80, eigenvalueThreshold);
        at.bytes.putDouble(offset + 88, heatTimeFactor);
        at.bytes.putInt(offset + 96, heatBoundary);
        at.bytes.putInt(offset + 100, pcaModes);
        at.bytes.putDouble(offset + 112, pcaVariance);
        at.bytes.putInt(offset + 120, pcaAllExpressions);
        at.bytes.putInt(offset + 124, pcaAlign);
        call.matrix(at, offset + 128, scalePerVertex, 1, "scale_per_vertex");
        at.bytes.putLong(offset + 40, Memory.address(call.records(kernels, 32)));
        at.bytes.putLong(offset + 48, call.rows(kernels, 1, "kernels"));
        at.bytes.putLong(offset + 104, Memory.address(call.textOrNull(pcaDataset)));
        at.bytes.putLong(offset + 160, Memory.address(call.records(landmarks, 16)));
        at.bytes.putLong(offset + 168, call.rows(landmarks, 1, "landmarks"));
        at.bytes.putLong(offset + 176, Memory.address(call.records(zones, 24)));
        at.bytes.putLong(offset + 184, call.rows(zones, 1, "zones"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(216);
        fill(call, at, 0);
        at.bytes.putLong(192, call.progressFunction(progress));
        at.bytes.putLong(200, call.progressUser());
        at.bytes.putLong(208, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

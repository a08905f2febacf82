package mien;

// Written by abi/generate_bindings.py.
/** mien_register_options of the C interface. */
public final class RegisterOptions implements Record_ {
    private int growth;
    private java.util.List<ScanLandmark> landmarks;
    private double landmarkSigmaMm;
    private int start;
    private int units;
    private Values scanWeights;
    private int skinWeights;
    private int closeGap;
    private int maxScalarModes;
    private int maxPcaModes;
    private int iterations;
    private int rejectBorder;
    private double sigmaStartMm;
    private double sigmaEndMm;
    private double maxAngleDeg;
    private double[] startRotation;
    private double[] startTranslation;
    private double startScale;
    private int colorFeatures;
    private double unitToMm;
    private int landmarkSides;
    private double maxDistanceMm;
    private double mutualMm;
    private double softMm;

    /** With the library's defaults. */
    public RegisterOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(296);
            int offset = 0;
            Raw.GET.mien_register_options_init(at.address, 296);
            growth = at.bytes.getInt(offset + 4);
            landmarkSigmaMm = at.bytes.getDouble(offset + 24);
            start = at.bytes.getInt(offset + 32);
            units = at.bytes.getInt(offset + 36);
            skinWeights = at.bytes.getInt(offset + 72);
            closeGap = at.bytes.getInt(offset + 76);
            maxScalarModes = at.bytes.getInt(offset + 80);
            maxPcaModes = at.bytes.getInt(offset + 84);
            iterations = at.bytes.getInt(offset + 88);
            rejectBorder = at.bytes.getInt(offset + 92);
            sigmaStartMm = at.bytes.getDouble(offset + 96);
            sigmaEndMm = at.bytes.getDouble(offset + 104);
            maxAngleDeg = at.bytes.getDouble(offset + 112);
            startRotation = at.doubles(offset + 120, 9);
            startTranslation = at.doubles(offset + 192, 3);
            startScale = at.bytes.getDouble(offset + 216);
            colorFeatures = at.bytes.getInt(offset + 248);
            unitToMm = at.bytes.getDouble(offset + 256);
            landmarkSides = at.bytes.getInt(offset + 264);
            maxDistanceMm = at.bytes.getDouble(offset + 272);
            mutualMm = at.bytes.getDouble(offset + 280);
            softMm = at.bytes.getDouble(offset + 288);
        }
    }

    /** MIEN_GROWTH_*; default constant, with annealed noise See Growth. */
    public RegisterOptions growth(int value) {
        growth = value;
        return this;
    }
    public int growth() { return growth; }

    /**
     * landmark_count landmarks; null: none. Ones that contradict the others are left out; where all lie to one
     * side of the face they are moved back onto it, and a note of the report says by how much
     */
    public RegisterOptions landmarks(java.util.List<ScanLandmark> value) {
        landmarks = value;
        return this;
    }
    public java.util.List<ScanLandmark> landmarks() { return landmarks; }

    /** picking error per axis, &gt; 0; default 2 */
    public RegisterOptions landmarkSigmaMm(double value) {
        landmarkSigmaMm = value;
        return this;
    }
    public double landmarkSigmaMm() { return landmarkSigmaMm; }

    /** MIEN_START_*; default automatic See Start. */
    public RegisterOptions start(int value) {
        start = value;
        return this;
    }
    public int start() { return start; }

    /** MIEN_UNITS_*; default detect See Units. */
    public RegisterOptions units(int value) {
        units = value;
        return this;
    }
    public int units() { return units; }

    /** one weight in [0, 1] per scan vertex; count 0: all one */
    public RegisterOptions scanWeights(Values value) {
        scanWeights = value;
        return this;
    }
    public Values scanWeights() { return scanWeights; }

    /** 1: weigh scan vertices by the probability of skin colour; default 0 */
    public RegisterOptions skinWeights(int value) {
        skinWeights = value;
        return this;
    }
    public int skinWeights() { return skinWeights; }

    /** 1 (default): a smooth field closes what the modes leave open */
    public RegisterOptions closeGap(int value) {
        closeGap = value;
        return this;
    }
    public int closeGap() { return closeGap; }

    /** of the model's kernel modes; default -1: all */
    public RegisterOptions maxScalarModes(int value) {
        maxScalarModes = value;
        return this;
    }
    public int maxScalarModes() { return maxScalarModes; }

    /**
     * of the model's trained modes; default -1: all. Left out where the landmarks, or without them what the fit
     * leaves of the surface, say that the face is outside of what they span (a note tells)
     */
    public RegisterOptions maxPcaModes(int value) {
        maxPcaModes = value;
        return this;
    }
    public int maxPcaModes() { return maxPcaModes; }

    /** 1 to 10000; default 0: as many as the library thinks right */
    public RegisterOptions iterations(int value) {
        iterations = value;
        return this;
    }
    public int iterations() { return iterations; }

    /** 1 (default): places on the scan's open border do not pull */
    public RegisterOptions rejectBorder(int value) {
        rejectBorder = value;
        return this;
    }
    public int rejectBorder() { return rejectBorder; }

    /** noise level of a surface point in the first round; default 3 */
    public RegisterOptions sigmaStartMm(double value) {
        sigmaStartMm = value;
        return this;
    }
    public double sigmaStartMm() { return sigmaStartMm; }

    /** and in the last; default 0.5 */
    public RegisterOptions sigmaEndMm(double value) {
        sigmaEndMm = value;
        return this;
    }
    public double sigmaEndMm() { return sigmaEndMm; }

    /** between the normals of a vertex and its place; default 60 */
    public RegisterOptions maxAngleDeg(double value) {
        maxAngleDeg = value;
        return this;
    }
    public double maxAngleDeg() { return maxAngleDeg; }

    /** row by row, template to scan; default identity */
    public RegisterOptions startRotation(double[] value) {
        startRotation = value;
        return this;
    }
    public double[] startRotation() { return startRotation; }

    /** mm */
    public RegisterOptions startTranslation(double[] value) {
        startTranslation = value;
        return this;
    }
    public double[] startTranslation() { return startTranslation; }

    /** default 1 */
    public RegisterOptions startScale(double value) {
        startScale = value;
        return this;
    }
    public double startScale() { return startScale; }

    /**
     * 1 (default): where the scan has vertex colours, its lips and brows hold the fit along the skin, and without
     * landmarks eyes are seen to be shut; 0: by form alone. Needs landmarks of the 68-point scheme in the model
     * (brow_*, mouth_outer_*, eye_*) or its zone "lips"
     */
    public RegisterOptions colorFeatures(int value) {
        colorFeatures = value;
        return this;
    }
    public int colorFeatures() { return colorFeatures; }

    /**
     * one unit of the scan in mm when it is known, e.g. 25.4; 0 (default): by `units` and by the landmarks, which
     * settle it
     */
    public RegisterOptions unitToMm(double value) {
        unitToMm = value;
        return this;
    }
    public double unitToMm() { return unitToMm; }

    /** MIEN_SIDES_*; default refuse See Sides. */
    public RegisterOptions landmarkSides(int value) {
        landmarkSides = value;
        return this;
    }
    public int landmarkSides() { return landmarkSides; }

    /**
     * places of the scan that are farther from their vertex do not pull, nearly so far ones less; default 0: as
     * the noise level lets. Since 0.2
     */
    public RegisterOptions maxDistanceMm(double value) {
        maxDistanceMm = value;
        return this;
    }
    public double maxDistanceMm() { return maxDistanceMm; }

    /**
     * a place pulls a vertex while the vertex that is nearest to the place lies no farther than that from it;
     * default 0: not asked. Below the template's spacing hardly any place pulls. Since 0.2
     */
    public RegisterOptions mutualMm(double value) {
        mutualMm = value;
        return this;
    }
    public double mutualMm() { return mutualMm; }

    /**
     * soft assignment: a vertex is pulled to the mean of the scan around its nearest place, weighed by a Gaussian
     * of this deviation; default 0: to the place itself. Since 0.2
     */
    public RegisterOptions softMm(double value) {
        softMm = value;
        return this;
    }
    public double softMm() { return softMm; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_register_options_init(at.address + offset, 296);
        at.bytes.putInt(offset + 4, growth);
        at.bytes.putDouble(offset + 24, landmarkSigmaMm);
        at.bytes.putInt(offset + 32, start);
        at.bytes.putInt(offset + 36, units);
        call.matrix(at, offset + 40, scanWeights, 1, "scan_weights");
        at.bytes.putInt(offset + 72, skinWeights);
        at.bytes.putInt(offset + 76, closeGap);
        at.bytes.putInt(offset + 80, maxScalarModes);
        at.bytes.putInt(offset + 84, maxPcaModes);
        at.bytes.putInt(offset + 88, iterations);
        at.bytes.putInt(offset + 92, rejectBorder);
        at.bytes.putDouble(offset + 96, sigmaStartMm);
        at.bytes.putDouble(offset + 104, sigmaEndMm);
        at.bytes.putDouble(offset + 112, maxAngleDeg);
        at.bytes.putDouble(offset + 216, startScale);
        at.bytes.putInt(offset + 248, colorFeatures);
        at.bytes.putDouble(offset + 256, unitToMm);
        at.bytes.putInt(offset + 264, landmarkSides);
        at.bytes.putDouble(offset + 272, maxDistanceMm);
        at.bytes.putDouble(offset + 280, mutualMm);
        at.bytes.putDouble(offset + 288, softMm);
        at.bytes.putLong(offset + 8, Memory.address(call.records(landmarks, 32)));
        at.bytes.putLong(offset + 16, call.rows(landmarks, 1, "landmarks"));
        at.put(offset + 120, startRotation, 9, "start_rotation");
        at.put(offset + 192, startTranslation, 3, "start_translation");
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(296);
        fill(call, at, 0);
        at.bytes.putLong(224, call.progressFunction(progress));
        at.bytes.putLong(232, call.progressUser());
        at.bytes.putLong(240, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

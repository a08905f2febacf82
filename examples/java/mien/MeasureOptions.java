package mien;

// Written by abi/generate_bindings.py.
/** mien_measure_options of the C interface. */
public final class MeasureOptions implements Record_ {
    private int skipBorders;
    private java.util.List<Zone> zones;
    private Values beforeSd;
    private Values afterSd;
    private double correlationLengthMm;
    private double alignmentRotationSdRad;
    private double alignmentTranslationSdMm;
    private double[] alignmentCentre;
    private double commonBiasMm;
    private double limitOfDetectionMl;
    private double maxDistanceMm;

    /** With the library's defaults. */
    public MeasureOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(184);
            int offset = 0;
            Raw.GET.mien_measure_options_init(at.address, 184);
            skipBorders = at.bytes.getInt(offset + 4);
            correlationLengthMm = at.bytes.getDouble(offset + 88);
            alignmentRotationSdRad = at.bytes.getDouble(offset + 96);
            alignmentTranslationSdMm = at.bytes.getDouble(offset + 104);
            alignmentCentre = at.doubles(offset + 112, 3);
            commonBiasMm = at.bytes.getDouble(offset + 136);
            limitOfDetectionMl = at.bytes.getDouble(offset + 144);
            maxDistanceMm = at.bytes.getDouble(offset + 152);
        }
    }

    /**
     * surfaces not in correspondence: 1 (default) leaves out places whose partner lies on an open border, where
     * nothing is known
     */
    public MeasureOptions skipBorders(int value) {
        skipBorders = value;
        return this;
    }
    public int skipBorders() { return skipBorders; }

    /** zone_count zones; null: the whole face only */
    public MeasureOptions zones(java.util.List<Zone> value) {
        zones = value;
        return this;
    }
    public java.util.List<Zone> zones() { return zones; }

    /**
     * #V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count
     * 0: exact. Without that of either face there is no interval (since 0.2), whatever the alignment's
     */
    public MeasureOptions beforeSd(Values value) {
        beforeSd = value;
        return this;
    }
    public Values beforeSd() { return beforeSd; }

    public MeasureOptions afterSd(Values value) {
        afterSd = value;
        return this;
    }
    public Values afterSd() { return afterSd; }

    /** over which errors of a surface go together; default 4, in 0.1: 10 */
    public MeasureOptions correlationLengthMm(double value) {
        correlationLengthMm = value;
        return this;
    }
    public double correlationLengthMm() { return correlationLengthMm; }

    /** of the after face against the before face; default 0 */
    public MeasureOptions alignmentRotationSdRad(double value) {
        alignmentRotationSdRad = value;
        return this;
    }
    public double alignmentRotationSdRad() { return alignmentRotationSdRad; }

    /** default 0 */
    public MeasureOptions alignmentTranslationSdMm(double value) {
        alignmentTranslationSdMm = value;
        return this;
    }
    public double alignmentTranslationSdMm() { return alignmentTranslationSdMm; }

    /** mm; what the alignment turns about, e.g. the stable zone's centre */
    public MeasureOptions alignmentCentre(double[] value) {
        alignmentCentre = value;
        return this;
    }
    public double[] alignmentCentre() { return alignmentCentre; }

    /** error common to all vertices; default 0 */
    public MeasureOptions commonBiasMm(double value) {
        commonBiasMm = value;
        return this;
    }
    public double commonBiasMm() { return commonBiasMm; }

    /** smaller changes are marked as below it; default 0: unknown */
    public MeasureOptions limitOfDetectionMl(double value) {
        limitOfDetectionMl = value;
        return this;
    }
    public double limitOfDetectionMl() { return limitOfDetectionMl; }

    /** surfaces not in correspondence: farther partners are none; default 0: no limit */
    public MeasureOptions maxDistanceMm(double value) {
        maxDistanceMm = value;
        return this;
    }
    public double maxDistanceMm() { return maxDistanceMm; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_measure_options_init(at.address + offset, 184);
        at.bytes.putInt(offset + 4, skipBorders);
        call.matrix(at, offset + 24, beforeSd, 1, "before_sd");
        call.matrix(at, offset + 56, afterSd, 1, "after_sd");
        at.bytes.putDouble(offset + 88, correlationLengthMm);
        at.bytes.putDouble(offset + 96, alignmentRotationSdRad);
        at.bytes.putDouble(offset + 104, alignmentTranslationSdMm);
        at.bytes.putDouble(offset + 136, commonBiasMm);
        at.bytes.putDouble(offset + 144, limitOfDetectionMl);
        at.bytes.putDouble(offset + 152, maxDistanceMm);
        at.bytes.putLong(offset + 8, Memory.address(call.records(zones, 24)));
        at.bytes.putLong(offset + 16, call.rows(zones, 1, "zones"));
        at.put(offset + 112, alignmentCentre, 3, "alignment_centre");
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(184);
        fill(call, at, 0);
        at.bytes.putLong(160, call.progressFunction(progress));
        at.bytes.putLong(168, call.progressUser());
        at.bytes.putLong(176, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

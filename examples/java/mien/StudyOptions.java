package mien;

// Written by abi/generate_bindings.py.
/** Names are those of zones. */
public final class StudyOptions implements Record_ {
    private java.util.List<Zone> zones;
    private java.util.List<String> treatedZones;
    private java.util.List<String> stableZones;
    private int[] visits;
    private double marginMm;
    private double level;
    private double noiseMm;
    private double correlationLengthMm;
    private double commonBiasMm;
    private double untrainedShare;
    private double minSeenShare;
    private int measureUnseen;

    /** With the library's defaults. */
    public StudyOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(160);
            int offset = 0;
            Raw.GET.mien_study_options_init(at.address, 160);
            marginMm = at.bytes.getDouble(offset + 72);
            level = at.bytes.getDouble(offset + 80);
            noiseMm = at.bytes.getDouble(offset + 88);
            correlationLengthMm = at.bytes.getDouble(offset + 96);
            commonBiasMm = at.bytes.getDouble(offset + 104);
            untrainedShare = at.bytes.getDouble(offset + 112);
            minSeenShare = at.bytes.getDouble(offset + 120);
            measureUnseen = at.bytes.getInt(offset + 152);
        }
    }

    /** zone_count zones to measure; null: those of the registrations' model */
    public StudyOptions zones(java.util.List<Zone> value) {
        zones = value;
        return this;
    }
    public java.util.List<Zone> zones() { return zones; }

    /** treated_count names: where the person may have changed, no witness of expression or pose; null: none */
    public StudyOptions treatedZones(java.util.List<String> value) {
        treatedZones = value;
        return this;
    }
    public java.util.List<String> treatedZones() { return treatedZones; }

    /**
     * stable_count names of zones to align on; null: all but the treated ones when zones are treated and
     * expressions taken off, otherwise "forehead" and "nose"; without any zone the whole face
     */
    public StudyOptions stableZones(java.util.List<String> value) {
        stableZones = value;
        return this;
    }
    public java.util.List<String> stableZones() { return stableZones; }

    /**
     * visit_number_count numbers, the visit of each face, from 0 and ascending: several captures of one visit
     * tell the limits of detection; null: each face is a visit of its own
     */
    public StudyOptions visits(int[] value) {
        visits = value;
        return this;
    }
    public int[] visits() { return visits; }

    /** around the treated zones, 0 to 100, measured with them as zones of their own at the end; default 10 */
    public StudyOptions marginMm(double value) {
        marginMm = value;
        return this;
    }
    public double marginMm() { return marginMm; }

    /** of the intervals, above 0 and below 1; default 0.95 */
    public StudyOptions level(double value) {
        level = value;
        return this;
    }
    public double level() { return level; }

    /** of a scanner's surface along its normal, where it was seen; default 0.08 */
    public StudyOptions noiseMm(double value) {
        noiseMm = value;
        return this;
    }
    public double noiseMm() { return noiseMm; }

    /** over which the errors of a fitted surface go together; default 4 */
    public StudyOptions correlationLengthMm(double value) {
        correlationLengthMm = value;
        return this;
    }
    public double correlationLengthMm() { return correlationLengthMm; }

    /** error common to all vertices; default 0.01 */
    public StudyOptions commonBiasMm(double value) {
        commonBiasMm = value;
        return this;
    }
    public double commonBiasMm() { return commonBiasMm; }

    /** of the volume that an expression accounted for: what no training set knew of it; default 0.06 */
    public StudyOptions untrainedShare(double value) {
        untrainedShare = value;
        return this;
    }
    public double untrainedShare() { return untrainedShare; }

    /** of a zone's area that both visits must have seen, 0 to 1; default 0.1 */
    public StudyOptions minSeenShare(double value) {
        minSeenShare = value;
        return this;
    }
    public double minSeenShare() { return minSeenShare; }

    /**
     * 1: zones keep what no scan saw, which fits guess: walls in nostrils, lips and lids, skin unseen in every
     * visit; default 0: left out of the zones
     */
    public StudyOptions measureUnseen(int value) {
        measureUnseen = value;
        return this;
    }
    public int measureUnseen() { return measureUnseen; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_study_options_init(at.address + offset, 160);
        at.bytes.putDouble(offset + 72, marginMm);
        at.bytes.putDouble(offset + 80, level);
        at.bytes.putDouble(offset + 88, noiseMm);
        at.bytes.putDouble(offset + 96, correlationLengthMm);
        at.bytes.putDouble(offset + 104, commonBiasMm);
        at.bytes.putDouble(offset + 112, untrainedShare);
        at.bytes.putDouble(offset + 120, minSeenShare);
        at.bytes.putInt(offset + 152, measureUnseen);
        at.bytes.putLong(offset + 8, Memory.address(call.records(zones, 24)));
        at.bytes.putLong(offset + 16, call.rows(zones, 1, "zones"));
        at.bytes.putLong(offset + 24, Memory.address(call.texts(treatedZones)));
        at.bytes.putLong(offset + 32, call.rows(treatedZones, 1, "treated_zones"));
        at.bytes.putLong(offset + 40, Memory.address(call.texts(stableZones)));
        at.bytes.putLong(offset + 48, call.rows(stableZones, 1, "stable_zones"));
        at.bytes.putLong(offset + 56, Memory.address(call.array(visits)));
        at.bytes.putLong(offset + 64, call.rows(visits, 1, "visits"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(160);
        fill(call, at, 0);
        at.bytes.putLong(128, call.progressFunction(progress));
        at.bytes.putLong(136, call.progressUser());
        at.bytes.putLong(144, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

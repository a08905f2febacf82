package mien;

// Written by abi/generate_bindings.py.
/**
 * What changed in one zone from one visit to another. Set struct_size first.
 * @param unknown MIEN_STUDY_*: why there is no deviation See StudyKind.
 * @param signedMl gained and lost together; positive: gained
 * @param gainedMl &gt;= 0
 * @param lostMl &lt;= 0
 * @param absoluteMl gained without lost
 * @param areaChangeMm2
 * @param meanDistanceMm along the normals of the first face; positive: outside
 * @param surfaceSdMl of signed_ml.sd: by the fitted surfaces
 * @param alignmentSdMl by the alignment on the stable zone
 * @param biasSdMl by the error common to all vertices
 * @param expressionSdMl by what taking the expressions off leaves open
 * @param expressionRemovedMl what the expressions accounted for, signed
 * @param seenShare of the zone's area, in both visits; NaN: not told
 * @param areaBeforeMm2
 * @param areaAfterMm2
 * @param detected 1: signed_ml reaches its limit of detection, 0: below it, -1: no limit known
 */
public record StudyChange(int unknown, StudyValue signedMl, StudyValue gainedMl, StudyValue lostMl, StudyValue absoluteMl, StudyValue areaChangeMm2, StudyValue meanDistanceMm, double surfaceSdMl, double alignmentSdMl, double biasSdMl, double expressionSdMl, double expressionRemovedMl, double seenShare, double areaBeforeMm2, double areaAfterMm2, int detected) {

    static StudyChange read(Call call, Memory at, int offset) {
        return new StudyChange(
            at.bytes.getInt(offset + 4),
            StudyValue.read(call, at, offset + 8),
            StudyValue.read(call, at, offset + 48),
            StudyValue.read(call, at, offset + 88),
            StudyValue.read(call, at, offset + 128),
            StudyValue.read(call, at, offset + 168),
            StudyValue.read(call, at, offset + 208),
            at.bytes.getDouble(offset + 248),
            at.bytes.getDouble(offset + 256),
            at.bytes.getDouble(offset + 264),
            at.bytes.getDouble(offset + 272),
            at.bytes.getDouble(offset + 280),
            at.bytes.getDouble(offset + 288),
            at.bytes.getDouble(offset + 296),
            at.bytes.getDouble(offset + 304),
            at.bytes.getInt(offset + 312));
    }
}

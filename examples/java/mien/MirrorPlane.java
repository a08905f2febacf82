package mien;

// Written by abi/generate_bindings.py.
/**
 * The plane between left and right. NaN where a number is not known.
 * @param by MIEN_MIRROR_BY_* See MirrorBy.
 * @param pairs of partners that counted
 * @param normal unit, to the subject's left
 * @param centre mm, in the plane
 * @param rmsMm of the distances between a side and the other's reflection
 * @param tiltSdRad about either direction of the plane, root mean square
 * @param offsetSdMm along the normal
 * @param betweenRad angle to the plane found the other way; NaN without landmarks
 * @param apartMm of that plane from the centre, along its normal
 */
public record MirrorPlane(int by, long pairs, double[] normal, double[] centre, double rmsMm, double tiltSdRad, double offsetSdMm, double betweenRad, double apartMm) {

    static MirrorPlane read(Call call, Memory at, int offset) {
        return new MirrorPlane(
            at.bytes.getInt(offset + 4),
            at.bytes.getLong(offset + 8),
            at.doubles(offset + 16, 3),
            at.doubles(offset + 40, 3),
            at.bytes.getDouble(offset + 64),
            at.bytes.getDouble(offset + 72),
            at.bytes.getDouble(offset + 80),
            at.bytes.getDouble(offset + 88),
            at.bytes.getDouble(offset + 96));
    }
}

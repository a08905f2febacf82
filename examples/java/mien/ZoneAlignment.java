package mien;

// Written by abi/generate_bindings.py.
/**
 * A rigid alignment on a stable zone and how sure it is.
 * @param pairs that counted
 * @param rmsMm left over along the normals
 * @param rotationSdRad about the centre, root mean square over the axes
 * @param translationSdMm per axis, root mean square
 * @param centre of the zone on the target
 * @param matrix 4 x 4 row by row, moving to target
 */
public record ZoneAlignment(long pairs, double rmsMm, double rotationSdRad, double translationSdMm, double[] centre, double[] matrix) {

    static ZoneAlignment read(Call call, Memory at, int offset) {
        return new ZoneAlignment(
            at.bytes.getLong(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32),
            at.doubles(offset + 40, 3),
            at.doubles(offset + 64, 16));
    }
}

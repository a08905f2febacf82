package mien;

// Written by abi/generate_bindings.py.
/**
 * Distances of one zone, mm, weighted with area.
 * @param meanSignedMm along the normal of the before face; positive: outside
 * @param sdSignedMm
 * @param meanAbsoluteMm of the signed ones
 * @param rmsMm of the lengths
 * @param meanLengthMm
 * @param medianLengthMm
 * @param p95LengthMm
 * @param maxLengthMm
 * @param vertexCount vertices that had a partner
 */
public record ZoneDistance(double meanSignedMm, double sdSignedMm, double meanAbsoluteMm, double rmsMm, double meanLengthMm, double medianLengthMm, double p95LengthMm, double maxLengthMm, long vertexCount) {

    static ZoneDistance read(Call call, Memory at, int offset) {
        return new ZoneDistance(
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32),
            at.bytes.getDouble(offset + 40),
            at.bytes.getDouble(offset + 48),
            at.bytes.getDouble(offset + 56),
            at.bytes.getDouble(offset + 64),
            at.bytes.getLong(offset + 72));
    }
}

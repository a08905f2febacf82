package mien;

// Written by abi/generate_bindings.py.
/**
 * The verdict on a fit; the reasons in words are in the JSON report. The quality is that of the error
 * expected of the whole face (mien_registration_get_expected_error()), doubtful at best where a zone has
 * failed.
 * @param quality MIEN_QUALITY_* See Quality.
 * @param coverage share of the template's vertices with a scan beside them
 * @param inlierShare of those: share that lies on the scan
 * @param meanResidualMm
 * @param landmarkRmsMm 0 without landmarks
 * @param sizeRatio fitted size over template size
 * @param meanDeviation of the coefficients, in standard deviations of the prior
 * @param unitToMm what one unit of the scan was taken for
 * @param landmarksUsed
 * @param landmarksRejected
 * @param flippedTriangles
 * @param selfIntersections
 */
public record FitVerdict(int quality, double coverage, double inlierShare, double meanResidualMm, double landmarkRmsMm, double sizeRatio, double meanDeviation, double unitToMm, int landmarksUsed, int landmarksRejected, int flippedTriangles, int selfIntersections) {

    static FitVerdict read(Call call, Memory at, int offset) {
        return new FitVerdict(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32),
            at.bytes.getDouble(offset + 40),
            at.bytes.getDouble(offset + 48),
            at.bytes.getDouble(offset + 56),
            at.bytes.getInt(offset + 64),
            at.bytes.getInt(offset + 68),
            at.bytes.getInt(offset + 72),
            at.bytes.getInt(offset + 76));
    }
}

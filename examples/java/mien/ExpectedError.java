package mien;

// Written by abi/generate_bindings.py.
/**
 * How far a fitted zone is expected to be from the truth: the mean distance of its vertices from the true
 * ones, learned from simulated fits of many people, poses and troubles. Since 0.2
 * @param quality MIEN_QUALITY_*, of the zone alone; doubtful at best where the fit failed or what speaks
 * against the scan speaks against all of it (two surfaces over each other, inside out, no known unit) See
 * Quality.
 * @param expectedMm
 * @param lowMm 8 of 10 like fits are between low_mm and high_mm off
 * @param highMm
 * @param unseen 0 to 1: share of the zone that the scan had no say in
 */
public record ExpectedError(int quality, double expectedMm, double lowMm, double highMm, double unseen) {

    static ExpectedError read(Call call, Memory at, int offset) {
        return new ExpectedError(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32));
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * Volume of one zone, mL. signed = positive + negative, absolute = positive - negative; positive: the after
 * face lies outside. NaN where a number is not known.
 * @param detected 1: |signed| reaches the limit of detection, 0: below it, -1: no limit given
 * @param signedMl
 * @param positiveMl &gt;= 0
 * @param negativeMl &lt;= 0
 * @param absoluteMl
 * @param sdMl of signed_ml; NaN when no deviation was given
 * @param low95Ml 95 % interval of signed_ml
 * @param high95Ml
 * @param areaBeforeMm2
 * @param areaAfterMm2 NaN for surfaces not in correspondence
 */
public record ZoneVolume(int detected, double signedMl, double positiveMl, double negativeMl, double absoluteMl, double sdMl, double low95Ml, double high95Ml, double areaBeforeMm2, double areaAfterMm2) {

    static ZoneVolume read(Call call, Memory at, int offset) {
        return new ZoneVolume(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32),
            at.bytes.getDouble(offset + 40),
            at.bytes.getDouble(offset + 48),
            at.bytes.getDouble(offset + 56),
            at.bytes.getDouble(offset + 64),
            at.bytes.getDouble(offset + 72));
    }
}

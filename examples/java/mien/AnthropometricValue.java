package mien;

// Written by abi/generate_bindings.py.
/**
 * One measurement of a face. NaN where a number is not known.
 * @param kind MIEN_MEASURE_* See Measure.
 * @param value NaN: mien_anthropometry_get_reason() says why
 * @param sd of the value, by the errors of the landmarks' places
 * @param z (value - norm_mean) / norm_sd
 * @param zSd sd / norm_sd
 * @param normMean over the people of the norms
 * @param normSd
 * @param normPeople 0: no norm
 */
public record AnthropometricValue(int kind, double value, double sd, double z, double zSd, double normMean, double normSd, long normPeople) {

    static AnthropometricValue read(Call call, Memory at, int offset) {
        return new AnthropometricValue(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32),
            at.bytes.getDouble(offset + 40),
            at.bytes.getDouble(offset + 48),
            at.bytes.getLong(offset + 56));
    }
}

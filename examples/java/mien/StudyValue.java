package mien;

// Written by abi/generate_bindings.py.
/**
 * A number with its error. NaN: not known.
 * @param value
 * @param sd standard deviation
 * @param low of the interval at the study's level
 * @param high of the interval at the study's level
 * @param limitOfDetection the minimal detectable change: a smaller size cannot be told from no change at the
 * study's level, as the interval holds zero; from repeated captures where there are enough
 */
public record StudyValue(double value, double sd, double low, double high, double limitOfDetection) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putDouble(offset + 0, value);
        at.bytes.putDouble(offset + 8, sd);
        at.bytes.putDouble(offset + 16, low);
        at.bytes.putDouble(offset + 24, high);
        at.bytes.putDouble(offset + 32, limitOfDetection);
    }

    static StudyValue read(Call call, Memory at, int offset) {
        return new StudyValue(
            at.bytes.getDouble(offset + 0),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32));
    }
}

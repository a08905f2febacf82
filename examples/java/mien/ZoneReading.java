package mien;

// Written by abi/generate_bindings.py.
/**
 * What a reading takes off inside the treated zone (without its margin).
 * @param differ 1: the two readings see another expression and another volume
 * @param probability of the likeliest expression, which the JSON names
 * @param removedMm root mean square over the zone
 * @param removedMl by which the zone stood out through the expression, to first order
 */
public record ZoneReading(int differ, double probability, double removedMm, double removedMl) {

    static ZoneReading read(Call call, Memory at, int offset) {
        return new ZoneReading(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24));
    }
}

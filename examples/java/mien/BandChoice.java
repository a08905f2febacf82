package mien;

// Written by abi/generate_bindings.py.
/**
 * One tried k of mien_blendshape_model_search().
 * @param k
 * @param l1Mm
 * @param dame
 * @param fmpd
 * @param onFront 1: no other k is better in both L1 and FMPD
 * @param chosen 1: the front's knee
 */
public record BandChoice(long k, double l1Mm, double dame, double fmpd, int onFront, int chosen) {

    static BandChoice read(Call call, Memory at, int offset) {
        return new BandChoice(
            at.bytes.getLong(offset + 0),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getInt(offset + 32),
            at.bytes.getInt(offset + 36));
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * A predicted score.
 * @param extrapolates 1: the face is unlike the training faces
 * @param score
 * @param low95 95 % prediction interval
 * @param high95
 * @param leverage distance from the training faces, about components / faces on average
 */
public record ScorePrediction(int extrapolates, double score, double low95, double high95, double leverage) {

    static ScorePrediction read(Call call, Memory at, int offset) {
        return new ScorePrediction(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24),
            at.bytes.getDouble(offset + 32));
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * Where a landmark was seen.
 * @param name of a landmark of the model; null: `vertex` says which
 * @param vertex read when name is null
 * @param position mm, in the frame of the template
 * @param noiseMm standard deviation of each coordinate, &gt;= 0.000001
 */
public record LandmarkObservation(String name, int vertex, double[] position, double noiseMm) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putInt(offset + 8, vertex);
        at.bytes.putDouble(offset + 40, noiseMm);
        at.bytes.putLong(offset + 0, Memory.address(call.textOrNull(name)));
        at.put(offset + 16, position, 3, "position");
    }
}

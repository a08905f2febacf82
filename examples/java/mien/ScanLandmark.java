package mien;

// Written by abi/generate_bindings.py.
/**
 * A named place on a scan, read in place and only during the call.
 * @param name matched with the names stored in the model
 * @param position in the scan's frame and unit
 */
public record ScanLandmark(String name, double[] position) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putLong(offset + 0, Memory.address(call.text(name)));
        at.put(offset + 8, position, 3, "position");
    }
}

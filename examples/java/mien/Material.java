package mien;

// Written by abi/generate_bindings.py.
/**
 * A material of a mesh, read in place and only during the call.
 * @param name UTF-8; may be left out
 * @param image number of the base colour's image, -1: none
 * @param red 0 to 1; an image is times this
 * @param green
 * @param blue
 */
public record Material(String name, int image, double red, double green, double blue) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putInt(offset + 8, image);
        at.bytes.putDouble(offset + 16, red);
        at.bytes.putDouble(offset + 24, green);
        at.bytes.putDouble(offset + 32, blue);
        at.bytes.putLong(offset + 0, Memory.address(call.textOrNull(name)));
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * A texture image of the host's, read in place and only during the call: either pixels or the bytes of a
 * file.
 * @param name UTF-8 file name without a folder; may be left out
 * @param pixels height rows of width x 3 red green blue, from the top; may be left out
 * @param rowStrideBytes from row to row; 0: tightly packed
 * @param width of pixels, else 0
 * @param height of pixels, else 0
 * @param file the bytes of a JPEG or PNG file; may be left out: when pixels are given
 */
public record Image(String name, byte[] pixels, long rowStrideBytes, int width, int height, byte[] file) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putLong(offset + 16, rowStrideBytes);
        at.bytes.putInt(offset + 24, width);
        at.bytes.putInt(offset + 28, height);
        at.bytes.putLong(offset + 0, Memory.address(call.textOrNull(name)));
        at.bytes.putLong(offset + 8, Memory.address(call.array(pixels)));
        if (pixels != null) call.agree("pixels", call.rows(pixels, at.bytes.getInt(offset + 24) * 3, "pixels"), at.bytes.getInt(offset + 28));
        at.bytes.putLong(offset + 32, Memory.address(call.array(file)));
        at.bytes.putLong(offset + 40, call.rows(file, 1, "file"));
    }
}

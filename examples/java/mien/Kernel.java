package mien;

// Written by abi/generate_bindings.py.
/**
 * One more kernel of a sum.
 * @param kind MIEN_KERNEL_..., not NONE See KernelKind.
 * @param sigmaMm
 * @param scaleMm
 * @param nu read for SURFACE_MATERN only
 */
public record Kernel(int kind, double sigmaMm, double scaleMm, double nu) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putInt(offset + 0, kind);
        at.bytes.putDouble(offset + 8, sigmaMm);
        at.bytes.putDouble(offset + 16, scaleMm);
        at.bytes.putDouble(offset + 24, nu);
    }

    static Kernel read(Call call, Memory at, int offset) {
        return new Kernel(
            at.bytes.getInt(offset + 0),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24));
    }
}

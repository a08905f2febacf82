package mien;

// Written by abi/generate_bindings.py.
/** mien_spectral_basis_options of the C interface. */
public final class SpectralBasisOptions implements Record_ {
    private int modeCount;
    private int mass;
    private int cotangents;

    /** With the library's defaults. */
    public SpectralBasisOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(40);
            int offset = 0;
            Raw.GET.mien_spectral_basis_options_init(at.address, 40);
            modeCount = at.bytes.getInt(offset + 4);
            mass = at.bytes.getInt(offset + 8);
            cotangents = at.bytes.getInt(offset + 12);
        }
    }

    /** 1 to #V - 1; default 500 */
    public SpectralBasisOptions modeCount(int value) {
        modeCount = value;
        return this;
    }
    public int modeCount() { return modeCount; }

    /** MIEN_MASS_...; default mixed Voronoi See Mass. */
    public SpectralBasisOptions mass(int value) {
        mass = value;
        return this;
    }
    public int mass() { return mass; }

    /** MIEN_COTANGENTS_...; default intrinsic Delaunay See Cotangents. */
    public SpectralBasisOptions cotangents(int value) {
        cotangents = value;
        return this;
    }
    public int cotangents() { return cotangents; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_spectral_basis_options_init(at.address + offset, 40);
        at.bytes.putInt(offset + 4, modeCount);
        at.bytes.putInt(offset + 8, mass);
        at.bytes.putInt(offset + 12, cotangents);
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(40);
        fill(call, at, 0);
        at.bytes.putLong(16, call.progressFunction(progress));
        at.bytes.putLong(24, call.progressUser());
        at.bytes.putLong(32, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** mien_blendshape_options of the C interface. */
public final class BlendshapeOptions implements Record_ {
    private double ridge;

    /** With the library's defaults. */
    public BlendshapeOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(40);
            int offset = 0;
            Raw.GET.mien_blendshape_options_init(at.address, 40);
            ridge = at.bytes.getDouble(offset + 8);
        }
    }

    /** of the kernel's mean diagonal; default 0: by leave-one-out error */
    public BlendshapeOptions ridge(double value) {
        ridge = value;
        return this;
    }
    public double ridge() { return ridge; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_blendshape_options_init(at.address + offset, 40);
        at.bytes.putDouble(offset + 8, ridge);
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

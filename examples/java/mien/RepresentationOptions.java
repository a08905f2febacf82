package mien;

// Written by abi/generate_bindings.py.
/** How to train; initialise with mien_representation_options_init(). */
public final class RepresentationOptions implements Record_ {
    private int neutralOnly;

    /** With the library's defaults. */
    public RepresentationOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(32);
            int offset = 0;
            Raw.GET.mien_representation_options_init(at.address, 32);
            neutralOnly = at.bytes.getInt(offset + 4);
        }
    }

    /** 1: only the faces marked neutral; default 0: all */
    public RepresentationOptions neutralOnly(int value) {
        neutralOnly = value;
        return this;
    }
    public int neutralOnly() { return neutralOnly; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_representation_options_init(at.address + offset, 32);
        at.bytes.putInt(offset + 4, neutralOnly);
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(32);
        fill(call, at, 0);
        at.bytes.putLong(8, call.progressFunction(progress));
        at.bytes.putLong(16, call.progressUser());
        at.bytes.putLong(24, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

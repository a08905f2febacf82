package mien;

// Written by abi/generate_bindings.py.
/** mien_batch_options of the C interface. */
public final class BatchOptions implements Record_ {

    /** With the library's defaults. */
    public BatchOptions() {
    }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_batch_options_init(at.address + offset, 32);
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

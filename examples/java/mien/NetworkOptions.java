package mien;

// Written by abi/generate_bindings.py.
/** How to run; initialise with mien_network_options_init(). */
public final class NetworkOptions implements Record_ {
    private Cancel cancel;
    private long bandLimit;

    /** With the library's defaults. */
    public NetworkOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(24);
            int offset = 0;
            Raw.GET.mien_network_options_init(at.address, 24);
            bandLimit = at.bytes.getLong(offset + 16);
        }
    }

    /** may be left out; looked at between layers */
    public NetworkOptions cancel(Cancel value) {
        cancel = value;
        return this;
    }
    public Cancel cancel() { return cancel; }

    /**
     * mien_network_apply() of a network that adds an expression in two bands: modes of the low one; default 0:
     * the file's own; negative: none, deformations alone; more than the file's basis has: coordinates alone
     */
    public NetworkOptions bandLimit(long value) {
        bandLimit = value;
        return this;
    }
    public long bandLimit() { return bandLimit; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_network_options_init(at.address + offset, 24);
        at.bytes.putLong(offset + 16, bandLimit);
        at.bytes.putLong(offset + 8, Memory.address(call.useOrNull(cancel)));
    }
}

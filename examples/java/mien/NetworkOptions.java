package mien;

// Written by abi/generate_bindings.py.
/** How to run; initialise with mien_network_options_init(). */
public final class NetworkOptions implements Record_ {
    private Cancel cancel;

    /** With the library's defaults. */
    public NetworkOptions() {
    }

    /** may be left out; looked at between layers */
    public NetworkOptions cancel(Cancel value) {
        cancel = value;
        return this;
    }
    public Cancel cancel() { return cancel; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_network_options_init(at.address + offset, 16);
        at.bytes.putLong(offset + 8, Memory.address(call.useOrNull(cancel)));
    }
}

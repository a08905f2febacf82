package mien;

// Written by abi/generate_bindings.py.
/** mien_tie_options of the C interface. */
public final class TieOptions implements Record_ {
    private double maxSlideMm;
    private double leastShare;

    /** With the library's defaults. */
    public TieOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(48);
            int offset = 0;
            Raw.GET.mien_tie_options_init(at.address, 48);
            maxSlideMm = at.bytes.getDouble(offset + 8);
            leastShare = at.bytes.getDouble(offset + 16);
        }
    }

    /** 0.1 to 20; default 6: no place moves farther */
    public TieOptions maxSlideMm(double value) {
        maxSlideMm = value;
        return this;
    }
    public double maxSlideMm() { return maxSlideMm; }

    /**
     * 0 to 1; default 0.2: of the skin that both visits see, the share on which their pictures must agree, or
     * nothing moves
     */
    public TieOptions leastShare(double value) {
        leastShare = value;
        return this;
    }
    public double leastShare() { return leastShare; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_tie_options_init(at.address + offset, 48);
        at.bytes.putDouble(offset + 8, maxSlideMm);
        at.bytes.putDouble(offset + 16, leastShare);
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(48);
        fill(call, at, 0);
        at.bytes.putLong(24, call.progressFunction(progress));
        at.bytes.putLong(32, call.progressUser());
        at.bytes.putLong(40, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** mien_session_options of the C interface. */
public final class SessionOptions implements Record_ {
    private int numThreads;
    private long maxBytes;
    private LogListener log;

    /** With the library's defaults. */
    public SessionOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(32);
            int offset = 0;
            Raw.GET.mien_session_options_init(at.address, 32);
            numThreads = at.bytes.getInt(offset + 4);
            maxBytes = at.bytes.getLong(offset + 8);
        }
    }

    /** 1 (default) to 256; 1 starts no thread. Results do not depend on it. */
    public SessionOptions numThreads(int value) {
        numThreads = value;
        return this;
    }
    public int numThreads() { return numThreads; }

    /** memory budget of one call, 0 (default): none */
    public SessionOptions maxBytes(long value) {
        maxBytes = value;
        return this;
    }
    public long maxBytes() { return maxBytes; }

    /** null (default): silent. The library never prints. */
    public SessionOptions log(LogListener value) {
        log = value;
        return this;
    }
    public LogListener log() { return log; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_session_options_init(at.address + offset, 32);
        at.bytes.putInt(offset + 4, numThreads);
        at.bytes.putLong(offset + 8, maxBytes);
        at.bytes.putLong(offset + 16, call.logFunction(log));
        at.bytes.putLong(offset + 16 + 8, call.logUser(log));
    }
}

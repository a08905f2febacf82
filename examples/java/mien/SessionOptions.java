package mien;

// Written by abi/generate_bindings.py.
/** mien_session_options of the C interface. */
public final class SessionOptions implements Record_ {
    private int numThreads;
    private long maxBytes;
    private LogListener log;
    private double maxSeconds;
    private int copyFiles;

    /** With the library's defaults. */
    public SessionOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(48);
            int offset = 0;
            Raw.GET.mien_session_options_init(at.address, 48);
            numThreads = at.bytes.getInt(offset + 4);
            maxBytes = at.bytes.getLong(offset + 8);
            maxSeconds = at.bytes.getDouble(offset + 32);
            copyFiles = at.bytes.getInt(offset + 40);
        }
    }

    /** 1 (default) to 256; 1 starts no thread. Results do not depend on it. */
    public SessionOptions numThreads(int value) {
        numThreads = value;
        return this;
    }
    public int numThreads() { return numThreads; }

    /**
     * memory budget of one call, 0 (default): none. Counted while the call runs, over all that the library's own
     * code allocates, the result included; MIEN_E_MEMORY_BUDGET before it would be exceeded. Mapped files do not
     * count.
     */
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

    /**
     * time limit of one call, 0 (default): none, to 1e8; after it a call ends with MIEN_E_TIME_LIMIT as soon as
     * it would end for a cancel token. Since 0.2.
     */
    public SessionOptions maxSeconds(double value) {
        maxSeconds = value;
        return this;
    }
    public double maxSeconds() { return maxSeconds; }

    /**
     * 0 (default): model files and datasets are mapped, and a file that another program shortens meanwhile may
     * end the process (as with any mapping; one that is replaced by renaming, as the library writes, is safe); 1:
     * they are read into memory. Since 0.2.
     */
    public SessionOptions copyFiles(int value) {
        copyFiles = value;
        return this;
    }
    public int copyFiles() { return copyFiles; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_session_options_init(at.address + offset, 48);
        at.bytes.putInt(offset + 4, numThreads);
        at.bytes.putLong(offset + 8, maxBytes);
        at.bytes.putDouble(offset + 32, maxSeconds);
        at.bytes.putInt(offset + 40, copyFiles);
        at.bytes.putLong(offset + 16, call.logFunction(log));
        at.bytes.putLong(offset + 16 + 8, call.logUser(log));
    }
}

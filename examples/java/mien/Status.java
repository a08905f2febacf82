package mien;

// Written by abi/generate_bindings.py.
/** MIEN_STATUS_* of the C interface. Plain numbers: newer libraries may have more. */
public final class Status {
    private Status() {}

    public static final int OK = 0;

    /** a parameter is null or out of its range */
    public static final int E_INVALID_ARGUMENT = -1;

    /** a handle is null, released or of another type */
    public static final int E_INVALID_HANDLE = -2;

    /** empty, not finite, index out of range, degenerate */
    public static final int E_INVALID_MESH = -3;

    /** the count was written, nothing else */
    public static final int E_BUFFER_TOO_SMALL = -4;

    /** an option, a switch or an enumerator that this library does not know */
    public static final int E_UNSUPPORTED_OPTION = -5;

    /** ABI or file format of another major version */
    public static final int E_UNSUPPORTED_VERSION = -6;

    /** an allocation failed; the session stays usable */
    public static final int E_NO_MEMORY = -7;

    /** the session's max_bytes would be exceeded */
    public static final int E_MEMORY_BUDGET = -8;

    /** a file cannot be opened, read or written */
    public static final int E_IO = -9;

    /** a file is not what its format says */
    public static final int E_BAD_FORMAT = -10;

    /** hash mismatch, or values that are not finite */
    public static final int E_CORRUPT = -11;

    /** a good file of another kind */
    public static final int E_WRONG_KIND = -12;

    /** inputs that do not belong together */
    public static final int E_MISMATCH = -13;

    /** a factorisation or an iteration failed */
    public static final int E_NO_SOLUTION = -14;

    /** an unknown name */
    public static final int E_NOT_FOUND = -15;

    /** by a progress callback or a cancel token */
    public static final int E_CANCELLED = -16;

    /** a callback unwound */
    public static final int E_CALLBACK = -17;

    /** a defect of the library: please report it */
    public static final int E_INTERNAL = -18;

    /** the session is in a call on another thread; since 0.2 */
    public static final int E_BUSY = -19;

    /** the session's max_seconds have passed; since 0.2 */
    public static final int E_TIME_LIMIT = -20;
}

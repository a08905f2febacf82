package mien;

// Written by abi/generate_bindings.py.
/** MIEN_LOG_* of the C interface. Plain numbers: newer libraries may have more. */
public final class Log {
    private Log() {}

    public static final int ERROR = 1;

    public static final int WARNING = 2;

    public static final int INFO = 3;

    public static final int DEBUG = 4;
}

package mien;

// Written by abi/generate_bindings.py.
/** How far a fit is to be trusted. Plain numbers: newer libraries may have more. */
public final class Quality {
    private Quality() {}

    public static final int GOOD = 0;

    public static final int DOUBTFUL = 1;

    public static final int FAILED = 2;
}

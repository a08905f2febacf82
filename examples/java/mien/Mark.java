package mien;

// Written by abi/generate_bindings.py.
/** What is known of a landmark. Plain numbers: newer libraries may have more. */
public final class Mark {
    private Mark() {}

    /** null, not a number, "not defined" or a placeholder in its file */
    public static final int NOT_PICKED = 0;

    public static final int PLACE = 1;

    public static final int VERTEX = 2;
}

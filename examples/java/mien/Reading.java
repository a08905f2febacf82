package mien;

// Written by abi/generate_bindings.py.
/** How a treated zone is read. Plain numbers: newer libraries may have more. */
public final class Reading {
    private Reading() {}

    /** the zone is no witness: what the result holds */
    public static final int TREATED = 0;

    /** all of the face is a witness */
    public static final int AS_EXPRESSION = 1;
}

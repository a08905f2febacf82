package mien;

// Written by abi/generate_bindings.py.
/**
 * What is done about landmarks whose left and right are exchanged. Plain numbers: newer libraries may have
 * more.
 */
public final class Sides {
    private Sides() {}

    /** MIEN_E_MISMATCH that names them */
    public static final int REFUSE = 0;

    /** exchange them back and say so in the report */
    public static final int MEND = 1;

    public static final int IGNORE = 2;
}

package mien;

// Written by abi/generate_bindings.py.
/** What one unit of the scan is. Plain numbers: newer libraries may have more. */
public final class Units {
    private Units() {}

    /** metres, deci- and centimetres and inches are recognised by size and scaled */
    public static final int DETECT = 0;

    public static final int MILLIMETRES = 1;

    /** anything that does not look like millimetres is an error */
    public static final int REFUSE = 2;
}

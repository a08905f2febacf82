package mien;

// Written by abi/generate_bindings.py.
/** Kinds of measurements. Plain numbers: newer libraries may have more. */
public final class Measure {
    private Measure() {}

    /** straight, mm */
    public static final int LENGTH = 1;

    /** along the skin, mm */
    public static final int SURFACE_LENGTH = 2;

    /** degrees */
    public static final int ANGLE = 3;

    /** signed, of one line against another, degrees */
    public static final int INCLINATION = 4;

    /** percent */
    public static final int PROPORTION = 5;

    /** signed distance from a line, mm */
    public static final int LINE_OFFSET = 6;
}

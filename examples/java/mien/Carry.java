package mien;

// Written by abi/generate_bindings.py.
/**
 * How vertices are carried onto a surface that is not in correspondence. Plain numbers: newer libraries may
 * have more.
 */
public final class Carry {
    private Carry() {}

    public static final int CLOSEST_POINT = 1;

    /** along one direction: a height field's integral */
    public static final int DIRECTION = 2;

    public static final int VERTEX_NORMAL = 3;
}

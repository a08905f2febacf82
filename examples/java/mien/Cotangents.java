package mien;

// Written by abi/generate_bindings.py.
/** What to do with negative cotangent weights. Plain numbers: newer libraries may have more. */
public final class Cotangents {
    private Cotangents() {}

    public static final int INTRINSIC_DELAUNAY = 0;

    public static final int CLAMP = 1;

    public static final int KEEP = 2;
}

package mien;

// Written by abi/generate_bindings.py.
/** Mass matrices of the Laplacian. Plain numbers: newer libraries may have more. */
public final class Mass {
    private Mass() {}

    public static final int MIXED_VORONOI = 0;

    public static final int BARYCENTRIC = 1;

    /** bands then follow the triangulation's density; for comparison */
    public static final int NONE = 2;
}

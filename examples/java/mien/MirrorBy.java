package mien;

// Written by abi/generate_bindings.py.
/** What the mirror plane of a face is found by. Plain numbers: newer libraries may have more. */
public final class MirrorBy {
    private MirrorBy() {}

    /** all vertices and their partners, robustly */
    public static final int SURFACE = 0;

    /** the landmarks and their partners alone */
    public static final int LANDMARKS = 1;
}

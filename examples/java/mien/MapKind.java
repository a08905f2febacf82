package mien;

// Written by abi/generate_bindings.py.
/** Directions of a hierarchy's maps. Plain numbers: newer libraries may have more. */
public final class MapKind {
    private MapKind() {}

    /** from the next finer level to this one */
    public static final int DOWN = 1;

    /** from this level to the next finer one */
    public static final int UP = 2;
}

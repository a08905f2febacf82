package mien;

// Written by abi/generate_bindings.py.
/** Distances between two faces. Plain numbers: newer libraries may have more. */
public final class Metric {
    private Metric() {}

    /** mm: mean of |dx| + |dy| + |dz| over the vertices */
    public static final int L1 = 1;

    /** mm: mean Euclidean distance over the vertices */
    public static final int L2 = 2;

    /** mm: largest distance of a vertex from the other surface, both ways */
    public static final int HAUSDORFF = 3;

    /** rad: change of the dihedral angles, masked, weighted with area */
    public static final int DAME = 4;

    /** 0 to 1: difference of the global roughness */
    public static final int FMPD = 5;
}

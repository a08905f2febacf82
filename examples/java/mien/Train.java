package mien;

// Written by abi/generate_bindings.py.
/** How the two subspaces are found. Plain numbers: newer libraries may have more. */
public final class Train {
    private Train() {}

    /** joint PCA */
    public static final int JPCA = 0;

    /** quasi-orthogonal joint PCA */
    public static final int QOJPCA = 1;
}

package mien;

// Written by abi/generate_bindings.py.
/** Kernels: what makes two vertices of the template move alike. Plain numbers: newer libraries may have more. */
public final class KernelKind {
    private KernelKind() {}

    /** no kernel: modes from faces alone (needs pca_dataset) */
    public static final int NONE = 0;

    /** squared exponential of the straight distance */
    public static final int EUCLIDEAN_SE = 1;

    /** of the distance along the surface: mouth and eyes may open */
    public static final int GEODESIC_SE = 2;

    /** cubic B-splines on a grid in space */
    public static final int BSPLINE = 3;

    /** Matern along the surface, positive definite by construction */
    public static final int SURFACE_MATERN = 4;
}

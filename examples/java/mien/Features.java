package mien;

// Written by abi/generate_bindings.py.
/** Representations. Plain numbers: newer libraries may have more. */
public final class Features {
    private Features() {}

    public static final int EUCLIDEAN = 1;

    public static final int EUCLIDEAN_STANDARDISED = 2;

    public static final int EUCLIDEAN_NORMALISED = 3;

    public static final int DEFORMATION = 4;

    public static final int DEFORMATION_NORMALISED = 5;

    public static final int DEFORMATION_STANDARDISED = 6;
}

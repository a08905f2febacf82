package mien;

// Written by abi/generate_bindings.py.
/** How a face is taken apart into identity and expression. Plain numbers: newer libraries may have more. */
public final class Fit {
    private Fit() {}

    /** prior of one of a few expressions; the default and the best */
    public static final int MIXTURE = 0;

    /** Gaussian priors */
    public static final int MAP = 1;

    /** joint least squares without a prior */
    public static final int EXACT = 2;

    /** block relaxation, for reproduction */
    public static final int ALTERNATING = 3;
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * What each vertex gives. jousse-2022 (B.2) has 17 numbers a vertex without naming them; ours are
 * displacement (3), change of the normal (3), k1, k2, mean and Gaussian curvature, curvedness, and the
 * curvature tensor (6), each of them an equal part of curvature_share. Plain numbers: newer libraries may
 * have more.
 */
public final class ScoreFeatures {
    private ScoreFeatures() {}

    /** displacement, k1, k2 */
    public static final int DISPLACEMENT_AND_CURVATURE = 0;

    /** all 17 */
    public static final int ALL = 1;
}

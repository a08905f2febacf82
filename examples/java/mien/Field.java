package mien;

// Written by abi/generate_bindings.py.
/** Fields with one value per vertex of the before face. Plain numbers: newer libraries may have more. */
public final class Field {
    private Field() {}

    /** along the normal of the before face */
    public static final int SIGNED_DISTANCE_MM = 1;

    /** length of the displacement or to the closest place */
    public static final int DISTANCE_MM = 2;

    public static final int POSITIVE_VOLUME_MM3 = 3;

    public static final int NEGATIVE_VOLUME_MM3 = 4;

    /** 1/mm, positive where the surface bulges outwards */
    public static final int CURVATURE_MAXIMAL = 5;

    /** 1/mm */
    public static final int CURVATURE_MINIMAL = 6;

    /** 1/mm */
    public static final int CURVATURE_MEAN = 7;

    /** 1/mm^2 */
    public static final int CURVATURE_GAUSSIAN = 8;
}

package mien;

// Written by abi/generate_bindings.py.
/** Fields with one value per vertex of a visit's face. Plain numbers: newer libraries may have more. */
public final class StudyField {
    private StudyField() {}

    /** how far the fitted surface may lie off the skin */
    public static final int NORMAL_SD_MM = 1;

    /** in [0, 1]: how far the scan was seen there */
    public static final int WEIGHT = 2;

    /** of the expression that was taken off: root of the summed posterior variance of a place's coordinates */
    public static final int EXPRESSION_SD_MM = 3;
}

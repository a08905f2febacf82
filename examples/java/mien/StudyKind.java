package mien;

// Written by abi/generate_bindings.py.
/** Why a change has no deviation. Plain numbers: newer libraries may have more. */
public final class StudyKind {
    private StudyKind() {}

    public static final int KNOWN = 0;

    /** too little of the zone was seen: no values either */
    public static final int UNSEEN = 1;

    /** the fit of one of the visits failed */
    public static final int FAILED_FIT = 2;

    /** a face came without deviations */
    public static final int NO_SURFACE_ERRORS = 3;

    /** the zone lies behind the expression model's rim */
    public static final int OUTSIDE_EXPRESSIONS = 4;
}

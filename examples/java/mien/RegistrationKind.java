package mien;

// Written by abi/generate_bindings.py.
/** Fields with one value per template vertex. Plain numbers: newer libraries may have more. */
public final class RegistrationKind {
    private RegistrationKind() {}

    /** signed distance to the scan, positive: the scan lies outside */
    public static final int RESIDUAL_MM = 1;

    /** in [0, 1]: how much of the scan's say counted */
    public static final int WEIGHT = 2;

    /** of the place, per axis (root mean square) */
    public static final int STANDARD_DEVIATION_MM = 3;

    /**
     * the true place lies within, 95 times out of 100: the deviation's pattern in the size of the zone's expected
     * error (mien_registration_get_expected_error)
     */
    public static final int RADIUS95_MM = 4;

    /** how far the surface may lie off the skin along its normal: what mien_measure_options wants. Since 0.2 */
    public static final int NORMAL_DEVIATION_MM = 5;

    /** how far mien_registration_tie() moved the place. Since 0.2 */
    public static final int SLIDE_MM = 6;

    /** -1 to 1: correlation of both visits' pictures around the place after the slide; 0: not compared. Since 0.2 */
    public static final int TIE_AGREEMENT = 7;

    /** 0 to 1: how far the texture holds the place. Since 0.2 */
    public static final int TIE_SHARE = 8;

    /** between both visits' places along the skin, per axis; 0 where the texture holds nothing. Since 0.2 */
    public static final int TIE_DEVIATION_MM = 9;
}

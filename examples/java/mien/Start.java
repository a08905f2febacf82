package mien;

// Written by abi/generate_bindings.py.
/** Where a fit begins. Plain numbers: newer libraries may have more. */
public final class Start {
    private Start() {}

    /** landmarks when three match, else a search */
    public static final int AUTOMATIC = 0;

    public static final int LANDMARKS = 1;

    /** start_rotation, start_translation, start_scale */
    public static final int POSE = 2;

    /** over all poses, those up to 60 degrees off frontal first */
    public static final int SEARCH = 3;
}

package mien;

// Written by abi/generate_bindings.py.
/** Where a face lies against the training faces. Plain numbers: newer libraries may have more. */
public final class Pose {
    private Pose() {}

    /**
     * on the model's stable zone where it has one; else rigid when the face lies more than 3 degrees or 8 mm away
     * from the mean face and a rigid motion explains it clearly better, else kept
     */
    public static final int AUTO = 0;

    /** in the training's frame */
    public static final int KEEP = 1;

    /** anywhere: a rigid motion is fitted together with the face */
    public static final int RIGID = 2;
}

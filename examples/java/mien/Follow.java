package mien;

// Written by abi/generate_bindings.py.
/** What became of the face in a frame. Plain numbers: newer libraries may have more. */
public final class Follow {
    private Follow() {}

    public static final int FOLLOWED = 0;

    /** hardly seen, or it has slid along its skin */
    public static final int DOUBTFUL = 1;

    /** was lost, and a search found it in this frame */
    public static final int FOUND_AGAIN = 2;

    /** the fitted face is that of the last frame that was not lost */
    public static final int LOST = 3;
}

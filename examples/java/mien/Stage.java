package mien;

// Written by abi/generate_bindings.py.
/** Stages of long work, as a progress callback sees them. Plain numbers: newer libraries may have more. */
public final class Stage {
    private Stage() {}

    public static final int READING = 1;

    public static final int GEODESICS = 2;

    public static final int BASIS = 3;

    public static final int ALIGNMENT = 4;

    public static final int FITTING = 5;

    public static final int REFINING = 6;

    public static final int TRAINING = 7;

    public static final int NEUTRALIZING = 8;

    public static final int MEASURING = 9;

    public static final int WRITING = 10;
}

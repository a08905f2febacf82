package mien;

// Written by abi/generate_bindings.py.
/**
 * How the number of deformation modes grows over the rounds (jousse-2022 2.5.2.2). Plain numbers: newer
 * libraries may have more.
 */
public final class Growth {
    private Growth() {}

    public static final int CONSTANT = 0;

    public static final int LINEAR = 1;

    public static final int EXPONENTIAL = 2;

    public static final int CUBIC = 3;
}

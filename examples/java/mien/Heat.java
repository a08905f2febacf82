package mien;

// Written by abi/generate_bindings.py.
/**
 * What the heat of the heat method does at borders of the template. Plain numbers: newer libraries may have
 * more.
 */
public final class Heat {
    private Heat() {}

    /** stays inside */
    public static final int NEUMANN = 1;

    /** is cooled to zero */
    public static final int DIRICHLET = 2;

    /** half of each */
    public static final int AVERAGE = 3;
}

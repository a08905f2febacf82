package mien;

// Written by abi/generate_bindings.py.
/** MIEN_DTYPE_* of the C interface. Plain numbers: newer libraries may have more. */
public final class Dtype {
    private Dtype() {}

    public static final int F32 = 1;

    public static final int F64 = 2;

    public static final int I32 = 3;

    public static final int U32 = 4;

    public static final int U8 = 5;
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * Places of the whole face and of what no zone covers, beside 0 .. zone_count - 1. Plain numbers: newer
 * libraries may have more.
 */
public final class ZoneKind {
    private ZoneKind() {}

    public static final int WHOLE = -1;

    public static final int REST = -2;
}

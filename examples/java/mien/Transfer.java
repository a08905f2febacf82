package mien;

// Written by abi/generate_bindings.py.
/** What mien_surface_transfer_json() carries over. Plain numbers: newer libraries may have more. */
public final class Transfer {
    private Transfer() {}

    public static final int LANDMARKS = 1;

    public static final int ZONES = 2;
}

package mien;

// Written by abi/generate_bindings.py.
/** Tells a running call to stop. Thread-safe, sticky, single-use. */
public final class Cancel extends NativeObject {
    Cancel(long owned) { super(owned, Raw.GET::mien_cancel_release); }

    /** Makes a cancel token: name it in the options of one call, request it from any thread. */
    public Cancel() { super(create()); }

    /**
     * Makes a cancel token: name it in the options of one call, request it from any thread. C:
     * mien_cancel_create().
     * @throws MienException MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public static Cancel create() {
        try (Call call = new Call()) {
            var outAt = call.room(8);
            call.check(Raw.GET.mien_cancel_create(Memory.address(outAt), call.error()));
            return call.keep(new Cancel(call.pointer(outAt)));
        }
    }

    /** Asks the call that was given this token to return MIEN_E_CANCELLED soon. Sticky. C: mien_cancel_request(). */
    public void request() {
        try (Call call = new Call()) {
            var cancelAt = call.use(this);
            Raw.GET.mien_cancel_request(Memory.address(cancelAt));
        }
    }
}

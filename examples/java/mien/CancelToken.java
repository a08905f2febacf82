package mien;

/** Stops the call that was given it; request() may come from any thread. Sticky, for one call. */
public final class CancelToken extends NativeObject {
    public CancelToken() { super(Native.CANCEL, Native.cancelCreate()); }

    public void request() {
        long handle = acquire();
        try {
            Native.cancelRequest(handle);
        } finally {
            done();
        }
    }
}

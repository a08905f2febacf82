package mien;

/** A template fitted to a scan. Immutable: share freely between threads. */
public final class Registration extends NativeObject {
    Registration(long handle) { super(Native.REGISTRATION, handle); }

    /** The mesh, with a reference of its own: it may outlive this object. */
    public Mesh mesh() {
        long handle = acquire();
        try {
            return new Mesh(Native.registrationMesh(handle));
        } finally {
            done();
        }
    }
}

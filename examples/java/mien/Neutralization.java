package mien;

/** A face without its expression. Immutable: share freely between threads. */
public final class Neutralization extends NativeObject {
    Neutralization(long handle) { super(Native.NEUTRALIZATION, handle); }

    /** The mesh, with a reference of its own: it may outlive this object. */
    public Mesh mesh() {
        long handle = acquire();
        try {
            return new Mesh(Native.neutralizationMesh(handle));
        } finally {
            done();
        }
    }
}

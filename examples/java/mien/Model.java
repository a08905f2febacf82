package mien;

/** A deformation model with its template. Immutable: share freely between threads. */
public final class Model extends NativeObject {
    Model(long handle) { super(Native.MODEL, handle); }
}

package mien;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/** A checked triangle mesh in millimetres. Immutable: share freely between threads. */
public final class Mesh extends NativeObject {
    Mesh(long handle) { super(Native.MESH, handle); }

    public int vertexCount() {
        long handle = acquire();
        try {
            return Math.toIntExact(Native.meshVertices(handle));
        } finally {
            done();
        }
    }

    /** The positions as bytes of #V x 3 floats in native order, in a direct buffer. */
    public ByteBuffer positionBytes() {
        long handle = acquire();
        try {
            int vertices = Math.toIntExact(Native.meshVertices(handle));
            ByteBuffer bytes = ByteBuffer.allocateDirect(Math.multiplyExact(12, vertices)).order(ByteOrder.nativeOrder());
            Native.meshPositions(handle, bytes, vertices);
            return bytes;
        } finally {
            done();
        }
    }

    public FloatBuffer positions() { return positionBytes().asFloatBuffer(); }
}

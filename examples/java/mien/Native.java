package mien;

import java.nio.ByteBuffer;

/** The functions of the JNI library. Handles are plain numbers here; text is UTF-8 in byte arrays. */
final class Native {
    static final int SESSION = 0, CANCEL = 1, MESH = 2, MODEL = 3, EXPRESSION_MODEL = 4, REGISTRATION = 5, NEUTRALIZATION = 6;

    static {
        String path = System.getProperty("mien.jni");
        if (path != null) System.load(path);
        else System.loadLibrary("mien_jni");
    }

    private Native() {}

    static native void release(int kind, long handle);
    static native byte[] version();
    static native byte[] statusName(int status);
    static native long sessionCreate(int threads, long maxBytes);
    static native long cancelCreate();
    static native void cancelRequest(long cancel);
    static native long meshCreate(long session, ByteBuffer positions, int vertices, ByteBuffer triangles, int triangleCount);
    static native long meshLoad(long session, byte[] path);
    static native void meshSave(long session, long mesh, byte[] path);
    static native long meshVertices(long mesh);
    static native void meshPositions(long mesh, ByteBuffer floats, int vertices);
    static native long modelLoad(long session, byte[] path);
    static native long expressionModelLoad(long session, byte[] path);
    static native long register(long session, long model, long scan, byte[][] names, double[] positions, Progress progress, long cancel);
    static native long registrationMesh(long registration);
    static native long neutralize(long session, long model, long registration, Progress progress, long cancel);
    static native long neutralizeMesh(long session, long model, long mesh, Progress progress, long cancel);
    static native long neutralizationMesh(long neutralization);
    static native double absoluteVolume(long session, long before, long after);
}

package mien;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;

/** Threads and a memory budget. One call at a time, so the calls that work are synchronized. */
public final class Session extends NativeObject {
    public Session() { this(1, 0); }
    public Session(int threads, long maxBytes) { super(Native.SESSION, Native.sessionCreate(threads, maxBytes)); }

    public static String version() { return new String(Native.version(), StandardCharsets.UTF_8); }

    private static byte[] utf8(String text) { return (text + "\0").getBytes(StandardCharsets.UTF_8); }
    private static long acquire(NativeObject object) { return object == null ? 0 : object.acquire(); }
    private static void done(NativeObject... objects) {
        for (NativeObject object : objects) if (object != null) object.done();
    }

    private static ByteBuffer direct(int bytes) { return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder()); }

    /** positions: x y z per vertex; triangles: three vertex numbers each, or null for a point cloud. */
    public synchronized Mesh createMesh(float[] positions, int[] triangles) {
        ByteBuffer points = direct(Math.multiplyExact(4, positions.length));
        points.asFloatBuffer().put(positions);
        ByteBuffer corners = triangles == null ? null : direct(Math.multiplyExact(4, triangles.length));
        if (corners != null) corners.asIntBuffer().put(triangles);
        long session = acquire();
        try {
            return new Mesh(Native.meshCreate(session, points, positions.length / 3, corners, triangles == null ? 0 : triangles.length / 3));
        } finally {
            done();
        }
    }

    public synchronized Mesh loadMesh(String path) {
        long session = acquire();
        try {
            return new Mesh(Native.meshLoad(session, utf8(path)));
        } finally {
            done();
        }
    }

    public synchronized void saveMesh(Mesh mesh, String path) {
        long session = acquire();
        try {
            long handle = mesh.acquire();
            try {
                Native.meshSave(session, handle, utf8(path));
            } finally {
                mesh.done();
            }
        } finally {
            done();
        }
    }

    public synchronized Model loadModel(String path) {
        long session = acquire();
        try {
            return new Model(Native.modelLoad(session, utf8(path)));
        } finally {
            done();
        }
    }

    public synchronized ExpressionModel loadExpressionModel(String path) {
        long session = acquire();
        try {
            return new ExpressionModel(Native.expressionModelLoad(session, utf8(path)));
        } finally {
            done();
        }
    }

    /** Fits the model's template to a scan. landmarks (three coordinates by name), progress, cancel: may be null. */
    public synchronized Registration register(Model model, Mesh scan, Map<String, double[]> landmarks, Progress progress, CancelToken cancel) {
        int count = landmarks == null ? 0 : landmarks.size(), row = 0;
        byte[][] names = new byte[count][];
        double[] positions = new double[3 * count];
        if (landmarks != null)
            for (Map.Entry<String, double[]> landmark : landmarks.entrySet()) {
                names[row] = utf8(landmark.getKey());
                System.arraycopy(landmark.getValue(), 0, positions, 3 * row++, 3);
            }
        long session = acquire(), modelHandle = 0, scanHandle = 0, cancelHandle = 0;
        try {
            modelHandle = model.acquire();
            scanHandle = scan.acquire();
            cancelHandle = acquire(cancel);
            return new Registration(Native.register(session, modelHandle, scanHandle, names, positions, progress, cancelHandle));
        } finally {
            done(modelHandle == 0 ? null : model, scanHandle == 0 ? null : scan, cancelHandle == 0 ? null : cancel, this);
        }
    }

    public synchronized Neutralization neutralize(ExpressionModel model, Registration fitted, Progress progress, CancelToken cancel) {
        return neutralize(model, (NativeObject) fitted, progress, cancel);
    }

    public synchronized Neutralization neutralize(ExpressionModel model, Mesh face, Progress progress, CancelToken cancel) {
        return neutralize(model, (NativeObject) face, progress, cancel);
    }

    private Neutralization neutralize(ExpressionModel model, NativeObject face, Progress progress, CancelToken cancel) {
        long session = acquire(), modelHandle = 0, faceHandle = 0, cancelHandle = 0;
        try {
            modelHandle = model.acquire();
            faceHandle = face.acquire();
            cancelHandle = acquire(cancel);
            return new Neutralization(face instanceof Registration
                ? Native.neutralize(session, modelHandle, faceHandle, progress, cancelHandle)
                : Native.neutralizeMesh(session, modelHandle, faceHandle, progress, cancelHandle));
        } finally {
            done(modelHandle == 0 ? null : model, faceHandle == 0 ? null : face, cancelHandle == 0 ? null : cancel, this);
        }
    }

    /** Absolute volume between two faces in correspondence, mL. */
    public synchronized double absoluteVolume(Mesh before, Mesh after) {
        long session = acquire(), beforeHandle = 0, afterHandle = 0;
        try {
            beforeHandle = before.acquire();
            afterHandle = after.acquire();
            return Native.absoluteVolume(session, beforeHandle, afterHandle);
        } finally {
            done(beforeHandle == 0 ? null : before, afterHandle == 0 ? null : after, this);
        }
    }
}

package mien;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;

/** Numbers for the library, float or double: arrays are copied, direct buffers in native order are read in place. */
public final class Values {
    final ByteBuffer bytes;
    final long count;
    final int dtype;  // MIEN_DTYPE_F32, MIEN_DTYPE_F64

    private Values(ByteBuffer bytes, long count, int dtype) {
        this.bytes = bytes;
        this.count = count;
        this.dtype = dtype;
    }

    public static Values of(double... values) {
        ByteBuffer bytes = room(8L * values.length);
        bytes.asDoubleBuffer().put(values);
        return new Values(bytes, values.length, 2);
    }

    public static Values of(float[] values) {
        ByteBuffer bytes = room(4L * values.length);
        bytes.asFloatBuffer().put(values);
        return new Values(bytes, values.length, 1);
    }

    /** `bytes` holds floats (or doubles) in native order; a direct buffer is not copied. */
    public static Values of(ByteBuffer bytes, boolean doubles) {
        int width = doubles ? 8 : 4;
        ByteBuffer slice = bytes.slice().order(ByteOrder.nativeOrder());
        if (!bytes.isDirect()) {
            ByteBuffer copy = room(slice.capacity());
            copy.put(slice);
            slice = copy;
        }
        return new Values(slice, slice.capacity() / width, doubles ? 2 : 1);
    }

    public static Values of(DoubleBuffer values) {
        double[] copy = new double[values.remaining()];
        values.duplicate().get(copy);
        return of(copy);
    }

    public static Values of(FloatBuffer values) {
        float[] copy = new float[values.remaining()];
        values.duplicate().get(copy);
        return of(copy);
    }

    private static ByteBuffer room(long size) {
        return ByteBuffer.allocateDirect(Math.toIntExact(Math.max(8, size))).order(ByteOrder.nativeOrder());
    }
}

package mien;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Direct memory of one call and its address. */
final class Memory {
    final ByteBuffer bytes;
    final long address;

    Memory(long size) {
        bytes = ByteBuffer.allocateDirect(Math.toIntExact(Math.max(8, size))).order(ByteOrder.nativeOrder());
        address = Raw.GET.address(bytes);
    }

    /** A host's own direct buffer. */
    Memory(ByteBuffer direct) {
        bytes = direct;
        address = Raw.GET.address(direct);
    }

    static long address(Memory memory) { return memory == null ? 0 : memory.address; }
    static long address(long pointer) { return pointer; }

    double[] doubles(int offset, int count) {
        double[] made = new double[count];
        for (int i = 0; i < count; ++i) made[i] = bytes.getDouble(offset + 8 * i);
        return made;
    }

    void put(int offset, double[] values, int count, String name) {
        if (values == null || values.length != count) throw new IllegalArgumentException(name + " needs " + count + " values");
        for (int i = 0; i < count; ++i) bytes.putDouble(offset + 8 * i, values[i]);
    }
}

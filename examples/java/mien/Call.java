package mien;

import java.lang.ref.Reference;
import java.lang.reflect.Array;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;

/** One call: its memory, the objects that it uses, progress, cancelling, and an exception to bring home. */
final class Call implements AutoCloseable {
    private static final int SCRATCH_BYTES = 65536;  // room of the first try where a result's size is not known
    private static final int ERROR_BYTES = 272;      // sizeof(mien_error), checked in mien_jni.c

    interface Reader<T> {
        T read(Call call, Memory at, int offset);
    }

    private final List<Object> kept = new ArrayList<>();
    private final List<NativeObject.State> used = new ArrayList<>();
    private final List<NativeObject.State> locked = new ArrayList<>();
    private Memory record;
    private Progress progress;
    private long progressUser, logUser;
    private Throwable thrown;

    @Override
    public void close() {
        if (progressUser != 0) Callbacks.forget(progressUser);
        for (NativeObject.State state : used) state.done();
        for (int i = locked.size(); i-- > 0;) locked.get(i).serial.unlock();
        Reference.reachabilityFence(kept);
    }

    // ---- memory and objects ----
    Memory room(long size) {
        Memory memory = new Memory(size);
        kept.add(memory);
        return memory;
    }

    long error() {
        record = room(ERROR_BYTES);
        record.bytes.putInt(0, ERROR_BYTES);
        return record.address;
    }

    void lock(NativeObject owner) {
        required(owner, "object").state.serial.lock();
        locked.add(owner.state);
    }

    long use(NativeObject owner) {
        long handle = required(owner, "object").state.acquire();
        used.add(owner.state);
        kept.add(owner);
        return handle;
    }

    long useOrNull(NativeObject owner) { return owner == null ? 0 : use(owner); }
    long pointer(Memory at) { return at.bytes.getLong(0); }

    <T extends NativeObject> T keep(T made) {
        if (logUser != 0) made.keep(logUser);
        logUser = 0;
        return made;
    }

    <T> T required(T value, String name) {
        if (value == null) throw new NullPointerException(name + " is null");
        return value;
    }

    Memory text(String text) {
        if (required(text, "text").indexOf('\0') >= 0) throw new IllegalArgumentException("a text holds a zero character");
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        Memory memory = room(bytes.length + 1L);
        memory.bytes.put(bytes);
        return memory;
    }

    Memory textOrNull(String text) { return text == null ? null : text(text); }

    Memory array(double[] values) {
        if (values == null || values.length == 0) return null;
        Memory memory = room(8L * values.length);
        memory.bytes.asDoubleBuffer().put(values);
        return memory;
    }

    Memory array(float[] values) {
        if (values == null || values.length == 0) return null;
        Memory memory = room(4L * values.length);
        memory.bytes.asFloatBuffer().put(values);
        return memory;
    }

    Memory array(int[] values) {
        if (values == null || values.length == 0) return null;
        Memory memory = room(4L * values.length);
        memory.bytes.asIntBuffer().put(values);
        return memory;
    }

    Memory array(long[] values) {
        if (values == null || values.length == 0) return null;
        Memory memory = room(8L * values.length);
        memory.bytes.asLongBuffer().put(values);
        return memory;
    }

    Memory array(byte[] values) {
        if (values == null || values.length == 0) return null;
        Memory memory = room(values.length);
        memory.bytes.put(values);
        return memory;
    }

    /** Writes a mien_array_view: data, count, stride, dtype, reserved. */
    void matrix(Memory at, int offset, Values values, int columns, String name) {
        if (values != null && values.count % columns != 0)
            throw new IllegalArgumentException(name + " has " + values.count + " values, which is no multiple of " + columns);
        if (values != null) kept.add(values);
        at.bytes.putLong(offset, values == null || values.count == 0 ? 0 : Raw.GET.address(values.bytes));
        at.bytes.putLong(offset + 8, values == null ? 0 : values.count / columns);
        at.bytes.putLong(offset + 16, 0);
        at.bytes.putInt(offset + 24, values == null ? 2 : values.dtype);
        at.bytes.putInt(offset + 28, 0);
    }

    Memory view(Values values, int columns, String name) {
        Memory memory = room(32);
        matrix(memory, 0, required(values, name), columns, name);
        return memory;
    }

    Memory viewOrNull(Values values, int columns, String name) { return values == null ? null : view(values, columns, name); }

    Memory texts(List<String> texts) {
        if (texts == null || texts.isEmpty()) return null;
        Memory memory = room(8L * texts.size());
        for (int i = 0; i < texts.size(); ++i) memory.bytes.putLong(8 * i, text(texts.get(i)).address);
        return memory;
    }

    Memory handles(List<? extends NativeObject> owners) {
        if (owners == null || owners.isEmpty()) return null;
        Memory memory = room(8L * owners.size());
        for (int i = 0; i < owners.size(); ++i) memory.bytes.putLong(8 * i, use(owners.get(i)));
        return memory;
    }

    Memory record(Record_ value, int size, boolean needed, String name) {
        if (value == null && !needed) return null;
        Memory memory = room(size);
        required(value, name).fill(this, memory, 0);
        return memory;
    }

    Memory records(List<? extends Record_> values, int size) {
        if (values == null || values.isEmpty()) return null;
        Memory memory = room((long) size * values.size());
        for (int i = 0; i < values.size(); ++i) values.get(i).fill(this, memory, size * i);
        return memory;
    }

    Memory sized(int size) {
        Memory memory = room(size);
        memory.bytes.putInt(0, size);
        return memory;
    }

    // ---- counts ----
    long rows(Object array, long columns, String name) {
        long size = array == null ? 0 : Array.getLength(array);
        if (columns <= 0 || size % columns != 0)
            throw new IllegalArgumentException(name + " has " + size + " values, which is no multiple of " + columns);
        return size / columns;
    }

    long rows(List<?> values, long columns, String name) { return values == null ? 0 : values.size(); }

    void agree(String name, long rows, long expected) {
        if (rows != expected) throw new IllegalArgumentException(name + " has " + rows + " rows, " + expected + " are expected");
    }

    long firstCapacity(long rowBytes) { return Math.max(1, SCRATCH_BYTES / rowBytes); }
    long count(Memory at) { return at.bytes.getLong(0); }

    /** Zero when the call is done; else the room that it asks for. */
    long more(int status, long capacity, Memory count) {
        if (status == Status.E_BUFFER_TOO_SMALL && count(count) > capacity) return count(count);
        check(status);
        return 0;
    }

    // ---- what comes out ----
    String readText(Memory at, long count) {
        byte[] bytes = new byte[Math.toIntExact(Math.max(0, count - 1))];
        at.bytes.get(0, bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    double[] readDoubles(Memory at, long count) {
        double[] to = new double[Math.toIntExact(count)];
        at.bytes.asDoubleBuffer().get(to);
        return to;
    }

    float[] readFloats(Memory at, long count) {
        float[] to = new float[Math.toIntExact(count)];
        at.bytes.asFloatBuffer().get(to);
        return to;
    }

    int[] readInts(Memory at, long count) {
        int[] to = new int[Math.toIntExact(count)];
        at.bytes.asIntBuffer().get(to);
        return to;
    }

    long[] readLongs(Memory at, long count) {
        long[] to = new long[Math.toIntExact(count)];
        at.bytes.asLongBuffer().get(to);
        return to;
    }

    byte[] readBytes(Memory at, long count) {
        byte[] to = new byte[Math.toIntExact(count)];
        at.bytes.get(0, to);
        return to;
    }

    <T> List<T> readRecords(Memory at, long count, int size, Reader<T> read) {
        List<T> made = new ArrayList<>();
        for (int i = 0; i < count; ++i) made.add(read.read(this, at, size * i));
        return made;
    }

    /** The library's own memory, read-only; its object stays as long as any view of it. */
    ByteBuffer lend(Memory at, long bytes, NativeObject owner) {
        ByteBuffer memory = Raw.GET.memory(at.bytes.getLong(0), bytes);
        NativeObject.State state = owner.state;
        state.acquire();
        NativeObject.CLEANER.register(memory, state::done);
        return memory.asReadOnlyBuffer().order(ByteOrder.nativeOrder());
    }

    /** Zero-terminated UTF-8 of the library. */
    static String text(long address) {
        if (address == 0) return null;
        int length = 0;
        ByteBuffer bytes = Raw.GET.memory(address, 4096);
        while (bytes.get(length) != 0) ++length;
        byte[] copy = new byte[length];
        bytes.get(0, copy);
        return new String(copy, StandardCharsets.UTF_8);
    }

    // ---- errors, progress, cancelling, log ----
    void check(int status) {
        if (status == Status.OK) return;
        if (thrown instanceof RuntimeException) throw (RuntimeException) thrown;
        if (thrown instanceof Error) throw (Error) thrown;
        long length = 0;
        while (length < 255 && record.bytes.get((int) (16 + length)) != 0) ++length;
        byte[] bytes = new byte[(int) length];
        record.bytes.get(16, bytes);
        String message = new String(bytes, StandardCharsets.UTF_8);
        if (status == Status.E_CANCELLED) throw new CancellationException(message);
        throw new MienException(status, record.bytes.getLong(8), message);
    }

    /** Also without a receiver: interrupting the thread cancels its call. */
    long progressFunction(Progress receiver) {
        progress = receiver;
        progressUser = Callbacks.remember(this);
        return Raw.GET.progressFunction();
    }

    long progressUser() { return progressUser; }

    int report(int stage, double fraction) {
        try {
            if (Thread.currentThread().isInterrupted()) return 1;
            return progress == null || progress.report(stage, fraction) ? 0 : 1;
        } catch (Throwable throwable) {  // must not unwind through native frames
            thrown = throwable;
            return 1;
        }
    }

    long logFunction(LogListener listener) {
        if (listener == null) return 0;
        logUser = Callbacks.remember(listener);
        return Raw.GET.logFunction();
    }

    long logUser(LogListener listener) { return listener == null ? 0 : logUser; }
}

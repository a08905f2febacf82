package mien;

import java.lang.ref.Cleaner;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.LongConsumer;

/**
 * Owns one reference to a native object. close() may be called any number of times, from any thread, also
 * while another thread is inside a call with the object: the release then waits for that call. What is never
 * closed is released after garbage collection.
 */
public abstract class NativeObject implements AutoCloseable {
    static final Cleaner CLEANER = Cleaner.create();

    /** Holds the handle and never the wrapper, which could otherwise never be collected. */
    static final class State implements Runnable {
        private final LongConsumer release;
        final ReentrantLock serial = new ReentrantLock();  // for objects that one call at a time may use
        private long handle;
        private int users;
        private boolean closed;
        private Object kept;  // a log's receiver

        State(long handle, LongConsumer release) {
            this.handle = handle;
            this.release = release;
        }

        synchronized long acquire() {
            if (closed) throw new IllegalStateException("the object is closed");
            ++users;
            return handle;
        }

        synchronized void done() {
            --users;
            releaseIfUnused();
        }

        @Override
        public synchronized void run() {
            closed = true;
            releaseIfUnused();
        }

        private void releaseIfUnused() {
            if (!closed || users > 0 || handle == 0) return;
            release.accept(handle);
            handle = 0;
            if (kept instanceof Long) Callbacks.forget((Long) kept);
        }
    }

    final State state;
    private final Cleaner.Cleanable cleanable;

    NativeObject(long owned, LongConsumer release) {
        if (owned == 0) throw new IllegalStateException("the object is closed");
        state = new State(owned, release);
        cleanable = CLEANER.register(this, state);
    }

    /** Takes over what another object of the same class was made for. */
    NativeObject(NativeObject made) {
        state = new State(made.state.acquire(), made.state.release);
        synchronized (made.state) {
            state.kept = made.state.kept;
            made.state.kept = null;
            made.state.handle = 0;
        }
        cleanable = CLEANER.register(this, state);
    }

    final void keep(Object kept) { state.kept = kept; }

    @Override
    public final void close() {
        cleanable.clean();
    }
}

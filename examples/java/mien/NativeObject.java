package mien;

import java.lang.ref.Cleaner;

/**
 * Owns one reference to a native object. close() may be called any number of times, from any thread, also
 * while another thread is inside a call with the object: the release then waits for that call. What is never
 * closed is released after garbage collection.
 */
abstract class NativeObject implements AutoCloseable {
    private static final Cleaner CLEANER = Cleaner.create();

    /** Holds the handle and never the wrapper, which could otherwise never be collected. */
    private static final class State implements Runnable {
        private long handle;
        private final int kind;
        private int users;
        private boolean closed;

        State(int kind, long handle) {
            this.kind = kind;
            this.handle = handle;
        }

        synchronized long acquire() {
            if (closed) throw new IllegalStateException("the object is closed");
            ++users;
            return handle;
        }

        synchronized void yieldUse() {
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
            Native.release(kind, handle);
            handle = 0;
        }
    }

    private final State state;
    private final Cleaner.Cleanable cleanable;

    NativeObject(int kind, long handle) {
        state = new State(kind, handle);
        cleanable = CLEANER.register(this, state);
    }

    /** The handle for one call; each acquire() needs a done() in a finally block. */
    final long acquire() {
        return state.acquire();
    }

    final void done() {
        state.yieldUse();
        java.lang.ref.Reference.reachabilityFence(this);
    }

    @Override
    public final void close() {
        cleanable.clean();
    }
}

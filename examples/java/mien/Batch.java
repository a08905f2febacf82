package mien;

// Written by abi/generate_bindings.py.
/** Scans to be fitted side by side with one model, and their fits. */
public final class Batch extends NativeObject {
    Batch(long owned) { super(owned, Raw.GET::mien_batch_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Batch share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_batch_retain(at);
            return new Batch(at);
        }
    }

    /**
     * An empty batch for a model. C: mien_batch_create().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public static Batch create(Session session, Model model) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(model);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_batch_create(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(outAt), call.error()));
            return call.keep(new Batch(call.pointer(outAt)));
        }
    }

    /**
     * Adds a scan with its own options. The mesh is kept until the scan has been fitted. C: mien_batch_add().
     * @param scan as for mien_register().
     * @param options may be left out: no landmarks, all defaults. progress and cancel are not read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (landmarks of which
     * the model knows none), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY
     */
    public void add(Session session, Mesh scan, RegisterOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            call.lock(this);
            var sessionAt = call.use(session);
            var batchAt = call.use(this);
            var scanAt = call.use(scan);
            var optionsAt = (options == null ? new RegisterOptions() : options).write(call, progress, cancel);
            call.check(Raw.GET.mien_batch_add(Memory.address(sessionAt), Memory.address(batchAt), Memory.address(scanAt), Memory.address(optionsAt), call.error()));
        }
    }

    /** Adds a scan with its own options. The mesh is kept until the scan has been fitted. All else as by default. */
    public void add(Session session, Mesh scan) {
        add(session, scan, null, null, null);
    }

    /** Adds a scan with its own options. The mesh is kept until the scan has been fitted. All else as by default. */
    public void add(Session session, Mesh scan, RegisterOptions options) {
        add(session, scan, options, null, null);
    }

    /**
     * Fits all scans that were added and not yet fitted, each on one thread and as many at a time as the session
     * has threads; each with the bits of mien_register(). A scan that cannot be fitted does not end the others:
     * mien_batch_get_registration() says why. Memory is that of as many scans as threads, and of the fits. C:
     * mien_batch_run().
     * @param options may be left out: all defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK; then no scan of this call is fitted
     */
    public void run(Session session, BatchOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            call.lock(this);
            var sessionAt = call.use(session);
            var batchAt = call.use(this);
            var optionsAt = (options == null ? new BatchOptions() : options).write(call, progress, cancel);
            call.check(Raw.GET.mien_batch_run(Memory.address(sessionAt), Memory.address(batchAt), Memory.address(optionsAt), call.error()));
        }
    }

    /**
     * Fits all scans that were added and not yet fitted, each on one thread and as many at a time as the session
     * has threads; each with the bits of mien_register(). A scan that cannot be fitted does not end the others:
     * mien_batch_get_registration() says why. Memory is that of as many scans as threads, and of the fits. All
     * else as by default.
     */
    public void run(Session session) {
        run(session, null, null, null);
    }

    /**
     * Fits all scans that were added and not yet fitted, each on one thread and as many at a time as the session
     * has threads; each with the bits of mien_register(). A scan that cannot be fitted does not end the others:
     * mien_batch_get_registration() says why. Memory is that of as many scans as threads, and of the fits. All
     * else as by default.
     */
    public void run(Session session, BatchOptions options) {
        run(session, options, null, null);
    }

    /**
     * How many scans were added, and how many of them were run. C: mien_batch_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public BatchCounts counts() {
        try (Call call = new Call()) {
            call.lock(this);
            var batchAt = call.use(this);
            var scanCountAt = call.room(8);
            var runCountAt = call.room(8);
            call.check(Raw.GET.mien_batch_get_counts(Memory.address(batchAt), Memory.address(scanCountAt), Memory.address(runCountAt), call.error()));
            return new BatchCounts(scanCountAt.bytes.getInt(0), runCountAt.bytes.getInt(0));
        }
    }

    /**
     * The fit of one scan, or the error that it ended with. C: mien_batch_get_registration().
     * @param index 0 to run_count - 1, in the order of mien_batch_add().
     * @throws MienException as mien_register(), MIEN_E_NOT_FOUND (no such scan, or it was not run)
     */
    public Registration registration(int index) {
        try (Call call = new Call()) {
            call.lock(this);
            var batchAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_batch_get_registration(Memory.address(batchAt), index, Memory.address(outAt), call.error()));
            return call.keep(new Registration(call.pointer(outAt)));
        }
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * A scan that was cleaned, wound, weighed and put into a search tree, for any number of models and fits.
 * Immutable: share freely.
 */
public final class ReadyScan extends NativeObject {
    ReadyScan(long owned) { super(owned, Raw.GET::mien_ready_scan_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public ReadyScan share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_ready_scan_retain(at);
            return new ReadyScan(at);
        }
    }

    /**
     * Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked for. C:
     * mien_ready_scan_create().
     * @param scan as for mien_register().
     * @param options may be left out: defaults. Of it units, unit_to_mm, scan_weights, skin_weights, progress and
     * cancel are read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
     * (scan_weights), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED,
     * MIEN_E_CALLBACK
     */
    public static ReadyScan create(Session session, Mesh scan, RegisterOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var scanAt = call.use(scan);
            var optionsAt = (options == null ? new RegisterOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_ready_scan_create(Memory.address(sessionAt), Memory.address(scanAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new ReadyScan(call.pointer(outAt)));
        }
    }

    /**
     * Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked for. All else
     * as by default.
     */
    public static ReadyScan create(Session session, Mesh scan) {
        return create(session, scan, null, null, null);
    }

    /**
     * Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked for. All else
     * as by default.
     */
    public static ReadyScan create(Session session, Mesh scan, RegisterOptions options) {
        return create(session, scan, options, null, null);
    }

    /**
     * mien_register() of a prepared scan: the same bits where the scan's unit is known or that which its size
     * tells. C: mien_ready_scan_register().
     * @param options may be left out: no landmarks, all defaults. What mien_ready_scan_create() reads is not read
     * again, but for progress and cancel.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException as mien_register()
     */
    public Registration register(Session session, Model model, RegisterOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(model);
            var scanAt = call.use(this);
            var optionsAt = (options == null ? new RegisterOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_ready_scan_register(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(scanAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Registration(call.pointer(outAt)));
        }
    }

    /**
     * mien_register() of a prepared scan: the same bits where the scan's unit is known or that which its size
     * tells. All else as by default.
     */
    public Registration register(Session session, Model model) {
        return register(session, model, null, null, null);
    }

    /**
     * mien_register() of a prepared scan: the same bits where the scan's unit is known or that which its size
     * tells. All else as by default.
     */
    public Registration register(Session session, Model model, RegisterOptions options) {
        return register(session, model, options, null, null);
    }
}

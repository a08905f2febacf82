package mien;

// Written by abi/generate_bindings.py.
/** A finished search for a kernel's settings. Immutable. */
public final class Tuning extends NativeObject {
    Tuning(long owned) { super(owned, Raw.GET::mien_tuning_release); }

    /**
     * Residuals as JSON text by the two-call protocol: best_sigma_mm, best_scale_mm, best_levels and, per
     * combination, its sigma, scale and levels, and mean, deviation and every face's residual norm in mm. C:
     * mien_tuning_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public String json() {
        try (Call call = new Call()) {
            var tuningAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_tuning_get_json(Memory.address(tuningAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

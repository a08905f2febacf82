package mien;

// Written by abi/generate_bindings.py.
/** Several scans of one person, neutralized together. Immutable: share freely between threads. */
public final class Series extends NativeObject {
    Series(long owned) { super(owned, Raw.GET::mien_series_release); }

    /**
     * The neutral mesh of one face of a series, in that face's frame; or the person's shared one. C:
     * mien_series_get_mesh().
     * @param index 0 to face_count - 1, or -1: the shared neutral face, in the training's frame.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY
     */
    public Mesh mesh(int index) {
        try (Call call = new Call()) {
            var seriesAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_series_get_mesh(Memory.address(seriesAt), index, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The report as a JSON object: "faces", a list with each face's expression, residual_rms_mm (distance from
     * its own fit), distance_to_shared_mm (root mean square distance of its neutral face from the shared one,
     * without the changing vertices) and warnings. C: mien_series_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public String json() {
        try (Call call = new Call()) {
            var seriesAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_series_get_json(Memory.address(seriesAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

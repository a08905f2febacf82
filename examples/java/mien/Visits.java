package mien;

// Written by abi/generate_bindings.py.
/** One person's faces at several visits, without their expressions. Immutable: share freely between threads. */
public final class Visits extends NativeObject {
    Visits(long owned) { super(owned, Raw.GET::mien_visits_release); }

    /**
     * The neutral face of one visit, in the frame of its face. C: mien_visits_get_mesh().
     * @param index 0 to face_count - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY
     */
    public Mesh mesh(int index) {
        try (Call call = new Call()) {
            var visitsAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_visits_get_mesh(Memory.address(visitsAt), index, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The name of the expression found at one visit. C: mien_visits_get_expression().
     * @param index 0 to face_count - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index)
     */
    public String expression(int index) {
        try (Call call = new Call()) {
            var visitsAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_visits_get_expression(Memory.address(visitsAt), index, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * What the expressions that were taken off amount to in a volume between two visits, and how surely they are
     * known. A neutral volume carries that doubt beside the doubts of the fits. C:
     * mien_visits_get_removed_volume().
     * @param first 0 to face_count - 1.
     * @param second 0 to face_count - 1.
     * @param zone may be left out: the whole face.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (zone),
     * MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_MEMORY
     */
    public VisitsRemovedVolume removedVolume(int first, int second, Zone zone) {
        try (Call call = new Call()) {
            var visitsAt = call.use(this);
            var zoneAt = call.record(zone, 24, false, "zone");
            var removedMlAt = call.room(8);
            var sdMlAt = call.room(8);
            call.check(Raw.GET.mien_visits_get_removed_volume(Memory.address(visitsAt), first, second, Memory.address(zoneAt), Memory.address(removedMlAt), Memory.address(sdMlAt), call.error()));
            return new VisitsRemovedVolume(removedMlAt.bytes.getDouble(0), sdMlAt.bytes.getDouble(0));
        }
    }

    /**
     * What the expressions that were taken off amount to in a volume between two visits, and how surely they are
     * known. A neutral volume carries that doubt beside the doubts of the fits. All else as by default.
     */
    public VisitsRemovedVolume removedVolume(int first, int second) {
        return removedVolume(first, second, null);
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** Errors of neutralization over a dataset. Immutable: share freely between threads. */
public final class Evaluation extends NativeObject {
    Evaluation(long owned) { super(owned, Raw.GET::mien_evaluation_release); }

    /**
     * The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each with faces,
     * baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d, superiority; with
     * options.volume_zones "volumes", the same per zone (mean_ml, sd_ml, median_ml). C:
     * mien_evaluation_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public String json() {
        try (Call call = new Call()) {
            var evaluationAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_evaluation_get_json(Memory.address(evaluationAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

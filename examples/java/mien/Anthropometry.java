package mien;

// Written by abi/generate_bindings.py.
/** The measurements of one face. Immutable: share freely. */
public final class Anthropometry extends NativeObject {
    Anthropometry(long owned) { super(owned, Raw.GET::mien_anthropometry_release); }

    /**
     * How many measurements there are, and how many of them have a value. C: mien_anthropometry_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public AnthropometryCounts counts() {
        try (Call call = new Call()) {
            var anthropometryAt = call.use(this);
            var countAt = call.room(8);
            var knownCountAt = call.room(8);
            call.check(Raw.GET.mien_anthropometry_get_counts(Memory.address(anthropometryAt), Memory.address(countAt), Memory.address(knownCountAt), call.error()));
            return new AnthropometryCounts(countAt.bytes.getLong(0), knownCountAt.bytes.getLong(0));
        }
    }

    /**
     * The name of one measurement, such as "n-gn". C: mien_anthropometry_get_name().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
     */
    public String name(long index) {
        try (Call call = new Call()) {
            var anthropometryAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_anthropometry_get_name(Memory.address(anthropometryAt), index, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * One measurement. C: mien_anthropometry_get_value().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
     */
    public AnthropometricValue value(long index) {
        try (Call call = new Call()) {
            var anthropometryAt = call.use(this);
            var outAt = call.sized(64);
            call.check(Raw.GET.mien_anthropometry_get_value(Memory.address(anthropometryAt), index, Memory.address(outAt), call.error()));
            return AnthropometricValue.read(call, outAt, 0);
        }
    }

    /**
     * Why one measurement has no value, in words; empty where it has one. C: mien_anthropometry_get_reason().
     * @param index below the count.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
     */
    public String reason(long index) {
        try (Call call = new Call()) {
            var anthropometryAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_anthropometry_get_reason(Memory.address(anthropometryAt), index, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * All measurements as JSON text: name, title, kind, unit, landmarks, source, value, sd, reason, z; and which
     * of the face's landmarks stand for those of the field. C: mien_anthropometry_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public String json() {
        try (Call call = new Call()) {
            var anthropometryAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_anthropometry_get_json(Memory.address(anthropometryAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** A fitted template: places, residuals, confidence, verdict. Immutable: share freely. */
public final class Registration extends NativeObject {
    Registration(long owned) { super(owned, Raw.GET::mien_registration_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Registration share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_registration_retain(at);
            return new Registration(at);
        }
    }

    /** The fitted template: template topology, the scan's frame, millimetres. C: mien_registration_mesh(). */
    public Mesh mesh() {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var lent = Raw.GET.mien_registration_mesh(Memory.address(registrationAt));
            Raw.GET.mien_mesh_retain(lent);
            return new Mesh(lent);
        }
    }

    /**
     * The verdict. C: mien_registration_get_verdict().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public FitVerdict verdict() {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var outAt = call.sized(80);
            call.check(Raw.GET.mien_registration_get_verdict(Memory.address(registrationAt), Memory.address(outAt), call.error()));
            return FitVerdict.read(call, outAt, 0);
        }
    }

    /**
     * Copies a field with one float64 per template vertex. C: mien_registration_get_field().
     * @param field one of MIEN_REGISTRATION_RESIDUAL_MM, MIEN_REGISTRATION_WEIGHT,
     * MIEN_REGISTRATION_STANDARD_DEVIATION_MM, MIEN_REGISTRATION_RADIUS95_MM. See RegistrationKind.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such field)
     */
    public double[] field(int field) {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_registration_get_field(Memory.address(registrationAt), field, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * The dense correspondence: for every template vertex the scan's triangle (or point, for a cloud) nearest to
     * its fitted place, and barycentric coordinates in it. Numbers are those of the scan as it was given. C:
     * mien_registration_get_correspondence().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public RegistrationCorrespondence correspondence() {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 8);
            Memory trianglesAt;
            Memory barycentricAt;
            do {
                trianglesAt = call.room(capacity * 4);
                barycentricAt = call.room(capacity * 3 * 8);
            } while ((capacity = call.more(Raw.GET.mien_registration_get_correspondence(Memory.address(registrationAt), Memory.address(trianglesAt), Memory.address(barycentricAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return new RegistrationCorrespondence(call.readInts(trianglesAt, rows), call.readDoubles(barycentricAt, rows * 3));
        }
    }

    /**
     * The motion from the template's frame to the scan's as a row-major 4 x 4 matrix. C:
     * mien_registration_get_motion().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public double[] motion() {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var matrixAt = call.room(16 * 8);
            call.check(Raw.GET.mien_registration_get_motion(Memory.address(registrationAt), Memory.address(matrixAt), call.error()));
            return call.readDoubles(matrixAt, 16);
        }
    }

    /**
     * Verdict with reasons, energies, motion, color_agreement (correlation of each feature's colour with the
     * template, -1 to 1; empty when colours had no say) and summaries as JSON text. C:
     * mien_registration_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public String json() {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_registration_get_json(Memory.address(registrationAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

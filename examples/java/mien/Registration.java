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
     * The error that is expected of a zone of the model, or of the whole face. C:
     * mien_registration_get_expected_error().
     * @param zone a zone of the model by its name; null: the whole face.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, or
     * the registration was made of arrays or read from a file that states none)
     */
    public ExpectedError expectedError(String zone) {
        try (Call call = new Call()) {
            var registrationAt = call.use(this);
            var zoneAt = call.textOrNull(zone);
            var outAt = call.sized(40);
            call.check(Raw.GET.mien_registration_get_expected_error(Memory.address(registrationAt), Memory.address(zoneAt), Memory.address(outAt), call.error()));
            return ExpectedError.read(call, outAt, 0);
        }
    }

    /** The error that is expected of a zone of the model, or of the whole face. All else as by default. */
    public ExpectedError expectedError() {
        return expectedError(null);
    }

    /**
     * Copies a field with one float64 per template vertex. C: mien_registration_get_field().
     * @param field one of MIEN_REGISTRATION_RESIDUAL_MM, MIEN_REGISTRATION_WEIGHT,
     * MIEN_REGISTRATION_STANDARD_DEVIATION_MM, MIEN_REGISTRATION_RADIUS95_MM,
     * MIEN_REGISTRATION_NORMAL_DEVIATION_MM, MIEN_REGISTRATION_SLIDE_MM, MIEN_REGISTRATION_TIE_AGREEMENT,
     * MIEN_REGISTRATION_TIE_SHARE, MIEN_REGISTRATION_TIE_DEVIATION_MM. See RegistrationKind.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such field, or it is not known of this
     * registration)
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
     * template, -1 to 1; empty when colours had no say), measures and expected_error of every zone and summaries
     * as JSON text. C: mien_registration_get_json().
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

    /**
     * Keeps a registration as a file: the fitted template, its residuals, weights and deviations, the verdict
     * with its reasons and notes, the tie to another visit and the model's zones, so that visits can be
     * registered today and studied in a year. The scan is not in it. C: mien_registration_save().
     * @param path UTF-8; replaced whole.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
     * MIEN_E_CANCELLED
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var registrationAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_registration_save(Memory.address(sessionAt), Memory.address(registrationAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Reads a registration that mien_registration_save() kept. It gives the same bits as the registration itself.
     * C: mien_registration_load().
     * @param path UTF-8.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
     * MIEN_E_NO_MEMORY
     */
    public static Registration load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_registration_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Registration(call.pointer(outAt)));
        }
    }

    /**
     * A registration of a face that was fitted elsewhere, or whose arrays a host kept itself. What is not given
     * here is zero or empty in it. C: mien_registration_create().
     * @param mesh the fitted template, mm.
     * @param quality MIEN_QUALITY_*: the verdict on the fit. See Quality.
     * @param weight may be left out: not known; #V values, 0 to 1: how far the scan was seen there.
     * @param residual may be left out: zero; #V values, mm: signed distance to the scan.
     * @param standardDeviation may be left out: not known; #V values, mm, &gt;= 0: of the place, per axis.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (lengths),
     * MIEN_E_NO_MEMORY
     */
    public static Registration create(Session session, Mesh mesh, int quality, Values weight, Values residual, Values standardDeviation) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(mesh);
            var weightAt = call.viewOrNull(weight, 1, "weight");
            var residualAt = call.viewOrNull(residual, 1, "residual");
            var standardDeviationAt = call.viewOrNull(standardDeviation, 1, "standard_deviation");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_registration_create(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(weightAt), Memory.address(residualAt), Memory.address(standardDeviationAt), quality, Memory.address(outAt), call.error()));
            return call.keep(new Registration(call.pointer(outAt)));
        }
    }

    /**
     * A registration of a face that was fitted elsewhere, or whose arrays a host kept itself. What is not given
     * here is zero or empty in it. All else as by default.
     */
    public static Registration create(Session session, Mesh mesh, int quality) {
        return create(session, mesh, quality, null, null, null);
    }

    /**
     * Ties a later visit's registration to an earlier one's along the skin: its places slide along the scan until
     * each lies on the freckles and pores that it lay on at the earlier visit, where both scans' pictures (a
     * texture image, or colours at the vertices) show the same detail, and go on smoothly where they do not.
     * Form, verdict and weights stay; residuals, correspondence and deviations are those of the moved places.
     * When the pictures agree on too little (another person, plain skin, very unlike light) nothing moves: that
     * is no error, and the JSON report says so under "reference", with why. C: mien_registration_tie().
     * @param model which both registrations were made with.
     * @param referenceScan the scan that it was made of, with colours.
     * @param registration the later visit.
     * @param scan the scan that it was made of, with colours.
     * @param options may be left out: the defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (options; a scan without colours),
     * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MISMATCH (a fit of another template; a scan that does not lie under its
     * fit), MIEN_E_INVALID_MESH, MIEN_E_CANCELLED, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public Registration tie(Session session, Model model, Mesh referenceScan, Registration registration, Mesh scan, TieOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(model);
            var referenceAt = call.use(this);
            var referenceScanAt = call.use(referenceScan);
            var registrationAt = call.use(registration);
            var scanAt = call.use(scan);
            var optionsAt = (options == null ? new TieOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_registration_tie(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(referenceAt), Memory.address(referenceScanAt), Memory.address(registrationAt), Memory.address(scanAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Registration(call.pointer(outAt)));
        }
    }

    /**
     * Ties a later visit's registration to an earlier one's along the skin: its places slide along the scan until
     * each lies on the freckles and pores that it lay on at the earlier visit, where both scans' pictures (a
     * texture image, or colours at the vertices) show the same detail, and go on smoothly where they do not.
     * Form, verdict and weights stay; residuals, correspondence and deviations are those of the moved places.
     * When the pictures agree on too little (another person, plain skin, very unlike light) nothing moves: that
     * is no error, and the JSON report says so under "reference", with why. All else as by default.
     */
    public Registration tie(Session session, Model model, Mesh referenceScan, Registration registration, Mesh scan) {
        return tie(session, model, referenceScan, registration, scan, null, null, null);
    }

    /**
     * Ties a later visit's registration to an earlier one's along the skin: its places slide along the scan until
     * each lies on the freckles and pores that it lay on at the earlier visit, where both scans' pictures (a
     * texture image, or colours at the vertices) show the same detail, and go on smoothly where they do not.
     * Form, verdict and weights stay; residuals, correspondence and deviations are those of the moved places.
     * When the pictures agree on too little (another person, plain skin, very unlike light) nothing moves: that
     * is no error, and the JSON report says so under "reference", with why. All else as by default.
     */
    public Registration tie(Session session, Model model, Mesh referenceScan, Registration registration, Mesh scan, TieOptions options) {
        return tie(session, model, referenceScan, registration, scan, options, null, null);
    }

    /**
     * The coefficients of a registered face: its fitted template, brought back into the model's frame by the
     * registration's own motion and fitted as by mien_model_fit(). What the fit took from the model comes back;
     * what it moved beyond the model's span, to close the last gap to the scan, is left out. C:
     * mien_registration_get_coefficients().
     * @param ridgeMm2 mm^2, &gt;= 0; 0: the nearest face of the model's span.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (of another model),
     * MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public double[] coefficients(Session session, Model model, double ridgeMm2) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var registrationAt = call.use(this);
            var modelAt = call.use(model);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_registration_get_coefficients(Memory.address(sessionAt), Memory.address(registrationAt), Memory.address(modelAt), ridgeMm2, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }
}

package mien;

// Written by abi/generate_bindings.py.
/** Visits of one person: neutral faces and what changed between them. Immutable: share freely. */
public final class Study extends NativeObject {
    Study(long owned) { super(owned, Raw.GET::mien_study_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Study share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_study_retain(at);
            return new Study(at);
        }
    }

    /**
     * Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the
     * first by what holds still, and measures what changed per zone with its errors. One registration: its
     * neutral face and how surely it is known. C: mien_study_create().
     * @param registrations registration_count fits of one model, first visit first.
     * @param expressions may be left out: faces are measured as they are held.
     * @param options may be left out: defaults, with the zones of the registrations' model. Zones are patches, as
     * those of mien_measure_volume().
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
     * (topology, zones), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static Study create(Session session, java.util.List<Registration> registrations, ExpressionModel expressions, StudyOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(registrations, "registrations");
            call.lock(session);
            var sessionAt = call.use(session);
            var registrationCount = call.rows(registrations, 1, "registrations");
            var registrationsAt = call.handles(registrations);
            var expressionsAt = call.useOrNull(expressions);
            var optionsAt = (options == null ? new StudyOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_study_create(Memory.address(sessionAt), Memory.address(registrationsAt), (int) registrationCount, Memory.address(expressionsAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Study(call.pointer(outAt)));
        }
    }

    /**
     * Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the
     * first by what holds still, and measures what changed per zone with its errors. One registration: its
     * neutral face and how surely it is known. All else as by default.
     */
    public static Study create(Session session, java.util.List<Registration> registrations) {
        return create(session, registrations, null, null, null, null);
    }

    /**
     * Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the
     * first by what holds still, and measures what changed per zone with its errors. One registration: its
     * neutral face and how surely it is known. All else as by default.
     */
    public static Study create(Session session, java.util.List<Registration> registrations, ExpressionModel expressions, StudyOptions options) {
        return create(session, registrations, expressions, options, null, null);
    }

    /**
     * The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low,
     * high and limit_of_detection are NaN. C: mien_study_create_from_meshes().
     * @param faces face_count meshes in one topology, mm, first visit first.
     * @param normalSd may be left out; face_count x #V values, face by face, mm, &gt;= 0: how far each surface
     * may lie off the skin along its normal.
     * @param weights may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0
     * to 1: 0 where a scan had no data.
     * @param expressions may be left out: faces are measured as they are held.
     * @param options may be left out: defaults, without any zone. noise_mm is not read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
     * (topology, zones, deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION,
     * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public static Study createFromMeshes(Session session, java.util.List<Mesh> faces, Values normalSd, Values weights, ExpressionModel expressions, StudyOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(faces, "faces");
            call.lock(session);
            var sessionAt = call.use(session);
            var faceCount = call.rows(faces, 1, "faces");
            var facesAt = call.handles(faces);
            var normalSdAt = call.viewOrNull(normalSd, 1, "normal_sd");
            var weightsAt = call.viewOrNull(weights, 1, "weights");
            var expressionsAt = call.useOrNull(expressions);
            var optionsAt = (options == null ? new StudyOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_study_create_from_meshes(Memory.address(sessionAt), Memory.address(facesAt), (int) faceCount, Memory.address(normalSdAt), Memory.address(weightsAt), Memory.address(expressionsAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Study(call.pointer(outAt)));
        }
    }

    /**
     * The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low,
     * high and limit_of_detection are NaN. All else as by default.
     */
    public static Study createFromMeshes(Session session, java.util.List<Mesh> faces) {
        return createFromMeshes(session, faces, null, null, null, null, null, null);
    }

    /**
     * The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low,
     * high and limit_of_detection are NaN. All else as by default.
     */
    public static Study createFromMeshes(Session session, java.util.List<Mesh> faces, Values normalSd, Values weights, ExpressionModel expressions, StudyOptions options) {
        return createFromMeshes(session, faces, normalSd, weights, expressions, options, null, null);
    }

    /**
     * How many visits and zones a study has. The treated zones with their margin are the last zones. C:
     * mien_study_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public StudyCounts counts() {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var visitCountAt = call.room(8);
            var zoneCountAt = call.room(8);
            call.check(Raw.GET.mien_study_get_counts(Memory.address(studyAt), Memory.address(visitCountAt), Memory.address(zoneCountAt), call.error()));
            return new StudyCounts(visitCountAt.bytes.getInt(0), zoneCountAt.bytes.getInt(0));
        }
    }

    /**
     * The name of a zone. C: mien_study_get_zone_name().
     * @param zone 0 to zone_count - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (zone)
     */
    public String zoneName(int zone) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_study_get_zone_name(Memory.address(studyAt), zone, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * The name of the expression that was taken off a visit. C: mien_study_get_expression().
     * @param visit 0 to visit_count - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit)
     */
    public String expression(int visit) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_study_get_expression(Memory.address(studyAt), visit, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * The neutral face of a visit, in its own frame or aligned on another visit. C: mien_study_get_mesh().
     * @param visit 0 to visit_count - 1.
     * @param frame the visit in whose frame to give it: its own number for its own frame.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_SOLUTION,
     * MIEN_E_NO_MEMORY
     */
    public Mesh mesh(int visit, int frame) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_study_get_mesh(Memory.address(studyAt), visit, frame, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Copies a field with one float64 per vertex of a visit's face. C: mien_study_get_field().
     * @param visit 0 to visit_count - 1.
     * @param field MIEN_STUDY_FIELD_*. See StudyField.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit, or nothing is known of such a field)
     */
    public double[] field(int visit, int field) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_study_get_field(Memory.address(studyAt), visit, field, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * How far each vertex moved between two visits: the signed distance of the second neutral face, aligned, from
     * the first along the first one's normals, mm. C: mien_study_get_distances().
     * @param first 0 to visit_count - 1.
     * @param second another visit.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a
     * visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public double[] distances(int first, int second) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_study_get_distances(Memory.address(studyAt), first, second, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * How the second visit was aligned on the first. C: mien_study_get_alignment().
     * @param first 0 to visit_count - 1.
     * @param second another visit.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a
     * visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public ZoneAlignment alignment(int first, int second) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var outAt = call.sized(192);
            call.check(Raw.GET.mien_study_get_alignment(Memory.address(studyAt), first, second, Memory.address(outAt), call.error()));
            return ZoneAlignment.read(call, outAt, 0);
        }
    }

    /**
     * What changed in a zone from one visit to another. C: mien_study_get_change().
     * @param first 0 to visit_count - 1.
     * @param second another visit.
     * @param zone 0 to zone_count - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a
     * visit or zone), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public StudyChange change(int first, int second, int zone) {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var outAt = call.sized(320);
            call.check(Raw.GET.mien_study_get_change(Memory.address(studyAt), first, second, zone, Memory.address(outAt), call.error()));
            return StudyChange.read(call, outAt, 0);
        }
    }

    /**
     * The study as a JSON object: "recipe" with every setting, "zones", and "visits" with the expression of each
     * and "changes_since_first" per zone. C: mien_study_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public String json() {
        try (Call call = new Call()) {
            var studyAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_study_get_json(Memory.address(studyAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }
}

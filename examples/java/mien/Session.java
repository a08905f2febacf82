package mien;

// Written by abi/generate_bindings.py.
/**
 * Threads, limits of memory and time, and logging. Externally synchronized: one call at a time; with more
 * than one thread of its own, a session that is in a call on another thread refuses a second call with
 * MIEN_E_BUSY. A callback may call the library with the session that called it. Objects made in a session may
 * outlive it.
 */
public final class Session extends NativeObject {
    Session(long owned) { super(owned, Raw.GET::mien_session_release); }

    /** Makes a session with default options: one thread, no memory budget, silent. */
    public Session() { super(create()); }

    /** Makes a session with options of the caller. */
    public Session(SessionOptions options) { super(createWithOptions(options)); }

    /**
     * Makes a session with default options: one thread, no memory budget, silent. C: mien_session_create().
     * @throws MienException MIEN_E_UNSUPPORTED_VERSION (another ABI), MIEN_E_NO_MEMORY
     */
    public static Session create() {
        try (Call call = new Call()) {
            var outAt = call.room(8);
            call.check(Raw.GET.mien_session_create(0, Memory.address(outAt), call.error()));
            return call.keep(new Session(call.pointer(outAt)));
        }
    }

    /**
     * Makes a session with options of the caller. C: mien_session_create_with_options().
     * @param options may be left out: defaults.
     * @throws MienException MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_ARGUMENT (num_threads),
     * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY (also when a thread cannot be started)
     */
    public static Session createWithOptions(SessionOptions options) {
        try (Call call = new Call()) {
            var optionsAt = call.record(options, 48, false, "options");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_session_create_with_options(0, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Session(call.pointer(outAt)));
        }
    }

    /** Makes a session with options of the caller. All else as by default. */
    public static Session createWithOptions() {
        return createWithOptions(null);
    }

    /**
     * The SHA-256 of a file's bytes as 64 lower-case hexadecimal digits: which model, which scan a result was
     * made from. With dst null and capacity 0: the size only, without reading the file. C:
     * mien_session_hash_file().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
     * MIEN_E_TIME_LIMIT
     */
    public String hashFile(String path) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var pathAt = call.text(path);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_session_hash_file(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
     * hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
     * "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly
     * coincide with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks
     * are missing is NaN with a reason. C: mien_measure_anthropometry().
     * @param face #V x 3, mm, with triangles.
     * @param landmarks vertices of the face, or places on it in its frame (a measurement with a place has no
     * deviation, and no length along the skin).
     * @param options may be left out: no deviations, no norms.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
     * (landmarks, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Anthropometry measureAnthropometry(Mesh face, Landmarks landmarks, AnthropometryOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var faceAt = call.use(face);
            var landmarksAt = call.use(landmarks);
            var optionsAt = (options == null ? new AnthropometryOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_anthropometry(Memory.address(sessionAt), Memory.address(faceAt), Memory.address(landmarksAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Anthropometry(call.pointer(outAt)));
        }
    }

    /**
     * Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
     * hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
     * "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly
     * coincide with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks
     * are missing is NaN with a reason. All else as by default.
     */
    public Anthropometry measureAnthropometry(Mesh face, Landmarks landmarks) {
        return measureAnthropometry(face, landmarks, null, null, null);
    }

    /**
     * Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
     * hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
     * "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly
     * coincide with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks
     * are missing is NaN with a reason. All else as by default.
     */
    public Anthropometry measureAnthropometry(Mesh face, Landmarks landmarks, AnthropometryOptions options) {
        return measureAnthropometry(face, landmarks, options, null, null);
    }

    /**
     * The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per
     * zone, exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of
     * triangles it shares; disjoint zones and the rest add up to the whole. A zone of twenty vertices or more of
     * which most lie in no triangle of it is one of another template: MIEN_E_MISMATCH. C: mien_measure_volume().
     * @param before #V x 3, mm, with triangles counter-clockwise seen from outside.
     * @param after same vertex count, in the frame of before; its triangles are not read.
     * @param options may be left out: the whole face, no uncertainty.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
     * MIEN_E_MISMATCH (vertex counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
     * MIEN_E_CANCELLED
     */
    public Measurement measureVolume(Mesh before, Mesh after, MeasureOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var beforeAt = call.use(before);
            var afterAt = call.use(after);
            var optionsAt = (options == null ? new MeasureOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_volume(Memory.address(sessionAt), Memory.address(beforeAt), Memory.address(afterAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Measurement(call.pointer(outAt)));
        }
    }

    /**
     * The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per
     * zone, exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of
     * triangles it shares; disjoint zones and the rest add up to the whole. A zone of twenty vertices or more of
     * which most lie in no triangle of it is one of another template: MIEN_E_MISMATCH. All else as by default.
     */
    public Measurement measureVolume(Mesh before, Mesh after) {
        return measureVolume(before, after, null, null, null);
    }

    /**
     * The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per
     * zone, exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of
     * triangles it shares; disjoint zones and the rest add up to the whole. A zone of twenty vertices or more of
     * which most lie in no triangle of it is one of another template: MIEN_E_MISMATCH. All else as by default.
     */
    public Measurement measureVolume(Mesh before, Mesh after, MeasureOptions options) {
        return measureVolume(before, after, options, null, null);
    }

    /**
     * Distances between two faces in correspondence, per vertex and per zone. C: mien_measure_distance().
     * @param before #V x 3, mm.
     * @param after same vertex count, in the frame of before.
     * @param options may be left out; zones, progress and cancel are read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Measurement measureDistance(Mesh before, Mesh after, MeasureOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var beforeAt = call.use(before);
            var afterAt = call.use(after);
            var optionsAt = (options == null ? new MeasureOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_distance(Memory.address(sessionAt), Memory.address(beforeAt), Memory.address(afterAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Measurement(call.pointer(outAt)));
        }
    }

    /** Distances between two faces in correspondence, per vertex and per zone. All else as by default. */
    public Measurement measureDistance(Mesh before, Mesh after) {
        return measureDistance(before, after, null, null, null);
    }

    /** Distances between two faces in correspondence, per vertex and per zone. All else as by default. */
    public Measurement measureDistance(Mesh before, Mesh after, MeasureOptions options) {
        return measureDistance(before, after, options, null, null);
    }

    /**
     * Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
     * distance takes both directions. C: mien_measure_surface_distance().
     * @param before #V x 3, mm, with triangles.
     * @param after a surface or a cloud of points, aligned with before.
     * @param options may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Measurement measureSurfaceDistance(Mesh before, Mesh after, MeasureOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var beforeAt = call.use(before);
            var afterAt = call.use(after);
            var optionsAt = (options == null ? new MeasureOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_surface_distance(Memory.address(sessionAt), Memory.address(beforeAt), Memory.address(afterAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Measurement(call.pointer(outAt)));
        }
    }

    /**
     * Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
     * distance takes both directions. All else as by default.
     */
    public Measurement measureSurfaceDistance(Mesh before, Mesh after) {
        return measureSurfaceDistance(before, after, null, null, null);
    }

    /**
     * Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
     * distance takes both directions. All else as by default.
     */
    public Measurement measureSurfaceDistance(Mesh before, Mesh after, MeasureOptions options) {
        return measureSurfaceDistance(before, after, options, null, null);
    }

    /**
     * The volume that a mesh encloses, by the divergence theorem about its centroid. C:
     * mien_measure_closed_volume().
     * @param mesh manifold along its edges and consistently oriented.
     * @param closeRims 1: each open rim is closed by a fan from the mean of its vertices; 0: an open mesh is an
     * error.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION
     * (close_rims), MIEN_E_INVALID_MESH (open, not manifold or not oriented: the message counts the edges),
     * MIEN_E_NO_MEMORY
     */
    public double measureClosedVolume(Mesh mesh, int closeRims) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var meshAt = call.use(mesh);
            var volumeMlAt = call.room(8);
            call.check(Raw.GET.mien_measure_closed_volume(Memory.address(sessionAt), Memory.address(meshAt), closeRims, Memory.address(volumeMlAt), call.error()));
            return volumeMlAt.bytes.getDouble(0);
        }
    }

    /**
     * The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices). Zones are
     * patches, as those of mien_measure_volume(). C: mien_measure_area().
     * @param mesh with triangles.
     * @param zone may be left out: the whole surface.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
     * (zone), MIEN_E_NO_MEMORY
     */
    public double measureArea(Mesh mesh, Zone zone) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var meshAt = call.use(mesh);
            var zoneAt = call.record(zone, 24, false, "zone");
            var areaMm2At = call.room(8);
            call.check(Raw.GET.mien_measure_area(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(zoneAt), Memory.address(areaMm2At), call.error()));
            return areaMm2At.bytes.getDouble(0);
        }
    }

    /**
     * The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices). Zones are
     * patches, as those of mien_measure_volume(). All else as by default.
     */
    public double measureArea(Mesh mesh) {
        return measureArea(mesh, null);
    }

    /**
     * Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex. C:
     * mien_measure_curvature().
     * @param mesh #V x 3, mm, with triangles counter-clockwise seen from outside.
     * @param radiusMm &gt; 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.
     * @param robust 1: a second fit leaves spikes and lashes out; 0: none.
     * @param options may be left out; zones, progress and cancel are read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust),
     * MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Measurement measureCurvature(Mesh mesh, double radiusMm, int robust, MeasureOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var meshAt = call.use(mesh);
            var optionsAt = (options == null ? new MeasureOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_curvature(Memory.address(sessionAt), Memory.address(meshAt), radiusMm, robust, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Measurement(call.pointer(outAt)));
        }
    }

    /**
     * Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex. All else as by
     * default.
     */
    public Measurement measureCurvature(Mesh mesh, double radiusMm, int robust) {
        return measureCurvature(mesh, radiusMm, robust, null, null, null);
    }

    /**
     * Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex. All else as by
     * default.
     */
    public Measurement measureCurvature(Mesh mesh, double radiusMm, int robust, MeasureOptions options) {
        return measureCurvature(mesh, radiusMm, robust, options, null, null);
    }

    /**
     * Straight lengths and lengths along the surface between pairs of vertices. C: mien_measure_lengths().
     * @param mesh #V x 3, mm, with triangles.
     * @param pairs pair_count x 2 vertex numbers.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
     * (vertex), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public MeasureLengths measureLengths(Mesh mesh, int[] pairs) {
        try (Call call = new Call()) {
            call.required(pairs, "pairs");
            call.lock(this);
            var sessionAt = call.use(this);
            var meshAt = call.use(mesh);
            var pairCount = call.rows(pairs, 2, "pairs");
            var pairsAt = call.array(pairs);
            var straightMmAt = call.room(pairCount * 8);
            var geodesicMmAt = call.room(pairCount * 8);
            call.check(Raw.GET.mien_measure_lengths(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(pairsAt), pairCount, Memory.address(straightMmAt), Memory.address(geodesicMmAt), call.error()));
            return new MeasureLengths(call.readDoubles(straightMmAt, pairCount), call.readDoubles(geodesicMmAt, pairCount));
        }
    }

    /**
     * The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is
     * carried onto after, then the swept volume is measured. Triangles without a partner do not count. C:
     * mien_measure_scan_volume().
     * @param before #V x 3, mm, with triangles.
     * @param after another surface with triangles, aligned with before.
     * @param carry MIEN_CARRY_*. See Carry.
     * @param direction 3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.
     * @param options may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml,
     * progress, cancel. Deviations are not read.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
     * MIEN_E_NO_SOLUTION (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public MeasureScanVolume measureScanVolume(Mesh before, Mesh after, int carry, double[] direction, MeasureOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var beforeAt = call.use(before);
            var afterAt = call.use(after);
            call.agree("direction", call.rows(direction, 1, "direction"), 3);
            var directionAt = call.array(direction);
            var optionsAt = (options == null ? new MeasureOptions() : options).write(call, progress, cancel);
            var coverageAt = call.room(8);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_scan_volume(Memory.address(sessionAt), Memory.address(beforeAt), Memory.address(afterAt), carry, Memory.address(directionAt), Memory.address(optionsAt), Memory.address(coverageAt), Memory.address(outAt), call.error()));
            return new MeasureScanVolume(coverageAt.bytes.getDouble(0), call.keep(new Measurement(call.pointer(outAt))));
        }
    }

    /**
     * The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is
     * carried onto after, then the swept volume is measured. Triangles without a partner do not count. All else
     * as by default.
     */
    public MeasureScanVolume measureScanVolume(Mesh before, Mesh after, int carry) {
        return measureScanVolume(before, after, carry, null, null, null, null);
    }

    /**
     * The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is
     * carried onto after, then the swept volume is measured. Triangles without a partner do not count. All else
     * as by default.
     */
    public MeasureScanVolume measureScanVolume(Mesh before, Mesh after, int carry, double[] direction, MeasureOptions options) {
        return measureScanVolume(before, after, carry, direction, options, null, null);
    }

    /**
     * Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge), robustly: by
     * correspondence first, then by closest points, because a fit slides along a scan more than it lifts off.
     * Surfaces with other triangles (two scans) are brought together by closest points alone and must lie within
     * 15 mm of each other there. The deviations feed alignment_rotation_sd_rad, alignment_translation_sd_mm and
     * alignment_centre. C: mien_measure_align().
     * @param moving #V x 3, mm, with triangles.
     * @param target with triangles.
     * @param stable may be left out: all vertices. Vertices of target.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
     * MIEN_E_NO_SOLUTION (zone too small or straight), MIEN_E_NO_MEMORY
     */
    public MeasureAlign measureAlign(Mesh moving, Mesh target, Zone stable) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var movingAt = call.use(moving);
            var targetAt = call.use(target);
            var stableAt = call.record(stable, 24, false, "stable");
            var infoAt = call.sized(192);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_align(Memory.address(sessionAt), Memory.address(movingAt), Memory.address(targetAt), Memory.address(stableAt), Memory.address(infoAt), Memory.address(outAt), call.error()));
            return new MeasureAlign(ZoneAlignment.read(call, infoAt, 0), call.keep(new Mesh(call.pointer(outAt))));
        }
    }

    /**
     * Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge), robustly: by
     * correspondence first, then by closest points, because a fit slides along a scan more than it lifts off.
     * Surfaces with other triangles (two scans) are brought together by closest points alone and must lie within
     * 15 mm of each other there. The deviations feed alignment_rotation_sd_rad, alignment_translation_sd_mm and
     * alignment_centre. All else as by default.
     */
    public MeasureAlign measureAlign(Mesh moving, Mesh target) {
        return measureAlign(moving, target, null);
    }

    /**
     * Compares the left side of a face with the reflection of its right side: volume and distance, signed
     * (positive: the left side lies farther out), whole and per zone, with intervals. Zones of both sides
     * ("cheek_left", "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is
     * compared with the right half. The result holds volumes, distances, and fields of all vertices (a right
     * vertex against the reflected left side). C: mien_measure_asymmetry().
     * @param face #V x 3, mm, in the template's topology.
     * @param templateMesh the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).
     * @param options may be left out: the whole side, no interval.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane),
     * MIEN_E_INVALID_MESH (no triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts, zones,
     * landmarks, deviations), MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Measurement measureAsymmetry(Mesh face, Mesh templateMesh, AsymmetryOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var faceAt = call.use(face);
            var templateMeshAt = call.use(templateMesh);
            var optionsAt = (options == null ? new AsymmetryOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_measure_asymmetry(Memory.address(sessionAt), Memory.address(faceAt), Memory.address(templateMeshAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Measurement(call.pointer(outAt)));
        }
    }

    /**
     * Compares the left side of a face with the reflection of its right side: volume and distance, signed
     * (positive: the left side lies farther out), whole and per zone, with intervals. Zones of both sides
     * ("cheek_left", "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is
     * compared with the right half. The result holds volumes, distances, and fields of all vertices (a right
     * vertex against the reflected left side). All else as by default.
     */
    public Measurement measureAsymmetry(Mesh face, Mesh templateMesh) {
        return measureAsymmetry(face, templateMesh, null, null, null);
    }

    /**
     * Compares the left side of a face with the reflection of its right side: volume and distance, signed
     * (positive: the left side lies farther out), whole and per zone, with intervals. Zones of both sides
     * ("cheek_left", "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is
     * compared with the right half. The result holds volumes, distances, and fields of all vertices (a right
     * vertex against the reflected left side). All else as by default.
     */
    public Measurement measureAsymmetry(Mesh face, Mesh templateMesh, AsymmetryOptions options) {
        return measureAsymmetry(face, templateMesh, options, null, null);
    }

    /**
     * Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted
     * solve with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit
     * that cannot be trusted is not an error: ask mien_registration_get_verdict(). C: mien_register().
     * @param scan a surface or a cloud of points, any connectivity, any frame; its unit is detected
     * (options.units), any rotation is found.
     * @param options may be left out: no landmarks, all defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left
     * after cleaning), MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged),
     * MIEN_E_NOT_FOUND (start by landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION,
     * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK
     */
    public Registration register(Model model, Mesh scan, RegisterOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var scanAt = call.use(scan);
            var optionsAt = (options == null ? new RegisterOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_register(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(scanAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Registration(call.pointer(outAt)));
        }
    }

    /**
     * Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted
     * solve with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit
     * that cannot be trusted is not an error: ask mien_registration_get_verdict(). All else as by default.
     */
    public Registration register(Model model, Mesh scan) {
        return register(model, scan, null, null, null);
    }

    /**
     * Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted
     * solve with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit
     * that cannot be trusted is not an error: ask mien_registration_get_verdict(). All else as by default.
     */
    public Registration register(Model model, Mesh scan, RegisterOptions options) {
        return register(model, scan, options, null, null);
    }

    /**
     * Carries places (landmarks, points of a contour) from one surface to another in the same frame, e.g. from a
     * fitted template to the scan under it or back: for each the nearest place on the other surface. C:
     * mien_surface_transfer_points().
     * @param surface where the places go; a mesh or a cloud of points, mm.
     * @param points #P x 3, F32 or F64, mm.
     * @param maxDistanceMm farther places are lost (triangle 0xFFFFFFFF); 0: 10, below 0: no limit.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MEMORY_BUDGET,
     * MIEN_E_NO_MEMORY
     */
    public SurfaceTransferPoints surfaceTransferPoints(Mesh surface, Values points, double maxDistanceMm) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var surfaceAt = call.use(surface);
            var pointsAt = call.view(points, 3, "points");
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 8);
            Memory trianglesAt;
            Memory barycentricAt;
            Memory positionsAt;
            do {
                trianglesAt = call.room(capacity * 4);
                barycentricAt = call.room(capacity * 3 * 8);
                positionsAt = call.room(capacity * 3 * 8);
            } while ((capacity = call.more(Raw.GET.mien_surface_transfer_points(Memory.address(sessionAt), Memory.address(surfaceAt), Memory.address(pointsAt), maxDistanceMm, Memory.address(trianglesAt), Memory.address(barycentricAt), Memory.address(positionsAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return new SurfaceTransferPoints(call.readInts(trianglesAt, rows), call.readDoubles(barycentricAt, rows * 3), call.readDoubles(positionsAt, rows * 3));
        }
    }

    /**
     * Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest place on
     * `from` lies in the zone (barycentric share of its vertices at least one half), ascending. C:
     * mien_surface_transfer_zone().
     * @param from with the zone's vertices.
     * @param maxDistanceMm farther vertices stay out; 0: 10, below 0: no limit.
     * @param vertices vertex_count vertex numbers of `from`
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (a fitted
     * template without triangles), MIEN_E_MISMATCH (a vertex that `from` does not have), MIEN_E_MEMORY_BUDGET,
     * MIEN_E_NO_MEMORY
     */
    public int[] surfaceTransferZone(Mesh from, Mesh to, double maxDistanceMm, int[] vertices) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var fromAt = call.use(from);
            var vertexCount = call.rows(vertices, 1, "vertices");
            var verticesAt = call.array(vertices);
            var toAt = call.use(to);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 4);
            } while ((capacity = call.more(Raw.GET.mien_surface_transfer_zone(Memory.address(sessionAt), Memory.address(fromAt), Memory.address(verticesAt), vertexCount, Memory.address(toAt), maxDistanceMm, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readInts(dstAt, rows);
        }
    }

    /**
     * Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest place on
     * `from` lies in the zone (barycentric share of its vertices at least one half), ascending. All else as by
     * default.
     */
    public int[] surfaceTransferZone(Mesh from, Mesh to, double maxDistanceMm) {
        return surfaceTransferZone(from, to, maxDistanceMm, null);
    }

    /**
     * A model's landmarks or zones, carried from its fitted template to a scan, as JSON text in the form of the
     * landmark and zone files: {"points": {name: [x, y, z]}, "distances_mm": {name: d}} or {"zones": {name: [scan
     * vertex, ...]}}. C: mien_surface_transfer_json().
     * @param model whose landmarks and zones are meant.
     * @param fitted the model's template after registration.
     * @param scan in the frame of fitted, mm.
     * @param what MIEN_TRANSFER_LANDMARKS or MIEN_TRANSFER_ZONES. See Transfer.
     * @param maxDistanceMm farther places are left out; 0: 10, below 0: no limit.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (what),
     * MIEN_E_MISMATCH (fitted is not of the model), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public String surfaceTransferJson(Model model, Mesh fitted, Mesh scan, int what, double maxDistanceMm) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var fittedAt = call.use(fitted);
            var scanAt = call.use(scan);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_surface_transfer_json(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(fittedAt), Memory.address(scanAt), what, maxDistanceMm, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high - mean is the
     * face. C: mien_spectral_split().
     * @param face #V vertices, mm, aligned with the mean shape.
     * @param k 0 to the basis' modes.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
     * MIEN_E_NO_MEMORY
     */
    public SpectralSplit spectralSplit(SpectralBasis basis, Mesh face, long k) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var basisAt = call.use(basis);
            var faceAt = call.use(face);
            var lowAt = call.room(8);
            var highAt = call.room(8);
            call.check(Raw.GET.mien_spectral_split(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(faceAt), k, Memory.address(lowAt), Memory.address(highAt), call.error()));
            return new SpectralSplit(call.keep(new Mesh(call.pointer(lowAt))), call.keep(new Mesh(call.pointer(highAt))));
        }
    }

    /**
     * The low frequencies of one face with the high frequencies of another. C: mien_spectral_assemble().
     * @param low #V vertices, mm.
     * @param high #V vertices, mm.
     * @param k 0 to the basis' modes; #V or more gives `low`.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
     * MIEN_E_NO_MEMORY
     */
    public Mesh spectralAssemble(SpectralBasis basis, Mesh low, Mesh high, long k) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var basisAt = call.use(basis);
            var lowAt = call.use(low);
            var highAt = call.use(high);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_assemble(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(lowAt), Memory.address(highAt), k, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it. C:
     * mien_spectral_edit().
     * @param face #V vertices, mm.
     * @param gains limit_count + 1 finite values.
     * @param limits limit_count ascending mode numbers
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH
     * (vertex count), MIEN_E_NO_MEMORY
     */
    public Mesh spectralEdit(SpectralBasis basis, Mesh face, double[] gains, long[] limits) {
        try (Call call = new Call()) {
            call.required(gains, "gains");
            call.lock(this);
            var sessionAt = call.use(this);
            var basisAt = call.use(basis);
            var faceAt = call.use(face);
            var limitCount = call.rows(limits, 1, "limits");
            var limitsAt = call.array(limits);
            call.agree("gains", call.rows(gains, 1, "gains"), limitCount + 1);
            var gainsAt = call.array(gains);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_edit(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(faceAt), Memory.address(limitsAt), limitCount, Memory.address(gainsAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it. All else as
     * by default.
     */
    public Mesh spectralEdit(SpectralBasis basis, Mesh face, double[] gains) {
        return spectralEdit(basis, face, gains, null);
    }

    /**
     * Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details. C:
     * mien_spectral_mix().
     * @param first #V vertices, mm; weight 0.
     * @param second #V vertices, mm; weight 1.
     * @param weights limit_count + 1 finite values.
     * @param limits limit_count ascending mode numbers
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH
     * (vertex count), MIEN_E_NO_MEMORY
     */
    public Mesh spectralMix(SpectralBasis basis, Mesh first, Mesh second, double[] weights, long[] limits) {
        try (Call call = new Call()) {
            call.required(weights, "weights");
            call.lock(this);
            var sessionAt = call.use(this);
            var basisAt = call.use(basis);
            var firstAt = call.use(first);
            var secondAt = call.use(second);
            var limitCount = call.rows(limits, 1, "limits");
            var limitsAt = call.array(limits);
            call.agree("weights", call.rows(weights, 1, "weights"), limitCount + 1);
            var weightsAt = call.array(weights);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_mix(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(firstAt), Memory.address(secondAt), Memory.address(limitsAt), limitCount, Memory.address(weightsAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details. All else
     * as by default.
     */
    public Mesh spectralMix(SpectralBasis basis, Mesh first, Mesh second, double[] weights) {
        return spectralMix(basis, first, second, weights, null);
    }

    /**
     * Spectral coefficients of a face: U' M (face - mean), one row of x, y, z per mode, float64. C:
     * mien_spectral_project().
     * @param face #V vertices, mm, aligned with the mean shape.
     * @param modeCount 0 to the basis' modes: the first of them; more means all.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
     * MIEN_E_NO_MEMORY
     */
    public double[] spectralProject(SpectralBasis basis, Mesh face, long modeCount) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var basisAt = call.use(basis);
            var faceAt = call.use(face);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3 * 8);
            } while ((capacity = call.more(Raw.GET.mien_spectral_project(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(faceAt), modeCount, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows * 3);
        }
    }

    /**
     * The face that has these spectral coefficients: mean + U c. All other modes are zero. C:
     * mien_spectral_synthesize().
     * @param firstMode the mode of the first row.
     * @param coefficients row_count x 3 row-major float64, finite
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (modes, not finite), MIEN_E_NO_MEMORY
     */
    public Mesh spectralSynthesize(SpectralBasis basis, long firstMode, double[] coefficients) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var basisAt = call.use(basis);
            var rowCount = call.rows(coefficients, 3, "coefficients");
            var coefficientsAt = call.array(coefficients);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_synthesize(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(coefficientsAt), rowCount, firstMode, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The face that has these spectral coefficients: mean + U c. All other modes are zero. All else as by
     * default.
     */
    public Mesh spectralSynthesize(SpectralBasis basis, long firstMode) {
        return spectralSynthesize(basis, firstMode, null);
    }

    /**
     * A geometric or perceptual distance. L1, L2 and DAME need correspondence, the others do not. C:
     * mien_metric().
     * @param metric MIEN_METRIC_... See Metric.
     * @param reference mm.
     * @param other mm.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
     * MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY
     */
    public double metric(int metric, Mesh reference, Mesh other) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var referenceAt = call.use(reference);
            var otherAt = call.use(other);
            var valueAt = call.room(8);
            call.check(Raw.GET.mien_metric(Memory.address(sessionAt), metric, Memory.address(referenceAt), Memory.address(otherAt), Memory.address(valueAt), call.error()));
            return valueAt.bytes.getDouble(0);
        }
    }

    /**
     * Where a distance comes from: one value per vertex of the reference. L1: |dx| + |dy| + |dz|; L2: distance of
     * the two vertices; Hausdorff: of the vertex from the other surface; DAME: masked change of the dihedral
     * angles around the vertex, rad; FMPD: how much rougher (above 0) or smoother (below 0) the other looks
     * there, after saturation and masking. C: mien_metric_field().
     * @param metric MIEN_METRIC_... See Metric.
     * @param reference mm.
     * @param other mm; the reference's triangles, but for Hausdorff.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
     * MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY
     */
    public double[] metricField(int metric, Mesh reference, Mesh other) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var referenceAt = call.use(reference);
            var otherAt = call.use(other);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_metric_field(Memory.address(sessionAt), metric, Memory.address(referenceAt), Memory.address(otherAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * Local roughness of one mesh, what FMPD is made of: the Laplacian of the angle defect, rad, zero at borders.
     * C: mien_metric_roughness().
     * @param mesh with triangles.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
     * MIEN_E_NO_MEMORY
     */
    public double[] metricRoughness(Mesh mesh) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var meshAt = call.use(mesh);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_metric_roughness(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * Carries an expression from one face to another by deformation transfer. C: mien_transfer_expression().
     * @param sourceNeutral #V vertices, mm.
     * @param sourceExpression the same person with the expression.
     * @param targetNeutral #V vertices, mm; its triangles hold for all.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no
     * triangles), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
     */
    public Mesh transferExpression(Mesh sourceNeutral, Mesh sourceExpression, Mesh targetNeutral) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var sourceNeutralAt = call.use(sourceNeutral);
            var sourceExpressionAt = call.use(sourceExpression);
            var targetNeutralAt = call.use(targetNeutral);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_transfer_expression(Memory.address(sessionAt), Memory.address(sourceNeutralAt), Memory.address(sourceExpressionAt), Memory.address(targetNeutralAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of
     * the scan. options.weights, where given, replace the registration's. C: mien_neutralize().
     * @param fitted registered with the template of the model's training faces.
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException as mien_neutralize_mesh()
     */
    public Neutralization neutralize(ExpressionModel model, Registration fitted, NeutralizeOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var fittedAt = call.use(fitted);
            var optionsAt = (options == null ? new NeutralizeOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_neutralize(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(fittedAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Neutralization(call.pointer(outAt)));
        }
    }

    /**
     * mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of
     * the scan. options.weights, where given, replace the registration's. All else as by default.
     */
    public Neutralization neutralize(ExpressionModel model, Registration fitted) {
        return neutralize(model, fitted, null, null, null);
    }

    /**
     * mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of
     * the scan. options.weights, where given, replace the registration's. All else as by default.
     */
    public Neutralization neutralize(ExpressionModel model, Registration fitted, NeutralizeOptions options) {
        return neutralize(model, fitted, options, null, null);
    }

    /**
     * Takes the expression off a face and keeps everything that the model does not explain. C:
     * mien_neutralize_mesh().
     * @param face in the model's topology, or in a larger one that begins with it (there the displacement runs
     * out smoothly behind the model's rim); mm.
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch
     * or an enumerator that this library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION
     * (MIEN_FIT_EXACT with too little of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Neutralization neutralizeMesh(ExpressionModel model, Mesh face, NeutralizeOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var faceAt = call.use(face);
            var optionsAt = (options == null ? new NeutralizeOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_neutralize_mesh(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(faceAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Neutralization(call.pointer(outAt)));
        }
    }

    /**
     * Takes the expression off a face and keeps everything that the model does not explain. All else as by
     * default.
     */
    public Neutralization neutralizeMesh(ExpressionModel model, Mesh face) {
        return neutralizeMesh(model, face, null, null, null);
    }

    /**
     * Takes the expression off a face and keeps everything that the model does not explain. All else as by
     * default.
     */
    public Neutralization neutralizeMesh(ExpressionModel model, Mesh face, NeutralizeOptions options) {
        return neutralizeMesh(model, face, options, null, null);
    }

    /**
     * Neutralizes every face of a dataset whose subject has a neutral face, and compares. C:
     * mien_evaluate_neutralization().
     * @param model in the dataset's topology.
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that
     * this library does not know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Evaluation evaluateNeutralization(ExpressionModel model, String datasetPath, EvaluateOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var datasetPathAt = call.text(datasetPath);
            var optionsAt = (options == null ? new EvaluateOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_evaluate_neutralization(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(datasetPathAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Evaluation(call.pointer(outAt)));
        }
    }

    /** Neutralizes every face of a dataset whose subject has a neutral face, and compares. All else as by default. */
    public Evaluation evaluateNeutralization(ExpressionModel model, String datasetPath) {
        return evaluateNeutralization(model, datasetPath, null, null, null);
    }

    /** Neutralizes every face of a dataset whose subject has a neutral face, and compares. All else as by default. */
    public Evaluation evaluateNeutralization(ExpressionModel model, String datasetPath, EvaluateOptions options) {
        return evaluateNeutralization(model, datasetPath, options, null, null);
    }

    /**
     * Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a
     * model's template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed. C:
     * mien_measure_geodesic().
     * @param mesh #V x 3, mm, with triangles.
     * @param sources source_count vertex numbers.
     * @param options may be left out: heat stays inside, a time of 4 mean edges squared.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public double[] measureGeodesic(Mesh mesh, int[] sources, GeodesicOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(sources, "sources");
            call.lock(this);
            var sessionAt = call.use(this);
            var meshAt = call.use(mesh);
            var sourceCount = call.rows(sources, 1, "sources");
            var sourcesAt = call.array(sources);
            var optionsAt = (options == null ? new GeodesicOptions() : options).write(call, progress, cancel);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_measure_geodesic(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(sourcesAt), sourceCount, Memory.address(optionsAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a
     * model's template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed. All else
     * as by default.
     */
    public double[] measureGeodesic(Mesh mesh, int[] sources) {
        return measureGeodesic(mesh, sources, null, null, null);
    }

    /**
     * Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a
     * model's template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed. All else
     * as by default.
     */
    public double[] measureGeodesic(Mesh mesh, int[] sources, GeodesicOptions options) {
        return measureGeodesic(mesh, sources, options, null, null);
    }

    /**
     * How far raters (or one rater's sessions) agree, as JSON: confusion matrices, percent agreement, Cohen's
     * kappa plain, linear and quadratic, Fleiss' kappa, all six intraclass correlations, majority grades. C:
     * mien_statistics_agreement().
     * @param ratings subject_count x rater_count, 0 .. grade_count - 1, negative: missing.
     * @param raterCount 2 to 1000.
     * @param gradeCount 2 to 1000.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (grades, no subject graded by all),
     * MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY
     */
    public String statisticsAgreement(int[] ratings, int raterCount, int gradeCount) {
        try (Call call = new Call()) {
            call.required(ratings, "ratings");
            call.lock(this);
            var sessionAt = call.use(this);
            var subjectCount = call.rows(ratings, (long) raterCount, "ratings");
            var ratingsAt = call.array(ratings);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_statistics_agreement(Memory.address(sessionAt), Memory.address(ratingsAt), subjectCount, raterCount, gradeCount, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Within-subject deviation and repeatability coefficient of repeated captures, and the limit of detection
     * from changes measured where nothing changed, as JSON. C: mien_statistics_repeatability().
     * @param subjects value_count numbers: who was measured.
     * @param values value_count values
     * @param blanks blank_count changes measured without any true one; may be left out when 0.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL,
     * MIEN_E_NO_MEMORY
     */
    public String statisticsRepeatability(int[] subjects, double[] values, double[] blanks) {
        try (Call call = new Call()) {
            call.required(subjects, "subjects");
            call.lock(this);
            var sessionAt = call.use(this);
            var valueCount = call.rows(values, 1, "values");
            var valuesAt = call.array(values);
            call.agree("subjects", call.rows(subjects, 1, "subjects"), valueCount);
            var subjectsAt = call.array(subjects);
            var blankCount = call.rows(blanks, 1, "blanks");
            var blanksAt = call.array(blanks);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_statistics_repeatability(Memory.address(sessionAt), Memory.address(valuesAt), Memory.address(subjectsAt), valueCount, Memory.address(blanksAt), blankCount, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Within-subject deviation and repeatability coefficient of repeated captures, and the limit of detection
     * from changes measured where nothing changed, as JSON. All else as by default.
     */
    public String statisticsRepeatability(int[] subjects) {
        return statisticsRepeatability(subjects, null, null);
    }

    /**
     * Bland and Altman's comparison of two methods on the same subjects, as JSON: bias, limits of agreement,
     * their intervals, and whether the bias grows with the size. C: mien_statistics_bland_altman().
     * @param first value_count values.
     * @param second value_count values.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL,
     * MIEN_E_NO_MEMORY
     */
    public String statisticsBlandAltman(double[] first, double[] second) {
        try (Call call = new Call()) {
            call.required(second, "second");
            call.required(first, "first");
            call.lock(this);
            var sessionAt = call.use(this);
            var valueCount = call.rows(first, 1, "first");
            var firstAt = call.array(first);
            call.agree("second", call.rows(second, 1, "second"), valueCount);
            var secondAt = call.array(second);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_statistics_bland_altman(Memory.address(sessionAt), Memory.address(firstAt), Memory.address(secondAt), valueCount, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Neutralizes several scans of one person together: one identity, an expression each. C:
     * mien_neutralize_series().
     * @param faces face_count faces in one topology: the model's, or a larger one that begins with it (there the
     * displacement runs out smoothly behind the model's rim).
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException as mien_neutralize_mesh()
     */
    public Series neutralizeSeries(ExpressionModel model, java.util.List<Mesh> faces, SeriesOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(faces, "faces");
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var faceCount = call.rows(faces, 1, "faces");
            var facesAt = call.handles(faces);
            var optionsAt = (options == null ? new SeriesOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_neutralize_series(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(facesAt), (int) faceCount, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Series(call.pointer(outAt)));
        }
    }

    /** Neutralizes several scans of one person together: one identity, an expression each. All else as by default. */
    public Series neutralizeSeries(ExpressionModel model, java.util.List<Mesh> faces) {
        return neutralizeSeries(model, faces, null, null, null);
    }

    /** Neutralizes several scans of one person together: one identity, an expression each. All else as by default. */
    public Series neutralizeSeries(ExpressionModel model, java.util.List<Mesh> faces, SeriesOptions options) {
        return neutralizeSeries(model, faces, options, null, null);
    }

    /**
     * Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings (inside
     * out, or mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and, where landmarks of
     * the 68-point scheme are given, pose, left and right, closed eyes and mouth. The findings come as JSON text
     * by the two-call protocol: {"errors": n, "warnings": n, "findings": [{"kind": "error" or "warning", "code",
     * "text", "vertices": [...]}]}. No model should be built from a mesh with errors; mien_model_build() does not
     * ask. C: mien_template_check().
     * @param templateMesh the mesh as it is given to mien_model_build().
     * @param mirror 1: symmetry about x = 0 is asked for, as by options.mirror_symmetric; 0.
     * @param landmarks may be left out; vertices of the mesh.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a landmark that is no vertex of the
     * mesh), MIEN_E_UNSUPPORTED_OPTION (mirror), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public String templateCheck(Mesh templateMesh, int mirror, Landmarks landmarks) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var templateMeshAt = call.use(templateMesh);
            var landmarksAt = call.useOrNull(landmarks);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_template_check(Memory.address(sessionAt), Memory.address(templateMeshAt), Memory.address(landmarksAt), mirror, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings (inside
     * out, or mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and, where landmarks of
     * the 68-point scheme are given, pose, left and right, closed eyes and mouth. The findings come as JSON text
     * by the two-call protocol: {"errors": n, "warnings": n, "findings": [{"kind": "error" or "warning", "code",
     * "text", "vertices": [...]}]}. No model should be built from a mesh with errors; mien_model_build() does not
     * ask. All else as by default.
     */
    public String templateCheck(Mesh templateMesh, int mirror) {
        return templateCheck(templateMesh, mirror, null);
    }

    /**
     * Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made
     * by subject, every part_count-th of the sorted subject numbers. C: mien_expression_shard_create().
     * @param shardPath written atomically.
     * @param options may be left out: the whole dataset.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not
     * exist or is empty
     */
    public void expressionShardCreate(String datasetPath, String shardPath, ShardOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(this);
            var sessionAt = call.use(this);
            var datasetPathAt = call.text(datasetPath);
            var optionsAt = (options == null ? new ShardOptions() : options).write(call, progress, cancel);
            var shardPathAt = call.text(shardPath);
            call.check(Raw.GET.mien_expression_shard_create(Memory.address(sessionAt), Memory.address(datasetPathAt), Memory.address(optionsAt), Memory.address(shardPathAt), call.error()));
        }
    }

    /**
     * Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made
     * by subject, every part_count-th of the sorted subject numbers. All else as by default.
     */
    public void expressionShardCreate(String datasetPath, String shardPath) {
        expressionShardCreate(datasetPath, shardPath, null, null, null);
    }

    /**
     * Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made
     * by subject, every part_count-th of the sorted subject numbers. All else as by default.
     */
    public void expressionShardCreate(String datasetPath, String shardPath, ShardOptions options) {
        expressionShardCreate(datasetPath, shardPath, options, null, null);
    }

    /**
     * Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
     * correspondence along the skin and differ by what changed. The right road to a volume over time: fitted
     * templates slide along the skin, and mien_neutralize() takes a part of the slide for expression. C:
     * mien_neutralize_visits().
     * @param faces face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it
     * (there the displacement runs out smoothly behind the model's rim).
     * @param options may be left out: defaults.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose
     * that this library does not know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated
     * vertices), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Visits neutralizeVisits(ExpressionModel model, java.util.List<Mesh> faces, VisitsOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.required(faces, "faces");
            call.lock(this);
            var sessionAt = call.use(this);
            var modelAt = call.use(model);
            var faceCount = call.rows(faces, 1, "faces");
            var facesAt = call.handles(faces);
            var optionsAt = (options == null ? new VisitsOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_neutralize_visits(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(facesAt), (int) faceCount, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Visits(call.pointer(outAt)));
        }
    }

    /**
     * Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
     * correspondence along the skin and differ by what changed. The right road to a volume over time: fitted
     * templates slide along the skin, and mien_neutralize() takes a part of the slide for expression. All else as
     * by default.
     */
    public Visits neutralizeVisits(ExpressionModel model, java.util.List<Mesh> faces) {
        return neutralizeVisits(model, faces, null, null, null);
    }

    /**
     * Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
     * correspondence along the skin and differ by what changed. The right road to a volume over time: fitted
     * templates slide along the skin, and mien_neutralize() takes a part of the slide for expression. All else as
     * by default.
     */
    public Visits neutralizeVisits(ExpressionModel model, java.util.List<Mesh> faces, VisitsOptions options) {
        return neutralizeVisits(model, faces, options, null, null);
    }
}

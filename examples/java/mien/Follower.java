package mien;

// Written by abi/generate_bindings.py.
/** A face that is followed. Changes with each frame: not to be shared between threads. */
public final class Follower extends NativeObject {
    Follower(long owned) { super(owned, Raw.GET::mien_follower_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Follower share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_follower_retain(at);
            return new Follower(at);
        }
    }

    /**
     * Begins to follow a face from a registration, of whatever origin: its fitted mesh becomes the shape that the
     * model's modes move about. C: mien_follower_create().
     * @param model of the registration.
     * @param start in the camera's frame.
     * @param options may be left out: all defaults.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (the registration is
     * of another template), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Follower create(Session session, Model model, Registration start, FollowOptions options) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var modelAt = call.use(model);
            var startAt = call.use(start);
            var optionsAt = call.record(options, 96, false, "options");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_follower_create(Memory.address(sessionAt), Memory.address(modelAt), Memory.address(startAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Follower(call.pointer(outAt)));
        }
    }

    /**
     * Begins to follow a face from a registration, of whatever origin: its fitted mesh becomes the shape that the
     * model's modes move about. All else as by default.
     */
    public static Follower create(Session session, Model model, Registration start) {
        return create(session, model, start, null);
    }

    /**
     * Fits the next frame. A face that is gone is not an error: it is told as lost, and searched in each frame
     * until it is found. C: mien_follower_fit().
     * @param points #P x 3, F32 or F64: one point a pixel, row by row, in the camera's frame and the unit of the
     * options; not finite, or of depth 0: nothing was seen.
     * @param width pixels in a row, 3 or more.
     * @param height rows, 3 or more; width x height is the number of points.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (points that are no pinhole camera's),
     * MIEN_E_MISMATCH (width x height), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public FollowState fit(Session session, Values points, int width, int height) {
        try (Call call = new Call()) {
            call.lock(session);
            call.lock(this);
            var sessionAt = call.use(session);
            var followerAt = call.use(this);
            var pointsAt = call.view(points, 3, "points");
            var outAt = call.sized(32);
            call.check(Raw.GET.mien_follower_fit(Memory.address(sessionAt), Memory.address(followerAt), Memory.address(pointsAt), width, height, Memory.address(outAt), call.error()));
            return FollowState.read(call, outAt, 0);
        }
    }

    /**
     * The fitted template of the last frame that was not lost: template topology, the camera's frame,
     * millimetres. C: mien_follower_get_mesh().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public Mesh mesh() {
        try (Call call = new Call()) {
            call.lock(this);
            var followerAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_follower_get_mesh(Memory.address(followerAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The head's motion in that frame, from the template's frame to the camera's, as a row-major 4 x 4 matrix. C:
     * mien_follower_get_motion().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public double[] motion() {
        try (Call call = new Call()) {
            call.lock(this);
            var followerAt = call.use(this);
            var matrixAt = call.room(16 * 8);
            call.check(Raw.GET.mien_follower_get_motion(Memory.address(followerAt), Memory.address(matrixAt), call.error()));
            return call.readDoubles(matrixAt, 16);
        }
    }
}

package mien;

// Written by abi/generate_bindings.py.
/**
 * A trained network with everything that belongs to it: layers, weights, neighbour lists and statistics of
 * one template. It may be one network, or two over the low and the high frequencies of a face, joined by
 * spectral assembly; the code of the latter holds first the low band's numbers, then the high band's.
 * Immutable: share freely.
 */
public final class Network extends NativeObject {
    Network(long owned) { super(owned, Raw.GET::mien_network_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Network share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_network_retain(at);
            return new Network(at);
        }
    }

    /**
     * Loads a network file through a memory map and checks all of it: structure, hash, finite weights, every
     * index of every list. A file is treated as hostile. C: mien_network_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Network load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_network_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Network(call.pointer(outAt)));
        }
    }

    /**
     * Loads a network from the bytes of a network file that the host holds in memory, e.g. as a resource of its
     * program. The bytes are copied. C: mien_network_load_memory().
     * @param data size bytes.
     * @throws MienException as mien_network_load(), without MIEN_E_IO
     */
    public static Network loadMemory(Session session, byte[] data) {
        try (Call call = new Call()) {
            call.required(data, "data");
            call.lock(session);
            var sessionAt = call.use(session);
            var size = call.rows(data, 1, "data");
            var dataAt = call.array(data);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_network_load_memory(Memory.address(sessionAt), Memory.address(dataAt), size, Memory.address(outAt), call.error()));
            return call.keep(new Network(call.pointer(outAt)));
        }
    }

    /**
     * Numbers of vertices of the faces and of numbers in a code. C: mien_network_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public NetworkCounts counts() {
        try (Call call = new Call()) {
            var networkAt = call.use(this);
            var vertexCountAt = call.room(8);
            var codeCountAt = call.room(8);
            call.check(Raw.GET.mien_network_get_counts(Memory.address(networkAt), Memory.address(vertexCountAt), Memory.address(codeCountAt), call.error()));
            return new NetworkCounts(vertexCountAt.bytes.getLong(0), codeCountAt.bytes.getLong(0));
        }
    }

    /**
     * What the network is, as JSON: name, sizes, features, layers with their multiply-adds, and what its training
     * wrote down. C: mien_network_get_json().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public String json() {
        try (Call call = new Call()) {
            var networkAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_network_get_json(Memory.address(networkAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * The mean face of the network's training, in whose frame codes are decoded. C: mien_network_get_mean().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
     */
    public Mesh mean() {
        try (Call call = new Call()) {
            var networkAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_network_get_mean(Memory.address(networkAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The code of a face. With dst null and capacity 0: writes the count only. C: mien_network_encode().
     * @param face #V vertices in the network's topology, mm, anywhere.
     * @param options may be left out: defaults.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (no
     * encoder), MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION (no rigid
     * motion; a result that is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public NetworkEncode encode(Session session, Mesh face, NetworkOptions options) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var networkAt = call.use(this);
            var faceAt = call.use(face);
            var optionsAt = call.record(options, 24, false, "options");
            var motionAt = call.room(12 * 8);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_network_encode(Memory.address(sessionAt), Memory.address(networkAt), Memory.address(faceAt), Memory.address(optionsAt), Memory.address(motionAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return new NetworkEncode(call.readDoubles(motionAt, 12), call.readDoubles(dstAt, rows));
        }
    }

    /** The code of a face. With dst null and capacity 0: writes the count only. All else as by default. */
    public NetworkEncode encode(Session session, Mesh face) {
        return encode(session, face, null);
    }

    /**
     * The face of a code. C: mien_network_decode().
     * @param code code_count finite values.
     * @param motion may be left out: the mean's frame; 12 float64 of mien_network_encode(), which is undone.
     * @param options may be left out: defaults.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
     * MIEN_E_UNSUPPORTED_OPTION (no decoder; a network that adds an expression), MIEN_E_MISMATCH (code_count),
     * MIEN_E_NO_SOLUTION (a result that is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Mesh decode(Session session, double[] code, double[] motion, NetworkOptions options) {
        try (Call call = new Call()) {
            call.required(code, "code");
            call.lock(session);
            var sessionAt = call.use(session);
            var networkAt = call.use(this);
            var codeCount = call.rows(code, 1, "code");
            var codeAt = call.array(code);
            call.agree("motion", call.rows(motion, 1, "motion"), 12);
            var motionAt = call.array(motion);
            var optionsAt = call.record(options, 24, false, "options");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_network_decode(Memory.address(sessionAt), Memory.address(networkAt), Memory.address(codeAt), codeCount, Memory.address(motionAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /** The face of a code. All else as by default. */
    public Mesh decode(Session session, double[] code) {
        return decode(session, code, null, null);
    }

    /**
     * The decoded face of a face's code, in the frame of that face: an autoencoder's reconstruction, or what the
     * network was trained to make of a face (a neutral one into an expression, with what is the person's own
     * kept). Networks on deformations, which know no place, have their result put onto the face rigidly; one that
     * deforms a neutral face alone keeps that one's centre. C: mien_network_apply().
     * @param face #V vertices in the network's topology, mm, anywhere.
     * @param options may be left out: defaults.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is
     * missing), MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION,
     * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Mesh apply(Session session, Mesh face, NetworkOptions options) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var networkAt = call.use(this);
            var faceAt = call.use(face);
            var optionsAt = call.record(options, 24, false, "options");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_network_apply(Memory.address(sessionAt), Memory.address(networkAt), Memory.address(faceAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The decoded face of a face's code, in the frame of that face: an autoencoder's reconstruction, or what the
     * network was trained to make of a face (a neutral one into an expression, with what is the person's own
     * kept). Networks on deformations, which know no place, have their result put onto the face rigidly; one that
     * deforms a neutral face alone keeps that one's centre. All else as by default.
     */
    public Mesh apply(Session session, Mesh face) {
        return apply(session, face, null);
    }

    /**
     * Which numbers of a code belong to which band. Editing some of them changes that band of the decoded face
     * (and the other one as far as its decoder was conditioned). C: mien_network_get_bands().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public NetworkBands bands() {
        try (Call call = new Call()) {
            var networkAt = call.use(this);
            var lowCodeCountAt = call.room(8);
            var bandLimitAt = call.room(8);
            call.check(Raw.GET.mien_network_get_bands(Memory.address(networkAt), Memory.address(lowCodeCountAt), Memory.address(bandLimitAt), call.error()));
            return new NetworkBands(lowCodeCountAt.bytes.getLong(0), bandLimitAt.bytes.getLong(0));
        }
    }

    /**
     * A face between two, or with the bands of both: each band's code goes from a's to b's by its own weight and
     * is decoded. Weights 0 and 0 give a as the network gives it back, 1 and 0 or 0 and 1 exchange a band, equal
     * ones interpolate. A network without bands takes the first weight. C: mien_network_mix().
     * @param a #V vertices in the network's topology, mm, anywhere.
     * @param b #V vertices in the network's topology, mm, anywhere.
     * @param lowWeight of the low band; any finite number.
     * @param highWeight of the high band; any finite number.
     * @param options may be left out: defaults.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a weight that is not finite),
     * MIEN_E_UNSUPPORTED_OPTION (a half is missing; a network that adds an expression), MIEN_E_MISMATCH (vertex
     * count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
     */
    public Mesh mix(Session session, Mesh a, Mesh b, double lowWeight, double highWeight, NetworkOptions options) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var networkAt = call.use(this);
            var aAt = call.use(a);
            var bAt = call.use(b);
            var optionsAt = call.record(options, 24, false, "options");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_network_mix(Memory.address(sessionAt), Memory.address(networkAt), Memory.address(aAt), Memory.address(bAt), lowWeight, highWeight, Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * A face between two, or with the bands of both: each band's code goes from a's to b's by its own weight and
     * is decoded. Weights 0 and 0 give a as the network gives it back, 1 and 0 or 0 and 1 exchange a band, equal
     * ones interpolate. A network without bands takes the first weight. All else as by default.
     */
    public Mesh mix(Session session, Mesh a, Mesh b, double lowWeight, double highWeight) {
        return mix(session, a, b, lowWeight, highWeight, null);
    }

    /**
     * The code of a made-up face: drawn from a Gaussian over the codes of the training faces, which the file
     * holds. Number and seed alone decide. With dst null and capacity 0: writes the count only. C:
     * mien_network_sample().
     * @param seed of the chance.
     * @param number of the code within the seed's series.
     * @param spread 0 the mean code, 1 as far apart as the training faces; not negative.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (spread), MIEN_E_UNSUPPORTED_OPTION
     * (no distribution in the file), MIEN_E_NO_MEMORY
     */
    public double[] sample(long seed, long number, double spread) {
        try (Call call = new Call()) {
            var networkAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_network_sample(Memory.address(networkAt), seed, number, spread, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over
     * the faces and by face. Judge a network on people that it was not trained on. C: mien_network_evaluate().
     * @param datasetPath a dataset file in the network's topology.
     * @param options may be left out: all faces.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is
     * missing, a switch, a network that adds an expression), MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no
     * such face), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY,
     * MIEN_E_CANCELLED
     */
    public String evaluate(Session session, String datasetPath, NetworkEvaluationOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var networkAt = call.use(this);
            var datasetPathAt = call.text(datasetPath);
            var optionsAt = (options == null ? new NetworkEvaluationOptions() : options).write(call, progress, cancel);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_network_evaluate(Memory.address(sessionAt), Memory.address(networkAt), Memory.address(datasetPathAt), Memory.address(optionsAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over
     * the faces and by face. Judge a network on people that it was not trained on. All else as by default.
     */
    public String evaluate(Session session, String datasetPath) {
        return evaluate(session, datasetPath, null, null, null);
    }

    /**
     * How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over
     * the faces and by face. Judge a network on people that it was not trained on. All else as by default.
     */
    public String evaluate(Session session, String datasetPath, NetworkEvaluationOptions options) {
        return evaluate(session, datasetPath, options, null, null);
    }
}

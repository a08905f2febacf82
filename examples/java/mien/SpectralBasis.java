package mien;

// Written by abi/generate_bindings.py.
/** The first Laplace-Beltrami eigenvectors of a mean shape. Immutable: share freely. */
public final class SpectralBasis extends NativeObject {
    SpectralBasis(long owned) { super(owned, Raw.GET::mien_spectral_basis_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public SpectralBasis share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_spectral_basis_retain(at);
            return new SpectralBasis(at);
        }
    }

    /**
     * Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that
     * none is missing. C: mien_spectral_basis_build().
     * @param mean the mean shape, mm. Any triangle mesh.
     * @param options may be left out: 500 modes, mixed Voronoi mass, intrinsic Delaunay.
     * @param progress may be null; returns false to cancel
     * @param cancel may be null; interrupting the thread cancels as well
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count),
     * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
     * MIEN_E_CANCELLED
     */
    public static SpectralBasis build(Session session, Mesh mean, SpectralBasisOptions options, Progress progress, Cancel cancel) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meanAt = call.use(mean);
            var optionsAt = (options == null ? new SpectralBasisOptions() : options).write(call, progress, cancel);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_basis_build(Memory.address(sessionAt), Memory.address(meanAt), Memory.address(optionsAt), Memory.address(outAt), call.error()));
            return call.keep(new SpectralBasis(call.pointer(outAt)));
        }
    }

    /**
     * Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that
     * none is missing. All else as by default.
     */
    public static SpectralBasis build(Session session, Mesh mean) {
        return build(session, mean, null, null, null);
    }

    /**
     * Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that
     * none is missing. All else as by default.
     */
    public static SpectralBasis build(Session session, Mesh mean, SpectralBasisOptions options) {
        return build(session, mean, options, null, null);
    }

    /**
     * Opens a basis file; the vectors stay in the mapped file. C: mien_spectral_basis_load().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
     * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
     */
    public static SpectralBasis load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_basis_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new SpectralBasis(call.pointer(outAt)));
        }
    }

    /**
     * Writes a basis file (safetensors). Atomic. C: mien_spectral_basis_save().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var basisAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_spectral_basis_save(Memory.address(sessionAt), Memory.address(basisAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Numbers of vertices and modes. C: mien_spectral_basis_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public SpectralBasisCounts counts() {
        try (Call call = new Call()) {
            var basisAt = call.use(this);
            var vertexCountAt = call.room(8);
            var modeCountAt = call.room(8);
            call.check(Raw.GET.mien_spectral_basis_get_counts(Memory.address(basisAt), Memory.address(vertexCountAt), Memory.address(modeCountAt), call.error()));
            return new SpectralBasisCounts(vertexCountAt.bytes.getLong(0), modeCountAt.bytes.getLong(0));
        }
    }

    /**
     * Copies the eigenvalues, ascending, 1/mm^2. With dst null and capacity 0: writes the count only. C:
     * mien_spectral_basis_get_eigenvalues().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public double[] eigenvalues() {
        try (Call call = new Call()) {
            var basisAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_spectral_basis_get_eigenvalues(Memory.address(basisAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * Copies one eigenvector, U's column: a value per vertex, orthonormal in the mass matrix, so 1/mm (plain
     * without mass). C: mien_spectral_basis_get_vector().
     * @param mode 0 to the basis' modes - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode), MIEN_E_NO_MEMORY
     */
    public double[] vector(long mode) {
        try (Call call = new Call()) {
            var basisAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_spectral_basis_get_vector(Memory.address(basisAt), mode, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * Copies the diagonal of the mass matrix: mm^2 per vertex, ones without mass. C:
     * mien_spectral_basis_get_mass().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public double[] mass() {
        try (Call call = new Call()) {
            var basisAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 8);
            } while ((capacity = call.more(Raw.GET.mien_spectral_basis_get_mass(Memory.address(basisAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows);
        }
    }

    /**
     * The mean shape that the basis belongs to. C: mien_spectral_basis_get_mean().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
     */
    public Mesh mean() {
        try (Call call = new Call()) {
            var basisAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_spectral_basis_get_mean(Memory.address(basisAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }
}

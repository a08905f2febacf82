/* Mien: frequency bands of faces, and the distances that judge a face against another. All faces
 * of one call share the topology of their basis or first mesh. */
#ifndef MIEN_SPECTRAL_H
#define MIEN_SPECTRAL_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The first Laplace-Beltrami eigenvectors of a mean shape. Immutable: share freely. */
typedef struct mien_spectral_basis mien_spectral_basis;

/** Mass matrices of the Laplacian. */
enum {
    MIEN_MASS_MIXED_VORONOI = 0,
    MIEN_MASS_BARYCENTRIC = 1,
    MIEN_MASS_NONE = 2 /**< bands then follow the triangulation's density; for comparison */
};

/** What to do with negative cotangent weights. */
enum {
    MIEN_COTANGENTS_INTRINSIC_DELAUNAY = 0,
    MIEN_COTANGENTS_CLAMP = 1,
    MIEN_COTANGENTS_KEEP = 2
};

/** Initialise with mien_spectral_basis_options_init(). */
typedef struct mien_spectral_basis_options {
    uint32_t struct_size;
    uint32_t mode_count;       /**< 1 to #V - 1; default 500 */
    int32_t mass;              /**< MIEN_MASS_...; default mixed Voronoi */
    int32_t cotangents;        /**< MIEN_COTANGENTS_...; default intrinsic Delaunay */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_spectral_basis_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_spectral_basis_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_spectral_basis_options_init(mien_spectral_basis_options* options,
                                                         size_t struct_size);

/**
 * Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts
 * prove that none is missing.
 *
 * @param session [in] not null.
 * @param mean    [in] not null; the mean shape, mm. Any triangle mesh.
 * @param options [in] may be null: 500 modes, mixed Voronoi mass, intrinsic Delaunay.
 * @param out     [out] not null; the basis, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count), MIEN_E_UNSUPPORTED_OPTION,
 * MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_spectral_basis_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(k #V) time with a large constant (seconds for 500 modes of 11,000 vertices), about 24 k
 * #V bytes
 * @since  0.1
 * @source kosk-2024 4.2, 4.10
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_build(mien_session* session,
                                                         const mien_mesh* mean,
                                                         const mien_spectral_basis_options* options,
                                                         mien_spectral_basis** out,
                                                         mien_error* error);

/**
 * Opens a basis file; the vectors stay in the mapped file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the basis, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_spectral_basis_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size), for the hash
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_load(mien_session* session, const char* path,
                                                        mien_spectral_basis** out,
                                                        mien_error* error);

/**
 * Writes a basis file (safetensors). Atomic.
 *
 * @param session [in] not null.
 * @param basis   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   8 k #V bytes written
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_save(mien_session* session,
                                                        const mien_spectral_basis* basis,
                                                        const char* path, mien_error* error);

/**
 * Numbers of vertices and modes.
 *
 * @param basis        [in] not null.
 * @param vertex_count [out] may be null; #V.
 * @param mode_count   [out] may be null; k.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_counts(const mien_spectral_basis* basis,
                                                              uint64_t* vertex_count,
                                                              uint64_t* mode_count,
                                                              mien_error* error);

/**
 * Copies the eigenvalues, ascending, 1/mm^2. With dst null and capacity 0: writes the count only.
 *
 * @param basis    [in] not null.
 * @param dst      [out] room for capacity float64, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; k.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(k)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_eigenvalues(const mien_spectral_basis* basis,
                                                                   double* dst, uint64_t capacity,
                                                                   uint64_t* count,
                                                                   mien_error* error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param basis [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_spectral_basis_retain(mien_spectral_basis* basis);

/**
 * Gives one reference back; the last one frees the basis.
 *
 * @param basis [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_spectral_basis_release(mien_spectral_basis* basis);

/**
 * Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high -
 * mean is the face.
 *
 * @param session [in] not null.
 * @param basis   [in] not null.
 * @param face    [in] not null; #V vertices, mm, aligned with the mean shape.
 * @param k       [in] 0 to the basis' modes.
 * @param low     [out] may be null; the low band's mesh, or null on failure.
 * @param high    [out] may be null; the high band's mesh, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *low and *high with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(k #V)
 * @since  0.1
 * @source kosk-2024 4.11
 */
MIEN_API mien_status MIEN_CALL mien_spectral_split(mien_session* session,
                                                   const mien_spectral_basis* basis,
                                                   const mien_mesh* face, uint64_t k,
                                                   mien_mesh** low, mien_mesh** high,
                                                   mien_error* error);

/**
 * The low frequencies of one face with the high frequencies of another.
 *
 * @param session [in] not null.
 * @param basis   [in] not null.
 * @param low     [in] not null; #V vertices, mm.
 * @param high    [in] not null; #V vertices, mm.
 * @param k       [in] 0 to the basis' modes; #V or more gives `low`.
 * @param out     [out] not null; the assembled face, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(k #V)
 * @since  0.1
 * @source kosk-2024 4.15, 5.10
 */
MIEN_API mien_status MIEN_CALL mien_spectral_assemble(mien_session* session,
                                                      const mien_spectral_basis* basis,
                                                      const mien_mesh* low, const mien_mesh* high,
                                                      uint64_t k, mien_mesh** out,
                                                      mien_error* error);

/**
 * Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it.
 *
 * @param session     [in] not null.
 * @param basis       [in] not null.
 * @param face        [in] not null; #V vertices, mm.
 * @param limits      [in] limit_count ascending mode numbers; may be null when limit_count is 0.
 * @param limit_count [in] number of limits; they cut limit_count + 1 bands, the last one open.
 * @param gains       [in] not null; limit_count + 1 finite values.
 * @param out         [out] not null; the edited face, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH (vertex
 * count), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(last limit x #V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_edit(mien_session* session,
                                                  const mien_spectral_basis* basis,
                                                  const mien_mesh* face, const uint64_t* limits,
                                                  uint64_t limit_count, const double* gains,
                                                  mien_mesh** out, mien_error* error);

/**
 * Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange
 * details.
 *
 * @param session     [in] not null.
 * @param basis       [in] not null.
 * @param first       [in] not null; #V vertices, mm; weight 0.
 * @param second      [in] not null; #V vertices, mm; weight 1.
 * @param limits      [in] limit_count ascending mode numbers; may be null when limit_count is 0.
 * @param limit_count [in] number of limits; they cut limit_count + 1 bands, the last one open.
 * @param weights     [in] not null; limit_count + 1 finite values.
 * @param out         [out] not null; the mixed face, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH (vertex
 * count), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(last limit x #V)
 * @since  0.1
 * @source kosk-2024 4.16, there in a network's latent space
 */
MIEN_API mien_status MIEN_CALL mien_spectral_mix(mien_session* session,
                                                 const mien_spectral_basis* basis,
                                                 const mien_mesh* first, const mien_mesh* second,
                                                 const uint64_t* limits, uint64_t limit_count,
                                                 const double* weights, mien_mesh** out,
                                                 mien_error* error);

/**
 * Copies one eigenvector, U's column: a value per vertex, orthonormal in the mass matrix, so 1/mm
 * (plain without mass). With dst null and capacity 0: the count only.
 *
 * @param basis    [in] not null.
 * @param mode     [in] 0 to the basis' modes - 1.
 * @param dst      [out] room for capacity float64, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode), MIEN_E_BUFFER_TOO_SMALL (dst
 * untouched, count written), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 * @source kosk-2024 (4.2)
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_vector(const mien_spectral_basis* basis,
                                                              uint64_t mode, double* dst,
                                                              uint64_t capacity, uint64_t* count,
                                                              mien_error* error);

/**
 * Copies the diagonal of the mass matrix: mm^2 per vertex, ones without mass. With dst null and
 * capacity 0: the count only.
 *
 * @param basis    [in] not null.
 * @param dst      [out] room for capacity float64, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 * @source kosk-2024 (4.2)
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_mass(const mien_spectral_basis* basis,
                                                            double* dst, uint64_t capacity,
                                                            uint64_t* count, mien_error* error);

/**
 * The mean shape that the basis belongs to.
 *
 * @param basis [in] not null.
 * @param out   [out] not null; the mesh, mm, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V + #F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_mean(const mien_spectral_basis* basis,
                                                            mien_mesh** out, mien_error* error);

/**
 * Spectral coefficients of a face: U' M (face - mean), one row of x, y, z per mode, float64. With
 * dst null and capacity 0: the count only.
 *
 * @param session    [in] not null.
 * @param basis      [in] not null.
 * @param face       [in] not null; #V vertices, mm, aligned with the mean shape.
 * @param mode_count [in] 0 to the basis' modes: the first of them; more means all.
 * @param dst        [out] room for capacity rows of 3, or null.
 * @param capacity   [in] rows that dst holds.
 * @param count      [out] may be null; the modes that were asked for, at most the basis'.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(mode_count x #V)
 * @since  0.2
 * @source kosk-2024 (4.3), (4.10)
 */
MIEN_API mien_status MIEN_CALL mien_spectral_project(mien_session* session,
                                                     const mien_spectral_basis* basis,
                                                     const mien_mesh* face, uint64_t mode_count,
                                                     double* dst, uint64_t capacity,
                                                     uint64_t* count, mien_error* error);

/**
 * The face that has these spectral coefficients: mean + U c. All other modes are zero.
 *
 * @param session      [in] not null.
 * @param basis        [in] not null.
 * @param coefficients [in] row_count x 3 row-major float64, finite; null when row_count is 0.
 * @param row_count    [in] 0 to the basis' modes - first_mode.
 * @param first_mode   [in] the mode of the first row.
 * @param out          [out] not null; the face, mm, or null on failure.
 * @param error        [out] may be null; detail_index is the first row that is not finite.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (modes, not finite), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(row_count x #V)
 * @since  0.2
 * @source kosk-2024 (4.4)
 */
MIEN_API mien_status MIEN_CALL mien_spectral_synthesize(mien_session* session,
                                                        const mien_spectral_basis* basis,
                                                        const double* coefficients,
                                                        uint64_t row_count, uint64_t first_mode,
                                                        mien_mesh** out, mien_error* error);

/** Distances between two faces. */
enum {
    MIEN_METRIC_L1 = 1, /**< mm: mean of |dx| + |dy| + |dz| over the vertices */
    MIEN_METRIC_L2 = 2, /**< mm: mean Euclidean distance over the vertices */
    MIEN_METRIC_HAUSDORFF =
        3,                /**< mm: largest distance of a vertex from the other surface, both ways */
    MIEN_METRIC_DAME = 4, /**< rad: change of the dihedral angles, masked, weighted with area */
    MIEN_METRIC_FMPD = 5  /**< 0 to 1: difference of the global roughness */
};

/**
 * A geometric or perceptual distance. L1, L2 and DAME need correspondence, the others do not.
 *
 * @param session   [in] not null.
 * @param metric    [in] MIEN_METRIC_...
 * @param reference [in] not null; mm.
 * @param other     [in] not null; mm.
 * @param value     [out] not null; unchanged on failure.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
 * MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V), Hausdorff O(#V log #F)
 * @since  0.1
 * @source kosk-2024 3.3.10; Vasa & Rus 2012; Wang, Torkhani & Montanvert 2012
 */
MIEN_API mien_status MIEN_CALL mien_metric(mien_session* session, int32_t metric,
                                           const mien_mesh* reference, const mien_mesh* other,
                                           double* value, mien_error* error);

/**
 * Where a distance comes from: one value per vertex of the reference. L1: |dx| + |dy| + |dz|; L2:
 * distance of the two vertices; Hausdorff: of the vertex from the other surface; DAME: masked
 * change of the dihedral angles around the vertex, rad; FMPD: how much rougher (above 0) or
 * smoother (below 0) the other looks there, after saturation and masking. With dst null and
 * capacity 0: the count only.
 *
 * @param session   [in] not null.
 * @param metric    [in] MIEN_METRIC_...
 * @param reference [in] not null; mm.
 * @param other     [in] not null; mm; the reference's triangles, but for Hausdorff.
 * @param dst       [out] room for capacity float64, or null.
 * @param capacity  [in] values that dst holds.
 * @param count     [out] may be null; #V of the reference.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
 * MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V), Hausdorff O(#V log #F)
 * @since  0.2
 * @source kosk-2024 3.3.10; Vasa & Rus 2012; Wang, Torkhani & Montanvert 2012
 */
MIEN_API mien_status MIEN_CALL mien_metric_field(mien_session* session, int32_t metric,
                                                 const mien_mesh* reference, const mien_mesh* other,
                                                 double* dst, uint64_t capacity, uint64_t* count,
                                                 mien_error* error);

/**
 * Local roughness of one mesh, what FMPD is made of: the Laplacian of the angle defect, rad, zero
 * at borders. With dst null and capacity 0: the count only.
 *
 * @param session  [in] not null.
 * @param mesh     [in] not null; with triangles.
 * @param dst      [out] room for capacity float64, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 * @source Wang, Torkhani & Montanvert 2012
 */
MIEN_API mien_status MIEN_CALL mien_metric_roughness(mien_session* session, const mien_mesh* mesh,
                                                     double* dst, uint64_t capacity,
                                                     uint64_t* count, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

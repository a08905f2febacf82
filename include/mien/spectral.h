/* Mien: frequency bands of faces, perceptual distances, representations, hierarchies, carried and predicted
 * expressions. All faces of one call share the topology of their basis, model or first mesh. */
#ifndef MIEN_SPECTRAL_H
#define MIEN_SPECTRAL_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The first Laplace-Beltrami eigenvectors of a mean shape. Immutable: share freely. */
typedef struct mien_spectral_basis mien_spectral_basis;
/** A trained representation of faces: numbers for learning, with their exact inverse. Immutable: share freely. */
typedef struct mien_representation mien_representation;
/** Levels of a template with maps between them. Immutable: share freely. */
typedef struct mien_hierarchy mien_hierarchy;
/** Predicts one expression of a person from the neutral face. Immutable: share freely. */
typedef struct mien_blendshape_model mien_blendshape_model;

/** Mass matrices of the Laplacian. */
enum {
    MIEN_MASS_MIXED_VORONOI = 0,
    MIEN_MASS_BARYCENTRIC = 1,
    MIEN_MASS_NONE = 2 /**< bands then follow the triangulation's density; for comparison */
};

/** What to do with negative cotangent weights. */
enum { MIEN_COTANGENTS_INTRINSIC_DELAUNAY = 0, MIEN_COTANGENTS_CLAMP = 1, MIEN_COTANGENTS_KEEP = 2 };

/** Initialise with mien_spectral_basis_options_init(). */
typedef struct mien_spectral_basis_options {
    uint32_t struct_size;
    uint32_t mode_count; /**< 1 to #V - 1; default 500 */
    int32_t mass;        /**< MIEN_MASS_...; default mixed Voronoi */
    int32_t cotangents;  /**< MIEN_COTANGENTS_...; default intrinsic Delaunay */
    mien_progress_fn progress; /**< may be null */
    void *progress_user;
    mien_cancel *cancel; /**< may be null */
} mien_spectral_basis_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
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
MIEN_API void MIEN_CALL mien_spectral_basis_options_init(mien_spectral_basis_options *options,
                                                         size_t struct_size);

/**
 * Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that
 * none is missing.
 *
 * @param session [in] not null.
 * @param mean    [in] not null; the mean shape, mm. Any triangle mesh.
 * @param options [in] may be null: 500 modes, mixed Voronoi mass, intrinsic Delaunay.
 * @param out     [out] not null; the basis, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_INVALID_MESH,
 *         MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_spectral_basis_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(k #V) time with a large constant (seconds for 500 modes of 11,000 vertices), about 24 k #V bytes
 * @since  0.1
 * @source kosk-2024 4.2, 4.10
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_build(mien_session *session, const mien_mesh *mean,
                                                         const mien_spectral_basis_options *options,
                                                         mien_spectral_basis **out, mien_error *error);

/**
 * Opens a basis file; the vectors stay in the mapped file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the basis, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 *         MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_spectral_basis_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size), for the hash
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_load(mien_session *session, const char *path,
                                                        mien_spectral_basis **out, mien_error *error);

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
MIEN_API mien_status MIEN_CALL mien_spectral_basis_save(mien_session *session,
                                                        const mien_spectral_basis *basis, const char *path,
                                                        mien_error *error);

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
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_counts(const mien_spectral_basis *basis,
                                                              uint64_t *vertex_count, uint64_t *mode_count,
                                                              mien_error *error);

/**
 * Copies the eigenvalues, ascending, 1/mm^2. With dst null and capacity 0: writes the count only.
 *
 * @param basis    [in] not null.
 * @param dst      [out] room for capacity float64, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; k.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(k)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_eigenvalues(const mien_spectral_basis *basis,
                                                                   double *dst, uint64_t capacity,
                                                                   uint64_t *count, mien_error *error);

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
MIEN_API void MIEN_CALL mien_spectral_basis_retain(mien_spectral_basis *basis);

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
MIEN_API void MIEN_CALL mien_spectral_basis_release(mien_spectral_basis *basis);

/**
 * Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high - mean is the face.
 *
 * @param session [in] not null.
 * @param basis   [in] not null.
 * @param face    [in] not null; #V vertices, mm, aligned with the mean shape.
 * @param k       [in] 0 to the basis' modes.
 * @param low     [out] may be null; the low band's mesh, or null on failure.
 * @param high    [out] may be null; the high band's mesh, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY
 * @owner  the caller releases *low and *high with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(k #V)
 * @since  0.1
 * @source kosk-2024 4.11
 */
MIEN_API mien_status MIEN_CALL mien_spectral_split(mien_session *session, const mien_spectral_basis *basis,
                                                   const mien_mesh *face, uint64_t k, mien_mesh **low,
                                                   mien_mesh **high, mien_error *error);

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
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(k #V)
 * @since  0.1
 * @source kosk-2024 4.15, 5.10
 */
MIEN_API mien_status MIEN_CALL mien_spectral_assemble(mien_session *session,
                                                      const mien_spectral_basis *basis,
                                                      const mien_mesh *low, const mien_mesh *high,
                                                      uint64_t k, mien_mesh **out, mien_error *error);

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
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH (vertex count),
 *         MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(last limit x #V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_spectral_edit(mien_session *session, const mien_spectral_basis *basis,
                                                  const mien_mesh *face, const uint64_t *limits,
                                                  uint64_t limit_count, const double *gains,
                                                  mien_mesh **out, mien_error *error);

/**
 * Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details.
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
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH (vertex count),
 *         MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(last limit x #V)
 * @since  0.1
 * @source kosk-2024 4.16, there in a network's latent space
 */
MIEN_API mien_status MIEN_CALL mien_spectral_mix(mien_session *session, const mien_spectral_basis *basis,
                                                 const mien_mesh *first, const mien_mesh *second,
                                                 const uint64_t *limits, uint64_t limit_count,
                                                 const double *weights, mien_mesh **out, mien_error *error);

/** Distances between two faces. */
enum {
    MIEN_METRIC_L1 = 1,        /**< mm: mean of |dx| + |dy| + |dz| over the vertices */
    MIEN_METRIC_L2 = 2,        /**< mm: mean Euclidean distance over the vertices */
    MIEN_METRIC_HAUSDORFF = 3, /**< mm: largest distance of a vertex from the other surface, both ways */
    MIEN_METRIC_DAME = 4,      /**< rad: change of the dihedral angles, masked, weighted with area */
    MIEN_METRIC_FMPD = 5       /**< 0 to 1: difference of the global roughness */
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
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (metric), MIEN_E_MISMATCH (vertex count or triangles),
 *         MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V), Hausdorff O(#V log #F)
 * @since  0.1
 * @source kosk-2024 3.3.10; Vasa & Rus 2012; Wang, Torkhani & Montanvert 2012
 */
MIEN_API mien_status MIEN_CALL mien_metric(mien_session *session, int32_t metric, const mien_mesh *reference,
                                           const mien_mesh *other, double *value, mien_error *error);

/** Representations. */
enum {
    MIEN_FEATURES_EUCLIDEAN = 1,
    MIEN_FEATURES_EUCLIDEAN_STANDARDISED = 2,
    MIEN_FEATURES_EUCLIDEAN_NORMALISED = 3,
    MIEN_FEATURES_DEFORMATION = 4,
    MIEN_FEATURES_DEFORMATION_NORMALISED = 5,
    MIEN_FEATURES_DEFORMATION_STANDARDISED = 6
};

/**
 * Learns the mean shape, scale and statistics of a dataset's faces.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; a dataset file.
 * @param kind         [in] MIEN_FEATURES_...
 * @param neutral_only [in] 1: only the faces marked neutral; 0: all.
 * @param out          [out] not null; the representation, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 *         MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_representation_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   five passes over the faces; one face in memory at a time
 * @since  0.1
 * @source kosk-2024 3.2 to 3.19
 */
MIEN_API mien_status MIEN_CALL mien_representation_train(mien_session *session, const char *dataset_path,
                                                         int32_t kind, int32_t neutral_only,
                                                         mien_representation **out, mien_error *error);

/**
 * Opens a representation file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the representation, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 *         MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_representation_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size); deformations factorise their template once
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_load(mien_session *session, const char *path,
                                                        mien_representation **out, mien_error *error);

/**
 * Writes a representation file (safetensors). Atomic.
 *
 * @param session        [in] not null.
 * @param representation [in] not null.
 * @param path           [in] UTF-8, not null.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_save(mien_session *session,
                                                        const mien_representation *representation,
                                                        const char *path, mien_error *error);

/**
 * Numbers of vertices and of features a vertex.
 *
 * @param representation [in] not null.
 * @param vertex_count   [out] may be null; #V.
 * @param channel_count  [out] may be null; 3, or 9 for deformations.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_get_counts(const mien_representation *representation,
                                                              uint64_t *vertex_count,
                                                              uint64_t *channel_count, mien_error *error);

/**
 * The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count only.
 *
 * @param session        [in] not null.
 * @param representation [in] not null.
 * @param face           [in] not null; #V vertices, mm, anywhere.
 * @param motion         [out] may be null; 12 float64: the rigid motion onto the mean, x -> R x + t, as R
 *                       row by row, then t in mm. mien_representation_decode() takes it back.
 * @param dst            [out] room for capacity rows of c, or null.
 * @param capacity       [in] rows that dst holds.
 * @param count          [out] may be null; #V.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 *         MIEN_E_MISMATCH (vertex count), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V); deformations two sparse solves
 * @since  0.1
 * @source kosk-2024 2.5, 3.14 to 3.19, 4.12
 */
MIEN_API mien_status MIEN_CALL mien_representation_encode(mien_session *session,
                                                          const mien_representation *representation,
                                                          const mien_mesh *face, double *motion,
                                                          double *dst, uint64_t capacity, uint64_t *count,
                                                          mien_error *error);

/**
 * The face that has these features.
 *
 * @param session        [in] not null.
 * @param representation [in] not null.
 * @param features       [in] not null; row_count x c row-major float64.
 * @param row_count      [in] #V.
 * @param motion         [in] may be null: the mean's frame; else 12 float64 of mien_representation_encode(),
 *                       which is undone.
 * @param out            [out] not null; the face, mm, or null on failure.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid), MIEN_E_MISMATCH (row_count),
 *         MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V); deformations one sparse solve
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_decode(mien_session *session,
                                                          const mien_representation *representation,
                                                          const double *features, uint64_t row_count,
                                                          const double *motion, mien_mesh **out,
                                                          mien_error *error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param representation [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_representation_retain(mien_representation *representation);

/**
 * Gives one reference back; the last one frees the representation.
 *
 * @param representation [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_representation_release(mien_representation *representation);

/**
 * Levels by quadric edge collapse, with barycentric maps up and selections down.
 *
 * @param session     [in] not null.
 * @param mesh        [in] not null; an orientable manifold.
 * @param level_count [in] levels below the mesh itself, 1 to 32; fewer when no collapse is legal.
 * @param factor      [in] vertices are divided by this from level to level; above 1.
 * @param out         [out] not null; the hierarchy, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_hierarchy_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V log #V)
 * @since  0.1
 * @source kosk-2024 3.3.2
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_build_quadric(mien_session *session, const mien_mesh *mesh,
                                                            uint32_t level_count, double factor,
                                                            mien_hierarchy **out, mien_error *error);

/**
 * Levels sampled from the connectivity alone.
 *
 * @param session     [in] not null.
 * @param mesh        [in] not null.
 * @param level_count [in] levels below the mesh itself, 1 to 32.
 * @param stride      [in] least distance of kept vertices in edges, at least 1.
 * @param radius      [in] edges over which the maps reach, stride - 1 to 64.
 * @param out         [out] not null; the hierarchy, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_hierarchy_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V times the vertices within radius)
 * @since  0.1
 * @source kosk-2024 3.3.4
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_build_connectivity(mien_session *session,
                                                                 const mien_mesh *mesh,
                                                                 uint32_t level_count, uint32_t stride,
                                                                 uint32_t radius, mien_hierarchy **out,
                                                                 mien_error *error);

/**
 * Opens a hierarchy file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the hierarchy, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 *         MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_hierarchy_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_load(mien_session *session, const char *path,
                                                   mien_hierarchy **out, mien_error *error);

/**
 * Writes a hierarchy file (safetensors; maps as compressed rows). Atomic.
 *
 * @param session   [in] not null.
 * @param hierarchy [in] not null.
 * @param path      [in] UTF-8, not null.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_save(mien_session *session, const mien_hierarchy *hierarchy,
                                                   const char *path, mien_error *error);

/**
 * Number of levels, the finest included.
 *
 * @param hierarchy   [in] not null.
 * @param level_count [out] not null.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_level_count(const mien_hierarchy *hierarchy,
                                                              uint32_t *level_count, mien_error *error);

/**
 * The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no triangles.
 *
 * @param hierarchy [in] not null.
 * @param level     [in] 0 to level_count - 1.
 * @param out       [out] not null; the mesh, or null on failure.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V + #F of the level)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_level(const mien_hierarchy *hierarchy, uint32_t level,
                                                        mien_mesh **out, mien_error *error);

/** Directions of a hierarchy's maps. */
enum {
    MIEN_MAP_DOWN = 1, /**< from the next finer level to this one */
    MIEN_MAP_UP = 2    /**< from this level to the next finer one */
};

/**
 * Applies a map to values on vertices: dst = map values.
 *
 * @param hierarchy     [in] not null.
 * @param level         [in] 1 to level_count - 1: the coarser level of the map.
 * @param direction     [in] MIEN_MAP_DOWN or MIEN_MAP_UP.
 * @param values        [in] not null; row_count x channel_count row-major float64.
 * @param row_count     [in] vertices of the level that the map starts from.
 * @param channel_count [in] values a vertex, 1 to 4096.
 * @param dst           [out] room for capacity rows of channel_count, or null with capacity 0.
 * @param capacity      [in] rows that dst holds.
 * @param count         [out] may be null; vertices of the level that the map ends at.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 *         MIEN_E_MISMATCH (row_count), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(non-zeroes x channel_count)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_apply(const mien_hierarchy *hierarchy, uint32_t level,
                                                    int32_t direction, const double *values,
                                                    uint64_t row_count, uint64_t channel_count, double *dst,
                                                    uint64_t capacity, uint64_t *count, mien_error *error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param hierarchy [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_hierarchy_retain(mien_hierarchy *hierarchy);

/**
 * Gives one reference back; the last one frees the hierarchy.
 *
 * @param hierarchy [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_hierarchy_release(mien_hierarchy *hierarchy);

/**
 * Carries an expression from one face to another by deformation transfer.
 *
 * @param session           [in] not null.
 * @param source_neutral    [in] not null; #V vertices, mm.
 * @param source_expression [in] not null; the same person with the expression.
 * @param target_neutral    [in] not null; #V vertices, mm; its triangles hold for all.
 * @param out               [out] not null; the target with the expression, or null on failure.
 * @param error             [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_SOLUTION,
 *         MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   one sparse factorisation of size #V
 * @since  0.1
 * @source Sumner & Popovic 2004; kosk-2024 5.2.3
 */
MIEN_API mien_status MIEN_CALL mien_transfer_expression(mien_session *session,
                                                        const mien_mesh *source_neutral,
                                                        const mien_mesh *source_expression,
                                                        const mien_mesh *target_neutral, mien_mesh **out,
                                                        mien_error *error);

/** Initialise with mien_blendshape_options_init(). */
typedef struct mien_blendshape_options {
    uint32_t struct_size;
    uint32_t reserved; /**< zero */
    double ridge;      /**< of the kernel's mean diagonal; default 0: by leave-one-out error */
    mien_progress_fn progress; /**< may be null */
    void *progress_user;
    mien_cancel *cancel; /**< may be null */
} mien_blendshape_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_blendshape_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_blendshape_options_init(mien_blendshape_options *options, size_t struct_size);

/**
 * Learns to predict one expression from the neutral face, on every subject of a dataset that has both.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; a dataset file whose names include "neutral".
 * @param expression   [in] UTF-8, not null; a name of the dataset.
 * @param options      [in] may be null.
 * @param out          [out] not null; the model, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge), MIEN_E_NOT_FOUND (expression),
 *         MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
 *         MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_blendshape_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   96 bytes a vertex and subject; a sparse factorisation a subject
 * @since  0.1
 * @source kosk-2024 5.3, with kernel ridge regression in the place of the networks
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_train(mien_session *session, const char *dataset_path,
                                                           const char *expression,
                                                           const mien_blendshape_options *options,
                                                           mien_blendshape_model **out, mien_error *error);

/**
 * Opens a blendshape model file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 *         MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_blendshape_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_load(mien_session *session, const char *path,
                                                          mien_blendshape_model **out, mien_error *error);

/**
 * Writes a blendshape model file (safetensors). Atomic.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   96 bytes a vertex and subject
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_save(mien_session *session,
                                                          const mien_blendshape_model *model,
                                                          const char *path, mien_error *error);

/**
 * The mean of the neutral training faces, centred: the mesh that a basis for this model is built on.
 *
 * @param model [in] not null.
 * @param out   [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V + #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_get_mean(const mien_blendshape_model *model,
                                                              mien_mesh **out, mien_error *error);

/**
 * A person's expression from the neutral face, in its frame.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param basis   [in] may be null: then k = 0 gives the deformations' prediction, any other k the coordinates'.
 * @param k       [in] low frequencies from the coordinates' prediction, high ones from the deformations';
 *                0 to the basis' modes, #V or more: coordinates alone.
 * @param neutral [in] not null; #V vertices, mm.
 * @param out     [out] not null; the predicted expression, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts), MIEN_E_NO_SOLUTION,
 *         MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(subjects x #V) and one sparse factorisation
 * @since  0.1
 * @source kosk-2024 5.10
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_predict(mien_session *session,
                                                             const mien_blendshape_model *model,
                                                             const mien_spectral_basis *basis, uint64_t k,
                                                             const mien_mesh *neutral, mien_mesh **out,
                                                             mien_error *error);

/** One tried k of mien_blendshape_model_search(). */
typedef struct mien_band_choice {
    uint64_t k;
    double l1_mm;
    double dame;
    double fmpd;
    int32_t on_front; /**< 1: no other k is better in both L1 and FMPD */
    int32_t chosen;   /**< 1: the front's knee */
} mien_band_choice;

/**
 * Tries values of k on a dataset's subjects that the model was not trained on.
 *
 * @param session      [in] not null.
 * @param model        [in] not null.
 * @param basis        [in] not null.
 * @param dataset_path [in] UTF-8, not null; subjects with a neutral face and the expression.
 * @param expression   [in] UTF-8, not null.
 * @param candidates   [in] not null; candidate_count values of k; above the basis' modes: coordinates alone.
 * @param candidate_count [in] 1 to 10000.
 * @param options      [in] may be null; its ridge is not read.
 * @param choices      [out] not null; candidate_count results.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression), MIEN_E_MISMATCH, MIEN_E_IO,
 *         MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   a prediction a subject, an assembly and two metrics a candidate
 * @since  0.1
 * @source kosk-2024 5.3.4, figure 5.8
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_search(
    mien_session *session, const mien_blendshape_model *model, const mien_spectral_basis *basis,
    const char *dataset_path, const char *expression, const uint64_t *candidates, uint32_t candidate_count,
    const mien_blendshape_options *options, mien_band_choice *choices, mien_error *error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_blendshape_model_retain(mien_blendshape_model *model);

/**
 * Gives one reference back; the last one frees the model.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_blendshape_model_release(mien_blendshape_model *model);

#ifdef __cplusplus
}
#endif
#endif

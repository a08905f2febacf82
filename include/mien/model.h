/* Mien: deformation models, how a template may move. */
#ifndef MIEN_MODEL_H
#define MIEN_MODEL_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A template with its modes of deformation: u(x) = mean(x) + sum_j basis_j(x) a_j + sum_k
 * mode_k(x) c_k, a and c standard normal; basis_j are scalar and serve x, y and z, mode_k come from
 * faces. Built or loaded once. Immutable: share freely between threads. */
typedef struct mien_model mien_model;

/** Kernels: what makes two vertices of the template move alike. */
enum {
    MIEN_KERNEL_NONE = 0,         /**< no kernel: modes from faces alone (needs pca_dataset) */
    MIEN_KERNEL_EUCLIDEAN_SE = 1, /**< squared exponential of the straight distance */
    MIEN_KERNEL_GEODESIC_SE = 2,  /**< of the distance along the surface: mouth and eyes may open */
    MIEN_KERNEL_BSPLINE = 3,      /**< cubic B-splines on a grid in space */
    MIEN_KERNEL_SURFACE_MATERN =
        4 /**< Matern along the surface, positive definite by construction */
};

/** What the heat of the heat method does at borders of the template. */
enum {
    MIEN_HEAT_NEUMANN = 1,   /**< stays inside */
    MIEN_HEAT_DIRICHLET = 2, /**< is cooled to zero */
    MIEN_HEAT_AVERAGE = 3    /**< half of each */
};

/** One more kernel of a sum. */
typedef struct mien_kernel {
    int32_t kind;     /**< MIEN_KERNEL_..., not NONE */
    int32_t reserved; /**< zero */
    double sigma_mm;
    double scale_mm;
    double nu; /**< read for SURFACE_MATERN only */
} mien_kernel;

/** A named vertex of the template. */
typedef struct mien_landmark {
    const char* name; /**< UTF-8, not null */
    uint32_t vertex;
    uint32_t reserved; /**< zero */
} mien_landmark;

/** Where a landmark was seen. */
typedef struct mien_landmark_observation {
    const char* name;   /**< of a landmark of the model; null: `vertex` says which */
    uint32_t vertex;    /**< read when name is null */
    uint32_t reserved;  /**< zero */
    double position[3]; /**< mm, in the frame of the template */
    double noise_mm;    /**< standard deviation of each coordinate, >= 0.000001 */
} mien_landmark_observation;

/** Initialise with mien_model_options_init(). */
typedef struct mien_model_options {
    uint32_t struct_size;
    int32_t kernel;    /**< MIEN_KERNEL_..., default GEODESIC_SE */
    double sigma_mm;   /**< length scale; full width for BSPLINE; > 0, default 20 */
    double scale_mm;   /**< standard deviation of a displacement's coordinate; > 0, default 3 */
    double nu;         /**< smoothness of SURFACE_MATERN, 0.1 to 20, default 2 */
    int32_t levels;    /**< 1 to 12, default 1: sum of kernels with sigma, 2 sigma, 4 sigma, ... */
    int32_t num_modes; /**< deformation modes at most, 3 per scalar mode; >= 3, default 999 */
    const mien_kernel* kernels; /**< kernel_count kernels added to the one above; may be null */
    uint64_t kernel_count;
    double tolerance;           /**< > 0: stop once this share of the variance is left; default 0 */
    int32_t num_control_points; /**< default 0: max(1000, num_modes), never more than #V */
    int32_t mirror_symmetric;   /**< 1: modes purely even or odd about the plane x = 0; default 0 */
    double mirror_correlation;  /**< 0 to 1: how much both sides are expected to move alike; default
                                   0 */
    double eigenvalue_threshold; /**< eigenvalues among the control points below this share of the
                                    largest are dropped; 0 < x < 1, default 0.0001 */
    double heat_time_factor; /**< heat time in units of (mean edge)^2, 0.01 to 10000, default 4 */
    int32_t heat_boundary;   /**< MIEN_HEAT_..., default NEUMANN */
    int32_t pca_modes;       /**< default 0: as many as pca_variance asks for */
    const char* pca_dataset; /**< UTF-8 path of a dataset of registered faces, or null: adds their
                                mean and principal modes; the kernel then stands for what they leave
                                over: of three people or more, for what they leave of people left
                                out (info pca_left_out_mm of the model's JSON) */
    double pca_variance;     /**< share of the faces' variance kept, 0 to 1, default 0.999 */
    int32_t pca_all_expressions; /**< 1 (default): all faces, 0: neutral ones */
    int32_t pca_align; /**< 1: move each face rigidly onto the template first; default 0 */
    mien_array_view
        scale_per_vertex;           /**< #V x 1 factors >= 0 of scale_mm; count 0: one everywhere */
    const mien_landmark* landmarks; /**< landmark_count; may be null */
    uint64_t landmark_count;
    const mien_zone* zones; /**< zone_count; may be null */
    uint64_t zone_count;
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_model_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_model_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_model_options_init(mien_model_options* options, size_t struct_size);

/**
 * Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also
 * the mean and the principal modes of its faces.
 *
 * @param session       [in] not null.
 * @param template_mesh [in] not null; #V x 3, mm, with triangles for the surface kernels.
 * @param options       [in] may be null: geodesic kernel of 20 mm, 999 modes.
 * @param out           [out] not null; the model, or null on failure.
 * @param error         [out] may be null; detail_index is the first offending vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not
 * symmetric), MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO,
 * MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V m^2 + m^3) for m control points, about 20 #V m bytes; same bits for any thread count
 * @since  0.1
 * @source jousse-2022 (2.5)-(2.12), (2.15)-(2.22); departures in src/model/low_rank.hpp
 */
MIEN_API mien_status MIEN_CALL mien_model_build(mien_session* session,
                                                const mien_mesh* template_mesh,
                                                const mien_model_options* options, mien_model** out,
                                                mien_error* error);

/**
 * Loads a model file through a memory map and checks all of it: structure, hash, finite values.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
 *         MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_model_release(); the file must stay as it is until
 * then
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_load(mien_session* session, const char* path,
                                               mien_model** out, mien_error* error);

/**
 * Loads a model from the bytes of a model file that the host holds in memory, e.g. as a resource of
 * its program. They are copied and checked like a file.
 *
 * @param session [in] not null.
 * @param data    [in] not null; size bytes, any alignment; not read after the call.
 * @param size    [in] of the whole file, bytes.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 * MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(size), and as much memory
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_load_memory(mien_session* session, const void* data,
                                                      uint64_t size, mien_model** out,
                                                      mien_error* error);

/**
 * Loads a model file that the host trusts: its structure is checked, its hash and values are not.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
 * MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_model_release(); the file must stay as it is until
 * then
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V + #F); the basis is read from the file when it is used
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_load_trusted(mien_session* session, const char* path,
                                                       mien_model** out, mien_error* error);

/**
 * Writes a model file (safetensors). Atomic: a full disk or a crash leaves an old file whole.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size), about 4 #V bytes per scalar mode
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_save(mien_session* session, const mien_model* model,
                                               const char* path, mien_error* error);

/**
 * Numbers of vertices and modes.
 *
 * @param model        [in] not null.
 * @param vertex_count [out] may be null; #V.
 * @param scalar_modes [out] may be null; columns of the scalar basis; 3 times as many deformation
 * modes.
 * @param vector_modes [out] may be null; modes trained on faces.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_get_counts(const mien_model* model,
                                                     uint64_t* vertex_count, uint64_t* scalar_modes,
                                                     uint64_t* vector_modes, mien_error* error);

/**
 * What the model is: counts, kernel and its settings, rank, variance explained, largest pointwise
 * variance error, clipped negative mass, names of landmarks and zones. As JSON text by the two-call
 * protocol.
 *
 * @param model    [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size of the text)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_get_json(const mien_model* model, char* dst,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error);

/**
 * Prior variance of each coordinate of each vertex, #V x 3 float64, mm^2, modes of both kinds
 * together.
 *
 * @param model    [in] not null.
 * @param dst      [out] room for capacity rows of 3, or null.
 * @param capacity [in] rows that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V x modes) when dst is given
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_model_get_variance(const mien_model* model, double* dst,
                                                       uint64_t capacity, uint64_t* count,
                                                       mien_error* error);

/**
 * A random face: the template moved by the mean and `strength` times a draw from the prior. Face
 * `index` of `seed` is the same whatever else was drawn; strength 0 gives the mean.
 *
 * @param session  [in] not null.
 * @param model    [in] not null.
 * @param seed     [in] any number.
 * @param index    [in] any number.
 * @param strength [in] >= 0; 1: the prior itself.
 * @param out      [out] not null; #V vertices in mm with the template's triangles, or null on
 * failure.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V x modes)
 * @since  0.1
 * @source jousse-2022 (2.3)
 */
MIEN_API mien_status MIEN_CALL mien_model_sample(mien_session* session, const mien_model* model,
                                                 uint64_t seed, uint64_t index, double strength,
                                                 mien_mesh** out, mien_error* error);

/**
 * The posterior model: what the template may still do once landmarks were seen. It is a model like
 * any other, with a mean of its own, and may be conditioned again.
 *
 * @param session           [in] not null.
 * @param model             [in] not null; built without mirror correlation.
 * @param observations      [in] not null; observation_count of them.
 * @param observation_count [in] 1 to 100000.
 * @param out               [out] not null; the posterior, or null on failure.
 * @param error             [out] may be null; detail_index is the first offending observation.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (name),
 * MIEN_E_UNSUPPORTED_OPTION (mirror correlation), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V r (h + r)) for r scalar modes and h observations
 * @since  0.1
 * @source jousse-2022 (2.13)-(2.14), with one noise per landmark; see src/model/posterior.hpp
 */
MIEN_API mien_status MIEN_CALL mien_model_condition(mien_session* session, const mien_model* model,
                                                    const mien_landmark_observation* observations,
                                                    uint64_t observation_count, mien_model** out,
                                                    mien_error* error);

/** A finished search for a kernel's settings. Immutable. */
typedef struct mien_tuning mien_tuning;

/** Initialise with mien_tune_options_init(). */
typedef struct mien_tune_options {
    uint32_t struct_size;
    int32_t kernel;                 /**< MIEN_KERNEL_..., not NONE; default GEODESIC_SE */
    const double* sigmas_mm;        /**< not null; sigma_count length scales to try, each > 0 */
    uint64_t sigma_count;           /**< 1 to 10000 */
    double scale_mm;                /**< > 0, default 1 */
    double nu;                      /**< default 2 */
    double rho;                     /**< weight of the prior in the fits, >= 0, default 5 */
    int32_t levels;                 /**< 1 to 12, default 1 */
    int32_t num_modes;              /**< deformation modes, >= 3, default 999 */
    const char* const* expressions; /**< expression_count names: these faces only; null: all */
    uint32_t expression_count;
    int32_t max_subjects;      /**< of the dataset's order; 0 (default): all */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel;         /**< may be null */
    const double* scales_mm;     /**< scale_count scales to try with each sigma, each > 0; null:
                                    scale_mm     alone */
    uint64_t scale_count;        /**< sigmas x scales x levels: at most 10000 */
    const int32_t* level_counts; /**< level_count numbers of levels to try with each of those, each
                                    1 to 12; null: `levels` alone */
    uint64_t level_count;        /**< at most 12 */
} mien_tune_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_tune_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_tune_options_init(mien_tune_options* options, size_t struct_size);

/**
 * Fits faces of known correspondence with a kernel of each length scale, and of each scale and
 * number of levels that is asked for, and reports what is left.
 *
 * @param session       [in] not null.
 * @param template_mesh [in] not null; #V x 3, mm.
 * @param dataset       [in] UTF-8 path of a dataset in the template's correspondence, not null; its
 * faces may cover only the template's first vertices.
 * @param options       [in] not null; sigmas_mm at least.
 * @param out           [out] not null; the tuning, or null on failure.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND
 * (expression), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_tuning_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   geodesics or eigenpairs once, then per combination O(#V m^2 + m^3) for m control points
 * @since  0.1
 * @source jousse-2022 2.6.1, (2.38)-(2.39)
 */
MIEN_API mien_status MIEN_CALL mien_model_tune(mien_session* session,
                                               const mien_mesh* template_mesh, const char* dataset,
                                               const mien_tune_options* options, mien_tuning** out,
                                               mien_error* error);

/**
 * Residuals as JSON text by the two-call protocol: best_sigma_mm, best_scale_mm, best_levels and,
 * per combination, its sigma, scale and levels, and mean, deviation and every face's residual norm
 * in mm.
 *
 * @param tuning   [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size of the text)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_tuning_get_json(const mien_tuning* tuning, char* dst,
                                                    uint64_t capacity, uint64_t* count,
                                                    mien_error* error);

/**
 * Releases a tuning.
 *
 * @param tuning [in] may be null.
 * @errors none
 * @owner  *tuning is gone afterwards
 * @thread no other call may use the tuning
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_tuning_release(mien_tuning* tuning);

/**
 * The template.
 *
 * @param model [in] may be null.
 * @errors none; null for a null or wrong handle
 * @owner  the mesh belongs to the model and is valid until its last reference is released; retain
 * it to keep it longer
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API const mien_mesh* MIEN_CALL mien_model_mesh(const mien_model* model);

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
MIEN_API void MIEN_CALL mien_model_retain(mien_model* model);

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
MIEN_API void MIEN_CALL mien_model_release(mien_model* model);

#ifdef __cplusplus
}
#endif
#endif

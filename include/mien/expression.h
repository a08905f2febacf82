/* Mien: expression models and neutralization. */
#ifndef MIEN_EXPRESSION_H
#define MIEN_EXPRESSION_H

#include "registration.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What was learned of faces and expressions: an identity subspace, an expression subspace, a prior of
 *  both. Immutable: share freely between threads. */
typedef struct mien_expression_model mien_expression_model;

/** A neutralized face. Immutable: share freely between threads. */
typedef struct mien_neutralization mien_neutralization;

/** Errors of neutralization over a dataset. Immutable: share freely between threads. */
typedef struct mien_evaluation mien_evaluation;

/** Several scans of one person, neutralized together. Immutable: share freely between threads. */
typedef struct mien_series mien_series;

/** How the two subspaces are found. */
enum {
    MIEN_TRAIN_JPCA = 0,  /**< joint PCA */
    MIEN_TRAIN_QOJPCA = 1 /**< quasi-orthogonal joint PCA */
};

/** How a face is taken apart into identity and expression. */
enum {
    MIEN_FIT_MIXTURE = 0,    /**< prior of one of a few expressions; the default and the best */
    MIEN_FIT_MAP = 1,        /**< Gaussian priors */
    MIEN_FIT_EXACT = 2,      /**< joint least squares without a prior */
    MIEN_FIT_ALTERNATING = 3 /**< block relaxation, for reproduction */
};

/** Where a face lies against the training faces. */
enum {
    MIEN_POSE_AUTO = 0,  /**< on the model's stable zone where it has one; else rigid when the face lies more
                              than 3 degrees or 8 mm away from the mean face and a rigid motion explains it
                              clearly better, else kept */
    MIEN_POSE_KEEP = 1,  /**< in the training's frame */
    MIEN_POSE_RIGID = 2  /**< anywhere: a rigid motion is fitted together with the face */
};

/** Initialise with mien_train_options_init(). */
typedef struct mien_train_options {
    uint32_t struct_size;
    int32_t method;           /**< MIEN_TRAIN_..., default MIEN_TRAIN_JPCA */
    int32_t identity_modes;   /**< 1 to 4000, default 50 */
    int32_t expression_modes; /**< 1 to 4000, default 50 */
    int32_t max_iterations;   /**< QOJPCA; default 1000 */
    int32_t passes;           /**< over the data, 1 to 50, default 4 */
    double lambda;            /**< QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX' */
    double lambda_factor;     /**< default 10 */
    double angle_tolerance_rad; /**< QOJPCA stops when no subspace turns farther; default 0.001 */
    double noise_mm2;         /**< noise variance of the fits; 0 (default): by cross-validation */
    const uint32_t *stable_vertices; /**< posture: every face is aligned rigidly on these vertices (forehead,
                                          nose bridge), in training and in every fit; null: faces as they lie */
    uint64_t stable_count;
    mien_progress_fn progress;  /**< may be null */
    void *progress_user;
    mien_cancel *cancel;        /**< may be null */
} mien_train_options;

/** Initialise with mien_neutralize_options_init(). */
typedef struct mien_neutralize_options {
    uint32_t struct_size;
    int32_t method;          /**< MIEN_FIT_..., default MIEN_FIT_MIXTURE */
    int32_t max_sweeps;      /**< alternating; 1 to 100000, default 200 */
    int32_t uncertainty;     /**< 1: compute the deviation per vertex; default 0 */
    int32_t pose;            /**< MIEN_POSE_..., default MIEN_POSE_AUTO */
    uint32_t reserved;       /**< zero */
    double tolerance_mm;     /**< alternating: stop when a sweep moves less; default 1e-6 */
    double noise_mm2;        /**< 0 (default): the model's own */
    double decay_mm;         /**< how far a displacement reaches beyond the model's rim; default 25 */
    mien_array_view weights; /**< #V x 1, >= 0: 0 where the scan had no data; count 0: all one */
    mien_progress_fn progress;  /**< may be null */
    void *progress_user;
    mien_cancel *cancel;        /**< may be null */
} mien_neutralize_options;

/** Initialise with mien_shard_options_init(). */
typedef struct mien_shard_options {
    uint32_t struct_size;
    int32_t part;       /**< 0 to part_count - 1, default 0: which subjects */
    int32_t part_count; /**< default 1: all subjects */
    int32_t max_rank;   /**< of identities and of expressions, default 512; parts with fewer subjects and
                             faces are exact */
    mien_progress_fn progress; /**< may be null */
    void *progress_user;
    mien_cancel *cancel;       /**< may be null */
} mien_shard_options;

/** Initialise with mien_series_options_init(). */
typedef struct mien_series_options {
    uint32_t struct_size;
    int32_t method;            /**< MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP */
    int32_t pose;              /**< MIEN_POSE_..., default MIEN_POSE_AUTO */
    uint32_t reserved;         /**< zero */
    double scan_noise_share;   /**< what differs between scans beyond the model, as a share of the noise
                                    variance; default 0.01 */
    double noise_mm2;          /**< noise variance; 0 (default): the model's own */
    const uint32_t *changing_vertices; /**< where the identity may change between scans; null: nowhere */
    uint64_t changing_count;
    double expected_change_mm; /**< there; default 5 */
    mien_progress_fn progress; /**< may be null */
    void *progress_user;
    mien_cancel *cancel;       /**< may be null */
} mien_series_options;

/** Initialise with mien_evaluate_options_init(). */
typedef struct mien_evaluate_options {
    uint32_t struct_size;
    int32_t method;             /**< MIEN_FIT_..., default MIEN_FIT_MIXTURE */
    int32_t max_sweeps;         /**< of the method; default 200 */
    int32_t against_method;     /**< MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING */
    int32_t against_max_sweeps; /**< default 3 */
    uint32_t reserved;          /**< zero */
    const mien_expression_model *against; /**< second model to compare with; may be null */
    const uint32_t *zone_vertices;   /**< measure on these vertices only; null: all */
    uint64_t zone_count;
    const uint32_t *stable_vertices; /**< align every face rigidly to its target on these first; null: not */
    uint64_t stable_count;
    mien_progress_fn progress;       /**< may be null */
    void *progress_user;
    mien_cancel *cancel;             /**< may be null */
} mien_evaluate_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_train_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_train_options_init(mien_train_options *options, size_t struct_size);

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_neutralize_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_neutralize_options_init(mien_neutralize_options *options, size_t struct_size);

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_evaluate_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_evaluate_options_init(mien_evaluate_options *options, size_t struct_size);

/**
 * Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral".
 * The faces are read through a memory map in blocks, so the file may be larger than memory. Subjects
 * without a neutral face are left out; missing expressions and repeated captures are fine.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null.
 * @param options      [in] may be null: defaults.
 * @param out          [out] not null; the model, or null on failure.
 * @param error        [out] may be null; detail_index is the first damaged face.
 * @errors MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn), MIEN_E_IO, MIEN_E_BAD_FORMAT,
 *         MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(passes faces #V modes) time, about 72 #V (modes + 100) bytes
 * @since  0.1
 * @source jousse-2022 (4.11), (4.28)-(4.31); the mixture prior and the noise level are this library's own
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_train(mien_session *session, const char *dataset_path,
                                                           const mien_train_options *options,
                                                           mien_expression_model **out, mien_error *error);

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_shard_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_shard_options_init(mien_shard_options *options, size_t struct_size);

/**
 * Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are
 * made by subject, every part_count-th of the sorted subject numbers.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null.
 * @param options      [in] may be null: the whole dataset.
 * @param shard_path   [in] UTF-8, not null; written atomically.
 * @param error        [out] may be null.
 * @errors as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or is empty
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(faces #V rank)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_shard_create(mien_session *session, const char *dataset_path,
                                                            const mien_shard_options *options,
                                                            const char *shard_path, mien_error *error);

/**
 * Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to
 * cut its rank.
 *
 * @param session     [in] not null.
 * @param shard_paths [in] not null; shard_count UTF-8 paths.
 * @param shard_count [in] 1 to 1000000.
 * @param options     [in] may be null: defaults. stable_vertices must be empty.
 * @param out         [out] not null; the model, or null on failure.
 * @param error       [out] may be null.
 * @errors as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different topologies or
 *         expression names), MIEN_E_INVALID_ARGUMENT (a subject in two shards)
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(passes faces #V rank)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_merge(mien_session *session,
                                                           const char *const *shard_paths,
                                                           uint32_t shard_count,
                                                           const mien_train_options *options,
                                                           mien_expression_model **out, mien_error *error);

/**
 * Loads a model file. The file is treated as hostile; the modes stay in the mapped file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT,
 *         MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_load(mien_session *session, const char *path,
                                                          mien_expression_model **out, mien_error *error);

/**
 * Loads a model from the bytes of a model file that the host holds in memory. They are copied and checked
 * like a file.
 *
 * @param session [in] not null.
 * @param data    [in] not null; size bytes, any alignment; not read after the call.
 * @param size    [in] of the whole file, bytes.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
 *         MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(size), and as much memory
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_load_memory(mien_session *session, const void *data,
                                                                 uint64_t size, mien_expression_model **out,
                                                                 mien_error *error);

/**
 * Writes a model file (safetensors, kind "mien-expression-model"). Atomic.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_save(mien_session *session,
                                                          const mien_expression_model *model,
                                                          const char *path, mien_error *error);

/**
 * Adds a reference.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  each retain needs one release
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_expression_model_retain(mien_expression_model *model);

/**
 * Drops a reference; the last one frees the model. Neutralizations keep what they need.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_expression_model_release(mien_expression_model *model);

/**
 * Numbers of vertices and modes.
 *
 * @param model            [in] not null.
 * @param vertex_count     [out] may be null; #V.
 * @param identity_modes   [out] may be null.
 * @param expression_modes [out] may be null.
 * @param error            [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_get_counts(const mien_expression_model *model,
                                                                uint64_t *vertex_count,
                                                                uint32_t *identity_modes,
                                                                uint32_t *expression_modes,
                                                                mien_error *error);

/**
 * What the model is, and after training how the training went, as a JSON object: sizes, expressions,
 * noise levels, iterations, orthogonality score per number of components, explained shares.
 *
 * @param model    [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_get_json(const mien_expression_model *model, char *dst,
                                                              uint64_t capacity, uint64_t *count,
                                                              mien_error *error);

/**
 * A face made from coordinates: mean + identity modes x identity + expression modes x expression.
 *
 * @param session    [in] not null.
 * @param model      [in] not null.
 * @param identity   [in] count identity_modes, F32 or F64, mm; count 0 (or null): the mean identity.
 * @param expression [in] count expression_modes, F32 or F64, mm; count 0 (or null): neutral.
 * @param out        [out] not null; the mesh, or null on failure.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V modes)
 * @since  0.1
 * @source jousse-2022 4.2
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_synthesize(mien_session *session,
                                                                const mien_expression_model *model,
                                                                const mien_array_view *identity,
                                                                const mien_array_view *expression,
                                                                mien_mesh **out, mien_error *error);

/**
 * A random face of the model: identity coordinates from their Gaussian, expression coordinates from the
 * prior of one expression.
 *
 * @param session    [in] not null.
 * @param model      [in] not null.
 * @param seed       [in] any number; the same seed gives the same face on every machine.
 * @param expression [in] name of an expression of the model, "neutral", "any" (all expressions together),
 *                   or null: neutral without any expression.
 * @param out        [out] not null; the mesh, or null on failure.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V modes)
 * @since  0.1
 * @source jousse-2022 4.2, figure 4.4
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_sample(mien_session *session,
                                                            const mien_expression_model *model,
                                                            uint64_t seed, const char *expression,
                                                            mien_mesh **out, mien_error *error);

/**
 * mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is
 * that of the scan. options.weights, where given, replace the registration's.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param fitted  [in] not null; registered with the template of the model's training faces.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the result in the scan's frame, or null on failure.
 * @param error   [out] may be null; detail_index is the first offending weight.
 * @errors as mien_neutralize_mesh()
 * @owner  the caller releases *out with mien_neutralization_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V modes^2)
 * @since  0.1
 * @source as mien_neutralize_mesh()
 */
MIEN_API mien_status MIEN_CALL mien_neutralize(mien_session *session, const mien_expression_model *model,
                                               const mien_registration *fitted,
                                               const mien_neutralize_options *options,
                                               mien_neutralization **out, mien_error *error);

/**
 * Takes the expression off a face and keeps everything that the model does not explain.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param face    [in] not null; in the model's topology, or in a larger one that begins with it (there
 *                the displacement runs out smoothly behind the model's rim); mm.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the result, or null on failure.
 * @param error   [out] may be null; detail_index is the first offending weight.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology, weights),
 *         MIEN_E_NO_SOLUTION (MIEN_FIT_EXACT with too little of the face visible), MIEN_E_NO_MEMORY,
 *         MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_neutralization_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V modes); with weights O(#V modes^2)
 * @since  0.1
 * @source jousse-2022 (4.14), (4.15), Algorithm 2 for MIEN_FIT_ALTERNATING; the priors are this library's own
 */
MIEN_API mien_status MIEN_CALL mien_neutralize_mesh(mien_session *session,
                                                    const mien_expression_model *model,
                                                    const mien_mesh *face,
                                                    const mien_neutralize_options *options,
                                                    mien_neutralization **out, mien_error *error);

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_series_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_series_options_init(mien_series_options *options, size_t struct_size);

/**
 * Neutralizes several scans of one person together: one identity, an expression each.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param faces   [in] not null; face_count faces in the model's topology.
 * @param face_count [in] 1 to 1000.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the result, or null on failure.
 * @param error   [out] may be null.
 * @errors as mien_neutralize_mesh()
 * @owner  the caller releases *out with mien_series_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(K^2 #V modes), with changing vertices O(K^2 #V modes^2); K faces
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_neutralize_series(mien_session *session,
                                                      const mien_expression_model *model,
                                                      const mien_mesh *const *faces, uint32_t face_count,
                                                      const mien_series_options *options,
                                                      mien_series **out, mien_error *error);

/**
 * The neutral mesh of one face of a series, in that face's frame; or the person's shared one.
 *
 * @param series [in] not null.
 * @param index  [in] 0 to face_count - 1, or -1: the shared neutral face, in the training's frame.
 * @param out    [out] not null; the mesh, or null on failure.
 * @param error  [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_series_get_mesh(const mien_series *series, int32_t index,
                                                    mien_mesh **out, mien_error *error);

/**
 * Releases a series.
 *
 * @param series [in] may be null.
 * @errors none
 * @owner  *series is gone afterwards; meshes taken from it stay
 * @thread no other call may use it
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_series_release(mien_series *series);

/**
 * Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and texture of
 * the scan stay. Parts far from the template move rigidly with their neighbourhood.
 *
 * @param session         [in] not null.
 * @param neutralization  [in] not null; of a face that was fitted to this scan.
 * @param scan            [in] not null; in the frame of the face.
 * @param max_distance_mm [in] how far from the fitted face a vertex takes its displacement; 0: 6 mm.
 * @param out             [out] not null; the moved scan, or null on failure.
 * @param error           [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#scan log #V) and one sparse solve
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_neutralization_apply_to_scan(mien_session *session,
                                                                 const mien_neutralization *neutralization,
                                                                 const mien_mesh *scan,
                                                                 double max_distance_mm, mien_mesh **out,
                                                                 mien_error *error);

/**
 * Puts the expression of one neutralized face onto another one's neutral face.
 *
 * @param session [in] not null.
 * @param model   [in] not null; the model of both neutralizations.
 * @param source  [in] not null; whose expression is taken.
 * @param target  [in] not null; whose neutral face receives it.
 * @param out     [out] not null; the mesh in the target's topology and frame, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (another model), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V modes)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_transfer(mien_session *session,
                                                              const mien_expression_model *model,
                                                              const mien_neutralization *source,
                                                              const mien_neutralization *target,
                                                              mien_mesh **out, mien_error *error);

/**
 * Neutralizes every face of a dataset whose subject has a neutral face, and compares.
 *
 * @param session      [in] not null.
 * @param model        [in] not null; in the dataset's topology.
 * @param dataset_path [in] UTF-8, not null.
 * @param options      [in] may be null: defaults.
 * @param out          [out] not null; the evaluation, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 *         MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_evaluation_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(faces #V modes)
 * @since  0.1
 * @source jousse-2022 4.4, table 4.2; (4.32)-(4.34) in their textbook forms
 */
MIEN_API mien_status MIEN_CALL mien_evaluate_neutralization(mien_session *session,
                                                            const mien_expression_model *model,
                                                            const char *dataset_path,
                                                            const mien_evaluate_options *options,
                                                            mien_evaluation **out, mien_error *error);

/**
 * The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each with
 * faces, baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d, superiority.
 *
 * @param evaluation [in] not null.
 * @param dst        [out] room for capacity bytes, or null.
 * @param capacity   [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count      [out] may be null; bytes with the terminating zero.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_evaluation_get_json(const mien_evaluation *evaluation, char *dst,
                                                        uint64_t capacity, uint64_t *count,
                                                        mien_error *error);

/**
 * Releases an evaluation.
 *
 * @param evaluation [in] may be null.
 * @errors none
 * @owner  *evaluation is gone afterwards
 * @thread no other call may use it
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_evaluation_release(mien_evaluation *evaluation);

/**
 * The neutral face with the triangles, colours and texture of the input, borrowed.
 *
 * @param neutralization [in] may be null.
 * @errors none (null for a null or released handle)
 * @owner  the neutralization; valid until it is released. mien_mesh_retain() keeps it longer.
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API const mien_mesh *MIEN_CALL mien_neutralization_mesh(const mien_neutralization *neutralization);

/**
 * Coordinates of the face in the model, mm along the unit modes.
 *
 * @param neutralization [in] not null.
 * @param identity       [out] room for identity_modes doubles of the model, or null.
 * @param expression     [out] room for expression_modes doubles of the model, or null.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(modes)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_neutralization_get_coordinates(const mien_neutralization *neutralization,
                                                                   double *identity, double *expression,
                                                                   mien_error *error);

/**
 * Deviation per vertex of the neutral face that comes from not knowing the expression, mm.
 *
 * @param neutralization [in] not null.
 * @param dst            [out] room for capacity doubles, or null.
 * @param capacity       [in] doubles that dst holds; with dst null and 0 only the count is written.
 * @param count          [out] may be null; #V of the face.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without a prior),
 *         MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_neutralization_get_uncertainty(const mien_neutralization *neutralization,
                                                                   double *dst, uint64_t capacity,
                                                                   uint64_t *count, mien_error *error);

/**
 * The report as a JSON object: expression found, its probability and the others', displacement,
 * residual, coordinates.
 *
 * @param neutralization [in] not null.
 * @param dst            [out] room for capacity bytes, or null.
 * @param capacity       [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count          [out] may be null; bytes with the terminating zero.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_neutralization_get_json(const mien_neutralization *neutralization,
                                                            char *dst, uint64_t capacity, uint64_t *count,
                                                            mien_error *error);

/**
 * Releases a neutralization.
 *
 * @param neutralization [in] may be null.
 * @errors none
 * @owner  *neutralization and the mesh it lent are gone afterwards
 * @thread no other call may use it
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_neutralization_release(mien_neutralization *neutralization);

#ifdef __cplusplus
}
#endif
#endif

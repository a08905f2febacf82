/* Mien: training of expression models, whole or in parts. */
#ifndef MIEN_TRAINING_H
#define MIEN_TRAINING_H

#include "expression.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How the two subspaces are found. */
enum {
    MIEN_TRAIN_JPCA = 0,  /**< joint PCA */
    MIEN_TRAIN_QOJPCA = 1 /**< quasi-orthogonal joint PCA */
};

/** Initialise with mien_train_options_init(). */
typedef struct mien_train_options {
    uint32_t struct_size;
    int32_t method;           /**< MIEN_TRAIN_..., default MIEN_TRAIN_JPCA */
    int32_t identity_modes;   /**< 1 to 4000; 0 (default since 0.2, 50 before): of 25, 50, 75 and
                                 100 the fewest that serve people left out of the training */
    int32_t expression_modes; /**< 1 to 4000; 0 (default): as above */
    int32_t max_iterations;   /**< QOJPCA; default 1000 */
    int32_t passes;           /**< over the data, 1 to 50, default 4 */
    double lambda;        /**< QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX' */
    double lambda_factor; /**< default 10 */
    double angle_tolerance_rad; /**< QOJPCA stops when no subspace turns farther; default 0.001 */
    double noise_mm2;           /**< noise variance of the fits; 0 (default): by cross-validation */
    const uint32_t*
        stable_vertices; /**< posture: every face is aligned rigidly on these vertices (forehead,
                              nose bridge), in training and in every fit; null: faces as they lie */
    uint64_t stable_count;
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_train_options;

/** Initialise with mien_shard_options_init(). */
typedef struct mien_shard_options {
    uint32_t struct_size;
    int32_t part;       /**< 0 to part_count - 1, default 0: which subjects */
    int32_t part_count; /**< default 1: all subjects */
    int32_t max_rank; /**< of identities and of expressions, default 512; parts with fewer subjects
                         and faces are exact */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel;             /**< may be null */
    const uint32_t* stable_vertices; /**< as in mien_train_options; all parts of a dataset are
                                        aligned alike; null: faces as they lie */
    uint64_t stable_count;
} mien_shard_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
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
MIEN_API void MIEN_CALL mien_train_options_init(mien_train_options* options, size_t struct_size);

/**
 * Trains an expression model from a dataset file (see dataset.h) with an expression named
 * "neutral". The faces are read through a memory map in blocks, so the file may be larger than
 * memory. Subjects without a neutral face are left out; missing expressions and repeated captures
 * are fine.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null.
 * @param options      [in] may be null: defaults.
 * @param out          [out] not null; the model, or null on failure.
 * @param error        [out] may be null; detail_index is the first damaged face.
 * @errors MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn),
 * MIEN_E_UNSUPPORTED_OPTION (a method that this library does not know), MIEN_E_IO,
 * MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION,
 * MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(passes faces #V modes) time, about 72 #V (modes + 100) bytes
 * @since  0.1
 * @source jousse-2022 (4.11), (4.28)-(4.31); the mixture prior and the noise level are this
 * library's own
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_train(mien_session* session,
                                                           const char* dataset_path,
                                                           const mien_train_options* options,
                                                           mien_expression_model** out,
                                                           mien_error* error);

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
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
MIEN_API void MIEN_CALL mien_shard_options_init(mien_shard_options* options, size_t struct_size);

/**
 * Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler.
 * Parts are made by subject, every part_count-th of the sorted subject numbers.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null.
 * @param options      [in] may be null: the whole dataset.
 * @param shard_path   [in] UTF-8, not null; written atomically.
 * @param error        [out] may be null.
 * @errors as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist
 * or is empty
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(faces #V rank)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_shard_create(mien_session* session,
                                                            const char* dataset_path,
                                                            const mien_shard_options* options,
                                                            const char* shard_path,
                                                            mien_error* error);

/**
 * Trains from shards. Equals training on all their faces at once to rounding, as long as no shard
 * had to cut its rank.
 *
 * @param session     [in] not null.
 * @param shard_paths [in] not null; shard_count UTF-8 paths.
 * @param shard_count [in] 1 to 1000000.
 * @param options     [in] may be null: defaults. stable_vertices must be empty: the shards' own
 * count.
 * @param out         [out] not null; the model, or null on failure.
 * @param error       [out] may be null.
 * @errors as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different
 * topologies, expression names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards)
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(passes faces #V rank)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_merge(
    mien_session* session, const char* const* shard_paths, uint32_t shard_count,
    const mien_train_options* options, mien_expression_model** out, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

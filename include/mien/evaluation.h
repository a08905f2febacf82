/* Mien: how well neutralization works over a dataset. */
#ifndef MIEN_EVALUATION_H
#define MIEN_EVALUATION_H

#include "neutralization.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Errors of neutralization over a dataset. Immutable: share freely between threads. */
typedef struct mien_evaluation mien_evaluation;

/** Initialise with mien_evaluate_options_init(). */
typedef struct mien_evaluate_options {
    uint32_t struct_size;
    int32_t method;         /**< MIEN_FIT_..., default MIEN_FIT_MIXTURE */
    int32_t max_sweeps;     /**< of the method; default 200 */
    int32_t against_method; /**< MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING */
    int32_t against_max_sweeps;           /**< default 3 */
    uint32_t reserved;                    /**< zero */
    const mien_expression_model* against; /**< second model to compare with; may be null */
    const uint32_t* zone_vertices;        /**< measure on these vertices only; null: all */
    uint64_t zone_count;
    const uint32_t*
        stable_vertices; /**< align every face rigidly to its target on these first; null: not */
    uint64_t stable_count;
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel;           /**< may be null */
    const mien_zone* volume_zones; /**< absolute volumes to the neutral face are measured in these,
                                      too; null: none. Since 0.2 */
    uint64_t volume_zone_count;
} mien_evaluate_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
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
MIEN_API void MIEN_CALL mien_evaluate_options_init(mien_evaluate_options* options,
                                                   size_t struct_size);

/**
 * Neutralizes every face of a dataset whose subject has a neutral face, and compares.
 *
 * @param session      [in] not null.
 * @param model        [in] not null; in the dataset's topology.
 * @param dataset_path [in] UTF-8, not null.
 * @param options      [in] may be null: defaults.
 * @param out          [out] not null; the evaluation, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that
 * this library does not know), MIEN_E_MISMATCH, MIEN_E_IO,
 * MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_evaluation_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(faces #V modes)
 * @since  0.1
 * @source jousse-2022 4.4, table 4.2; (4.32)-(4.34) in their textbook forms
 */
MIEN_API mien_status MIEN_CALL mien_evaluate_neutralization(
    mien_session* session, const mien_expression_model* model, const char* dataset_path,
    const mien_evaluate_options* options, mien_evaluation** out, mien_error* error);

/**
 * The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each
 * with faces, baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d,
 * superiority; with options.volume_zones "volumes", the same per zone (mean_ml, sd_ml, median_ml).
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
MIEN_API mien_status MIEN_CALL mien_evaluation_get_json(const mien_evaluation* evaluation,
                                                        char* dst, uint64_t capacity,
                                                        uint64_t* count, mien_error* error);

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
MIEN_API void MIEN_CALL mien_evaluation_release(mien_evaluation* evaluation);

#ifdef __cplusplus
}
#endif
#endif

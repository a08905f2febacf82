/* Mien: one person's faces at several visits, neutralized so that what changed can be measured. */
#ifndef MIEN_VISITS_H
#define MIEN_VISITS_H

#include "neutralization.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One person's faces at several visits, without their expressions. Immutable: share freely between
 * threads. */
typedef struct mien_visits mien_visits;

/** Initialise with mien_visits_options_init(). */
typedef struct mien_visits_options {
    uint32_t struct_size;
    int32_t pose;            /**< MIEN_POSE_..., default MIEN_POSE_AUTO */
    double normal_noise_mm2; /**< variance of a fitted vertex along the skin's normal, with what no
                                mode explains; default 0.3 */
    double tangential_noise_mm2;      /**< along the skin: fits slide; default 30 */
    const uint32_t* treated_vertices; /**< where the person may have changed: no witness of the
                                         expression; null: nowhere */
    uint64_t treated_count;
    mien_array_view weights;   /**< face_count x #V, face by face, >= 0: 0 where a scan had no data;
                                  count 0: all one */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_visits_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_visits_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API void MIEN_CALL mien_visits_options_init(mien_visits_options* options, size_t struct_size);

/**
 * Takes the expressions off faces of one person, first visit first, so that the neutral faces are
 * in correspondence along the skin and differ by what changed. The right road to a volume over
 * time: fitted templates slide along the skin, and mien_neutralize() takes a part of the slide for
 * expression.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param faces   [in] not null; face_count fitted faces, mm, in one topology: the model's, or a
 * larger one that begins with it (there the displacement runs out smoothly behind the model's rim).
 * @param face_count [in] 1 to 200.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the result, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that
 * this library does not know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (topology, weights, treated vertices), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_visits_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(K^2 #V modes^2 / 3); K faces
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 * @source this library's own; see src/expression/joint_fit.hpp
 */
MIEN_API mien_status MIEN_CALL mien_neutralize_visits(
    mien_session* session, const mien_expression_model* model, const mien_mesh* const* faces,
    uint32_t face_count, const mien_visits_options* options, mien_visits** out, mien_error* error);

/**
 * The neutral face of one visit, in the frame of its face.
 *
 * @param visits [in] not null.
 * @param index  [in] 0 to face_count - 1.
 * @param out    [out] not null; the mesh, or null on failure.
 * @param error  [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API mien_status MIEN_CALL mien_visits_get_mesh(const mien_visits* visits, int32_t index,
                                                    mien_mesh** out, mien_error* error);

/**
 * The name of the expression found at one visit.
 *
 * @param visits   [in] not null.
 * @param index    [in] 0 to face_count - 1.
 * @param dst      [out] room for capacity bytes, or null; UTF-8, empty for a model without named
 * expressions.
 * @param capacity [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API mien_status MIEN_CALL mien_visits_get_expression(const mien_visits* visits, int32_t index,
                                                          char* dst, uint64_t capacity,
                                                          uint64_t* count, mien_error* error);

/**
 * What the expressions that were taken off amount to in a volume between two visits, and how surely
 * they are known. A neutral volume carries that doubt beside the doubts of the fits.
 *
 * @param visits     [in] not null.
 * @param first      [in] 0 to face_count - 1.
 * @param second     [in] 0 to face_count - 1.
 * @param zone       [in] may be null: the whole face.
 * @param removed_ml [out] may be null; signed, mL.
 * @param sd_ml      [out] may be null; posterior deviation, mL.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (zone), MIEN_E_NOT_FOUND
 * (a visit), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V modes)
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API mien_status MIEN_CALL mien_visits_get_removed_volume(const mien_visits* visits,
                                                              int32_t first, int32_t second,
                                                              const mien_zone* zone,
                                                              double* removed_ml, double* sd_ml,
                                                              mien_error* error);

/**
 * Releases visits.
 *
 * @param visits [in] may be null.
 * @errors none
 * @owner  *visits is gone afterwards; meshes taken from it stay
 * @thread no other call may use it
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API void MIEN_CALL mien_visits_release(mien_visits* visits);

#ifdef __cplusplus
}
#endif
#endif

/* Mien: several scans of one person, neutralized together. */
#ifndef MIEN_SERIES_H
#define MIEN_SERIES_H

#include "neutralization.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Several scans of one person, neutralized together. Immutable: share freely between threads. */
typedef struct mien_series mien_series;

/** Initialise with mien_series_options_init(). */
typedef struct mien_series_options {
    uint32_t struct_size;
    int32_t method;          /**< MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP */
    int32_t pose;            /**< MIEN_POSE_..., default MIEN_POSE_AUTO */
    uint32_t reserved;       /**< zero */
    double scan_noise_share; /**< what differs between scans beyond the model, as a share of the
                                noise variance; default 0.01 */
    double noise_mm2;        /**< noise variance; 0 (default): the model's own */
    const uint32_t*
        changing_vertices; /**< where the identity may change between scans; null: nowhere */
    uint64_t changing_count;
    double expected_change_mm; /**< > 0, default 5; without effect since 0.2: what lies there is no
                                  witness of the expression at all */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel;     /**< may be null */
    mien_array_view weights; /**< face_count x #V, face by face, >= 0: 0 where a scan had no data;
                                count 0: all one. */
} mien_series_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_series_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API void MIEN_CALL mien_series_options_init(mien_series_options* options, size_t struct_size);

/**
 * Neutralizes several scans of one person together: one identity, an expression each.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param faces   [in] not null; face_count faces in one topology: the model's, or a larger one that
 * begins with it (there the displacement runs out smoothly behind the model's rim).
 * @param face_count [in] 1 to 1000.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the result, or null on failure.
 * @param error   [out] may be null.
 * @errors as mien_neutralize_mesh()
 * @owner  the caller releases *out with mien_series_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(K^2 #V modes), with changing vertices or weights O(K^2 #V modes^2); K faces
 * @since  0.1
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API mien_status MIEN_CALL mien_neutralize_series(
    mien_session* session, const mien_expression_model* model, const mien_mesh* const* faces,
    uint32_t face_count, const mien_series_options* options, mien_series** out, mien_error* error);

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
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API mien_status MIEN_CALL mien_series_get_mesh(const mien_series* series, int32_t index,
                                                    mien_mesh** out, mien_error* error);

/**
 * The report as a JSON object: "faces", a list with each face's expression, residual_rms_mm
 * (distance from its own fit), distance_to_shared_mm (root mean square distance of its neutral face
 * from the shared one, without the changing vertices) and warnings.
 *
 * @param series   [in] not null.
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
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API mien_status MIEN_CALL mien_series_get_json(const mien_series* series, char* dst,
                                                    uint64_t capacity, uint64_t* count,
                                                    mien_error* error);

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
 * @deprecated since 0.2, use mien_study_*
 */
MIEN_API void MIEN_CALL mien_series_release(mien_series* series);

#ifdef __cplusplus
}
#endif
#endif

/* Mien: the measurements of anthropometry, by named landmarks, with deviations and norms. */
#ifndef MIEN_ANTHROPOMETRY_H
#define MIEN_ANTHROPOMETRY_H

#include "landmarks.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The measurements of one face. Immutable: share freely. */
typedef struct mien_anthropometry mien_anthropometry;

/** Mean and deviation of each measurement over the people of a dataset. Immutable: share freely. */
typedef struct mien_norms mien_norms;

/** Kinds of measurements. */
enum {
    MIEN_MEASURE_LENGTH = 1,         /**< straight, mm */
    MIEN_MEASURE_SURFACE_LENGTH = 2, /**< along the skin, mm */
    MIEN_MEASURE_ANGLE = 3,          /**< degrees */
    MIEN_MEASURE_INCLINATION = 4,    /**< signed, of one line against another, degrees */
    MIEN_MEASURE_PROPORTION = 5,     /**< percent */
    MIEN_MEASURE_LINE_OFFSET = 6     /**< signed distance from a line, mm */
};

/** Initialise with mien_anthropometry_options_init(). */
typedef struct mien_anthropometry_options {
    uint32_t struct_size;
    uint32_t reserved;            /**< zero */
    mien_array_view place_sd;     /**< #V, mm: deviation of each vertex' place per axis, as
                                     MIEN_REGISTRATION_STANDARD_DEVIATION_MM tells it; count 0: not
                                     known, and no deviation */
    mien_array_view normal_sd;    /**< #V, mm: along the normal, as
                                     MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: as
                                     place_sd */
    double slide_correlation_mm;  /**< over which a template slides together along the skin; default
                                     15 */
    double normal_correlation_mm; /**< over which it errs together across the skin; default 4 */
    const mien_norms* norms;      /**< may be null: no z-scores */
    mien_progress_fn progress;    /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_anthropometry_options;

/** One measurement of a face. NaN where a number is not known. */
typedef struct mien_anthropometric_value {
    uint32_t struct_size;
    int32_t kind;     /**< MIEN_MEASURE_* */
    double value;     /**< NaN: mien_anthropometry_get_reason() says why */
    double sd;        /**< of the value, by the errors of the landmarks' places */
    double z;         /**< (value - norm_mean) / norm_sd */
    double z_sd;      /**< sd / norm_sd */
    double norm_mean; /**< over the people of the norms */
    double norm_sd;
    uint64_t norm_people; /**< 0: no norm */
} mien_anthropometric_value;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_anthropometry_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_anthropometry_options_init(mien_anthropometry_options* options,
                                                        size_t struct_size);

/**
 * The landmarks of a template and, beside them, those of its profile that its shape defines by
 * itself: glabella, nasion, columella, sublabiale and pogonion, where they are not among the given
 * ones. Every face in the template's topology has them at the same vertices.
 *
 * @param landmarks     [in] not null; vertices of the template; the 68-point names nose_bridge_3,
 * nose_base_2, mouth_outer_09, jaw_08, eye_right_3 and eye_left_0 must be among them.
 * @param template_mesh [in] not null; symmetric about its plane x = 0, +y up, +z forward
 * (mien_model_mesh()).
 * @param out           [out] not null; all landmarks, or null on failure.
 * @param error         [out] may be null; detail_index is the first offending vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (a landmark that the
 * search starts from), MIEN_E_MISMATCH (vertex), MIEN_E_INVALID_MESH (not symmetric, no midline),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_landmarks_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V log #V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_add_profile(const mien_landmarks* landmarks,
                                                          const mien_mesh* template_mesh,
                                                          mien_landmarks** out, mien_error* error);

/**
 * Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a
 * face: some hundred of the field's, always in the same order. Landmarks go by the field's names
 * ("pronasale", "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point
 * scheme that truly coincide with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A
 * measurement whose landmarks are missing is NaN with a reason.
 *
 * @param session   [in] not null.
 * @param face      [in] not null; #V x 3, mm, with triangles.
 * @param landmarks [in] not null; vertices of the face, or places on it in its frame (a measurement
 * with a place has no deviation, and no length along the skin).
 * @param options   [in] may be null: no deviations, no norms.
 * @param out       [out] not null; the measurements, or null on failure.
 * @param error     [out] may be null; detail_index is the first offending landmark or vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (landmarks, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_anthropometry_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V^1.5) for the lengths along the skin
 * @since  0.2
 * @source Farkas 1994; see src/measure/anthropometry_table.cpp for each measurement's
 */
MIEN_API mien_status MIEN_CALL mien_measure_anthropometry(
    mien_session* session, const mien_mesh* face, const mien_landmarks* landmarks,
    const mien_anthropometry_options* options, mien_anthropometry** out, mien_error* error);

/**
 * How many measurements there are, and how many of them have a value.
 *
 * @param anthropometry [in] not null.
 * @param count         [out] may be null.
 * @param known_count   [out] may be null.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL
mien_anthropometry_get_counts(const mien_anthropometry* anthropometry, uint64_t* count,
                              uint64_t* known_count, mien_error* error);

/**
 * The name of one measurement, such as "n-gn". With dst null and capacity 0: the size only.
 *
 * @param anthropometry [in] not null.
 * @param index         [in] below the count.
 * @param dst           [out] room for capacity bytes, or null.
 * @param capacity      [in] bytes that dst holds.
 * @param count         [out] may be null; bytes with the terminating zero.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_anthropometry_get_name(const mien_anthropometry* anthropometry,
                                                           uint64_t index, char* dst,
                                                           uint64_t capacity, uint64_t* count,
                                                           mien_error* error);

/**
 * One measurement. Set out->struct_size first.
 *
 * @param anthropometry [in] not null.
 * @param index         [in] below the count.
 * @param out           [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_anthropometry_get_value(const mien_anthropometry* anthropometry,
                                                            uint64_t index,
                                                            mien_anthropometric_value* out,
                                                            mien_error* error);

/**
 * Why one measurement has no value, in words; empty where it has one. With dst null and capacity 0:
 * the size only.
 *
 * @param anthropometry [in] not null.
 * @param index         [in] below the count.
 * @param dst           [out] room for capacity bytes, or null.
 * @param capacity      [in] bytes that dst holds.
 * @param count         [out] may be null; bytes with the terminating zero.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL
mien_anthropometry_get_reason(const mien_anthropometry* anthropometry, uint64_t index, char* dst,
                              uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * All measurements as JSON text: name, title, kind, unit, landmarks, source, value, sd, reason, z;
 * and which of the face's landmarks stand for those of the field. With dst null and capacity 0: the
 * size only.
 *
 * @param anthropometry [in] not null.
 * @param dst           [out] room for capacity bytes, or null.
 * @param capacity      [in] bytes that dst holds.
 * @param count         [out] may be null; bytes with the terminating zero.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_anthropometry_get_json(const mien_anthropometry* anthropometry,
                                                           char* dst, uint64_t capacity,
                                                           uint64_t* count, mien_error* error);

/**
 * Releases the measurements.
 *
 * @param anthropometry [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_anthropometry_release(mien_anthropometry* anthropometry);

/**
 * Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of
 * the dataset and for faces in its topology: the same landmark lies elsewhere on another template.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; faces of ten people or more.
 * @param landmarks    [in] not null; vertices of the dataset's faces.
 * @param options      [in] may be null; progress and cancel are read.
 * @param out          [out] not null; the norms, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are
 * no vertices), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement
 * has its landmarks), MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_norms_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(faces #V^1.5)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_norms_create(mien_session* session, const char* dataset_path,
                                                 const mien_landmarks* landmarks,
                                                 const mien_anthropometry_options* options,
                                                 mien_norms** out, mien_error* error);

/**
 * Reads norms that mien_norms_save() wrote, or that a host wrote from the literature:
 * {"norms": {"n-gn": {"mean": 121.3, "sd": 6.8, "people": 109}}}.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the norms, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a norm of fewer than ten people, or given
 * twice), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_norms_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_norms_load(mien_session* session, const char* path,
                                               mien_norms** out, mien_error* error);

/**
 * Writes norms as JSON. Atomic.
 *
 * @param session [in] not null.
 * @param norms   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(norms)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_norms_save(mien_session* session, const mien_norms* norms,
                                               const char* path, mien_error* error);

/**
 * The norms as JSON text, as mien_norms_save() writes it. With dst null and capacity 0: the size
 * only.
 *
 * @param norms    [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_norms_get_json(const mien_norms* norms, char* dst,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error);

/**
 * Releases norms.
 *
 * @param norms [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_norms_release(mien_norms* norms);

#ifdef __cplusplus
}
#endif
#endif

/* Mien: how the left side of a face differs from its right. */
#ifndef MIEN_ASYMMETRY_H
#define MIEN_ASYMMETRY_H

#include "landmarks.h"
#include "measure.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the mirror plane of a face is found by. */
enum {
    MIEN_MIRROR_BY_SURFACE = 0,  /**< all vertices and their partners, robustly */
    MIEN_MIRROR_BY_LANDMARKS = 1 /**< the landmarks and their partners alone */
};

/** Initialise with mien_asymmetry_options_init(). */
typedef struct mien_asymmetry_options {
    uint32_t struct_size;
    int32_t plane;          /**< MIEN_MIRROR_BY_*; default by the surface */
    const mien_zone* zones; /**< zone_count zones of either side; null: the whole side only */
    uint64_t zone_count;
    const mien_landmarks* landmarks; /**< of the template, vertices; may be null unless the plane is
                                        found by them */
    mien_array_view normal_sd;       /**< #V, mm: deviation of each vertex along the normal, as
                                        MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: not
                                        known,       and no interval */
    double correlation_length_mm;    /**< over which errors of the surface go together; default 4 */
    mien_progress_fn progress;       /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_asymmetry_options;

/** The plane between left and right. NaN where a number is not known. */
typedef struct mien_mirror_plane {
    uint32_t struct_size;
    int32_t by;          /**< MIEN_MIRROR_BY_* */
    uint64_t pairs;      /**< of partners that counted */
    double normal[3];    /**< unit, to the subject's left */
    double centre[3];    /**< mm, in the plane */
    double rms_mm;       /**< of the distances between a side and the other's reflection */
    double tilt_sd_rad;  /**< about either direction of the plane, root mean square */
    double offset_sd_mm; /**< along the normal */
    double between_rad;  /**< angle to the plane found the other way; NaN without landmarks */
    double apart_mm;     /**< of that plane from the centre, along its normal */
} mien_mirror_plane;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_asymmetry_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_asymmetry_options_init(mien_asymmetry_options* options,
                                                    size_t struct_size);

/**
 * Compares the left side of a face with the reflection of its right side: volume and distance,
 * signed (positive: the left side lies farther out), whole and per zone, with intervals. Zones of
 * both sides ("cheek_left", "cheek_right") are one comparison ("cheek"); of a zone in the middle
 * the left half is compared with the right half. The result holds volumes, distances, and fields of
 * all vertices (a right vertex against the reflected left side).
 *
 * @param session       [in] not null.
 * @param face          [in] not null; #V x 3, mm, in the template's topology.
 * @param template_mesh [in] not null; the template, symmetric about its plane x = 0, +x to the left
 * (mien_model_mesh()).
 * @param options       [in] may be null: the whole side, no interval.
 * @param out           [out] not null; the measurement, or null on failure.
 * @param error         [out] may be null; detail_index is the first offending vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane),
 * MIEN_E_INVALID_MESH (no triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex
 * counts, zones, landmarks, deviations), MIEN_E_NO_SOLUTION (no plane is determined),
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_measurement_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V log #V + #F); with deviations as mien_measure_volume()
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_measure_asymmetry(mien_session* session, const mien_mesh* face,
                                                      const mien_mesh* template_mesh,
                                                      const mien_asymmetry_options* options,
                                                      mien_measurement** out, mien_error* error);

/**
 * The mirror plane of a comparison of left and right. Set out->struct_size first.
 *
 * @param measurement [in] not null; made by mien_measure_asymmetry().
 * @param out         [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (another measurement)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_measurement_get_mirror_plane(
    const mien_measurement* measurement, mien_mirror_plane* out, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

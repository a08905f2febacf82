/* Mien: the visits of one person, from registrations to numbers that a clinic signs.
 *
 *   mien_study_create(session, registrations, 3, expressions, NULL, &study, &error);
 *   mien_study_get_change(study, 0, 2, zone, &change, &error);
 */
#ifndef MIEN_STUDY_H
#define MIEN_STUDY_H

#include "expression.h"
#include "measure.h"
#include "registration.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Visits of one person: neutral faces and what changed between them. Immutable: share freely. */
typedef struct mien_study mien_study;

/** Initialise with mien_study_options_init(). Names are those of zones. */
typedef struct mien_study_options {
    uint32_t struct_size;
    uint32_t reserved;      /**< zero */
    const mien_zone* zones; /**< zone_count zones to measure; null: those of the registrations'
                               model */
    uint64_t zone_count;
    const char* const* treated_zones; /**< treated_count names: where the person may have changed,
                                         no witness of expression or pose; null: none */
    uint64_t treated_count;
    const char* const* stable_zones; /**< stable_count names of zones to align on; null: all but
                                        the treated ones when zones are treated and expressions
                                        taken off, otherwise "forehead" and "nose"; without any
                                        zone the whole face */
    uint64_t stable_count;
    const int32_t* visits;       /**< visit_number_count numbers, the visit of each face, from 0 and
                                    ascending: several captures of one visit tell the limits of
                                    detection; null: each face is a visit of its own */
    uint64_t visit_number_count; /**< 0, or the number of faces */
    double margin_mm;            /**< around the treated zones, 0 to 100, measured with them as
                                    zones of their own at the end; default 10 */
    double level;                /**< of the intervals, above 0 and below 1; default 0.95 */
    double noise_mm;             /**< of a scanner's surface along its normal, where it was seen;
                                    default 0.08 */
    double correlation_length_mm; /**< over which the errors of a fitted surface go together;
                                     default 4 */
    double common_bias_mm;        /**< error common to all vertices; default 0.01 */
    double untrained_share;       /**< of the volume that an expression accounted for: what no
                                     training set knew of it; default 0.06 */
    double min_seen_share;        /**< of a zone's area that both visits must have seen, 0 to 1;
                                     default 0.1 */
    mien_progress_fn progress;    /**< may be null */
    void* progress_user;
    mien_cancel* cancel;    /**< may be null */
    int32_t measure_unseen; /**< 1: zones keep what no scan saw, which fits guess: walls in
                               nostrils, lips and lids, skin unseen in every visit; default 0: left
                               out of the zones */
    uint32_t reserved_end;  /**< zero */
} mien_study_options;

/** A number with its error. NaN: not known. */
typedef struct mien_study_value {
    double value;
    double sd;                 /**< standard deviation */
    double low;                /**< of the interval at the study's level */
    double high;               /**< of the interval at the study's level */
    double limit_of_detection; /**< the minimal detectable change: a smaller size cannot be told
                                  from no change at the study's level, as the interval holds zero;
                                  from repeated captures where there are enough */
} mien_study_value;

/** Why a change has no deviation. */
enum {
    MIEN_STUDY_KNOWN = 0,
    MIEN_STUDY_UNSEEN = 1,             /**< too little of the zone was seen: no values either */
    MIEN_STUDY_FAILED_FIT = 2,         /**< the fit of one of the visits failed */
    MIEN_STUDY_NO_SURFACE_ERRORS = 3,  /**< a face came without deviations */
    MIEN_STUDY_OUTSIDE_EXPRESSIONS = 4 /**< the zone lies behind the expression model's rim */
};

/** What changed in one zone from one visit to another. Set struct_size first. */
typedef struct mien_study_change {
    uint32_t struct_size;
    int32_t unknown;              /**< MIEN_STUDY_*: why there is no deviation */
    mien_study_value signed_ml;   /**< gained and lost together; positive: gained */
    mien_study_value gained_ml;   /**< >= 0 */
    mien_study_value lost_ml;     /**< <= 0 */
    mien_study_value absolute_ml; /**< gained without lost */
    mien_study_value area_change_mm2;
    mien_study_value
        mean_distance_mm;         /**< along the normals of the first face; positive: outside */
    double surface_sd_ml;         /**< of signed_ml.sd: by the fitted surfaces */
    double alignment_sd_ml;       /**< by the alignment on the stable zone */
    double bias_sd_ml;            /**< by the error common to all vertices */
    double expression_sd_ml;      /**< by what taking the expressions off leaves open */
    double expression_removed_ml; /**< what the expressions accounted for, signed */
    double seen_share;            /**< of the zone's area, in both visits; NaN: not told */
    double area_before_mm2;
    double area_after_mm2;
    int32_t detected; /**< 1: signed_ml reaches its limit of detection, 0: below it, -1: no limit
                         known */
    uint32_t reserved;
} mien_study_change;

/** Fields with one value per vertex of a visit's face. */
enum {
    MIEN_STUDY_FIELD_NORMAL_SD_MM = 1,    /**< how far the fitted surface may lie off the skin */
    MIEN_STUDY_FIELD_WEIGHT = 2,          /**< in [0, 1]: how far the scan was seen there */
    MIEN_STUDY_FIELD_EXPRESSION_SD_MM = 3 /**< of the expression that was taken off: root of the
                                             summed posterior variance of a place's coordinates */
};

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_study_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_study_options_init(mien_study_options* options, size_t struct_size);

/**
 * Studies the visits of one person: takes the expressions off all faces together, aligns each
 * visit on the first by what holds still, and measures what changed per zone with its errors. One
 * registration: its neutral face and how surely it is known.
 *
 * @param session            [in] not null.
 * @param registrations      [in] not null; registration_count fits of one model, first visit first.
 * @param registration_count [in] 1 to 200.
 * @param expressions        [in] may be null: faces are measured as they are held.
 * @param options            [in] may be null: defaults, with the zones of the registrations' model.
 *                           Zones are patches, as those of mien_measure_volume().
 * @param out                [out] not null; the study, or null on failure.
 * @param error              [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (topology, zones), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION,
 * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_study_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(K^2 #V modes^2 / 3) for the joint fit of K faces, and per visit and zone of n vertices
 * O(n k), k of them within 4 correlation lengths
 * @since  0.2
 * @source this library's own; see src/study
 */
MIEN_API mien_status MIEN_CALL mien_study_create(mien_session* session,
                                                 const mien_registration* const* registrations,
                                                 uint32_t registration_count,
                                                 const mien_expression_model* expressions,
                                                 const mien_study_options* options,
                                                 mien_study** out, mien_error* error);

/**
 * The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors:
 * sd, low, high and limit_of_detection are NaN.
 *
 * @param session     [in] not null.
 * @param faces       [in] not null; face_count meshes in one topology, mm, first visit first.
 * @param face_count  [in] 1 to 200.
 * @param normal_sd   [in] may be null; face_count x #V values, face by face, mm, >= 0: how far each
 * surface may lie off the skin along its normal.
 * @param weights     [in] may be null: all was seen, as far as is known; face_count x #V values,
 * face by face, 0 to 1: 0 where a scan had no data.
 * @param expressions [in] may be null: faces are measured as they are held.
 * @param options     [in] may be null: defaults, without any zone. noise_mm is not read.
 * @param out         [out] not null; the study, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (topology, zones, deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION,
 * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_study_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   as mien_study_create()
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_create_from_meshes(
    mien_session* session, const mien_mesh* const* faces, uint32_t face_count,
    const mien_array_view* normal_sd, const mien_array_view* weights,
    const mien_expression_model* expressions, const mien_study_options* options, mien_study** out,
    mien_error* error);

/**
 * How many visits and zones a study has. The treated zones with their margin are the last zones.
 *
 * @param study       [in] not null.
 * @param visit_count [out] may be null.
 * @param zone_count  [out] may be null.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_counts(const mien_study* study, uint32_t* visit_count,
                                                     uint32_t* zone_count, mien_error* error);

/**
 * The name of a zone.
 *
 * @param study    [in] not null.
 * @param zone     [in] 0 to zone_count - 1.
 * @param dst      [out] room for capacity bytes, or null; UTF-8.
 * @param capacity [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (zone), MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_zone_name(const mien_study* study, int32_t zone,
                                                        char* dst, uint64_t capacity,
                                                        uint64_t* count, mien_error* error);

/**
 * The name of the expression that was taken off a visit.
 *
 * @param study    [in] not null.
 * @param visit    [in] 0 to visit_count - 1.
 * @param dst      [out] room for capacity bytes, or null; UTF-8, empty without an expression model
 * or without named expressions.
 * @param capacity [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit), MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_expression(const mien_study* study, int32_t visit,
                                                         char* dst, uint64_t capacity,
                                                         uint64_t* count, mien_error* error);

/**
 * The neutral face of a visit, in its own frame or aligned on another visit.
 *
 * @param study [in] not null.
 * @param visit [in] 0 to visit_count - 1.
 * @param frame [in] the visit in whose frame to give it: its own number for its own frame.
 * @param out   [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V); a pair of later visits is aligned and measured when it is first asked for
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_mesh(const mien_study* study, int32_t visit,
                                                   int32_t frame, mien_mesh** out,
                                                   mien_error* error);

/**
 * Copies a field with one float64 per vertex of a visit's face. With dst null and capacity 0: the
 * count only.
 *
 * @param study    [in] not null.
 * @param visit    [in] 0 to visit_count - 1.
 * @param field    [in] MIEN_STUDY_FIELD_*.
 * @param dst      [out] room for capacity values, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit, or nothing is known of such a field),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_field(const mien_study* study, int32_t visit,
                                                    int32_t field, double* dst, uint64_t capacity,
                                                    uint64_t* count, mien_error* error);

/**
 * How far each vertex moved between two visits: the signed distance of the second neutral face,
 * aligned, from the first along the first one's normals, mm. With dst null and capacity 0: the
 * count only.
 *
 * @param study    [in] not null.
 * @param first    [in] 0 to visit_count - 1.
 * @param second   [in] another visit.
 * @param dst      [out] room for capacity values, or null; positive: outside.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a
 * visit), MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_NO_SOLUTION,
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V log #V); a pair of later visits is aligned and measured when it is first asked for
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_distances(const mien_study* study, int32_t first,
                                                        int32_t second, double* dst,
                                                        uint64_t capacity, uint64_t* count,
                                                        mien_error* error);

/**
 * How the second visit was aligned on the first. Set out->struct_size first.
 *
 * @param study  [in] not null.
 * @param first  [in] 0 to visit_count - 1.
 * @param second [in] another visit.
 * @param out    [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error  [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a
 * visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1); a pair of later visits is aligned and measured when it is first asked for
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_alignment(const mien_study* study, int32_t first,
                                                        int32_t second, mien_zone_alignment* out,
                                                        mien_error* error);

/**
 * What changed in a zone from one visit to another. Set out->struct_size first.
 *
 * @param study  [in] not null.
 * @param first  [in] 0 to visit_count - 1.
 * @param second [in] another visit.
 * @param zone   [in] 0 to zone_count - 1.
 * @param out    [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error  [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a
 * visit or zone), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1); a pair of later visits is aligned and measured when it is first asked for
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_change(const mien_study* study, int32_t first,
                                                     int32_t second, int32_t zone,
                                                     mien_study_change* out, mien_error* error);

/**
 * The study as a JSON object: "recipe" with every setting, "zones", and "visits" with the
 * expression of each and "changes_since_first" per zone. With dst null and capacity 0: the size
 * only.
 *
 * @param study    [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(visits zones)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_study_get_json(const mien_study* study, char* dst,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error);

/**
 * Adds a reference.
 *
 * @param study [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_study_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_study_retain(mien_study* study);

/**
 * Releases a study.
 *
 * @param study [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards; meshes taken from it stay
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_study_release(mien_study* study);

#ifdef __cplusplus
}
#endif
#endif

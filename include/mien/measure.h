/* Mien: volumes, areas and distances between faces, with their uncertainty. */
#ifndef MIEN_MEASURE_H
#define MIEN_MEASURE_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What was measured: numbers per zone and values per vertex. Immutable: share freely. */
typedef struct mien_measurement mien_measurement;

/** Initialise with mien_measure_options_init(). */
typedef struct mien_measure_options {
    uint32_t struct_size;
    int32_t skip_borders;   /**< surfaces not in correspondence: 1 (default) leaves out places whose
                               partner   lies on an open border, where nothing is known */
    const mien_zone* zones; /**< zone_count zones; null: the whole face only */
    uint64_t zone_count;
    mien_array_view
        before_sd; /**< #V, mm: deviation of each vertex along the normal, as
                      MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: exact. Without that
                      of either face there is no interval (since 0.2), whatever the alignment's */
    mien_array_view after_sd;
    double correlation_length_mm;     /**< over which errors of a surface go together; default 4, in
                                         0.1: 10 */
    double alignment_rotation_sd_rad; /**< of the after face against the before face; default 0 */
    double alignment_translation_sd_mm; /**< default 0 */
    double alignment_centre[3];   /**< mm; what the alignment turns about, e.g. the stable zone's
                                     centre */
    double common_bias_mm;        /**< error common to all vertices; default 0 */
    double limit_of_detection_ml; /**< smaller changes are marked as below it; default 0: unknown */
    double max_distance_mm;       /**< surfaces not in correspondence: farther partners are none;
                                       default 0: no limit */
    mien_progress_fn progress;    /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_measure_options;

/** Places of the whole face and of what no zone covers, beside 0 .. zone_count - 1. */
enum { MIEN_ZONE_WHOLE = -1, MIEN_ZONE_REST = -2 };

/** Volume of one zone, mL. signed = positive + negative, absolute = positive - negative; positive:
 * the after face lies outside. NaN where a number is not known. */
typedef struct mien_zone_volume {
    uint32_t struct_size;
    int32_t detected; /**< 1: |signed| reaches the limit of detection, 0: below it, -1: no limit
                         given */
    double signed_ml;
    double positive_ml; /**< >= 0 */
    double negative_ml; /**< <= 0 */
    double absolute_ml;
    double sd_ml;    /**< of signed_ml; NaN when no deviation was given */
    double low95_ml; /**< 95 % interval of signed_ml */
    double high95_ml;
    double area_before_mm2;
    double area_after_mm2; /**< NaN for surfaces not in correspondence */
} mien_zone_volume;

/** Distances of one zone, mm, weighted with area. */
typedef struct mien_zone_distance {
    uint32_t struct_size;
    uint32_t reserved;
    double mean_signed_mm; /**< along the normal of the before face; positive: outside */
    double sd_signed_mm;
    double mean_absolute_mm; /**< of the signed ones */
    double rms_mm;           /**< of the lengths */
    double mean_length_mm;
    double median_length_mm;
    double p95_length_mm;
    double max_length_mm;
    uint64_t vertex_count; /**< vertices that had a partner */
} mien_zone_distance;

/** Fields with one value per vertex of the before face. */
enum {
    MIEN_FIELD_SIGNED_DISTANCE_MM = 1, /**< along the normal of the before face */
    MIEN_FIELD_DISTANCE_MM = 2,        /**< length of the displacement or to the closest place */
    MIEN_FIELD_POSITIVE_VOLUME_MM3 = 3,
    MIEN_FIELD_NEGATIVE_VOLUME_MM3 = 4,
    MIEN_FIELD_CURVATURE_MAXIMAL = 5, /**< 1/mm, positive where the surface bulges outwards */
    MIEN_FIELD_CURVATURE_MINIMAL = 6, /**< 1/mm */
    MIEN_FIELD_CURVATURE_MEAN = 7,    /**< 1/mm */
    MIEN_FIELD_CURVATURE_GAUSSIAN = 8 /**< 1/mm^2 */
};

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_measure_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_measure_options_init(mien_measure_options* options,
                                                  size_t struct_size);

/**
 * The volume between two faces in correspondence: signed, positive, negative and absolute, whole
 * and per zone, exact where the faces cross inside a triangle pair. A zone's edge runs linearly
 * through the ring of triangles it shares; disjoint zones and the rest add up to the whole. A zone
 * of twenty vertices or more of which most lie in no triangle of it is one of another template:
 * MIEN_E_MISMATCH.
 *
 * @param session [in] not null.
 * @param before  [in] not null; #V x 3, mm, with triangles counter-clockwise seen from outside.
 * @param after   [in] not null; same vertex count, in the frame of before; its triangles are not
 * read.
 * @param options [in] may be null: the whole face, no uncertainty.
 * @param out     [out] not null; the measurement, or null on failure.
 * @param error   [out] may be null; detail_index is the first offending vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
 * MIEN_E_MISMATCH (vertex counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_measurement_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V + #F); with deviations O(n k) per zone of n vertices, k of them within 4 correlation
 * lengths
 * @since  0.1
 * @source jousse-2022 4.1.2, there unsigned and inexact at crossings; see src/measure/volume.hpp
 */
MIEN_API mien_status MIEN_CALL mien_measure_volume(mien_session* session, const mien_mesh* before,
                                                   const mien_mesh* after,
                                                   const mien_measure_options* options,
                                                   mien_measurement** out, mien_error* error);

/**
 * Distances between two faces in correspondence, per vertex and per zone.
 *
 * @param session [in] not null.
 * @param before  [in] not null; #V x 3, mm.
 * @param after   [in] not null; same vertex count, in the frame of before.
 * @param options [in] may be null; zones, progress and cancel are read.
 * @param out     [out] not null; the measurement, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
 * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_measurement_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V log #V + #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measure_distance(mien_session* session, const mien_mesh* before,
                                                     const mien_mesh* after,
                                                     const mien_measure_options* options,
                                                     mien_measurement** out, mien_error* error);

/**
 * Distances from the vertices of one surface to the closest place on another, in any topology; the
 * Hausdorff distance takes both directions.
 *
 * @param session [in] not null.
 * @param before  [in] not null; #V x 3, mm, with triangles.
 * @param after   [in] not null; a surface or a cloud of points, aligned with before.
 * @param options [in] may be null; zones (of before), max_distance_mm, skip_borders, progress,
 * cancel.
 * @param out     [out] not null; the measurement, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
 * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_measurement_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O((#V before + #V after) log #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measure_surface_distance(
    mien_session* session, const mien_mesh* before, const mien_mesh* after,
    const mien_measure_options* options, mien_measurement** out, mien_error* error);

/**
 * The volume that a mesh encloses, by the divergence theorem about its centroid.
 *
 * @param session    [in] not null.
 * @param mesh       [in] not null; manifold along its edges and consistently oriented.
 * @param close_rims [in] 1: each open rim is closed by a fan from the mean of its vertices; 0: an
 * open mesh is an error.
 * @param volume_ml  [out] not null; mL, positive when the triangles face outwards.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (close_rims),
 * MIEN_E_INVALID_MESH (open, not manifold or not oriented: the message counts the edges),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#F log #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measure_closed_volume(mien_session* session,
                                                          const mien_mesh* mesh, int32_t close_rims,
                                                          double* volume_ml, mien_error* error);

/**
 * The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices).
 * Zones are patches, as those of mien_measure_volume().
 *
 * @param session  [in] not null.
 * @param mesh     [in] not null; with triangles.
 * @param zone     [in] may be null: the whole surface.
 * @param area_mm2 [out] not null; mm^2.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (zone), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V + #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measure_area(mien_session* session, const mien_mesh* mesh,
                                                 const mien_zone* zone, double* area_mm2,
                                                 mien_error* error);

/**
 * Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.
 *
 * @param session   [in] not null.
 * @param mesh      [in] not null; #V x 3, mm, with triangles counter-clockwise seen from outside.
 * @param radius_mm [in] > 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.
 * @param robust    [in] 1: a second fit leaves spikes and lashes out; 0: none.
 * @param options   [in] may be null; zones, progress and cancel are read.
 * @param out       [out] not null; the measurement, or null on failure. Its JSON holds the zones'
 * means.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust),
 * MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_measurement_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   about 0.1 ms per vertex
 * @since  0.1
 * @source Cazals & Pouget 2005; see src/geometry/curvature.hpp
 */
MIEN_API mien_status MIEN_CALL mien_measure_curvature(mien_session* session, const mien_mesh* mesh,
                                                      double radius_mm, int32_t robust,
                                                      const mien_measure_options* options,
                                                      mien_measurement** out, mien_error* error);

/**
 * Straight lengths and lengths along the surface between pairs of vertices.
 *
 * @param session     [in] not null.
 * @param mesh        [in] not null; #V x 3, mm, with triangles.
 * @param pairs       [in] not null; pair_count x 2 vertex numbers.
 * @param pair_count  [in] 1 to #V.
 * @param straight_mm [out] room for pair_count values, or null.
 * @param geodesic_mm [out] room for pair_count values, or null; by the heat method, within about
 * one percent; infinite where no surface joins the two.
 * @param error       [out] may be null; detail_index is the first offending pair.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (vertex), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V^1.5) once and O(#V) per distinct vertex
 * @since  0.1
 * @source Crane, Weischedel & Wardetzky 2013; see src/measure/lengths.hpp
 */
MIEN_API mien_status MIEN_CALL mien_measure_lengths(mien_session* session, const mien_mesh* mesh,
                                                    const uint32_t* pairs, uint64_t pair_count,
                                                    double* straight_mm, double* geodesic_mm,
                                                    mien_error* error);

/** How vertices are carried onto a surface that is not in correspondence. */
enum {
    MIEN_CARRY_CLOSEST_POINT = 1,
    MIEN_CARRY_DIRECTION = 2, /**< along one direction: a height field's integral */
    MIEN_CARRY_VERTEX_NORMAL = 3
};

/**
 * The volume between two surfaces that are not in correspondence, scan to scan: each vertex of
 * before is carried onto after, then the swept volume is measured. Triangles without a partner do
 * not count.
 *
 * @param session   [in] not null.
 * @param before    [in] not null; #V x 3, mm, with triangles.
 * @param after     [in] not null; another surface with triangles, aligned with before.
 * @param carry     [in] MIEN_CARRY_*.
 * @param direction [in] 3 numbers, any length but zero; may be null unless carry is
 * MIEN_CARRY_DIRECTION.
 * @param options   [in] may be null; zones (of before), max_distance_mm (0: 20),
 * limit_of_detection_ml, progress, cancel. Deviations are not read.
 * @param coverage  [out] may be null; share of before's area that had a partner, 0 to 1.
 * @param out       [out] not null; the measurement, or null on failure.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
 * MIEN_E_NO_SOLUTION (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_measurement_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V log #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measure_scan_volume(
    mien_session* session, const mien_mesh* before, const mien_mesh* after, int32_t carry,
    const double* direction, const mien_measure_options* options, double* coverage,
    mien_measurement** out, mien_error* error);

/** A rigid alignment on a stable zone and how sure it is. */
typedef struct mien_zone_alignment {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t pairs;           /**< that counted */
    double rms_mm;            /**< left over along the normals */
    double rotation_sd_rad;   /**< about the centre, root mean square over the axes */
    double translation_sd_mm; /**< per axis, root mean square */
    double centre[3];         /**< of the zone on the target */
    double matrix[16];        /**< 4 x 4 row by row, moving to target */
} mien_zone_alignment;

/**
 * Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge),
 * robustly: by correspondence first, then by closest points, because a fit slides along a scan more
 * than it lifts off. Surfaces with other triangles (two scans) are brought together by closest
 * points alone and must lie within 15 mm of each other there. The deviations feed
 * alignment_rotation_sd_rad, alignment_translation_sd_mm and alignment_centre.
 *
 * @param session [in] not null.
 * @param moving  [in] not null; #V x 3, mm, with triangles.
 * @param target  [in] not null; with triangles.
 * @param stable  [in] may be null: all vertices. Vertices of target.
 * @param info    [in,out] may be null; struct_size as the caller knows it, the rest is written.
 * @param out     [out] not null; the moved mesh, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
 * MIEN_E_NO_SOLUTION (zone too small or straight), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V log #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measure_align(mien_session* session, const mien_mesh* moving,
                                                  const mien_mesh* target, const mien_zone* stable,
                                                  mien_zone_alignment* info, mien_mesh** out,
                                                  mien_error* error);

/**
 * How many zones were measured.
 *
 * @param measurement    [in] not null.
 * @param zone_count     [out] may be null; the number of zones given.
 * @param zones_disjoint [out] may be null; 1 when no vertex lies in two zones: zones and rest then
 * add up.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measurement_get_zones(const mien_measurement* measurement,
                                                          uint32_t* zone_count,
                                                          int32_t* zones_disjoint,
                                                          mien_error* error);

/**
 * The volume of a zone. Set out->struct_size first.
 *
 * @param measurement [in] not null; made by mien_measure_volume().
 * @param zone        [in] 0 .. zone_count - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.
 * @param out         [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no volume
 * in it)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measurement_get_volume(const mien_measurement* measurement,
                                                           int32_t zone, mien_zone_volume* out,
                                                           mien_error* error);

/**
 * The distances of a zone. Set out->struct_size first.
 *
 * @param measurement [in] not null; made by a distance function.
 * @param zone        [in] 0 .. zone_count - 1 or MIEN_ZONE_WHOLE.
 * @param out         [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no
 * distance in it)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measurement_get_distance(const mien_measurement* measurement,
                                                             int32_t zone, mien_zone_distance* out,
                                                             mien_error* error);

/**
 * Copies a field with one float64 per vertex of the before face; NaN where there was no partner.
 * With dst null and capacity 0: the count only.
 *
 * @param measurement [in] not null.
 * @param field       [in] MIEN_FIELD_*.
 * @param dst         [out] room for capacity values, or null.
 * @param capacity    [in] values that dst holds.
 * @param count       [out] may be null; #V.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (this measurement has no such field),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measurement_get_field(const mien_measurement* measurement,
                                                          int32_t field, double* dst,
                                                          uint64_t capacity, uint64_t* count,
                                                          mien_error* error);

/**
 * The whole measurement as JSON text. With dst null and capacity 0: the size only.
 *
 * @param measurement [in] not null.
 * @param dst         [out] room for capacity bytes, or null.
 * @param capacity    [in] bytes that dst holds.
 * @param count       [out] may be null; bytes with the terminating zero.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(zones)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_measurement_get_json(const mien_measurement* measurement,
                                                         char* dst, uint64_t capacity,
                                                         uint64_t* count, mien_error* error);

/**
 * Releases a measurement.
 *
 * @param measurement [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_measurement_release(mien_measurement* measurement);

#ifdef __cplusplus
}
#endif
#endif

/* Mien: from a raw scan to the template on it. */
#ifndef MIEN_REGISTRATION_H
#define MIEN_REGISTRATION_H

#include "landmarks.h"
#include "model.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A fitted template: places, residuals, confidence, verdict. Immutable: share freely. */
typedef struct mien_registration mien_registration;

/** How the number of deformation modes grows over the rounds (jousse-2022 2.5.2.2). */
enum {
    MIEN_GROWTH_CONSTANT = 0,
    MIEN_GROWTH_LINEAR = 1,
    MIEN_GROWTH_EXPONENTIAL = 2,
    MIEN_GROWTH_CUBIC = 3
};

/** Where a fit begins. */
enum {
    MIEN_START_AUTOMATIC = 0, /**< landmarks when three match, else a search */
    MIEN_START_LANDMARKS = 1,
    MIEN_START_POSE = 2,  /**< start_rotation, start_translation, start_scale */
    MIEN_START_SEARCH = 3 /**< over all poses, those up to 60 degrees off frontal first */
};

/** What one unit of the scan is. */
enum {
    MIEN_UNITS_DETECT =
        0, /**< metres, deci- and centimetres and inches are recognised by size and scaled */
    MIEN_UNITS_MILLIMETRES = 1,
    MIEN_UNITS_REFUSE = 2 /**< anything that does not look like millimetres is an error */
};

/** What is done about landmarks whose left and right are exchanged. */
enum {
    MIEN_SIDES_REFUSE = 0, /**< MIEN_E_MISMATCH that names them */
    MIEN_SIDES_MEND = 1,   /**< exchange them back and say so in the report */
    MIEN_SIDES_IGNORE = 2
};

/** Initialise with mien_register_options_init(). */
typedef struct mien_register_options {
    uint32_t struct_size;
    int32_t growth; /**< MIEN_GROWTH_*; default constant, with annealed noise */
    const mien_scan_landmark* landmarks; /**< landmark_count landmarks; null: none. Ones that
                                            contradict the others are left out; where all lie to one
                                            side of the face they are moved back onto it, and a note
                                            of the report says by how much */
    uint64_t landmark_count;
    double landmark_sigma_mm;     /**< picking error per axis, > 0; default 2 */
    int32_t start;                /**< MIEN_START_*; default automatic */
    int32_t units;                /**< MIEN_UNITS_*; default detect */
    mien_array_view scan_weights; /**< one weight in [0, 1] per scan vertex; count 0: all one */
    int32_t
        skin_weights;  /**< 1: weigh scan vertices by the probability of skin colour; default 0 */
    int32_t close_gap; /**< 1 (default): a smooth field closes what the modes leave open */
    int32_t max_scalar_modes; /**< of the model's kernel modes; default -1: all */
    int32_t max_pca_modes;    /**< of the model's trained modes; default -1: all. Left out where the
                                 landmarks, or without them what the fit leaves of the surface, say
                                 that the face is outside of what they span (a note tells) */
    int32_t iterations;       /**< 1 to 10000; default 0: as many as the library thinks right */
    int32_t reject_border;    /**< 1 (default): places on the scan's open border do not pull */
    double sigma_start_mm;    /**< noise level of a surface point in the first round; default 3 */
    double sigma_end_mm;      /**< and in the last; default 0.5 */
    double max_angle_deg;     /**< between the normals of a vertex and its place; default 60 */
    double start_rotation[9]; /**< row by row, template to scan; default identity */
    double start_translation[3]; /**< mm */
    double start_scale;          /**< default 1 */
    mien_progress_fn progress;   /**< may be null */
    void* progress_user;
    mien_cancel* cancel;    /**< may be null */
    int32_t color_features; /**< 1 (default): where the scan has vertex colours, its lips and brows
                               hold the fit along the skin, and without landmarks eyes are seen to
                               be shut; 0: by form alone. Needs landmarks of the 68-point scheme in
                               the model (brow_*, mouth_outer_*, eye_*) or its zone "lips" */
    uint32_t reserved;      /**< zero */
    double unit_to_mm; /**< one unit of the scan in mm when it is known, e.g. 25.4; 0 (default):
                          by `units` and by the landmarks, which settle it */
    int32_t landmark_sides; /**< MIEN_SIDES_*; default refuse */
    uint32_t reserved2;     /**< zero */
    double max_distance_mm; /**< places of the scan that are farther from their vertex do not pull,
                               nearly so far ones less; default 0: as the noise level lets. Since
                               0.2 */
    double mutual_mm; /**< a place pulls a vertex while the vertex that is nearest to the place
                         lies no farther than that from it; default 0: not asked. Below the
                         template's spacing hardly any place pulls. Since 0.2 */
    double soft_mm;   /**< soft assignment: a vertex is pulled to the mean of the scan around its
                         nearest place, weighed by a Gaussian of this deviation; default 0: to the
                         place itself. Since 0.2 */
} mien_register_options;

/** How far a fit is to be trusted. */
enum { MIEN_QUALITY_GOOD = 0, MIEN_QUALITY_DOUBTFUL = 1, MIEN_QUALITY_FAILED = 2 };

/** The verdict on a fit; the reasons in words are in the JSON report. The quality is that of the
 * error expected of the whole face (mien_registration_get_expected_error()), doubtful at best where
 * a zone has failed. */
typedef struct mien_fit_verdict {
    uint32_t struct_size;
    int32_t quality;     /**< MIEN_QUALITY_* */
    double coverage;     /**< share of the template's vertices with a scan beside them */
    double inlier_share; /**< of those: share that lies on the scan */
    double mean_residual_mm;
    double landmark_rms_mm; /**< 0 without landmarks */
    double size_ratio;      /**< fitted size over template size */
    double mean_deviation;  /**< of the coefficients, in standard deviations of the prior */
    double unit_to_mm;      /**< what one unit of the scan was taken for */
    int32_t landmarks_used;
    int32_t landmarks_rejected;
    int32_t flipped_triangles;
    int32_t self_intersections;
} mien_fit_verdict;

/** How far a fitted zone is expected to be from the truth: the mean distance of its vertices from
 * the true ones, learned from simulated fits of many people, poses and troubles. Since 0.2 */
typedef struct mien_expected_error {
    uint32_t struct_size;
    int32_t quality; /**< MIEN_QUALITY_*, of the zone alone; doubtful at best where the fit failed
                        or what speaks against the scan speaks against all of it (two surfaces over
                        each other, inside out, no known unit) */
    double expected_mm;
    double low_mm; /**< 8 of 10 like fits are between low_mm and high_mm off */
    double high_mm;
    double unseen; /**< 0 to 1: share of the zone that the scan had no say in */
} mien_expected_error;

/** Fields with one value per template vertex. */
enum {
    MIEN_REGISTRATION_RESIDUAL_MM =
        1, /**< signed distance to the scan, positive: the scan lies outside */
    MIEN_REGISTRATION_WEIGHT = 2, /**< in [0, 1]: how much of the scan's say counted */
    MIEN_REGISTRATION_STANDARD_DEVIATION_MM = 3, /**< of the place, per axis (root mean square) */
    MIEN_REGISTRATION_RADIUS95_MM = 4, /**< the true place lies within, 95 times out of 100: the
                                          deviation's pattern in the size of the zone's expected
                                          error (mien_registration_get_expected_error) */
    MIEN_REGISTRATION_NORMAL_DEVIATION_MM = 5, /**< how far the surface may lie off the skin along
                                                 its normal: what mien_measure_options wants. Since
                                                 0.2 */
    MIEN_REGISTRATION_SLIDE_MM = 6, /**< how far mien_registration_tie() moved the place. Since 0.2
                                     */
    MIEN_REGISTRATION_TIE_AGREEMENT = 7, /**< -1 to 1: correlation of both visits' pictures around
                                            the place after the slide; 0: not compared. Since 0.2 */
    MIEN_REGISTRATION_TIE_SHARE = 8, /**< 0 to 1: how far the texture holds the place. Since 0.2 */
    MIEN_REGISTRATION_TIE_DEVIATION_MM = 9 /**< between both visits' places along the skin, per
                                              axis; 0 where the texture holds nothing. Since 0.2 */
};

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_register_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_register_options_init(mien_register_options* options,
                                                   size_t struct_size);

/**
 * Fits a model's template to a scan: start, then rounds of closest points, robust weights and a
 * weighted solve with the model's prior, at falling noise levels; then a smooth field for the rest
 * of the gap. A fit that cannot be trusted is not an error: ask mien_registration_get_verdict().
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param scan    [in] not null; a surface or a cloud of points, any connectivity, any frame; its
 * unit is detected (options.units), any rotation is found.
 * @param options [in] may be null: no landmarks, all defaults.
 * @param out     [out] not null; the registration, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after
 * cleaning), MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged),
 * MIEN_E_NOT_FOUND (start by landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION,
 * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED,
 * MIEN_E_CALLBACK
 * @owner  the caller releases *out with mien_registration_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(rounds (#V r + #V log #F)) time, O(#V r + #F) bytes; r modes
 * @since  0.1
 * @source jousse-2022 2.4, 2.5; see src/registration for equations and departures
 */
MIEN_API mien_status MIEN_CALL mien_register(mien_session* session, const mien_model* model,
                                             const mien_mesh* scan,
                                             const mien_register_options* options,
                                             mien_registration** out, mien_error* error);

/**
 * The fitted template: template topology, the scan's frame, millimetres.
 *
 * @param registration [in] may be null (gives null).
 * @errors none
 * @owner  the registration; mien_mesh_retain() keeps it longer
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API const mien_mesh* MIEN_CALL mien_registration_mesh(const mien_registration* registration);

/**
 * The verdict. Set out->struct_size first.
 *
 * @param registration [in] not null.
 * @param out          [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_registration_get_verdict(const mien_registration* registration,
                                                             mien_fit_verdict* out,
                                                             mien_error* error);

/**
 * The error that is expected of a zone of the model, or of the whole face. Set out->struct_size
 * first.
 *
 * @param registration [in] not null.
 * @param zone         [in] a zone of the model by its name; null: the whole face.
 * @param out          [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, or the
 * registration was made of arrays or read from a file that states none)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(number of zones)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL
mien_registration_get_expected_error(const mien_registration* registration, const char* zone,
                                     mien_expected_error* out, mien_error* error);

/**
 * Copies a field with one float64 per template vertex. With dst null and capacity 0: the count
 * only.
 *
 * @param registration [in] not null.
 * @param field        [in] one of MIEN_REGISTRATION_RESIDUAL_MM, MIEN_REGISTRATION_WEIGHT,
 *                     MIEN_REGISTRATION_STANDARD_DEVIATION_MM, MIEN_REGISTRATION_RADIUS95_MM,
 *                     MIEN_REGISTRATION_NORMAL_DEVIATION_MM, MIEN_REGISTRATION_SLIDE_MM,
 *                     MIEN_REGISTRATION_TIE_AGREEMENT, MIEN_REGISTRATION_TIE_SHARE,
 *                     MIEN_REGISTRATION_TIE_DEVIATION_MM.
 * @param dst          [out] room for capacity values, or null.
 * @param capacity     [in] values that dst holds.
 * @param count        [out] may be null; #V.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such field, or it is not known of this
 * registration), MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_registration_get_field(const mien_registration* registration,
                                                           int32_t field, double* dst,
                                                           uint64_t capacity, uint64_t* count,
                                                           mien_error* error);

/**
 * The dense correspondence: for every template vertex the scan's triangle (or point, for a cloud)
 * nearest to its fitted place, and barycentric coordinates in it. Numbers are those of the scan as
 * it was given.
 *
 * @param registration [in] not null.
 * @param triangles    [out] room for capacity numbers, or null.
 * @param barycentric  [out] room for capacity x 3 values, or null.
 * @param capacity     [in] rows that each given array holds.
 * @param count        [out] may be null; #V.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (nothing but count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_registration_get_correspondence(
    const mien_registration* registration, uint32_t* triangles, double* barycentric,
    uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * The motion from the template's frame to the scan's as a row-major 4 x 4 matrix.
 *
 * @param registration [in] not null.
 * @param matrix       [out] not null; 16 values; lengths in mm.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_registration_get_motion(const mien_registration* registration,
                                                            double* matrix, mien_error* error);

/**
 * Verdict with reasons, energies, motion, color_agreement (correlation of each feature's colour
 * with the template, -1 to 1; empty when colours had no say), measures and expected_error of every
 * zone and summaries as JSON text. With dst null and capacity 0: the size only.
 *
 * @param registration [in] not null.
 * @param dst          [out] room for capacity bytes, or null.
 * @param capacity     [in] bytes that dst holds.
 * @param count        [out] may be null; bytes with the terminating zero.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_registration_get_json(const mien_registration* registration,
                                                          char* dst, uint64_t capacity,
                                                          uint64_t* count, mien_error* error);

/**
 * Keeps a registration as a file: the fitted template, its residuals, weights and deviations, the
 * verdict with its reasons and notes, the tie to another visit and the model's zones, so that
 * visits can be registered today and studied in a year. The scan is not in it.
 *
 * @param session      [in] not null.
 * @param registration [in] not null.
 * @param path         [in] not null; UTF-8; replaced whole.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_registration_save(mien_session* session,
                                                      const mien_registration* registration,
                                                      const char* path, mien_error* error);

/**
 * Reads a registration that mien_registration_save() kept. It gives the same bits as the
 * registration itself.
 *
 * @param session [in] not null.
 * @param path    [in] not null; UTF-8.
 * @param out     [out] not null; the registration, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH,
 * MIEN_E_MISMATCH, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_registration_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_registration_load(mien_session* session, const char* path,
                                                      mien_registration** out, mien_error* error);

/**
 * A registration of a face that was fitted elsewhere, or whose arrays a host kept itself. What is
 * not given here is zero or empty in it.
 *
 * @param session            [in] not null.
 * @param mesh               [in] not null; the fitted template, mm.
 * @param weight             [in] may be null: not known; #V values, 0 to 1: how far the scan was
 * seen there.
 * @param residual           [in] may be null: zero; #V values, mm: signed distance to the scan.
 * @param standard_deviation [in] may be null: not known; #V values, mm, >= 0: of the place, per
 * axis.
 * @param quality            [in] MIEN_QUALITY_*: the verdict on the fit.
 * @param out                [out] not null; the registration, or null on failure.
 * @param error              [out] may be null; detail_index is the first offending vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (lengths),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_registration_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_registration_create(
    mien_session* session, const mien_mesh* mesh, const mien_array_view* weight,
    const mien_array_view* residual, const mien_array_view* standard_deviation, int32_t quality,
    mien_registration** out, mien_error* error);

/** Initialise with mien_tie_options_init(). */
typedef struct mien_tie_options {
    uint32_t struct_size;
    uint32_t reserved;         /**< zero */
    double max_slide_mm;       /**< 0.1 to 20; default 6: no place moves farther */
    double least_share;        /**< 0 to 1; default 0.2: of the skin that both visits see, the share
                                  on which their pictures must agree, or nothing moves */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_tie_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_tie_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_tie_options_init(mien_tie_options* options, size_t struct_size);

/**
 * Ties a later visit's registration to an earlier one's along the skin: its places slide along the
 * scan until each lies on the freckles and pores that it lay on at the earlier visit, where both
 * scans' pictures (a texture image, or colours at the vertices) show the same detail, and go on
 * smoothly where they do not. Form, verdict and weights stay; residuals, correspondence and
 * deviations are those of the moved places. When the pictures agree on too little (another person,
 * plain skin, very unlike light) nothing moves: that is no error, and the JSON report says so under
 * "reference", with why.
 *
 * @param session        [in] not null.
 * @param model          [in] not null; which both registrations were made with.
 * @param reference      [in] not null; the earlier visit.
 * @param reference_scan [in] not null; the scan that it was made of, with colours.
 * @param registration   [in] not null; the later visit.
 * @param scan           [in] not null; the scan that it was made of, with colours.
 * @param options        [in] may be null: the defaults.
 * @param out            [out] not null; the tied registration, or null on failure.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (options; a scan without colours),
 * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MISMATCH (a fit of another template; a scan that does not lie
 * under its fit), MIEN_E_INVALID_MESH, MIEN_E_CANCELLED, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_registration_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   one to three seconds for two scans of 60,000 vertices
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_registration_tie(
    mien_session* session, const mien_model* model, const mien_registration* reference,
    const mien_mesh* reference_scan, const mien_registration* registration, const mien_mesh* scan,
    const mien_tie_options* options, mien_registration** out, mien_error* error);

/**
 * Adds a reference.
 *
 * @param registration [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_registration_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_registration_retain(mien_registration* registration);

/**
 * Releases a registration.
 *
 * @param registration [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_registration_release(mien_registration* registration);

/** What mien_surface_transfer_json() carries over. */
enum { MIEN_TRANSFER_LANDMARKS = 1, MIEN_TRANSFER_ZONES = 2 };

/**
 * Carries places (landmarks, points of a contour) from one surface to another in the same frame,
 * e.g. from a fitted template to the scan under it or back: for each the nearest place on the other
 * surface. With all outputs null and capacity 0: the count only.
 *
 * @param session         [in] not null.
 * @param surface         [in] not null; where the places go; a mesh or a cloud of points, mm.
 * @param points          [in] not null; #P x 3, F32 or F64, mm.
 * @param max_distance_mm [in] farther places are lost (triangle 0xFFFFFFFF); 0: 10, below 0: no
 * limit.
 * @param triangles       [out] room for capacity triangle (cloud: vertex) numbers of `surface`, or
 * null.
 * @param barycentric     [out] room for capacity x 3 values, or null.
 * @param positions       [out] room for capacity x 3 values in mm, or null; a lost place keeps
 * where it was.
 * @param capacity        [in] rows that each given array holds.
 * @param count           [out] may be null; #P.
 * @param error           [out] may be null; detail_index is the first point that is not finite.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (nothing but
 * count written), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#F log #F + #P log #F)
 * @since  0.1
 * @source jousse-2022 1.2, 5.2
 */
MIEN_API mien_status MIEN_CALL mien_surface_transfer_points(
    mien_session* session, const mien_mesh* surface, const mien_array_view* points,
    double max_distance_mm, uint32_t* triangles, double* barycentric, double* positions,
    uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest
 * place on `from` lies in the zone (barycentric share of its vertices at least one half),
 * ascending. With dst null and capacity 0: the count only, at the cost of the whole computation.
 *
 * @param session         [in] not null.
 * @param from            [in] not null; with the zone's vertices.
 * @param vertices        [in] vertex_count vertex numbers of `from`; null when vertex_count is 0.
 * @param vertex_count    [in] length of vertices, at most the vertices of `from`.
 * @param to              [in] not null.
 * @param max_distance_mm [in] farther vertices stay out; 0: 10, below 0: no limit.
 * @param dst             [out] room for capacity vertex numbers of `to`, or null.
 * @param capacity        [in] numbers that dst holds.
 * @param count           [out] may be null; how many there are.
 * @param error           [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (a fitted template
 * without triangles), MIEN_E_MISMATCH (a vertex that `from` does not have), MIEN_E_BUFFER_TOO_SMALL
 * (dst untouched, count written), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#F log #F + #V log #F)
 * @since  0.1
 * @source jousse-2022 1.2, 5.2
 */
MIEN_API mien_status MIEN_CALL
mien_surface_transfer_zone(mien_session* session, const mien_mesh* from, const uint32_t* vertices,
                           uint64_t vertex_count, const mien_mesh* to, double max_distance_mm,
                           uint32_t* dst, uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * A model's landmarks or zones, carried from its fitted template to a scan, as JSON text in the
 * form of the landmark and zone files: {"points": {name: [x, y, z]}, "distances_mm": {name: d}} or
 * {"zones": {name: [scan vertex, ...]}}. With dst null and capacity 0: the size only, at the cost
 * of the whole computation.
 *
 * @param session         [in] not null.
 * @param model           [in] not null; whose landmarks and zones are meant.
 * @param fitted          [in] not null; the model's template after registration.
 * @param scan            [in] not null; in the frame of fitted, mm.
 * @param what            [in] MIEN_TRANSFER_LANDMARKS or MIEN_TRANSFER_ZONES.
 * @param max_distance_mm [in] farther places are left out; 0: 10, below 0: no limit.
 * @param dst             [out] room for capacity bytes, or null.
 * @param capacity        [in] bytes that dst holds.
 * @param count           [out] may be null; bytes with the terminating zero.
 * @param error           [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (what),
 * MIEN_E_MISMATCH (fitted is not of the model), MIEN_E_BUFFER_TOO_SMALL (dst untouched, count
 * written), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#F log #F + zones x #V log #F)
 * @since  0.1
 * @source jousse-2022 1.2, 5.2
 */
MIEN_API mien_status MIEN_CALL
mien_surface_transfer_json(mien_session* session, const mien_model* model, const mien_mesh* fitted,
                           const mien_mesh* scan, int32_t what, double max_distance_mm, char* dst,
                           uint64_t capacity, uint64_t* count, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

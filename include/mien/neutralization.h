/* Mien: faces without their expression. */
#ifndef MIEN_NEUTRALIZATION_H
#define MIEN_NEUTRALIZATION_H

#include "expression.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A neutralized face. Immutable: share freely between threads. */
typedef struct mien_neutralization mien_neutralization;

/** How a face is taken apart into identity and expression. */
enum {
    MIEN_FIT_MIXTURE = 0,    /**< prior of one of a few expressions; the default and the best */
    MIEN_FIT_MAP = 1,        /**< Gaussian priors */
    MIEN_FIT_EXACT = 2,      /**< joint least squares without a prior */
    MIEN_FIT_ALTERNATING = 3 /**< block relaxation, for reproduction */
};

/** Where a face lies against the training faces. */
enum {
    MIEN_POSE_AUTO = 0, /**< on the model's stable zone where it has one; else rigid when the face
                           lies more than 3 degrees or 8 mm away from the mean face and a rigid
                           motion explains it clearly better, else kept */
    MIEN_POSE_KEEP = 1, /**< in the training's frame */
    MIEN_POSE_RIGID = 2 /**< anywhere: a rigid motion is fitted together with the face */
};

/** Initialise with mien_neutralize_options_init(). */
typedef struct mien_neutralize_options {
    uint32_t struct_size;
    int32_t method;      /**< MIEN_FIT_..., default MIEN_FIT_MIXTURE */
    int32_t max_sweeps;  /**< alternating; 1 to 100000, default 200 */
    int32_t uncertainty; /**< 1: compute the deviation per vertex; default 0 */
    int32_t pose;        /**< MIEN_POSE_..., default MIEN_POSE_AUTO */
    uint32_t reserved;   /**< zero */
    double tolerance_mm; /**< alternating: stop when a sweep moves less; default 1e-6 */
    double noise_mm2;    /**< 0 (default): the model's own */
    double decay_mm;     /**< how far a displacement reaches beyond the model's rim; default 25 */
    mien_array_view weights;   /**< #V x 1, >= 0: 0 where the scan had no data; count 0: all one */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel;     /**< may be null */
    const uint32_t* treated; /**< treated_count vertices where the person may have been changed: no
                                witness of expression or pose, so that filler in a lip stays on the
                                face and is not taken for a rolled lip; null: none. Since 0.2 */
    uint64_t treated_count;
    double treated_margin_mm; /**< around them, no witness either; treatments spread; 0 to 100,
                                 default 10 */
} mien_neutralize_options;

/** How a treated zone is read. */
enum {
    MIEN_READING_TREATED = 0,      /**< the zone is no witness: what the result holds */
    MIEN_READING_AS_EXPRESSION = 1 /**< all of the face is a witness */
};

/** What a reading takes off inside the treated zone (without its margin). */
typedef struct mien_zone_reading {
    uint32_t struct_size;
    int32_t differ;     /**< 1: the two readings see another expression and another volume */
    double probability; /**< of the likeliest expression, which the JSON names */
    double removed_mm;  /**< root mean square over the zone */
    double removed_ml;  /**< by which the zone stood out through the expression, to first order */
} mien_zone_reading;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
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
MIEN_API void MIEN_CALL mien_neutralize_options_init(mien_neutralize_options* options,
                                                     size_t struct_size);

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
MIEN_API mien_status MIEN_CALL mien_neutralize(mien_session* session,
                                               const mien_expression_model* model,
                                               const mien_registration* fitted,
                                               const mien_neutralize_options* options,
                                               mien_neutralization** out, mien_error* error);

/**
 * Takes the expression off a face and keeps everything that the model does not explain.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param face    [in] not null; in the model's topology, or in a larger one that begins with it
 * (there the displacement runs out smoothly behind the model's rim); mm.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the result, or null on failure.
 * @param error   [out] may be null; detail_index is the first offending weight.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or
 *         an enumerator that this library does not know), MIEN_E_MISMATCH (topology, weights),
 *         MIEN_E_NO_SOLUTION (MIEN_FIT_EXACT with too little of the face visible),
 * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_neutralization_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V modes); with weights O(#V modes^2)
 * @since  0.1
 * @source jousse-2022 (4.14), (4.15), Algorithm 2 for MIEN_FIT_ALTERNATING; the priors are this
 * library's own
 */
MIEN_API mien_status MIEN_CALL mien_neutralize_mesh(mien_session* session,
                                                    const mien_expression_model* model,
                                                    const mien_mesh* face,
                                                    const mien_neutralize_options* options,
                                                    mien_neutralization** out, mien_error* error);

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
MIEN_API const mien_mesh* MIEN_CALL
mien_neutralization_mesh(const mien_neutralization* neutralization);

/**
 * Numbers of vertices of the neutral face and of coordinates of
 * mien_neutralization_get_coordinates().
 *
 * @param neutralization   [in] not null.
 * @param vertex_count     [out] may be null; #V.
 * @param identity_modes   [out] may be null; those of the model.
 * @param expression_modes [out] may be null; those of the model.
 * @param error            [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_neutralization_get_counts(
    const mien_neutralization* neutralization, uint64_t* vertex_count, uint32_t* identity_modes,
    uint32_t* expression_modes, mien_error* error);

/**
 * Coordinates of the face in the model, mm along the unit modes. mien_neutralization_get_counts()
 * says how many.
 *
 * @param neutralization [in] not null.
 * @param identity       [out] room for identity_modes values, or null.
 * @param expression     [out] room for expression_modes values, or null.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(modes)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL
mien_neutralization_get_coordinates(const mien_neutralization* neutralization, double* identity,
                                    double* expression, mien_error* error);

/**
 * Deviation per vertex of the neutral face that comes from not knowing the expression, mm.
 *
 * @param neutralization [in] not null.
 * @param dst            [out] room for capacity doubles, or null.
 * @param capacity       [in] doubles that dst holds; with dst null and 0 only the count is written.
 * @param count          [out] may be null; #V of the face.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without a
 * prior), MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL
mien_neutralization_get_uncertainty(const mien_neutralization* neutralization, double* dst,
                                    uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * How a treated zone is read, both ways: treatments of lips, brows and the corners of the mouth can
 * look like expressions. Set out->struct_size first.
 *
 * @param neutralization [in] not null; made with options.treated.
 * @param reading        [in] MIEN_READING_*.
 * @param out            [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (reading),
 * MIEN_E_NOT_FOUND (nothing was treated)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL
mien_neutralization_get_reading(const mien_neutralization* neutralization, int32_t reading,
                                mien_zone_reading* out, mien_error* error);

/**
 * The report as a JSON object: expression found, its probability and the others', displacement,
 * residual, coordinates; with options.treated both readings of the zone.
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
MIEN_API mien_status MIEN_CALL
mien_neutralization_get_json(const mien_neutralization* neutralization, char* dst,
                             uint64_t capacity, uint64_t* count, mien_error* error);

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
MIEN_API void MIEN_CALL mien_neutralization_release(mien_neutralization* neutralization);

/**
 * Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and
 * texture of the scan stay. Parts far from the template move rigidly with their neighbourhood.
 *
 * @param session         [in] not null.
 * @param neutralization  [in] not null; of a face that was fitted to this scan.
 * @param scan            [in] not null; in the frame of the face.
 * @param max_distance_mm [in] how far from the fitted face a vertex takes its displacement; 0: 6
 * mm.
 * @param out             [out] not null; the moved scan, or null on failure.
 * @param error           [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION,
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#scan log #V) and one sparse solve
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_neutralization_apply_to_scan(
    mien_session* session, const mien_neutralization* neutralization, const mien_mesh* scan,
    double max_distance_mm, mien_mesh** out, mien_error* error);

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
MIEN_API mien_status MIEN_CALL mien_expression_model_transfer(mien_session* session,
                                                              const mien_expression_model* model,
                                                              const mien_neutralization* source,
                                                              const mien_neutralization* target,
                                                              mien_mesh** out, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

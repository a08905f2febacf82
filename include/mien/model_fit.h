/* Mien: coefficients of a deformation model: from a face of known correspondence, from a
 * registration, and back to a face.
 *
 * Coefficients are one list of 3 r + p values for r scalar and p vector modes, in units of the
 * prior's deviation: those of scalar mode j for x, y and z at 3 j, 3 j + 1 and 3 j + 2, then one
 * per vector mode (mien_model_get_counts() says r and p).
 *
 *     mien_model_fit(session, model, face, NULL, values, 3 * r + p, NULL, &error);
 *     mien_model_synthesize(session, model, values, 3 * r + p, &nearest, &error);
 */
#ifndef MIEN_MODEL_FIT_H
#define MIEN_MODEL_FIT_H

#include "model.h"
#include "registration.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Initialise with mien_model_fit_options_init(). */
typedef struct mien_model_fit_options {
    uint32_t struct_size;
    int32_t align;           /**< 1: move the target rigidly onto the model's mean; default 0 */
    double ridge_mm2;        /**< rho: variance of the target's noise, mm^2, >= 0; default 1 */
    mien_array_view weights; /**< one per vertex of the target, >= 0, which enter squared; count 0:
                                all one */
    int32_t scalar_modes;    /**< the first of them, the others stay 0; -1 (default): all */
    int32_t vector_modes;    /**< the first of them, the others stay 0; -1 (default): all */
} mien_model_fit_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_model_fit_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_model_fit_options_init(mien_model_fit_options* options,
                                                    size_t struct_size);

/**
 * The coefficients that bring the template nearest to a face in its correspondence: least squares,
 * weighted per vertex, with a ridge. With dst null and capacity 0: the count only.
 *
 * @param session  [in] not null.
 * @param model    [in] not null.
 * @param target   [in] not null; mm, in the template's frame unless options.align; the vertices of
 * the template, or its first ones.
 * @param options  [in] may be null: no weights, a ridge of 1 mm^2, all modes.
 * @param dst      [out] room for capacity float64, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; 3 r + p.
 * @param error    [out] may be null; detail_index is the first offending vertex.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertices, weights),
 * MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count
 * written), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V (r + p)^2 + r^3 + p^3), about 8 #V (r + 6 p) bytes
 * @since  0.2
 * @source jousse-2022 (2.33), (2.34)
 */
MIEN_API mien_status MIEN_CALL mien_model_fit(mien_session* session, const mien_model* model,
                                              const mien_mesh* target,
                                              const mien_model_fit_options* options, double* dst,
                                              uint64_t capacity, uint64_t* count,
                                              mien_error* error);

/**
 * The face that has these coefficients: the template moved by the mean and the modes.
 *
 * @param session      [in] not null.
 * @param model        [in] not null.
 * @param coefficients [in] coefficient_count finite values; null when coefficient_count is 0.
 * @param coefficient_count [in] 0 (the mean) to 3 r, a multiple of 3: the first scalar modes alone;
 * or 3 r + 0 to p: all scalar modes and the first vector modes.
 * @param out          [out] not null; #V vertices in mm with the template's triangles, or null on
 * failure.
 * @param error        [out] may be null; detail_index is the first value that is not finite.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (coefficient_count),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V (r + p))
 * @since  0.2
 * @source jousse-2022 (2.3)
 */
MIEN_API mien_status MIEN_CALL mien_model_synthesize(mien_session* session, const mien_model* model,
                                                     const double* coefficients,
                                                     uint64_t coefficient_count, mien_mesh** out,
                                                     mien_error* error);

/**
 * The coefficients of a registered face: its fitted template, brought back into the model's frame
 * by the registration's own motion and fitted as by mien_model_fit(). What the fit took from the
 * model comes back; what it moved beyond the model's span, to close the last gap to the scan, is
 * left out. With dst null and capacity 0: the count only.
 *
 * @param session      [in] not null.
 * @param registration [in] not null; of a scan to this model.
 * @param model        [in] not null.
 * @param ridge_mm2    [in] mm^2, >= 0; 0: the nearest face of the model's span.
 * @param dst          [out] room for capacity float64, or null.
 * @param capacity     [in] values that dst holds.
 * @param count        [out] may be null; 3 r + p.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (of another model),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   as mien_model_fit()
 * @since  0.2
 * @source jousse-2022 (2.37)
 */
MIEN_API mien_status MIEN_CALL mien_registration_get_coefficients(
    mien_session* session, const mien_registration* registration, const mien_model* model,
    double ridge_mm2, double* dst, uint64_t capacity, uint64_t* count, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

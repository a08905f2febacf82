/* Mien: is a mesh fit to be a template? */
#ifndef MIEN_TEMPLATE_CHECK_H
#define MIEN_TEMPLATE_CHECK_H

#include "landmarks.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings
 * (inside out, or mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and,
 * where landmarks of the 68-point scheme are given, pose, left and right, closed eyes and mouth.
 * The findings come as JSON text by the two-call protocol: {"errors": n, "warnings": n, "findings":
 * [{"kind": "error" or "warning", "code", "text", "vertices": [...]}]}. No model should be built
 * from a mesh with errors; mien_model_build() does not ask.
 *
 * @param session       [in] not null.
 * @param template_mesh [in] not null; the mesh as it is given to mien_model_build().
 * @param landmarks     [in] may be null; vertices of the mesh.
 * @param mirror        [in] 1: symmetry about x = 0 is asked for, as by options.mirror_symmetric;
 * 0.
 * @param dst           [out] room for capacity bytes, or null.
 * @param capacity      [in] bytes that dst holds.
 * @param count         [out] may be null; bytes with the terminating zero.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a landmark that is no vertex of the
 * mesh), MIEN_E_UNSUPPORTED_OPTION (mirror), MIEN_E_BUFFER_TOO_SMALL (dst untouched, count
 * written), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(V log V + F log F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_template_check(mien_session* session,
                                                   const mien_mesh* template_mesh,
                                                   const mien_landmarks* landmarks, int32_t mirror,
                                                   char* dst, uint64_t capacity, uint64_t* count,
                                                   mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

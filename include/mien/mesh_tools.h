/* Mien: what a mesh is, what is wrong with it, and the simple cures. */
#ifndef MIEN_MESH_TOOLS_H
#define MIEN_MESH_TOOLS_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * What a mesh is and what is wrong with it, as JSON text: counts, box, extent and the units in
 * which that is a face, a head or a body, pieces, borders, windings, doubled and unused parts, and
 * "faults": a list of sentences that say what is wrong and what to do. With dst null and capacity
 * 0: the size only.
 *
 * @param session [in] not null.
 * @param mesh [in] not null.
 * @param dst [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count [out] may be null; bytes with the terminating zero.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(V + F log F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_inspect(mien_session* session, const mien_mesh* mesh,
                                                 char* dst, uint64_t capacity, uint64_t* count,
                                                 mien_error* error);

/**
 * Merges vertices of equal coordinates, drops degenerate, doubled and unused parts and pieces of
 * fewer than min_triangles triangles, and winds all triangles of a piece alike. Order and
 * coordinates of what stays are kept.
 *
 * @param session [in] not null.
 * @param mesh [in] not null.
 * @param min_triangles [in] 0: all pieces stay.
 * @param out [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(V + F log F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_clean(mien_session* session, const mien_mesh* mesh,
                                               uint64_t min_triangles, mien_mesh** out,
                                               mien_error* error);

/**
 * Moves every vertex by a row-major 4 x 4 matrix: scales, turns, shifts. When it mirrors (negative
 * determinant), the triangles are wound the other way, so that outside stays outside.
 *
 * @param session [in] not null.
 * @param mesh [in] not null.
 * @param matrix [in] not null; 16 values, last row 0 0 0 1, invertible.
 * @param out [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(V + F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_transform(mien_session* session, const mien_mesh* mesh,
                                                   const double* matrix, mien_mesh** out,
                                                   mien_error* error);

/**
 * Winds every triangle the other way: inside becomes outside.
 *
 * @param session [in] not null.
 * @param mesh [in] not null.
 * @param out [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(V + F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_turn_over(mien_session* session, const mien_mesh* mesh,
                                                   mien_mesh** out, mien_error* error);

/**
 * Collapses edges of least quadric error until vertex_count vertices are left or no collapse is
 * legal. Every vertex that stays is one of the input with its place and colour; texture
 * coordinates are dropped. Vertices in which fans of triangles merely touch are split first;
 * triangles that fit into no manifold go.
 *
 * @param session [in] not null.
 * @param mesh [in] not null.
 * @param vertex_count [in] at least 4.
 * @param out [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(V log V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_decimate(mien_session* session, const mien_mesh* mesh,
                                                  uint64_t vertex_count, mien_mesh** out,
                                                  mien_error* error);

/**
 * Fails when one of two meshes of the same face is so many times larger that they cannot be in one
 * unit (7 times; mm and cm differ by 10). The message names the unit that would explain it.
 *
 * @param first [in] not null.
 * @param second [in] not null.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (not in one unit), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_check_same_unit(const mien_mesh* first,
                                                         const mien_mesh* second,
                                                         mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

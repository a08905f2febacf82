/* Mien: distances along a surface.
 *
 *     double* field = malloc(vertex_count * sizeof *field);
 *     const uint32_t nose_tip = 3;
 *     mien_measure_geodesic(session, mesh, &nose_tip, 1, NULL, field, vertex_count, NULL, &error);
 */
#ifndef MIEN_GEODESIC_H
#define MIEN_GEODESIC_H

#include "model.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Initialise with mien_geodesic_options_init(). */
typedef struct mien_geodesic_options {
    uint32_t struct_size;
    int32_t heat_boundary;     /**< MIEN_HEAT_..., default NEUMANN */
    double heat_time_factor;   /**< heat time in units of (mean edge)^2, 0.01 to 10000, default 4 */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_geodesic_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_geodesic_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_geodesic_options_init(mien_geodesic_options* options,
                                                   size_t struct_size);

/**
 * Distance of every vertex from the nearest of some vertices, along the surface, by the heat
 * method; a model's template is a mesh too (mien_model_mesh()). Holes are gone around, edges are
 * not followed. With dst null and capacity 0: the count only.
 *
 * @param session      [in] not null.
 * @param mesh         [in] not null; #V x 3, mm, with triangles.
 * @param sources      [in] not null; source_count vertex numbers.
 * @param source_count [in] 1 to the vertices of the mesh.
 * @param options      [in] may be null: heat stays inside, a time of 4 mean edges squared.
 * @param dst          [out] room for capacity float64, or null: mm, 0 at the sources, infinity on
 * pieces of the mesh that hold no source.
 * @param capacity     [in] values that dst holds.
 * @param count        [out] may be null; #V.
 * @param error        [out] may be null; detail_index is the first source out of range.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#V^1.5) once, O(#V log #V) per source; about 480 #V bytes
 * @since  0.2
 * @source jousse-2022 (2.20)-(2.22); Crane, Weischedel & Wardetzky, "Geodesics in heat"
 */
MIEN_API mien_status MIEN_CALL mien_measure_geodesic(mien_session* session, const mien_mesh* mesh,
                                                     const uint32_t* sources, uint64_t source_count,
                                                     const mien_geodesic_options* options,
                                                     double* dst, uint64_t capacity,
                                                     uint64_t* count, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

/* Mien: coarser levels of a template, with maps of values between them. */
#ifndef MIEN_HIERARCHY_H
#define MIEN_HIERARCHY_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Levels of a template with maps between them. Immutable: share freely. */
typedef struct mien_hierarchy mien_hierarchy;

/**
 * Levels by quadric edge collapse, with barycentric maps up and selections down.
 *
 * @param session     [in] not null.
 * @param mesh        [in] not null; an orientable manifold.
 * @param level_count [in] levels below the mesh itself, 1 to 32; fewer when no collapse is legal.
 * @param factor      [in] vertices are divided by this from level to level; above 1.
 * @param out         [out] not null; the hierarchy, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_hierarchy_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V log #V)
 * @since  0.1
 * @source kosk-2024 3.3.2
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_build_quadric(mien_session* session,
                                                            const mien_mesh* mesh,
                                                            uint32_t level_count, double factor,
                                                            mien_hierarchy** out,
                                                            mien_error* error);

/**
 * Levels sampled from the connectivity alone.
 *
 * @param session     [in] not null.
 * @param mesh        [in] not null.
 * @param level_count [in] levels below the mesh itself, 1 to 32.
 * @param stride      [in] least distance of kept vertices in edges, at least 1.
 * @param radius      [in] edges over which the maps reach, stride - 1 to 64.
 * @param out         [out] not null; the hierarchy, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_hierarchy_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V times the vertices within radius)
 * @since  0.1
 * @source kosk-2024 3.3.4
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_build_connectivity(
    mien_session* session, const mien_mesh* mesh, uint32_t level_count, uint32_t stride,
    uint32_t radius, mien_hierarchy** out, mien_error* error);

/**
 * Opens a hierarchy file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the hierarchy, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_hierarchy_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_load(mien_session* session, const char* path,
                                                   mien_hierarchy** out, mien_error* error);

/**
 * Writes a hierarchy file (safetensors; maps as compressed rows). Atomic.
 *
 * @param session   [in] not null.
 * @param hierarchy [in] not null.
 * @param path      [in] UTF-8, not null.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_save(mien_session* session,
                                                   const mien_hierarchy* hierarchy,
                                                   const char* path, mien_error* error);

/**
 * Number of levels, the finest included.
 *
 * @param hierarchy   [in] not null.
 * @param level_count [out] not null.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_level_count(const mien_hierarchy* hierarchy,
                                                              uint32_t* level_count,
                                                              mien_error* error);

/**
 * The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no
 * triangles.
 *
 * @param hierarchy [in] not null.
 * @param level     [in] 0 to level_count - 1.
 * @param out       [out] not null; the mesh, or null on failure.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V + #F of the level)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_level(const mien_hierarchy* hierarchy,
                                                        uint32_t level, mien_mesh** out,
                                                        mien_error* error);

/** Directions of a hierarchy's maps. */
enum {
    MIEN_MAP_DOWN = 1, /**< from the next finer level to this one */
    MIEN_MAP_UP = 2    /**< from this level to the next finer one */
};

/**
 * Applies a map to values on vertices: dst = map values.
 *
 * @param hierarchy     [in] not null.
 * @param level         [in] 1 to level_count - 1: the coarser level of the map.
 * @param direction     [in] MIEN_MAP_DOWN or MIEN_MAP_UP.
 * @param values        [in] not null; row_count x channel_count row-major float64.
 * @param row_count     [in] vertices of the level that the map starts from.
 * @param channel_count [in] values a vertex, 1 to 4096.
 * @param dst           [out] room for capacity rows of channel_count, or null with capacity 0.
 * @param capacity      [in] rows that dst holds.
 * @param count         [out] may be null; vertices of the level that the map ends at.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_MISMATCH (row_count),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(non-zeroes x channel_count)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_apply(const mien_hierarchy* hierarchy, uint32_t level,
                                                    int32_t direction, const double* values,
                                                    uint64_t row_count, uint64_t channel_count,
                                                    double* dst, uint64_t capacity, uint64_t* count,
                                                    mien_error* error);

/**
 * A map as a sparse matrix: its entries by rows, ascending, each row adding up to one. With all
 * arrays null and capacity 0: the counts only.
 *
 * @param hierarchy    [in] not null.
 * @param level        [in] 1 to level_count - 1: the coarser level of the map.
 * @param direction    [in] MIEN_MAP_DOWN or MIEN_MAP_UP.
 * @param rows         [out] room for capacity numbers of vertices that the map ends at, or null.
 * @param columns      [out] room for capacity numbers of vertices that it starts from, or null.
 * @param values       [out] room for capacity float64, or null.
 * @param capacity     [in] entries that each given array holds.
 * @param count        [out] may be null; entries of the map.
 * @param row_count    [out] may be null; vertices that the map ends at.
 * @param column_count [out] may be null; vertices that it starts from.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction),
 * MIEN_E_BUFFER_TOO_SMALL (nothing but the counts written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(entries)
 * @since  0.2
 * @source kosk-2024 3.3.2 to 3.3.4
 */
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_map(const mien_hierarchy* hierarchy,
                                                      uint32_t level, int32_t direction,
                                                      uint32_t* rows, uint32_t* columns,
                                                      double* values, uint64_t capacity,
                                                      uint64_t* count, uint64_t* row_count,
                                                      uint64_t* column_count, mien_error* error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param hierarchy [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_hierarchy_retain(mien_hierarchy* hierarchy);

/**
 * Gives one reference back; the last one frees the hierarchy.
 *
 * @param hierarchy [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_hierarchy_release(mien_hierarchy* hierarchy);

#ifdef __cplusplus
}
#endif
#endif

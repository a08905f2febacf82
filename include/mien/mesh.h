/* Mien: meshes, from arrays or files. */
#ifndef MIEN_MESH_H
#define MIEN_MESH_H

#include "session.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A triangle mesh or point cloud, checked: finite coordinates, indices in range. Millimetres.
 *  Immutable: share freely between threads. */
typedef struct mien_mesh mien_mesh;

/** Element types of arrays. */
typedef int32_t mien_dtype;
enum {
    MIEN_DTYPE_F32 = 1,
    MIEN_DTYPE_F64 = 2,
    MIEN_DTYPE_I32 = 3,
    MIEN_DTYPE_U32 = 4,
    MIEN_DTYPE_U8 = 5
};

/** An array of the host's, read in place and only during the call. */
typedef struct mien_array_view {
    const void* data;      /**< aligned for dtype; may be null when count is 0 */
    uint64_t count;        /**< rows */
    uint64_t stride_bytes; /**< from row to row; 0: tightly packed */
    mien_dtype dtype;
    int32_t reserved; /**< zero */
} mien_array_view;

/** A named set of vertices of a surface, read in place and only during the call. */
typedef struct mien_zone {
    const char* name;         /**< UTF-8, not null */
    const uint32_t* vertices; /**< vertex_count vertex numbers; repeated ones count once */
    uint64_t vertex_count;    /**< never more than the surface has vertices */
} mien_zone;

/** What a mesh is made of. Initialise with mien_mesh_arrays_init(). */
typedef struct mien_mesh_arrays {
    uint32_t struct_size;
    uint32_t reserved;         /**< zero */
    mien_array_view positions; /**< #V x 3, F32 or F64, mm */
    const uint32_t*
        triangles; /**< #F x 3 tightly packed, counter-clockwise seen from outside; may be null */
    uint64_t triangle_count; /**< #F; 0: a point cloud */
    const uint8_t* colors;   /**< #V x 3 red green blue, tightly packed; may be null */
} mien_mesh_arrays;

/**
 * Zeroes the first struct_size bytes of *arrays and writes struct_size.
 *
 * @param arrays      [out] not null.
 * @param struct_size [in] sizeof(mien_mesh_arrays) of the caller.
 * @errors none (does nothing when arrays is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_mesh_arrays_init(mien_mesh_arrays* arrays, size_t struct_size);

/**
 * Makes a mesh from the host's arrays, which are copied.
 *
 * @param session [in] not null.
 * @param arrays  [in] not null; see the fields for shapes and units.
 * @param out     [out] not null; the mesh, or null on failure.
 * @param error   [out] may be null; detail_index is the first offending vertex or triangle.
 * @errors MIEN_E_INVALID_ARGUMENT (null, misaligned, stride, dtype), MIEN_E_INVALID_MESH (no
 * vertex, value not finite, index out of range), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V + #F) time, 24 #V + 12 #F bytes
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_create(mien_session* session,
                                                const mien_mesh_arrays* arrays, mien_mesh** out,
                                                mien_error* error);

/**
 * Reads a mesh file: PLY, OBJ, STL or OFF by extension, ASCII or binary. Polygons become triangle
 * fans, colours and texture coordinates are kept. The file is treated as hostile.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the mesh, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_BAD_FORMAT (also an unknown extension), MIEN_E_INVALID_MESH,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_load(mien_session* session, const char* path,
                                              mien_mesh** out, mien_error* error);

/**
 * Writes a mesh file by extension: PLY (binary, float32), OBJ, STL (binary) or OFF. Atomic: a full
 * disk or a crash leaves an old file whole.
 *
 * @param session [in] not null.
 * @param mesh    [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V + #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_save(mien_session* session, const mien_mesh* mesh,
                                              const char* path, mien_error* error);

/**
 * Numbers of vertices and triangles.
 *
 * @param mesh            [in] not null.
 * @param vertex_count    [out] may be null; #V.
 * @param triangle_count  [out] may be null; #F.
 * @param error           [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_counts(const mien_mesh* mesh, uint64_t* vertex_count,
                                                    uint64_t* triangle_count, mien_error* error);

/**
 * Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count
 * only.
 *
 * @param mesh     [in] not null.
 * @param dtype    [in] MIEN_DTYPE_F32 or MIEN_DTYPE_F64 of dst.
 * @param dst      [out] room for capacity rows of 3, or null.
 * @param capacity [in] rows that dst holds.
 * @param count    [out] may be null; #V.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_positions(const mien_mesh* mesh, mien_dtype dtype,
                                                       void* dst, uint64_t capacity,
                                                       uint64_t* count, mien_error* error);

/**
 * Copies the triangles, #F x 3 uint32 tightly packed. With dst null and capacity 0: the count only.
 *
 * @param mesh     [in] not null.
 * @param dst      [out] room for capacity rows of 3, or null.
 * @param capacity [in] rows that dst holds.
 * @param count    [out] may be null; #F.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_triangles(const mien_mesh* mesh, uint32_t* dst,
                                                       uint64_t capacity, uint64_t* count,
                                                       mien_error* error);

/**
 * Copies the vertex colours, #V x 3 uint8; the count is 0 when the mesh has none.
 *
 * @param mesh     [in] not null.
 * @param dst      [out] room for capacity rows of 3, or null.
 * @param capacity [in] rows that dst holds.
 * @param count    [out] may be null; #V or 0.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_colors(const mien_mesh* mesh, uint8_t* dst,
                                                    uint64_t capacity, uint64_t* count,
                                                    mien_error* error);

/**
 * The positions in place: *data points to #V x 3 float64, tightly packed, mm.
 *
 * @param mesh  [in] not null.
 * @param data  [out] not null.
 * @param count [out] may be null; #V.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
 * @owner  *data belongs to the mesh and is valid until its last reference is released
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_positions_view(const mien_mesh* mesh, const double** data,
                                                        uint64_t* count, mien_error* error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param mesh [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_mesh_retain(mien_mesh* mesh);

/**
 * Gives one reference back; the last one frees the mesh.
 *
 * @param mesh [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_mesh_release(mien_mesh* mesh);

#ifdef __cplusplus
}
#endif
#endif

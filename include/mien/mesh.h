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
    const uint32_t* vertices; /**< vertex_count vertex numbers, not null; repeated ones count
                                 once */
    uint64_t vertex_count;    /**< never more than the surface has vertices */
} mien_zone;

/** A texture image of the host's, read in place and only during the call: either pixels or the
 * bytes of a file. */
typedef struct mien_image {
    const char* name;          /**< UTF-8 file name without a folder; may be null */
    const uint8_t* pixels;     /**< [count=height*width*3] height rows of width x 3 red green blue,
                                  from the top; may be null */
    uint64_t row_stride_bytes; /**< from row to row; 0: tightly packed */
    uint32_t width;            /**< of pixels, else 0 */
    uint32_t height;           /**< of pixels, else 0 */
    const uint8_t* file; /**< [count=file_size] the bytes of a JPEG or PNG file; may be null: when
                        pixels are given */
    uint64_t file_size;  /**< bytes */
} mien_image;

/** A material of a mesh, read in place and only during the call. */
typedef struct mien_material {
    const char* name; /**< UTF-8; may be null */
    int32_t image;    /**< number of the base colour's image, -1: none */
    int32_t reserved; /**< zero */
    double red;       /**< 0 to 1; an image is times this */
    double green;
    double blue;
} mien_material;

/** What a mesh is made of. Initialise with mien_mesh_arrays_init(). */
typedef struct mien_mesh_arrays {
    uint32_t struct_size;
    uint32_t reserved;         /**< zero */
    mien_array_view positions; /**< #V x 3, F32 or F64, mm */
    const uint32_t*
        triangles; /**< #F x 3 tightly packed, counter-clockwise seen from outside; may be null */
    uint64_t triangle_count; /**< #F; 0: a point cloud */
    const uint8_t* colors;   /**< [count=positions.count*3] #V x 3 red green blue, tightly packed;
                                may be null */
    const float* texture;    /**< #T x 2, (0, 0) at the image's lower left corner; may be null */
    uint64_t texture_count;  /**< #T */
    const uint32_t*
        texture_triangles; /**< [count=triangle_count*3] #F x 3 numbers of texture; may be null:
                              with texture, texture has a row for each vertex */
    const mien_material* materials;     /**< may be null */
    uint64_t material_count;            /**< at most 65536 */
    const uint32_t* triangle_materials; /**< [count=triangle_count] #F numbers of materials; null:
                                           all are of the first */
    const mien_image* images;           /**< may be null */
    uint64_t image_count;               /**< at most 65536 */
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
 * Reads a mesh file: see mien_mesh_format_extension(). What the file holds tells its format, its
 * name only where that leaves it open. Polygons become triangle fans; colours, texture coordinates,
 * materials and images (of this file and beside it) are kept. Points that are not numbers and part
 * of no triangle are dropped, with a warning in the session's log. The file is treated as hostile.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the mesh, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_BAD_FORMAT,
 * MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_mesh_load(mien_session* session, const char* path,
                                              mien_mesh** out, mien_error* error);

/**
 * Writes a mesh file by extension: see mien_mesh_format_writes(). Coordinates are float32 or nine
 * digits where that steps by at most 0.001 mm, else double; STL, which cannot, is refused then.
 * Materials and images are written beside OBJ and PLY files and into GLB files, each image's bytes
 * as they were read. Atomic: a full disk or a crash leaves an old file whole.
 *
 * @param session [in] not null.
 * @param mesh    [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension, a format that is read only),
 * MIEN_E_INVALID_MESH (STL far from the origin), MIEN_E_UNSUPPORTED_OPTION (pixels, in a build
 * without image coders), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V + #F), and writing the images
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
 * The number of mesh formats, counted by file extension.
 *
 * @errors none
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API uint32_t MIEN_CALL mien_mesh_format_count(void);

/**
 * The extension of a mesh format: lower case, without its dot, e.g. "ply".
 *
 * @param format [in] 0 to mien_mesh_format_count() - 1; null is returned for others.
 * @errors none
 * @owner  static text, never freed
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API const char* MIEN_CALL mien_mesh_format_extension(uint32_t format);

/**
 * What a mesh format is called, for people, e.g. "Stanford PLY".
 *
 * @param format [in] 0 to mien_mesh_format_count() - 1; null is returned for others.
 * @errors none
 * @owner  static text, never freed
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API const char* MIEN_CALL mien_mesh_format_description(uint32_t format);

/**
 * 1 for a format that mien_mesh_save() writes, 0 for one that is only read.
 *
 * @param format [in] 0 to mien_mesh_format_count() - 1; 0 is returned for others.
 * @errors none
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API int32_t MIEN_CALL mien_mesh_format_writes(uint32_t format);

/**
 * Copies the texture coordinates, #T x 2 float32: (0, 0) is the lower left corner of the image,
 * (1, 1) the upper right. The count is 0 when the mesh has none.
 *
 * @param mesh     [in] not null.
 * @param dst      [out] room for capacity rows of 2, or null.
 * @param capacity [in] rows that dst holds.
 * @param count    [out] may be null; #T or 0.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#T)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_texture(const mien_mesh* mesh, float* dst,
                                                     uint64_t capacity, uint64_t* count,
                                                     mien_error* error);

/**
 * Copies for each corner of each triangle the number of its texture coordinate, #F x 3 uint32. The
 * count is 0 when the mesh has none.
 *
 * @param mesh     [in] not null.
 * @param dst      [out] room for capacity rows of 3, or null.
 * @param capacity [in] rows that dst holds.
 * @param count    [out] may be null; #F or 0.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_texture_triangles(const mien_mesh* mesh, uint32_t* dst,
                                                               uint64_t capacity, uint64_t* count,
                                                               mien_error* error);

/**
 * Copies the number of each triangle's material, #F uint32. The count is 0 when the mesh has no
 * material, or a single one that all triangles have.
 *
 * @param mesh     [in] not null.
 * @param dst      [out] room for capacity numbers, or null.
 * @param capacity [in] numbers that dst holds.
 * @param count    [out] may be null; #F or 0.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#F)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_triangle_materials(const mien_mesh* mesh,
                                                                uint32_t* dst, uint64_t capacity,
                                                                uint64_t* count, mien_error* error);

/**
 * Numbers of materials and of images.
 *
 * @param mesh           [in] not null.
 * @param material_count [out] may be null.
 * @param image_count    [out] may be null.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_material_counts(const mien_mesh* mesh,
                                                             uint64_t* material_count,
                                                             uint64_t* image_count,
                                                             mien_error* error);

/**
 * A material: its base colour and the number of its base colour's image.
 *
 * @param mesh     [in] not null.
 * @param material [in] 0 to the number of materials - 1.
 * @param image    [out] may be null; -1: none.
 * @param red      [out] may be null; 0 to 1.
 * @param green    [out] may be null; 0 to 1.
 * @param blue     [out] may be null; 0 to 1.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_material(const mien_mesh* mesh, uint64_t material,
                                                      int32_t* image, double* red, double* green,
                                                      double* blue, mien_error* error);

/**
 * Copies a material's name, UTF-8 with its terminating zero.
 *
 * @param mesh     [in] not null.
 * @param material [in] 0 to the number of materials - 1.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(length)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_material_name(const mien_mesh* mesh, uint64_t material,
                                                           char* dst, uint64_t capacity,
                                                           uint64_t* count, mien_error* error);

/**
 * Copies an image's file name without a folder, UTF-8 with its terminating zero.
 *
 * @param mesh     [in] not null.
 * @param image    [in] 0 to the number of images - 1.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(length)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_image_name(const mien_mesh* mesh, uint64_t image,
                                                        char* dst, uint64_t capacity,
                                                        uint64_t* count, mien_error* error);

/**
 * Copies the bytes of an image's file as they were read. The count is 0 for pixels of a host's.
 *
 * @param mesh     [in] not null.
 * @param image    [in] 0 to the number of images - 1.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(bytes)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_image_file(const mien_mesh* mesh, uint64_t image,
                                                        uint8_t* dst, uint64_t capacity,
                                                        uint64_t* count, mien_error* error);

/**
 * The width and height of an image in pixels, from its header.
 *
 * @param mesh   [in] not null.
 * @param image  [in] 0 to the number of images - 1.
 * @param width  [out] may be null; pixels.
 * @param height [out] may be null; pixels.
 * @param error  [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image), MIEN_E_BAD_FORMAT
 * (damaged), MIEN_E_UNSUPPORTED_OPTION (neither JPEG nor PNG, or above 134 million pixels)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1), of a JPEG O(its bytes before the first frame)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_image_size(const mien_mesh* mesh, uint64_t image,
                                                        uint32_t* width, uint32_t* height,
                                                        mien_error* error);

/**
 * Decodes an image into height rows of width x 3 red green blue bytes, from the top.
 *
 * @param session          [in] not null.
 * @param mesh             [in] not null.
 * @param image            [in] 0 to the number of images - 1.
 * @param row_stride_bytes [in] bytes from row to row of dst, at least 3 * width; 0: tightly packed.
 * @param dst              [out] room for capacity bytes, or null; bytes between rows stay as they
 *                         are.
 * @param capacity         [in] bytes that dst holds.
 * @param count            [out] may be null; bytes from the first to the last of the pixels.
 * @param error            [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image, stride below a row),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_BAD_FORMAT (damaged),
 * MIEN_E_UNSUPPORTED_OPTION (another kind, or a build without image decoders),
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(width * height)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_get_image_pixels(mien_session* session,
                                                          const mien_mesh* mesh, uint64_t image,
                                                          uint64_t row_stride_bytes, uint8_t* dst,
                                                          uint64_t capacity, uint64_t* count,
                                                          mien_error* error);

/**
 * Writes a GLB file of a mesh and named changes of it (glTF's morph targets): an expression model's
 * blendshapes in one file. Each target is the whole changed mesh, with the vertices of `mesh`.
 *
 * @param session      [in] not null.
 * @param mesh         [in] not null.
 * @param targets      [in] target_count meshes, not null unless target_count is 0.
 * @param names        [in] target_count UTF-8 names, not null unless target_count is 0.
 * @param target_count [in] at most 100000.
 * @param path         [in] UTF-8, not null; ends with .glb.
 * @param error        [out] may be null; detail_index is the first target that does not fit.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (another extension), MIEN_E_MISMATCH
 * (vertex counts), MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(target_count * #V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_save_targets(mien_session* session, const mien_mesh* mesh,
                                                      const mien_mesh* const* targets,
                                                      const char* const* names,
                                                      uint64_t target_count, const char* path,
                                                      mien_error* error);

/**
 * Reads a glTF file with one of its morph targets at full weight.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null; .glb or .gltf.
 * @param name    [in] UTF-8 name of the target, not null.
 * @param out     [out] not null; the changed mesh, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_NOT_FOUND (no such target; the message names some), otherwise as mien_mesh_load()
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_mesh_load_target(mien_session* session, const char* path,
                                                     const char* name, mien_mesh** out,
                                                     mien_error* error);

/**
 * The positions in place: *data points to #V x 3 float64, tightly packed, mm.
 *
 * @param mesh  [in] not null.
 * @param data  [out,count=count*3] not null.
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
 * Adds a reference: each retain needs a release of its own. What a registration or a model lends as
 * const mien_mesh* becomes the caller's own this way.
 *
 * @param mesh [in] may be null.
 * @return the same mesh, to be released; null for null and for what is no mesh.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_mesh* MIEN_CALL mien_mesh_retain(const mien_mesh* mesh);

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

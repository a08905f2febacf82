/* Mien: datasets, a study's faces in correspondence. */
#ifndef MIEN_DATASET_H
#define MIEN_DATASET_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Collects faces with a subject and an expression each, then saves them as one safetensors file:
 *  vertices f32 [s, n, 3], subject i32 [s], expression i32 [s], triangles u32 [m, 3]. Externally
 *  synchronized. */
typedef struct mien_dataset_writer mien_dataset_writer;

/**
 * Starts a dataset in the topology of a mesh.
 *
 * @param session          [in] not null.
 * @param topology         [in] not null; its triangles and vertex count hold for all faces.
 * @param expression_names [in] not null; expression_count UTF-8 names. One should be "neutral".
 * @param expression_count [in] 1 to 1000000.
 * @param out              [out] not null; the writer, or null on failure.
 * @param error            [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_dataset_writer_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_dataset_writer_create(
    mien_session* session, const mien_mesh* topology, const char* const* expression_names,
    uint32_t expression_count, mien_dataset_writer** out, mien_error* error);

/**
 * Adds one face; its positions are copied.
 *
 * @param writer     [in] not null.
 * @param positions  [in] not null; #V x 3, F32 or F64, mm.
 * @param subject    [in] any number that names the person.
 * @param expression [in] index into the expression names.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
 * MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by writer
 * @cancel no
 * @cost   O(#V), 12 #V bytes
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_dataset_writer_add(mien_dataset_writer* writer,
                                                       const mien_array_view* positions,
                                                       int32_t subject, int32_t expression,
                                                       mien_error* error);

/**
 * Writes all faces added so far. Atomic; more may be added and saved again.
 *
 * @param session [in] not null.
 * @param writer  [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no face), MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session and writer
 * @cancel no
 * @cost   O(faces x #V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_dataset_writer_save(mien_session* session,
                                                        const mien_dataset_writer* writer,
                                                        const char* path, mien_error* error);

/**
 * Releases a writer.
 *
 * @param writer [in] may be null.
 * @errors none
 * @owner  *writer is gone afterwards
 * @thread no other call may use the writer
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_dataset_writer_release(mien_dataset_writer* writer);

#ifdef __cplusplus
}
#endif
#endif

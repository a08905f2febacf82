/* Mien: faces as numbers for learning, and back. All faces of one call share the topology of the
 * dataset. */
#ifndef MIEN_REPRESENTATION_H
#define MIEN_REPRESENTATION_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A trained representation of faces: numbers for learning, with their exact inverse. Immutable:
 * share freely. */
typedef struct mien_representation mien_representation;

/** Representations. */
enum {
    MIEN_FEATURES_EUCLIDEAN = 1,
    MIEN_FEATURES_EUCLIDEAN_STANDARDISED = 2,
    MIEN_FEATURES_EUCLIDEAN_NORMALISED = 3,
    MIEN_FEATURES_DEFORMATION = 4,
    MIEN_FEATURES_DEFORMATION_NORMALISED = 5,
    MIEN_FEATURES_DEFORMATION_STANDARDISED = 6
};

/**
 * mien_representation_train_with_options() without progress and cancel.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; a dataset file.
 * @param kind         [in] MIEN_FEATURES_...
 * @param neutral_only [in] 1: only the faces marked neutral; 0: all.
 * @param out          [out] not null; the representation, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
 * neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
 * MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_representation_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   five passes over the faces; one face in memory at a time
 * @since  0.1
 * @source kosk-2024 3.2 to 3.19
 */
MIEN_API mien_status MIEN_CALL mien_representation_train(mien_session* session,
                                                         const char* dataset_path, int32_t kind,
                                                         int32_t neutral_only,
                                                         mien_representation** out,
                                                         mien_error* error);

/** How to train; initialise with mien_representation_options_init(). */
typedef struct mien_representation_options {
    uint32_t struct_size;
    int32_t neutral_only;      /**< 1: only the faces marked neutral; default 0: all */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_representation_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_representation_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_representation_options_init(mien_representation_options* options,
                                                         size_t struct_size);

/**
 * Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; a dataset file.
 * @param kind         [in] MIEN_FEATURES_...
 * @param options      [in] may be null: all faces.
 * @param out          [out] not null; the representation, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
 * neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
 * MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_representation_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   five passes over the faces; one face in memory at a time
 * @since  0.2
 * @source kosk-2024 3.2 to 3.19
 */
MIEN_API mien_status MIEN_CALL mien_representation_train_with_options(
    mien_session* session, const char* dataset_path, int32_t kind,
    const mien_representation_options* options, mien_representation** out, mien_error* error);

/**
 * Opens a representation file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the representation, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_representation_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size); deformations factorise their template once
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_load(mien_session* session, const char* path,
                                                        mien_representation** out,
                                                        mien_error* error);

/**
 * Writes a representation file (safetensors). Atomic.
 *
 * @param session        [in] not null.
 * @param representation [in] not null.
 * @param path           [in] UTF-8, not null.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_save(mien_session* session,
                                                        const mien_representation* representation,
                                                        const char* path, mien_error* error);

/**
 * Numbers of vertices and of features a vertex.
 *
 * @param representation [in] not null.
 * @param vertex_count   [out] may be null; #V.
 * @param channel_count  [out] may be null; 3, or 9 for deformations.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL
mien_representation_get_counts(const mien_representation* representation, uint64_t* vertex_count,
                               uint64_t* channel_count, mien_error* error);

/**
 * The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count
 * only.
 *
 * @param session        [in] not null.
 * @param representation [in] not null.
 * @param face           [in] not null; #V vertices, mm, anywhere.
 * @param motion         [out] may be null; 12 float64: the rigid motion onto the mean, x -> R x +
 * t, as R row by row, then t in mm. mien_representation_decode() takes it back.
 * @param dst            [out] room for capacity rows of channel_count values, or null.
 * @param capacity       [in] rows that dst holds.
 * @param count          [out] may be null; #V.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V); deformations two sparse solves
 * @since  0.1
 * @source kosk-2024 2.5, 3.14 to 3.19, 4.12
 */
MIEN_API mien_status MIEN_CALL mien_representation_encode(mien_session* session,
                                                          const mien_representation* representation,
                                                          const mien_mesh* face, double* motion,
                                                          double* dst, uint64_t capacity,
                                                          uint64_t* count, mien_error* error);

/**
 * The face that has these features.
 *
 * @param session        [in] not null.
 * @param representation [in] not null.
 * @param features       [in] not null; row_count x channel_count row-major float64.
 * @param row_count      [in] #V.
 * @param motion         [in] may be null: the mean's frame; 12 float64 of
 * mien_representation_encode(), which is undone.
 * @param out            [out] not null; the face, mm, or null on failure.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
 * MIEN_E_MISMATCH (row_count), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V); deformations one sparse solve
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_representation_decode(mien_session* session,
                                                          const mien_representation* representation,
                                                          const double* features,
                                                          uint64_t row_count, const double* motion,
                                                          mien_mesh** out, mien_error* error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param representation [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_representation_retain(mien_representation* representation);

/**
 * Gives one reference back; the last one frees the representation.
 *
 * @param representation [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_representation_release(mien_representation* representation);

#ifdef __cplusplus
}
#endif
#endif

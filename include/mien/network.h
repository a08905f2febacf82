/* Mien: trained networks on registered faces: a face becomes a short code, a code a face. Networks
 * are trained by the program mien-train, never here; nothing but this library is needed to run
 * them. */
#ifndef MIEN_NETWORK_H
#define MIEN_NETWORK_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A trained network with everything that belongs to it: layers, weights, neighbour lists and
 * statistics of one template. Immutable: share freely. */
typedef struct mien_network mien_network;

/** How to run; initialise with mien_network_options_init(). */
typedef struct mien_network_options {
    uint32_t struct_size;
    uint32_t reserved;   /**< zero */
    mien_cancel* cancel; /**< may be null; looked at between layers */
} mien_network_options;

/** What to evaluate; initialise with mien_network_evaluation_options_init(). */
typedef struct mien_network_evaluation_options {
    uint32_t struct_size;
    int32_t neutral_only;    /**< 1: only the faces marked neutral; default 0: all */
    int32_t perceptual;      /**< 1 (default): DAME and FMPD too; 0: distances alone */
    uint32_t reserved;       /**< zero */
    const int32_t* subjects; /**< faces of these subjects; null: of all */
    uint64_t subject_count;
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_network_evaluation_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_network_evaluation_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL
mien_network_evaluation_options_init(mien_network_evaluation_options* options, size_t struct_size);

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_network_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_network_options_init(mien_network_options* options,
                                                  size_t struct_size);

/**
 * Loads a network file through a memory map and checks all of it: structure, hash, finite weights,
 * every index of every list. A file is treated as hostile.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the network, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_MEMORY_BUDGET,
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_network_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_network_load(mien_session* session, const char* path,
                                                 mien_network** out, mien_error* error);

/**
 * Loads a network from the bytes of a network file that the host holds in memory, e.g. as a
 * resource of its program. The bytes are copied.
 *
 * @param session [in] not null.
 * @param data    [in] not null; size bytes.
 * @param size    [in] bytes of the file.
 * @param out     [out] not null; the network, or null on failure.
 * @param error   [out] may be null.
 * @errors as mien_network_load(), without MIEN_E_IO
 * @owner  the caller releases *out with mien_network_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(size), and as much memory
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_network_load_memory(mien_session* session, const void* data,
                                                        uint64_t size, mien_network** out,
                                                        mien_error* error);

/**
 * Numbers of vertices of the faces and of numbers in a code.
 *
 * @param network      [in] not null.
 * @param vertex_count [out] may be null; #V.
 * @param code_count   [out] may be null; numbers of a code.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_network_get_counts(const mien_network* network,
                                                       uint64_t* vertex_count, uint64_t* code_count,
                                                       mien_error* error);

/**
 * What the network is, as JSON: name, sizes, features, layers with their multiply-adds, and what
 * its training wrote down.
 *
 * @param network  [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(layers)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_network_get_json(const mien_network* network, char* dst,
                                                     uint64_t capacity, uint64_t* count,
                                                     mien_error* error);

/**
 * The mean face of the network's training, in whose frame codes are decoded.
 *
 * @param network [in] not null.
 * @param out     [out] not null; the face, mm, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_network_get_mean(const mien_network* network, mien_mesh** out,
                                                     mien_error* error);

/**
 * The code of a face. With dst null and capacity 0: writes the count only.
 *
 * @param session  [in] not null.
 * @param network  [in] not null; with an encoder.
 * @param face     [in] not null; #V vertices in the network's topology, mm, anywhere.
 * @param options  [in] may be null: defaults.
 * @param motion   [out] may be null; 12 float64: the rigid motion onto the mean, x -> R x + t, as R
 * row by row, then t in mm. mien_network_decode() takes it back.
 * @param dst      [out] room for capacity values, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; numbers of the code.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (no encoder),
 * MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_MISMATCH (vertex count),
 * MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION (no rigid motion; a result that is not
 * finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   mien_network_get_json() tells the multiply-adds; about 5 ms for a face of 11000 vertices
 * @since  0.2
 * @source kosk-2024 chapter 3
 */
MIEN_API mien_status MIEN_CALL mien_network_encode(mien_session* session,
                                                   const mien_network* network,
                                                   const mien_mesh* face,
                                                   const mien_network_options* options,
                                                   double* motion, double* dst, uint64_t capacity,
                                                   uint64_t* count, mien_error* error);

/**
 * The face of a code.
 *
 * @param session    [in] not null.
 * @param network    [in] not null; with a decoder.
 * @param code       [in] not null; code_count finite values.
 * @param code_count [in] numbers of the code.
 * @param motion     [in] may be null: the mean's frame; 12 float64 of mien_network_encode(), which
 * is undone.
 * @param options    [in] may be null: defaults.
 * @param out        [out] not null; the face, mm, or null on failure.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
 * MIEN_E_UNSUPPORTED_OPTION (no decoder), MIEN_E_MISMATCH (code_count), MIEN_E_NO_SOLUTION (a
 * result that is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   as mien_network_encode(), about four times as much
 * @since  0.2
 * @source kosk-2024 chapter 3
 */
MIEN_API mien_status MIEN_CALL mien_network_decode(mien_session* session,
                                                   const mien_network* network, const double* code,
                                                   uint64_t code_count, const double* motion,
                                                   const mien_network_options* options,
                                                   mien_mesh** out, mien_error* error);

/**
 * The decoded face of a face's code, in the frame of that face: an autoencoder's reconstruction, or
 * what the network was trained to make of a face (a neutral one into an expression). Networks on
 * deformations, which know no place, have their result put onto the face rigidly.
 *
 * @param session [in] not null.
 * @param network [in] not null; with encoder and decoder.
 * @param face    [in] not null; #V vertices in the network's topology, mm, anywhere.
 * @param options [in] may be null: defaults.
 * @param out     [out] not null; the face, mm, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is
 * missing), MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION,
 * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   the sum of mien_network_encode() and mien_network_decode()
 * @since  0.2
 * @source kosk-2024 chapters 3 and 5
 */
MIEN_API mien_status MIEN_CALL mien_network_apply(mien_session* session,
                                                  const mien_network* network,
                                                  const mien_mesh* face,
                                                  const mien_network_options* options,
                                                  mien_mesh** out, mien_error* error);

/**
 * How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as
 * means over the faces and by face. Judge a network on people that it was not trained on.
 *
 * @param session      [in] not null.
 * @param network      [in] not null; with encoder and decoder.
 * @param dataset_path [in] UTF-8, not null; a dataset file in the network's topology.
 * @param options      [in] may be null: all faces.
 * @param dst          [out] room for capacity bytes, or null.
 * @param capacity     [in] bytes that dst holds.
 * @param count        [out] may be null; bytes with the terminating zero.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is
 * missing, a switch), MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such face), MIEN_E_IO,
 * MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   mien_network_apply() a face; DAME and FMPD about 0.1 s a face of 10000 vertices; the size
 * is not known before the work is done, so give room at once (200 bytes and 80 a face)
 * @since  0.2
 * @source kosk-2024 3.3.10
 */
MIEN_API mien_status MIEN_CALL mien_network_evaluate(mien_session* session,
                                                     const mien_network* network,
                                                     const char* dataset_path,
                                                     const mien_network_evaluation_options* options,
                                                     char* dst, uint64_t capacity, uint64_t* count,
                                                     mien_error* error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param network [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_network_retain(mien_network* network);

/**
 * Gives one reference back; the last one frees the network.
 *
 * @param network [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_network_release(mien_network* network);

#ifdef __cplusplus
}
#endif
#endif

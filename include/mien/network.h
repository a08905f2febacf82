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
 * statistics of one template. It may be one network, or two over the low and the high frequencies
 * of a face, joined by spectral assembly; the code of the latter holds first the low band's
 * numbers, then the high band's. Immutable: share freely. */
typedef struct mien_network mien_network;

/** How to run; initialise with mien_network_options_init(). */
typedef struct mien_network_options {
    uint32_t struct_size;
    uint32_t reserved;   /**< zero */
    mien_cancel* cancel; /**< may be null; looked at between layers */
    int64_t band_limit;  /**< mien_network_apply() of a network that adds an expression in two
                            bands: modes of the low one; default 0: the file's own; negative: none,
                            deformations alone; more than the file's basis has: coordinates alone */
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
 * MIEN_E_UNSUPPORTED_OPTION (no decoder; a network that adds an expression), MIEN_E_MISMATCH
 * (code_count), MIEN_E_NO_SOLUTION (a result that is not finite), MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
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
 * what the network was trained to make of a face (a neutral one into an expression, with what is
 * the person's own kept). Networks on deformations, which know no place, have their result put onto
 * the face rigidly; one that deforms a neutral face alone keeps that one's centre.
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
 * Which numbers of a code belong to which band. Editing some of them changes that band of the
 * decoded face (and the other one as far as its decoder was conditioned).
 *
 * @param network        [in] not null.
 * @param low_code_count [out] may be null; numbers of the low band's code, which come first; all
 * numbers of a network without bands.
 * @param band_limit     [out] may be null; modes of the low band; -1 for a network without bands.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 * @source kosk-2024 4.11
 */
MIEN_API mien_status MIEN_CALL mien_network_get_bands(const mien_network* network,
                                                      uint64_t* low_code_count, int64_t* band_limit,
                                                      mien_error* error);

/**
 * A face between two, or with the bands of both: each band's code goes from a's to b's by its own
 * weight and is decoded. Weights 0 and 0 give a as the network gives it back, 1 and 0 or 0 and 1
 * exchange a band, equal ones interpolate. A network without bands takes the first weight.
 *
 * @param session     [in] not null.
 * @param network     [in] not null; with encoder and decoder.
 * @param a           [in] not null; #V vertices in the network's topology, mm, anywhere.
 * @param b           [in] not null; #V vertices in the network's topology, mm, anywhere.
 * @param low_weight  [in] of the low band; any finite number.
 * @param high_weight [in] of the high band; any finite number.
 * @param options     [in] may be null: defaults.
 * @param out         [out] not null; the face in the frame of a, mm, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a weight that is not finite),
 * MIEN_E_UNSUPPORTED_OPTION (a half is missing; a network that adds an expression), MIEN_E_MISMATCH
 * (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   twice mien_network_encode() and once mien_network_decode()
 * @since  0.2
 * @source kosk-2024 4.16, 4.19
 */
MIEN_API mien_status MIEN_CALL mien_network_mix(mien_session* session, const mien_network* network,
                                                const mien_mesh* a, const mien_mesh* b,
                                                double low_weight, double high_weight,
                                                const mien_network_options* options,
                                                mien_mesh** out, mien_error* error);

/**
 * The code of a made-up face: drawn from a Gaussian over the codes of the training faces, which the
 * file holds. Number and seed alone decide. With dst null and capacity 0: writes the count only.
 *
 * @param network  [in] not null; with a distribution of codes.
 * @param seed     [in] of the chance.
 * @param number   [in] of the code within the seed's series.
 * @param spread   [in] 0 the mean code, 1 as far apart as the training faces; not negative.
 * @param dst      [out] room for capacity values, or null.
 * @param capacity [in] values that dst holds.
 * @param count    [out] may be null; numbers of the code.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (spread), MIEN_E_UNSUPPORTED_OPTION (no
 * distribution in the file), MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(code squared)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_network_sample(const mien_network* network, uint64_t seed,
                                                   uint64_t number, double spread, double* dst,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error);

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
 * missing, a switch, a network that adds an expression), MIEN_E_MISMATCH (vertex count),
 * MIEN_E_NOT_FOUND (no such face), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
 * MIEN_E_NO_SOLUTION, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written), MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED
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

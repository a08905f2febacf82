/* Mien: expression models: load, save, ask, make faces. */
#ifndef MIEN_EXPRESSION_H
#define MIEN_EXPRESSION_H

#include "registration.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What was learned of faces and expressions: an identity subspace, an expression subspace, a prior
 * of both. Immutable: share freely between threads. */
typedef struct mien_expression_model mien_expression_model;

/**
 * Loads a model file. The file is treated as hostile; the modes stay in the mapped file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION,
 * MIEN_E_CORRUPT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_load(mien_session* session, const char* path,
                                                          mien_expression_model** out,
                                                          mien_error* error);

/**
 * Loads a model from the bytes of a model file that the host holds in memory. They are copied and
 * checked like a file.
 *
 * @param session [in] not null.
 * @param data    [in] not null; size bytes, any alignment; not read after the call.
 * @param size    [in] of the whole file, bytes.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
 *         MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_expression_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(size), and as much memory
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_load_memory(mien_session* session,
                                                                 const void* data, uint64_t size,
                                                                 mien_expression_model** out,
                                                                 mien_error* error);

/**
 * Writes a model file (safetensors, kind "mien-expression-model"). Atomic.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_save(mien_session* session,
                                                          const mien_expression_model* model,
                                                          const char* path, mien_error* error);

/**
 * Adds a reference.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  each retain needs one release
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_expression_model_retain(mien_expression_model* model);

/**
 * Drops a reference; the last one frees the model. Neutralizations keep what they need.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_expression_model_release(mien_expression_model* model);

/**
 * Numbers of vertices and modes.
 *
 * @param model            [in] not null.
 * @param vertex_count     [out] may be null; #V.
 * @param identity_modes   [out] may be null.
 * @param expression_modes [out] may be null.
 * @param error            [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_get_counts(const mien_expression_model* model,
                                                                uint64_t* vertex_count,
                                                                uint32_t* identity_modes,
                                                                uint32_t* expression_modes,
                                                                mien_error* error);

/**
 * What the model is, and after training how the training went, as a JSON object: sizes,
 * expressions, noise levels, iterations, orthogonality score per number of components, explained
 * shares.
 *
 * @param model    [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds; with dst null and 0 only the count is written.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(count)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_get_json(const mien_expression_model* model,
                                                              char* dst, uint64_t capacity,
                                                              uint64_t* count, mien_error* error);

/**
 * A face made from coordinates: mean + identity modes x identity + expression modes x expression.
 *
 * @param session    [in] not null.
 * @param model      [in] not null.
 * @param identity   [in] count identity_modes, F32 or F64, mm; count 0 (or null): the mean
 * identity.
 * @param expression [in] count expression_modes, F32 or F64, mm; count 0 (or null): neutral.
 * @param out        [out] not null; the mesh, or null on failure.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V modes)
 * @since  0.1
 * @source jousse-2022 4.2
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_synthesize(mien_session* session,
                                                                const mien_expression_model* model,
                                                                const mien_array_view* identity,
                                                                const mien_array_view* expression,
                                                                mien_mesh** out, mien_error* error);

/**
 * A random face of the model: identity coordinates from their Gaussian, expression coordinates from
 * the prior of one expression.
 *
 * @param session    [in] not null.
 * @param model      [in] not null.
 * @param seed       [in] any number; the same seed gives the same face on every machine.
 * @param expression [in] name of an expression of the model, "neutral", "any" (all expressions
 * together), or null: neutral without any expression.
 * @param out        [out] not null; the mesh, or null on failure.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V modes)
 * @since  0.1
 * @source jousse-2022 4.2, figure 4.4
 */
MIEN_API mien_status MIEN_CALL mien_expression_model_sample(mien_session* session,
                                                            const mien_expression_model* model,
                                                            uint64_t seed, const char* expression,
                                                            mien_mesh** out, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

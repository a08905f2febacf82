/* Mien: expressions of a person from the neutral face: carried over from somebody else, or
 * predicted. All faces of one call share a topology. */
#ifndef MIEN_BLENDSHAPES_H
#define MIEN_BLENDSHAPES_H

#include "spectral.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Predicts one expression of a person from the neutral face. Immutable: share freely. */
typedef struct mien_blendshape_model mien_blendshape_model;

/**
 * Carries an expression from one face to another by deformation transfer.
 *
 * @param session           [in] not null.
 * @param source_neutral    [in] not null; #V vertices, mm.
 * @param source_expression [in] not null; the same person with the expression.
 * @param target_neutral    [in] not null; #V vertices, mm; its triangles hold for all.
 * @param out               [out] not null; the target with the expression, or null on failure.
 * @param error             [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no
 * triangles), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   one sparse factorisation of size #V
 * @since  0.1
 * @source Sumner & Popovic 2004; kosk-2024 5.2.3
 */
MIEN_API mien_status MIEN_CALL mien_transfer_expression(mien_session* session,
                                                        const mien_mesh* source_neutral,
                                                        const mien_mesh* source_expression,
                                                        const mien_mesh* target_neutral,
                                                        mien_mesh** out, mien_error* error);

/** Initialise with mien_blendshape_options_init(). */
typedef struct mien_blendshape_options {
    uint32_t struct_size;
    uint32_t reserved; /**< zero */
    double ridge;      /**< of the kernel's mean diagonal; default 0: by leave-one-out error */
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_blendshape_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_blendshape_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_blendshape_options_init(mien_blendshape_options* options,
                                                     size_t struct_size);

/**
 * Learns to predict one expression from the neutral face, on every subject of a dataset that has
 * both.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; a dataset file whose names include "neutral".
 * @param expression   [in] UTF-8, not null; a name of the dataset.
 * @param options      [in] may be null.
 * @param out          [out] not null; the model, or null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge),
 * MIEN_E_NOT_FOUND (expression), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_blendshape_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   96 bytes a vertex and subject; a sparse factorisation a subject
 * @since  0.1
 * @source kosk-2024 5.3, with kernel ridge regression in the place of the networks
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_train(
    mien_session* session, const char* dataset_path, const char* expression,
    const mien_blendshape_options* options, mien_blendshape_model** out, mien_error* error);

/**
 * Opens a blendshape model file.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the model, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_CORRUPT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_blendshape_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_load(mien_session* session, const char* path,
                                                          mien_blendshape_model** out,
                                                          mien_error* error);

/**
 * Writes a blendshape model file (safetensors). Atomic.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   96 bytes a vertex and subject
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_save(mien_session* session,
                                                          const mien_blendshape_model* model,
                                                          const char* path, mien_error* error);

/**
 * The mean of the neutral training faces, centred: the mesh that a basis for this model is built
 * on.
 *
 * @param model [in] not null.
 * @param out   [out] not null; the mesh, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V + #F)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_get_mean(const mien_blendshape_model* model,
                                                              mien_mesh** out, mien_error* error);

/**
 * A person's expression from the neutral face, in its frame.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param basis   [in] may be null: then k = 0 gives the deformations' prediction, any other k the
 * coordinates'.
 * @param k       [in] low frequencies from the coordinates' prediction, high ones from the
 * deformations'; 0 to the basis' modes, #V or more: coordinates alone.
 * @param neutral [in] not null; #V vertices, mm.
 * @param out     [out] not null; the predicted expression, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts),
 * MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(subjects x #V) and one sparse factorisation
 * @since  0.1
 * @source kosk-2024 5.10
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_predict(mien_session* session,
                                                             const mien_blendshape_model* model,
                                                             const mien_spectral_basis* basis,
                                                             uint64_t k, const mien_mesh* neutral,
                                                             mien_mesh** out, mien_error* error);

/** One tried k of mien_blendshape_model_search(). */
typedef struct mien_band_choice {
    uint64_t k;
    double l1_mm;
    double dame;
    double fmpd;
    int32_t on_front; /**< 1: no other k is better in both L1 and FMPD */
    int32_t chosen;   /**< 1: the front's knee */
} mien_band_choice;

/**
 * Tries values of k on a dataset's subjects that the model was not trained on.
 *
 * @param session      [in] not null.
 * @param model        [in] not null.
 * @param basis        [in] not null.
 * @param dataset_path [in] UTF-8, not null; subjects with a neutral face and the expression.
 * @param expression   [in] UTF-8, not null.
 * @param candidates   [in] not null; candidate_count values of k; above the basis' modes:
 * coordinates alone.
 * @param candidate_count [in] 1 to 10000.
 * @param options      [in] may be null; its ridge is not read.
 * @param choices      [out] not null; candidate_count results.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression),
 * MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   a prediction a subject, an assembly and two metrics a candidate
 * @since  0.1
 * @source kosk-2024 5.3.4, figure 5.8
 */
MIEN_API mien_status MIEN_CALL mien_blendshape_model_search(
    mien_session* session, const mien_blendshape_model* model, const mien_spectral_basis* basis,
    const char* dataset_path, const char* expression, const uint64_t* candidates,
    uint32_t candidate_count, const mien_blendshape_options* options, mien_band_choice* choices,
    mien_error* error);

/**
 * Adds a reference: each retain needs a release of its own.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  the caller holds one more reference
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_blendshape_model_retain(mien_blendshape_model* model);

/**
 * Gives one reference back; the last one frees the model.
 *
 * @param model [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_blendshape_model_release(mien_blendshape_model* model);

#ifdef __cplusplus
}
#endif
#endif

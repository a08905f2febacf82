/* Mien: scans that are fitted more than once, and many scans at a time. */
#ifndef MIEN_BATCH_H
#define MIEN_BATCH_H

#include "registration.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A scan that was cleaned, wound, weighed and put into a search tree, for any number of models and
 * fits. Immutable: share freely. */
typedef struct mien_ready_scan mien_ready_scan;

/** Scans to be fitted side by side with one model, and their fits. */
typedef struct mien_batch mien_batch;

/** Initialise with mien_batch_options_init(). */
typedef struct mien_batch_options {
    uint32_t struct_size;
    uint32_t reserved; /**< zero */
    mien_progress_fn
        progress; /**< may be null; called between some scans, in the stage of fitting */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
} mien_batch_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_batch_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_batch_options_init(mien_batch_options* options, size_t struct_size);

/**
 * Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked
 * for.
 *
 * @param session [in] not null.
 * @param scan    [in] not null; as for mien_register().
 * @param options [in] may be null: defaults. Of it units, unit_to_mm, scan_weights, skin_weights,
 * progress and cancel are read.
 * @param out     [out] not null; the prepared scan, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
 * (scan_weights), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
 * MIEN_E_CANCELLED, MIEN_E_CALLBACK
 * @owner  the caller releases *out with mien_ready_scan_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(#F log #F) time, O(#F) bytes
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_ready_scan_create(mien_session* session, const mien_mesh* scan,
                                                      const mien_register_options* options,
                                                      mien_ready_scan** out, mien_error* error);

/**
 * mien_register() of a prepared scan: the same bits where the scan's unit is known or that which
 * its size tells.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param scan    [in] not null.
 * @param options [in] may be null: no landmarks, all defaults. What mien_ready_scan_create() reads
 * is not read again, but for progress and cancel.
 * @param out     [out] not null; the registration, or null on failure.
 * @param error   [out] may be null.
 * @errors as mien_register()
 * @owner  the caller releases *out with mien_registration_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   that of mien_register() without cleaning and tree
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_ready_scan_register(mien_session* session,
                                                        const mien_model* model,
                                                        const mien_ready_scan* scan,
                                                        const mien_register_options* options,
                                                        mien_registration** out, mien_error* error);

/**
 * Adds a reference.
 *
 * @param scan [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_ready_scan_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_ready_scan_retain(mien_ready_scan* scan);

/**
 * Releases a prepared scan.
 *
 * @param scan [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_ready_scan_release(mien_ready_scan* scan);

/**
 * An empty batch for a model.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param out     [out] not null; the batch, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_batch_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_batch_create(mien_session* session, const mien_model* model,
                                                 mien_batch** out, mien_error* error);

/**
 * Adds a scan with its own options. The mesh is kept until the scan has been fitted.
 *
 * @param session [in] not null.
 * @param batch   [in] not null.
 * @param scan    [in] not null; as for mien_register().
 * @param options [in] may be null: no landmarks, all defaults. progress and cancel are not read.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (landmarks of which the
 * model knows none), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session and batch
 * @cancel no
 * @cost   O(number of landmarks)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_batch_add(mien_session* session, mien_batch* batch,
                                              const mien_mesh* scan,
                                              const mien_register_options* options,
                                              mien_error* error);

/**
 * Fits all scans that were added and not yet fitted, each on one thread and as many at a time as
 * the session has threads; each with the bits of mien_register(). A scan that cannot be fitted does
 * not end the others: mien_batch_get_registration() says why. Memory is that of as many scans as
 * threads, and of the fits.
 *
 * @param session [in] not null.
 * @param batch   [in] not null.
 * @param options [in] may be null: all defaults.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION,
 * MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK; then no scan of this call is fitted
 * @owner  nothing
 * @thread externally synchronized by session and batch
 * @cancel yes
 * @cost   that of mien_register() for each scan
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_batch_run(mien_session* session, mien_batch* batch,
                                              const mien_batch_options* options, mien_error* error);

/**
 * How many scans were added, and how many of them were run.
 *
 * @param batch      [in] not null.
 * @param scan_count [out] may be null.
 * @param run_count  [out] may be null.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread externally synchronized by batch
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_batch_get_counts(const mien_batch* batch, uint32_t* scan_count,
                                                     uint32_t* run_count, mien_error* error);

/**
 * The fit of one scan, or the error that it ended with.
 *
 * @param batch [in] not null.
 * @param index [in] 0 to run_count - 1, in the order of mien_batch_add().
 * @param out   [out] not null; the registration, or null on failure.
 * @param error [out] may be null.
 * @errors as mien_register(), MIEN_E_NOT_FOUND (no such scan, or it was not run)
 * @owner  the caller releases *out with mien_registration_release()
 * @thread externally synchronized by batch
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_batch_get_registration(const mien_batch* batch, int32_t index,
                                                           mien_registration** out,
                                                           mien_error* error);

/**
 * Adds a reference.
 *
 * @param batch [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_batch_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_batch_retain(mien_batch* batch);

/**
 * Releases a batch; fits that were asked for live on.
 *
 * @param batch [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_batch_release(mien_batch* batch);

#ifdef __cplusplus
}
#endif
#endif

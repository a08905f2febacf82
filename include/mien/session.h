/* Mien: sessions, cancellation, progress and logging. */
#ifndef MIEN_SESSION_H
#define MIEN_SESSION_H

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Threads, limits of memory and time, and logging. Externally synchronized: one call at a time;
 * with more than one thread of its own, a session that is in a call on another thread refuses a
 * second call with MIEN_E_BUSY. A callback may call the library with the session that called it.
 * Objects made in a session may outlive it. */
typedef struct mien_session mien_session;

/** Tells a running call to stop. Thread-safe, sticky, single-use. */
typedef struct mien_cancel mien_cancel;

/** Stages of long work, as a progress callback sees them. */
enum {
    MIEN_STAGE_READING = 1,
    MIEN_STAGE_GEODESICS = 2,
    MIEN_STAGE_BASIS = 3,
    MIEN_STAGE_ALIGNMENT = 4,
    MIEN_STAGE_FITTING = 5,
    MIEN_STAGE_REFINING = 6,
    MIEN_STAGE_TRAINING = 7,
    MIEN_STAGE_NEUTRALIZING = 8,
    MIEN_STAGE_MEASURING = 9,
    MIEN_STAGE_WRITING = 10
};

/** Called on the calling thread only, holding no lock, at fixed points, with a fraction of 0 to 1
 * that never falls within a stage. Non-zero cancels: the call returns MIEN_E_CANCELLED. Must not
 * unwind. */
typedef int32_t(MIEN_CALL* mien_progress_fn)(void* user, int32_t stage, double fraction);

enum { MIEN_LOG_ERROR = 1, MIEN_LOG_WARNING = 2, MIEN_LOG_INFO = 3, MIEN_LOG_DEBUG = 4 };

/** One message without a newline, on the calling thread. Must not unwind. */
typedef void(MIEN_CALL* mien_log_fn)(void* user, int32_t level, const char* message);

/** Initialise with mien_session_options_init(). */
typedef struct mien_session_options {
    uint32_t struct_size;
    int32_t
        num_threads;    /**< 1 (default) to 256; 1 starts no thread. Results do not depend on it. */
    uint64_t max_bytes; /**< memory budget of one call, 0 (default): none. Counted while the call
                         * runs, over all that the library's own code allocates, the result
                         * included; MIEN_E_MEMORY_BUDGET before it would be exceeded. Mapped files
                         * do not count. */
    mien_log_fn log;    /**< null (default): silent. The library never prints. */
    void* log_user;
    double max_seconds; /**< time limit of one call, 0 (default): none, to 1e8; after it a call ends
                         * with MIEN_E_TIME_LIMIT as soon as it would end for a cancel token. Since
                         * 0.2. */
    int32_t copy_files; /**< 0 (default): model files and datasets are mapped, and a file that
                         * another program shortens meanwhile may end the process (as with any
                         * mapping; one that is replaced by renaming, as the library writes, is
                         * safe); 1: they are read into memory. Since 0.2. */
    int32_t reserved;   /**< 0 */
} mien_session_options;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_session_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_session_options_init(mien_session_options* options,
                                                  size_t struct_size);

/**
 * Makes a session with default options: one thread, no memory budget, silent.
 *
 * @param abi_version [in] MIEN_ABI_VERSION of the caller's headers.
 * @param out         [out] not null; the session, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_UNSUPPORTED_VERSION (another ABI), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_session_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_session_create(uint32_t abi_version, mien_session** out,
                                                   mien_error* error);

/**
 * Makes a session with options of the caller.
 *
 * @param abi_version [in] MIEN_ABI_VERSION of the caller's headers.
 * @param options     [in] may be null: defaults.
 * @param out         [out] not null; the session, or null on failure.
 * @param error       [out] may be null.
 * @errors MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_ARGUMENT (num_threads),
 * MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY (also when a thread cannot be started)
 * @owner  the caller releases *out with mien_session_release()
 * @thread thread-safe
 * @cancel no
 * @cost   starts num_threads - 1 threads
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_session_create_with_options(uint32_t abi_version,
                                                                const mien_session_options* options,
                                                                mien_session** out,
                                                                mien_error* error);

/**
 * Ends a session and its threads. Objects that were made in it stay valid.
 *
 * @param session [in] may be null.
 * @errors none
 * @owner  *session is gone afterwards
 * @thread no other call may use the session
 * @cancel no
 * @cost   joins the session's threads
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_session_release(mien_session* session);

/**
 * Makes a cancel token: name it in the options of one call, request it from any thread.
 *
 * @param out   [out] not null; the token, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_cancel_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_cancel_create(mien_cancel** out, mien_error* error);

/**
 * Asks the call that was given this token to return MIEN_E_CANCELLED soon. Sticky.
 *
 * @param cancel [in] may be null: nothing happens.
 * @errors none
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_cancel_request(mien_cancel* cancel);

/**
 * Releases a token. A running call that was given it keeps it alive.
 *
 * @param cancel [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_cancel_release(mien_cancel* cancel);

/**
 * The SHA-256 of a file's bytes as 64 lower-case hexadecimal digits: which model, which scan a
 * result was made from. With dst null and capacity 0: the size only, without reading the file.
 *
 * @param session  [in] not null.
 * @param path     [in] UTF-8, not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero: 65.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BUFFER_TOO_SMALL (dst
 * untouched, count written), MIEN_E_NO_MEMORY, MIEN_E_TIME_LIMIT
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(bytes)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_session_hash_file(mien_session* session, const char* path,
                                                      char* dst, uint64_t capacity, uint64_t* count,
                                                      mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

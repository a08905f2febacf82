/* Mien: statuses and the error record. */
#ifndef MIEN_ERROR_H
#define MIEN_ERROR_H

#include "config.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Result of every fallible function: zero is success, negatives are failures. Hosts must tolerate
 *  values that they do not know. */
typedef int32_t mien_status;
enum {
    MIEN_OK = 0,
    MIEN_E_INVALID_ARGUMENT = -1, /**< a parameter is null or out of its range */
    MIEN_E_INVALID_HANDLE = -2,   /**< a handle is null, released or of another type */
    MIEN_E_INVALID_MESH = -3,     /**< empty, not finite, index out of range, degenerate */
    MIEN_E_BUFFER_TOO_SMALL = -4, /**< the count was written, nothing else */
    MIEN_E_UNSUPPORTED_OPTION =
        -5, /**< an option, a switch or an enumerator that this library does not know */
    MIEN_E_UNSUPPORTED_VERSION = -6, /**< ABI or file format of another major version */
    MIEN_E_NO_MEMORY = -7,           /**< an allocation failed; the session stays usable */
    MIEN_E_MEMORY_BUDGET = -8,       /**< the session's max_bytes would be exceeded */
    MIEN_E_IO = -9,                  /**< a file cannot be opened, read or written */
    MIEN_E_BAD_FORMAT = -10,         /**< a file is not what its format says */
    MIEN_E_CORRUPT = -11,            /**< hash mismatch, or values that are not finite */
    MIEN_E_WRONG_KIND = -12,         /**< a good file of another kind */
    MIEN_E_MISMATCH = -13,           /**< inputs that do not belong together */
    MIEN_E_NO_SOLUTION = -14,        /**< a factorisation or an iteration failed */
    MIEN_E_NOT_FOUND = -15,          /**< an unknown name */
    MIEN_E_CANCELLED = -16,          /**< by a progress callback or a cancel token */
    MIEN_E_CALLBACK = -17,           /**< a callback unwound */
    MIEN_E_INTERNAL = -18,           /**< a defect of the library: please report it */
    MIEN_E_BUSY = -19,               /**< the session is in a call on another thread; since 0.2 */
    MIEN_E_TIME_LIMIT = -20          /**< the session's max_seconds have passed; since 0.2 */
};

/** Detail of the last call that was given this record. Caller-allocated, so that nothing can leak
 * and nothing is allocated when memory has run out. Set struct_size before the first use; every
 * call overwrites the rest. */
typedef struct mien_error {
    uint32_t struct_size; /**< sizeof(mien_error) as the caller knows it. 0, as in a zeroed record,
                           * is taken for the size of the first release. */
    mien_status status;
    int64_t detail_index; /**< first offending index (vertex, triangle, value), or -1 */
    char message[256];    /**< UTF-8, zero-terminated: what, where, what to do. For people. */
} mien_error;

/**
 * The name of a status, e.g. "MIEN_E_IO".
 *
 * @param status  [in] any value; unknown ones give "MIEN_E_UNKNOWN".
 * @errors none
 * @owner  static text, never freed
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API const char* MIEN_CALL mien_status_name(mien_status status);

/**
 * The library's version as MAJOR * 1000000 + MINOR * 1000 + PATCH.
 *
 * @errors none
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API uint32_t MIEN_CALL mien_version_number(void);

/**
 * The library's version as text, e.g. "0.2.0".
 *
 * @errors none
 * @owner  static text, never freed
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API const char* MIEN_CALL mien_version_string(void);

/**
 * What was built, for bug reports: version, compiler, instruction sets in use on this processor.
 *
 * @errors none
 * @owner  static text, never freed
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API const char* MIEN_CALL mien_build_id(void);

#ifdef __cplusplus
}
#endif
#endif

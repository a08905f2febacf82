/* Mien: landmarks and zones as files hold them, and as a model names them. */
#ifndef MIEN_LANDMARKS_H
#define MIEN_LANDMARKS_H

#include "model.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A list of named landmarks: places on a scan, or vertices of a template. Immutable: share freely.
 */
typedef struct mien_landmarks mien_landmarks;

/** A list of named sets of vertices. Immutable: share freely. */
typedef struct mien_zones mien_zones;

/** A named place on a scan, read in place and only during the call. */
typedef struct mien_scan_landmark {
    const char* name;   /**< UTF-8, not null; matched with the names stored in the model */
    double position[3]; /**< in the scan's frame and unit */
} mien_scan_landmark;

/** What is known of a landmark. */
enum {
    MIEN_MARK_NOT_PICKED = 0, /**< null, not a number, "not defined" or a placeholder in its file */
    MIEN_MARK_PLACE = 1,
    MIEN_MARK_VERTEX = 2
};

/**
 * Reads a landmark file, told by its content: this project's JSON ({"points": ...} or {"vertices":
 * ...}), 3D Slicer's .mrk.json and .fcsv (coordinates come out as LPS), MeshLab's .pp, .pts,
 * menpo's .ljson, tables name,x,y,z or name,vertex, and vertex numbers alone. What was not picked
 * (null, not a number, "not defined", a repeated placeholder such as 0 0 0) is kept as such.
 * Landmarks without a name are called by their number, from "1".
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the landmarks, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_landmarks_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_load(mien_session* session, const char* path,
                                                   mien_landmarks** out, mien_error* error);

/**
 * Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not
 * picked.
 *
 * @param landmarks      [in] landmark_count of them; null allowed when that is 0. Names must
 * differ.
 * @param landmark_count [in] 0 to 100000.
 * @param out            [out] not null; the landmarks, or null on failure.
 * @param error          [out] may be null.
 * @errors MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_landmarks_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(landmark_count)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_create(const mien_scan_landmark* landmarks,
                                                     uint64_t landmark_count, mien_landmarks** out,
                                                     mien_error* error);

/**
 * The landmarks of a model: names and vertices of its template.
 *
 * @param model [in] not null.
 * @param out   [out] not null; the landmarks, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_landmarks_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(landmarks)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_model_get_landmarks(const mien_model* model,
                                                        mien_landmarks** out, mien_error* error);

/**
 * The landmarks under the names that a model has for them. Case, separators and leading zeros do
 * not count; numbers alone are read as iBUG-68 (from 0 or 1) or MediaPipe (468 or 478), where the
 * model has the 68 names of that scheme. What the model does not know is left out and listed in
 * the JSON of the result.
 *
 * @param landmarks [in] not null.
 * @param model     [in] not null.
 * @param out       [out] not null; the landmarks, or null on failure.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (two names mean one landmark, numbers fit
 * two schemes), MIEN_E_NOT_FOUND (none is known; the message gives examples of known names),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_landmarks_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(n log n)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_match(const mien_landmarks* landmarks,
                                                    const mien_model* model, mien_landmarks** out,
                                                    mien_error* error);

/**
 * The landmarks as places: vertex numbers become the vertices' places on a mesh, places stay as
 * they are.
 *
 * @param landmarks [in] not null.
 * @param mesh      [in] not null; has the numbered vertices.
 * @param out       [out] not null; the landmarks, or null on failure.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (a number that the mesh
 * does not have), MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_landmarks_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(n)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_on_mesh(const mien_landmarks* landmarks,
                                                      const mien_mesh* mesh, mien_landmarks** out,
                                                      mien_error* error);

/**
 * Writes a landmark file by its extension: .json, .mrk.json and .fcsv (both LPS), .pp, .pts,
 * .ljson, .csv. Vertex numbers go into .json and .csv. Atomic.
 *
 * @param session   [in] not null.
 * @param landmarks [in] not null.
 * @param path      [in] UTF-8, not null.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(n)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_save(mien_session* session,
                                                   const mien_landmarks* landmarks,
                                                   const char* path, mien_error* error);

/**
 * How many landmarks there are, and how many of them are a place or a vertex.
 *
 * @param landmarks    [in] not null.
 * @param count        [out] may be null.
 * @param picked_count [out] may be null.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_get_counts(const mien_landmarks* landmarks,
                                                         uint64_t* count, uint64_t* picked_count,
                                                         mien_error* error);

/**
 * The name of one landmark. With dst null and capacity 0: the size only.
 *
 * @param landmarks [in] not null.
 * @param index     [in] below the count.
 * @param dst       [out] room for capacity bytes, or null.
 * @param capacity  [in] bytes that dst holds.
 * @param count     [out] may be null; bytes with the terminating zero.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_get_name(const mien_landmarks* landmarks,
                                                       uint64_t index, char* dst, uint64_t capacity,
                                                       uint64_t* count, mien_error* error);

/**
 * What is known of one landmark.
 *
 * @param landmarks [in] not null.
 * @param index     [in] below the count.
 * @param where     [out] may be null; MIEN_MARK_*.
 * @param position  [out] may be null; x, y and z in the file's unit, zeros unless it is a place.
 * @param vertex    [out] may be null; 0 unless it is a vertex.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (misaligned), MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_get_mark(const mien_landmarks* landmarks,
                                                       uint64_t index, int32_t* where,
                                                       double* position, uint32_t* vertex,
                                                       mien_error* error);

/**
 * What the list is, as JSON text by the two-call protocol: format, system (LPS or RAS as the file
 * says it), unit_to_mm (null: not told), count, picked, not_picked (names), and after
 * mien_landmarks_match() scheme and unknown (names).
 *
 * @param landmarks [in] not null.
 * @param dst       [out] room for capacity bytes, or null.
 * @param capacity  [in] bytes that dst holds.
 * @param count     [out] may be null; bytes with the terminating zero.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_landmarks_get_json(const mien_landmarks* landmarks, char* dst,
                                                       uint64_t capacity, uint64_t* count,
                                                       mien_error* error);

/**
 * Adds a reference.
 *
 * @param landmarks [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_landmarks_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_landmarks_retain(mien_landmarks* landmarks);

/**
 * Gives one reference back; the last one frees the list.
 *
 * @param landmarks [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_landmarks_release(mien_landmarks* landmarks);

/**
 * Reads a zone file {"zones": {name: [vertex, ...]}}; further lists of vertices beside "zones",
 * such as "lips", are zones too.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; the zones, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_zones_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_zones_load(mien_session* session, const char* path,
                                               mien_zones** out, mien_error* error);

/**
 * Makes a list of zones from the host's.
 *
 * @param zones      [in] zone_count of them, each of at most 16777216 vertices; null
 *                   allowed when that is 0. Names must differ.
 * @param zone_count [in] 0 to 100000.
 * @param out        [out] not null; the zones, or null on failure.
 * @param error      [out] may be null.
 * @errors MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_zones_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(vertices)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_zones_create(const mien_zone* zones, uint64_t zone_count,
                                                 mien_zones** out, mien_error* error);

/**
 * The zones of a model: names and vertices of its template.
 *
 * @param model [in] not null.
 * @param out   [out] not null; the zones, or null on failure.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_zones_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(vertices)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_model_get_zones(const mien_model* model, mien_zones** out,
                                                    mien_error* error);

/**
 * Writes a zone file. Atomic.
 *
 * @param session [in] not null.
 * @param zones   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
 * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(vertices)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_zones_save(mien_session* session, const mien_zones* zones,
                                               const char* path, mien_error* error);

/**
 * How many zones there are.
 *
 * @param zones [in] not null.
 * @param count [out] may be null.
 * @param error [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_zones_get_count(const mien_zones* zones, uint64_t* count,
                                                    mien_error* error);

/**
 * The name of one zone. With dst null and capacity 0: the size only.
 *
 * @param zones    [in] not null.
 * @param index    [in] below the count.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(size)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_zones_get_name(const mien_zones* zones, uint64_t index,
                                                   char* dst, uint64_t capacity, uint64_t* count,
                                                   mien_error* error);

/**
 * The vertices of one zone. With dst null and capacity 0: their number only.
 *
 * @param zones    [in] not null.
 * @param index    [in] below the count.
 * @param dst      [out] room for capacity numbers, or null.
 * @param capacity [in] numbers that dst holds.
 * @param count    [out] may be null; vertices of the zone.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL (dst untouched,
 * count written), MIEN_E_NOT_FOUND (index)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(vertices)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_zones_get_vertices(const mien_zones* zones, uint64_t index,
                                                       uint32_t* dst, uint64_t capacity,
                                                       uint64_t* count, mien_error* error);

/**
 * Adds a reference.
 *
 * @param zones [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_zones_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_zones_retain(mien_zones* zones);

/**
 * Gives one reference back; the last one frees the list.
 *
 * @param zones [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_zones_release(mien_zones* zones);

#ifdef __cplusplus
}
#endif
#endif

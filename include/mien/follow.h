/* Mien: a fit that follows a moving face before a depth camera, frame after frame.
 *
 *   mien_register(session, model, first_frame, NULL, &start, &error);
 *   mien_follower_create(session, model, start, NULL, &follower, &error);
 *   for each frame: mien_follower_fit(session, follower, &points, 320, 200, &state, &error);
 *                   mien_follower_get_mesh(follower, &face, &error);
 */
#ifndef MIEN_FOLLOW_H
#define MIEN_FOLLOW_H

#include "registration.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A face that is followed. Changes with each frame: not to be shared between threads. */
typedef struct mien_follower mien_follower;

/** What became of the face in a frame. */
enum {
    MIEN_FOLLOW_FOLLOWED = 0,
    MIEN_FOLLOW_DOUBTFUL = 1,    /**< hardly seen, or it has slid along its skin */
    MIEN_FOLLOW_FOUND_AGAIN = 2, /**< was lost, and a search found it in this frame */
    MIEN_FOLLOW_LOST = 3         /**< the fitted face is that of the last frame that was not lost */
};

/** Initialise with mien_follow_options_init(). */
typedef struct mien_follow_options {
    uint32_t struct_size;
    int32_t rounds;           /**< of closest places and a solve, per frame, 1 to 100; default 3 */
    int32_t max_vertices;     /**< of the template that pull, 100 or more; default 2500 */
    int32_t max_scalar_modes; /**< of the model's kernel modes that move, 0 or more; default 250 */
    int32_t max_pca_modes;    /**< of the model's trained modes that move, 0 or more; default 60 */
    uint32_t reserved;        /**< zero */
    double temporal_mm;       /**< deviation of a vertex from where it was on the head in the frame
                                 before; 0: frames know nothing of each other; default 4 */
    double sigma_start_mm;    /**< noise level of a surface point in a frame's first round; default
                                 1.5 */
    double sigma_end_mm;      /**< and in its last; default 0.7 */
    double lost_share;        /**< the face is lost when less of it lies on what the camera sees;
                                 0 to 1, default 0.5 */
    double unit_to_mm;        /**< one unit of the frames' points in mm; default 1 */
    double focal_x;  /**< pixels, column = focal_x x / z + centre_x; 0 (default): all four are found
                        from each frame's points */
    double focal_y;  /**< pixels, row = focal_y y / z + centre_y */
    double centre_x; /**< pixels */
    double centre_y; /**< pixels */
} mien_follow_options;

/** What is told of a frame. */
typedef struct mien_follow_state {
    uint32_t struct_size;
    int32_t state;      /**< MIEN_FOLLOW_* */
    double share;       /**< 0 to 1: of the vertices that face the camera, those on the surface */
    double residual_mm; /**< mean distance of these from it */
    double slide_mm;    /**< median way of the vertices along the skin since the start: expressions
                           move a part of a face, sliding moves most of it */
} mien_follow_state;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_follow_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_follow_options_init(mien_follow_options* options, size_t struct_size);

/**
 * Begins to follow a face from a registration, of whatever origin: its fitted mesh becomes the
 * shape that the model's modes move about.
 *
 * @param session [in] not null.
 * @param model   [in] not null; of the registration.
 * @param start   [in] not null; in the camera's frame.
 * @param options [in] may be null: all defaults.
 * @param out     [out] not null; the follower, or null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (the registration is of
 * another template), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET,
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_follower_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V log #F) time, O(vertices x modes) bytes
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_follower_create(mien_session* session, const mien_model* model,
                                                    const mien_registration* start,
                                                    const mien_follow_options* options,
                                                    mien_follower** out, mien_error* error);

/**
 * Fits the next frame. A face that is gone is not an error: it is told as lost, and searched in
 * each frame until it is found.
 *
 * @param session  [in] not null.
 * @param follower [in] not null.
 * @param points   [in] not null; #P x 3, F32 or F64: one point a pixel, row by row, in the camera's
 * frame and the unit of the options; not finite, or of depth 0: nothing was seen.
 * @param width    [in] pixels in a row, 3 or more.
 * @param height   [in] rows, 3 or more; width x height is the number of points.
 * @param out      [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (points that are no pinhole camera's),
 * MIEN_E_MISMATCH (width x height), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session and follower
 * @cancel no
 * @cost   O(rounds x #V x modes); a frame with a search is as dear as a registration
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_follower_fit(mien_session* session, mien_follower* follower,
                                                 const mien_array_view* points, int32_t width,
                                                 int32_t height, mien_follow_state* out,
                                                 mien_error* error);

/**
 * The fitted template of the last frame that was not lost: template topology, the camera's frame,
 * millimetres.
 *
 * @param follower [in] not null.
 * @param out      [out] not null; the mesh, or null on failure.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by follower
 * @cancel no
 * @cost   O(#V)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_follower_get_mesh(const mien_follower* follower,
                                                      mien_mesh** out, mien_error* error);

/**
 * The head's motion in that frame, from the template's frame to the camera's, as a row-major 4 x 4
 * matrix.
 *
 * @param follower [in] not null.
 * @param matrix   [out] not null; 16 values; lengths in mm.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
 * @owner  nothing
 * @thread externally synchronized by follower
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_follower_get_motion(const mien_follower* follower,
                                                        double* matrix, mien_error* error);

/**
 * Adds a reference.
 *
 * @param follower [in] may be null.
 * @errors none
 * @owner  the caller owes one more mien_follower_release()
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_follower_retain(mien_follower* follower);

/**
 * Releases a follower.
 *
 * @param follower [in] may be null.
 * @errors none
 * @owner  the caller's reference is gone afterwards
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API void MIEN_CALL mien_follower_release(mien_follower* follower);

#ifdef __cplusplus
}
#endif
#endif

/* Mien: biomarker scores from faces, and the statistics of raters and repeated captures. */
#ifndef MIEN_SCORE_H
#define MIEN_SCORE_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A trained score: partial least squares on displacement and curvature. Immutable: share freely.
 */
typedef struct mien_score_model mien_score_model;

/** Which algorithm finds the latent variables; with one score both give the same regression. */
enum { MIEN_PLS_NIPALS = 0, MIEN_PLS_SIMPLS = 1 };

/** What each vertex gives. jousse-2022 (B.2) has 17 numbers a vertex without naming them; ours are
 * displacement (3), change of the normal (3), k1, k2, mean and Gaussian curvature, curvedness, and
 * the curvature tensor (6), each of them an equal part of curvature_share. */
enum {
    MIEN_SCORE_FEATURES_DISPLACEMENT_AND_CURVATURE = 0, /**< displacement, k1, k2 */
    MIEN_SCORE_FEATURES_ALL = 1                         /**< all 17 */
};

/** Initialise with mien_score_options_init(). */
typedef struct mien_score_options {
    uint32_t struct_size;
    int32_t method;         /**< MIEN_PLS_*; default NIPALS */
    int32_t num_components; /**< 0 (default): by cross-validation and the one-standard-error rule */
    int32_t max_components; /**< tried in cross-validation, 1 to 50; default 10 */
    int32_t folds;          /**< over subjects; 0: leave one subject out; default 10 */
    uint32_t reserved;      /**< zero */
    uint64_t seed;          /**< of the folds; default 1 */
    double curvature_share; /**< total variance of the curvature features over that of the
                               displacements; 0: none; default 0.1 */
    double curvature_radius_mm;    /**< of the fits that estimate curvature; default 8 */
    double lowest;                 /**< range that predictions are cut to; */
    double highest;                /**< equal (default): none */
    const uint32_t* zone_vertices; /**< of interest; null: all */
    uint64_t zone_count;
    const uint32_t* stable_vertices; /**< faces are aligned on these; null: on all, robustly */
    uint64_t stable_count;
    mien_progress_fn progress; /**< may be null */
    void* progress_user;
    mien_cancel* cancel; /**< may be null */
    uint32_t focus; /**< 1 (default): vertices count by how far they move with the score, found anew
                       in each fold; 0: by their area alone */
    uint32_t reserved2; /**< zero */
    int32_t features;   /**< MIEN_SCORE_FEATURES_*; default displacement and curvature. Since 0.2 */
    uint32_t reserved3; /**< zero */
} mien_score_options;

/** A predicted score. */
typedef struct mien_score_prediction {
    uint32_t struct_size;
    int32_t extrapolates; /**< 1: the face is unlike the training faces */
    double score;
    double low95; /**< 95 % prediction interval */
    double high95;
    double leverage; /**< distance from the training faces, about components / faces on average */
} mien_score_prediction;

/**
 * Writes the defaults into the first struct_size bytes of *options and zeroes what it does not
 * know.
 *
 * @param options     [out] not null.
 * @param struct_size [in] sizeof(mien_score_options) of the caller.
 * @errors none (does nothing when options is null or struct_size is below 4)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(1)
 * @since  0.1
 */
MIEN_API void MIEN_CALL mien_score_options_init(mien_score_options* options, size_t struct_size);

/**
 * Learns a score from graded faces in correspondence.
 *
 * @param session      [in] not null.
 * @param dataset_path [in] UTF-8, not null; a dataset file, faces of one subject share a fold.
 * @param grades       [in] not null; grade_count values, one per face, NaN: not graded.
 * @param grade_count  [in] faces of the dataset.
 * @param options      [in] may be null: defaults.
 * @param out          [out] not null; null on failure.
 * @param error        [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces),
 * MIEN_E_MISMATCH (counts, zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO,
 * MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED
 * @owner  the caller releases *out with mien_score_model_release()
 * @thread externally synchronized by session
 * @cancel yes
 * @cost   O(n^2 #V) for n faces, about 0.1 ms of curvature per vertex and face and about a second
 * per fold for a hundred faces (focus); 260 n #V bytes
 * @since  0.1
 * @source jousse-2022 chapter 3 as summarised there; see src/measure/score_model.hpp and
 * score_direction.hpp
 */
MIEN_API mien_status MIEN_CALL mien_score_model_train(mien_session* session,
                                                      const char* dataset_path,
                                                      const double* grades, uint64_t grade_count,
                                                      const mien_score_options* options,
                                                      mien_score_model** out, mien_error* error);

/**
 * Reads a score model file, which is treated as hostile.
 *
 * @param session [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param out     [out] not null; null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION,
 * MIEN_E_CORRUPT, MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_score_model_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(file size)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_score_model_load(mien_session* session, const char* path,
                                                     mien_score_model** out, mien_error* error);

/**
 * Writes a score model as a safetensors file, atomically.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param path    [in] UTF-8, not null.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_score_model_save(mien_session* session,
                                                     const mien_score_model* model,
                                                     const char* path, mien_error* error);

/**
 * The score of a face with its 95 % prediction interval. Set out->struct_size first.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param face    [in] not null; in the model's topology, mm, anywhere in space.
 * @param out     [in,out] not null; struct_size as the caller knows it, the rest is written.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   about 0.1 ms per vertex with curvatures
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_score_model_predict(mien_session* session,
                                                        const mien_score_model* model,
                                                        const mien_mesh* face,
                                                        mien_score_prediction* out,
                                                        mien_error* error);

/**
 * The face as it would look with another score.
 *
 * @param session [in] not null.
 * @param model   [in] not null.
 * @param face    [in] may be null: the training's mean face.
 * @param target  [in] the score wanted, finite.
 * @param out     [out] not null; the face in its own frame, null on failure.
 * @param error   [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology),
 * MIEN_E_NO_MEMORY
 * @owner  the caller releases *out with mien_mesh_release()
 * @thread externally synchronized by session
 * @cancel no
 * @cost   as mien_score_model_predict()
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_score_model_simulate(mien_session* session,
                                                         const mien_score_model* model,
                                                         const mien_mesh* face, double target,
                                                         mien_mesh** out, mien_error* error);

/**
 * A latent variable on the template: how far each vertex moves, mm, at one standard deviation of
 * it. Component -1: per unit of score. With dst null and capacity 0: the count only.
 *
 * @param model     [in] not null.
 * @param component [in] 0 .. components - 1, or -1.
 * @param dst       [out] room for capacity values, or null.
 * @param capacity  [in] values that dst holds.
 * @param count     [out] may be null; #V.
 * @param error     [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such component), MIEN_E_BUFFER_TOO_SMALL (dst
 * untouched, count written)
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(#V)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_score_model_get_latent(const mien_score_model* model,
                                                           int32_t component, double* dst,
                                                           uint64_t capacity, uint64_t* count,
                                                           mien_error* error);

/**
 * What was learned as JSON: components, cross-validated errors, held-out predictions and
 * focus_places (how many places the focus takes a face for; 0: none), which are not kept in files.
 *
 * @param model    [in] not null.
 * @param dst      [out] room for capacity bytes, or null.
 * @param capacity [in] bytes that dst holds.
 * @param count    [out] may be null; bytes with the terminating zero.
 * @param error    [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_BUFFER_TOO_SMALL (dst untouched, count written),
 * MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread thread-safe
 * @cancel no
 * @cost   O(faces)
 * @since  0.1
 */
MIEN_API mien_status MIEN_CALL mien_score_model_get_json(const mien_score_model* model, char* dst,
                                                         uint64_t capacity, uint64_t* count,
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
MIEN_API void MIEN_CALL mien_score_model_retain(mien_score_model* model);

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
MIEN_API void MIEN_CALL mien_score_model_release(mien_score_model* model);

/**
 * How far raters (or one rater's sessions) agree, as JSON: confusion matrices, percent agreement,
 * Cohen's kappa plain, linear and quadratic, Fleiss' kappa, all six intraclass correlations,
 * majority grades.
 *
 * @param session       [in] not null.
 * @param ratings       [in] not null; subject_count x rater_count, 0 .. grade_count - 1, negative:
 * missing.
 * @param subject_count [in] 2 to 10000000.
 * @param rater_count   [in] 2 to 1000.
 * @param grade_count   [in] 2 to 1000.
 * @param dst           [out] room for capacity bytes, or null.
 * @param capacity      [in] bytes that dst holds.
 * @param count         [out] may be null; bytes with the terminating zero.
 * @param error         [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (grades, no subject graded by all),
 * MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(subjects x raters^2)
 * @since  0.1
 * @source Cohen 1960, 1968; Fleiss 1971; Shrout & Fleiss 1979; McGraw & Wong 1996
 */
MIEN_API mien_status MIEN_CALL mien_statistics_agreement(
    mien_session* session, const int32_t* ratings, uint64_t subject_count, uint32_t rater_count,
    int32_t grade_count, char* dst, uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * Within-subject deviation and repeatability coefficient of repeated captures, and the limit of
 * detection from changes measured where nothing changed, as JSON.
 *
 * @param session     [in] not null.
 * @param values      [in] value_count values; may be null when value_count is 0.
 * @param subjects    [in] not null; value_count numbers: who was measured.
 * @param value_count [in] 0: no repeatability; otherwise some subject has two.
 * @param blanks      [in] blank_count changes measured without any true one; may be null when 0.
 * @param blank_count [in] 0: no limit of detection; otherwise 2 or more.
 * @param dst         [out] room for capacity bytes, or null.
 * @param capacity    [in] bytes that dst holds.
 * @param count       [out] may be null; bytes with the terminating zero.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(n log n)
 * @since  0.1
 * @source Bland & Altman 1999; CLSI EP17
 */
MIEN_API mien_status MIEN_CALL
mien_statistics_repeatability(mien_session* session, const double* values, const int32_t* subjects,
                              uint64_t value_count, const double* blanks, uint64_t blank_count,
                              char* dst, uint64_t capacity, uint64_t* count, mien_error* error);

/**
 * Bland and Altman's comparison of two methods on the same subjects, as JSON: bias, limits of
 * agreement, their intervals, and whether the bias grows with the size.
 *
 * @param session     [in] not null.
 * @param first       [in] not null; value_count values.
 * @param second      [in] not null; value_count values.
 * @param value_count [in] 3 or more.
 * @param dst         [out] room for capacity bytes, or null.
 * @param capacity    [in] bytes that dst holds.
 * @param count       [out] may be null; bytes with the terminating zero.
 * @param error       [out] may be null.
 * @errors MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY
 * @owner  nothing
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(n)
 * @since  0.1
 * @source Bland & Altman 1986, 1999
 */
MIEN_API mien_status MIEN_CALL mien_statistics_bland_altman(
    mien_session* session, const double* first, const double* second, uint64_t value_count,
    char* dst, uint64_t capacity, uint64_t* count, mien_error* error);

#ifdef __cplusplus
}
#endif
#endif

/* Frozen by abi/baseline/freeze_headers.py; comments are in the headers of that release. */
#ifndef MIEN_MIEN_H
#define MIEN_MIEN_H
#ifndef MIEN_CONFIG_H
#define MIEN_CONFIG_H
#include <stddef.h>
#include <stdint.h>
#define MIEN_VERSION_MAJOR 0
#define MIEN_VERSION_MINOR 1
#define MIEN_VERSION_PATCH 0
#define MIEN_VERSION_STRING "0.1.0"
#define MIEN_ABI_VERSION 0u
#if defined(_WIN32) && !defined(MIEN_STATIC)
#  if defined(MIEN_BUILD)
#    define MIEN_API __declspec(dllexport)
#  else
#    define MIEN_API __declspec(dllimport)
#  endif
#elif defined(__GNUC__) && !defined(MIEN_STATIC)
#  define MIEN_API __attribute__((visibility("default")))
#else
#  define MIEN_API
#endif
#if defined(_WIN32)
#  define MIEN_CALL __cdecl
#else
#  define MIEN_CALL
#endif
#endif
#ifndef MIEN_DATASET_H
#define MIEN_DATASET_H
#ifndef MIEN_MESH_H
#define MIEN_MESH_H
#ifndef MIEN_SESSION_H
#define MIEN_SESSION_H
#ifndef MIEN_ERROR_H
#define MIEN_ERROR_H
#ifdef __cplusplus
extern "C" {
#endif
typedef int32_t mien_status;
enum {
    MIEN_OK = 0,
    MIEN_E_INVALID_ARGUMENT = -1,
    MIEN_E_INVALID_HANDLE = -2,
    MIEN_E_INVALID_MESH = -3,
    MIEN_E_BUFFER_TOO_SMALL = -4,
    MIEN_E_UNSUPPORTED_OPTION = -5,
    MIEN_E_UNSUPPORTED_VERSION = -6,
    MIEN_E_NO_MEMORY = -7,
    MIEN_E_MEMORY_BUDGET = -8,
    MIEN_E_IO = -9,
    MIEN_E_BAD_FORMAT = -10,
    MIEN_E_CORRUPT = -11,
    MIEN_E_WRONG_KIND = -12,
    MIEN_E_MISMATCH = -13,
    MIEN_E_NO_SOLUTION = -14,
    MIEN_E_NOT_FOUND = -15,
    MIEN_E_CANCELLED = -16,
    MIEN_E_CALLBACK = -17,
    MIEN_E_INTERNAL = -18
};
typedef struct mien_error {
    uint32_t struct_size;
    mien_status status;
    int64_t detail_index;
    char message[256];
} mien_error;
MIEN_API const char *MIEN_CALL mien_status_name(mien_status status);
MIEN_API uint32_t MIEN_CALL mien_version_number(void);
MIEN_API const char *MIEN_CALL mien_version_string(void);
MIEN_API const char *MIEN_CALL mien_build_id(void);
#ifdef __cplusplus
}
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_session mien_session;
typedef struct mien_cancel mien_cancel;
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
typedef int32_t(MIEN_CALL *mien_progress_fn)(void *user, int32_t stage, double fraction);
enum { MIEN_LOG_ERROR = 1, MIEN_LOG_WARNING = 2, MIEN_LOG_INFO = 3, MIEN_LOG_DEBUG = 4 };
typedef void(MIEN_CALL *mien_log_fn)(void *user, int32_t level, const char *message);
typedef struct mien_session_options {
    uint32_t struct_size;
    int32_t num_threads;
    uint64_t max_bytes;
    mien_log_fn log;
    void *log_user;
} mien_session_options;
MIEN_API void MIEN_CALL mien_session_options_init(mien_session_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_session_create(uint32_t abi_version, mien_session **out,
                                                   mien_error *error);
MIEN_API mien_status MIEN_CALL mien_session_create_with_options(uint32_t abi_version,
                                                                const mien_session_options *options,
                                                                mien_session **out,
                                                                mien_error *error);
MIEN_API void MIEN_CALL mien_session_release(mien_session *session);
MIEN_API mien_status MIEN_CALL mien_cancel_create(mien_cancel **out, mien_error *error);
MIEN_API void MIEN_CALL mien_cancel_request(mien_cancel *cancel);
MIEN_API void MIEN_CALL mien_cancel_release(mien_cancel *cancel);
#ifdef __cplusplus
}
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_mesh mien_mesh;
typedef int32_t mien_dtype;
enum {
    MIEN_DTYPE_F32 = 1,
    MIEN_DTYPE_F64 = 2,
    MIEN_DTYPE_I32 = 3,
    MIEN_DTYPE_U32 = 4,
    MIEN_DTYPE_U8 = 5
};
typedef struct mien_array_view {
    const void *data;
    uint64_t count;
    uint64_t stride_bytes;
    mien_dtype dtype;
    int32_t reserved;
} mien_array_view;
typedef struct mien_zone {
    const char *name;
    const uint32_t *vertices;
    uint64_t vertex_count;
} mien_zone;
typedef struct mien_mesh_arrays {
    uint32_t struct_size;
    uint32_t reserved;
    mien_array_view positions;
    const uint32_t *triangles;
    uint64_t triangle_count;
    const uint8_t *colors;
} mien_mesh_arrays;
MIEN_API void MIEN_CALL mien_mesh_arrays_init(mien_mesh_arrays *arrays, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_mesh_create(mien_session *session, const mien_mesh_arrays *arrays,
                                                mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_load(mien_session *session, const char *path, mien_mesh **out,
                                              mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_save(mien_session *session, const mien_mesh *mesh,
                                              const char *path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_get_counts(const mien_mesh *mesh, uint64_t *vertex_count,
                                                    uint64_t *triangle_count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_get_positions(const mien_mesh *mesh, mien_dtype dtype, void *dst,
                                                       uint64_t capacity, uint64_t *count,
                                                       mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_get_triangles(const mien_mesh *mesh, uint32_t *dst,
                                                       uint64_t capacity, uint64_t *count,
                                                       mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_get_colors(const mien_mesh *mesh, uint8_t *dst,
                                                    uint64_t capacity, uint64_t *count,
                                                    mien_error *error);
MIEN_API mien_status MIEN_CALL mien_mesh_positions_view(const mien_mesh *mesh, const double **data,
                                                        uint64_t *count, mien_error *error);
MIEN_API void MIEN_CALL mien_mesh_retain(mien_mesh *mesh);
MIEN_API void MIEN_CALL mien_mesh_release(mien_mesh *mesh);
#ifdef __cplusplus
}
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_dataset_writer mien_dataset_writer;
MIEN_API mien_status MIEN_CALL mien_dataset_writer_create(mien_session *session, const mien_mesh *topology,
                                                          const char *const *expression_names,
                                                          uint32_t expression_count,
                                                          mien_dataset_writer **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_dataset_writer_add(mien_dataset_writer *writer,
                                                       const mien_array_view *positions, int32_t subject,
                                                       int32_t expression, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_dataset_writer_save(mien_session *session,
                                                        const mien_dataset_writer *writer,
                                                        const char *path, mien_error *error);
MIEN_API void MIEN_CALL mien_dataset_writer_release(mien_dataset_writer *writer);
#ifdef __cplusplus
}
#endif
#endif
#ifndef MIEN_EXPRESSION_H
#define MIEN_EXPRESSION_H
#ifndef MIEN_REGISTRATION_H
#define MIEN_REGISTRATION_H
#ifndef MIEN_MODEL_H
#define MIEN_MODEL_H
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_model mien_model;
enum {
    MIEN_KERNEL_NONE = 0,
    MIEN_KERNEL_EUCLIDEAN_SE = 1,
    MIEN_KERNEL_GEODESIC_SE = 2,
    MIEN_KERNEL_BSPLINE = 3,
    MIEN_KERNEL_SURFACE_MATERN = 4
};
enum {
    MIEN_HEAT_NEUMANN = 1,
    MIEN_HEAT_DIRICHLET = 2,
    MIEN_HEAT_AVERAGE = 3
};
typedef struct mien_kernel {
    int32_t kind;
    int32_t reserved;
    double sigma_mm;
    double scale_mm;
    double nu;
} mien_kernel;
typedef struct mien_landmark {
    const char *name;
    uint32_t vertex;
    uint32_t reserved;
} mien_landmark;
typedef struct mien_landmark_observation {
    const char *name;
    uint32_t vertex;
    uint32_t reserved;
    double position[3];
    double noise_mm;
} mien_landmark_observation;
typedef struct mien_model_options {
    uint32_t struct_size;
    int32_t kernel;
    double sigma_mm;
    double scale_mm;
    double nu;
    int32_t levels;
    int32_t num_modes;
    const mien_kernel *kernels;
    uint64_t kernel_count;
    double tolerance;
    int32_t num_control_points;
    int32_t mirror_symmetric;
    double mirror_correlation;
    double eigenvalue_threshold;
    double heat_time_factor;
    int32_t heat_boundary;
    int32_t pca_modes;
    const char *pca_dataset;
    double pca_variance;
    int32_t pca_all_expressions;
    int32_t pca_align;
    mien_array_view scale_per_vertex;
    const mien_landmark *landmarks;
    uint64_t landmark_count;
    const mien_zone *zones;
    uint64_t zone_count;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_model_options;
MIEN_API void MIEN_CALL mien_model_options_init(mien_model_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_model_build(mien_session *session, const mien_mesh *template_mesh,
                                                const mien_model_options *options, mien_model **out,
                                                mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_load(mien_session *session, const char *path, mien_model **out,
                                               mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_load_memory(mien_session *session, const void *data, uint64_t size,
                                                      mien_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_load_trusted(mien_session *session, const char *path,
                                                       mien_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_save(mien_session *session, const mien_model *model,
                                               const char *path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_get_counts(const mien_model *model, uint64_t *vertex_count,
                                                     uint64_t *scalar_modes, uint64_t *vector_modes,
                                                     mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_get_json(const mien_model *model, char *dst, uint64_t capacity,
                                                   uint64_t *count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_get_variance(const mien_model *model, double *dst,
                                                       uint64_t capacity, uint64_t *count,
                                                       mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_sample(mien_session *session, const mien_model *model,
                                                 uint64_t seed, uint64_t index, double strength,
                                                 mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_model_condition(mien_session *session, const mien_model *model,
                                                    const mien_landmark_observation *observations,
                                                    uint64_t observation_count, mien_model **out,
                                                    mien_error *error);
typedef struct mien_tuning mien_tuning;
typedef struct mien_tune_options {
    uint32_t struct_size;
    int32_t kernel;
    const double *sigmas_mm;
    uint64_t sigma_count;
    double scale_mm;
    double nu;
    double rho;
    int32_t levels;
    int32_t num_modes;
    const char *const *expressions;
    uint32_t expression_count;
    int32_t max_subjects;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_tune_options;
MIEN_API void MIEN_CALL mien_tune_options_init(mien_tune_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_model_tune(mien_session *session, const mien_mesh *template_mesh,
                                               const char *dataset, const mien_tune_options *options,
                                               mien_tuning **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_tuning_get_json(const mien_tuning *tuning, char *dst, uint64_t capacity,
                                                    uint64_t *count, mien_error *error);
MIEN_API void MIEN_CALL mien_tuning_release(mien_tuning *tuning);
MIEN_API const mien_mesh *MIEN_CALL mien_model_mesh(const mien_model *model);
MIEN_API void MIEN_CALL mien_model_retain(mien_model *model);
MIEN_API void MIEN_CALL mien_model_release(mien_model *model);
#ifdef __cplusplus
}
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_registration mien_registration;
typedef struct mien_scan_landmark {
    const char *name;
    double position[3];
} mien_scan_landmark;
enum {
    MIEN_GROWTH_CONSTANT = 0,
    MIEN_GROWTH_LINEAR = 1,
    MIEN_GROWTH_EXPONENTIAL = 2,
    MIEN_GROWTH_CUBIC = 3
};
enum {
    MIEN_START_AUTOMATIC = 0,
    MIEN_START_LANDMARKS = 1,
    MIEN_START_POSE = 2,
    MIEN_START_SEARCH = 3
};
enum {
    MIEN_UNITS_DETECT = 0,
    MIEN_UNITS_MILLIMETRES = 1,
    MIEN_UNITS_REFUSE = 2
};
typedef struct mien_register_options {
    uint32_t struct_size;
    int32_t growth;
    const mien_scan_landmark *landmarks;
    uint64_t landmark_count;
    double landmark_sigma_mm;
    int32_t start;
    int32_t units;
    mien_array_view scan_weights;
    int32_t skin_weights;
    int32_t close_gap;
    int32_t max_scalar_modes;
    int32_t max_pca_modes;
    int32_t iterations;
    int32_t reject_border;
    double sigma_start_mm;
    double sigma_end_mm;
    double max_angle_deg;
    double start_rotation[9];
    double start_translation[3];
    double start_scale;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_register_options;
enum { MIEN_QUALITY_GOOD = 0, MIEN_QUALITY_DOUBTFUL = 1, MIEN_QUALITY_FAILED = 2 };
typedef struct mien_fit_verdict {
    uint32_t struct_size;
    int32_t quality;
    double coverage;
    double inlier_share;
    double mean_residual_mm;
    double landmark_rms_mm;
    double size_ratio;
    double mean_deviation;
    double unit_to_mm;
    int32_t landmarks_used;
    int32_t landmarks_rejected;
    int32_t flipped_triangles;
    int32_t self_intersections;
} mien_fit_verdict;
enum {
    MIEN_REGISTRATION_RESIDUAL_MM = 1,
    MIEN_REGISTRATION_WEIGHT = 2,
    MIEN_REGISTRATION_STANDARD_DEVIATION_MM = 3,
    MIEN_REGISTRATION_RADIUS95_MM = 4
};
MIEN_API void MIEN_CALL mien_register_options_init(mien_register_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_register(mien_session *session, const mien_model *model,
                                             const mien_mesh *scan, const mien_register_options *options,
                                             mien_registration **out, mien_error *error);
MIEN_API const mien_mesh *MIEN_CALL mien_registration_mesh(const mien_registration *registration);
MIEN_API mien_status MIEN_CALL mien_registration_get_verdict(const mien_registration *registration,
                                                             mien_fit_verdict *out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_registration_get_field(const mien_registration *registration,
                                                           int32_t field, double *dst, uint64_t capacity,
                                                           uint64_t *count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_registration_get_correspondence(const mien_registration *registration,
                                                                    uint32_t *triangles, double *barycentric,
                                                                    uint64_t capacity, uint64_t *count,
                                                                    mien_error *error);
MIEN_API mien_status MIEN_CALL mien_registration_get_motion(const mien_registration *registration,
                                                            double *matrix, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_registration_get_json(const mien_registration *registration, char *dst,
                                                          uint64_t capacity, uint64_t *count,
                                                          mien_error *error);
MIEN_API void MIEN_CALL mien_registration_retain(mien_registration *registration);
MIEN_API void MIEN_CALL mien_registration_release(mien_registration *registration);
enum { MIEN_TRANSFER_LANDMARKS = 1, MIEN_TRANSFER_ZONES = 2 };
MIEN_API mien_status MIEN_CALL mien_surface_transfer_points(mien_session *session, const mien_mesh *surface,
                                                            const mien_array_view *points,
                                                            double max_distance_mm, uint32_t *triangles,
                                                            double *barycentric, double *positions,
                                                            uint64_t capacity, uint64_t *count,
                                                            mien_error *error);
MIEN_API mien_status MIEN_CALL mien_surface_transfer_zone(mien_session *session, const mien_mesh *from,
                                                          const uint32_t *vertices, uint64_t vertex_count,
                                                          const mien_mesh *to, double max_distance_mm,
                                                          uint32_t *dst, uint64_t capacity, uint64_t *count,
                                                          mien_error *error);
MIEN_API mien_status MIEN_CALL mien_surface_transfer_json(mien_session *session, const mien_model *model,
                                                          const mien_mesh *fitted, const mien_mesh *scan,
                                                          int32_t what, double max_distance_mm, char *dst,
                                                          uint64_t capacity, uint64_t *count,
                                                          mien_error *error);
#ifdef __cplusplus
}
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_expression_model mien_expression_model;
typedef struct mien_neutralization mien_neutralization;
typedef struct mien_evaluation mien_evaluation;
typedef struct mien_series mien_series;
enum {
    MIEN_TRAIN_JPCA = 0,
    MIEN_TRAIN_QOJPCA = 1
};
enum {
    MIEN_FIT_MIXTURE = 0,
    MIEN_FIT_MAP = 1,
    MIEN_FIT_EXACT = 2,
    MIEN_FIT_ALTERNATING = 3
};
enum {
    MIEN_POSE_AUTO = 0,
    MIEN_POSE_KEEP = 1,
    MIEN_POSE_RIGID = 2
};
typedef struct mien_train_options {
    uint32_t struct_size;
    int32_t method;
    int32_t identity_modes;
    int32_t expression_modes;
    int32_t max_iterations;
    int32_t passes;
    double lambda;
    double lambda_factor;
    double angle_tolerance_rad;
    double noise_mm2;
    const uint32_t *stable_vertices;
    uint64_t stable_count;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_train_options;
typedef struct mien_neutralize_options {
    uint32_t struct_size;
    int32_t method;
    int32_t max_sweeps;
    int32_t uncertainty;
    int32_t pose;
    uint32_t reserved;
    double tolerance_mm;
    double noise_mm2;
    double decay_mm;
    mien_array_view weights;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_neutralize_options;
typedef struct mien_shard_options {
    uint32_t struct_size;
    int32_t part;
    int32_t part_count;
    int32_t max_rank;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_shard_options;
typedef struct mien_series_options {
    uint32_t struct_size;
    int32_t method;
    int32_t pose;
    uint32_t reserved;
    double scan_noise_share;
    double noise_mm2;
    const uint32_t *changing_vertices;
    uint64_t changing_count;
    double expected_change_mm;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_series_options;
typedef struct mien_evaluate_options {
    uint32_t struct_size;
    int32_t method;
    int32_t max_sweeps;
    int32_t against_method;
    int32_t against_max_sweeps;
    uint32_t reserved;
    const mien_expression_model *against;
    const uint32_t *zone_vertices;
    uint64_t zone_count;
    const uint32_t *stable_vertices;
    uint64_t stable_count;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_evaluate_options;
MIEN_API void MIEN_CALL mien_train_options_init(mien_train_options *options, size_t struct_size);
MIEN_API void MIEN_CALL mien_neutralize_options_init(mien_neutralize_options *options, size_t struct_size);
MIEN_API void MIEN_CALL mien_evaluate_options_init(mien_evaluate_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_expression_model_train(mien_session *session, const char *dataset_path,
                                                           const mien_train_options *options,
                                                           mien_expression_model **out, mien_error *error);
MIEN_API void MIEN_CALL mien_shard_options_init(mien_shard_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_expression_shard_create(mien_session *session, const char *dataset_path,
                                                            const mien_shard_options *options,
                                                            const char *shard_path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_merge(mien_session *session,
                                                           const char *const *shard_paths,
                                                           uint32_t shard_count,
                                                           const mien_train_options *options,
                                                           mien_expression_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_load(mien_session *session, const char *path,
                                                          mien_expression_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_load_memory(mien_session *session, const void *data,
                                                                 uint64_t size, mien_expression_model **out,
                                                                 mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_save(mien_session *session,
                                                          const mien_expression_model *model,
                                                          const char *path, mien_error *error);
MIEN_API void MIEN_CALL mien_expression_model_retain(mien_expression_model *model);
MIEN_API void MIEN_CALL mien_expression_model_release(mien_expression_model *model);
MIEN_API mien_status MIEN_CALL mien_expression_model_get_counts(const mien_expression_model *model,
                                                                uint64_t *vertex_count,
                                                                uint32_t *identity_modes,
                                                                uint32_t *expression_modes,
                                                                mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_get_json(const mien_expression_model *model, char *dst,
                                                              uint64_t capacity, uint64_t *count,
                                                              mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_synthesize(mien_session *session,
                                                                const mien_expression_model *model,
                                                                const mien_array_view *identity,
                                                                const mien_array_view *expression,
                                                                mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_sample(mien_session *session,
                                                            const mien_expression_model *model,
                                                            uint64_t seed, const char *expression,
                                                            mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_neutralize(mien_session *session, const mien_expression_model *model,
                                               const mien_registration *fitted,
                                               const mien_neutralize_options *options,
                                               mien_neutralization **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_neutralize_mesh(mien_session *session,
                                                    const mien_expression_model *model,
                                                    const mien_mesh *face,
                                                    const mien_neutralize_options *options,
                                                    mien_neutralization **out, mien_error *error);
MIEN_API void MIEN_CALL mien_series_options_init(mien_series_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_neutralize_series(mien_session *session,
                                                      const mien_expression_model *model,
                                                      const mien_mesh *const *faces, uint32_t face_count,
                                                      const mien_series_options *options,
                                                      mien_series **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_series_get_mesh(const mien_series *series, int32_t index,
                                                    mien_mesh **out, mien_error *error);
MIEN_API void MIEN_CALL mien_series_release(mien_series *series);
MIEN_API mien_status MIEN_CALL mien_neutralization_apply_to_scan(mien_session *session,
                                                                 const mien_neutralization *neutralization,
                                                                 const mien_mesh *scan,
                                                                 double max_distance_mm, mien_mesh **out,
                                                                 mien_error *error);
MIEN_API mien_status MIEN_CALL mien_expression_model_transfer(mien_session *session,
                                                              const mien_expression_model *model,
                                                              const mien_neutralization *source,
                                                              const mien_neutralization *target,
                                                              mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_evaluate_neutralization(mien_session *session,
                                                            const mien_expression_model *model,
                                                            const char *dataset_path,
                                                            const mien_evaluate_options *options,
                                                            mien_evaluation **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_evaluation_get_json(const mien_evaluation *evaluation, char *dst,
                                                        uint64_t capacity, uint64_t *count,
                                                        mien_error *error);
MIEN_API void MIEN_CALL mien_evaluation_release(mien_evaluation *evaluation);
MIEN_API const mien_mesh *MIEN_CALL mien_neutralization_mesh(const mien_neutralization *neutralization);
MIEN_API mien_status MIEN_CALL mien_neutralization_get_coordinates(const mien_neutralization *neutralization,
                                                                   double *identity, double *expression,
                                                                   mien_error *error);
MIEN_API mien_status MIEN_CALL mien_neutralization_get_uncertainty(const mien_neutralization *neutralization,
                                                                   double *dst, uint64_t capacity,
                                                                   uint64_t *count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_neutralization_get_json(const mien_neutralization *neutralization,
                                                            char *dst, uint64_t capacity, uint64_t *count,
                                                            mien_error *error);
MIEN_API void MIEN_CALL mien_neutralization_release(mien_neutralization *neutralization);
#ifdef __cplusplus
}
#endif
#endif
#ifndef MIEN_MEASURE_H
#define MIEN_MEASURE_H
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_measurement mien_measurement;
typedef struct mien_measure_options {
    uint32_t struct_size;
    int32_t skip_borders;
    const mien_zone *zones;
    uint64_t zone_count;
    mien_array_view before_sd;
    mien_array_view after_sd;
    double correlation_length_mm;
    double alignment_rotation_sd_rad;
    double alignment_translation_sd_mm;
    double alignment_centre[3];
    double common_bias_mm;
    double limit_of_detection_ml;
    double max_distance_mm;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_measure_options;
enum { MIEN_ZONE_WHOLE = -1, MIEN_ZONE_REST = -2 };
typedef struct mien_zone_volume {
    uint32_t struct_size;
    int32_t detected;
    double signed_ml;
    double positive_ml;
    double negative_ml;
    double absolute_ml;
    double sd_ml;
    double low95_ml;
    double high95_ml;
    double area_before_mm2;
    double area_after_mm2;
} mien_zone_volume;
typedef struct mien_zone_distance {
    uint32_t struct_size;
    uint32_t reserved;
    double mean_signed_mm;
    double sd_signed_mm;
    double mean_absolute_mm;
    double rms_mm;
    double mean_length_mm;
    double median_length_mm;
    double p95_length_mm;
    double max_length_mm;
    uint64_t vertex_count;
} mien_zone_distance;
enum {
    MIEN_FIELD_SIGNED_DISTANCE_MM = 1,
    MIEN_FIELD_DISTANCE_MM = 2,
    MIEN_FIELD_POSITIVE_VOLUME_MM3 = 3,
    MIEN_FIELD_NEGATIVE_VOLUME_MM3 = 4
};
MIEN_API void MIEN_CALL mien_measure_options_init(mien_measure_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_measure_volume(mien_session *session, const mien_mesh *before,
                                                   const mien_mesh *after,
                                                   const mien_measure_options *options,
                                                   mien_measurement **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measure_distance(mien_session *session, const mien_mesh *before,
                                                     const mien_mesh *after,
                                                     const mien_measure_options *options,
                                                     mien_measurement **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measure_surface_distance(mien_session *session,
                                                             const mien_mesh *before,
                                                             const mien_mesh *after,
                                                             const mien_measure_options *options,
                                                             mien_measurement **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measure_closed_volume(mien_session *session, const mien_mesh *mesh,
                                                          int32_t close_rims, double *volume_ml,
                                                          mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measure_area(mien_session *session, const mien_mesh *mesh,
                                                 const mien_zone *zone, double *area_mm2,
                                                 mien_error *error);
enum {
    MIEN_CARRY_CLOSEST_POINT = 1,
    MIEN_CARRY_DIRECTION = 2,
    MIEN_CARRY_VERTEX_NORMAL = 3
};
MIEN_API mien_status MIEN_CALL mien_measure_scan_volume(mien_session *session, const mien_mesh *before,
                                                        const mien_mesh *after, int32_t carry,
                                                        const double *direction,
                                                        const mien_measure_options *options,
                                                        double *coverage, mien_measurement **out,
                                                        mien_error *error);
typedef struct mien_zone_alignment {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t pairs;
    double rms_mm;
    double rotation_sd_rad;
    double translation_sd_mm;
    double centre[3];
    double matrix[16];
} mien_zone_alignment;
MIEN_API mien_status MIEN_CALL mien_measure_align(mien_session *session, const mien_mesh *moving,
                                                  const mien_mesh *target, const mien_zone *stable,
                                                  mien_zone_alignment *info, mien_mesh **out,
                                                  mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measurement_get_zones(const mien_measurement *measurement,
                                                          uint32_t *zone_count, int32_t *zones_disjoint,
                                                          mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measurement_get_volume(const mien_measurement *measurement,
                                                           int32_t zone, mien_zone_volume *out,
                                                           mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measurement_get_distance(const mien_measurement *measurement,
                                                             int32_t zone, mien_zone_distance *out,
                                                             mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measurement_get_field(const mien_measurement *measurement,
                                                          int32_t field, double *dst, uint64_t capacity,
                                                          uint64_t *count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_measurement_get_json(const mien_measurement *measurement, char *dst,
                                                         uint64_t capacity, uint64_t *count,
                                                         mien_error *error);
MIEN_API void MIEN_CALL mien_measurement_release(mien_measurement *measurement);
#ifdef __cplusplus
}
#endif
#endif
#ifndef MIEN_SCORE_H
#define MIEN_SCORE_H
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_score_model mien_score_model;
enum { MIEN_PLS_NIPALS = 0, MIEN_PLS_SIMPLS = 1 };
typedef struct mien_score_options {
    uint32_t struct_size;
    int32_t method;
    int32_t num_components;
    int32_t max_components;
    int32_t folds;
    uint32_t reserved;
    uint64_t seed;
    double curvature_share;
    double curvature_radius_mm;
    double lowest;
    double highest;
    const uint32_t *zone_vertices;
    uint64_t zone_count;
    const uint32_t *stable_vertices;
    uint64_t stable_count;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_score_options;
typedef struct mien_score_prediction {
    uint32_t struct_size;
    int32_t extrapolates;
    double score;
    double low95;
    double high95;
    double leverage;
} mien_score_prediction;
MIEN_API void MIEN_CALL mien_score_options_init(mien_score_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_score_model_train(mien_session *session, const char *dataset_path,
                                                      const double *grades, uint64_t grade_count,
                                                      const mien_score_options *options,
                                                      mien_score_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_score_model_load(mien_session *session, const char *path,
                                                     mien_score_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_score_model_save(mien_session *session, const mien_score_model *model,
                                                     const char *path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_score_model_predict(mien_session *session, const mien_score_model *model,
                                                        const mien_mesh *face, mien_score_prediction *out,
                                                        mien_error *error);
MIEN_API mien_status MIEN_CALL mien_score_model_simulate(mien_session *session, const mien_score_model *model,
                                                         const mien_mesh *face, double target, mien_mesh **out,
                                                         mien_error *error);
MIEN_API mien_status MIEN_CALL mien_score_model_get_latent(const mien_score_model *model, int32_t component,
                                                           double *dst, uint64_t capacity, uint64_t *count,
                                                           mien_error *error);
MIEN_API mien_status MIEN_CALL mien_score_model_get_json(const mien_score_model *model, char *dst,
                                                         uint64_t capacity, uint64_t *count,
                                                         mien_error *error);
MIEN_API void MIEN_CALL mien_score_model_retain(mien_score_model *model);
MIEN_API void MIEN_CALL mien_score_model_release(mien_score_model *model);
MIEN_API mien_status MIEN_CALL mien_statistics_agreement(mien_session *session, const int32_t *ratings,
                                                         uint64_t subject_count, uint32_t rater_count,
                                                         int32_t grade_count, char *dst, uint64_t capacity,
                                                         uint64_t *count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_statistics_repeatability(mien_session *session, const double *values,
                                                             const int32_t *subjects, uint64_t value_count,
                                                             const double *blanks, uint64_t blank_count,
                                                             char *dst, uint64_t capacity, uint64_t *count,
                                                             mien_error *error);
MIEN_API mien_status MIEN_CALL mien_statistics_bland_altman(mien_session *session, const double *first,
                                                            const double *second, uint64_t value_count,
                                                            char *dst, uint64_t capacity, uint64_t *count,
                                                            mien_error *error);
#ifdef __cplusplus
}
#endif
#endif
#ifndef MIEN_SPECTRAL_H
#define MIEN_SPECTRAL_H
#ifdef __cplusplus
extern "C" {
#endif
typedef struct mien_spectral_basis mien_spectral_basis;
typedef struct mien_representation mien_representation;
typedef struct mien_hierarchy mien_hierarchy;
typedef struct mien_blendshape_model mien_blendshape_model;
enum {
    MIEN_MASS_MIXED_VORONOI = 0,
    MIEN_MASS_BARYCENTRIC = 1,
    MIEN_MASS_NONE = 2
};
enum { MIEN_COTANGENTS_INTRINSIC_DELAUNAY = 0, MIEN_COTANGENTS_CLAMP = 1, MIEN_COTANGENTS_KEEP = 2 };
typedef struct mien_spectral_basis_options {
    uint32_t struct_size;
    uint32_t mode_count;
    int32_t mass;
    int32_t cotangents;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_spectral_basis_options;
MIEN_API void MIEN_CALL mien_spectral_basis_options_init(mien_spectral_basis_options *options,
                                                         size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_spectral_basis_build(mien_session *session, const mien_mesh *mean,
                                                         const mien_spectral_basis_options *options,
                                                         mien_spectral_basis **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_basis_load(mien_session *session, const char *path,
                                                        mien_spectral_basis **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_basis_save(mien_session *session,
                                                        const mien_spectral_basis *basis, const char *path,
                                                        mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_counts(const mien_spectral_basis *basis,
                                                              uint64_t *vertex_count, uint64_t *mode_count,
                                                              mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_basis_get_eigenvalues(const mien_spectral_basis *basis,
                                                                   double *dst, uint64_t capacity,
                                                                   uint64_t *count, mien_error *error);
MIEN_API void MIEN_CALL mien_spectral_basis_retain(mien_spectral_basis *basis);
MIEN_API void MIEN_CALL mien_spectral_basis_release(mien_spectral_basis *basis);
MIEN_API mien_status MIEN_CALL mien_spectral_split(mien_session *session, const mien_spectral_basis *basis,
                                                   const mien_mesh *face, uint64_t k, mien_mesh **low,
                                                   mien_mesh **high, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_assemble(mien_session *session,
                                                      const mien_spectral_basis *basis,
                                                      const mien_mesh *low, const mien_mesh *high,
                                                      uint64_t k, mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_edit(mien_session *session, const mien_spectral_basis *basis,
                                                  const mien_mesh *face, const uint64_t *limits,
                                                  uint64_t limit_count, const double *gains,
                                                  mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_spectral_mix(mien_session *session, const mien_spectral_basis *basis,
                                                 const mien_mesh *first, const mien_mesh *second,
                                                 const uint64_t *limits, uint64_t limit_count,
                                                 const double *weights, mien_mesh **out, mien_error *error);
enum {
    MIEN_METRIC_L1 = 1,
    MIEN_METRIC_L2 = 2,
    MIEN_METRIC_HAUSDORFF = 3,
    MIEN_METRIC_DAME = 4,
    MIEN_METRIC_FMPD = 5
};
MIEN_API mien_status MIEN_CALL mien_metric(mien_session *session, int32_t metric, const mien_mesh *reference,
                                           const mien_mesh *other, double *value, mien_error *error);
enum {
    MIEN_FEATURES_EUCLIDEAN = 1,
    MIEN_FEATURES_EUCLIDEAN_STANDARDISED = 2,
    MIEN_FEATURES_EUCLIDEAN_NORMALISED = 3,
    MIEN_FEATURES_DEFORMATION = 4,
    MIEN_FEATURES_DEFORMATION_NORMALISED = 5,
    MIEN_FEATURES_DEFORMATION_STANDARDISED = 6
};
MIEN_API mien_status MIEN_CALL mien_representation_train(mien_session *session, const char *dataset_path,
                                                         int32_t kind, int32_t neutral_only,
                                                         mien_representation **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_representation_load(mien_session *session, const char *path,
                                                        mien_representation **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_representation_save(mien_session *session,
                                                        const mien_representation *representation,
                                                        const char *path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_representation_get_counts(const mien_representation *representation,
                                                              uint64_t *vertex_count,
                                                              uint64_t *channel_count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_representation_encode(mien_session *session,
                                                          const mien_representation *representation,
                                                          const mien_mesh *face, double *motion,
                                                          double *dst, uint64_t capacity, uint64_t *count,
                                                          mien_error *error);
MIEN_API mien_status MIEN_CALL mien_representation_decode(mien_session *session,
                                                          const mien_representation *representation,
                                                          const double *features, uint64_t row_count,
                                                          const double *motion, mien_mesh **out,
                                                          mien_error *error);
MIEN_API void MIEN_CALL mien_representation_retain(mien_representation *representation);
MIEN_API void MIEN_CALL mien_representation_release(mien_representation *representation);
MIEN_API mien_status MIEN_CALL mien_hierarchy_build_quadric(mien_session *session, const mien_mesh *mesh,
                                                            uint32_t level_count, double factor,
                                                            mien_hierarchy **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_hierarchy_build_connectivity(mien_session *session,
                                                                 const mien_mesh *mesh,
                                                                 uint32_t level_count, uint32_t stride,
                                                                 uint32_t radius, mien_hierarchy **out,
                                                                 mien_error *error);
MIEN_API mien_status MIEN_CALL mien_hierarchy_load(mien_session *session, const char *path,
                                                   mien_hierarchy **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_hierarchy_save(mien_session *session, const mien_hierarchy *hierarchy,
                                                   const char *path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_level_count(const mien_hierarchy *hierarchy,
                                                              uint32_t *level_count, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_hierarchy_get_level(const mien_hierarchy *hierarchy, uint32_t level,
                                                        mien_mesh **out, mien_error *error);
enum {
    MIEN_MAP_DOWN = 1,
    MIEN_MAP_UP = 2
};
MIEN_API mien_status MIEN_CALL mien_hierarchy_apply(const mien_hierarchy *hierarchy, uint32_t level,
                                                    int32_t direction, const double *values,
                                                    uint64_t row_count, uint64_t channel_count, double *dst,
                                                    uint64_t capacity, uint64_t *count, mien_error *error);
MIEN_API void MIEN_CALL mien_hierarchy_retain(mien_hierarchy *hierarchy);
MIEN_API void MIEN_CALL mien_hierarchy_release(mien_hierarchy *hierarchy);
MIEN_API mien_status MIEN_CALL mien_transfer_expression(mien_session *session,
                                                        const mien_mesh *source_neutral,
                                                        const mien_mesh *source_expression,
                                                        const mien_mesh *target_neutral, mien_mesh **out,
                                                        mien_error *error);
typedef struct mien_blendshape_options {
    uint32_t struct_size;
    uint32_t reserved;
    double ridge;
    mien_progress_fn progress;
    void *progress_user;
    mien_cancel *cancel;
} mien_blendshape_options;
MIEN_API void MIEN_CALL mien_blendshape_options_init(mien_blendshape_options *options, size_t struct_size);
MIEN_API mien_status MIEN_CALL mien_blendshape_model_train(mien_session *session, const char *dataset_path,
                                                           const char *expression,
                                                           const mien_blendshape_options *options,
                                                           mien_blendshape_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_blendshape_model_load(mien_session *session, const char *path,
                                                          mien_blendshape_model **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_blendshape_model_save(mien_session *session,
                                                          const mien_blendshape_model *model,
                                                          const char *path, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_blendshape_model_get_mean(const mien_blendshape_model *model,
                                                              mien_mesh **out, mien_error *error);
MIEN_API mien_status MIEN_CALL mien_blendshape_model_predict(mien_session *session,
                                                             const mien_blendshape_model *model,
                                                             const mien_spectral_basis *basis, uint64_t k,
                                                             const mien_mesh *neutral, mien_mesh **out,
                                                             mien_error *error);
typedef struct mien_band_choice {
    uint64_t k;
    double l1_mm;
    double dame;
    double fmpd;
    int32_t on_front;
    int32_t chosen;
} mien_band_choice;
MIEN_API mien_status MIEN_CALL mien_blendshape_model_search(
    mien_session *session, const mien_blendshape_model *model, const mien_spectral_basis *basis,
    const char *dataset_path, const char *expression, const uint64_t *candidates, uint32_t candidate_count,
    const mien_blendshape_options *options, mien_band_choice *choices, mien_error *error);
MIEN_API void MIEN_CALL mien_blendshape_model_retain(mien_blendshape_model *model);
MIEN_API void MIEN_CALL mien_blendshape_model_release(mien_blendshape_model *model);
#ifdef __cplusplus
}
#endif
#endif
#endif

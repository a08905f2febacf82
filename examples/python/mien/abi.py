"""Structs, constants and signatures of the C headers. Written by abi/generate_bindings.py."""
import ctypes

ProgressFn = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_int32, ctypes.c_double)
LogFn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32, ctypes.c_char_p)

MIEN_OK = 0
MIEN_E_INVALID_ARGUMENT = -1
MIEN_E_INVALID_HANDLE = -2
MIEN_E_INVALID_MESH = -3
MIEN_E_BUFFER_TOO_SMALL = -4
MIEN_E_UNSUPPORTED_OPTION = -5
MIEN_E_UNSUPPORTED_VERSION = -6
MIEN_E_NO_MEMORY = -7
MIEN_E_MEMORY_BUDGET = -8
MIEN_E_IO = -9
MIEN_E_BAD_FORMAT = -10
MIEN_E_CORRUPT = -11
MIEN_E_WRONG_KIND = -12
MIEN_E_MISMATCH = -13
MIEN_E_NO_SOLUTION = -14
MIEN_E_NOT_FOUND = -15
MIEN_E_CANCELLED = -16
MIEN_E_CALLBACK = -17
MIEN_E_INTERNAL = -18
MIEN_STAGE_READING = 1
MIEN_STAGE_GEODESICS = 2
MIEN_STAGE_BASIS = 3
MIEN_STAGE_ALIGNMENT = 4
MIEN_STAGE_FITTING = 5
MIEN_STAGE_REFINING = 6
MIEN_STAGE_TRAINING = 7
MIEN_STAGE_NEUTRALIZING = 8
MIEN_STAGE_MEASURING = 9
MIEN_STAGE_WRITING = 10
MIEN_LOG_ERROR = 1
MIEN_LOG_WARNING = 2
MIEN_LOG_INFO = 3
MIEN_LOG_DEBUG = 4
MIEN_DTYPE_F32 = 1
MIEN_DTYPE_F64 = 2
MIEN_DTYPE_I32 = 3
MIEN_DTYPE_U32 = 4
MIEN_DTYPE_U8 = 5
MIEN_MASS_MIXED_VORONOI = 0
MIEN_MASS_BARYCENTRIC = 1
MIEN_MASS_NONE = 2
MIEN_COTANGENTS_INTRINSIC_DELAUNAY = 0
MIEN_COTANGENTS_CLAMP = 1
MIEN_COTANGENTS_KEEP = 2
MIEN_METRIC_L1 = 1
MIEN_METRIC_L2 = 2
MIEN_METRIC_HAUSDORFF = 3
MIEN_METRIC_DAME = 4
MIEN_METRIC_FMPD = 5
MIEN_KERNEL_NONE = 0
MIEN_KERNEL_EUCLIDEAN_SE = 1
MIEN_KERNEL_GEODESIC_SE = 2
MIEN_KERNEL_BSPLINE = 3
MIEN_KERNEL_SURFACE_MATERN = 4
MIEN_HEAT_NEUMANN = 1
MIEN_HEAT_DIRICHLET = 2
MIEN_HEAT_AVERAGE = 3
MIEN_MARK_NOT_PICKED = 0
MIEN_MARK_PLACE = 1
MIEN_MARK_VERTEX = 2
MIEN_GROWTH_CONSTANT = 0
MIEN_GROWTH_LINEAR = 1
MIEN_GROWTH_EXPONENTIAL = 2
MIEN_GROWTH_CUBIC = 3
MIEN_START_AUTOMATIC = 0
MIEN_START_LANDMARKS = 1
MIEN_START_POSE = 2
MIEN_START_SEARCH = 3
MIEN_UNITS_DETECT = 0
MIEN_UNITS_MILLIMETRES = 1
MIEN_UNITS_REFUSE = 2
MIEN_SIDES_REFUSE = 0
MIEN_SIDES_MEND = 1
MIEN_SIDES_IGNORE = 2
MIEN_QUALITY_GOOD = 0
MIEN_QUALITY_DOUBTFUL = 1
MIEN_QUALITY_FAILED = 2
MIEN_REGISTRATION_RESIDUAL_MM = 1
MIEN_REGISTRATION_WEIGHT = 2
MIEN_REGISTRATION_STANDARD_DEVIATION_MM = 3
MIEN_REGISTRATION_RADIUS95_MM = 4
MIEN_REGISTRATION_NORMAL_DEVIATION_MM = 5
MIEN_TRANSFER_LANDMARKS = 1
MIEN_TRANSFER_ZONES = 2
MIEN_FIT_MIXTURE = 0
MIEN_FIT_MAP = 1
MIEN_FIT_EXACT = 2
MIEN_FIT_ALTERNATING = 3
MIEN_POSE_AUTO = 0
MIEN_POSE_KEEP = 1
MIEN_POSE_RIGID = 2
MIEN_MAP_DOWN = 1
MIEN_MAP_UP = 2
MIEN_ZONE_WHOLE = -1
MIEN_ZONE_REST = -2
MIEN_FIELD_SIGNED_DISTANCE_MM = 1
MIEN_FIELD_DISTANCE_MM = 2
MIEN_FIELD_POSITIVE_VOLUME_MM3 = 3
MIEN_FIELD_NEGATIVE_VOLUME_MM3 = 4
MIEN_FIELD_CURVATURE_MAXIMAL = 5
MIEN_FIELD_CURVATURE_MINIMAL = 6
MIEN_FIELD_CURVATURE_MEAN = 7
MIEN_FIELD_CURVATURE_GAUSSIAN = 8
MIEN_CARRY_CLOSEST_POINT = 1
MIEN_CARRY_DIRECTION = 2
MIEN_CARRY_VERTEX_NORMAL = 3
MIEN_FEATURES_EUCLIDEAN = 1
MIEN_FEATURES_EUCLIDEAN_STANDARDISED = 2
MIEN_FEATURES_EUCLIDEAN_NORMALISED = 3
MIEN_FEATURES_DEFORMATION = 4
MIEN_FEATURES_DEFORMATION_NORMALISED = 5
MIEN_FEATURES_DEFORMATION_STANDARDISED = 6
MIEN_PLS_NIPALS = 0
MIEN_PLS_SIMPLS = 1
MIEN_STUDY_KNOWN = 0
MIEN_STUDY_UNSEEN = 1
MIEN_STUDY_FAILED_FIT = 2
MIEN_STUDY_NO_SURFACE_ERRORS = 3
MIEN_STUDY_OUTSIDE_EXPRESSIONS = 4
MIEN_STUDY_FIELD_NORMAL_SD_MM = 1
MIEN_STUDY_FIELD_WEIGHT = 2
MIEN_STUDY_FIELD_EXPRESSION_SD_MM = 3
MIEN_TRAIN_JPCA = 0
MIEN_TRAIN_QOJPCA = 1
MIEN_ABI_VERSION = 0


class Error(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("status", ctypes.c_int32),
        ("detail_index", ctypes.c_int64),
        ("message", ctypes.c_char * 256),
    ]


class SessionOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("num_threads", ctypes.c_int32),
        ("max_bytes", ctypes.c_uint64),
        ("log", LogFn),
        ("log_user", ctypes.c_void_p),
    ]


class ArrayView(ctypes.Structure):
    _fields_ = [
        ("data", ctypes.c_void_p),
        ("count", ctypes.c_uint64),
        ("stride_bytes", ctypes.c_uint64),
        ("dtype", ctypes.c_int32),
        ("reserved", ctypes.c_int32),
    ]


class Zone(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("vertices", ctypes.c_void_p),
        ("vertex_count", ctypes.c_uint64),
    ]


class Image(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("pixels", ctypes.c_void_p),
        ("row_stride_bytes", ctypes.c_uint64),
        ("width", ctypes.c_uint32),
        ("height", ctypes.c_uint32),
        ("file", ctypes.c_void_p),
        ("file_size", ctypes.c_uint64),
    ]


class Material(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("image", ctypes.c_int32),
        ("reserved", ctypes.c_int32),
        ("red", ctypes.c_double),
        ("green", ctypes.c_double),
        ("blue", ctypes.c_double),
    ]


class MeshArrays(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
        ("positions", ArrayView),
        ("triangles", ctypes.c_void_p),
        ("triangle_count", ctypes.c_uint64),
        ("colors", ctypes.c_void_p),
        ("texture", ctypes.c_void_p),
        ("texture_count", ctypes.c_uint64),
        ("texture_triangles", ctypes.c_void_p),
        ("materials", ctypes.POINTER(Material)),
        ("material_count", ctypes.c_uint64),
        ("triangle_materials", ctypes.c_void_p),
        ("images", ctypes.POINTER(Image)),
        ("image_count", ctypes.c_uint64),
    ]


class SpectralBasisOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("mode_count", ctypes.c_uint32),
        ("mass", ctypes.c_int32),
        ("cotangents", ctypes.c_int32),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class BlendshapeOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
        ("ridge", ctypes.c_double),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class BandChoice(ctypes.Structure):
    _fields_ = [
        ("k", ctypes.c_uint64),
        ("l1_mm", ctypes.c_double),
        ("dame", ctypes.c_double),
        ("fmpd", ctypes.c_double),
        ("on_front", ctypes.c_int32),
        ("chosen", ctypes.c_int32),
    ]


class Kernel(ctypes.Structure):
    _fields_ = [
        ("kind", ctypes.c_int32),
        ("reserved", ctypes.c_int32),
        ("sigma_mm", ctypes.c_double),
        ("scale_mm", ctypes.c_double),
        ("nu", ctypes.c_double),
    ]


class Landmark(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("vertex", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
    ]


class LandmarkObservation(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("vertex", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
        ("position", ctypes.c_double * 3),
        ("noise_mm", ctypes.c_double),
    ]


class ModelOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("kernel", ctypes.c_int32),
        ("sigma_mm", ctypes.c_double),
        ("scale_mm", ctypes.c_double),
        ("nu", ctypes.c_double),
        ("levels", ctypes.c_int32),
        ("num_modes", ctypes.c_int32),
        ("kernels", ctypes.POINTER(Kernel)),
        ("kernel_count", ctypes.c_uint64),
        ("tolerance", ctypes.c_double),
        ("num_control_points", ctypes.c_int32),
        ("mirror_symmetric", ctypes.c_int32),
        ("mirror_correlation", ctypes.c_double),
        ("eigenvalue_threshold", ctypes.c_double),
        ("heat_time_factor", ctypes.c_double),
        ("heat_boundary", ctypes.c_int32),
        ("pca_modes", ctypes.c_int32),
        ("pca_dataset", ctypes.c_char_p),
        ("pca_variance", ctypes.c_double),
        ("pca_all_expressions", ctypes.c_int32),
        ("pca_align", ctypes.c_int32),
        ("scale_per_vertex", ArrayView),
        ("landmarks", ctypes.POINTER(Landmark)),
        ("landmark_count", ctypes.c_uint64),
        ("zones", ctypes.POINTER(Zone)),
        ("zone_count", ctypes.c_uint64),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class TuneOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("kernel", ctypes.c_int32),
        ("sigmas_mm", ctypes.c_void_p),
        ("sigma_count", ctypes.c_uint64),
        ("scale_mm", ctypes.c_double),
        ("nu", ctypes.c_double),
        ("rho", ctypes.c_double),
        ("levels", ctypes.c_int32),
        ("num_modes", ctypes.c_int32),
        ("expressions", ctypes.POINTER(ctypes.c_char_p)),
        ("expression_count", ctypes.c_uint32),
        ("max_subjects", ctypes.c_int32),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class ScanLandmark(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("position", ctypes.c_double * 3),
    ]


class RegisterOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("growth", ctypes.c_int32),
        ("landmarks", ctypes.POINTER(ScanLandmark)),
        ("landmark_count", ctypes.c_uint64),
        ("landmark_sigma_mm", ctypes.c_double),
        ("start", ctypes.c_int32),
        ("units", ctypes.c_int32),
        ("scan_weights", ArrayView),
        ("skin_weights", ctypes.c_int32),
        ("close_gap", ctypes.c_int32),
        ("max_scalar_modes", ctypes.c_int32),
        ("max_pca_modes", ctypes.c_int32),
        ("iterations", ctypes.c_int32),
        ("reject_border", ctypes.c_int32),
        ("sigma_start_mm", ctypes.c_double),
        ("sigma_end_mm", ctypes.c_double),
        ("max_angle_deg", ctypes.c_double),
        ("start_rotation", ctypes.c_double * 9),
        ("start_translation", ctypes.c_double * 3),
        ("start_scale", ctypes.c_double),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
        ("color_features", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
        ("unit_to_mm", ctypes.c_double),
        ("landmark_sides", ctypes.c_int32),
        ("reserved2", ctypes.c_uint32),
    ]


class FitVerdict(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("quality", ctypes.c_int32),
        ("coverage", ctypes.c_double),
        ("inlier_share", ctypes.c_double),
        ("mean_residual_mm", ctypes.c_double),
        ("landmark_rms_mm", ctypes.c_double),
        ("size_ratio", ctypes.c_double),
        ("mean_deviation", ctypes.c_double),
        ("unit_to_mm", ctypes.c_double),
        ("landmarks_used", ctypes.c_int32),
        ("landmarks_rejected", ctypes.c_int32),
        ("flipped_triangles", ctypes.c_int32),
        ("self_intersections", ctypes.c_int32),
    ]


class NeutralizeOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("method", ctypes.c_int32),
        ("max_sweeps", ctypes.c_int32),
        ("uncertainty", ctypes.c_int32),
        ("pose", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
        ("tolerance_mm", ctypes.c_double),
        ("noise_mm2", ctypes.c_double),
        ("decay_mm", ctypes.c_double),
        ("weights", ArrayView),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class EvaluateOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("method", ctypes.c_int32),
        ("max_sweeps", ctypes.c_int32),
        ("against_method", ctypes.c_int32),
        ("against_max_sweeps", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
        ("against", ctypes.c_void_p),
        ("zone_vertices", ctypes.c_void_p),
        ("zone_count", ctypes.c_uint64),
        ("stable_vertices", ctypes.c_void_p),
        ("stable_count", ctypes.c_uint64),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class MeasureOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("skip_borders", ctypes.c_int32),
        ("zones", ctypes.POINTER(Zone)),
        ("zone_count", ctypes.c_uint64),
        ("before_sd", ArrayView),
        ("after_sd", ArrayView),
        ("correlation_length_mm", ctypes.c_double),
        ("alignment_rotation_sd_rad", ctypes.c_double),
        ("alignment_translation_sd_mm", ctypes.c_double),
        ("alignment_centre", ctypes.c_double * 3),
        ("common_bias_mm", ctypes.c_double),
        ("limit_of_detection_ml", ctypes.c_double),
        ("max_distance_mm", ctypes.c_double),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class ZoneVolume(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("detected", ctypes.c_int32),
        ("signed_ml", ctypes.c_double),
        ("positive_ml", ctypes.c_double),
        ("negative_ml", ctypes.c_double),
        ("absolute_ml", ctypes.c_double),
        ("sd_ml", ctypes.c_double),
        ("low95_ml", ctypes.c_double),
        ("high95_ml", ctypes.c_double),
        ("area_before_mm2", ctypes.c_double),
        ("area_after_mm2", ctypes.c_double),
    ]


class ZoneDistance(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
        ("mean_signed_mm", ctypes.c_double),
        ("sd_signed_mm", ctypes.c_double),
        ("mean_absolute_mm", ctypes.c_double),
        ("rms_mm", ctypes.c_double),
        ("mean_length_mm", ctypes.c_double),
        ("median_length_mm", ctypes.c_double),
        ("p95_length_mm", ctypes.c_double),
        ("max_length_mm", ctypes.c_double),
        ("vertex_count", ctypes.c_uint64),
    ]


class ZoneAlignment(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
        ("pairs", ctypes.c_uint64),
        ("rms_mm", ctypes.c_double),
        ("rotation_sd_rad", ctypes.c_double),
        ("translation_sd_mm", ctypes.c_double),
        ("centre", ctypes.c_double * 3),
        ("matrix", ctypes.c_double * 16),
    ]


class RepresentationOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("neutral_only", ctypes.c_int32),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class ScoreOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("method", ctypes.c_int32),
        ("num_components", ctypes.c_int32),
        ("max_components", ctypes.c_int32),
        ("folds", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
        ("seed", ctypes.c_uint64),
        ("curvature_share", ctypes.c_double),
        ("curvature_radius_mm", ctypes.c_double),
        ("lowest", ctypes.c_double),
        ("highest", ctypes.c_double),
        ("zone_vertices", ctypes.c_void_p),
        ("zone_count", ctypes.c_uint64),
        ("stable_vertices", ctypes.c_void_p),
        ("stable_count", ctypes.c_uint64),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
        ("focus", ctypes.c_uint32),
        ("reserved2", ctypes.c_uint32),
    ]


class ScorePrediction(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("extrapolates", ctypes.c_int32),
        ("score", ctypes.c_double),
        ("low95", ctypes.c_double),
        ("high95", ctypes.c_double),
        ("leverage", ctypes.c_double),
    ]


class SeriesOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("method", ctypes.c_int32),
        ("pose", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
        ("scan_noise_share", ctypes.c_double),
        ("noise_mm2", ctypes.c_double),
        ("changing_vertices", ctypes.c_void_p),
        ("changing_count", ctypes.c_uint64),
        ("expected_change_mm", ctypes.c_double),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
        ("weights", ArrayView),
    ]


class StudyOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("reserved", ctypes.c_uint32),
        ("zones", ctypes.POINTER(Zone)),
        ("zone_count", ctypes.c_uint64),
        ("treated_zones", ctypes.POINTER(ctypes.c_char_p)),
        ("treated_count", ctypes.c_uint64),
        ("stable_zones", ctypes.POINTER(ctypes.c_char_p)),
        ("stable_count", ctypes.c_uint64),
        ("visits", ctypes.c_void_p),
        ("visit_number_count", ctypes.c_uint64),
        ("margin_mm", ctypes.c_double),
        ("level", ctypes.c_double),
        ("noise_mm", ctypes.c_double),
        ("correlation_length_mm", ctypes.c_double),
        ("common_bias_mm", ctypes.c_double),
        ("untrained_share", ctypes.c_double),
        ("min_seen_share", ctypes.c_double),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class StudyValue(ctypes.Structure):
    _fields_ = [
        ("value", ctypes.c_double),
        ("sd", ctypes.c_double),
        ("low", ctypes.c_double),
        ("high", ctypes.c_double),
        ("limit_of_detection", ctypes.c_double),
    ]


class StudyChange(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("unknown", ctypes.c_int32),
        ("signed_ml", StudyValue),
        ("gained_ml", StudyValue),
        ("lost_ml", StudyValue),
        ("absolute_ml", StudyValue),
        ("area_change_mm2", StudyValue),
        ("mean_distance_mm", StudyValue),
        ("surface_sd_ml", ctypes.c_double),
        ("alignment_sd_ml", ctypes.c_double),
        ("bias_sd_ml", ctypes.c_double),
        ("expression_sd_ml", ctypes.c_double),
        ("expression_removed_ml", ctypes.c_double),
        ("seen_share", ctypes.c_double),
        ("area_before_mm2", ctypes.c_double),
        ("area_after_mm2", ctypes.c_double),
        ("detected", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
    ]


class TrainOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("method", ctypes.c_int32),
        ("identity_modes", ctypes.c_int32),
        ("expression_modes", ctypes.c_int32),
        ("max_iterations", ctypes.c_int32),
        ("passes", ctypes.c_int32),
        ("lambda", ctypes.c_double),
        ("lambda_factor", ctypes.c_double),
        ("angle_tolerance_rad", ctypes.c_double),
        ("noise_mm2", ctypes.c_double),
        ("stable_vertices", ctypes.c_void_p),
        ("stable_count", ctypes.c_uint64),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


class ShardOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("part", ctypes.c_int32),
        ("part_count", ctypes.c_int32),
        ("max_rank", ctypes.c_int32),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
        ("stable_vertices", ctypes.c_void_p),
        ("stable_count", ctypes.c_uint64),
    ]


class VisitsOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("pose", ctypes.c_int32),
        ("normal_noise_mm2", ctypes.c_double),
        ("tangential_noise_mm2", ctypes.c_double),
        ("treated_vertices", ctypes.c_void_p),
        ("treated_count", ctypes.c_uint64),
        ("weights", ArrayView),
        ("progress", ProgressFn),
        ("progress_user", ctypes.c_void_p),
        ("cancel", ctypes.c_void_p),
    ]


SIGNATURES = {
    "mien_status_name": (ctypes.c_char_p, [ctypes.c_int32]),
    "mien_version_number": (ctypes.c_uint32, []),
    "mien_version_string": (ctypes.c_char_p, []),
    "mien_build_id": (ctypes.c_char_p, []),
    "mien_session_options_init": (None, [ctypes.POINTER(SessionOptions), ctypes.c_size_t]),
    "mien_session_create": (ctypes.c_int32, [ctypes.c_uint32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_session_create_with_options": (ctypes.c_int32, [ctypes.c_uint32, ctypes.POINTER(SessionOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_session_release": (None, [ctypes.c_void_p]),
    "mien_cancel_create": (ctypes.c_int32, [ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_cancel_request": (None, [ctypes.c_void_p]),
    "mien_cancel_release": (None, [ctypes.c_void_p]),
    "mien_mesh_arrays_init": (None, [ctypes.POINTER(MeshArrays), ctypes.c_size_t]),
    "mien_mesh_create": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(MeshArrays), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_positions": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_triangles": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_colors": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_format_count": (ctypes.c_uint32, []),
    "mien_mesh_format_extension": (ctypes.c_char_p, [ctypes.c_uint32]),
    "mien_mesh_format_description": (ctypes.c_char_p, [ctypes.c_uint32]),
    "mien_mesh_format_writes": (ctypes.c_void_p, [ctypes.c_uint32]),
    "mien_mesh_get_texture": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_texture_triangles": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_triangle_materials": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_material_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_material": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_material_name": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_image_name": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_image_file": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_image_size": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_get_image_pixels": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_save_targets": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(ctypes.c_char_p), ctypes.c_uint64, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_mesh_load_target": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_positions_view": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_retain": (None, [ctypes.c_void_p]),
    "mien_mesh_release": (None, [ctypes.c_void_p]),
    "mien_spectral_basis_options_init": (None, [ctypes.POINTER(SpectralBasisOptions), ctypes.c_size_t]),
    "mien_spectral_basis_build": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(SpectralBasisOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_spectral_basis_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_spectral_basis_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_spectral_basis_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_spectral_basis_get_eigenvalues": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_spectral_basis_retain": (None, [ctypes.c_void_p]),
    "mien_spectral_basis_release": (None, [ctypes.c_void_p]),
    "mien_spectral_split": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_spectral_assemble": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_spectral_edit": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_spectral_mix": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_metric": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_transfer_expression": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_blendshape_options_init": (None, [ctypes.POINTER(BlendshapeOptions), ctypes.c_size_t]),
    "mien_blendshape_model_train": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.POINTER(BlendshapeOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_blendshape_model_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_blendshape_model_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_blendshape_model_get_mean": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_blendshape_model_predict": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_blendshape_model_search": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_uint32, ctypes.POINTER(BlendshapeOptions), ctypes.POINTER(BandChoice), ctypes.POINTER(Error)]),
    "mien_blendshape_model_retain": (None, [ctypes.c_void_p]),
    "mien_blendshape_model_release": (None, [ctypes.c_void_p]),
    "mien_dataset_writer_create": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_char_p), ctypes.c_uint32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_dataset_writer_add": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ArrayView), ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(Error)]),
    "mien_dataset_writer_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_dataset_writer_release": (None, [ctypes.c_void_p]),
    "mien_model_options_init": (None, [ctypes.POINTER(ModelOptions), ctypes.c_size_t]),
    "mien_model_build": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ModelOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_load_memory": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_load_trusted": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_model_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_model_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_model_get_variance": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_model_sample": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64, ctypes.c_double, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_condition": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(LandmarkObservation), ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_tune_options_init": (None, [ctypes.POINTER(TuneOptions), ctypes.c_size_t]),
    "mien_model_tune": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(TuneOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_tuning_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_tuning_release": (None, [ctypes.c_void_p]),
    "mien_model_mesh": (ctypes.c_void_p, [ctypes.c_void_p]),
    "mien_model_retain": (None, [ctypes.c_void_p]),
    "mien_model_release": (None, [ctypes.c_void_p]),
    "mien_landmarks_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_landmarks_create": (ctypes.c_int32, [ctypes.POINTER(ScanLandmark), ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_get_landmarks": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_landmarks_match": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_landmarks_on_mesh": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_landmarks_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_landmarks_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_landmarks_get_name": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_landmarks_get_mark": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_landmarks_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_landmarks_retain": (None, [ctypes.c_void_p]),
    "mien_landmarks_release": (None, [ctypes.c_void_p]),
    "mien_zones_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_zones_create": (ctypes.c_int32, [ctypes.POINTER(Zone), ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_model_get_zones": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_zones_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_zones_get_count": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_zones_get_name": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_zones_get_vertices": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_zones_retain": (None, [ctypes.c_void_p]),
    "mien_zones_release": (None, [ctypes.c_void_p]),
    "mien_register_options_init": (None, [ctypes.POINTER(RegisterOptions), ctypes.c_size_t]),
    "mien_register": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(RegisterOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_registration_mesh": (ctypes.c_void_p, [ctypes.c_void_p]),
    "mien_registration_get_verdict": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(FitVerdict), ctypes.POINTER(Error)]),
    "mien_registration_get_field": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_registration_get_correspondence": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_registration_get_motion": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_registration_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_registration_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_registration_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_registration_create": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ArrayView), ctypes.POINTER(ArrayView), ctypes.POINTER(ArrayView), ctypes.c_int32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_registration_retain": (None, [ctypes.c_void_p]),
    "mien_registration_release": (None, [ctypes.c_void_p]),
    "mien_surface_transfer_points": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ArrayView), ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_surface_transfer_zone": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_surface_transfer_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int32, ctypes.c_double, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_expression_model_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_expression_model_load_memory": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_expression_model_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_expression_model_retain": (None, [ctypes.c_void_p]),
    "mien_expression_model_release": (None, [ctypes.c_void_p]),
    "mien_expression_model_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_expression_model_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_expression_model_synthesize": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ArrayView), ctypes.POINTER(ArrayView), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_expression_model_sample": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_neutralize_options_init": (None, [ctypes.POINTER(NeutralizeOptions), ctypes.c_size_t]),
    "mien_neutralize": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(NeutralizeOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_neutralize_mesh": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(NeutralizeOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_neutralization_mesh": (ctypes.c_void_p, [ctypes.c_void_p]),
    "mien_neutralization_get_coordinates": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_neutralization_get_uncertainty": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_neutralization_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_neutralization_release": (None, [ctypes.c_void_p]),
    "mien_neutralization_apply_to_scan": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_expression_model_transfer": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_evaluate_options_init": (None, [ctypes.POINTER(EvaluateOptions), ctypes.c_size_t]),
    "mien_evaluate_neutralization": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(EvaluateOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_evaluation_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_evaluation_release": (None, [ctypes.c_void_p]),
    "mien_hierarchy_build_quadric": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_double, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_hierarchy_build_connectivity": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_uint32, ctypes.c_uint32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_hierarchy_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_hierarchy_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_hierarchy_get_level_count": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_hierarchy_get_level": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_hierarchy_apply": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_uint32, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_hierarchy_retain": (None, [ctypes.c_void_p]),
    "mien_hierarchy_release": (None, [ctypes.c_void_p]),
    "mien_measure_options_init": (None, [ctypes.POINTER(MeasureOptions), ctypes.c_size_t]),
    "mien_measure_volume": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(MeasureOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_measure_distance": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(MeasureOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_measure_surface_distance": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(MeasureOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_measure_closed_volume": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_measure_area": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Zone), ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_measure_curvature": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.c_int32, ctypes.POINTER(MeasureOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_measure_lengths": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_measure_scan_volume": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(MeasureOptions), ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_measure_align": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Zone), ctypes.POINTER(ZoneAlignment), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_measurement_get_zones": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_measurement_get_volume": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.POINTER(ZoneVolume), ctypes.POINTER(Error)]),
    "mien_measurement_get_distance": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.POINTER(ZoneDistance), ctypes.POINTER(Error)]),
    "mien_measurement_get_field": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_measurement_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_measurement_release": (None, [ctypes.c_void_p]),
    "mien_mesh_inspect": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_mesh_clean": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_transform": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_turn_over": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_decimate": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_mesh_check_same_unit": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_representation_train": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_representation_options_init": (None, [ctypes.POINTER(RepresentationOptions), ctypes.c_size_t]),
    "mien_representation_train_with_options": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int32, ctypes.POINTER(RepresentationOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_representation_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_representation_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_representation_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_representation_encode": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_representation_decode": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_representation_retain": (None, [ctypes.c_void_p]),
    "mien_representation_release": (None, [ctypes.c_void_p]),
    "mien_score_options_init": (None, [ctypes.POINTER(ScoreOptions), ctypes.c_size_t]),
    "mien_score_model_train": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ScoreOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_score_model_load": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_score_model_save": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_score_model_predict": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ScorePrediction), ctypes.POINTER(Error)]),
    "mien_score_model_simulate": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_score_model_get_latent": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_score_model_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_score_model_retain": (None, [ctypes.c_void_p]),
    "mien_score_model_release": (None, [ctypes.c_void_p]),
    "mien_statistics_agreement": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint32, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_statistics_repeatability": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_statistics_bland_altman": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_series_options_init": (None, [ctypes.POINTER(SeriesOptions), ctypes.c_size_t]),
    "mien_neutralize_series": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.c_uint32, ctypes.POINTER(SeriesOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_series_get_mesh": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_series_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_series_release": (None, [ctypes.c_void_p]),
    "mien_study_options_init": (None, [ctypes.POINTER(StudyOptions), ctypes.c_size_t]),
    "mien_study_create": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.c_uint32, ctypes.c_void_p, ctypes.POINTER(StudyOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_study_create_from_meshes": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.c_uint32, ctypes.POINTER(ArrayView), ctypes.POINTER(ArrayView), ctypes.c_void_p, ctypes.POINTER(StudyOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_study_get_counts": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_study_get_zone_name": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_study_get_expression": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_study_get_mesh": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_study_get_field": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_study_get_distances": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_study_get_alignment": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(ZoneAlignment), ctypes.POINTER(Error)]),
    "mien_study_get_change": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(StudyChange), ctypes.POINTER(Error)]),
    "mien_study_get_json": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_study_retain": (None, [ctypes.c_void_p]),
    "mien_study_release": (None, [ctypes.c_void_p]),
    "mien_template_check": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_train_options_init": (None, [ctypes.POINTER(TrainOptions), ctypes.c_size_t]),
    "mien_expression_model_train": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(TrainOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_shard_options_init": (None, [ctypes.POINTER(ShardOptions), ctypes.c_size_t]),
    "mien_expression_shard_create": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ShardOptions), ctypes.c_char_p, ctypes.POINTER(Error)]),
    "mien_expression_model_merge": (ctypes.c_int32, [ctypes.c_void_p, ctypes.POINTER(ctypes.c_char_p), ctypes.c_uint32, ctypes.POINTER(TrainOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_visits_options_init": (None, [ctypes.POINTER(VisitsOptions), ctypes.c_size_t]),
    "mien_neutralize_visits": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p), ctypes.c_uint32, ctypes.POINTER(VisitsOptions), ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_visits_get_mesh": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.POINTER(ctypes.c_void_p), ctypes.POINTER(Error)]),
    "mien_visits_get_expression": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_visits_get_removed_volume": (ctypes.c_int32, [ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(Zone), ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(Error)]),
    "mien_visits_release": (None, [ctypes.c_void_p]),
}

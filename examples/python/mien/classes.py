"""Classes over the C interface, one per handle, struct and group of constants.

Written by abi/generate_bindings.py; how they work stands in runtime.py.
"""
from __future__ import annotations

import enum
from typing import Callable, NamedTuple, Sequence

import numpy
from numpy.typing import ArrayLike, DTypeLike

from .runtime import Options as _Options
from .runtime import Object as _Object
from .runtime import Progress, Text
from .runtime import Record as _Record
from .runtime import register_classes as _register_classes
from .runtime import run as _run

__all__ = [
    "AnthropometricValue",
    "Anthropometry",
    "AnthropometryCounts",
    "AnthropometryOptions",
    "AsymmetryOptions",
    "BandChoice",
    "BlendshapeModel",
    "BlendshapeOptions",
    "Cancel",
    "Carry",
    "Cotangents",
    "DatasetWriter",
    "Dtype",
    "EvaluateOptions",
    "Evaluation",
    "ExpectedError",
    "ExpressionModel",
    "ExpressionModelCounts",
    "Features",
    "Field",
    "Fit",
    "FitVerdict",
    "GeodesicOptions",
    "Growth",
    "Heat",
    "Hierarchy",
    "HierarchyMap",
    "Image",
    "Kernel",
    "KernelKind",
    "Landmark",
    "LandmarkObservation",
    "Landmarks",
    "LandmarksCounts",
    "LandmarksMark",
    "Log",
    "MapKind",
    "Mark",
    "Mass",
    "Material",
    "Measure",
    "MeasureAlign",
    "MeasureLengths",
    "MeasureOptions",
    "MeasureScanVolume",
    "Measurement",
    "MeasurementZones",
    "Mesh",
    "MeshArrays",
    "MeshCounts",
    "MeshImageSize",
    "MeshMaterial",
    "MeshMaterialCounts",
    "Metric",
    "MirrorBy",
    "MirrorPlane",
    "Model",
    "ModelCounts",
    "ModelFitOptions",
    "ModelOptions",
    "Network",
    "NetworkCounts",
    "NetworkEncode",
    "NetworkEvaluationOptions",
    "NetworkOptions",
    "Neutralization",
    "NeutralizationCoordinates",
    "NeutralizationCounts",
    "NeutralizeOptions",
    "Norms",
    "Pls",
    "Pose",
    "Quality",
    "Reading",
    "RegisterOptions",
    "Registration",
    "RegistrationCorrespondence",
    "RegistrationKind",
    "Representation",
    "RepresentationCounts",
    "RepresentationEncode",
    "RepresentationOptions",
    "ScanLandmark",
    "ScoreFeatures",
    "ScoreModel",
    "ScoreOptions",
    "ScorePrediction",
    "Series",
    "SeriesOptions",
    "Session",
    "SessionOptions",
    "ShardOptions",
    "Sides",
    "SpectralBasis",
    "SpectralBasisCounts",
    "SpectralBasisOptions",
    "SpectralSplit",
    "Stage",
    "Start",
    "Status",
    "Study",
    "StudyChange",
    "StudyCounts",
    "StudyField",
    "StudyKind",
    "StudyOptions",
    "StudyValue",
    "SurfaceTransferPoints",
    "Train",
    "TrainOptions",
    "Transfer",
    "TuneOptions",
    "Tuning",
    "Units",
    "Visits",
    "VisitsOptions",
    "VisitsRemovedVolume",
    "Zone",
    "ZoneAlignment",
    "ZoneDistance",
    "ZoneKind",
    "ZoneReading",
    "ZoneVolume",
    "Zones",
    "build_id",
    "status_name",
    "version_number",
    "version_string",
]


class Status(enum.IntEnum):
    """MIEN_STATUS_* of the C interface."""
    OK = 0
    #: a parameter is null or out of its range
    E_INVALID_ARGUMENT = -1
    #: a handle is null, released or of another type
    E_INVALID_HANDLE = -2
    #: empty, not finite, index out of range, degenerate
    E_INVALID_MESH = -3
    #: the count was written, nothing else
    E_BUFFER_TOO_SMALL = -4
    #: an option, a switch or an enumerator that this library does not know
    E_UNSUPPORTED_OPTION = -5
    #: ABI or file format of another major version
    E_UNSUPPORTED_VERSION = -6
    #: an allocation failed; the session stays usable
    E_NO_MEMORY = -7
    #: the session's max_bytes would be exceeded
    E_MEMORY_BUDGET = -8
    #: a file cannot be opened, read or written
    E_IO = -9
    #: a file is not what its format says
    E_BAD_FORMAT = -10
    #: hash mismatch, or values that are not finite
    E_CORRUPT = -11
    #: a good file of another kind
    E_WRONG_KIND = -12
    #: inputs that do not belong together
    E_MISMATCH = -13
    #: a factorisation or an iteration failed
    E_NO_SOLUTION = -14
    #: an unknown name
    E_NOT_FOUND = -15
    #: by a progress callback or a cancel token
    E_CANCELLED = -16
    #: a callback unwound
    E_CALLBACK = -17
    #: a defect of the library: please report it
    E_INTERNAL = -18
    #: the session is in a call on another thread; since 0.2
    E_BUSY = -19
    #: the session's max_seconds have passed; since 0.2
    E_TIME_LIMIT = -20


class Stage(enum.IntEnum):
    """Stages of long work, as a progress callback sees them."""
    READING = 1
    GEODESICS = 2
    BASIS = 3
    ALIGNMENT = 4
    FITTING = 5
    REFINING = 6
    TRAINING = 7
    NEUTRALIZING = 8
    MEASURING = 9
    WRITING = 10


class Log(enum.IntEnum):
    """MIEN_LOG_* of the C interface."""
    ERROR = 1
    WARNING = 2
    INFO = 3
    DEBUG = 4


class Dtype(enum.IntEnum):
    """MIEN_DTYPE_* of the C interface."""
    F32 = 1
    F64 = 2
    I32 = 3
    U32 = 4
    U8 = 5


class KernelKind(enum.IntEnum):
    """Kernels: what makes two vertices of the template move alike."""
    #: no kernel: modes from faces alone (needs pca_dataset)
    NONE = 0
    #: squared exponential of the straight distance
    EUCLIDEAN_SE = 1
    #: of the distance along the surface: mouth and eyes may open
    GEODESIC_SE = 2
    #: cubic B-splines on a grid in space
    BSPLINE = 3
    #: Matern along the surface, positive definite by construction
    SURFACE_MATERN = 4


class Heat(enum.IntEnum):
    """What the heat of the heat method does at borders of the template."""
    #: stays inside
    NEUMANN = 1
    #: is cooled to zero
    DIRICHLET = 2
    #: half of each
    AVERAGE = 3


class Mark(enum.IntEnum):
    """What is known of a landmark."""
    #: null, not a number, "not defined" or a placeholder in its file
    NOT_PICKED = 0
    PLACE = 1
    VERTEX = 2


class Measure(enum.IntEnum):
    """Kinds of measurements."""
    #: straight, mm
    LENGTH = 1
    #: along the skin, mm
    SURFACE_LENGTH = 2
    #: degrees
    ANGLE = 3
    #: signed, of one line against another, degrees
    INCLINATION = 4
    #: percent
    PROPORTION = 5
    #: signed distance from a line, mm
    LINE_OFFSET = 6


class ZoneKind(enum.IntEnum):
    """Places of the whole face and of what no zone covers, beside 0 .. zone_count - 1."""
    WHOLE = -1
    REST = -2


class Field(enum.IntEnum):
    """Fields with one value per vertex of the before face."""
    #: along the normal of the before face
    SIGNED_DISTANCE_MM = 1
    #: length of the displacement or to the closest place
    DISTANCE_MM = 2
    POSITIVE_VOLUME_MM3 = 3
    NEGATIVE_VOLUME_MM3 = 4
    #: 1/mm, positive where the surface bulges outwards
    CURVATURE_MAXIMAL = 5
    #: 1/mm
    CURVATURE_MINIMAL = 6
    #: 1/mm
    CURVATURE_MEAN = 7
    #: 1/mm^2
    CURVATURE_GAUSSIAN = 8


class Carry(enum.IntEnum):
    """How vertices are carried onto a surface that is not in correspondence."""
    CLOSEST_POINT = 1
    #: along one direction: a height field's integral
    DIRECTION = 2
    VERTEX_NORMAL = 3


class MirrorBy(enum.IntEnum):
    """What the mirror plane of a face is found by."""
    #: all vertices and their partners, robustly
    SURFACE = 0
    #: the landmarks and their partners alone
    LANDMARKS = 1


class Mass(enum.IntEnum):
    """Mass matrices of the Laplacian."""
    MIXED_VORONOI = 0
    BARYCENTRIC = 1
    #: bands then follow the triangulation's density; for comparison
    NONE = 2


class Cotangents(enum.IntEnum):
    """What to do with negative cotangent weights."""
    INTRINSIC_DELAUNAY = 0
    CLAMP = 1
    KEEP = 2


class Metric(enum.IntEnum):
    """Distances between two faces."""
    #: mm: mean of |dx| + |dy| + |dz| over the vertices
    L1 = 1
    #: mm: mean Euclidean distance over the vertices
    L2 = 2
    #: mm: largest distance of a vertex from the other surface, both ways
    HAUSDORFF = 3
    #: rad: change of the dihedral angles, masked, weighted with area
    DAME = 4
    #: 0 to 1: difference of the global roughness
    FMPD = 5


class Growth(enum.IntEnum):
    """How the number of deformation modes grows over the rounds (jousse-2022 2.5.2.2)."""
    CONSTANT = 0
    LINEAR = 1
    EXPONENTIAL = 2
    CUBIC = 3


class Start(enum.IntEnum):
    """Where a fit begins."""
    #: landmarks when three match, else a search
    AUTOMATIC = 0
    LANDMARKS = 1
    #: start_rotation, start_translation, start_scale
    POSE = 2
    #: over all poses, those up to 60 degrees off frontal first
    SEARCH = 3


class Units(enum.IntEnum):
    """What one unit of the scan is."""
    #: metres, deci- and centimetres and inches are recognised by size and scaled
    DETECT = 0
    MILLIMETRES = 1
    #: anything that does not look like millimetres is an error
    REFUSE = 2


class Sides(enum.IntEnum):
    """What is done about landmarks whose left and right are exchanged."""
    #: MIEN_E_MISMATCH that names them
    REFUSE = 0
    #: exchange them back and say so in the report
    MEND = 1
    IGNORE = 2


class Quality(enum.IntEnum):
    """How far a fit is to be trusted."""
    GOOD = 0
    DOUBTFUL = 1
    FAILED = 2


class RegistrationKind(enum.IntEnum):
    """Fields with one value per template vertex."""
    #: signed distance to the scan, positive: the scan lies outside
    RESIDUAL_MM = 1
    #: in [0, 1]: how much of the scan's say counted
    WEIGHT = 2
    #: of the place, per axis (root mean square)
    STANDARD_DEVIATION_MM = 3
    #: the true place lies within, 95 times out of 100: the deviation's pattern in the size of the zone's
    #: expected error (mien_registration_get_expected_error)
    RADIUS95_MM = 4
    #: how far the surface may lie off the skin along its normal: what mien_measure_options wants. Since 0.2
    NORMAL_DEVIATION_MM = 5


class Transfer(enum.IntEnum):
    """What mien_surface_transfer_json() carries over."""
    LANDMARKS = 1
    ZONES = 2


class Fit(enum.IntEnum):
    """How a face is taken apart into identity and expression."""
    #: prior of one of a few expressions; the default and the best
    MIXTURE = 0
    #: Gaussian priors
    MAP = 1
    #: joint least squares without a prior
    EXACT = 2
    #: block relaxation, for reproduction
    ALTERNATING = 3


class Pose(enum.IntEnum):
    """Where a face lies against the training faces."""
    #: on the model's stable zone where it has one; else rigid when the face lies more than 3 degrees or 8 mm
    #: away from the mean face and a rigid motion explains it clearly better, else kept
    AUTO = 0
    #: in the training's frame
    KEEP = 1
    #: anywhere: a rigid motion is fitted together with the face
    RIGID = 2


class Reading(enum.IntEnum):
    """How a treated zone is read."""
    #: the zone is no witness: what the result holds
    TREATED = 0
    #: all of the face is a witness
    AS_EXPRESSION = 1


class MapKind(enum.IntEnum):
    """Directions of a hierarchy's maps."""
    #: from the next finer level to this one
    DOWN = 1
    #: from this level to the next finer one
    UP = 2


class Features(enum.IntEnum):
    """Representations."""
    EUCLIDEAN = 1
    EUCLIDEAN_STANDARDISED = 2
    EUCLIDEAN_NORMALISED = 3
    DEFORMATION = 4
    DEFORMATION_NORMALISED = 5
    DEFORMATION_STANDARDISED = 6


class Pls(enum.IntEnum):
    """Which algorithm finds the latent variables; with one score both give the same regression."""
    NIPALS = 0
    SIMPLS = 1


class ScoreFeatures(enum.IntEnum):
    """What each vertex gives. jousse-2022 (B.2) has 17 numbers a vertex without naming them; ours are displacement
    (3), change of the normal (3), k1, k2, mean and Gaussian curvature, curvedness, and the curvature tensor
    (6), each of them an equal part of curvature_share.
    """
    #: displacement, k1, k2
    DISPLACEMENT_AND_CURVATURE = 0
    #: all 17
    ALL = 1


class StudyKind(enum.IntEnum):
    """Why a change has no deviation."""
    KNOWN = 0
    #: too little of the zone was seen: no values either
    UNSEEN = 1
    #: the fit of one of the visits failed
    FAILED_FIT = 2
    #: a face came without deviations
    NO_SURFACE_ERRORS = 3
    #: the zone lies behind the expression model's rim
    OUTSIDE_EXPRESSIONS = 4


class StudyField(enum.IntEnum):
    """Fields with one value per vertex of a visit's face."""
    #: how far the fitted surface may lie off the skin
    NORMAL_SD_MM = 1
    #: in [0, 1]: how far the scan was seen there
    WEIGHT = 2
    #: of the expression that was taken off: root of the summed posterior variance of a place's coordinates
    EXPRESSION_SD_MM = 3


class Train(enum.IntEnum):
    """How the two subspaces are found."""
    #: joint PCA
    JPCA = 0
    #: quasi-orthogonal joint PCA
    QOJPCA = 1


class SessionOptions(_Options):
    """mien_session_options of the C interface."""
    _name = "mien_session_options"
    #: 1 (default) to 256; 1 starts no thread. Results do not depend on it.
    num_threads: int
    #: memory budget of one call, 0 (default): none. Counted while the call runs, over all that the library's own
    #: code allocates, the result included; MIEN_E_MEMORY_BUDGET before it would be exceeded. Mapped files do not
    #: count.
    max_bytes: int
    #: null (default): silent. The library never prints.
    log: Callable[[int, str], None] | None
    #: time limit of one call, 0 (default): none, to 1e8; after it a call ends with MIEN_E_TIME_LIMIT as soon as
    #: it would end for a cancel token. Since 0.2.
    max_seconds: float
    #: 0 (default): model files and datasets are mapped, and a file that another program shortens meanwhile may
    #: end the process (as with any mapping; one that is replaced by renaming, as the library writes, is safe);
    #: 1: they are read into memory. Since 0.2.
    copy_files: int


class Zone(_Record):
    """A named set of vertices of a surface, read in place and only during the call."""
    _name = "mien_zone"
    name: Text
    #: vertex_count vertex numbers, repeated ones count once
    vertices: ArrayLike

    def __init__(self, name: Text, vertices: ArrayLike) -> None:
        self.name = name
        self.vertices = vertices


class Image(_Record):
    """A texture image of the host's, read in place and only during the call: either pixels or the bytes of a file."""
    _name = "mien_image"
    #: UTF-8 file name without a folder; may be left out
    name: Text | None
    #: height rows of width x 3 red green blue, from the top; may be left out
    pixels: ArrayLike | None
    #: from row to row; 0: tightly packed
    row_stride_bytes: int
    #: of pixels, else 0
    width: int
    #: of pixels, else 0
    height: int
    #: the bytes of a JPEG or PNG file; may be left out: when pixels are given
    file: ArrayLike | None

    def __init__(self, row_stride_bytes: int = 0, width: int = 0, height: int = 0, name: Text | None = None, pixels: ArrayLike | None = None, file: ArrayLike | None = None) -> None:
        self.name = name
        self.pixels = pixels
        self.row_stride_bytes = row_stride_bytes
        self.width = width
        self.height = height
        self.file = file


class Material(_Record):
    """A material of a mesh, read in place and only during the call."""
    _name = "mien_material"
    #: UTF-8; may be left out
    name: Text | None
    #: number of the base colour's image, -1: none
    image: int
    #: 0 to 1; an image is times this
    red: float
    green: float
    blue: float

    def __init__(self, image: int = 0, red: float = 0, green: float = 0, blue: float = 0, name: Text | None = None) -> None:
        self.name = name
        self.image = image
        self.red = red
        self.green = green
        self.blue = blue


class MeshArrays(_Options):
    """What a mesh is made of."""
    _name = "mien_mesh_arrays"
    #: #V x 3, F32 or F64, mm
    positions: ArrayLike
    #: #F x 3 tightly packed, counter-clockwise seen from outside; may be left out
    triangles: ArrayLike | None
    #: #V x 3 red green blue, tightly packed; may be left out
    colors: ArrayLike | None
    #: #T x 2, (0, 0) at the image's lower left corner; may be left out
    texture: ArrayLike | None
    #: #F x 3 numbers of texture; may be left out: with texture, texture has a row for each vertex
    texture_triangles: ArrayLike | None
    #: may be left out
    materials: Sequence[Material] | None
    #: #F numbers of materials; null: all are of the first
    triangle_materials: ArrayLike | None
    #: may be left out
    images: Sequence[Image] | None


class Kernel(_Record):
    """One more kernel of a sum."""
    _name = "mien_kernel"
    #: MIEN_KERNEL_..., not NONE
    kind: KernelKind | int
    sigma_mm: float
    scale_mm: float
    #: read for SURFACE_MATERN only
    nu: float

    def __init__(self, kind: KernelKind | int = 0, sigma_mm: float = 0, scale_mm: float = 0, nu: float = 0) -> None:
        self.kind = kind
        self.sigma_mm = sigma_mm
        self.scale_mm = scale_mm
        self.nu = nu


class Landmark(_Record):
    """A named vertex of the template."""
    _name = "mien_landmark"
    name: Text
    vertex: int

    def __init__(self, name: Text, vertex: int = 0) -> None:
        self.name = name
        self.vertex = vertex


class LandmarkObservation(_Record):
    """Where a landmark was seen."""
    _name = "mien_landmark_observation"
    #: of a landmark of the model; null: `vertex` says which
    name: Text | None
    #: read when name is null
    vertex: int
    #: mm, in the frame of the template
    position: Sequence[float]
    #: standard deviation of each coordinate, >= 0.000001
    noise_mm: float

    def __init__(self, position: Sequence[float], vertex: int = 0, noise_mm: float = 0, name: Text | None = None) -> None:
        self.name = name
        self.vertex = vertex
        self.position = position
        self.noise_mm = noise_mm


class ModelOptions(_Options):
    """mien_model_options of the C interface."""
    _name = "mien_model_options"
    #: MIEN_KERNEL_..., default GEODESIC_SE
    kernel: KernelKind | int
    #: length scale; full width for BSPLINE; > 0, default 20
    sigma_mm: float
    #: standard deviation of a displacement's coordinate; > 0, default 3
    scale_mm: float
    #: smoothness of SURFACE_MATERN, 0.1 to 20, default 2
    nu: float
    #: 1 to 12, default 1: sum of kernels with sigma, 2 sigma, 4 sigma, ...
    levels: int
    #: deformation modes at most, 3 per scalar mode; >= 3, default 999
    num_modes: int
    #: kernel_count kernels added to the one above; may be left out
    kernels: Sequence[Kernel] | None
    #: > 0: stop once this share of the variance is left; default 0
    tolerance: float
    #: default 0: max(1000, num_modes), never more than #V
    num_control_points: int
    #: 1: modes purely even or odd about the plane x = 0; default 0
    mirror_symmetric: int
    #: 0 to 1: how much both sides are expected to move alike; default 0
    mirror_correlation: float
    #: eigenvalues among the control points below this share of the largest are dropped; 0 < x < 1, default
    #: 0.0001
    eigenvalue_threshold: float
    #: heat time in units of (mean edge)^2, 0.01 to 10000, default 4
    heat_time_factor: float
    #: MIEN_HEAT_..., default NEUMANN
    heat_boundary: Heat | int
    #: default 0: as many as pca_variance asks for
    pca_modes: int
    #: UTF-8 path of a dataset of registered faces, or null: adds their mean and principal modes; the kernel then
    #: stands for what they leave over
    pca_dataset: Text | None
    #: share of the faces' variance kept, 0 to 1, default 0.999
    pca_variance: float
    #: 1 (default): all faces, 0: neutral ones
    pca_all_expressions: int
    #: 1: move each face rigidly onto the template first; default 0
    pca_align: int
    #: #V x 1 factors >= 0 of scale_mm; count 0: one everywhere
    scale_per_vertex: ArrayLike
    #: landmark_count; may be left out
    landmarks: Sequence[Landmark] | None
    #: zone_count; may be left out
    zones: Sequence[Zone] | None


class TuneOptions(_Options):
    """mien_tune_options of the C interface."""
    _name = "mien_tune_options"
    #: MIEN_KERNEL_..., not NONE; default GEODESIC_SE
    kernel: KernelKind | int
    #: sigma_count length scales to try, each > 0
    sigmas_mm: ArrayLike
    #: > 0, default 1
    scale_mm: float
    #: default 2
    nu: float
    #: weight of the prior in the fits, >= 0, default 5
    rho: float
    #: 1 to 12, default 1
    levels: int
    #: deformation modes, >= 3, default 999
    num_modes: int
    #: expression_count names: these faces only; null: all
    expressions: Sequence[str] | None
    #: of the dataset's order; 0 (default): all
    max_subjects: int
    #: scale_count scales to try with each sigma, each > 0; null: scale_mm alone
    scales_mm: ArrayLike | None
    #: level_count numbers of levels to try with each of those, each 1 to 12; null: `levels` alone
    level_counts: ArrayLike | None


class ScanLandmark(_Record):
    """A named place on a scan, read in place and only during the call."""
    _name = "mien_scan_landmark"
    #: matched with the names stored in the model
    name: Text
    #: in the scan's frame and unit
    position: Sequence[float]

    def __init__(self, name: Text, position: Sequence[float]) -> None:
        self.name = name
        self.position = position


class AnthropometryOptions(_Options):
    """mien_anthropometry_options of the C interface."""
    _name = "mien_anthropometry_options"
    #: #V, mm: deviation of each vertex' place per axis, as MIEN_REGISTRATION_STANDARD_DEVIATION_MM tells it;
    #: count 0: not known, and no deviation
    place_sd: ArrayLike
    #: #V, mm: along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: as place_sd
    normal_sd: ArrayLike
    #: over which a template slides together along the skin; default 15
    slide_correlation_mm: float
    #: over which it errs together across the skin; default 4
    normal_correlation_mm: float
    #: may be left out: no z-scores
    norms: Norms | None


class AnthropometricValue(_Record):
    """One measurement of a face. NaN where a number is not known."""
    _name = "mien_anthropometric_value"
    #: MIEN_MEASURE_*
    kind: Measure | int
    #: NaN: mien_anthropometry_get_reason() says why
    value: float
    #: of the value, by the errors of the landmarks' places
    sd: float
    #: (value - norm_mean) / norm_sd
    z: float
    #: sd / norm_sd
    z_sd: float
    #: over the people of the norms
    norm_mean: float
    norm_sd: float
    #: 0: no norm
    norm_people: int


class MeasureOptions(_Options):
    """mien_measure_options of the C interface."""
    _name = "mien_measure_options"
    #: surfaces not in correspondence: 1 (default) leaves out places whose partner lies on an open border, where
    #: nothing is known
    skip_borders: int
    #: zone_count zones; null: the whole face only
    zones: Sequence[Zone] | None
    #: #V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it;
    #: count 0: exact. Without that of either face there is no interval (since 0.2), whatever the alignment's
    before_sd: ArrayLike
    after_sd: ArrayLike
    #: over which errors of a surface go together; default 4, in 0.1: 10
    correlation_length_mm: float
    #: of the after face against the before face; default 0
    alignment_rotation_sd_rad: float
    #: default 0
    alignment_translation_sd_mm: float
    #: mm; what the alignment turns about, e.g. the stable zone's centre
    alignment_centre: Sequence[float]
    #: error common to all vertices; default 0
    common_bias_mm: float
    #: smaller changes are marked as below it; default 0: unknown
    limit_of_detection_ml: float
    #: surfaces not in correspondence: farther partners are none; default 0: no limit
    max_distance_mm: float


class ZoneVolume(_Record):
    """Volume of one zone, mL. signed = positive + negative, absolute = positive - negative; positive: the after
    face lies outside. NaN where a number is not known.
    """
    _name = "mien_zone_volume"
    #: 1: |signed| reaches the limit of detection, 0: below it, -1: no limit given
    detected: int
    signed_ml: float
    #: >= 0
    positive_ml: float
    #: <= 0
    negative_ml: float
    absolute_ml: float
    #: of signed_ml; NaN when no deviation was given
    sd_ml: float
    #: 95 % interval of signed_ml
    low95_ml: float
    high95_ml: float
    area_before_mm2: float
    #: NaN for surfaces not in correspondence
    area_after_mm2: float


class ZoneDistance(_Record):
    """Distances of one zone, mm, weighted with area."""
    _name = "mien_zone_distance"
    #: along the normal of the before face; positive: outside
    mean_signed_mm: float
    sd_signed_mm: float
    #: of the signed ones
    mean_absolute_mm: float
    #: of the lengths
    rms_mm: float
    mean_length_mm: float
    median_length_mm: float
    p95_length_mm: float
    max_length_mm: float
    #: vertices that had a partner
    vertex_count: int


class ZoneAlignment(_Record):
    """A rigid alignment on a stable zone and how sure it is."""
    _name = "mien_zone_alignment"
    #: that counted
    pairs: int
    #: left over along the normals
    rms_mm: float
    #: about the centre, root mean square over the axes
    rotation_sd_rad: float
    #: per axis, root mean square
    translation_sd_mm: float
    #: of the zone on the target
    centre: numpy.ndarray
    #: 4 x 4 row by row, moving to target
    matrix: numpy.ndarray


class AsymmetryOptions(_Options):
    """mien_asymmetry_options of the C interface."""
    _name = "mien_asymmetry_options"
    #: MIEN_MIRROR_BY_*; default by the surface
    plane: MirrorBy | int
    #: zone_count zones of either side; null: the whole side only
    zones: Sequence[Zone] | None
    #: of the template, vertices; may be left out unless the plane is found by them
    landmarks: Landmarks | None
    #: #V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it;
    #: count 0: not known, and no interval
    normal_sd: ArrayLike
    #: over which errors of the surface go together; default 4
    correlation_length_mm: float


class MirrorPlane(_Record):
    """The plane between left and right. NaN where a number is not known."""
    _name = "mien_mirror_plane"
    #: MIEN_MIRROR_BY_*
    by: MirrorBy | int
    #: of partners that counted
    pairs: int
    #: unit, to the subject's left
    normal: numpy.ndarray
    #: mm, in the plane
    centre: numpy.ndarray
    #: of the distances between a side and the other's reflection
    rms_mm: float
    #: about either direction of the plane, root mean square
    tilt_sd_rad: float
    #: along the normal
    offset_sd_mm: float
    #: angle to the plane found the other way; NaN without landmarks
    between_rad: float
    #: of that plane from the centre, along its normal
    apart_mm: float


class SpectralBasisOptions(_Options):
    """mien_spectral_basis_options of the C interface."""
    _name = "mien_spectral_basis_options"
    #: 1 to #V - 1; default 500
    mode_count: int
    #: MIEN_MASS_...; default mixed Voronoi
    mass: Mass | int
    #: MIEN_COTANGENTS_...; default intrinsic Delaunay
    cotangents: Cotangents | int


class BlendshapeOptions(_Options):
    """mien_blendshape_options of the C interface."""
    _name = "mien_blendshape_options"
    #: of the kernel's mean diagonal; default 0: by leave-one-out error
    ridge: float


class BandChoice(_Record):
    """One tried k of mien_blendshape_model_search()."""
    _name = "mien_band_choice"
    k: int
    l1_mm: float
    dame: float
    fmpd: float
    #: 1: no other k is better in both L1 and FMPD
    on_front: int
    #: 1: the front's knee
    chosen: int

    def __init__(self, k: int = 0, l1_mm: float = 0, dame: float = 0, fmpd: float = 0, on_front: int = 0, chosen: int = 0) -> None:
        self.k = k
        self.l1_mm = l1_mm
        self.dame = dame
        self.fmpd = fmpd
        self.on_front = on_front
        self.chosen = chosen


class RegisterOptions(_Options):
    """mien_register_options of the C interface."""
    _name = "mien_register_options"
    #: MIEN_GROWTH_*; default constant, with annealed noise
    growth: Growth | int
    #: landmark_count landmarks; null: none
    landmarks: Sequence[ScanLandmark] | None
    #: picking error per axis, > 0; default 2
    landmark_sigma_mm: float
    #: MIEN_START_*; default automatic
    start: Start | int
    #: MIEN_UNITS_*; default detect
    units: Units | int
    #: one weight in [0, 1] per scan vertex; count 0: all one
    scan_weights: ArrayLike
    #: 1: weigh scan vertices by the probability of skin colour; default 0
    skin_weights: int
    #: 1 (default): a smooth field closes what the modes leave open
    close_gap: int
    #: of the model's kernel modes; default -1: all
    max_scalar_modes: int
    #: of the model's trained modes; default -1: all
    max_pca_modes: int
    #: 1 to 10000; default 0: as many as the library thinks right
    iterations: int
    #: 1 (default): places on the scan's open border do not pull
    reject_border: int
    #: noise level of a surface point in the first round; default 3
    sigma_start_mm: float
    #: and in the last; default 0.5
    sigma_end_mm: float
    #: between the normals of a vertex and its place; default 60
    max_angle_deg: float
    #: row by row, template to scan; default identity
    start_rotation: Sequence[float]
    #: mm
    start_translation: Sequence[float]
    #: default 1
    start_scale: float
    #: 1 (default): where the scan has vertex colours, its lips and brows hold the fit along the skin, and
    #: without landmarks eyes are seen to be shut; 0: by form alone. Needs landmarks of the 68-point scheme in
    #: the model (brow_*, mouth_outer_*, eye_*) or its zone "lips"
    color_features: int
    #: one unit of the scan in mm when it is known, e.g. 25.4; 0 (default): by `units` and by the landmarks,
    #: which settle it
    unit_to_mm: float
    #: MIEN_SIDES_*; default refuse
    landmark_sides: Sides | int
    #: places of the scan that are farther from their vertex do not pull, nearly so far ones less; default 0: as
    #: the noise level lets. Since 0.2
    max_distance_mm: float
    #: a place pulls a vertex while the vertex that is nearest to the place lies no farther than that from it;
    #: default 0: not asked. Below the template's spacing hardly any place pulls. Since 0.2
    mutual_mm: float
    #: soft assignment: a vertex is pulled to the mean of the scan around its nearest place, weighed by a
    #: Gaussian of this deviation; default 0: to the place itself. Since 0.2
    soft_mm: float


class FitVerdict(_Record):
    """The verdict on a fit; the reasons in words are in the JSON report. The quality is that of the error expected
    of the whole face (mien_registration_get_expected_error()), doubtful at best where a zone has failed.
    """
    _name = "mien_fit_verdict"
    #: MIEN_QUALITY_*
    quality: Quality | int
    #: share of the template's vertices with a scan beside them
    coverage: float
    #: of those: share that lies on the scan
    inlier_share: float
    mean_residual_mm: float
    #: 0 without landmarks
    landmark_rms_mm: float
    #: fitted size over template size
    size_ratio: float
    #: of the coefficients, in standard deviations of the prior
    mean_deviation: float
    #: what one unit of the scan was taken for
    unit_to_mm: float
    landmarks_used: int
    landmarks_rejected: int
    flipped_triangles: int
    self_intersections: int


class ExpectedError(_Record):
    """How far a fitted zone is expected to be from the truth: the mean distance of its vertices from the true
    ones, learned from simulated fits of many people, poses and troubles. Since 0.2
    """
    _name = "mien_expected_error"
    #: MIEN_QUALITY_*, of the zone alone
    quality: Quality | int
    expected_mm: float
    #: 8 of 10 like fits are between low_mm and high_mm off
    low_mm: float
    high_mm: float
    #: 0 to 1: share of the zone that the scan had no say in
    unseen: float


class NeutralizeOptions(_Options):
    """mien_neutralize_options of the C interface."""
    _name = "mien_neutralize_options"
    #: MIEN_FIT_..., default MIEN_FIT_MIXTURE
    method: Fit | int
    #: alternating; 1 to 100000, default 200
    max_sweeps: int
    #: 1: compute the deviation per vertex; default 0
    uncertainty: int
    #: MIEN_POSE_..., default MIEN_POSE_AUTO
    pose: Pose | int
    #: alternating: stop when a sweep moves less; default 1e-6
    tolerance_mm: float
    #: 0 (default): the model's own
    noise_mm2: float
    #: how far a displacement reaches beyond the model's rim; default 25
    decay_mm: float
    #: #V x 1, >= 0: 0 where the scan had no data; count 0: all one
    weights: ArrayLike
    #: treated_count vertices where the person may have been changed: no witness of expression or pose, so that
    #: filler in a lip stays on the face and is not taken for a rolled lip; null: none. Since 0.2
    treated: ArrayLike | None
    #: around them, no witness either; treatments spread; 0 to 100, default 10
    treated_margin_mm: float


class ZoneReading(_Record):
    """What a reading takes off inside the treated zone (without its margin)."""
    _name = "mien_zone_reading"
    #: 1: the two readings see another expression and another volume
    differ: int
    #: of the likeliest expression, which the JSON names
    probability: float
    #: root mean square over the zone
    removed_mm: float
    #: by which the zone stood out through the expression, to first order
    removed_ml: float


class EvaluateOptions(_Options):
    """mien_evaluate_options of the C interface."""
    _name = "mien_evaluate_options"
    #: MIEN_FIT_..., default MIEN_FIT_MIXTURE
    method: Fit | int
    #: of the method; default 200
    max_sweeps: int
    #: MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING
    against_method: Fit | int
    #: default 3
    against_max_sweeps: int
    #: second model to compare with; may be left out
    against: ExpressionModel | None
    #: measure on these vertices only; null: all
    zone_vertices: ArrayLike | None
    #: align every face rigidly to its target on these first; null: not
    stable_vertices: ArrayLike | None
    #: absolute volumes to the neutral face are measured in these, too; null: none. Since 0.2
    volume_zones: Sequence[Zone] | None


class GeodesicOptions(_Options):
    """mien_geodesic_options of the C interface."""
    _name = "mien_geodesic_options"
    #: MIEN_HEAT_..., default NEUMANN
    heat_boundary: Heat | int
    #: heat time in units of (mean edge)^2, 0.01 to 10000, default 4
    heat_time_factor: float


class ModelFitOptions(_Options):
    """mien_model_fit_options of the C interface."""
    _name = "mien_model_fit_options"
    #: 1: move the target rigidly onto the model's mean; default 0
    align: int
    #: rho: variance of the target's noise, mm^2, >= 0; default 1
    ridge_mm2: float
    #: one per vertex of the target, >= 0, which enter squared; count 0: all one
    weights: ArrayLike
    #: the first of them, the others stay 0; -1 (default): all
    scalar_modes: int
    #: the first of them, the others stay 0; -1 (default): all
    vector_modes: int


class NetworkOptions(_Options):
    """How to run; initialise with mien_network_options_init()."""
    _name = "mien_network_options"
    #: may be left out; looked at between layers
    cancel: Cancel | None


class NetworkEvaluationOptions(_Options):
    """What to evaluate; initialise with mien_network_evaluation_options_init()."""
    _name = "mien_network_evaluation_options"
    #: 1: only the faces marked neutral; default 0: all
    neutral_only: int
    #: 1 (default): DAME and FMPD too; 0: distances alone
    perceptual: int
    #: faces of these subjects; null: of all
    subjects: ArrayLike | None


class RepresentationOptions(_Options):
    """How to train; initialise with mien_representation_options_init()."""
    _name = "mien_representation_options"
    #: 1: only the faces marked neutral; default 0: all
    neutral_only: int


class ScoreOptions(_Options):
    """mien_score_options of the C interface."""
    _name = "mien_score_options"
    #: MIEN_PLS_*; default NIPALS
    method: Pls | int
    #: 0 (default): by cross-validation and the one-standard-error rule
    num_components: int
    #: tried in cross-validation, 1 to 50; default 10
    max_components: int
    #: over subjects; 0: leave one subject out; default 10
    folds: int
    #: of the folds; default 1
    seed: int
    #: total variance of the curvature features over that of the displacements; 0: none; default 0.1
    curvature_share: float
    #: of the fits that estimate curvature; default 8
    curvature_radius_mm: float
    #: range that predictions are cut to
    lowest: float
    #: equal (default): none
    highest: float
    #: of interest; null: all
    zone_vertices: ArrayLike | None
    #: faces are aligned on these; null: on all, robustly
    stable_vertices: ArrayLike | None
    #: 1 (default): vertices count by how far they move with the score, found anew in each fold; 0: by their area
    #: alone
    focus: int
    #: MIEN_SCORE_FEATURES_*; default displacement and curvature. Since 0.2
    features: ScoreFeatures | int


class ScorePrediction(_Record):
    """A predicted score."""
    _name = "mien_score_prediction"
    #: 1: the face is unlike the training faces
    extrapolates: int
    score: float
    #: 95 % prediction interval
    low95: float
    high95: float
    #: distance from the training faces, about components / faces on average
    leverage: float


class SeriesOptions(_Options):
    """mien_series_options of the C interface."""
    _name = "mien_series_options"
    #: MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP
    method: Fit | int
    #: MIEN_POSE_..., default MIEN_POSE_AUTO
    pose: Pose | int
    #: what differs between scans beyond the model, as a share of the noise variance; default 0.01
    scan_noise_share: float
    #: noise variance; 0 (default): the model's own
    noise_mm2: float
    #: where the identity may change between scans; null: nowhere
    changing_vertices: ArrayLike | None
    #: > 0, default 5; without effect since 0.2: what lies there is no witness of the expression at all
    expected_change_mm: float
    #: face_count x #V, face by face, >= 0: 0 where a scan had no data; count 0: all one.
    weights: ArrayLike


class StudyOptions(_Options):
    """mien_study_options of the C interface."""
    _name = "mien_study_options"
    #: zone_count zones to measure; null: those of the registrations' model
    zones: Sequence[Zone] | None
    #: treated_count names: where the person may have changed, no witness of expression or pose; null: none
    treated_zones: Sequence[str] | None
    #: stable_count names of zones to align on; null: all but the treated ones when zones are treated and
    #: expressions taken off, otherwise "forehead" and "nose"; without any zone the whole face
    stable_zones: Sequence[str] | None
    #: visit_number_count numbers, the visit of each face, from 0 and ascending: several captures of one visit
    #: tell the limits of detection; null: each face is a visit of its own
    visits: ArrayLike | None
    #: around the treated zones, 0 to 100, measured with them as zones of their own at the end; default 10
    margin_mm: float
    #: of the intervals, above 0 and below 1; default 0.95
    level: float
    #: of a scanner's surface along its normal, where it was seen; default 0.08
    noise_mm: float
    #: over which the errors of a fitted surface go together; default 4
    correlation_length_mm: float
    #: error common to all vertices; default 0.01
    common_bias_mm: float
    #: of the volume that an expression accounted for: what no training set knew of it; default 0.06
    untrained_share: float
    #: of a zone's area that both visits must have seen, 0 to 1; default 0.1
    min_seen_share: float


class StudyValue(_Record):
    """A number with its error. NaN: not known."""
    _name = "mien_study_value"
    value: float
    #: standard deviation
    sd: float
    #: of the interval at the study's level
    low: float
    #: of the interval at the study's level
    high: float
    #: a smaller size cannot be told from no change
    limit_of_detection: float

    def __init__(self, value: float = 0, sd: float = 0, low: float = 0, high: float = 0, limit_of_detection: float = 0) -> None:
        self.value = value
        self.sd = sd
        self.low = low
        self.high = high
        self.limit_of_detection = limit_of_detection


class StudyChange(_Record):
    """What changed in one zone from one visit to another. Set struct_size first."""
    _name = "mien_study_change"
    #: MIEN_STUDY_*: why there is no deviation
    unknown: StudyKind | int
    #: gained and lost together; positive: gained
    signed_ml: StudyValue
    #: >= 0
    gained_ml: StudyValue
    #: <= 0
    lost_ml: StudyValue
    #: gained without lost
    absolute_ml: StudyValue
    area_change_mm2: StudyValue
    #: along the normals of the first face; positive: outside
    mean_distance_mm: StudyValue
    #: of signed_ml.sd: by the fitted surfaces
    surface_sd_ml: float
    #: by the alignment on the stable zone
    alignment_sd_ml: float
    #: by the error common to all vertices
    bias_sd_ml: float
    #: by what taking the expressions off leaves open
    expression_sd_ml: float
    #: what the expressions accounted for, signed
    expression_removed_ml: float
    #: of the zone's area, in both visits; NaN: not told
    seen_share: float
    area_before_mm2: float
    area_after_mm2: float
    #: 1: signed_ml reaches its limit of detection, 0: below it, -1: no limit known
    detected: int


class TrainOptions(_Options):
    """mien_train_options of the C interface."""
    _name = "mien_train_options"
    #: MIEN_TRAIN_..., default MIEN_TRAIN_JPCA
    method: Train | int
    #: 1 to 4000; 0 (default since 0.2, 50 before): of 25, 50, 75 and 100 the fewest that serve people left out
    #: of the training
    identity_modes: int
    #: 1 to 4000; 0 (default): as above
    expression_modes: int
    #: QOJPCA; default 1000
    max_iterations: int
    #: over the data, 1 to 50, default 4
    passes: int
    #: QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX'
    lambda_: float
    #: default 10
    lambda_factor: float
    #: QOJPCA stops when no subspace turns farther; default 0.001
    angle_tolerance_rad: float
    #: noise variance of the fits; 0 (default): by cross-validation
    noise_mm2: float
    #: posture: every face is aligned rigidly on these vertices (forehead, nose bridge), in training and in every
    #: fit; null: faces as they lie
    stable_vertices: ArrayLike | None


class ShardOptions(_Options):
    """mien_shard_options of the C interface."""
    _name = "mien_shard_options"
    #: 0 to part_count - 1, default 0: which subjects
    part: int
    #: default 1: all subjects
    part_count: int
    #: of identities and of expressions, default 512; parts with fewer subjects and faces are exact
    max_rank: int
    #: as in mien_train_options; all parts of a dataset are aligned alike; null: faces as they lie
    stable_vertices: ArrayLike | None


class VisitsOptions(_Options):
    """mien_visits_options of the C interface."""
    _name = "mien_visits_options"
    #: MIEN_POSE_..., default MIEN_POSE_AUTO
    pose: Pose | int
    #: variance of a fitted vertex along the skin's normal, with what no mode explains; default 0.3
    normal_noise_mm2: float
    #: along the skin: fits slide; default 30
    tangential_noise_mm2: float
    #: where the person may have changed: no witness of the expression; null: nowhere
    treated_vertices: ArrayLike | None
    #: face_count x #V, face by face, >= 0: 0 where a scan had no data; count 0: all one
    weights: ArrayLike


class MeasureLengths(NamedTuple):
    #: pair_count values.
    straight_mm: numpy.ndarray
    #: pair_count values; by the heat method, within about one percent; infinite where no surface joins the two.
    geodesic_mm: numpy.ndarray


class MeasureScanVolume(NamedTuple):
    #: may be left out; share of before's area that had a partner, 0 to 1.
    coverage: float
    #: the measurement.
    out: Measurement


class MeasureAlign(NamedTuple):
    #: may be left out
    info: ZoneAlignment
    #: the moved mesh.
    out: Mesh


class SpectralSplit(NamedTuple):
    #: may be left out; the low band's mesh.
    low: Mesh
    #: may be left out; the high band's mesh.
    high: Mesh


class SurfaceTransferPoints(NamedTuple):
    #: triangle (cloud: vertex) numbers of `surface`.
    triangles: numpy.ndarray
    #: rows of 3 values.
    barycentric: numpy.ndarray
    #: rows of 3 values in mm; a lost place keeps where it was.
    positions: numpy.ndarray


class MeshCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out; #F.
    triangle_count: int


class MeshMaterialCounts(NamedTuple):
    #: may be left out.
    material_count: int
    #: may be left out.
    image_count: int


class MeshMaterial(NamedTuple):
    #: may be left out; -1: none.
    image: int
    #: may be left out; 0 to 1.
    red: float
    #: may be left out; 0 to 1.
    green: float
    #: may be left out; 0 to 1.
    blue: float


class MeshImageSize(NamedTuple):
    #: may be left out; pixels.
    width: int
    #: may be left out; pixels.
    height: int


class ModelCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out; columns of the scalar basis; 3 times as many deformation modes.
    scalar_modes: int
    #: may be left out; modes trained on faces.
    vector_modes: int


class LandmarksCounts(NamedTuple):
    #: may be left out.
    count: int
    #: may be left out.
    picked_count: int


class LandmarksMark(NamedTuple):
    #: may be left out; MIEN_MARK_*.
    where: int
    #: may be left out; x, y and z in the file's unit, zeros unless it is a place.
    position: float
    #: may be left out; 0 unless it is a vertex.
    vertex: int


class AnthropometryCounts(NamedTuple):
    #: may be left out.
    count: int
    #: may be left out.
    known_count: int


class MeasurementZones(NamedTuple):
    #: may be left out; the number of zones given.
    zone_count: int
    #: may be left out; 1 when no vertex lies in two zones: zones and rest then add up.
    zones_disjoint: int


class SpectralBasisCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out; k.
    mode_count: int


class RegistrationCorrespondence(NamedTuple):
    #: numbers.
    triangles: numpy.ndarray
    #: rows of 3 values.
    barycentric: numpy.ndarray


class ExpressionModelCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out.
    identity_modes: int
    #: may be left out.
    expression_modes: int


class NeutralizationCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out; those of the model.
    identity_modes: int
    #: may be left out; those of the model.
    expression_modes: int


class NeutralizationCoordinates(NamedTuple):
    #: identity_modes values.
    identity: numpy.ndarray
    #: expression_modes values.
    expression: numpy.ndarray


class HierarchyMap(NamedTuple):
    #: numbers of vertices that the map ends at.
    rows: numpy.ndarray
    #: numbers of vertices that it starts from.
    columns: numpy.ndarray
    #: float64.
    values: numpy.ndarray
    #: may be left out; vertices that the map ends at.
    row_count: int
    #: may be left out; vertices that it starts from.
    column_count: int


class NetworkCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out; numbers of a code.
    code_count: int


class NetworkEncode(NamedTuple):
    #: may be left out; 12 float64: the rigid motion onto the mean, x -> R x + t, as R row by row, then t in mm.
    #: mien_network_decode() takes it back.
    motion: numpy.ndarray
    #: values.
    dst: numpy.ndarray


class RepresentationCounts(NamedTuple):
    #: may be left out; #V.
    vertex_count: int
    #: may be left out; 3, or 9 for deformations.
    channel_count: int


class RepresentationEncode(NamedTuple):
    #: may be left out; 12 float64: the rigid motion onto the mean, x -> R x + t, as R row by row, then t in mm.
    #: mien_representation_decode() takes it back.
    motion: numpy.ndarray
    #: rows of channel_count values.
    dst: numpy.ndarray


class StudyCounts(NamedTuple):
    #: may be left out.
    visit_count: int
    #: may be left out.
    zone_count: int


class VisitsRemovedVolume(NamedTuple):
    #: may be left out; signed, mL.
    removed_ml: float
    #: may be left out; posterior deviation, mL.
    sd_ml: float


class Session(_Object):
    """Threads, limits of memory and time, and logging. Externally synchronized: one call at a time; with more than
    one thread of its own, a session that is in a call on another thread refuses a second call with MIEN_E_BUSY.
    A callback may call the library with the session that called it. Objects made in a session may outlive it.
    """
    _release = "mien_session_release"

    def __init__(self, options: SessionOptions | None = None) -> None:
        """Makes a session with default options: one thread, no memory budget, silent. With options: those."""
        self._take((_run("mien_session_create_with_options", {"options": options}) if options is not None else _run("mien_session_create", {}))[0])

    def hash_file(self, path: Text) -> str:
        """The SHA-256 of a file's bytes as 64 lower-case hexadecimal digits: which model, which scan a result was made
        from. With dst null and capacity 0: the size only, without reading the file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
        MIEN_E_TIME_LIMIT.
        C: mien_session_hash_file()
        """
        return _run("mien_session_hash_file", {"path": path, "session": self})[0]

    def measure_anthropometry(self, face: Mesh, landmarks: Landmarks, options: AnthropometryOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Anthropometry:
        """Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
        hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
        "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly coincide
        with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks are
        missing is NaN with a reason.
        face: #V x 3, mm, with triangles.
        landmarks: vertices of the face, or places on it in its frame (a measurement with a place has no
        deviation, and no length along the skin).
        options: may be left out: no deviations, no norms.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (landmarks, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_anthropometry()
        """
        return _run("mien_measure_anthropometry", {"face": face, "landmarks": landmarks, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_volume(self, before: Mesh, after: Mesh, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per zone,
        exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of
        triangles it shares; disjoint zones and the rest add up to the whole.
        before: #V x 3, mm, with triangles counter-clockwise seen from outside.
        after: same vertex count, in the frame of before; its triangles are not read.
        options: may be left out: the whole face, no uncertainty.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
        MIEN_E_MISMATCH (vertex counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_measure_volume()
        """
        return _run("mien_measure_volume", {"before": before, "after": after, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_distance(self, before: Mesh, after: Mesh, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Distances between two faces in correspondence, per vertex and per zone.
        before: #V x 3, mm.
        after: same vertex count, in the frame of before.
        options: may be left out; zones, progress and cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_distance()
        """
        return _run("mien_measure_distance", {"before": before, "after": after, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_surface_distance(self, before: Mesh, after: Mesh, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
        distance takes both directions.
        before: #V x 3, mm, with triangles.
        after: a surface or a cloud of points, aligned with before.
        options: may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_surface_distance()
        """
        return _run("mien_measure_surface_distance", {"before": before, "after": after, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_closed_volume(self, mesh: Mesh, close_rims: int) -> float:
        """The volume that a mesh encloses, by the divergence theorem about its centroid.
        mesh: manifold along its edges and consistently oriented.
        close_rims: 1: each open rim is closed by a fan from the mean of its vertices; 0: an open mesh is an
        error.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (close_rims),
        MIEN_E_INVALID_MESH (open, not manifold or not oriented: the message counts the edges),
        MIEN_E_NO_MEMORY.
        C: mien_measure_closed_volume()
        """
        return _run("mien_measure_closed_volume", {"mesh": mesh, "close_rims": close_rims, "session": self})[0]

    def measure_area(self, mesh: Mesh, zone: Zone | None = None) -> float:
        """The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices).
        mesh: with triangles.
        zone: may be left out: the whole surface.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zone),
        MIEN_E_NO_MEMORY.
        C: mien_measure_area()
        """
        return _run("mien_measure_area", {"mesh": mesh, "zone": zone, "session": self})[0]

    def measure_curvature(self, mesh: Mesh, radius_mm: float, robust: int, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.
        mesh: #V x 3, mm, with triangles counter-clockwise seen from outside.
        radius_mm: > 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.
        robust: 1: a second fit leaves spikes and lashes out; 0: none.
        options: may be left out; zones, progress and cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust),
        MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_curvature()
        """
        return _run("mien_measure_curvature", {"mesh": mesh, "radius_mm": radius_mm, "robust": robust, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_lengths(self, mesh: Mesh, pairs: ArrayLike) -> MeasureLengths:
        """Straight lengths and lengths along the surface between pairs of vertices.
        mesh: #V x 3, mm, with triangles.
        pairs: pair_count x 2 vertex numbers.
        straight_mm: pair_count values.
        geodesic_mm: pair_count values; by the heat method, within about one percent; infinite where no surface
        joins the two.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (vertex), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_measure_lengths()
        """
        return MeasureLengths(*_run("mien_measure_lengths", {"mesh": mesh, "pairs": pairs, "session": self}))

    def measure_scan_volume(self, before: Mesh, after: Mesh, carry: Carry | int, direction: ArrayLike | None = None, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> MeasureScanVolume:
        """The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is
        carried onto after, then the swept volume is measured. Triangles without a partner do not count.
        before: #V x 3, mm, with triangles.
        after: another surface with triangles, aligned with before.
        carry: MIEN_CARRY_*.
        direction: 3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.
        options: may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml, progress,
        cancel. Deviations are not read.
        coverage: may be left out; share of before's area that had a partner, 0 to 1.
        out: the measurement.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_SOLUTION (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_scan_volume()
        """
        return MeasureScanVolume(*_run("mien_measure_scan_volume", {"before": before, "after": after, "carry": carry, "direction": direction, "options": options, "session": self}, progress=progress, cancel=cancel))

    def measure_align(self, moving: Mesh, target: Mesh, stable: Zone | None = None) -> MeasureAlign:
        """Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge), robustly: by
        correspondence first, then by closest points, because a fit slides along a scan more than it lifts off.
        Surfaces with other triangles (two scans) are brought together by closest points alone and must lie within
        15 mm of each other there. The deviations feed alignment_rotation_sd_rad, alignment_translation_sd_mm and
        alignment_centre.
        moving: #V x 3, mm, with triangles.
        target: with triangles.
        stable: may be left out: all vertices. Vertices of target.
        info: may be left out
        out: the moved mesh.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_SOLUTION (zone too small or straight), MIEN_E_NO_MEMORY.
        C: mien_measure_align()
        """
        return MeasureAlign(*_run("mien_measure_align", {"moving": moving, "target": target, "stable": stable, "session": self}))

    def measure_asymmetry(self, face: Mesh, template_mesh: Mesh, options: AsymmetryOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Compares the left side of a face with the reflection of its right side: volume and distance, signed
        (positive: the left side lies farther out), whole and per zone, with intervals. Zones of both sides
        ("cheek_left", "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is
        compared with the right half. The result holds volumes, distances, and fields of all vertices (a right
        vertex against the reflected left side).
        face: #V x 3, mm, in the template's topology.
        template_mesh: the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).
        options: may be left out: the whole side, no interval.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane),
        MIEN_E_INVALID_MESH (no triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts,
        zones, landmarks, deviations), MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_asymmetry()
        """
        return _run("mien_measure_asymmetry", {"face": face, "template_mesh": template_mesh, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def spectral_split(self, basis: SpectralBasis, face: Mesh, k: int) -> SpectralSplit:
        """Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high - mean is the
        face.
        face: #V vertices, mm, aligned with the mean shape.
        k: 0 to the basis' modes.
        low: may be left out; the low band's mesh.
        high: may be left out; the high band's mesh.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_MEMORY.
        C: mien_spectral_split()
        """
        return SpectralSplit(*_run("mien_spectral_split", {"basis": basis, "face": face, "k": k, "session": self}))

    def spectral_assemble(self, basis: SpectralBasis, low: Mesh, high: Mesh, k: int) -> Mesh:
        """The low frequencies of one face with the high frequencies of another.
        low: #V vertices, mm.
        high: #V vertices, mm.
        k: 0 to the basis' modes; #V or more gives `low`.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_MEMORY.
        C: mien_spectral_assemble()
        """
        return _run("mien_spectral_assemble", {"basis": basis, "low": low, "high": high, "k": k, "session": self})[0]

    def spectral_edit(self, basis: SpectralBasis, face: Mesh, gains: ArrayLike, limits: ArrayLike | None = None) -> Mesh:
        """Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it.
        face: #V vertices, mm.
        limits: limit_count ascending mode numbers
        gains: limit_count + 1 finite values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH (vertex
        count), MIEN_E_NO_MEMORY.
        C: mien_spectral_edit()
        """
        return _run("mien_spectral_edit", {"basis": basis, "face": face, "gains": gains, "limits": limits, "session": self})[0]

    def spectral_mix(self, basis: SpectralBasis, first: Mesh, second: Mesh, weights: ArrayLike, limits: ArrayLike | None = None) -> Mesh:
        """Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details.
        first: #V vertices, mm; weight 0.
        second: #V vertices, mm; weight 1.
        limits: limit_count ascending mode numbers
        weights: limit_count + 1 finite values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH (vertex
        count), MIEN_E_NO_MEMORY.
        C: mien_spectral_mix()
        """
        return _run("mien_spectral_mix", {"basis": basis, "first": first, "second": second, "weights": weights, "limits": limits, "session": self})[0]

    def spectral_project(self, basis: SpectralBasis, face: Mesh, mode_count: int) -> numpy.ndarray:
        """Spectral coefficients of a face: U' M (face - mean), one row of x, y, z per mode, float64.
        face: #V vertices, mm, aligned with the mean shape.
        mode_count: 0 to the basis' modes: the first of them; more means all.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_MEMORY.
        C: mien_spectral_project()
        """
        return _run("mien_spectral_project", {"basis": basis, "face": face, "mode_count": mode_count, "session": self})[0]

    def spectral_synthesize(self, basis: SpectralBasis, first_mode: int, coefficients: ArrayLike | None = None) -> Mesh:
        """The face that has these spectral coefficients: mean + U c. All other modes are zero.
        coefficients: row_count x 3 row-major float64, finite
        first_mode: the mode of the first row.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (modes, not finite), MIEN_E_NO_MEMORY.
        C: mien_spectral_synthesize()
        """
        return _run("mien_spectral_synthesize", {"basis": basis, "first_mode": first_mode, "coefficients": coefficients, "session": self})[0]

    def metric(self, metric: Metric | int, reference: Mesh, other: Mesh) -> float:
        """A geometric or perceptual distance. L1, L2 and DAME need correspondence, the others do not.
        metric: MIEN_METRIC_...
        reference: mm.
        other: mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
        MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY.
        C: mien_metric()
        """
        return _run("mien_metric", {"metric": metric, "reference": reference, "other": other, "session": self})[0]

    def metric_field(self, metric: Metric | int, reference: Mesh, other: Mesh) -> numpy.ndarray:
        """Where a distance comes from: one value per vertex of the reference. L1: |dx| + |dy| + |dz|; L2: distance of
        the two vertices; Hausdorff: of the vertex from the other surface; DAME: masked change of the dihedral
        angles around the vertex, rad; FMPD: how much rougher (above 0) or smoother (below 0) the other looks there,
        after saturation and masking.
        metric: MIEN_METRIC_...
        reference: mm.
        other: mm; the reference's triangles, but for Hausdorff.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
        MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY.
        C: mien_metric_field()
        """
        return _run("mien_metric_field", {"metric": metric, "reference": reference, "other": other, "session": self})[0]

    def metric_roughness(self, mesh: Mesh) -> numpy.ndarray:
        """Local roughness of one mesh, what FMPD is made of: the Laplacian of the angle defect, rad, zero at borders.
        mesh: with triangles.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
        MIEN_E_NO_MEMORY.
        C: mien_metric_roughness()
        """
        return _run("mien_metric_roughness", {"mesh": mesh, "session": self})[0]

    def transfer_expression(self, source_neutral: Mesh, source_expression: Mesh, target_neutral: Mesh) -> Mesh:
        """Carries an expression from one face to another by deformation transfer.
        source_neutral: #V vertices, mm.
        source_expression: the same person with the expression.
        target_neutral: #V vertices, mm; its triangles hold for all.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no triangles),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_transfer_expression()
        """
        return _run("mien_transfer_expression", {"source_neutral": source_neutral, "source_expression": source_expression, "target_neutral": target_neutral, "session": self})[0]

    def register(self, model: Model, scan: Mesh, options: RegisterOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Registration:
        """Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted solve
        with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit that
        cannot be trusted is not an error: ask mien_registration_get_verdict().
        scan: a surface or a cloud of points, any connectivity, any frame; its unit is detected (options.units),
        any rotation is found.
        options: may be left out: no landmarks, all defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after
        cleaning), MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged),
        MIEN_E_NOT_FOUND (start by landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION,
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK.
        C: mien_register()
        """
        return _run("mien_register", {"model": model, "scan": scan, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def surface_transfer_points(self, surface: Mesh, points: ArrayLike, max_distance_mm: float) -> SurfaceTransferPoints:
        """Carries places (landmarks, points of a contour) from one surface to another in the same frame, e.g. from a
        fitted template to the scan under it or back: for each the nearest place on the other surface.
        surface: where the places go; a mesh or a cloud of points, mm.
        points: #P x 3, F32 or F64, mm.
        max_distance_mm: farther places are lost (triangle 0xFFFFFFFF); 0: 10, below 0: no limit.
        triangles: triangle (cloud: vertex) numbers of `surface`.
        barycentric: rows of 3 values.
        positions: rows of 3 values in mm; a lost place keeps where it was.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_surface_transfer_points()
        """
        return SurfaceTransferPoints(*_run("mien_surface_transfer_points", {"surface": surface, "points": points, "max_distance_mm": max_distance_mm, "session": self}))

    def surface_transfer_zone(self, from_: Mesh, to: Mesh, max_distance_mm: float, vertices: ArrayLike | None = None) -> numpy.ndarray:
        """Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest place on
        `from` lies in the zone (barycentric share of its vertices at least one half), ascending.
        from: with the zone's vertices.
        vertices: vertex_count vertex numbers of `from`
        max_distance_mm: farther vertices stay out; 0: 10, below 0: no limit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (a fitted template
        without triangles), MIEN_E_MISMATCH (a vertex that `from` does not have), MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_surface_transfer_zone()
        """
        return _run("mien_surface_transfer_zone", {"from": from_, "to": to, "max_distance_mm": max_distance_mm, "vertices": vertices, "session": self})[0]

    def surface_transfer_json(self, model: Model, fitted: Mesh, scan: Mesh, what: Transfer | int, max_distance_mm: float) -> str:
        """A model's landmarks or zones, carried from its fitted template to a scan, as JSON text in the form of the
        landmark and zone files: {"points": {name: [x, y, z]}, "distances_mm": {name: d}} or {"zones": {name: [scan
        vertex, ...]}}.
        model: whose landmarks and zones are meant.
        fitted: the model's template after registration.
        scan: in the frame of fitted, mm.
        what: MIEN_TRANSFER_LANDMARKS or MIEN_TRANSFER_ZONES.
        max_distance_mm: farther places are left out; 0: 10, below 0: no limit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (what),
        MIEN_E_MISMATCH (fitted is not of the model), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_surface_transfer_json()
        """
        return _run("mien_surface_transfer_json", {"model": model, "fitted": fitted, "scan": scan, "what": what, "max_distance_mm": max_distance_mm, "session": self})[0]

    def neutralize(self, model: ExpressionModel, fitted: Registration, options: NeutralizeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Neutralization:
        """mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of
        the scan. options.weights, where given, replace the registration's.
        fitted: registered with the template of the model's training faces.
        options: may be left out: defaults.
        Fails with as mien_neutralize_mesh().
        C: mien_neutralize()
        """
        return _run("mien_neutralize", {"model": model, "fitted": fitted, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def neutralize_mesh(self, model: ExpressionModel, face: Mesh, options: NeutralizeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Neutralization:
        """Takes the expression off a face and keeps everything that the model does not explain.
        face: in the model's topology, or in a larger one that begins with it (there the displacement runs out
        smoothly behind the model's rim); mm.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or an
        enumerator that this library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION
        (MIEN_FIT_EXACT with too little of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_neutralize_mesh()
        """
        return _run("mien_neutralize_mesh", {"model": model, "face": face, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def evaluate_neutralization(self, model: ExpressionModel, dataset_path: Text, options: EvaluateOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Evaluation:
        """Neutralizes every face of a dataset whose subject has a neutral face, and compares.
        model: in the dataset's topology.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that this
        library does not know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_evaluate_neutralization()
        """
        return _run("mien_evaluate_neutralization", {"model": model, "dataset_path": dataset_path, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_geodesic(self, mesh: Mesh, sources: ArrayLike, options: GeodesicOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> numpy.ndarray:
        """Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a model's
        template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed.
        mesh: #V x 3, mm, with triangles.
        sources: source_count vertex numbers.
        options: may be left out: heat stays inside, a time of 4 mean edges squared.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_geodesic()
        """
        return _run("mien_measure_geodesic", {"mesh": mesh, "sources": sources, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def statistics_agreement(self, ratings: ArrayLike, rater_count: int, grade_count: int) -> str:
        """How far raters (or one rater's sessions) agree, as JSON: confusion matrices, percent agreement, Cohen's
        kappa plain, linear and quadratic, Fleiss' kappa, all six intraclass correlations, majority grades.
        ratings: subject_count x rater_count, 0 .. grade_count - 1, negative: missing.
        rater_count: 2 to 1000.
        grade_count: 2 to 1000.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (grades, no subject graded by all),
        MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY.
        C: mien_statistics_agreement()
        """
        return _run("mien_statistics_agreement", {"ratings": ratings, "rater_count": rater_count, "grade_count": grade_count, "session": self})[0]

    def statistics_repeatability(self, subjects: ArrayLike, values: ArrayLike | None = None, blanks: ArrayLike | None = None) -> str:
        """Within-subject deviation and repeatability coefficient of repeated captures, and the limit of detection from
        changes measured where nothing changed, as JSON.
        values: value_count values
        subjects: value_count numbers: who was measured.
        blanks: blank_count changes measured without any true one; may be left out when 0.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY.
        C: mien_statistics_repeatability()
        """
        return _run("mien_statistics_repeatability", {"subjects": subjects, "values": values, "blanks": blanks, "session": self})[0]

    def statistics_bland_altman(self, first: ArrayLike, second: ArrayLike) -> str:
        """Bland and Altman's comparison of two methods on the same subjects, as JSON: bias, limits of agreement, their
        intervals, and whether the bias grows with the size.
        first: value_count values.
        second: value_count values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY.
        C: mien_statistics_bland_altman()
        """
        return _run("mien_statistics_bland_altman", {"first": first, "second": second, "session": self})[0]

    def neutralize_series(self, model: ExpressionModel, faces: Sequence[Mesh], options: SeriesOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Series:
        """Neutralizes several scans of one person together: one identity, an expression each.
        faces: face_count faces in one topology: the model's, or a larger one that begins with it (there the
        displacement runs out smoothly behind the model's rim).
        options: may be left out: defaults.
        Fails with as mien_neutralize_mesh().
        C: mien_neutralize_series()
        """
        return _run("mien_neutralize_series", {"model": model, "faces": faces, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def template_check(self, template_mesh: Mesh, mirror: int, landmarks: Landmarks | None = None) -> str:
        """Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings (inside
        out, or mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and, where landmarks of
        the 68-point scheme are given, pose, left and right, closed eyes and mouth. The findings come as JSON text
        by the two-call protocol: {"errors": n, "warnings": n, "findings": [{"kind": "error" or "warning", "code",
        "text", "vertices": [...]}]}. No model should be built from a mesh with errors; mien_model_build() does not
        ask.
        template_mesh: the mesh as it is given to mien_model_build().
        landmarks: may be left out; vertices of the mesh.
        mirror: 1: symmetry about x = 0 is asked for, as by options.mirror_symmetric; 0.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a landmark that is no vertex of the mesh),
        MIEN_E_UNSUPPORTED_OPTION (mirror), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_template_check()
        """
        return _run("mien_template_check", {"template_mesh": template_mesh, "mirror": mirror, "landmarks": landmarks, "session": self})[0]

    def expression_shard_create(self, dataset_path: Text, shard_path: Text, options: ShardOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> None:
        """Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made
        by subject, every part_count-th of the sorted subject numbers.
        options: may be left out: the whole dataset.
        shard_path: written atomically.
        Fails with as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or
        is empty.
        C: mien_expression_shard_create()
        """
        _run("mien_expression_shard_create", {"dataset_path": dataset_path, "shard_path": shard_path, "options": options, "session": self}, progress=progress, cancel=cancel)

    def neutralize_visits(self, model: ExpressionModel, faces: Sequence[Mesh], options: VisitsOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Visits:
        """Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
        correspondence along the skin and differ by what changed. The right road to a volume over time: fitted
        templates slide along the skin, and mien_neutralize() takes a part of the slide for expression.
        faces: face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it
        (there the displacement runs out smoothly behind the model's rim).
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that this
        library does not know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated vertices),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_neutralize_visits()
        """
        return _run("mien_neutralize_visits", {"model": model, "faces": faces, "options": options, "session": self}, progress=progress, cancel=cancel)[0]


class Cancel(_Object):
    """Tells a running call to stop. Thread-safe, sticky, single-use."""
    _release = "mien_cancel_release"

    def __init__(self) -> None:
        """Makes a cancel token: name it in the options of one call, request it from any thread."""
        self._take((_run("mien_cancel_create", {}))[0])

    def request(self) -> None:
        """Asks the call that was given this token to return MIEN_E_CANCELLED soon. Sticky.
        C: mien_cancel_request()
        """
        _run("mien_cancel_request", {"cancel": self})


class Mesh(_Object):
    """A triangle mesh or point cloud, checked: finite coordinates, indices in range. Millimetres. Immutable: share
    freely between threads.
    """
    _release = "mien_mesh_release"
    _retain = "mien_mesh_retain"

    def share(self) -> Mesh:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, arrays: MeshArrays) -> Mesh:
        """Makes a mesh from the host's arrays, which are copied.
        arrays: see the fields for shapes and units.
        Fails with MIEN_E_INVALID_ARGUMENT (null, misaligned, stride, dtype), MIEN_E_INVALID_MESH (no vertex,
        value not finite, index out of range), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_mesh_create()
        """
        return _run("mien_mesh_create", {"session": session, "arrays": arrays})[0]

    @staticmethod
    def load(session: Session, path: Text) -> Mesh:
        """Reads a mesh file: see mien_mesh_format_extension(). What the file holds tells its format, its name only
        where that leaves it open. Polygons become triangle fans; colours, texture coordinates, materials and images
        (of this file and beside it) are kept. Points that are not numbers and part of no triangle are dropped, with
        a warning in the session's log. The file is treated as hostile.
        Fails with MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_BAD_FORMAT,
        MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_mesh_load()
        """
        return _run("mien_mesh_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a mesh file by extension: see mien_mesh_format_writes(). Coordinates are float32 or nine digits where
        that steps by at most 0.001 mm, else double; STL, which cannot, is refused then. Materials and images are
        written beside OBJ and PLY files and into GLB files, each image's bytes as they were read. Atomic: a full
        disk or a crash leaves an old file whole.
        Fails with MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension, a format that is read only),
        MIEN_E_INVALID_MESH (STL far from the origin), MIEN_E_UNSUPPORTED_OPTION (pixels, in a build without
        image coders), MIEN_E_NO_MEMORY.
        C: mien_mesh_save()
        """
        _run("mien_mesh_save", {"session": session, "path": path, "mesh": self})

    def counts(self) -> MeshCounts:
        """Numbers of vertices and triangles.
        vertex_count: may be left out; #V.
        triangle_count: may be left out; #F.
        C: mien_mesh_get_counts()
        """
        return MeshCounts(*_run("mien_mesh_get_counts", {"mesh": self}))

    def positions(self, dtype: DTypeLike = numpy.float64) -> numpy.ndarray:
        """Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_positions()
        """
        return _run("mien_mesh_get_positions", {"mesh": self}, dtype=dtype)[0]

    def triangles(self) -> numpy.ndarray:
        """Copies the triangles, #F x 3 uint32 tightly packed.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_triangles()
        """
        return _run("mien_mesh_get_triangles", {"mesh": self})[0]

    def colors(self) -> numpy.ndarray:
        """Copies the vertex colours, #V x 3 uint8; the count is 0 when the mesh has none.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_colors()
        """
        return _run("mien_mesh_get_colors", {"mesh": self})[0]

    @staticmethod
    def format_count() -> int:
        """The number of mesh formats, counted by file extension.
        C: mien_mesh_format_count()
        """
        return _run("mien_mesh_format_count", {})

    @staticmethod
    def format_extension(format: int) -> str:
        """The extension of a mesh format: lower case, without its dot, e.g. "ply".
        format: 0 to mien_mesh_format_count() - 1; null is returned for others.
        C: mien_mesh_format_extension()
        """
        return _run("mien_mesh_format_extension", {"format": format})

    @staticmethod
    def format_description(format: int) -> str:
        """What a mesh format is called, for people, e.g. "Stanford PLY".
        format: 0 to mien_mesh_format_count() - 1; null is returned for others.
        C: mien_mesh_format_description()
        """
        return _run("mien_mesh_format_description", {"format": format})

    @staticmethod
    def format_writes(format: int) -> int:
        """1 for a format that mien_mesh_save() writes, 0 for one that is only read.
        format: 0 to mien_mesh_format_count() - 1; 0 is returned for others.
        C: mien_mesh_format_writes()
        """
        return _run("mien_mesh_format_writes", {"format": format})

    def texture(self) -> numpy.ndarray:
        """Copies the texture coordinates, #T x 2 float32: (0, 0) is the lower left corner of the image, (1, 1) the
        upper right. The count is 0 when the mesh has none.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_texture()
        """
        return _run("mien_mesh_get_texture", {"mesh": self})[0]

    def texture_triangles(self) -> numpy.ndarray:
        """Copies for each corner of each triangle the number of its texture coordinate, #F x 3 uint32. The count is 0
        when the mesh has none.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_texture_triangles()
        """
        return _run("mien_mesh_get_texture_triangles", {"mesh": self})[0]

    def triangle_materials(self) -> numpy.ndarray:
        """Copies the number of each triangle's material, #F uint32. The count is 0 when the mesh has no material, or a
        single one that all triangles have.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_triangle_materials()
        """
        return _run("mien_mesh_get_triangle_materials", {"mesh": self})[0]

    def material_counts(self) -> MeshMaterialCounts:
        """Numbers of materials and of images.
        material_count: may be left out.
        image_count: may be left out.
        C: mien_mesh_get_material_counts()
        """
        return MeshMaterialCounts(*_run("mien_mesh_get_material_counts", {"mesh": self}))

    def material(self, material: int) -> MeshMaterial:
        """A material: its base colour and the number of its base colour's image.
        material: 0 to the number of materials - 1.
        image: may be left out; -1: none.
        red: may be left out; 0 to 1.
        green: may be left out; 0 to 1.
        blue: may be left out; 0 to 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material).
        C: mien_mesh_get_material()
        """
        return MeshMaterial(*_run("mien_mesh_get_material", {"material": material, "mesh": self}))

    def material_name(self, material: int) -> str:
        """Copies a material's name, UTF-8 with its terminating zero.
        material: 0 to the number of materials - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material).
        C: mien_mesh_get_material_name()
        """
        return _run("mien_mesh_get_material_name", {"material": material, "mesh": self})[0]

    def image_name(self, image: int) -> str:
        """Copies an image's file name without a folder, UTF-8 with its terminating zero.
        image: 0 to the number of images - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image).
        C: mien_mesh_get_image_name()
        """
        return _run("mien_mesh_get_image_name", {"image": image, "mesh": self})[0]

    def image_file(self, image: int) -> numpy.ndarray:
        """Copies the bytes of an image's file as they were read. The count is 0 for pixels of a host's.
        image: 0 to the number of images - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image).
        C: mien_mesh_get_image_file()
        """
        return _run("mien_mesh_get_image_file", {"image": image, "mesh": self})[0]

    def image_size(self, image: int) -> MeshImageSize:
        """The width and height of an image in pixels, from its header.
        image: 0 to the number of images - 1.
        width: may be left out; pixels.
        height: may be left out; pixels.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image), MIEN_E_BAD_FORMAT (damaged),
        MIEN_E_UNSUPPORTED_OPTION (neither JPEG nor PNG, or above 134 million pixels).
        C: mien_mesh_get_image_size()
        """
        return MeshImageSize(*_run("mien_mesh_get_image_size", {"image": image, "mesh": self}))

    def image_pixels(self, session: Session, image: int, row_stride_bytes: int) -> numpy.ndarray:
        """Decodes an image into height rows of width x 3 red green blue bytes, from the top.
        image: 0 to the number of images - 1.
        row_stride_bytes: bytes from row to row of dst, at least 3 * width; 0: tightly packed.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image, stride below a row),
        MIEN_E_BAD_FORMAT (damaged), MIEN_E_UNSUPPORTED_OPTION (another kind, or a build without image
        decoders), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_mesh_get_image_pixels()
        """
        return _run("mien_mesh_get_image_pixels", {"session": session, "image": image, "row_stride_bytes": row_stride_bytes, "mesh": self})[0]

    def save_targets(self, session: Session, targets: Sequence[Mesh], names: Sequence[str], path: Text) -> None:
        """Writes a GLB file of a mesh and named changes of it (glTF's morph targets): an expression model's
        blendshapes in one file. Each target is the whole changed mesh, with the vertices of `mesh`.
        targets: target_count meshes, unless target_count is 0.
        names: target_count UTF-8 names, unless target_count is 0.
        path: ends with .glb.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (another extension), MIEN_E_MISMATCH (vertex
        counts), MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_mesh_save_targets()
        """
        _run("mien_mesh_save_targets", {"session": session, "targets": targets, "names": names, "path": path, "mesh": self})

    @staticmethod
    def load_target(session: Session, path: Text, name: Text) -> Mesh:
        """Reads a glTF file with one of its morph targets at full weight.
        path: .glb or .gltf.
        name: UTF-8 name of the target
        Fails with MIEN_E_NOT_FOUND (no such target; the message names some), otherwise as mien_mesh_load().
        C: mien_mesh_load_target()
        """
        return _run("mien_mesh_load_target", {"session": session, "path": path, "name": name})[0]

    def positions_view(self) -> numpy.ndarray:
        """The positions in place: *data points to #V x 3 float64, tightly packed, mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_positions_view()
        """
        return _run("mien_mesh_positions_view", {"mesh": self})[0]

    def inspect(self, session: Session) -> str:
        """What a mesh is and what is wrong with it, as JSON text: counts, box, extent and the units in which that is a
        face, a head or a body, pieces, borders, windings, doubled and unused parts, and "faults": a list of
        sentences that say what is wrong and what to do.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_inspect()
        """
        return _run("mien_mesh_inspect", {"session": session, "mesh": self})[0]

    def clean(self, session: Session, min_triangles: int) -> Mesh:
        """Merges vertices of equal coordinates, drops degenerate, doubled and unused parts and pieces of fewer than
        min_triangles triangles, and winds all triangles of a piece alike. Order and coordinates of what stays are
        kept.
        min_triangles: 0: all pieces stay.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_clean()
        """
        return _run("mien_mesh_clean", {"session": session, "min_triangles": min_triangles, "mesh": self})[0]

    def transform(self, session: Session, matrix: ArrayLike) -> Mesh:
        """Moves every vertex by a row-major 4 x 4 matrix: scales, turns, shifts. When it mirrors (negative
        determinant), the triangles are wound the other way, so that outside stays outside.
        matrix: 16 values, last row 0 0 0 1, invertible.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_transform()
        """
        return _run("mien_mesh_transform", {"session": session, "matrix": matrix, "mesh": self})[0]

    def turn_over(self, session: Session) -> Mesh:
        """Winds every triangle the other way: inside becomes outside.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_turn_over()
        """
        return _run("mien_mesh_turn_over", {"session": session, "mesh": self})[0]

    def decimate(self, session: Session, vertex_count: int) -> Mesh:
        """Collapses edges of least quadric error until vertex_count vertices are left or no collapse is legal. Every
        vertex that stays is one of the input with its place and colour; texture coordinates are dropped. Vertices
        in which fans of triangles merely touch are split first; triangles that fit into no manifold go.
        vertex_count: at least 4.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_decimate()
        """
        return _run("mien_mesh_decimate", {"session": session, "vertex_count": vertex_count, "mesh": self})[0]

    def check_same_unit(self, second: Mesh) -> None:
        """Fails when one of two meshes of the same face is so many times larger that they cannot be in one unit (7
        times; mm and cm differ by 10). The message names the unit that would explain it.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (not in one unit), MIEN_E_NO_MEMORY.
        C: mien_mesh_check_same_unit()
        """
        _run("mien_mesh_check_same_unit", {"second": second, "first": self})


class Model(_Object):
    """A template with its modes of deformation: u(x) = mean(x) + sum_j basis_j(x) a_j + sum_k mode_k(x) c_k, a and
    c standard normal; basis_j are scalar and serve x, y and z, mode_k come from faces. Built or loaded once.
    Immutable: share freely between threads.
    """
    _release = "mien_model_release"
    _retain = "mien_model_retain"

    def share(self) -> Model:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def build(session: Session, template_mesh: Mesh, options: ModelOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Model:
        """Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean and
        the principal modes of its faces.
        template_mesh: #V x 3, mm, with triangles for the surface kernels.
        options: may be left out: geodesic kernel of 20 mm, 999 modes.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not
        symmetric), MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_model_build()
        """
        return _run("mien_model_build", {"session": session, "template_mesh": template_mesh, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> Model:
        """Loads a model file through a memory map and checks all of it: structure, hash, finite values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY.
        C: mien_model_load()
        """
        return _run("mien_model_load", {"session": session, "path": path})[0]

    @staticmethod
    def load_memory(session: Session, data: bytes) -> Model:
        """Loads a model from the bytes of a model file that the host holds in memory, e.g. as a resource of its
        program. They are copied and checked like a file.
        data: size bytes, any alignment; not read after the call.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_model_load_memory()
        """
        return _run("mien_model_load_memory", {"session": session, "data": data})[0]

    @staticmethod
    def load_trusted(session: Session, path: Text) -> Model:
        """Loads a model file that the host trusts: its structure is checked, its hash and values are not.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
        MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY.
        C: mien_model_load_trusted()
        """
        return _run("mien_model_load_trusted", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a model file (safetensors). Atomic: a full disk or a crash leaves an old file whole.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_model_save()
        """
        _run("mien_model_save", {"session": session, "path": path, "model": self})

    def counts(self) -> ModelCounts:
        """Numbers of vertices and modes.
        vertex_count: may be left out; #V.
        scalar_modes: may be left out; columns of the scalar basis; 3 times as many deformation modes.
        vector_modes: may be left out; modes trained on faces.
        C: mien_model_get_counts()
        """
        return ModelCounts(*_run("mien_model_get_counts", {"model": self}))

    def json(self) -> str:
        """What the model is: counts, kernel and its settings, rank, variance explained, largest pointwise variance
        error, clipped negative mass, names of landmarks and zones. As JSON text by the two-call protocol.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_model_get_json()
        """
        return _run("mien_model_get_json", {"model": self})[0]

    def variance(self) -> numpy.ndarray:
        """Prior variance of each coordinate of each vertex, #V x 3 float64, mm^2, modes of both kinds together.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_get_variance()
        """
        return _run("mien_model_get_variance", {"model": self})[0]

    def sample(self, session: Session, seed: int, index: int, strength: float) -> Mesh:
        """A random face: the template moved by the mean and `strength` times a draw from the prior. Face `index` of
        `seed` is the same whatever else was drawn; strength 0 gives the mean.
        seed: any number.
        index: any number.
        strength: >= 0; 1: the prior itself.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_sample()
        """
        return _run("mien_model_sample", {"session": session, "seed": seed, "index": index, "strength": strength, "model": self})[0]

    def condition(self, session: Session, observations: Sequence[LandmarkObservation]) -> Model:
        """The posterior model: what the template may still do once landmarks were seen. It is a model like any other,
        with a mean of its own, and may be conditioned again.
        observations: observation_count of them.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (name),
        MIEN_E_UNSUPPORTED_OPTION (mirror correlation), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_model_condition()
        """
        return _run("mien_model_condition", {"session": session, "observations": observations, "model": self})[0]

    @staticmethod
    def tune(session: Session, template_mesh: Mesh, dataset: Text, options: TuneOptions, progress: Progress | None = None, cancel: Cancel | None = None) -> Tuning:
        """Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of
        levels that is asked for, and reports what is left.
        template_mesh: #V x 3, mm.
        dataset: UTF-8 path of a dataset in the template's correspondence, its faces may cover only the
        template's first vertices.
        options: sigmas_mm at least.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND
        (expression), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_model_tune()
        """
        return _run("mien_model_tune", {"session": session, "template_mesh": template_mesh, "dataset": dataset, "options": options}, progress=progress, cancel=cancel)[0]

    def mesh(self) -> Mesh:
        """The template.
        C: mien_model_mesh()
        """
        return Mesh._adopt(_run("mien_model_mesh", {"model": self}))

    def landmarks(self) -> Landmarks:
        """The landmarks of a model: names and vertices of its template.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_get_landmarks()
        """
        return _run("mien_model_get_landmarks", {"model": self})[0]

    def zones(self) -> Zones:
        """The zones of a model: names and vertices of its template.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_get_zones()
        """
        return _run("mien_model_get_zones", {"model": self})[0]

    def fit(self, session: Session, target: Mesh, options: ModelFitOptions | None = None) -> numpy.ndarray:
        """The coefficients that bring the template nearest to a face in its correspondence: least squares, weighted
        per vertex, with a ridge.
        target: mm, in the template's frame unless options.align; the vertices of the template, or its first
        ones.
        options: may be left out: no weights, a ridge of 1 mm^2, all modes.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertices, weights),
        MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_model_fit()
        """
        return _run("mien_model_fit", {"session": session, "target": target, "options": options, "model": self})[0]

    def synthesize(self, session: Session, coefficients: ArrayLike | None = None) -> Mesh:
        """The face that has these coefficients: the template moved by the mean and the modes.
        coefficients: coefficient_count finite values
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (coefficient_count),
        MIEN_E_NO_MEMORY.
        C: mien_model_synthesize()
        """
        return _run("mien_model_synthesize", {"session": session, "coefficients": coefficients, "model": self})[0]


class Tuning(_Object):
    """A finished search for a kernel's settings. Immutable."""
    _release = "mien_tuning_release"

    def json(self) -> str:
        """Residuals as JSON text by the two-call protocol: best_sigma_mm, best_scale_mm, best_levels and, per
        combination, its sigma, scale and levels, and mean, deviation and every face's residual norm in mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_tuning_get_json()
        """
        return _run("mien_tuning_get_json", {"tuning": self})[0]


class Landmarks(_Object):
    """A list of named landmarks: places on a scan, or vertices of a template. Immutable: share freely."""
    _release = "mien_landmarks_release"
    _retain = "mien_landmarks_retain"

    def share(self) -> Landmarks:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> Landmarks:
        """Reads a landmark file, told by its content: this project's JSON ({"points": ...} or {"vertices": ...}), 3D
        Slicer's .mrk.json and .fcsv (coordinates come out as LPS), MeshLab's .pp, .pts, menpo's .ljson, tables
        name,x,y,z or name,vertex, and vertex numbers alone. What was not picked (null, not a number, "not defined",
        a repeated placeholder such as 0 0 0) is kept as such. Landmarks without a name are called by their number,
        from "1".
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_landmarks_load()
        """
        return _run("mien_landmarks_load", {"session": session, "path": path})[0]

    @staticmethod
    def create(landmarks: Sequence[ScanLandmark] | None = None) -> Landmarks:
        """Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not picked.
        landmarks: landmark_count of them; null allowed when that is 0. Names must differ.
        Fails with MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_landmarks_create()
        """
        return _run("mien_landmarks_create", {"landmarks": landmarks})[0]

    def match(self, model: Model) -> Landmarks:
        """The landmarks under the names that a model has for them. Case, separators and leading zeros do not count;
        numbers alone are read as iBUG-68 (from 0 or 1) or MediaPipe (468 or 478), where the model has the 68 names
        of that scheme. What the model does not know is left out and listed in the JSON of the result.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (two names mean one landmark, numbers fit two
        schemes), MIEN_E_NOT_FOUND (none is known; the message gives examples of known names), MIEN_E_NO_MEMORY.
        C: mien_landmarks_match()
        """
        return _run("mien_landmarks_match", {"model": model, "landmarks": self})[0]

    def on_mesh(self, mesh: Mesh) -> Landmarks:
        """The landmarks as places: vertex numbers become the vertices' places on a mesh, places stay as they are.
        mesh: has the numbered vertices.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (a number that the mesh does
        not have), MIEN_E_NO_MEMORY.
        C: mien_landmarks_on_mesh()
        """
        return _run("mien_landmarks_on_mesh", {"mesh": mesh, "landmarks": self})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a landmark file by its extension: .json, .mrk.json and .fcsv (both LPS), .pp, .pts, .ljson, .csv.
        Vertex numbers go into .json and .csv. Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_landmarks_save()
        """
        _run("mien_landmarks_save", {"session": session, "path": path, "landmarks": self})

    def counts(self) -> LandmarksCounts:
        """How many landmarks there are, and how many of them are a place or a vertex.
        count: may be left out.
        picked_count: may be left out.
        C: mien_landmarks_get_counts()
        """
        return LandmarksCounts(*_run("mien_landmarks_get_counts", {"landmarks": self}))

    def name(self, index: int) -> str:
        """The name of one landmark.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_landmarks_get_name()
        """
        return _run("mien_landmarks_get_name", {"index": index, "landmarks": self})[0]

    def mark(self, index: int) -> LandmarksMark:
        """What is known of one landmark.
        index: below the count.
        where: may be left out; MIEN_MARK_*.
        position: may be left out; x, y and z in the file's unit, zeros unless it is a place.
        vertex: may be left out; 0 unless it is a vertex.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (misaligned), MIEN_E_NOT_FOUND (index).
        C: mien_landmarks_get_mark()
        """
        return LandmarksMark(*_run("mien_landmarks_get_mark", {"index": index, "landmarks": self}))

    def json(self) -> str:
        """What the list is, as JSON text by the two-call protocol: format, system (LPS or RAS as the file says it),
        unit_to_mm (null: not told), count, picked, not_picked (names), and after mien_landmarks_match() scheme and
        unknown (names).
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_landmarks_get_json()
        """
        return _run("mien_landmarks_get_json", {"landmarks": self})[0]

    def add_profile(self, template_mesh: Mesh) -> Landmarks:
        """The landmarks of a template and, beside them, those of its profile that its shape defines by itself:
        glabella, nasion, columella, sublabiale and pogonion, where they are not among the given ones. Every face in
        the template's topology has them at the same vertices.
        template_mesh: symmetric about its plane x = 0, +y up, +z forward (mien_model_mesh()).
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (a landmark that the search
        starts from), MIEN_E_MISMATCH (vertex), MIEN_E_INVALID_MESH (not symmetric, no midline),
        MIEN_E_NO_MEMORY.
        C: mien_landmarks_add_profile()
        """
        return _run("mien_landmarks_add_profile", {"template_mesh": template_mesh, "landmarks": self})[0]


class Zones(_Object):
    """A list of named sets of vertices. Immutable: share freely."""
    _release = "mien_zones_release"
    _retain = "mien_zones_retain"

    def share(self) -> Zones:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> Zones:
        """Reads a zone file {"zones": {name: [vertex, ...]}}; further lists of vertices beside "zones", such as
        "lips", are zones too.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_zones_load()
        """
        return _run("mien_zones_load", {"session": session, "path": path})[0]

    @staticmethod
    def create(zones: Sequence[Zone] | None = None) -> Zones:
        """Makes a list of zones from the host's.
        zones: zone_count of them, each of at most 16777216 vertices; null allowed when that is 0. Names must
        differ.
        Fails with MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_zones_create()
        """
        return _run("mien_zones_create", {"zones": zones})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a zone file. Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_zones_save()
        """
        _run("mien_zones_save", {"session": session, "path": path, "zones": self})

    def count(self) -> int:
        """How many zones there are.
        C: mien_zones_get_count()
        """
        return _run("mien_zones_get_count", {"zones": self})[0]

    def name(self, index: int) -> str:
        """The name of one zone.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_zones_get_name()
        """
        return _run("mien_zones_get_name", {"index": index, "zones": self})[0]

    def vertices(self, index: int) -> numpy.ndarray:
        """The vertices of one zone. With dst null and capacity 0: their number only.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_zones_get_vertices()
        """
        return _run("mien_zones_get_vertices", {"index": index, "zones": self})[0]


class Anthropometry(_Object):
    """The measurements of one face. Immutable: share freely."""
    _release = "mien_anthropometry_release"

    def counts(self) -> AnthropometryCounts:
        """How many measurements there are, and how many of them have a value.
        count: may be left out.
        known_count: may be left out.
        C: mien_anthropometry_get_counts()
        """
        return AnthropometryCounts(*_run("mien_anthropometry_get_counts", {"anthropometry": self}))

    def name(self, index: int) -> str:
        """The name of one measurement, such as "n-gn".
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_anthropometry_get_name()
        """
        return _run("mien_anthropometry_get_name", {"index": index, "anthropometry": self})[0]

    def value(self, index: int) -> AnthropometricValue:
        """One measurement.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_anthropometry_get_value()
        """
        return _run("mien_anthropometry_get_value", {"index": index, "anthropometry": self})[0]

    def reason(self, index: int) -> str:
        """Why one measurement has no value, in words; empty where it has one.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_anthropometry_get_reason()
        """
        return _run("mien_anthropometry_get_reason", {"index": index, "anthropometry": self})[0]

    def json(self) -> str:
        """All measurements as JSON text: name, title, kind, unit, landmarks, source, value, sd, reason, z; and which
        of the face's landmarks stand for those of the field.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_anthropometry_get_json()
        """
        return _run("mien_anthropometry_get_json", {"anthropometry": self})[0]


class Norms(_Object):
    """Mean and deviation of each measurement over the people of a dataset. Immutable: share freely."""
    _release = "mien_norms_release"

    @staticmethod
    def create(session: Session, dataset_path: Text, landmarks: Landmarks, options: AnthropometryOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Norms:
        """Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset
        and for faces in its topology: the same landmark lies elsewhere on another template.
        dataset_path: faces of ten people or more.
        landmarks: vertices of the dataset's faces.
        options: may be left out; progress and cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are no
        vertices), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its
        landmarks), MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_norms_create()
        """
        return _run("mien_norms_create", {"session": session, "dataset_path": dataset_path, "landmarks": landmarks, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> Norms:
        """Reads norms that mien_norms_save() wrote, or that a host wrote from the literature: {"norms": {"n-gn":
        {"mean": 121.3, "sd": 6.8, "people": 109}}}.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a norm of fewer than ten people, or given
        twice), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_norms_load()
        """
        return _run("mien_norms_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes norms as JSON. Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_norms_save()
        """
        _run("mien_norms_save", {"session": session, "path": path, "norms": self})

    def json(self) -> str:
        """The norms as JSON text, as mien_norms_save() writes it.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_norms_get_json()
        """
        return _run("mien_norms_get_json", {"norms": self})[0]


class Measurement(_Object):
    """What was measured: numbers per zone and values per vertex. Immutable: share freely."""
    _release = "mien_measurement_release"

    def zones(self) -> MeasurementZones:
        """How many zones were measured.
        zone_count: may be left out; the number of zones given.
        zones_disjoint: may be left out; 1 when no vertex lies in two zones: zones and rest then add up.
        C: mien_measurement_get_zones()
        """
        return MeasurementZones(*_run("mien_measurement_get_zones", {"measurement": self}))

    def volume(self, zone: int) -> ZoneVolume:
        """The volume of a zone.
        zone: 0 .. zone_count - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no volume in
        it).
        C: mien_measurement_get_volume()
        """
        return _run("mien_measurement_get_volume", {"zone": zone, "measurement": self})[0]

    def distance(self, zone: int) -> ZoneDistance:
        """The distances of a zone.
        zone: 0 .. zone_count - 1 or MIEN_ZONE_WHOLE.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no distance
        in it).
        C: mien_measurement_get_distance()
        """
        return _run("mien_measurement_get_distance", {"zone": zone, "measurement": self})[0]

    def field(self, field: Field | int) -> numpy.ndarray:
        """Copies a field with one float64 per vertex of the before face; NaN where there was no partner.
        field: MIEN_FIELD_*.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (this measurement has no such field).
        C: mien_measurement_get_field()
        """
        return _run("mien_measurement_get_field", {"field": field, "measurement": self})[0]

    def json(self) -> str:
        """The whole measurement as JSON text.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_measurement_get_json()
        """
        return _run("mien_measurement_get_json", {"measurement": self})[0]

    def mirror_plane(self) -> MirrorPlane:
        """The mirror plane of a comparison of left and right.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (another measurement).
        C: mien_measurement_get_mirror_plane()
        """
        return _run("mien_measurement_get_mirror_plane", {"measurement": self})[0]


class SpectralBasis(_Object):
    """The first Laplace-Beltrami eigenvectors of a mean shape. Immutable: share freely."""
    _release = "mien_spectral_basis_release"
    _retain = "mien_spectral_basis_retain"

    def share(self) -> SpectralBasis:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def build(session: Session, mean: Mesh, options: SpectralBasisOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> SpectralBasis:
        """Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that
        none is missing.
        mean: the mean shape, mm. Any triangle mesh.
        options: may be left out: 500 modes, mixed Voronoi mass, intrinsic Delaunay.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count), MIEN_E_UNSUPPORTED_OPTION,
        MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_spectral_basis_build()
        """
        return _run("mien_spectral_basis_build", {"session": session, "mean": mean, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> SpectralBasis:
        """Opens a basis file; the vectors stay in the mapped file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_load()
        """
        return _run("mien_spectral_basis_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a basis file (safetensors). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_save()
        """
        _run("mien_spectral_basis_save", {"session": session, "path": path, "basis": self})

    def counts(self) -> SpectralBasisCounts:
        """Numbers of vertices and modes.
        vertex_count: may be left out; #V.
        mode_count: may be left out; k.
        C: mien_spectral_basis_get_counts()
        """
        return SpectralBasisCounts(*_run("mien_spectral_basis_get_counts", {"basis": self}))

    def eigenvalues(self) -> numpy.ndarray:
        """Copies the eigenvalues, ascending, 1/mm^2. With dst null and capacity 0: writes the count only.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_spectral_basis_get_eigenvalues()
        """
        return _run("mien_spectral_basis_get_eigenvalues", {"basis": self})[0]

    def vector(self, mode: int) -> numpy.ndarray:
        """Copies one eigenvector, U's column: a value per vertex, orthonormal in the mass matrix, so 1/mm (plain
        without mass).
        mode: 0 to the basis' modes - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode), MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_get_vector()
        """
        return _run("mien_spectral_basis_get_vector", {"mode": mode, "basis": self})[0]

    def mass(self) -> numpy.ndarray:
        """Copies the diagonal of the mass matrix: mm^2 per vertex, ones without mass.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_spectral_basis_get_mass()
        """
        return _run("mien_spectral_basis_get_mass", {"basis": self})[0]

    def mean(self) -> Mesh:
        """The mean shape that the basis belongs to.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_get_mean()
        """
        return _run("mien_spectral_basis_get_mean", {"basis": self})[0]


class BlendshapeModel(_Object):
    """Predicts one expression of a person from the neutral face. Immutable: share freely."""
    _release = "mien_blendshape_model_release"
    _retain = "mien_blendshape_model_retain"

    def share(self) -> BlendshapeModel:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def train(session: Session, dataset_path: Text, expression: Text, options: BlendshapeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> BlendshapeModel:
        """Learns to predict one expression from the neutral face, on every subject of a dataset that has both.
        dataset_path: a dataset file whose names include "neutral".
        expression: a name of the dataset.
        options: may be left out.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge),
        MIEN_E_NOT_FOUND (expression), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_blendshape_model_train()
        """
        return _run("mien_blendshape_model_train", {"session": session, "dataset_path": dataset_path, "expression": expression, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> BlendshapeModel:
        """Opens a blendshape model file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_load()
        """
        return _run("mien_blendshape_model_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a blendshape model file (safetensors). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_save()
        """
        _run("mien_blendshape_model_save", {"session": session, "path": path, "model": self})

    def mean(self) -> Mesh:
        """The mean of the neutral training faces, centred: the mesh that a basis for this model is built on.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_get_mean()
        """
        return _run("mien_blendshape_model_get_mean", {"model": self})[0]

    def predict(self, session: Session, k: int, neutral: Mesh, basis: SpectralBasis | None = None) -> Mesh:
        """A person's expression from the neutral face, in its frame.
        basis: may be left out: then k = 0 gives the deformations' prediction, any other k the coordinates'.
        k: low frequencies from the coordinates' prediction, high ones from the deformations'; 0 to the basis'
        modes, #V or more: coordinates alone.
        neutral: #V vertices, mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_predict()
        """
        return _run("mien_blendshape_model_predict", {"session": session, "k": k, "neutral": neutral, "basis": basis, "model": self})[0]

    def search(self, session: Session, basis: SpectralBasis, dataset_path: Text, expression: Text, candidates: ArrayLike, options: BlendshapeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> list[BandChoice]:
        """Tries values of k on a dataset's subjects that the model was not trained on.
        dataset_path: subjects with a neutral face and the expression.
        candidates: candidate_count values of k; above the basis' modes: coordinates alone.
        options: may be left out; its ridge is not read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression),
        MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_blendshape_model_search()
        """
        return _run("mien_blendshape_model_search", {"session": session, "basis": basis, "dataset_path": dataset_path, "expression": expression, "candidates": candidates, "options": options, "model": self}, progress=progress, cancel=cancel)[0]


class DatasetWriter(_Object):
    """Collects faces with a subject and an expression each, then saves them as one safetensors file: vertices f32
    [s, n, 3], subject i32 [s], expression i32 [s], triangles u32 [m, 3]. Externally synchronized.
    """
    _release = "mien_dataset_writer_release"

    @staticmethod
    def create(session: Session, topology: Mesh, expression_names: Sequence[str]) -> DatasetWriter:
        """Starts a dataset in the topology of a mesh.
        topology: its triangles and vertex count hold for all faces.
        expression_names: expression_count UTF-8 names. One should be "neutral".
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_dataset_writer_create()
        """
        return _run("mien_dataset_writer_create", {"session": session, "topology": topology, "expression_names": expression_names})[0]

    def add(self, positions: ArrayLike, subject: int, expression: int) -> None:
        """Adds one face; its positions are copied.
        positions: #V x 3, F32 or F64, mm.
        subject: any number that names the person.
        expression: index into the expression names.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
        MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_MEMORY.
        C: mien_dataset_writer_add()
        """
        _run("mien_dataset_writer_add", {"positions": positions, "subject": subject, "expression": expression, "writer": self})

    def save(self, session: Session, path: Text) -> None:
        """Writes all faces added so far. Atomic; more may be added and saved again.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no face), MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_dataset_writer_save()
        """
        _run("mien_dataset_writer_save", {"session": session, "path": path, "writer": self})


class Registration(_Object):
    """A fitted template: places, residuals, confidence, verdict. Immutable: share freely."""
    _release = "mien_registration_release"
    _retain = "mien_registration_retain"

    def share(self) -> Registration:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    def mesh(self) -> Mesh:
        """The fitted template: template topology, the scan's frame, millimetres.
        C: mien_registration_mesh()
        """
        return Mesh._adopt(_run("mien_registration_mesh", {"registration": self}))

    def verdict(self) -> FitVerdict:
        """The verdict.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_registration_get_verdict()
        """
        return _run("mien_registration_get_verdict", {"registration": self})[0]

    def expected_error(self, zone: Text | None = None) -> ExpectedError:
        """The error that is expected of a zone of the model, or of the whole face.
        zone: a zone of the model by its name; null: the whole face.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, or the
        registration was made of arrays or read from a file that states none).
        C: mien_registration_get_expected_error()
        """
        return _run("mien_registration_get_expected_error", {"zone": zone, "registration": self})[0]

    def field(self, field: RegistrationKind | int) -> numpy.ndarray:
        """Copies a field with one float64 per template vertex.
        field: one of MIEN_REGISTRATION_RESIDUAL_MM, MIEN_REGISTRATION_WEIGHT,
        MIEN_REGISTRATION_STANDARD_DEVIATION_MM, MIEN_REGISTRATION_RADIUS95_MM,
        MIEN_REGISTRATION_NORMAL_DEVIATION_MM.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such field, or it is not known of this
        registration).
        C: mien_registration_get_field()
        """
        return _run("mien_registration_get_field", {"field": field, "registration": self})[0]

    def correspondence(self) -> RegistrationCorrespondence:
        """The dense correspondence: for every template vertex the scan's triangle (or point, for a cloud) nearest to
        its fitted place, and barycentric coordinates in it. Numbers are those of the scan as it was given.
        triangles: numbers.
        barycentric: rows of 3 values.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_registration_get_correspondence()
        """
        return RegistrationCorrespondence(*_run("mien_registration_get_correspondence", {"registration": self}))

    def motion(self) -> numpy.ndarray:
        """The motion from the template's frame to the scan's as a row-major 4 x 4 matrix.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_registration_get_motion()
        """
        return _run("mien_registration_get_motion", {"registration": self})[0]

    def json(self) -> str:
        """Verdict with reasons, energies, motion, color_agreement (correlation of each feature's colour with the
        template, -1 to 1; empty when colours had no say), measures and expected_error of every zone and summaries
        as JSON text.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_registration_get_json()
        """
        return _run("mien_registration_get_json", {"registration": self})[0]

    def save(self, session: Session, path: Text) -> None:
        """Keeps a registration as a file: the fitted template, its residuals, weights and deviations, the verdict and
        the model's zones, so that visits can be registered today and studied in a year. The scan is not in it.
        path: UTF-8; replaced whole.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_registration_save()
        """
        _run("mien_registration_save", {"session": session, "path": path, "registration": self})

    @staticmethod
    def load(session: Session, path: Text) -> Registration:
        """Reads a registration that mien_registration_save() kept. It gives the same bits as the registration itself.
        path: UTF-8.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY.
        C: mien_registration_load()
        """
        return _run("mien_registration_load", {"session": session, "path": path})[0]

    @staticmethod
    def create(session: Session, mesh: Mesh, quality: Quality | int, weight: ArrayLike | None = None, residual: ArrayLike | None = None, standard_deviation: ArrayLike | None = None) -> Registration:
        """A registration of a face that was fitted elsewhere, or whose arrays a host kept itself. What is not given
        here is zero or empty in it.
        mesh: the fitted template, mm.
        weight: may be left out: not known; #V values, 0 to 1: how far the scan was seen there.
        residual: may be left out: zero; #V values, mm: signed distance to the scan.
        standard_deviation: may be left out: not known; #V values, mm, >= 0: of the place, per axis.
        quality: MIEN_QUALITY_*: the verdict on the fit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (lengths), MIEN_E_NO_MEMORY.
        C: mien_registration_create()
        """
        return _run("mien_registration_create", {"session": session, "mesh": mesh, "quality": quality, "weight": weight, "residual": residual, "standard_deviation": standard_deviation})[0]

    def coefficients(self, session: Session, model: Model, ridge_mm2: float) -> numpy.ndarray:
        """The coefficients of a registered face: its fitted template, brought back into the model's frame by the
        registration's own motion and fitted as by mien_model_fit(). What the fit took from the model comes back;
        what it moved beyond the model's span, to close the last gap to the scan, is left out.
        ridge_mm2: mm^2, >= 0; 0: the nearest face of the model's span.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (of another model),
        MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_registration_get_coefficients()
        """
        return _run("mien_registration_get_coefficients", {"session": session, "model": model, "ridge_mm2": ridge_mm2, "registration": self})[0]


class ExpressionModel(_Object):
    """What was learned of faces and expressions: an identity subspace, an expression subspace, a prior of both.
    Immutable: share freely between threads.
    """
    _release = "mien_expression_model_release"
    _retain = "mien_expression_model_retain"

    def share(self) -> ExpressionModel:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> ExpressionModel:
        """Loads a model file. The file is treated as hostile; the modes stay in the mapped file.
        Fails with MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT,
        MIEN_E_NO_MEMORY.
        C: mien_expression_model_load()
        """
        return _run("mien_expression_model_load", {"session": session, "path": path})[0]

    @staticmethod
    def load_memory(session: Session, data: bytes) -> ExpressionModel:
        """Loads a model from the bytes of a model file that the host holds in memory. They are copied and checked like
        a file.
        data: size bytes, any alignment; not read after the call.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
        MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_expression_model_load_memory()
        """
        return _run("mien_expression_model_load_memory", {"session": session, "data": data})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a model file (safetensors, kind "mien-expression-model"). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_expression_model_save()
        """
        _run("mien_expression_model_save", {"session": session, "path": path, "model": self})

    def counts(self) -> ExpressionModelCounts:
        """Numbers of vertices and modes.
        vertex_count: may be left out; #V.
        identity_modes: may be left out.
        expression_modes: may be left out.
        C: mien_expression_model_get_counts()
        """
        return ExpressionModelCounts(*_run("mien_expression_model_get_counts", {"model": self}))

    def json(self) -> str:
        """What the model is, and after training how the training went, as a JSON object: sizes, expressions, noise
        levels, iterations, orthogonality score per number of components, explained shares.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_expression_model_get_json()
        """
        return _run("mien_expression_model_get_json", {"model": self})[0]

    def synthesize(self, session: Session, identity: ArrayLike | None = None, expression: ArrayLike | None = None) -> Mesh:
        """A face made from coordinates: mean + identity modes x identity + expression modes x expression.
        identity: count identity_modes, F32 or F64, mm; count 0 (or null): the mean identity.
        expression: count expression_modes, F32 or F64, mm; count 0 (or null): neutral.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts), MIEN_E_NO_MEMORY.
        C: mien_expression_model_synthesize()
        """
        return _run("mien_expression_model_synthesize", {"session": session, "identity": identity, "expression": expression, "model": self})[0]

    def sample(self, session: Session, seed: int, expression: Text | None = None) -> Mesh:
        """A random face of the model: identity coordinates from their Gaussian, expression coordinates from the prior
        of one expression.
        seed: any number; the same seed gives the same face on every machine.
        expression: name of an expression of the model, "neutral", "any" (all expressions together), or null:
        neutral without any expression.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY.
        C: mien_expression_model_sample()
        """
        return _run("mien_expression_model_sample", {"session": session, "seed": seed, "expression": expression, "model": self})[0]

    def transfer(self, session: Session, source: Neutralization, target: Neutralization) -> Mesh:
        """Puts the expression of one neutralized face onto another one's neutral face.
        source: whose expression is taken.
        target: whose neutral face receives it.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (another model), MIEN_E_NO_MEMORY.
        C: mien_expression_model_transfer()
        """
        return _run("mien_expression_model_transfer", {"session": session, "source": source, "target": target, "model": self})[0]

    @staticmethod
    def train(session: Session, dataset_path: Text, options: TrainOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ExpressionModel:
        """Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The faces
        are read through a memory map in blocks, so the file may be larger than memory. Subjects without a neutral
        face are left out; missing expressions and repeated captures are fine.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn),
        MIEN_E_UNSUPPORTED_OPTION (a method that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED.
        C: mien_expression_model_train()
        """
        return _run("mien_expression_model_train", {"session": session, "dataset_path": dataset_path, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def merge(session: Session, shard_paths: Sequence[str], options: TrainOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ExpressionModel:
        """Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut
        its rank.
        shard_paths: shard_count UTF-8 paths.
        options: may be left out: defaults. stable_vertices must be empty: the shards' own count.
        Fails with as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different
        topologies, expression names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards).
        C: mien_expression_model_merge()
        """
        return _run("mien_expression_model_merge", {"session": session, "shard_paths": shard_paths, "options": options}, progress=progress, cancel=cancel)[0]


class Neutralization(_Object):
    """A neutralized face. Immutable: share freely between threads."""
    _release = "mien_neutralization_release"

    def mesh(self) -> Mesh:
        """The neutral face with the triangles, colours and texture of the input, borrowed.
        C: mien_neutralization_mesh()
        """
        return Mesh._adopt(_run("mien_neutralization_mesh", {"neutralization": self}))

    def counts(self) -> NeutralizationCounts:
        """Numbers of vertices of the neutral face and of coordinates of mien_neutralization_get_coordinates().
        vertex_count: may be left out; #V.
        identity_modes: may be left out; those of the model.
        expression_modes: may be left out; those of the model.
        C: mien_neutralization_get_counts()
        """
        return NeutralizationCounts(*_run("mien_neutralization_get_counts", {"neutralization": self}))

    def coordinates(self) -> NeutralizationCoordinates:
        """Coordinates of the face in the model, mm along the unit modes. mien_neutralization_get_counts() says how
        many.
        identity: identity_modes values.
        expression: expression_modes values.
        C: mien_neutralization_get_coordinates()
        """
        return NeutralizationCoordinates(*_run("mien_neutralization_get_coordinates", {"neutralization": self}))

    def uncertainty(self) -> numpy.ndarray:
        """Deviation per vertex of the neutral face that comes from not knowing the expression, mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without a
        prior).
        C: mien_neutralization_get_uncertainty()
        """
        return _run("mien_neutralization_get_uncertainty", {"neutralization": self})[0]

    def reading(self, reading: Reading | int) -> ZoneReading:
        """How a treated zone is read, both ways: treatments of lips, brows and the corners of the mouth can look like
        expressions.
        reading: MIEN_READING_*.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (reading),
        MIEN_E_NOT_FOUND (nothing was treated).
        C: mien_neutralization_get_reading()
        """
        return _run("mien_neutralization_get_reading", {"reading": reading, "neutralization": self})[0]

    def json(self) -> str:
        """The report as a JSON object: expression found, its probability and the others', displacement, residual,
        coordinates; with options.treated both readings of the zone.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_neutralization_get_json()
        """
        return _run("mien_neutralization_get_json", {"neutralization": self})[0]

    def apply_to_scan(self, session: Session, scan: Mesh, max_distance_mm: float) -> Mesh:
        """Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and texture of the
        scan stay. Parts far from the template move rigidly with their neighbourhood.
        scan: in the frame of the face.
        max_distance_mm: how far from the fitted face a vertex takes its displacement; 0: 6 mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION,
        MIEN_E_NO_MEMORY.
        C: mien_neutralization_apply_to_scan()
        """
        return _run("mien_neutralization_apply_to_scan", {"session": session, "scan": scan, "max_distance_mm": max_distance_mm, "neutralization": self})[0]


class Evaluation(_Object):
    """Errors of neutralization over a dataset. Immutable: share freely between threads."""
    _release = "mien_evaluation_release"

    def json(self) -> str:
        """The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each with faces,
        baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d, superiority; with
        options.volume_zones "volumes", the same per zone (mean_ml, sd_ml, median_ml).
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_evaluation_get_json()
        """
        return _run("mien_evaluation_get_json", {"evaluation": self})[0]


class Hierarchy(_Object):
    """Levels of a template with maps between them. Immutable: share freely."""
    _release = "mien_hierarchy_release"
    _retain = "mien_hierarchy_retain"

    def share(self) -> Hierarchy:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def build_quadric(session: Session, mesh: Mesh, level_count: int, factor: float) -> Hierarchy:
        """Levels by quadric edge collapse, with barycentric maps up and selections down.
        mesh: an orientable manifold.
        level_count: levels below the mesh itself, 1 to 32; fewer when no collapse is legal.
        factor: vertices are divided by this from level to level; above 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_hierarchy_build_quadric()
        """
        return _run("mien_hierarchy_build_quadric", {"session": session, "mesh": mesh, "level_count": level_count, "factor": factor})[0]

    @staticmethod
    def build_connectivity(session: Session, mesh: Mesh, level_count: int, stride: int, radius: int) -> Hierarchy:
        """Levels sampled from the connectivity alone.
        level_count: levels below the mesh itself, 1 to 32.
        stride: least distance of kept vertices in edges, at least 1.
        radius: edges over which the maps reach, stride - 1 to 64.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_hierarchy_build_connectivity()
        """
        return _run("mien_hierarchy_build_connectivity", {"session": session, "mesh": mesh, "level_count": level_count, "stride": stride, "radius": radius})[0]

    @staticmethod
    def load(session: Session, path: Text) -> Hierarchy:
        """Opens a hierarchy file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_hierarchy_load()
        """
        return _run("mien_hierarchy_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a hierarchy file (safetensors; maps as compressed rows). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_hierarchy_save()
        """
        _run("mien_hierarchy_save", {"session": session, "path": path, "hierarchy": self})

    def level_count(self) -> int:
        """Number of levels, the finest included.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_hierarchy_get_level_count()
        """
        return _run("mien_hierarchy_get_level_count", {"hierarchy": self})[0]

    def level(self, level: int) -> Mesh:
        """The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no triangles.
        level: 0 to level_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY.
        C: mien_hierarchy_get_level()
        """
        return _run("mien_hierarchy_get_level", {"level": level, "hierarchy": self})[0]

    def apply(self, level: int, direction: MapKind | int, values: ArrayLike, channel_count: int) -> numpy.ndarray:
        """Applies a map to values on vertices: dst = map values.
        level: 1 to level_count - 1: the coarser level of the map.
        direction: MIEN_MAP_DOWN or MIEN_MAP_UP.
        values: row_count x channel_count row-major float64.
        channel_count: values a vertex, 1 to 4096.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction),
        MIEN_E_MISMATCH (row_count), MIEN_E_NO_MEMORY.
        C: mien_hierarchy_apply()
        """
        return _run("mien_hierarchy_apply", {"level": level, "direction": direction, "values": values, "channel_count": channel_count, "hierarchy": self})[0]

    def map(self, level: int, direction: MapKind | int) -> HierarchyMap:
        """A map as a sparse matrix: its entries by rows, ascending, each row adding up to one. With all arrays null
        and capacity 0: the counts only.
        level: 1 to level_count - 1: the coarser level of the map.
        direction: MIEN_MAP_DOWN or MIEN_MAP_UP.
        rows: numbers of vertices that the map ends at.
        columns: numbers of vertices that it starts from.
        values: float64.
        row_count: may be left out; vertices that the map ends at.
        column_count: may be left out; vertices that it starts from.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction).
        C: mien_hierarchy_get_map()
        """
        return HierarchyMap(*_run("mien_hierarchy_get_map", {"level": level, "direction": direction, "hierarchy": self}))


class Network(_Object):
    """A trained network with everything that belongs to it: layers, weights, neighbour lists and statistics of one
    template. Immutable: share freely.
    """
    _release = "mien_network_release"
    _retain = "mien_network_retain"

    def share(self) -> Network:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> Network:
        """Loads a network file through a memory map and checks all of it: structure, hash, finite weights, every index
        of every list. A file is treated as hostile.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_network_load()
        """
        return _run("mien_network_load", {"session": session, "path": path})[0]

    @staticmethod
    def load_memory(session: Session, data: bytes) -> Network:
        """Loads a network from the bytes of a network file that the host holds in memory, e.g. as a resource of its
        program. The bytes are copied.
        data: size bytes.
        Fails with as mien_network_load(), without MIEN_E_IO.
        C: mien_network_load_memory()
        """
        return _run("mien_network_load_memory", {"session": session, "data": data})[0]

    def counts(self) -> NetworkCounts:
        """Numbers of vertices of the faces and of numbers in a code.
        vertex_count: may be left out; #V.
        code_count: may be left out; numbers of a code.
        C: mien_network_get_counts()
        """
        return NetworkCounts(*_run("mien_network_get_counts", {"network": self}))

    def json(self) -> str:
        """What the network is, as JSON: name, sizes, features, layers with their multiply-adds, and what its training
        wrote down.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_network_get_json()
        """
        return _run("mien_network_get_json", {"network": self})[0]

    def mean(self) -> Mesh:
        """The mean face of the network's training, in whose frame codes are decoded.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_network_get_mean()
        """
        return _run("mien_network_get_mean", {"network": self})[0]

    def encode(self, session: Session, face: Mesh, options: NetworkOptions | None = None) -> NetworkEncode:
        """The code of a face. With dst null and capacity 0: writes the count only.
        face: #V vertices in the network's topology, mm, anywhere.
        options: may be left out: defaults.
        motion: may be left out; 12 float64: the rigid motion onto the mean, x -> R x + t, as R row by row, then
        t in mm. mien_network_decode() takes it back.
        dst: values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (no encoder),
        MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION (no rigid motion; a
        result that is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_encode()
        """
        return NetworkEncode(*_run("mien_network_encode", {"session": session, "face": face, "options": options, "network": self}))

    def decode(self, session: Session, code: ArrayLike, motion: ArrayLike | None = None, options: NetworkOptions | None = None) -> Mesh:
        """The face of a code.
        code: code_count finite values.
        motion: may be left out: the mean's frame; 12 float64 of mien_network_encode(), which is undone.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
        MIEN_E_UNSUPPORTED_OPTION (no decoder), MIEN_E_MISMATCH (code_count), MIEN_E_NO_SOLUTION (a result that
        is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_decode()
        """
        return _run("mien_network_decode", {"session": session, "code": code, "motion": motion, "options": options, "network": self})[0]

    def apply(self, session: Session, face: Mesh, options: NetworkOptions | None = None) -> Mesh:
        """The decoded face of a face's code, in the frame of that face: an autoencoder's reconstruction, or what the
        network was trained to make of a face (a neutral one into an expression). Networks on deformations, which
        know no place, have their result put onto the face rigidly.
        face: #V vertices in the network's topology, mm, anywhere.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is
        missing), MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_apply()
        """
        return _run("mien_network_apply", {"session": session, "face": face, "options": options, "network": self})[0]

    def evaluate(self, session: Session, dataset_path: Text, options: NetworkEvaluationOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> str:
        """How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over
        the faces and by face. Judge a network on people that it was not trained on.
        dataset_path: a dataset file in the network's topology.
        options: may be left out: all faces.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing,
        a switch), MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such face), MIEN_E_IO,
        MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_evaluate()
        """
        return _run("mien_network_evaluate", {"session": session, "dataset_path": dataset_path, "options": options, "network": self}, progress=progress, cancel=cancel)[0]


class Representation(_Object):
    """A trained representation of faces: numbers for learning, with their exact inverse. Immutable: share freely."""
    _release = "mien_representation_release"
    _retain = "mien_representation_retain"

    def share(self) -> Representation:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def train(session: Session, dataset_path: Text, kind: Features | int, neutral_only: int) -> Representation:
        """mien_representation_train_with_options() without progress and cancel.
        dataset_path: a dataset file.
        kind: MIEN_FEATURES_...
        neutral_only: 1: only the faces marked neutral; 0: all.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
        neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
        MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_representation_train()
        """
        return _run("mien_representation_train", {"session": session, "dataset_path": dataset_path, "kind": kind, "neutral_only": neutral_only})[0]

    @staticmethod
    def train_with_options(session: Session, dataset_path: Text, kind: Features | int, options: RepresentationOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Representation:
        """Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.
        dataset_path: a dataset file.
        kind: MIEN_FEATURES_...
        options: may be left out: all faces.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
        neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
        MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_representation_train_with_options()
        """
        return _run("mien_representation_train_with_options", {"session": session, "dataset_path": dataset_path, "kind": kind, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> Representation:
        """Opens a representation file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_representation_load()
        """
        return _run("mien_representation_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a representation file (safetensors). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_representation_save()
        """
        _run("mien_representation_save", {"session": session, "path": path, "representation": self})

    def counts(self) -> RepresentationCounts:
        """Numbers of vertices and of features a vertex.
        vertex_count: may be left out; #V.
        channel_count: may be left out; 3, or 9 for deformations.
        C: mien_representation_get_counts()
        """
        return RepresentationCounts(*_run("mien_representation_get_counts", {"representation": self}))

    def encode(self, session: Session, face: Mesh) -> RepresentationEncode:
        """The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count only.
        face: #V vertices, mm, anywhere.
        motion: may be left out; 12 float64: the rigid motion onto the mean, x -> R x + t, as R row by row, then
        t in mm. mien_representation_decode() takes it back.
        dst: rows of channel_count values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_representation_encode()
        """
        return RepresentationEncode(*_run("mien_representation_encode", {"session": session, "face": face, "representation": self}))

    def decode(self, session: Session, features: ArrayLike, motion: ArrayLike | None = None) -> Mesh:
        """The face that has these features.
        features: row_count x channel_count row-major float64.
        motion: may be left out: the mean's frame; 12 float64 of mien_representation_encode(), which is undone.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
        MIEN_E_MISMATCH (row_count), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_representation_decode()
        """
        return _run("mien_representation_decode", {"session": session, "features": features, "motion": motion, "representation": self})[0]


class ScoreModel(_Object):
    """A trained score: partial least squares on displacement and curvature. Immutable: share freely."""
    _release = "mien_score_model_release"
    _retain = "mien_score_model_retain"

    def share(self) -> ScoreModel:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def train(session: Session, dataset_path: Text, grades: ArrayLike, options: ScoreOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ScoreModel:
        """Learns a score from graded faces in correspondence.
        dataset_path: a dataset file, faces of one subject share a fold.
        grades: grade_count values, one per face, NaN: not graded.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces),
        MIEN_E_MISMATCH (counts, zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_score_model_train()
        """
        return _run("mien_score_model_train", {"session": session, "dataset_path": dataset_path, "grades": grades, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> ScoreModel:
        """Reads a score model file, which is treated as hostile.
        Fails with MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT,
        MIEN_E_NO_MEMORY.
        C: mien_score_model_load()
        """
        return _run("mien_score_model_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a score model as a safetensors file, atomically.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_score_model_save()
        """
        _run("mien_score_model_save", {"session": session, "path": path, "model": self})

    def predict(self, session: Session, face: Mesh) -> ScorePrediction:
        """The score of a face with its 95 % prediction interval.
        face: in the model's topology, mm, anywhere in space.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY.
        C: mien_score_model_predict()
        """
        return _run("mien_score_model_predict", {"session": session, "face": face, "model": self})[0]

    def simulate(self, session: Session, target: float, face: Mesh | None = None) -> Mesh:
        """The face as it would look with another score.
        face: may be left out: the training's mean face.
        target: the score wanted, finite.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY.
        C: mien_score_model_simulate()
        """
        return _run("mien_score_model_simulate", {"session": session, "target": target, "face": face, "model": self})[0]

    def latent(self, component: int) -> numpy.ndarray:
        """A latent variable on the template: how far each vertex moves, mm, at one standard deviation of it. Component
        -1: per unit of score.
        component: 0 .. components - 1, or -1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such component).
        C: mien_score_model_get_latent()
        """
        return _run("mien_score_model_get_latent", {"component": component, "model": self})[0]

    def json(self) -> str:
        """What was learned as JSON: components, cross-validated errors, held-out predictions and focus_places (how
        many places the focus takes a face for; 0: none), which are not kept in files.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_score_model_get_json()
        """
        return _run("mien_score_model_get_json", {"model": self})[0]


class Series(_Object):
    """Several scans of one person, neutralized together. Immutable: share freely between threads."""
    _release = "mien_series_release"

    def mesh(self, index: int) -> Mesh:
        """The neutral mesh of one face of a series, in that face's frame; or the person's shared one.
        index: 0 to face_count - 1, or -1: the shared neutral face, in the training's frame.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY.
        C: mien_series_get_mesh()
        """
        return _run("mien_series_get_mesh", {"index": index, "series": self})[0]

    def json(self) -> str:
        """The report as a JSON object: "faces", a list with each face's expression, residual_rms_mm (distance from its
        own fit), distance_to_shared_mm (root mean square distance of its neutral face from the shared one, without
        the changing vertices) and warnings.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_series_get_json()
        """
        return _run("mien_series_get_json", {"series": self})[0]


class Study(_Object):
    """Visits of one person: neutral faces and what changed between them. Immutable: share freely."""
    _release = "mien_study_release"
    _retain = "mien_study_retain"

    def share(self) -> Study:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, registrations: Sequence[Registration], expressions: ExpressionModel | None = None, options: StudyOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Study:
        """Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the
        first by what holds still, and measures what changed per zone with its errors. One registration: its neutral
        face and how surely it is known.
        registrations: registration_count fits of one model, first visit first.
        expressions: may be left out: faces are measured as they are held.
        options: may be left out: defaults, with the zones of the registrations' model.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (topology, zones), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_study_create()
        """
        return _run("mien_study_create", {"session": session, "registrations": registrations, "expressions": expressions, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def create_from_meshes(session: Session, faces: Sequence[Mesh], normal_sd: ArrayLike | None = None, weights: ArrayLike | None = None, expressions: ExpressionModel | None = None, options: StudyOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Study:
        """The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low, high
        and limit_of_detection are NaN.
        faces: face_count meshes in one topology, mm, first visit first.
        normal_sd: may be left out; face_count x #V values, face by face, mm, >= 0: how far each surface may lie
        off the skin along its normal.
        weights: may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0 to
        1: 0 where a scan had no data.
        expressions: may be left out: faces are measured as they are held.
        options: may be left out: defaults, without any zone. noise_mm is not read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (topology, zones, deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION,
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_study_create_from_meshes()
        """
        return _run("mien_study_create_from_meshes", {"session": session, "faces": faces, "normal_sd": normal_sd, "weights": weights, "expressions": expressions, "options": options}, progress=progress, cancel=cancel)[0]

    def counts(self) -> StudyCounts:
        """How many visits and zones a study has. The treated zones with their margin are the last zones.
        visit_count: may be left out.
        zone_count: may be left out.
        C: mien_study_get_counts()
        """
        return StudyCounts(*_run("mien_study_get_counts", {"study": self}))

    def zone_name(self, zone: int) -> str:
        """The name of a zone.
        zone: 0 to zone_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (zone).
        C: mien_study_get_zone_name()
        """
        return _run("mien_study_get_zone_name", {"zone": zone, "study": self})[0]

    def expression(self, visit: int) -> str:
        """The name of the expression that was taken off a visit.
        visit: 0 to visit_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit).
        C: mien_study_get_expression()
        """
        return _run("mien_study_get_expression", {"visit": visit, "study": self})[0]

    def mesh(self, visit: int, frame: int) -> Mesh:
        """The neutral face of a visit, in its own frame or aligned on another visit.
        visit: 0 to visit_count - 1.
        frame: the visit in whose frame to give it: its own number for its own frame.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_mesh()
        """
        return _run("mien_study_get_mesh", {"visit": visit, "frame": frame, "study": self})[0]

    def field(self, visit: int, field: StudyField | int) -> numpy.ndarray:
        """Copies a field with one float64 per vertex of a visit's face.
        visit: 0 to visit_count - 1.
        field: MIEN_STUDY_FIELD_*.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit, or nothing is known of such a field).
        C: mien_study_get_field()
        """
        return _run("mien_study_get_field", {"visit": visit, "field": field, "study": self})[0]

    def distances(self, first: int, second: int) -> numpy.ndarray:
        """How far each vertex moved between two visits: the signed distance of the second neutral face, aligned, from
        the first along the first one's normals, mm.
        first: 0 to visit_count - 1.
        second: another visit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_distances()
        """
        return _run("mien_study_get_distances", {"first": first, "second": second, "study": self})[0]

    def alignment(self, first: int, second: int) -> ZoneAlignment:
        """How the second visit was aligned on the first.
        first: 0 to visit_count - 1.
        second: another visit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_alignment()
        """
        return _run("mien_study_get_alignment", {"first": first, "second": second, "study": self})[0]

    def change(self, first: int, second: int, zone: int) -> StudyChange:
        """What changed in a zone from one visit to another.
        first: 0 to visit_count - 1.
        second: another visit.
        zone: 0 to zone_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit
        or zone), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_change()
        """
        return _run("mien_study_get_change", {"first": first, "second": second, "zone": zone, "study": self})[0]

    def json(self) -> str:
        """The study as a JSON object: "recipe" with every setting, "zones", and "visits" with the expression of each
        and "changes_since_first" per zone.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_study_get_json()
        """
        return _run("mien_study_get_json", {"study": self})[0]


class Visits(_Object):
    """One person's faces at several visits, without their expressions. Immutable: share freely between threads."""
    _release = "mien_visits_release"

    def mesh(self, index: int) -> Mesh:
        """The neutral face of one visit, in the frame of its face.
        index: 0 to face_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY.
        C: mien_visits_get_mesh()
        """
        return _run("mien_visits_get_mesh", {"index": index, "visits": self})[0]

    def expression(self, index: int) -> str:
        """The name of the expression found at one visit.
        index: 0 to face_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index).
        C: mien_visits_get_expression()
        """
        return _run("mien_visits_get_expression", {"index": index, "visits": self})[0]

    def removed_volume(self, first: int, second: int, zone: Zone | None = None) -> VisitsRemovedVolume:
        """What the expressions that were taken off amount to in a volume between two visits, and how surely they are
        known. A neutral volume carries that doubt beside the doubts of the fits.
        first: 0 to face_count - 1.
        second: 0 to face_count - 1.
        zone: may be left out: the whole face.
        removed_ml: may be left out; signed, mL.
        sd_ml: may be left out; posterior deviation, mL.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (zone), MIEN_E_NOT_FOUND (a
        visit), MIEN_E_NO_MEMORY.
        C: mien_visits_get_removed_volume()
        """
        return VisitsRemovedVolume(*_run("mien_visits_get_removed_volume", {"first": first, "second": second, "zone": zone, "visits": self}))


def status_name(status: int) -> str:
    """The name of a status, e.g. "MIEN_E_IO".
    status: any value; unknown ones give "MIEN_E_UNKNOWN".
    C: mien_status_name()
    """
    return _run("mien_status_name", {"status": status})


def version_number() -> int:
    """The library's version as MAJOR * 1000000 + MINOR * 1000 + PATCH.
    C: mien_version_number()
    """
    return _run("mien_version_number", {})


def version_string() -> str:
    """The library's version as text, e.g. "0.2.0".
    C: mien_version_string()
    """
    return _run("mien_version_string", {})


def build_id() -> str:
    """What was built, for bug reports: version, compiler, instruction sets in use on this processor.
    C: mien_build_id()
    """
    return _run("mien_build_id", {})


_enums = {"STATUS": Status, "STAGE": Stage, "LOG": Log, "DTYPE": Dtype, "KERNEL": KernelKind, "HEAT": Heat,
"MARK": Mark, "MEASURE": Measure, "ZONE": ZoneKind, "FIELD": Field, "CARRY": Carry, "MIRROR_BY": MirrorBy,
"MASS": Mass, "COTANGENTS": Cotangents, "METRIC": Metric, "GROWTH": Growth, "START": Start, "UNITS": Units,
"SIDES": Sides, "QUALITY": Quality, "REGISTRATION": RegistrationKind, "TRANSFER": Transfer, "FIT": Fit,
"POSE": Pose, "READING": Reading, "MAP": MapKind, "FEATURES": Features, "PLS": Pls, "SCORE_FEATURES":
ScoreFeatures, "STUDY": StudyKind, "STUDY_FIELD": StudyField, "TRAIN": Train}
_register_classes(globals())

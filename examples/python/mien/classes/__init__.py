"""Classes over the C interface, one module per handle, struct and group of constants.

Written by abi/generate_bindings.py; how they work stands in runtime.py.
"""
import sys as _sys

from ..runtime import register_classes as _register_classes
from .anthropometric_value import AnthropometricValue
from .anthropometry import Anthropometry
from .anthropometry_counts import AnthropometryCounts
from .anthropometry_options import AnthropometryOptions
from .asymmetry_options import AsymmetryOptions
from .band_choice import BandChoice
from .batch import Batch
from .batch_counts import BatchCounts
from .batch_options import BatchOptions
from .blendshape_model import BlendshapeModel
from .blendshape_options import BlendshapeOptions
from .cancel import Cancel
from .carry import Carry
from .cotangents import Cotangents
from .dataset_writer import DatasetWriter
from .dtype import Dtype
from .evaluate_options import EvaluateOptions
from .evaluation import Evaluation
from .expected_error import ExpectedError
from .expression_model import ExpressionModel
from .expression_model_counts import ExpressionModelCounts
from .features import Features
from .field import Field
from .fit import Fit
from .fit_verdict import FitVerdict
from .follow import Follow
from .follow_options import FollowOptions
from .follow_state import FollowState
from .follower import Follower
from .geodesic_options import GeodesicOptions
from .growth import Growth
from .heat import Heat
from .hierarchy import Hierarchy
from .hierarchy_map import HierarchyMap
from .image import Image
from .kernel import Kernel
from .kernel_kind import KernelKind
from .landmark import Landmark
from .landmark_observation import LandmarkObservation
from .landmarks import Landmarks
from .landmarks_counts import LandmarksCounts
from .landmarks_mark import LandmarksMark
from .log import Log
from .map_kind import MapKind
from .mark import Mark
from .mass import Mass
from .material import Material
from .measure import Measure
from .measure_align import MeasureAlign
from .measure_lengths import MeasureLengths
from .measure_options import MeasureOptions
from .measure_scan_volume import MeasureScanVolume
from .measurement import Measurement
from .measurement_zones import MeasurementZones
from .mesh import Mesh
from .mesh_arrays import MeshArrays
from .mesh_counts import MeshCounts
from .mesh_image_size import MeshImageSize
from .mesh_material import MeshMaterial
from .mesh_material_counts import MeshMaterialCounts
from .metric import Metric
from .mirror_by import MirrorBy
from .mirror_plane import MirrorPlane
from .model import Model
from .model_counts import ModelCounts
from .model_fit_options import ModelFitOptions
from .model_options import ModelOptions
from .network import Network
from .network_bands import NetworkBands
from .network_counts import NetworkCounts
from .network_encode import NetworkEncode
from .network_evaluation_options import NetworkEvaluationOptions
from .network_options import NetworkOptions
from .neutralization import Neutralization
from .neutralization_coordinates import NeutralizationCoordinates
from .neutralization_counts import NeutralizationCounts
from .neutralize_options import NeutralizeOptions
from .norms import Norms
from .pls import Pls
from .pose import Pose
from .quality import Quality
from .reading import Reading
from .ready_scan import ReadyScan
from .register_options import RegisterOptions
from .registration import Registration
from .registration_correspondence import RegistrationCorrespondence
from .registration_kind import RegistrationKind
from .representation import Representation
from .representation_counts import RepresentationCounts
from .representation_encode import RepresentationEncode
from .representation_options import RepresentationOptions
from .scan_landmark import ScanLandmark
from .score_features import ScoreFeatures
from .score_model import ScoreModel
from .score_options import ScoreOptions
from .score_prediction import ScorePrediction
from .series import Series
from .series_options import SeriesOptions
from .session import Session
from .session_options import SessionOptions
from .shard_options import ShardOptions
from .sides import Sides
from .spectral_basis import SpectralBasis
from .spectral_basis_counts import SpectralBasisCounts
from .spectral_basis_options import SpectralBasisOptions
from .spectral_split import SpectralSplit
from .stage import Stage
from .start import Start
from .status import Status
from .study import Study
from .study_change import StudyChange
from .study_counts import StudyCounts
from .study_field import StudyField
from .study_kind import StudyKind
from .study_options import StudyOptions
from .study_value import StudyValue
from .surface_transfer_points import SurfaceTransferPoints
from .tie_options import TieOptions
from .train import Train
from .train_options import TrainOptions
from .transfer import Transfer
from .tune_options import TuneOptions
from .tuning import Tuning
from .units import Units
from .visits import Visits
from .visits_options import VisitsOptions
from .visits_removed_volume import VisitsRemovedVolume
from .zone import Zone
from .zone_alignment import ZoneAlignment
from .zone_distance import ZoneDistance
from .zone_kind import ZoneKind
from .zone_reading import ZoneReading
from .zone_volume import ZoneVolume
from .zones import Zones
from .information import build_id, status_name, version_number, version_string

__all__ = [
    "AnthropometricValue",
    "Anthropometry",
    "AnthropometryCounts",
    "AnthropometryOptions",
    "AsymmetryOptions",
    "BandChoice",
    "Batch",
    "BatchCounts",
    "BatchOptions",
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
    "Follow",
    "FollowOptions",
    "FollowState",
    "Follower",
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
    "NetworkBands",
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
    "ReadyScan",
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
    "TieOptions",
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

_enums = {"STATUS": Status, "STAGE": Stage, "LOG": Log, "DTYPE": Dtype, "KERNEL": KernelKind, "HEAT": Heat,
"MARK": Mark, "MEASURE": Measure, "ZONE": ZoneKind, "FIELD": Field, "CARRY": Carry, "MIRROR_BY": MirrorBy,
"GROWTH": Growth, "START": Start, "UNITS": Units, "SIDES": Sides, "QUALITY": Quality, "REGISTRATION":
RegistrationKind, "TRANSFER": Transfer, "MASS": Mass, "COTANGENTS": Cotangents, "METRIC": Metric, "FIT":
Fit, "POSE": Pose, "READING": Reading, "FOLLOW": Follow, "MAP": MapKind, "FEATURES": Features, "PLS": Pls,
"SCORE_FEATURES": ScoreFeatures, "STUDY": StudyKind, "STUDY_FIELD": StudyField, "TRAIN": Train}
_register_classes(globals())
# The modules' type hints name each other's classes.
for _name in __all__:
    vars(_sys.modules[globals()[_name].__module__]).update({name: globals()[name] for name in __all__})

// Structs, constants and signatures of the C headers. Written by abi/generate_bindings.py.
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

#if NET7_0_OR_GREATER
[assembly: DisableRuntimeMarshalling]
#endif

namespace Mien.Native
{
    internal static class Constants
    {
        internal const int MIEN_OK = 0;
        internal const int MIEN_E_INVALID_ARGUMENT = -1;
        internal const int MIEN_E_INVALID_HANDLE = -2;
        internal const int MIEN_E_INVALID_MESH = -3;
        internal const int MIEN_E_BUFFER_TOO_SMALL = -4;
        internal const int MIEN_E_UNSUPPORTED_OPTION = -5;
        internal const int MIEN_E_UNSUPPORTED_VERSION = -6;
        internal const int MIEN_E_NO_MEMORY = -7;
        internal const int MIEN_E_MEMORY_BUDGET = -8;
        internal const int MIEN_E_IO = -9;
        internal const int MIEN_E_BAD_FORMAT = -10;
        internal const int MIEN_E_CORRUPT = -11;
        internal const int MIEN_E_WRONG_KIND = -12;
        internal const int MIEN_E_MISMATCH = -13;
        internal const int MIEN_E_NO_SOLUTION = -14;
        internal const int MIEN_E_NOT_FOUND = -15;
        internal const int MIEN_E_CANCELLED = -16;
        internal const int MIEN_E_CALLBACK = -17;
        internal const int MIEN_E_INTERNAL = -18;
        internal const int MIEN_STAGE_READING = 1;
        internal const int MIEN_STAGE_GEODESICS = 2;
        internal const int MIEN_STAGE_BASIS = 3;
        internal const int MIEN_STAGE_ALIGNMENT = 4;
        internal const int MIEN_STAGE_FITTING = 5;
        internal const int MIEN_STAGE_REFINING = 6;
        internal const int MIEN_STAGE_TRAINING = 7;
        internal const int MIEN_STAGE_NEUTRALIZING = 8;
        internal const int MIEN_STAGE_MEASURING = 9;
        internal const int MIEN_STAGE_WRITING = 10;
        internal const int MIEN_LOG_ERROR = 1;
        internal const int MIEN_LOG_WARNING = 2;
        internal const int MIEN_LOG_INFO = 3;
        internal const int MIEN_LOG_DEBUG = 4;
        internal const int MIEN_DTYPE_F32 = 1;
        internal const int MIEN_DTYPE_F64 = 2;
        internal const int MIEN_DTYPE_I32 = 3;
        internal const int MIEN_DTYPE_U32 = 4;
        internal const int MIEN_DTYPE_U8 = 5;
        internal const int MIEN_MASS_MIXED_VORONOI = 0;
        internal const int MIEN_MASS_BARYCENTRIC = 1;
        internal const int MIEN_MASS_NONE = 2;
        internal const int MIEN_COTANGENTS_INTRINSIC_DELAUNAY = 0;
        internal const int MIEN_COTANGENTS_CLAMP = 1;
        internal const int MIEN_COTANGENTS_KEEP = 2;
        internal const int MIEN_METRIC_L1 = 1;
        internal const int MIEN_METRIC_L2 = 2;
        internal const int MIEN_METRIC_HAUSDORFF = 3;
        internal const int MIEN_METRIC_DAME = 4;
        internal const int MIEN_METRIC_FMPD = 5;
        internal const int MIEN_KERNEL_NONE = 0;
        internal const int MIEN_KERNEL_EUCLIDEAN_SE = 1;
        internal const int MIEN_KERNEL_GEODESIC_SE = 2;
        internal const int MIEN_KERNEL_BSPLINE = 3;
        internal const int MIEN_KERNEL_SURFACE_MATERN = 4;
        internal const int MIEN_HEAT_NEUMANN = 1;
        internal const int MIEN_HEAT_DIRICHLET = 2;
        internal const int MIEN_HEAT_AVERAGE = 3;
        internal const int MIEN_MARK_NOT_PICKED = 0;
        internal const int MIEN_MARK_PLACE = 1;
        internal const int MIEN_MARK_VERTEX = 2;
        internal const int MIEN_GROWTH_CONSTANT = 0;
        internal const int MIEN_GROWTH_LINEAR = 1;
        internal const int MIEN_GROWTH_EXPONENTIAL = 2;
        internal const int MIEN_GROWTH_CUBIC = 3;
        internal const int MIEN_START_AUTOMATIC = 0;
        internal const int MIEN_START_LANDMARKS = 1;
        internal const int MIEN_START_POSE = 2;
        internal const int MIEN_START_SEARCH = 3;
        internal const int MIEN_UNITS_DETECT = 0;
        internal const int MIEN_UNITS_MILLIMETRES = 1;
        internal const int MIEN_UNITS_REFUSE = 2;
        internal const int MIEN_SIDES_REFUSE = 0;
        internal const int MIEN_SIDES_MEND = 1;
        internal const int MIEN_SIDES_IGNORE = 2;
        internal const int MIEN_QUALITY_GOOD = 0;
        internal const int MIEN_QUALITY_DOUBTFUL = 1;
        internal const int MIEN_QUALITY_FAILED = 2;
        internal const int MIEN_REGISTRATION_RESIDUAL_MM = 1;
        internal const int MIEN_REGISTRATION_WEIGHT = 2;
        internal const int MIEN_REGISTRATION_STANDARD_DEVIATION_MM = 3;
        internal const int MIEN_REGISTRATION_RADIUS95_MM = 4;
        internal const int MIEN_REGISTRATION_NORMAL_DEVIATION_MM = 5;
        internal const int MIEN_TRANSFER_LANDMARKS = 1;
        internal const int MIEN_TRANSFER_ZONES = 2;
        internal const int MIEN_FIT_MIXTURE = 0;
        internal const int MIEN_FIT_MAP = 1;
        internal const int MIEN_FIT_EXACT = 2;
        internal const int MIEN_FIT_ALTERNATING = 3;
        internal const int MIEN_POSE_AUTO = 0;
        internal const int MIEN_POSE_KEEP = 1;
        internal const int MIEN_POSE_RIGID = 2;
        internal const int MIEN_MAP_DOWN = 1;
        internal const int MIEN_MAP_UP = 2;
        internal const int MIEN_ZONE_WHOLE = -1;
        internal const int MIEN_ZONE_REST = -2;
        internal const int MIEN_FIELD_SIGNED_DISTANCE_MM = 1;
        internal const int MIEN_FIELD_DISTANCE_MM = 2;
        internal const int MIEN_FIELD_POSITIVE_VOLUME_MM3 = 3;
        internal const int MIEN_FIELD_NEGATIVE_VOLUME_MM3 = 4;
        internal const int MIEN_FIELD_CURVATURE_MAXIMAL = 5;
        internal const int MIEN_FIELD_CURVATURE_MINIMAL = 6;
        internal const int MIEN_FIELD_CURVATURE_MEAN = 7;
        internal const int MIEN_FIELD_CURVATURE_GAUSSIAN = 8;
        internal const int MIEN_CARRY_CLOSEST_POINT = 1;
        internal const int MIEN_CARRY_DIRECTION = 2;
        internal const int MIEN_CARRY_VERTEX_NORMAL = 3;
        internal const int MIEN_FEATURES_EUCLIDEAN = 1;
        internal const int MIEN_FEATURES_EUCLIDEAN_STANDARDISED = 2;
        internal const int MIEN_FEATURES_EUCLIDEAN_NORMALISED = 3;
        internal const int MIEN_FEATURES_DEFORMATION = 4;
        internal const int MIEN_FEATURES_DEFORMATION_NORMALISED = 5;
        internal const int MIEN_FEATURES_DEFORMATION_STANDARDISED = 6;
        internal const int MIEN_PLS_NIPALS = 0;
        internal const int MIEN_PLS_SIMPLS = 1;
        internal const int MIEN_STUDY_KNOWN = 0;
        internal const int MIEN_STUDY_UNSEEN = 1;
        internal const int MIEN_STUDY_FAILED_FIT = 2;
        internal const int MIEN_STUDY_NO_SURFACE_ERRORS = 3;
        internal const int MIEN_STUDY_OUTSIDE_EXPRESSIONS = 4;
        internal const int MIEN_STUDY_FIELD_NORMAL_SD_MM = 1;
        internal const int MIEN_STUDY_FIELD_WEIGHT = 2;
        internal const int MIEN_STUDY_FIELD_EXPRESSION_SD_MM = 3;
        internal const int MIEN_TRAIN_JPCA = 0;
        internal const int MIEN_TRAIN_QOJPCA = 1;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Error
    {
        public uint structSize;
        public int status;
        public long detailIndex;
        public fixed byte message[256];
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct SessionOptions
    {
        public uint structSize;
        public int numThreads;
        public ulong maxBytes;
        public IntPtr log;
        public IntPtr logUser;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ArrayView
    {
        public IntPtr data;
        public ulong count;
        public ulong strideBytes;
        public int dtype;
        public int reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Zone
    {
        public IntPtr name;
        public IntPtr vertices;
        public ulong vertexCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Image
    {
        public IntPtr name;
        public IntPtr pixels;
        public ulong rowStrideBytes;
        public uint width;
        public uint height;
        public IntPtr file;
        public ulong fileSize;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Material
    {
        public IntPtr name;
        public int image;
        public int reserved;
        public double red;
        public double green;
        public double blue;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct MeshArrays
    {
        public uint structSize;
        public uint reserved;
        public ArrayView positions;
        public IntPtr triangles;
        public ulong triangleCount;
        public IntPtr colors;
        public IntPtr texture;
        public ulong textureCount;
        public IntPtr textureTriangles;
        public IntPtr materials;
        public ulong materialCount;
        public IntPtr triangleMaterials;
        public IntPtr images;
        public ulong imageCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct SpectralBasisOptions
    {
        public uint structSize;
        public uint modeCount;
        public int mass;
        public int cotangents;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct BlendshapeOptions
    {
        public uint structSize;
        public uint reserved;
        public double ridge;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct BandChoice
    {
        public ulong k;
        public double l1Mm;
        public double dame;
        public double fmpd;
        public int onFront;
        public int chosen;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Kernel
    {
        public int kind;
        public int reserved;
        public double sigmaMm;
        public double scaleMm;
        public double nu;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Landmark
    {
        public IntPtr name;
        public uint vertex;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct LandmarkObservation
    {
        public IntPtr name;
        public uint vertex;
        public uint reserved;
        public fixed double position[3];
        public double noiseMm;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ModelOptions
    {
        public uint structSize;
        public int kernel;
        public double sigmaMm;
        public double scaleMm;
        public double nu;
        public int levels;
        public int numModes;
        public IntPtr kernels;
        public ulong kernelCount;
        public double tolerance;
        public int numControlPoints;
        public int mirrorSymmetric;
        public double mirrorCorrelation;
        public double eigenvalueThreshold;
        public double heatTimeFactor;
        public int heatBoundary;
        public int pcaModes;
        public IntPtr pcaDataset;
        public double pcaVariance;
        public int pcaAllExpressions;
        public int pcaAlign;
        public ArrayView scalePerVertex;
        public IntPtr landmarks;
        public ulong landmarkCount;
        public IntPtr zones;
        public ulong zoneCount;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct TuneOptions
    {
        public uint structSize;
        public int kernel;
        public IntPtr sigmasMm;
        public ulong sigmaCount;
        public double scaleMm;
        public double nu;
        public double rho;
        public int levels;
        public int numModes;
        public IntPtr expressions;
        public uint expressionCount;
        public int maxSubjects;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ScanLandmark
    {
        public IntPtr name;
        public fixed double position[3];
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct RegisterOptions
    {
        public uint structSize;
        public int growth;
        public IntPtr landmarks;
        public ulong landmarkCount;
        public double landmarkSigmaMm;
        public int start;
        public int units;
        public ArrayView scanWeights;
        public int skinWeights;
        public int closeGap;
        public int maxScalarModes;
        public int maxPcaModes;
        public int iterations;
        public int rejectBorder;
        public double sigmaStartMm;
        public double sigmaEndMm;
        public double maxAngleDeg;
        public fixed double startRotation[9];
        public fixed double startTranslation[3];
        public double startScale;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
        public int colorFeatures;
        public uint reserved;
        public double unitToMm;
        public int landmarkSides;
        public uint reserved2;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct FitVerdict
    {
        public uint structSize;
        public int quality;
        public double coverage;
        public double inlierShare;
        public double meanResidualMm;
        public double landmarkRmsMm;
        public double sizeRatio;
        public double meanDeviation;
        public double unitToMm;
        public int landmarksUsed;
        public int landmarksRejected;
        public int flippedTriangles;
        public int selfIntersections;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct NeutralizeOptions
    {
        public uint structSize;
        public int method;
        public int maxSweeps;
        public int uncertainty;
        public int pose;
        public uint reserved;
        public double toleranceMm;
        public double noiseMm2;
        public double decayMm;
        public ArrayView weights;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct EvaluateOptions
    {
        public uint structSize;
        public int method;
        public int maxSweeps;
        public int againstMethod;
        public int againstMaxSweeps;
        public uint reserved;
        public IntPtr against;
        public IntPtr zoneVertices;
        public ulong zoneCount;
        public IntPtr stableVertices;
        public ulong stableCount;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct MeasureOptions
    {
        public uint structSize;
        public int skipBorders;
        public IntPtr zones;
        public ulong zoneCount;
        public ArrayView beforeSd;
        public ArrayView afterSd;
        public double correlationLengthMm;
        public double alignmentRotationSdRad;
        public double alignmentTranslationSdMm;
        public fixed double alignmentCentre[3];
        public double commonBiasMm;
        public double limitOfDetectionMl;
        public double maxDistanceMm;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ZoneVolume
    {
        public uint structSize;
        public int detected;
        public double signedMl;
        public double positiveMl;
        public double negativeMl;
        public double absoluteMl;
        public double sdMl;
        public double low95Ml;
        public double high95Ml;
        public double areaBeforeMm2;
        public double areaAfterMm2;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ZoneDistance
    {
        public uint structSize;
        public uint reserved;
        public double meanSignedMm;
        public double sdSignedMm;
        public double meanAbsoluteMm;
        public double rmsMm;
        public double meanLengthMm;
        public double medianLengthMm;
        public double p95LengthMm;
        public double maxLengthMm;
        public ulong vertexCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ZoneAlignment
    {
        public uint structSize;
        public uint reserved;
        public ulong pairs;
        public double rmsMm;
        public double rotationSdRad;
        public double translationSdMm;
        public fixed double centre[3];
        public fixed double matrix[16];
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct RepresentationOptions
    {
        public uint structSize;
        public int neutralOnly;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ScoreOptions
    {
        public uint structSize;
        public int method;
        public int numComponents;
        public int maxComponents;
        public int folds;
        public uint reserved;
        public ulong seed;
        public double curvatureShare;
        public double curvatureRadiusMm;
        public double lowest;
        public double highest;
        public IntPtr zoneVertices;
        public ulong zoneCount;
        public IntPtr stableVertices;
        public ulong stableCount;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
        public uint focus;
        public uint reserved2;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ScorePrediction
    {
        public uint structSize;
        public int extrapolates;
        public double score;
        public double low95;
        public double high95;
        public double leverage;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct SeriesOptions
    {
        public uint structSize;
        public int method;
        public int pose;
        public uint reserved;
        public double scanNoiseShare;
        public double noiseMm2;
        public IntPtr changingVertices;
        public ulong changingCount;
        public double expectedChangeMm;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
        public ArrayView weights;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct StudyOptions
    {
        public uint structSize;
        public uint reserved;
        public IntPtr zones;
        public ulong zoneCount;
        public IntPtr treatedZones;
        public ulong treatedCount;
        public IntPtr stableZones;
        public ulong stableCount;
        public IntPtr visits;
        public ulong visitNumberCount;
        public double marginMm;
        public double level;
        public double noiseMm;
        public double correlationLengthMm;
        public double commonBiasMm;
        public double untrainedShare;
        public double minSeenShare;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct StudyValue
    {
        public double value;
        public double sd;
        public double low;
        public double high;
        public double limitOfDetection;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct StudyChange
    {
        public uint structSize;
        public int unknown;
        public StudyValue signedMl;
        public StudyValue gainedMl;
        public StudyValue lostMl;
        public StudyValue absoluteMl;
        public StudyValue areaChangeMm2;
        public StudyValue meanDistanceMm;
        public double surfaceSdMl;
        public double alignmentSdMl;
        public double biasSdMl;
        public double expressionSdMl;
        public double expressionRemovedMl;
        public double seenShare;
        public double areaBeforeMm2;
        public double areaAfterMm2;
        public int detected;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct TrainOptions
    {
        public uint structSize;
        public int method;
        public int identityModes;
        public int expressionModes;
        public int maxIterations;
        public int passes;
        public double lambda;
        public double lambdaFactor;
        public double angleToleranceRad;
        public double noiseMm2;
        public IntPtr stableVertices;
        public ulong stableCount;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ShardOptions
    {
        public uint structSize;
        public int part;
        public int partCount;
        public int maxRank;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
        public IntPtr stableVertices;
        public ulong stableCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct VisitsOptions
    {
        public uint structSize;
        public int pose;
        public double normalNoiseMm2;
        public double tangentialNoiseMm2;
        public IntPtr treatedVertices;
        public ulong treatedCount;
        public ArrayView weights;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    internal sealed class SessionHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_session_release(handle); return true; }
    }

    internal sealed class CancelHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_cancel_release(handle); return true; }
    }

    internal sealed class MeshHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_mesh_release(handle); return true; }
    }

    internal sealed class SpectralBasisHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_spectral_basis_release(handle); return true; }
    }

    internal sealed class BlendshapeModelHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_blendshape_model_release(handle); return true; }
    }

    internal sealed class DatasetWriterHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_dataset_writer_release(handle); return true; }
    }

    internal sealed class ModelHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_model_release(handle); return true; }
    }

    internal sealed class TuningHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_tuning_release(handle); return true; }
    }

    internal sealed class LandmarksHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_landmarks_release(handle); return true; }
    }

    internal sealed class ZonesHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_zones_release(handle); return true; }
    }

    internal sealed class RegistrationHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_registration_release(handle); return true; }
    }

    internal sealed class ExpressionModelHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_expression_model_release(handle); return true; }
    }

    internal sealed class NeutralizationHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_neutralization_release(handle); return true; }
    }

    internal sealed class EvaluationHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_evaluation_release(handle); return true; }
    }

    internal sealed class HierarchyHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_hierarchy_release(handle); return true; }
    }

    internal sealed class MeasurementHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_measurement_release(handle); return true; }
    }

    internal sealed class RepresentationHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_representation_release(handle); return true; }
    }

    internal sealed class ScoreModelHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_score_model_release(handle); return true; }
    }

    internal sealed class SeriesHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_series_release(handle); return true; }
    }

    internal sealed class StudyHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_study_release(handle); return true; }
    }

    internal sealed class VisitsHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_visits_release(handle); return true; }
    }

    internal static unsafe partial class Functions
    {
        internal const uint AbiVersion = 0;

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_status_name(int status);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_status_name(int status);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial uint mien_version_number();
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint mien_version_number();
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_version_string();
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_version_string();
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_build_id();
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_build_id();
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_session_options_init(ref SessionOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_session_options_init(ref SessionOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_session_create(uint abi_version, out SessionHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_session_create(uint abi_version, out SessionHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_session_create_with_options(uint abi_version, ref SessionOptions options, out SessionHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_session_create_with_options(uint abi_version, ref SessionOptions options, out SessionHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_session_release(IntPtr session);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_session_release(IntPtr session);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_cancel_create(out CancelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_cancel_create(out CancelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_cancel_request(IntPtr cancel);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_cancel_request(IntPtr cancel);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_cancel_release(IntPtr cancel);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_cancel_release(IntPtr cancel);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_mesh_arrays_init(ref MeshArrays arrays, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_mesh_arrays_init(ref MeshArrays arrays, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_create(SessionHandle session, ref MeshArrays arrays, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_create(SessionHandle session, ref MeshArrays arrays, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_load(SessionHandle session, byte[] path, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_load(SessionHandle session, byte[] path, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_save(SessionHandle session, MeshHandle mesh, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_save(SessionHandle session, MeshHandle mesh, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_counts(MeshHandle mesh, out ulong vertex_count, out ulong triangle_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_counts(MeshHandle mesh, out ulong vertex_count, out ulong triangle_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_positions(MeshHandle mesh, int dtype, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_positions(MeshHandle mesh, int dtype, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_triangles(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_triangles(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_colors(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_colors(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial uint mien_mesh_format_count();
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint mien_mesh_format_count();
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_mesh_format_extension(uint format);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_mesh_format_extension(uint format);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_mesh_format_description(uint format);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_mesh_format_description(uint format);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_mesh_format_writes(uint format);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_mesh_format_writes(uint format);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_texture(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_texture(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_texture_triangles(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_texture_triangles(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_triangle_materials(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_triangle_materials(MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_material_counts(MeshHandle mesh, out ulong material_count, out ulong image_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_material_counts(MeshHandle mesh, out ulong material_count, out ulong image_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_material(MeshHandle mesh, ulong material, IntPtr image, IntPtr red, IntPtr green, IntPtr blue, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_material(MeshHandle mesh, ulong material, IntPtr image, IntPtr red, IntPtr green, IntPtr blue, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_material_name(MeshHandle mesh, ulong material, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_material_name(MeshHandle mesh, ulong material, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_image_name(MeshHandle mesh, ulong image, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_name(MeshHandle mesh, ulong image, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_image_file(MeshHandle mesh, ulong image, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_file(MeshHandle mesh, ulong image, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_image_size(MeshHandle mesh, ulong image, IntPtr width, IntPtr height, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_size(MeshHandle mesh, ulong image, IntPtr width, IntPtr height, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_get_image_pixels(SessionHandle session, MeshHandle mesh, ulong image, ulong row_stride_bytes, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_pixels(SessionHandle session, MeshHandle mesh, ulong image, ulong row_stride_bytes, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_save_targets(SessionHandle session, MeshHandle mesh, out MeshHandle targets, IntPtr[] names, ulong target_count, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_save_targets(SessionHandle session, MeshHandle mesh, out MeshHandle targets, IntPtr[] names, ulong target_count, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_load_target(SessionHandle session, byte[] path, byte[] name, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_load_target(SessionHandle session, byte[] path, byte[] name, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_positions_view(MeshHandle mesh, out IntPtr data, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_positions_view(MeshHandle mesh, out IntPtr data, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_mesh_retain(IntPtr mesh);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_mesh_retain(IntPtr mesh);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_mesh_release(IntPtr mesh);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_mesh_release(IntPtr mesh);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_spectral_basis_options_init(ref SpectralBasisOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_spectral_basis_options_init(ref SpectralBasisOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_basis_build(SessionHandle session, MeshHandle mean, ref SpectralBasisOptions options, out SpectralBasisHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_build(SessionHandle session, MeshHandle mean, ref SpectralBasisOptions options, out SpectralBasisHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_basis_load(SessionHandle session, byte[] path, out SpectralBasisHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_load(SessionHandle session, byte[] path, out SpectralBasisHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_basis_save(SessionHandle session, SpectralBasisHandle basis, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_save(SessionHandle session, SpectralBasisHandle basis, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_basis_get_counts(SpectralBasisHandle basis, out ulong vertex_count, out ulong mode_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_counts(SpectralBasisHandle basis, out ulong vertex_count, out ulong mode_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_basis_get_eigenvalues(SpectralBasisHandle basis, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_eigenvalues(SpectralBasisHandle basis, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_spectral_basis_retain(IntPtr basis);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_spectral_basis_retain(IntPtr basis);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_spectral_basis_release(IntPtr basis);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_spectral_basis_release(IntPtr basis);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_split(SessionHandle session, SpectralBasisHandle basis, MeshHandle face, ulong k, out MeshHandle low, out MeshHandle high, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_split(SessionHandle session, SpectralBasisHandle basis, MeshHandle face, ulong k, out MeshHandle low, out MeshHandle high, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_assemble(SessionHandle session, SpectralBasisHandle basis, MeshHandle low, MeshHandle high, ulong k, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_assemble(SessionHandle session, SpectralBasisHandle basis, MeshHandle low, MeshHandle high, ulong k, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_edit(SessionHandle session, SpectralBasisHandle basis, MeshHandle face, IntPtr limits, ulong limit_count, IntPtr gains, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_edit(SessionHandle session, SpectralBasisHandle basis, MeshHandle face, IntPtr limits, ulong limit_count, IntPtr gains, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_spectral_mix(SessionHandle session, SpectralBasisHandle basis, MeshHandle first, MeshHandle second, IntPtr limits, ulong limit_count, IntPtr weights, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_mix(SessionHandle session, SpectralBasisHandle basis, MeshHandle first, MeshHandle second, IntPtr limits, ulong limit_count, IntPtr weights, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_metric(SessionHandle session, int metric, MeshHandle reference, MeshHandle other, IntPtr value, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_metric(SessionHandle session, int metric, MeshHandle reference, MeshHandle other, IntPtr value, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_transfer_expression(SessionHandle session, MeshHandle source_neutral, MeshHandle source_expression, MeshHandle target_neutral, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_transfer_expression(SessionHandle session, MeshHandle source_neutral, MeshHandle source_expression, MeshHandle target_neutral, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_blendshape_options_init(ref BlendshapeOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_blendshape_options_init(ref BlendshapeOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_blendshape_model_train(SessionHandle session, byte[] dataset_path, byte[] expression, ref BlendshapeOptions options, out BlendshapeModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_train(SessionHandle session, byte[] dataset_path, byte[] expression, ref BlendshapeOptions options, out BlendshapeModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_blendshape_model_load(SessionHandle session, byte[] path, out BlendshapeModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_load(SessionHandle session, byte[] path, out BlendshapeModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_blendshape_model_save(SessionHandle session, BlendshapeModelHandle model, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_save(SessionHandle session, BlendshapeModelHandle model, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_blendshape_model_get_mean(BlendshapeModelHandle model, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_get_mean(BlendshapeModelHandle model, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_blendshape_model_predict(SessionHandle session, BlendshapeModelHandle model, IntPtr basis, ulong k, MeshHandle neutral, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_predict(SessionHandle session, BlendshapeModelHandle model, IntPtr basis, ulong k, MeshHandle neutral, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_blendshape_model_search(SessionHandle session, BlendshapeModelHandle model, SpectralBasisHandle basis, byte[] dataset_path, byte[] expression, IntPtr candidates, uint candidate_count, ref BlendshapeOptions options, ref BandChoice choices, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_search(SessionHandle session, BlendshapeModelHandle model, SpectralBasisHandle basis, byte[] dataset_path, byte[] expression, IntPtr candidates, uint candidate_count, ref BlendshapeOptions options, ref BandChoice choices, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_blendshape_model_retain(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_blendshape_model_retain(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_blendshape_model_release(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_blendshape_model_release(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_dataset_writer_create(SessionHandle session, MeshHandle topology, IntPtr[] expression_names, uint expression_count, out DatasetWriterHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_dataset_writer_create(SessionHandle session, MeshHandle topology, IntPtr[] expression_names, uint expression_count, out DatasetWriterHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_dataset_writer_add(DatasetWriterHandle writer, ref ArrayView positions, int subject, int expression, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_dataset_writer_add(DatasetWriterHandle writer, ref ArrayView positions, int subject, int expression, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_dataset_writer_save(SessionHandle session, DatasetWriterHandle writer, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_dataset_writer_save(SessionHandle session, DatasetWriterHandle writer, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_dataset_writer_release(IntPtr writer);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_dataset_writer_release(IntPtr writer);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_model_options_init(ref ModelOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_options_init(ref ModelOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_build(SessionHandle session, MeshHandle template_mesh, ref ModelOptions options, out ModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_build(SessionHandle session, MeshHandle template_mesh, ref ModelOptions options, out ModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_load(SessionHandle session, byte[] path, out ModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_load(SessionHandle session, byte[] path, out ModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_load_memory(SessionHandle session, IntPtr data, ulong size, out ModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_load_memory(SessionHandle session, IntPtr data, ulong size, out ModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_load_trusted(SessionHandle session, byte[] path, out ModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_load_trusted(SessionHandle session, byte[] path, out ModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_save(SessionHandle session, ModelHandle model, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_save(SessionHandle session, ModelHandle model, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_get_counts(ModelHandle model, out ulong vertex_count, IntPtr scalar_modes, IntPtr vector_modes, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_counts(ModelHandle model, out ulong vertex_count, IntPtr scalar_modes, IntPtr vector_modes, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_get_json(ModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_json(ModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_get_variance(ModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_variance(ModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_sample(SessionHandle session, ModelHandle model, ulong seed, ulong index, double strength, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_sample(SessionHandle session, ModelHandle model, ulong seed, ulong index, double strength, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_condition(SessionHandle session, ModelHandle model, ref LandmarkObservation observations, ulong observation_count, out ModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_condition(SessionHandle session, ModelHandle model, ref LandmarkObservation observations, ulong observation_count, out ModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_tune_options_init(ref TuneOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_tune_options_init(ref TuneOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_tune(SessionHandle session, MeshHandle template_mesh, byte[] dataset, ref TuneOptions options, out TuningHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_tune(SessionHandle session, MeshHandle template_mesh, byte[] dataset, ref TuneOptions options, out TuningHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_tuning_get_json(TuningHandle tuning, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_tuning_get_json(TuningHandle tuning, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_tuning_release(IntPtr tuning);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_tuning_release(IntPtr tuning);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_model_mesh(ModelHandle model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_model_mesh(ModelHandle model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_model_retain(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_retain(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_model_release(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_release(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_load(SessionHandle session, byte[] path, out LandmarksHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_load(SessionHandle session, byte[] path, out LandmarksHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_create(ref ScanLandmark landmarks, ulong landmark_count, out LandmarksHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_create(ref ScanLandmark landmarks, ulong landmark_count, out LandmarksHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_get_landmarks(ModelHandle model, out LandmarksHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_landmarks(ModelHandle model, out LandmarksHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_match(LandmarksHandle landmarks, ModelHandle model, out LandmarksHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_match(LandmarksHandle landmarks, ModelHandle model, out LandmarksHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_on_mesh(LandmarksHandle landmarks, MeshHandle mesh, out LandmarksHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_on_mesh(LandmarksHandle landmarks, MeshHandle mesh, out LandmarksHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_save(SessionHandle session, LandmarksHandle landmarks, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_save(SessionHandle session, LandmarksHandle landmarks, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_get_counts(LandmarksHandle landmarks, out ulong count, out ulong picked_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_counts(LandmarksHandle landmarks, out ulong count, out ulong picked_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_get_name(LandmarksHandle landmarks, ulong index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_name(LandmarksHandle landmarks, ulong index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_get_mark(LandmarksHandle landmarks, ulong index, IntPtr where, IntPtr position, IntPtr vertex, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_mark(LandmarksHandle landmarks, ulong index, IntPtr where, IntPtr position, IntPtr vertex, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_landmarks_get_json(LandmarksHandle landmarks, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_json(LandmarksHandle landmarks, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_landmarks_retain(IntPtr landmarks);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_landmarks_retain(IntPtr landmarks);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_landmarks_release(IntPtr landmarks);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_landmarks_release(IntPtr landmarks);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_zones_load(SessionHandle session, byte[] path, out ZonesHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_load(SessionHandle session, byte[] path, out ZonesHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_zones_create(ref Zone zones, ulong zone_count, out ZonesHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_create(ref Zone zones, ulong zone_count, out ZonesHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_model_get_zones(ModelHandle model, out ZonesHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_zones(ModelHandle model, out ZonesHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_zones_save(SessionHandle session, ZonesHandle zones, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_save(SessionHandle session, ZonesHandle zones, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_zones_get_count(ZonesHandle zones, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_get_count(ZonesHandle zones, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_zones_get_name(ZonesHandle zones, ulong index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_get_name(ZonesHandle zones, ulong index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_zones_get_vertices(ZonesHandle zones, ulong index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_get_vertices(ZonesHandle zones, ulong index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_zones_retain(IntPtr zones);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_zones_retain(IntPtr zones);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_zones_release(IntPtr zones);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_zones_release(IntPtr zones);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_register_options_init(ref RegisterOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_register_options_init(ref RegisterOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_register(SessionHandle session, ModelHandle model, MeshHandle scan, ref RegisterOptions options, out RegistrationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_register(SessionHandle session, ModelHandle model, MeshHandle scan, ref RegisterOptions options, out RegistrationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_registration_mesh(RegistrationHandle registration);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_registration_mesh(RegistrationHandle registration);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_get_verdict(RegistrationHandle registration, ref FitVerdict @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_verdict(RegistrationHandle registration, ref FitVerdict @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_get_field(RegistrationHandle registration, int field, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_field(RegistrationHandle registration, int field, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_get_correspondence(RegistrationHandle registration, IntPtr triangles, IntPtr barycentric, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_correspondence(RegistrationHandle registration, IntPtr triangles, IntPtr barycentric, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_get_motion(RegistrationHandle registration, IntPtr matrix, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_motion(RegistrationHandle registration, IntPtr matrix, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_get_json(RegistrationHandle registration, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_json(RegistrationHandle registration, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_save(SessionHandle session, RegistrationHandle registration, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_save(SessionHandle session, RegistrationHandle registration, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_load(SessionHandle session, byte[] path, out RegistrationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_load(SessionHandle session, byte[] path, out RegistrationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_registration_create(SessionHandle session, MeshHandle mesh, ref ArrayView weight, ref ArrayView residual, ref ArrayView standard_deviation, int quality, out RegistrationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_create(SessionHandle session, MeshHandle mesh, ref ArrayView weight, ref ArrayView residual, ref ArrayView standard_deviation, int quality, out RegistrationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_registration_retain(IntPtr registration);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_registration_retain(IntPtr registration);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_registration_release(IntPtr registration);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_registration_release(IntPtr registration);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_surface_transfer_points(SessionHandle session, MeshHandle surface, ref ArrayView points, double max_distance_mm, IntPtr triangles, IntPtr barycentric, IntPtr positions, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_surface_transfer_points(SessionHandle session, MeshHandle surface, ref ArrayView points, double max_distance_mm, IntPtr triangles, IntPtr barycentric, IntPtr positions, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_surface_transfer_zone(SessionHandle session, MeshHandle from, IntPtr vertices, ulong vertex_count, MeshHandle to, double max_distance_mm, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_surface_transfer_zone(SessionHandle session, MeshHandle from, IntPtr vertices, ulong vertex_count, MeshHandle to, double max_distance_mm, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_surface_transfer_json(SessionHandle session, ModelHandle model, MeshHandle fitted, MeshHandle scan, int what, double max_distance_mm, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_surface_transfer_json(SessionHandle session, ModelHandle model, MeshHandle fitted, MeshHandle scan, int what, double max_distance_mm, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_load(SessionHandle session, byte[] path, out ExpressionModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_load(SessionHandle session, byte[] path, out ExpressionModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_load_memory(SessionHandle session, IntPtr data, ulong size, out ExpressionModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_load_memory(SessionHandle session, IntPtr data, ulong size, out ExpressionModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_save(SessionHandle session, ExpressionModelHandle model, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_save(SessionHandle session, ExpressionModelHandle model, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_expression_model_retain(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_expression_model_retain(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_expression_model_release(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_expression_model_release(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_get_counts(ExpressionModelHandle model, out ulong vertex_count, IntPtr identity_modes, IntPtr expression_modes, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_get_counts(ExpressionModelHandle model, out ulong vertex_count, IntPtr identity_modes, IntPtr expression_modes, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_get_json(ExpressionModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_get_json(ExpressionModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_synthesize(SessionHandle session, ExpressionModelHandle model, ref ArrayView identity, ref ArrayView expression, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_synthesize(SessionHandle session, ExpressionModelHandle model, ref ArrayView identity, ref ArrayView expression, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_sample(SessionHandle session, ExpressionModelHandle model, ulong seed, byte[] expression, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_sample(SessionHandle session, ExpressionModelHandle model, ulong seed, byte[] expression, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_neutralize_options_init(ref NeutralizeOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_neutralize_options_init(ref NeutralizeOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralize(SessionHandle session, ExpressionModelHandle model, RegistrationHandle fitted, ref NeutralizeOptions options, out NeutralizationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize(SessionHandle session, ExpressionModelHandle model, RegistrationHandle fitted, ref NeutralizeOptions options, out NeutralizationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralize_mesh(SessionHandle session, ExpressionModelHandle model, MeshHandle face, ref NeutralizeOptions options, out NeutralizationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize_mesh(SessionHandle session, ExpressionModelHandle model, MeshHandle face, ref NeutralizeOptions options, out NeutralizationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial IntPtr mien_neutralization_mesh(NeutralizationHandle neutralization);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_neutralization_mesh(NeutralizationHandle neutralization);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralization_get_coordinates(NeutralizationHandle neutralization, IntPtr identity, IntPtr expression, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_coordinates(NeutralizationHandle neutralization, IntPtr identity, IntPtr expression, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralization_get_uncertainty(NeutralizationHandle neutralization, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_uncertainty(NeutralizationHandle neutralization, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralization_get_json(NeutralizationHandle neutralization, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_json(NeutralizationHandle neutralization, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_neutralization_release(IntPtr neutralization);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_neutralization_release(IntPtr neutralization);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralization_apply_to_scan(SessionHandle session, NeutralizationHandle neutralization, MeshHandle scan, double max_distance_mm, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_apply_to_scan(SessionHandle session, NeutralizationHandle neutralization, MeshHandle scan, double max_distance_mm, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_transfer(SessionHandle session, ExpressionModelHandle model, NeutralizationHandle source, NeutralizationHandle target, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_transfer(SessionHandle session, ExpressionModelHandle model, NeutralizationHandle source, NeutralizationHandle target, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_evaluate_options_init(ref EvaluateOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_evaluate_options_init(ref EvaluateOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_evaluate_neutralization(SessionHandle session, ExpressionModelHandle model, byte[] dataset_path, ref EvaluateOptions options, out EvaluationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_evaluate_neutralization(SessionHandle session, ExpressionModelHandle model, byte[] dataset_path, ref EvaluateOptions options, out EvaluationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_evaluation_get_json(EvaluationHandle evaluation, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_evaluation_get_json(EvaluationHandle evaluation, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_evaluation_release(IntPtr evaluation);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_evaluation_release(IntPtr evaluation);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_build_quadric(SessionHandle session, MeshHandle mesh, uint level_count, double factor, out HierarchyHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_build_quadric(SessionHandle session, MeshHandle mesh, uint level_count, double factor, out HierarchyHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_build_connectivity(SessionHandle session, MeshHandle mesh, uint level_count, uint stride, uint radius, out HierarchyHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_build_connectivity(SessionHandle session, MeshHandle mesh, uint level_count, uint stride, uint radius, out HierarchyHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_load(SessionHandle session, byte[] path, out HierarchyHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_load(SessionHandle session, byte[] path, out HierarchyHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_save(SessionHandle session, HierarchyHandle hierarchy, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_save(SessionHandle session, HierarchyHandle hierarchy, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_get_level_count(HierarchyHandle hierarchy, out ulong level_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_get_level_count(HierarchyHandle hierarchy, out ulong level_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_get_level(HierarchyHandle hierarchy, uint level, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_get_level(HierarchyHandle hierarchy, uint level, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_hierarchy_apply(HierarchyHandle hierarchy, uint level, int direction, IntPtr values, ulong row_count, ulong channel_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_apply(HierarchyHandle hierarchy, uint level, int direction, IntPtr values, ulong row_count, ulong channel_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_hierarchy_retain(IntPtr hierarchy);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_hierarchy_retain(IntPtr hierarchy);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_hierarchy_release(IntPtr hierarchy);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_hierarchy_release(IntPtr hierarchy);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_measure_options_init(ref MeasureOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_measure_options_init(ref MeasureOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_volume(SessionHandle session, MeshHandle before, MeshHandle after, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_volume(SessionHandle session, MeshHandle before, MeshHandle after, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_distance(SessionHandle session, MeshHandle before, MeshHandle after, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_distance(SessionHandle session, MeshHandle before, MeshHandle after, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_surface_distance(SessionHandle session, MeshHandle before, MeshHandle after, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_surface_distance(SessionHandle session, MeshHandle before, MeshHandle after, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_closed_volume(SessionHandle session, MeshHandle mesh, int close_rims, IntPtr volume_ml, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_closed_volume(SessionHandle session, MeshHandle mesh, int close_rims, IntPtr volume_ml, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_area(SessionHandle session, MeshHandle mesh, ref Zone zone, IntPtr area_mm2, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_area(SessionHandle session, MeshHandle mesh, ref Zone zone, IntPtr area_mm2, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_curvature(SessionHandle session, MeshHandle mesh, double radius_mm, int robust, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_curvature(SessionHandle session, MeshHandle mesh, double radius_mm, int robust, ref MeasureOptions options, out MeasurementHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_lengths(SessionHandle session, MeshHandle mesh, IntPtr pairs, ulong pair_count, IntPtr straight_mm, IntPtr geodesic_mm, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_lengths(SessionHandle session, MeshHandle mesh, IntPtr pairs, ulong pair_count, IntPtr straight_mm, IntPtr geodesic_mm, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_scan_volume(SessionHandle session, MeshHandle before, MeshHandle after, int carry, IntPtr direction, ref MeasureOptions options, IntPtr coverage, out MeasurementHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_scan_volume(SessionHandle session, MeshHandle before, MeshHandle after, int carry, IntPtr direction, ref MeasureOptions options, IntPtr coverage, out MeasurementHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measure_align(SessionHandle session, MeshHandle moving, MeshHandle target, ref Zone stable, ref ZoneAlignment info, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_align(SessionHandle session, MeshHandle moving, MeshHandle target, ref Zone stable, ref ZoneAlignment info, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measurement_get_zones(MeasurementHandle measurement, out ulong zone_count, IntPtr zones_disjoint, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_zones(MeasurementHandle measurement, out ulong zone_count, IntPtr zones_disjoint, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measurement_get_volume(MeasurementHandle measurement, int zone, ref ZoneVolume @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_volume(MeasurementHandle measurement, int zone, ref ZoneVolume @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measurement_get_distance(MeasurementHandle measurement, int zone, ref ZoneDistance @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_distance(MeasurementHandle measurement, int zone, ref ZoneDistance @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measurement_get_field(MeasurementHandle measurement, int field, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_field(MeasurementHandle measurement, int field, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_measurement_get_json(MeasurementHandle measurement, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_json(MeasurementHandle measurement, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_measurement_release(IntPtr measurement);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_measurement_release(IntPtr measurement);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_inspect(SessionHandle session, MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_inspect(SessionHandle session, MeshHandle mesh, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_clean(SessionHandle session, MeshHandle mesh, ulong min_triangles, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_clean(SessionHandle session, MeshHandle mesh, ulong min_triangles, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_transform(SessionHandle session, MeshHandle mesh, IntPtr matrix, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_transform(SessionHandle session, MeshHandle mesh, IntPtr matrix, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_turn_over(SessionHandle session, MeshHandle mesh, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_turn_over(SessionHandle session, MeshHandle mesh, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_decimate(SessionHandle session, MeshHandle mesh, ulong vertex_count, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_decimate(SessionHandle session, MeshHandle mesh, ulong vertex_count, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_mesh_check_same_unit(MeshHandle first, MeshHandle second, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_check_same_unit(MeshHandle first, MeshHandle second, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_train(SessionHandle session, byte[] dataset_path, int kind, int neutral_only, out RepresentationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_train(SessionHandle session, byte[] dataset_path, int kind, int neutral_only, out RepresentationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_representation_options_init(ref RepresentationOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_representation_options_init(ref RepresentationOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_train_with_options(SessionHandle session, byte[] dataset_path, int kind, ref RepresentationOptions options, out RepresentationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_train_with_options(SessionHandle session, byte[] dataset_path, int kind, ref RepresentationOptions options, out RepresentationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_load(SessionHandle session, byte[] path, out RepresentationHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_load(SessionHandle session, byte[] path, out RepresentationHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_save(SessionHandle session, RepresentationHandle representation, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_save(SessionHandle session, RepresentationHandle representation, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_get_counts(RepresentationHandle representation, out ulong vertex_count, out ulong channel_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_get_counts(RepresentationHandle representation, out ulong vertex_count, out ulong channel_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_encode(SessionHandle session, RepresentationHandle representation, MeshHandle face, IntPtr motion, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_encode(SessionHandle session, RepresentationHandle representation, MeshHandle face, IntPtr motion, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_representation_decode(SessionHandle session, RepresentationHandle representation, IntPtr features, ulong row_count, IntPtr motion, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_decode(SessionHandle session, RepresentationHandle representation, IntPtr features, ulong row_count, IntPtr motion, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_representation_retain(IntPtr representation);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_representation_retain(IntPtr representation);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_representation_release(IntPtr representation);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_representation_release(IntPtr representation);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_score_options_init(ref ScoreOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_score_options_init(ref ScoreOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_train(SessionHandle session, byte[] dataset_path, IntPtr grades, ulong grade_count, ref ScoreOptions options, out ScoreModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_train(SessionHandle session, byte[] dataset_path, IntPtr grades, ulong grade_count, ref ScoreOptions options, out ScoreModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_load(SessionHandle session, byte[] path, out ScoreModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_load(SessionHandle session, byte[] path, out ScoreModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_save(SessionHandle session, ScoreModelHandle model, byte[] path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_save(SessionHandle session, ScoreModelHandle model, byte[] path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_predict(SessionHandle session, ScoreModelHandle model, MeshHandle face, ref ScorePrediction @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_predict(SessionHandle session, ScoreModelHandle model, MeshHandle face, ref ScorePrediction @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_simulate(SessionHandle session, ScoreModelHandle model, IntPtr face, double target, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_simulate(SessionHandle session, ScoreModelHandle model, IntPtr face, double target, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_get_latent(ScoreModelHandle model, int component, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_get_latent(ScoreModelHandle model, int component, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_score_model_get_json(ScoreModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_get_json(ScoreModelHandle model, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_score_model_retain(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_score_model_retain(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_score_model_release(IntPtr model);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_score_model_release(IntPtr model);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_statistics_agreement(SessionHandle session, IntPtr ratings, ulong subject_count, uint rater_count, int grade_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_statistics_agreement(SessionHandle session, IntPtr ratings, ulong subject_count, uint rater_count, int grade_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_statistics_repeatability(SessionHandle session, IntPtr values, IntPtr subjects, ulong value_count, IntPtr blanks, ulong blank_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_statistics_repeatability(SessionHandle session, IntPtr values, IntPtr subjects, ulong value_count, IntPtr blanks, ulong blank_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_statistics_bland_altman(SessionHandle session, IntPtr first, IntPtr second, ulong value_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_statistics_bland_altman(SessionHandle session, IntPtr first, IntPtr second, ulong value_count, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_series_options_init(ref SeriesOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_series_options_init(ref SeriesOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralize_series(SessionHandle session, ExpressionModelHandle model, out MeshHandle faces, uint face_count, ref SeriesOptions options, out SeriesHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize_series(SessionHandle session, ExpressionModelHandle model, out MeshHandle faces, uint face_count, ref SeriesOptions options, out SeriesHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_series_get_mesh(SeriesHandle series, int index, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_series_get_mesh(SeriesHandle series, int index, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_series_get_json(SeriesHandle series, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_series_get_json(SeriesHandle series, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_series_release(IntPtr series);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_series_release(IntPtr series);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_study_options_init(ref StudyOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_study_options_init(ref StudyOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_create(SessionHandle session, out RegistrationHandle registrations, uint registration_count, IntPtr expressions, ref StudyOptions options, out StudyHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_create(SessionHandle session, out RegistrationHandle registrations, uint registration_count, IntPtr expressions, ref StudyOptions options, out StudyHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_create_from_meshes(SessionHandle session, out MeshHandle faces, uint face_count, ref ArrayView normal_sd, ref ArrayView weights, IntPtr expressions, ref StudyOptions options, out StudyHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_create_from_meshes(SessionHandle session, out MeshHandle faces, uint face_count, ref ArrayView normal_sd, ref ArrayView weights, IntPtr expressions, ref StudyOptions options, out StudyHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_counts(StudyHandle study, out ulong visit_count, out ulong zone_count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_counts(StudyHandle study, out ulong visit_count, out ulong zone_count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_zone_name(StudyHandle study, int zone, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_zone_name(StudyHandle study, int zone, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_expression(StudyHandle study, int visit, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_expression(StudyHandle study, int visit, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_mesh(StudyHandle study, int visit, int frame, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_mesh(StudyHandle study, int visit, int frame, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_field(StudyHandle study, int visit, int field, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_field(StudyHandle study, int visit, int field, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_distances(StudyHandle study, int first, int second, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_distances(StudyHandle study, int first, int second, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_alignment(StudyHandle study, int first, int second, ref ZoneAlignment @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_alignment(StudyHandle study, int first, int second, ref ZoneAlignment @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_change(StudyHandle study, int first, int second, int zone, ref StudyChange @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_change(StudyHandle study, int first, int second, int zone, ref StudyChange @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_study_get_json(StudyHandle study, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_json(StudyHandle study, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_study_retain(IntPtr study);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_study_retain(IntPtr study);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_study_release(IntPtr study);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_study_release(IntPtr study);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_template_check(SessionHandle session, MeshHandle template_mesh, IntPtr landmarks, int mirror, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_template_check(SessionHandle session, MeshHandle template_mesh, IntPtr landmarks, int mirror, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_train_options_init(ref TrainOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_train_options_init(ref TrainOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_train(SessionHandle session, byte[] dataset_path, ref TrainOptions options, out ExpressionModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_train(SessionHandle session, byte[] dataset_path, ref TrainOptions options, out ExpressionModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_shard_options_init(ref ShardOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_shard_options_init(ref ShardOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_shard_create(SessionHandle session, byte[] dataset_path, ref ShardOptions options, byte[] shard_path, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_shard_create(SessionHandle session, byte[] dataset_path, ref ShardOptions options, byte[] shard_path, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_expression_model_merge(SessionHandle session, IntPtr[] shard_paths, uint shard_count, ref TrainOptions options, out ExpressionModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_merge(SessionHandle session, IntPtr[] shard_paths, uint shard_count, ref TrainOptions options, out ExpressionModelHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_visits_options_init(ref VisitsOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_visits_options_init(ref VisitsOptions options, UIntPtr struct_size);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_neutralize_visits(SessionHandle session, ExpressionModelHandle model, out MeshHandle faces, uint face_count, ref VisitsOptions options, out VisitsHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize_visits(SessionHandle session, ExpressionModelHandle model, out MeshHandle faces, uint face_count, ref VisitsOptions options, out VisitsHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_visits_get_mesh(VisitsHandle visits, int index, out MeshHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_visits_get_mesh(VisitsHandle visits, int index, out MeshHandle @out, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_visits_get_expression(VisitsHandle visits, int index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_visits_get_expression(VisitsHandle visits, int index, IntPtr dst, ulong capacity, out ulong count, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial int mien_visits_get_removed_volume(VisitsHandle visits, int first, int second, ref Zone zone, IntPtr removed_ml, IntPtr sd_ml, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_visits_get_removed_volume(VisitsHandle visits, int first, int second, ref Zone zone, IntPtr removed_ml, IntPtr sd_ml, ref Error error);
#endif

#if NET7_0_OR_GREATER
        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]
        internal static partial void mien_visits_release(IntPtr visits);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_visits_release(IntPtr visits);
#endif
    }
}

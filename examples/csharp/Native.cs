// Structs and functions of the C headers. Written by abi/generate_bindings.py.
using System;
using System.Runtime.InteropServices;

namespace Mien.Native
{
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
        public double maxSeconds;
        public int copyFiles;
        public int reserved;
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
        public IntPtr scalesMm;
        public ulong scaleCount;
        public IntPtr levelCounts;
        public ulong levelCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ScanLandmark
    {
        public IntPtr name;
        public fixed double position[3];
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct AnthropometryOptions
    {
        public uint structSize;
        public uint reserved;
        public ArrayView placeSd;
        public ArrayView normalSd;
        public double slideCorrelationMm;
        public double normalCorrelationMm;
        public IntPtr norms;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct AnthropometricValue
    {
        public uint structSize;
        public int kind;
        public double value;
        public double sd;
        public double z;
        public double zSd;
        public double normMean;
        public double normSd;
        public ulong normPeople;
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
    internal unsafe struct AsymmetryOptions
    {
        public uint structSize;
        public int plane;
        public IntPtr zones;
        public ulong zoneCount;
        public IntPtr landmarks;
        public ArrayView normalSd;
        public double correlationLengthMm;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct MirrorPlane
    {
        public uint structSize;
        public int by;
        public ulong pairs;
        public fixed double normal[3];
        public fixed double centre[3];
        public double rmsMm;
        public double tiltSdRad;
        public double offsetSdMm;
        public double betweenRad;
        public double apartMm;
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
        public double maxDistanceMm;
        public double mutualMm;
        public double softMm;
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
    internal unsafe struct ExpectedError
    {
        public uint structSize;
        public int quality;
        public double expectedMm;
        public double lowMm;
        public double highMm;
        public double unseen;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct TieOptions
    {
        public uint structSize;
        public uint reserved;
        public double maxSlideMm;
        public double leastShare;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct BatchOptions
    {
        public uint structSize;
        public uint reserved;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
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
        public IntPtr treated;
        public ulong treatedCount;
        public double treatedMarginMm;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ZoneReading
    {
        public uint structSize;
        public int differ;
        public double probability;
        public double removedMm;
        public double removedMl;
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
        public IntPtr volumeZones;
        public ulong volumeZoneCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct FollowOptions
    {
        public uint structSize;
        public int rounds;
        public int maxVertices;
        public int maxScalarModes;
        public int maxPcaModes;
        public uint reserved;
        public double temporalMm;
        public double sigmaStartMm;
        public double sigmaEndMm;
        public double lostShare;
        public double unitToMm;
        public double focalX;
        public double focalY;
        public double centreX;
        public double centreY;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct FollowState
    {
        public uint structSize;
        public int state;
        public double share;
        public double residualMm;
        public double slideMm;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct GeodesicOptions
    {
        public uint structSize;
        public int heatBoundary;
        public double heatTimeFactor;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ModelFitOptions
    {
        public uint structSize;
        public int align;
        public double ridgeMm2;
        public ArrayView weights;
        public int scalarModes;
        public int vectorModes;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct NetworkOptions
    {
        public uint structSize;
        public uint reserved;
        public IntPtr cancel;
        public long bandLimit;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct NetworkEvaluationOptions
    {
        public uint structSize;
        public int neutralOnly;
        public int perceptual;
        public uint reserved;
        public IntPtr subjects;
        public ulong subjectCount;
        public IntPtr progress;
        public IntPtr progressUser;
        public IntPtr cancel;
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
        public int features;
        public uint reserved3;
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
        public int measureUnseen;
        public uint reservedEnd;
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

    internal static class Functions
    {
        internal const uint AbiVersion = 0;
        internal const string Version = "0.2.0";

#if MIEN_STATIC // linked into the program, as on iOS
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_status_name(int status);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint mien_version_number();
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_version_string();
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_build_id();
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_session_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_session_create(uint abiVersion, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_session_create_with_options(uint abiVersion, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_session_release(IntPtr session);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_cancel_create(IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_cancel_request(IntPtr cancel);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_cancel_release(IntPtr cancel);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_session_hash_file(IntPtr session, IntPtr path, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_mesh_arrays_init(IntPtr arrays, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_create(IntPtr session, IntPtr arrays, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_save(IntPtr session, IntPtr mesh, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_counts(IntPtr mesh, IntPtr vertexCount, IntPtr triangleCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_positions(IntPtr mesh, int dtype, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_triangles(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_colors(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint mien_mesh_format_count();
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_mesh_format_extension(uint format);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_mesh_format_description(uint format);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_format_writes(uint format);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_texture(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_texture_triangles(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_triangle_materials(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_material_counts(IntPtr mesh, IntPtr materialCount, IntPtr imageCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_material(IntPtr mesh, ulong material, IntPtr image, IntPtr red, IntPtr green, IntPtr blue, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_material_name(IntPtr mesh, ulong material, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_name(IntPtr mesh, ulong image, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_file(IntPtr mesh, ulong image, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_size(IntPtr mesh, ulong image, IntPtr width, IntPtr height, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_get_image_pixels(IntPtr session, IntPtr mesh, ulong image, ulong rowStrideBytes, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_save_targets(IntPtr session, IntPtr mesh, IntPtr targets, IntPtr names, ulong targetCount, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_load_target(IntPtr session, IntPtr path, IntPtr name, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_positions_view(IntPtr mesh, IntPtr data, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_mesh_retain(IntPtr mesh);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_mesh_release(IntPtr mesh);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_build(IntPtr session, IntPtr templateMesh, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_load_memory(IntPtr session, IntPtr data, ulong size, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_load_trusted(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_save(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_counts(IntPtr model, IntPtr vertexCount, IntPtr scalarModes, IntPtr vectorModes, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_json(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_variance(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_sample(IntPtr session, IntPtr model, ulong seed, ulong index, double strength, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_condition(IntPtr session, IntPtr model, IntPtr observations, ulong observationCount, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_tune_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_tune(IntPtr session, IntPtr templateMesh, IntPtr dataset, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_tuning_get_json(IntPtr tuning, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_tuning_release(IntPtr tuning);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_model_mesh(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_retain(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_release(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_create(IntPtr landmarks, ulong landmarkCount, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_landmarks(IntPtr model, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_match(IntPtr landmarks, IntPtr model, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_on_mesh(IntPtr landmarks, IntPtr mesh, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_save(IntPtr session, IntPtr landmarks, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_counts(IntPtr landmarks, IntPtr count, IntPtr pickedCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_name(IntPtr landmarks, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_mark(IntPtr landmarks, ulong index, IntPtr where, IntPtr position, IntPtr vertex, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_get_json(IntPtr landmarks, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_landmarks_retain(IntPtr landmarks);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_landmarks_release(IntPtr landmarks);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_create(IntPtr zones, ulong zoneCount, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_get_zones(IntPtr model, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_save(IntPtr session, IntPtr zones, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_get_count(IntPtr zones, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_get_name(IntPtr zones, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_zones_get_vertices(IntPtr zones, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_zones_retain(IntPtr zones);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_zones_release(IntPtr zones);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_anthropometry_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_landmarks_add_profile(IntPtr landmarks, IntPtr templateMesh, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_anthropometry(IntPtr session, IntPtr face, IntPtr landmarks, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_anthropometry_get_counts(IntPtr anthropometry, IntPtr count, IntPtr knownCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_anthropometry_get_name(IntPtr anthropometry, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_anthropometry_get_value(IntPtr anthropometry, ulong index, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_anthropometry_get_reason(IntPtr anthropometry, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_anthropometry_get_json(IntPtr anthropometry, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_anthropometry_release(IntPtr anthropometry);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_norms_create(IntPtr session, IntPtr datasetPath, IntPtr landmarks, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_norms_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_norms_save(IntPtr session, IntPtr norms, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_norms_get_json(IntPtr norms, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_norms_release(IntPtr norms);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_measure_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_volume(IntPtr session, IntPtr before, IntPtr after, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_distance(IntPtr session, IntPtr before, IntPtr after, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_surface_distance(IntPtr session, IntPtr before, IntPtr after, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_closed_volume(IntPtr session, IntPtr mesh, int closeRims, IntPtr volumeMl, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_area(IntPtr session, IntPtr mesh, IntPtr zone, IntPtr areaMm2, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_curvature(IntPtr session, IntPtr mesh, double radiusMm, int robust, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_lengths(IntPtr session, IntPtr mesh, IntPtr pairs, ulong pairCount, IntPtr straightMm, IntPtr geodesicMm, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_scan_volume(IntPtr session, IntPtr before, IntPtr after, int carry, IntPtr direction, IntPtr options, IntPtr coverage, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_align(IntPtr session, IntPtr moving, IntPtr target, IntPtr stable, IntPtr info, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_zones(IntPtr measurement, IntPtr zoneCount, IntPtr zonesDisjoint, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_volume(IntPtr measurement, int zone, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_distance(IntPtr measurement, int zone, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_field(IntPtr measurement, int field, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_json(IntPtr measurement, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_measurement_release(IntPtr measurement);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_asymmetry_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_asymmetry(IntPtr session, IntPtr face, IntPtr templateMesh, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measurement_get_mirror_plane(IntPtr measurement, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_register_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_register(IntPtr session, IntPtr model, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_registration_mesh(IntPtr registration);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_verdict(IntPtr registration, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_expected_error(IntPtr registration, IntPtr zone, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_field(IntPtr registration, int field, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_correspondence(IntPtr registration, IntPtr triangles, IntPtr barycentric, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_motion(IntPtr registration, IntPtr matrix, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_json(IntPtr registration, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_save(IntPtr session, IntPtr registration, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_create(IntPtr session, IntPtr mesh, IntPtr weight, IntPtr residual, IntPtr standardDeviation, int quality, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_tie_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_tie(IntPtr session, IntPtr model, IntPtr reference, IntPtr referenceScan, IntPtr registration, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_registration_retain(IntPtr registration);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_registration_release(IntPtr registration);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_surface_transfer_points(IntPtr session, IntPtr surface, IntPtr points, double maxDistanceMm, IntPtr triangles, IntPtr barycentric, IntPtr positions, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_surface_transfer_zone(IntPtr session, IntPtr from, IntPtr vertices, ulong vertexCount, IntPtr to, double maxDistanceMm, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_surface_transfer_json(IntPtr session, IntPtr model, IntPtr fitted, IntPtr scan, int what, double maxDistanceMm, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_batch_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_ready_scan_create(IntPtr session, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_ready_scan_register(IntPtr session, IntPtr model, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_ready_scan_retain(IntPtr scan);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_ready_scan_release(IntPtr scan);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_batch_create(IntPtr session, IntPtr model, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_batch_add(IntPtr session, IntPtr batch, IntPtr scan, IntPtr options, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_batch_run(IntPtr session, IntPtr batch, IntPtr options, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_batch_get_counts(IntPtr batch, IntPtr scanCount, IntPtr runCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_batch_get_registration(IntPtr batch, int index, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_batch_retain(IntPtr batch);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_batch_release(IntPtr batch);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_spectral_basis_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_build(IntPtr session, IntPtr mean, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_save(IntPtr session, IntPtr basis, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_counts(IntPtr basis, IntPtr vertexCount, IntPtr modeCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_eigenvalues(IntPtr basis, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_spectral_basis_retain(IntPtr basis);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_spectral_basis_release(IntPtr basis);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_split(IntPtr session, IntPtr basis, IntPtr face, ulong k, IntPtr low, IntPtr high, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_assemble(IntPtr session, IntPtr basis, IntPtr low, IntPtr high, ulong k, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_edit(IntPtr session, IntPtr basis, IntPtr face, IntPtr limits, ulong limitCount, IntPtr gains, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_mix(IntPtr session, IntPtr basis, IntPtr first, IntPtr second, IntPtr limits, ulong limitCount, IntPtr weights, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_vector(IntPtr basis, ulong mode, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_mass(IntPtr basis, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_basis_get_mean(IntPtr basis, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_project(IntPtr session, IntPtr basis, IntPtr face, ulong modeCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_spectral_synthesize(IntPtr session, IntPtr basis, IntPtr coefficients, ulong rowCount, ulong firstMode, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_metric(IntPtr session, int metric, IntPtr reference, IntPtr other, IntPtr value, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_metric_field(IntPtr session, int metric, IntPtr reference, IntPtr other, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_metric_roughness(IntPtr session, IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_transfer_expression(IntPtr session, IntPtr sourceNeutral, IntPtr sourceExpression, IntPtr targetNeutral, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_blendshape_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_train(IntPtr session, IntPtr datasetPath, IntPtr expression, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_save(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_get_mean(IntPtr model, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_predict(IntPtr session, IntPtr model, IntPtr basis, ulong k, IntPtr neutral, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_blendshape_model_search(IntPtr session, IntPtr model, IntPtr basis, IntPtr datasetPath, IntPtr expression, IntPtr candidates, uint candidateCount, IntPtr options, IntPtr choices, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_blendshape_model_retain(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_blendshape_model_release(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_dataset_writer_create(IntPtr session, IntPtr topology, IntPtr expressionNames, uint expressionCount, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_dataset_writer_add(IntPtr writer, IntPtr positions, int subject, int expression, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_dataset_writer_save(IntPtr session, IntPtr writer, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_dataset_writer_release(IntPtr writer);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_load_memory(IntPtr session, IntPtr data, ulong size, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_save(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_expression_model_retain(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_expression_model_release(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_get_counts(IntPtr model, IntPtr vertexCount, IntPtr identityModes, IntPtr expressionModes, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_get_json(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_synthesize(IntPtr session, IntPtr model, IntPtr identity, IntPtr expression, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_sample(IntPtr session, IntPtr model, ulong seed, IntPtr expression, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_neutralize_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize(IntPtr session, IntPtr model, IntPtr fitted, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize_mesh(IntPtr session, IntPtr model, IntPtr face, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr mien_neutralization_mesh(IntPtr neutralization);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_counts(IntPtr neutralization, IntPtr vertexCount, IntPtr identityModes, IntPtr expressionModes, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_coordinates(IntPtr neutralization, IntPtr identity, IntPtr expression, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_uncertainty(IntPtr neutralization, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_reading(IntPtr neutralization, int reading, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_get_json(IntPtr neutralization, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_neutralization_release(IntPtr neutralization);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralization_apply_to_scan(IntPtr session, IntPtr neutralization, IntPtr scan, double maxDistanceMm, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_transfer(IntPtr session, IntPtr model, IntPtr source, IntPtr target, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_evaluate_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_evaluate_neutralization(IntPtr session, IntPtr model, IntPtr datasetPath, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_evaluation_get_json(IntPtr evaluation, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_evaluation_release(IntPtr evaluation);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_follow_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_follower_create(IntPtr session, IntPtr model, IntPtr start, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_follower_fit(IntPtr session, IntPtr follower, IntPtr points, int width, int height, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_follower_get_mesh(IntPtr follower, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_follower_get_motion(IntPtr follower, IntPtr matrix, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_follower_retain(IntPtr follower);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_follower_release(IntPtr follower);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_geodesic_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_geodesic(IntPtr session, IntPtr mesh, IntPtr sources, ulong sourceCount, IntPtr options, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_build_quadric(IntPtr session, IntPtr mesh, uint levelCount, double factor, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_build_connectivity(IntPtr session, IntPtr mesh, uint levelCount, uint stride, uint radius, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_save(IntPtr session, IntPtr hierarchy, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_get_level_count(IntPtr hierarchy, IntPtr levelCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_get_level(IntPtr hierarchy, uint level, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_apply(IntPtr hierarchy, uint level, int direction, IntPtr values, ulong rowCount, ulong channelCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_hierarchy_get_map(IntPtr hierarchy, uint level, int direction, IntPtr rows, IntPtr columns, IntPtr values, ulong capacity, IntPtr count, IntPtr rowCount, IntPtr columnCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_hierarchy_retain(IntPtr hierarchy);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_hierarchy_release(IntPtr hierarchy);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_inspect(IntPtr session, IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_clean(IntPtr session, IntPtr mesh, ulong minTriangles, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_transform(IntPtr session, IntPtr mesh, IntPtr matrix, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_turn_over(IntPtr session, IntPtr mesh, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_decimate(IntPtr session, IntPtr mesh, ulong vertexCount, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_mesh_check_same_unit(IntPtr first, IntPtr second, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_model_fit_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_fit(IntPtr session, IntPtr model, IntPtr target, IntPtr options, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_model_synthesize(IntPtr session, IntPtr model, IntPtr coefficients, ulong coefficientCount, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_registration_get_coefficients(IntPtr session, IntPtr registration, IntPtr model, double ridgeMm2, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_network_evaluation_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_network_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_load_memory(IntPtr session, IntPtr data, ulong size, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_get_counts(IntPtr network, IntPtr vertexCount, IntPtr codeCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_get_json(IntPtr network, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_get_mean(IntPtr network, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_encode(IntPtr session, IntPtr network, IntPtr face, IntPtr options, IntPtr motion, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_decode(IntPtr session, IntPtr network, IntPtr code, ulong codeCount, IntPtr motion, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_apply(IntPtr session, IntPtr network, IntPtr face, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_get_bands(IntPtr network, IntPtr lowCodeCount, IntPtr bandLimit, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_mix(IntPtr session, IntPtr network, IntPtr a, IntPtr b, double lowWeight, double highWeight, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_sample(IntPtr network, ulong seed, ulong number, double spread, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_network_evaluate(IntPtr session, IntPtr network, IntPtr datasetPath, IntPtr options, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_network_retain(IntPtr network);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_network_release(IntPtr network);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_train(IntPtr session, IntPtr datasetPath, int kind, int neutralOnly, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_representation_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_train_with_options(IntPtr session, IntPtr datasetPath, int kind, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_save(IntPtr session, IntPtr representation, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_get_counts(IntPtr representation, IntPtr vertexCount, IntPtr channelCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_encode(IntPtr session, IntPtr representation, IntPtr face, IntPtr motion, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_representation_decode(IntPtr session, IntPtr representation, IntPtr features, ulong rowCount, IntPtr motion, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_representation_retain(IntPtr representation);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_representation_release(IntPtr representation);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_score_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_train(IntPtr session, IntPtr datasetPath, IntPtr grades, ulong gradeCount, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_load(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_save(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_predict(IntPtr session, IntPtr model, IntPtr face, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_simulate(IntPtr session, IntPtr model, IntPtr face, double target, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_get_latent(IntPtr model, int component, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_score_model_get_json(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_score_model_retain(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_score_model_release(IntPtr model);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_statistics_agreement(IntPtr session, IntPtr ratings, ulong subjectCount, uint raterCount, int gradeCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_statistics_repeatability(IntPtr session, IntPtr values, IntPtr subjects, ulong valueCount, IntPtr blanks, ulong blankCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_statistics_bland_altman(IntPtr session, IntPtr first, IntPtr second, ulong valueCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_series_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize_series(IntPtr session, IntPtr model, IntPtr faces, uint faceCount, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_series_get_mesh(IntPtr series, int index, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_series_get_json(IntPtr series, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_series_release(IntPtr series);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_study_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_create(IntPtr session, IntPtr registrations, uint registrationCount, IntPtr expressions, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_create_from_meshes(IntPtr session, IntPtr faces, uint faceCount, IntPtr normalSd, IntPtr weights, IntPtr expressions, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_counts(IntPtr study, IntPtr visitCount, IntPtr zoneCount, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_zone_name(IntPtr study, int zone, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_expression(IntPtr study, int visit, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_mesh(IntPtr study, int visit, int frame, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_field(IntPtr study, int visit, int field, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_distances(IntPtr study, int first, int second, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_alignment(IntPtr study, int first, int second, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_change(IntPtr study, int first, int second, int zone, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_study_get_json(IntPtr study, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_study_retain(IntPtr study);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_study_release(IntPtr study);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_template_check(IntPtr session, IntPtr templateMesh, IntPtr landmarks, int mirror, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_train_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_train(IntPtr session, IntPtr datasetPath, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_shard_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_shard_create(IntPtr session, IntPtr datasetPath, IntPtr options, IntPtr shardPath, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_merge(IntPtr session, IntPtr shardPaths, uint shardCount, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_visits_options_init(IntPtr options, UIntPtr structSize);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_neutralize_visits(IntPtr session, IntPtr model, IntPtr faces, uint faceCount, IntPtr options, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_visits_get_mesh(IntPtr visits, int index, IntPtr @out, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_visits_get_expression(IntPtr visits, int index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_visits_get_removed_volume(IntPtr visits, int first, int second, IntPtr zone, IntPtr removedMl, IntPtr sdMl, IntPtr error);
        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_visits_release(IntPtr visits);
#else
        static Functions() { } // at the first use and not before: Library.Need() has looked then
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_status_name_function(int status);
        internal static readonly mien_status_name_function mien_status_name = Library.Function<mien_status_name_function>("mien_status_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate uint mien_version_number_function();
        internal static readonly mien_version_number_function mien_version_number = Library.Function<mien_version_number_function>("mien_version_number");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_version_string_function();
        internal static readonly mien_version_string_function mien_version_string = Library.Function<mien_version_string_function>("mien_version_string");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_build_id_function();
        internal static readonly mien_build_id_function mien_build_id = Library.Function<mien_build_id_function>("mien_build_id");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_session_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_session_options_init_function mien_session_options_init = Library.Function<mien_session_options_init_function>("mien_session_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_session_create_function(uint abiVersion, IntPtr @out, IntPtr error);
        internal static readonly mien_session_create_function mien_session_create = Library.Function<mien_session_create_function>("mien_session_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_session_create_with_options_function(uint abiVersion, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_session_create_with_options_function mien_session_create_with_options = Library.Function<mien_session_create_with_options_function>("mien_session_create_with_options");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_session_release_function(IntPtr session);
        internal static readonly mien_session_release_function mien_session_release = Library.Function<mien_session_release_function>("mien_session_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_cancel_create_function(IntPtr @out, IntPtr error);
        internal static readonly mien_cancel_create_function mien_cancel_create = Library.Function<mien_cancel_create_function>("mien_cancel_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_cancel_request_function(IntPtr cancel);
        internal static readonly mien_cancel_request_function mien_cancel_request = Library.Function<mien_cancel_request_function>("mien_cancel_request");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_cancel_release_function(IntPtr cancel);
        internal static readonly mien_cancel_release_function mien_cancel_release = Library.Function<mien_cancel_release_function>("mien_cancel_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_session_hash_file_function(IntPtr session, IntPtr path, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_session_hash_file_function mien_session_hash_file = Library.Function<mien_session_hash_file_function>("mien_session_hash_file");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_mesh_arrays_init_function(IntPtr arrays, UIntPtr structSize);
        internal static readonly mien_mesh_arrays_init_function mien_mesh_arrays_init = Library.Function<mien_mesh_arrays_init_function>("mien_mesh_arrays_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_create_function(IntPtr session, IntPtr arrays, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_create_function mien_mesh_create = Library.Function<mien_mesh_create_function>("mien_mesh_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_load_function mien_mesh_load = Library.Function<mien_mesh_load_function>("mien_mesh_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_save_function(IntPtr session, IntPtr mesh, IntPtr path, IntPtr error);
        internal static readonly mien_mesh_save_function mien_mesh_save = Library.Function<mien_mesh_save_function>("mien_mesh_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_counts_function(IntPtr mesh, IntPtr vertexCount, IntPtr triangleCount, IntPtr error);
        internal static readonly mien_mesh_get_counts_function mien_mesh_get_counts = Library.Function<mien_mesh_get_counts_function>("mien_mesh_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_positions_function(IntPtr mesh, int dtype, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_positions_function mien_mesh_get_positions = Library.Function<mien_mesh_get_positions_function>("mien_mesh_get_positions");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_triangles_function(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_triangles_function mien_mesh_get_triangles = Library.Function<mien_mesh_get_triangles_function>("mien_mesh_get_triangles");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_colors_function(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_colors_function mien_mesh_get_colors = Library.Function<mien_mesh_get_colors_function>("mien_mesh_get_colors");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate uint mien_mesh_format_count_function();
        internal static readonly mien_mesh_format_count_function mien_mesh_format_count = Library.Function<mien_mesh_format_count_function>("mien_mesh_format_count");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_mesh_format_extension_function(uint format);
        internal static readonly mien_mesh_format_extension_function mien_mesh_format_extension = Library.Function<mien_mesh_format_extension_function>("mien_mesh_format_extension");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_mesh_format_description_function(uint format);
        internal static readonly mien_mesh_format_description_function mien_mesh_format_description = Library.Function<mien_mesh_format_description_function>("mien_mesh_format_description");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_format_writes_function(uint format);
        internal static readonly mien_mesh_format_writes_function mien_mesh_format_writes = Library.Function<mien_mesh_format_writes_function>("mien_mesh_format_writes");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_texture_function(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_texture_function mien_mesh_get_texture = Library.Function<mien_mesh_get_texture_function>("mien_mesh_get_texture");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_texture_triangles_function(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_texture_triangles_function mien_mesh_get_texture_triangles = Library.Function<mien_mesh_get_texture_triangles_function>("mien_mesh_get_texture_triangles");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_triangle_materials_function(IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_triangle_materials_function mien_mesh_get_triangle_materials = Library.Function<mien_mesh_get_triangle_materials_function>("mien_mesh_get_triangle_materials");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_material_counts_function(IntPtr mesh, IntPtr materialCount, IntPtr imageCount, IntPtr error);
        internal static readonly mien_mesh_get_material_counts_function mien_mesh_get_material_counts = Library.Function<mien_mesh_get_material_counts_function>("mien_mesh_get_material_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_material_function(IntPtr mesh, ulong material, IntPtr image, IntPtr red, IntPtr green, IntPtr blue, IntPtr error);
        internal static readonly mien_mesh_get_material_function mien_mesh_get_material = Library.Function<mien_mesh_get_material_function>("mien_mesh_get_material");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_material_name_function(IntPtr mesh, ulong material, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_material_name_function mien_mesh_get_material_name = Library.Function<mien_mesh_get_material_name_function>("mien_mesh_get_material_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_image_name_function(IntPtr mesh, ulong image, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_image_name_function mien_mesh_get_image_name = Library.Function<mien_mesh_get_image_name_function>("mien_mesh_get_image_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_image_file_function(IntPtr mesh, ulong image, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_image_file_function mien_mesh_get_image_file = Library.Function<mien_mesh_get_image_file_function>("mien_mesh_get_image_file");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_image_size_function(IntPtr mesh, ulong image, IntPtr width, IntPtr height, IntPtr error);
        internal static readonly mien_mesh_get_image_size_function mien_mesh_get_image_size = Library.Function<mien_mesh_get_image_size_function>("mien_mesh_get_image_size");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_get_image_pixels_function(IntPtr session, IntPtr mesh, ulong image, ulong rowStrideBytes, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_get_image_pixels_function mien_mesh_get_image_pixels = Library.Function<mien_mesh_get_image_pixels_function>("mien_mesh_get_image_pixels");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_save_targets_function(IntPtr session, IntPtr mesh, IntPtr targets, IntPtr names, ulong targetCount, IntPtr path, IntPtr error);
        internal static readonly mien_mesh_save_targets_function mien_mesh_save_targets = Library.Function<mien_mesh_save_targets_function>("mien_mesh_save_targets");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_load_target_function(IntPtr session, IntPtr path, IntPtr name, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_load_target_function mien_mesh_load_target = Library.Function<mien_mesh_load_target_function>("mien_mesh_load_target");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_positions_view_function(IntPtr mesh, IntPtr data, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_positions_view_function mien_mesh_positions_view = Library.Function<mien_mesh_positions_view_function>("mien_mesh_positions_view");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_mesh_retain_function(IntPtr mesh);
        internal static readonly mien_mesh_retain_function mien_mesh_retain = Library.Function<mien_mesh_retain_function>("mien_mesh_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_mesh_release_function(IntPtr mesh);
        internal static readonly mien_mesh_release_function mien_mesh_release = Library.Function<mien_mesh_release_function>("mien_mesh_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_model_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_model_options_init_function mien_model_options_init = Library.Function<mien_model_options_init_function>("mien_model_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_build_function(IntPtr session, IntPtr templateMesh, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_model_build_function mien_model_build = Library.Function<mien_model_build_function>("mien_model_build");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_model_load_function mien_model_load = Library.Function<mien_model_load_function>("mien_model_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_load_memory_function(IntPtr session, IntPtr data, ulong size, IntPtr @out, IntPtr error);
        internal static readonly mien_model_load_memory_function mien_model_load_memory = Library.Function<mien_model_load_memory_function>("mien_model_load_memory");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_load_trusted_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_model_load_trusted_function mien_model_load_trusted = Library.Function<mien_model_load_trusted_function>("mien_model_load_trusted");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_save_function(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        internal static readonly mien_model_save_function mien_model_save = Library.Function<mien_model_save_function>("mien_model_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_get_counts_function(IntPtr model, IntPtr vertexCount, IntPtr scalarModes, IntPtr vectorModes, IntPtr error);
        internal static readonly mien_model_get_counts_function mien_model_get_counts = Library.Function<mien_model_get_counts_function>("mien_model_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_get_json_function(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_model_get_json_function mien_model_get_json = Library.Function<mien_model_get_json_function>("mien_model_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_get_variance_function(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_model_get_variance_function mien_model_get_variance = Library.Function<mien_model_get_variance_function>("mien_model_get_variance");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_sample_function(IntPtr session, IntPtr model, ulong seed, ulong index, double strength, IntPtr @out, IntPtr error);
        internal static readonly mien_model_sample_function mien_model_sample = Library.Function<mien_model_sample_function>("mien_model_sample");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_condition_function(IntPtr session, IntPtr model, IntPtr observations, ulong observationCount, IntPtr @out, IntPtr error);
        internal static readonly mien_model_condition_function mien_model_condition = Library.Function<mien_model_condition_function>("mien_model_condition");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_tune_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_tune_options_init_function mien_tune_options_init = Library.Function<mien_tune_options_init_function>("mien_tune_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_tune_function(IntPtr session, IntPtr templateMesh, IntPtr dataset, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_model_tune_function mien_model_tune = Library.Function<mien_model_tune_function>("mien_model_tune");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_tuning_get_json_function(IntPtr tuning, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_tuning_get_json_function mien_tuning_get_json = Library.Function<mien_tuning_get_json_function>("mien_tuning_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_tuning_release_function(IntPtr tuning);
        internal static readonly mien_tuning_release_function mien_tuning_release = Library.Function<mien_tuning_release_function>("mien_tuning_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_model_mesh_function(IntPtr model);
        internal static readonly mien_model_mesh_function mien_model_mesh = Library.Function<mien_model_mesh_function>("mien_model_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_model_retain_function(IntPtr model);
        internal static readonly mien_model_retain_function mien_model_retain = Library.Function<mien_model_retain_function>("mien_model_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_model_release_function(IntPtr model);
        internal static readonly mien_model_release_function mien_model_release = Library.Function<mien_model_release_function>("mien_model_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_landmarks_load_function mien_landmarks_load = Library.Function<mien_landmarks_load_function>("mien_landmarks_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_create_function(IntPtr landmarks, ulong landmarkCount, IntPtr @out, IntPtr error);
        internal static readonly mien_landmarks_create_function mien_landmarks_create = Library.Function<mien_landmarks_create_function>("mien_landmarks_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_get_landmarks_function(IntPtr model, IntPtr @out, IntPtr error);
        internal static readonly mien_model_get_landmarks_function mien_model_get_landmarks = Library.Function<mien_model_get_landmarks_function>("mien_model_get_landmarks");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_match_function(IntPtr landmarks, IntPtr model, IntPtr @out, IntPtr error);
        internal static readonly mien_landmarks_match_function mien_landmarks_match = Library.Function<mien_landmarks_match_function>("mien_landmarks_match");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_on_mesh_function(IntPtr landmarks, IntPtr mesh, IntPtr @out, IntPtr error);
        internal static readonly mien_landmarks_on_mesh_function mien_landmarks_on_mesh = Library.Function<mien_landmarks_on_mesh_function>("mien_landmarks_on_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_save_function(IntPtr session, IntPtr landmarks, IntPtr path, IntPtr error);
        internal static readonly mien_landmarks_save_function mien_landmarks_save = Library.Function<mien_landmarks_save_function>("mien_landmarks_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_get_counts_function(IntPtr landmarks, IntPtr count, IntPtr pickedCount, IntPtr error);
        internal static readonly mien_landmarks_get_counts_function mien_landmarks_get_counts = Library.Function<mien_landmarks_get_counts_function>("mien_landmarks_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_get_name_function(IntPtr landmarks, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_landmarks_get_name_function mien_landmarks_get_name = Library.Function<mien_landmarks_get_name_function>("mien_landmarks_get_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_get_mark_function(IntPtr landmarks, ulong index, IntPtr where, IntPtr position, IntPtr vertex, IntPtr error);
        internal static readonly mien_landmarks_get_mark_function mien_landmarks_get_mark = Library.Function<mien_landmarks_get_mark_function>("mien_landmarks_get_mark");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_get_json_function(IntPtr landmarks, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_landmarks_get_json_function mien_landmarks_get_json = Library.Function<mien_landmarks_get_json_function>("mien_landmarks_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_landmarks_retain_function(IntPtr landmarks);
        internal static readonly mien_landmarks_retain_function mien_landmarks_retain = Library.Function<mien_landmarks_retain_function>("mien_landmarks_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_landmarks_release_function(IntPtr landmarks);
        internal static readonly mien_landmarks_release_function mien_landmarks_release = Library.Function<mien_landmarks_release_function>("mien_landmarks_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_zones_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_zones_load_function mien_zones_load = Library.Function<mien_zones_load_function>("mien_zones_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_zones_create_function(IntPtr zones, ulong zoneCount, IntPtr @out, IntPtr error);
        internal static readonly mien_zones_create_function mien_zones_create = Library.Function<mien_zones_create_function>("mien_zones_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_get_zones_function(IntPtr model, IntPtr @out, IntPtr error);
        internal static readonly mien_model_get_zones_function mien_model_get_zones = Library.Function<mien_model_get_zones_function>("mien_model_get_zones");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_zones_save_function(IntPtr session, IntPtr zones, IntPtr path, IntPtr error);
        internal static readonly mien_zones_save_function mien_zones_save = Library.Function<mien_zones_save_function>("mien_zones_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_zones_get_count_function(IntPtr zones, IntPtr count, IntPtr error);
        internal static readonly mien_zones_get_count_function mien_zones_get_count = Library.Function<mien_zones_get_count_function>("mien_zones_get_count");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_zones_get_name_function(IntPtr zones, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_zones_get_name_function mien_zones_get_name = Library.Function<mien_zones_get_name_function>("mien_zones_get_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_zones_get_vertices_function(IntPtr zones, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_zones_get_vertices_function mien_zones_get_vertices = Library.Function<mien_zones_get_vertices_function>("mien_zones_get_vertices");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_zones_retain_function(IntPtr zones);
        internal static readonly mien_zones_retain_function mien_zones_retain = Library.Function<mien_zones_retain_function>("mien_zones_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_zones_release_function(IntPtr zones);
        internal static readonly mien_zones_release_function mien_zones_release = Library.Function<mien_zones_release_function>("mien_zones_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_anthropometry_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_anthropometry_options_init_function mien_anthropometry_options_init = Library.Function<mien_anthropometry_options_init_function>("mien_anthropometry_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_landmarks_add_profile_function(IntPtr landmarks, IntPtr templateMesh, IntPtr @out, IntPtr error);
        internal static readonly mien_landmarks_add_profile_function mien_landmarks_add_profile = Library.Function<mien_landmarks_add_profile_function>("mien_landmarks_add_profile");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_anthropometry_function(IntPtr session, IntPtr face, IntPtr landmarks, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_anthropometry_function mien_measure_anthropometry = Library.Function<mien_measure_anthropometry_function>("mien_measure_anthropometry");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_anthropometry_get_counts_function(IntPtr anthropometry, IntPtr count, IntPtr knownCount, IntPtr error);
        internal static readonly mien_anthropometry_get_counts_function mien_anthropometry_get_counts = Library.Function<mien_anthropometry_get_counts_function>("mien_anthropometry_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_anthropometry_get_name_function(IntPtr anthropometry, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_anthropometry_get_name_function mien_anthropometry_get_name = Library.Function<mien_anthropometry_get_name_function>("mien_anthropometry_get_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_anthropometry_get_value_function(IntPtr anthropometry, ulong index, IntPtr @out, IntPtr error);
        internal static readonly mien_anthropometry_get_value_function mien_anthropometry_get_value = Library.Function<mien_anthropometry_get_value_function>("mien_anthropometry_get_value");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_anthropometry_get_reason_function(IntPtr anthropometry, ulong index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_anthropometry_get_reason_function mien_anthropometry_get_reason = Library.Function<mien_anthropometry_get_reason_function>("mien_anthropometry_get_reason");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_anthropometry_get_json_function(IntPtr anthropometry, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_anthropometry_get_json_function mien_anthropometry_get_json = Library.Function<mien_anthropometry_get_json_function>("mien_anthropometry_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_anthropometry_release_function(IntPtr anthropometry);
        internal static readonly mien_anthropometry_release_function mien_anthropometry_release = Library.Function<mien_anthropometry_release_function>("mien_anthropometry_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_norms_create_function(IntPtr session, IntPtr datasetPath, IntPtr landmarks, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_norms_create_function mien_norms_create = Library.Function<mien_norms_create_function>("mien_norms_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_norms_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_norms_load_function mien_norms_load = Library.Function<mien_norms_load_function>("mien_norms_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_norms_save_function(IntPtr session, IntPtr norms, IntPtr path, IntPtr error);
        internal static readonly mien_norms_save_function mien_norms_save = Library.Function<mien_norms_save_function>("mien_norms_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_norms_get_json_function(IntPtr norms, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_norms_get_json_function mien_norms_get_json = Library.Function<mien_norms_get_json_function>("mien_norms_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_norms_release_function(IntPtr norms);
        internal static readonly mien_norms_release_function mien_norms_release = Library.Function<mien_norms_release_function>("mien_norms_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_measure_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_measure_options_init_function mien_measure_options_init = Library.Function<mien_measure_options_init_function>("mien_measure_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_volume_function(IntPtr session, IntPtr before, IntPtr after, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_volume_function mien_measure_volume = Library.Function<mien_measure_volume_function>("mien_measure_volume");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_distance_function(IntPtr session, IntPtr before, IntPtr after, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_distance_function mien_measure_distance = Library.Function<mien_measure_distance_function>("mien_measure_distance");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_surface_distance_function(IntPtr session, IntPtr before, IntPtr after, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_surface_distance_function mien_measure_surface_distance = Library.Function<mien_measure_surface_distance_function>("mien_measure_surface_distance");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_closed_volume_function(IntPtr session, IntPtr mesh, int closeRims, IntPtr volumeMl, IntPtr error);
        internal static readonly mien_measure_closed_volume_function mien_measure_closed_volume = Library.Function<mien_measure_closed_volume_function>("mien_measure_closed_volume");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_area_function(IntPtr session, IntPtr mesh, IntPtr zone, IntPtr areaMm2, IntPtr error);
        internal static readonly mien_measure_area_function mien_measure_area = Library.Function<mien_measure_area_function>("mien_measure_area");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_curvature_function(IntPtr session, IntPtr mesh, double radiusMm, int robust, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_curvature_function mien_measure_curvature = Library.Function<mien_measure_curvature_function>("mien_measure_curvature");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_lengths_function(IntPtr session, IntPtr mesh, IntPtr pairs, ulong pairCount, IntPtr straightMm, IntPtr geodesicMm, IntPtr error);
        internal static readonly mien_measure_lengths_function mien_measure_lengths = Library.Function<mien_measure_lengths_function>("mien_measure_lengths");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_scan_volume_function(IntPtr session, IntPtr before, IntPtr after, int carry, IntPtr direction, IntPtr options, IntPtr coverage, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_scan_volume_function mien_measure_scan_volume = Library.Function<mien_measure_scan_volume_function>("mien_measure_scan_volume");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_align_function(IntPtr session, IntPtr moving, IntPtr target, IntPtr stable, IntPtr info, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_align_function mien_measure_align = Library.Function<mien_measure_align_function>("mien_measure_align");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measurement_get_zones_function(IntPtr measurement, IntPtr zoneCount, IntPtr zonesDisjoint, IntPtr error);
        internal static readonly mien_measurement_get_zones_function mien_measurement_get_zones = Library.Function<mien_measurement_get_zones_function>("mien_measurement_get_zones");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measurement_get_volume_function(IntPtr measurement, int zone, IntPtr @out, IntPtr error);
        internal static readonly mien_measurement_get_volume_function mien_measurement_get_volume = Library.Function<mien_measurement_get_volume_function>("mien_measurement_get_volume");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measurement_get_distance_function(IntPtr measurement, int zone, IntPtr @out, IntPtr error);
        internal static readonly mien_measurement_get_distance_function mien_measurement_get_distance = Library.Function<mien_measurement_get_distance_function>("mien_measurement_get_distance");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measurement_get_field_function(IntPtr measurement, int field, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_measurement_get_field_function mien_measurement_get_field = Library.Function<mien_measurement_get_field_function>("mien_measurement_get_field");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measurement_get_json_function(IntPtr measurement, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_measurement_get_json_function mien_measurement_get_json = Library.Function<mien_measurement_get_json_function>("mien_measurement_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_measurement_release_function(IntPtr measurement);
        internal static readonly mien_measurement_release_function mien_measurement_release = Library.Function<mien_measurement_release_function>("mien_measurement_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_asymmetry_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_asymmetry_options_init_function mien_asymmetry_options_init = Library.Function<mien_asymmetry_options_init_function>("mien_asymmetry_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_asymmetry_function(IntPtr session, IntPtr face, IntPtr templateMesh, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_measure_asymmetry_function mien_measure_asymmetry = Library.Function<mien_measure_asymmetry_function>("mien_measure_asymmetry");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measurement_get_mirror_plane_function(IntPtr measurement, IntPtr @out, IntPtr error);
        internal static readonly mien_measurement_get_mirror_plane_function mien_measurement_get_mirror_plane = Library.Function<mien_measurement_get_mirror_plane_function>("mien_measurement_get_mirror_plane");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_register_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_register_options_init_function mien_register_options_init = Library.Function<mien_register_options_init_function>("mien_register_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_register_function(IntPtr session, IntPtr model, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_register_function mien_register = Library.Function<mien_register_function>("mien_register");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_registration_mesh_function(IntPtr registration);
        internal static readonly mien_registration_mesh_function mien_registration_mesh = Library.Function<mien_registration_mesh_function>("mien_registration_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_verdict_function(IntPtr registration, IntPtr @out, IntPtr error);
        internal static readonly mien_registration_get_verdict_function mien_registration_get_verdict = Library.Function<mien_registration_get_verdict_function>("mien_registration_get_verdict");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_expected_error_function(IntPtr registration, IntPtr zone, IntPtr @out, IntPtr error);
        internal static readonly mien_registration_get_expected_error_function mien_registration_get_expected_error = Library.Function<mien_registration_get_expected_error_function>("mien_registration_get_expected_error");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_field_function(IntPtr registration, int field, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_registration_get_field_function mien_registration_get_field = Library.Function<mien_registration_get_field_function>("mien_registration_get_field");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_correspondence_function(IntPtr registration, IntPtr triangles, IntPtr barycentric, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_registration_get_correspondence_function mien_registration_get_correspondence = Library.Function<mien_registration_get_correspondence_function>("mien_registration_get_correspondence");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_motion_function(IntPtr registration, IntPtr matrix, IntPtr error);
        internal static readonly mien_registration_get_motion_function mien_registration_get_motion = Library.Function<mien_registration_get_motion_function>("mien_registration_get_motion");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_json_function(IntPtr registration, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_registration_get_json_function mien_registration_get_json = Library.Function<mien_registration_get_json_function>("mien_registration_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_save_function(IntPtr session, IntPtr registration, IntPtr path, IntPtr error);
        internal static readonly mien_registration_save_function mien_registration_save = Library.Function<mien_registration_save_function>("mien_registration_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_registration_load_function mien_registration_load = Library.Function<mien_registration_load_function>("mien_registration_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_create_function(IntPtr session, IntPtr mesh, IntPtr weight, IntPtr residual, IntPtr standardDeviation, int quality, IntPtr @out, IntPtr error);
        internal static readonly mien_registration_create_function mien_registration_create = Library.Function<mien_registration_create_function>("mien_registration_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_tie_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_tie_options_init_function mien_tie_options_init = Library.Function<mien_tie_options_init_function>("mien_tie_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_tie_function(IntPtr session, IntPtr model, IntPtr reference, IntPtr referenceScan, IntPtr registration, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_registration_tie_function mien_registration_tie = Library.Function<mien_registration_tie_function>("mien_registration_tie");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_registration_retain_function(IntPtr registration);
        internal static readonly mien_registration_retain_function mien_registration_retain = Library.Function<mien_registration_retain_function>("mien_registration_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_registration_release_function(IntPtr registration);
        internal static readonly mien_registration_release_function mien_registration_release = Library.Function<mien_registration_release_function>("mien_registration_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_surface_transfer_points_function(IntPtr session, IntPtr surface, IntPtr points, double maxDistanceMm, IntPtr triangles, IntPtr barycentric, IntPtr positions, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_surface_transfer_points_function mien_surface_transfer_points = Library.Function<mien_surface_transfer_points_function>("mien_surface_transfer_points");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_surface_transfer_zone_function(IntPtr session, IntPtr from, IntPtr vertices, ulong vertexCount, IntPtr to, double maxDistanceMm, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_surface_transfer_zone_function mien_surface_transfer_zone = Library.Function<mien_surface_transfer_zone_function>("mien_surface_transfer_zone");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_surface_transfer_json_function(IntPtr session, IntPtr model, IntPtr fitted, IntPtr scan, int what, double maxDistanceMm, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_surface_transfer_json_function mien_surface_transfer_json = Library.Function<mien_surface_transfer_json_function>("mien_surface_transfer_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_batch_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_batch_options_init_function mien_batch_options_init = Library.Function<mien_batch_options_init_function>("mien_batch_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_ready_scan_create_function(IntPtr session, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_ready_scan_create_function mien_ready_scan_create = Library.Function<mien_ready_scan_create_function>("mien_ready_scan_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_ready_scan_register_function(IntPtr session, IntPtr model, IntPtr scan, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_ready_scan_register_function mien_ready_scan_register = Library.Function<mien_ready_scan_register_function>("mien_ready_scan_register");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_ready_scan_retain_function(IntPtr scan);
        internal static readonly mien_ready_scan_retain_function mien_ready_scan_retain = Library.Function<mien_ready_scan_retain_function>("mien_ready_scan_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_ready_scan_release_function(IntPtr scan);
        internal static readonly mien_ready_scan_release_function mien_ready_scan_release = Library.Function<mien_ready_scan_release_function>("mien_ready_scan_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_batch_create_function(IntPtr session, IntPtr model, IntPtr @out, IntPtr error);
        internal static readonly mien_batch_create_function mien_batch_create = Library.Function<mien_batch_create_function>("mien_batch_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_batch_add_function(IntPtr session, IntPtr batch, IntPtr scan, IntPtr options, IntPtr error);
        internal static readonly mien_batch_add_function mien_batch_add = Library.Function<mien_batch_add_function>("mien_batch_add");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_batch_run_function(IntPtr session, IntPtr batch, IntPtr options, IntPtr error);
        internal static readonly mien_batch_run_function mien_batch_run = Library.Function<mien_batch_run_function>("mien_batch_run");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_batch_get_counts_function(IntPtr batch, IntPtr scanCount, IntPtr runCount, IntPtr error);
        internal static readonly mien_batch_get_counts_function mien_batch_get_counts = Library.Function<mien_batch_get_counts_function>("mien_batch_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_batch_get_registration_function(IntPtr batch, int index, IntPtr @out, IntPtr error);
        internal static readonly mien_batch_get_registration_function mien_batch_get_registration = Library.Function<mien_batch_get_registration_function>("mien_batch_get_registration");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_batch_retain_function(IntPtr batch);
        internal static readonly mien_batch_retain_function mien_batch_retain = Library.Function<mien_batch_retain_function>("mien_batch_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_batch_release_function(IntPtr batch);
        internal static readonly mien_batch_release_function mien_batch_release = Library.Function<mien_batch_release_function>("mien_batch_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_spectral_basis_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_spectral_basis_options_init_function mien_spectral_basis_options_init = Library.Function<mien_spectral_basis_options_init_function>("mien_spectral_basis_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_build_function(IntPtr session, IntPtr mean, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_basis_build_function mien_spectral_basis_build = Library.Function<mien_spectral_basis_build_function>("mien_spectral_basis_build");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_basis_load_function mien_spectral_basis_load = Library.Function<mien_spectral_basis_load_function>("mien_spectral_basis_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_save_function(IntPtr session, IntPtr basis, IntPtr path, IntPtr error);
        internal static readonly mien_spectral_basis_save_function mien_spectral_basis_save = Library.Function<mien_spectral_basis_save_function>("mien_spectral_basis_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_get_counts_function(IntPtr basis, IntPtr vertexCount, IntPtr modeCount, IntPtr error);
        internal static readonly mien_spectral_basis_get_counts_function mien_spectral_basis_get_counts = Library.Function<mien_spectral_basis_get_counts_function>("mien_spectral_basis_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_get_eigenvalues_function(IntPtr basis, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_spectral_basis_get_eigenvalues_function mien_spectral_basis_get_eigenvalues = Library.Function<mien_spectral_basis_get_eigenvalues_function>("mien_spectral_basis_get_eigenvalues");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_spectral_basis_retain_function(IntPtr basis);
        internal static readonly mien_spectral_basis_retain_function mien_spectral_basis_retain = Library.Function<mien_spectral_basis_retain_function>("mien_spectral_basis_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_spectral_basis_release_function(IntPtr basis);
        internal static readonly mien_spectral_basis_release_function mien_spectral_basis_release = Library.Function<mien_spectral_basis_release_function>("mien_spectral_basis_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_split_function(IntPtr session, IntPtr basis, IntPtr face, ulong k, IntPtr low, IntPtr high, IntPtr error);
        internal static readonly mien_spectral_split_function mien_spectral_split = Library.Function<mien_spectral_split_function>("mien_spectral_split");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_assemble_function(IntPtr session, IntPtr basis, IntPtr low, IntPtr high, ulong k, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_assemble_function mien_spectral_assemble = Library.Function<mien_spectral_assemble_function>("mien_spectral_assemble");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_edit_function(IntPtr session, IntPtr basis, IntPtr face, IntPtr limits, ulong limitCount, IntPtr gains, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_edit_function mien_spectral_edit = Library.Function<mien_spectral_edit_function>("mien_spectral_edit");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_mix_function(IntPtr session, IntPtr basis, IntPtr first, IntPtr second, IntPtr limits, ulong limitCount, IntPtr weights, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_mix_function mien_spectral_mix = Library.Function<mien_spectral_mix_function>("mien_spectral_mix");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_get_vector_function(IntPtr basis, ulong mode, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_spectral_basis_get_vector_function mien_spectral_basis_get_vector = Library.Function<mien_spectral_basis_get_vector_function>("mien_spectral_basis_get_vector");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_get_mass_function(IntPtr basis, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_spectral_basis_get_mass_function mien_spectral_basis_get_mass = Library.Function<mien_spectral_basis_get_mass_function>("mien_spectral_basis_get_mass");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_basis_get_mean_function(IntPtr basis, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_basis_get_mean_function mien_spectral_basis_get_mean = Library.Function<mien_spectral_basis_get_mean_function>("mien_spectral_basis_get_mean");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_project_function(IntPtr session, IntPtr basis, IntPtr face, ulong modeCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_spectral_project_function mien_spectral_project = Library.Function<mien_spectral_project_function>("mien_spectral_project");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_spectral_synthesize_function(IntPtr session, IntPtr basis, IntPtr coefficients, ulong rowCount, ulong firstMode, IntPtr @out, IntPtr error);
        internal static readonly mien_spectral_synthesize_function mien_spectral_synthesize = Library.Function<mien_spectral_synthesize_function>("mien_spectral_synthesize");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_metric_function(IntPtr session, int metric, IntPtr reference, IntPtr other, IntPtr value, IntPtr error);
        internal static readonly mien_metric_function mien_metric = Library.Function<mien_metric_function>("mien_metric");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_metric_field_function(IntPtr session, int metric, IntPtr reference, IntPtr other, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_metric_field_function mien_metric_field = Library.Function<mien_metric_field_function>("mien_metric_field");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_metric_roughness_function(IntPtr session, IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_metric_roughness_function mien_metric_roughness = Library.Function<mien_metric_roughness_function>("mien_metric_roughness");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_transfer_expression_function(IntPtr session, IntPtr sourceNeutral, IntPtr sourceExpression, IntPtr targetNeutral, IntPtr @out, IntPtr error);
        internal static readonly mien_transfer_expression_function mien_transfer_expression = Library.Function<mien_transfer_expression_function>("mien_transfer_expression");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_blendshape_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_blendshape_options_init_function mien_blendshape_options_init = Library.Function<mien_blendshape_options_init_function>("mien_blendshape_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_blendshape_model_train_function(IntPtr session, IntPtr datasetPath, IntPtr expression, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_blendshape_model_train_function mien_blendshape_model_train = Library.Function<mien_blendshape_model_train_function>("mien_blendshape_model_train");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_blendshape_model_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_blendshape_model_load_function mien_blendshape_model_load = Library.Function<mien_blendshape_model_load_function>("mien_blendshape_model_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_blendshape_model_save_function(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        internal static readonly mien_blendshape_model_save_function mien_blendshape_model_save = Library.Function<mien_blendshape_model_save_function>("mien_blendshape_model_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_blendshape_model_get_mean_function(IntPtr model, IntPtr @out, IntPtr error);
        internal static readonly mien_blendshape_model_get_mean_function mien_blendshape_model_get_mean = Library.Function<mien_blendshape_model_get_mean_function>("mien_blendshape_model_get_mean");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_blendshape_model_predict_function(IntPtr session, IntPtr model, IntPtr basis, ulong k, IntPtr neutral, IntPtr @out, IntPtr error);
        internal static readonly mien_blendshape_model_predict_function mien_blendshape_model_predict = Library.Function<mien_blendshape_model_predict_function>("mien_blendshape_model_predict");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_blendshape_model_search_function(IntPtr session, IntPtr model, IntPtr basis, IntPtr datasetPath, IntPtr expression, IntPtr candidates, uint candidateCount, IntPtr options, IntPtr choices, IntPtr error);
        internal static readonly mien_blendshape_model_search_function mien_blendshape_model_search = Library.Function<mien_blendshape_model_search_function>("mien_blendshape_model_search");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_blendshape_model_retain_function(IntPtr model);
        internal static readonly mien_blendshape_model_retain_function mien_blendshape_model_retain = Library.Function<mien_blendshape_model_retain_function>("mien_blendshape_model_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_blendshape_model_release_function(IntPtr model);
        internal static readonly mien_blendshape_model_release_function mien_blendshape_model_release = Library.Function<mien_blendshape_model_release_function>("mien_blendshape_model_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_dataset_writer_create_function(IntPtr session, IntPtr topology, IntPtr expressionNames, uint expressionCount, IntPtr @out, IntPtr error);
        internal static readonly mien_dataset_writer_create_function mien_dataset_writer_create = Library.Function<mien_dataset_writer_create_function>("mien_dataset_writer_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_dataset_writer_add_function(IntPtr writer, IntPtr positions, int subject, int expression, IntPtr error);
        internal static readonly mien_dataset_writer_add_function mien_dataset_writer_add = Library.Function<mien_dataset_writer_add_function>("mien_dataset_writer_add");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_dataset_writer_save_function(IntPtr session, IntPtr writer, IntPtr path, IntPtr error);
        internal static readonly mien_dataset_writer_save_function mien_dataset_writer_save = Library.Function<mien_dataset_writer_save_function>("mien_dataset_writer_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_dataset_writer_release_function(IntPtr writer);
        internal static readonly mien_dataset_writer_release_function mien_dataset_writer_release = Library.Function<mien_dataset_writer_release_function>("mien_dataset_writer_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_load_function mien_expression_model_load = Library.Function<mien_expression_model_load_function>("mien_expression_model_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_load_memory_function(IntPtr session, IntPtr data, ulong size, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_load_memory_function mien_expression_model_load_memory = Library.Function<mien_expression_model_load_memory_function>("mien_expression_model_load_memory");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_save_function(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        internal static readonly mien_expression_model_save_function mien_expression_model_save = Library.Function<mien_expression_model_save_function>("mien_expression_model_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_expression_model_retain_function(IntPtr model);
        internal static readonly mien_expression_model_retain_function mien_expression_model_retain = Library.Function<mien_expression_model_retain_function>("mien_expression_model_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_expression_model_release_function(IntPtr model);
        internal static readonly mien_expression_model_release_function mien_expression_model_release = Library.Function<mien_expression_model_release_function>("mien_expression_model_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_get_counts_function(IntPtr model, IntPtr vertexCount, IntPtr identityModes, IntPtr expressionModes, IntPtr error);
        internal static readonly mien_expression_model_get_counts_function mien_expression_model_get_counts = Library.Function<mien_expression_model_get_counts_function>("mien_expression_model_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_get_json_function(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_expression_model_get_json_function mien_expression_model_get_json = Library.Function<mien_expression_model_get_json_function>("mien_expression_model_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_synthesize_function(IntPtr session, IntPtr model, IntPtr identity, IntPtr expression, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_synthesize_function mien_expression_model_synthesize = Library.Function<mien_expression_model_synthesize_function>("mien_expression_model_synthesize");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_sample_function(IntPtr session, IntPtr model, ulong seed, IntPtr expression, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_sample_function mien_expression_model_sample = Library.Function<mien_expression_model_sample_function>("mien_expression_model_sample");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_neutralize_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_neutralize_options_init_function mien_neutralize_options_init = Library.Function<mien_neutralize_options_init_function>("mien_neutralize_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralize_function(IntPtr session, IntPtr model, IntPtr fitted, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_neutralize_function mien_neutralize = Library.Function<mien_neutralize_function>("mien_neutralize");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralize_mesh_function(IntPtr session, IntPtr model, IntPtr face, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_neutralize_mesh_function mien_neutralize_mesh = Library.Function<mien_neutralize_mesh_function>("mien_neutralize_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate IntPtr mien_neutralization_mesh_function(IntPtr neutralization);
        internal static readonly mien_neutralization_mesh_function mien_neutralization_mesh = Library.Function<mien_neutralization_mesh_function>("mien_neutralization_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralization_get_counts_function(IntPtr neutralization, IntPtr vertexCount, IntPtr identityModes, IntPtr expressionModes, IntPtr error);
        internal static readonly mien_neutralization_get_counts_function mien_neutralization_get_counts = Library.Function<mien_neutralization_get_counts_function>("mien_neutralization_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralization_get_coordinates_function(IntPtr neutralization, IntPtr identity, IntPtr expression, IntPtr error);
        internal static readonly mien_neutralization_get_coordinates_function mien_neutralization_get_coordinates = Library.Function<mien_neutralization_get_coordinates_function>("mien_neutralization_get_coordinates");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralization_get_uncertainty_function(IntPtr neutralization, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_neutralization_get_uncertainty_function mien_neutralization_get_uncertainty = Library.Function<mien_neutralization_get_uncertainty_function>("mien_neutralization_get_uncertainty");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralization_get_reading_function(IntPtr neutralization, int reading, IntPtr @out, IntPtr error);
        internal static readonly mien_neutralization_get_reading_function mien_neutralization_get_reading = Library.Function<mien_neutralization_get_reading_function>("mien_neutralization_get_reading");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralization_get_json_function(IntPtr neutralization, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_neutralization_get_json_function mien_neutralization_get_json = Library.Function<mien_neutralization_get_json_function>("mien_neutralization_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_neutralization_release_function(IntPtr neutralization);
        internal static readonly mien_neutralization_release_function mien_neutralization_release = Library.Function<mien_neutralization_release_function>("mien_neutralization_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralization_apply_to_scan_function(IntPtr session, IntPtr neutralization, IntPtr scan, double maxDistanceMm, IntPtr @out, IntPtr error);
        internal static readonly mien_neutralization_apply_to_scan_function mien_neutralization_apply_to_scan = Library.Function<mien_neutralization_apply_to_scan_function>("mien_neutralization_apply_to_scan");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_transfer_function(IntPtr session, IntPtr model, IntPtr source, IntPtr target, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_transfer_function mien_expression_model_transfer = Library.Function<mien_expression_model_transfer_function>("mien_expression_model_transfer");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_evaluate_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_evaluate_options_init_function mien_evaluate_options_init = Library.Function<mien_evaluate_options_init_function>("mien_evaluate_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_evaluate_neutralization_function(IntPtr session, IntPtr model, IntPtr datasetPath, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_evaluate_neutralization_function mien_evaluate_neutralization = Library.Function<mien_evaluate_neutralization_function>("mien_evaluate_neutralization");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_evaluation_get_json_function(IntPtr evaluation, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_evaluation_get_json_function mien_evaluation_get_json = Library.Function<mien_evaluation_get_json_function>("mien_evaluation_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_evaluation_release_function(IntPtr evaluation);
        internal static readonly mien_evaluation_release_function mien_evaluation_release = Library.Function<mien_evaluation_release_function>("mien_evaluation_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_follow_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_follow_options_init_function mien_follow_options_init = Library.Function<mien_follow_options_init_function>("mien_follow_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_follower_create_function(IntPtr session, IntPtr model, IntPtr start, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_follower_create_function mien_follower_create = Library.Function<mien_follower_create_function>("mien_follower_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_follower_fit_function(IntPtr session, IntPtr follower, IntPtr points, int width, int height, IntPtr @out, IntPtr error);
        internal static readonly mien_follower_fit_function mien_follower_fit = Library.Function<mien_follower_fit_function>("mien_follower_fit");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_follower_get_mesh_function(IntPtr follower, IntPtr @out, IntPtr error);
        internal static readonly mien_follower_get_mesh_function mien_follower_get_mesh = Library.Function<mien_follower_get_mesh_function>("mien_follower_get_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_follower_get_motion_function(IntPtr follower, IntPtr matrix, IntPtr error);
        internal static readonly mien_follower_get_motion_function mien_follower_get_motion = Library.Function<mien_follower_get_motion_function>("mien_follower_get_motion");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_follower_retain_function(IntPtr follower);
        internal static readonly mien_follower_retain_function mien_follower_retain = Library.Function<mien_follower_retain_function>("mien_follower_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_follower_release_function(IntPtr follower);
        internal static readonly mien_follower_release_function mien_follower_release = Library.Function<mien_follower_release_function>("mien_follower_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_geodesic_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_geodesic_options_init_function mien_geodesic_options_init = Library.Function<mien_geodesic_options_init_function>("mien_geodesic_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_measure_geodesic_function(IntPtr session, IntPtr mesh, IntPtr sources, ulong sourceCount, IntPtr options, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_measure_geodesic_function mien_measure_geodesic = Library.Function<mien_measure_geodesic_function>("mien_measure_geodesic");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_build_quadric_function(IntPtr session, IntPtr mesh, uint levelCount, double factor, IntPtr @out, IntPtr error);
        internal static readonly mien_hierarchy_build_quadric_function mien_hierarchy_build_quadric = Library.Function<mien_hierarchy_build_quadric_function>("mien_hierarchy_build_quadric");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_build_connectivity_function(IntPtr session, IntPtr mesh, uint levelCount, uint stride, uint radius, IntPtr @out, IntPtr error);
        internal static readonly mien_hierarchy_build_connectivity_function mien_hierarchy_build_connectivity = Library.Function<mien_hierarchy_build_connectivity_function>("mien_hierarchy_build_connectivity");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_hierarchy_load_function mien_hierarchy_load = Library.Function<mien_hierarchy_load_function>("mien_hierarchy_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_save_function(IntPtr session, IntPtr hierarchy, IntPtr path, IntPtr error);
        internal static readonly mien_hierarchy_save_function mien_hierarchy_save = Library.Function<mien_hierarchy_save_function>("mien_hierarchy_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_get_level_count_function(IntPtr hierarchy, IntPtr levelCount, IntPtr error);
        internal static readonly mien_hierarchy_get_level_count_function mien_hierarchy_get_level_count = Library.Function<mien_hierarchy_get_level_count_function>("mien_hierarchy_get_level_count");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_get_level_function(IntPtr hierarchy, uint level, IntPtr @out, IntPtr error);
        internal static readonly mien_hierarchy_get_level_function mien_hierarchy_get_level = Library.Function<mien_hierarchy_get_level_function>("mien_hierarchy_get_level");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_apply_function(IntPtr hierarchy, uint level, int direction, IntPtr values, ulong rowCount, ulong channelCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_hierarchy_apply_function mien_hierarchy_apply = Library.Function<mien_hierarchy_apply_function>("mien_hierarchy_apply");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_hierarchy_get_map_function(IntPtr hierarchy, uint level, int direction, IntPtr rows, IntPtr columns, IntPtr values, ulong capacity, IntPtr count, IntPtr rowCount, IntPtr columnCount, IntPtr error);
        internal static readonly mien_hierarchy_get_map_function mien_hierarchy_get_map = Library.Function<mien_hierarchy_get_map_function>("mien_hierarchy_get_map");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_hierarchy_retain_function(IntPtr hierarchy);
        internal static readonly mien_hierarchy_retain_function mien_hierarchy_retain = Library.Function<mien_hierarchy_retain_function>("mien_hierarchy_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_hierarchy_release_function(IntPtr hierarchy);
        internal static readonly mien_hierarchy_release_function mien_hierarchy_release = Library.Function<mien_hierarchy_release_function>("mien_hierarchy_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_inspect_function(IntPtr session, IntPtr mesh, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_mesh_inspect_function mien_mesh_inspect = Library.Function<mien_mesh_inspect_function>("mien_mesh_inspect");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_clean_function(IntPtr session, IntPtr mesh, ulong minTriangles, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_clean_function mien_mesh_clean = Library.Function<mien_mesh_clean_function>("mien_mesh_clean");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_transform_function(IntPtr session, IntPtr mesh, IntPtr matrix, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_transform_function mien_mesh_transform = Library.Function<mien_mesh_transform_function>("mien_mesh_transform");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_turn_over_function(IntPtr session, IntPtr mesh, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_turn_over_function mien_mesh_turn_over = Library.Function<mien_mesh_turn_over_function>("mien_mesh_turn_over");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_decimate_function(IntPtr session, IntPtr mesh, ulong vertexCount, IntPtr @out, IntPtr error);
        internal static readonly mien_mesh_decimate_function mien_mesh_decimate = Library.Function<mien_mesh_decimate_function>("mien_mesh_decimate");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_mesh_check_same_unit_function(IntPtr first, IntPtr second, IntPtr error);
        internal static readonly mien_mesh_check_same_unit_function mien_mesh_check_same_unit = Library.Function<mien_mesh_check_same_unit_function>("mien_mesh_check_same_unit");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_model_fit_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_model_fit_options_init_function mien_model_fit_options_init = Library.Function<mien_model_fit_options_init_function>("mien_model_fit_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_fit_function(IntPtr session, IntPtr model, IntPtr target, IntPtr options, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_model_fit_function mien_model_fit = Library.Function<mien_model_fit_function>("mien_model_fit");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_model_synthesize_function(IntPtr session, IntPtr model, IntPtr coefficients, ulong coefficientCount, IntPtr @out, IntPtr error);
        internal static readonly mien_model_synthesize_function mien_model_synthesize = Library.Function<mien_model_synthesize_function>("mien_model_synthesize");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_registration_get_coefficients_function(IntPtr session, IntPtr registration, IntPtr model, double ridgeMm2, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_registration_get_coefficients_function mien_registration_get_coefficients = Library.Function<mien_registration_get_coefficients_function>("mien_registration_get_coefficients");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_network_evaluation_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_network_evaluation_options_init_function mien_network_evaluation_options_init = Library.Function<mien_network_evaluation_options_init_function>("mien_network_evaluation_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_network_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_network_options_init_function mien_network_options_init = Library.Function<mien_network_options_init_function>("mien_network_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_network_load_function mien_network_load = Library.Function<mien_network_load_function>("mien_network_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_load_memory_function(IntPtr session, IntPtr data, ulong size, IntPtr @out, IntPtr error);
        internal static readonly mien_network_load_memory_function mien_network_load_memory = Library.Function<mien_network_load_memory_function>("mien_network_load_memory");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_get_counts_function(IntPtr network, IntPtr vertexCount, IntPtr codeCount, IntPtr error);
        internal static readonly mien_network_get_counts_function mien_network_get_counts = Library.Function<mien_network_get_counts_function>("mien_network_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_get_json_function(IntPtr network, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_network_get_json_function mien_network_get_json = Library.Function<mien_network_get_json_function>("mien_network_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_get_mean_function(IntPtr network, IntPtr @out, IntPtr error);
        internal static readonly mien_network_get_mean_function mien_network_get_mean = Library.Function<mien_network_get_mean_function>("mien_network_get_mean");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_encode_function(IntPtr session, IntPtr network, IntPtr face, IntPtr options, IntPtr motion, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_network_encode_function mien_network_encode = Library.Function<mien_network_encode_function>("mien_network_encode");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_decode_function(IntPtr session, IntPtr network, IntPtr code, ulong codeCount, IntPtr motion, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_network_decode_function mien_network_decode = Library.Function<mien_network_decode_function>("mien_network_decode");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_apply_function(IntPtr session, IntPtr network, IntPtr face, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_network_apply_function mien_network_apply = Library.Function<mien_network_apply_function>("mien_network_apply");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_get_bands_function(IntPtr network, IntPtr lowCodeCount, IntPtr bandLimit, IntPtr error);
        internal static readonly mien_network_get_bands_function mien_network_get_bands = Library.Function<mien_network_get_bands_function>("mien_network_get_bands");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_mix_function(IntPtr session, IntPtr network, IntPtr a, IntPtr b, double lowWeight, double highWeight, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_network_mix_function mien_network_mix = Library.Function<mien_network_mix_function>("mien_network_mix");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_sample_function(IntPtr network, ulong seed, ulong number, double spread, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_network_sample_function mien_network_sample = Library.Function<mien_network_sample_function>("mien_network_sample");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_network_evaluate_function(IntPtr session, IntPtr network, IntPtr datasetPath, IntPtr options, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_network_evaluate_function mien_network_evaluate = Library.Function<mien_network_evaluate_function>("mien_network_evaluate");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_network_retain_function(IntPtr network);
        internal static readonly mien_network_retain_function mien_network_retain = Library.Function<mien_network_retain_function>("mien_network_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_network_release_function(IntPtr network);
        internal static readonly mien_network_release_function mien_network_release = Library.Function<mien_network_release_function>("mien_network_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_train_function(IntPtr session, IntPtr datasetPath, int kind, int neutralOnly, IntPtr @out, IntPtr error);
        internal static readonly mien_representation_train_function mien_representation_train = Library.Function<mien_representation_train_function>("mien_representation_train");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_representation_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_representation_options_init_function mien_representation_options_init = Library.Function<mien_representation_options_init_function>("mien_representation_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_train_with_options_function(IntPtr session, IntPtr datasetPath, int kind, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_representation_train_with_options_function mien_representation_train_with_options = Library.Function<mien_representation_train_with_options_function>("mien_representation_train_with_options");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_representation_load_function mien_representation_load = Library.Function<mien_representation_load_function>("mien_representation_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_save_function(IntPtr session, IntPtr representation, IntPtr path, IntPtr error);
        internal static readonly mien_representation_save_function mien_representation_save = Library.Function<mien_representation_save_function>("mien_representation_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_get_counts_function(IntPtr representation, IntPtr vertexCount, IntPtr channelCount, IntPtr error);
        internal static readonly mien_representation_get_counts_function mien_representation_get_counts = Library.Function<mien_representation_get_counts_function>("mien_representation_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_encode_function(IntPtr session, IntPtr representation, IntPtr face, IntPtr motion, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_representation_encode_function mien_representation_encode = Library.Function<mien_representation_encode_function>("mien_representation_encode");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_representation_decode_function(IntPtr session, IntPtr representation, IntPtr features, ulong rowCount, IntPtr motion, IntPtr @out, IntPtr error);
        internal static readonly mien_representation_decode_function mien_representation_decode = Library.Function<mien_representation_decode_function>("mien_representation_decode");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_representation_retain_function(IntPtr representation);
        internal static readonly mien_representation_retain_function mien_representation_retain = Library.Function<mien_representation_retain_function>("mien_representation_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_representation_release_function(IntPtr representation);
        internal static readonly mien_representation_release_function mien_representation_release = Library.Function<mien_representation_release_function>("mien_representation_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_score_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_score_options_init_function mien_score_options_init = Library.Function<mien_score_options_init_function>("mien_score_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_train_function(IntPtr session, IntPtr datasetPath, IntPtr grades, ulong gradeCount, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_score_model_train_function mien_score_model_train = Library.Function<mien_score_model_train_function>("mien_score_model_train");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_load_function(IntPtr session, IntPtr path, IntPtr @out, IntPtr error);
        internal static readonly mien_score_model_load_function mien_score_model_load = Library.Function<mien_score_model_load_function>("mien_score_model_load");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_save_function(IntPtr session, IntPtr model, IntPtr path, IntPtr error);
        internal static readonly mien_score_model_save_function mien_score_model_save = Library.Function<mien_score_model_save_function>("mien_score_model_save");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_predict_function(IntPtr session, IntPtr model, IntPtr face, IntPtr @out, IntPtr error);
        internal static readonly mien_score_model_predict_function mien_score_model_predict = Library.Function<mien_score_model_predict_function>("mien_score_model_predict");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_simulate_function(IntPtr session, IntPtr model, IntPtr face, double target, IntPtr @out, IntPtr error);
        internal static readonly mien_score_model_simulate_function mien_score_model_simulate = Library.Function<mien_score_model_simulate_function>("mien_score_model_simulate");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_get_latent_function(IntPtr model, int component, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_score_model_get_latent_function mien_score_model_get_latent = Library.Function<mien_score_model_get_latent_function>("mien_score_model_get_latent");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_score_model_get_json_function(IntPtr model, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_score_model_get_json_function mien_score_model_get_json = Library.Function<mien_score_model_get_json_function>("mien_score_model_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_score_model_retain_function(IntPtr model);
        internal static readonly mien_score_model_retain_function mien_score_model_retain = Library.Function<mien_score_model_retain_function>("mien_score_model_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_score_model_release_function(IntPtr model);
        internal static readonly mien_score_model_release_function mien_score_model_release = Library.Function<mien_score_model_release_function>("mien_score_model_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_statistics_agreement_function(IntPtr session, IntPtr ratings, ulong subjectCount, uint raterCount, int gradeCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_statistics_agreement_function mien_statistics_agreement = Library.Function<mien_statistics_agreement_function>("mien_statistics_agreement");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_statistics_repeatability_function(IntPtr session, IntPtr values, IntPtr subjects, ulong valueCount, IntPtr blanks, ulong blankCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_statistics_repeatability_function mien_statistics_repeatability = Library.Function<mien_statistics_repeatability_function>("mien_statistics_repeatability");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_statistics_bland_altman_function(IntPtr session, IntPtr first, IntPtr second, ulong valueCount, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_statistics_bland_altman_function mien_statistics_bland_altman = Library.Function<mien_statistics_bland_altman_function>("mien_statistics_bland_altman");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_series_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_series_options_init_function mien_series_options_init = Library.Function<mien_series_options_init_function>("mien_series_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralize_series_function(IntPtr session, IntPtr model, IntPtr faces, uint faceCount, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_neutralize_series_function mien_neutralize_series = Library.Function<mien_neutralize_series_function>("mien_neutralize_series");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_series_get_mesh_function(IntPtr series, int index, IntPtr @out, IntPtr error);
        internal static readonly mien_series_get_mesh_function mien_series_get_mesh = Library.Function<mien_series_get_mesh_function>("mien_series_get_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_series_get_json_function(IntPtr series, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_series_get_json_function mien_series_get_json = Library.Function<mien_series_get_json_function>("mien_series_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_series_release_function(IntPtr series);
        internal static readonly mien_series_release_function mien_series_release = Library.Function<mien_series_release_function>("mien_series_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_study_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_study_options_init_function mien_study_options_init = Library.Function<mien_study_options_init_function>("mien_study_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_create_function(IntPtr session, IntPtr registrations, uint registrationCount, IntPtr expressions, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_study_create_function mien_study_create = Library.Function<mien_study_create_function>("mien_study_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_create_from_meshes_function(IntPtr session, IntPtr faces, uint faceCount, IntPtr normalSd, IntPtr weights, IntPtr expressions, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_study_create_from_meshes_function mien_study_create_from_meshes = Library.Function<mien_study_create_from_meshes_function>("mien_study_create_from_meshes");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_counts_function(IntPtr study, IntPtr visitCount, IntPtr zoneCount, IntPtr error);
        internal static readonly mien_study_get_counts_function mien_study_get_counts = Library.Function<mien_study_get_counts_function>("mien_study_get_counts");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_zone_name_function(IntPtr study, int zone, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_study_get_zone_name_function mien_study_get_zone_name = Library.Function<mien_study_get_zone_name_function>("mien_study_get_zone_name");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_expression_function(IntPtr study, int visit, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_study_get_expression_function mien_study_get_expression = Library.Function<mien_study_get_expression_function>("mien_study_get_expression");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_mesh_function(IntPtr study, int visit, int frame, IntPtr @out, IntPtr error);
        internal static readonly mien_study_get_mesh_function mien_study_get_mesh = Library.Function<mien_study_get_mesh_function>("mien_study_get_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_field_function(IntPtr study, int visit, int field, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_study_get_field_function mien_study_get_field = Library.Function<mien_study_get_field_function>("mien_study_get_field");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_distances_function(IntPtr study, int first, int second, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_study_get_distances_function mien_study_get_distances = Library.Function<mien_study_get_distances_function>("mien_study_get_distances");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_alignment_function(IntPtr study, int first, int second, IntPtr @out, IntPtr error);
        internal static readonly mien_study_get_alignment_function mien_study_get_alignment = Library.Function<mien_study_get_alignment_function>("mien_study_get_alignment");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_change_function(IntPtr study, int first, int second, int zone, IntPtr @out, IntPtr error);
        internal static readonly mien_study_get_change_function mien_study_get_change = Library.Function<mien_study_get_change_function>("mien_study_get_change");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_study_get_json_function(IntPtr study, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_study_get_json_function mien_study_get_json = Library.Function<mien_study_get_json_function>("mien_study_get_json");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_study_retain_function(IntPtr study);
        internal static readonly mien_study_retain_function mien_study_retain = Library.Function<mien_study_retain_function>("mien_study_retain");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_study_release_function(IntPtr study);
        internal static readonly mien_study_release_function mien_study_release = Library.Function<mien_study_release_function>("mien_study_release");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_template_check_function(IntPtr session, IntPtr templateMesh, IntPtr landmarks, int mirror, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_template_check_function mien_template_check = Library.Function<mien_template_check_function>("mien_template_check");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_train_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_train_options_init_function mien_train_options_init = Library.Function<mien_train_options_init_function>("mien_train_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_train_function(IntPtr session, IntPtr datasetPath, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_train_function mien_expression_model_train = Library.Function<mien_expression_model_train_function>("mien_expression_model_train");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_shard_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_shard_options_init_function mien_shard_options_init = Library.Function<mien_shard_options_init_function>("mien_shard_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_shard_create_function(IntPtr session, IntPtr datasetPath, IntPtr options, IntPtr shardPath, IntPtr error);
        internal static readonly mien_expression_shard_create_function mien_expression_shard_create = Library.Function<mien_expression_shard_create_function>("mien_expression_shard_create");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_expression_model_merge_function(IntPtr session, IntPtr shardPaths, uint shardCount, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_expression_model_merge_function mien_expression_model_merge = Library.Function<mien_expression_model_merge_function>("mien_expression_model_merge");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_visits_options_init_function(IntPtr options, UIntPtr structSize);
        internal static readonly mien_visits_options_init_function mien_visits_options_init = Library.Function<mien_visits_options_init_function>("mien_visits_options_init");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_neutralize_visits_function(IntPtr session, IntPtr model, IntPtr faces, uint faceCount, IntPtr options, IntPtr @out, IntPtr error);
        internal static readonly mien_neutralize_visits_function mien_neutralize_visits = Library.Function<mien_neutralize_visits_function>("mien_neutralize_visits");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_visits_get_mesh_function(IntPtr visits, int index, IntPtr @out, IntPtr error);
        internal static readonly mien_visits_get_mesh_function mien_visits_get_mesh = Library.Function<mien_visits_get_mesh_function>("mien_visits_get_mesh");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_visits_get_expression_function(IntPtr visits, int index, IntPtr dst, ulong capacity, IntPtr count, IntPtr error);
        internal static readonly mien_visits_get_expression_function mien_visits_get_expression = Library.Function<mien_visits_get_expression_function>("mien_visits_get_expression");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int mien_visits_get_removed_volume_function(IntPtr visits, int first, int second, IntPtr zone, IntPtr removedMl, IntPtr sdMl, IntPtr error);
        internal static readonly mien_visits_get_removed_volume_function mien_visits_get_removed_volume = Library.Function<mien_visits_get_removed_volume_function>("mien_visits_get_removed_volume");
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void mien_visits_release_function(IntPtr visits);
        internal static readonly mien_visits_release_function mien_visits_release = Library.Function<mien_visits_release_function>("mien_visits_release");
#endif
    }
}

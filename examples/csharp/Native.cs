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
        internal const int MIEN_KERNEL_NONE = 0;
        internal const int MIEN_KERNEL_EUCLIDEAN_SE = 1;
        internal const int MIEN_KERNEL_GEODESIC_SE = 2;
        internal const int MIEN_KERNEL_BSPLINE = 3;
        internal const int MIEN_KERNEL_SURFACE_MATERN = 4;
        internal const int MIEN_HEAT_NEUMANN = 1;
        internal const int MIEN_HEAT_DIRICHLET = 2;
        internal const int MIEN_HEAT_AVERAGE = 3;
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
        internal const int MIEN_FIT_GOOD = 0;
        internal const int MIEN_FIT_DOUBTFUL = 1;
        internal const int MIEN_FIT_FAILED = 2;
        internal const int MIEN_FIELD_RESIDUAL_MM = 1;
        internal const int MIEN_FIELD_WEIGHT = 2;
        internal const int MIEN_FIELD_STANDARD_DEVIATION_MM = 3;
        internal const int MIEN_FIELD_RADIUS95_MM = 4;
        internal const int MIEN_TRAIN_JPCA = 0;
        internal const int MIEN_TRAIN_QOJPCA = 1;
        internal const int MIEN_FIT_MIXTURE = 0;
        internal const int MIEN_FIT_MAP = 1;
        internal const int MIEN_FIT_EXACT = 2;
        internal const int MIEN_FIT_ALTERNATING = 3;
        internal const int MIEN_POSE_AUTO = 0;
        internal const int MIEN_POSE_KEEP = 1;
        internal const int MIEN_POSE_RIGID = 2;
        internal const int MIEN_ZONE_WHOLE = -1;
        internal const int MIEN_ZONE_REST = -2;
        internal const int MIEN_FIELD_SIGNED_DISTANCE_MM = 1;
        internal const int MIEN_FIELD_DISTANCE_MM = 2;
        internal const int MIEN_FIELD_POSITIVE_VOLUME_MM3 = 3;
        internal const int MIEN_FIELD_NEGATIVE_VOLUME_MM3 = 4;
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
    internal unsafe struct MeshArrays
    {
        public uint structSize;
        public uint reserved;
        public ArrayView positions;
        public IntPtr triangles;
        public ulong triangleCount;
        public IntPtr colors;
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
    internal unsafe struct Zone
    {
        public IntPtr name;
        public IntPtr vertices;
        public ulong vertexCount;
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
    internal unsafe struct MeasureZone
    {
        public IntPtr name;
        public IntPtr vertices;
        public ulong vertexCount;
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

    internal sealed class DatasetWriterHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_dataset_writer_release(handle); return true; }
    }

    internal sealed class ModelHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_model_release(handle); return true; }
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

    internal sealed class MeasurementHandle : Handle
    {
        protected override bool ReleaseHandle() { Functions.mien_measurement_release(handle); return true; }
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
        internal static partial void mien_train_options_init(ref TrainOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_train_options_init(ref TrainOptions options, UIntPtr struct_size);
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
        internal static partial void mien_evaluate_options_init(ref EvaluateOptions options, UIntPtr struct_size);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void mien_evaluate_options_init(ref EvaluateOptions options, UIntPtr struct_size);
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
        internal static partial int mien_expression_model_load(SessionHandle session, byte[] path, out ExpressionModelHandle @out, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_expression_model_load(SessionHandle session, byte[] path, out ExpressionModelHandle @out, ref Error error);
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
        internal static partial int mien_measure_area(SessionHandle session, MeshHandle mesh, ref MeasureZone zone, IntPtr area_mm2, ref Error error);
#else
        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int mien_measure_area(SessionHandle session, MeshHandle mesh, ref MeasureZone zone, IntPtr area_mm2, ref Error error);
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
    }
}

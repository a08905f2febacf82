// Mien for C#: classes over the C interface. C# 7.3 on Mono or .NET Framework, and .NET 8 or later.
//
// Every native object is a SafeHandle, so that the garbage collector may release objects in any order and
// none while a call uses it. Failures are exceptions made from the error record of the same call.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Mien.Native;

namespace Mien.Native
{
    internal static class Library
    {
        // Resolved by the system's search: libmien.so.0 (dllmap or symlink), mien-0.dll, libmien.0.dylib.
#if MIEN_WINDOWS
        internal const string Name = "mien-0";
#else
        internal const string Name = "libmien.so.0";
#endif
    }

    internal abstract class Handle : SafeHandle
    {
        protected Handle() : base(IntPtr.Zero, true) { }
        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
        internal void Adopt(IntPtr owned) { SetHandle(owned); }
    }
}

namespace Mien
{
    /// <summary>A failed call: its status, the status's name and the first offending index or -1.</summary>
    public class MienException : Exception
    {
        internal MienException(int status, long index, string message) : base(message) { Status = status; DetailIndex = index; }
        public int Status { get; private set; }
        public long DetailIndex { get; private set; }
        public string StatusName { get { return Text.FromNative(Functions.mien_status_name(Status)); } }
    }

    internal static class Text
    {
        /// <summary>Zero-terminated UTF-8, or null.</summary>
        internal static byte[] ToNative(string text)
        {
            if (text == null) return null;
            var bytes = new byte[Encoding.UTF8.GetByteCount(text) + 1];
            Encoding.UTF8.GetBytes(text, 0, text.Length, bytes, 0);
            return bytes;
        }

        internal static string FromNative(IntPtr text)
        {
            var length = 0;
            while (Marshal.ReadByte(text, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }
    }

    /// <summary>What one call runs with: the error record, progress, a cancel token, and an exception to bring home.</summary>
    internal sealed unsafe class Call : IDisposable
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate int ProgressDelegate(IntPtr user, int stage, double fraction);

        // One static delegate for all calls: it can never be collected while native code holds it.
        private static readonly ProgressDelegate Forward = OnProgress;
        private static readonly IntPtr ForwardPointer = Marshal.GetFunctionPointerForDelegate(Forward);

        private readonly IProgress<Progress> progress;
        private readonly CancellationToken token;
        private readonly CancellationTokenRegistration registration;
        private readonly GCHandle self;
        private readonly CancelHandle cancel;
        private Exception thrown;
        internal Error Record;

        internal Call(IProgress<Progress> progress = null, CancellationToken token = default(CancellationToken))
        {
            Record.structSize = (uint)sizeof(Error);
            this.progress = progress;
            this.token = token;
            self = GCHandle.Alloc(this);
            if (!token.CanBeCanceled) return;
            Check(Functions.mien_cancel_create(out cancel, ref Record));
            var requested = cancel;
            registration = token.Register(() => Request(requested));
        }

        private static void Request(CancelHandle cancel)
        {
            var added = false;
            try
            {
                cancel.DangerousAddRef(ref added);
                Functions.mien_cancel_request(cancel.DangerousGetHandle());
            }
            finally { if (added) cancel.DangerousRelease(); }
        }

        internal IntPtr ProgressFunction { get { return progress == null ? IntPtr.Zero : ForwardPointer; } }
        internal IntPtr ProgressUser { get { return GCHandle.ToIntPtr(self); } }
        internal IntPtr Cancel { get { return cancel == null ? IntPtr.Zero : cancel.DangerousGetHandle(); } }

        private static int OnProgress(IntPtr user, int stage, double fraction)
        {
            var call = (Call)GCHandle.FromIntPtr(user).Target;
            try
            {
                call.progress.Report(new Progress(stage, fraction));
                return 0;
            }
            catch (Exception exception) // must not unwind through native frames
            {
                call.thrown = exception;
                return 1;
            }
        }

        internal void Check(int status)
        {
            if (status == Constants.MIEN_OK) return;
            if (thrown != null) throw thrown;
            string message;
            fixed (byte* text = Record.message) message = Text.FromNative((IntPtr)text);
            if (status == Constants.MIEN_E_CANCELLED) throw new OperationCanceledException(message, token);
            throw new MienException(status, Record.detailIndex, message);
        }

        public void Dispose()
        {
            registration.Dispose(); // waits for a running Request
            if (cancel != null) cancel.Dispose();
            self.Free();
        }
    }

    public struct Progress
    {
        public Progress(int stage, double fraction) { Stage = stage; Fraction = fraction; }
        public readonly int Stage;
        public readonly double Fraction;
    }

    /// <summary>A checked, immutable triangle mesh in millimetres.</summary>
    public sealed unsafe class Mesh : IDisposable
    {
        internal readonly MeshHandle Handle;
        internal Mesh(MeshHandle handle) { Handle = handle; }
        public void Dispose() { Handle.Dispose(); }

        /// <summary>#V x 3, x0 y0 z0 x1 ...</summary>
        public float[] Positions
        {
            get
            {
                using (var call = new Call())
                {
                    ulong count, triangles;
                    call.Check(Functions.mien_mesh_get_counts(Handle, out count, out triangles, ref call.Record));
                    var positions = new float[checked((int)(3 * count))];
                    fixed (float* data = positions)
                        call.Check(Functions.mien_mesh_get_positions(Handle, Constants.MIEN_DTYPE_F32, (IntPtr)data, count, out count, ref call.Record));
                    return positions;
                }
            }
        }

        public int[] Triangles
        {
            get
            {
                using (var call = new Call())
                {
                    ulong vertices, count;
                    call.Check(Functions.mien_mesh_get_counts(Handle, out vertices, out count, ref call.Record));
                    var triangles = new int[checked((int)(3 * count))];
                    fixed (int* data = triangles)
                        if (count != 0) call.Check(Functions.mien_mesh_get_triangles(Handle, (IntPtr)data, count, out count, ref call.Record));
                    return triangles;
                }
            }
        }
    }

    public sealed class Model : IDisposable
    {
        internal readonly ModelHandle Handle;
        internal Model(ModelHandle handle) { Handle = handle; }
        public void Dispose() { Handle.Dispose(); }
    }

    public sealed class ExpressionModel : IDisposable
    {
        internal readonly ExpressionModelHandle Handle;
        internal ExpressionModel(ExpressionModelHandle handle) { Handle = handle; }
        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>A template fitted to a scan.</summary>
    public sealed class Registration : IDisposable
    {
        internal readonly RegistrationHandle Handle;
        internal Registration(RegistrationHandle handle) { Handle = handle; }
        public void Dispose() { Handle.Dispose(); }
        public Mesh Mesh { get { return Session.Borrow(Handle, Functions.mien_registration_mesh(Handle)); } }
    }

    /// <summary>A face without its expression.</summary>
    public sealed class Neutralization : IDisposable
    {
        internal readonly NeutralizationHandle Handle;
        internal Neutralization(NeutralizationHandle handle) { Handle = handle; }
        public void Dispose() { Handle.Dispose(); }
        public Mesh Mesh { get { return Session.Borrow(Handle, Functions.mien_neutralization_mesh(Handle)); } }
    }

    /// <summary>Threads and a memory budget; one call at a time.</summary>
    public sealed unsafe class Session : IDisposable
    {
        internal readonly SessionHandle Handle;

        public Session(int threads = 1, ulong maxBytes = 0)
        {
            using (var call = new Call())
            {
                var options = default(SessionOptions);
                Functions.mien_session_options_init(ref options, (UIntPtr)sizeof(SessionOptions));
                options.numThreads = threads;
                options.maxBytes = maxBytes;
                call.Check(Functions.mien_session_create_with_options(Functions.AbiVersion, ref options, out Handle, ref call.Record));
            }
        }
        public void Dispose() { Handle.Dispose(); }

        public static string Version { get { return Text.FromNative(Functions.mien_version_string()); } }

        /// <summary>A reference of its own to a mesh that `owner` holds.</summary>
        internal static Mesh Borrow(SafeHandle owner, IntPtr mesh)
        {
            if (mesh == IntPtr.Zero) throw new ObjectDisposedException("owner");
            Functions.mien_mesh_retain(mesh);
            GC.KeepAlive(owner);
            var handle = new MeshHandle();
            handle.Adopt(mesh);
            return new Mesh(handle);
        }

        public Mesh CreateMesh(float[] positions, int[] triangles)
        {
            if (positions == null) throw new ArgumentNullException("positions");
            fixed (float* points = positions)
            fixed (int* corners = triangles)
            using (var call = new Call())
            {
                var arrays = default(MeshArrays);
                Functions.mien_mesh_arrays_init(ref arrays, (UIntPtr)sizeof(MeshArrays));
                arrays.positions.data = (IntPtr)points;
                arrays.positions.count = (ulong)(positions.Length / 3);
                arrays.positions.dtype = Constants.MIEN_DTYPE_F32;
                arrays.triangles = (IntPtr)corners;
                arrays.triangleCount = triangles == null ? 0 : (ulong)(triangles.Length / 3);
                MeshHandle mesh;
                call.Check(Functions.mien_mesh_create(Handle, ref arrays, out mesh, ref call.Record));
                return new Mesh(mesh);
            }
        }

        public Mesh LoadMesh(string path)
        {
            using (var call = new Call())
            {
                MeshHandle mesh;
                call.Check(Functions.mien_mesh_load(Handle, Text.ToNative(path), out mesh, ref call.Record));
                return new Mesh(mesh);
            }
        }

        public void SaveMesh(Mesh mesh, string path)
        {
            using (var call = new Call())
                call.Check(Functions.mien_mesh_save(Handle, mesh.Handle, Text.ToNative(path), ref call.Record));
        }

        public Model LoadModel(string path)
        {
            using (var call = new Call())
            {
                ModelHandle model;
                call.Check(Functions.mien_model_load(Handle, Text.ToNative(path), out model, ref call.Record));
                return new Model(model);
            }
        }

        public ExpressionModel LoadExpressionModel(string path)
        {
            using (var call = new Call())
            {
                ExpressionModelHandle model;
                call.Check(Functions.mien_expression_model_load(Handle, Text.ToNative(path), out model, ref call.Record));
                return new ExpressionModel(model);
            }
        }

        /// <summary>Fits the model's template to a scan. Landmarks: three coordinates by name.</summary>
        public Registration Register(Model model, Mesh scan, IDictionary<string, double[]> landmarks = null,
                                     IProgress<Progress> progress = null, CancellationToken token = default(CancellationToken))
        {
            var pinned = new List<GCHandle>();
            var rows = new ScanLandmark[landmarks == null ? 0 : landmarks.Count];
            try
            {
                fixed (ScanLandmark* first = rows)
                using (var call = new Call(progress, token))
                {
                    var row = first;
                    foreach (var landmark in landmarks ?? new Dictionary<string, double[]>())
                    {
                        var name = GCHandle.Alloc(Text.ToNative(landmark.Key), GCHandleType.Pinned);
                        pinned.Add(name);
                        row->name = name.AddrOfPinnedObject();
                        for (var axis = 0; axis < 3; ++axis) row->position[axis] = landmark.Value[axis];
                        ++row;
                    }
                    var options = default(RegisterOptions);
                    Functions.mien_register_options_init(ref options, (UIntPtr)sizeof(RegisterOptions));
                    options.landmarks = (IntPtr)first;
                    options.landmarkCount = (ulong)rows.Length;
                    options.progress = call.ProgressFunction;
                    options.progressUser = call.ProgressUser;
                    options.cancel = call.Cancel;
                    RegistrationHandle registration;
                    call.Check(Functions.mien_register(Handle, model.Handle, scan.Handle, ref options, out registration, ref call.Record));
                    return new Registration(registration);
                }
            }
            finally { foreach (var pin in pinned) pin.Free(); }
        }

        public Neutralization Neutralize(ExpressionModel expressions, Registration fitted, IProgress<Progress> progress = null,
                                         CancellationToken token = default(CancellationToken))
        {
            using (var call = new Call(progress, token))
            {
                var options = NeutralizeOptionsFor(call);
                NeutralizationHandle neutral;
                call.Check(Functions.mien_neutralize(Handle, expressions.Handle, fitted.Handle, ref options, out neutral, ref call.Record));
                return new Neutralization(neutral);
            }
        }

        public Neutralization Neutralize(ExpressionModel expressions, Mesh face, IProgress<Progress> progress = null,
                                         CancellationToken token = default(CancellationToken))
        {
            using (var call = new Call(progress, token))
            {
                var options = NeutralizeOptionsFor(call);
                NeutralizationHandle neutral;
                call.Check(Functions.mien_neutralize_mesh(Handle, expressions.Handle, face.Handle, ref options, out neutral, ref call.Record));
                return new Neutralization(neutral);
            }
        }

        private static NeutralizeOptions NeutralizeOptionsFor(Call call)
        {
            var options = default(NeutralizeOptions);
            Functions.mien_neutralize_options_init(ref options, (UIntPtr)sizeof(NeutralizeOptions));
            options.progress = call.ProgressFunction;
            options.progressUser = call.ProgressUser;
            options.cancel = call.Cancel;
            return options;
        }

        /// <summary>Absolute volume between two faces in correspondence, mL.</summary>
        public double AbsoluteVolume(Mesh before, Mesh after)
        {
            using (var call = new Call())
            {
                var options = default(MeasureOptions);
                Functions.mien_measure_options_init(ref options, (UIntPtr)sizeof(MeasureOptions));
                MeasurementHandle measurement;
                call.Check(Functions.mien_measure_volume(Handle, before.Handle, after.Handle, ref options, out measurement, ref call.Record));
                using (measurement)
                {
                    var volume = default(ZoneVolume);
                    volume.structSize = (uint)sizeof(ZoneVolume);
                    call.Check(Functions.mien_measurement_get_volume(measurement, Constants.MIEN_ZONE_WHOLE, ref volume, ref call.Record));
                    return volume.absoluteMl;
                }
            }
        }
    }
}

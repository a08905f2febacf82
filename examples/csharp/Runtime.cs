// What the classes stand on: finding the library, owning handles, errors, progress, and the memory of one call.
// C# 7.2: Mono, .NET Framework, Unity (also IL2CPP), .NET 8 and later; netstandard2.1.
using System;
using System.Buffers;
using System.Collections.Generic;
using System.IO;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Mien.Native;

namespace Mien.Native
{
    /// <summary>Where the native library is: Mien.Settings.LibraryPath, MIEN_LIBRARY, runtimes/RID/native beside the
    /// assembly, or the system's own search.</summary>
    internal static class Library
    {
        [DllImport("libdl.so.2", EntryPoint = "dlopen")]
        private static extern IntPtr OpenLinux([MarshalAs(UnmanagedType.LPStr)] string path, int flags);
        [DllImport("libdl.so.2", EntryPoint = "dlsym")]
        private static extern IntPtr SymbolLinux(IntPtr library, [MarshalAs(UnmanagedType.LPStr)] string name);
        [DllImport("libSystem.dylib", EntryPoint = "dlopen")]
        private static extern IntPtr OpenMac([MarshalAs(UnmanagedType.LPStr)] string path, int flags);
        [DllImport("libSystem.dylib", EntryPoint = "dlsym")]
        private static extern IntPtr SymbolMac(IntPtr library, [MarshalAs(UnmanagedType.LPStr)] string name);
        [DllImport("kernel32", EntryPoint = "LoadLibraryW", CharSet = CharSet.Unicode)]
        private static extern IntPtr OpenWindows(string path);
        [DllImport("kernel32", EntryPoint = "GetProcAddress", CharSet = CharSet.Ansi)]
        private static extern IntPtr SymbolWindows(IntPtr library, string name);

        private const int Now = 2; // RTLD_NOW
        private static readonly object Guard = new object();
        private static IntPtr loaded;
        private static string loadedPath;

        private static bool IsWindows { get { return Path.DirectorySeparatorChar == '\\'; } }
        private static bool IsMac { get { return RuntimeInformation.IsOSPlatform(OSPlatform.OSX); } }

        /// <summary>The native function as a delegate.</summary>
        internal static T Function<T>(string name) where T : class
        {
            var library = Load();
            var address = IsWindows ? SymbolWindows(library, name) : IsMac ? SymbolMac(library, name) : SymbolLinux(library, name);
            if (address == IntPtr.Zero)
                throw new EntryPointNotFoundException(loadedPath + " has no " + name + "(): it is older than this binding (" + Functions.Version + ")");
            return (T)(object)Marshal.GetDelegateForFunctionPointer(address, typeof(T));
        }

        /// <summary>Loads the library unless it is there; throws DllNotFoundException, after which another path may be set: the
        /// table of functions, whose failure would be final, has not been made then.</summary>
        internal static void Need()
        {
#if !MIEN_STATIC
            Load();
#endif
        }

        private static IntPtr Load()
        {
            lock (Guard)
            {
                if (loaded != IntPtr.Zero) return loaded;
                loadedPath = Find();
                loaded = IsWindows ? OpenWindows(loadedPath) : IsMac ? OpenMac(loadedPath, Now) : OpenLinux(loadedPath, Now);
                if (loaded == IntPtr.Zero)
                    throw new DllNotFoundException("cannot load " + loadedPath + ": set Mien.Settings.LibraryPath or MIEN_LIBRARY, or put it beside the assembly");
                return loaded;
            }
        }

        private static string Find()
        {
            var given = Settings.LibraryPath ?? Environment.GetEnvironmentVariable("MIEN_LIBRARY");
            if (!string.IsNullOrEmpty(given)) return given;
            var name = IsWindows ? "mien-0.dll" : IsMac ? "libmien.0.dylib" : "libmien.so.0";
            var machine = RuntimeInformation.ProcessArchitecture == Architecture.Arm64 ? "-arm64" : "-x64";
            var rid = (IsWindows ? "win" : IsMac ? "osx" : "linux") + machine;
            var folder = AppDomain.CurrentDomain.BaseDirectory;
            foreach (var path in new[] { Path.Combine(folder, "runtimes", rid, "native", name), Path.Combine(folder, name) })
                if (File.Exists(path)) return path;
            return name; // the system's search
        }
    }

    internal delegate void ReleaseFunction(IntPtr handle);

    /// <summary>One reference to a native object. The garbage collector may release objects in any order, and none
    /// while a call uses it.</summary>
    internal sealed class NativeHandle : SafeHandle
    {
        private readonly ReleaseFunction release;
        internal NativeHandle(IntPtr owned, ReleaseFunction release) : base(IntPtr.Zero, true)
        {
            this.release = release;
            SetHandle(owned);
        }
        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
        protected override bool ReleaseHandle() { release(handle); return true; }
    }

    /// <summary>For compilers ahead of time (IL2CPP): native code calls this method.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type) { }
    }
}

namespace Mien
{
    /// <summary>Set before the first use of the library.</summary>
    public static class Settings
    {
        /// <summary>Full path of the native library; null: found beside the assembly or by the system.</summary>
        public static string LibraryPath { get; set; }
    }

    /// <summary>A failed call: its status, the status's name and the first offending index or -1.</summary>
    public class MienException : Exception
    {
        internal MienException(int status, long index, string message) : base(message) { Status = (Status)status; DetailIndex = index; }
        /// <summary>What failed; values that this version does not know may come from a newer library.</summary>
        public Status Status { get; private set; }
        /// <summary>First offending vertex, triangle or value, or -1.</summary>
        public long DetailIndex { get; private set; }
        /// <summary>The C name, e.g. MIEN_E_IO.</summary>
        public string StatusName { get { return Text.FromNative(Functions.mien_status_name((int)Status)); } }
    }

    /// <summary>A stage of a long call (see Stage) and how much of it is done, 0 to 1.</summary>
    public struct Progress
    {
        internal Progress(int stage, double fraction) { Stage = (Stage)stage; Fraction = fraction; }
        public readonly Stage Stage;
        public readonly double Fraction;
    }

    /// <summary>Numbers of the host as the library reads them in place: arrays of float or double convert by themselves.</summary>
    public sealed class Values
    {
        internal readonly Array Data;
        internal readonly int Dtype;
        private Values(Array data, int dtype) { Data = data; Dtype = dtype; }
        public static implicit operator Values(float[] data) { return data == null ? null : new Values(data, 1); }
        public static implicit operator Values(double[] data) { return data == null ? null : new Values(data, 2); }
    }

    /// <summary>Owns one native object. Dispose it, or leave it to the garbage collector.</summary>
    public abstract class NativeObject : IDisposable
    {
        internal readonly NativeHandle Handle;
        internal object Kept; // callbacks that live as long as the object
        internal volatile bool Disposed; // a view may still hold the handle

        internal NativeObject(IntPtr owned, ReleaseFunction release) { Handle = new NativeHandle(owned, release); }
        internal NativeObject(NativeObject made) { Handle = made.Handle; Kept = made.Kept; }
        /// <summary>Gives the native object back once no running call uses it.</summary>
        public void Dispose()
        {
            Disposed = true;
            Handle.Dispose();
        }
    }

    /// <summary>A struct of values that is handed to the library.</summary>
    public abstract class Record
    {
        internal abstract void Fill(Call call, IntPtr at);
    }

    internal static class Text
    {
        internal static string FromNative(IntPtr text)
        {
            if (text == IntPtr.Zero) return null;
            var length = 0;
            while (Marshal.ReadByte(text, length) != 0) ++length;
            return FromNative(text, length);
        }

        internal static string FromNative(IntPtr text, int length)
        {
            var bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }
    }

    /// <summary>Memory in the library that stays alive as long as anybody holds it.</summary>
    internal sealed unsafe class LentMemory<T> : MemoryManager<T> where T : struct
    {
        private readonly void* data;
        private readonly int count;
        private NativeHandle owner;

        internal LentMemory(IntPtr data, int count, NativeHandle owner)
        {
            var added = false;
            owner.DangerousAddRef(ref added);
            this.data = (void*)data;
            this.count = count;
            this.owner = owner;
        }
        ~LentMemory() { Dispose(false); }
        public override Span<T> GetSpan() { return new Span<T>(data, count); }
        public override MemoryHandle Pin(int elementIndex = 0)
        {
            var handle = GCHandle.Alloc(this); // keeps this alive while it is pinned
            return new MemoryHandle((byte*)data + elementIndex * Marshal.SizeOf(typeof(T)), handle, this);
        }
        public override void Unpin() { }
        protected override void Dispose(bool disposing)
        {
            var held = Interlocked.Exchange(ref owner, null);
            if (held != null) held.DangerousRelease();
        }
    }

    /// <summary>One call: its memory, the objects that it uses, progress, cancelling, and an exception to bring home.</summary>
    internal sealed unsafe class Call : IDisposable
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate int ProgressDelegate(IntPtr user, int stage, double fraction);
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void LogDelegate(IntPtr user, int level, IntPtr message);

        // One static delegate for all calls: it can never be collected while native code holds it.
        private static readonly ProgressDelegate Forward = OnProgress;
        private static readonly LogDelegate ForwardLog = OnLog;
        private const int ScratchBytes = 65536; // room of the first try where a result's size is not known

        private readonly List<IntPtr> blocks = new List<IntPtr>();
        private readonly List<GCHandle> pins = new List<GCHandle>();
        private readonly List<NativeHandle> used = new List<NativeHandle>();
        private readonly List<object> locked = new List<object>();
        private readonly Native.Error* record;
        private LogTarget log;
        private IProgress<Progress> progress;
        private CancellationToken token;
        private CancellationTokenRegistration registration;
        private Cancel cancel;
        private Exception thrown;

        internal Call()
        {
            Library.Need();
            record = (Native.Error*)Room(sizeof(Native.Error));
            record->structSize = (uint)sizeof(Native.Error);
        }

        internal IntPtr Error { get { return (IntPtr)record; } }

        public void Dispose()
        {
            registration.Dispose(); // waits for a running request
            if (cancel != null) cancel.Dispose();
            foreach (var handle in used) handle.DangerousRelease();
            foreach (var pin in pins) pin.Free();
            foreach (var block in blocks) Marshal.FreeHGlobal(block);
            for (var i = locked.Count; i-- > 0;) Monitor.Exit(locked[i]);
        }

        // ---- memory and objects ----
        internal IntPtr Room(long bytes)
        {
            var block = Marshal.AllocHGlobal((IntPtr)Math.Max(bytes, 8));
            blocks.Add(block);
            for (long i = 0; i < Math.Min(bytes, 1024); ++i) ((byte*)block)[i] = 0; // structs; arrays are written whole
            return block;
        }

        internal void Lock(NativeObject owner)
        {
            if (owner == null) throw new ArgumentNullException("owner");
            Monitor.Enter(owner.Handle);
            locked.Add(owner.Handle);
        }

        internal IntPtr Use(NativeObject owner)
        {
            if (owner == null) throw new ArgumentNullException("owner");
            if (owner.Disposed) throw new ObjectDisposedException(owner.GetType().Name);
            var added = false;
            owner.Handle.DangerousAddRef(ref added);
            used.Add(owner.Handle);
            return owner.Handle.DangerousGetHandle();
        }

        internal IntPtr UseOrNull(NativeObject owner) { return owner == null ? IntPtr.Zero : Use(owner); }
        internal IntPtr Pointer(IntPtr at) { return *(IntPtr*)at; }
        internal T Keep<T>(T made) where T : NativeObject { made.Kept = log; return made; }

        internal T Required<T>(T value, string name) where T : class
        {
            if (value == null) throw new ArgumentNullException(name);
            return value;
        }

        internal IntPtr Text(string text)
        {
            if (text == null) throw new ArgumentNullException("text");
            if (text.IndexOf('\0') >= 0) throw new ArgumentException("a text holds a zero character");
            var bytes = Encoding.UTF8.GetBytes(text);
            var at = Room(bytes.Length + 1);
            Marshal.Copy(bytes, 0, at, bytes.Length);
            ((byte*)at)[bytes.Length] = 0;
            return at;
        }

        internal IntPtr TextOrNull(string text) { return text == null ? IntPtr.Zero : Text(text); }

        internal IntPtr Array(Array values)
        {
            if (values == null || values.Length == 0) return IntPtr.Zero;
            var pin = GCHandle.Alloc(values, GCHandleType.Pinned);
            pins.Add(pin);
            return pin.AddrOfPinnedObject();
        }

        internal Native.ArrayView Matrix(Values values, int columns, string name)
        {
            var view = default(Native.ArrayView);
            view.dtype = values == null ? 2 : values.Dtype;
            if (values == null) return view;
            view.count = (ulong)Rows(values.Data, columns, name);
            view.data = Array(values.Data);
            return view;
        }

        internal IntPtr View(Values values, int columns, string name)
        {
            if (values == null) throw new ArgumentNullException(name);
            var at = Room(sizeof(Native.ArrayView));
            *(Native.ArrayView*)at = Matrix(values, columns, name);
            return at;
        }

        internal IntPtr ViewOrNull(Values values, int columns, string name) { return values == null ? IntPtr.Zero : View(values, columns, name); }

        internal IntPtr Texts(IReadOnlyList<string> texts)
        {
            if (texts == null || texts.Count == 0) return IntPtr.Zero;
            var at = Room((long)texts.Count * sizeof(IntPtr));
            for (var i = 0; i < texts.Count; ++i) ((IntPtr*)at)[i] = Text(texts[i]);
            return at;
        }

        internal IntPtr Handles(IReadOnlyList<NativeObject> owners)
        {
            if (owners == null || owners.Count == 0) return IntPtr.Zero;
            var at = Room((long)owners.Count * sizeof(IntPtr));
            for (var i = 0; i < owners.Count; ++i) ((IntPtr*)at)[i] = Use(owners[i]);
            return at;
        }

        internal IntPtr Record(Record value, int size, bool nullable, string name)
        {
            if (value == null && nullable) return IntPtr.Zero;
            if (value == null) throw new ArgumentNullException(name);
            var at = Room(size);
            value.Fill(this, at);
            return at;
        }

        internal IntPtr Records(IReadOnlyList<Record> values, int size)
        {
            if (values == null || values.Count == 0) return IntPtr.Zero;
            var at = Room((long)values.Count * size);
            for (long i = 0; i < (long)values.Count * size; ++i) ((byte*)at)[i] = 0;
            for (var i = 0; i < values.Count; ++i) values[i].Fill(this, (IntPtr)((byte*)at + (long)i * size));
            return at;
        }

        internal IntPtr Sized(int size)
        {
            var at = Room(size);
            *(uint*)at = (uint)size;
            return at;
        }

        // ---- counts ----
        internal long Rows(Array values, long columns, string name)
        {
            var size = values == null ? 0 : values.LongLength;
            if (columns <= 0 || size % columns != 0) throw new ArgumentException(name + " has " + size + " values, which is no multiple of " + columns);
            return size / columns;
        }

        internal long Rows(IReadOnlyCollection<object> values, long columns, string name) { return values == null ? 0 : values.Count; }

        internal void Agree(string name, long rows, long expected)
        {
            if (rows != expected) throw new ArgumentException(name + " has " + rows + " rows, " + expected + " are expected");
        }

        internal long FirstCapacity(long rowBytes) { return Math.Max(1, ScratchBytes / rowBytes); }
        internal long Count(IntPtr at) { return checked((long)*(ulong*)at); }

        /// <summary>Zero when the call is done; else the room that it asks for.</summary>
        internal long More(int status, long capacity, IntPtr count)
        {
            if (status == (int)Status.EBufferTooSmall && Count(count) > capacity) return Count(count);
            Check(status);
            return 0;
        }

        // ---- what comes out ----
        internal string ReadText(IntPtr at, long count) { return Mien.Text.FromNative(at, checked((int)Math.Max(0, count - 1))); }
        internal double[] ReadDoubles(IntPtr at, long count) { var to = new double[count]; if (count != 0) Marshal.Copy(at, to, 0, checked((int)count)); return to; }
        internal float[] ReadFloats(IntPtr at, long count) { var to = new float[count]; if (count != 0) Marshal.Copy(at, to, 0, checked((int)count)); return to; }
        internal byte[] ReadBytes(IntPtr at, long count) { var to = new byte[count]; if (count != 0) Marshal.Copy(at, to, 0, checked((int)count)); return to; }
        internal int[] ReadInts(IntPtr at, long count) { var to = new int[count]; if (count != 0) Marshal.Copy(at, to, 0, checked((int)count)); return to; }
        internal uint[] ReadUints(IntPtr at, long count) { var to = new uint[count]; for (long i = 0; i < count; ++i) to[i] = ((uint*)at)[i]; return to; }
        internal ulong[] ReadUlongs(IntPtr at, long count) { var to = new ulong[count]; for (long i = 0; i < count; ++i) to[i] = ((ulong*)at)[i]; return to; }
        internal long[] ReadLongs(IntPtr at, long count) { var to = new long[count]; for (long i = 0; i < count; ++i) to[i] = ((long*)at)[i]; return to; }

        internal T[] ReadRecords<T>(IntPtr at, long count, int size, Func<Call, IntPtr, T> read)
        {
            var made = new T[count];
            for (long i = 0; i < count; ++i) made[i] = read(this, (IntPtr)((byte*)at + i * size));
            return made;
        }

        internal ReadOnlyMemory<T> Lend<T>(IntPtr data, long count, NativeObject owner) where T : struct
        {
            return new LentMemory<T>(data, checked((int)count), owner.Handle).Memory;
        }

        internal static double[] CopyOut(double* from, int count)
        {
            var made = new double[count];
            for (var i = 0; i < count; ++i) made[i] = from[i];
            return made;
        }

        internal static void CopyIn(double[] values, double* to, int count, string name)
        {
            if (values == null || values.Length != count) throw new ArgumentException(name + " needs " + count + " values");
            for (var i = 0; i < count; ++i) to[i] = values[i];
        }

        // ---- errors, progress, cancelling, log ----
        internal void Check(int status)
        {
            if (status == (int)Status.Ok) return;
            if (thrown != null) ExceptionDispatchInfo.Capture(thrown).Throw(); // with where it was thrown
            var message = Mien.Text.FromNative((IntPtr)record->message);
            if (status == (int)Status.ECancelled) throw new OperationCanceledException(message, token);
            throw new MienException(status, record->detailIndex, message);
        }

        private GCHandle self;
        internal IntPtr ProgressUser { get { return self.IsAllocated ? GCHandle.ToIntPtr(self) : IntPtr.Zero; } }

        internal IntPtr ProgressFunction(IProgress<Progress> target)
        {
            if (target == null) return IntPtr.Zero;
            progress = target;
            self = GCHandle.Alloc(this);
            pins.Add(self);
            return Marshal.GetFunctionPointerForDelegate(Forward);
        }

        internal IntPtr CancelToken(CancellationToken given)
        {
            token = given;
            if (!given.CanBeCanceled) return IntPtr.Zero;
            cancel = new Cancel();
            var requested = cancel;
            registration = given.Register(() => requested.Request());
            return Use(cancel);
        }

        [MonoPInvokeCallback(typeof(ProgressDelegate))]
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

        /// <summary>A log's receiver, as long as the session.</summary>
        private sealed class LogTarget
        {
            internal readonly Action<int, string> Receive;
            internal readonly GCHandle Self;
            internal LogTarget(Action<int, string> receive) { Receive = receive; Self = GCHandle.Alloc(this, GCHandleType.Weak); }
            ~LogTarget() { Self.Free(); }
        }

        internal IntPtr LogFunction(Action<int, string> receive)
        {
            if (receive == null) return IntPtr.Zero;
            log = new LogTarget(receive);
            return Marshal.GetFunctionPointerForDelegate(ForwardLog);
        }

        internal IntPtr LogUser(Action<int, string> receive) { return receive == null ? IntPtr.Zero : GCHandle.ToIntPtr(log.Self); }

        [MonoPInvokeCallback(typeof(LogDelegate))]
        private static void OnLog(IntPtr user, int level, IntPtr message)
        {
            try
            {
                var target = (LogTarget)GCHandle.FromIntPtr(user).Target;
                if (target != null) target.Receive(level, Mien.Text.FromNative(message));
            }
            catch (Exception) { } // a log must not stop a call, and must not unwind through native frames
        }
    }
}

// Walks the public classes: walk FACE EXPRESSIONS SCAN DATASET FOLDER LAYOUT LIBRARY. Each method without arguments of each
// object; the structs against the recorded layout of the C structs; that the library is found where it is said to be while
// the program runs, that long calls are awaited, told of and cancelled, and that what nobody disposes is given back.
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
using System.Threading.Tasks;
using Mien;

public static class Walk
{
    private static readonly Dictionary<string, NativeObject> Live = new Dictionary<string, NativeObject>();

    private static T Keep<T>(T made) where T : NativeObject { Live[typeof(T).Name] = made; return made; }
    private static void Require(bool good, string what) { if (!good) throw new Exception(what); }

    private static void Refuses<T>(Action work) where T : Exception
    {
        try { work(); } catch (T) { return; }
        throw new Exception(typeof(T) + " is expected");
    }

    private sealed class Report : IProgress<Progress>
    {
        public Action Then;
        void IProgress<Progress>.Report(Progress value) { Then(); }
    }

    /// A sheet of 12 x 12 vertices, bent by who it is and by an expression.
    private static double[] SmallFace(int person, int grin)
    {
        var places = new double[3 * 144];
        for (var v = 0; v < 144; ++v)
        {
            double x = v % 12, y = v / 12;
            places[3 * v] = x;
            places[3 * v + 1] = y;
            places[3 * v + 2] = x * y / 40.0 + 0.2 * person * Math.Sin(0.5 * x + person) + 0.3 * grin * Math.Cos(0.4 * y);
        }
        return places;
    }

    private static Mesh Grid(Session session)
    {
        var places = SmallFace(0, 0);
        var corners = new List<uint>();
        for (var v = 0; v < 144; ++v)
        {
            int x = v % 12, y = v / 12;
            if (x < 11 && y < 11) corners.AddRange(new[] { v, v + 1, v + 12, v + 1, v + 13, v + 12 }.Select(i => (uint)i));
        }
        return Mesh.Create(session, new MeshArrays { Positions = places, Triangles = corners.ToArray(), Colors = new byte[places.Length] });
    }

    /// What is learned from small faces.
    private static void KeepSmall(Session session, Mesh small, string faces, string folder)
    {
        var few = ExpressionModel.Train(session, faces, new TrainOptions { IdentityModes = 3, ExpressionModes = 1 });
        Keep(session.EvaluateNeutralization(few, faces));
        Keep(BlendshapeModel.Train(session, faces, "grin"));
        var grades = Enumerable.Range(0, 24).Select(k => 0.5 * k).ToArray();
        Keep(ScoreModel.Train(session, faces, grades, new ScoreOptions { Folds = 4, CurvatureShare = 0 }));
        Keep(Model.Tune(session, small, faces, new TuneOptions { SigmasMm = new[] { 5.0 }, NumModes = 6 }));
        Keep(Network.Load(session, Path.Combine(folder, "walk_network.safetensors")));
        var zones = new[] { new Zone { Name = "some", Vertices = Enumerable.Range(0, 100).Select(i => (uint)i).ToArray() } };
        Keep(Study.CreateFromMeshes(session, new[] { small, small }, options: new StudyOptions { Zones = zones, StableZones = new[] { "some" } }));
        var picked = Path.Combine(folder, "walk_landmarks.json");
        File.WriteAllText(picked, "{\"vertices\": {\"pronasale\": 70, \"subnasale\": 40, \"gnathion\": 6}}");
        Keep(Norms.Create(session, faces, Landmarks.Load(session, picked)));
    }

    private static int CallAll()
    {
        var called = 0;
        foreach (var made in Live.Values)
            foreach (var method in made.GetType().GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly))
            {
                if (method.GetParameters().Length != 0) continue;
                try { method.Invoke(made, null); }
                catch (TargetInvocationException thrown)
                {
                    var failure = thrown.InnerException as MienException;
                    Require(failure != null && failure.Status == Status.ENotFound, made.GetType() + "." + method.Name + ": " + thrown.InnerException);
                }
                ++called;
            }
        return called;
    }

    private static string Snake(string name)
    {
        return string.Concat(name.Select((c, i) => char.IsUpper(c) ? (i == 0 ? "" : "_") + char.ToLowerInvariant(c) : c.ToString()));
    }

    /// Every struct of the binding against the recorded sizes and offsets of the C structs.
    private static int CompareLayout(string snapshot)
    {
        var facts = File.ReadAllLines(snapshot).Select(line => line.Split(' ')).Where(words => words.Length >= 3)
            .ToDictionary(words => string.Join(" ", words.Take(words.Length - 1)), words => long.Parse(words.Last()));
        var compared = 0;
        foreach (var type in Assembly.GetExecutingAssembly().GetTypes())
        {
            if (type.Namespace != "Mien.Native" || !type.IsValueType || type.IsEnum || type.IsNested) continue;
            var name = "mien_" + Snake(type.Name);
            Require(facts["struct " + name + " size"] == Marshal.SizeOf(type), name + " has another size");
            foreach (var field in type.GetFields(BindingFlags.Instance | BindingFlags.Public))
            {
                var key = "field " + name + "." + Snake(field.Name) + " offset";
                Require(facts.ContainsKey(key) && facts[key] == (long)Marshal.OffsetOf(type, field.Name), key + " differs");
                ++compared;
            }
        }
        return compared;
    }

    /// A path that leads nowhere is told in words, and another one may be set then.
    private static void FindLibrary(string path)
    {
        Settings.LibraryPath = path + ".absent";
        foreach (var use in new Action[] { () => new SessionOptions(), () => new Session(), () => Information.VersionString() })
        {
            try { use(); }
            catch (DllNotFoundException told)
            {
                Require(told.Message.Contains(path + ".absent") && told.Message.Contains("Mien.Settings.LibraryPath"), told.Message);
                continue;
            }
            throw new Exception("a library that is not there was loaded");
        }
        Settings.LibraryPath = path;
    }

    private sealed class Stages : IProgress<Progress>
    {
        public readonly List<Progress> Told = new List<Progress>();
        void IProgress<Progress>.Report(Progress value) { lock (Told) Told.Add(value); }
    }

    /// A long call away from this thread: awaited, told of, cancelled in the middle and before it begins.
    private static async Task Await(Session session, Model face, Mesh scan)
    {
        var options = new RegisterOptions { Iterations = 2, CloseGap = 0 };
        var stages = new Stages();
        using (var fitted = await session.RegisterAsync(face, scan, options, stages, new CancellationTokenSource().Token))
            Require(fitted.GetMesh().GetCounts().VertexCount > 0, "an awaited call brings its result");
        Require(stages.Told.Count > 2 && stages.Told.All(p => p.Fraction >= 0 && p.Fraction <= 1), "progress of an awaited call");
        foreach (var early in new[] { true, false })
            using (var source = new CancellationTokenSource())
            {
                if (early) source.Cancel();
                try { (await session.RegisterAsync(face, scan, options, new Report { Then = source.Cancel }, source.Token)).Dispose(); }
                catch (OperationCanceledException) { continue; }
                throw new Exception("a cancelled call came to its end");
            }
    }

    /// For compilers ahead of time: whatever native code calls is a static method that says so.
    private static int CheckCallbacks()
    {
        var count = 0;
        foreach (var type in Assembly.GetExecutingAssembly().GetTypes().Where(t => t.Namespace == "Mien" || t.Namespace == "Mien.Native"))
            foreach (var field in type.GetFields(BindingFlags.Static | BindingFlags.NonPublic | BindingFlags.Public))
            {
                if (field.Name[0] == '<' || !typeof(Delegate).IsAssignableFrom(field.FieldType) || field.FieldType.DeclaringType != type) continue;
                if (!field.FieldType.IsDefined(typeof(UnmanagedFunctionPointerAttribute), false)) continue;
                var method = ((Delegate)field.GetValue(null)).Method;
                if (!method.DeclaringType.Namespace.StartsWith("Mien")) continue; // a native function
                Require(method.IsStatic && method.CustomAttributes.Any(t => t.AttributeType.Name == "MonoPInvokeCallbackAttribute"), method + " has no MonoPInvokeCallback");
                ++count;
            }
        return count;
    }

    /// What nobody disposes goes with the garbage: far more than would fit beside it.
    private static void LeaveToGarbage(Session session)
    {
        var places = new double[3 * 100000];
        for (var k = 0; k < places.Length; ++k) places[k] = k % 977;
        Func<long> resident = () => File.Exists("/proc/self/statm") ? 4096L * long.Parse(File.ReadAllText("/proc/self/statm").Split(' ')[1]) : 0;
        var before = resident();
        for (var k = 0; k < 200; ++k)
        {
            Mesh.Create(session, new MeshArrays { Positions = places });
            if (k % 20 != 19) continue;
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
        Require(resident() - before < 240L << 20, "meshes that nobody holds were not given back: " + (resident() - before) + " bytes more");
    }

    public static void Main(string[] a)
    {
        FindLibrary(a[6]);
        var session = Keep(new Session(new SessionOptions { NumThreads = 2, Log = (level, text) => { } }));
        Keep(new Cancel());
        var face = Keep(Model.Load(session, a[0]));
        var expressions = Keep(ExpressionModel.Load(session, a[1]));
        var scan = Mesh.Load(session, a[2]);
        var template = Keep(face.GetMesh());
        var fitted = Keep(session.Register(face, scan, new RegisterOptions { Iterations = 2, CloseGap = 0 }));
        var neutral = Keep(session.NeutralizeAsync(expressions, fitted).Result);
        var pair = new[] { fitted.GetMesh(), neutral.GetMesh() };
        Keep(session.NeutralizeVisits(expressions, pair));
        Keep(session.NeutralizeSeries(expressions, pair));
        var zones = new[] { new Zone { Name = "some", Vertices = Enumerable.Range(0, 100).Select(i => (uint)i).ToArray() } };
        Keep(session.MeasureVolume(pair[1], pair[0], new MeasureOptions { Zones = zones }));
        var small = Grid(session);
        Keep(SpectralBasis.Build(session, small, new SpectralBasisOptions { ModeCount = 8 }));
        Keep(Hierarchy.BuildQuadric(session, small, 1, 2.0));
        Keep(Representation.Train(session, a[3], Features.Euclidean, 1));
        var writer = Keep(DatasetWriter.Create(session, small, new[] { "neutral", "grin" }));
        for (var k = 0; k < 24; ++k) writer.Add(SmallFace(k / 2, k % 2), k / 2, k % 2);
        var faces = Path.Combine(a[4], "walk.safetensors");
        writer.Save(session, faces);
        KeepSmall(session, small, faces, a[4]);
        var named = Keep(face.GetLandmarks());
        Keep(face.GetZones());
        Keep(session.MeasureAnthropometry(template, named));
        Keep(ReadyScan.Create(session, scan));
        var batch = Keep(Batch.Create(session, face));
        batch.Add(session, scan, new RegisterOptions { Iterations = 1, CloseGap = 0 });
        batch.Run(session);
        Require(batch.GetCounts().RunCount == 1, "a batch of one");
        Keep(Follower.Create(session, face, fitted));
        var called = CallAll();

        var view = template.GetPositionsView();
        var first = view.Span[0];
        template.Dispose();
        face.Dispose();
        GC.Collect();
        Require(view.Span[0] == first, "a view outlives its mesh");
        Refuses<ObjectDisposedException>(() => template.GetCounts());
        Refuses<MienException>(() => Mesh.Load(session, "/absent/f\u00e4ce.ply"));
        Refuses<ArgumentException>(() => session.MeasureLengths(small, new uint[] { 1, 2, 3 }));
        Refuses<ArgumentException>(() => Mesh.Create(session, new MeshArrays { Positions = new double[3], Colors = new byte[6] }));
        var again = Model.Load(session, a[0]);
        Refuses<DivideByZeroException>(() => session.Register(again, scan, null, new Report { Then = () => { throw new DivideByZeroException(); } }));
        var source = new CancellationTokenSource();
        Refuses<OperationCanceledException>(() => session.Register(again, scan, null, new Report { Then = source.Cancel }, source.Token));
        Await(session, again, scan).Wait();
        var callbacks = CheckCallbacks();
        Require(callbacks == 2, callbacks + " callbacks");
        LeaveToGarbage(session);
        Require(typeof(SafeHandle).IsAssignableFrom(typeof(Mien.Native.NativeHandle)), "handles are SafeHandles");
        var classes = typeof(NativeObject).Assembly.GetTypes().Where(t => t.IsSubclassOf(typeof(NativeObject))).ToArray();
        var others = classes.Where(t => !Live.ContainsKey(t.Name)).Select(t => t.Name).ToArray();
        Require(others.Length == 0, "not walked: " + string.Join(", ", others));
        Console.WriteLine("walked " + Live.Count + " of " + classes.Length + " classes (" + called + " methods), " + CompareLayout(a[5]) + " facts of the layout agree, awaited and cancelled calls, version " + Information.VersionString());
    }
}

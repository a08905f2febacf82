// Walks the public classes: walk FACE EXPRESSIONS SCAN DATASET FOLDER LAYOUT. Each method without arguments of each
// object; the structs against the recorded layout of the C structs.
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
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

    private static Mesh Grid(Session session)
    {
        var places = new double[3 * 144];
        var corners = new List<uint>();
        for (var v = 0; v < 144; ++v)
        {
            int x = v % 12, y = v / 12;
            places[3 * v] = x;
            places[3 * v + 1] = y;
            places[3 * v + 2] = x * y / 40.0;
            if (x < 11 && y < 11) corners.AddRange(new[] { v, v + 1, v + 12, v + 1, v + 13, v + 12 }.Select(i => (uint)i));
        }
        return Mesh.Create(session, new MeshArrays { Positions = places, Triangles = corners.ToArray(), Colors = new byte[places.Length] });
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

    public static void Main(string[] a)
    {
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
        writer.Add(small.GetPositions(), 0, 0);
        writer.Save(session, Path.Combine(a[4], "walk.safetensors"));
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
        Require(Live.Count >= 14, "walked only " + string.Join(", ", Live.Keys));
        Console.WriteLine("walked " + Live.Count + " classes (" + called + " methods), " + CompareLayout(a[5]) + " facts of the layout agree, version " + Information.VersionString());
    }
}

// From a raw scan to a neutral face, with progress and cancellation.
//   main_job FACE.safetensors EXPRESSIONS.safetensors SCAN.ply FITTED.ply NEUTRAL.ply [LANDMARKS.txt]
// LANDMARKS.txt has a name and three coordinates on each line. With --self-test as the only argument:
// checks of the binding itself that need no files.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Threading;
using Mien;

internal static class Program
{
    private sealed class Percent : IProgress<Progress>
    {
        public int Reports;
        public Action OnReport;
        public void Report(Progress progress)
        {
            ++Reports;
            if (OnReport != null) OnReport();
        }
    }

    private static IDictionary<string, double[]> ReadLandmarks(string path)
    {
        var landmarks = new Dictionary<string, double[]>();
        foreach (var line in File.ReadAllLines(path))
        {
            var words = line.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length != 4) continue;
            landmarks[words[0]] = Array.ConvertAll(new[] { words[1], words[2], words[3] }, w => double.Parse(w, CultureInfo.InvariantCulture));
        }
        return landmarks;
    }

    private static string Hash(float[] values)
    {
        var bytes = new byte[4 * values.Length];
        Buffer.BlockCopy(values, 0, bytes, 0, bytes.Length);
        using (var sha = SHA256.Create()) return BitConverter.ToString(sha.ComputeHash(bytes)).Replace("-", "").ToLowerInvariant();
    }

    private static int Main(string[] arguments)
    {
        if (arguments.Length >= 1 && arguments[0] == "--self-test") return SelfTest(arguments.Length > 1 ? arguments[1] : null);
        if (arguments.Length < 5) return 2;
        try
        {
            var progress = new Percent();
            using (var session = new Session())
            using (var face = session.LoadModel(arguments[0]))
            using (var expressions = session.LoadExpressionModel(arguments[1]))
            using (var scan = session.LoadMesh(arguments[2]))
            {
                var landmarks = arguments.Length > 5 ? ReadLandmarks(arguments[5]) : null;
                CancelsAndRethrows(session, face, scan);
                using (var fitted = session.Register(face, scan, landmarks, progress))
                using (var neutral = session.Neutralize(expressions, fitted, progress))
                using (var fittedMesh = fitted.Mesh)
                using (var neutralMesh = neutral.Mesh)
                {
                    session.SaveMesh(fittedMesh, arguments[3]);
                    session.SaveMesh(neutralMesh, arguments[4]);
                    Console.WriteLine("neutral " + Hash(neutralMesh.Positions));
                    Console.WriteLine("volume " + session.AbsoluteVolume(fittedMesh, neutralMesh).ToString("F6", CultureInfo.InvariantCulture) + " mL");
                    if (progress.Reports == 0) throw new Exception("no progress was reported");
                }
            }
            return 0;
        }
        catch (MienException failure)
        {
            Console.Error.WriteLine(failure.StatusName + ": " + failure.Message);
            return 1;
        }
    }

    /// A cancelled call throws OperationCanceledException; an exception of the callback comes back as itself.
    private static void CancelsAndRethrows(Session session, Model face, Mesh scan)
    {
        using (var source = new CancellationTokenSource())
        {
            try
            {
                session.Register(face, scan, null, new Percent { OnReport = source.Cancel }, source.Token);
                throw new Exception("the token did not cancel");
            }
            catch (OperationCanceledException) { }
        }
        try
        {
            session.Register(face, scan, null, new Percent { OnReport = () => { throw new InvalidTimeZoneException("mine"); } });
            throw new Exception("the callback's exception got lost");
        }
        catch (InvalidTimeZoneException) { }
    }

    private static void Require(bool good, string what)
    {
        if (!good) throw new Exception(what);
    }

    private static int SelfTest(string layout)
    {
        using (var session = new Session(2))
        {
            var positions = new float[] { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
            using (var mesh = session.CreateMesh(positions, new[] { 0, 1, 2 }))
            {
                Require(mesh.Positions.Length == 9 && mesh.Positions[3] == 1, "positions differ");
                Require(mesh.Triangles[2] == 2, "triangles differ");
                try
                {
                    session.SaveMesh(mesh, "/absent/f\u00e4ce.ply");
                    Require(false, "saving into an absent folder works");
                }
                catch (MienException failure) { Require(failure.StatusName == "MIEN_E_IO", failure.StatusName); }
            }
            try
            {
                session.CreateMesh(new[] { 0f, 0f, 0f, float.NaN, 0f, 0f }, null);
                Require(false, "NaN is accepted");
            }
            catch (MienException failure) { Require(failure.DetailIndex == 1, "the wrong vertex is named: " + failure.DetailIndex); }
        }
        // Objects in any order, and all of them by the garbage collector.
        for (var i = 0; i < 200; ++i) new Session().CreateMesh(new float[] { 0, 0, 0 }, null);
        GC.Collect();
        GC.WaitForPendingFinalizers();
        Console.WriteLine((layout == null ? 0 : CompareLayout(layout)) + " facts of the layout agree; self-test passed, version " + Session.Version);
        return 0;
    }

    /// Every struct of the binding against the recorded sizes and offsets of the C structs.
    private static int CompareLayout(string snapshot)
    {
        var facts = new Dictionary<string, int>();
        foreach (var line in File.ReadAllLines(snapshot))
        {
            var cut = line.LastIndexOf(' ');
            int value;
            if (int.TryParse(line.Substring(cut + 1), out value)) facts[line.Substring(0, cut)] = value;
        }
        var compared = 0;
        foreach (var type in Assembly.GetExecutingAssembly().GetTypes())
        {
            if (type.Namespace != "Mien.Native" || !type.IsValueType || type.IsEnum || type.IsNested) continue;
            var name = "mien" + string.Concat(Array.ConvertAll(type.Name.ToCharArray(), c => char.IsUpper(c) ? "_" + char.ToLowerInvariant(c) : c.ToString()));
            Require(facts.ContainsKey("struct " + name + " size"), name + " is no struct of the interface");
            Require(facts["struct " + name + " size"] == Marshal.SizeOf(type), name + " has another size");
            var fields = type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
            foreach (var field in fields)
            {
                var label = string.Concat(Array.ConvertAll(field.Name.ToCharArray(), c => char.IsUpper(c) ? "_" + char.ToLowerInvariant(c) : c.ToString()));
                var key = "field " + name + "." + label + " offset";
                Require(facts.ContainsKey(key), "no " + key);
                Require(facts[key] == (int)Marshal.OffsetOf(type, field.Name), key + " differs");
                ++compared;
            }
        }
        return compared;
    }
}

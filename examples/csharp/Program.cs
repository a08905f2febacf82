// The main job: main_job FACE.safetensors EXPRESSIONS.safetensors SCAN.ply NEUTRAL.ply EARLIER.ply LATER.ply (fitted faces of two other visits)
using System;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Mien;

public static class Program
{
    public static void Main(string[] a)
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        using (Session session = new Session())
        using (Model face = Model.Load(session, a[0]))
        using (ExpressionModel expressions = ExpressionModel.Load(session, a[1]))
        using (Mesh file = Mesh.Load(session, a[2]))
        using (var scan = Mesh.Create(session, new MeshArrays { Positions = file.GetPositions(), Triangles = file.GetTriangles(), Colors = file.GetColors() }))
        using (var fitted = session.RegisterAsync(face, scan).Result)
        using (var neutral = session.Neutralize(expressions, fitted))
        using (var before = neutral.GetMesh())
        using (var after = fitted.GetMesh())
        {
            string reasons = Regex.Match(fitted.GetJson(), "\"reasons\":\\[\"?(.*?)\"?\\]").Groups[1].Value.Replace("\",\"", "; ");
            Console.WriteLine("verdict " + fitted.GetVerdict().Quality.ToString().ToUpperInvariant() + " " + reasons);
            before.Save(session, a[3]);
            var hash = System.Security.Cryptography.SHA256.Create().ComputeHash(before.GetPositionsF32().SelectMany(BitConverter.GetBytes).ToArray());
            Console.WriteLine("neutral " + string.Concat(hash.Select(b => b.ToString("x2"))));
            var x = face.GetMesh().GetPositions().Where((_, i) => i % 3 == 0).ToArray();
            Func<Func<double, bool>, uint[]> where = half => Enumerable.Range(0, x.Length).Where(i => half(x[i])).Select(i => (uint)i).ToArray();
            var zones = new[] { new Zone { Name = "left", Vertices = where(v => v > 0) }, new Zone { Name = "right", Vertices = where(v => v < 0) } };
            var moved = session.MeasureVolume(before, after, new MeasureOptions { Zones = zones, AfterSd = fitted.GetField(RegistrationKind.StandardDeviationMm) });
            foreach (var v in zones.Select((zone, i) => new { zone.Name, Of = moved.GetVolume(i) }))
                Console.WriteLine("zone {0} {1:F4} mL [{2:F4}, {3:F4}]", v.Name, v.Of.SignedMl, v.Of.Low95Ml, v.Of.High95Ml);
            var visits = session.NeutralizeVisits(expressions, new[] { Mesh.Load(session, a[4]), after, Mesh.Load(session, a[5]) });
            VisitsRemovedVolume removed = visits.GetRemovedVolume(0, 2);
            Console.WriteLine("visits {0}, removed {1:F4} mL, sd {2:F4} mL", string.Join(", ", Enumerable.Range(0, 3).Select(visits.GetExpression)), removed.RemovedMl, removed.SdMl);
            try { session.Register(face, scan, cancellationToken: new System.Threading.CancellationToken(true)); } catch (OperationCanceledException) { Console.WriteLine("cancelled"); }
        }
    }
}

// What changed in a face between visits, with intervals: ThreeVisits FACE.safetensors EXPRESSIONS.safetensors SCAN.ply ...
// The numbers are those of `mien report --visits FOLDER --model FACE --expressions EXPRESSIONS`.
using System;
using System.Globalization;
using System.Linq;
using Mien;

public static class ThreeVisits
{
    public static void Main(string[] a)
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        using (var session = new Session())
        using (var face = Model.Load(session, a[0]))
        using (var expressions = ExpressionModel.Load(session, a[1]))
        {
            var fits = a.Skip(2).Select(path => session.Register(face, Mesh.Load(session, path))).ToList();
            using (var study = Study.Create(session, fits, expressions))
            {
                StudyCounts counts = study.GetCounts();
                for (int visit = 1; visit < counts.VisitCount; ++visit)
                    for (int zone = 0; zone < counts.ZoneCount; ++zone)
                    {
                        StudyValue ml = study.GetChange(0, visit, zone).SignedMl;
                        Console.WriteLine("{0} {1,-24} {2,11:F6} {3,11:F6} {4,11:F6} {5,11:F6}", visit, study.GetZoneName(zone), ml.Value, ml.Low, ml.High, ml.LimitOfDetection);
                    }
            }
            fits.ForEach(fit => fit.Dispose());
        }
    }
}

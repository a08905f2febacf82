import java.util.*;
import mien.*;

/**
 * What changed in a face between visits, with intervals: ThreeVisits FACE.safetensors EXPRESSIONS.safetensors SCAN.ply ...
 * The numbers are those of `mien report --visits FOLDER --model FACE --expressions EXPRESSIONS`.
 */
public final class ThreeVisits {
    public static void main(String[] a) {
        try (Session session = new Session(); Model face = Model.load(session, a[0]);
             ExpressionModel expressions = ExpressionModel.load(session, a[1])) {
            List<Registration> fits = new ArrayList<>();
            for (String path : List.of(a).subList(2, a.length))
                try (Mesh scan = Mesh.load(session, path)) {
                    fits.add(session.register(face, scan));
                }
            try (Study study = Study.create(session, fits, expressions, null)) {
                for (int visit = 1; visit < study.counts().visitCount(); ++visit)
                    for (int zone = 0; zone < study.counts().zoneCount(); ++zone) {
                        StudyValue ml = study.change(0, visit, zone).signedMl();
                        System.out.printf(Locale.ROOT, "%d %-24s %11.6f %11.6f %11.6f %11.6f%n", visit, study.zoneName(zone),
                                          ml.value(), ml.low(), ml.high(), ml.limitOfDetection());
                    }
            }
            fits.forEach(Registration::close);
        }
    }
}

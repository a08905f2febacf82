import java.nio.*;
import java.security.MessageDigest;
import java.util.*;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import mien.*;

/** MainJob FACE.safetensors EXPRESSIONS.safetensors SCAN.ply NEUTRAL.ply EARLIER.ply LATER.ply (fitted faces of other visits). */
public final class MainJob {
    public static void main(String[] a) throws Exception {
        try (Session session = new Session(); Model face = Model.load(session, a[0]);
             ExpressionModel expressions = ExpressionModel.load(session, a[1]); Mesh file = Mesh.load(session, a[2]);
             Mesh scan = Mesh.create(session, new MeshArrays().positions(Values.of(file.positions())).triangles(file.triangles()).colors(file.colors()));
             Registration fitted = session.register(face, scan); Neutralization neutral = session.neutralize(expressions, fitted);
             Mesh before = neutral.mesh(); Mesh after = fitted.mesh()) {
            String quality = List.of("GOOD", "DOUBTFUL", "FAILED").get(fitted.verdict().quality());
            String reasons = fitted.json().replaceAll("(?s).*\"reasons\":\\[\"?(.*?)\"?\\].*", "$1").replace("\",\"", "; ");
            System.out.println("verdict " + quality + " " + reasons);
            before.save(session, a[3]);
            float[] positions = before.positionsF32();
            ByteBuffer bytes = ByteBuffer.allocate(4 * positions.length).order(ByteOrder.nativeOrder());
            bytes.asFloatBuffer().put(positions);
            System.out.println("neutral " + HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes.array())));
            double[] at = face.mesh().positions();
            List<Zone> zones = List.of(new Zone("left", IntStream.range(0, at.length / 3).filter(i -> at[3 * i] > 0).toArray()),
                                       new Zone("right", IntStream.range(0, at.length / 3).filter(i -> at[3 * i] < 0).toArray()));
            Measurement moved = session.measureVolume(before, after, new MeasureOptions().zones(zones)
                .afterSd(Values.of(fitted.field(RegistrationKind.STANDARD_DEVIATION_MM))));
            for (int i = 0; i < 2; ++i) {
                ZoneVolume v = moved.volume(i);
                System.out.printf(Locale.ROOT, "zone %s %.4f mL [%.4f, %.4f]%n", zones.get(i).name(), v.signedMl(), v.low95Ml(), v.high95Ml());
            }
            Visits visits = session.neutralizeVisits(expressions, List.of(Mesh.load(session, a[4]), after, Mesh.load(session, a[5])));
            VisitsRemovedVolume removed = visits.removedVolume(0, 2);
            System.out.printf(Locale.ROOT, "visits %s, %s, %s, removed %.4f mL, sd %.4f mL%n", visits.expression(0), visits.expression(1), visits.expression(2), removed.removedMl(), removed.sdMl());
            try { session.register(face, scan, null, (stage, fraction) -> false, null); } catch (CancellationException expected) { System.out.println("cancelled"); }
        }
    }
}

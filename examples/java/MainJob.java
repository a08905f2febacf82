import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import mien.CancelToken;
import mien.ExpressionModel;
import mien.Mesh;
import mien.MienException;
import mien.Model;
import mien.Neutralization;
import mien.Registration;
import mien.Session;

/**
 * From a raw scan to a neutral face:
 * MainJob FACE.safetensors EXPRESSIONS.safetensors SCAN.ply FITTED.ply NEUTRAL.ply [LANDMARKS.txt]
 * LANDMARKS.txt has a name and three coordinates on each line. MainJob --self-test needs no files.
 */
public final class MainJob {
    static Map<String, double[]> readLandmarks(String path) throws Exception {
        Map<String, double[]> landmarks = new LinkedHashMap<>();
        for (String line : Files.readAllLines(Path.of(path))) {
            String[] words = line.trim().split(" +");
            if (words.length == 4)
                landmarks.put(words[0], new double[] {Double.parseDouble(words[1]), Double.parseDouble(words[2]), Double.parseDouble(words[3])});
        }
        return landmarks;
    }

    static String hash(ByteBuffer bytes) throws Exception {
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        digest.update(bytes);
        StringBuilder text = new StringBuilder();
        for (byte b : digest.digest()) text.append(String.format("%02x", b));
        return text.toString();
    }

    public static void main(String[] arguments) throws Exception {
        if (arguments.length == 1 && arguments[0].equals("--self-test")) {
            selfTest();
            return;
        }
        int[] reports = {0};
        try (Session session = new Session();
             Model face = session.loadModel(arguments[0]);
             ExpressionModel expressions = session.loadExpressionModel(arguments[1]);
             Mesh scan = session.loadMesh(arguments[2])) {
            cancelsAndRethrows(session, face, scan);
            Map<String, double[]> landmarks = arguments.length > 5 ? readLandmarks(arguments[5]) : null;
            try (Registration fitted = session.register(face, scan, landmarks, (stage, fraction) -> ++reports[0] > 0, null);
                 Neutralization neutral = session.neutralize(expressions, fitted, null, null);
                 Mesh fittedMesh = fitted.mesh();
                 Mesh neutralMesh = neutral.mesh()) {
                session.saveMesh(fittedMesh, arguments[3]);
                session.saveMesh(neutralMesh, arguments[4]);
                System.out.println("neutral " + hash(neutralMesh.positionBytes()));
                System.out.println(String.format(Locale.ROOT, "volume %.6f mL", session.absoluteVolume(fittedMesh, neutralMesh)));
                require(reports[0] > 0, "no progress was reported");
            }
        } catch (MienException failure) {
            System.err.println(failure.statusName() + ": " + failure.getMessage());
            System.exit(1);
        }
    }

    static void require(boolean good, String what) {
        if (!good) throw new AssertionError(what);
    }

    /** A token stops a call; what a callback throws comes out of the call. */
    static void cancelsAndRethrows(Session session, Model face, Mesh scan) {
        try (CancelToken token = new CancelToken()) {
            session.register(face, scan, null, (stage, fraction) -> { token.request(); return true; }, token);
            throw new AssertionError("the token did not cancel");
        } catch (CancellationException expected) {
        }
        try {
            session.register(face, scan, null, (stage, fraction) -> { throw new ArithmeticException("mine"); }, null);
            throw new AssertionError("the callback's exception got lost");
        } catch (ArithmeticException expected) {
        }
    }

    /** What needs no files, from many threads at once: for -Xcheck:jni. */
    static void selfTest() throws Exception {
        try (Session session = new Session()) {
            Mesh shared = session.createMesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
            Thread[] threads = new Thread[8];
            Throwable[] failed = {null};
            for (int t = 0; t < threads.length; ++t) {
                threads[t] = new Thread(() -> {
                    try (Session own = new Session()) {
                        for (int i = 0; i < 300; ++i) {
                            require(shared.positions().get(3) == 1, "positions differ");
                            Mesh mesh = own.createMesh(new float[] {i, 0, 0}, null);
                            require(mesh.positions().get(0) == i, "a position differs");
                            if (i % 3 != 0) mesh.close();  // the rest is the cleaner's
                            mesh = null;
                            try {
                                own.loadMesh("/absent/f\u00e4ce.ply");
                                throw new AssertionError("an absent file loads");
                            } catch (MienException expected) {
                                require(expected.statusName().equals("MIEN_E_IO"), expected.getMessage());
                                require(expected.getMessage().contains("f\u00e4ce"), expected.getMessage());
                            }
                        }
                    } catch (Throwable throwable) {
                        failed[0] = throwable;
                    }
                });
                threads[t].start();
            }
            for (Thread thread : threads) thread.join();
            if (failed[0] != null) throw new AssertionError(failed[0]);
            shared.close();
            shared.close();
            try {
                shared.vertexCount();
                throw new AssertionError("a closed mesh answers");
            } catch (IllegalStateException expected) {
            }
            try {
                session.createMesh(new float[] {0, 0, 0, Float.NaN, 0, 0}, null);
                throw new AssertionError("NaN is accepted");
            } catch (MienException expected) {
                require(expected.detailIndex() == 1, "the wrong vertex is named");
            }
        }
        System.gc();
        System.out.println("self-test passed, version " + Session.version());
    }
}

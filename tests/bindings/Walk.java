import java.lang.reflect.*;
import java.nio.DoubleBuffer;
import java.nio.file.*;
import java.util.*;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import mien.*;

/** Walks the public classes: Walk FACE EXPRESSIONS SCAN DATASET FOLDER. Each method without arguments of each object; ownership, cancelling. */
public final class Walk {
    private static final Map<String, NativeObject> LIVE = new TreeMap<>();

    static <T extends NativeObject> T keep(T made) {
        LIVE.putIfAbsent(made.getClass().getSimpleName(), made);
        return made;
    }

    static void require(boolean good, String what) {
        if (!good) throw new AssertionError(what);
    }

    static void refuses(Class<? extends Throwable> kind, Runnable work) {
        try {
            work.run();
        } catch (Throwable thrown) {
            require(kind.isInstance(thrown), kind + " is expected, not " + thrown);
            return;
        }
        throw new AssertionError(kind + " is expected");
    }

    /** A sheet of 12 x 12 vertices, bent by who it is and by an expression. */
    static double[] smallFace(int person, int grin) {
        double[] places = new double[3 * 144];
        for (int v = 0; v < 144; ++v) {
            double x = v % 12, y = v / 12;
            places[3 * v] = x;
            places[3 * v + 1] = y;
            places[3 * v + 2] = x * y / 40 + 0.2 * person * Math.sin(0.5 * x + person) + 0.3 * grin * Math.cos(0.4 * y);
        }
        return places;
    }

    static Mesh grid(Session session) {
        double[] places = smallFace(0, 0);
        List<Integer> corners = new ArrayList<>();
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x) {
                int v = 12 * y + x;
                if (x < 11 && y < 11) corners.addAll(List.of(v, v + 1, v + 12, v + 1, v + 13, v + 12));
            }
        int[] triangles = corners.stream().mapToInt(Integer::intValue).toArray();
        return Mesh.create(session, new MeshArrays().positions(Values.of(places)).triangles(triangles).colors(new byte[places.length]));
    }

    /** What is learned from small faces. */
    static void keepSmall(Session session, Mesh small, String faces, String folder) throws Exception {
        ExpressionModel few = ExpressionModel.train(session, faces, new TrainOptions().identityModes(3).expressionModes(1));
        keep(session.evaluateNeutralization(few, faces));
        keep(BlendshapeModel.train(session, faces, "grin"));
        double[] grades = IntStream.range(0, 24).mapToDouble(k -> 0.5 * k).toArray();
        keep(ScoreModel.train(session, faces, grades, new ScoreOptions().folds(4).curvatureShare(0)));
        keep(Model.tune(session, small, faces, new TuneOptions().sigmasMm(new double[] {5}).numModes(6)));
        keep(Network.load(session, folder + "/walk_network.safetensors"));
        List<Zone> zones = List.of(new Zone("some", IntStream.range(0, 100).toArray()));
        keep(Study.createFromMeshes(session, List.of(small, small), null, null, null, new StudyOptions().zones(zones).stableZones(List.of("some"))));
        Path picked = Path.of(folder, "walk_landmarks.json");
        Files.writeString(picked, "{\"vertices\": {\"pronasale\": 70, \"subnasale\": 40, \"gnathion\": 6}}");
        keep(Norms.create(session, faces, Landmarks.load(session, picked.toString())));
    }

    /** The names of all classes that own a native object. */
    static Set<String> classes() throws Exception {
        Set<String> names = new TreeSet<>();
        Path folder = Path.of(NativeObject.class.getProtectionDomain().getCodeSource().getLocation().toURI()).resolve("mien");
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.class")) {
            for (Path file : files) {
                String name = file.getFileName().toString().replace(".class", "");
                if (Class.forName("mien." + name, false, Walk.class.getClassLoader()).getSuperclass() == NativeObject.class) names.add(name);
            }
        }
        return names;
    }

    static int callAll() throws Exception {
        int called = 0;
        for (NativeObject made : LIVE.values())
            for (Method method : made.getClass().getDeclaredMethods()) {
                if (method.getParameterCount() != 0 || Modifier.isStatic(method.getModifiers()) || !Modifier.isPublic(method.getModifiers())) continue;
                try {
                    method.invoke(made);
                } catch (InvocationTargetException thrown) {
                    require(thrown.getCause() instanceof MienException failure && failure.status() == Status.E_NOT_FOUND,
                            made.getClass() + "." + method.getName() + ": " + thrown.getCause());
                }
                ++called;
            }
        return called;
    }

    static long resident() throws Exception {
        Path file = Path.of("/proc/self/statm");
        return Files.exists(file) ? 4096 * Long.parseLong(Files.readString(file).split(" ")[1]) : 0;
    }

    /** What nobody closes goes with the garbage, by a Cleaner: far more than would fit beside it. */
    static void leaveToGarbage(Session session) throws Exception {
        double[] places = new double[3 * 100000];
        for (int k = 0; k < places.length; ++k) places[k] = k % 977;
        Values values = Values.of(places);
        long before = resident();
        for (int k = 0; k < 200; ++k) {
            Mesh.create(session, new MeshArrays().positions(values));
            if (k % 20 != 19) continue;
            System.gc();
            Thread.sleep(10);
        }
        long more = resident() - before;
        require(more < 240L << 20, "meshes that nobody holds were not given back: " + more + " bytes more");
    }

    /** Another thread interrupts a call in its middle, or requests its token. */
    static void stopFromOutside(Session session, Model face, Mesh scan) throws Exception {
        Thread caller = Thread.currentThread();
        for (boolean byInterrupt : new boolean[] {true, false}) {
            Cancel token = new Cancel();
            Thread other = new Thread(byInterrupt ? caller::interrupt : token::request);
            refuses(CancellationException.class, () -> session.register(face, scan, null, (stage, fraction) -> {
                if (fraction > 0.1 && other.getState() == Thread.State.NEW) other.start();
                return true;
            }, token));
            other.join();
            require(Thread.interrupted() == byInterrupt, "an interrupt stays to be seen, and a token leaves none");
        }
    }

    public static void main(String[] a) throws Exception {
        Session session = keep(new Session(new SessionOptions().numThreads(2)));
        keep(new Cancel());
        Model face = keep(Model.load(session, a[0]));
        ExpressionModel expressions = keep(ExpressionModel.load(session, a[1]));
        Mesh scan = Mesh.load(session, a[2]);
        Mesh template = keep(face.mesh());
        Registration fitted = keep(session.register(face, scan, new RegisterOptions().iterations(2).closeGap(0)));
        Neutralization neutral = keep(session.neutralize(expressions, fitted));
        keep(session.neutralizeVisits(expressions, List.of(fitted.mesh(), neutral.mesh())));
        keep(session.neutralizeSeries(expressions, List.of(fitted.mesh(), neutral.mesh())));
        keep(session.measureVolume(neutral.mesh(), fitted.mesh(), new MeasureOptions().zones(List.of(new Zone("some", IntStream.range(0, 100).toArray())))));
        Mesh small = grid(session);
        keep(SpectralBasis.build(session, small, new SpectralBasisOptions().modeCount(8)));
        keep(Hierarchy.buildQuadric(session, small, 1, 2.0));
        keep(Representation.train(session, a[3], Features.EUCLIDEAN, 1));
        DatasetWriter writer = keep(DatasetWriter.create(session, small, List.of("neutral", "grin")));
        for (int k = 0; k < 24; ++k) writer.add(Values.of(smallFace(k / 2, k % 2)), k / 2, k % 2);
        String faces = a[4] + "/walk.safetensors";
        writer.save(session, faces);
        keepSmall(session, small, faces, a[4]);
        Landmarks named = keep(face.landmarks());
        keep(face.zones());
        keep(session.measureAnthropometry(template, named));
        keep(ReadyScan.create(session, scan));
        Batch batch = keep(Batch.create(session, face));
        batch.add(session, scan, new RegisterOptions().iterations(1).closeGap(0));
        batch.run(session);
        require(batch.counts().runCount() == 1, "a batch of one");
        keep(Follower.create(session, face, fitted));
        int called = callAll();

        DoubleBuffer view = template.positionsView();
        double first = view.get(0);
        template.close();
        template.close();
        face.close();
        System.gc();
        require(view.get(0) == first, "a view outlives its mesh");
        refuses(IllegalStateException.class, template::counts);
        refuses(MienException.class, () -> Mesh.load(session, "/absent/f\u00e4ce.ply"));
        refuses(IllegalArgumentException.class, () -> session.measureLengths(small, new int[] {1, 2, 3}));
        refuses(IllegalArgumentException.class, () -> Mesh.create(session, new MeshArrays().positions(Values.of(0, 0, 0)).colors(new byte[6])));
        Model again = Model.load(session, a[0]);
        refuses(ArithmeticException.class, () -> session.register(again, scan, null, (stage, fraction) -> { throw new ArithmeticException("mine"); }, null));
        Cancel token = new Cancel();
        refuses(CancellationException.class, () -> session.register(again, scan, null, (stage, fraction) -> { token.request(); return true; }, token));
        Thread.currentThread().interrupt();
        refuses(CancellationException.class, () -> session.register(again, scan));
        require(Thread.interrupted(), "an interrupt stays to be seen");
        stopFromOutside(session, again, scan);
        leaveToGarbage(session);
        Set<String> classes = classes(), others = new TreeSet<>(classes);
        others.removeAll(LIVE.keySet());
        require(others.isEmpty(), "not walked: " + others);
        System.out.println("walked " + LIVE.size() + " of " + classes.size() + " classes (" + called + " methods), version " + Information.versionString());
    }
}

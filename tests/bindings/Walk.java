import java.lang.reflect.*;
import java.nio.DoubleBuffer;
import java.util.*;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import mien.*;

/** Walks the public classes: Walk FACE EXPRESSIONS SCAN DATASET FOLDER. Each method without arguments of each object. */
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

    static Mesh grid(Session session) {
        double[] places = new double[3 * 144];
        List<Integer> corners = new ArrayList<>();
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x) {
                int v = 12 * y + x;
                places[3 * v] = x;
                places[3 * v + 1] = y;
                places[3 * v + 2] = x * y / 40.0;
                if (x < 11 && y < 11) corners.addAll(List.of(v, v + 1, v + 12, v + 1, v + 13, v + 12));
            }
        int[] triangles = corners.stream().mapToInt(Integer::intValue).toArray();
        return Mesh.create(session, new MeshArrays().positions(Values.of(places)).triangles(triangles).colors(new byte[places.length]));
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
        writer.add(Values.of(small.positions()), 0, 0);
        writer.save(session, a[4] + "/walk.safetensors");
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
        require(LIVE.size() >= 14, "walked only " + LIVE.keySet());
        System.out.println("walked " + LIVE.size() + " classes (" + called + " methods), version " + Information.versionString());
    }
}

import static java.lang.foreign.ValueLayout.ADDRESS;
import static java.lang.foreign.ValueLayout.JAVA_BYTE;
import static java.lang.foreign.ValueLayout.JAVA_DOUBLE;
import static java.lang.foreign.ValueLayout.JAVA_FLOAT;
import static java.lang.foreign.ValueLayout.JAVA_INT;
import static java.lang.foreign.ValueLayout.JAVA_LONG;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemoryLayout;
import java.lang.foreign.MemoryLayout.PathElement;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.StructLayout;
import java.lang.foreign.SymbolLookup;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.concurrent.CancellationException;

/**
 * From a raw scan to a neutral face without a line of C, by the Foreign Function API of Java 22 and later:
 * java --enable-native-access=ALL-UNNAMED -Dmien.library=libmien.so MainJobForeign.java
 *      FACE.safetensors EXPRESSIONS.safetensors SCAN.ply FITTED.ply NEUTRAL.ply
 */
public final class MainJobForeign {
    static final int ABI_VERSION = 0, DTYPE_F32 = 1, CANCELLED = -16;
    static final Arena FOREVER = Arena.global();
    static final Linker LINKER = Linker.nativeLinker();
    static final SymbolLookup LIBRARY = SymbolLookup.libraryLookup(Path.of(System.getProperty("mien.library")), FOREVER);

    static final StructLayout ERROR = MemoryLayout.structLayout(
        JAVA_INT.withName("struct_size"), JAVA_INT.withName("status"), JAVA_LONG.withName("detail_index"),
        MemoryLayout.sequenceLayout(256, JAVA_BYTE).withName("message"));
    // Only what this program sets has a name; the library fills in the rest.
    static final StructLayout REGISTER_OPTIONS = MemoryLayout.structLayout(
        JAVA_INT.withName("struct_size"), MemoryLayout.paddingLayout(220), ADDRESS.withName("progress"),
        ADDRESS.withName("progress_user"), ADDRESS.withName("cancel"));

    static long offset(StructLayout layout, String field) { return layout.byteOffset(PathElement.groupElement(field)); }

    static MemoryLayout kindOf(Object argument) {
        if (argument instanceof MemorySegment) return ADDRESS;
        return argument instanceof Integer ? JAVA_INT : argument instanceof Long ? JAVA_LONG : JAVA_DOUBLE;
    }

    /** Any function of the library, by name; `result` is null for void. */
    static Object invoke(MemoryLayout result, String name, Object... arguments) {
        MemoryLayout[] kinds = new MemoryLayout[arguments.length];
        for (int i = 0; i < kinds.length; ++i) kinds[i] = kindOf(arguments[i]);
        MethodHandle function = LINKER.downcallHandle(LIBRARY.find(name).orElseThrow(),
            result == null ? FunctionDescriptor.ofVoid(kinds) : FunctionDescriptor.of(result, kinds));
        try {
            return function.invokeWithArguments(arguments);
        } catch (Throwable broken) {
            throw new IllegalStateException(name, broken);
        }
    }

    /** A function that returns a status; its error record comes last. */
    static void call(String name, Object... arguments) {
        try (Arena arena = Arena.ofConfined()) {
            MemorySegment error = arena.allocate(ERROR);
            error.set(JAVA_INT, 0, (int) ERROR.byteSize());
            Object[] all = java.util.Arrays.copyOf(arguments, arguments.length + 1);
            all[arguments.length] = error;
            int status = (int) invoke(JAVA_INT, name, all);
            if (status == CANCELLED) throw new CancellationException(name);
            if (status != 0)
                throw new IllegalStateException(name + ": " + error.asSlice(offset(ERROR, "message")).getString(0));
        }
    }

    /** A new handle of a type, released with the arena; the library allows any order. */
    static MemorySegment make(Arena arena, String type, String name, Object... arguments) {
        MemorySegment out = arena.allocate(ADDRESS);
        Object[] all = java.util.Arrays.copyOf(arguments, arguments.length + 1);
        all[arguments.length] = out;
        call(name, all);
        return out.get(ADDRESS, 0).reinterpret(arena, handle -> invoke(null, type + "_release", handle));
    }

    // What a callback throws must not unwind through C: it is kept, and the call is cancelled.
    static Throwable thrown;
    static int reports;
    static Runnable onReport = () -> {};

    static int progress(MemorySegment user, int stage, double fraction) {
        try {
            ++reports;
            onReport.run();
            return 0;
        } catch (Throwable mine) {
            thrown = mine;
            return 1;
        }
    }

    static MemorySegment register(Arena arena, MemorySegment session, MemorySegment face, MemorySegment scan, MemorySegment cancel)
            throws Exception {
        MethodHandle target = MethodHandles.lookup().findStatic(MainJobForeign.class, "progress",
            MethodType.methodType(int.class, MemorySegment.class, int.class, double.class));
        MemorySegment options = arena.allocate(REGISTER_OPTIONS);
        invoke(null, "mien_register_options_init", options, REGISTER_OPTIONS.byteSize());
        options.set(ADDRESS, offset(REGISTER_OPTIONS, "progress"),
            LINKER.upcallStub(target, FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_DOUBLE), arena));
        options.set(ADDRESS, offset(REGISTER_OPTIONS, "cancel"), cancel);
        return make(arena, "mien_registration", "mien_register", session, face, scan, options);
    }

    static void require(boolean good, String what) {
        if (!good) throw new AssertionError(what);
    }

    /** A token stops a call; what a callback throws is not lost. */
    static void cancelsAndRethrows(MemorySegment session, MemorySegment face, MemorySegment scan) throws Exception {
        try (Arena arena = Arena.ofConfined()) {
            MemorySegment cancel = make(arena, "mien_cancel", "mien_cancel_create");
            onReport = () -> invoke(null, "mien_cancel_request", cancel);
            register(arena, session, face, scan, cancel);
            throw new AssertionError("the token did not cancel");
        } catch (CancellationException expected) {
            require(thrown == null, "a callback failed: " + thrown);
        }
        try (Arena arena = Arena.ofConfined()) {
            onReport = () -> { throw new ArithmeticException("mine"); };
            register(arena, session, face, scan, MemorySegment.NULL);
            throw new AssertionError("the callback's exception got lost");
        } catch (CancellationException expected) {
            require(thrown instanceof ArithmeticException, "another exception came back: " + thrown);
        }
        onReport = () -> {};
    }

    public static void main(String[] paths) throws Exception {
        try (Arena arena = Arena.ofConfined()) {
            MemorySegment session = make(arena, "mien_session", "mien_session_create", ABI_VERSION);
            MemorySegment face = make(arena, "mien_model", "mien_model_load", session, arena.allocateFrom(paths[0]));
            MemorySegment expressions =
                make(arena, "mien_expression_model", "mien_expression_model_load", session, arena.allocateFrom(paths[1]));
            MemorySegment scan = make(arena, "mien_mesh", "mien_mesh_load", session, arena.allocateFrom(paths[2]));
            cancelsAndRethrows(session, face, scan);
            MemorySegment fitted = register(arena, session, face, scan, MemorySegment.NULL);
            MemorySegment neutral =
                make(arena, "mien_neutralization", "mien_neutralize", session, expressions, fitted, MemorySegment.NULL);
            MemorySegment fittedMesh = (MemorySegment) invoke(ADDRESS, "mien_registration_mesh", fitted);
            MemorySegment neutralMesh = (MemorySegment) invoke(ADDRESS, "mien_neutralization_mesh", neutral);
            call("mien_mesh_save", session, fittedMesh, arena.allocateFrom(paths[3]));
            call("mien_mesh_save", session, neutralMesh, arena.allocateFrom(paths[4]));

            MemorySegment count = arena.allocate(JAVA_LONG);
            call("mien_mesh_get_counts", neutralMesh, count, MemorySegment.NULL);
            MemorySegment positions = arena.allocate(JAVA_FLOAT, 3 * count.get(JAVA_LONG, 0));
            call("mien_mesh_get_positions", neutralMesh, DTYPE_F32, positions, count.get(JAVA_LONG, 0), MemorySegment.NULL);
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update(positions.asByteBuffer());
            System.out.println("neutral " + HexFormat.of().formatHex(digest.digest()));
            require(reports > 0, "no progress was reported");
        }
    }
}

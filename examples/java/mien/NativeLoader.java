package mien;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;

/**
 * Finds the native library. System properties: mien.binding is "jni" or "foreign" (else: JNI, and on Java 22 or later
 * the Foreign Function API where no JNI library is found); mien.library and mien.jni are paths. Without them the natives
 * inside the jar are unpacked, and without those the system is searched.
 */
final class NativeLoader {
    private NativeLoader() {}

    static Raw load() {
        String binding = System.getProperty("mien.binding", "");
        if (binding.equals("foreign")) return foreign();
        try {
            return jni();
        } catch (UnsatisfiedLinkError missing) {
            if (binding.equals("jni") || Runtime.version().feature() < 22) throw missing;
            return foreign();
        }
    }

    private static Raw jni() {
        String library = System.getProperty("mien.library");
        if (library == null) library = unpack(libraryName());
        if (library != null) System.load(Path.of(library).toAbsolutePath().toString());  // before the JNI library, which names it
        String path = System.getProperty("mien.jni");
        if (path == null) path = unpack(System.mapLibraryName("mien_jni"));
        if (path != null) System.load(Path.of(path).toAbsolutePath().toString());
        else System.loadLibrary("mien_jni");
        return new RawJni();
    }

    private static Raw foreign() {
        try {
            return (Raw) Class.forName("mien.RawForeign").getDeclaredConstructor().newInstance();
        } catch (ReflectiveOperationException | LinkageError thrown) {
            throw new UnsatisfiedLinkError("the Foreign Function API cannot be used: " + thrown + (thrown.getCause() == null ? "" : ", " + thrown.getCause()));
        }
    }

    static String libraryName() {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        return system.startsWith("windows") ? "mien-0.dll" : system.startsWith("mac") ? "libmien.0.dylib" : "libmien.so.0";
    }

    static String machine() {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        String os = system.startsWith("windows") ? "windows" : system.startsWith("mac") ? "macos" : "linux";
        return os + "-" + (System.getProperty("os.arch").matches("aarch64|arm64") ? "aarch64" : "x86_64");
    }

    private static Path folder;

    /** The path of a native file from the jar, unpacked; null where the jar has none. */
    static synchronized String unpack(String name) {
        try (InputStream in = NativeLoader.class.getResourceAsStream("/META-INF/native/" + machine() + "/" + name)) {
            if (in == null) return null;
            if (folder == null) {
                folder = Files.createTempDirectory("mien");
                folder.toFile().deleteOnExit();
            }
            Path path = folder.resolve(name);
            Files.copy(in, path, StandardCopyOption.REPLACE_EXISTING);
            path.toFile().deleteOnExit();
            return path.toString();
        } catch (IOException failure) {
            throw new UnsatisfiedLinkError("cannot unpack " + name + ": " + failure.getMessage());
        }
    }
}

package mien;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.SymbolLookup;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.nio.file.Path;

/** The library as the Foreign Function API sees it. */
final class ForeignLibrary {
    private final SymbolLookup symbols;
    final long progress, log;

    ForeignLibrary() {
        if (ValueLayout.ADDRESS.byteSize() != 8) throw new UnsupportedOperationException("64-bit machines only");
        String path = System.getProperty("mien.library");
        if (path == null) path = NativeLoader.unpack(NativeLoader.libraryName());
        symbols = path == null ? SymbolLookup.libraryLookup(NativeLoader.libraryName(), Arena.global())
                               : SymbolLookup.libraryLookup(Path.of(path), Arena.global());
        progress = upcall("progress", int.class, FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.JAVA_LONG,
                          ValueLayout.JAVA_INT, ValueLayout.JAVA_DOUBLE), long.class, int.class, double.class);
        log = upcall("log", void.class, FunctionDescriptor.ofVoid(ValueLayout.JAVA_LONG, ValueLayout.JAVA_INT, ValueLayout.JAVA_LONG),
                     long.class, int.class, long.class);
    }

    private static long upcall(String name, Class<?> result, FunctionDescriptor descriptor, Class<?>... parameters) {
        try {
            MethodHandle target = MethodHandles.lookup().findStatic(Callbacks.class, name, MethodType.methodType(result, parameters));
            return Linker.nativeLinker().upcallStub(target, descriptor, Arena.global()).address();
        } catch (ReflectiveOperationException impossible) {
            throw new AssertionError(impossible);
        }
    }

    MethodHandle find(String name, FunctionDescriptor descriptor) {
        return Linker.nativeLinker().downcallHandle(
            symbols.find(name).orElseThrow(() -> new UnsatisfiedLinkError("the native library has no " + name + "(): it is older than this jar")),
            descriptor);
    }

    static RuntimeException unexpected(Throwable thrown) {
        if (thrown instanceof RuntimeException) return (RuntimeException) thrown;
        if (thrown instanceof Error) throw (Error) thrown;
        return new IllegalStateException(thrown);
    }
}

"""Java: the package examples/java/mien (classes), its raw functions through JNI (RawJni.java, mien_jni.c) and through
the Foreign Function API (foreign/mien/RawForeign.java).

Raw functions take and return numbers alone: addresses and handles are long. Structs are written into direct
memory at the offsets that all 64-bit machines share (abi/layout); mien_jni.c has the compiler check them.
"""
from documentation import base_of
from host_plan import camel, element, host_words, lent_class, lower_camel, number_result, owns_count, scalars_first, sentences, visible_fields
from write_classes import SIZES, Body, Dialect, doc_lines, escape, ordered

NUMBERS = {"int32_t": "int", "uint32_t": "int", "int64_t": "long", "uint64_t": "long", "size_t": "long", "double": "double",
           "float": "float", "uint8_t": "byte", "char": "byte"}
BOXES = {"int": "Int", "long": "Long", "double": "Double", "float": "Float", "byte": "Byte"}
WORDS = {"default", "native", "final", "static", "this", "class", "public", "private", "new", "package", "import", "enum"}
NOTE = "// Written by abi/generate_bindings.py."


def word(name):
    text = lower_camel(name)
    return text + "_" if text in WORDS else text


def layouts(interface):
    """{struct: (size, {field: offset})} of machines with 8-byte pointers and natural alignment."""
    found, structs = {}, {s.name: s for s in interface.structs}

    def one(name):
        if name in found:
            return found[name]
        at, widest, places = 0, 1, {}
        for f in structs[name].fields:
            if "*" in f.type or f.role == "callback":
                size = align = 8
            elif f.base in structs:
                size, places_of = one(f.base)[:2]
                align = one(f.base)[2]
            else:
                align = SIZES[element(f.base, interface)]
                size = align * (f.count[0] if f.role in ("fixed", "chars") else 1)
            at = (at + align - 1) // align * align
            places[f.name] = at
            at, widest = at + size, max(widest, align)
        found[name] = ((at + widest - 1) // widest * widest, places, widest)
        return found[name]

    for s in interface.structs:
        one(s.name)
    return found


class Java(Dialect):
    name = "java"
    functions = "Raw.GET."
    error = "call.error()"
    capacity_argument = "capacity"
    address_type = "Memory"
    cancel_argument = "cancel"

    def __init__(self, plan):
        super().__init__(plan)
        self.abi_version = str(plan.interface.abi_version)
        self.layouts = layouts(plan.interface)

    def helper(self, name):
        return name

    def argument(self, name):
        return word(name)

    def local(self, name):
        return word(name)

    def counts_member(self, receiver, name):
        return f"{receiver}.counts().{word(name)}()"

    def by_value(self, p, expression, counted=False):
        kind = NUMBERS[element(p.base, self.interface)]
        return f"({kind}) {expression}" if counted and kind != "long" else expression

    def pointer(self, expression):
        return f"Memory.address({expression})"

    def fresh_options(self, base, host, nullable):
        return f"({host} == null ? new {camel(base)}() : {host})" if nullable else f'call.required({host}, "options")'

    def write_record(self, p, host):
        required = "false" if p.nullable else "true"
        return f'call.record({host}, {self.layouts[p.base][0]}, {required}, "{p.name}")'

    def write_records(self, p, host):
        return f"call.records({host}, {self.layouts[p.base][0]})"

    def fresh_record(self, base):
        return f"call.sized({self.layouts[base][0]})"

    def record_size(self, base):
        return self.layouts[base][0]

    def read_records(self, p, at, count):
        return f"call.readRecords({at}, {count}, {self.layouts[p.base][0]}, {camel(p.base)}::read)"

    def read_number(self, p, at):
        return f"{at}.bytes.get{BOXES[NUMBERS[element(p.base, self.interface)]]}(0)".replace("getByte(", "get(")

    def array_reader(self, kind):
        return f"read{BOXES[NUMBERS[kind]]}s"

    def view(self, body, at, total, kind):
        return f"call.lend({at}, {total} * {SIZES[kind]}, this).as{BOXES[NUMBERS[kind]]}Buffer()"

    def plain_result(self, f, call):
        return f"return Call.text({call});" if f.result == "const char*" else f"return {call};" if f.result != "void" else call + ";"


def host_type(item, plan):
    if item.role in ("array", "bytes", "fixed"):
        return ("byte" if item.base == "void" else NUMBERS[element(item.base, plan.interface)]) + "[]"
    if item.role == "matrix":
        return "Values"
    if item.role in ("text", "chars"):
        return "String"
    if item.role == "texts":
        return "java.util.List<String>"
    if item.role in ("handles", "structs"):
        return f"java.util.List<{camel(item.base)}>"
    if item.role in ("handle", "struct", "handle_out", "struct_out"):
        return camel(item.base)
    if item.role == "callback":
        return "LogListener"
    return NUMBERS[element(item.base, plan.interface)]


def output_type(item, plan, dtype=None):
    if item.role == "text_out":
        return "String"
    if item.role == "structs_out":
        return f"java.util.List<{camel(item.base)}>"
    if item.role == "array_out":
        return NUMBERS[dtype or element(item.base, plan.interface)] + "[]"
    if item.role == "view_out":
        return f"java.nio.{BOXES[NUMBERS[element(item.base, plan.interface)]]}Buffer"
    return host_type(item, plan)


def javadoc(words, tags, indent):
    rows = sentences(escape(words).replace("*/", "* /"), 110, " * ")
    for tag, text in tags:
        rows += sentences(f"@{tag} {escape(text)}", 110, " * ")
    if len(rows) == 1:
        return [f"{indent}/** {rows[0][3:]} */"]
    return [f"{indent}/**"] + [indent + r for r in rows] + [f"{indent} */"] if rows else []


def enum_note(item, plan):
    return f" See {plan.enums[item.enum]}." if item.enum else ""


def get(f, s, dialect, plan):
    """The expression that reads a field of a struct in direct memory."""
    place = dialect.layouts[s.name][1][f.name]
    if f.role == "struct":
        return f"{camel(f.base)}.read(call, at, offset + {place})"
    if f.role == "fixed":
        return f"at.doubles(offset + {place}, {f.count[0]})"
    kind = NUMBERS[element(f.base, plan.interface)]
    return f"at.bytes.get{BOXES[kind]}(offset + {place})".replace("getByte(", "get(")


def put(f, s, host, dialect, plan):
    """Statements that write a field of a struct into direct memory."""
    places = dialect.layouts[s.name][1]
    at, optional = f"offset + {places[f.name]}", "OrNull" if f.nullable else ""
    address = lambda expression: [f"at.bytes.putLong({at}, Memory.address({expression}));"]  # noqa: E731
    if f.role == "scalar":
        kind = NUMBERS[element(f.base, plan.interface)]
        return [f"at.bytes.put{BOXES[kind]}({at}, {host});".replace("putByte(", "put(")]
    if f.role == "struct":
        return [f'call.required({host}, "{f.name}").fill(call, at, {at});']
    if f.role == "fixed":
        return [f'at.put({at}, {host}, {f.count[0]}, "{f.name}");']
    if f.role == "text":
        return address(f"call.text{optional}({host})")
    if f.role == "handle":
        return address(f"call.use{optional}({host})")
    if f.role == "matrix":
        return [f'call.matrix(at, {at}, {host}, {f.count[0]}, "{f.name}");']
    if f.role == "callback":
        return [f"at.bytes.putLong({at}, call.logFunction({host}));", f"at.bytes.putLong({at} + 8, call.logUser({host}));"]
    columns = " * ".join(str(c) if isinstance(c, int) else f"at.bytes.getInt(offset + {places[c]})" for c in f.count[1:]) or "1"
    rows = f'call.rows({host}, {columns}, "{f.name}")'
    lines = [] if f.nullable else [f'call.required({host}, "{f.name}");']
    if f.role == "structs":
        lines += address(f"call.records({host}, {dialect.layouts[f.base][0]})")
    else:
        lines += address(f"call.{'texts' if f.role == 'texts' else 'array'}({host})")
    first = str(f.count[0])
    if "." in first:
        holder, _, inner = first.partition(".")
        base = next(c.base for c in s.fields if c.name == holder)
        place = places[holder] + dialect.layouts[base][1][inner]
        lines.append(f'if ({host} != null) call.agree("{f.name}", {rows}, at.bytes.getLong(offset + {place}));')
    elif not owns_count(f, s):
        kind = NUMBERS[element(next(c.base for c in s.fields if c.name == first), plan.interface)]
        lines.append(f'if ({host} != null) call.agree("{f.name}", {rows}, at.bytes.get{BOXES[kind]}(offset + {places[first]}));')
    else:
        kind = NUMBERS[element(next(c.base for c in s.fields if c.name == first), plan.interface)]
        lines.append(f"at.bytes.put{BOXES[kind]}(offset + {places[first]}, {'' if kind == 'long' else '(' + kind + ') '}{rows});")
    return lines


def options_class(s, plan, dialect):
    name, fields, size = camel(s.name), visible_fields(s), dialect.layouts[s.name][0]
    places = dialect.layouts[s.name][1]
    lines = ["package mien;", "", NOTE] + javadoc(host_words(s.comment) or f"{s.name} of the C interface.", [], "")
    lines += [f"public final class {name} implements Record_ {{"]
    lines += [f"    private {host_type(f, plan)} {word(f.name)};" for f in fields]
    lines += ["", "    /** With the library's defaults. */", f"    public {name}() {{"]
    read = [f for f in fields if f.role in ("scalar", "fixed")]
    if read:
        lines += ["        try (Call call = new Call()) {", f"            Memory at = call.room({size});", "            int offset = 0;",
                  f"            Raw.GET.{s.name}_init(at.address, {size});"]
        lines += [f"            {word(f.name)} = {get(f, s, dialect, plan)};" for f in read] + ["        }"]
    lines += ["    }"]
    for f in fields:
        lines += [""] + javadoc(host_words(f.comment) + enum_note(f, plan), [], "    ")
        lines += [f"    public {name} {word(f.name)}({host_type(f, plan)} value) {{", f"        {word(f.name)} = value;", "        return this;", "    }"]
        lines += [f"    public {host_type(f, plan)} {word(f.name)}() {{ return {word(f.name)}; }}"]
    lines += ["", "    @Override", "    public void fill(Call call, Memory at, int offset) {", f"        Raw.GET.{s.name}_init(at.address + offset, {size});"]
    for f in scalars_first(fields):
        lines += ["        " + line for line in put(f, s, word(f.name), dialect, plan)]
    lines += ["    }"]
    if {"progress", "cancel"} <= {f.name for f in s.fields}:
        lines += ["", "    Memory write(Call call, Progress progress, Cancel cancel) {", f"        Memory at = call.room({size});", "        fill(call, at, 0);",
                  f"        at.bytes.putLong({places['progress']}, call.progressFunction(progress));",
                  f"        at.bytes.putLong({places['progress_user']}, call.progressUser());",
                  f"        at.bytes.putLong({places['cancel']}, Memory.address(call.useOrNull(cancel)));", "        return at;", "    }"]
    return "\n".join(lines + ["}"]) + "\n"


def record_class(s, plan, dialect, given):
    """A record: a value that is given, or a result."""
    name, fields = camel(s.name), visible_fields(s)
    components = ", ".join(f"{host_type(f, plan)} {word(f.name)}" for f in fields)
    tags = [(f"param {word(f.name)}", host_words(f.comment) + enum_note(f, plan)) for f in fields]
    lines = ["package mien;", "", NOTE] + javadoc(host_words(s.comment) or f"{s.name} of the C interface.", tags, "")
    lines += [f"public record {name}({components}){' implements Record_' if given else ''} {{"]
    if given:
        lines += ["    @Override", "    public void fill(Call call, Memory at, int offset) {"]
        for f in scalars_first(fields):
            lines += ["        " + line for line in put(f, s, word(f.name), dialect, plan)]
        lines += ["    }"]
    if all(f.role in ("scalar", "fixed", "struct") for f in fields):
        lines += ["", f"    static {name} read(Call call, Memory at, int offset) {{", f"        return new {name}("]
        lines += [",\n".join(f"            {get(f, s, dialect, plan)}" for f in fields) + ");", "    }"]
    return "\n".join(lines + ["}"]) + "\n"


def method_text(m, plan, dialect, dtype=None):
    f, indent = m.function, "    "
    inputs = ordered(m.inputs)
    if f.lends:
        returned = lent_class(f)
    elif m.result:
        returned = m.result
    elif m.outputs:
        returned = output_type(m.outputs[0], plan, dtype)
    else:
        number = number_result(f, plan.interface)
        returned = "String" if f.result == "const char*" else NUMBERS[number] if number else "void"
    name = word(m.name) + ("F32" if dtype == "float" else "")
    static = "static " if m.static else ""
    words, documented, errors = doc_lines(m)
    by_name = {p.name: p for p in inputs}
    tags = [(f"param {word(a)}", t + enum_note(by_name[a], plan)) for a, t in documented]
    full = [(host_type(p, plan), word(p.name)) for p in inputs]
    if m.options is not None:
        full += [("Progress", "progress"), ("Cancel", "cancel")]
        tags += [("param progress", "may be null; returns false to cancel"), ("param cancel", "may be null; interrupting the thread cancels as well")]
    if errors:
        tags.append(("throws MienException", errors))
    tags.append(("see", f"&lt;mien/{f.header}&gt; {f.name}()")) if False else None
    lines = javadoc(f"{words} C: {f.name}().", tags, indent)
    lines += [f"{indent}public {static}{returned} {name}({', '.join(' '.join(p) for p in full)}) {{"]
    body = Body(m, dialect, dtype).write()
    if any("call." in line for line in body):
        body = ["try (Call call = new Call()) {"] + ["    " + line for line in body] + ["}"]
    lines += [f"{indent}    {line}" for line in body] + [f"{indent}}}", ""]
    shorter, seen = [[p for p in inputs if not p.nullable], inputs], {len(full)}
    for some in shorter:
        if len(some) in seen:
            continue
        seen.add(len(some))
        given = {p.name for p in some}
        passed = [word(p.name) if p.name in given else "null" for p in inputs] + (["null", "null"] if m.options is not None else [])
        lines += javadoc(f"{words} All else as by default.", [], indent)
        lines += [f"{indent}public {static}{returned} {name}({', '.join(f'{host_type(p, plan)} {word(p.name)}' for p in some)}) {{",
                  f"{indent}    {'return ' if returned != 'void' else ''}{name}({', '.join(passed)});", f"{indent}}}", ""]
    return lines


def handle_class(handle, methods, plan, dialect):
    name = camel(handle)
    lines = ["package mien;", "", NOTE] + javadoc(host_words(plan.interface.handles[handle]), [], "")
    lines += [f"public final class {name} extends NativeObject {{", f"    {name}(long owned) {{ super(owned, Raw.GET::{handle}_release); }}", ""]
    makers = {m.name: m for m in methods}
    plain = makers.get("create") if makers.get("create") and not makers["create"].inputs else None
    fuller = makers.get("create_with_options") if plain else None
    for maker in filter(None, (plain, fuller)):
        arguments = ", ".join(f"{host_type(p, plan)} {word(p.name)}" for p in maker.inputs)
        lines += javadoc(host_words(maker.function.purpose), [], "    ")
        lines += [f"    public {name}({arguments}) {{ super({word(maker.name)}({', '.join(word(p.name) for p in maker.inputs)})); }}", ""]
    if f"{handle}_retain" in plan.lifetime:
        lines += ["    /** One more object for the same native one: each may be closed by itself. */", f"    public {name} share() {{",
                  "        try (Call call = new Call()) {", "            long at = call.use(this);", f"            Raw.GET.{handle}_retain(at);",
                  f"            return new {name}(at);", "        }", "    }", ""]
    for m in methods:
        for dtype in (("double", "float") if m.dtype is not None else (None,)):
            lines += method_text(m, plan, dialect, dtype)
    lines[-1:] = ["}"]
    return "\n".join(lines) + "\n"


def files(plan):
    """(file name, text) of the generated classes."""
    dialect, interface = Java(plan), plan.interface
    outputs = {p.base for methods in [*plan.classes.values(), plan.library] for m in methods for p in m.outputs}
    for group in interface.groups:
        prefix = "MIEN_" if group.name == "STATUS" else f"MIEN_{group.name}_"
        name = plan.enums[group.name]
        lines = ["package mien;", "", NOTE] + javadoc((host_words(group.comment) or f"MIEN_{group.name}_* of the C interface.") +
                                                     " Plain numbers: newer libraries may have more.", [], "")
        lines += [f"public final class {name} {{", f"    private {name}() {{}}"]
        for c in group.constants:
            lines += [""] + javadoc(host_words(c.comment), [], "    ") + [f"    public static final int {c.name[len(prefix):]} = {c.value};"]
        yield name, "\n".join(lines + ["}"]) + "\n"
    for s in interface.structs:
        if s.name in ("mien_error", "mien_array_view"):
            continue
        if s.use == "options":
            yield camel(s.name), options_class(s, plan, dialect)
        else:
            yield camel(s.name), record_class(s, plan, dialect, s.use == "value" and s.name not in outputs)
    for name, results in plan.results.items():
        components = ", ".join(f"{output_type(p, plan)} {word(p.name)}" for p in results)
        tags = [(f"param {word(p.name)}", host_words(p.comment) or p.name) for p in results]
        yield name, "\n".join(["package mien;", "", NOTE, *javadoc("What comes out of one call.", tags, ""), f"public record {name}({components}) {{}}"]) + "\n"
    for handle, methods in plan.classes.items():
        yield camel(handle), handle_class(handle, methods, plan, dialect)
    lines = ["package mien;", "", NOTE, "/** What belongs to no object. */", "public final class Information {", "    private Information() {}", ""]
    for m in plan.library:
        lines += method_text(m, plan, dialect)
    lines[-1:] = ["}"]
    yield "Information", "\n".join(lines) + "\n"


def raw_type(p, interface):
    return "long" if "*" in p.type else NUMBERS[element(p.base, interface)]


def raw_result(f, interface):
    number = number_result(f, interface)
    return NUMBERS[number] if number else {"void": "void", "mien_status": "int"}.get(f.result, "long")


def raw_signature(f, interface):
    return f"{raw_result(f, interface)} {f.name}({', '.join(f'{raw_type(p, interface)} {word(p.name)}' for p in f.parameters)})"


def raw_interface(plan):
    lines = ["package mien;", "", NOTE, "/** The C functions as they are: addresses and handles are numbers. */", "interface Raw {",
             "    Raw GET = NativeLoader.load();", "",
             "    /** The address of a direct buffer's memory. */", "    long address(java.nio.ByteBuffer memory);",
             "    /** Memory of the library as a buffer. */", "    java.nio.ByteBuffer memory(long address, long bytes);",
             "    /** A C function that calls Callbacks.progress. */", "    long progressFunction();",
             "    /** A C function that calls Callbacks.log. */", "    long logFunction();", ""]
    lines += [f"    {raw_signature(f, plan.interface)};" for f in plan.interface.functions]
    return "\n".join(lines + ["}"]) + "\n"


def raw_jni(plan):
    lines = ["package mien;", "", NOTE, "/** Raw through the JNI library mien_jni.c. */", "final class RawJni implements Raw {",
             "    @Override public native long address(java.nio.ByteBuffer memory);",
             "    @Override public native java.nio.ByteBuffer memory(long address, long bytes);",
             "    @Override public native long progressFunction();", "    @Override public native long logFunction();"]
    lines += [f"    @Override public native {raw_signature(f, plan.interface)};" for f in plan.interface.functions]
    return "\n".join(lines + ["}"]) + "\n"


def jni_functions(plan):
    """The part of the JNI library that repeats the headers."""
    interface, dialect = plan.interface, Java(plan)
    lines = ["/* One C function per method of mien.RawJni. Written by abi/generate_bindings.py. */",
             "/* clang-format off */", ""]
    for s in interface.structs:
        size, places, _ = dialect.layouts[s.name]
        lines.append(f"STATIC_CHECK(sizeof({s.name}) == {size}, size_of_{s.name});")
        lines += [f"STATIC_CHECK(offsetof({s.name}, {name}) == {place}, place_of_{s.name}_{name});" for name, place in places.items()]
    for f in interface.functions:
        mangled = f.name.replace("_", "_1")
        row, arguments = [], []
        for p in f.parameters:
            kind = "jlong" if "*" in p.type else {"int": "jint", "long": "jlong", "double": "jdouble", "float": "jfloat", "byte": "jbyte"}[raw_type(p, interface)]
            row.append(f"{kind} {p.name}")
            arguments.append(f"({p.type})(intptr_t){p.name}" if "*" in p.type else f"({p.type}){p.name}")
        result = {"void": "void", "int": "jint", "long": "jlong", "double": "jdouble"}[raw_result(f, interface)]
        call = f"{f.name}({', '.join(arguments)})"
        body = f"{call};" if result == "void" else f"return (jlong)(intptr_t){call};" if "*" in f.result else f"return ({result}){call};"
        lines += ["", f"JNIEXPORT {result} JNICALL Java_mien_RawJni_{mangled}({', '.join(['JNIEnv *env', 'jobject self', *row])}) {{",
                  "    (void)env;", "    (void)self;", f"    {body}", "}"]
    return "\n".join(lines) + "\n"


def raw_foreign(plan):
    layouts_of = {"long": "JAVA_LONG", "int": "JAVA_INT", "double": "JAVA_DOUBLE", "float": "JAVA_FLOAT", "byte": "JAVA_BYTE"}
    lines = ["package mien;", "", NOTE, "import static java.lang.foreign.ValueLayout.JAVA_DOUBLE;", "import static java.lang.foreign.ValueLayout.JAVA_INT;",
             "import static java.lang.foreign.ValueLayout.JAVA_LONG;", "", "import java.lang.foreign.FunctionDescriptor;",
             "import java.lang.foreign.MemorySegment;", "import java.lang.invoke.MethodHandle;", "",
             "/** Raw through the Foreign Function API: Java 22 and later, no C. */", "final class RawForeign implements Raw {",
             "    private final ForeignLibrary library = new ForeignLibrary();", "",
             "    @Override public long address(java.nio.ByteBuffer memory) { return MemorySegment.ofBuffer(memory).address(); }",
             "    @Override public java.nio.ByteBuffer memory(long address, long bytes) {",
             "        return MemorySegment.ofAddress(address).reinterpret(bytes).asByteBuffer();", "    }",
             "    @Override public long progressFunction() { return library.progress; }", "    @Override public long logFunction() { return library.log; }"]
    for f in plan.interface.functions:
        row = ", ".join(layouts_of[raw_type(p, plan.interface)] for p in f.parameters)
        result = raw_result(f, plan.interface)
        descriptor = f"FunctionDescriptor.ofVoid({row})" if result == "void" else f"FunctionDescriptor.of({', '.join(filter(None, [layouts_of[result], row]))})"
        names = ", ".join(word(p.name) for p in f.parameters)
        returned = f"{f.name}.invokeExact({names});" if result == "void" else f"return ({result}) {f.name}.invokeExact({names});"
        lines += ["", f'    private final MethodHandle {f.name} = library.find("{f.name}", {descriptor});',
                  f"    @Override public {raw_signature(f, plan.interface)} {{",
                  f"        try {{ {returned} }} catch (Throwable thrown) {{ throw ForeignLibrary.unexpected(thrown); }}", "    }"]
    return "\n".join(lines + ["}"]) + "\n"

"""C#: examples/csharp/Native.cs (structs and functions as C has them) and classes/NAME.cs, one file per class."""
from documentation import base_of
from host_plan import camel, element, host_words, lent_class, lower_camel, number_result, owns_count, scalars_first, sentences, visible_fields
from write_classes import Body, Dialect, doc_lines, escape, ordered

NUMBERS = {"int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong", "size_t": "UIntPtr", "double": "double",
           "float": "float", "uint8_t": "byte", "char": "byte"}
WORDS = {"object", "string", "out", "ref", "in", "params", "fixed", "lock", "event", "operator", "base", "this", "checked", "default"}


def pascal(name):
    return camel("mien_" + name)


def word(name):
    text = lower_camel(name)
    return "@" + text if text in WORDS else text


class CSharp(Dialect):
    name = "csharp"
    functions = "Functions."
    error = "call.Error"
    capacity_argument = "(ulong)capacity"
    abi_version = "Functions.AbiVersion"
    address_type = "IntPtr"
    cancel_argument = "cancellationToken"

    def helper(self, name):
        return name[:1].upper() + name[1:]

    def argument(self, name):
        return word(name)

    def local(self, name):
        return word(name)

    def counts_member(self, receiver, name):
        return f"(long){receiver}.GetCounts().{pascal(name)}"

    def by_value(self, p, expression, counted=False):
        kind = NUMBERS[element(p.base, self.interface)]
        return f"({kind}){expression}" if counted or p.enum else expression

    def fresh_options(self, base, host, nullable):
        return f"({host} ?? new {camel(base)}())" if nullable else f'call.Required({host}, "options")'

    def write_record(self, p, host):
        return f"call.Record({host}, sizeof(Native.{camel(p.base)}), {'true' if p.nullable else 'false'}, \"{p.name}\")"

    def write_records(self, p, host):
        return f"call.Records({host}, sizeof(Native.{camel(p.base)}))"

    def fresh_record(self, base):
        return f"call.Sized(sizeof(Native.{camel(base)}))"

    def record_size(self, base):
        return f"sizeof(Native.{camel(base)})"

    def read_records(self, p, at, count):
        return f"call.ReadRecords({at}, {count}, sizeof(Native.{camel(p.base)}), {camel(p.base)}.Read)"

    def read_number(self, p, at):
        kind = NUMBERS[element(p.base, self.interface)]
        cast = f"({self.plan.enums[p.enum]})" if p.enum else ""
        return f"{cast}*({kind}*){at}"

    def array_reader(self, kind):
        return f"Read{pascal(NUMBERS[kind])}s"

    def view(self, body, at, total, kind):
        return f"call.Lend<{NUMBERS[kind]}>(*(IntPtr*){at}, {total}, this)"

    def plain_result(self, f, call):
        return f"return Text.FromNative({call});" if f.result == "const char*" else f"return {call};" if f.result != "void" else call + ";"


def host_type(item, plan):
    if item.role in ("array", "bytes", "fixed"):
        return ("byte" if item.base == "void" else NUMBERS[element(item.base, plan.interface)]) + "[]"
    if item.role == "matrix":
        return "Values"
    if item.role in ("text", "chars"):
        return "string"
    if item.role == "texts":
        return "IReadOnlyList<string>"
    if item.role in ("handles", "structs"):
        return f"IReadOnlyList<{camel(item.base)}>"
    if item.role in ("handle", "struct", "handle_out", "struct_out"):
        return camel(item.base)
    if item.role == "callback":
        return "Action<int, string>"
    if item.enum:
        return plan.enums[item.enum]
    kind = NUMBERS[element(item.base, plan.interface)]
    return "ulong" if kind == "UIntPtr" else kind


def output_type(item, plan, dtype=None):
    if item.role == "text_out":
        return "string"
    if item.role == "structs_out":
        return camel(item.base) + "[]"
    if item.role == "array_out":
        return NUMBERS[dtype or element(item.base, plan.interface)] + "[]"
    if item.role == "view_out":
        return f"ReadOnlyMemory<{NUMBERS[element(item.base, plan.interface)]}>"
    return host_type(item, plan)


def summary(text, indent, tag="summary"):
    rows = sentences(escape(text), 112, "")
    if not rows:
        return []
    if len(rows) == 1:
        return [f"{indent}/// <{tag}>{rows[0]}</{tag.split()[0]}>"]
    return [f"{indent}/// <{tag}>{rows[0]}"] + [f"{indent}/// {r}" for r in rows[1:-1]] + [f"{indent}/// {rows[-1]}</{tag.split()[0]}>"]


def native_field(f, interface, structs):
    name = word(f.name)
    if f.role in ("fixed", "chars"):
        return f"public fixed {NUMBERS[element(f.base, interface)]} {name}[{f.count[0]}];"
    if "*" in f.type or f.role == "callback":
        return f"public IntPtr {name};"
    return f"public {camel(f.base) if f.base in structs else NUMBERS[element(f.base, interface)]} {name};"


def native_file(plan):
    interface = plan.interface
    lines = ["// Structs and functions of the C headers. Written by abi/generate_bindings.py.", "using System;",
             "using System.Runtime.InteropServices;", "", "namespace Mien.Native", "{"]
    for s in interface.structs:
        lines += ["    [StructLayout(LayoutKind.Sequential)]", f"    internal unsafe struct {camel(s.name)}", "    {"]
        lines += [f"        {native_field(f, interface, plan.structs)}" for f in s.fields] + ["    }", ""]
    lines += ["    internal static class Functions", "    {", f"        internal const uint AbiVersion = {interface.abi_version};",
              f'        internal const string Version = "{interface.version}";']

    def raw(p):
        return "IntPtr" if "*" in p.type else NUMBERS[element(p.base, interface)]

    signatures = []
    for f in interface.functions:
        number = number_result(f, interface)
        result = NUMBERS[number] if number else {"void": "void", "mien_status": "int"}.get(f.result, "IntPtr")
        signatures.append((f.name, result, ", ".join(f"{raw(p)} {word(p.name)}" for p in f.parameters)))
    lines += ["", "#if MIEN_STATIC // linked into the program, as on iOS"]
    for name, result, parameters in signatures:
        lines += ['        [DllImport("__Internal", CallingConvention = CallingConvention.Cdecl)]',
                  f"        internal static extern {result} {name}({parameters});"]
    lines += ["#else", "        static Functions() { } // at the first use and not before: Library.Need() has looked then"]
    for name, result, parameters in signatures:
        lines += ["        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]", f"        internal delegate {result} {name}_function({parameters});",
                  f'        internal static readonly {name}_function {name} = Library.Function<{name}_function>("{name}");']
    lines.append("#endif")
    return "\n".join(lines + ["    }", "}"]) + "\n"


def write_struct(s, plan):
    name, fields, structs = camel(s.name), visible_fields(s), plan.structs
    progress = len([f for f in s.fields if f.name in ("progress", "cancel")]) == 2
    inputs = s.use != "result"
    base = " : Record" if inputs else ""
    lines = summary(host_words(s.comment) or f"{s.name} of the C interface.", "    ")
    lines += [f"    public sealed unsafe class {name}{base}", "    {"]
    if s.use == "options" and any(f.role in ("scalar", "fixed") for f in fields):
        lines += ["        /// <summary>With the library's defaults.</summary>", f"        public {name}()", "        {",
                  "            Library.Need();", f"            var raw = default(Native.{name});",
                  f"            Functions.{s.name}_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.{name}));"]
        for f in fields:
            if f.role == "scalar":
                cast = f"({plan.enums[f.enum]})" if f.enum else ""
                lines.append(f"            {pascal(f.name)} = {cast}raw.{word(f.name)};")
            elif f.role == "fixed":
                lines.append(f"            {pascal(f.name)} = Call.CopyOut(raw.{word(f.name)}, {f.count[0]});")
        lines += ["        }", ""]
    for f in fields:
        lines += summary(host_words(f.comment), "        ")
        setter = "set; " if inputs else "internal set; "
        lines.append(f"        public {host_type(f, plan)} {pascal(f.name)} {{ get; {setter}}}")
    if inputs:
        lines += ["", "        internal override void Fill(Call call, IntPtr at)", "        {"]
        if fields:
            lines.append(f"            var raw = (Native.{name}*)at;")
        if s.use == "options":
            lines.append(f"            Functions.{s.name}_init(at, (UIntPtr)sizeof(Native.{name}));")
        for f in scalars_first(fields):
            lines += [f"            {line}" for line in fill_field(f, s, plan)]
        lines.append("        }")
    if progress:
        lines += ["", "        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)", "        {",
                  f"            var at = call.Room(sizeof(Native.{name}));", "            Fill(call, at);", f"            var raw = (Native.{name}*)at;",
                  "            raw->progress = call.ProgressFunction(progress);", "            raw->progressUser = call.ProgressUser;",
                  "            raw->cancel = call.CancelToken(cancellationToken);", "            return at;", "        }"]
    if s.use != "options" and all(f.role in ("scalar", "fixed", "struct") for f in fields):
        lines += ["", f"        internal static {name} Read(Call call, IntPtr at)", "        {", f"            var raw = (Native.{name}*)at;",
                  f"            var made = new {name}();"]
        for f in fields:
            if f.role == "scalar":
                cast = f"({plan.enums[f.enum]})" if f.enum else ""
                lines.append(f"            made.{pascal(f.name)} = {cast}raw->{word(f.name)};")
            elif f.role == "struct":
                lines.append(f"            made.{pascal(f.name)} = {camel(f.base)}.Read(call, (IntPtr)(&raw->{word(f.name)}));")
            elif f.role == "fixed":
                lines.append(f"            made.{pascal(f.name)} = Call.CopyOut(raw->{word(f.name)}, {f.count[0]});")
        lines += ["            return made;", "        }"]
    return lines + ["    }", ""]


def fill_field(f, s, plan):
    host, raw = pascal(f.name), f"raw->{word(f.name)}"
    optional = "OrNull" if f.nullable else ""
    if f.role == "scalar":
        kind = NUMBERS[element(f.base, plan.interface)]
        return [f"{raw} = {f'({kind})' if f.enum else ''}{host};"]
    if f.role == "struct":
        return [f'call.Required({host}, "{f.name}").Fill(call, (IntPtr)(&{raw}));']
    if f.role == "fixed":
        return [f'Call.CopyIn({host}, {raw}, {f.count[0]}, "{f.name}");']
    if f.role == "text":
        return [f"{raw} = call.Text{optional}({host});"]
    if f.role == "handle":
        return [f"{raw} = call.Use{optional}({host});"]
    if f.role == "matrix":
        return [f'{raw} = call.Matrix({host}, {f.count[0]}, "{f.name}");']
    if f.role == "callback":
        return [f"{raw} = call.LogFunction({host});", f"{raw}User = call.LogUser({host});"]
    columns = " * ".join(str(c) if isinstance(c, int) else f"(long)raw->{word(c)}" for c in f.count[1:]) or "1"
    rows = f'call.Rows({host}, {columns}, "{f.name}")'
    lines = [] if f.nullable else [f'call.Required({host}, "{f.name}");']
    if f.role == "structs":
        lines.append(f"{raw} = call.Records({host}, sizeof(Native.{camel(f.base)}));")
    else:
        lines.append(f"{raw} = call.{'Texts' if f.role == 'texts' else 'Array'}({host});")
    first = str(f.count[0])
    if "." in first:
        holder, _, inner = first.partition(".")
        lines.append(f'if ({host} != null) call.Agree("{f.name}", {rows}, (long)raw->{word(holder)}.{word(inner)});')
    elif not owns_count(f, s):
        lines.append(f'if ({host} != null) call.Agree("{f.name}", {rows}, (long)raw->{word(first)});')
    else:
        counter = next(c for c in s.fields if c.name == first)
        lines.append(f"raw->{word(first)} = ({NUMBERS[element(counter.base, plan.interface)]}){rows};")
    return lines


def method_name(method):
    c = method.function.name
    name = pascal(method.name)
    return "Get" + name if "_get_" in c or method.function.lends or (method.outputs and method.outputs[0].role == "view_out") else name


def write_method(method, plan, dialect, dtype=None):
    f, m, indent = method.function, method, "        "
    arguments, passed = [], []
    for p in ordered(m.inputs):
        arguments.append(f"{host_type(p, plan)} {word(p.name)}" + (" = null" if p.nullable else ""))
        passed.append(word(p.name))
    if m.options is not None:
        arguments += ["IProgress<Progress> progress = null", "CancellationToken cancellationToken = default(CancellationToken)"]
        passed += ["progress", "cancellationToken"]
    if f.lends:
        returned = lent_class(f)
    elif m.result:
        returned = m.result
    elif m.outputs:
        returned = output_type(m.outputs[0], plan, dtype)
    else:
        number = number_result(f, plan.interface)
        returned = "string" if f.result == "const char*" else NUMBERS[number] if number else "void"
    words, documented, errors = doc_lines(m)
    name = method_name(m) + ("F32" if dtype == "float" else "")
    lines = summary(words, indent)
    for argument, text in documented:
        lines += summary(text, indent, f'param name="{lower_camel(argument)}"')
    if errors:
        lines += summary(errors, indent, 'exception cref="MienException"')
    lines.append(f"{indent}/// <remarks>C: {f.name}()</remarks>")
    head = list(lines)
    body = Body(m, dialect, dtype).write()
    static = "static " if m.static else ""
    lines += [f"{indent}public {static}{returned} {name}({', '.join(arguments)})", indent + "{", indent + "    using (var call = new Call())",
              indent + "    {"]
    lines += [indent + "        " + line for line in body] + [indent + "    }", indent + "}", ""]
    if m.options is not None:
        task = f"Task<{returned}>" if returned != "void" else "Task"
        lines += head + [f"{indent}public {static}{task} {name}Async({', '.join(arguments)})", indent + "{",
                         f"{indent}    return Task.Run(() => {name}({', '.join(passed)}), cancellationToken);", indent + "}", ""]
    return lines


HEAD = ["// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.", "using System;", "using System.Collections.Generic;",
        "using System.Threading;", "using System.Threading.Tasks;", "using Mien.Native;", "", "namespace Mien", "{"]


def enum_lines(group, plan):
    prefix = "MIEN_" if group.name == "STATUS" else f"MIEN_{group.name}_"
    lines = summary(host_words(group.comment) or f"MIEN_{group.name}_* of the C interface.", "    ")
    lines += [f"    public enum {plan.enums[group.name]}", "    {"]
    for c in group.constants:
        lines += summary(host_words(c.comment), "        ")
        lines.append(f"        {pascal(c.name[len(prefix):].lower())} = {c.value},")
    return lines + ["    }"]


def result_lines(name, outputs, plan):
    lines = ["    /// <summary>What comes out of one call.</summary>", f"    public sealed class {name}", "    {"]
    arguments = ", ".join(f"{output_type(p, plan)} {word(p.name)}" for p in outputs)
    lines += [f"        internal {name}({arguments})", "        {"]
    lines += [f"            {pascal(p.name)} = {word(p.name)};" for p in outputs] + ["        }", ""]
    for p in outputs:
        lines += summary(host_words(p.comment), "        ")
        lines.append(f"        public {output_type(p, plan)} {pascal(p.name)} {{ get; private set; }}")
    return lines + ["    }"]


def handle_lines(handle, methods, plan, dialect):
    name = camel(handle)
    lines = summary(host_words(plan.interface.handles[handle]), "    ")
    lines += [f"    public sealed unsafe class {name} : NativeObject", "    {",
              f"        internal {name}(IntPtr owned) : base(owned, at => Functions.{handle}_release(at)) {{ }}", ""]
    makers = {m.name: m for m in methods}
    plain = makers.get("create") if makers.get("create") and not makers["create"].inputs else None
    fuller = makers.get("create_with_options") if plain else None
    for maker in filter(None, (plain, fuller)):
        arguments = ", ".join(f"{host_type(p, plan)} {word(p.name)}" for p in maker.inputs)
        passed = ", ".join(word(p.name) for p in maker.inputs)
        lines += summary(host_words(maker.function.purpose), "        ")
        lines += [f"        public {name}({arguments}) : base({pascal(maker.name)}({passed})) {{ }}", ""]
    if f"{handle}_retain" in plan.lifetime:
        lines += ["        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>",
                  f"        public {name} Share()", "        {", "            using (var call = new Call())", "            {",
                  "                var at = call.Use(this);", f"                Functions.{handle}_retain(at);",
                  f"                return new {name}(at);", "            }", "        }", ""]
    for m in methods:
        if m.dtype is not None:
            lines += write_method(m, plan, dialect, "double") + write_method(m, plan, dialect, "float")
        else:
            lines += write_method(m, plan, dialect)
    return lines[:-1] + ["    }"]


def class_files(plan):
    """(name, text) of every class: one file each, named as the class."""
    interface, dialect = plan.interface, CSharp(plan)
    for group in interface.groups:
        yield plan.enums[group.name], enum_lines(group, plan)
    for s in interface.structs:
        if s.name not in ("mien_error", "mien_array_view"):
            yield camel(s.name), write_struct(s, plan)[:-1]
    for name, outputs in plan.results.items():
        yield name, result_lines(name, outputs, plan)
    for handle, methods in plan.classes.items():
        yield camel(handle), handle_lines(handle, methods, plan, dialect)
    lines = ["    /// <summary>What belongs to no object.</summary>", "    public static class Information", "    {"]
    for m in plan.library:
        lines += write_method(m, plan, dialect)
    yield "Information", lines[:-1] + ["    }"]


def files(plan):
    """(name, text) of the files under examples/csharp/classes."""
    for name, lines in class_files(plan):
        yield name, "\n".join(HEAD + lines + ["}"]) + "\n"

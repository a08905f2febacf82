"""Python: examples/python/mien/abi.py (structs, signatures, what each parameter is) and classes/NAME.py, one file per class."""
import keyword

from documentation import base_of
from host_plan import camel, element, host_words, lent_class, number_result, sentences, visible_fields

NUMPY = {"int32_t": "int32", "uint32_t": "uint32", "int64_t": "int64", "uint64_t": "uint64", "uint8_t": "uint8",
         "double": "float64", "float": "float32", "size_t": "uint64"}


def safe(name):
    return name + "_" if keyword.iskeyword(name) else name


def ctype(field, interface):
    structs = {s.name for s in interface.structs}
    if field.role in ("callback",):
        return camel(field.base)
    if "*" in field.type:
        return "ctypes.c_void_p"
    if field.base in structs:
        return camel(field.base)
    kind = element(field.base, interface)
    kind = "ctypes.c_char" if kind == "char" else f"ctypes.c_{'uint8' if kind == 'uint8_t' else kind.replace('_t', '')}"
    kind = "ctypes.c_size_t" if element(field.base, interface) == "size_t" else kind
    return f"{kind} * {field.count[0]}" if field.role in ("fixed", "chars") else kind


def callback_type(callback, interface):
    def one(kind):
        if kind == "void":
            return "None"
        if kind == "const char*":
            return "ctypes.c_char_p"
        return "ctypes.c_void_p" if "*" in kind else f"ctypes.c_{element(base_of(kind), interface).replace('_t', '')}"
    return f"ctypes.CFUNCTYPE({', '.join([one(callback.result)] + [one(p.type) for p in callback.parameters])})"


def abi_module(plan):
    interface = plan.interface
    lines = ['"""Structs, signatures and parameters of the C interface. Written by abi/generate_bindings.py."""',
             "import ctypes", ""]
    lines += [f"{camel(c.name)} = {callback_type(c, interface)}" for c in interface.callbacks]
    lines += ["", f"ABI_VERSION = {interface.abi_version}", f'VERSION = "{interface.version}"']
    for struct in interface.structs:
        lines += ["", "", f"class {camel(struct.name)}(ctypes.Structure):", "    _fields_ = ["]
        lines += [f'        ("{f.name}", {ctype(f, interface)}),' for f in struct.fields]
        lines += ["    ]"]
    lines += ["", "", "# struct: ((field, role, base, count, enum), ...)", "STRUCTS = {"]
    for struct in interface.structs:
        lines.append(f'    "{struct.name}": (')
        lines += [f'        ("{f.name}", "{f.role}", "{f.base}", {tuple(f.count)!r}, "{f.enum}"),' for f in struct.fields]
        lines.append("    ),")
    lines += ["}", "", "# function: (result, locks, options, ((parameter, role, base, count, nullable, enum), ...))", "FUNCTIONS = {"]
    for f in interface.functions:
        number = number_result(f, interface)
        # Numbers that are no status are named, so that the runtime tells them apart.
        result = {"void": "None", "mien_status": "ctypes.c_int32", "const char*": "ctypes.c_char_p"}.get(f.result, "ctypes.c_void_p")
        result = f'"{number}"' if number else result
        lines.append(f'    "{f.name}": ({result}, {tuple(f.locks)!r}, (')
        lines += [f'        ("{p.name}", "{p.role}", "{p.base}", {tuple(p.count)!r}, {p.nullable}, "{p.enum}"),' for p in f.parameters]
        lines.append("    )),")
    lines += ["}", "", "NUMBERS = {"]
    numbers = [("mien_status", "int32_t"), *[(a, k) for a, k in interface.aliases.items() if a != "mien_status"]]
    for name, kind in [*numbers, *[(k, k) for k in NUMPY]]:
        c = "ctypes.c_" + (kind.replace("_t", "") if kind != "size_t" else "size_t")
        lines.append(f'    "{name}": ({c}, "{NUMPY[kind]}"),')
    return "\n".join(lines + ["}"]) + "\n"


def hint(item, plan, optional=True):
    """The type of an argument or a field, as a string hint."""
    columns = {"array": "ArrayLike", "matrix": "ArrayLike", "bytes": "bytes", "text": "Text", "texts": "Sequence[str]",
               "fixed": "Sequence[float]", "chars": "str"}
    if item.role in columns:
        kind = columns[item.role]
    elif item.role == "callback":
        kind = "Callable[[int, str], None]"
    elif item.role in ("handle", "struct"):
        kind = camel(item.base)
    elif item.role in ("handles", "structs"):
        kind = f"Sequence[{camel(item.base)}]"
    else:
        kind = "float" if element(item.base, plan.interface) in ("double", "float") else plan.enums.get(item.enum, "int") if item.enum else "int"
        kind = f"{kind} | int" if item.enum else kind
    return f"{kind} | None" if optional and item.nullable else kind


def output_hint(item, plan):
    if item.role == "handle_out":
        return camel(item.base)
    if item.role == "struct_out":
        return camel(item.base)
    if item.role == "structs_out":
        return f"list[{camel(item.base)}]"
    if item.role == "text_out":
        return "str"
    if item.role in ("array_out", "view_out"):
        return "numpy.ndarray"
    return "float" if element(item.base, plan.interface) in ("double", "float") else "int"


def docstring(lines, indent):
    text = "\n".join(lines).replace("\\", "\\\\").replace('"""', "'''")
    rows = text.split("\n")
    if len(rows) == 1:
        return [f'{indent}"""{rows[0]}"""']
    return [f'{indent}"""{rows[0]}'] + [f"{indent}{row}".rstrip() for row in rows[1:]] + [f'{indent}"""']


def method_doc(method, plan):
    f = method.function
    lines = sentences(host_words(f.purpose), 108)
    for p in method.inputs + (method.outputs if method.result else []):
        if host_words(p.comment):
            lines += sentences(f"{p.name}: {host_words(p.comment)}", 104)
    if f.statuses and f.statuses != ["MIEN_E_INVALID_HANDLE"]:
        lines += sentences(f"Fails with {host_words(f.fields['errors'])}.".replace("..", "."), 104)
    lines.append(f"C: {f.name}()")
    return lines


def ordered(inputs):
    """Arguments that may be left out come last."""
    return [p for p in inputs if not p.nullable] + [p for p in inputs if p.nullable]


def write_method(method, plan):
    f, arguments, given = method.function, [], {}
    for p in ordered(method.inputs):
        arguments.append(f"{safe(p.name)}: {hint(p, plan)}{' = None' if p.nullable else ''}")
        given[p.name] = safe(p.name)
    if method.receiver is not None:
        arguments.insert(0, "self")
        given[method.receiver.name] = "self"
    extra = ""
    if method.dtype is not None:
        arguments.append("dtype: DTypeLike = numpy.float64")
        extra += ", dtype=dtype"
    if method.options is not None:
        arguments += ["progress: Progress | None = None", "cancel: Cancel | None = None"]
        extra += ", progress=progress, cancel=cancel"
    outputs = method.outputs
    if f.lends:
        returned, made = lent_class(f), f"{lent_class(f)}._adopt({{}})"
    elif f.result == "const char*":
        returned, made = "str", "{}"
    elif number_result(f, plan.interface):
        returned, made = "int", "{}"
    elif method.result:
        returned, made = method.result, method.result + "(*{})"
    elif outputs:
        returned, made = output_hint(outputs[0], plan), "{}[0]"
    else:
        returned, made = "None", "{}"
    call = f'_run("{f.name}", {{{", ".join(f"{chr(34)}{k}{chr(34)}: {v}" for k, v in given.items())}}}{extra})'
    lines = []
    if method.static and method.owner:
        lines.append("    @staticmethod")
    indent = "    " if method.owner else ""
    lines.append(f"{indent}def {method.name}({', '.join(arguments)}) -> {returned}:")
    lines += docstring(method_doc(method, plan), indent + "    ")
    statement = made.format(call)
    lines.append(f"{indent}    {'return ' if returned != 'None' else ''}{statement}")
    return lines + [""]


def write_struct(struct, plan):
    name, fields = camel(struct.name), visible_fields(struct)
    lines = ["", "", f"class {name}(_{'Options' if struct.use == 'options' else 'Record'}):"]
    lines += docstring(sentences(struct.comment.split("Initialise with")[0].strip() or f"{struct.name} of the C interface.", 108), "    ")
    lines += [f'    _name = "{struct.name}"']
    for f in fields:
        if f.comment:
            lines += [f"    #: {row}" for row in sentences(host_words(f.comment), 106)]
        kind = "numpy.ndarray" if struct.use == "result" and f.role == "fixed" else hint(f, plan)
        lines.append(f"    {safe(f.name)}: {kind}")
    if struct.use != "options":
        required = [f for f in fields if not f.nullable]
        arguments = [f"{safe(f.name)}: {hint(f, plan)}" + ("" if f in required and struct.use == "value" and f.role not in ("scalar",) else " = None" if f.nullable else " = 0")
                     for f in required + [f for f in fields if f.nullable]]
        if struct.use == "value":
            leading = [a for a in arguments if " = " not in a]
            rest = [a for a in arguments if " = " in a]
            lines += ["", f"    def __init__(self, {', '.join(leading + rest)}) -> None:"]
            lines += [f"        self.{safe(f.name)} = {safe(f.name)}" for f in fields]
    return lines


HEAD = ["from __future__ import annotations", "", "import enum  # noqa: F401", "from typing import TYPE_CHECKING, Callable, NamedTuple, Sequence  # noqa: F401",
        "", "import numpy  # noqa: F401", "from numpy.typing import ArrayLike, DTypeLike  # noqa: F401", "",
        "from ..runtime import Object as _Object  # noqa: F401", "from ..runtime import Options as _Options  # noqa: F401",
        "from ..runtime import Progress, Text  # noqa: F401", "from ..runtime import Record as _Record  # noqa: F401",
        "from ..runtime import run as _run  # noqa: F401", "", "if TYPE_CHECKING:", "    from . import *  # noqa: F401,F403"]


def snake(name):
    return "".join("_" + c.lower() if c.isupper() else c for c in name).lstrip("_")


def enum_lines(group, plan):
    lines = [f"class {plan.enums[group.name]}(enum.IntEnum):"]
    lines += docstring(sentences(group.comment or f"MIEN_{group.name}_* of the C interface.", 108), "    ")
    prefix = "MIEN_" if group.name == "STATUS" else f"MIEN_{group.name}_"
    for c in group.constants:
        if c.comment:
            lines += [f"    #: {row}" for row in sentences(c.comment, 106)]
        lines.append(f"    {c.name[len(prefix):]} = {c.value}")
    return lines


def result_lines(name, outputs, plan):
    lines = [f"class {name}(NamedTuple):"]
    for p in outputs:
        if p.comment:
            lines += [f"    #: {row}" for row in sentences(host_words(p.comment), 106)]
        lines.append(f"    {safe(p.name)}: {output_hint(p, plan)}")
    return lines


def handle_lines(handle, methods, plan):
    lines = [f"class {camel(handle)}(_Object):"]
    lines += docstring(sentences(plan.interface.handles[handle], 108), "    ")
    lines += [f'    _release = "{handle}_release"']
    if f"{handle}_retain" in plan.lifetime:
        lines.append(f'    _retain = "{handle}_retain"')
        lines += ["", f"    def share(self) -> {camel(handle)}:",
                  '        """One more object for the same native one: each may be closed by itself."""',
                  f"        return self._share()"]
    lines.append("")
    makers = {m.name: m for m in methods}
    plain = makers.get("create") if makers.get("create") and not makers["create"].inputs else None
    if plain is not None:
        fuller = makers.get("create_with_options")
        options = fuller.inputs[0] if fuller else None
        lines.append(f"    def __init__(self{f', options: {camel(options.base)} | None = None' if options else ''}) -> None:")
        lines += docstring(sentences(plain.function.purpose + (" With options: those." if options else ""), 104), "        ")
        call = f'_run("{plain.function.name}", {{}})'
        if options:
            call = f'_run("{fuller.function.name}", {{"options": options}}) if options is not None else {call}'
        lines += [f"        self._take(({call})[0])", ""]
    for m in methods:
        if m is not plain and not (plain is not None and m.name == "create_with_options"):
            lines += write_method(m, plan)
    return lines[:-1]


def class_lines(plan):
    """(name, lines) of every class."""
    interface = plan.interface
    for group in interface.groups:
        yield plan.enums[group.name], enum_lines(group, plan)
    for struct in interface.structs:
        if struct.name not in ("mien_error", "mien_array_view"):
            lines = write_struct(struct, plan)
            yield camel(struct.name), lines[next(k for k, line in enumerate(lines) if line):]
    for name, outputs in plan.results.items():
        yield name, result_lines(name, outputs, plan)
    for handle, methods in plan.classes.items():
        yield camel(handle), handle_lines(handle, methods, plan)


def files(plan):
    """(name, text) of the files under examples/python/mien/classes: one module per class, and what gathers them."""
    gathered = []
    for name, lines in class_lines(plan):
        gathered.append(name)
        title = f'"""{name}. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""'
        yield snake(name), "\n".join([title, *HEAD, "", "", *lines]) + "\n"
    lines = ['"""What belongs to no object. Written by abi/generate_bindings.py."""', *HEAD]
    for m in plan.library:
        lines += ["", ""] + write_method(m, plan)[:-1]
    yield "information", "\n".join(lines) + "\n"
    functions = [m.name for m in plan.library]
    lines = ['"""Classes over the C interface, one module per handle, struct and group of constants.', "",
             "Written by abi/generate_bindings.py; how they work stands in runtime.py.", '"""', "import sys as _sys", "",
             "from ..runtime import register_classes as _register_classes"]
    lines += [f"from .{snake(name)} import {name}" for name in sorted(gathered)]
    lines += [f"from .information import {', '.join(sorted(functions))}", "", "__all__ = ["]
    lines += [f'    "{name}",' for name in sorted(gathered + functions)] + ["]"]
    pairs = ", ".join(f'"{group}": {name}' for group, name in plan.enums.items())
    lines += [""] + sentences(f"_enums = {{{pairs}}}", 108)
    lines += ["_register_classes(globals())", "# The modules' type hints name each other's classes.",
              "for _name in __all__:", "    vars(_sys.modules[globals()[_name].__module__]).update({name: globals()[name] for name in __all__})"]
    yield "__init__", "\n".join(lines) + "\n"

#!/usr/bin/env python3
"""Writes the tables of tests/abi/abuse/: every function, every parameter, every struct of the headers.

  generate_abuse.py INCLUDE_DIR OUT.inc

So a function that is added to the headers is abused without anybody listing it.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "abi"))
from read_headers import read_interface

REAL = {"double", "float"}
WHOLE = {"int32_t", "uint32_t", "int64_t", "uint64_t", "size_t", "uint8_t", "mien_status", "mien_dtype"}


def kind_of(parameter, function, interface):
    """The abuse that a parameter's type calls for (enum Kind in abuse.hpp)."""
    structs = {s.name for s in interface.structs}
    kind = parameter.type
    base = re.sub(r"\bconst\b|[\s*]", "", kind)
    stars = kind.count("*")
    if parameter.name == "error" and base == "mien_error":
        return "error"
    if base in interface.handles:
        return {1: "handle", 2: "handle_out" if not kind.startswith("const") else "handle_list"}[stars]
    if base in interface.callbacks:
        return "callback"
    if base in structs:
        return "struct_in" if kind.startswith("const") else "struct_out"
    if base == "char" and kind.startswith("const"):
        return {1: "text", 2: "text_list"}[stars]
    if stars == 2:
        return "view_out"
    if stars == 1 and kind.startswith("const"):
        return "array_in"
    if stars == 1:
        if parameter.name.endswith("user"):
            return "user"
        # Several arrays may share one capacity; what counts them stands alone.
        shares = any(p.name == "capacity" for p in function.parameters) and not parameter.name.endswith("count")
        return "array_out" if shares else "value_out"
    if base in REAL:
        return "real"
    if base in WHOLE:
        return "whole"
    raise SystemExit(f"generate_abuse.py: no abuse is known for the type '{kind}'")


def argument(index, parameter, kind):
    if kind == "real":
        return f"static_cast<{parameter.type}>(a[{index}].real)"
    if kind == "whole":
        return f"static_cast<{parameter.type}>(a[{index}].whole)"
    if kind == "callback":
        return f"reinterpret_cast<{parameter.type}>(a[{index}].function)"
    return f"reinterpret_cast<{parameter.type}>(a[{index}].pointer)"


def field_kind(field, interface):
    base = re.sub(r"\bconst\b|[\s*]|\[.*", "", field.type)
    if field.type == "function" or base in interface.callbacks:
        return "callback"
    if "*" in field.type:
        return "pointer"
    if base in REAL:
        return "real64" if base == "double" else "real32"
    if base in {s.name for s in interface.structs}:
        return "nested"
    if base in WHOLE:
        return "whole64" if "64" in base or base == "size_t" else "whole32" if "8" not in base else "bytes"
    return "bytes"


def main():
    interface = read_interface(sys.argv[1])
    lines = ["// Generated from the public headers by tests/abi/generate_abuse.py.", "", "const StructRow kStructs[] = {"]
    inits = {f.parameters[0].type.rstrip("*"): f.name for f in interface.functions
             if f.name.endswith("_init") and len(f.parameters) == 2}
    for struct in interface.structs:
        fields = ", ".join(f'{{"{f.name}", offsetof({struct.name}, {f.name}), sizeof({struct.name}::{f.name}), Field::{field_kind(f, interface)}}}'
                           for f in struct.fields)
        init = (f"[](void* s, std::size_t n) {{ {inits[struct.name]}(static_cast<{struct.name}*>(s), n); }}"
                if struct.name in inits else "nullptr")
        sized = "true" if struct.fields[0].name == "struct_size" else "false"
        lines.append(f'    {{"{struct.name}", sizeof({struct.name}), alignof({struct.name}), {sized}, {init}, {{{fields}}}}},')
    lines += ["};", "", "const FunctionRow kFunctions[] = {"]
    for f in interface.functions:
        kinds = [kind_of(p, f, interface) for p in f.parameters]
        call = f"{f.name}({', '.join(argument(i, p, k) for i, (p, k) in enumerate(zip(f.parameters, kinds)))})"
        if f.result == "mien_status":
            body, result = f"return {call};", "status"
        elif f.result == "void":
            body, result = f"{call}; return std::int64_t{{0}};", "nothing"
        elif f.result.endswith("*"):
            body, result = f"return static_cast<std::int64_t>(reinterpret_cast<std::intptr_t>({call}));", "pointer"
        else:
            body, result = f"return static_cast<std::int64_t>({call});", "value"
        parameters = ", ".join(
            f'{{"{p.name}", Kind::{k}, {"true" if p.nullable else "false"}, "{re.sub(r"const|[ *]", "", p.type)}"}}'
            for p, k in zip(f.parameters, kinds))
        unused = "" if f.parameters else "[[maybe_unused]] "
        lines.append(f'    {{"{f.name}", Result::{result}, {{{parameters}}},\n'
                     f"     []({unused}const Argument* a) -> std::int64_t {{ {body} }}}},")
    lines.append("};")
    Path(sys.argv[2]).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()

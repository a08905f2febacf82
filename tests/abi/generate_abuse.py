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


KINDS = {"error": "error", "handle": "handle", "handle_out": "handle_out", "handles": "handle_list", "callback": "callback",
         "struct": "struct_in", "structs": "struct_in", "matrix": "struct_in", "struct_out": "struct_out",
         "structs_out": "struct_out", "text": "text", "texts": "text_list", "view_out": "view_out", "array": "array_in",
         "bytes": "array_in", "user": "user", "scalar_out": "value_out", "count_out": "value_out"}


def kind_of(parameter, interface):
    """The abuse that a parameter's role calls for (enum Kind in abuse.hpp)."""
    if parameter.role in KINDS:
        return KINDS[parameter.role]
    if parameter.role in ("array_out", "text_out"):  # of a fixed length it is written whole
        return "array_out" if parameter.count[0] == "capacity" else "value_out"
    kind = interface.aliases.get(parameter.base, parameter.base)
    if kind in REAL:
        return "real"
    if kind in WHOLE:
        return "whole"
    raise SystemExit(f"generate_abuse.py: no abuse is known for the role '{parameter.role}' of the type '{parameter.type}'")


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
    if base in {c.name for c in interface.callbacks}:
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
        kinds = [kind_of(p, interface) for p in f.parameters]
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

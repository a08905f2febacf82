#!/usr/bin/env python3
"""Writes the parts of the example bindings that repeat the headers: examples/python/mien/abi.py and
examples/csharp/Native.cs.

  generate_bindings.py [--check]     with --check: exit 1 when a written file is out of date

Structs, constants and signatures come from the headers, so that a binding cannot drift from them; the
classes around them are written by hand.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from read_headers import header_files, read_interface, without_comments

PROJECT = Path(__file__).resolve().parent.parent
NUMBERS = {"int32_t": ("int32", "int"), "uint32_t": ("uint32", "uint"), "int64_t": ("int64", "long"),
           "uint64_t": ("uint64", "ulong"), "size_t": ("size_t", "UIntPtr"), "uint8_t": ("uint8", "byte"),
           "double": ("double", "double"), "float": ("float", "float"), "char": ("char", "byte"),
           "mien_status": ("int32", "int"), "mien_dtype": ("int32", "int")}


def base_of(kind):
    return re.sub(r"\bconst\b|[\s*]|\[.*", "", kind)


def camel(name):
    return "".join(word.capitalize() for word in name.replace("mien_", "", 1).split("_"))


def constants(include):
    """(name, value) of the enumerators, by the text of the headers."""
    found = []
    for path in header_files(include):
        for body in re.findall(r"\benum\s*\{(.*?)\}", without_comments(path.read_text()), re.S):
            found += re.findall(r"(\w+)\s*=\s*(-?\w+)", body)
    return found


def abi_version(include):
    return re.search(r"MIEN_ABI_VERSION (\d+)", (include / "config.h").read_text()).group(1)


def python_binding(interface, include):
    structs = {s.name for s in interface.structs}
    callbacks = set(interface.callbacks)

    def plain(kind):
        base = base_of(kind)
        if "*" in kind:
            if base in structs and kind.count("*") == 1:
                return f"ctypes.POINTER({camel(base)})"
            if base == "char":
                return "ctypes.c_char_p" if kind.count("*") == 1 else "ctypes.POINTER(ctypes.c_char_p)"
            return "ctypes.c_void_p"
        if base in callbacks:
            return camel(base)
        array = re.search(r"\[(\d+)\]", kind)
        name = camel(base) if base in structs else f"ctypes.c_{NUMBERS[base][0]}"
        return f"{name} * {array.group(1)}" if array else name

    def parameter(p):
        base = base_of(p.type)
        if base in interface.handles or "*" not in p.type or base in structs or base == "char" and p.type.startswith("const"):
            return "ctypes.c_void_p" if base in interface.handles and p.type.count("*") == 1 else \
                "ctypes.POINTER(ctypes.c_void_p)" if base in interface.handles else plain(p.type)
        return "ctypes.c_void_p"  # arrays and outputs: byref() or an array's address

    lines = ['"""Structs, constants and signatures of the C headers. Written by abi/generate_bindings.py."""',
             "import ctypes", "",
             "ProgressFn = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_int32, ctypes.c_double)",
             "LogFn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32, ctypes.c_char_p)", ""]
    lines += [f"{name} = {value}" for name, value in constants(include)]
    lines += [f"MIEN_ABI_VERSION = {abi_version(include)}"]
    for struct in interface.structs:
        lines += ["", "", f"class {camel(struct.name)}(ctypes.Structure):", "    _fields_ = ["]
        lines += [f'        ("{f.name}", {plain(f.type)}),' for f in struct.fields]
        lines += ["    ]"]
    lines += ["", "", "SIGNATURES = {"]
    for f in interface.functions:
        result = {"void": "None", "mien_status": "ctypes.c_int32", "uint32_t": "ctypes.c_uint32",
                  "const char*": "ctypes.c_char_p"}.get(f.result, "ctypes.c_void_p")
        lines.append(f'    "{f.name}": ({result}, [{", ".join(parameter(p) for p in f.parameters)}]),')
    lines += ["}"]
    return "\n".join(lines) + "\n"


def csharp_binding(interface, include):
    structs = {s.name for s in interface.structs}

    def field(f):
        base = base_of(f.type)
        name = re.sub(r"_(\w)", lambda m: m.group(1).upper(), f.name)
        array = re.search(r"\[(\d+)\]", f.type)
        if array:
            return f"public fixed {NUMBERS[base][1]} {name}[{array.group(1)}];"
        if "*" in f.type or base in interface.callbacks or f.type == "function":
            return f"public IntPtr {name};"
        return f"public {base and (camel(base) if base in structs else NUMBERS[base][1])} {name};"

    def parameter(p, function):
        base, stars = base_of(p.type), p.type.count("*")
        name = "@out" if p.name == "out" else p.name
        if base in interface.handles:
            if stars == 2:
                return f"out {camel(base)}Handle {name}"
            nullable = p.nullable and function.result in ("mien_status", "void")
            return f"IntPtr {name}" if nullable else f"{camel(base)}Handle {name}"
        if base in structs:
            return f"ref {camel(base)} {name}"
        if base == "char" and p.type.startswith("const"):
            return f"byte[] {name}" if stars == 1 else f"IntPtr[] {name}"
        if stars == 2:
            return f"out IntPtr {name}"
        if stars == 1:
            return f"out ulong {name}" if p.name.endswith("count") else f"IntPtr {name}"
        return f"{NUMBERS[base][1]} {name}"

    lines = ["// Structs, constants and signatures of the C headers. Written by abi/generate_bindings.py.",
             "using System;", "using System.Runtime.CompilerServices;", "using System.Runtime.InteropServices;", "",
             "#if NET7_0_OR_GREATER", "[assembly: DisableRuntimeMarshalling]", "#endif", "",
             "namespace Mien.Native", "{", "    internal static class Constants", "    {"]
    lines += [f"        internal const int {name} = {value};" for name, value in constants(include)]
    lines += ["    }"]
    for struct in interface.structs:
        lines += ["", "    [StructLayout(LayoutKind.Sequential)]", f"    internal unsafe struct {camel(struct.name)}", "    {"]
        lines += [f"        {field(f)}" for f in struct.fields]
        lines += ["    }"]
    for handle in interface.handles:
        name = camel(handle)
        lines += ["", f"    internal sealed class {name}Handle : Handle", "    {",
                  f"        protected override bool ReleaseHandle() {{ Functions.{handle}_release(handle); return true; }}", "    }"]
    lines += ["", "    internal static unsafe partial class Functions", "    {",
              f"        internal const uint AbiVersion = {abi_version(include)};"]
    for f in interface.functions:
        # Reference counting is the handle classes' business: they hold raw pointers.
        raw = f.name.endswith(("_release", "_retain"))
        parameters = ", ".join(f"IntPtr {p.name}" if raw else parameter(p, f) for p in f.parameters)
        result = {"void": "void", "mien_status": "int", "uint32_t": "uint"}.get(f.result, "IntPtr")
        signature = f"{result} {f.name}({parameters});"
        lines += ["", "#if NET7_0_OR_GREATER",
                  "        [LibraryImport(Library.Name)] [UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]",
                  f"        internal static partial {signature}", "#else",
                  "        [DllImport(Library.Name, CallingConvention = CallingConvention.Cdecl)]",
                  f"        internal static extern {signature}", "#endif"]
    lines += ["    }", "}"]
    return "\n".join(lines) + "\n"


def main():
    include = PROJECT / "include" / "mien"
    interface = read_interface(include)
    stale = []
    for path, text in ((PROJECT / "examples/python/mien/abi.py", python_binding(interface, include)),
                       (PROJECT / "examples/csharp/Native.cs", csharp_binding(interface, include))):
        if "--check" in sys.argv:
            if not path.exists() or path.read_text() != text:
                stale.append(str(path.relative_to(PROJECT)))
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    if stale:
        print("out of date, run python3 abi/generate_bindings.py: " + ", ".join(stale))
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())

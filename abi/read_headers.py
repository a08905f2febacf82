"""Reads the public C headers into plain tables: structs with fields, enumerators, functions with
their documentation. It understands the subset of C that the headers keep to (abi/README.md), and
says so when it meets anything else.
"""
import re
from collections import namedtuple
from pathlib import Path

Field = namedtuple("Field", "name type")  # type as written, "[n]" appended for arrays
Struct = namedtuple("Struct", "name fields header")
Parameter = namedtuple("Parameter", "name type nullable")  # nullable: the comment says "may be null"
Function = namedtuple("Function", "name result parameters comment header")
Interface = namedtuple("Interface", "structs enumerators functions handles callbacks")


def header_files(include):
    """The headers that mien.h pulls in, each after those that it stands on."""
    found = []

    def visit(name):
        for needed in re.findall(r'#include "(\w+\.h)"', (Path(include) / name).read_text()):
            visit(needed)
        if Path(include) / name not in found:
            found.append(Path(include) / name)

    visit("mien.h")
    return found[:-1]


def without_comments(text):
    return re.sub(r"/\*.*?\*/", " ", text, flags=re.S)


def read_fields(body, where):
    fields = []
    for part in body.split(";"):
        part = " ".join(part.split())
        if not part:
            continue
        pointer = re.fullmatch(r"(\w+)\s*\(\s*MIEN_CALL\s*\*\s*(\w+)\s*\)\s*\(.*\)", part)
        plain = re.fullmatch(r"((?:const\s+)?\w+[\w\s\*]*?)\s*(\w+(?:\[\w+\])?(?:\s*,\s*\w+)*)", part)
        if pointer:
            fields.append(Field(pointer.group(2), "function"))
        elif plain:
            for name in plain.group(2).split(","):
                name, _, size = name.strip().partition("[")
                fields.append(Field(name, plain.group(1).strip() + ("[" + size if size else "")))
        else:
            raise ValueError(f"{where}: cannot read the field '{part}'")
    return fields


def read_parameters(text, comment):
    parameters = []
    for part in without_comments(text).split(","):
        part = " ".join(part.split())
        if part in ("", "void"):
            continue
        match = re.fullmatch(r"(.*?)(\w+)(\[\w*\])?", part)
        kind = match.group(1).strip().replace(" *", "*") + ("*" if match.group(3) else "")
        documented = re.search(rf"@param\s+{match.group(2)}\s+(.*?)(?=\n\s*\*\s*@|\Z)", comment, re.S)
        said = documented.group(1) if documented else ""
        nullable = bool(re.search(r"may be null|or null\b|null:", said)) and "not null" not in said
        parameters.append(Parameter(match.group(2), kind, nullable))
    return parameters


def read_interface(include):
    structs, enumerators, functions, handles, callbacks = [], [], [], [], []
    for path in header_files(include):
        text = path.read_text()
        code = without_comments(text)
        for name, body in re.findall(r"typedef\s+struct\s+(\w+)\s*\{(.*?)\}\s*\1\s*;", code, re.S):
            structs.append(Struct(name, read_fields(body, f"{path.name}: {name}"), path.name))
        if len(re.findall(r"\bstruct\s+\w*\s*\{", code)) != sum(s.header == path.name for s in structs):
            raise ValueError(f"{path.name}: a struct is not of the form typedef struct x {{...}} x;")
        for body in re.findall(r"\benum\s*\{(.*?)\}", code, re.S):
            for item in body.split(","):
                if "=" not in item:
                    raise ValueError(f"{path.name}: the constant '{item.strip()}' has no explicit value")
                enumerators.append(item.split("=")[0].strip())
        handles += re.findall(r"typedef\s+struct\s+(\w+)\s+\1\s*;", code)
        callbacks += re.findall(r"typedef\s+\w+\s*\(\s*MIEN_CALL\s*\*\s*(\w+)\s*\)", code)
        declared = r"(?:(/\*\*(?:(?!\*/).)*\*/)\s*)?MIEN_API\s+([^;{]*?)MIEN_CALL\s+(mien_\w+)\s*\(([^;]*?)\)\s*;"
        for comment, result, name, parameters in re.findall(declared, text, re.S):
            functions.append(Function(name, result.strip().replace(" *", "*"),
                                      read_parameters(parameters, comment), comment, path.name))
    return Interface(structs, enumerators, functions, handles, callbacks)

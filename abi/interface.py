#!/usr/bin/env python3
"""The interface as data: abi/interface.json, from the headers.

  interface.py print    the JSON text: handles, constants, structs, callbacks, functions; for each parameter
                        direction, type, nullability, role, count, unit; for each function statuses,
                        ownership, locks

generate_bindings.py writes and checks the file with everything else that repeats the headers, so a binding
for another language can be made from this one file without reading C.
"""
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from documentation import base_of
from read_headers import HeaderError, read_interface


def item(p):
    row = {"name": p.name, "type": p.type, "role": p.role}
    if getattr(p, "direction", ""):
        row["direction"] = p.direction
    if "*" in p.type or p.role in ("callback", "user"):
        row["nullable"] = p.nullable
    for key in ("count", "counts", "enum", "unit"):
        if getattr(p, key):
            row[key] = getattr(p, key)
    if p.comment:
        row["text"] = p.comment
    return row


def function(f, interface):
    row = {"name": f.name, "header": f.header, "result": f.result, "purpose": f.purpose,
           "parameters": [item(p) for p in f.parameters], "statuses": f.statuses}
    makes = {p.name: f"{p.base}_release" for p in f.parameters if p.role == "handle_out"}
    if makes:
        row["makes"] = makes
    if f.lends:
        row["lends"] = {"owner": f.lends, "retain": f"{base_of(f.result)}_retain"}
    if f.locks:
        row["locks"] = f.locks
    row["cancel"] = f.fields["cancel"] == "yes"
    return {**row, **{key: f.fields[key] for key in ("errors", "owner", "thread", "cost", "since", "source", "return", "deprecated") if key in f.fields}}


def as_data(interface):
    return {
        "written_by": "abi/generate_bindings.py from include/mien/*.h",
        "version": interface.version, "abi_version": interface.abi_version,
        "aliases": interface.aliases,
        "handles": [{"name": name, "text": text} for name, text in interface.handles.items()],
        "constants": [{"name": g.name, "text": g.comment, "header": g.header,
                       "values": [{"name": c.name, "value": c.value, "text": c.comment} for c in g.constants]}
                      for g in interface.groups],
        "callbacks": [{"name": c.name, "result": c.result, "text": c.comment,
                       "parameters": [{"name": p.name, "type": p.type} for p in c.parameters]} for c in interface.callbacks],
        "structs": [{"name": s.name, "header": s.header, "use": s.use, "text": s.comment, "fields": [item(f) for f in s.fields]}
                    for s in interface.structs],
        "functions": [function(f, interface) for f in interface.functions],
    }


def as_text(interface):
    """JSON with one handle, constant, field, parameter or function on a line: small changes stay small."""
    def one(value):
        return json.dumps(value, ensure_ascii=False)

    def members(row, inner):
        head = {k: v for k, v in row.items() if k != inner}
        rows = ",\n   ".join(one(v) for v in row[inner])
        return f'{one(head)[:-1]}, "{inner}": [\n   {rows}]}}' if row[inner] else one(row)

    inner = {"constants": "values", "callbacks": "parameters", "structs": "fields", "functions": "parameters"}
    parts = []
    for key, value in as_data(interface).items():
        if isinstance(value, list):
            rows = ",\n  ".join(members(row, inner[key]) if key in inner else one(row) for row in value)
            parts.append(f' "{key}": [\n  {rows}\n ]')
        else:
            parts.append(f' "{key}": {one(value)}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


def main():
    try:
        sys.stdout.write(as_text(read_interface(Path(__file__).resolve().parent.parent / "include/mien")))
    except HeaderError as problem:
        print(problem, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

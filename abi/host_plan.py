"""How functions, structs and constants look in a language with classes: one plan for Python, C# and Java.

A function belongs to the class of the handle that its name opens with (mien_mesh_get_counts -> Mesh.counts);
without such a handle to Session, or to the library as a whole. What the C interface needs and a host knows by
itself is left out: counts of arrays, capacities, struct sizes, error records, the two calls for an array.
What comes out is the method's result; several outputs make a small class of their own.
"""
import re
from dataclasses import dataclass, field

from documentation import REAL, WHOLE, base_of

HIDDEN = ("count", "capacity", "count_out", "error", "struct_size", "user", "callback")
OUTPUTS = ("handle_out", "scalar_out", "array_out", "text_out", "struct_out", "structs_out", "view_out")
# Words that a runtime or a language takes for itself.
TAKEN = {"Progress", "Call", "Handle", "Library", "Native", "Functions", "Text", "Error", "MienException", "Object", "Cancelled",
         "Map", "List", "Set", "Record", "Task", "Thread", "Values", "Settings", "Information"}


def camel(name):
    return "".join(word[:1].upper() + word[1:].lower() for word in name.replace("mien_", "", 1).split("_"))


def lower_camel(name):
    text = camel("mien_" + name)
    return text[:1].lower() + text[1:]


@dataclass
class Method:
    function: object
    owner: str  # C name of the handle, or "" for the library
    name: str  # snake case, without get_
    static: bool  # no receiver
    receiver: object = None
    inputs: list = field(default_factory=list)
    outputs: list = field(default_factory=list)
    result: str = ""  # class of several outputs
    options: object = None  # the parameter whose struct carries progress and cancel
    dtype: object = None  # the parameter that says what a void* array holds


@dataclass
class Plan:
    interface: object
    classes: dict  # handle -> [Method]
    library: list  # methods of no class
    results: dict  # class name -> [Parameter]
    enums: dict  # group name -> class name
    structs: dict  # C name -> Struct
    lifetime: dict  # function name -> how a host reaches it
    makes: dict = field(default_factory=dict)


def carries_progress(struct):
    roles = {f.name: f.role for f in struct.fields}
    return roles.get("progress") == "callback" and roles.get("cancel") == "handle"


def visible_fields(struct):
    """Fields that a host sets or reads; progress and cancel are arguments of the call."""
    hidden = {"progress", "progress_user", "cancel"} if carries_progress(struct) else set()
    return [f for f in struct.fields if f.role not in ("struct_size", "reserved", "count", "user") and f.name not in hidden]


def owns_count(f, struct):
    """Whether the array gives its count field, which stands behind it; others must agree with what it says."""
    names = [other.name for other in struct.fields]
    return "." not in str(f.count[0]) and names.index(f.count[0]) == names.index(f.name) + 1


def scalars_first(fields):
    """Fields in the order in which they are written: lengths of arrays may be checked against numbers and views."""
    return sorted(fields, key=lambda f: f.role not in ("scalar", "matrix"))


def owner_of(function, interface):
    name = function.name[len("mien_"):]
    fits = [h for h in interface.handles if name.startswith(h[len("mien_"):] + "_")]
    if fits:
        handle = max(fits, key=len)
        return handle, name[len(handle) - len("mien_") + 1:]
    if any(p.base == "mien_session" and p.role == "handle" for p in function.parameters):
        return "mien_session", name
    return "", name


def plan_method(function, interface, structs):
    owner, name = owner_of(function, interface)
    name = name[4:] if name.startswith("get_") and name != "get_" else name
    method = Method(function, owner, name, True)
    pointer_output = next((p for p in function.parameters if p.role == "array_out" and p.base == "void"), None)
    for p in function.parameters:
        if p.role == "handle" and p.base == owner and method.receiver is None:
            method.receiver, method.static = p, False
        elif pointer_output is not None and p.base == "mien_dtype":
            method.dtype = p
        elif p.name == "abi_version" or p.role in HIDDEN:
            continue
        elif p.role in OUTPUTS:
            method.outputs.append(p)
        else:
            method.inputs.append(p)
        if p.role == "struct" and carries_progress(structs[p.base]):
            method.options = p
    # A handle that is made by a function which names its class and takes no object of it: static.
    if len(method.outputs) > 1:
        method.result = (camel(owner) if owner not in ("", "mien_session") else "") + camel("mien_" + name)
    return method


def make_plan(interface):
    structs = {s.name: s for s in interface.structs}
    plan = Plan(interface, {h: [] for h in interface.handles}, [], {}, {}, structs, {})
    for f in interface.functions:
        if f.name.endswith("_init") and f.parameters[0].role == "struct_out":
            plan.lifetime[f.name] = f.parameters[0].base
        elif f.name.endswith(("_retain", "_release")):
            plan.lifetime[f.name] = f.parameters[0].base
        else:
            method = plan_method(f, interface, structs)
            (plan.classes[method.owner] if method.owner else plan.library).append(method)
    names = {camel(h) for h in interface.handles} | {camel(s) for s in structs} | TAKEN
    for methods in [*plan.classes.values(), plan.library]:
        seen = set()
        for m in methods:
            if m.name in seen:
                raise SystemExit(f"host_plan.py: two functions want the method '{m.name}': {m.function.name}")
            seen.add(m.name)
            if m.result:
                if m.result in names:
                    raise SystemExit(f"host_plan.py: {m.function.name}: the name {m.result} of its results is taken")
                names.add(m.result)
                plan.results[m.result] = m.outputs
    for group in interface.groups:
        name = camel("mien_" + group.name)
        plan.enums[group.name] = name + "Kind" if name in names else name
    return plan


def element(base, interface):
    """The plain C type behind an alias."""
    kind = interface.aliases.get(base, base)
    if kind not in WHOLE + REAL + ("void", "char"):
        raise SystemExit(f"host_plan.py: '{base}' is no number")
    return kind


def number_result(function, interface):
    """The C type of a number that is returned by value, or ""; a status is none."""
    kind = interface.aliases.get(function.result, function.result)
    return kind if function.result != "mien_status" and kind in WHOLE + REAL else ""


def lent_class(function):
    return camel(base_of(function.result))


# What a comment says of pointers, sizes and buffers is C's business alone.
C_ALONE = (r"With (?:dst|all outputs) null and capacity 0: the (?:size|count)(?: only)?(?:, at the cost of the whole computation)?\.",
           r"; with dst null and 0 only the count is written", r"Set out->struct_size first\.", r"Initialise with mien_\w+\(\)\.",
           r"struct_size as the caller knows it, the rest is written\.?", r",? or null on failure", r",? or null with capacity 0",
           r"UTF-8, not null[;,.]? ?", r"\bnot null[;,.]? ?", r", or null(?=[.;,]|$)", r"room for (?=capacity|\w+_count|\w+_modes)",
           r"may be null when \w+ is 0[;.]? ?", r"\bnull when \w+ is 0[;.]? ?",
           r",? ?MIEN_E_BUFFER_TOO_SMALL \([^)]*\)", r"(?:one of )?capacity (?:rows of (?=\d)|x |(?=values|numbers|bytes|vertex|triangle|float64|doubles))")


def host_words(text):
    """A comment without what only C callers need."""
    text = re.sub(r"room for capacity(?: rows of)?(?: x)? (\d+|\w+_count)\b(?: values)?", r"rows of \1 values", text)
    for pattern in C_ALONE:
        text = re.sub(pattern, "", text)
    text = re.sub(r"\bmay be null\b", "may be left out", text)
    return re.sub(r"\s+", " ", text).strip(" ;,")


def sentences(text, width, prefix=""):
    """Words wrapped into lines, for comments."""
    lines, line = [], ""
    for word in text.split():
        if line and len(prefix) + len(line) + 1 + len(word) > width:
            lines.append(prefix + line)
            line = word
        else:
            line = f"{line} {word}".strip()
    return lines + ([prefix + line] if line else [])

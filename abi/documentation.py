"""What the comments of the headers mean for a caller: nullability, counts, ownership, errors, units.

The words are free except where a program must understand them; there the forms below are the only ones,
and anything else is a problem that names the parameter and says what to write:
  nullability  of a pointer: "not null", "may be null", "null allowed", "..., or null", "null when COUNT is 0"
  how many     of an array: "room for capacity [rows of] [x] N ...", "COUNT [x N] ...", "COUNT + 1 ...",
               "12 values ..."; or the attribute [in,count=COUNT*3]. COUNT is a parameter, or an output of
               the object's ..._get_counts(); in structs also the field NAME_count that follows
  @owner       of a made handle: "the caller releases *out with mien_..._release()"
  @errors      "none", names of statuses, "as mien_...()"
  @thread      "thread-safe", "externally synchronized by NAME [and NAME]", "no other call may use ..."
  @cancel      "yes" or "no";  @since a version
"""
import re

WHOLE = ("int32_t", "uint32_t", "int64_t", "uint64_t", "size_t", "uint8_t")
REAL = ("double", "float")
UNITS = ("mm2", "mm3", "mm", "ml", "rad", "deg")
NULLABILITY = re.compile(r"\bnot null\b|\bmay be null\b|\bnull allowed\b|\bor null\b|\bnull when \w+ is 0\b|\bnull: |\bnull \(default\)")
FACTOR = r"(?:\w+(?: \+ 1)?)"


def base_of(kind):
    return re.sub(r"\bconst\b|[\s*]|\[.*", "", kind)


def stars(kind):
    return kind.count("*")


def group_name(group):
    """FIT for MIEN_FIT_MIXTURE, MIEN_FIT_MAP; STATUS for the statuses."""
    names = [c.name.split("_")[1:] for c in group.constants]
    if any(c.name == "MIEN_OK" for c in group.constants):
        return "STATUS"
    shared = []
    for words in zip(*names):
        if len(set(words)) > 1 or len(shared) == min(map(len, names)) - 1:
            break
        shared.append(words[0])
    return "_".join(shared)


class Reader:
    """Understands one function or struct: collects problems instead of stopping at the first."""

    def __init__(self, interface):
        self.interface, self.problems = interface, []
        self.structs = {s.name: s for s in interface.structs}
        self.statuses = {c.name for g in interface.groups if g.name == "STATUS" for c in g.constants}
        self.functions = {f.name: f for f in interface.functions}
        self.callbacks = {c.name for c in interface.callbacks}
        self.where = ""

    def problem(self, what):
        self.problems.append(f"{self.where}: {what}")

    # ---- what parameters and fields share -------------------------------------------------------------
    def resolve(self, kind):
        base = base_of(kind)
        return self.interface.aliases.get(base, base)

    def read_nullability(self, item, label):
        words = re.sub(r",? (?:or )?null on failure|\(gives null\)", "", item.comment)
        if "null" in item.attributes or "nonnull" in item.attributes:
            item.nullable = "null" in item.attributes
            return
        said = {m != "not null" for m in NULLABILITY.findall(words)}
        if len(said) != 1:
            self.problem(f"{label}: say {'one of ' if said else ''}'not null' or 'may be null' "
                         f"(or '..., or null', 'null when COUNT is 0') in '{item.comment[:70]}'")
        item.nullable = said == {True}

    def read_unit(self, item):
        words = item.name.split("_")
        if "per" not in words and words[-1] in UNITS:
            item.unit = {"ml": "mL"}.get(words[-1], words[-1])
        else:
            match = re.search(r"(?:^|[;,] )(mm\^2|mm|mL|rad)(?:[,;.]|$| \()", item.comment)
            item.unit = match.group(1).replace("^", "") if match else ""

    def read_enum(self, item):
        groups = {g.name: g for g in self.interface.groups}
        match = re.search(r"\bMIEN_([A-Z0-9_]*?)_(?:\*|\.\.\.)", item.comment)
        named = re.findall(r"\bMIEN_[A-Z0-9_]+\b", item.comment)
        if match:
            if match.group(1) not in groups:
                self.problem(f"{item.name}: MIEN_{match.group(1)}_* are no constants of the headers")
            item.enum = match.group(1)
        elif named and re.match(r"(?:one of )?MIEN_", item.comment):
            for group in groups.values():
                if named[0] in [c.name for c in group.constants]:
                    item.enum = group.name

    def factors(self, text, known):
        """'limit_count + 1' or 'row_count * channel_count' -> list of factors, or None with what is unknown."""
        found = []
        for part in re.split(r" ?\* ?", text):
            part = part.replace(" ", "")
            name = part[:-2] if part.endswith("+1") else part
            if part.isdigit():
                found.append(int(part))
            elif name in known:
                found.append(part)
            elif "counts." + name in known:
                found.append("counts." + part)
            else:
                return None
        return found

    def count_from_words(self, comment, known):
        for clause in re.split(r"[;.:] |, ", comment):
            clause = re.sub(r"^room for ", "", clause.strip().rstrip("."))
            match = re.match(rf"({FACTOR}) rows of ({FACTOR})\b|({FACTOR}(?: x {FACTOR})*)\b", clause)
            if not match:
                continue
            text = f"{match.group(1)}*{match.group(2)}" if match.group(1) else match.group(3)
            found = self.factors(text.replace(" x ", "*"), known)
            if found and (not isinstance(found[0], int) or re.match(r"\d+ (values|numbers|float64|float32|doubles|bytes)\b", clause)):
                return found
            # A first factor that counts, with words behind it: "vertex_count vertex numbers".
            if match.group(3) and " x " not in match.group(3):
                found = self.factors(match.group(3), known)
                if found and not isinstance(found[0], int):
                    return found
        return None

    # ---- structs ---------------------------------------------------------------------------------------
    def read_struct(self, struct):
        fields = struct.fields
        numbers = {f.name for f in fields if not stars(f.type) and base_of(f.type) in ("uint64_t", "uint32_t")}
        for index, item in enumerate(fields):
            self.where = item.where
            label = f"{struct.name}.{item.name}"
            item.base = base_of(item.type)
            match = re.match(r"\[([a-z]+(?:=[^\],]+)?(?:,[a-z]+(?:=[^\],]+)?)*)\] ?", item.comment)
            if match:
                item.attributes = dict(part.partition("=")[::2] for part in match.group(1).split(","))
                item.comment = item.comment[match.end():]
            item.comment = " ".join(item.comment.split())
            self.read_unit(item)
            following = fields[index + 1].name if index + 1 < len(fields) else ""
            if item.name == "struct_size":
                item.role = "struct_size"
            elif item.name.startswith("reserved"):
                item.role = "reserved"
            elif item.base in self.callbacks:
                item.role, item.nullable = "callback", True
            elif item.type == "void*" and index and fields[index - 1].role == "callback":
                item.role, item.nullable = "user", True
            elif item.base == "mien_array_view" and not stars(item.type):
                item.role = "matrix"
                columns = re.search(r"#?\w+ x (\d+)", item.comment)
                item.count = [int(columns.group(1)) if columns else 1]
            elif stars(item.type):
                self.read_pointer_field(struct, item, following, numbers, label)
            elif item.base in self.structs:
                item.role = "struct"
            elif self.resolve(item.type) in WHOLE + REAL + ("char",):
                size = re.search(r"\[(\d+)\]", item.type)
                item.role = ("chars" if item.base == "char" else "fixed") if size else "scalar"
                item.count = [int(size.group(1))] if size else []
                if self.resolve(item.type) in WHOLE:
                    self.read_enum(item)
            else:
                self.problem(f"{label}: the type '{item.type}' is unknown to the interface")
        for item in fields:  # a field that counts others belongs to them
            item.counts = [f.name for f in fields if f.role in ("array", "texts", "structs") and f.count and f.count[0] == item.name]
            before = fields[fields.index(item) - 1].name
            if before in item.counts and item.role == "scalar":
                item.role = "count"
        inits = {f.parameters[0].base for f in self.interface.functions
                 if f.name == f"{struct.name}_init" and len(f.parameters) == 2}
        sized = bool(fields) and fields[0].role == "struct_size"
        struct.use = "options" if struct.name in inits else "result" if sized else "value"

    def read_pointer_field(self, struct, item, following, numbers, label):
        if item.base == "void" and struct.name == "mien_array_view":
            item.role, item.nullable, item.count = "data", True, ["count"]
            return
        self.read_nullability(item, label)
        if item.base in self.interface.handles:
            item.role = "handle" if stars(item.type) == 1 else "handles"
            if item.role == "handle":
                return
        elif item.base == "char" and stars(item.type) == 1:
            item.role = "text"
            return
        else:
            item.role = "texts" if item.base == "char" else "structs" if item.base in self.structs else "array"
        columns = re.match(r"#?\w+ x (\d+)\b", item.comment)
        if "count" in item.attributes:
            item.count = [int(c) if c.isdigit() else c for c in item.attributes["count"].split("*")]
        elif following in numbers and following.endswith("_count"):
            item.count = [following] + ([int(columns.group(1))] if columns else [])
        else:
            self.problem(f"{label}: how many? Let a field NAME_count follow, or open its comment with [count=FIELD*3]")

    # ---- functions -------------------------------------------------------------------------------------
    def read_function(self, f):
        self.where = f"{f.where}: {f.name}"
        by_name = {p.name: p for p in f.parameters}
        known = {p.name for p in f.parameters if not stars(p.type) and self.resolve(p.type) in WHOLE}
        receiver = next((p for p in f.parameters if base_of(p.type) in self.interface.handles and stars(p.type) == 1
                         and base_of(p.type) not in ("mien_session", "mien_cancel")), None)
        counter = self.functions.get(f"{base_of(receiver.type)}_get_counts") if receiver else None
        if counter and counter is not f:
            known |= {"counts." + p.name for p in counter.parameters if stars(p.type) == 1 and p.direction == "out"}
        for p in f.parameters:
            p.base = base_of(p.type)
            self.read_unit(p)
            self.read_role(f, p, known)
        for p in f.parameters:
            p.counts = [q.name for q in f.parameters if q.count and str(q.count[0]).replace("+1", "") == p.name]
            if p.role == "scalar" and p.name == "capacity":
                p.role = "capacity"
            elif p.role == "scalar" and any(by_name[n].direction == "in" or not by_name[n].count[0] == p.name for n in p.counts):
                p.role = "count"
            if p.role == "capacity" and not p.counts:
                self.problem("capacity: no array has room for it ('room for capacity values, or null')")
        if any(p.role == "capacity" for p in f.parameters) and not any(p.role == "count_out" for p in f.parameters):
            self.problem("an array of 'capacity' needs the output 'count' (uint64_t*) behind it")
        self.read_fields(f)

    def read_role(self, f, p, known):
        count, const = stars(p.type), p.type.startswith("const")
        if count == 0:
            if self.resolve(p.type) in WHOLE + REAL:
                p.role = "struct_size" if p.name == "struct_size" else "scalar"
                if p.direction != "in":
                    self.problem(f"{p.name}: a number passed by value is [in]")
                if self.resolve(p.type) in WHOLE:
                    self.read_enum(p)
            elif p.base in self.callbacks:
                p.role, p.nullable = "callback", True
            else:
                self.problem(f"{p.name}: the type '{p.type}' is unknown to the interface")
            return
        if p.name == "error" and p.base == "mien_error":
            p.role, p.nullable = "error", True
            if p.nullable and "may be null" not in p.comment:
                self.problem("error: an error record may be null")
            return
        self.read_nullability(p, p.name)
        wrong = "in" if const and count == 1 or p.type.startswith("const") and p.base in self.interface.handles else ""
        if wrong and p.direction != "in":
            self.problem(f"{p.name}: '{p.type}' is read only, so it is [in]")
        needs_count = False
        if p.base in self.interface.handles:
            p.role = {1: "handle", 2: "handles" if const else "handle_out"}.get(count, "")
            needs_count = p.role == "handles"
        elif p.base == "mien_array_view":
            p.role = "matrix"
            columns = re.search(r"#?\w+ x (\d+)", p.comment)
            p.count = [int(columns.group(1)) if columns else 1]
        elif p.base in self.structs:
            found = self.count_from_words(p.comment, known) or p.attributes.get("count")
            p.role = ("structs" if found else "struct") if const else ("structs_out" if found else "struct_out")
            needs_count = bool(found)
        elif p.base == "char":
            p.role = ("text" if count == 1 else "texts") if const else "text_out"
            needs_count = p.role != "text"
        elif p.type == "void*" and f.parameters[f.parameters.index(p) - 1].role == "callback":
            p.role = "user"
        elif count == 2:
            p.role = "view_out"
            counting = [q for q in f.parameters if q.name == "count" and stars(q.type)]
            p.count = self.factors(p.attributes.get("count", ""), {"count"}) if counting else None
            if not p.count:
                self.problem(f"{p.name}: a lent array is [out,count=count*3], with the output 'count' (uint64_t*) behind it")
                p.count = []
        elif p.base == "uint64_t" and p.name == "count" and not const and any(
                q.name == "capacity" or stars(q.type) == 2 and q.base not in self.interface.handles for q in f.parameters):
            p.role = "count_out"
        elif const:
            p.role, needs_count = "array" if p.base != "void" else "bytes", True
        else:
            found = self.count_from_words(p.comment, known) if "count" not in p.attributes else True
            p.role = "array_out" if found else "scalar_out"
            needs_count = bool(found)
            if not found and re.search(r"\broom for\b", p.comment):
                self.problem(f"{p.name}: how many? '{p.comment[:60]}' names no parameter; write e.g. "
                             "'room for capacity x 3 values, or null' or [out,count=capacity*3]")
            if p.base == "void":
                p.role, needs_count = "array_out", True
        if needs_count:
            if "count" in p.attributes:
                found = self.factors(p.attributes["count"], known)
            else:
                found = self.count_from_words(p.comment, known)
            if not found:
                self.problem(f"{p.name}: how many? '{p.comment[:60]}' names no parameter; write e.g. "
                             f"'value_count values' or [{p.direction},count=value_count*3]")
            p.count = found or []

    def read_fields(self, f):
        errors = f.fields.get("errors", "")
        f.statuses = list(dict.fromkeys(re.findall(r"\bMIEN_E_\w+", errors)))
        for name in f.statuses:
            if name not in self.statuses:
                self.problem(f"@errors: {name} is no status")
        for other in re.findall(r"\bas (mien_\w+)\(\)", errors):
            if other not in self.functions:
                self.problem(f"@errors: {other}() is no function")
            f.statuses.append("as " + other)
        if f.result == "mien_status" and not f.statuses:
            self.problem("@errors: name the statuses, or 'as mien_...()'")
        if f.result != "mien_status" and not errors.startswith("none"):
            self.problem("@errors: 'none': it returns no status")
        if f.fields.get("cancel", "no") not in ("yes", "no"):
            self.problem("@cancel: 'yes' or 'no'")
        if not re.fullmatch(r"\d+\.\d+", f.fields.get("since", "0.1")):
            self.problem("@since: a version such as 0.2")
        thread = f.fields.get("thread", "thread-safe")
        match = re.fullmatch(r"externally synchronized by (\w+)(?: and (\w+))?\.?", thread)
        if match:
            f.locks = [name for name in match.groups() if name]
            for name in f.locks:
                if name not in [p.name for p in f.parameters]:
                    self.problem(f"@thread: {name} is no parameter")
        elif not re.match(r"thread-safe|no other call may use", thread):
            self.problem("@thread: 'thread-safe', 'externally synchronized by NAME' or 'no other call may use NAME'")
        owner = f.fields.get("owner", "")
        for p in f.parameters:
            if p.role == "handle_out" and f"{p.base}_release()" not in owner:
                self.problem(f"@owner: 'the caller releases *{p.name} with {p.base}_release()'")
        if base_of(f.result) in self.interface.handles and not f.name.endswith("_retain"):
            lenders = [p for p in f.parameters if p.role == "handle"]
            f.lends = lenders[0].name if len(lenders) == 1 else ""
            if not f.lends or f"{base_of(f.result)}_retain" not in self.functions:
                self.problem("a lent handle needs exactly one object that lends it, and a _retain() of its type")


def understand(interface):
    """Fills in roles, counts, nullability, locks of the whole interface; the list of what stays unclear."""
    for group in interface.groups:
        group.name = group_name(group)
    reader = Reader(interface)
    for function in interface.functions:  # roles of structs need the _init functions' types
        for parameter in function.parameters:
            parameter.base = base_of(parameter.type)
    for struct in interface.structs:
        reader.read_struct(struct)
    for function in interface.functions:
        reader.read_function(function)
    names = [g.name for g in interface.groups]
    for name in {n for n in names if names.count(n) > 1}:
        reader.problem(f"two enums share the name {name}")
    return reader.problems

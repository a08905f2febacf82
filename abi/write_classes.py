"""What C# and Java share: the bodies of methods over a Call object that owns one call's memory.

Both languages spell the steps alike (var, new, method calls); a Dialect names what differs. A method's body
is: lock what only one call at a time may use, bring the arguments over, make room for what comes out, call
(again with more room, where the size was not known), read the results.
"""
from documentation import REAL
from host_plan import camel, element, host_words, lent_class, lower_camel

SIZES = {"int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "size_t": 8, "double": 8, "float": 4, "uint8_t": 1, "char": 1}


class Dialect:
    """Names of one language."""
    open_call = ""  # statement that makes the Call and opens its scope
    functions = ""  # what raw functions are called on
    self_word = "this"
    error = ""  # the error record's address
    length = ""  # length of an array

    def __init__(self, plan):
        self.plan, self.interface = plan, plan.interface

    def helper(self, name):  # a method of Call
        raise NotImplementedError

    def member(self, name):  # a public method or property of a class
        raise NotImplementedError

    def kind(self, base):
        return element(base, self.interface)

    def counts_member(self, receiver, name):
        raise NotImplementedError

    def by_value(self, parameter, expression):
        """A number as the raw function takes it."""
        raise NotImplementedError

    def pointer(self, expression):
        """The address that a raw function takes of what a helper returned."""
        return expression


def safe(name, words):
    return name + "_" if name in words else name


class Body:
    def __init__(self, method, dialect, dtype=None):
        self.m, self.d, self.f, self.dtype = method, dialect, method.function, dtype
        self.lines, self.at, self.counts = [], {}, {}

    def host(self, name):
        """The argument's name in the host language."""
        if self.m.receiver is not None and name == self.m.receiver.name:
            return self.d.self_word
        return self.d.argument(name)

    def factor(self, factor):
        if isinstance(factor, int):
            return str(factor)
        name, plus = (factor[:-2], " + 1") if factor.endswith("+1") else (factor, "")
        if name.startswith("counts."):
            receiver = next(p for p in self.f.parameters if p.role == "handle" and p.base not in ("mien_session", "mien_cancel"))
            return self.d.counts_member(self.host(receiver.name), name[len("counts."):]) + plus
        if name in self.counts:
            return self.counts[name] + plus
        p = next(p for p in self.f.parameters if p.name == name)
        wide = self.d.name == "java" and SIZES[self.d.kind(p.base)] == 8
        return f"{'' if wide else '(long) '}{self.d.argument(name)}{plus}"

    def product(self, factors):
        return " * ".join(self.factor(f) for f in factors) or "1"

    def say(self, line):
        self.lines.append(line)

    def set_rows(self, p, host):
        """The count that an array gives, or the check that it agrees with what is known."""
        d, first = self.d, p.count[0]
        rows = f'call.{d.helper("rows")}({host}, {self.product(p.count[1:])}, "{p.name}")'
        name = str(first).replace("+1", "")
        counter = next((q for q in self.f.parameters if q.name == name and q.role == "count"), None)
        if counter is not None and name not in self.counts and not str(first).endswith("+1"):
            self.counts[name] = d.local(name)
            self.say(f"var {d.local(name)} = {rows};")
        else:
            self.say(f'call.{d.helper("agree")}("{p.name}", {rows}, {self.factor(first)});')

    def bring_inputs(self):
        d, m = self.d, self.m
        for name in self.f.locks:
            self.say(f"call.{d.helper('lock')}({self.host(name)});")
        # Arrays whose count has a plain name first: they define what others must agree with.
        parameters = sorted(self.f.parameters, key=lambda p: bool(p.count) and str(p.count[0]).endswith("+1"))
        for p in parameters:
            host, at = self.host(p.name), d.local(p.name + "_at")
            optional = "OrNull" if p.nullable and host != d.self_word else ""
            if p.role == "handle":
                self.say(f"var {at} = call.{d.helper('use' + optional)}({host});")
            elif p.role == "text":
                self.say(f"var {at} = call.{d.helper('text' + optional)}({host});")
            elif p is m.options:
                made = d.fresh_options(p.base, host, p.nullable)
                self.say(f"var {at} = {made}.{d.helper('write')}(call, progress, {d.cancel_argument});")
            elif p.role == "struct":
                self.say(f"var {at} = {d.write_record(p, host)};")
            elif p.role == "matrix":
                self.say(f"var {at} = call.{d.helper('view' + optional)}({host}, {p.count[0]}, \"{p.name}\");")
            elif p.role in ("array", "bytes", "texts", "handles", "structs"):
                self.set_rows(p, host)
                helper = {"array": "array", "bytes": "array", "texts": "texts", "handles": "handles"}.get(p.role)
                required = "" if p.nullable else f'call.{d.helper("required")}({host}, "{p.name}");'
                if required:
                    self.lines.insert(0, required)
                made = f"call.{d.helper(helper)}({host})" if helper else d.write_records(p, host)
                self.say(f"var {at} = {made};")
            else:
                continue
            self.at[p.name] = d.pointer(at)

    def make_room(self, capacity):
        d = self.d
        for p in self.m.outputs:
            at = d.local(p.name + "_at")
            if p.role in ("handle_out", "scalar_out", "view_out"):
                size = "8"
            elif p.role == "struct_out":
                size = None
                self.say(f"var {at} = {d.fresh_record(p.base)};")
            else:
                if (p.count[0] == "capacity") != capacity:
                    continue
                width = self.width(p)
                columns = self.product(p.count[1:])
                rows = "capacity" if capacity else self.factor(p.count[0])
                size = " * ".join(x for x in (rows, columns, str(width)) if x != "1") or "1"
            if p.role == "struct_out" and capacity or (capacity and p.role in ("handle_out", "scalar_out", "view_out")):
                continue
            if size is not None:
                self.say(f"var {at} = call.{d.helper('room')}({size});" if not capacity else f"{at} = call.{d.helper('room')}({size});")
            self.at[p.name] = d.pointer(at)

    def width(self, p):
        if p.role == "structs_out":
            return self.d.record_size(p.base)
        kind = self.dtype or self.d.kind(p.base)
        return SIZES[kind]

    def arguments(self):
        d, row = self.d, []
        for p in self.f.parameters:
            if p.role == "error":
                row.append(d.error)
            elif p.role == "capacity":
                row.append(d.capacity_argument)
            elif p.role == "count":
                row.append(d.by_value(p, self.counts[p.name], counted=True))
            elif p.role == "count_out":
                row.append(d.pointer("countAt"))
            elif p.name == "abi_version":
                row.append(d.abi_version)
            elif p is self.m.dtype:
                row.append("1" if self.dtype == "float" else "2")
            elif p.role == "scalar":
                row.append(d.by_value(p, self.host(p.name)))
            else:
                row.append(self.at[p.name])
        return ", ".join(row)

    def read(self, p, rows):
        """The host value of an output."""
        d, at = self.d, self.d.local(p.name + "_at")
        if p.role == "handle_out":
            return f"call.{d.helper('keep')}(new {camel(p.base)}(call.{d.helper('pointer')}({at})))"
        if p.role == "scalar_out":
            return d.read_number(p, at)
        if p.role == "struct_out":
            return f"{camel(p.base)}.{d.helper('read')}(call, {at})" if d.name == "csharp" else f"{camel(p.base)}.read(call, {at}, 0)"
        if p.role == "structs_out":
            return d.read_records(p, at, self.factor(p.count[0]))
        if p.role == "text_out":
            return f"call.{d.helper('readText')}({at}, {rows})"
        count = rows if p.count[0] in ("capacity", "count") else self.factor(p.count[0])
        total = " * ".join(x for x in (count, self.product(p.count[1:])) if x != "1") or "1"
        kind = self.dtype or d.kind(p.base)
        if p.role == "view_out":
            return d.view(self, at, total, kind)
        return f"call.{d.array_reader(kind)}({at}, {total})"

    def write(self):
        """The statements inside the call's scope, with the return."""
        d, f, m = self.d, self.f, self.m
        self.bring_inputs()
        if f.lends:
            self.say(f"var lent = {d.functions}{f.name}({self.arguments()});")
            self.say(f"{d.functions}{m.function.parameters and ''}{_retain(f)}(lent);")
            return self.lines + [f"return new {lent_class(f)}(lent);"]
        if f.result != "mien_status":
            return self.lines + [d.plain_result(f, f"{d.functions}{f.name}({self.arguments()})")]
        sized = any(p.role == "capacity" for p in f.parameters)
        counted = any(p.role == "count_out" for p in f.parameters)
        self.make_room(False)
        if counted:
            self.say(f"var countAt = call.{d.helper('room')}(8);")
        rows = f"call.{d.helper('count')}(countAt)"
        if sized:
            widest = self.widest()
            self.say(f"long capacity = call.{d.helper('firstCapacity')}({widest});")
            for p in m.outputs:
                if p.count and p.count[0] == "capacity":
                    self.say(f"{d.address_type} {d.local(p.name + '_at')};")
            self.say("do {")
            before = len(self.lines)
            self.make_room(True)
            self.lines[before:] = ["    " + line for line in self.lines[before:]]
            call = f"{d.functions}{f.name}({self.arguments()})"
            self.say(f"}} while ((capacity = call.{d.helper('more')}({call}, capacity, countAt)) != 0);")
            if any(p.role != "text_out" and p.count and p.count[0] == "capacity" for p in m.outputs):
                self.say(f"var rows = {rows};")
                rows = "rows"
        else:
            self.say(f"call.{d.helper('check')}({d.functions}{f.name}({self.arguments()}));")
            if counted:
                self.say(f"var rows = {rows};")
                rows = "rows"
        values = [self.read(p, rows) for p in m.outputs]
        if m.result:
            return self.lines + [f"return new {m.result}({', '.join(values)});"]
        return self.lines + ([f"return {values[0]};"] if values else [])

    def widest(self):
        sizes = [" * ".join(x for x in (self.product(p.count[1:]), str(self.width(p))) if x != "1") or "1"
                 for p in self.m.outputs if p.count and p.count[0] == "capacity"]
        return max(sizes, key=lambda s: (not s.isdigit() and "*" in s and not all(t.strip().isdigit() for t in s.split("*")),
                                         _value(s)))


def _value(text):
    total = 1
    for part in text.split("*"):
        total *= int(part) if part.strip().isdigit() else 1
    return total


def _retain(f):
    from documentation import base_of
    return f"{base_of(f.result)}_retain"


def ordered(inputs):
    return [p for p in inputs if not p.nullable] + [p for p in inputs if p.nullable]


def real(base, interface):
    return element(base, interface) in REAL


def doc_lines(method):
    """(summary, [(argument, words)], failures) of a method."""
    arguments = [(p.name, host_words(p.comment)) for p in ordered(method.inputs) if host_words(p.comment)]
    errors = host_words(method.function.fields["errors"])
    return host_words(method.function.purpose), arguments, "" if errors == "none" else errors


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


__all__ = ["Body", "Dialect", "SIZES", "camel", "doc_lines", "escape", "lower_camel", "ordered", "real", "safe"]

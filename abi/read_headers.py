"""Reads the public C headers into plain tables: structs with fields, constants, callbacks, functions
with their documentation. One strict parser for all that stands on the interface: it knows the subset
of C that the headers keep to (abi/README.md) and the fixed fields of their comments, and stops with
file, line and what to write where it meets anything else. What the words of a comment mean for a
caller (nullability, counts, ownership) is documentation.py's business.
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

TOKEN = re.compile(r"""(?P<after>/\*\*<(?:(?!\*/).)*\*/)|(?P<doc>/\*\*(?:(?!\*/).)*\*/)|(?P<note>/\*(?:(?!\*/).)*\*/)
    |(?P<directive>^[ \t]*\#(?:[^\n\\]|\\\n|\\.)*)|(?P<space>\s+)|(?P<text>"[^"\n]*")|(?P<word>[A-Za-z_]\w*)
    |(?P<number>-?\d\w*)|(?P<mark>[{}()\[\];,=*])""", re.S | re.X | re.M)
FUNCTION_FIELDS = ("errors", "owner", "thread", "cancel", "cost", "since")
OPTIONAL_FIELDS = ("source", "return", "deprecated")


class HeaderError(ValueError):
    """What is unclear in a header, where, and what to write instead."""


@dataclass
class Field:
    name: str
    type: str  # as written, "[n]" appended for arrays
    comment: str = ""
    where: str = ""
    # Written by documentation.py, as for parameters.
    nullable: bool = False
    role: str = ""
    base: str = ""
    count: list = field(default_factory=list)
    counts: list = field(default_factory=list)
    enum: str = ""
    unit: str = ""
    attributes: dict = field(default_factory=dict)


@dataclass
class Struct:
    name: str
    fields: list
    header: str
    comment: str = ""
    use: str = ""  # options (has an _init), result (opens with struct_size, written by the library), value


@dataclass
class Constant:
    name: str
    value: int
    comment: str = ""


@dataclass
class Group:  # the constants of one enum
    constants: list
    header: str
    comment: str = ""
    name: str = ""  # from the words that all constants open with


@dataclass
class Parameter:
    name: str
    type: str
    direction: str = ""
    comment: str = ""  # behind the direction, one line
    attributes: dict = field(default_factory=dict)  # [in,count=3] -> {"count": "3"}
    # Written by documentation.py: what a caller must know.
    nullable: bool = False
    role: str = ""
    base: str = ""  # the type without const, stars and [n]
    count: list = field(default_factory=list)  # factors: numbers, names of parameters, "name+1", "counts.name"
    counts: list = field(default_factory=list)  # role count: the parameters whose length it gives
    enum: str = ""  # the group of constants that it takes
    unit: str = ""


@dataclass
class Function:
    name: str
    result: str
    parameters: list
    comment: str  # as written
    header: str
    where: str = ""
    purpose: str = ""
    fields: dict = field(default_factory=dict)  # errors, owner, thread, cancel, cost, since, source
    # Written by documentation.py.
    statuses: list = field(default_factory=list)
    locks: list = field(default_factory=list)  # parameters that only one call at a time may use
    lends: str = ""  # a returned handle stays with this parameter


@dataclass
class Callback:
    name: str
    result: str
    parameters: list
    header: str
    comment: str = ""


@dataclass
class Interface:
    structs: list
    groups: list
    functions: list
    handles: dict  # name -> comment
    callbacks: list
    aliases: dict  # mien_status -> int32_t
    version: str = ""
    abi_version: int = 0

    @property
    def enumerators(self):
        return [c.name for group in self.groups for c in group.constants]


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


def plain(comment):
    """The text of a comment without its frame, one space between words, paragraphs kept apart by newlines."""
    text = re.sub(r"^/\*\*?<?|\*/$", "", comment.strip())
    lines = [re.sub(r"^\s*\*( |$)", "", line).strip() for line in text.split("\n")]
    return re.sub(r"[ \t]+", " ", "\n".join(lines)).strip()


class Reader:
    """One header as tokens: (kind, text, line)."""

    def __init__(self, path):
        self.path, self.at, self.tokens = path, 0, []
        text, place = path.read_text(), 0
        while place < len(text):
            match = TOKEN.match(text, place)
            line = text.count("\n", 0, place) + 1
            if not match:
                raise HeaderError(f"{path.name}:{line}: cannot read '{text[place:place + 20].splitlines()[0]}'")
            if match.lastgroup not in ("space", "note"):
                self.tokens.append((match.lastgroup, match.group(), line))
            place = match.end()

    def fail(self, what):
        line = self.tokens[min(self.at, len(self.tokens) - 1)][2]
        raise HeaderError(f"{self.path.name}:{line}: {what}")

    def peek(self, ahead=0):
        return self.tokens[self.at + ahead][1] if self.at + ahead < len(self.tokens) else ""

    def kind(self):
        return self.tokens[self.at][0] if self.at < len(self.tokens) else ""

    def where(self):
        return f"{self.path.name}:{self.tokens[self.at][2]}"

    def take(self, expected=None):
        if self.at >= len(self.tokens):
            self.fail(f"the file ends where '{expected or 'more'}' is expected")
        kind, text, _ = self.tokens[self.at]
        if expected is not None and text != expected:
            self.fail(f"'{expected}' is expected before '{text}'")
        self.at += 1
        return text

    def word(self, what):
        if self.kind() != "word":
            self.fail(f"{what} is expected before '{self.peek()}'")
        return self.take()

    def documentation(self, kind):
        found = ""
        while self.kind() == kind:
            found += plain(self.take()) + " "
        return found.strip()

    def type_and_name(self, stop):
        """A C declarator of the subset: words and stars, a name, optional [n]. Function pointers: type 'function'."""
        words = []
        while self.kind() == "word" or self.peek() == "*":
            words.append(self.take())
        if self.peek() == "(":
            self.fail("a function pointer needs a typedef: typedef T(MIEN_CALL* mien_x_fn)(...);")
        if len(words) < 2 or words[-1] == "*":
            self.fail("a type and a name are expected")
        name, size = words.pop(), ""
        if self.peek() == "[":
            self.take()
            size = "[" + (self.take() if self.peek() != "]" else "") + "]"
            self.take("]")
        if self.peek() not in stop:
            self.fail(f"one of {' '.join(stop)} is expected behind '{name}'")
        kind = " ".join(words).replace(" *", "*").replace("* ", "*").replace("*const*", "* const*")
        return kind.replace("*const", "* const").replace("*  const", "* const"), name, size


def read_struct(reader, name, comment):
    fields = []
    while reader.peek() != "}":
        where = reader.where()
        kind, field_name, size = reader.type_and_name((";",))
        reader.take(";")
        fields.append(Field(field_name, kind + size, reader.documentation("after"), where))
    reader.take("}")
    if reader.peek() != name:
        reader.fail(f"a struct is written typedef struct {name} {{...}} {name};")
    reader.take()
    reader.take(";")
    return Struct(name, fields, reader.path.name, comment)


def read_group(reader, comment):
    constants = []
    reader.take("{")
    while reader.peek() != "}":
        name = reader.word("a constant's name")
        if reader.peek() != "=":
            reader.fail(f"the constant '{name}' needs an explicit value")
        reader.take()
        value = reader.take()
        if not re.fullmatch(r"-?\d+", value):
            reader.fail(f"the value of '{name}' must be a decimal number, not '{value}'")
        before = reader.documentation("after")
        if reader.peek() == ",":
            reader.take()
        constants.append(Constant(name, int(value), (before + " " + reader.documentation("after")).strip()))
    reader.take("}")
    reader.take(";")
    return Group(constants, reader.path.name, comment)


def read_parameters(reader):
    parameters = []
    reader.take("(")
    if reader.peek() == "void" and reader.peek(1) == ")":
        reader.take()
    while reader.peek() != ")":
        kind, name, size = reader.type_and_name((",", ")"))
        if size:
            reader.fail(f"write '{kind}*' and the count in the comment: C does not keep '{name}{size}'")
        parameters.append(Parameter(name, kind))
        if reader.peek() == ",":
            reader.take()
    reader.take(")")
    return parameters


def read_function_comment(function, problem):
    """Purpose, parameters and fields of a function's comment; every field once, nothing unknown."""
    blocks = re.split(r"(?m)^@", plain(function.comment))
    function.purpose = " ".join(blocks[0].split())
    if not function.purpose:
        problem("no purpose: say in the first sentence what it does")
    described = {}
    for block in blocks[1:]:
        name, _, text = block.partition(" ")
        text = " ".join(text.split())
        if name == "param":
            match = re.fullmatch(r"(\w+) \[(in|out|in,out)((?:,[a-z]+(?:=[^\],]+)?)*)\](?: (.*))?", text)
            if not match:
                problem(f"'@param {text[:60]}' is not of the form @param NAME [in|out|in,out] words, "
                        "with attributes as in [out,count=3]")
                continue
            if match.group(1) in described:
                problem(f"parameter {match.group(1)} is documented twice")
            described[match.group(1)] = match
        elif name in FUNCTION_FIELDS + OPTIONAL_FIELDS:
            if name in function.fields:
                problem(f"@{name} stands twice")
            if not text:
                problem(f"@{name} is empty")
            function.fields[name] = text
        else:
            problem(f"@{name} is no field; known are @param @{' @'.join(FUNCTION_FIELDS + OPTIONAL_FIELDS)}")
    for name in FUNCTION_FIELDS:
        if name not in function.fields:
            problem(f"@{name} is missing")
    for parameter in function.parameters:
        match = described.pop(parameter.name, None)
        if match is None:
            problem(f"parameter {parameter.name} is not documented with [in] or [out]")
            continue
        parameter.direction, parameter.comment = match.group(2), match.group(4) or ""
        for item in filter(None, match.group(3).split(",")):
            key, _, value = item.partition("=")
            parameter.attributes[key] = value
    for name in described:
        problem(f"documents {name}, which is no parameter")


def read_header(path, interface, problems):
    reader = Reader(path)
    while reader.at < len(reader.tokens):
        where, comment_raw = reader.where(), ""
        if reader.kind() == "doc":
            comment_raw = reader.take()
        if reader.kind() == "directive":  # a comment before it is its own
            reader.take()
            continue
        if comment_raw and reader.kind() == "doc":
            problems.append(f"{where}: a comment that belongs to no declaration")
            continue
        comment = plain(comment_raw)
        word = reader.take()
        if word == "extern":
            reader.take('"C"')
            reader.take("{")
        elif word == "}":
            continue  # of extern "C"
        elif word == "typedef" and reader.peek() == "struct":
            reader.take()
            name = reader.word("a struct's name")
            if reader.peek() == "{":
                reader.take()
                interface.structs.append(read_struct(reader, name, comment))
            else:
                reader.take(name)
                reader.take(";")
                interface.handles[name] = comment
        elif word == "typedef":
            kind = reader.word("a type")
            if reader.peek() == "(":
                reader.take()
                reader.take("MIEN_CALL")
                reader.take("*")
                name = reader.word("the callback's name")
                reader.take(")")
                interface.callbacks.append(Callback(name, kind, read_parameters(reader), path.name, comment))
            else:
                interface.aliases[reader.word("the alias")] = kind
            reader.take(";")
        elif word == "enum":
            interface.groups.append(read_group(reader, comment))
        elif word == "MIEN_API":
            words = []
            while reader.peek() != "MIEN_CALL":
                words.append(reader.take())
            reader.take()
            name, where = reader.word("the function's name"), reader.where()
            function = Function(name, " ".join(words).replace(" *", "*"), read_parameters(reader), comment_raw,
                                path.name, where)
            reader.take(";")
            interface.functions.append(function)
            report = lambda what, at=where, name=name: problems.append(f"{at}: {name}: {what}")  # noqa: E731
            if comment_raw:
                read_function_comment(function, report)
            else:
                report("no documentation")
        else:
            reader.at -= 1
            reader.fail(f"'{word}' opens no declaration that the interface knows (typedef, enum, MIEN_API)")


def read_interface(include, strict=True):
    """The whole interface. strict: problems of comments raise HeaderError; else they are returned beside it."""
    from documentation import understand  # stands on this module

    interface, problems = Interface([], [], [], {}, [], {}), []
    for path in header_files(include):
        read_header(path, interface, problems)
    config = (Path(include) / "config.h").read_text()
    interface.abi_version = int(re.search(r"#define MIEN_ABI_VERSION (\d+)", config).group(1))
    interface.version = re.search(r'#define MIEN_VERSION_STRING "([^"]+)"', config).group(1)
    problems += understand(interface)
    if strict and problems:
        raise HeaderError("\n".join(problems))
    return interface if strict else (interface, problems)

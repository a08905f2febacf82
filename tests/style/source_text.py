"""Enough of C++'s grammar to measure functions and follow includes in the project's own formatted sources."""
import re

_NOT_CODE = re.compile(r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*""",
                       re.S | re.M)
_SCOPE = re.compile(r"\b(namespace|class|struct|union|enum)\b|\bextern\s*$")


def blank(text):
    """The text with comments, literals and preprocessor lines as spaces; every line keeps its number."""
    def spaces(match):
        found = match.group(0)
        if re.fullmatch(r"'\d*", found):
            return found
        return re.sub(r"[^\n]", " ", found)
    # A digit separator is no quotation mark.
    return _NOT_CODE.sub(spaces, re.sub(r"(?<=\d)'(?=\d)", " ", text))


def functions(text):
    """(name, first line, number of lines) of every function that has a body, lambdas within their function."""
    code = blank(text)
    found, stack, begin, i = [], [], 0, 0
    while i < len(code):
        char = code[i]
        inside_function = any(kind == "function" for kind, _ in stack)
        if char in ";" and not inside_function and _depth(code[begin:i]) == 0:
            begin = i + 1
        elif char == "{":
            head = code[begin:i]
            if inside_function:
                stack.append(("block", None))
            elif _is_function(head):
                stack.append(("function", begin + len(head) - len(head.lstrip())))
            else:
                kind = "scope" if _SCOPE.search(head) and "(" not in _SCOPE.split(head)[-1] else "block"
                stack.append((kind, begin))
                if kind == "scope":
                    begin = i + 1
        elif char == "}" and stack:
            kind, start = stack.pop()
            if kind == "function":
                follows = code[i + 1:].lstrip()[:1]
                if follows in (",", "{"):  # a member's initialiser in braces
                    i += 1
                    continue
                first, last = code.count("\n", 0, start) + 1, code.count("\n", 0, i) + 1
                found.append((_name(code[start:i]), first, last - first + 1))
                begin = i + 1
            elif kind == "scope" and not inside_function:
                begin = i + 1
        i += 1
    return found


def _depth(head):
    return head.count("(") - head.count(")")


def _is_function(head):
    plain = re.sub(r"\([^()]*\)", "()", head)
    while plain != (plain := re.sub(r"\(\(\)\)|\([^()]*\(\)[^()]*\)", "()", plain)):
        pass
    return "()" in plain and _depth(head) == 0 and not re.search(r"(?<![=!<>])=(?!=)(?![^<]*>)", plain.split("()")[0]) \
        and not re.search(r"\boperator\b", plain.split("()")[0][:0])


def _name(text):
    head = text.split("(")[0].split()
    return head[-1].lstrip("*&") if head else "?"

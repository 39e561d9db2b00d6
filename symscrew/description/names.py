"""Which names and texts a description may use: they end up in generated C, file names and comments."""

from __future__ import annotations

import keyword
import re

from symscrew.description.taken_names import taken_as_file
from symscrew.errors import DescriptionError, shorten

LONGEST = 64  # letters of a name: linkers and editors take it, and files of that name, too
_NAME = re.compile(rf"[A-Za-z][A-Za-z0-9_]{{0,{LONGEST - 1}}}", re.ASCII)

C_AND_CPP = (
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return",
    "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void",
    "volatile", "while", "alignas", "alignof", "and", "and_eq", "asm", "bitand", "bitor", "bool",
    "catch", "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "consteval", "constexpr",
    "constinit", "const_cast", "co_await", "co_return", "co_yield", "decltype", "delete",
    "dynamic_cast", "explicit", "export", "false", "friend", "mutable", "namespace", "new", "noexcept",
    "not", "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public",
    "reinterpret_cast", "requires", "static_assert", "static_cast", "template", "this", "thread_local",
    "throw", "true", "try", "typeid", "typename", "typeof", "using", "virtual", "wchar_t", "xor",
    "xor_eq", "main", "NULL",
)  # fmt: skip
RESERVED = frozenset(C_AND_CPP) | frozenset(keyword.kwlist)


def check_name(name: object, where: str) -> str:
    """`name`, if it can be an identifier of C, C++ and Python; raises DescriptionError otherwise."""
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise DescriptionError(
            f"{where}: {shorten(name)} is not a valid name; expected a letter followed by at most 63 "
            "letters, digits and underscores"
        )
    if name in RESERVED:
        raise DescriptionError(f"{where}: {name!r} is a keyword of C, C++ or Python; use another name")
    return name


def longer_name(name: str, ending: str) -> str:
    """A mechanism's name with an ending, of a model made from it; raises DescriptionError where that is too long."""
    if not _NAME.fullmatch(name + ending):
        most = LONGEST - len(ending)
        raise DescriptionError(
            f"mechanism: expected a name of at most {most} letters, digits and underscores, as functions get its name "
            f"with {ending}, got {len(name)}: {shorten(name)}; rename it"
        )
    return name + ending


def check_mechanism_name(name: object, where: str) -> str:
    """`name`, if it can be an identifier and the name of C files; raises DescriptionError otherwise."""
    checked = check_name(name, where)
    taken = taken_as_file(checked)
    if taken is not None:
        raise DescriptionError(
            f"{where}: {name!r} would give {name}.h and {name}.c, which would be mistaken for {taken}; use another name"
        )
    return checked


def markdown_text(text: str) -> str:
    """Somebody's `text` in one line of Markdown, as it stands: no markup, link, table cell or HTML comes of it.

    >>> print(markdown_text("a_b <img src=x> [here](http://x) 2*3|4"))
    a_b \\<img src=x\\> \\[here\\](http\\://x) 2\\*3\\|4
    """
    line = re.sub(r"\s+", " ", text)
    line = re.sub(r"[\\`*<>\[\]|~$&]|(?<![A-Za-z0-9])_|_(?![A-Za-z0-9])|:(?=//)|(?<=www)\.|@", r"\\\g<0>", line)
    return re.sub(r"^(?:[-+#=]|\d+(?=[.)](?: |$)))", lambda m: m[0] + "\\" if m[0].isdigit() else "\\" + m[0], line)


def check_text(text: object, where: str, *, limit: int = 4000) -> str:
    """`text`, if it can stand in a comment of generated code; raises DescriptionError otherwise."""
    if not isinstance(text, str):
        raise DescriptionError(f"{where}: expected text, got {shorten(text)}")
    if len(text) > limit:
        raise DescriptionError(f"{where}: expected at most {limit} characters, got {len(text)}")
    bad = re.search(r"[\x00-\x08\x0b-\x1f\x7f\u2028\u2029\\]|\*/|/\*|\?\?", text)
    if bad is not None:
        raise DescriptionError(
            f"{where}: {shorten(bad.group())} must not be in it; control characters, backslashes and the "
            "marks of C comments are refused"
        )
    return text

"""Comments of a description that is written anew: they stay with the sections and keys that they stood at.

    old text --statements--> comments above, inside and beside --same section or key--> new text with all of them

What has no such place any more (a key that is written in another way) stands above the section that took its place, or
at the end: no comment is lost.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from decimal import Decimal

_PART = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*"{3,5}' + r"|'''(?:[^']|'(?!''))*'{3,5}"
    r'|"(?:[^"\\\n]|\\.)*"' + r"|'[^'\n]*'" + r"|#[^\n]*|[\[\]{}\n]|[^\"'#\[\]{}\n]+|.",
    re.DOTALL,
)
Path = tuple[str, ...]


@dataclass
class _Statement:
    """A header or a key with its value: where it is in the file, its text, and the comments that belong to it."""

    path: Path = ()
    text: str = ""
    header: bool = False
    above: list[str] = field(default_factory=list)
    inside: list[str] = field(default_factory=list)
    beside: list[str] = field(default_factory=list)


def with_comments(new: str, old: str) -> str:
    """`new` with all comments of `old`, and its values as they are.

    >>> print(with_comments('[a]\\nx = 2', '# about a\\n[a]  # here\\nx = 1  # and x'))
    # about a
    [a]  # here
    x = 2  # and x
    """
    *given, rest = _statements(old)
    *made, last = _statements(new)
    for one in [*given, rest]:
        target = (_place(one.path, made) if one.path else None) or last
        exact = target.path == one.path and not target.beside
        if one.inside and exact and target.header == one.header and _value(one.text) == _value(target.text):
            target.text, one.inside = one.text, []  # the comments with it, each in its line
        if any(one.above):  # more than blank lines
            target.above += one.above
        target.above += one.inside
        (target.beside if exact and target.text else target.above).extend(one.beside)
    lines = [line for one in (*made, last) for line in (*one.above, "  ".join([one.text, *one.beside]))]
    once = [line for line, before in zip(lines, ["", *lines], strict=False) if line or before]
    text = "\n".join(once).rstrip("\n") + "\n" * new.endswith("\n")
    try:
        same = tomllib.loads(text) == tomllib.loads(new)
    except tomllib.TOMLDecodeError:
        same = False
    return text if same else "\n".join([*_comments(old), new])


def _place(path: Path, among: Sequence[_Statement]) -> _Statement | None:
    """The statement of this path, else the first inside of it, else the section that it would be in."""
    for one in among:
        if one.path == path:
            return one
    for one in among:
        if one.path[: len(path)] == path:
            return one
    return _place(path[:-1], among) if len(path) > 1 else None


def _statements(text: str) -> list[_Statement]:
    """All statements in order; the last one is none, and holds what stands below them. Blank lines stand above."""
    made, section, current = list[_Statement](), Path(), _Statement()
    depth, commented = 0, False
    for match in _PART.finditer(text.replace("\r\n", "\n").removesuffix("\n") + "\n"):
        part = match[0]
        if part[0] == "#":
            commented = True
            if depth:
                current.inside.append(part.rstrip())
            else:
                (current.beside if current.text.strip() else current.above).append(part.rstrip())
                continue
        depth += (part in "[{") - (part in "]}")
        if part != "\n" or depth:
            current.text += part
            continue
        if current.text.strip():
            section = _finished(current, section)
            made.append(current)
            current = _Statement()
        elif not commented and (made or current.above):
            current.above.append("")
        if not current.text.strip():
            current.text = ""
        commented = False
    return [*made, current]


def _finished(statement: _Statement, section: Path) -> Path:
    """The statement with its path, and the section that it is in or begins."""
    statement.text = statement.text.strip()
    statement.header = statement.text.startswith("[")
    if statement.header:
        statement.path = _key(statement.text.strip("[] \t"))
        return statement.path
    statement.path = section + _key(statement.text.partition("=")[0])
    return section


def _key(text: str) -> Path:
    """The parts of a dotted key; the text itself where it is none, as no file that was read has."""
    try:
        return tuple(_parts(tomllib.loads(f"{text} = 0")))
    except tomllib.TOMLDecodeError:
        return (text,)


def _parts(table: object) -> Iterator[str]:
    while isinstance(table, dict):
        ((name, table),) = table.items()
        yield name


def _value(text: str) -> object:
    """What a statement says, numbers with all digits."""
    return tomllib.loads(text, parse_float=Decimal)


def _comments(text: str) -> list[str]:
    return [match[0].rstrip() for match in _PART.finditer(text) if match[0][0] == "#"]

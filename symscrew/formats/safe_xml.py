"""XML files read safely and written tidily; attributes as exact numbers.

    Path --read--> Element --attribute, numbers--> exact decimals;   Element --text_of--> file

Entities, document types and processing of other files are refused, so a short file cannot grow in memory or
reach outside itself. Numbers keep all their decimals.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal
from pathlib import Path
from xml.etree import ElementTree

import defusedxml
import defusedxml.ElementTree

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.loose_xml import within_the_rules
from symscrew.whole_files import only_file

# A file beyond these is refused before anything is made of it; the largest models that people publish have a few
# thousand elements, nested to about thirty. Nesting also limits the readers' recursion, Python's being 1000 calls.
MAX_BYTES = 20_000_000
MAX_DEPTH = 300
MAX_ELEMENTS = 100_000

_NUMBER = re.compile(r"[+-]?(\d{1,400}\.?\d{0,400}|\.\d{1,400})([eE][+-]?\d{1,3})?", re.ASCII)
Element = ElementTree.Element


def read(path: Path) -> Element:
    """The root element of an XML file.

    Raises:
        DescriptionError: the file cannot be read, is not XML, is too large or too deep, or has a document type.
    """
    try:
        if only_file(path).stat().st_size > MAX_BYTES:
            raise DescriptionError(
                f"{path.name}: the file has {path.stat().st_size} bytes; at most {MAX_BYTES} are read"
            )
        content = path.read_bytes()
    except OSError as error:
        raise DescriptionError(f"{path.name}: the file cannot be read: {error.strerror}") from error
    try:
        root = _parsed(content)
    except defusedxml.DefusedXmlException as error:
        raise DescriptionError(
            f"{path.name}: document types and entities are refused ({type(error).__name__}); remove the DOCTYPE"
        ) from error
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise DescriptionError(f"{path.name}: not a valid XML file: {shorten(str(error), 200)}") from error
    _check_size(root, path.name)
    _drop_namespace(root)
    return root


def _parsed(content: bytes) -> Element:
    """The root element; of text that XML refuses and others read, as these read it."""
    try:
        found: Element = defusedxml.ElementTree.fromstring(content, forbid_dtd=True)
    except (ElementTree.ParseError, ValueError, LookupError):
        mended = within_the_rules(content)
        if mended is None:
            raise
        try:
            found = defusedxml.ElementTree.fromstring(mended, forbid_dtd=True)
        except (ElementTree.ParseError, ValueError):
            mended = None
        if mended is None:
            raise
    return found


def _drop_namespace(root: Element) -> None:
    """Take the root's own namespace off all elements that share it: it is the usual one there."""
    space = root.tag.rpartition("}")[0]
    if space:
        for element in root.iter():
            if isinstance(element.tag, str) and element.tag.startswith(f"{space}}}"):
                element.tag = element.tag[len(space) + 1 :]


def _check_size(root: Element, file: str) -> None:
    level, depth, count = [root], 0, 0
    while level:
        depth, count = depth + 1, count + len(level)
        if depth > MAX_DEPTH or count > MAX_ELEMENTS:
            raise DescriptionError(
                f"{file}: expected at most {MAX_ELEMENTS} elements nested at most {MAX_DEPTH} deep, got more"
            )
        level = [child for element in level for child in element if isinstance(child.tag, str)]


def elements(parent: Element, *tags: str) -> Iterator[Element]:
    """The children of an element, of all tags or the given ones; comments are passed over."""
    for child in parent:
        if isinstance(child.tag, str) and (not tags or child.tag in tags):
            yield child


def first(parent: Element, tag: str) -> list[Element]:
    """The first child with a tag, which is the one that counts where there are several; empty where there is none."""
    return list(elements(parent, tag))[:1]


def label(element: Element) -> str:
    """How an element is called in an error: its tag and its name, if it has one."""
    name = element.get("name")
    return f"<{element.tag}>" if name is None else f"<{element.tag} name={shorten(name)}>"


def check_attributes(element: Element, known: Sequence[str], where: str | None = None) -> None:
    """Refuses attributes that are not known: an unread one could change the mechanics."""
    for key in element.keys():  # noqa: SIM118
        if key not in known:
            raise DescriptionError(
                f"{where or label(element)}: the attribute {shorten(key)} is not supported; {did_you_mean(key, known)}"
            )


def attribute(element: Element, key: str) -> str:
    """A required attribute."""
    value = element.get(key)
    if value is None:
        raise DescriptionError(f"{label(element)}: the attribute {key!r} is missing")
    return value


def numbers(text: str, where: str, count: int | None = None) -> list[Decimal]:
    """The decimals in a text, separated by blanks; refuses another number of them than `count`."""
    parts = text.split()
    for part in parts:
        if not _NUMBER.fullmatch(part):
            cure = "; expand the file with xacro first" if "$" in part else ""
            raise DescriptionError(f"{where}: expected decimal numbers, got {shorten(part)}{cure}")
    if count is not None and len(parts) != count:
        raise DescriptionError(f"{where}: expected {count} number{'s' * (count != 1)}, got {len(parts)}")
    return [Decimal(part) for part in parts]


def number(text: str, where: str) -> Decimal:
    """The one decimal in a text."""
    return numbers(text, where, 1)[0]


def text_of(root: Element, comment: Sequence[str]) -> str:
    """An element as a file: declaration, a comment line by line, indented elements, a newline at the end."""
    ElementTree.indent(root)
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!--", *(_comment(line) for line in comment), "-->"]
    return "\n".join([*lines, ElementTree.tostring(root, encoding="unicode"), ""])


def _comment(line: str) -> str:
    """A line that cannot end the comment it stands in."""
    while "--" in line:
        line = line.replace("--", "- -")
    return line.removesuffix("-")


def decimals(values: Iterable[float]) -> str:
    """Numbers as text that reads back to the same doubles; whole ones without a point.

    >>> decimals([0.0, -1.0, 0.1])
    '0 -1 0.1'
    """
    return " ".join(repr(int(v)) if float(v).is_integer() and abs(v) < 1e15 else repr(float(v)) for v in values)

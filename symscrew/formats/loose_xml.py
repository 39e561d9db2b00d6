"""Files that XML's own rules refuse and that ROS and MuJoCo read: the same text within the rules.

    two dashes in a comment, bytes of another encoding there     comments are left out
    <geom name="a"type="box">                                    attributes without a space between them
    name="a & b < c"                                             signs that mean themselves in a value
    blank lines before <?xml ...?>                               the declaration is left out
    <sensor:camera> without xmlns:sensor                         the prefix is declared

What each means nobody reads in two ways, so nothing here is a guess; everything else stays an error.
"""

from __future__ import annotations

import re

_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_DECLARATION = re.compile(r"<\?.*?\?>", re.DOTALL)
_TAG = re.compile(r"""<([A-Za-z_][\w:.-]*)((?:[^<>"']|"[^"]*"|'[^']*')*)>""")
_ATTRIBUTE = re.compile(r"""\s*([A-Za-z_][\w:.-]*)\s*=\s*("[^"]*"|'[^']*')""")
_SIGN = re.compile(r"&(?!(?:amp|lt|gt|quot|apos|#\d{1,7}|#x[0-9a-fA-F]{1,6});)")
KNOWN_SPACES = {"drake": "http://drake.mit.edu"}
"""Prefixes that mean something to the readers -> their namespaces; others stand for themselves."""


def within_the_rules(content: bytes) -> bytes | None:
    """The file's text as XML has it; None where it is not one of the kinds above."""
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    if "<![CDATA[" in text or "<!DOCTYPE" in text:
        return None
    text = _DECLARATION.sub("", _COMMENT.sub(_lines, text)).lstrip("\ufeff \t\r\n")
    made: list[str] = []
    end = 0
    for tag in _TAG.finditer(text):
        inside = _attributes(tag.group(2))
        if inside is None:
            return None
        made += [text[end : tag.start()], f"<{tag.group(1)}", inside]
        end = tag.end()
    if len(made) < 3 or made[0].strip():
        return None
    made.append(text[end:])
    whole = "".join(made)
    prefixes = {name.partition(":")[0] for name in re.findall(r"[<\s]([A-Za-z_][\w.-]*:[\w.-]+)[\s=/>]", whole)}
    for prefix in sorted(prefixes - {"xml", "xmlns"} - set(re.findall(r"xmlns:([\w.-]+)\s*=", whole))):
        made[1] += f' xmlns:{prefix}="{KNOWN_SPACES.get(prefix, prefix)}"'
    return "".join(made).encode("utf-8")


def _lines(comment: re.Match[str]) -> str:
    """As many line ends as a comment has: errors further down name the line that the file has."""
    return "\n" * comment.group().count("\n")


def _attributes(text: str) -> str | None:
    """What follows a tag's name, with a space before every attribute, up to its end; None if it is something else."""
    made, end = "", 0
    while found := _ATTRIBUTE.match(text, end):
        value = _SIGN.sub("&amp;", found.group(2)).replace("<", "&lt;")
        made += f"{' ' if not found.group().count(chr(10)) else chr(10)}{found.group(1)}={value}"
        end = found.end()
    rest = text[end:].strip()
    return f"{made}{rest}>" if rest in ("", "/") else None

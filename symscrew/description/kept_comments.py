"""Comments of a description that is written anew: they stay with the sections and keys that they stood at.

old text --above a section, at its head, beside a key--> comments --the same section and key--> new text with them
"""

from __future__ import annotations

import re
import tomllib

_HEADER = re.compile(r"\s*(\[\[?[^\]#]+\]\]?)\s*(#.*)?")


def with_comments(new: str, old: str) -> str:
    """`new` with the comments of `old`, and its values as they are; `new` itself where that cannot be done.

    >>> print(with_comments('[a]\\nx = 2', '# about a\\n[a]  # here\\nx = 1  # and x'))
    # about a
    [a]  # here
    x = 2  # and x
    """
    above, beside, pending, section = dict[str, list[str]](), dict[tuple[str, str], str](), list[str](), ""
    for line in old.splitlines():
        header, (key, said) = _HEADER.fullmatch(line), _key(line)
        if line.lstrip().startswith("#"):
            pending.append(line.strip())
        elif header:
            section = header[1]
            above.setdefault(section, pending)
            if header[2]:
                beside.setdefault((section, ""), header[2])
            pending = []
        elif key and said:
            beside.setdefault((section, key), said)
            pending = []
        elif line.strip():
            pending = []
    lines, section = [], ""
    for line in new.splitlines():
        header = _HEADER.fullmatch(line)
        name = "" if header else line.partition("=")[0].strip()
        if header:
            section = header[1]
            lines += [text for text in above.pop(section, []) if text not in lines]
        said = beside.pop((section, name), "") if (header or "=" in line) and "#" not in line else ""
        lines.append(f"{line}  {said}" if said else line)
    made = "\n".join(lines) + "\n" * new.endswith("\n")
    try:
        return made if tomllib.loads(made) == tomllib.loads(new) else new
    except tomllib.TOMLDecodeError:
        return new


def _key(line: str) -> tuple[str, str]:
    """The key of a line and the comment behind its value; empty where there is none."""
    quote = ""
    for k, letter in enumerate(line):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        elif letter == "#":
            return line.partition("=")[0].strip(), line[k:].strip()
    return line.partition("=")[0].strip(), ""

"""Names and texts of a file as a description may hold them.

"hip-1" --safe_names--> "hip_1"
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from symscrew.description import RESERVED, taken_as_file

LONGEST = 60
"""Letters of a name, as in descriptions; a longer one is cut off."""
NUMBERED = 55
"""Letters that are kept of a name that gets a number, to make it differ from another."""


def safe_names(names: Iterable[str]) -> dict[str, str]:
    """A file's names -> ours: letters, digits and underscores, all different, no keywords.

    >>> safe_names(["hip-1", "hip_1", "2nd", "for"])
    {'hip-1': 'hip_1_2', 'hip_1': 'hip_1', '2nd': 'n2nd', 'for': 'for_'}
    """
    wanted = {name: _identifier(name) for name in names}
    taken = {name for name, new in wanted.items() if name == new}
    result = {}
    for name, new in wanted.items():
        chosen, count = new, 2
        while name != new and chosen in taken:
            chosen, count = f"{new[:NUMBERED]}_{count}", count + 1
        taken.add(chosen)
        result[name] = chosen
    return result


def _identifier(name: str) -> str:
    text = re.sub(r"[^A-Za-z0-9_]", "_", name)[:LONGEST]
    text = text if re.match(r"[A-Za-z]", text) else f"n{text}"
    return f"{text}_" if text in RESERVED else text


def mechanism_name(name: str) -> str:
    """A file's name of the whole as the name of a mechanism, which becomes one of files and functions."""
    new = _identifier(name)
    return f"{new}_" if taken_as_file(new) else new


def printable(text: str) -> str:
    """A file's text as a description may hold it."""
    return re.sub(r"[\x00-\x1f\x7f\u2028\u2029\\]|\*/|/\*|\?\?", " ", text)


def fresh(name: str, used: Iterable[str]) -> str:
    """`name`, or with the first number that makes it differ from all used ones."""
    known = set(used)
    chosen, count = name, 2
    while chosen in known:
        chosen, count = f"{name}_{count}", count + 1
    return chosen

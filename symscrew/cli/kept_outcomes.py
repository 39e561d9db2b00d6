"""What a command made before of the same input, by the same version: what it prints, and its files.

    input --canonical--> text --key--> user's cache: facts, files, or nothing: then it is made

The text holds all that the outcome depends on; where something of the input has no text, nothing is kept. What is kept
is read as JSON, and nothing in it is run.
"""

from __future__ import annotations

import base64
import binascii
import json
import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, field, fields, is_dataclass
from typing import Any

from symscrew.description import Mechanism, to_toml
from symscrew.effects import Effect, effect_to_table
from symscrew.errors import DescriptionError

LIBRARIES = ("casadi", "mpmath", "numpy", "scipy", "sympy")  # whose versions an outcome may depend on


@dataclass(frozen=True)
class Outcome:
    """What is printed, as JSON holds it, and files by name.

    `good`: it may be kept. `earlier`: it was made in an earlier run.
    """

    facts: Mapping[str, Any]
    files: Mapping[str, bytes] = field(default_factory=dict)
    good: bool = True
    earlier: bool = False


def once(command: str, given: Sequence[object], make: Callable[[], Outcome]) -> Outcome:
    """The outcome of a command for what was `given`: from an earlier run, or made now and kept if it is good."""
    from symscrew.runtime import entry, key_of, version

    try:
        text = json.dumps([command, *map(canonical, given), _installed()])
        key: str | None = key_of(b"outcome", version().encode(), text.encode("utf-8", "surrogateescape"))
    except (DescriptionError, TypeError):
        key = None
    with entry(key) as kept:  # not held while it is made: making may ask for entries of its own
        found = _read(kept.read())
    if found is not None:
        return found
    made = make()
    if made.good:
        files = {name: base64.b64encode(data).decode("ascii") for name, data in made.files.items()}
        with entry(key) as kept:
            kept.write(json.dumps({"facts": made.facts, "files": files}).encode("ascii"))
    return made


def canonical(value: object) -> Any:
    """A value as JSON holds it, with all that it says; raises TypeError where nothing writes it."""
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, Mechanism):
        return ["mechanism", to_toml(value), list(value.warnings)]
    if isinstance(value, Effect):
        return [f"{type(value).__module__}.{type(value).__qualname__}", canonical(effect_to_table(value))]
    if is_dataclass(value):
        return [type(value).__qualname__, {f.name: canonical(getattr(value, f.name)) for f in fields(value)}]
    if isinstance(value, Mapping):
        return [[canonical(name), canonical(entry)] for name, entry in value.items()]
    if isinstance(value, Sequence):
        return [canonical(entry) for entry in value]
    if isinstance(value, Set):
        return sorted(map(str, value))
    raise TypeError(f"nothing writes a {type(value).__qualname__}")


def _installed() -> list[list[str]]:
    """The libraries that are found first where this Python looks, and their versions.

    By the names of folders that installers make, as `importlib.metadata` has them, whose import takes as long as
    reading a simple description.
    """
    name = re.compile(rf"({'|'.join(LIBRARIES)})-(.+)\.(?:dist|egg)-info")
    found: dict[str, str] = {}
    for place in sys.path:
        with suppress(OSError), os.scandir(place or ".") as entries:
            for match in filter(None, (name.fullmatch(entry.name) for entry in entries)):
                found.setdefault(match[1], match[2])
    return sorted(map(list, found.items()))


def _read(kept: bytes | None) -> Outcome | None:
    try:
        found = json.loads(kept) if kept is not None else None
        files = {name: base64.b64decode(text, validate=True) for name, text in found["files"].items()} if found else {}
        return Outcome(found["facts"], files, earlier=True) if found else None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, binascii.Error):
        return None

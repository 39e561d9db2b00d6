"""What a command made before of the same input, by the same version: what it prints, and its files.

    input --canonical--> text --key--> user's cache: facts, files, or nothing: then it is made

The text holds all that the outcome depends on; where something of the input has no text, nothing is kept. What is kept
is read as JSON, and nothing in it is run.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import fields, is_dataclass
from typing import Any

from symscrew.cli.same_files import LIBRARIES, Outcome, keep_outcome, kept_outcome
from symscrew.description import Mechanism, to_toml
from symscrew.effects import Effect, effect_to_table
from symscrew.errors import DescriptionError


def once(command: str, given: Sequence[object], make: Callable[[], Outcome]) -> Outcome:
    """The outcome of a command for what was `given`: from an earlier run, or made now and kept if it is good."""
    from symscrew.runtime import installed, key_of, version

    try:
        text = json.dumps([command, *map(canonical, given), *map(installed, LIBRARIES)])
        key: str | None = key_of(b"outcome", version().encode(), text.encode("utf-8", "surrogateescape"))
    except (DescriptionError, TypeError):
        key = None
    found = kept_outcome(key)
    if found is not None:
        return found
    made = make()
    if made.good:
        keep_outcome(key, made)
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

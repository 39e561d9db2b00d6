"""Which effects there are, and effects as tables: from a scene file or a manifest, and back.

[[effects]]
type = "viscous_friction"
joint = "A"
coefficient = 0.2
"""

from __future__ import annotations

import dataclasses
import math
import pkgutil
from collections.abc import Iterable, Mapping
from decimal import Decimal
from difflib import get_close_matches
from fractions import Fraction
from functools import cache
from importlib import import_module
from pathlib import Path
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

from symscrew.description import Mechanism, read_tables, read_text
from symscrew.effects.effect import Effect, system_under
from symscrew.errors import DescriptionError, did_you_mean, shorten

NEAR = 0.85  # 'effect' has 0.92: of a scene's other sections, none has 0.4
HELPERS = (
    "acting",
    "ball_turns",
    "contact_law",
    "cord_path",
    "cord_wraps",
    "effect",
    "of_files",
    "parts",
    "records",
    "registry",
)  # files of this folder that hold no effect


@cache
def effect_types() -> dict[str, str]:
    """Type name (the name of the file) to the name of its class, in alphabetical order; no file is read for it."""
    names = sorted(m.name for m in pkgutil.iter_modules([str(Path(__file__).parent)]) if m.name not in HELPERS)
    return {name: class_name(name) for name in names}


@cache
def known_effects() -> dict[str, type[Effect]]:
    """Type name to class, in alphabetical order."""
    return {name: effect_class(name) for name in effect_types()}


def effect_class(kind: str) -> type[Effect]:
    """The class of one type, whose file alone is read."""
    found: type[Effect] = getattr(import_module(f"symscrew.effects.{kind}"), class_name(kind))
    return found


def simplifications() -> dict[str, Effect]:
    """In words ("massless limbs"), the simplifications that need no further keys, in alphabetical order of types."""
    known = [kind for kind in known_effects().values() if kind.simplifies]
    return {kind.simplifies: kind() for kind in known if not _required(kind)}


def _required(kind: type[Effect]) -> list[str]:
    """Keys that a table of this type must have."""
    return [f.name for f in dataclasses.fields(kind) if f.default is dataclasses.MISSING]


def class_name(kind: str) -> str:
    """`some_effect` to `SomeEffect`."""
    return "".join(part.capitalize() for part in kind.split("_"))


def type_name(effect: Effect) -> str:
    """The type by which a table calls an effect."""
    return type(effect).__module__.rpartition(".")[2]


def effect_from_table(table: Any, where: str = "effects") -> Effect:
    """The effect that a table describes: `type` and the fields of the effect's class.

    Numbers may be texts with expressions, as everywhere in a description; lists become tuples.

    Raises:
        DescriptionError: no table, an unknown type or key, a missing key, or a value of the wrong kind.
    """
    if not isinstance(table, Mapping):
        raise DescriptionError(f"{where}: expected a table with the key 'type', got {shorten(table)}")
    known = known_effects()
    kind = table.get("type")
    if not isinstance(kind, str):
        raise DescriptionError(
            f"{where}: expected the key 'type' with the name of an effect ({', '.join(known)}), got {shorten(kind)}"
        )
    names = {**known, **{made.__name__: made for made in known.values()}}
    if kind not in names:
        raise DescriptionError(f"{where}: unknown effect {shorten(kind)}; {did_you_mean(kind, known)}")
    made = names[kind]
    fields = {f.name: f for f in dataclasses.fields(made)}
    kinds = get_type_hints(made)  # not the fields' own annotations: these are texts in some files and types in others
    values = {}
    for key, value in table.items():
        if key == "type":
            continue
        if key not in fields:
            known_keys, near = ", ".join(fields) or "none", did_you_mean(str(key), fields)
            told = f"{near} (its keys: {known_keys})" if near.startswith("did you mean") else f"its keys: {known_keys}"
            raise DescriptionError(f"{where}: unknown key {shorten(key)} of the effect {kind}; {told}")
        values[key] = _checked(value, kinds[key], f"{where}.{key}")
    missing = [name for name in _required(made) if name not in values]
    if missing:
        raise DescriptionError(f"{where}: the effect {kind} needs the key {missing[0]!r}")
    return made(**values)


def _checked(value: Any, annotation: Any, where: str) -> Any:
    """A value of a table, of the kind that the field's annotation asks for."""
    kinds = _kinds(annotation)
    if isinstance(value, bool):
        expected, good = "text or numbers", bool in kinds
    elif isinstance(value, str):
        expected, good = "true or false" if kinds == {bool} else "a list or a number", str in kinds
    elif isinstance(value, int | float | Decimal | Fraction):
        integer = int in kinds and float not in kinds
        expected = "an index" if integer else ("true or false" if kinds == {bool} else "text or a list")
        good = isinstance(value, int) if integer else float in kinds
    elif isinstance(value, list | tuple):
        expected, good = "a single value", tuple in kinds
        value = tuple(_frozen(v, where) for v in value)
    else:
        expected, good = "text, a number, true or false, or a list", False
    if not good:
        raise DescriptionError(f"{where}: expected {expected}, got {shorten(value)}")
    return _finite(value, where)


def _kinds(annotation: Any) -> set[type]:
    """The types of a union, or the one type; `tuple` for any tuple."""
    parts = get_args(annotation) if get_origin(annotation) in (Union, UnionType) else (annotation,)
    return {get_origin(part) or part for part in parts}


def _finite(value: Any, where: str) -> Any:
    if isinstance(value, float | Decimal) and not math.isfinite(value):
        raise DescriptionError(f"{where}: expected a finite number, got {value}")
    return value


def _frozen(value: Any, where: str) -> Any:
    if isinstance(value, list | tuple):
        return tuple(_frozen(v, where) for v in value)
    if isinstance(value, bool) or not isinstance(value, str | int | float | Decimal | Fraction):
        raise DescriptionError(f"{where}: expected a list of numbers or texts, got {shorten(value)} in it")
    return _finite(value, where)


def load_effects(path: str | Path) -> tuple[Effect, ...]:
    """The effects of a TOML file with tables [[effects]], a scene for instance; the rest of the file is not looked at.

    Raises:
        DescriptionError: the file cannot be read, has no effects, or one of them cannot be read.
    """
    file = Path(path)
    try:
        return effects_of_text(read_text(file))
    except DescriptionError as error:
        raise DescriptionError(f"{file.name}: {error}") from error


def effects_of_text(text: str) -> tuple[Effect, ...]:
    """As `load_effects`, of what stands in the file."""
    whole = read_tables(text)
    tables = whole.get("effects")
    misspelt = get_close_matches("effects", [key for key in whole if key != "effects"], n=1, cutoff=NEAR)
    if misspelt:
        raise DescriptionError(f"expected tables [[effects]] in the file, found {shorten(misspelt[0])}, too")
    if not isinstance(tables, list):
        raise DescriptionError("expected tables [[effects]] in the file, found none")
    return tuple(effect_from_table(table, f"effects[{k}]") for k, table in enumerate(tables))


def effect_to_table(effect: Effect) -> dict[str, Any]:
    """The table of an effect: its type, and the fields that are required or differ from their defaults."""
    return {"type": type_name(effect), **{k: _plain(v) for k, v in effect.shown_fields().items()}}


def _plain(value: Any) -> Any:
    """Lists for tuples."""
    return [_plain(v) for v in value] if isinstance(value, tuple) else value


def check_effects(mechanism: Mechanism, effects: Iterable[Effect]) -> None:
    """Refuse effects that do not fit the mechanism, by letting them act on it once.

    Raises:
        DescriptionError: names the effect, what was expected, what came, and the cure.
    """
    from symscrew.effects.acting import Acting

    every = tuple(effects)
    Acting(system_under(mechanism, every), every)

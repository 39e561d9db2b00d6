"""Effects: what acts on a mechanism beyond its own inertia. One file per effect; nothing when not asked for.

A file `some_effect.py` of this package holds the class `SomeEffect`; a scene's table says `type = "some_effect"`.
Nothing is listed anywhere else: a file that is taken away is an effect that does not exist.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, given_effects, system_under, transformed
from symscrew.effects.of_files import effects_of_file, forces_of_effects, stops_of_file
from symscrew.effects.records import AddedInertia, Contact, Estimate, Passed, State
from symscrew.effects.registry import (
    check_effects,
    effect_class,
    effect_from_table,
    effect_to_table,
    effect_types,
    effects_of_text,
    known_effects,
    load_effects,
    simplifications,
    type_name,
)

if TYPE_CHECKING:
    from symscrew.effects.external_wrench import ExternalWrench
    from symscrew.effects.gravity import Gravity

__all__ = [
    "Acting",
    "AddedInertia",
    "Contact",
    "Effect",
    "Estimate",
    "ExternalWrench",
    "Gravity",
    "Passed",
    "State",
    "check_effects",
    "effect_class",
    "effect_from_table",
    "effect_to_table",
    "effect_types",
    "effects_of_file",
    "effects_of_text",
    "forces_of_effects",
    "given_effects",
    "known_effects",
    "load_effects",
    "simplifications",
    "stops_of_file",
    "system_under",
    "transformed",
    "type_name",
]


def __getattr__(name: str) -> Any:
    found = {made: kind for kind, made in effect_types().items()}
    if name in found:
        return effect_class(found[name])
    raise AttributeError(f"module 'symscrew.effects' has no attribute {name!r}; known: {', '.join(found)}")

"""The effects that a robot's file names in its own words: armature, damping, friction, spring, servo, reach.

{"kind": "armature", "joint": "knee", "inertia": 0.02} --effect_of_file--> RotorInertia("knee", 0.02)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from symscrew.description import Mechanism, Reader
from symscrew.effects.effect import Effect
from symscrew.effects.registry import effect_from_table, effect_to_table

TYPES: Mapping[str, str] = {
    "armature": "rotor_inertia",
    "damping": "viscous_friction",
    "friction": "dry_friction",
    "spring": "joint_spring",
    "servo": "position_servo",
    "load": "external_wrench",
    "drag": "fluid_drag",
    "cord": "point_spring",
    "tendon": "cable",
    "muscle": "hill_muscle",
}
"""What a file calls a force -> the type of its effect."""
HELD: Mapping[str, frozenset[str]] = {
    "armature": frozenset({"joint", "freedom", "inertia", "ratio"}),
    "damping": frozenset({"joint", "freedom", "coefficient"}),
    "friction": frozenset({"joint", "freedom", "coulomb", "velocity"}),
    "spring": frozenset({"joint", "freedom", "stiffness", "rest", "damping", "nearest"}),
    "servo": frozenset({"joint", "freedom", "stiffness", "damping", "limit", "lowest", "name"}),
    "load": frozenset({"point", "wrench"}),
    "cord": frozenset({"start", "end", "through", "stiffness", "length", "shortest", "damping"}),
    "tendon": frozenset({"name", "path", "stiffness", "length", "shortest", "damping", "pulled"}),
    "muscle": frozenset({"name", "path", "strength", "lengths", "scaled", "lmin", "lmax", "vmax", "fpmax", "fvmax"}),
    "drag": frozenset({"body", "sides", "axes", "density", "viscosity", "wind"}),
}
"""What files say of each: an effect with other keys is more than a file holds."""
WORDS = ("joint", "point", "body", "freedom", "name", "start", "end", "through", "nearest", "path", "pulled")
"""What of an effect's table is no number."""
USUAL = (0, 0, "-9.81")
"""Gravity [m/s^2] of a file that does not say its own."""


def effects_of_file(forces: Iterable[Mapping[str, Any]], gravity: tuple[float, ...] | None = None) -> list[Effect]:
    """Gravity, by default 9.81 m/s^2 along -z, and an effect for every force that a file names."""
    first = {"type": "gravity", "acceleration": list(USUAL if gravity is None else gravity)}
    tables = [{**force, "type": TYPES[force["kind"]]} for force in forces]
    every = [first, *({k: v for k, v in table.items() if k != "kind"} for table in tables)]
    return [effect_from_table(table) for table in every]


def forces_of_effects(
    mechanism: Mechanism, effects: Iterable[Effect]
) -> tuple[tuple[Mapping[str, Any], ...], tuple[float, ...], tuple[str, ...]]:
    """(forces in a file's words, gravity [m/s^2], in words the effects that no file names).

    The inverse of `effects_of_file`: numbers are doubles at the parameters' values. Without gravity the field is zero.
    """
    kinds = {type_of: kind for kind, type_of in TYPES.items()}
    reader = Reader(dict(mechanism.parameters))
    forces: list[Mapping[str, Any]] = []
    others: list[str] = []
    field = (0.0, 0.0, 0.0)
    for effect in effects:
        table = effect_to_table(effect)
        name = table.pop("type")
        if name == "gravity" and not table.get("input"):
            x, y, z = (float(mechanism.number(reader.number(c, "gravity"))) for c in table["acceleration"])
            field = (x, y, z)
            continue
        kind = kinds.get(name)
        if kind is None or not set(table) <= HELD[kind] or (kind == "load" and table.get("axes") == "body"):
            others.append(f"{name} with {', '.join(table)}" if kind else name)
            continue
        plain = {k: v if k in WORDS else _number(mechanism, reader, v) for k, v in table.items()}
        forces.append({"kind": kind, **plain})
    return tuple(forces), field, tuple(others)


def _number(mechanism: Mechanism, reader: Reader, value: Any) -> Any:
    if isinstance(value, list | tuple):
        return [_number(mechanism, reader, part) for part in value]
    return float(mechanism.number(reader.number(value, "effects")))


def stops_of_file(reach: Mapping[str, tuple[float | None, float | None]]) -> list[Effect]:
    """Rigid stops where joints leave their reach: joint or `joint.k` -> (lower, upper) [rad or m], None for no stop."""
    tables = []
    for label, ends in reach.items():
        joint, _, freedom = label.partition(".")
        given = {key: value for key, value in zip(("lower", "upper"), ends, strict=True) if value is not None}
        if given:
            where = {"joint": joint, **({"freedom": int(freedom)} if freedom else {})}
            tables.append({"type": "end_stop", **where, "mode": "impact", **given})
    return [effect_from_table(table) for table in tables]

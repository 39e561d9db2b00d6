"""The effects that a robot's file names in its own words: armature, damping, friction, spring, servo, reach.

{"kind": "armature", "joint": "knee", "inertia": 0.02} --effect_of_file--> RotorInertia("knee", 0.02)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from symscrew.effects.effect import Effect
from symscrew.effects.registry import effect_from_table

TYPES: Mapping[str, str] = {
    "armature": "rotor_inertia",
    "damping": "viscous_friction",
    "friction": "dry_friction",
    "spring": "joint_spring",
    "servo": "position_servo",
    "load": "external_wrench",
}
"""What a file calls a force -> the type of its effect."""
USUAL = (0, 0, "-9.81")
"""Gravity [m/s^2] of a file that does not say its own."""


def effects_of_file(forces: Iterable[Mapping[str, Any]], gravity: tuple[float, ...] | None = None) -> list[Effect]:
    """Gravity, by default 9.81 m/s^2 along -z, and an effect for every force that a file names."""
    first = {"type": "gravity", "acceleration": list(USUAL if gravity is None else gravity)}
    tables = [{**force, "type": TYPES[force["kind"]]} for force in forces]
    every = [first, *({k: v for k, v in table.items() if k != "kind"} for table in tables)]
    return [effect_from_table(table) for table in every]


def stops_of_file(reach: Mapping[str, tuple[float | None, float | None]]) -> list[Effect]:
    """Rigid stops where joints leave their reach: joint -> (lower, upper) [rad or m], None for no stop."""
    tables = []
    for joint, ends in reach.items():
        given = {key: value for key, value in zip(("lower", "upper"), ends, strict=True) if value is not None}
        if given:
            tables.append({"type": "end_stop", "joint": joint, "mode": "impact", **given})
    return [effect_from_table(table) for table in tables]

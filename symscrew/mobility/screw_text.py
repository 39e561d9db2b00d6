"""Screws in words: a force along a line, a couple, a rotation about a line, with a point of the axis."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import CONTEXT, Vector, cross, dot, scale
from symscrew.mobility.screw_systems import ZERO_BELOW, Real


def describe_wrench(wrench: Sequence[Real]) -> str:
    """A wrench in words: a force along a line, a couple, or a wrench with pitch."""
    return f"{_words(wrench, 'force', 'couple', 'wrench')}: ({text(wrench[:3])}; {text(wrench[3:])})"


def describe_twist(twist: Sequence[Real]) -> str:
    """A twist in words: a rotation about a line, a translation, or a screw motion."""
    return f"{_words(twist, 'rotation', 'translation', 'screw motion')}: ({text(twist[:3])}; {text(twist[3:])})"


def describe_type(dimension: int, rotations: int, helical: int = 0) -> str:
    """The type of a system of freedoms, rotations first: `2R`, `3T`, `1R3T`, `1H`, `0`.

    `rotations` is the dimension of the angular-velocity projection; `helical` of these have a pitch other than zero.

    >>> describe_type(4, 1), describe_type(0, 0), describe_type(3, 2, 1)
    ('1R3T', '0', '1R1H1T')
    """
    counts = {"R": rotations - helical, "H": helical, "T": dimension - rotations}
    return "".join(f"{count}{letter}" for letter, count in counts.items() if count) or "0"


def axis_of(screw: Sequence[Real]) -> tuple[Vector, Vector, Real] | None:
    """(direction, point of the axis nearest to O, pitch) of a screw; None for a couple or translation."""
    direction, moment = (screw[0], screw[1], screw[2]), (screw[3], screw[4], screw[5])
    square = dot(direction, direction)
    if square < ZERO_BELOW * max(1, dot(moment, moment)):
        return None
    return direction, scale(1 / square, cross(direction, moment)), dot(direction, moment) / square


def _words(screw: Sequence[Real], line: str, free: str, general: str) -> str:
    found = axis_of(screw)
    if found is None:
        return f"{free} {'along' if free == 'translation' else 'about'} {_direction(screw[3:])}"
    direction, point, pitch = found
    size = max(CONTEXT.one, *(abs(c) for c in screw))
    place = "O" if all(abs(c) < ZERO_BELOW * size for c in point) else f"({text(point)})"
    where = f"{'parallel to' if line == 'force' else 'about'} {_direction(direction)} through {place}"
    if abs(pitch) < ZERO_BELOW * size:
        return f"{line} {where}"
    return f"{general} {where}, pitch {float(pitch):.6g} m"


def _direction(vector: Sequence[Real]) -> str:
    size = max(abs(c) for c in vector)
    large = [i for i, c in enumerate(vector) if abs(c) > ZERO_BELOW * size]
    return "xyz"[large[0]] if len(large) == 1 else f"({text(vector)})"


def text(vector: Sequence[Real]) -> str:
    """The components with six digits; what is rounding beside the largest is zero."""
    size = max((abs(c) for c in vector), default=0)
    return ", ".join(f"{float(c):.6g}" if abs(c) > ZERO_BELOW * size else "0" for c in vector)

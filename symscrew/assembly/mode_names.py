"""Names of modes: those of the reference, kept along straight ways of the drives on which no singularity lies.

    "home"          the mode that the reference leads to with its drives straight to the given values
    "+1", "-2" ...  sign of the determinant with the drives locked, number in the order of the turn from the reference

At the reference's drives modes are numbered by their poses; elsewhere a mode has the name of the one to which the way
back leads, and one that no way leads back from has a name with "n" (new): "+n1". A mechanism whose modes meet in cusps
has no names that are the same along all ways; then a name says which way it was found by.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations, Way
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.start_system import together

Array = np.ndarray[Any, Any]

EQUAL = 6
"""Digits to which poses are compared for the order: what tracking and Newton's method leave is below."""


@dataclass(frozen=True)
class Named:
    """What a mode's name depends on: its zero, pose, and sign of the determinant with the drives locked.

    `translation`: in sizes of the mechanism, so that names are the same in mm and km. `distances`: of marks, displaced,
    from marks that rest: the same wherever the whole mechanism stands and however it is turned.
    """

    z: Array
    rotation: Array
    translation: Array
    sign: str
    distances: tuple[float, ...] = ()


def distances_of(marks: Array, rotation: Array, translation: Array) -> tuple[float, ...]:
    """Of all marks (n, 3), displaced, from all of them, in their order."""
    moved = marks @ rotation.T + translation
    return tuple(np.linalg.norm(moved[:, None] - marks[None], axis=2).ravel().tolist())


def numbered(modes: Sequence[Named], home: int | None, new: str = "") -> list[str]:
    """Names in the order of their poses: sign and number."""
    order = sorted(range(len(modes)), key=lambda k: _place(modes[k]))
    count: dict[str, int] = {}
    names = [""] * len(modes)
    for k in order:
        if k == home:
            names[k] = "home"
            continue
        sign = modes[k].sign + new
        count[sign] = count.get(sign, 0) + 1
        names[k] = f"{sign}{count[sign]}"
    return names


def _place(mode: Named) -> tuple[float, ...]:
    """Turn and distances from the reference, then all entries: the order of modes at the same drives.

    First the distances by their size, then in the order of the joints: of modes that a symmetry of the mechanism takes
    to one another this alone, so that only their names depend on the order in which joints are listed.
    """
    turn = float(np.arccos(np.clip((np.trace(mode.rotation) - 1) / 2, -1, 1)))
    entries = [*mode.rotation.ravel(), *mode.translation]
    return tuple(round(float(c), EQUAL) + 0.0 for c in (turn, *sorted(mode.distances), *mode.distances, *entries))


def names_by_ways(
    way: Way, equations: BatchEquations, modes: Sequence[Named], reference: tuple[Sequence[Named], Sequence[str]]
) -> list[str]:
    """Names at other drives: `way` leads from there to the reference."""
    if not modes:
        return []
    ends = Tracker(equations).follow(np.array([m.z for m in modes]).astype(complex), way.at)
    known = (
        equations.scaled(np.array([m.z for m in reference[0]]).astype(complex)) if reference[0] else np.zeros((0, 1))
    )
    names = [""] * len(modes)
    for k, (z, reached) in enumerate(zip(ends.z, ends.reached, strict=True)):
        same = list(np.flatnonzero(together(equations, known, z))) if reached and len(known) else list[int]()
        if same:
            names[k] = reference[1][int(same[0])]
    left = [k for k, name in enumerate(names) if not name or names.count(name) > 1]
    for k, name in zip(left, numbered([modes[k] for k in left], None, "n"), strict=True):
        names[k] = name
    return names

"""Components over given coordinates: all poses there, counted modulo primes, and which of them are of one component.

    some joints' variables, or ratios of x, fixed at random, modulo primes --counted_poses--> how many, their factors
    real configurations moved to one such place --the place moves round loops--> poses, joined where of one component

A generic section in all variables has hundreds of points where one in the joints' variables alone has forty: of a delta
those of its platform on six rods. Every component over which the joints' variables vary freely has points there, and
loops of the place join those of an irreducible one. That none is missing is by the count: poses in characteristic p are
as many as in zero for all but finitely many primes and places. Each component over the field has a sum of the factors'
degrees, for every prime (`plane_sections`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.certified_points import refined
from symscrew.mobility.components.closure_parts import ClosureEquations
from symscrew.mobility.components.counted_poses import (
    Coordinate,
    Counted,
    are_independent,
    by_further_primes,
    choices,
    counted_poses,
    rows_at,
)
from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.moving_sections import (
    Section,
    SquareSystem,
    complex_numbers,
    moved_points,
)
from symscrew.mobility.components.plane_sections import sums_of
from symscrew.mobility.components.witness_sets import AGAIN, SAME, joined_sets

Array = np.ndarray[Any, Any]

FEWEST = 2
"""Primes that have to count the same."""
ZERO = 1e-8
"""Of equations with coefficients about one, at a point that was followed."""
SEED = 20231009
"""Of places: always the same, so that results repeat."""


@dataclass(frozen=True)
class PosesOfOne:
    """Poses of one component over a generic place: how many, certified as regular zeros, residual of all equations.

    `on`: real configurations on it; `through`: whether the reference is.
    """

    poses: int
    certified: int
    residual: float
    on: int
    through: bool


@dataclass(frozen=True)
class OverJoints:
    """All components of a dimension over which some coordinates vary freely.

    `joints`: the freedoms, or ratios of Study's x, that are fixed; `total`: poses over generic values of them, over the
    complex numbers;
    `sums`: how many of them a component over the field can have, by the factors modulo so many `primes`; `quiet`: loops
    after the last that joined or found something; `reason`: why the parts are not all, else empty; `beside`:
    equations of the known sets, of more dimensions, whose poses are left out.
    """

    dimension: int
    joints: tuple[str, ...]
    total: int
    sums: tuple[int, ...]
    primes: int
    parts: tuple[PosesOfOne, ...]
    quiet: int
    reason: str
    beside: tuple[tuple[str, ...], ...] = ()

    @property
    def irreducible(self) -> bool:
        """Whether factors leave no finer parts than those that loops have not joined."""
        return set(self.sums) == sums_of([part.poses for part in self.parts])


def over_joints(
    closure: ClosureEquations,
    polynomials: ManyPoints,
    points: Array,
    dimension: int,
    *,
    allowed: AllowedTime,
    reference: bool,
    beside: Sequence[Sequence[str]] = (),
) -> OverJoints | None:
    """The components of the dimension at these real points, in units; `reference`: whether it is the last of them.

    `beside`: equations of known sets of poses, on which points are not counted. None where no coordinates are
    independent there, or the count did not end or is not one of simple points.
    """
    for chosen in _tried(closure, polynomials, points, dimension):
        counted = counted_poses(closure, chosen, FEWEST, beside=beside, allowed=allowed)
        if counted is not None:
            break
    else:
        return None
    total, spent = counted.total, allowed.over
    generator = np.random.default_rng(SEED)
    kind = (rows_at(closure, chosen, np.ones((1, points.shape[1])))[0] != 0).astype(float)
    system = SquareSystem.of(polynomials, len(kind), generator)
    rows = rows_at(closure, chosen, points)
    matrix = rows * complex_numbers(generator, *rows.shape[:2])[..., None]
    if closure.scaled:
        matrix[:, -1] = kind[-1] * complex_numbers(generator, len(points), kind.shape[1])
    right = np.einsum("pij,pj->pi", matrix, points)
    tied = [k for k, coordinate in enumerate(chosen) if coordinate.over is not None]
    right[:, tied] = 0.0
    given = np.ones(len(kind), dtype=complex)
    given[tied] = 0.0
    section = Section(kind.astype(complex), given).another(generator)
    moved, come = moved_points(system, points, (Section(matrix, right), section), spent, patient=False)
    come[come] &= np.abs(polynomials.at(moved[come])[0]).max(axis=1, initial=0.0) < ZERO
    who = np.flatnonzero(come)
    sets, quiet = joined_sets(system, section, moved[come], total, random=generator, spent=spent)
    parts = []
    for z, seeds in sets:
        fine = refined(system, section, z)
        on = {int(who[k]) for k in seeds}
        through = {len(points) - 1} & on if reference else set[int]()
        poses = _different(z[:, len(closure.lengths) :])
        parts.append(PosesOfOne(poses, fine.certified, fine.residual, len(on - through), bool(through)))
    found, until = sum(part.poses for part in parts), sums_of([part.poses for part in parts])
    again: Counted | None = counted
    if len(parts) > 1 or found < total:  # else loops have joined all
        again = by_further_primes(closure, chosen, counted, until=until, beside=beside, allowed=allowed)
    if again is None:
        return None
    reason = "" if found == total else f"{found} of {total} poses were found"
    reason = reason or ("" if quiet >= AGAIN or len(parts) == 1 else "time was over before further loops")
    parts.sort(key=lambda part: (part.poses, -part.on))
    names = tuple(coordinate.name(closure) for coordinate in chosen)
    return OverJoints(dimension, names, total, tuple(sorted(again.sums)), again.primes, tuple(parts), quiet, reason,
                      tuple(map(tuple, beside)))  # fmt: skip


def _different(poses: Array) -> int:
    """How many of them: limbs may be in several positions at one."""
    kept: list[Array] = []
    for pose in poses:
        if all(np.abs(pose - other).max() > SAME * (1 + np.abs(pose).max()) for other in kept):
            kept.append(pose)
    return len(kept)


def _tried(
    closure: ClosureEquations, polynomials: ManyPoints, points: Array, dimension: int
) -> list[tuple[Coordinate, ...]]:
    """The first joints' variables, and the first ratios, that are coordinates there."""
    found: dict[bool, tuple[Coordinate, ...]] = {}
    for chosen in choices(closure, dimension):
        ratios = chosen[0].over is not None
        if ratios not in found and are_independent(closure, polynomials, points, chosen):
            found[ratios] = chosen
    return list(found.values())

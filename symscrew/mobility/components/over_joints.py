"""Components over given joint angles: all poses there, counted modulo primes, and which of them are of one component.

    some joints' variables fixed at random, modulo primes --Singular--> how many poses, degrees of their factors
    real configurations moved to one such place --the place moves round loops--> poses, joined where of one component

A generic section in all variables has hundreds of points where one in the joints' variables alone has forty: of a delta
those of its platform on six rods. Every component over which the joints' variables vary freely has points there, and
loops of the place join those of an irreducible one. That none is missing is by the count: poses in characteristic p are
as many as in zero for all but finitely many primes and places. Each component over the field has a sum of the factors'
degrees, for every prime (`plane_sections`).
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from typing import Any

import numpy as np

from symscrew.mobility.components.algebra_program import algebra_answer
from symscrew.mobility.components.certified_points import refined
from symscrew.mobility.components.closure_parts import ClosureEquations
from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.moving_sections import (
    Section,
    SquareSystem,
    complex_numbers,
    moved_points,
)
from symscrew.mobility.components.plane_sections import places_modulo, sums_of
from symscrew.mobility.components.polynomials import Polynomial
from symscrew.mobility.components.witness_sets import AGAIN, joined_sets

Array = np.ndarray[Any, Any]

PRIMES, FEWEST = 16, 2
"""Primes at most, and those that have to count the same: a pair of poses is parted by one prime in two, so that what
sums sixteen leave open are probably components."""
SECONDS = 4.0
"""Of the processor, for a prime: forty poses take half a second."""
MOST_CHOICES = 64
"""Choices of joints that are tried: the first of each limb, which mostly are independent, are among the first."""
SINGULAR = 1e-4
"""Quotient of singular values of the equations with some variables fixed, below which these are not independent."""
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
    """All components of a dimension over which some joints vary freely.

    `joints`: the freedoms that are fixed; `total`: poses over generic values of them, over the complex numbers;
    `sums`: how many of them a component over the field can have, by the factors modulo so many `primes`; `quiet`: loops
    after the last that joined or found something; `reason`: why the parts are not all, else empty.
    """

    dimension: int
    joints: tuple[str, ...]
    total: int
    sums: tuple[int, ...]
    primes: int
    parts: tuple[PosesOfOne, ...]
    quiet: int
    reason: str

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
    spent: Callable[[], bool],
    reference: bool,
) -> OverJoints | None:
    """The components of the dimension at these real points, in units; `reference`: whether it is the last of them.

    None where no joints' variables are independent there, or the count did not end or is not one of simple points.
    """
    chosen = _independent(closure, polynomials, points, dimension)
    if chosen is None:
        return None
    counted = _counted(closure, chosen, FEWEST, until=set())
    if counted is None:
        return None
    total = counted[0]
    generator = np.random.default_rng(SEED)
    kind = _kind(closure, chosen)
    system = SquareSystem.of(polynomials, len(kind), generator)
    matrix = kind * complex_numbers(generator, len(points), *kind.shape)
    start = Section(matrix, np.einsum("pij,pj->pi", matrix, points))
    section = Section(kind.astype(complex), kind[:, 0].astype(complex)).another(generator)
    moved, come = moved_points(system, points, (start, section), spent, patient=False)
    come[come] &= np.abs(polynomials.at(moved[come])[0]).max(axis=1, initial=0.0) < ZERO
    who = np.flatnonzero(come)
    sets, quiet = joined_sets(system, section, moved[come], total, random=generator, spent=spent)
    parts = []
    for z, seeds in sets:
        fine = refined(system, section, z)
        on = {int(who[k]) for k in seeds}
        through = {len(points) - 1} & on if reference else set[int]()
        parts.append(PosesOfOne(len(z), fine.certified, fine.residual, len(on - through), bool(through)))
    found = sum(part.poses for part in parts)
    again = _counted(closure, chosen, PRIMES, until=sums_of([part.poses for part in parts]))
    if again is None or again[0] != total:
        return None
    _, sums, primes = again
    reason = "" if found == total else f"{found} of {total} poses were found"
    reason = reason or ("" if quiet >= AGAIN else "time was over before further loops")
    parts.sort(key=lambda part: (part.poses, -part.on))
    names = tuple(_name(closure, k) for k in chosen)
    return OverJoints(dimension, names, total, tuple(sorted(sums)), primes, tuple(parts), quiet, reason)


def _name(closure: ClosureEquations, place: int) -> str:
    length = closure.lengths[place]
    several = sum(other.joint == length.joint for other in closure.lengths) > 1
    return f"{length.joint}.{length.freedom}" if several else length.joint


def _kind(closure: ClosureEquations, chosen: Sequence[int]) -> Array:
    """Ones where the equations of a place have variables: each of the chosen is fixed, and a scale of the pose."""
    count = len(closure.variables)
    rows = np.eye(count)[list(chosen)]
    if closure.scaled:
        rows = np.concatenate([rows, np.isin(np.arange(count), closure.scaled)[None]])
    return np.asarray(rows)


def _independent(
    closure: ClosureEquations, polynomials: ManyPoints, points: Array, dimension: int
) -> tuple[int, ...] | None:
    """The first joints' variables that are coordinates at half of the points, near these."""
    joints = range(len(closure.lengths)) if closure.body else ()
    _, slopes = polynomials.at(points)
    for chosen in islice(combinations(joints, dimension), MOST_CHOICES):
        rows = np.broadcast_to(_kind(closure, chosen), (len(points), len(chosen) + 1, points.shape[1])).copy()
        rows[:, -1] *= points  # across the line through zero
        values = np.linalg.svd(np.concatenate([slopes, rows], axis=1), compute_uv=False)
        if 2 * (values[:, -1] > SINGULAR * values[:, 0]).sum() > len(points):
            return chosen
    return None


def _counted(
    closure: ClosureEquations, chosen: Sequence[int], most: int, *, until: set[int]
) -> tuple[int, set[int], int] | None:
    """(poses over a place, what sums of degrees all primes leave, how many primes); None where one has multiple ones.

    Another place for every prime: what is true for each is no accident of one. Till `until` is left, or `most` primes.
    """
    numbers, total, primes = random.Random(SEED), 0, 0
    sums: set[int] = set()
    for prime, roots in places_modulo([g.modulus for g in closure.field.generators], 0, most):
        answer = algebra_answer(_script(closure, chosen, prime, roots, numbers=numbers), SECONDS)
        degrees = [int(d) for d in re.findall(r"^@degree (\d+)$", answer[0], re.MULTILINE)] if answer else []
        if answer is None or not answer[1] or not degrees or (total and sum(degrees) != total):
            return None
        own = sums_of(degrees)
        total, sums, primes = sum(degrees), (sums & own if primes else own), primes + 1
        if sums == until and primes >= FEWEST:
            break
    return total, sums, primes


def _script(
    closure: ClosureEquations, chosen: Sequence[int], prime: int, roots: Sequence[int], *, numbers: random.Random
) -> str:
    """Poses over a place without those at which an excluded polynomial vanishes, told from each other by a form u."""
    names = [f"v{k + 1}" for k in range(len(closure.variables))]
    letters = [f"a{k + 1}" for k in range(len(roots))]

    def form(places: Sequence[int]) -> str:
        return "+".join(f"{numbers.randint(1, prime - 1)}*{names[k]}" for k in places)

    def text(polynomials: Sequence[Polynomial]) -> str:
        return ",\n".join(p.text(names, closure.field.generators, letters) for p in polynomials)

    cuts = [f"v{k + 1}-{numbers.randint(1, prime - 1)}" for k in chosen]
    cuts += [f"{form(closure.scaled)}-1"] if closure.scaled else []
    given = "".join(f"poly {letter} = {root}; " for letter, root in zip(letters, roots, strict=True))
    left = [k for k in range(len(names)) if k not in chosen]
    never = [p for p in closure.excluded if any(key[k] for key in p.terms for k in left)]
    apart = "".join(f"K = std(sat(K, ideal({text([p])}))[1]);\n" for p in never)
    return f"""LIB "elim.lib";
ring r = {prime}, ({",".join(names)},u), dp; option(redSB); short = 0; {given}
ideal K = std(ideal({text(closure.equations)},
{",".join(cuts)}, u-({form(left)})));
{apart}
if (dim(K) == 0) {{
  int count = vdim(K);
  ring s = {prime}, ({",".join(names)},u), lp; ideal L = fglm(r, K); poly f = L[1]; int i;
  if (deg(f) == count and deg(gcd(f, diff(f, u))) <= 0) {{
    list F = factorize(f, 1);
    for (i = 1; i <= ncols(F[1]); i++) {{ print("@degree " + string(deg(F[1][i]))); }}
  }}
}}
print("@end");
quit;
"""

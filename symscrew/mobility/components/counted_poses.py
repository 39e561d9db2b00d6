"""How many poses there are over given coordinates, modulo primes, and the degrees of their factors.

    equations of each limb with the coordinates fixed at random --its joints eliminated--> what it lays on the pose
    all of these together, beside known sets --dimension 0--> number of poses, factors of what a form of them is zero of

A coordinate is a joint's variable or a ratio of two of Study's x: over two of these, limb by limb, what a 4-RUU does
beside its Schoenflies modes takes five seconds where all equations at once take no less than two minutes.
"""

from __future__ import annotations

import random
import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from typing import Any

import numpy as np

from symscrew.mobility.components.algebra_program import algebra_answer
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.closure_parts import ClosureEquations
from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.plane_sections import places_modulo, sums_of
from symscrew.mobility.components.polynomials import Polynomial

Array = np.ndarray[Any, Any]

SECONDS = 10.0
"""Of the processor, for a prime: forty poses take half a second, two hundred six."""
PRIMES = 16
"""Primes at most: a pair of poses is parted by one prime in two, so that what sums sixteen leave open are probably
components."""
MOST_CHOICES = 64
"""Choices of joints that are tried: the first of each limb, which mostly are independent, are among the first."""
SINGULAR = 1e-4
"""Quotient of singular values of the equations with some variables fixed, below which these are not independent."""
SEED = 20231009
"""Of places: always the same, so that results repeat."""
PAIRS = ((0, 3), (1, 2), (0, 1), (0, 2), (1, 3), (2, 3))
"""Ratios of Study's x: tangents of half the sum and half the difference of Euler's angles about z first."""


@dataclass(frozen=True)
class Coordinate:
    """A joint's variable at a place of the closure's, or how one of Study's x is to another: `over` is its place."""

    place: int
    over: int | None = None

    def name(self, closure: ClosureEquations) -> str:
        """The joint, with the number of its freedom where it has several among the variables; or a ratio."""
        if self.over is not None:
            return f"{closure.variables[self.place]} : {closure.variables[self.over]}"
        length = closure.lengths[self.place]
        several = sum(other.joint == length.joint for other in closure.lengths) > 1
        return f"{length.joint}.{length.freedom}" if several else length.joint


def choices(closure: ClosureEquations, dimension: int) -> list[tuple[Coordinate, ...]]:
    """Sets of so many coordinates of a body's pose: joints' variables first, then ratios of x."""
    if not closure.body:
        return []
    joints = [Coordinate(k) for k in range(len(closure.lengths))]
    first = closure.scaled[0]
    ratios = [Coordinate(first + j, first + i) for i, j in PAIRS]
    return [chosen for kind in (joints, ratios) for chosen in islice(combinations(kind, dimension), MOST_CHOICES)]


def rows_at(closure: ClosureEquations, chosen: Sequence[Coordinate], points: Array) -> Array:
    """Linear forms of the variables that fix the coordinates at points, a last one of the scale: points x rows x
    variables. Those of ratios are zero at the points."""
    rows = np.zeros((len(points), len(chosen) + bool(closure.scaled), points.shape[1]), dtype=points.dtype)
    for k, coordinate in enumerate(chosen):
        rows[:, k, coordinate.place] = 1.0
        if coordinate.over is not None:
            rows[:, k, coordinate.place] = points[:, coordinate.over]
            rows[:, k, coordinate.over] = -points[:, coordinate.place]
    if closure.scaled:
        rows[:, -1, list(closure.scaled)] = 1.0
    return rows


def are_independent(
    closure: ClosureEquations, polynomials: ManyPoints, points: Array, chosen: Sequence[Coordinate]
) -> bool:
    """Whether these are coordinates at half of the points, near these."""
    rows = rows_at(closure, chosen, points)
    rows[:, -1] *= points  # across the line through zero
    values = np.linalg.svd(np.concatenate([polynomials.at(points)[1], rows], axis=1), compute_uv=False)
    return bool(2 * (values[:, -1] > SINGULAR * values[:, 0]).sum() > len(points))


@dataclass(frozen=True)
class Counted:
    """Poses over a place, what sums of factors' degrees all primes leave, how many primes."""

    total: int
    sums: frozenset[int]
    primes: int

    def further(self, degrees: Sequence[int]) -> Counted:
        """With those of another prime."""
        own = frozenset(sums_of(degrees))
        return Counted(sum(degrees), self.sums & own if self.primes else own, self.primes + 1)


def counted_poses(
    closure: ClosureEquations,
    chosen: Sequence[Coordinate],
    primes: int,
    *,
    beside: Sequence[Sequence[str]],
    allowed: AllowedTime,
) -> Counted | None:
    """The poses modulo so many primes; None where one has none, multiple ones, or others than the first, or time ends.

    Another place for every prime: what is true for each is no accident of one. Points on sets with these equations,
    `beside`, are not among them.
    """
    found = Counted(0, frozenset(), 0)
    for k in range(primes):
        degrees = _degrees(closure, chosen, k, beside=beside, allowed=allowed)
        if not degrees or (found.total and sum(degrees) != found.total):
            return None
        found = found.further(degrees)
    return found


def by_further_primes(
    closure: ClosureEquations,
    chosen: Sequence[Coordinate],
    found: Counted,
    *,
    until: set[int],
    beside: Sequence[Sequence[str]],
    allowed: AllowedTime,
) -> Counted | None:
    """The same until no other sums of degrees are left, or `PRIMES` primes, or time is over; None as above."""
    while found.sums != until and found.primes < PRIMES and not allowed.over():
        degrees = _degrees(closure, chosen, found.primes, beside=beside, allowed=allowed)
        if degrees is None:
            break
        if sum(degrees) != found.total:
            return None
        found = found.further(degrees)
    return found


def _degrees(
    closure: ClosureEquations,
    chosen: Sequence[Coordinate],
    number: int,
    *,
    beside: Sequence[Sequence[str]],
    allowed: AllowedTime,
) -> list[int] | None:
    """Of the factors modulo a prime, none where there are no simple points; None where the program did not end."""
    ((prime, roots),) = places_modulo([g.modulus for g in closure.field.generators], number, 1)
    script = _Script(closure, chosen, prime, random.Random(SEED + number)).text(roots, beside)
    answer = algebra_answer(script, allowed.at_most(SECONDS))
    if answer is None or not answer[1]:
        return None
    return [int(d) for d in re.findall(r"^@degree (\d+)$", answer[0], re.MULTILINE)]


class _Script:
    """A program that counts modulo a prime, at a place of its own."""

    def __init__(
        self, closure: ClosureEquations, chosen: Sequence[Coordinate], prime: int, numbers: random.Random
    ) -> None:
        self.closure, self.chosen, self.prime, self.numbers = closure, chosen, prime, numbers
        self.names = [f"v{k + 1}" for k in range(len(closure.variables))]
        fixed = {c.place for c in chosen if c.over is None}
        self.joints = [k for k in range(len(closure.lengths)) if k not in fixed]
        self.left = [k for k in range(len(self.names)) if k not in fixed]

    def text(self, roots: Sequence[int], beside: Sequence[Sequence[str]]) -> str:
        """Poses over a place without those at which an excluded polynomial vanishes, told apart by a form u."""
        letters = [f"a{k + 1}" for k in range(len(roots))]

        def texts(polynomials: Sequence[Polynomial]) -> str:
            return ",\n".join(p.text(self.names, self.closure.field.generators, letters) for p in polynomials)

        cuts = [self._cut(c) for c in self.chosen]
        cuts += [f"{self._form(self.closure.scaled)}-1"] if self.closure.scaled else []
        given = "".join(f"poly {letter} = {root}; " for letter, root in zip(letters, roots, strict=True))
        never = [p for p in self.closure.excluded if any(key[k] for key in p.terms for k in self.left)]
        known = "*".join(f"({self._one([self._back(e, letters) for e in equations])})" for equations in beside)
        aside = f", w*{known}-1" if known else ""  # one more variable costs a tenth of what a quotient does
        limbs = self._limbs()
        poses = limbs.pop(frozenset(), [])

        def away(joints: frozenset[int]) -> str:
            own = [p for p in never if {k for key in p.terms for k in self.joints if key[k]} <= joints]
            return f"ideal({texts(own) or '1'})"

        each = "\n".join(
            f"K = apart(std(F + ideal({texts(own)}{aside})), {away(joints)}); "
            f"S = S + eliminate(K, {'*'.join(['w', *(self.names[k] for k in sorted(joints))])});"
            for joints, own in limbs.items()
        )
        rest = [self.names[k] for k in self.joints]
        poses_of = [k for k in range(len(self.names)) if k >= len(self.closure.lengths)]
        return f"""LIB "elim.lib";
ring r = {self.prime}, ({",".join(self.names)},u,w), dp; option(redSB); short = 0; {given}
proc apart(ideal L, ideal never) {{
  int i; poly f;
  for (i = 1; i <= size(never); i++) {{
    f = reduce(never[i], L);
    if (dim(std(L + ideal(f))) >= 0) {{ L = std(sat(L, ideal(f))[1]); }}
  }}
  return(L);
}}
ideal F = {",".join([*filter(None, [texts(poses)]), *cuts])};
ideal K; F = std(F); ideal S = F;
{each}
K = apart(std(S + ideal({",".join([*rest, f"u-({self._form(poses_of)})"])}{aside or ", w"})), {away(frozenset())});
if (dim(K) == 0) {{
  int count = vdim(K);
  ring s = {self.prime}, ({",".join(self.names)},w,u), lp; ideal L = fglm(r, K); poly f = L[1]; int i;
  if (deg(f) == count and deg(gcd(f, diff(f, u))) <= 0) {{
    list F = factorize(f, 1);
    for (i = 1; i <= ncols(F[1]); i++) {{ print("@degree " + string(deg(F[1][i]))); }}
  }}
}}
print("@end");
quit;
"""

    def _limbs(self) -> dict[frozenset[int], list[Polynomial]]:
        """Joints' variables that are not fixed -> the equations with these, and with no others."""
        limbs: dict[frozenset[int], list[Polynomial]] = {}
        for equation in self.closure.equations:
            inside = frozenset(k for k in self.joints if any(key[k] for key in equation.terms))
            others = [joints for joints in limbs if joints & inside]
            merged = [p for joints in others for p in limbs.pop(joints)]
            limbs.setdefault(inside.union(*others), []).extend([*merged, equation])
        return limbs

    def _one(self, equations: Sequence[str]) -> str:
        """A polynomial that is zero where all these are, and at no other of finitely many points but by chance."""
        return "+".join(f"{self.numbers.randint(1, self.prime - 1)}*({e})" for e in equations)

    def _form(self, places: Sequence[int]) -> str:
        return "+".join(f"{self.numbers.randint(1, self.prime - 1)}*{self.names[k]}" for k in places)

    def _cut(self, coordinate: Coordinate) -> str:
        other = "" if coordinate.over is None else f"*{self.names[coordinate.over]}"
        return f"{self.names[coordinate.place]}-{self.numbers.randint(1, self.prime - 1)}{other}"

    def _back(self, equation: str, letters: Sequence[str]) -> str:
        """An equation in the names of the closure's variables and roots, in those of the program."""
        for generator, letter in zip(self.closure.field.generators, letters, strict=True):
            equation = equation.replace(str(generator.name), letter)
        places = {name: self.names[k] for k, name in enumerate(self.closure.variables)}
        return re.sub(r"[A-Za-z_]\w*", lambda m: places.get(m[0], m[0]), equation)

"""Components of the configuration space by numerical irreducible decomposition, where exact algebra does not divide.

    real configurations --rank: local dimension--> each moved to one random section --witness_sets--> components
    points of a component --certified_points--> proved regular zeros, sums linear to 60 digits

What it gives is numerical: a component's degree by the trace test, that it is irreducible over the complex numbers by
loops that join its points. Components are those that real configurations from random starts lie on; others may be
missing. Points where the equations' derivatives have less rank than around them belong to none: of a component on all
of which it is so (a multiple one) nothing is said.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.certified_points import refined, trace_in_digits
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.moving_sections import (
    Section,
    SquareSystem,
    complex_numbers,
    moved_points,
    short_numbers,
)
from symscrew.mobility.components.real_configurations import (
    SEED,
    real_configurations,
    told_apart,
    variables_at,
)
from symscrew.mobility.components.witness_sets import WitnessSet, completed_sets, together
from symscrew.mobility.finite import blocks_of
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import exact_value

Array = np.ndarray[Any, Any]

SECONDS = 20.0
"""Of the processor, for one decomposition: degrees up to some hundred take one to fifteen."""
LARGE = 1e4
"""A variable beyond it is a joint near the angle where its tangent has no value: the point is left out."""
RANK = 1e-8
"""Relative singular value of the derivatives that counts as none: those of dependent equations have 1e-15."""
LEAST = 1e-2
"""Largest singular value, of equations with coefficients about one, below which it is no measure of rounding: where all
derivatives are zero it is rounding itself, 1e-15, and where equations move at all it is near one."""
ZERO = 1e-8
"""Of equations with coefficients about one, at a point that was followed: more is a zero of combinations only."""
ALL = 1e-30
"""Of all equations at points in 60 digits: zeros of all have 1e-48 or less. Where a real point is singular, known to
1e-6, one near it can be a zero of combinations, and others are 1e-9 there."""
APART = 1e-6
"""Isolated configurations that differ by more are two."""
LOOPING, JOINING = 0.75, 0.85
"""Parts of the time after which no further points are looked for, and those that were found not joined once more."""
ENDS = (1e-2, 1e-4, 1e-6)
"""How near to the reference's section points are followed, where it is singular: m that meet come by the m-th root."""
COMES, STAYS = 0.5, 0.9
"""Quotient of distances at the last and the first: of eight that meet 0.3 is left, of one elsewhere all of it."""
NEAR = 1e-2
"""Distance at the last one within which a point comes to the reference, in units of the variables."""


@dataclass(frozen=True)
class NumericalComponent:
    """A component: dimension, degree; all points of it on a random section were found.

    `closed`: whether the trace test says that these are all; if not, `degree` is how many were found of one component
    or several, at most `sets`;
    `certified`: of how many it is proved that they are regular zeros, apart from each other; `trace`: second difference
    of their sum, relative, in 60 digits where `fine`; `residual`: largest of all equations at them; `loops`: how many
    joined all points when they were followed a second time, 0 where that was not done; `on`: real configurations on it;
    `through`: whether the reference is on it, None where that is not known.
    """

    dimension: int
    degree: int
    closed: bool
    certified: int
    trace: float
    fine: bool
    residual: float
    loops: int
    sets: int = 1
    on: int = 0
    through: bool | None = None


@dataclass(frozen=True)
class NumericalSpace:
    """The components of one set of linked loops, with the variables in which degrees are counted.

    `found`: real configurations; `isolated`: of these the ones about which nothing moves, how many different ones;
    `unplaced`: those that are on none, as they are singular or could not be followed; `combined`: whether points are
    certified of combinations of the equations; `reason`: why not all points of the components
    that were met are known, else empty.
    """

    subject: str
    variables: tuple[str, ...]
    field: str
    components: tuple[NumericalComponent, ...]
    found: int
    isolated: int
    unplaced: int
    combined: bool
    settles: bool
    reason: str

    @property
    def closed(self) -> bool:
        """Whether every component that was met has all its points."""
        return not self.reason


def numerical_components(
    mechanism: Mechanism, network: Network, seconds: float = SECONDS
) -> tuple[NumericalSpace, ...] | str:
    """The components of each set of loops that share no joint with others, or why there are none."""
    spaces = list[NumericalSpace]()
    for block in blocks_of(network):
        if not block.chords:
            continue
        try:
            closure = _closure(mechanism, block)
        except NotAlgebraicError as error:
            return f"no numerical decomposition: {error}"
        found = decomposed(closure, block, seconds)
        if found is None:
            return "no numerical decomposition: random starts came to no configuration whose place doubles tell"
        spaces.append(found)
    return tuple(spaces) or "no numerical decomposition: no loops"


def _closure(mechanism: Mechanism, network: Network) -> ClosureEquations:
    """The equations, of the pose alone where angles of ball joints would be among the variables: these are none."""
    closure = closure_equations(mechanism, network)
    if any(network.edges[length.joint].motions[0][0].spherical for length in closure.lengths):
        closure = closure_equations(mechanism, network, fewest=True)
    return closure


def decomposed(closure: ClosureEquations, network: Network, seconds: float = SECONDS) -> NumericalSpace | None:
    """The components that real configurations lie on; None where none of these were found."""
    begun = time.process_time()
    values, blurred = _known_points(closure, network)
    if not len(values):
        return None
    polynomials = ManyPoints.of(closure.equations, _units(closure, values))
    z = _closer(polynomials, values / polynomials.sizes)
    reference = np.array([[float(exact_value(c)) for c in closure.reference]]) / polynomials.sizes
    points = np.concatenate([z, reference])  # the reference last
    ranks = _coranks(polynomials, points)
    cone = int(bool(closure.scaled))
    placed, components = ranks == cone, list[NumericalComponent]()
    several = sorted({int(s) for s in ranks[:-1] if s > cone}, reverse=True)
    for number, size in enumerate(several):  # each has the same time
        work = _Dimension(polynomials, size, _limit(begun, seconds * (number + 1) / len(several)))
        who = np.flatnonzero(ranks == size)
        sets, known = work.sets(points[who])
        placed[who[known]] = True
        for found in sets:
            part = work.component(found, size - cone)
            if part.residual > ALL:
                placed[[who[known][k] for k in found.seeds]] = False
                continue
            on = {int(who[known][k]) for k in found.seeds}
            through = len(z) in on if ranks[-1] <= size else work.reaches(found, reference[0])
            if ranks[-1] == size and not placed[-1]:
                through = None
            components.append(replace(part, on=len(on - {len(z)}), through=through))
    components.sort(key=lambda c: (-c.dimension, c.degree, -c.on))
    least = min((c.dimension for c in components), default=0) + cone
    late = time.process_time() - begun > LOOPING * seconds
    reason = f"not all points were found within {seconds:g} s of the processor"
    return NumericalSpace(
        closure.subject, closure.variables, str(closure.field), tuple(components), len(z) + blurred,
        _different(z[ranks[:-1] == cone], closure), int((~placed[:-1]).sum()) + blurred,
        len(closure.equations) > len(closure.variables) - least, closure.settles,
        reason if not all(c.closed for c in components) or (late and not placed.all()) else "",
    )  # fmt: skip


class _Dimension:
    """Points of components of one dimension, on one random section; `late`: whether a part of the time is over."""

    def __init__(self, polynomials: ManyPoints, size: int, late: Callable[[float], bool]) -> None:
        self.random = np.random.default_rng(SEED)
        self.size, self.late = size, late
        self.times = (lambda: late(LOOPING), lambda: late(JOINING))
        self.system = SquareSystem.of(polynomials, size, self.random)
        self.width = len(polynomials.sizes)
        self.section = Section(complex_numbers(self.random, size, self.width), short_numbers(self.random, size))

    def sets(self, points: Array) -> tuple[list[WitnessSet], Array]:
        """(sets of the points' components, which points were followed to the section and are zeros there)."""
        matrix = complex_numbers(self.random, len(points), self.size, self.width)
        start = Section(matrix, np.einsum("pij,pj->pi", matrix, points))
        moved, come = moved_points(self.system, points, (start, self.section), self.times[0])
        come[come] &= np.abs(self.system.polynomials.at(moved[come])[0]).max(axis=1, initial=0.0) < ZERO
        return together(completed_sets(self.system, self.section, moved[come], self.times, random=self.random)), come

    def component(self, found: WitnessSet, dimension: int) -> NumericalComponent:
        """What is known of the set's component, its points in 60 digits where there is time for them."""
        certified, residual, trace, fine = 0, 0.0, found.trace, False
        if not self.late(1.0):
            here = refined(self.system, self.section, found.points)
            certified, residual = here.certified, here.residual
            if found.beside is not None and not self.late(1.0):
                sides = [refined(self.system, found.parallel(self.section, side), found.beside[k])
                         for k, side in enumerate((1, -1))]  # fmt: skip
                trace, fine = trace_in_digits(here.points, (sides[0].points, sides[1].points)), True
        return NumericalComponent(dimension, len(found.points), found.closed, certified, trace, fine, residual,
                                  found.sure, found.sets)  # fmt: skip

    def reaches(self, found: WitnessSet, point: Array) -> bool | None:
        """Whether a singular point is of the set's component: points of the set come to it as the section does."""
        if not found.closed or self.times[1]():
            return None
        matrix = complex_numbers(self.random, self.size, self.width)
        aside = complex_numbers(self.random, self.size)
        at, z, away = self.section, found.points, list[float]()
        held = np.zeros(len(z), dtype=bool)  # near the point itself a path may be too steep to be followed on
        for end in ENDS:
            to, z = Section(matrix, matrix @ point + end * aside), z.copy()
            z[~held], come = moved_points(self.system, z[~held], (at, to), self.times[1])
            held[~held] = ~come
            distance = np.abs(z - point).max(axis=1)
            if (distance[held] > NEAR).any():
                return None
            at = to
            away.append(float(distance.min()))
        if away[-1] > STAYS * away[0]:
            return False
        return True if away[-1] < COMES * away[0] and away[-1] < NEAR else None


def _limit(begun: float, until: float) -> Callable[[float], bool]:
    return lambda part: time.process_time() - begun > part * until


def _known_points(closure: ClosureEquations, network: Network) -> tuple[Array, int]:
    """(values of the variables at real configurations, one a row, how many others doubles do not tell the place of).

    Of ratios the ones with x of length one.
    """
    q = real_configurations(network)
    told = told_apart(network, q)
    values = variables_at(closure, network, q[told]) if told.any() else None
    if values is None:
        return np.zeros((0, len(closure.variables))), 0
    values = values[np.isfinite(values).all(axis=1)]
    if closure.scaled and len(values):
        first = closure.scaled[0]
        values = values.copy()
        values[:, first:] /= np.linalg.norm(values[:, first : first + 4], axis=1, keepdims=True)
    return np.asarray(values[np.abs(values).max(axis=1, initial=0.0) < LARGE]), int((~told).sum())


def _least_step(polynomials: ManyPoints, z: Array) -> Array:
    values, slopes = polynomials.at(z)
    return np.asarray((np.linalg.pinv(slopes, rcond=RANK) @ values[..., None])[..., 0])


def _closer(polynomials: ManyPoints, z: Array) -> Array:
    """The points to rounding."""
    for _ in range(2):
        z = z - _least_step(polynomials, z)
    return np.asarray(z[np.isfinite(z).all(axis=1)])


def _units(closure: ClosureEquations, values: Array) -> Array:
    """Powers of two near the size of the variables: one of cosines, sines and x; one of all y; each of the others."""
    units = np.quantile(np.abs(values), 0.75, axis=0)
    units[: 2 * len(closure.turning)] = 1.0
    if closure.scaled:
        first = closure.scaled[0]
        units[first : first + 4] = 1.0
        units[first + 4 :] = np.sqrt((values[:, first + 4 :] ** 2).mean())
    return np.asarray(2.0 ** np.round(np.log2(np.where(units > 0, units, 1.0))))


def _coranks(polynomials: ManyPoints, z: Array) -> Array:
    """Dimensions of what the equations leave to first order."""
    _, slopes = polynomials.at(z)
    values = np.linalg.svd(slopes, compute_uv=False)
    return np.asarray(z.shape[1] - (values > RANK * np.maximum(values[:, :1], LEAST)).sum(axis=1))


def _different(z: Array, closure: ClosureEquations) -> int:
    """How many of the points are not the same; of ratios a point is the same with the other sign."""
    kept = list[Array]()
    first = closure.scaled[0] if closure.scaled else z.shape[1]
    for point in z:
        turned = np.concatenate([point[:first], -point[first:]])
        if all(min(np.abs(p - point).max(), np.abs(p - turned).max()) > APART for p in kept):
            kept.append(point)
    return len(kept)

"""Components of the configuration space by numerical irreducible decomposition, where exact algebra does not divide.

    real configurations --rank: local dimension--> each moved to one random section --witness_sets--> components
    points of a component --certified_points--> proved regular zeros, sums linear to 60 digits

What it gives is numerical: a component's degree by the trace test, that it is irreducible over the complex numbers by
loops that join its points. Components are those that real configurations from random starts lie on; others may be
missing. Points where the equations' derivatives have less rank than around them belong to none; where all that were
found are such, the sets of equal rank are decomposed in their place (`deflation`). What does not close so is looked at
over given joint angles (`over_joints`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.certified_points import refined, trace_in_digits
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.component_parts import Part, linear_equations
from symscrew.mobility.components.deflation import deflated, made_regular, ranks_of
from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.moving_sections import (
    Section,
    SquareSystem,
    complex_numbers,
    moved_points,
    short_numbers,
)
from symscrew.mobility.components.over_joints import OverJoints, over_joints
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
NOTHING = 1e-6
"""Of the largest of all values: a variable below it is rounding of zero at singular configurations, unit one."""
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
    `through`: whether the reference is on it, None where that is not known; `rank`: of the equations' derivatives all
    over a set on which that is lower than around it; it is certified with equations for this rank (deflated).
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
    rank: int | None = None


@dataclass(frozen=True)
class NumericalSpace:
    """The components of one set of linked loops, with the variables in which degrees are counted.

    `found`: real configurations; `isolated`: of these the ones about which nothing moves, how many different ones;
    `unplaced`: those that are on none, as they are singular or could not be followed; `combined`: whether points are
    certified of combinations of the equations; `reason`: why not all points of the components
    that were met are known, else empty; `over`: then the components over given joint angles, where these are fewer.
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
    over: tuple[OverJoints, ...] = ()

    @property
    def closed(self) -> bool:
        """Whether every component that was met has all its points."""
        return not self.reason


def numerical_components(
    mechanism: Mechanism,
    network: Network,
    seconds: float = SECONDS,
    *,
    over: float | None = None,
    beside: Sequence[Part] = (),
) -> tuple[NumericalSpace, ...] | str:
    """The components of each set of loops that share no joint with others, or why there are none.

    In so many seconds of the processor for all, and as many again, or `over`, for those over given coordinates, which
    have no points on known sets of poses, `beside`.
    """
    blocks, over = [block for block in blocks_of(network) if block.chords], seconds if over is None else over
    allowed, known = AllowedTime(seconds + over), [(part.dimension, linear_equations(part)) for part in beside]
    spaces = list[NumericalSpace]()
    for block in blocks:
        try:
            closure = pose_equations(mechanism, block)
        except NotAlgebraicError as error:
            return f"no numerical decomposition: {error}"
        first = allowed.at_most(seconds)
        found = decomposed(closure, block, (first, min(over, allowed.left - first)), beside=known)
        if found is None:
            return "no numerical decomposition: random starts came to no configuration whose place doubles tell"
        spaces.append(found)
    return tuple(spaces) or "no numerical decomposition: no loops"


def pose_equations(mechanism: Mechanism, network: Network) -> ClosureEquations:
    """The equations, of the pose alone where angles of ball joints would be among the variables: these are none."""
    closure = closure_equations(mechanism, network)
    if any(network.edges[length.joint].motions[0][0].spherical for length in closure.lengths):
        closure = closure_equations(mechanism, network, fewest=True)
    return closure


def decomposed(
    closure: ClosureEquations,
    network: Network,
    times: tuple[float, float],
    *,
    beside: Sequence[tuple[int, Sequence[str]]] = (),
) -> NumericalSpace | None:
    """The components that real configurations lie on; None where none of these were found.

    `times`: for them, and for those over given coordinates where these have not closed, `beside` sets of more
    dimensions with these equations.
    """
    seconds, over_seconds = times
    begun = AllowedTime(seconds)
    values, vague = _found_points(closure, network)
    if not len(values):
        return _deflated(closure, vague, begun.over)
    blurred = len(vague)
    polynomials = ManyPoints.of(closure.equations, _units(closure, values))
    z = _closer(polynomials, values / polynomials.sizes)
    reference = np.array([[float(exact_value(c)) for c in closure.reference]]) / polynomials.sizes
    points = np.concatenate([z, reference])  # the reference last
    ranks = _coranks(polynomials, points)
    cone = int(bool(closure.scaled))
    placed, components = ranks == cone, list[NumericalComponent]()
    several = sorted({int(s) for s in ranks[:-1] if s > cone}, reverse=True)
    for number, size in enumerate(several):  # each has the same time
        work = _Dimension(polynomials, size, _late(begun, (number + 1) / len(several)))
        who = np.flatnonzero(ranks == size)
        sets, known = work.sets(points[who])
        placed[who[known]] = True
        for one in sets:
            part = work.component(one, size - cone)
            if part.residual > ALL:
                placed[[who[known][k] for k in one.seeds]] = False
                continue
            on = {int(who[known][k]) for k in one.seeds}
            through = len(z) in on if ranks[-1] <= size else work.reaches(one, reference[0])
            if ranks[-1] == size and not placed[-1]:
                through = None
            components.append(replace(part, on=len(on - {len(z)}), through=through))
    components.sort(key=lambda c: (-c.dimension, c.degree, -c.on))
    least = min((c.dimension for c in components), default=0) + cone
    late = begun.over(LOOPING)
    done = all(c.closed for c in components) and not (late and not placed.all())
    over = list[OverJoints]()
    if not done:
        allowed = AllowedTime(over_seconds)
        for size in several:
            larger = [equations for dimension, equations in beside if dimension > size - cone]
            found = over_joints(closure, polynomials, points[ranks == size], size - cone,
                                allowed=allowed, reference=bool(ranks[-1] == size), beside=larger)  # fmt: skip
            over += [found] if found is not None else []
    return NumericalSpace(
        closure.subject, closure.variables, str(closure.field), tuple(components), len(z) + blurred,
        _different(z[ranks[:-1] == cone], closure), int((~placed[:-1]).sum()) + blurred,
        len(closure.equations) > len(closure.variables) - least, closure.settles,
        "" if done else f"not all points were found within {seconds:.3g} s of the processor", tuple(over),
    )  # fmt: skip


def _deflated(
    closure: ClosureEquations, vague: Array, late: Callable[[float], bool]
) -> NumericalSpace | None:  # fmt: skip
    """The sets where equations have less rank than around them, of a mechanism all of whose configurations are such.

    None where conditions for the rank do not make a zero regular.
    """
    vague = vague[np.isfinite(vague).all(axis=1)]
    if not len(vague) or np.abs(vague).max() > LARGE:
        return None
    sizes, cone = _units(closure, vague), int(bool(closure.scaled))
    plain, count = ManyPoints.of(closure.equations, sizes), len(sizes)
    reference = np.array([[float(exact_value(c)) for c in closure.reference]]) / sizes
    points = np.concatenate([vague / sizes, reference])
    ranks = ranks_of(plain, points)
    components, placed = list[NumericalComponent](), np.zeros(len(points), dtype=bool)
    for rank in sorted(set(ranks.tolist())):
        given = deflated(closure.equations, rank, np.random.default_rng(SEED))
        more = len(next(iter(given[0].terms))) - count
        polynomials = ManyPoints.of(given, np.concatenate([sizes, np.ones(more)]))
        who = np.flatnonzero(ranks == rank)
        z, settled = made_regular(polynomials, points[who], RANK)
        who, z = who[settled], z[settled]
        free = _coranks(polynomials, z)
        for size in sorted({int(s) for s in free if s > cone}, reverse=True):
            work = _Dimension(polynomials, size, late, np.arange(count + more) < count)
            own = who[free == size]
            sets, known = work.sets(z[free == size])
            for one in sets:
                part = work.component(one, size - cone)
                if part.residual <= ALL:
                    on = {int(own[known][k]) for k in one.seeds}
                    placed[list(on)] = True
                    through = len(vague) in on
                    components.append(replace(part, on=len(on - {len(vague)}), through=through, rank=rank))
    if not components:
        return None
    done = all(c.closed for c in components)
    return NumericalSpace(
        closure.subject, closure.variables, str(closure.field), tuple(components), len(vague), 0,
        int((~placed[:-1]).sum()), True, closure.settles, "" if done else "not all points were found in the time given",
    )  # fmt: skip


class _Dimension:
    """Points of components of one dimension, on one random section; `late`: whether a part of the time is over.

    `support`: the variables that the section is of.
    """

    def __init__(
        self, polynomials: ManyPoints, size: int, late: Callable[[float], bool], support: Array | None = None
    ) -> None:
        self.random = np.random.default_rng(SEED)
        self.size, self.late = size, late
        self.times = (lambda: late(LOOPING), lambda: late(JOINING))
        self.system = SquareSystem.of(polynomials, size, self.random)
        self.width = len(polynomials.sizes)
        self.support = np.ones(self.width, dtype=bool) if support is None else support
        matrix = complex_numbers(self.random, size, self.width) * self.support
        self.section = Section(matrix, short_numbers(self.random, size))

    def sets(self, points: Array) -> tuple[list[WitnessSet], Array]:
        """(sets of the points' components, which points were followed to the section and are zeros there)."""
        matrix = complex_numbers(self.random, len(points), self.size, self.width) * self.support
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


def _late(allowed: AllowedTime, share: float) -> Callable[[float], bool]:
    """Whether a part of this share of the time is over."""
    return lambda part: allowed.over(part * share)


def _found_points(closure: ClosureEquations, network: Network) -> tuple[Array, Array]:
    """(values of the variables at real configurations, one a row; those of others, which doubles tell the place of
    to fewer digits only). Of ratios the ones with x of length one.
    """
    q = real_configurations(network)
    told = told_apart(network, q)
    values = variables_at(closure, network, q) if len(q) else None
    if values is None:
        return np.zeros((0, len(closure.variables))), np.zeros((0, len(closure.variables)))
    if closure.scaled:
        first = closure.scaled[0]
        values = values.copy()
        values[:, first:] /= np.linalg.norm(values[:, first : first + 4], axis=1, keepdims=True)
    good = np.abs(np.nan_to_num(values, nan=np.inf)).max(axis=1, initial=0.0) < LARGE
    return values[told & good], values[~told]


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
    return np.asarray(2.0 ** np.round(np.log2(np.where(units > NOTHING * np.abs(values).max(), units, 1.0))))


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

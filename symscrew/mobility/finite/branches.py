"""Branches of the configuration space through a singular configuration.

    random starts, cone directions --zeros of g on a sphere--> points --inwards--> those on a branch --> dimensions

A branch through the configuration meets every small sphere around it. So: zeros of the reduced closure on spheres
in the instantaneous motions, from random starts and from the directions of the second-order tangent cone, found on
linear slices of every dimension; each zero is followed inwards to a much smaller sphere, which drops those that do
not pass through the configuration; the dimension of the branch at a zero is the number of instantaneous freedoms
there, after real motion along all of them has been confirmed in 60 digits. Where a whole branch is shaky (more
instantaneous freedoms than real ones everywhere on it) the dimension is that of the zeros around.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass

import numpy as np

from symscrew.mobility.finite.local_solutions import (
    SEED,
    Local,
    coarse_rank,
    flatten,
    local_at,
    local_refined,
    vanishes,
)
from symscrew.mobility.finite.quadric_cone import cone_directions
from symscrew.mobility.finite.reduced_closure import ReducedClosure, Values, is_zero
from symscrew.mobility.finite.variety import Array, ClosureVariety
from symscrew.mobility.finite.witnesses import Witness

RADII = (0.1, 0.02)
"""Spheres on which zeros are looked for, in units of the mechanism's size: on a large one zeros are told from rounding
better, a small one misses no branch that bends away soon. Zeros beyond the larger one are of no concern here."""
INWARDS = 6
"""Times that a zero is followed to half the radius: down to 1/64, where a branch that passes by at a distance of a few
hundredths of the radius is left behind."""
KEPT = 8
"""Zeros of each kind (equally many instantaneous freedoms) that are followed, as far apart as possible; the evidence
says how many. More cost more and have shown no other dimension."""
APART = 1e-3
"""Zeros closer together than this part of the radius are one."""
ASTRAY = 0.4
"""A zero that is followed inwards must stay this near to the ray, in radii; else it has gone over to another branch."""
UNDECIDED = 0
"""Stands for the dimension of a branch whose zeros could not be classified."""
SIGNAL = 1e-10
"""g must be this large at random points of a sphere for a zero in double precision to mean something; a smaller sphere
is left out, and the evidence says so. Where all are, the mobility is not decided."""
DEPTH = 2
"""How often a zero may lie where branches meet and hand over to a neighbour, on a sphere ten times smaller."""
SPREAD = 0.05
"""Directions to neighbours count as spanning a further dimension if their spread there is this part of the distance:
rounding and the curvature of a branch over a tenth of the radius stay below it."""
CLASSIFIED = 3
"""Zeros of each kind whose branch gets its dimension."""
SHAKY = 1e-7
"""|g|, relative, of zeros around one on a shaky branch: they are double, and known to half the digits only."""
LEAST_SCALE = 1e-12
"""The size of g around a zero is taken to be at least this."""


@dataclass(frozen=True)
class BranchPoint:
    """A point of a branch: its dimension, instantaneous freedoms, displacements in 60 digits, and in words."""

    dimension: int
    instantaneous: int
    q: Array
    text: str


class UndecidedError(ArithmeticError):
    """The configuration is singular, and double precision does not tell the dimension of the motion through it."""


@dataclass(frozen=True)
class Branches:
    """Dimensions of the branches, ascending, how they were found, and a point of each."""

    dimensions: tuple[int, ...]
    evidence: tuple[str, ...]
    witnesses: tuple[Witness, ...]


def find_branches(coarse: ClosureVariety, fine: ClosureVariety, here: Local, forms: Array) -> Branches:
    """The dimensions of all branches that were found through `here`; none means an isolated configuration."""
    reduced = ReducedClosure(coarse, here)
    starts, in_cone = _starts(here.dof, forms)
    found: dict[tuple[int, bool], BranchPoint] = {}
    known: set[int] = set()
    evidence = []
    left_out = []
    for radius in RADII:
        scale = _scale(reduced, starts, radius)
        if not scale > SIGNAL:
            left_out.append(
                f"no zeros were looked for on a sphere of radius {radius:g}: the redundant equations are of size "
                f"{scale:.0e} there, which double precision does not tell from zero"
            )
            continue
        zeros = _representatives(coarse, reduced.zeros_on_sphere(radius * starts, radius, scale), radius, scale)
        kept, reached = _followed(reduced, starts, zeros, radius)
        evidence.append(
            f"zeros on a sphere of radius {radius:g} from {len(starts)} starts, {in_cone} of them "
            f"directions of the second-order cone on linear slices: {len(zeros.u)} kept for their variety, "
            f"{len(kept)} of them lead to the configuration (followed down to {reached:.1e})"
        )
        groups = _kinds(coarse, kept)
        for kind, point in _dimensions(coarse, fine, groups, radius=radius, known=known).items():
            found.setdefault(kind, point)
        known |= set(groups)
    points = [found[kind] for kind in sorted(found) if kind[0] != UNDECIDED]
    if points:
        if len(points) < len(found):
            left_out.append("another zero could not be classified: a branch of a further dimension is not excluded")
    elif found:
        raise UndecidedError(
            "real motion leads away from this singular configuration, but in double precision its "
            "dimension cannot be told"
        )
    if not evidence:
        raise UndecidedError("the reduced closure is too small on all spheres to find its zeros in double precision")
    witnesses = (Witness(coarse.network, "branch", p.dimension, p.instantaneous, p.q) for p in points)
    texts = (*evidence, *left_out, *(p.text for p in points))
    return Branches(tuple(sorted({p.dimension for p in points})), texts, tuple(witnesses))


def _starts(dof: int, forms: Array) -> tuple[Array, int]:
    """(unit directions, how many of them are in the second-order cone); without quadratic forms more random ones."""
    generator = np.random.default_rng(SEED + 1)
    cone = cone_directions(forms, generator) if len(forms) else np.zeros((0, dof))
    count = 12 + 4 * dof if len(cone) else 32 + 8 * dof
    random = generator.normal(size=(count, dof))
    return np.concatenate([random / np.linalg.norm(random, axis=1)[:, None], cone]), len(cone)


def _representatives(variety: ClosureVariety, values: Values, radius: float, scale: float) -> Values:
    """Of the zeros with equally many instantaneous freedoms at most eight, as far apart as possible."""
    index = is_zero(values, radius, scale)
    freedoms = np.array([local_at(variety, values.q[i]).dof for i in index], dtype=int)
    chosen: list[int] = []
    for kind in np.unique(freedoms):
        members = index[freedoms == kind]
        picked = [members[0]]
        distance = np.linalg.norm(values.u[members] - values.u[members[0]], axis=1)
        while len(picked) < KEPT and distance.max() > APART * radius:
            picked.append(members[int(distance.argmax())])
            distance = np.minimum(distance, np.linalg.norm(values.u[members] - values.u[picked[-1]], axis=1))
        chosen += picked
    return values.at(np.array(chosen, dtype=int))


def _followed(reduced: ReducedClosure, starts: Array, zeros: Values, radius: float) -> tuple[Array, float]:
    """(displacements of those zeros whose branch leads to the configuration, radius followed down to)."""
    kept, now = zeros.q, zeros
    for _ in range(INWARDS):
        scale = _scale(reduced, starts, radius / 2)
        if not len(kept) or scale < SIGNAL:
            break
        radius /= 2
        guess = reduced.here.q + (now.q - reduced.here.q) / 2
        inner = reduced.zeros_on_sphere(now.u / 2, radius, scale, guess=guess)
        index = is_zero(inner, radius, scale)
        index = index[np.linalg.norm(inner.u[index] - now.u[index] / 2, axis=1) < ASTRAY * radius]
        kept, now = kept[index], inner.at(index)
    return kept, radius


def _scale(reduced: ReducedClosure, starts: Array, radius: float) -> float:
    values: Values = reduced.evaluate(radius * starts[:40])
    return float(np.median(np.abs(values.g[values.solved]).max(axis=1))) if values.solved.any() else 0.0


def _kinds(coarse: ClosureVariety, zeros: Array) -> dict[int, list[Array]]:
    """Number of instantaneous freedoms -> the zeros that have it."""
    groups: dict[int, list[Array]] = {}
    for q in zeros:
        groups.setdefault(local_at(coarse, q).dof, []).append(q)
    return groups


def _dimensions(
    coarse: ClosureVariety,
    fine: ClosureVariety,
    groups: Mapping[int, Sequence[Array]],
    *,
    radius: float,
    known: Set[int],
) -> dict[tuple[int, bool], BranchPoint]:
    """(dimension, whether shaky) of the branch at each kind of zero -> how it was decided.

    Of `known` kinds one zero is enough. A shaky branch and one that is not may have the same dimension.
    """
    found: dict[tuple[int, bool], BranchPoint] = {}
    for kind, points in sorted(groups.items()):
        for q in points[:: max(1, len(points) // CLASSIFIED)][: 1 if kind in known else CLASSIFIED]:
            point = _dimension_at(coarse, fine, q, radius)
            found.setdefault((point.dimension, point.instantaneous > point.dimension), point)
    return found


def _dimension_at(
    coarse: ClosureVariety, fine: ClosureVariety, q: Array, radius: float, *, depth: int = 0
) -> BranchPoint:
    """The configuration space at a generic point of a branch."""
    there, point, residual = local_refined(coarse, fine, q)
    instantaneous = there.dof
    gap = f"singular values {there.gap[0]:.1e} | {there.gap[1]:.1e}"
    manifold = f"a branch of dimension {instantaneous}: at a point of it (closed to {residual:.0e})"
    if there.rank == coarse.rows:
        text = f"{manifold} the closure equations are independent; {gap}"
        return BranchPoint(instantaneous, instantaneous, point, text)
    steps = tuple(radius / k for k in (10, 30, 100))
    trials = [vanishes(coarse, fine, there, direction, steps=steps) for direction in flatten(instantaneous, 2)]
    if all(trial.closed for trial in trials):
        text = f"{manifold} finite motions along all {instantaneous} instantaneous freedoms close in 60 digits; {gap}"
        return BranchPoint(instantaneous, instantaneous, point, text)
    zeros = _zeros_around(coarse, there, radius / 10)
    likely = sorted(zeros, key=lambda q: float(coarse_rank(coarse, q)), reverse=True)[:3]
    fewest = min(((local_refined(coarse, fine, q)[0].dof, k) for k, q in enumerate(likely)), default=(instantaneous, 0))
    if depth < DEPTH and fewest[0] < instantaneous:
        # the zero lies where branches meet; a neighbour shows one of them
        return _dimension_at(coarse, fine, likely[fewest[1]], radius / 10, depth=depth + 1)
    dimension = _spanned(zeros, there, radius / 10)
    if dimension and dimension == _spanned(_zeros_around(coarse, there, radius / 30), there, radius / 30):
        text = f"a branch of dimension {dimension}, shaky all along: {instantaneous} instantaneous freedoms on it"
        return BranchPoint(dimension, instantaneous, point, text)
    return BranchPoint(UNDECIDED, instantaneous, point, "a zero on it could not be classified")


def _zeros_around(variety: ClosureVariety, there: Local, radius: float) -> Array:
    """Displacements of zeros of the closure on a sphere around a zero."""
    starts = np.array(list(flatten(there.dof, 16 + 4 * there.dof)))
    reduced = ReducedClosure(variety, there)
    scale = max(_scale(reduced, starts, radius), LEAST_SCALE)
    values = reduced.zeros_on_sphere(radius * starts, radius, scale)
    return np.asarray(values.q[is_zero(values, radius, scale, SHAKY)])


def _spanned(zeros: Array, there: Local, radius: float) -> int:
    """Dimension of the space of directions from a zero to those around it."""
    if not len(zeros):
        return 0
    directions = (zeros - there.q) @ there.kernel / radius
    spread = np.linalg.svd(directions, compute_uv=False) / np.sqrt(len(zeros))
    return int((spread > SPREAD).sum())


def zeros_nearby(
    coarse: ClosureVariety, here: Local, forms: Array, *, off: float, kind: Callable[[Array], int]
) -> dict[int, list[Array]]:
    """Kind -> displacements of zeros of the reduced closure on the larger sphere, each the farthest from those before.

    They may be `off` by so much. Whether their branches lead to the configuration is not looked at.
    """
    reduced = ReducedClosure(coarse, here)
    starts, _ = _starts(here.dof, forms)
    radius = RADII[0]
    scale = _scale(reduced, starts, radius)
    if not scale > off:
        return {}
    values = reduced.zeros_on_sphere(radius * starts, radius, scale)
    zeros = values.q[is_zero(values, radius, scale, off / scale)]
    kinds = np.array([kind(q) for q in zeros], dtype=int)
    chosen: dict[int, list[Array]] = {}
    for one in np.unique(kinds):
        own = zeros[kinds == one]
        distance, farthest = np.full(len(own), np.inf), 0
        while distance[farthest] > APART * radius and len(chosen.get(one, ())) < 2 * KEPT:
            chosen.setdefault(int(one), []).append(own[farthest])
            distance = np.minimum(distance, np.linalg.norm(own - own[farthest], axis=1))
            farthest = int(np.argmax(distance))
    return chosen

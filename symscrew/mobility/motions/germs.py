"""Branches of one part of a mechanism through the configuration, told apart.

    Witness of the part --zeros on a small sphere--> points of known dimension --tangents, paths--> Germs, one a branch

Zeros of the reduced closure on a sphere around the configuration belong to one branch if they have the same tangent
space, or if a path of zeros of the same rank leads from one to the other on the sphere. A branch goes through the
configuration, so a zero and the one opposite count as one where the line between them is tangent to both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from symscrew.mobility.finite import (
    ClosureVariety,
    Local,
    ReducedClosure,
    Witness,
    cone_directions,
    is_zero,
    local_at,
    quadratic_forms,
    solve_dependent,
)
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.one_equation import sheets_of_one_equation
from symscrew.mobility.motions.sheets import on_one_sheet
from symscrew.mobility.screw_systems import null_space

Array = np.ndarray[Any, Any]

RADIUS = 0.02
"""Of the sphere, in units of the mechanism's size: the smaller one of the search for branches."""
INWARDS = 4
"""Times that a zero is followed to half the radius: to 1/16, where what passes by is left behind, and tangents are
right to a thousandth."""
FOLLOWED = 1e-6
"""Of g's size on the sphere: what may be left of g at a zero that is followed inwards. At 1/16 of the radius g is 1e-7
where it vanishes to second order, 1e-9 to third order, in units of the mechanism's size, and its rounding of 1e-15 is
more than the 1e-9 of it to which a zero on the first sphere is held."""
ASTRAY = 0.4
"""A zero that is followed inwards must stay this near to the ray, in radii."""
STARTS, PER_FREEDOM = 24, 8
"""Random starts beside the directions of the second-order cone."""
SEED = 20230811
"""Of the starts: always the same, so that results repeat."""
APART = 0.05
"""Sine of the angle between tangent spaces that are different: ten times what curvature makes of one branch over a
sphere that is a fiftieth of the mechanism."""
ONE_LINE = 0.1
"""The same for lines from the configuration to points at a thousandth of the mechanism: half-branches of a cusp, which
leave like t^(3/2), are still that much apart there."""
SAME_ZERO = 1e-3
"""Distance, in radii, below which zeros are one: they are found to 1e-9, tangent branches are further apart."""
MOST = 8
"""Zeros of branches of two and more dimensions that are grouped, as far apart as possible: paths between them cost."""
MISSED = 3
"""Of two zeros: nearest others to which no path led, after which no further ones are tried between them."""
BETWEEN = 0.2
"""A zero belongs to the nearer of two tangent spaces if its distance is this part of that from the other one."""
AT_REST = 1e-7
"""Of a unit motion: what is left of a joint that does not move along a branch, at points known to 1e-9."""
STEPS = 10
"""Steps of a path between two zeros on the sphere."""
TURNING = 3.0
"""Angle by which the tangent space may turn along such a step, over the angle of the step seen from the configuration:
about 1 on a cone. Branches that cross at a larger angle than this, 0.3 rad for a step of a tenth, are told apart."""
STRIDES = (0.1, 0.03, 0.01)
"""Sizes of the finite motion from a smooth point to a generic one: the largest that can be solved for."""


@dataclass(frozen=True)
class Germ:
    """A branch of a part: its dimension, two points on it near the configuration, and the directions of those seen.

    `points`: displacements, the generic one first, then one nearer to the configuration. `directions`: unit vectors
    from the configuration to zeros near it, in the part's columns. `cusp`: both half-branches leave to one side.
    A branch that has more instantaneous freedoms than real ones all along has no points: its tangents are not known.
    """

    network: Network
    dimension: int
    points: tuple[Array, ...]
    directions: Array
    cusp: bool = False


def germs_of(witnesses: Sequence[Witness]) -> tuple[tuple[Germ, ...], str]:
    """(the branches of the part that the witnesses are of, what limits this); if isolated, one of dimension 0."""
    network = witnesses[0].network
    kinds = {w.kind for w in witnesses}
    if kinds == {"smooth"}:
        return (_smooth(network, witnesses[0].dimension),), ""
    origin = np.zeros(network.freedoms)
    if kinds == {"isolated"}:
        return (Germ(network, 0, (origin,), np.zeros((0, network.freedoms))),), ""
    dimensions = {w.instantaneous: w.dimension for w in witnesses if w.instantaneous == w.dimension}
    found = tuple(_branches(network, dimensions))
    nothing = np.zeros((0, network.freedoms))
    shaky = [Germ(network, w.dimension, (), nothing) for w in witnesses if w.instantaneous != w.dimension]
    if shaky:
        return (*found, *shaky), "of a branch that is shaky all along there may be several"
    missing = set(dimensions) - {germ.dimension for germ in found}
    return found, f"of dimension {', '.join(map(str, sorted(missing)))} none could be followed" if missing else ""


def _smooth(network: Network, dimension: int) -> Germ:
    variety = ClosureVariety(network)
    generator = np.random.default_rng(SEED)
    points = []
    if not (network.chords or network.ties):
        points = [0.3 * generator.normal(size=network.freedoms) for _ in range(2)]
        return Germ(network, dimension, tuple(points), np.eye(network.freedoms))
    if not dimension:  # nothing to follow; a value that is not zero in 60 digits may be in doubles
        return Germ(network, 0, (np.zeros(network.freedoms),), np.zeros((0, network.freedoms)))
    here = local_at(variety, np.zeros(variety.columns), rank=variety.columns - dimension)
    for _ in range(2):
        direction = generator.normal(size=dimension)
        direction /= np.linalg.norm(direction) or 1.0
        solved = (solve_dependent(variety, here, here.kernel @ (s * direction)) for s in STRIDES)
        points.append(next((q for q in solved if q is not None), here.q))
    return Germ(network, dimension, tuple(points), here.kernel.T)


def _branches(network: Network, dimensions: dict[int, int]) -> Iterator[Germ]:
    """The branches at the configuration; `dimensions`: of branches by the instantaneous freedoms on them."""
    variety = ClosureVariety(network)
    motions = null_space(network.loop_rows(), network.freedoms).basis
    here = local_at(variety, np.zeros(variety.columns), motions=motions)
    yield from germs_at(variety, here, dimensions)


def germs_at(variety: ClosureVariety, here: Local, dimensions: Mapping[int, int]) -> Iterator[Germ]:
    """The branches at any configuration: zeros on a sphere around it, grouped.

    Args:
        variety: of the part.
        here: the configuration, with its rank.
        dimensions: of branches by the instantaneous freedoms on them.
    """
    network, reduced = variety.network, ReducedClosure(variety, here)
    forms = quadratic_forms(variety, here)
    outer, inner = _zeros(reduced, forms)
    known: list[_Zero] = []
    for q, near in zip(outer, inner, strict=True):
        there = local_at(variety, q)
        if there.dof in dimensions:
            line = (near - here.q) / np.linalg.norm(near - here.q)
            tangent = local_at(variety, near, rank=there.rank).kernel  # where a branch has hardly bent away
            resting = np.flatnonzero(np.abs(there.kernel).max(axis=1, initial=0.0) < AT_REST)
            known.append(_Zero(dimensions[there.dof], q, near, tangent, line, frozenset(resting.tolist())))
    yield from _curves(network, [zero for zero in known if zero.dimension == 1])
    for dimension in sorted({zero.dimension for zero in known} - {1}):
        zeros = [zero for zero in known if zero.dimension == dimension]
        for group in _of_one_equation(reduced, forms, zeros) or _grouped(reduced, _far_apart(zeros)):
            lines = np.array([zero.line for zero in group])
            yield Germ(network, dimension, (group[0].q, group[0].near), lines)


def _of_one_equation(reduced: ReducedClosure, forms: Array, zeros: list[_Zero]) -> list[list[_Zero]]:
    """The zeros of each branch where one equation tells how many there are; empty where it does not.

    Zeros near to both of two tangent spaces are left out.
    """
    if zeros[0].dimension != reduced.here.dof - 1:
        return []
    normals = sheets_of_one_equation(reduced, forms)
    if normals is None:
        return []
    if not len(normals):
        return [zeros]
    off = [np.abs(normals @ (reduced.here.kernel.T @ zero.line)) for zero in zeros]
    groups = [[zero for zero, d in zip(zeros, off, strict=True) if d[k] < BETWEEN * d[1 - k]] for k in range(2)]
    return groups if all(groups) else []


def _grouped(reduced: ReducedClosure, zeros: list[_Zero]) -> list[list[_Zero]]:
    """Zeros of one branch together: of one tangent space, or, on a cone, linked by a path; the nearest pairs first."""
    groups = _joined([[zero] for zero in zeros], reduced, _same)
    flat = [group for group in groups if _flat(group)]
    curved = [group for group in groups if not _flat(group)]
    return flat + _joined(curved, reduced, _linked)


def _joined(
    groups: list[list[_Zero]], reduced: ReducedClosure, related: Callable[[ReducedClosure, _Zero, _Zero], bool]
) -> list[list[_Zero]]:
    zeros = [zero for group in groups for zero in group]
    missed: dict[int, int] = {id(zero): 0 for zero in zeros}
    for one, two in sorted(combinations(zeros, 2), key=lambda pair: (_unlike(*pair), _distance(reduced, *pair))):
        first, second = (next(g for g in groups if any(z is zero for z in g)) for zero in (one, two))
        if first is second or min(missed[id(one)], missed[id(two)]) >= MISSED:
            continue
        if related(reduced, one, two):
            groups = [g for g in groups if g is not first and g is not second] + [first + second]
        else:
            missed[id(one)] += 1
            missed[id(two)] += 1
    return groups


def _unlike(one: _Zero, two: _Zero) -> bool:
    """Whether different columns are at rest at the zeros: they are hardly on one branch, and looked at last."""
    return one.resting != two.resting


def _flat(group: list[_Zero]) -> bool:
    """Whether zeros of one tangent space lie in several lines through the configuration: not so on a cone."""
    return any(abs(float(one.line @ two.line)) < 1 - ONE_LINE**2 for one, two in combinations(group, 2))


def _distance(reduced: ReducedClosure, one: _Zero, two: _Zero) -> float:
    a, b = one.q - reduced.here.q, two.q - reduced.here.q
    return float(min(np.linalg.norm(a - b), np.linalg.norm(a + b)))


@dataclass(frozen=True)
class _Zero:
    """A point of a branch on the sphere, one of the same branch nearer in, the tangents there, the line to it.

    `resting`: columns that do not move at the point on the sphere.
    """

    dimension: int
    q: Array
    near: Array
    tangent: Array
    line: Array
    resting: frozenset[int]


def _curves(network: Network, zeros: list[_Zero]) -> Iterator[Germ]:
    """Half-branches put together: opposite ones on one line; two that leave to the same side are a cusp."""
    left = list(zeros)
    while left:
        first = left.pop(0)
        along = [zero for zero in left if 1 - float(zero.line @ first.line) ** 2 < ONE_LINE**2]
        opposite = [zero for zero in along if zero.line @ first.line < 0]
        candidates = opposite or along
        other = min(candidates, key=lambda zero: _turned(first, zero), default=None)
        lines = [first.line] if other is None else [first.line, other.line]
        left = [zero for zero in left if zero is not other]
        yield Germ(network, 1, (first.q, first.near), np.array(lines), cusp=other is not None and not opposite)


def _turned(one: _Zero, two: _Zero) -> float:
    return 1 - abs(float(one.tangent[:, 0] @ two.tangent[:, 0]))


def _far_apart(zeros: list[_Zero]) -> list[_Zero]:
    if not zeros:
        return []
    chosen = [zeros[0]]
    distance = np.array([np.linalg.norm(zero.q - zeros[0].q) for zero in zeros])
    while len(chosen) < min(MOST, len(zeros)):
        chosen.append(zeros[int(distance.argmax())])
        distance = np.minimum(distance, [np.linalg.norm(zero.q - chosen[-1].q) for zero in zeros])
    return chosen


def _zeros(reduced: ReducedClosure, forms: Array) -> tuple[Array, Array]:
    """Displacements of zeros on the sphere that lead to the configuration, and of the same near to it."""
    generator = np.random.default_rng(SEED)
    dof = reduced.here.dof
    random = generator.normal(size=(STARTS + PER_FREEDOM * dof, dof))
    cone = cone_directions(forms, generator) if len(forms) else np.zeros((0, dof))
    starts = np.concatenate([random / np.linalg.norm(random, axis=1)[:, None], cone])
    radius = RADIUS
    scale = _scale(reduced, starts, radius)
    now = reduced.zeros_on_sphere(radius * starts, radius, scale)
    now = now.at(is_zero(now, radius, scale))
    chosen: list[int] = []
    for k, u in enumerate(now.u):
        if all(np.linalg.norm(u - now.u[i]) > SAME_ZERO * radius for i in chosen):
            chosen.append(k)
    now = now.at(np.array(chosen, dtype=int))
    kept = now.q
    for _ in range(INWARDS):
        if not len(kept):
            break
        radius /= 2
        scale = _scale(reduced, starts, radius)
        guess = reduced.here.q + (now.q - reduced.here.q) / 2
        after = reduced.zeros_on_sphere(now.u / 2, radius, scale, guess=guess)
        index = is_zero(after, radius, scale, FOLLOWED)
        index = index[np.linalg.norm(after.u[index] - now.u[index] / 2, axis=1) < ASTRAY * radius]
        kept, now = kept[index], after.at(index)
    return kept, now.q


def _scale(reduced: ReducedClosure, starts: Array, radius: float) -> float:
    values = reduced.evaluate(radius * starts[:40])
    return float(np.median(np.abs(values.g[values.solved]).max(axis=1))) if values.solved.any() else 1.0


def _same(reduced: ReducedClosure, one: _Zero, two: _Zero) -> bool:
    """Whether two zeros have the same tangent space, in which they lie; where unlike joints move, on one sheet, too."""
    cosines = np.linalg.svd(one.tangent.T @ two.tangent, compute_uv=False)
    line = two.near - one.near
    across = line - one.tangent @ (one.tangent.T @ line)
    near = np.linalg.norm(across) < APART * np.linalg.norm(one.near - reduced.here.q)
    if not near or cosines.min(initial=1.0) < np.sqrt(1 - APART**2):
        return False
    if not _unlike(one, two):  # sheets that touch and on which the same moves are not told apart
        return True
    return on_one_sheet(reduced.variety, reduced.here, one.q, two.q, rank=len(one.q) - one.tangent.shape[1])


def _linked(reduced: ReducedClosure, one: _Zero, two: _Zero) -> bool:
    """Whether a path of zeros leads from one to the other, or to what is opposite of it."""
    here = reduced.here
    u, v = (here.kernel.T @ (zero.q - here.q) for zero in (one, two))
    return any(_path(reduced, u, end, one.tangent.shape[1]) for end in (v, -v))


def _path(reduced: ReducedClosure, u: Array, v: Array, dof: int) -> bool:
    """Whether zeros of the same rank lead from one direction to the other on the sphere, in small steps.

    Where branches cross, the tangent space jumps; along one it turns about as far as the step does.
    """
    scale = _scale(reduced, np.concatenate([np.eye(len(u)), -np.eye(len(u))]), RADIUS)
    now, stride = u, float(np.linalg.norm(v - u)) / STEPS
    tangent: Array | None = None
    for _ in range(2 * STEPS):
        left = v - now
        if np.linalg.norm(left) < APART * RADIUS:
            return True
        step = left * min(1.0, stride / float(np.linalg.norm(left)))
        guess = (now + step) / np.linalg.norm(now + step) * RADIUS
        found = reduced.zeros_on_sphere(guess[None], RADIUS, scale)
        if not len(is_zero(found, RADIUS, scale)):
            return False
        there = local_at(reduced.variety, found.q[0])
        moved = float(np.linalg.norm(found.u[0] - now))
        if there.dof != dof or not stride / 10 < moved < 3 * stride:
            return False
        if tangent is not None:
            cosine = np.linalg.svd(tangent.T @ there.kernel, compute_uv=False).min(initial=1.0)
            if cosine < np.cos(TURNING * moved / RADIUS):
                return False
        now, tangent = found.u[0], there.kernel
    return False

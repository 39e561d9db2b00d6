"""Special geometry close to the one typed: the smallest change of joints with which loops keep closed along a motion.

    singular values of the closure, small but not zero --Gauss-Newton in the joints' places and axes--> special geometry

The unknowns are the places and axes of all joints, and configurations along the motions that nearly close. The
equations are the closure of all loops in each of them, or, where no finite motion nearly closes, the loss of rank in
the reference configuration alone. They are solved with the least change, residuals in 60 digits; whether the geometry
found really moves is left to the ordinary analysis.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from symscrew.algebra import CONTEXT, Vector, cross, dot, scale
from symscrew.mobility.finite.local_solutions import Local, flatten, local_at, solve_dependent
from symscrew.mobility.finite.variety import DIGITS_60, Array, ClosureVariety
from symscrew.mobility.joint_network import Edge, Network

NEAR = 1e-4
"""Relative singular values of the closure below this, which are not zero, are looked at: numbers of six digits leave
1e-6 of what vanishes as meant. Above it nothing is said, and nothing is concluded."""
STEP = 0.3
"""Size of the finite motions, in units of the mechanism's size and in radians: large enough that what a motion needs
at higher order shows, small enough that Newton's method solves it."""
MOTIONS = 8
"""Finite motions along which the loops are to close, both ways each: more conditions than any linkage has numbers."""
CLOSES = 1e4
"""A finite motion nearly closes if it is off by less than this times the small singular value: of order one times it
where the motion exists as meant, of the order of the step squared where it does not."""
CUT_OFF = 30.0
"""Singular values of the conditions below so many times the small one of the closure are rounding as typed."""
ROUNDS = 14
"""Steps of Gauss-Newton: linear with the ratio of the distance, so a handful for doubles and a dozen for six digits."""
CONVERGED = 1e-40
"""Residual at which it has ended: far below what ranks take for zero, far above rounding of 60 digits."""
DIFFERENCE = 1e-6
"""Half the step of central differences in doubles: right to ten digits, of which each round gains as many."""
FARTHEST = 1e-3
"""Of the mechanism's size: farther geometry is another mechanism."""


@dataclass(frozen=True)
class NearGeometry:
    """The special geometry: its network, the largest change of a joint [1, the mechanism's size], and of which.

    `moves`: found from finite motions that close; else only the rank in the reference configuration is lost.
    """

    network: Network
    distance: float
    changes: tuple[tuple[str, float], ...]
    moves: bool


def nearest_special(network: Network, rank: int) -> NearGeometry | None:
    """The nearest geometry in which the closure loses rank; None where no singular value is small, or none found."""
    if not network.chords or not rank:
        return None
    coarse = ClosureVariety(network)
    values = np.linalg.svd(coarse.evaluate(np.zeros((1, coarse.columns)))[1][0], compute_uv=False)
    fewer = int((values > NEAR * values[0]).sum())
    if fewer >= rank or not fewer:
        return None
    here = local_at(coarse, np.zeros(coarse.columns), rank=fewer)
    noise = max(float(values[fewer]), 1e-15)
    points = _motions(coarse, here, noise)
    if not points:
        return None
    return _solved(network, points, fewer, noise)


def _motions(coarse: ClosureVariety, here: Local, noise: float) -> list[Array]:
    """Configurations along finite motions that nearly close; empty where one does not."""
    points = []
    for k, direction in enumerate(flatten(here.dof, MOTIONS)):
        for size in (STEP * (k + 1) / MOTIONS, -STEP * (k + 1.5) / MOTIONS):  # all different: one freedom has one line
            q = solve_dependent(coarse, here, here.q + here.kernel @ (size * direction))
            if q is None or np.linalg.norm(coarse.residual(q)) > CLOSES * noise:
                return []
            points.append(q)
    return points


def _solved(network: Network, points: list[Array], rank: int, noise: float) -> NearGeometry | None:
    slots = _slots(network)
    z = np.array([CONTEXT.zero] * sum(len(s) * 3 for s in slots.values()), dtype=object)
    q = [np.array([CONTEXT.mpf(float(c)) for c in point], dtype=object) for point in points]
    best, changed, rough = float("inf"), network, noise
    steps: list[tuple[Array, Array, Array]] = []
    for attempt in range(ROUNDS):
        changed = _changed(network, slots, z)
        fine = ClosureVariety(changed, DIGITS_60)
        residuals = [fine.residual(point).astype(float) for point in q]
        size = max(float(np.linalg.norm(r)) for r in residuals)
        if size < CONVERGED:
            break
        if attempt > 2 and size > best / 2:
            return None
        if attempt < 3:
            steps = _linearised(changed, [p.astype(float) for p in q], rank)
            rough = max(1e-11, rough if attempt == 0 else size)
        best = size
        conditions = np.concatenate([left @ by_z for left, _, by_z in steps])
        missing = np.concatenate([left @ r for (left, _, _), r in zip(steps, residuals, strict=True)])
        cut = CUT_OFF * max(rough, 1e-10)
        dz = -np.linalg.lstsq(conditions, missing, rcond=min(0.1, cut))[0]
        z = z + np.array([CONTEXT.mpf(float(c)) for c in dz], dtype=object)
        for k, ((_, inverse, by_z), r) in enumerate(zip(steps, residuals, strict=True)):
            q[k] = q[k] - np.array([CONTEXT.mpf(float(c)) for c in inverse @ (r + by_z @ dz)], dtype=object)
    else:
        return None
    changes = _sizes(network, changed)
    distance = max(size for _, size in changes)
    return NearGeometry(changed, distance, changes, True) if distance < FARTHEST else None


def _linearised(network: Network, points: list[Array], rank: int) -> list[tuple[Array, Array, Array]]:
    """(redundant rows, inverse of the others, derivative by the geometry) of the closure at each point."""
    slots = _slots(network)
    count = sum(len(s) * 3 for s in slots.values())
    coarse, batch = ClosureVariety(network), np.array(points)
    columns = []
    for k in range(count):
        ends = []
        for sign in (1, -1):
            z = np.array([CONTEXT.zero] * count, dtype=object)
            z[k] = CONTEXT.mpf(sign * DIFFERENCE)
            ends.append(ClosureVariety(_changed(network, slots, z)).evaluate(batch)[0])
        columns.append((ends[0] - ends[1]) / (2 * DIFFERENCE))
    by_z = np.stack(columns, axis=2)
    places = [local_at(coarse, point, rank=rank) for point in points]
    return [(place.stresses, place.inverse, by_z[k]) for k, place in enumerate(places)]


def _slots(network: Network) -> dict[str, tuple[int, ...]]:
    """Joint -> what is changed of it, three numbers each: -1 its place, k its axis k (a turn)."""
    result = {}
    for name, edge in network.edges.items():
        axes = sorted({motion.axis or 0 for motion, _ in edge.motions if motion.single})
        result[name] = (-1, *axes)
    return result


def _changed(network: Network, slots: dict[str, tuple[int, ...]], z: Array) -> Network:
    edges, start = {}, 0
    for name, edge in network.edges.items():
        given = {slot: z[start + 3 * i : start + 3 * i + 3] for i, slot in enumerate(slots[name])}
        start += 3 * len(slots[name])
        edges[name] = _moved_edge(edge, given)
    return replace(network, edges=edges)


def _moved_edge(edge: Edge, given: dict[int, Array]) -> Edge:
    if not any(any(part) for part in given.values()):
        return edge
    x, y, z = (a + b for a, b in zip(edge.point, given[-1], strict=True))
    point: Vector = (x, y, z)
    screws = []
    for motion, column in edge.motions:
        own = edge.screws[column - edge.start : column - edge.start + motion.freedom]
        if motion.spherical:
            screws += [(*s[:3], *cross(point, (s[0], s[1], s[2]))) for s in own]
            continue
        turned = own[0][:3] if motion.turns else own[0][3:]
        axis: Vector = (turned[0], turned[1], turned[2])
        turn = given[motion.axis or 0]
        u, v, w = (a + b for a, b in zip(axis, cross((turn[0], turn[1], turn[2]), axis), strict=True))
        axis = scale(1 / CONTEXT.sqrt(dot((u, v, w), (u, v, w))), (u, v, w))
        if not motion.turns:
            screws.append((CONTEXT.zero, CONTEXT.zero, CONTEXT.zero, *axis))
            continue
        pitch = dot((own[0][0], own[0][1], own[0][2]), (own[0][3], own[0][4], own[0][5]))
        moment = cross(point, axis)
        screws.append((*axis, *(m + pitch * a for m, a in zip(moment, axis, strict=True))))
    return replace(edge, point=point, screws=tuple(screws))


def _sizes(before: Network, after: Network) -> tuple[tuple[str, float], ...]:
    """Joint -> the larger of how far its place has moved and its axes have turned, the largest first."""
    found = []
    for name, edge in before.edges.items():
        other = after.edges[name]
        size = max(abs(a - b) for a, b in zip(edge.point, other.point, strict=True))
        for motion, column in edge.motions:
            if motion.single:
                part = slice(0, 3) if motion.turns else slice(3, 6)
                a, b = (e.screws[column - edge.start][part] for e in (edge, other))
                size = max(size, *(abs(c - d) for c, d in zip(a, b, strict=True)))
        found.append((name, float(size)))
    return tuple(sorted(found, key=lambda pair: -pair[1]))

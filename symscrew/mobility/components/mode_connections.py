"""Which assembly modes of the reference are connected without a singularity: paths as witnesses.

    drives at rest --Newton from random starts--> assembly modes
    these, random configurations of the same sign --straight ways, projected on the closure--> road map --> paths

A path is followed in steps over which the passive joints' matrix changes by less than its smallest singular value, so
that it is not singular between them (Weyl), by its derivative and a bound of the second. Modes whose determinants
differ in sign have a singularity on every path. What the road map does not reach may still be connected. (C. Innocenti,
V. Parenti-Castelli, 1992: a planar platform goes from mode to mode without a singularity.)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from symscrew.mobility.components.real_configurations import CLOSED, CUT_OFF, real_configurations, wrapped
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import Network

Array = np.ndarray[Any, Any]

STARTS = 200
"""Random starts for the modes: of six modes of a planar platform each is met by five or more."""
NEWTON = 60
"""Steps from a start; those that have not closed the loops by then rarely do."""
NODES = 120
"""Random starts for the other configurations of the road map; half of those found have the sign of the reference."""
NEIGHBOURS = 8
"""Of each node, to which a straight way is tried."""
AT_ONCE = 48
"""Ways that are tried before it is looked which ones are still needed: so many cost little more than one."""
TURN = 0.02
"""Smallest singular value on a way; below it the way is given up. Regular poses have 0.05 to 1."""
LEFT = 0.3
"""The same as part of the least of modes that are given: those of a delta have 0.015."""
STRIDE = 0.15
"""Longest step of a path, rad or sizes of the mechanism."""
SAFE = 0.5
"""Part of s that the matrix may change by in a step: bounds are those of its beginning, and grow along it."""
NEAR = 1e-9
"""Relative singular value below which a space has no such direction."""
SAME = 1e-5
"""Bodies' poses that differ by less, in sizes of the mechanism, are the same mode: they are closed to 1e-12."""
DIFFERENCE = 1e-7
"""Displacement for the derivative of the closure's Jacobian: half the digits."""
MOST_STEPS = 250
"""Of a way; it is some five rad long."""
SIDEWAYS = 0.05
"""A way of which less than this part lies along the closure leads nowhere."""
ARRIVED = 1e-6
"""Distance to the end of a way that counts as none: the last step is as long as what is left."""
FAR = 2.0
"""Slides and ball joints start within this many sizes of the mechanism, or rad, from the reference."""
SEED = 20231009
"""Of starts and loops: always the same, so that results repeat."""


@dataclass(frozen=True)
class Mode:
    """An assembly mode: displacements, smallest singular value of the passive joints, sign of their determinant.

    `sign` is 0 where redundant rows leave no determinant. `corners`: displacements through which a path without a
    singularity leads from the reference, straight between them but for the closure; None where none was found.
    `margin`: smallest singular value on it; `trail`: displacements along it [points x columns].
    """

    q: Array
    smallest: float
    sign: int
    corners: tuple[Array, ...] | None
    margin: float
    trail: Array | None = None


@dataclass(frozen=True)
class ModeConnections:
    """The modes, that of the reference first; columns of the drives; how many ways of the road map are regular."""

    drives: tuple[int, ...]
    modes: tuple[Mode, ...]
    ways: int


def assembly_connections(network: Network, drives: Sequence[int] = ()) -> ModeConnections | str:
    """The assembly modes at the drives of the reference and paths between them, or why not."""
    drives = tuple(drives or network.driven)
    if not drives or not network.chords:
        return "not decided: no drives"
    paths = _Paths(network, drives)
    smallest = paths.smallest(np.zeros(paths.columns))
    if smallest < TURN:
        return "not decided: with the drives locked the reference can move, or is singular"
    found = paths.modes()
    signs = [paths.sign(q) for q in found]
    alike = [k for k, sign in enumerate(signs) if sign == signs[0]]
    ways: dict[tuple[int, int], Regular] = {}
    nodes = [found[k] for k in alike]
    if len(alike) > 1:
        others = [q for q in real_configurations(network, NODES) if paths.sign(q) == signs[0]]
        nodes += [q for q in others if paths.smallest(q) > TURN]
        ways = _joining(paths, np.array(nodes), len(alike))
    routes = _routes(ways)
    modes = []
    for k, q in enumerate(found):
        route = routes.get(alike.index(k)) if k in alike else None
        margin = min((ways[min(e), max(e)].margin for e in pairwise(route or ())), default=paths.smallest(q))
        corners = None if route is None else tuple(nodes[i] for i in route[1:-1])
        trail = None if route is None or len(route) < 2 else _trail(ways, route)
        modes.append(Mode(q, paths.smallest(q), signs[k], corners, margin if route is not None else 0.0, trail))
    return ModeConnections(drives, tuple(modes), len(ways))


def regular_ways(
    network: Network, drives: Sequence[int], modes: Sequence[Array], nodes: int = NODES
) -> dict[tuple[int, int], Array]:
    """Pairs of modes (first, other) with a way without a singularity: displacements along it [points x columns].

    Of modes whose determinants have the same sign the first that is not yet connected is joined with all that the road
    map reaches. Steps are too short to cross a singularity by bounds in doubles.
    """
    drives = tuple(drives)
    paths = _Paths(network, drives)
    paths.least = min([TURN, *(LEFT * paths.smallest(q) for q in modes)])
    others = [q for q in real_configurations(network, nodes) if paths.smallest(q) > paths.least]
    found: dict[tuple[int, int], Array] = {}
    for sign in (1, 0, -1):
        alike = [k for k, q in enumerate(modes) if paths.sign(q) == sign]
        if len(alike) < 2:
            continue
        points = np.array([*(modes[k] for k in alike), *(q for q in others if paths.sign(q) == sign)])
        ways = _joining(paths, points, len(alike))
        left = list(range(len(alike)))
        while left:
            first, routes = left[0], _routes(ways, left[0])
            for k in [k for k in left[1:] if k in routes]:
                found[alike[first], alike[k]] = _trail(ways, routes[k])
            left = [k for k in left if k not in routes]
    return found


@dataclass(frozen=True)
class Regular:
    """A way from node to node: the smallest singular value on it, displacements along it."""

    margin: float
    points: Array


def _joining(paths: _Paths, points: Array, modes: int) -> dict[tuple[int, int], Regular]:
    """Regular ways between points, short ones first and none within a piece, until the first points are one piece."""
    ways, pairs = dict[tuple[int, int], Regular](), paths.near(points)
    while pairs and not set(range(modes)) <= set(_routes(ways)):
        pieces = {k: min(_routes(ways, k)) for k in range(len(points))}
        pairs = [pair for pair in pairs if pieces[pair[0]] != pieces[pair[1]]]
        ways |= paths.regular(points, pairs[:AT_ONCE])
        pairs = pairs[AT_ONCE:]
    return ways


def _routes(ways: Mapping[tuple[int, int], Regular], first: int = 0) -> dict[int, tuple[int, ...]]:
    """Node -> the nodes from the first to it, with as few ways as possible."""
    routes: dict[int, tuple[int, ...]] = {first: (first,)}
    front = [first]
    while front:
        here = front.pop(0)
        for one, two in ways:
            if here in (one, two) and (there := two if one == here else one) not in routes:
                routes[there] = (*routes[here], there)
                front.append(there)
    return routes


def _trail(ways: Mapping[tuple[int, int], Regular], route: Sequence[int]) -> Array:
    """Displacements along ways from node to node."""
    legs = [ways[a, b].points if a < b else ways[b, a].points[::-1] for a, b in pairwise(route)]
    return np.concatenate(legs)


class _Paths:
    """Modes and paths of a mechanism with these drives."""

    def __init__(self, network: Network, drives: tuple[int, ...]) -> None:
        self.network, self.drives = network, list(drives)
        self.variety = ClosureVariety(network)
        self.columns = self.variety.columns
        self.passive = [c for c in range(self.columns) if c not in drives]
        hinges = {start for e in network.edges.values() for motion, start in e.motions if motion.revolute}
        self.turning = np.array([c in hinges for c in range(self.columns)])
        self.space = self._space()
        self.least = TURN

    def jacobian(self, q: Array) -> tuple[Array, Array]:
        """(screws, the closure's Jacobian)."""
        screws = self.variety.forward(q[None])[0]
        return screws[0], self.variety.jacobians(screws, q[None])[0]

    def smallest(self, q: Array) -> float:
        """The smallest singular value of the passive joints' matrix."""
        part = self.jacobian(q)[1][:, self.passive]
        if part.shape[0] < part.shape[1]:
            return 0.0
        return float(np.linalg.svd(part, compute_uv=False)[-1])

    def sign(self, q: Array) -> int:
        """The sign of its determinant; 0 where its columns span no space that is always the same."""
        if self.space is None:
            return 0
        return int(np.linalg.slogdet(self.space.T @ self.jacobian(q)[1][:, self.passive])[0])

    def _space(self) -> Array | None:
        """A basis of what the passive joints' matrix maps to at all configurations, if it has as many dimensions."""
        q = np.random.default_rng(SEED).normal(size=(2 * len(self.passive), self.columns))
        parts = self.variety.jacobians(self.variety.forward(q)[0], q)[:, :, self.passive]
        u, s, _ = np.linalg.svd(np.concatenate(list(parts), axis=1), full_matrices=False)
        return np.asarray(u[:, : len(self.passive)]) if (s > NEAR * s[0]).sum() == len(self.passive) else None

    def modes(self) -> list[Array]:
        """The reference and other configurations with the same drives, from random starts."""
        random = np.random.default_rng(SEED)
        q = random.uniform(-1, 1, size=(STARTS, self.columns)) * np.where(self.turning, np.pi, FAR)
        q[:, self.drives] = 0.0
        for _ in range(NEWTON):
            q = self._newton(q, limit=1.0)
        residuals, _ = self.variety.evaluate(q)
        found = [np.zeros(self.columns)]
        for end in q[np.abs(residuals).max(axis=1) < CLOSED]:
            if not any(self.same(end, other) for other in found):
                found.append(end)
        return found

    def _newton(self, q: Array, limit: float) -> Array:
        residuals, jacobians = self.variety.evaluate(q)
        step = (np.linalg.pinv(jacobians[:, :, self.passive], rcond=CUT_OFF) @ residuals[..., None])[..., 0]
        size = np.linalg.norm(step, axis=1, keepdims=True)
        q = q.copy()
        q[:, self.passive] -= step / np.maximum(1.0, size / limit)
        return wrapped(self.network, q)

    def same(self, one: Array, two: Array) -> bool:
        """Whether all bodies have the same poses."""
        poses = self.variety.forward(np.stack([one, two]))[1]
        return all(
            float(np.abs(part[0] - part[1]).max()) < SAME
            for name, pose in poses.items() if name in self.network.bodies for part in pose
        )  # fmt: skip

    def near(self, nodes: Array) -> list[tuple[int, int]]:
        """Pairs of near nodes, the nearest first."""
        gaps = np.linalg.norm(self._gap(nodes[:, None], nodes[None]), axis=2)
        order = np.argsort(gaps, axis=1)[:, 1 : NEIGHBOURS + 1]
        pairs = {(min(i, int(j)), max(i, int(j))) for i in range(len(nodes)) for j in order[i]}
        return sorted(pairs, key=lambda pair: (float(gaps[pair]), pair))

    def regular(self, nodes: Array, pairs: Sequence[tuple[int, int]]) -> dict[tuple[int, int], Regular]:
        """Those of the pairs with a regular way between them."""
        if not pairs:
            return {}
        ends = np.array([nodes[j] for _, j in pairs])
        q, margins = np.array([nodes[i] for i, _ in pairs]), np.full(len(pairs), np.inf)
        going, trails = np.ones(len(pairs), dtype=bool), [[start.copy()] for start in q]
        for _ in range(MOST_STEPS):
            now = np.flatnonzero(going)
            if not len(now):
                break
            q[now], smallest = self._stepped(q[now], self._gap(q[now], ends[now]))
            margins[now] = np.minimum(margins[now], smallest)
            for k in now:
                trails[k].append(q[k].copy())
            there = np.linalg.norm(self._gap(q[now], ends[now]), axis=1) < ARRIVED
            going[now] = ~there & (smallest > self.least)
        regular = np.flatnonzero(~going & (margins > self.least)).tolist()
        return {pairs[k]: Regular(float(margins[k]), np.array(trails[k])) for k in regular if self.same(q[k], ends[k])}

    def _gap(self, q: Array, end: Array) -> Array:
        """The way from q to the end, angles the shorter way round."""
        gap = end - q
        return np.where(self.turning, (gap + np.pi) % (2 * np.pi) - np.pi, gap)

    def _stepped(self, q: Array, left: Array) -> tuple[Array, Array]:
        """A step along the closure towards what is left of a way; smallest singular values, 0 where it fails."""
        screws = self.variety.forward(q)[0]
        jacobian = self.variety.jacobians(screws, q)
        smallest = np.linalg.svd(jacobian[:, :, self.passive], compute_uv=False)[:, -1]
        inverse = np.linalg.pinv(jacobian, rcond=CUT_OFF)
        rate = left - (inverse @ (jacobian @ left[..., None]))[..., 0]
        size = np.maximum(np.linalg.norm(rate, axis=1), ARRIVED**2)
        beside = q + DIFFERENCE * rate / size[:, None]
        slope = self.variety.jacobians(self.variety.forward(beside)[0], beside) - jacobian
        first = np.linalg.norm(slope[:, :, self.passive], ord=2, axis=(1, 2)) / DIFFERENCE
        second = _curvature(screws, rate / size[:, None])
        # first h + second h^2 / 2 = a part of the smallest singular value
        room = SAFE * smallest
        longest = np.minimum(STRIDE, 2 * room / (first + np.sqrt(first**2 + 2 * second * room)))
        after = q + rate * np.minimum(1.0, longest / size)[:, None]
        for _ in range(3):  # from a step this short two are enough
            residuals, jacobians = self.variety.evaluate(after)
            after = after - (np.linalg.pinv(jacobians, rcond=CUT_OFF) @ residuals[..., None])[..., 0]
        residuals, _ = self.variety.evaluate(after)
        moved = np.linalg.norm(after - q, axis=1)
        good = (np.abs(residuals).max(axis=1) < CLOSED) & (moved < 2 * longest)
        good &= size > SIDEWAYS * np.linalg.norm(left, axis=1)
        return after, np.where(good, smallest, 0.0)


def _curvature(screws: Array, direction: Array) -> Array:
    """Bounds of the second derivative of all screws along directions of length 1.

    dS_k = [T_k, S_k] with T_k the sum of S_j dq_j before k, so that |dS_k| <= sum |dq_j| |[S_j, S_k]|, and
    d^2 S_k = [T_k, [T_k, S_k]] + [sum of dS_j dq_j, S_k], with |[S, X]| <= (|omega| + |v|) |X|.
    """
    w, v = screws[:, :, None, :3], screws[:, :, None, 3:]
    x, y = screws[:, None, :, :3], screws[:, None, :, 3:]
    angular, linear = np.cross(w, x), np.cross(w, y) + np.cross(v, x)
    sizes = np.sqrt((angular**2).sum(axis=3) + (linear**2).sum(axis=3))
    weights = np.abs(direction)
    first = np.einsum("nj,njk->nk", weights, sizes)
    norms = np.linalg.norm(screws[:, :, :3], axis=2) + np.linalg.norm(screws[:, :, 3:], axis=2)
    carried = (weights * norms).sum(axis=1) * np.linalg.norm(first, axis=1)
    return np.asarray(carried + np.linalg.norm(norms, axis=1) * (weights * first).sum(axis=1))

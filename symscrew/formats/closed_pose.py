"""Where loops close: a Gauss-Newton iteration over all freedoms of a tree, from several starts.

    freedoms, ways to bodies, sides of loops --displacements--> the nearest closed pose, or the least open one

The first start is the file's own pose, from which the iteration goes the shortest way (least norm, short steps).
Where that ends at a pose that is open, others are tried: farther and farther from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.formats.draft import Draft
from symscrew.formats.rigid_displacements import Pose
from symscrew.formats.tree_freedoms import Freedom, cross_matrix, doubles, freedoms_of, ways_to
from symscrew.reference import rotation_vector

Array = np.ndarray[Any, Any]
Side = tuple[str, Pose]
"""A link and the pose of its frame of a loop."""
Loop = tuple[Side, Side, bool]
"""Two sides, and whether the turning of their frames is held as well as their place."""
LONGEST = 0.2
"""Of a step [rad, m]: a longer one may leave the way to the nearest closed pose."""
MOST_STEPS = 150
"""Of which few are used near the end; from half a turn away a step of `LONGEST` needs some twenty."""
STANDS_STILL = 1e-13
"""A step or a gap below this [rad, m] is rounding of doubles along a chain of links."""
DAMPING = 1e-10
"""Square of the singular values below which a direction is not used: redundant rows of loops have such."""
BETTER, PATIENCE = 0.99, 50
"""A start is given up after so many steps without a gap that is smaller by a hundredth: one that closes halves it."""
CLOSED = 1e-9
"""Gap [m, rad] at which a start has found a closed pose: iterations that close end a thousand times below."""
STARTS = 8
"""The own pose, and seven farther and farther from it: public files close from the first, or some loop of theirs alone
does from none."""


@dataclass(frozen=True)
class Tree:
    """The freedoms of a tree, those that carry each body, and the loops to close."""

    freedoms: Sequence[Freedom]
    ways: Mapping[str, Sequence[int]]
    loops: Sequence[Loop]

    @staticmethod
    def of(draft: Draft, loops: Sequence[Loop]) -> Tree:
        """All freedoms of a draft's joints."""
        freedoms = [f for k, joint in enumerate(draft.joints) for f in freedoms_of(k, joint)]
        return Tree(freedoms, ways_to(draft, freedoms), loops)

    @cached_property
    def frames(self) -> list[list[tuple[str, Array, Array]]]:
        """Of every loop the two links, with axes and place of their frames in doubles."""
        return [
            [
                (link, np.array([doubles(row) for row in pose.rotation]), doubles(pose.translation))
                for link, pose in (one, other)
            ]
            for one, other, _ in self.loops
        ]

    def alone(self, index: int) -> Tree:
        """One loop with the freedoms that move its sides against each other; what carries both changes no gap."""
        one, other, turning = self.loops[index]
        here, there = self.ways[one[0]], self.ways[other[0]]
        own = [k for k in here if k not in there], [k for k in there if k not in here]
        freedoms, first = [self.freedoms[k] for k in (*own[0], *own[1])], len(own[0])
        ways = {"here": range(first), "there": range(first, len(freedoms))}
        return Tree(freedoms, ways, [(("here", one[1]), ("there", other[1]), turning)])

    def starts(self, count: int = STARTS) -> Iterable[Array]:
        """Displacements to begin at, always the same ones: none, then random ones up to half a turn."""
        turns = np.array([np.pi if freedom.turns else self._reach() for freedom in self.freedoms])
        random = np.random.default_rng(0)
        for k in range(count):
            yield random.uniform(-1, 1, len(turns)) * turns * (k / max(count - 1, 1))

    def _reach(self) -> float:
        """How far a slide may begin from the own pose: a tenth of the largest distance of an axis from the origin."""
        return 0.1 * max((float(np.abs(freedom.doubles[1]).max()) for freedom in self.freedoms), default=1.0)


def closed_displacements(tree: Tree, starts: int = STARTS) -> tuple[Array, float]:
    """(displacements of the freedoms, largest gap [m, rad]): of the first start that closes, or the least open pose.

    No second one is tried where some loop does not even close alone.
    """
    q, gap = _best(tree, 1)
    if gap <= CLOSED or starts == 1 or open_alone(tree, starts):
        return q, gap
    return _best(tree, starts)


def open_alone(tree: Tree, starts: int = STARTS) -> dict[int, float]:
    """Index of every loop that does not even close by itself -> its smallest gap [m, rad] from all starts."""
    gaps = {k: _best(tree.alone(k), starts)[1] for k in range(len(tree.loops))}
    return {k: gap for k, gap in gaps.items() if gap > CLOSED}


def _best(tree: Tree, starts: int) -> tuple[Array, float]:
    best, least = np.zeros(len(tree.freedoms)), np.inf
    for begun in tree.starts(starts):
        q, gap = _followed(tree, begun)
        if gap < least:
            best, least = q, gap
        if least <= CLOSED:
            break
    return best, least


def _followed(tree: Tree, q: Array) -> tuple[Array, float]:
    """(q, gap) of the least open pose on the iteration's way from q."""
    best, least, since = q, np.inf, 0
    for _ in range(MOST_STEPS):
        residual, jacobian = _open(tree, q)
        gap = float(np.abs(residual).max(initial=0))
        since = 0 if gap < BETTER * least else since + 1
        best, least = (q, gap) if gap < least else (best, least)
        if gap < STANDS_STILL or since > PATIENCE:
            break
        u, s, vt = np.linalg.svd(jacobian, full_matrices=False)
        step = -vt.T @ ((s / (s * s + DAMPING)) * (u.T @ residual))
        size = float(np.abs(step).max(initial=0))
        if size < STANDS_STILL:
            break
        q = q + step * min(1.0, LONGEST / size)
    return best, least


def _open(tree: Tree, q: Array) -> tuple[Array, Array]:
    """(how far every loop is open, its derivative by the freedoms) in doubles."""
    residuals: list[Array] = []
    rows: list[Array] = []
    moved = _Moved(tree.freedoms, q)
    for ends, turning in zip(tree.frames, (turning for *_, turning in tree.loops), strict=True):
        (first, here, one), (second, there, other) = (moved.frame(tree.ways[link], *frame) for link, *frame in ends)
        by = one - other
        residuals.append(here - there)
        rows.append(by[:3])
        if turning:
            residuals.append(rotation_vector(first @ second.T))
            rows.append(by[3:])
    return np.concatenate(residuals), np.concatenate(rows)


class _Moved:
    """A tree at displacements q: what is behind every freedom is found once."""

    def __init__(self, freedoms: Sequence[Freedom], q: Array) -> None:
        self.freedoms, self.q = freedoms, q
        self.behind: dict[int, tuple[Array, Array]] = {}
        self.screws: dict[int, tuple[Array, Array]] = {}

    def frame(self, way: Sequence[int], turned: Array, place: Array) -> tuple[Array, Array, Array]:
        """Rotation and place of a body's frame, and the twist at that place (velocity, turning) by the freedoms."""
        rotation, shift = np.eye(3), np.zeros(3)
        for k in way:
            if k not in self.behind:
                self.behind[k] = self._pushed(k, rotation, shift)
            rotation, shift = self.behind[k]
        there = rotation @ place + shift
        twist, around = np.zeros((6, len(self.q))), cross_matrix(there)
        for k in way:
            omega, linear = self.screws[k]
            twist[:3, k], twist[3:, k] = linear - around @ omega, omega
        return rotation @ turned, there, twist

    def _pushed(self, k: int, rotation: Array, shift: Array) -> tuple[Array, Array]:
        """What is behind freedom k, before which the bodies have this rotation and shift; its present screw is kept."""
        axis, point, hat, twice = self.freedoms[k].doubles
        along = rotation @ axis
        if not self.freedoms[k].turns:
            self.screws[k] = np.zeros(3), along
            return rotation, shift + along * self.q[k]
        self.screws[k] = along, cross_matrix(rotation @ point + shift) @ along
        turn = np.eye(3) + np.sin(self.q[k]) * hat + (1 - np.cos(self.q[k])) * twice
        return rotation @ turn, shift + rotation @ (point - turn @ point)

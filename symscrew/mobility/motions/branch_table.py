"""The branch table: what moves along each branch through the configuration.

    Mobility --germs of every part--> branches of the whole --points on them--> BranchRow: platform, joints, judgement

At a generic point of a branch near the configuration the instantaneous motions are its tangent space. So the freedoms
of the platform there, its screw system, the internal freedoms and the joints at rest are those of the branch. They are
sampled at two points, with ranks of 60 digits; that the list is complete, and the dimensions, are proved where the
proof file's evidence shows it (`symscrew.mobility.proofs`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice, product
from typing import Any

import numpy as np

from symscrew.mobility.finite import FiniteMobility, Witness, rotation_vector
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.germs import Germ, germs_of
from symscrew.mobility.motions.seen_poses import Closures, Seen, in_doubles, seen_at
from symscrew.mobility.screw_classes import ScrewClass
from symscrew.mobility.screw_systems import null_space

Array = np.ndarray[Any, Any]

MOST_ROWS = 24
"""Branches of the whole that are listed: with several singular parts their numbers multiply."""
SAME_PITCH = 1e-6
"""Relative difference, or part of the mechanism's size, of pitches that are the same at two points."""


@dataclass(frozen=True)
class BranchRow:
    """One branch through the configuration.

    Attributes:
        dimension: of the real motion along it.
        tangent: unit motions in the joint freedoms at the configuration, its directions as seen [rad, length].
        platform: class of the platform's freedoms along it, with principal pitches; None, as the rest, for a branch
            that has more instantaneous freedoms than real ones all along.
        internal: dimension of the motions along it that leave the platform at rest.
        idle: joints that do not move along it.
        axes: joint freedoms about, or along, which the platform can move all along what was seen of it.
        constant: whether the principal pitches are the same at both points that were looked at.
        cusp: both half-branches of a curve leave the configuration to one side.
        here: whether the principal pitches are those at the configuration, else at a point of the branch nearby.
        almost: what holds to seven digits only, in words: a class, joints at rest; empty where nothing does.
    """

    dimension: int
    tangent: Array
    platform: ScrewClass | None
    internal: int
    idle: tuple[str, ...]
    axes: tuple[str, ...]
    constant: bool
    cusp: bool
    points: tuple[Array, ...]
    here: bool = False
    almost: str = ""


UNSEEN = "their dimensions are proved; what moves along them was not looked at"


@dataclass(frozen=True)
class BranchTable:
    """The branches through a configuration, those of most dimensions first.

    `complete`: why there is no other branch; empty where that is not proved, then `open` says so.
    """

    body: str
    rows: tuple[BranchRow, ...]
    complete: str
    open: str

    @property
    def judgement(self) -> str:
        """`proved` where number and dimensions of the branches are, else `sampled`."""
        return "proved" if self.complete else "sampled"


def branches_through(network: Network, finite: FiniteMobility, body: str, *, complete: str = "") -> BranchTable:
    """The table of a configuration whose finite mobility is decided.

    Args:
        network: the configuration.
        finite: what really moves, with a witness for every part.
        body: whose freedoms.
        complete: why dimensions and number are proved; empty where they are not.
    """
    if not finite.smooth and not finite.witnesses:  # proved from the equations alone: no point of a branch is known
        return BranchTable(body, (), complete if not finite.branches else "", "" if not finite.branches else UNSEEN)
    parts: dict[tuple[str, ...], list[Witness]] = {}
    for witness in finite.witnesses:
        parts.setdefault(tuple(witness.network.edges), []).append(witness)
    found = [germs_of(witnesses) for witnesses in parts.values()]
    limits = [text for _, text in found if text]
    choices = list(islice(product(*(germs for germs, _ in found)), MOST_ROWS + 1))
    if len(choices) > MOST_ROWS:
        limits.append(f"only the first {MOST_ROWS} combinations of the parts' branches are listed")
    rows = [
        row
        for row in (_row(network, body, germs, smooth=finite.smooth) for germs in choices[:MOST_ROWS])
        if row.dimension
    ]
    rows.sort(key=lambda row: -row.dimension)
    told = "of number and dimensions of the branches there is no proof: they are those that were seen from many starts"
    return BranchTable(body, tuple(rows), "" if limits else complete, "; ".join(limits) or ("" if complete else told))


def _row(network: Network, body: str, germs: Sequence[Germ], *, smooth: bool) -> BranchRow:
    spins = network.freedoms - sum(germ.network.freedoms for germ in germs)
    dimension = spins + sum(germ.dimension for germ in germs)
    if any(not germ.points or _shaky(germ) for germ in germs):
        return BranchRow(dimension, np.zeros((0, network.freedoms)), None, 0, (), (), False, False, ())
    count = max((len(germ.points) for germ in germs), default=1)
    points = [_whole(network, [(germ.network, germ.points[min(k, len(germ.points) - 1)]) for germ in germs])
              for k in range(count)]  # fmt: skip
    closures, length = Closures(network), float(network.length)
    seen = [seen_at(closures, q, dimension, body) for q in points]
    first = max(seen, key=lambda one: one.system.order)
    platform = first.system
    idle = tuple(name for name in network.edges if all(name in one.resting(network) for one in seen))
    common = tuple(name for name in seen[0].axes if all(name in one.axes for one in seen))
    pitches = [one.system.pitches for one in seen if one.system.order == platform.order]
    same = all(np.allclose(p, pitches[0], rtol=SAME_PITCH, atol=SAME_PITCH * length) for p in pitches)
    constant = len(pitches) == len(points) and len({one.name for one in seen}) == 1 and same
    almost = _almost(first, in_doubles(closures, points[seen.index(first)], dimension, body), network)
    here = False
    if smooth and not constant:  # elsewhere the tangent at the configuration is not the null space
        own = seen_at(closures, np.zeros(network.freedoms), dimension, body).system
        here = (own.order, own.name) == (platform.order, platform.name)
        platform = own if here else platform
    cusp = any(germ.cusp for germ in germs)
    tangent = _directions(network, germs)
    return BranchRow(dimension, tangent, platform, dimension - platform.order, idle, common, constant, cusp,
                     tuple(points), here, almost)  # fmt: skip


def _shaky(germ: Germ) -> bool:
    """Whether a part that does not move has instantaneous freedoms: what moves is not told by ranks then."""
    return not germ.dimension and bool(null_space(germ.network.loop_rows(), germ.network.freedoms).basis)


def _almost(found: Seen, roughly: Seen, network: Network) -> str:
    """What holds to seven digits and not exactly, in words; empty where nothing does."""
    texts = []
    if roughly.name != found.name:
        texts.append(f"{roughly.system.motion_type}, {roughly.system}")
    if resting := sorted(roughly.resting(network) - found.resting(network)):
        texts.append(f"{', '.join(resting)} at rest")
    return "; ".join(texts)


def _directions(network: Network, germs: Sequence[Germ]) -> Array:
    """Unit motions at the configuration along which the branch was seen, in the columns of the whole."""
    rows = []
    for germ in germs:
        for direction in germ.directions:
            whole = _whole(network, [(germ.network, direction * 1e-6)]) * 1e6
            rows.append(whole / (np.linalg.norm(whole) or 1.0))
    return np.array(rows).reshape(len(rows), network.freedoms)


def _whole(network: Network, parts: Sequence[tuple[Network, Array]]) -> Array:
    """Displacements of the whole from those of its parts; two turns across a line stand for a ball joint's three."""
    result = np.zeros(network.freedoms)
    for part, q in parts:
        for edge in part.edges.values():
            own = network.edges[edge.name]
            if len(own.screws) == len(edge.screws):
                result[list(own.columns)] = q[list(edge.columns)]
            else:
                result[list(own.columns)] = rotation_vector(edge, q[list(edge.columns)])
    return result

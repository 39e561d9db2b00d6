"""The closure with passive spins held: rods between two balls do not turn about the line of their centres.

Each spin is an instantaneous motion at every pose that moves nothing else, so that where it is held the other motions
are what they were, and losses of rank stay where they are. Held is the angular velocity of the ball joint at one end
along the line of centres; where the rod has turned to by then does not matter. A body that is asked for may spin.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from symscrew.mobility.finite import DOUBLE, Arithmetic, ClosureVariety, named_spins
from symscrew.mobility.joint_network import Network

Array = np.ndarray[Any, Any]
Pose = tuple[Array, Array]


class HeldSpins(ClosureVariety):
    """The closure variety with an equation of rates more for every passive spin; nothing of it can be left open."""

    def __init__(self, network: Network, body: str, arithmetic: Arithmetic = DOUBLE) -> None:
        """`body`: whose freedoms are asked for; where it spins itself, that is one of them and is not held."""
        super().__init__(network, arithmetic)
        edges = network.edges
        chains = {pair: _between(network, *pair) for pair in named_spins(network)}
        self._spinning = {name for joints, _ in chains.values() for name in joints}
        self.ends = [
            (list(edges[a].columns), list(edges[b].columns))
            for (a, b), (_, bodies) in chains.items()
            if body not in bodies and not {*edges[a].columns, *edges[b].columns} & set(network.driven)
        ]

    def gaps(self, poses: Mapping[str, Pose], q: Array) -> Array:
        """The residuals at the points q with these displacements of the bodies; see `ClosureVariety`."""
        return np.concatenate([super().gaps(poses, q), self._zeros(len(q), len(self.ends))], axis=1)

    def residual(self, q: Array) -> Array:
        """The residual at one point."""
        found = super().residual(q)  # in doubles it is that of `evaluate`
        return found if self._fixed is None else np.concatenate([found, self._zeros(len(self.ends))])

    def jacobians(self, screws: Array, q: Array) -> Array:
        """The Jacobians at the points q with these displaced screws."""
        found = super().jacobians(screws, q)
        if not self.ends:
            return found
        held = self._zeros(len(screws), len(self.ends), self.columns)
        for k, (first, second) in enumerate(self.ends):
            line = _centres(screws[:, second]) - _centres(screws[:, first])
            held[:, k, first] = (screws[:, first, :3] * line[:, None]).sum(axis=2)
        return np.concatenate([found, held], axis=1)

    def places(self, q: Array) -> Array:
        """Where joints are at one point: axes as lines, ball joints by their centres; turns and spins do not count."""
        screws = self.displaced(q[None])
        found = [np.zeros(0)]
        for edge in (edge for name, edge in self.network.edges.items() if name not in self._spinning):
            for motion, start in edge.motions:
                ball = motion.spherical
                found.append(_centres(screws[:, start : start + 3])[0] if ball else screws[0, start])
        return np.concatenate(found)


def _between(network: Network, first: str, last: str) -> tuple[list[str], list[str]]:
    """(joints, bodies) of the links between two balls, which spin with them."""
    for start in (network.edges[first].parent, network.edges[first].child):
        joint, joints, bodies = first, list[str](), [start]
        while bodies[-1] != network.ground:
            body = bodies[-1]
            there = [e for e in network.edges.values() if body in (e.parent, e.child) and e.name != joint]
            if len(there) != 1 or there[0].name in joints:
                break
            joint = there[0].name
            if joint == last:
                return joints, bodies
            joints.append(joint)
            bodies.append(there[0].child if there[0].parent == body else there[0].parent)
    return [], []


def _centres(screws: Array) -> Array:
    """N x 3: the common point of three rotations (omega ; c x omega) with independent axes, N x 3 x 6."""
    a, b, c = (screws[:, k, :3] for k in range(3))
    dual = [np.cross(b, c), np.cross(c, a), np.cross(a, b)]
    volume = (a * dual[0]).sum(axis=1)
    hat = sum(screws[:, k, 3:, None] * dual[k][:, None] for k in range(3))  # v = hat omega, times the volume
    return np.asarray(np.stack([hat[:, 2, 1], hat[:, 0, 2], hat[:, 1, 0]], axis=1) / volume[:, None])

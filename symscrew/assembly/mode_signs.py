"""Signs of determinants of a configuration, against the reference, and how far it is from a singularity.

    displacements q --screws--> closure's matrix: passive joints with the drives locked, joints of a limb with its ends

A motion on which no determinant is zero keeps all signs (C. Gosselin, J. Angeles, 1990).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import most_independent
from symscrew.description import Mechanism
from symscrew.mobility import ClosureVariety, Network

Array = np.ndarray[Any, Any]

NEAR = 1e-9
"""Relative singular value below which a space has no such direction, and a determinant no sign."""
SEED = 20231009
"""Of the configurations that span what the passive joints' matrix maps to."""
PLANAR = 3
"""Components of screws of a planar mechanism whose axis is one of the absolute axes; limbs of others have no signs."""
LOCKED = "drives locked"


@dataclass(frozen=True)
class Seen:
    """A configuration: opening of the loops, singular values, signs, poses of bodies about O in metres."""

    residual: float
    smallest: float
    volume: float
    signs: Mapping[str, str]
    poses: Mapping[str, tuple[Array, Array]]

    def pose(self, body: str) -> tuple[Array, Array]:
        """Displacement of a body from the reference: rotation, translation [m] of what is at O."""
        return self.poses[body]


class ModeSigns:
    """Of a mechanism with these columns held."""

    def __init__(self, network: Network, mechanism: Mechanism, held: Sequence[int]) -> None:
        self.network = network
        self.variety = ClosureVariety(network)
        self.passive = [c for c in range(self.variety.columns) if c not in held]
        self.limbs = {
            limb.name: [c for name in limb.joints for c in network.edges[name].columns]
            for limb in mechanism.limbs.values() if all(name in network.edges for name in limb.joints)
        }  # fmt: skip
        self.space = self._space() if network.chords else None
        screws = self.variety.forward(np.zeros((1, self.variety.columns)))[0][0]
        planar = int((np.abs(screws).max(axis=0) > NEAR).sum()) <= PLANAR
        size = PLANAR if planar else 6
        self.minors = {
            n: most_independent(screws[columns].T) for n, columns in self.limbs.items() if len(columns) == size
        }
        self.reference = self._determinants(np.zeros(self.variety.columns))

    def _space(self) -> Array | None:
        """A basis of what the passive joints' matrix maps to everywhere, if it has as many dimensions as columns."""
        q = np.random.default_rng(SEED).normal(size=(2 * len(self.passive) + 1, self.variety.columns))
        parts = self.variety.jacobians(self.variety.forward(q)[0], q)[:, :, self.passive]
        u, s, _ = np.linalg.svd(np.concatenate(list(parts), axis=1), full_matrices=False)
        return np.asarray(u[:, : len(self.passive)]) if (s > NEAR * s[0]).sum() == len(self.passive) else None

    def _determinants(self, q: Array) -> dict[str, float]:
        screws = self.variety.forward(q[None])[0]
        found = {}
        if self.space is not None and self.passive:
            matrix = self.space.T @ self.variety.jacobians(screws, q[None])[0][:, self.passive]
            found[LOCKED] = _sign(matrix)
        for name, rows in self.minors.items():
            found[name] = _sign(screws[0][self.limbs[name]][:, rows].T)
        return found

    def look(self, q: Array) -> Seen:
        """A configuration."""
        residuals, jacobians = self.variety.evaluate(q[None])
        values = np.linalg.svd(jacobians[0][:, self.passive], compute_uv=False)
        part = values[: len(self.passive)] if values.size else np.ones(1)
        whole = jacobians.shape[1] >= len(self.passive)
        now = self._determinants(q)
        against = {name: value * self.reference[name] for name, value in now.items()}
        signs = {name: "0" if not value else "+" if value > 0 else "-" for name, value in against.items()}
        poses = {
            body: self._about_origin(pose)
            for body, pose in self.variety.forward(q[None])[1].items() if body in self.network.bodies
        }  # fmt: skip
        smallest = float(part[-1]) if whole and len(self.passive) else float(len(self.passive) == 0)
        return Seen(float(np.abs(residuals).max(initial=0.0)), smallest, float(np.prod(part)), signs, poses)

    def _about_origin(self, pose: tuple[Array, Array]) -> tuple[Array, Array]:
        rotation, translation = pose[0][0], pose[1][0]
        centre, unit = np.array([float(c) for c in self.variety.centre]), float(self.network.length)
        return rotation, (centre - rotation @ centre + translation) * unit


def _sign(matrix: Array) -> float:
    values = np.linalg.svd(matrix, compute_uv=False)
    return 0.0 if values[-1] < NEAR * values[0] else float(np.linalg.slogdet(matrix)[0])

"""Limbs as serial chains of their own, with NumPy: the source paper's way, independent of the generated code.

Each limb carries a copy of the platform and goes by its own joint positions: screws of all joints at O by products
of exponentials, eqs. (5) and (6); rates by least squares of eq. (27), all limbs at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.reference import numeric

Array = np.ndarray
SMALL_ANGLE = 1e-9  # its sine: below, angle and sine are the same number; above, their quotient is well defined


def opened(mechanism: Mechanism) -> Mechanism:
    """The mechanism with a platform of its own at the end of every limb: a tree without loops."""
    platform = mechanism.platform
    bodies, joints = dict(mechanism.bodies), dict(mechanism.joints)
    for k, limb in enumerate(mechanism.limbs.values()):
        tip = joints[limb.joints[-1]]
        if tip.child != platform:
            raise DescriptionError(f"the limb {limb.name} does not end at the platform with its last joint")
        if k:
            own = f"{platform}_{k + 1}"
            bodies[own] = replace(bodies[tip.child], name=own)
            joints[tip.name] = replace(tip, child=own)
    if set(joints) != {name for limb in mechanism.limbs.values() for name in limb.joints}:
        raise DescriptionError("there are joints that belong to no limb")
    return replace(mechanism, bodies=bodies, joints=joints, limbs={})


class Chains:
    """Limbs by products of exponentials. A state is a list: per joint its coordinates, a quaternion for S joints."""

    def __init__(self, mechanism: Mechanism) -> None:
        numbers = numeric(mechanism)
        self.limbs: list[list[int]] = []
        self.spherical = [mechanism.joints[name].kind.ball for name in numbers.joints]
        for limb in mechanism.limbs.values():
            self.limbs.append([numbers.joints.index(name) for name in limb.joints])
        self.freedoms, self.points = numbers.freedoms, numbers.points
        self.axes, self.turns = numbers.axes, numbers.turns
        pairs = zip(numbers.references, numbers.freedoms, strict=True)
        self.references = [np.resize(r, len(own)) if len(r) else np.zeros(len(own)) for r, own in pairs]
        self.count = len(numbers.axes)
        self.rows = 6 * len(self.limbs)

    def start(self) -> list[Array]:
        """The reference configuration."""
        return [
            np.array([1.0, 0.0, 0.0, 0.0]) if s else np.array(r)
            for s, r in zip(self.spherical, self.references, strict=True)
        ]

    def matrix(self, state: Sequence[Array]) -> Array:
        """S = blockdiag(S_1 ... S_n), (6 limbs, freedoms), columns in the order of the joints."""
        whole = np.zeros((self.rows, self.count))
        for k, joints in enumerate(self.limbs):
            rotation, shift = np.eye(3), np.zeros(3)
            for j in joints:
                centre = rotation @ self.points[j] + shift
                own = self.freedoms[j]
                if self.spherical[j]:
                    axes = rotation  # the parent's axes
                    whole[6 * k : 6 * k + 3, own] = axes
                    whole[6 * k + 3 : 6 * k + 6, own] = _cross_all(centre, axes)
                    turn = rotation @ _matrix(state[j]) @ rotation.T
                    rotation, shift = turn @ rotation, centre + turn @ (shift - centre)
                    continue
                for i, f in enumerate(own):
                    axis = rotation @ self.axes[f]
                    change = state[j][i] - self.references[j][i]
                    if self.turns[f]:
                        whole[6 * k : 6 * k + 3, f] = axis
                        whole[6 * k + 3 : 6 * k + 6, f] = _cross(centre, axis)
                        turn = _rotation(axis, change)
                        rotation, shift = turn @ rotation, centre + turn @ (shift - centre)
                    else:
                        whole[6 * k + 3 : 6 * k + 6, f] = axis
                        shift, centre = shift + change * axis, centre + change * axis
        return whole

    def moved(self, state: Sequence[Array], rates: Array, h: float) -> list[Array]:
        """theta + h w, eq. (9); quaternions by h times their rate, then unit again."""
        result = []
        for j, own in enumerate(self.freedoms):
            if self.spherical[j]:
                turned = state[j] + h * _quaternion_rate(state[j], rates[own])
                result.append(turned / np.sqrt(turned @ turned))
            else:
                result.append(state[j] + h * rates[own])
        return result

    def displacements(self, state: Sequence[Array]) -> Array:
        """All joint displacements as figure 7 has them: rotation vectors for S joints."""
        return np.concatenate([_vector(x) if s else x for s, x in zip(self.spherical, state, strict=True)])

    def flat(self, state: Sequence[Array]) -> Array:
        """A state as one array."""
        return np.concatenate(state)

    def unflat(self, values: Array) -> list[Array]:
        """The state of one array, quaternions of unit length."""
        sizes = [4 if s else len(r) for s, r in zip(self.spherical, self.references, strict=True)]
        parts = np.split(values, np.cumsum(sizes)[:-1])
        return [p / np.sqrt(p @ p) if s else p for s, p in zip(self.spherical, parts, strict=True)]

    def flat_rates(self, state: Sequence[Array], rates: Array) -> Array:
        """Time derivative of `flat`."""
        return np.concatenate(
            [
                _quaternion_rate(x, rates[own]) if s else rates[own]
                for s, x, own in zip(self.spherical, state, self.freedoms, strict=True)
            ]
        )


def least_squares(matrix: Array, twist: Array) -> Array:
    """w = (S^T S)^-1 S^T V, eqs. (7) and (27), with the platform's twist once per limb."""
    stacked = np.tile(twist, len(matrix) // 6)
    return np.linalg.solve(matrix.T @ matrix, matrix.T @ stacked)


def _cross(a: Array, b: Array) -> Array:
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _skew(a: Array) -> Array:
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def _cross_all(point: Array, axes: Array) -> Array:
    moments: Array = _skew(point) @ axes
    return moments


def _rotation(axis: Array, angle: float) -> Array:
    k = _skew(axis)
    turned: Array = np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)
    return turned


def _matrix(q: Array) -> Array:
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _quaternion_rate(q: Array, omega: Array) -> Array:
    """Half of (0, omega) q: rates in the parent's axes."""
    w, r = q[0], q[1:]
    return 0.5 * np.concatenate([[-(omega @ r)], w * omega + _cross(omega, r)])


def _vector(q: Array) -> Array:
    """The rotation vector of a unit quaternion, the shorter of both."""
    sine = float(np.sqrt(q[1:] @ q[1:]))
    factor = 2.0 if sine < SMALL_ANGLE else 2.0 * float(np.arctan2(sine, abs(q[0]))) / sine
    vector: Array = factor * np.sign(q[0] or 1.0) * q[1:]
    return vector

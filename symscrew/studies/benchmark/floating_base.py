"""States of trees for other engines, whose base may move freely: coordinates, rates and accelerations in their words.

A free joint is in ours a place and the velocity of a point in absolute axes, a quaternion (w, x, y, z) and the angular
velocity in the body's axes. MuJoCo has the same, from its own origin; Pinocchio (x, y, z, w), and the velocity in the
body's axes, whose rate has a term of turning.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.model import Model
from symscrew.studies.benchmark.pinocchio_tree import rotations

Array = np.ndarray


@dataclass(frozen=True)
class Column:
    """A joint of the tree: where its coordinates and rates stand in ours."""

    name: str
    q: tuple[int, ...]
    v: tuple[int, ...]

    @property
    def free(self) -> bool:
        """Whether it is the base's."""
        return len(self.v) > 1


def comparable(model: Model) -> bool:
    """Whether a tree is one of driven R and P joints, on the ground or on a body that moves freely there."""
    mechanism = model.mechanism
    moving = [joint for joint in mechanism.joints.values() if joint.kind.freedom]
    free = [j for j in moving if j.kind.unconstrained and not j.driven and j.parent == mechanism.ground
            and not any(j.reference)]  # fmt: skip
    others = [joint for joint in moving if joint not in free]
    return len(free) <= 1 and all(j.kind.freedom == 1 and len(j.driven) == 1 for j in others)


def columns(model: Model) -> list[Column]:
    """The tree's joints in the order of its coordinates."""
    found: dict[str, tuple[list[int], list[int]]] = {}
    for which, labels in enumerate((model.system.tree.q, model.system.tree.v)):
        for k, coordinate in enumerate(labels):
            found.setdefault(coordinate.label.split(".")[0], ([], []))[which].append(k)
    return [Column(name, tuple(q), tuple(v)) for name, (q, v) in found.items()]


def to_pinocchio(column: Column, q: Array, rates: tuple[Array, ...]) -> tuple[Array, ...]:
    """A free joint's q (states, 7), velocity and, where it is given, acceleration (states, 6) as Pinocchio has them."""
    place = q[:, column.q]
    turn = rotations(place[:, 3:])
    moved = [rate[:, column.v] for rate in rates]
    local = [np.concatenate([np.einsum("sji,sj->si", turn, m[:, :3]), m[:, 3:]], axis=1) for m in moved]
    if len(local) > 1:
        local[1][:, :3] -= np.cross(local[0][:, 3:], local[0][:, :3])
    return np.concatenate([place[:, :3], place[:, 4:], place[:, 3:4]], axis=1), *local


def from_pinocchio(column: Column, q: Array, v: Array, acceleration: Array) -> Array:
    """A free joint's acceleration (states, 6) as ours; `v` and `acceleration` are Pinocchio's."""
    turn = rotations(q[:, column.q[3:]])
    linear = np.einsum("sij,sj->si", turn, acceleration[:, :3] + np.cross(v[:, 3:], v[:, :3]))
    return np.concatenate([linear, acceleration[:, 3:]], axis=1)


def turned(q: Array, listed: list[Column]) -> Array:
    """(states, n, n): from our rates to Pinocchio's, joint by joint in our order."""
    made = np.tile(np.eye(max(k for c in listed for k in c.v) + 1), (len(q), 1, 1))
    for column in listed:
        if column.free:
            rows = np.array(column.v[:3])
            made[:, rows[:, None], rows] = rotations(q[:, column.q[3:]]).swapaxes(1, 2)
    return made

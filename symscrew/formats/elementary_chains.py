"""A mechanism as the chains of elementary joints that other formats want, with numbers as doubles.

Mechanism --chains--> tree of bodies from the ground, cut joints;   joint --steps--> R, P, H, S motions in order
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symscrew.description import Joint, Mechanism, Motion, Vector
from symscrew.reference import plane_axes

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Step:
    """An elementary motion of a joint, from the ground outwards.

    `motion` says what it is; `axis` is the unit axis in the reference configuration, `reference` the
    coordinate's value there, `driven` the indices of its driven freedoms. The name is the joint's, with the
    index of the motion where the joint has several.
    """

    name: str
    motion: Motion
    axis: Array
    reference: float
    pitch: float
    driven: tuple[int, ...]


@dataclass(frozen=True)
class Branch:
    """A body of the tree: the joint that carries it, whether it is passed from child to parent."""

    body: str
    parent: str
    joint: Joint
    inverted: bool


@dataclass(frozen=True)
class Chains:
    """The tree in an order where parents come first, and the joints that close loops."""

    branches: tuple[Branch, ...]
    cut: tuple[Joint, ...]


def chains(mechanism: Mechanism, rank: Callable[[Joint], int] = lambda joint: 0) -> Chains:
    """A spanning tree that takes joints of low rank first (Kruskal), in the order of the description."""
    group = {name: name for name in mechanism.bodies}

    def leader(name: str) -> str:
        while group[name] != name:
            name = group[name]
        return name

    kept: list[Joint] = []
    cut: list[Joint] = []
    for joint in sorted(mechanism.joints.values(), key=rank):
        one, other = leader(joint.parent), leader(joint.child)
        (cut if one == other else kept).append(joint)
        group[one] = other
    order = {name: k for k, name in enumerate(mechanism.joints)}
    kept.sort(key=lambda joint: order[joint.name])
    branches: list[Branch] = []
    reached = {mechanism.ground}
    while len(reached) < len(mechanism.bodies):
        for joint in kept:
            for near, far, inverted in ((joint.parent, joint.child, False), (joint.child, joint.parent, True)):
                if near in reached and far not in reached:
                    branches.append(Branch(far, near, joint, inverted))
                    reached.add(far)
    return Chains(tuple(branches), tuple(sorted(cut, key=lambda joint: order[joint.name])))


def steps(mechanism: Mechanism, joint: Joint, *, inverted: bool = False) -> list[Step]:
    """The elementary motions of a joint from the ground outwards; against the joint's sense, the reverse.

    The coordinates are the joint's own in both cases: passing a motion backwards negates its axis.
    """
    kind = joint.kind
    axes = kind.motion_axes([numbers(mechanism, axis) for axis in joint.axes], list(np.eye(3)), plane_axes)
    result = []
    names = kind.motion_names(joint.name)
    for k, (name, motion, first) in enumerate(zip(names, kind.motions, kind.starts, strict=True)):
        result.append(
            Step(
                name,
                motion,
                np.array([0.0, 0.0, 1.0]) if motion.axis is None else axes[motion.axis] * (-1 if inverted else 1),
                float(mechanism.number(joint.reference[k])) if k < len(joint.reference) else 0.0,
                0.0 if joint.pitch is None else float(mechanism.number(joint.pitch)),
                tuple(index - first for index in joint.driven if first <= index < first + motion.freedom),
            )
        )
    return result[::-1] if inverted else result


def numbers(mechanism: Mechanism, vector: Vector) -> Array:
    """Three expressions as doubles."""
    return np.array([float(mechanism.number(entry)) for entry in vector])

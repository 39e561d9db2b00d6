"""What a configuration is asked for by: a coordinate of a joint, a rotation of a spherical one, the pose of a body.

"joint", "joint.i"              the displacement of a single freedom [rad, m]
"joint.qx", "joint.rx" ...      of a spherical joint: vector part of its quaternion; its rotation vector [rad]
"platform_pose.0", ".qx"        of the joint on which the package hangs a platform that many limbs hold: as it names it
"body.x", "body.qx", "body.rx"  of a body: how far it is displaced [m], how it is turned, from the reference
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import Joint, Mechanism, exact
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.kinematics import virtual_joint
from symscrew.mobility.finite import Array, ClosureVariety
from symscrew.mobility.joint_network import Edge, Network, edge_of
from symscrew.mobility.screw_systems import Real

DIFFERENCE = 1e-6
"""Half the step of central differences in doubles: right to ten digits, of which each refinement gains as many."""
STRAIGHT = 1e-10
"""Half a rotation vector shorter than this [rad] is its quaternion's vector part, to better than rounding."""
VECTOR = "xyz"
SPATIAL = 6
"""Freedoms of the joint on which a spatial platform hangs: the only one with a quaternion."""


@dataclass(frozen=True)
class Target:
    """A number of the configuration that is to be `goal`; `column` where it is a coordinate itself.

    `of_all`: the number at the points q, N x columns, in the variety's arithmetic.

    The goal is in units of the network: angles [rad], lengths by its length.
    """

    goal: Real
    of_all: Callable[[ClosureVariety, Array], Array]
    column: int | None = None

    def gradient(self, variety: ClosureVariety, q: Array) -> Array:
        """Derivative by the displacements, in doubles."""
        if self.column is not None:
            return np.asarray(np.eye(len(q))[self.column])
        steps = DIFFERENCE * np.eye(len(q))
        values = self.of_all(variety, np.concatenate([q + steps, q - steps])).astype(float)
        return np.asarray((values[: len(q)] - values[len(q) :]) / (2 * DIFFERENCE))

    def of(self, variety: ClosureVariety, q: Array) -> Real:
        """The number at one point."""
        return self.of_all(variety, q[None])[0]


def target_of(mechanism: Mechanism, network: Network, name: str, value: Any) -> Target:
    """The target that a name and a value mean.

    Raises:
        DescriptionError: no joint or body of this name, or it has no such coordinate.
    """
    owner, _, part = name.partition(".")
    virtual = virtual_joint(mechanism)
    if virtual is not None and owner == virtual.name:
        return _of_virtual(mechanism, network, virtual, (name, part, high_precision(exact(value, where=name))))
    if owner not in network.edges and owner not in network.bodies:
        known = [*mechanism.parameters, *network.edges, *network.bodies]
        raise DescriptionError(f"at {name}: no parameter, joint or body of this name; {did_you_mean(owner, known)}")
    goal = high_precision(exact(value, where=name))
    if owner in network.edges:
        edge = network.edges[owner]
        spherical = [column for motion, column in edge.motions if motion.spherical]
        if spherical and part in _turns():
            first = spherical[0]
            turned = _quaternion_of if part[0] == "q" else _vector_of
            column = first + VECTOR.index(part[1]) if part[0] == "r" else None
            axis = VECTOR.index(part[1])
            return Target(goal, lambda _, q: _each(turned(v)[axis] for v in q[:, first : first + 3]), column)
        return _single(mechanism, network, edge, (name, part, goal))
    if part in VECTOR and len(part) == 1:
        axis = VECTOR.index(part)
        return Target(goal / network.length, lambda variety, q: _each(t[axis] for _, t in _moved(variety, q, owner)))
    if part in _turns():
        axis = VECTOR.index(part[1])
        read = _half_turn if part[0] == "q" else _rotation_vector
        return Target(goal, lambda variety, q: _each(read(r)[axis] for r, _ in _moved(variety, q, owner)))
    raise DescriptionError(
        f"at {name}: expected {owner}.x, .y, .z [m], .qx, .qy, .qz, or .rx, .ry, .rz [rad] of a body"
    )


def _of_virtual(mechanism: Mechanism, network: Network, joint: Joint, asked: tuple[str, str, Real]) -> Target:
    """A coordinate of the joint on which the package hangs the platform: of its point's place, of its turn."""
    name, part, goal = asked
    edge, body = edge_of(mechanism, joint, network.length, 0), joint.child
    if part in _turns() and part[0] == "q" and joint.kind.freedom == SPATIAL:
        axis = VECTOR.index(part[1])
        return Target(goal, lambda variety, q: _each(_half_turn(r)[axis] for r, _ in _moved(variety, q, body)))
    singles = [(motion, column) for motion, column in edge.motions if motion.single]
    if not part.isdecimal() or int(part) >= len(singles):
        numbers = ", ".join(f".{k}" for k in range(len(singles)))
        turned = " or .qx, .qy, .qz" if joint.kind.freedom == SPATIAL else ""
        raise DescriptionError(f"at {name}: expected {joint.name} with {numbers}{turned}")
    place = int(part)
    motion, column = singles[place]
    screw = edge.screws[column]
    reference = high_precision(mechanism.number(joint.reference[place])) if place < len(joint.reference) else 0
    if motion.turns:
        return Target(goal - reference, lambda variety, q: _each(
            _along(screw[:3], _rotation_vector(r)) for r, _ in _moved(variety, q, body)))  # fmt: skip
    return Target((goal - reference) / network.length, lambda variety, q: _each(
        _along(screw[3:], t) for _, t in _moved(variety, q, body, edge.point)))  # fmt: skip


def _along(axis: Sequence[Real], vector: Iterable[Real]) -> Real:
    return sum(a * b for a, b in zip(axis, vector, strict=True))


def _turns() -> tuple[str, ...]:
    return tuple(kind + axis for kind in "qr" for axis in VECTOR)


def _single(mechanism: Mechanism, network: Network, edge: Edge, asked: tuple[str, str, Real]) -> Target:
    """A coordinate that is one freedom of a joint."""
    name, index, goal = asked
    motions = [motion for motion, _ in edge.motions]
    spherical = any(motion.spherical for motion in motions)
    place = int(index) if index.isdecimal() else 0
    if spherical or place >= len(motions) or (not index and len(motions) > 1) or (index and not index.isdecimal()):
        has = (
            "three rotations: .qx, .qy, .qz of its quaternion, or .rx, .ry, .rz [rad] of its rotation vector"
            if spherical
            else len(motions)
        )
        raise DescriptionError(
            f"at {name}: expected {edge.name} or {edge.name}.i for a single coordinate; this joint of type {edge.type} "
            f"has {has}"
        )
    reference = mechanism.joints[edge.name].reference
    start = high_precision(mechanism.number(reference[place])) if place < len(reference) else CONTEXT.zero
    column = edge.motions[place][1]
    displacement = goal - start
    return Target(
        displacement / network.length if motions[place].prismatic else displacement, lambda _, q: q[:, column], column
    )


def _vector_of(vector: Array) -> Array:
    return vector


def _quaternion_of(vector: Array) -> list[Real]:
    """The vector part of the unit quaternion of a rotation vector."""
    square = sum(c * c for c in vector)
    if square < STRAIGHT**2:
        return [c / 2 for c in vector]
    angle = CONTEXT.sqrt(square)
    factor = CONTEXT.sin(angle / 2) / angle
    return [factor * c for c in vector]


def _each(values: Iterable[Real]) -> Array:
    return np.array(list(values), dtype=object)


def _moved(
    variety: ClosureVariety, q: Array, body: str, place: Sequence[Real] | None = None
) -> Iterator[tuple[Array, Array]]:
    """(rotation, displacement of a place) of a body from the reference, at every point.

    The place is the centre of the body's joints unless one is given.
    """
    points = [e.point for e in variety.network.edges.values() if body in (e.parent, e.child)]
    points = points if place is None else [tuple(place)]
    middle = [sum(p[k] for p in points) / len(points) - variety.centre[k] for k in range(3)]
    point = np.array([variety.arithmetic.read(c) for c in middle], dtype=variety.arithmetic.dtype)
    for rotation, translation in zip(*variety.forward(q)[1][body], strict=True):
        yield rotation, rotation @ point + translation - point


def _half_turn(rotation: Array) -> list[Real]:
    """The vector part of a rotation's unit quaternion, whose scalar part is positive."""
    scalar = CONTEXT.sqrt(CONTEXT.mpf(1 + rotation[0, 0] + rotation[1, 1] + rotation[2, 2])) / 2
    return [(rotation[(k + 2) % 3, (k + 1) % 3] - rotation[(k + 1) % 3, (k + 2) % 3]) / (4 * scalar) for k in range(3)]


def _rotation_vector(rotation: Array) -> list[Real]:
    half = _half_turn(rotation)
    sine = CONTEXT.sqrt(sum(c * c for c in half))
    if sine < STRAIGHT**2:
        return [2 * c for c in half]
    return [2 * CONTEXT.asin(min(sine, CONTEXT.one)) / sine * c for c in half]

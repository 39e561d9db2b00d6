"""What a configuration is asked for by: a coordinate of a joint, a rotation of a spherical one, the pose of a body.

Names are those of `symscrew.kinematics.coordinate_names`. Displacements of a body are of the centre of its joints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import Joint, Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinematics import (
    BODY_PARTS,
    SPHERICAL_PARTS,
    Doubles,
    PoseRow,
    half_turn,
    nearest_names,
    pose_read,
    pose_rows,
    rotation_vector,
    typable_names,
    virtual_joint,
)
from symscrew.mobility.finite import Array, ClosureVariety
from symscrew.mobility.joint_network import Edge, Network, edge_of
from symscrew.mobility.screw_systems import Real

DIFFERENCE = 1e-6
"""Half the step of central differences in doubles: right to ten digits, of which each refinement gains as many."""
STRAIGHT = 1e-10
"""Half a rotation vector shorter than this [rad] is its quaternion's vector part, to better than rounding."""
VECTOR = "xyz"
Poses = Mapping[str, tuple[Array, Array]]
Reader = Callable[[Array, Array], Real]
"""(rotation, displacement) -> a number of them."""
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


def targets_of(mechanism: Mechanism, network: Network, given: Mapping[str, sympy.Expr]) -> list[Target]:
    """The targets that names and their exact values [rad, m] mean.

    Raises:
        DescriptionError: no joint or body of this name, or it has no such coordinate.
    """
    virtual = virtual_joint(mechanism)
    found: list[Target] = []
    poses: dict[str, dict[str, Real]] = {}
    for name, value in given.items():
        owner, _, part = name.partition(".")
        goal = high_precision(value)
        if virtual is not None and owner == virtual.name:
            found.append(_of_virtual(mechanism, network, virtual, (name, part, goal)))
        elif owner in network.edges:
            found.append(_of_joint(mechanism, network, network.edges[owner], (name, part, goal)))
        elif owner not in network.bodies:
            known = [*mechanism.parameters, *network.bodies, *typable_names(mechanism)]
            raise DescriptionError(f"at {name}: no parameter, joint or body of this name; {nearest_names(name, known)}")
        elif part not in BODY_PARTS:
            angles = ".rx, .ry, .rz, .tilt, .azimuth, .torsion, .roll, .pitch, .yaw [rad]"
            raise DescriptionError(
                f"at {name}: expected {owner}.x, .y, .z [m], {angles}, .turn, or .qx, .qy, .qz of a body"
            )
        else:
            poses.setdefault(owner, {})[part] = goal
    for body, given_parts in poses.items():
        found += _of_pose(network, body, given_parts)
    return found


def _of_pose(network: Network, body: str, parts: Mapping[str, Real]) -> list[Target]:
    """The pose of a body, or some of it."""

    exact, doubles = (pose_rows(parts, arithmetic, CONTEXT.tan) for arithmetic in (CONTEXT, Doubles()))
    last: list[tuple[ClosureVariety, Array, Poses]] = []

    def target(row: PoseRow, fast: PoseRow) -> Target:
        def read(variety: ClosureVariety, q: Array) -> Array:
            if not last or last[0][0] is not variety or not np.array_equal(last[0][1], q):  # once for all its numbers
                last[:] = [(variety, q.copy(), variety.forward(q)[1])]
            return _read(variety, last[0][2], body, (row.of, fast.of))

        return Target(row.goal / network.length if row.is_length else row.goal, read)

    return [target(*rows) for rows in zip(exact, doubles, strict=True)]


def _of_joint(mechanism: Mechanism, network: Network, edge: Edge, asked: tuple[str, str, Real]) -> Target:
    """A coordinate of a joint."""
    _, part, goal = asked
    spherical = [column for motion, column in edge.motions if motion.spherical]
    if not spherical or part not in SPHERICAL_PARTS:
        return _single(mechanism, network, edge, asked)
    first, axis = spherical[0], VECTOR.index(part[1])
    turned = _quaternion_of if part[0] == "q" else _vector_of
    column = first + axis if part[0] == "r" else None
    return Target(goal, lambda _, q: _each(turned(v)[axis] for v in q[:, first : first + 3]), column)


def _of_virtual(mechanism: Mechanism, network: Network, joint: Joint, asked: tuple[str, str, Real]) -> Target:
    """A coordinate of the joint on which the package hangs the platform: of its point's place, of its turn."""
    name, part, goal = asked
    edge, body = edge_of(mechanism, joint, network.length, 0), joint.child
    if part in SPHERICAL_PARTS and joint.kind.freedom == SPATIAL:
        axis, read = VECTOR.index(part[1]), half_turn if part[0] == "q" else rotation_vector
        of = (lambda r, _: read(r, CONTEXT)[axis], lambda r, _: read(r, Doubles())[axis])
        return Target(goal, lambda variety, q: _read(variety, variety.forward(q)[1], body, of))
    singles = [(motion, column) for motion, column in edge.motions if motion.single]
    if not part.isdecimal() or int(part) >= len(singles):
        numbers = ", ".join(f".{k}" for k in range(len(singles)))
        turned = " or .qx, .qy, .qz, .rx, .ry, .rz" if joint.kind.freedom == SPATIAL else ""
        raise DescriptionError(f"at {name}: expected {joint.name} with {numbers}{turned}")
    place = int(part)
    motion, column = singles[place]
    screw = edge.screws[column]
    reference = _reference(mechanism, joint, place)
    goal, length = goal - reference, network.length

    readers = (
        lambda r, _: _along(screw[:3], rotation_vector(r, CONTEXT)),
        lambda r, _: _along([float(c) for c in screw[:3]], rotation_vector(r, Doubles())),
    )

    def turned_by(variety: ClosureVariety, q: Array) -> Array:
        return _read(variety, variety.forward(q)[1], body, readers)

    def shifted_by(variety: ClosureVariety, q: Array) -> Array:
        return _each(_along(screw[3:], t) for _, t in _moved(variety, variety.forward(q)[1], body, edge.point))

    return Target(goal, turned_by) if motion.turns else Target(goal / length, shifted_by)


def _along(axis: Sequence[Real], vector: Iterable[Real]) -> Real:
    return sum(a * b for a, b in zip(axis, vector, strict=True))


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
    start = _reference(mechanism, mechanism.joints[edge.name], place)
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


def _read(variety: ClosureVariety, poses: Poses, body: str, of: tuple[Reader, Reader]) -> Array:
    """A number of the pose of a body, at each of some points by the first reader; of doubles by the second, at all."""
    if variety.arithmetic.dtype is object:
        return _each(of[0](r, t) for r, t in _moved(variety, poses, body))
    rotations, places = (np.array(part) for part in zip(*_moved(variety, poses, body), strict=True))
    return np.asarray(of[1](np.moveaxis(rotations, 0, -1), places.T))


def _moved(
    variety: ClosureVariety, poses: Poses, body: str, place: Sequence[Real] | None = None
) -> Iterator[tuple[Array, Array]]:
    """(rotation, displacement of a place) of a body from the reference, at every point.

    The place is the centre of the body's joints unless one is given.
    """
    points = [e.point for e in variety.network.edges.values() if body in (e.parent, e.child)]
    points = points if place is None else [tuple(place)]
    middle = [sum(p[k] for p in points) / len(points) - variety.centre[k] for k in range(3)]
    point = np.array([variety.arithmetic.read(c) for c in middle], dtype=variety.arithmetic.dtype)
    for rotation, translation in zip(*poses[body], strict=True):
        yield rotation, rotation @ point + translation - point


def read_coordinates(mechanism: Mechanism, variety: ClosureVariety, point: Array) -> dict[str, float]:
    """Every coordinate of the joints and of the platform by name at one point [rad, m]; what `targets_of` takes."""
    network, found = variety.network, dict[str, float]()
    for edge in network.edges.values():
        joint = mechanism.joints[edge.name]
        for k, (label, (motion, column)) in enumerate(
            zip(joint.kind.motion_names(joint.name), edge.motions, strict=True)
        ):
            if motion.spherical:
                found |= {f"{joint.name}.r{c}": float(point[column + i]) for i, c in enumerate(VECTOR)}
            else:
                moved = point[column] * network.length if motion.prismatic else point[column]
                found[label] = float(_reference(mechanism, joint, k) + moved)
    poses = variety.forward(point[None])[1]
    virtual = virtual_joint(mechanism)
    if virtual is not None:
        found |= _read_virtual(mechanism, variety, virtual, poses)
    if mechanism.platform is not None:
        for r, t in _moved(variety, poses, mechanism.platform):
            read = pose_read(r, t * network.length, CONTEXT)
            found |= {f"{mechanism.platform}.{part}": float(value) for part, value in read.items()}
    return found


def _read_virtual(mechanism: Mechanism, variety: ClosureVariety, joint: Joint, poses: Poses) -> dict[str, float]:
    """The coordinates of the joint on which the package hangs the platform."""
    found: dict[str, float] = {}
    edge = edge_of(mechanism, joint, variety.network.length, 0)
    ((r, t),) = _moved(variety, poses, joint.child, edge.point)
    vector = rotation_vector(r, CONTEXT)
    for k, (label, (motion, column)) in enumerate(zip(joint.kind.motion_names(joint.name), edge.motions, strict=True)):
        if motion.spherical:
            found |= {f"{joint.name}.r{c}": float(v) for c, v in zip(VECTOR, vector, strict=True)}
        else:
            screw = edge.screws[column]
            moved = _along(screw[:3], vector) if motion.turns else _along(screw[3:], t) * variety.network.length
            found[label] = float(_reference(mechanism, joint, k) + moved)
    return found


def _reference(mechanism: Mechanism, joint: Joint, place: int) -> Real:
    """The value of a joint's coordinate in the reference configuration [rad, m]."""
    given = joint.reference
    return high_precision(mechanism.number(given[place])) if place < len(given) else CONTEXT.zero

"""Displacements of joints, in the tree or closing a loop, as nodes."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Matrix, Node, Tape, Vector, cross, dot, product, subtract, transform, transpose
from symscrew.description import Joint
from symscrew.kinematics.cut_joints import Cut
from symscrew.kinematics.loop_closure import hub_angle, relative_rotation
from symscrew.kinematics.system import System

SMALL_ANGLE = 1e-8
"""Below this sine [rad] a rotation vector is its axial part times the limit of angle / sine, to better than a double's
last digit: the next term is the square of it; above it the quotient is divided, which is exact to rounding."""


def tree_displacement(system: System, joint: Joint) -> list[Node]:
    """Displacements of a joint of the tree: its coordinates, a spherical one as rotation vector."""
    links = system.tree.links_of(joint.name)
    values: list[Node] = []
    for link in links[::-1] if links and links[0].inverted else links:
        entries = list(system.inputs.q[link.q])
        values += rotation_vector(system.tape, entries) if link.motion.spherical else entries
    return values


def rotation_vector(tape: Tape, quaternion: Sequence[Node]) -> list[Node]:
    """Rotation vector [rad] of a unit quaternion (w, x, y, z), smooth through the identity; angle up to pi."""
    w, x, y, z = quaternion
    half_sine = tape.sqrt(x * x + y * y + z * z)
    small = tape.function("less", half_sine, tape.constant(SMALL_ANGLE))
    safe = tape.function("select", small, tape.one, half_sine)
    negative = tape.function("less", w, tape.zero)
    sign = tape.function("select", negative, -tape.one, tape.one)
    angle = 2 * tape.function("atan2", half_sine, sign * w)
    factor = sign * tape.function("select", small, tape.node(2), angle / safe)
    return [factor * x, factor * y, factor * z]


def whole_rotation_vector(system: System, cut: Cut) -> list[Node]:
    """Rotation vector [rad] of a cut ball joint, parent's axes, exact up to half a turn, where the axial part vanishes.

    By the quaternion whose largest component is found first: 4 q_i q_k are sums of the matrix's entries.
    """
    tape, m = system.tape, _ball_rotation(system, cut)
    diagonal = [1 + m[0][0] + m[1][1] + m[2][2], *(1 + 2 * m[i][i] - m[0][0] - m[1][1] - m[2][2] for i in range(3))]
    away = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    rows = [[diagonal[0], *away]]
    for i in range(3):
        both = [m[i][j] + m[j][i] if j != i else diagonal[1 + i] for j in range(3)]
        rows.append([away[i], *both])
    largest, row = diagonal[0], rows[0]
    for size, other in zip(diagonal[1:], rows[1:], strict=True):
        less = tape.function("less", largest, size)
        largest = tape.function("select", less, size, largest)
        row = [tape.function("select", less, b, a) for a, b in zip(row, other, strict=True)]
    scale = 1 / (2 * tape.sqrt(tape.node(largest)))
    return rotation_vector(tape, [tape.node(entry * scale) for entry in row])


def _ball_rotation(system: System, cut: Cut) -> Matrix:
    """Rotation of a cut ball joint's child against its parent, axes that the parent carries."""
    relative = relative_rotation(cut, system.linkage)
    axes = system.frames[cut.tip].axes
    in_body = product(product(axes, relative), transpose(axes))
    return in_body if cut.tip_is_parent else transpose(in_body)


def cut_displacement(system: System, cut: Cut) -> list[Node]:
    """Displacements of a cut joint from the relative pose of its bodies."""
    tape, linkage = system.tape, system.linkage
    kind = cut.joint.kind
    motions = kind.motions
    references = cut.joint.reference or (0,) * len(motions)
    offset = [system.geometry.scalar(r) if r != 0 else tape.zero for r in references]
    if kind.ball:
        return whole_rotation_vector(system, cut)
    gap = _gap_child_from_parent(system, cut)
    sign = 1 if cut.tip_is_parent else -1
    values: list[Node] = []
    turns = iter(_universal_angles(system, cut) if kind.universal else [])
    axes = cut.tip_axes
    for position, m in enumerate(motions):
        if m.prismatic:
            value = dot(axes[m.axis or 0], gap)
        elif kind.universal:
            value = next(turns)
        else:
            value = sign * hub_angle(cut, linkage, system.geometry)
        values.append(tape.node(value) + offset[position])
    return values


def _gap_child_from_parent(system: System, cut: Cut) -> Vector:
    """From the parent's joint point to the child's, tip axes."""
    back = transpose(system.pose[cut.tip].rotation)
    tip, hub = system.pose[cut.tip].point(cut.tip_point), system.pose[cut.hub].point(cut.hub_point)
    return transform(back, subtract(hub, tip) if cut.tip_is_parent else subtract(tip, hub))


def _universal_angles(system: System, cut: Cut) -> list[Node]:
    """Both angles of a cut universal joint, parent's axis first, each from how it turns the other's axis."""
    tape = system.tape
    first_reference, second_reference = cut.tip_axes
    carried = [system.linkage.carry(cut.hub, cut.tip, axis) for axis in cut.hub_axes]
    # seen from the tip, the hub's copies of the two axes; the own axis of the tip stays
    if cut.tip_is_parent:
        theta1 = _angle_about(tape, first_reference, second_reference, carried[1])
        back = [system.linkage.carry(cut.tip, cut.hub, axis) for axis in cut.tip_axes]
        theta2 = -1 * _angle_about(tape, cut.hub_axes[1], cut.hub_axes[0], back[0])
    else:
        back = [system.linkage.carry(cut.tip, cut.hub, axis) for axis in cut.tip_axes]
        theta1 = _angle_about(tape, cut.hub_axes[0], cut.hub_axes[1], back[1])
        theta2 = -1 * _angle_about(tape, second_reference, first_reference, carried[0])
    return [theta1, theta2]


def _angle_about(tape: Tape, axis: Vector, start: Vector, end: Vector) -> Node:
    """Angle about `axis` that turns `start` into `end` (their components across the axis)."""
    sine = dot(axis, cross(start, end))
    cosine = dot(start, end) - dot(axis, start) * dot(axis, end)
    return tape.function("atan2", sine, cosine)

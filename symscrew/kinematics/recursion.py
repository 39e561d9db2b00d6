"""Recursions over the tree in link frames: placements, poses, rates, inertial wrenches.

The same quantities as the screws of `screws_at_origin`, referred to a point that moves with each link and to the
link's own axes: constants fold, linear velocities drop out of the dynamics, and a third of the operations is left.
A test holds the two against each other for every mechanism.

With U = [alpha]x + [omega]x^2 the acceleration of a point r of a link is a_o + U r. The link's inertia then
enters through its mass m, first moment s and second moment matrix Sigma about the link's origin:
force m a_o + U s, moment s x a_o + axial(U Sigma): the rate of the momentum screw, referred to the origin.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Node,
    Pose,
    Tape,
    Twist,
    Vector,
    add,
    cross,
    dot,
    product,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.description import Body, Mechanism
from symscrew.kinematics.link_frames import Frame, Geometry, quarter_turns
from symscrew.kinematics.tree import Link, Tree


@dataclass(frozen=True)
class Placement:
    """Where a link is on its parent, for given coordinates.

    `turn` rotates link axes to the axes before the motion, `rotation` those to the parent's axes; `offset`
    is the link's origin in the parent's coordinates.
    """

    rotation: Matrix
    turn: Matrix
    offset: Vector

    def outwards(self, vector: Vector) -> Vector:
        """A vector from parent axes to link axes."""
        return transform(transpose(self.turn), transform(transpose(self.rotation), vector))

    def before(self, vector: Vector) -> Vector:
        """A vector from link axes to the axes before the joint's motion."""
        return transform(self.turn, vector)

    def inwards(self, vector: Vector) -> Vector:
        """A vector from link axes to parent axes."""
        return transform(self.rotation, transform(self.turn, vector))


@dataclass(frozen=True)
class Rates:
    """Angular velocity, angular acceleration, acceleration of the origin, and U; link axes."""

    omega: Vector
    alpha: Vector
    origin: Vector
    matrix: Matrix

    def at(self, point: Vector) -> Vector:
        """Acceleration of the point of the link at `point` (link coordinates)."""
        return add(self.origin, transform(self.matrix, point))


@dataclass(frozen=True)
class Inertia:
    """Mass, first moment and second moment matrix about the link's origin, link axes."""

    mass: Node
    first: Vector
    second: Matrix


def cosine_sine(tape: Tape, frame: Frame, q: Node) -> tuple[Node, Node]:
    """Cosine and sine of a revolute link's angle q + phase."""
    turns = quarter_turns(frame.phase)
    if turns is None and frame.phase.value is not None:
        angle = q + frame.phase
        return tape.function("cos", angle), tape.function("sin", angle)
    if turns is not None:
        c, s = tape.function("cos", q), tape.function("sin", q)
        return ((c, s), (-s, c), (-c, -s), (s, -c))[turns]
    assert frame.start is not None  # revolute and helical links have it
    c, s = tape.function("cos", q - frame.reference), tape.function("sin", q - frame.reference)
    cos_phase, sin_phase = frame.start
    return c * cos_phase - s * sin_phase, s * cos_phase + c * sin_phase


def quaternion_matrix(w: Node, x: Node, y: Node, z: Node) -> Matrix:
    """Rotation matrix of a unit quaternion, child axes to parent axes."""
    x2, y2, z2 = 2 * x, 2 * y, 2 * z
    xx, yy, zz, xy, xz, yz = x * x2, y * y2, z * z2, x * y2, x * z2, y * z2
    wx, wy, wz = w * x2, w * y2, w * z2
    return (
        (1 - (yy + zz), xy - wz, xz + wy),
        (xy + wz, 1 - (xx + zz), yz - wx),
        (xz - wy, yz + wx, 1 - (xx + yy)),
    )


def placements(
    tape: Tape,
    tree: Tree,
    frames: Sequence[Frame],
    q: Sequence[Node],
    turns: dict[int, tuple[Node, Node]] | None = None,
) -> tuple[Placement, ...]:
    """The placement of every link; `turns` gives cosine and sine of links whose angle is not needed."""
    result = [Placement(IDENTITY, IDENTITY, ZERO)]
    for link, frame in zip(tree.links[1:], frames[1:], strict=True):
        kind = link.motion.kind
        turn: Matrix = IDENTITY
        offset = frame.offset
        if kind == "S":
            w, x, y, z = q[link.q]
            turn = quaternion_matrix(w, x, y, z)
        elif kind == "F":
            pass
        elif kind == "P":
            # offset along the sliding direction and q are one sum: phase + q + constant
            along = q[link.q.start] + frame.phase
            offset = _slide(tape, frame, along)
        else:
            c, s = (turns or {}).get(link.index) or cosine_sine(tape, frame, q[link.q.start])
            turn = ((c, -s, 0), (s, c, 0), (0, 0, 1))
            if kind == "H":
                lift = frame.pitch * (q[link.q.start] - frame.reference)
                offset = add(offset, scale(lift, frame.axis))
        result.append(Placement(frame.rotation, turn, offset))
    return tuple(result)


def _slide(tape: Tape, frame: Frame, along: Node) -> Vector:
    if all(tape.node(c).value is not None for c in (*frame.axis, *frame.offset)):
        # collect constants first, so that an offset along the axis costs no operation of its own
        start = dot(frame.offset, frame.axis)
        return add(subtract(frame.offset, scale(start, frame.axis)), scale(along + start, frame.axis))
    return add(frame.offset, scale(along, frame.axis))


def poses(tree: Tree, placed: Sequence[Placement]) -> tuple[Pose, ...]:
    """absolute_T_link of every link."""
    result = [Pose()]
    for link in tree.links[1:]:
        here, parent = placed[link.index], result[link.parent]
        rotation = product(product(parent.rotation, here.rotation), here.turn)
        result.append(Pose(rotation, parent.point(here.offset)))
    return tuple(result)


def twists(tree: Tree, frames: Sequence[Frame], placed: Sequence[Placement], v: Sequence[Node]) -> tuple[Twist, ...]:
    """Twist of every link at its own origin in its own axes."""
    result = [Twist(ZERO, ZERO)]
    for link in tree.links[1:]:
        here, parent = placed[link.index], result[link.parent]
        own = own_screws(link, frames[link.index], v)
        linear = here.outwards(add(parent.velocity_at(here.offset), own.linear))
        result.append(Twist(add(here.outwards(parent.angular), own.angular), linear))
    return tuple(result)


def own_screws(link: Link, frame: Frame, v: Sequence[Node]) -> Twist:
    """What the joint adds: angular part in link axes, linear part in parent axes."""
    kind = link.motion.kind
    if kind == "F":
        return Twist(ZERO, ZERO)
    if kind == "S":
        x, y, z = v[link.v]
        return Twist((x, y, z), ZERO)
    rate = v[link.v.start]
    if kind == "P":
        return Twist(ZERO, scale(rate, frame.axis))
    linear = scale(frame.pitch * rate, frame.axis) if kind == "H" else ZERO
    return Twist((0, 0, rate), linear)


def rates(
    tree: Tree,
    frames: Sequence[Frame],
    placed: Sequence[Placement],
    v: Sequence[Node],
    a: Sequence[Node],
    ground: Rates | None = None,
) -> tuple[Rates, ...]:
    """Rates of every link; `ground` carries gravity as the ground's acceleration -g, and a moving base."""
    result = [ground or Rates(ZERO, ZERO, ZERO, ((0, 0, 0),) * 3)]
    for link in tree.links[1:]:
        frame, here, parent = frames[link.index], placed[link.index], result[link.parent]
        speed, gain = own_screws(link, frame, v), own_screws(link, frame, a)
        carried = add(parent.at(here.offset), gain.linear)
        if speed.linear is not ZERO:
            carried = add(carried, cross(scale(2, parent.omega), speed.linear))
        if link.motion.kind in "PF":
            result.append(Rates(parent.omega, parent.alpha, carried, parent.matrix))
            continue
        before = here.outwards(parent.omega)
        omega = add(before, speed.angular)
        alpha = add(add(here.outwards(parent.alpha), gain.angular), cross(before, speed.angular))
        result.append(Rates(omega, alpha, here.outwards(carried), acceleration_matrix(omega, alpha)))
    return tuple(result)


def acceleration_matrix(omega: Vector, alpha: Vector) -> Matrix:
    """U = [alpha]x + [omega]x^2."""
    x, y, z = omega
    xx, yy, zz, xy, xz, yz = x * x, y * y, z * z, x * y, x * z, y * z
    return (
        (-(yy + zz), xy - alpha[2], xz + alpha[1]),
        (xy + alpha[2], -(xx + zz), yz - alpha[0]),
        (xz - alpha[1], yz + alpha[0], -(xx + yy)),
    )


def link_inertias(mechanism: Mechanism, tree: Tree, frames: Sequence[Frame], geometry: Geometry) -> tuple[Inertia, ...]:
    """Inertia of every link: the sum over the bodies that it carries (massless: zeros)."""
    result = []
    for link, frame in zip(tree.links, frames, strict=True):
        total = Inertia(geometry.tape.zero, ZERO, ((0, 0, 0),) * 3)
        for name in link.bodies if link.index else ():
            total = combined(geometry, total, body_inertia(mechanism.bodies[name], frame, geometry))
        result.append(total)
    return tuple(result)


def body_inertia(body: Body, frame: Frame, geometry: Geometry) -> Inertia:
    """A body's inertia about the origin of its link, link axes."""
    if body.mass is None or body.com is None:
        return Inertia(geometry.tape.zero, ZERO, ((0, 0, 0),) * 3)
    mass = geometry.scalar(body.mass)
    away = subtract(geometry.vector(body.com), frame.origin)
    com = geometry.settle(transform(transpose(frame.axes), away))
    second: Matrix = ((0, 0, 0),) * 3
    if body.inertia is not None:
        rows = tuple(geometry.vector(row) for row in body.inertia)
        local = product(product(transpose(frame.axes), (rows[0], rows[1], rows[2])), frame.axes)
        trace = geometry.settle((local[0][0] + local[1][1] + local[2][2], 0, 0))[0]
        second = tuple(  # type: ignore[assignment]
            tuple((_half(geometry, trace) if i == j else 0) - local[i][j] for j in range(3)) for i in range(3)
        )
    spread = tuple(tuple(second[i][j] + mass * com[i] * com[j] for j in range(3)) for i in range(3))
    return Inertia(mass, geometry.settle(scale(mass, com)), geometry.settle_matrix(spread))  # type: ignore[arg-type]


def _half(geometry: Geometry, node: Node) -> Node:
    return node * geometry.tape.reciprocal(geometry.tape.node(2))


def combined(geometry: Geometry, a: Inertia, b: Inertia) -> Inertia:
    """The inertia of two bodies on one link, about the same origin."""
    second = tuple(add(x, y) for x, y in zip(a.second, b.second, strict=True))
    return Inertia(a.mass + b.mass, geometry.settle(add(a.first, b.first)), geometry.settle_matrix(second))  # type: ignore[arg-type]


def regrouped(
    tree: Tree, frames: Sequence[Frame], inertia: Sequence[Inertia], geometry: Geometry
) -> tuple[Inertia, ...]:
    """Inertias with the same generalised forces of the tree and fewer numbers in them.

    What lies on a revolute joint's axis moves with the parent just as well: mass, first moment along the
    axis, and as much second moment along it as makes J_xx vanish. What a slider adds to its parent's angular
    inertia is the parent's. (Khalil and Dombre, Modeling, Identification and Control of Robots, 2002, sec. 9.4:
    base inertial parameters.) The drives and the multipliers of cut joints are unchanged; the reactions
    inside the tree are not, so they are computed from the inertias as given. Only constants are regrouped.
    """
    result = list(inertia)
    for link in reversed(tree.links[1:]):
        own, frame = result[link.index], frames[link.index]
        if not _constant(geometry, own, frame) or not _constant(geometry, result[link.parent], frame):
            continue
        zero = geometry.tape.zero
        if link.motion.kind == "P":
            moved = Inertia(zero, ZERO, own.second)
            result[link.index] = Inertia(own.mass, own.first, ((0, 0, 0),) * 3)
        elif link.motion.kind == "R":
            (xx, xy, xz), (_, yy, yz), (_, _, zz) = own.second
            line = geometry.settle((zz + yy, 0, 0))[0]
            moved = _line_on_axis(frame, own.mass, own.first[2], line)
            left = ((xx, xy, xz), (xy, yy, yz), (xz, yz, -geometry.tape.node(yy)))
            result[link.index] = Inertia(zero, (own.first[0], own.first[1], zero), left)
        elif link.motion.kind == "F":
            moved = _shifted(frame, own)
            result[link.index] = Inertia(zero, ZERO, ((0, 0, 0),) * 3)
        elif link.motion.kind == "S":
            moved = _line_on_axis(frame, own.mass, zero, zero)
            result[link.index] = Inertia(zero, own.first, own.second)
        else:
            continue
        result[link.parent] = combined(geometry, result[link.parent], moved)
    return tuple(result)


def _constant(geometry: Geometry, inertia: Inertia, frame: Frame) -> bool:
    values = (
        inertia.mass,
        *inertia.first,
        *(c for row in inertia.second for c in row),
        *frame.offset,
        *frame.axis,
    )
    return all(geometry.tape.node(v).value is not None for v in values)


def _line_on_axis(frame: Frame, mass: Node, first: Node, second: Node) -> Inertia:
    """A mass distribution along the joint's axis, in the parent's coordinates."""
    r, e = frame.offset, frame.axis
    spread = tuple(
        tuple(mass * r[i] * r[j] + first * (r[i] * e[j] + e[i] * r[j]) + second * e[i] * e[j] for j in range(3))
        for i in range(3)
    )
    return Inertia(mass, add(scale(mass, r), scale(first, e)), spread)  # type: ignore[arg-type]


def _shifted(frame: Frame, inertia: Inertia) -> Inertia:
    """The inertia of a link that is fixed to its parent (equal axes), about the parent's origin."""
    r, s = frame.offset, inertia.first
    spread = tuple(
        tuple(inertia.second[i][j] + r[i] * s[j] + s[i] * r[j] + inertia.mass * (r[i] * r[j]) for j in range(3))
        for i in range(3)
    )
    return Inertia(inertia.mass, add(s, scale(inertia.mass, r)), spread)  # type: ignore[arg-type]


NOTHING: Matrix = ((0, 0, 0),) * 3


def inertial_wrench(inertia: Inertia, rate: Rates, still: Matrix = NOTHING) -> tuple[Vector, Vector]:
    """(force, moment about the link's origin): the rate of the link's momentum screw, link axes.

    The axial vector of U Sigma is written so that a diagonal Sigma costs three operations a component:
    J_x alpha_x + (Sigma_yy - Sigma_zz) omega_y omega_z, and so on. `still` is the part of Sigma whose
    terms in omega are left out.
    """
    force = add(scale(inertia.mass, rate.origin), transform(rate.matrix, inertia.first))
    omega, alpha, matrix = rate.omega, rate.alpha, rate.matrix
    spread = inertia.second
    axial = []
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        spun = spread[y][y] - spread[z][z] - (still[y][y] - still[z][z])
        value = (spread[y][y] + spread[z][z]) * alpha[x]
        value = value + spun * (omega[y] * omega[z])
        value = value + (matrix[z][x] * spread[x][y] - matrix[y][x] * spread[x][z])
        value = value - (omega[z] * omega[x] * still[x][y] - omega[y] * omega[x] * still[x][z])
        axial.append(value + (spread[y][z] - still[y][z]) * (omega[z] * omega[z] - omega[y] * omega[y]))
    return force, add((axial[0], axial[1], axial[2]), cross(inertia.first, rate.origin))

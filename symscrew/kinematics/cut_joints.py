"""Loop closure: a cut joint contributes exactly its reciprocal wrenches.

For every cut joint the wrenches reciprocal to its screws are written in the axes of its tip link (the side
that fewer cut joints share) at the joint's point. Multiplier k times wrench k acts on the tip, its opposite
on the hub. So row k of the closure Jacobian is w_k . (V_tip - V_hub): a wrench with a name, a point and a
unit, and the same rows serve velocities, accelerations (`closure_bias`), positions (`closure_residual`) and
the equilibrium of forces.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from symscrew.algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Node,
    Pose,
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
from symscrew.description import Joint
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import Frame, Placement, Rates
from symscrew.kinematics.tree import GROUND, Tree


@dataclass(frozen=True)
class Row:
    """One reciprocal wrench at the cut point, tip axes: (force ; couple), with its multiplier's label."""

    label: str
    unit: str
    force: Vector
    couple: Vector


@dataclass(frozen=True)
class Cut:
    """A cut joint: its links, its point in both, the axes it has in both, and its rows.

    `hub_point` is the joint's point in the hub, `contact` the hub's point that is now at the tip's point (the
    same unless the joint slides), `arm` the way to it from the hub's origin through the limb, in tip axes (None:
    it is better seen through the hub). `triad` holds in its rows two unit vectors across the joint's single axis
    and the axis, tip axes. `reference` is hub_R_tip in the reference configuration. The rows of `parent_axes`
    are the absolute axes of the reference configuration, carried by the joint's parent, in that link's axes.
    """

    joint: Joint
    tip: int
    hub: int
    tip_point: Vector
    hub_point: Vector
    contact: Vector
    tip_axes: tuple[Vector, ...]
    hub_axes: tuple[Vector, ...]
    triad: Matrix
    reference: Matrix
    parent_axes: Matrix
    tip_is_parent: bool
    arm: Vector | None = None
    rows: tuple[Row, ...] = ()


def cuts(
    tree: Tree, frames: Sequence[Frame], geometry: Geometry, placed: Sequence[Placement], *, through_limbs: bool = True
) -> tuple[Cut, ...]:
    """Every cut joint with its reciprocal wrenches, for given placements of links whose loops are closed.

    Without `through_limbs` places on a hub are seen through the hub: where limbs follow from it, that is known.
    """
    shared = [0] * len(tree.links)
    for joint in tree.cut:
        shared[tree.link_of_body[joint.parent]] += 1
        shared[tree.link_of_body[joint.child]] += 1
    result = []
    for joint in tree.cut:
        parent, child = tree.link_of_body[joint.parent], tree.link_of_body[joint.child]
        parent_first = parent != GROUND and (shared[parent] <= shared[child] or child == GROUND)
        tip, hub = (parent, child) if parent_first else (child, parent)
        cut = _cut(tree, frames, geometry, placed, joint, tip, hub)
        result.append(replace(cut, arm=_arm(tree, placed, cut) if through_limbs else None))
    return tuple(result)


def _cut(
    tree: Tree,
    frames: Sequence[Frame],
    geometry: Geometry,
    placed: Sequence[Placement],
    joint: Joint,
    tip: int,
    hub: int,
) -> Cut:
    point = geometry.vector(joint.point)
    axes = geometry.motion_axes(joint) if joint.axes else ()
    local = []
    for link in (tip, hub):
        back = transpose(frames[link].axes)
        at = geometry.settle(transform(back, subtract(point, frames[link].origin)))
        local.append((at, tuple(geometry.settle(transform(back, axis)) for axis in axes)))
    (tip_point, tip_axes), (hub_point, hub_axes) = local
    tip_is_parent = tree.link_of_body[joint.parent] == tip
    triad = _triad(geometry, joint, tip_axes)
    parent_axes = frames[tip if tip_is_parent else hub].axes
    reference = geometry.settle_matrix(product(transpose(frames[hub].axes), frames[tip].axes))
    contact = carry_point(tree, placed, tip, hub, tip_point) if joint.kind.slides else hub_point
    cut = Cut(
        joint,
        tip,
        hub,
        tip_point,
        hub_point,
        contact,
        tip_axes,
        hub_axes,
        triad,
        reference,
        parent_axes,
        tip_is_parent,
    )
    return replace(cut, rows=reciprocal_rows(cut, geometry, tree, placed))


def _triad(geometry: Geometry, joint: Joint, axes: tuple[Vector, ...]) -> Matrix:
    """Rows: two unit vectors across the joint's single axis, then the axis; the tip's axes if there is none."""
    if len(axes) == 3:
        return (axes[0], axes[1], axes[2])
    if len(axes) != 1:
        return IDENTITY
    axis = axes[0]
    first = geometry.perpendicular(axis)
    return (first, geometry.settle(cross(axis, first)), axis)


def reciprocal_rows(cut: Cut, geometry: Geometry, tree: Tree, placed: Sequence[Placement]) -> tuple[Row, ...]:
    """The wrenches reciprocal to all screws of the joint: 6 minus its freedoms.

    A force along d at the joint's point is reciprocal to rotations through the point and to translations
    across d; a couple along d to translations and to rotations about axes across d. A helical joint adds
    the wrench (e ; -h e).
    """
    kind = cut.joint.kind
    a, b, axis = cut.triad
    rows: list[Row] = []

    def force(direction: Vector, name: str) -> None:
        rows.append(Row(f"{cut.joint.name}.f{name}", "N", direction, ZERO))

    def moment(direction: Vector, name: str) -> None:
        rows.append(Row(f"{cut.joint.name}.m{name}", "N m", ZERO, direction))

    if not kind.slides:
        for direction, name in zip(IDENTITY, "xyz", strict=True):
            force(direction, name)
    elif len(kind.sliding) == 2:
        force(axis, "z")
    else:
        force(a, "x")
        force(b, "y")
    if kind.helical:
        pitch = geometry.scalar(cut.joint.pitch)
        rows.append(Row(f"{cut.joint.name}.fz", "N", axis, scale(-pitch, axis)))
    turning = len(kind.turning)
    if turning == 0 and not kind.spherical:
        for direction, name in zip(IDENTITY, "xyz", strict=True):
            moment(direction, name)
    elif turning == 1:
        moment(a, "x")
        moment(b, "y")
    elif turning == 2:
        first, second = universal_axes(cut, tree, placed)
        moment(cross(first, second), "n")
    return tuple(rows)


def drive_row(cut: Cut, freedom: int, tree: Tree, placed: Sequence[Placement]) -> Row:
    """The unit wrench of a drive on a freedom of a cut joint: a force along, or a couple about its axis."""
    kind = cut.joint.kind
    motion = kind.freedoms[freedom]
    if motion.spherical:
        axis = cut.parent_axes[freedom - kind.freedoms.index(motion)]
        axis = axis if cut.tip_is_parent else carry(tree, placed, cut.hub, cut.tip, axis)
    elif kind.universal:
        axis = universal_axes(cut, tree, placed)[motion.axis or 0]
    else:
        axis = cut.tip_axes[motion.axis or 0]
    name = f"{cut.joint.name}.drive{freedom}"
    return Row(name, "N", axis, ZERO) if motion.prismatic else Row(name, "N m", ZERO, axis)


def universal_axes(cut: Cut, tree: Tree, placed: Sequence[Placement]) -> tuple[Vector, Vector]:
    """Present axes of a cut universal joint in tip axes: the first is carried by the parent, the second by
    the child."""
    carried = tuple(carry(tree, placed, cut.hub, cut.tip, axis) for axis in cut.hub_axes)
    return (cut.tip_axes[0], carried[1]) if cut.tip_is_parent else (carried[0], cut.tip_axes[1])


def carry(
    tree: Tree, placed: Sequence[Placement], source: int, target: int, vector: Vector, *, before: bool = False
) -> Vector:
    """A vector from the axes of one link to those of another, along the tree's path between them.

    With `before` it ends in the axes that the target has before its own motion.
    """
    down, up = tree.path(source), tree.path(target)
    common = set(down) & set(up)
    for link in down:
        if link in common:
            break
        vector = placed[link].inwards(vector)
    if target in common or target == GROUND:
        return placed[target].before(vector) if before else vector
    for link in reversed([u for u in up if u not in common]):
        if before and link == target:
            return transform(transpose(placed[link].rotation), vector)
        vector = placed[link].outwards(vector)
    return vector


def carry_before(tree: Tree, placed: Sequence[Placement], source: int, target: int, vector: Vector) -> Vector:
    """A vector from the axes that a link has before its own motion to the axes of another link outside it."""
    return carry(tree, placed, tree.links[source].parent, target, transform(placed[source].rotation, vector))


def carry_point(
    tree: Tree, placed: Sequence[Placement], source: int, target: int, point: Vector, *, before: bool = False
) -> Vector:
    """A point from the coordinates of one link to those of another, along the tree's path between them.

    With `before` in the axes that the target has before its own motion.
    """
    down, up = tree.path(source), tree.path(target)
    common = set(down) & set(up)
    for link in down:
        if link in common:
            break
        point = add(placed[link].inwards(point), placed[link].offset)
    if target in common or target == GROUND:
        return placed[target].before(point) if before else point
    for link in reversed([u for u in up if u not in common]):
        if before and link == target:
            back = transpose(placed[link].rotation)
            return subtract(transform(back, point), transform(back, placed[link].offset))
        point = placed[link].outwards(subtract(point, placed[link].offset))
    return point


def carry_across(tree: Tree, placed: Sequence[Placement], source: int, target: int, vector: Vector) -> Vector:
    """A vector from the axes that one link has before its motion to those that another one has."""
    if source == target:
        return vector
    if source != GROUND:
        vector = transform(placed[source].rotation, vector)
    return carry(tree, placed, tree.links[source].parent, target, vector, before=target != GROUND)


def seen_before(tree: Tree, placed: Sequence[Placement], source: int, target: int, point: Vector) -> Vector:
    """A point of a link from another one's origin, in the axes that the latter has before its motion.

    It is the sum of where the link's origin is, which several of its points share, and of the point's turned place.
    """
    turned = point if source == GROUND else placed[source].before(point)
    origin = carry_point(tree, placed, source, target, ZERO, before=True)
    return add(origin, carry_across(tree, placed, source, target, turned))


def velocity_across(
    tree: Tree, placed: Sequence[Placement], twist: Twist, source: int, target: int, point: Vector
) -> Vector:
    """Velocity of a link's point in the axes that another one has before its motion; `twist`: the link's own."""
    spin = placed[source].before(twist.angular)
    moved = add(placed[source].before(twist.linear), cross(spin, placed[source].before(point)))
    return carry_across(tree, placed, source, target, moved)


def acceleration_across(
    tree: Tree, placed: Sequence[Placement], rates: Rates, source: int, target: int, point: Vector
) -> Vector:
    """Acceleration of a link's point in the axes that another one has before its motion; `rates`: the link's own."""
    turned = transform(product(placed[source].turn, rates.matrix), point)
    return carry_across(tree, placed, source, target, add(placed[source].before(rates.origin), turned))


def closure_bias(
    cut: Cut,
    tree: Tree,
    placed: Sequence[Placement],
    twist: Sequence[Twist],
    rate: Sequence[Rates],
) -> tuple[Node, ...]:
    """The part of d/dt (w_k . (V_tip - V_hub)) that is free of the accelerations in `rate` or adds to them.

    With `rate` taken at a = 0 this is (dJ/dt) v; the closure of accelerations is J a + bias = 0. In the tip's
    own axes only the couple of a universal joint moves.
    """

    def seen(vector: Vector) -> Vector:
        return carry(tree, placed, cut.hub, cut.tip, vector)

    tip, hub = rate[cut.tip], rate[cut.hub]
    at_contact = _hub_acceleration(cut, tree, placed, hub)
    omega = subtract(seen(hub.omega), tip.omega)
    alpha = subtract(subtract(seen(hub.alpha), tip.alpha), cross(tip.omega, omega))
    linear = subtract(at_contact, tip.at(cut.tip_point))
    if cut.joint.kind.slides:
        # the hub's point that is now at the tip's point slides relative to it
        slide = subtract(seen(twist[cut.hub].velocity_at(cut.contact)), twist[cut.tip].velocity_at(cut.tip_point))
        linear = subtract(linear, cross(add(scale(2, tip.omega), omega), slide))
    result = []
    for row in cut.rows:
        value = dot(row.force, linear) + dot(row.couple, alpha)
        if cut.joint.kind.universal and row.unit == "N m":
            first, second = universal_axes(cut, tree, placed)
            moving = cross(first, cross(omega, second)) if cut.tip_is_parent else cross(cross(omega, first), second)
            value = value + dot(moving, omega)
        result.append(-value)
    return tuple(result)


def _arm(tree: Tree, placed: Sequence[Placement], cut: Cut) -> Vector | None:
    """From the hub's origin to the contact through the limb, tip axes; None where the way through the hub is shorter.

    Where the loops are closed, a hub that turns about a point of the limb's base has it through the limb just as
    well, and there most of it is constant or zero: a leg on its universal joint sees the centre in a plane of its own.
    """
    if cut.hub == GROUND:
        return None
    hub = tree.links[cut.hub]
    limb = tree.path(cut.tip)
    if not hub.motion.spherical or cut.hub in limb or hub.parent not in (GROUND, *limb):
        return None
    return subtract(cut.tip_point, carry_point(tree, placed, hub.parent, cut.tip, placed[cut.hub].offset))


def on_hub(cut: Cut, tree: Tree, placed: Sequence[Placement], force: Vector, couple: Vector) -> tuple[Vector, Vector]:
    """A wrench at the cut joint (tip axes) as force and moment about the hub's origin, axes before the hub's motion."""
    if cut.arm is not None:
        couple = add(couple, cross(cut.arm, force))
    force, couple = (carry(tree, placed, cut.tip, cut.hub, vector, before=True) for vector in (force, couple))
    if cut.arm is None:
        couple = add(couple, cross(placed[cut.hub].before(cut.contact), force))
    return force, couple


def _hub_acceleration(cut: Cut, tree: Tree, placed: Sequence[Placement], hub: Rates) -> Vector:
    """Acceleration of the hub's point at the cut joint, tip axes.

    Where several limbs meet on a spherical hub, its acceleration matrix is rotated once for all of them.
    """
    if cut.arm is not None:
        origin, spin, gain = (carry(tree, placed, cut.hub, cut.tip, x) for x in (hub.origin, hub.omega, hub.alpha))
        return add(origin, add(cross(gain, cut.arm), cross(spin, cross(spin, cut.arm))))
    if cut.hub == GROUND or not tree.links[cut.hub].motion.spherical:
        return carry(tree, placed, cut.hub, cut.tip, hub.at(cut.contact))
    turn = placed[cut.hub].turn
    before = add(transform(turn, hub.origin), transform(product(turn, hub.matrix), cut.contact))
    return carry_before(tree, placed, cut.hub, cut.tip, before)


def closure_rate(cut: Cut, tree: Tree, placed: Sequence[Placement], twist: Sequence[Twist]) -> tuple[Node, ...]:
    """w_k . (V_tip - V_hub) per row, from twists of the links at their origins in their axes."""
    hub, tip = twist[cut.hub], twist[cut.tip]
    if cut.hub == GROUND or not tree.links[cut.hub].motion.spherical:
        velocity = carry(tree, placed, cut.hub, cut.tip, hub.velocity_at(cut.contact))
        omega = carry(tree, placed, cut.hub, cut.tip, hub.angular)
    else:
        turn = placed[cut.hub].turn
        spin = transform(turn, hub.angular)
        before = add(transform(turn, hub.linear), cross(spin, transform(turn, cut.contact)))
        velocity = carry_before(tree, placed, cut.hub, cut.tip, before)
        omega = carry_before(tree, placed, cut.hub, cut.tip, spin)
    slide = subtract(tip.velocity_at(cut.tip_point), velocity)
    turning = subtract(tip.angular, omega)
    return tuple(dot(row.force, slide) + dot(row.couple, turning) for row in cut.rows)


def closure_residual(
    cut: Cut, tree: Tree, placed: Sequence[Placement], pose: Sequence[Pose], geometry: Geometry
) -> tuple[Node, ...]:
    """How far the loop is open, one number per row [m, or rad for couples]; its rate is J v where it is 0."""
    tape = geometry.tape
    back = transpose(pose[cut.tip].rotation)
    gap = transform(back, subtract(pose[cut.tip].point(cut.tip_point), pose[cut.hub].point(cut.hub_point)))
    kind = cut.joint.kind
    turning = len(kind.turning)
    values = [dot(row.force, gap) for row in cut.rows if row.unit == "N"]
    if turning == 1:
        a, b, _ = cut.triad
        carried = carry(tree, placed, cut.hub, cut.tip, cut.hub_axes[-1])
        values += [dot(carried, b), -dot(carried, a)]
    elif turning == 2:
        first, second = universal_axes(cut, tree, placed)
        reference = geometry.tape.settle(dot(cut.tip_axes[0], cut.tip_axes[1]))
        opening = dot(first, second) - reference
        values.append(opening if cut.tip_is_parent else -opening)
    elif not kind.spherical:
        values += _rotation_gap(cut, tree, placed, geometry)
    if kind.helical:
        index = next(i for i, row in enumerate(cut.rows) if row.label.endswith(".fz"))
        values[index] = values[index] + geometry.scalar(cut.joint.pitch) * hub_angle(cut, tree, placed, geometry)
    return tuple(tape.node(v) for v in values)


def hub_angle(cut: Cut, tree: Tree, placed: Sequence[Placement], geometry: Geometry) -> Node:
    """Angle by which the hub has turned about the joint's axis relative to the tip, from the reference [rad]."""
    a, b, _ = cut.triad
    # the hub's copy of the tip's first transverse axis, carried to the tip
    carried = carry(tree, placed, cut.hub, cut.tip, transform(cut.reference, a))
    return geometry.tape.function("atan2", dot(carried, b), dot(carried, a))


def relative_rotation(cut: Cut, tree: Tree, placed: Sequence[Placement]) -> Matrix:
    """Rotation of the hub relative to the tip since the reference configuration, in tip axes."""
    x, y, z = (carry(tree, placed, cut.hub, cut.tip, column) for column in transpose(cut.reference))
    return transpose((x, y, z))


def _rotation_gap(cut: Cut, tree: Tree, placed: Sequence[Placement], geometry: Geometry) -> list[Node]:
    m = relative_rotation(cut, tree, placed)
    half = geometry.tape.reciprocal(geometry.tape.node(2))
    return [-half * (m[2][1] - m[1][2]), -half * (m[0][2] - m[2][0]), -half * (m[1][0] - m[0][1])]

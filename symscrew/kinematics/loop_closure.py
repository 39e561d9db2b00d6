"""How open a cut joint's loop is, how fast it opens, and what its rates add to the acceleration of opening.

Row k is a reciprocal wrench w_k of the joint (`symscrew.kinematics.cut_joints`):

    residual g_k --rate--> w_k . (V_tip - V_hub) = J v --rate--> J a + bias
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import (
    Matrix,
    Node,
    Twist,
    Vector,
    add,
    cross,
    dot,
    named_entries,
    product,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics.cut_joints import Cut, universal_axes
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.kept_joints import SAME_DIRECTION
from symscrew.kinematics.link_quantities import Rates
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.rolling import rolling_bias
from symscrew.kinematics.tree import GROUND


def closure_bias(
    cut: Cut,
    at: Linkage,
    twist: Sequence[Twist],
    rate: Sequence[Rates],
    *,
    v: Sequence[Node],
    a: Sequence[Node] | None = None,
) -> tuple[Node, ...]:
    """The part of d/dt (w_k . (V_tip - V_hub)) that is free of the accelerations in `rate` or adds to them.

    With `rate` taken at a = 0 this is (dJ/dt) v; the closure of accelerations is J a + bias = 0. In the tip's
    own axes only the couple of a universal joint moves. A coupling asks for the rates v of the tree, and for the
    accelerations a that `rate` was taken at (None: 0).
    """
    if cut.relation is not None:
        return _named([cut.relation.bias(v, a)], "opening_bias", cut)
    if cut.touch is not None:
        gained = rolling_bias(at, (cut.tip, cut.hub), cut.touch, twist=twist, rate=rate)
        return _named([dot(row.force, gained) for row in cut.rows], "opening_bias", cut)

    def seen(vector: Vector) -> Vector:
        return at.carry(cut.hub, cut.tip, vector)

    tip, hub = rate[cut.tip], rate[cut.hub]
    at_contact = _hub_acceleration(cut, at, hub)
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
            first, second = universal_axes(cut, at)
            moving = cross(first, cross(omega, second)) if cut.tip_is_parent else cross(cross(omega, first), second)
            value = value + dot(moving, omega)
        result.append(-value)
    return _named(result, "opening_bias", cut)


def _hub_acceleration(cut: Cut, at: Linkage, hub: Rates) -> Vector:
    """Acceleration of the hub's point at the cut joint, tip axes.

    Where several limbs meet on a spherical hub, its acceleration matrix is rotated once for all of them.
    """
    if cut.arm is not None:
        origin, spin, gain = (at.carry(cut.hub, cut.tip, x) for x in (hub.origin, hub.omega, hub.alpha))
        return add(origin, add(cross(gain, cut.arm), cross(spin, cross(spin, cut.arm))))
    if cut.hub == GROUND or not at.tree.links[cut.hub].motion.spherical:
        return at.carry(cut.hub, cut.tip, hub.at(cut.contact))
    turn = at.placed[cut.hub].turn
    before = add(transform(turn, hub.origin), transform(product(turn, hub.matrix), cut.contact))
    return at.carry_before(cut.hub, cut.tip, before)


def closure_rate(cut: Cut, at: Linkage, twist: Sequence[Twist], v: Sequence[Node]) -> tuple[Node, ...]:
    """w_k . (V_tip - V_hub) per row, from twists of the links at their origins in their axes; of couplings from v."""
    if cut.relation is not None:
        return _named([cut.relation.rate(v)], "opening_rate", cut)
    hub, tip = twist[cut.hub], twist[cut.tip]
    if cut.hub == GROUND or not at.tree.links[cut.hub].motion.spherical:
        velocity = at.carry(cut.hub, cut.tip, hub.velocity_at(cut.contact))
        omega = at.carry(cut.hub, cut.tip, hub.angular)
    else:
        turn = at.placed[cut.hub].turn
        spin = transform(turn, hub.angular)
        before = add(transform(turn, hub.linear), cross(spin, transform(turn, cut.contact)))
        velocity = at.carry_before(cut.hub, cut.tip, before)
        omega = at.carry_before(cut.hub, cut.tip, spin)
    slide = subtract(tip.velocity_at(cut.tip_point), velocity)
    turning = subtract(tip.angular, omega)
    return _named([dot(row.force, slide) + dot(row.couple, turning) for row in cut.rows], "opening_rate", cut)


def closure_residual(cut: Cut, at: Linkage, geometry: Geometry) -> tuple[Node, ...]:
    """How far the loop is open, one number per row [m, or rad for couples]; its rate is J v where it is 0.

    Of a joint that slides J v is that of the hub's point which is now at the tip's: the same where v keeps its couples
    closed, else off by how far it slid times how fast they open.
    """
    if cut.relation is not None:
        return _named([cut.relation.residual], "opening", cut)
    if cut.touch is not None:
        return _named([cut.touch.gap if row.holonomic else geometry.tape.zero for row in cut.rows], "opening", cut)
    tape, pose = geometry.tape, at.poses
    back = transpose(pose[cut.tip].rotation)
    gap = transform(back, subtract(pose[cut.tip].point(cut.tip_point), pose[cut.hub].point(cut.hub_point)))
    kind = cut.joint.kind
    turning = len(kind.turning)
    values = [dot(row.force, gap) for row in cut.rows if row.unit == "N"]
    if turning == 1:
        a, b, _ = cut.triad
        carried = at.carry(cut.hub, cut.tip, cut.hub_axes[-1])
        values += [dot(carried, b), -dot(carried, a)]
    elif turning == 2:
        first, second = universal_axes(cut, at)
        reference = geometry.tape.settle(dot(cut.tip_axes[0], cut.tip_axes[1]))
        opening = dot(first, second) - reference
        values.append(opening if cut.tip_is_parent else -opening)
    elif not kind.spherical:
        values += _rotation_gap(cut, at, geometry)
    if kind.helical:
        index = next(i for i, row in enumerate(cut.rows) if row.label.endswith(".fz"))
        values[index] = values[index] + geometry.scalar(cut.joint.pitch) * hub_angle(cut, at, geometry)
    return _named([tape.node(v) for v in values], "opening", cut)


def _named(values: Sequence[Node], quantity: str, cut: Cut) -> tuple[Node, ...]:
    """A value per row of a cut joint."""
    named_entries(values, quantity, [row.label for row in cut.rows])
    return tuple(values)


def hub_angle(cut: Cut, at: Linkage, geometry: Geometry) -> Node:
    """Angle by which the hub has turned about the joint's axis relative to the tip, from the reference [rad].

    Where all that turns on the way from tip to hub turns about parallel axes, it is the sum of these turns: continuous
    over any number of them. Elsewhere it is what the pose says, in (-pi, pi].
    """
    turns = parallel_turns(cut, at, geometry)
    if turns is not None:
        angle = geometry.tape.zero
        for link, sign in turns:
            turned = at.q[at.tree.links[link].q.start] - at.frames[link].reference
            angle = angle + turned if sign > 0 else angle - turned
        return angle
    a, b, _ = cut.triad
    # the hub's copy of the tip's first transverse axis, carried to the tip
    carried = at.carry(cut.hub, cut.tip, transform(cut.reference, a))
    return geometry.tape.function("atan2", dot(carried, b), dot(carried, a))


def parallel_turns(cut: Cut, at: Linkage, geometry: Geometry) -> tuple[tuple[int, int], ...] | None:
    """The links whose turns add up to the hub's against the tip, with signs; None if an axis is not parallel."""
    common = at.tree.common(cut.tip, cut.hub)
    axis = geometry.motion_axes(cut.joint)[-1]
    found = []
    for end, sign in ((cut.hub, 1), (cut.tip, -1)):
        for link in at.tree.path(end):
            if link == common:
                break
            if not at.tree.links[link].motion.turns:
                continue
            along = _along(at, link, axis, geometry)
            if along == 0:
                return None
            found.append((link, sign * along))
    return tuple(sorted(found)) if at.q else None


def turns_are_lost(cut: Cut, at: Linkage, geometry: Geometry) -> bool:
    """Whether an angle of a cut joint is known within half a turn only: by the pose."""
    kind = cut.joint.kind
    if kind.spherical or not kind.turning:
        return False
    return kind.universal or parallel_turns(cut, at, geometry) is None


def _along(at: Linkage, link: int, axis: Vector, geometry: Geometry) -> int:
    """1 or -1 where a link turns about that direction or against it, else 0."""
    if at.tree.links[link].motion.spherical:
        return 0
    cosine = geometry.tape.settle(dot(transpose(at.frames[link].axes)[2], axis)).value
    if cosine is None or abs(abs(cosine) - 1) > SAME_DIRECTION:
        return 0
    return 1 if cosine > 0 else -1


def relative_rotation(cut: Cut, at: Linkage) -> Matrix:
    """Rotation of the hub relative to the tip since the reference configuration, in tip axes."""
    x, y, z = (at.carry(cut.hub, cut.tip, column) for column in transpose(cut.reference))
    return transpose((x, y, z))


def _rotation_gap(cut: Cut, at: Linkage, geometry: Geometry) -> list[Node]:
    m = relative_rotation(cut, at)
    half = geometry.tape.reciprocal(geometry.tape.node(2))
    return [-half * (m[2][1] - m[1][2]), -half * (m[0][2] - m[2][0]), -half * (m[1][0] - m[0][1])]

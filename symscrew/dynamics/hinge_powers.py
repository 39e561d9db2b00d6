"""Links on a hinge that carry nothing further, on a link that turns about an axis at rest: cranks on a turning body.

What such a link needs for its inertia matters by its powers along the two hinges alone, where reactions are not asked
for. These follow from its kinetic energy (I w^2 + 2 K w q' + L q'^2)/2, w of the carrier and q' of its own hinge, in
which I = k0 + k2 s + c (k1 + k3 c + k4 s) and K = l0 + l1 c + l2 s are of the cosine and sine of q, with constants,
and L is one:

    I w' + K q'' + I' w q' + K' q'^2,        K w' + L q'' - I' w^2 / 2.

A couple of these powers stands for the wrench, as regrouped inertias stand for the bodies'. Accelerations of the link's
points are seen in the axes before its motion, where U of the carrier has its zeros and the hinge adds little to it:

    U_link = U + q'' [e]x + q'^2 [e]x^2 + 2 q' [omega]x [e]x,    [omega]x [e]x = e omega^T - (omega . e) 1.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra import (
    Matrix,
    Node,
    Vector,
    add,
    count_operations,
    cross,
    dot,
    is_zero,
    named_wrench,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.dynamics.setting import Wrench
from symscrew.effects import Acting
from symscrew.kinematics import Inertia, Link, Rates, System, acceleration_matrix


@dataclass(frozen=True)
class HingedTip:
    """What a link needs for its inertia, at its origin, and its U; axes before its motion."""

    wrench: Wrench
    matrix: Matrix


def hinged_tips(
    system: System, acting: Acting, inertia: Sequence[Inertia], moving: Sequence[Rates], *, left_out: set[int]
) -> dict[int, HingedTip]:
    """The links, by index, that take fewer operations so; `left_out` are no links, but bars."""
    if not acting.keeps_motion:
        return {}
    bent = {bending.link for bending in acting.bendings}
    carrying = {link.parent for link in system.tree.links[1:] if link.index not in left_out}
    found = {}
    for link in system.tree.links[1:]:
        own, placed = inertia[link.index], system.placed[link.index]
        axis = transform(transpose(placed.rotation), (0, 0, 1))
        if not link.motion.revolute or link.index in {*carrying, *left_out, *bent} or not _still(own):
            continue
        if not _about_axis_at_rest(system, acting, link.parent) or not _crosses(system, axis):
            continue
        tip = _tip(system, link, own, moving[link.parent])
        plain = [placed.before(part) for part in acting.inertial_wrench(link.index, own, moving)]
        if _operations(system, tip.wrench) < _operations(system, plain):
            named_wrench(tip.wrench, "joint_force", system.tree.part(link.index))
            found[link.index] = tip
    return found


def _operations(system: System, vectors: Sequence[Vector]) -> int:
    return count_operations([system.tape.node(c) for vector in vectors for c in vector])


def _tip(system: System, link: Link, inertia: Inertia, carrier: Rates) -> HingedTip:
    placed = system.placed[link.index]
    back = transpose(placed.rotation)
    rate, gain = system.inputs.v[link.v.start], system.inputs.a[link.v.start]
    matrix = hinged_matrix(transform(back, carrier.omega), transform(back, carrier.alpha), rate, gain)
    origin = transform(back, carrier.origin)  # what the ground and gravity give all points
    axis, arm = transform(back, (0, 0, 1)), transform(back, placed.offset)
    couple = _couple(system, link, inertia, axis=axis, arm=arm)
    moment = cross(placed.before(inertia.first), origin)
    lean = (moment[0], moment[1], _along_hinge(system, inertia.first, origin, placed.turn))
    moment = min((moment, lean), key=lambda way: _operations(system, [way]))
    return HingedTip((scale(inertia.mass, origin), add(couple, moment)), matrix)


def _along_hinge(system: System, first: Vector, acceleration: Vector, turn: Matrix) -> Node:
    """The moment along z of a turned first moment in an acceleration: of constants where that is gravity at rest."""
    (x, y, _), (east, north, _), ((c, _, _), (s, _, _), _) = first, acceleration, turn
    node = system.tape.node
    return node(node(x * north - y * east) * c - node(x * east + y * north) * s)


def _still(inertia: Inertia) -> bool:
    """Whether all of its moments are wanted."""
    return all(is_zero(c) for row in inertia.still for c in row)


def _crosses(system: System, axis: Vector) -> bool:
    """Whether the carrier's axis is not along the hinge's, whatever the parameters are."""
    across = system.tape.settle(_across(system, axis))
    return across.value is not None and not is_zero(across)


def _about_axis_at_rest(system: System, acting: Acting, index: int) -> bool:
    """Whether a link turns on the ground, which does not turn itself."""
    links = system.tree.links
    inner = [links[k] for k in system.tree.path(index)[1:]]
    fixed = all(link.v.start == link.v.stop for link in inner)
    return links[index].motion.revolute and fixed and acting.base is None


def _across(system: System, axis: Vector) -> Node:
    """The square of the part of the carrier's axis that is across the hinge's."""
    return system.tape.node(axis[0] * axis[0] + axis[1] * axis[1])


def _couple(system: System, link: Link, inertia: Inertia, *, axis: Vector, arm: Vector) -> Vector:
    """A couple with the powers of the link's inertia along its hinge and its carrier's, axes before its motion.

    `axis` is that of the carrier, unit length, `arm` from there to the link's origin, both in these axes.
    """
    (p, n, h), (x, y, z), (a, b, _) = axis, arm, inertia.first
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = inertia.second
    along = dot(axis, arm)
    far = subtract(arm, scale(along, axis))
    to_sides = p * xz + n * yz, n * xz - p * yz
    k0 = inertia.mass * dot(far, far) + 2 * far[2] * inertia.first[2] + xx + yy + zz
    k0 = k0 - (n * n * xx + p * p * yy - 2 * p * n * xy + h * h * zz)
    k1 = 2 * (far[0] * a + far[1] * b) - 2 * h * to_sides[0]
    k2 = 2 * (far[1] * a - far[0] * b) - 2 * h * to_sides[1]
    k3 = (n * n - p * p) * (xx - yy) - 4 * p * n * xy
    k4 = 2 * (p * p - n * n) * xy - 2 * p * n * (xx - yy)
    l1 = h * (x * a + y * b) - z * (p * a + n * b) - to_sides[0]
    l2 = h * (y * a - x * b) - z * (n * a - p * b) - to_sides[1]
    node = system.tape.node
    (c, _, _), (s, _, _), _ = system.placed[link.index].turn
    part = node(k3 * c)
    lever = part + node(k1 + node(k4 * s))
    total = node(k0 + k2 * s) + c * lever
    change = c * node(k2 + k4 * c) - s * (lever + part)
    shared, shared_change = node(h * (xx + yy) + (l1 * c + l2 * s)), node(l2 * c - l1 * s)
    carrier = system.tree.links[link.parent].v.start
    (rate, w), (gain, w_dot) = (
        (values[link.v.start], values[carrier]) for values in (system.inputs.v, system.inputs.a)
    )
    of_carrier = total * w_dot + shared * gain + (change * w + shared_change * rate) * rate
    half = system.tape.reciprocal(node(2))
    own = (xx + yy) * gain + shared * w_dot - change * (half * (w * w))
    beside = (of_carrier - h * own) * (1 / _across(system, axis))
    return (p * beside, n * beside, own)


def hinged_matrix(omega: Vector, alpha: Vector, rate: Node, gain: Node) -> Matrix:
    """U of what turns on a hinge by `rate` and `gain`, from the rates of its carrier, third axis the hinge's."""
    (xx, xy, xz), (yx, yy, yz), (_, _, zz) = acceleration_matrix(omega, alpha)
    x, y, z = omega
    twice = 2 * rate
    inwards = rate * (rate + 2 * z)
    return (
        (xx - inwards, xy - gain, xz),
        (yx + gain, yy - inwards, yz),
        (x * (z + twice) - alpha[1], y * (z + twice) + alpha[0], zz),
    )


def as_loads(tips: Mapping[int, HingedTip], loads: Mapping[int, Wrench]) -> dict[int, Wrench]:
    """What acts on the links, with what these ones need for their inertia against it."""
    found = dict(loads)
    for index, tip in tips.items():
        force, moment = tip.wrench
        known = found.get(index)
        found[index] = (
            (scale(-1, force), scale(-1, moment))
            if known is None
            else (subtract(known[0], force), subtract(known[1], moment))
        )
    return found

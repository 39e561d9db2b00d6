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

from symscrew.algebra import (
    ZERO,
    Matrix,
    Node,
    Scalar,
    Twist,
    Vector,
    add,
    cross,
    is_zero,
    named_matrix,
    named_vector,
    scale,
    transform,
)
from symscrew.kinematics.link_quantities import NO_SPREAD, Frame, Inertia, Rates
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.tree import Link


def twists(at: Linkage, v: Sequence[Node]) -> tuple[Twist, ...]:
    """Twist of every link at its own origin in its own axes."""
    result = [Twist(ZERO, ZERO)]
    for link in at.tree.links[1:]:
        here, parent = at.placed[link.index], result[link.parent]
        own = own_screws(link, at.frames[link.index], v)
        linear = here.outwards(add(parent.velocity_at(here.offset), own.linear))
        part = at.tree.part(link.index)
        omega = named_vector(add(here.outwards(parent.angular), own.angular), "omega", part)
        result.append(Twist(omega, named_vector(linear, "velocity", part)))
    return tuple(result)


def own_screws(link: Link, frame: Frame, v: Sequence[Scalar]) -> Twist:
    """What the joint adds: angular part in link axes, linear part in parent axes; `v` are the tree's rates."""
    return link.pair.own_twist(frame, v[link.v])


def rates(at: Linkage, v: Sequence[Node], a: Sequence[Node], *, ground: Rates | None = None) -> tuple[Rates, ...]:
    """Rates of every link; `ground` carries gravity as the ground's acceleration -g, and a moving base.

    The linkage keeps the answer: several functions ask for it.
    """
    key = ("rates", tuple(v), tuple(a), ground)
    if key not in at.answers:
        at.answers[key] = _rates(at, v, a, ground)
    found: tuple[Rates, ...] = at.answers[key]
    return found


def _rates(at: Linkage, v: Sequence[Node], a: Sequence[Node], ground: Rates | None) -> tuple[Rates, ...]:
    result = [ground or Rates(ZERO, ZERO, ZERO, NO_SPREAD)]
    still = "_still" if all(is_zero(x) for x in a) else ""
    for link in at.tree.links[1:]:
        frame, here, parent = at.frames[link.index], at.placed[link.index], result[link.parent]
        speed, gain = own_screws(link, frame, v), own_screws(link, frame, a)
        carried = add(parent.at(here.offset), gain.linear)
        if speed.linear is not ZERO:
            carried = add(carried, cross(scale(2, parent.omega), speed.linear))
        if not link.motion.turns:  # the parent's axes and its U
            named_vector(carried, f"acceleration{still}", at.tree.part(link.index))
            result.append(Rates(parent.omega, parent.alpha, carried, parent.matrix))
            continue
        before = here.outwards(parent.omega)
        omega = add(before, speed.angular)
        alpha = add(add(here.outwards(parent.alpha), gain.angular), cross(before, speed.angular))
        moving = Rates(omega, alpha, here.outwards(carried), acceleration_matrix(omega, alpha))
        result.append(_named(moving, at.tree.part(link.index), still))
    return tuple(result)


def _named(moving: Rates, part: str, still: str) -> Rates:
    """The rates of a link, called what they are."""
    named_vector(moving.omega, "omega", part)
    named_vector(moving.alpha, f"alpha{still}", part)
    named_vector(moving.origin, f"acceleration{still}", part)
    named_matrix(moving.matrix, f"acceleration_matrix{still}", part)
    return moving


def acceleration_matrix(omega: Vector, alpha: Vector) -> Matrix:
    """U = [alpha]x + [omega]x^2."""
    x, y, z = omega
    xx, yy, zz, xy, xz, yz = x * x, y * y, z * z, x * y, x * z, y * z
    return (
        (-(yy + zz), xy - alpha[2], xz + alpha[1]),
        (xy + alpha[2], -(xx + zz), yz - alpha[0]),
        (xz - alpha[1], yz + alpha[0], -(xx + yy)),
    )


def inertial_wrench(inertia: Inertia, rate: Rates) -> tuple[Vector, Vector]:
    """(force, moment about the link's origin): the rate of the link's momentum screw, link axes.

    The axial vector of U Sigma is written so that a diagonal Sigma costs three operations a component:
    J_x alpha_x + (Sigma_yy - Sigma_zz) omega_y omega_z, and so on; of the part of Sigma that is `still` without
    the terms in omega.
    """
    force = add(scale(inertia.mass, rate.origin), transform(rate.matrix, inertia.first))
    omega, alpha, matrix = rate.omega, rate.alpha, rate.matrix
    spread, still = inertia.second, inertia.still
    axial = []
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        spun = spread[y][y] - spread[z][z] - (still[y][y] - still[z][z])
        value = (spread[y][y] + spread[z][z]) * alpha[x]
        value = value + spun * (omega[y] * omega[z])
        value = value + (matrix[z][x] * spread[x][y] - matrix[y][x] * spread[x][z])
        value = value - (omega[z] * omega[x] * still[x][y] - omega[y] * omega[x] * still[x][z])
        axial.append(value + (spread[y][z] - still[y][z]) * (omega[z] * omega[z] - omega[y] * omega[y]))
    return force, add((axial[0], axial[1], axial[2]), cross(inertia.first, rate.origin))

"""Rolling without sliding as rows of the closure, beside those of cut joints.

    wheel's surface --touches at W + r--> ground's surface:   velocities there are equal

Row k is the power of a unit force where they touch: two along the ground, which no function of the coordinates has as
its rate (a nonholonomic constraint), and one across it, whose opening is the way between the surfaces. The place where
they touch moves over both bodies, r = -R u/|u| with u across the ground (of a disc: its part across the axle).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Node, Scalar, Twist, Vector, add, cross, dot, scale, subtract, transform, transpose
from symscrew.description import Point
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import Rates
from symscrew.kinematics.linkage import Linkage


@dataclass(frozen=True)
class Rolling:
    """A body with its centre at the point `wheel` and a radius [m] that rolls on another one, at `ground`.

    `axis`: of a disc, absolute in the reference configuration; none: a ball. It rolls on the plane across `normal`,
    or on a circle of the radius `circle` [m] about `ground`, within it where that is negative (`inside`). `held`:
    whether its centre is held at its distance from the ground, too. Numbers are expressions of the parameters.
    """

    name: str
    wheel: Point
    ground: Point
    radius: object
    normal: tuple[object, ...]
    axis: tuple[object, ...] = ()
    circle: object | None = None
    inside: bool = False
    held: bool = True


@dataclass(frozen=True)
class Touch:
    """Where a wheel touches, tip axes: the wheel is on the tip, what it rolls on on the hub.

    `centre` and `foot` are the points of `Rolling`, each in coordinates of its own link, `up` is the plane's normal in
    the hub's axes (none: a circle), `axle` the disc's (none: a ball). `across` is u and `size` its length, `gap` [m]
    how far the wheel is from the ground, `labels` what is said of the rows.
    """

    given: Rolling
    radius: Node
    centre: Vector
    foot: Vector
    up: Vector | None
    axle: Vector | None
    across: Vector
    size: Scalar
    arm: Vector
    along: tuple[Vector, Vector]
    normal: Vector
    gap: Node

    def arm_rate(self, at: Linkage, links: tuple[int, int], twist: Sequence[Twist], omega: Vector) -> Vector:
        """How fast the place where it touches moves over the wheel [m/s], tip axes; `omega`: hub against tip."""
        tip, hub = links
        if self.up is not None:
            moved = cross(omega, at.carry(hub, tip, self.up))
        else:
            foot = at.carry_point(hub, tip, self.foot)
            drift = at.carry(hub, tip, twist[hub].velocity_at(self.foot))
            moved = subtract(twist[tip].velocity_at(foot), drift)
            moved = scale(-1, moved) if self.given.inside else moved
        if self.axle is None:
            return scale(-1 * self.radius, moved)
        moved = subtract(moved, scale(dot(self.axle, moved), self.axle))
        unit = scale(1 / self.size, self.across)
        turned = subtract(moved, scale(dot(unit, moved), unit))
        return scale(-1 * self.radius / self.size, turned)


def touch(at: Linkage, geometry: Geometry, given: Rolling) -> Touch:
    """Where a wheel touches at the coordinates of a linkage."""
    tree, tape = at.tree, geometry.tape
    tip, hub = tree.link_of_body[given.wheel.body], tree.link_of_body[given.ground.body]
    centre, foot = (_local(at, geometry, link, p.at) for link, p in ((tip, given.wheel), (hub, given.ground)))
    radius = geometry.scalar(given.radius)
    axle = _direction(at, geometry, tip, given.axis) if given.axis else None
    away = subtract(centre, at.carry_point(hub, tip, foot))
    if given.circle is None:
        up = _direction(at, geometry, hub, given.normal)
        normal = at.carry(hub, tip, up)
        across = normal if axle is None else _across(normal, axle)
        size: Scalar = 1 if axle is None else tape.sqrt(tape.node(dot(across, across)))
        arm = scale(-1 * radius / size, across)
        gap = tape.node(dot(normal, add(away, arm)))
    else:
        assert axle is not None, "on a circle the plane of the wheel is across its axis"
        up, flat = None, _across(away, axle)
        size = tape.sqrt(tape.node(dot(flat, flat)))
        across = scale(-1, flat) if given.inside else flat
        normal = scale(1 / size, across)
        arm = scale(-1 * radius, normal)
        gap = tape.node((-1 if given.inside else 1) * (size - geometry.scalar(given.circle)) - radius)
    along = _along(at, geometry, (tip, hub), normal=normal, up=up, axle=axle)
    return Touch(given, radius, centre, foot, up, axle, across, size, arm, along, normal, gap)


def rolling_bias(at: Linkage, links: tuple[int, int], found: Touch, *, twist: Sequence[Twist],
                 rate: Sequence[Rates]) -> Vector:  # fmt: skip
    """What the rates add to the acceleration of sliding, tip axes, and that of `rate`'s own: of motions that roll.

    With equal velocities where they touch, s = 0, ds/dt is the difference of the accelerations of the two material
    points, and (omega_wheel - omega_ground) x the rate at which the place moves over the wheel.
    """
    tip, hub = links
    place = add(found.centre, found.arm)
    contact = at.carry_point(tip, hub, place)
    omega = subtract(at.carry(hub, tip, rate[hub].omega), rate[tip].omega)
    linear = subtract(rate[tip].at(place), at.carry(hub, tip, rate[hub].at(contact)))
    return subtract(linear, cross(omega, found.arm_rate(at, links, twist, omega)))


def _along(
    at: Linkage, geometry: Geometry, links: tuple[int, int], *, normal: Vector, up: Vector | None, axle: Vector | None
) -> tuple[Vector, Vector]:
    """Two directions along the ground, tip axes: that in which a disc rolls first."""
    if axle is None:
        assert up is not None
        first = geometry.perpendicular(up)
        second = geometry.settle(cross(up, first))
        return at.carry(links[1], links[0], first), at.carry(links[1], links[0], second)
    ahead = cross(axle, normal)
    length = geometry.tape.sqrt(geometry.tape.node(dot(ahead, ahead)))
    ahead = scale(1 / length, ahead)
    return ahead, cross(normal, ahead)


def _across(vector: Vector, axis: Vector) -> Vector:
    return subtract(vector, scale(dot(axis, vector), axis))


def _local(at: Linkage, geometry: Geometry, link: int, point: Sequence[object]) -> Vector:
    """A point of the reference configuration in coordinates of a link."""
    frame = at.frames[link]
    return geometry.settle(transform(transpose(frame.axes), subtract(geometry.vector(point), frame.origin)))


def _direction(at: Linkage, geometry: Geometry, link: int, given: Sequence[object]) -> Vector:
    """A unit vector of the reference configuration in the axes of a link."""
    unit = geometry.unit(geometry.vector(given))
    return geometry.settle(transform(transpose(at.frames[link].axes), unit))

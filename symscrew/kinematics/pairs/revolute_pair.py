"""A rotation about an axis, which is the link's z: the moment about it does work."""

from __future__ import annotations

from collections.abc import Sequence

import mpmath

from symscrew.algebra import (
    CONTEXT,
    ZERO,
    Matrix,
    Node,
    Pose,
    Scalar,
    Tape,
    Twist,
    Vector,
    add,
    cross,
    dot,
    revolute,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics.geometry_nodes import UNITS, Geometry
from symscrew.kinematics.link_quantities import Frame, Inertia, Placement
from symscrew.kinematics.pairs.lower_pair import LowerPair, Site, Turn

ALONG = 1e-9
"""A direction whose part across the axis is smaller than that [m, or 1] is along it: x then points elsewhere. Real
directions across an axis are far longer and rounded ones far shorter, and either choice gives correct code."""

STEEP = 0.05
"""Component of an axis [1] from which on its point in a plane of coordinates may be an origin: it is not far away."""

QUARTER = mpmath.mpf(10) ** -40
"""A constant phase so near to quarter turns, of its 60 digits, is that many: its cosine and sine are 0 and 1."""


class Revolute(LowerPair):
    """R: a rotation by q + phase about z."""

    def frame(self, site: Site) -> Frame:
        """z along the axis, x towards what lies further out."""
        return turning_frame(site)

    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        """The axes turn about z."""
        return turned(frame, turn or cosine_sine(tape, frame, q[0]))

    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        """An angular velocity about z."""
        return Twist((0, 0, v[0]), ZERO)

    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        """The moment about z."""
        return (moment[2],)

    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        """(e_z ; 0)."""
        return (Twist((0, 0, 1), ZERO),)

    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        """(e ; r x e)."""
        return (revolute(transpose(own.rotation)[2], own.translation),)

    def screws(self, axis: Vector, point: Vector, pitch: Scalar) -> tuple[Twist, ...]:
        """(e ; r x e)."""
        return (revolute(axis, point),)

    def cleared(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Vector, Vector]:
        """Without the moment about z."""
        return force, (moment[0], moment[1], 0)

    def base_inertia(self, geometry: Geometry, frame: Frame, own: Inertia) -> tuple[Inertia, Inertia] | None:
        """What lies on the axis moves with the parent: mass, first moment along z, second moment until J_xx is 0."""
        zero = geometry.tape.zero
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = own.second
        line = geometry.settle((zz + yy, 0, 0))[0]
        left: Matrix = ((xx, xy, xz), (xy, yy, yz), (xz, yz, -geometry.tape.node(yy)))
        stays = Inertia(zero, (own.first[0], own.first[1], zero), left, own.still)
        return stays, line_on_axis(frame, own.mass, own.first[2], line)


def turning_frame(site: Site) -> Frame:
    """z along the axis, x towards what lies further out, the origin where the offsets have fewest numbers."""
    geometry, parent, tape = site.geometry, site.parent, site.geometry.tape
    point, axis, reference = site.point, site.axis, site.reference
    local = geometry.settle(transform(transpose(parent.axes), axis))
    origin = _origin(site, axis, point)
    before = _sparse_triad(geometry, local)
    start = geometry.settle_matrix(transpose(_matmul(parent.axes, before)))  # rows: x', y', z absolute
    x = geometry.perpendicular(axis, _outwards(site, axis, origin))
    cosine = tape.settle(dot(start[0], x))
    sine = tape.settle(dot(start[1], x))
    phase = tape.settle(tape.function("atan2", sine, cosine) - reference)
    axes = transpose((x, geometry.settle(cross(axis, x)), axis))
    offset = site.in_parent(origin)
    arm = geometry.settle((0, 0, dot(axis, subtract(point, origin))))
    return Frame(axes, origin, before, offset, local, tape.node(phase), reference, start=(cosine, sine), arm=arm)


def turned(frame: Frame, turn: Turn) -> Placement:
    """A link turned about z by an angle with that cosine and sine."""
    c, s = turn
    return Placement(frame.rotation, ((c, -s, 0), (s, c, 0), (0, 0, 1)), frame.offset)


def cosine_sine(tape: Tape, frame: Frame, q: Node) -> Turn:
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


def quarter_turns(phase: Node) -> int | None:
    """How many quarter turns a constant phase is, or None."""
    if phase.value is None:
        return None
    turns = phase.value / (CONTEXT.pi / 2)
    nearest = CONTEXT.nint(turns)
    return int(nearest) % 4 if abs(turns - nearest) < QUARTER else None


def line_on_axis(frame: Frame, mass: Scalar, first: Scalar, second: Scalar) -> Inertia:
    """A mass distribution along the joint's axis, in the parent's coordinates."""
    r, e = frame.offset, frame.axis

    def row(i: int) -> Vector:
        x, y, z = (mass * r[i] * r[j] + first * (r[i] * e[j] + e[i] * r[j]) + second * e[i] * e[j] for j in range(3))
        return (x, y, z)

    return Inertia(mass, add(scale(mass, r), scale(first, e)), (row(0), row(1), row(2)))


def _matmul(a: Matrix, b: Matrix) -> Matrix:
    columns = transpose(b)
    return transpose((transform(a, columns[0]), transform(a, columns[1]), transform(a, columns[2])))


def _sparse_triad(geometry: Geometry, axis: Vector) -> Matrix:
    """A rotation matrix whose third column is `axis`, with as many zeros and ones as can be had."""
    sizes = [geometry.size(c) for c in axis]
    zeros = [k for k in range(3) if geometry.vanishes(axis[k])]
    if len(zeros) == 2:
        main = sizes.index(max(sizes))
        first: Vector = UNITS[(main + 1) % 3]
    elif zeros:
        first = geometry.settle(cross(UNITS[zeros[0]], axis))
    else:
        first = geometry.unit(cross(UNITS[sizes.index(min(sizes))], axis))
    return transpose((first, geometry.settle(cross(axis, first)), axis))


def _origin(site: Site, axis: Vector, point: Vector) -> Vector:
    """A point of the axis: the given one, or the foot of the perpendicular from the parent's origin if that
    leaves fewer numbers in the offsets to the parent and to the joints further out, of equals in the former: what
    arrives from outboard passes there. Nothing passes on to the ground. Of a link that carries nothing, where the axis
    goes through a plane of the parent's coordinates may be one too: of its outboard points there is the centre of mass
    alone, and what is further out does not look on."""
    geometry, parent = site.geometry, site.parent
    away = geometry.settle(subtract(point, parent.origin))
    foot = geometry.settle(subtract(point, scale(dot(away, axis), axis)))

    def numbers(origin: Vector) -> tuple[int, int]:
        count = sum(geometry.size(c) != 0 for c in site.in_parent(origin))
        outboard = list(site.outboard_points())
        along = (geometry.tape.settle(dot(subtract(p, origin), axis)) for p in outboard)
        return count + sum(geometry.size(c) != 0 for c in along), 0 if site.on_ground else count

    if len(list(site.outboard_points())) > 1 or list(site.outboard_axes()):
        return foot if numbers(foot) < numbers(point) else point
    local = geometry.settle(transform(transpose(parent.axes), axis))
    shifts = [site.in_parent(point)[k] / c if geometry.size(c) > STEEP else None for k, c in enumerate(local)]
    crossings = [geometry.settle(subtract(point, scale(shift, axis))) for shift in shifts if shift is not None]
    return min((point, foot, *crossings), key=numbers)


def _outwards(site: Site, axis: Vector, origin: Vector) -> Vector | None:
    """What x of a revolute link turns to: the next axis, else the next joint's point, else the centre of mass."""
    geometry = site.geometry
    candidates = [*site.outboard_axes(), *(subtract(p, origin) for p in site.outboard_points())]
    for candidate in candidates:
        across = geometry.settle(cross(axis, candidate))
        if max(geometry.size(c) for c in across) > ALONG:
            return candidate
    return None

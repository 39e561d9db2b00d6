"""Checks of a whole mechanism: everything that one part alone cannot show.

Decisions are taken on numbers of 50 digits at the parameters' values. Thresholds are relative to the
mechanism's size, so that no result depends on the unit of length.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np
import sympy

from symscrew.description.expressions import numeric
from symscrew.description.mechanism import Body, Joint, Matrix3, Mechanism, Parameter, Vector
from symscrew.description.planar_motion import planar_normal
from symscrew.errors import DescriptionError, did_you_mean

AXIS_TOLERANCE = 1e-14
"""Accepted deviation of an axis' length from 1: a unit vector of doubles or of 15 decimals passes, one of 12 decimals
is refused with the vector to write instead, because its error would stand in every generated constant."""

TRIAD_TOLERANCE = 1e-12
"""Accepted error of the products of the axes of an inertia: what axes exported as doubles have, and no wrong axis."""

NO_LENGTH = 1e-30
"""An axis shorter than that is zero, not a vector to be normalised: any that is meant is far longer."""

PARALLEL_AXES = 1e-12
"""Sine of the angle between two axes of a joint below which they are one: the joint would have one freedom less."""

SKEW_AXES = 1e-6
"""Cosine of the angle between the axes of a universal joint above which they are called not perpendicular: axes that
were written in six digits are."""

CLOSURE_TOLERANCE = 1e-12
"""Accepted gap of a loop, relative to the mechanism's size, and accepted angle [rad]: places of 13 digits meet; what is
further apart is a slip, whose gap every generated function would carry along."""

INERTIA_TOLERANCE = 1e-12
"""Accepted violation of symmetry and of the triangle inequality, relative to the largest entry: rods have moments of
rounding size, and what is worse is refused since no body has such an inertia."""

FAR = 100.0
"""A place farther from all others than so many times their extent is probably in another unit: millimetres are off by
1000. It is a warning, since such a mechanism may be meant."""

_CONTEXT = mpmath.mp.clone()
_CONTEXT.dps = 50  # digits: three times a double's, so that no tolerance here is near the rounding

Numbers = tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf]


@dataclass(frozen=True)
class Feature:
    """Where a joint's feature is on its child body, when the description gives it a second time."""

    point: Vector | None = None
    axes: tuple[Vector, ...] | None = None


def validate(mechanism: Mechanism, features: Mapping[str, Feature] | None = None) -> tuple[str, ...]:
    """The warnings about `mechanism`; `features` are the joints' places on their child bodies, if given.

    Raises:
        DescriptionError: names the part that is wrong, by how much, and the cure.
    """
    _check_references(mechanism)
    _check_connected(mechanism)
    for joint in mechanism.joints.values():
        _check_axes(mechanism, joint)
    size = mechanism_size(mechanism)
    for name, feature in (features or {}).items():
        _check_closure(mechanism, mechanism.joints[name], feature, size)
    moments = {body.name: _check_inertia(mechanism, body) for body in mechanism.bodies.values()}
    places = _places(mechanism)
    extents = [_extent_warning(mechanism, name, places[name], largest) for name, largest in moments.items()]
    return (*(warning for warning in extents if warning), *_far_warnings(mechanism), *_skew_warnings(mechanism))


def check_values_of(mechanism: Mechanism) -> None:
    """Refuse values of run-time parameters that leave a body an inertia, or a joint axes, that are none.

    Loops are not looked at: they are closed anew at every state.

    Raises:
        DescriptionError: as `validate`.
    """
    for joint in mechanism.joints.values():
        if any(mechanism.baked(entry).free_symbols for axis in joint.axes for entry in axis):
            _check_axes(mechanism, joint)
    for body in mechanism.bodies.values():
        numbers = [entry for row in body.inertia or () for entry in row]
        numbers += [] if body.mass is None else [body.mass]
        if any(mechanism.baked(entry).free_symbols for entry in numbers):
            _check_inertia(mechanism, body)


def mechanism_size(mechanism: Mechanism) -> float:
    """Diagonal [m] of the box around all joint points and named points in the reference configuration."""
    places = [_numbers(mechanism, joint.point, joint.name) for joint in mechanism.joints.values()]
    places += [_numbers(mechanism, point.at, point.name) for point in mechanism.points.values()]
    if not places:
        return 0.0
    spans = [max(p[k] for p in places) - min(p[k] for p in places) for k in range(3)]
    return float(_CONTEXT.norm(spans))


def check_axes_triad(axes: Matrix3, parameters: Mapping[str, Parameter], where: str) -> None:
    """Refuses the axes of an inertia that are not three orthogonal unit vectors."""
    values = {p.symbol: p.value for p in parameters.values()}
    rows = [tuple(_mpf(entry.xreplace(values), where) for entry in axis) for axis in axes]
    for i in range(3):
        for j in range(i, 3):
            product = _dot(rows[i], rows[j])
            if abs(product - (i == j)) > TRIAD_TOLERANCE:
                what = "length" if i == j else f"product with axis {j}"
                value = _CONTEXT.sqrt(product) if i == j else product
                raise DescriptionError(
                    f"{where}: expected three orthogonal unit vectors, but axis {i} has {what} {mpmath.nstr(value, 10)}"
                )


def _check_references(mechanism: Mechanism) -> None:
    def known(name: str, where: str) -> None:
        if name not in mechanism.bodies:
            raise DescriptionError(
                f"{where}: the body {name!r} is not described; add [bodies.{name}] or correct the name: "
                f"{did_you_mean(name, mechanism.bodies)}"
            )

    if mechanism.platform is not None:
        known(mechanism.platform, "mechanism.platform")
    for joint in mechanism.joints.values():
        known(joint.parent, f"joints.{joint.name}.parent")
        known(joint.child, f"joints.{joint.name}.child")
        if joint.parent == joint.child:
            raise DescriptionError(
                f"joints.{joint.name}: parent and child are the same body {joint.parent!r}; expected two bodies"
            )
    for point in mechanism.points.values():
        known(point.body, f"points.{point.name}.body")
    for limb in mechanism.limbs.values():
        for name in limb.joints:
            if name not in mechanism.joints:
                raise DescriptionError(
                    f"limbs.{limb.name}.joints: the joint {name!r} is not described; "
                    f"{did_you_mean(name, mechanism.joints)}"
                )
        for before, after in zip(limb.joints, limb.joints[1:], strict=False):
            first, second = mechanism.joints[before], mechanism.joints[after]
            if not {first.parent, first.child} & {second.parent, second.child}:
                raise DescriptionError(
                    f"limbs.{limb.name}.joints: {before!r} and {after!r} have no body in common; list the "
                    "joints in order from base to tip"
                )


def _check_connected(mechanism: Mechanism) -> None:
    if not mechanism.joints:
        raise DescriptionError(f"mechanism {mechanism.name!r}: it has no joints; add [joints.NAME] or [limbs.NAME]")
    neighbours: dict[str, list[str]] = {name: [] for name in mechanism.bodies}
    for joint in mechanism.joints.values():
        neighbours[joint.parent].append(joint.child)
        neighbours[joint.child].append(joint.parent)
    reached, front = {mechanism.ground}, [mechanism.ground]
    while front:
        new = [n for n in neighbours[front.pop()] if n not in reached]
        reached.update(new)
        front.extend(new)
    missing = [name for name in mechanism.bodies if name not in reached]
    if missing:
        raise DescriptionError(
            f"mechanism {mechanism.name!r}: no chain of joints leads from the ground {mechanism.ground!r} to "
            + ", ".join(repr(name) for name in missing)
            + "; connect them (a free body needs a joint of type 'free')"
        )


def _check_axes(mechanism: Mechanism, joint: Joint) -> None:
    axes = [_numbers(mechanism, axis, f"joints.{joint.name}.axes") for axis in joint.axes]
    for k, axis in enumerate(axes):
        where = f"joints.{joint.name}.axes[{k}]"
        length = _length(axis)
        if length < NO_LENGTH:
            raise DescriptionError(f"{where}: the axis is zero; expected a unit vector")
        if abs(length - 1) > AXIS_TOLERANCE:
            unit = ", ".join(_unit_text(mechanism, joint.axes[k], axis, length))
            raise DescriptionError(
                f"{where}: expected a unit vector, got one of length {mpmath.nstr(length, 15)}; use [{unit}]"
            )
    if len(axes) == 2 and _length(_cross(axes[0], axes[1])) < PARALLEL_AXES:
        raise DescriptionError(
            f"joints.{joint.name}.axes: the two axes of a {joint.kind.name} joint are parallel; "
            "expected different directions (or use one R joint)"
        )


def _unit_text(mechanism: Mechanism, axis: Vector, values: Numbers, length: mpmath.mpf) -> list[str]:
    """The normalised axis as it can be typed: exact where that is short, else 20 digits."""
    exact = [mechanism.number(entry) for entry in axis]
    if all(entry.is_Rational for entry in exact):
        norm = sympy.sqrt(sum(entry**2 for entry in exact))
        typed = [str(entry / norm) for entry in exact]
        if all(len(text) <= 24 for text in typed):
            return [text if text.lstrip("-").isdigit() else f'"{text}"' for text in typed]
    return [f'"{mpmath.nstr(value / length, 20)}"' for value in values]


def _check_closure(mechanism: Mechanism, joint: Joint, feature: Feature, size: float) -> None:
    """The joint's place on the child must be its place on the parent, but for what the joint can move."""
    where = f"joints.{joint.name}"
    axes = [_numbers(mechanism, axis, where) for axis in joint.axes]
    sliding = joint.kind.sliding
    if feature.point is not None and len(sliding) < 3:
        here, there = _numbers(mechanism, joint.point, where), _numbers(mechanism, feature.point, where)
        gap = (there[0] - here[0], there[1] - here[1], there[2] - here[2])
        if sliding:  # along one axis, or in the plane whose normal is the only axis given
            axis = axes[sliding[0]] if len(sliding) == 1 else axes[0]
            along = _dot(gap, axis)
            across = _length((gap[0] - along * axis[0], gap[1] - along * axis[1], gap[2] - along * axis[2]))
            distance = across if len(sliding) == 1 else abs(along)
        else:
            distance = _length(gap)
        if distance > CLOSURE_TOLERANCE * max(size, float(_length(gap))):
            raise DescriptionError(
                f"{where}: the loop does not close in the reference configuration: the joint's place on "
                f"{joint.child!r} is {mpmath.nstr(distance, 6)} m away from its place on {joint.parent!r}; "
                f"point [{_list(here)}], child_point [{_list(there)}]"
            )
    for k, axis in enumerate(feature.axes or ()):
        there = _numbers(mechanism, axis, f"{where}.child_axes")
        angle = _CONTEXT.atan2(_length(_cross(axes[k], there)), _dot(axes[k], there))
        if abs(angle) > CLOSURE_TOLERANCE:
            raise DescriptionError(
                f"{where}: the loop does not close in the reference configuration: axis {k} on "
                f"{joint.child!r} is turned by {mpmath.nstr(angle, 6)} rad against axis {k} on "
                f"{joint.parent!r}; axes [{_list(axes[k])}], child_axes [{_list(there)}]"
            )


def _check_inertia(mechanism: Mechanism, body: Body) -> mpmath.mpf | None:
    """The largest principal moment of the body; None for a body without mass."""
    where = f"bodies.{body.name}"
    if body.mass is None or body.inertia is None:
        return None
    mass = _mpf(mechanism.number(body.mass), f"{where}.mass")
    if mass < 0:
        raise DescriptionError(f"{where}.mass: expected a mass of at least 0 kg, got {mpmath.nstr(mass, 10)}")
    rows = [_numbers(mechanism, row, f"{where}.inertia") for row in body.inertia]
    scale = max(abs(entry) for row in rows for entry in row)
    for i in range(3):
        for j in range(i):
            if abs(rows[i][j] - rows[j][i]) > INERTIA_TOLERANCE * scale:
                raise DescriptionError(
                    f"{where}.inertia: expected a symmetric matrix, but entry [{i}][{j}] is "
                    f"{mpmath.nstr(rows[i][j], 10)} and [{j}][{i}] is {mpmath.nstr(rows[j][i], 10)}"
                )
    if scale == 0:
        return _CONTEXT.mpf(0)
    moments = sorted(_CONTEXT.eigsy(_CONTEXT.matrix([list(row) for row in rows]), eigvals_only=True))
    shown = ", ".join(mpmath.nstr(moment, 10) for moment in moments)
    limit = -INERTIA_TOLERANCE * scale
    if moments[0] < limit:
        raise DescriptionError(
            f"{where}.inertia: expected principal moments of at least 0, got {shown} kg m^2; check signs and axes"
        )
    if moments[0] + moments[1] - moments[2] < limit and not _only_about_normal(mechanism, rows):
        raise DescriptionError(
            f"{where}.inertia: no body has the principal moments {shown} kg m^2: the largest exceeds the sum "
            f"of the other two by {mpmath.nstr(moments[2] - moments[0] - moments[1], 6)}; check units and "
            "axes, and that the inertia is about the centre of mass"
        )
    if mass == 0:
        raise DescriptionError(f"{where}.mass: expected a positive mass with the inertia {shown} kg m^2, got 0")
    return moments[2]


def _only_about_normal(mechanism: Mechanism, rows: Sequence[Numbers]) -> bool:
    """Whether an inertia is one moment about the normal of a planar mechanism: no other moment counts there."""
    normal = planar_normal(mechanism)
    if normal is None:
        return False
    about = [_CONTEXT.fdot(row, normal) for row in rows]
    moment = _CONTEXT.fdot(about, normal)
    rest = [abs(rows[i][j] - moment * normal[i] * normal[j]) for i in range(3) for j in range(3)]
    return bool(max(rest) <= INERTIA_TOLERANCE * abs(moment))


def _places(mechanism: Mechanism) -> dict[str, list[Numbers]]:
    """Body -> the points of its joints and its named points."""
    found: dict[str, list[Numbers]] = {name: [] for name in (mechanism.ground, *mechanism.bodies)}
    for joint in mechanism.joints.values():
        place = _numbers(mechanism, joint.point, joint.name)
        for body in dict.fromkeys((joint.parent, joint.child)):
            found[body].append(place)
    for point in mechanism.points.values():
        found[point.body].append(_numbers(mechanism, point.at, point.name))
    return found


def _extent_warning(
    mechanism: Mechanism, name: str, given: Sequence[Numbers], largest: mpmath.mpf | None
) -> str | None:
    body = mechanism.bodies[name]
    if not largest or body.mass is None or body.com is None:
        return None
    places = [*given, _numbers(mechanism, body.com, name)]
    extent = _extent(places)
    radius = _CONTEXT.sqrt(largest / _mpf(mechanism.number(body.mass), name))
    if extent == 0 or radius <= extent:  # a single place says nothing about the body's size
        return None
    return (
        f"bodies.{name}: the radius of gyration {mpmath.nstr(radius, 4)} m exceeds the body's extent "
        f"{mpmath.nstr(extent, 4)} m (joint points, named points and centre of mass); are inertia and units "
        "right?"
    )


def _extent(places: Sequence[Numbers]) -> mpmath.mpf:
    """The largest distance of two places, found in doubles: bodies of files may have thousands of points."""
    doubles = np.array([[float(entry) for entry in place] for place in places])
    ends, most = (0, 0), -1.0
    for k, place in enumerate(doubles):
        far = np.linalg.norm(doubles - place, axis=1)
        other = int(far.argmax())
        ends, most = ((k, other), far[other]) if far[other] > most else (ends, most)
    a, b = places[ends[0]], places[ends[1]]
    return _length((a[0] - b[0], a[1] - b[1], a[2] - b[2]))


def _skew_warnings(mechanism: Mechanism) -> list[str]:
    """Universal joints whose axes are not perpendicular: geometry that is computed as it is, and seldom meant."""
    found = []
    for joint in mechanism.joints.values():
        if len(joint.axes) == 2:
            product = _dot(*(_numbers(mechanism, axis, f"joints.{joint.name}.axes") for axis in joint.axes))
            if abs(product) > SKEW_AXES:
                angle = mpmath.nstr(_CONTEXT.degrees(_CONTEXT.acos(product)), 8)
                found.append(
                    f"joints.{joint.name}: the axes of this {joint.kind.name} joint are {angle} degrees apart, not 90"
                )
    return found


def _far_warnings(mechanism: Mechanism) -> list[str]:
    """Centres of mass, joint points and named points that lie far from all (other) joint points and named points."""
    fixed = {f"joints.{j.name}: the joint point": j.point for j in mechanism.joints.values()}
    fixed |= {f"points.{p.name}: the point": p.at for p in mechanism.points.values()}
    centres = {f"bodies.{b.name}: the centre of mass": b.com for b in mechanism.bodies.values() if b.com is not None}
    places = {label: _numbers(mechanism, at, label) for label, at in (fixed | centres).items()}
    distinct = {place for name, place in places.items() if name in fixed}
    orders = [sorted(place[k] for place in distinct) for k in range(3)]
    found = []
    for label, place in places.items():
        own = place in distinct  # of the others the least and the greatest come next to its own
        if len(distinct) - own < (3 if label in fixed else 2):  # one or two places do not tell the size of a mechanism
            continue
        low = [order[own and order[0] == x] for order, x in zip(orders, place, strict=True)]
        high = [order[-2 if own and order[-1] == x else -1] for order, x in zip(orders, place, strict=True)]
        extent = _length([b - a for a, b in zip(low, high, strict=True)])
        away = _length([max(a - x, x - b, 0) for a, x, b in zip(low, place, high, strict=True)])
        if away > FAR * extent:
            found.append(
                f"{label} is {mpmath.nstr(away, 4)} m away from the (other) joint points and named points, which lie "
                f"within {mpmath.nstr(extent, 4)} m; is it in metres?"
            )
    return found


def _mpf(value: sympy.Expr, where: str) -> mpmath.mpf:
    number = numeric(value, where=where)
    return _CONTEXT.mpf(number.p) if isinstance(number, sympy.Integer) else _CONTEXT.make_mpf(number._mpf_)


def _numbers(mechanism: Mechanism, vector: Vector, where: str) -> Numbers:
    x, y, z = (_mpf(mechanism.number(entry), where) for entry in vector)
    return (x, y, z)


def _dot(a: Sequence[mpmath.mpf], b: Sequence[mpmath.mpf]) -> mpmath.mpf:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Numbers, b: Numbers) -> Numbers:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _length(a: Sequence[mpmath.mpf]) -> mpmath.mpf:
    return _CONTEXT.sqrt(_dot(a, a))


def _list(values: Numbers) -> str:
    return ", ".join(mpmath.nstr(value, 12) for value in values)

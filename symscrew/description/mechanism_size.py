"""The size of a mechanism: one number [m] by which norms of lengths and angles, forces and moments divide lengths."""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.description.digits import sixty_digits
from symscrew.description.mechanism import Body, Mechanism, Vector

Array = np.ndarray[Any, Any]

SMALLEST = 1e-13
"""Spread of all points [m] that is rounding, where nothing else has a size: doubles computed from lengths of metres
leave 1e-15 of what ought to be the origin, and no mechanism is smaller than an atom. Below, the length is 1; above, it
is the spread: a linkage of nanometres, measured in metres, would lose its closure to rounding, at status 0."""
SAME_POINT = 1e-5
"""The same relative to how far bodies reach from the points: coordinates of six digits leave as much."""
LAST_DIGITS = 1e-9
"""The same relative to coordinates, far from the origin: a robot on the earth is 1e-8 of its distance to the centre;
and relative to radii of gyration, where all centres of mass are in the point as well."""


def characteristic_length(mechanism: Mechanism) -> float:
    """The length [m] by which norms of mixed quantities divide lengths: the description's, if it gives one.

    Else the root mean square distance of the joints' points and the named points from their centre: invariant
    under rigid motions, proportional to the unit; 1 where all points coincide, up to rounding of what was typed, as
    those of a spherical linkage do.
    """
    if mechanism.characteristic_length is not None:
        return float(mechanism.number(mechanism.characteristic_length))
    points = [_doubles(mechanism, joint.point) for joint in mechanism.joints.values()]
    points += [_doubles(mechanism, point.at) for point in mechanism.points.values()]
    cloud = np.array(points)
    size = float(np.sqrt(((cloud - cloud.mean(axis=0)) ** 2).sum(axis=1).mean())) if len(cloud) else 0.0
    # Rounded, so that the same description gives the same bytes on every machine.
    return float(f"{size:.6g}") if size > _rounding(mechanism, cloud) else 1.0


def _doubles(mechanism: Mechanism, place: Vector) -> list[float]:
    """A place by the digits that are known of it since it was read."""
    return [float(sixty_digits(mechanism.number(c))) for c in place]


def _rounding(mechanism: Mechanism, cloud: Array) -> float:
    """The spread [m] that points which are meant to be one have as typed."""
    if not len(cloud):
        return 0.0
    centres = [_doubles(mechanism, body.com) for body in mechanism.bodies.values() if body.com]
    around = [float(np.linalg.norm(np.array(c) - cloud.mean(axis=0))) for c in centres]
    pitches = [abs(float(mechanism.number(j.pitch))) for j in mechanism.joints.values() if j.pitch is not None]
    others = max([*around, *pitches], default=0.0)
    reach = max(
        float(np.abs(cloud).max()), *(radius_of_gyration(mechanism, body) for body in mechanism.bodies.values())
    )
    return max(SMALLEST, SAME_POINT * others, LAST_DIGITS * reach)


def radius_of_gyration(mechanism: Mechanism, body: Body) -> float:
    """About the radius of gyration [m] of a body, 0 without inertia."""
    if body.mass is None or body.inertia is None:
        return 0.0
    mass, *moments = (float(mechanism.number(c)) for c in (body.mass, *(body.inertia[k][k] for k in range(3))))
    return max(0.0, max(moments) / mass) ** 0.5 if mass > 0 else 0.0

"""Screws of the paper: every joint's unit screws, every body's twist and its rate, at O in absolute axes.

Written over any scalar: with nodes of the tape it gives generated functions, with SymPy expressions what a
person reads. The rate of a joint screw carried by a body of twist V is [V, S] (no differentiation).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import (
    ZERO,
    Pose,
    Scalar,
    Twist,
    Vector,
    named_twist,
    product,
    subtract,
    transform,
    transpose,
)
from symscrew.description import JointType, Motion
from symscrew.kinematics.link_quantities import Frame
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.pairs import pair_of
from symscrew.kinematics.tree import Tree


@dataclass(frozen=True)
class BodyMotion:
    """Twist of a link and its componentwise rate, at O in absolute axes."""

    twist: Twist
    rate: Twist


def joint_screws(at: Linkage) -> tuple[tuple[Twist, ...], ...]:
    """Unit screws of every link's motion: one for R, P, H, three through the centre for S (parent's axes)."""
    result: list[tuple[Twist, ...]] = [()]
    for link in at.tree.links[1:]:
        k = link.index
        screws = link.pair.absolute_screws(at.frames[k], at.placed[k], at.poses[link.parent], at.poses[k])
        names = [c.label for c in at.tree.v[link.v]]
        result.append(tuple(named_twist(screw, "screw", name) for screw, name in zip(screws, names, strict=True)))
    return tuple(result)


def motion_screws(
    kind: JointType, axes: Sequence[Vector], point: Vector, pitch: Scalar
) -> list[tuple[Motion, tuple[Twist, ...]]]:
    """(motion, unit screws) of a joint from parent to child, over any scalars.

    `axes` are those that its motions refer to (`JointType.motion_axes`), `pitch` that of a helical joint.
    """
    return [(m, pair_of(m).screws(ZERO if m.axis is None else axes[m.axis], point, pitch)) for m in kind.motions]


def body_motions(
    tree: Tree, screws: Sequence[Sequence[Twist]], w: Sequence[Scalar], w_dot: Sequence[Scalar]
) -> tuple[BodyMotion, ...]:
    """Twists V = sum S w and their rates sum (S dw/dt + [V, S] w) of every link, eq. (6) and its derivative.

    `w` are joint rates; those of a spherical joint along its parent's axes.
    """
    still = Twist(ZERO, ZERO)
    result = [BodyMotion(still, still)]
    for link in tree.links[1:]:
        carrier = result[link.parent]
        twist, rate = carrier.twist, carrier.rate
        for screw, speed, gain in zip(screws[link.index], w[link.v], w_dot[link.v], strict=True):
            rate = rate + screw * gain + carrier.twist.bracket(screw) * speed
            twist = twist + screw * speed
        part = tree.part(link.index)
        result.append(BodyMotion(named_twist(twist, "twist", part), named_twist(rate, "twist_rate", part)))
    return tuple(result)


def displacement(frame: Frame, pose: Pose) -> Pose:
    """How a link has moved since the reference configuration: x_now = rotation x_reference + translation."""
    rotation = product(pose.rotation, transpose(frame.axes))
    return Pose(rotation, subtract(pose.translation, transform(rotation, frame.origin)))

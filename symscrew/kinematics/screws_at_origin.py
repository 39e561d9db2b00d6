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
    helical,
    prismatic,
    product,
    revolute,
    subtract,
    transform,
    transpose,
)
from symscrew.kinematics.link_frames import Frame
from symscrew.kinematics.recursion import Placement
from symscrew.kinematics.tree import Link, Tree


@dataclass(frozen=True)
class BodyMotion:
    """Twist of a link and its componentwise rate, at O in absolute axes."""

    twist: Twist
    rate: Twist


def joint_screws(
    tree: Tree, frames: Sequence[Frame], placed: Sequence[Placement], pose: Sequence[Pose]
) -> tuple[tuple[Twist, ...], ...]:
    """Unit screws of every link's motion: one for R, P, H, three through the centre for S (parent's axes)."""
    result: list[tuple[Twist, ...]] = [()]
    for link in tree.links[1:]:
        result.append(_link_screws(link, frames[link.index], placed[link.index], pose[link.parent], pose[link.index]))
    return tuple(result)


def _link_screws(link: Link, frame: Frame, placed: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
    if link.motion.kind == "F":
        return ()
    if link.motion.kind == "S":
        before = transpose(product(parent.rotation, placed.rotation))
        return tuple(revolute(axis, own.translation) for axis in before)
    if link.motion.kind == "P":
        return (prismatic(parent.direction(frame.axis)),)
    axis = transpose(own.rotation)[2]
    if link.motion.kind == "H":
        return (helical(axis, own.translation, frame.pitch),)
    return (revolute(axis, own.translation),)


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
        result.append(BodyMotion(twist, rate))
    return tuple(result)


def displacement(frame: Frame, pose: Pose) -> Pose:
    """How a link has moved since the reference configuration: x_now = rotation x_reference + translation."""
    rotation = product(pose.rotation, transpose(frame.axes))
    return Pose(rotation, subtract(pose.translation, transform(rotation, frame.origin)))

"""A screw motion: a rotation about the link's z with a translation along it, by the joint's pitch h [m/rad].

What does work on it is a wrench that no component of force or moment shows alone, and what lies on its axis moves
along it: so nothing is cleared from a reaction, and no inertia is the parent's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symscrew.algebra import Node, Pose, Scalar, Tape, Twist, Vector, add, helical, scale, transpose
from symscrew.kinematics.link_quantities import Frame, Placement
from symscrew.kinematics.pairs.lower_pair import LowerPair, Site, Turn
from symscrew.kinematics.pairs.revolute_pair import cosine_sine, turned, turning_frame


class Helical(LowerPair):
    """H: a rotation by q + phase about z, and a translation by h (q - reference) along it."""

    def frame(self, site: Site) -> Frame:
        """That of the rotation, with the pitch."""
        return replace(turning_frame(site), pitch=site.geometry.scalar(site.joint.pitch))

    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        """The axes turn about z, the origin moves along it."""
        resting = turned(frame, turn or cosine_sine(tape, frame, q[0]))
        lift = frame.pitch * (q[0] - frame.reference)
        return replace(resting, offset=add(frame.offset, scale(lift, frame.axis)))

    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        """An angular velocity about z and a velocity along it."""
        return Twist((0, 0, v[0]), scale(frame.pitch * v[0], frame.axis))

    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        """Moment about z and h times the force along it."""
        return (moment[2] + frame.pitch * force[2],)

    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        """(e_z ; h e_z)."""
        return (Twist((0, 0, 1), (0, 0, frame.pitch)),)

    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        """(e ; r x e + h e)."""
        return (helical(transpose(own.rotation)[2], own.translation, frame.pitch),)

    def screws(self, axis: Vector, point: Vector, pitch: Scalar) -> tuple[Twist, ...]:
        """(e ; r x e + h e)."""
        return (helical(axis, point, pitch),)

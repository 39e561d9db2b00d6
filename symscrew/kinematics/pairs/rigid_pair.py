"""No motion: the link of a fixed joint, which is its parent in other words."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import IDENTITY, ZERO, Matrix, Node, Pose, Scalar, Tape, Twist, Vector, add, scale
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import NO_SPREAD, Frame, Inertia, Placement
from symscrew.kinematics.pairs.lower_pair import LowerPair, Site, Turn


class Rigid(LowerPair):
    """Nothing moves: no coordinates and no screws."""

    def frame(self, site: Site) -> Frame:
        """At the joint's point, in the parent's axes."""
        return site.resting_frame(site.point)

    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        """As in the reference configuration."""
        return Placement(frame.rotation, IDENTITY, frame.offset)

    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        """Nothing."""
        return Twist(ZERO, ZERO)

    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        """None."""
        return ()

    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        """None."""
        return ()

    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        """None."""
        return ()

    def screws(self, axis: Vector, point: Vector, pitch: Scalar) -> tuple[Twist, ...]:
        """None."""
        return ()

    def base_inertia(self, geometry: Geometry, frame: Frame, own: Inertia) -> tuple[Inertia, Inertia] | None:
        """All of it is the parent's."""
        return Inertia(geometry.tape.zero, ZERO, NO_SPREAD), _shifted(frame, own)

    def reference(self, value: float) -> tuple[float, ...]:
        """No entries."""
        return ()


def _shifted(frame: Frame, inertia: Inertia) -> Inertia:
    """The inertia of a link that is fixed to its parent (equal axes), about the parent's origin."""
    r, s = frame.offset, inertia.first

    def row(i: int) -> Vector:
        x, y, z = (inertia.second[i][j] + r[i] * s[j] + s[i] * r[j] + inertia.mass * (r[i] * r[j]) for j in range(3))
        return (x, y, z)

    spread: Matrix = (row(0), row(1), row(2))
    return Inertia(inertia.mass, add(s, scale(inertia.mass, r)), spread, inertia.still)

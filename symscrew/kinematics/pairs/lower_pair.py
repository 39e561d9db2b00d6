"""What every elementary motion of a joint answers: its frame, its placement, its screws, powers and steps.

    axes before the motion --q--> link axes        w = rates in the former, v = rates in the latter

Rates v are in link axes, joint rates w in the axes before the motion. The two differ for a spherical motion
only, since an axis keeps its components when the link turns about it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import IDENTITY, ZERO, Node, Pose, Scalar, Tape, Twist, Vector, scale, subtract, transform
from symscrew.algebra import transpose as transposed
from symscrew.description import Joint, Motion
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import Frame, Inertia, Placement

Turn = tuple[Node, Node]
"""Cosine and sine of an angle."""

Array = np.ndarray[Any, Any]


@dataclass(frozen=True)
class Site:
    """Where a motion is in the reference configuration, and what lies further out on its link.

    `position` is the motion's place among its joint's, `inverted` says that the tree passes the joint from child
    to parent: its axis is then negated. `outboard_points` and `outboard_axes` are the points and axes, absolute,
    of what leaves the link outwards.
    """

    geometry: Geometry
    parent: Frame
    on_ground: bool
    joint: Joint
    position: int
    inverted: bool
    outboard_points: Callable[[], Iterator[Vector]]
    outboard_axes: Callable[[], Iterator[Vector]]

    @property
    def motion(self) -> Motion:
        """The motion itself."""
        return self.joint.kind.motions[self.position]

    @property
    def point(self) -> Vector:
        """The joint's point [m], absolute."""
        return self.geometry.vector(self.joint.point)

    @property
    def axis(self) -> Vector:
        """The motion's axis, absolute, outwards."""
        axis = self.geometry.motion_axes(self.joint)[self.motion.axis or 0]
        return scale(-1, axis) if self.inverted else axis

    @property
    def reference(self) -> Node:
        """The coordinate in the reference configuration."""
        if not self.joint.reference:
            return self.geometry.tape.zero
        return self.geometry.scalar(self.joint.reference[self.position])

    def in_parent(self, point: Vector) -> Vector:
        """An absolute point in the parent's coordinates."""
        back = transposed(self.parent.axes)
        return self.geometry.settle(transform(back, subtract(point, self.parent.origin)))

    def resting_frame(self, origin: Vector) -> Frame:
        """A frame at `origin` that keeps the parent's axes."""
        zero = self.geometry.tape.zero
        return Frame(self.parent.axes, origin, IDENTITY, self.in_parent(origin), ZERO, zero)


class LowerPair(ABC):
    """One elementary motion. Vectors have three scalars, matrices three rows; `frame` is the link's.

    A motion's file holds one subclass without data; `pair_table` holds its only object.
    """

    @abstractmethod
    def frame(self, site: Site) -> Frame:
        """The frame of the link that the motion moves, chosen so that its constants are mostly zeros and ones."""

    @abstractmethod
    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        """Where the link is on its parent at coordinates q; `turn` is cosine and sine of an angle that is known."""

    @abstractmethod
    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        """What rates v add to the parent's twist: angular part in link axes, linear part in parent axes."""

    @abstractmethod
    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        """Power per unit rate of a wrench at the link's origin.

        In the axes before the motion it is that per joint rate w, in link axes that per rate v.
        """

    @abstractmethod
    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        """Unit screw per entry of v, link axes, at the link's origin."""

    @abstractmethod
    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        """Unit screw per joint rate w at O in absolute axes, from the poses of the parent and of the link."""

    @abstractmethod
    def screws(self, axis: Vector, point: Vector, pitch: Scalar) -> tuple[Twist, ...]:
        """Unit screws of an axis through a point, over any scalars; spherical: about the axes of the coordinates."""

    def cleared(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Vector, Vector]:
        """A wrench at the link's origin, axes before the motion, without what does work on the motion.

        One that does not split into a force or a couple along an axis (helical) is returned as it is.
        """
        return force, moment

    def base_inertia(self, geometry: Geometry, frame: Frame, own: Inertia) -> tuple[Inertia, Inertia] | None:
        """(what stays on the link, what moves with the parent just as well, about its origin), or None."""
        return None

    def reference(self, value: float) -> tuple[float, ...]:
        """Entries of q in the reference configuration, from the description's value."""
        return (value,)

    def moved(self, q: Array, step: Array) -> Array:
        """Coordinates (..., entries) after a step along joint rates w (..., freedoms)."""
        return q + step

    def joint_rates(self, placement: Placement, v: Sequence[Node]) -> Sequence[Node]:
        """w from v."""
        return v

    def tree_rates(self, placement: Placement, w: Sequence[Node]) -> Sequence[Node]:
        """v from w."""
        return w

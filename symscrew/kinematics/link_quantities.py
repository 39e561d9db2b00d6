"""What is known of a link: its frame, its place on its parent, its rates and its inertia.

    parent --Frame.rotation--> axes before the motion --Placement.turn--> link axes

Every quantity stands in the link's own axes, at the link's own origin, unless its name says otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from symscrew.algebra import ZERO, Matrix, Node, Vector, add, transform, transpose

Wrench = tuple[Vector, Vector]
"""(force [N], moment [N m] about a point that the context names)."""

NO_SPREAD: Matrix = ((0, 0, 0),) * 3
"""The second moment matrix of no mass."""


@dataclass(frozen=True)
class Frame:
    """Constants of a link.

    `axes`: absolute_R_link in the reference configuration. `origin`: absolute, in the reference
    configuration. `rotation`: parent_R_link before the joint's own motion. `offset`: of the origin from the
    parent's, parent's axes, in the reference configuration. `axis`: the joint axis in the parent's axes.
    `reference`: the joint's coordinate in the reference configuration.
    `phase`: the motion is a rotation about z by q + phase (R, H) or a translation by q + phase along `axis`.
    `arm`: from the origin to the joint's point in the link's axes, of a slider to the line along which it is pushed.
    """

    axes: Matrix
    origin: Vector
    rotation: Matrix
    offset: Vector
    axis: Vector
    phase: Node
    reference: Node | int = 0
    start: tuple[Node, Node] | None = None  # cosine and sine of the angle at the reference configuration
    pitch: Node | None = None
    arm: Vector = ZERO


@dataclass(frozen=True)
class Placement:
    """Where a link is on its parent, for given coordinates.

    `turn` rotates link axes to the axes before the motion, `rotation` those to the parent's axes; `offset`
    is the link's origin in the parent's coordinates. Vectors that were turned before are known: a model's functions
    turn the same ones again and again.
    """

    rotation: Matrix
    turn: Matrix
    offset: Vector
    known: dict[tuple[str, Vector], Vector] = field(default_factory=dict, init=False, repr=False, compare=False)

    def outwards(self, vector: Vector) -> Vector:
        """A vector from parent axes to link axes."""
        key = ("outwards", vector)
        if key not in self.known:
            self.known[key] = transform(transpose(self.turn), transform(transpose(self.rotation), vector))
        return self.known[key]

    def before(self, vector: Vector) -> Vector:
        """A vector from link axes to the axes before the joint's motion."""
        key = ("before", vector)
        if key not in self.known:
            self.known[key] = transform(self.turn, vector)
        return self.known[key]

    def from_before(self, vector: Vector) -> Vector:
        """A vector from the axes before the joint's motion to parent axes."""
        key = ("from_before", vector)
        if key not in self.known:
            self.known[key] = transform(self.rotation, vector)
        return self.known[key]

    def inwards(self, vector: Vector) -> Vector:
        """A vector from link axes to parent axes."""
        return self.from_before(self.before(vector))


@dataclass(frozen=True)
class Rates:
    """Angular velocity, angular acceleration, acceleration of the origin, and U; link axes."""

    omega: Vector
    alpha: Vector
    origin: Vector
    matrix: Matrix

    def at(self, point: Vector) -> Vector:
        """Acceleration of the point of the link at `point` (link coordinates)."""
        return add(self.origin, transform(self.matrix, point))


@dataclass(frozen=True)
class Inertia:
    """Mass, first moment and second moment matrix about the link's origin, link axes.

    `still` is the part of the second moment matrix whose moments in omega are left out: nothing, but for a
    simplification.
    """

    mass: Node
    first: Vector
    second: Matrix
    still: Matrix = NO_SPREAD

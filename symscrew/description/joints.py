"""The joint types, as data: one table for every algorithm of the package.

A joint is a product of elementary motions, from parent to child. Each elementary motion is a rotation
("R"), a translation ("P") or a screw motion ("H") about an axis, or a spherical rotation ("S").
`symscrew` never branches on a joint's type: it walks over `JointType.motions` and asks each motion what it
is (`Motion.turns`, `Motion.slides`, `Motion.freedom` ...). What a motion does with nodes, its velocity and
the power of a wrench along it, is its lower pair's (`symscrew.kinematics.pairs`, one file each).

A new joint type that is made of these motions is a line in `JOINT_TYPES`. A new motion is a constructor here
and a file there.

The reciprocal wrenches of a joint, which a cut joint contributes as its loop closure, follow from the
same table (`symscrew.kinematics.cut_joints`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TypeVar

Axis = TypeVar("Axis")


@dataclass(frozen=True)
class Entry:
    """One entry of a motion in q or in v: what its label ends in, what it is, and its unit."""

    suffix: str
    kind: str
    unit: str


@dataclass(frozen=True)
class Motion:
    """One elementary motion: what its axis is and what it does along and about it.

    `kind` is its letter: "R", "P", "H", "S", or "F" for none. `axis` is the index into the joint's axes (see
    `JointType`); "S" and "F" have none. A motion `turns` if the child's axes turn against the parent's, and
    `slides` if points of the axis move along it. `q` and `v` are its entries among the coordinates and
    their rates, `parts` says how the names of its freedoms end.
    """

    kind: str
    axis: int | None = None
    name: str = ""
    turns: bool = False
    slides: bool = False
    q: tuple[Entry, ...] = ()
    v: tuple[Entry, ...] = ()
    parts: tuple[str, ...] = ()

    @property
    def freedom(self) -> int:
        """Number of freedoms: entries in v."""
        return len(self.v)

    @property
    def fixed(self) -> bool:
        """Whether nothing moves."""
        return self.freedom == 0

    @property
    def single(self) -> bool:
        """Whether it has one freedom, along or about one axis, and one coordinate."""
        return self.freedom == 1

    @property
    def spherical(self) -> bool:
        """Whether it is a rotation about a point: three freedoms, and a quaternion as coordinates."""
        return self.freedom == 3

    @property
    def revolute(self) -> bool:
        """Whether it is a pure rotation about its axis."""
        return self.single and self.turns and not self.slides

    @property
    def prismatic(self) -> bool:
        """Whether it is a pure translation along its axis: coordinate in metres, effort in newtons."""
        return self.single and self.slides and not self.turns

    @property
    def helical(self) -> bool:
        """Whether it is a rotation with a translation, by the joint's pitch."""
        return self.single and self.turns and self.slides


class Triad(Enum):
    """Which axes the motions of a joint refer to."""

    GIVEN = "the axes of the description"
    NORMAL = "the axis of the description is the last of three; two are completed across it"
    ABSOLUTE = "the absolute axes"


@dataclass(frozen=True)
class JointType:
    """`axes` = number of axes that the description gives; `motions` in order from parent to child.

    E and free joints need a full triad: given axis 2 is the normal of the plane, 0 and 1 are completed
    orthogonally (free: the absolute axes).
    """

    letter: str
    name: str
    axes: int
    motions: tuple[Motion, ...]
    triad: Triad = Triad.GIVEN

    @property
    def freedom(self) -> int:
        """Number of freedoms: 3 for each spherical motion, 1 for any other."""
        return sum(motion.freedom for motion in self.motions)

    @property
    def freedoms(self) -> tuple[Motion, ...]:
        """The motion that each freedom belongs to: three times the same for a spherical motion."""
        return tuple(m for m in self.motions for _ in range(m.freedom))

    @property
    def starts(self) -> tuple[int, ...]:
        """The first freedom of each motion."""
        return tuple(sum(m.freedom for m in self.motions[:k]) for k in range(len(self.motions)))

    @property
    def sliding(self) -> tuple[int, ...]:
        """Indices of the axes of its pure translations."""
        return tuple(m.axis or 0 for m in self.motions if m.prismatic)

    @property
    def turning(self) -> tuple[int, ...]:
        """Indices of the axes about which it turns: of rotations and screw motions."""
        return tuple(m.axis or 0 for m in self.motions if m.single and m.turns)

    @property
    def slides(self) -> bool:
        """Whether the joint's point on one body moves along an axis on the other."""
        return any(m.slides for m in self.motions)

    @property
    def helical(self) -> bool:
        """Whether it has a screw motion, and so needs a pitch."""
        return any(m.helical for m in self.motions)

    @property
    def spherical(self) -> bool:
        """Whether it has a spherical motion, so that it turns about every axis."""
        return any(m.spherical for m in self.motions)

    @property
    def ball(self) -> bool:
        """Whether a spherical motion is all it has."""
        return len(self.motions) == 1 and self.spherical

    @property
    def hinge(self) -> bool:
        """Whether a rotation about an axis is all it has."""
        return len(self.motions) == 1 and self.motions[0].revolute

    @property
    def slider(self) -> bool:
        """Whether a translation along an axis is all it has."""
        return len(self.motions) == 1 and self.motions[0].prismatic

    @property
    def universal(self) -> bool:
        """Whether it turns about two axes, the first on the parent and the second on the child."""
        return sum(m.revolute for m in self.motions) == 2

    @property
    def planar(self) -> bool:
        """Whether it slides in a plane, along two directions that are completed across the given normal."""
        return self.triad is Triad.NORMAL

    @property
    def closable(self) -> bool:
        """Whether its reciprocal wrenches are known when a loop is cut at it.

        All its axes are at rest on both bodies (one axis, or a plane and its normal), or it turns only.
        """
        turns_only = not self.slides and (self.ball or len(self.turning) <= 2)
        return turns_only or self.triad is Triad.NORMAL or (self.axes == 1 and not self.spherical)

    @property
    def unconstrained(self) -> bool:
        """Whether it leaves all six freedoms."""
        return self.freedom == 6

    @property
    def references(self) -> int:
        """How many coordinates may have a reference value: all, but none of spherical motions and completed axes."""
        return 0 if self.spherical or self.triad is not Triad.GIVEN else len(self.motions)

    def motion_axes(
        self, given: Sequence[Axis], units: Sequence[Axis], across: Callable[[Axis], tuple[Axis, Axis]]
    ) -> tuple[Axis, ...]:
        """The axes that the motions refer to, over any vectors, from those that the description gives.

        `units` are the absolute axes, `across(normal)` two directions that complete a normal to a triad.
        """
        if self.triad is Triad.ABSOLUTE:
            return tuple(units)
        if self.triad is Triad.NORMAL:
            first, second = across(given[0])
            return (first, second, given[0])
        return tuple(given)

    def motion_names(self, joint: str) -> list[str]:
        """A name for every motion of a joint of that name: `joint`, or `joint.i` where there are several."""
        return [joint if len(self.motions) == 1 else f"{joint}.{k}" for k in range(len(self.motions))]

    def freedom_names(self, joint: str) -> list[str]:
        """A name for every freedom of a joint of that name: its motion's, or `joint.x` ... for a spherical motion."""
        return [
            f"{joint}{part}" if part else name
            for name, motion in zip(self.motion_names(joint), self.motions, strict=True)
            for part in motion.parts
        ]


def _along_axis(letter: str, axis: int, name: str, *, turns: bool, slides: bool) -> Motion:
    kind, unit = ("angle", "rad") if turns else ("length", "m")
    q, v = (Entry("", kind, unit),), (Entry("", kind, f"{unit}/s"),)
    return Motion(letter, axis, name, turns=turns, slides=slides, q=q, v=v, parts=("",))


def rotation(axis: int = 0) -> Motion:
    """R: a rotation about an axis."""
    return _along_axis("R", axis, "rotation", turns=True, slides=False)


def translation(axis: int = 0) -> Motion:
    """P: a translation along an axis."""
    return _along_axis("P", axis, "translation", turns=False, slides=True)


def screw_motion(axis: int = 0) -> Motion:
    """H: a rotation about an axis with a translation along it, by the joint's pitch."""
    return _along_axis("H", axis, "screw motion", turns=True, slides=True)


SPHERICAL = Motion(
    "S",
    name="rotation",
    turns=True,
    q=tuple(Entry(f".q{c}", "quaternion", "1") for c in "wxyz"),
    v=tuple(Entry(f".w{c}", "rotation", "rad/s") for c in "xyz"),
    parts=(".x", ".y", ".z"),
)
"""S: a rotation about a point; its coordinates are the unit quaternion (w, x, y, z) of child axes to parent axes."""

NO_MOTION = Motion("F")
"""F: the single, immobile link of a fixed joint."""

JOINT_TYPES: dict[str, JointType] = {
    "R": JointType("R", "revolute", 1, (rotation(),)),
    "P": JointType("P", "prismatic", 1, (translation(),)),
    "H": JointType("H", "helical", 1, (screw_motion(),)),
    "C": JointType("C", "cylindrical", 1, (translation(), rotation())),
    "U": JointType("U", "universal", 2, (rotation(0), rotation(1))),
    "S": JointType("S", "spherical", 0, (SPHERICAL,)),
    "E": JointType("E", "planar", 1, (translation(0), translation(1), rotation(2)), Triad.NORMAL),
    "fixed": JointType("fixed", "fixed", 0, ()),
    "free": JointType("free", "free", 0, (*map(translation, range(3)), SPHERICAL), Triad.ABSOLUTE),
}

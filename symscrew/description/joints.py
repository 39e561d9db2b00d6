"""The joint types, as data: one table for every algorithm of the package.

A joint is a product of elementary motions, from parent to child. Each elementary motion is a rotation
("R"), a translation ("P") or a screw motion ("H") about an axis, or a spherical rotation ("S").
`symscrew` never branches on a joint's type: it walks over `JointType.motions`.

The reciprocal wrenches of a joint, which a cut joint contributes as its loop closure, follow from the
same table (`symscrew.kinematics.cut_joints`).
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Motion:
    """One elementary motion: its kind ("R", "P", "H", "S", or "F" for none) and how its axis is found.

    `axis` is the index into the joint's axes (see `JointType`); "S" and "F" have none.
    """

    kind: str
    axis: int | None = None


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

    @property
    def freedom(self) -> int:
        """Number of freedoms: 3 for each spherical motion, 1 for any other."""
        return len(self.freedoms)

    @property
    def freedoms(self) -> tuple[Motion, ...]:
        """The motion that each freedom belongs to: three times the same for a spherical motion."""
        return tuple(m for m in self.motions for _ in range(3 if m.kind == "S" else 1))


R, P, H, S = (lambda axis: Motion("R", axis)), (lambda axis: Motion("P", axis)), Motion("H", 0), Motion("S")

JOINT_TYPES: dict[str, JointType] = {
    "R": JointType("R", "revolute", 1, (R(0),)),
    "P": JointType("P", "prismatic", 1, (P(0),)),
    "H": JointType("H", "helical", 1, (H,)),
    "C": JointType("C", "cylindrical", 1, (P(0), R(0))),
    "U": JointType("U", "universal", 2, (R(0), R(1))),
    "S": JointType("S", "spherical", 0, (S,)),
    "E": JointType("E", "planar", 1, (P(0), P(1), R(2))),
    "fixed": JointType("fixed", "fixed", 0, ()),
    "free": JointType("free", "free", 0, (P(0), P(1), P(2), S)),
}

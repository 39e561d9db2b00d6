"""What a class of limbs with a closed form answers: where its tip is wanted, and its coordinates from there.

    platform's pose --target--> place of the tip, as the limb sees it --solve--> cosines and sines, slides

One file a class; `closed_forms` has the table.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar

from symscrew.algebra import Node, Vector
from symscrew.kinematics import Cut, Link, Linkage, System, Turn


class LimbForm(ABC):
    """A limb whose coordinates follow from where the platform holds its tip, the point of the cut joint.

    `left_open`: components of the tip's place, in its axes, that the closed form leaves to the closure. `through_rods`:
    whether the closed form points a rod at the tip: far from a solution the assembly then finds fewer of them by the
    platform's coordinates alone than by all.
    """

    cut: Cut
    left_open: tuple[int, ...] = ()
    through_rods: ClassVar[bool] = False

    @property
    @abstractmethod
    def links(self) -> tuple[Link, ...]:
        """The limb's links, from the one that is carried by the ground or by another limb."""

    @abstractmethod
    def solve(self, system: System, target: Vector, guess: Sequence[Node]) -> tuple[dict[int, Turn], dict[int, Node]]:
        """Cosine and sine of every angle by link, slides by index into q, on the branch of the guess (nodes of q)."""

    def opening(self, system: System, target: Vector) -> Node | None:
        """How far what is `left_open` is from closed [m], where that takes less than the closure's row; else None."""
        return None

    def target(self, linkage: Linkage) -> Vector:
        """Where the platform holds the tip [m], in coordinates of the link that carries the limb."""
        return linkage.carry_point(self.cut.hub, self.links[0].parent, self.cut.hub_point)

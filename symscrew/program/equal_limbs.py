"""Which parts of a mechanism are equal limbs: what lanes are made of, and what headings of generated code are called.

    base -- U -- lower -- P -- upper -- S -- platform      limb 1: lower, upper ...     roles 0, 1, ...
         -- U -- lower -- P -- upper -- S --               limb 2: the same roles

`symscrew.kinematics` finds them from the spanning tree; a program carries them beside its instructions.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property


@dataclass(frozen=True)
class Limb:
    """A branch of the tree: `parts` are its bodies, joints and motions (`joint.0`), each with its role in the limb.

    Parts of equal limbs with the same role correspond to each other.
    """

    name: str
    parts: Mapping[str, str]


@dataclass(frozen=True)
class Limbs:
    """Families of equal limbs, those on the base or a hub first, then equal branches inside of limbs."""

    families: tuple[tuple[Limb, ...], ...] = ()

    @cached_property
    def _outermost(self) -> dict[str, Limb]:
        found: dict[str, Limb] = {}
        for limb in (limb for family in self.families for limb in family):
            for part in limb.parts:
                found.setdefault(part, limb)
        return found

    def limb_of(self, part: str) -> Limb | None:
        """The limb that a body, a joint or a joint's motion belongs to, the outermost; None on the base or a hub."""
        return self._outermost.get(part)


NO_LIMBS = Limbs()

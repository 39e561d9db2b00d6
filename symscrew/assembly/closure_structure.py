"""The structure of a closure: groups of homogeneous coordinates, loops of forms, and the slots that hold its numbers.

Two mechanisms of one structure differ in the numbers of their slots only: points, axes, lengths.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from symscrew.algebra import dot, subtract
from symscrew.assembly.elementary_graph import Edge, HeldGraph, Point, Run

WIDTH = {"turn": 2, "slide": 2, "ball": 4, "planar": 4, "free": 8}
"""Homogeneous coordinates of a group."""


@dataclass(frozen=True)
class Slot:
    """Numbers of a structure: a point or an axis fixed in a body, or a number.

    `kind`: "point", "axis", "number", "distance" (of slots 0 and 1, with a rod between two places as length); "turned"
    and "slid": cosine and sine, or 1 and the way itself, of what is held in the column `at`. `body`: that carries it;
    `at`: where in the reference.
    """

    kind: str
    body: str = ""
    at: Any = None
    of: tuple[int, ...] = ()
    rod: tuple[tuple[str, Point], tuple[str, Point]] | None = None


@dataclass(frozen=True)
class Group:
    """Homogeneous coordinates: of a joint of the tree, or of a cluster against the ground. `edge`: of a joint."""

    kind: str
    cluster: str
    parent: str
    slots: tuple[int, ...]
    edge: Edge | None = None
    forward: bool = True


@dataclass(frozen=True)
class Form:
    """An equation or four: "distance", "angle", "crossing", "meeting", "parallel", "turned", "slid", and its slots."""

    kind: str
    slots: tuple[int, ...]


@dataclass(frozen=True)
class Loop:
    """All forms in the displacement of cluster `body` against cluster `base`.

    `spins`: of a coupling, (place among the structure's spins, whether back) for each of its factors: no bodies'.
    """

    base: str
    body: str
    forms: tuple[Form, ...]
    spins: tuple[tuple[int, bool], ...] = ()


@dataclass(frozen=True)
class Spin:
    """The motion of a group that a coupling ties, as a turn about one axis for all, or `size` times its slide."""

    group: int
    turning: bool
    size: int = 1


@dataclass(frozen=True)
class Rod:
    """A cluster that only holds two points at a distance: its runs, from base to body.

    `crossing`: it also holds the outer axes of its universal joints in one plane with itself.
    """

    cluster: str
    runs: tuple[Run, Run]
    crossing: bool = False


@dataclass(frozen=True)
class Structure:
    """Groups, loops, slots. `unknowns`, `equations`: their numbers, equal where nothing is redundant.

    `chains`: cluster -> its groups from the ground. `open_limbs`: chains that hold nothing. `spins`: motions that
    couplings tie. `frame`: rows are the axes
    that coordinates are counted in, about
    `centre`; a planar mechanism lies in the first two.
    """

    graph: HeldGraph
    groups: tuple[Group, ...]
    loops: tuple[Loop, ...]
    slots: tuple[Slot, ...]
    chains: Mapping[str, tuple[int, ...]]
    rods: tuple[Rod, ...]
    unknowns: int
    equations: int
    frame: tuple[Point, Point, Point]
    centre: Point
    open_limbs: tuple[tuple[Run, ...], ...] = ()
    spins: tuple[Spin, ...] = ()

    @property
    def crossings(self) -> bool:
        """Whether legs hold axes in one plane: numbers of three slots are multiplied."""
        return any(rod.crossing for rod in self.rods)

    @property
    def planar(self) -> bool:
        """Whether all motion is along one plane."""
        return self.graph.axis is not None

    @property
    def key(self) -> str:
        """The same of two mechanisms of one structure."""
        groups = [
            (g.kind, g.slots, [k for k, c in enumerate(self.groups) if c.cluster == g.parent]) for g in self.groups
        ]
        loops = [
            (self.chains[loop.base], self.chains[loop.body], [(f.kind, f.slots) for f in loop.forms], *self._tied(loop))
            for loop in self.loops
        ]
        kind = "spherical" if self.graph.spherical else self.planar
        return repr((kind, groups, loops, [(s.kind, s.of) for s in self.slots]))

    def _tied(self, loop: Loop) -> list[tuple[int, bool, int, bool]]:
        found = [(self.spins[k], back) for k, back in loop.spins]
        return [(spin.group, spin.turning, spin.size, back) for spin, back in found]

    def local(self, point: Point) -> Point:
        """A point in the frame about the centre; of a planar mechanism on the plane."""
        return self.turned(subtract(point, self.centre))

    def turned(self, vector: Point) -> Point:
        """A vector in the frame."""
        x, y, z = (dot(axis, vector) for axis in self.frame)
        return (x, y, 0 * z) if self.planar else (x, y, z)

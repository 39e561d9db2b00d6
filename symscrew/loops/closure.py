"""The closure that loops are solved with: every cut joint in one of its formulations, and what a mode adds.

    rows . (w ; z) = right side:   rows of the cut joints in their order | definitions of z | followers of a mode

z are components of velocities that the rows of a formulation use beside the joint rates w.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from symscrew.algebra import Affine, Column, Node, cost, substitute
from symscrew.kinematics import System
from symscrew.loops.formulations import CHOICES, FORMULATIONS, CutRows
from symscrew.loops.modes import Mode


@dataclass(frozen=True)
class Closure:
    """J (w ; z) = right side: the rows of all loops; `parts`: those of each of `system.cuts`.

    The first rows are the cut joints', one per reciprocal wrench; their right side is 0 for rates, the negative of
    `bias` for accelerations and of the residual for a Newton step. All further rows have right sides 0.

    In an operation `mode` coordinates that follow from others are replaced in the rows, and rates that do have rows.
    """

    system: System
    parts: tuple[CutRows, ...]
    mode: Mode | None = None

    @property
    def of_system(self) -> bool:
        """Whether the system's residual, and changes of its own rows, are right sides of these rows."""
        return all(part.of_system for part in self.parts)

    @cached_property
    def unknowns(self) -> dict[Column, float]:
        """Every unknown with its unit scale: joint rates by index into v, then components."""
        scales = dict(enumerate(map(float, self.system.scales)))
        return {**scales, **{name: 1.0 for part in self.parts for name, _ in part.definitions}}

    @cached_property
    def rows(self) -> list[Affine]:
        """{unknown: entry} of every row."""
        definitions = [row for part in self.parts for _, row in part.definitions]
        rows = [*(row for part in self.parts for row in part.rows), *definitions]
        return [*map(self._in_mode, rows), *(row for _, row in self._followers)] if self.mode else rows

    @property
    def scales(self) -> list[float]:
        """What makes the entries of every row per joint rate without units."""
        scales = [scale for part in self.parts for scale in part.scales]
        scales += [1.0 for part in self.parts for _ in part.definitions]
        return [*scales, *(1.0 / self.unknowns[column] for column, _ in self._followers)]

    @property
    def defined(self) -> dict[int, Column]:
        """Index of a row that is there for one unknown -> this unknown."""
        names = [*(name for part in self.parts for name, _ in part.definitions), *(k for k, _ in self._followers)]
        start = sum(len(part.rows) for part in self.parts)
        return dict(enumerate(names, start))

    @cached_property
    def _followers(self) -> list[tuple[int, Affine]]:
        return self.mode.rows if self.mode else []

    def bias(self, moving: System) -> list[Node]:
        """(dJ/dt) v per row of the cut joints, for the system with rates that keep the loops closed."""
        still = moving.rates([moving.tape.zero] * len(moving.tree.v))
        pairs = zip(self.parts, moving.cuts, strict=True)
        return [value for part, cut in pairs for value in part.bias(moving, cut, still)]

    def cost(self, nodes: Sequence[Node]) -> int:
        """What it takes to compute nodes, in the operation mode if there is one: see `symscrew.algebra.cost`."""
        return cost(substitute(self.system.tape, nodes, self.mode.nodes) if self.mode else nodes)

    def _in_mode(self, row: Affine) -> Affine:
        assert self.mode is not None
        entries = substitute(self.system.tape, list(row.values()), self.mode.nodes)
        return {k: entry for k, entry in zip(row, entries, strict=True) if entry is not self.system.tape.zero}


def closures(system: System) -> Iterator[Closure]:
    """The closures to choose from, one per entry of `CHOICES`, those with equal rows once.

    They are made one after another, as they are asked for: each leaves its nodes on the tape.
    """
    made: list[Closure] = []
    for names in CHOICES:
        closure = closure_by(system, names)
        if all(closure.rows != other.rows for other in made):
            made.append(closure)
            yield closure


def closure_by(system: System, names: Sequence[str]) -> Closure:
    """The closure in which every cut joint takes the first that it has of these formulations."""
    found: dict[int, CutRows] = {}
    for name in names:
        for k, cut in enumerate(system.cuts):
            rows = FORMULATIONS[name](system, cut) if k not in found else None
            if rows is not None:
                found[k] = rows
    return Closure(system, tuple(found[k] for k in range(len(system.cuts))))

"""The closure of all loops as a grid without units, and the volume that vanishes where it loses rank.

    rows of cut joints over joint rates --private rates eliminated--> rows over shared rates --volume--> a number

Rates that only one cut joint's rows know (a leg's own) are eliminated with the wrenches reciprocal to them, so that
the volume of what is left does not vanish where only that leg is singular.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace

from symscrew.algebra import (
    IDENTITY,
    Grid,
    Node,
    Volume,
    dot,
    rank_of,
    reciprocal_factors,
    trimmed,
    vanishes,
    volume,
)
from symscrew.kinematics import Cut, Row, System


class ClosureGrids:
    """The rows of all cut joints over the joint rates, without units; `private` columns belong to one cut."""

    def __init__(self, system: System) -> None:
        self.system = system
        tape = system.tape
        self.by_length = tape.constant(1 / system.length)
        self.columns = [tape.constant(system.length) if c.kind == "length" else tape.one for c in system.tree.v]
        self.spins: set[int] = set()
        self.turned = system.closure
        self.cut_drives = system.cut_drives()
        self.rows = [self._entries(cut, cut.rows) for cut in system.cuts]
        known = [{k for row in rows for k in row} for rows in self.rows]
        uses = Counter(k for columns in known for k in columns)
        self.shared = sorted(k for k, n in uses.items() if n > 1)
        self.private = [sorted(k for k in columns if uses[k] == 1) for columns in known]
        self._use_own_axes()
        self._left: dict[tuple[int, ...], int] = {}

    def _use_own_axes(self) -> None:
        """Rates of private spherical joints in the axes of their link instead of those before the rotation.

        There a leg that spins about itself has a constant direction, so that the same two of its rates are always
        independent.
        """
        tree, private = self.system.tree, {k for columns in self.private for k in columns}
        turning = []
        for link in tree.links[1:]:
            below = {k for i in tree.path(link.parent) for k in range(tree.links[i].v.start, tree.links[i].v.stop)}
            own = set(range(link.v.start, link.v.stop))
            if link.motion.spherical and own <= private and not below & private:
                turning.append(link)
        if not turning:
            return
        placed = list(self.system.placed)
        for link in turning:
            placed[link.index] = replace(placed[link.index], turn=IDENTITY)
            self.spins |= set(range(link.v.start, link.v.stop))
        linkage = replace(self.system.linkage, placed=tuple(placed))
        self.turned = replace(self.turned, linkage=linkage)
        self.rows = [self._entries(cut, cut.rows) for cut in self.system.cuts]

    def _entries(self, cut: Cut, rows: Sequence[Row]) -> list[dict[int, Node]]:
        """Rows of a cut joint without units."""
        given = replace(cut, rows=tuple(rows))
        entries = self.system.closure.cut_rows(given)
        if self.spins:
            others = self.turned.cut_rows(given)
            entries = [{k: e for k, e in row.items() if k not in self.spins}
                       | {k: e for k, e in other.items() if k in self.spins}
                       for row, other in zip(entries, others, strict=True)]  # fmt: skip
        return [self._unitless(row, e) for row, e in zip(rows, entries, strict=True)]

    def _unitless(self, row: Row, entries: dict[int, Node]) -> dict[int, Node]:
        tape = self.system.tape
        factor = self.by_length if row.unit == "N" else tape.one
        scaled = {k: factor * self.columns[k] * e for k, e in entries.items()}
        return {k: e for k, e in scaled.items() if not vanishes(tape, e)}

    def _locked(self, locked: Sequence[int]) -> tuple[set[int], list[list[dict[int, Node]]]]:
        """(columns of locked drives of the tree, rows of all cuts with those of locked drives of cut joints)."""
        columns = {v for v, u in self.system.drive_rows().items() if u in locked}
        rows = []
        for c, (cut, own) in enumerate(zip(self.system.cuts, self.rows, strict=True)):
            held = [row for u, row in self.cut_drives.get(c, ()) if u in locked]
            rows.append([*own, *(self._entries(cut, held) if held else [])])
        return columns, rows

    def grid(self, locked: Sequence[int], held: Iterable[int] = ()) -> Grid:
        """The closure with the given drives locked and rates `held` at 0.

        Rates private to a cut joint are eliminated, if there are shared ones.
        """
        tape = self.system.tape
        gone, rows = self._locked(locked)
        gone |= set(held)
        result = []
        for own, private in zip(rows, self.private, strict=True):
            columns = [k for k in private if k not in gone] if self.shared else []
            block = [[row.get(k, tape.zero) for k in columns] for row in own]
            for factors in reciprocal_factors(tape, block):
                combined: dict[int, Node] = {}
                for i, factor in factors.items():
                    for k, entry in own[i].items():
                        if k not in columns:
                            combined[k] = combined.get(k, tape.zero) + factor * entry
                result.append(combined)
        left = self.shared if self.shared else sorted({k for row in result for k in row})
        return [[row.get(k, tape.zero) for k in left if k not in gone] for row in result]

    def left(self, locked: Sequence[int]) -> int:
        """Freedoms that are left with the given drives locked, in general position."""
        key = tuple(locked)
        if key not in self._left:
            gone, rows = self._locked(locked)
            free = [k for k in range(len(self.system.tree.v)) if k not in gone]
            zero = self.system.tape.zero
            every = [[row.get(k, zero) for k in free] for own in rows for row in own]
            self._left[key] = len(free) - (rank_of(self.system.tape, every) if every and free else 0)
        return self._left[key]

    @property
    def freedoms(self) -> int:
        """Freedoms with no drive locked, in general position."""
        return self.left(())

    def holds_as_much(self, locked: Sequence[int], all_drives: Sequence[int]) -> bool:
        """Whether these drives, locked, leave no more freedoms than all drives do."""
        return self.left(locked) == self.left(all_drives)

    def volume(self, locked: Sequence[int], held: Iterable[int] = ()) -> Volume | None:
        """The volume of `grid` at its rank in general position; None for no constraints at all.

        Raises:
            TooLargeError: it would need too many minors.
        """
        return closure_volume(self.system, self.grid(locked, held))


def closure_volume(system: System, grid: Grid) -> Volume | None:
    """Volume at the rank in general position; None for no constraints at all.

    A wide grid is taken in axes in which it is square, if a link has such.
    """
    tape = system.tape
    lean = trimmed(tape, grid)
    if not lean:
        return None
    rank = rank_of(tape, lean)
    if len(lean) == rank and len(lean[0]) > rank:
        lean = _turned(system, grid) or lean
    return volume(tape, lean, rank)


def _turned(system: System, grid: Grid) -> Grid | None:
    """The grid of a spherical joint's three columns in the axes of a link that leaves a square one, if any.

    A constraint that passes through an axis of its limb acts on the joint only across that axis.
    """
    tape, tree = system.tape, system.tree
    hubs = [link for link in tree.links[1:] if link.motion.spherical]
    if len(grid[0]) != 3 or len(hubs) != 1:
        return None
    for link in tree.links[1:]:
        axes = [system.linkage.carry(link.index, hubs[0].index, axis, before=True) for axis in IDENTITY]
        turned = trimmed(tape, [[tape.node(dot((row[0], row[1], row[2]), axis)) for axis in axes] for row in grid])
        if len(turned) == len(turned[0]) == len(grid):
            return turned
    return None

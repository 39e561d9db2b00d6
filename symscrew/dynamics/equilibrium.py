"""Equilibrium of all links at once: drives and joint reactions from the rates of the momentum screws.

From the tips of the limbs to the ground, every link carries one wrench per column: column 1 (inertia,
weight, loads), one per multiplier of a cut joint, one per drive. The row of a passive freedom, S . W = 0,
solves for one multiplier at once, so that only the columns that are still unknown travel down the limb;
the row of a driven freedom trades a multiplier for the drive. What remains at the hub are as many
equations in the drives as the mechanism has freedoms.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field
from functools import partial

from symscrew.algebra import (
    IDENTITY,
    NEGLIGIBLE,
    SAFE,
    Affine,
    Column,
    Guard,
    Node,
    Pivot,
    Vector,
    add,
    choose_pivot,
    count_operations,
    cross,
    dot,
    insert_solution,
    magnitude,
    named,
    scale,
    solve_block,
    solve_for,
    transform,
)
from symscrew.dynamics.carried_loops import carried_wrenches
from symscrew.dynamics.setting import ONE, Seated, Setting, Wrench, Wrenches, accumulate
from symscrew.kinematics import GROUND, Link

Projection = Callable[[Wrench], Node]


@dataclass
class Balance:
    """Result of the elimination: multipliers as affine functions of drives and free multipliers."""

    multipliers: dict[Column, Affine]
    finals: list[Affine]
    guards: list[Guard]
    free: list[Column]
    unbalanced: list[int] = field(default_factory=list)


def balance(
    setting: Setting,
    wrench: Callable[[Link], tuple[Vector, Vector]],
    loads: Mapping[int, tuple[Vector, Vector]],
) -> Balance:
    """Eliminate all multipliers, limb by limb.

    `wrench(link)` is the inertial wrench of a link less what acts on it (link axes, at its origin);
    `loads` are further wrenches that act on a link, in the axes before its motion.
    """
    one_by_one, _ = _swept(setting, wrench, loads, drives_last=False, carried=carried_wrenches(setting, wrench, loads))
    return one_by_one.finished(blocks=False)


def balances(
    setting: Setting,
    wrench: Callable[[Link], tuple[Vector, Vector]],
    loads: Mapping[int, tuple[Vector, Vector]],
    *,
    drives_last: bool,
    carried: Mapping[int, Wrenches],
) -> tuple[Balance, Balance]:
    """The same with multipliers that wait at the hub one by one, and in blocks.

    With `drives_last` the rows of driven freedoms are used for no multiplier that other rows give: the drives follow
    from the multipliers then, and their levers, which vanish where a limb is stretched, are no pivots. In blocks two or
    three multipliers whose pivots would wait for each other are solved at once. `carried` are `carried_wrenches` of
    links that carry whole loops, or none.
    """
    one_by_one, in_blocks = _swept(setting, wrench, loads, drives_last=drives_last, carried=carried)
    return one_by_one.finished(blocks=False), in_blocks.finished(blocks=True)


def _swept(
    setting: Setting,
    wrench: Callable[[Link], tuple[Vector, Vector]],
    loads: Mapping[int, tuple[Vector, Vector]],
    *,
    drives_last: bool,
    carried: Mapping[int, Wrenches],
) -> tuple[_Elimination, _Elimination]:
    """The elimination from the tips of the limbs to the ground, and once more, to go on in another way."""
    found = _Elimination(setting, wrench, loads, drives_last=drives_last, carried=carried)
    found.sweep()
    return found, found.copied()


class _Elimination:
    """State of `balance`: wrenches that wait at links, multipliers solved so far."""

    def __init__(
        self,
        setting: Setting,
        wrench: Callable[[Link], tuple[Vector, Vector]],
        loads: Mapping[int, tuple[Vector, Vector]],
        *,
        drives_last: bool,
        carried: Mapping[int, Wrenches],
    ) -> None:
        self.setting, self.wrench, self.loads = setting, wrench, loads
        self.drives_last, self.carried = drives_last, carried
        tape = setting.tape
        self.scales = setting.multipliers()
        self.solved: dict[Column, Affine] = {c: {c: tape.one} for c in self.scales}
        self.waiting: dict[int, Wrenches] = {link.index: {} for link in setting.tree.links}
        for c, cut in enumerate(setting.cuts):
            if cut.tip != GROUND and c not in setting.bars:
                here = self.waiting[cut.tip]
                for column, (f, m) in self._cut_wrench(c).items():
                    accumulate(here, column, scale(-1, f), scale(-1, add(cross(cut.tip_point, f), m)))
        self.result = Balance(self.solved, [], [], [])
        self.deferred: list[tuple[int | None, Affine]] = []
        self.last: dict[Column, Affine] | None = None  # what is solved at the end, in this order
        self.driven: dict[int, Affine] = {}  # index into v of a drive whose row waits -> the row as it was then

    def copied(self) -> _Elimination:
        """The same elimination; what is done with one leaves the other as it is."""
        other = copy(self)
        other.solved, other.waiting, other.deferred = dict(self.solved), dict(self.waiting), list(self.deferred)
        other.driven = dict(self.driven)
        known = self.result
        other.result = Balance(other.solved, list(known.finals), list(known.guards), [], list(known.unbalanced))
        return other

    def sweep(self) -> None:
        """From the tips of the limbs to the ground."""
        tree = self.setting.tree
        pending = {link.index for link in tree.links[1:]} - self.setting.left_out
        outwards = Counter(tree.links[j].parent for j in pending)
        ready = {i for i in pending if not outwards[i]}
        while ready:
            index = min(ready, key=lambda i: (self._open_tips(i, pending), self._unknowns(i), i))
            pending.discard(index)
            ready.discard(index)
            parent = tree.links[index].parent
            outwards[parent] -= 1
            if parent in pending and not outwards[parent]:
                ready.add(parent)
            self._process(tree.links[index])

    def finished(self, *, blocks: bool) -> Balance:
        """The result, rows that waited included."""
        self._finish(blocks=blocks)
        used = {c for affine in self.solved.values() for c in affine}
        self.result.free = [c for c in self.scales if c in used]
        return self.result

    def _open_tips(self, index: int, pending: set[int]) -> int:
        """How many limbs that end at this hub have not been eliminated down to where the hub's path begins."""
        inside = set(self.setting.tree.path(index))
        limbs = (set(self.setting.tree.path(cut.tip)) - inside for cut in self.setting.cuts if cut.hub == index)
        return sum(1 for limb in limbs if limb & pending)

    def _unknowns(self, index: int) -> int:
        columns = {c for c in self.waiting[index] if c in self.scales}
        for c, cut in enumerate(self.setting.cuts):
            if index in (cut.hub, *(self.setting.bars[c].ends if c in self.setting.bars else ())):
                for r in range(1 if c in self.setting.bars else len(cut.rows)):
                    columns |= {k for k in self.solved["multiplier", c, r] if k in self.scales}
        return len(columns)

    def _process(self, link: Link) -> None:
        setting = self.setting
        here = self.waiting.pop(link.index)
        if link.index in self.carried:
            before = dict(self.carried[link.index])
        else:
            accumulate(here, ONE, *self.wrench(link))
            before = setting.before_motion(link, here, self.loads, self._cut_wrench)
            setting.add_bars(link, before, self.solved)
        if setting.seated and link.index == setting.seated.hub:
            self._use_rows(*self._seated_rows(link, setting.seated), before)
            return
        screws = [lambda w, k=k: self._component(link, k, *w) for k in range(link.v.stop - link.v.start)]
        before = self._use_rows(list(range(link.v.start, link.v.stop)), screws, before)
        if link.joint == setting.tree.virtual and link.parent == GROUND:
            before = self._use_rows(*self._virtual_rows(), before)
        self.waiting[link.index] = {}
        if link.parent == GROUND:
            return
        placed = self.setting.placed[link.index]
        for column, (f, m) in before.items():
            f, m = transform(placed.rotation, f), transform(placed.rotation, m)
            accumulate(self.waiting[link.parent], column, f, add(m, cross(placed.offset, f)))

    def _virtual_rows(self) -> tuple[list[int | None], list[Projection]]:
        """A virtual joint transmits nothing: rows also for the wrenches that are reciprocal to it."""
        forces, couples = self.setting.virtual_directions
        rows: list[Projection] = [*(partial(_along, 0, d) for d in forces), *(partial(_along, 1, d) for d in couples)]
        return [None] * len(rows), rows

    def _seated_rows(self, link: Link, seated: Seated) -> tuple[list[int | None], list[Projection]]:
        """All rows of a hub on a free joint, which are called by its coordinates."""
        inner = [k for index in seated.inner[::-1] for k in self._freedoms(self.setting.tree.links[index])]
        rows = [partial(_along, part, direction) for part in (0, 1) for direction in IDENTITY]
        return [*inner, *self._freedoms(link)], [*rows]

    def _freedoms(self, link: Link) -> range:
        return range(link.v.start, link.v.stop)

    def _component(self, link: Link, k: int, f: Vector, m: Vector) -> Node:
        """S . W for the k-th screw of the link's motion; axes before the motion."""
        return self.setting.tape.node(link.pair.powers(self.setting.frames[link.index], f, m)[k])

    def _cut_wrench(self, c: int) -> Wrenches:
        """The cut joint's wrench on its tip at its point, tip axes, per column that is still unknown."""
        one = self.setting.tape.one
        return self.setting.cut_wrench(c, self.solved, lambda u: {("drive", u): one})

    def _use_rows(self, v_indices: Sequence[int | None], screws: Sequence[Projection], before: Wrenches) -> Wrenches:
        """Solve a multiplier from every row S . W = 0, best pivot first; returns the updated wrenches.

        A row whose pivots are all small at some sample state waits until all links are done.
        """
        waiting = dict(enumerate(zip(v_indices, screws, strict=True)))
        if self.drives_last:
            later = [k for k, (v, _) in waiting.items() if v in self.setting.drives or self._of_platform(v)]
            self._defer([(v, self._row(v, screw, before)) for v, screw in (waiting.pop(k) for k in later)])
        while waiting:
            rows = {k: self._row(v, screw, before) for k, (v, screw) in waiting.items()}
            found = {k: self._pivot(rows[k], v) for k, (v, _) in waiting.items()}
            sizes = {k: pivot.size if pivot else -1.0 for k, pivot in found.items()}
            best = max(waiting, key=sizes.__getitem__)
            pivot = found[best]
            if pivot is None or pivot.size < SAFE:
                self._defer([(v, rows[k]) for k, (v, _) in waiting.items()])
                return before
            before = _substitute_wrench(before, pivot.column, self._solve(rows[best], pivot.column))
            del waiting[best]
        return before

    def _defer(self, rows: Sequence[tuple[int | None, Affine]]) -> None:
        self.deferred += rows
        self.driven |= {v: row for v, row in rows if v is not None and v in self.setting.drives}

    def _of_platform(self, v_index: int | None) -> bool:
        """Whether a row is one of a hub on a virtual joint, all of whose rows are compared at once."""
        return v_index is None or self.setting.tree.v[v_index].joint == self.setting.tree.virtual

    def _row(self, v_index: int | None, screw: Projection, before: Wrenches) -> Affine:
        """S . W per column, less the drive of a driven freedom."""
        row: Affine = {}
        for column, wrench in before.items():
            entry = self.setting.tape.node(screw(wrench))
            if entry is not self.setting.tape.zero:
                row[column] = entry
        self.setting.name_row(row, v_index)
        if v_index is None:
            return row
        known = self.setting.joint_forces.get(v_index)
        if known is not None:
            row[ONE] = row.get(ONE, self.setting.tape.zero) - known
        for c, entry in self.setting.ties.get(v_index, ()):
            for column, factor in self.solved["multiplier", c, 0].items():
                row[column] = row.get(column, self.setting.tape.zero) - entry * factor
        drive = self.setting.drives.get(v_index)
        if drive is not None:
            row["drive", drive] = row.get(("drive", drive), self.setting.tape.zero) - self.setting.tape.one
        return row

    def _pivot(self, row: Affine, v_index: int | None) -> Pivot | None:
        factor = self.setting.row_scale(v_index)
        allowed = {c: factor * s for c, s in self.scales.items()}
        return choose_pivot(self.setting.tape, row, allowed, self._cost())

    def _solve(self, row: Affine, pivot: Column) -> Affine:
        """Solve the pivot's multiplier from sum(row) = 0 and put it in everywhere."""
        if row[pivot].value is None:
            _, largest = magnitude(self.setting.tape, row[pivot], 1.0)
            self.result.guards.append(Guard(row[pivot], 1.0 / largest if largest > 0 else 1.0))
        solution = solve_for(row, pivot)
        self._put_in(pivot, solution)
        return solution

    def _put_in(self, pivot: Column, solution: Affine) -> None:
        """Replace a multiplier by its solution everywhere; at the end, in the rows that wait alone."""
        if self.last is not None:
            self.last[pivot] = solution
            self.deferred = [(v, insert_solution(r, pivot, solution)) for v, r in self.deferred]
            return
        for key, affine in self.solved.items():
            if pivot in affine:
                self.solved[key] = insert_solution(affine, pivot, solution)
                self.setting.name_multiplier(key, self.solved[key])
        for index, here in self.waiting.items():
            self.waiting[index] = _substitute_wrench(here, pivot, solution)
        self.deferred = [(v, insert_solution(r, pivot, solution)) for v, r in self.deferred]

    def _finish(self, *, blocks: bool) -> None:
        """Rows that waited: best pivots first, what has none is an equation for the drives.

        What is solved here is put into the multipliers that were solved before it at the end, the last one first: each
        by what it depends on in the end, not by what this depends on in turn.
        """
        self.last = {}
        kept = []
        while self.deferred:
            best, pivot = self._best(self.deferred)
            if pivot is None:
                kept.append(self.deferred.pop(best))
                continue
            block = self._block(best, pivot.column) if blocks else [(best, pivot.column)]
            rows = [self.deferred[k][1] for k, _ in block]
            self.deferred = [entry for k, entry in enumerate(self.deferred) if k not in dict(block)]
            if len(block) == 1:
                self._solve(rows[0], pivot.column)
            else:
                self._solve_block(rows, [column for _, column in block])
        self._put_back(self.last)
        for v_index, row in kept:
            self._keep(v_index, row)

    def _put_back(self, last: dict[Column, Affine]) -> None:
        """Put what was solved last, in this order, into all multipliers."""
        for pivot in reversed(last):
            last[pivot] = _with_solutions(last[pivot], last)
        for key, affine in self.solved.items():
            if any(pivot in affine for pivot in last):
                self.solved[key] = _with_solutions(affine, last)
                self.setting.name_multiplier(key, self.solved[key])

    def _best(self, waiting: Sequence[tuple[int | None, Affine]]) -> tuple[int, Pivot | None]:
        """The row with the best pivot: those of the drives last, then those without one."""
        found = [self._pivot(row, v) for v, row in waiting]
        passive = [v not in self.setting.drives for v, _ in waiting]
        sizes = [(passive[k], pivot.size if pivot else -1.0) for k, pivot in enumerate(found)]
        best = sizes.index(max(sizes))
        return best, found[best]

    def _block(self, first: int, column: Column) -> list[tuple[int, Column]]:
        """Rows that wait and their unknowns, to be solved at once: three or two whose pivots would all wait for each
        other, else the first alone."""
        found = [(first, column)]
        left = dict(enumerate(self.deferred))
        v_index, row = left.pop(first)
        while len(found) < 3 and left and v_index not in self.setting.drives:
            if row[column].value is not None:
                break
            solution = solve_for(row, column)
            left = {k: (v, insert_solution(r, column, solution)) for k, (v, r) in left.items()}
            places = list(left)
            best, pivot = self._best(list(left.values()))
            v_index, row = left.pop(places[best])
            if pivot is None or v_index in self.setting.drives or row[pivot.column].value is not None:
                break
            column = pivot.column
            found.append((places[best], column))
        for count in (3, 2):
            some = found[:count]
            full = all(column in self.deferred[k][1] for k, _ in some for _, column in some)
            if len(some) == count and full:
                return some
        return found[:1]

    def _solve_block(self, rows: Sequence[Affine], columns: Sequence[Column]) -> None:
        """Solve several multipliers at once and put them in everywhere."""
        solutions, determinant = solve_block(rows, columns)
        place, _, component = self.setting.label(columns[0]).partition(".")
        named(determinant, "determinant", place, component)
        if determinant.value is None:
            _, largest = magnitude(self.setting.tape, determinant, 1.0)
            self.result.guards.append(Guard(determinant, 1.0 / largest if largest > 0 else 1.0))
        for pivot, solution in zip(columns, solutions, strict=True):
            self._put_in(pivot, solution)

    def _cost(self) -> dict[Column, int]:
        """In how many places a multiplier still stands: at the end, in how many rows."""
        cost: dict[Column, int] = {}
        for affine in self.solved.values() if self.last is None else (row for _, row in self.deferred):
            for column in affine:
                cost[column] = cost.get(column, 0) + 1
        return cost

    def _keep(self, v_index: int | None, row: Affine) -> None:
        """A row without multipliers: an equation for the drives, or nothing on the manifold.

        That of a drive takes its multipliers as they are known now, each once, not those again of which they consist:
        but for constants, which fold.
        """
        if v_index in self.driven:
            other = _with_solutions(self.driven[v_index], self.solved)
            if other != row:  # in an open chain it is the same, joint by joint: counting all behind it grows squarely
                row = min(row, other, key=lambda way: count_operations([*way.values()]))
        known = {c: e for c, e in row.items() if c not in self.scales}
        self.setting.name_row(known, v_index)
        if any(self._pushes(c, entry, v_index) for c, entry in known.items()):
            self.result.finals.append(known)
        elif known and v_index is not None:
            self.result.unbalanced.append(v_index)

    def _pushes(self, column: Column, entry: Node, v_index: int | None) -> bool:
        """Whether a column is a drive that does work on a freedom; a rod's spin has rounding where its ends would."""
        if column == ONE:
            return False
        unit = self.setting.row_scale(v_index) * self.setting.drive_scales[column[1]]
        return magnitude(self.setting.tape, entry, unit)[1] > NEGLIGIBLE


def _with_solutions(affine: Affine, solutions: Mapping[Column, Affine]) -> Affine:
    """`affine` with unknowns replaced by their solutions, which have none of these."""
    for pivot, solution in solutions.items():
        if pivot in affine:
            affine = insert_solution(affine, pivot, solution)
    return affine


def _along(part: int, direction: Vector, wrench: Wrench) -> Node:
    """A wrench's force (part 0) or moment (part 1) along a direction."""
    component: Node = dot(direction, wrench[part])
    return component


def _substitute_wrench(here: Wrenches, pivot: Column, solution: Affine) -> Wrenches:
    if pivot not in here:
        return here
    force, moment = here[pivot]
    result = {c: w for c, w in here.items() if c != pivot}
    for column, factor in solution.items():
        accumulate(result, column, scale(factor, force), scale(factor, moment))
    return result

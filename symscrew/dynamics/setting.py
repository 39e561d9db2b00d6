"""What equilibrium is written for: the tree at given placements, its cuts, drives and scales; wrenches by column.

column 1: inertia, weight, loads | one per multiplier of a cut joint | one per drive
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from symscrew.algebra import (
    ZERO,
    Affine,
    Column,
    Matrix,
    Node,
    Tape,
    Vector,
    add,
    cross,
    named_entries,
    named_wrench,
    scale,
    subtract,
    transform,
)
from symscrew.kinematics import Cut, Frame, Link, Linkage, Placement, Row, Tree, on_hub

ONE: Column = "1"
Wrench = tuple[Vector, Vector]
Wrenches = dict[Column, Wrench]


@dataclass(frozen=True)
class Bar:
    """A limb's last body, at a cut joint, as a bar that bears tension: see `symscrew.dynamics.rods`.

    `ends`: link -> what it must supply for the bar per unit of tension, and for the bar's inertia; in the axes before
    its motion, at its origin. `links` are the bar's own links, which are left out then. `inside`: one of the ends'
    links, the link that carries it, and what the former must supply for the bar's inertia in the latter's coordinates.
    """

    links: frozenset[int]
    ends: Mapping[int, tuple[Wrench, Wrench]]
    inside: tuple[int, int, Wrench] | None = None


@dataclass(frozen=True)
class Seated:
    """A hub that sits on another link than its virtual joint puts it: see `symscrew.dynamics.hub_seats`.

    `inner`: the joint's other links, which are left out. `turns`: one after another from the hub's axes to those of the
    link that it sits on; `rotation`: to these from those before the joint's motion, where `arm` stands, from the hub's
    own origin to its new one. `wrench`: what its inertia needs about there, in its own axes; or about its own origin
    but for the `moved` force of its mass, from where all is moved then, with the arm: both in axes of that link.
    """

    hub: int
    inner: tuple[int, ...]
    turns: tuple[Matrix, ...]
    rotation: Matrix
    arm: Vector
    wrench: Wrench
    moved: tuple[Vector, Vector] | None = None

    def turned(self, vector: Vector) -> Vector:
        """From the hub's axes to those of the link that it sits on."""
        for turn in self.turns:
            vector = transform(turn, vector)
        return vector


@dataclass(frozen=True)
class Setting:
    """What equilibrium is written for: the tree at given placements, its cuts, drives and unit scales."""

    tape: Tape
    tree: Tree
    frames: Sequence[Frame]
    placed: Sequence[Placement]
    cuts: Sequence[Cut]
    drives: Mapping[int, int]  # index into v -> index into u
    cut_drives: Mapping[int, Sequence[tuple[int, Row]]]  # cut -> (index into u, unit drive wrench on its child)
    length: float  # characteristic length [m]
    virtual_directions: tuple[tuple[Vector, ...], tuple[Vector, ...]] = (
        (),
        (),
    )  # forces, couples it cannot bear
    joint_forces: Mapping[int, Node] = field(default_factory=dict)  # index into v -> known generalised force
    bars: Mapping[int, Bar] = field(default_factory=dict)  # cut -> the bar that ends there
    seated: Seated | None = None
    called: str = "force"  # the wrench of a link and all that hangs on it

    @property
    def linkage(self) -> Linkage:
        """The tree at these placements."""
        return Linkage(self.tree, tuple(self.frames), tuple(self.placed))

    def row_scale(self, v_index: int | None) -> float:
        """1/length for the row of a rotation (its entries for forces are lever arms), 1 for a translation."""
        return 1.0 if v_index is None or self.tree.v[v_index].kind == "length" else 1.0 / self.length

    @cached_property
    def drive_scales(self) -> dict[int, float]:
        """Index into u -> unit scale of the drive's column."""
        forces = {u: self.tree.v[k].kind == "length" for k, u in self.drives.items()}
        forces |= {u: row.unit == "N" for some in self.cut_drives.values() for u, row in some}
        return {u: 1.0 if forces[u] else self.length for u in sorted(forces)}

    def multipliers(self) -> dict[Column, float]:
        """All multiplier columns with their unit scale; a bar has its tension per length."""
        return {
            ("multiplier", c, r): 1.0 / self.length if c in self.bars else 1.0 if row.unit == "N" else self.length
            for c, cut in enumerate(self.cuts)
            for r, row in enumerate(cut.rows[:1] if c in self.bars else cut.rows)
        }

    def cut_wrench(self, c: int, multipliers: Mapping[Column, Affine], drive: Callable[[int], Affine]) -> Wrenches:
        """What a cut joint exerts on its tip, at its point in tip axes, per column: multipliers and drives."""
        cut = self.cuts[c]
        total: Wrenches = {}
        for r, row in enumerate(cut.rows):
            for column, factor in multipliers["multiplier", c, r].items():
                accumulate(total, column, scale(factor, row.force), scale(factor, row.couple))
        sign = -1 if cut.tip_is_parent else 1
        for u, row in self.cut_drives.get(c, ()):
            for column, factor in drive(u).items():
                accumulate(total, column, scale(sign * factor, row.force), scale(sign * factor, row.couple))
        return total

    def before_motion(
        self, link: Link, here: Wrenches, loads: Mapping[int, tuple[Vector, Vector]], at_cut: Callable[[int], Wrenches]
    ) -> Wrenches:
        """All that the joint of a link must supply, in the axes before its motion, at its origin.

        `here` are the wrenches on the link in its own axes; the loads and the cuts where it is the hub
        (`at_cut(c)`: what cut c exerts on its tip, tip axes) come on top.
        """
        self._named(here, self.called, link.index)
        result = self.turned_back(link, here, loads)
        for c, cut in enumerate(self.cuts):
            if cut.hub != link.index or c in self.bars:
                continue
            for column, (f, m) in at_cut(c).items():
                accumulate(result, column, *on_hub(cut, self.linkage, f, m))
        self._named(result, f"joint_{self.called}", link.index)
        return result

    def turned_back(self, link: Link, here: Wrenches, loads: Mapping[int, Wrench]) -> Wrenches:
        """Wrenches on a link, in its own axes, in those before its motion, with its loads, which stand there."""
        placed, seated = self.placed[link.index], self.seated
        if seated is not None and seated.hub == link.index:
            result: Wrenches = {c: (seated.turned(f), seated.turned(m)) for c, (f, m) in here.items()}
            if link.index in loads:
                force, moment = loads[link.index]
                moment = moment if seated.moved else subtract(moment, cross(seated.arm, force))
                force, moment = (scale(-1, transform(seated.rotation, vector)) for vector in (force, moment))
                accumulate(result, ONE, force, moment)
            if seated.moved:
                force, arm = seated.moved
                accumulate(result, ONE, force, ZERO)
                result = {c: (f, subtract(m, cross(arm, f))) for c, (f, m) in result.items()}
            return result
        result = {c: (placed.before(f), placed.before(m)) for c, (f, m) in here.items()}
        if link.index in loads:
            force, moment = loads[link.index]
            accumulate(result, ONE, scale(-1, force), scale(-1, moment))
        return result

    def handed_on(self, index: int, force: Vector, moment: Vector) -> Wrench:
        """From the axes before a link's motion, at its origin, to its parent's, at the parent's."""
        placed = self.placed[index]
        force = placed.from_before(force)
        return force, add(placed.from_before(moment), cross(placed.offset, force))

    @property
    def left_out(self) -> set[int]:
        """Links that carry no wrench: those of bars, and those of a virtual joint whose hub is seen from elsewhere."""
        return {index for bar in self.bars.values() for index in bar.links} | {
            *(self.seated.inner if self.seated else ())
        }

    @cached_property
    def ties(self) -> dict[int, list[tuple[int, Node]]]:
        """Index into v -> (index of a coupling among the cuts, what its multiplier is on this freedom per unit)."""
        found: dict[int, list[tuple[int, Node]]] = {}
        for c, cut in enumerate(self.cuts):
            for k, entry in (cut.relation.row if cut.relation else {}).items():
                found.setdefault(k, []).append((c, entry))
        return found

    @cached_property
    def drive_labels(self) -> dict[int, str]:
        """What the drives are called, by index into u: the freedoms that they act on, or their cut joints."""
        labels = {u: self.tree.v[k].label for k, u in self.drives.items()}
        return labels | {u: self.cuts[c].joint.name for c, some in self.cut_drives.items() for u, _ in some}

    def label(self, column: Column) -> str:
        """What a coefficient of this column belongs to: a multiplier's row, a drive; of column 1 nothing."""
        if column == ONE:
            return ""
        if column[0] == "drive":
            return self.drive_labels[column[1]]
        label: str = self.cuts[column[1]].rows[column[2]].label
        return label

    def _named(self, wrenches: Wrenches, quantity: str, link: int) -> None:
        for column, wrench in wrenches.items():
            named_wrench(wrench, quantity, self.tree.part(link), by=self.label(column))

    def name_row(self, row: Affine, v_index: int | None) -> None:
        """Call the power along a freedom of what a joint must supply so, column by column."""
        freedom = "hub" if v_index is None else self.tree.v[v_index].label
        named_entries(row.values(), "balance", [f"{freedom}|{self.label(column)}" for column in row])

    def name_multiplier(self, column: Column, affine: Affine) -> None:
        """Call a multiplier so, or its parts: what it is without drives and others, and per each of these."""
        label, complete = self.label(column), set(affine) == {ONE}
        quantity = "multiplier" if complete else "multiplier_part"
        named_entries(affine.values(), quantity, [f"{label}|{self.label(by)}" for by in affine])

    def add_inertia_of_bars(self, link: Link, before: Wrenches, *, inside: bool = False) -> None:
        """Add to `before` what a link must supply for the masses of the bars that end on it.

        Not what is seen from further `inside`.
        """
        for bar in self.bars.values():
            if link.index in bar.ends and not (inside and bar.inside and bar.inside[0] == link.index):
                accumulate(before, ONE, *bar.ends[link.index][1])

    def add_bars(self, link: Link, before: Wrenches, multipliers: Mapping[Column, Affine]) -> None:
        """Add to `before` what a link must supply for the bars that end on it."""
        self.add_inertia_of_bars(link, before)
        for c, bar in self.bars.items():
            if link.index in bar.ends:
                (pull, couple), _ = bar.ends[link.index]
                for column, factor in multipliers["multiplier", c, 0].items():
                    accumulate(before, column, scale(factor, pull), scale(factor, couple))


def accumulate(here: Wrenches, column: Column, force: Vector, moment: Vector) -> None:
    """Add a wrench to a column of `here`, which the caller owns."""
    if column in here:
        f, m = here[column]
        force, moment = add(f, force), add(m, moment)
    here[column] = (force, moment)

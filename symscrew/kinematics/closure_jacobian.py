"""The closure Jacobian in joint rates: every reciprocal wrench of a cut joint, pushed inwards along both sides.

    wrench at the cut --push--> its power per joint rate of the limb, less that of the hub's side

Row k is {index into v: entry}, the power of wrench k on the tip less that on the hub; links that carry both sides of
the loop make no difference.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from symscrew.algebra import Node, Tape, Twist, add, cross, named_entries, named_wrench
from symscrew.kinematics.cut_joints import Cut, Row, on_hub
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import Rates, Wrench
from symscrew.kinematics.linkage import Linkage
from symscrew.kinematics.loop_closure import closure_bias, closure_residual


@dataclass(frozen=True, eq=False)
class ClosureJacobian:
    """The rows of all cut joints of a linkage, and parts of them for those who combine them otherwise."""

    geometry: Geometry
    linkage: Linkage
    cuts: tuple[Cut, ...]

    def __repr__(self) -> str:
        return f"ClosureJacobian({len(self.cuts)} cut joints, {len(self.linkage.tree.v)} rates)"

    @property
    def tape(self) -> Tape:
        """The tape of all nodes."""
        return self.geometry.tape

    @cached_property
    def rows(self) -> list[dict[int, Node]]:
        """Rows in joint rates w: {index into v: entry}, one per multiplier."""
        return [row for cut in self.cuts for row in self.cut_rows(cut)]

    def dense(self) -> list[Node]:
        """The rows as a full matrix (rows, freedoms of the tree), row-major."""
        n = len(self.linkage.tree.v)
        return [row.get(k, self.tape.zero) for row in self.rows for k in range(n)]

    @cached_property
    def residual(self) -> list[Node]:
        """How far the loops are open, one number per row [m, or rad for couples]."""
        return [value for cut in self.cuts for value in closure_residual(cut, self.linkage, self.geometry)]

    def bias(
        self, twist: Sequence[Twist], rate: Sequence[Rates], v: Sequence[Node], a: Sequence[Node] | None = None
    ) -> list[Node]:
        """(dJ/dt) v per row, from twists of the links and their rates at accelerations a (None: 0) of the tree."""
        return [value for cut in self.cuts for value in closure_bias(cut, self.linkage, twist, rate, v=v, a=a)]

    def cut_rows(self, cut: Cut) -> list[dict[int, Node]]:
        """Rows of one cut joint."""
        if cut.relation is not None:
            return [cut.relation.row]
        tree = self.linkage.tree
        common = tree.common(cut.tip, cut.hub)
        rows = []
        for row in cut.rows:
            entries, below = self.limb_wrenches(cut, row)
            if cut.hub != common:
                parent = tree.links[cut.hub].parent
                if cut.arm is not None and parent in below:
                    wrench = self.linkage.outwards(cut.hub, below[parent])
                else:
                    wrench = on_hub(cut, self.linkage, row.force, row.couple)
                entries |= {k: -1 * power for k, power in self.powers(cut.hub, wrench, common).items()}
            for k, entry in entries.items():
                named_entries([entry], "closure", [f"{row.label}|{tree.v[k].label}"])
            rows.append({k: e for k, e in entries.items() if e is not self.tape.zero})
        return rows

    def powers(self, index: int, wrench: Wrench, inside: int) -> dict[int, Node]:
        """Power per joint rate, down to link `inside`, of a wrench on a link (axes before its motion, its origin)."""
        return self._pushed(index, wrench, inside)[0]

    def limb_wrenches(self, cut: Cut, row: Row) -> tuple[dict[int, Node], dict[int, Wrench]]:
        """A reciprocal wrench along the limb: its power per joint rate of the limb, and the wrench itself.

        The latter at the origin of the tip and of every link between it and what the hub hangs on, that one too, in
        that link's axes.
        """
        common = self.linkage.tree.common(cut.tip, cut.hub)
        if cut.tip == common:
            return {}, {}
        placed = self.linkage.placed[cut.tip]
        force, moment = row.force, add(row.couple, cross(cut.tip_point, row.force))
        powers, below = self._pushed(cut.tip, (placed.before(force), placed.before(moment)), common)
        for index, wrench in below.items():
            named_wrench(wrench, "lever", self.linkage.tree.part(index), by=row.label)
        return powers, {cut.tip: (force, moment), **below}

    def _pushed(self, index: int, wrench: Wrench, inside: int) -> tuple[dict[int, Node], dict[int, Wrench]]:
        links = self.linkage.tree.links
        entries: dict[int, Node] = {}
        below: dict[int, Wrench] = {}
        for at, powers, beyond in self.linkage.push(index, wrench, inside):
            for k, power in enumerate(powers, start=links[at].v.start):
                entries[k] = self.tape.node(power)
            below[links[at].parent] = beyond
        return entries, below

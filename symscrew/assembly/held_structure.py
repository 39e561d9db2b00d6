"""Unknowns and equations of a mechanism with some freedoms held, as a structure with numbers in its slots.

    HeldGraph --bodies between two points--> distances --tree of runs--> groups of homogeneous coordinates
              --what is left--> loops: forms of `dual_forms` in the displacement of one cluster against another
    slots --slot_numbers--> numbers, for values of what is held

A body that hangs on distances alone has Study's parameters as coordinates. What couplings tie is in the tree.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.algebra import IDENTITY, cross, dot, scale, subtract
from symscrew.assembly.closure_structure import WIDTH, Form, Group, Loop, Rod, Slot, Spin, Structure
from symscrew.assembly.elementary_graph import Edge, HeldGraph, Point, Run
from symscrew.assembly.linked_columns import Link
from symscrew.mobility import NotAlgebraicError

Array = np.ndarray[Any, Any]

EQUATIONS = {"distance": 1, "ball": 3, "hook": 4, "turn": 5, "slide": 5}
"""Of a run that closes a spatial loop, independent ones."""
PLANAR_EQUATIONS = {"distance": 1, "turn": 2, "slide": 2}
SPHERICAL_EQUATIONS = {"turn": 2}
SPATIAL_FREEDOMS, PLANAR_FREEDOMS = 6, 3
"""Of all displacements."""
TELESCOPE = 3
"""Runs of a leg that turns about two points and slides between them."""
MANY_LEGS = 3
"""Of legs on two universal joints from which on their angles are no unknowns: of fewer a tree of them has few solutions
more, and C; of three no Groebner basis ended with eight angles as unknowns."""
SPANNED = 1e-9
"""Singular value of screws, in sizes of the mechanism, below which they are dependent: rounding leaves 1e-15."""
TOGETHER = 1e-12
"""Points of one body this close, in sizes of the mechanism, are one point."""
PARALLEL = 1e-40
"""Difference of axes of length one that have one direction: they are known to 60 digits."""


def held_structure(graph: HeldGraph, centre: Point, platform: str | None) -> Structure:
    """The structure of a mechanism with held freedoms.

    Raises:
        NotAlgebraicError: closures that no form stands for.
    """
    try:
        return _Planner(graph, centre, platform).structure()
    except _SlideLeftError:
        return _Planner(graph, centre, platform, slides_first=True).structure()


class _SlideLeftError(NotAlgebraicError):
    """The tree left a slide to close a loop, of which there are no forms."""


class _Planner:
    def __init__(self, graph: HeldGraph, centre: Point, platform: str | None, *, slides_first: bool = False) -> None:
        """`slides_first`: into the tree, so that hinges close loops; other trees have been stored."""
        self.graph, self.centre, self.slides_first = graph, centre, slides_first
        self.platform = graph.cluster.get(platform or "", "")
        self.slots: list[Slot] = []
        self.points: list[tuple[str, Point, int]] = []
        self.axes: list[tuple[str, Point, int]] = []
        self.behind: dict[str, str] = {}
        self.groups: list[Group] = []
        self.chains: dict[str, tuple[int, ...]] = {graph.ground: ()}
        self.forms: dict[tuple[str, str], list[Form]] = {}
        self.counts = {"equations": 0}
        self.spins: list[Spin] = []
        self.couplings: list[Loop] = []

    def structure(self) -> Structure:
        self.runs, open_limbs = self._open_limbs(list(self.graph.runs))
        runs, rods = self._rods()
        clusters = dict.fromkeys(e for r in runs for e in (r.near, r.far))
        clusters |= dict.fromkeys(e for rod in rods for e in (rod.runs[0].near, rod.runs[1].far))
        left = [c for c in clusters if c not in self.chains]
        cuts = list(runs)
        while left:
            found = self._nearest(cuts)
            if found is None:
                hub = max(left, key=lambda c: (c == self.platform, self._held_by(c, cuts, rods)))
                self._add_group(Group("planar" if self.graph.axis else "free", hub, self.graph.ground, ()))
            else:
                cuts.remove(found[0])
                self._hang(found[1])
            left = [c for c in left if c not in self.chains]
        for run in cuts:
            self._close(run)
        for rod in rods:
            self._distance(rod)
        for link in self.graph.links:
            self._couple(link)
        widths = [WIDTH[g.kind] - 1 - (g.kind == "free") for g in self.groups]
        loops = (*(Loop(*ends, tuple(found)) for ends, found in self.forms.items()), *self.couplings)
        return Structure(
            self.graph, tuple(self.groups), loops, tuple(self.slots), dict(self.chains), tuple(rods), sum(widths),
            self.counts["equations"], self._frame(), self.centre, tuple(open_limbs), tuple(self.spins),
        )  # fmt: skip

    def _open_limbs(self, runs: list[Run]) -> tuple[list[Run], list[tuple[Run, ...]]]:
        """(other runs, chains between two clusters with so many freedoms that they hold nothing).

        Only of a mechanism with a platform: without one, the two ways of a chain to reach are modes of their own.
        """
        found = list[tuple[Run, ...]]()
        if not self.platform:
            return runs, found
        hubs = {self.graph.ground, self.platform}
        hubs |= {b for b in self._ends(runs) if sum(b in (r.near, r.far) for r in runs) != 2}
        for hub in hubs:
            for first in [run for run in runs if hub in (run.near, run.far)]:
                chain = [first if first.near == hub else first.reversed()]
                while chain[-1].far not in hubs:
                    body = chain[-1].far
                    more = next(r for r in runs if body in (r.near, r.far) and r.edges not in
                                (chain[-1].edges, chain[-1].edges[::-1]))  # fmt: skip
                    chain.append(more if more.near == body else more.reversed())
                if chain[-1].far != hub and self._reaches_all(chain) and not any(map(self.graph.tied, chain)):
                    used = [set(run.edges) for run in chain]
                    runs = [run for run in runs if set(run.edges) not in used]
                    found.append(tuple(chain))
        return runs, found

    @staticmethod
    def _ends(runs: Sequence[Run]) -> list[str]:
        return list(dict.fromkeys(end for run in runs for end in (run.near, run.far)))

    def _reaches_all(self, chain: Sequence[Run]) -> bool:
        """Whether a leg that slides has all displacements of its ends, in the reference."""
        rows = list[list[float]]()
        for edge in (e for run in chain for e in run.edges):
            point = [float(c) for c in edge.point]
            axes = np.eye(3) if edge.axis is None else np.array([[float(c) for c in edge.axis]])
            for axis in axes:
                slides = edge.kind == "slide"
                rows.append([*([0.0] * 3 if slides else axis), *(axis if slides else np.cross(point, axis))])
        if len(chain) != TELESCOPE or chain[1].kind != "slide":  # of others the ways to hold the same ends differ
            return False
        wanted = PLANAR_FREEDOMS if self.graph.axis else SPATIAL_FREEDOMS
        return len(rows) >= wanted and int(np.linalg.matrix_rank(np.array(rows), tol=SPANNED)) == wanted

    def _frame(self) -> tuple[Point, Point, Point]:
        if self.graph.axis is None:
            return IDENTITY
        normal = self.graph.axis
        sizes = [abs(float(c)) for c in normal]
        near = IDENTITY[sizes.index(min(sizes))]
        rest = subtract(near, scale(dot(near, normal), normal))
        first = scale(1 / dot(rest, rest) ** 0.5, rest)
        return first, cross(normal, first), normal

    @staticmethod
    def _held_by(cluster: str, runs: Sequence[Run], rods: Sequence[Rod]) -> int:
        return sum(cluster in (r.near, r.far) for r in runs) + sum(
            cluster in (rod.runs[0].near, rod.runs[1].far) for rod in rods
        )

    def _rods(self) -> tuple[list[Run], list[Rod]]:
        """Bodies between two others, with a point held on each, become distances.

        A universal joint holds the same rod in two ways, which are modes of their own where there is no platform.
        """
        runs, rods, crossing = list(self.runs), list[Rod](), self._crossing_legs()
        for body in dict.fromkeys(end for run in runs for end in (run.near, run.far)):
            at = [run for run in runs if body in (run.near, run.far)]
            ends = [end for rod in rods for end in (rod.runs[0].near, rod.runs[1].far)]
            if len(at) != 2 or body in (self.graph.ground, self.platform, *ends) or any(map(self.graph.tied, at)):
                continue
            kinds = sorted(run.kind for run in at)
            spatial = [["ball", "ball"], *([["ball", "hook"]] if self.platform else [])]
            holds = kinds == ["turn", "turn"] if self.graph.axis else kinds in spatial
            one = at[0] if at[0].far == body else at[0].reversed()
            two = at[1] if at[1].near == body else at[1].reversed()
            if (holds or body in crossing) and one.near != two.far:
                rods.append(Rod(body, (one, two), body in crossing))
                runs = [run for run in runs if run not in at]
        return runs, rods

    def _crossing_legs(self) -> set[str]:
        """Clusters between two universal joints with parallel inner axes across the leg, if there are several of them.

        Where the outer axes and the leg lie in one plane the inner axes are normal to it, so that this is all that the
        leg holds beside its length. A leg turns over in two ways, which are modes of their own without a platform.
        """
        found = set[str]()
        if not self.platform or self.graph.spherical:
            return found
        for body in dict.fromkeys(self._ends(self.runs)):
            at = [run for run in self.runs if body in (run.near, run.far)]
            if [run.kind for run in at] != ["hook", "hook"] or body in (self.graph.ground, self.platform):
                continue
            one = at[0] if at[0].far == body else at[0].reversed()
            two = at[1] if at[1].near == body else at[1].reversed()
            if self._across(body, one.edges[-1], two.edges[0]):
                found.add(body)
        return found if len(found) >= MANY_LEGS else set()

    def _across(self, body: str, one: Edge, two: Edge) -> bool:
        """Whether two axes on a body are parallel and normal to the way between them, at all values of what is held."""
        if one.axis is None or two.axis is None:
            return False
        axis, way = one.axis, subtract(two.point, one.point)
        gaps = [*cross(axis, two.axis), dot(axis, way)]
        for edge in self.graph.held:
            if self.graph.cluster[edge.parent] == self.graph.cluster[edge.child] == body and edge.axis is not None:
                gaps += [dot(axis, edge.axis)] if edge.kind == "slide" else cross(axis, edge.axis)
            elif edge.kind == "ball":
                return False
        return all(abs(float(gap)) < PARALLEL for gap in gaps)

    def _nearest(self, runs: Sequence[Run]) -> tuple[Run, Run] | None:
        """(run, the same from a cluster that has a place): a coupled one, the platform's, else with fewest freedoms."""
        found = [(run, run if run.near in self.chains else run.reversed()) for run in runs
                 if (run.near in self.chains) != (run.far in self.chains)]  # fmt: skip
        hub = {self.graph.ground, self.platform}  # on the shortest way forms have the lowest degree
        late = [self.slides_first and pair[0].kind != "slide" for pair in found]
        order = [(not self.graph.tied(r), l, hub != {r.near, r.far}, r.freedoms)
                 for l, (r, _) in zip(late, found, strict=True)]  # fmt: skip
        return found[order.index(min(order))] if found else None

    def _add_group(self, group: Group) -> None:
        self.chains[group.cluster] = (*self.chains[group.parent], len(self.groups))
        self.groups.append(group)

    def _hang(self, run: Run) -> None:
        """The groups of a run of the tree; between the edges of a hook is a body of its own."""
        start, body = run.near, self._end(run, near=True)
        if run.kind == "ball":
            edge = run.edges[0] if len(run.edges) == 1 else None
            slot = self._point(body, run.edges[0].point)
            self._add_group(Group("ball", run.far, start, (slot,), edge, self._forward(run, 0)))
            return
        for k, edge in enumerate(run.edges):
            assert edge.axis is not None
            far = run.far if k == len(run.edges) - 1 else f"{run.near}>{edge.joint}:{edge.columns[0]}"
            slots = [self._axis(body, edge.axis)]
            self.behind[edge.child if edge.parent == body else edge.parent] = self.behind.get(body, body)
            if edge.kind == "turn":
                slots.append(self._point(body, edge.point))
            self._add_group(Group(edge.kind, far, start, tuple(slots), edge, self._forward(run, k)))
            start = far

    def _forward(self, run: Run, place: int) -> bool:
        """Whether an edge of a run is passed from parent to child."""
        edge, bodies = run.edges[place], self.graph.cluster
        return bodies[edge.parent] == run.near if place == 0 else bodies[edge.child] == run.far

    def _end(self, run: Run, *, near: bool) -> str:
        """The body that a run starts or ends on."""
        edge, cluster = (run.edges[0], run.near) if near else (run.edges[-1], run.far)
        return edge.parent if self.graph.cluster[edge.parent] == cluster else edge.child

    def _slot(self, slot: Slot) -> int:
        self.slots.append(slot)
        return len(self.slots) - 1

    def _axis(self, body: str, axis: Point, taken: Sequence[int] = ()) -> int:
        """The slot of a joint's axis on a body; that of a joint before it in a row which has the same direction.

        Cylinders and hinges in a row that stay parallel are so in every mechanism of the structure: without that a
        general one has more solutions, whose paths end at infinity. `taken`: slots that are no choice.
        """
        carrier = self.behind.get(body, body)
        for owner, known, number in self.axes if self.graph.axis is None else ():
            if owner == carrier and number not in taken and self._parallel(known, axis):
                return number
        self.axes.append((carrier, axis, self._slot(Slot("axis", body, axis))))
        return self.axes[-1][2]

    @staticmethod
    def _parallel(one: Point, two: Point) -> bool:
        """Whether two axes of length one have the same direction and sense."""
        return all(abs(float(a - b)) < PARALLEL for a, b in zip(one, two, strict=True))

    def _point(self, body: str, at: Point) -> int:
        """The slot of a point of a body; that of the same point if there is one."""
        for owner, place, number in self.points:
            if owner == body and all(abs(float(a - b)) < TOGETHER for a, b in zip(at, place, strict=True)):
                return number
        self.points.append((body, at, self._slot(Slot("point", body, at))))
        return self.points[-1][2]

    def _form(self, run_ends: tuple[str, str], form: Form) -> None:
        self.forms.setdefault(run_ends, []).append(form)

    def _close(self, run: Run) -> None:
        """The forms of a run that closes a loop: its points meet, its axes keep their angle."""
        one, two = self._end(run, near=True), self._end(run, near=False)
        first, last = run.edges[0], run.edges[-1]
        ends = (run.near, run.far)
        table = PLANAR_EQUATIONS if self.graph.axis else SPHERICAL_EQUATIONS if self.graph.spherical else EQUATIONS
        self.counts["equations"] += table[run.kind]
        if run.kind == "slide":
            raise _SlideLeftError(f"a loop of slides alone, closed by {first.joint}")
        if not self.graph.spherical:
            self._form(ends, Form("meeting", (self._point(two, last.point), self._point(one, first.point))))
        if run.kind == "ball" or self.graph.axis:
            return
        assert first.axis is not None and last.axis is not None
        pairs = [form.slots for forms in self.forms.values() for form in forms if form.kind == "parallel"]
        taken = [slot for pair in pairs for slot in pair]  # each pair goes from member to member in its own way
        w, u = self._axis(two, last.axis, taken), self._axis(one, first.axis, taken)
        if run.kind == "hook":
            number = self._slot(Slot("number", at=dot(first.axis, last.axis)))
            self._form(ends, Form("angle", (w, u, number)))
        else:
            self._form(ends, Form("parallel", (w, u)))

    def _couple(self, link: Link) -> None:
        """The equation of a coupling: a product of what it ties, each as often as its whole number says."""
        groups = {g.edge.columns[0]: (k, g) for k, g in enumerate(self.groups) if g.edge is not None}
        factors = list[tuple[int, bool]]()
        for column, times in link.factors.items():
            if column not in groups:
                raise NotAlgebraicError(f"the coupling {link.name} ties all joints of a loop")
            place, group = groups[column]
            spin = Spin(place, link.turning, 1 if link.turning else abs(times))
            if spin not in self.spins:
                self.spins.append(spin)
            back = (times < 0) == group.forward
            factors += [(self.spins.index(spin), back)] * (abs(times) if link.turning else 1)
        kind = "turned" if link.turning else "slid"
        slot = self._slot(Slot(kind, at=link.column))
        self.counts["equations"] += 1
        ground = self.graph.ground
        self.couplings.append(Loop(ground, ground, (Form(kind, (slot,)),), tuple(factors)))

    def _distance(self, rod: Rod) -> None:
        one, two = rod.runs
        places = (one.edges[0].point, two.edges[-1].point)
        a = self._point(self._end(one, near=True), places[0])
        p = self._point(self._end(two, near=False), places[1])
        ends = ((self._end(one, near=False), places[0]), (self._end(two, near=True), places[1]))
        number = self._slot(Slot("distance", of=(p, a), rod=ends))
        self.counts["equations"] += 1
        self._form((one.near, two.far), Form("distance", (p, a, number)))
        if rod.crossing:
            outer, other = one.edges[0].axis, two.edges[-1].axis
            w = self._slot(Slot("axis", self._end(two, near=False), other))
            u = self._slot(Slot("axis", self._end(one, near=True), outer))
            self.counts["equations"] += 1
            self._form((one.near, two.far), Form("crossing", (w, p, u, a)))

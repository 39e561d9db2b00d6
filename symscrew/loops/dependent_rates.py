"""Solving the loops: independent coordinates, rates and accelerations of all others, Newton steps.

The closure J w = 0 is eliminated once, with the independent rates left over; the same elimination serves
velocities, accelerations, the null space and the Newton step of the assembly. Independent coordinates are
entries of q: a spherical joint contributes components of its quaternion's vector part.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.algebra import (
    NEGLIGIBLE,
    Column,
    Elimination,
    Guard,
    Node,
    Vector,
    add,
    cross,
    dot,
    eliminate,
    named_entries,
    pair,
    scale,
)
from symscrew.errors import DescriptionError
from symscrew.kinematics import Link, System, check_apart, identifiers, tree_label, unit_quaternion
from symscrew.loops.closure import Closure, closures

SMALL = 60
"""Freedoms of a tree up to which equal ways to the same numbers are all built and the cheapest is kept. Beyond, the
first is taken, which costs a few per cent of the operations (5 % for a chain of four-bars): building them all makes
deriving half as long again there, and more with every further freedom. The model's notes say so."""

DOUBLE = 1e-6
"""Singular values below this part of the largest are those of double zeros: where all loops close doubly, states are
found to the root of rounding only, which leaves 1e-8 to 1e-7 of what vanishes; a simple zero has above 1e-5 at one of
several random states."""


@dataclass(frozen=True)
class Independent:
    """One independent coordinate: its index in q, the joint rate (index into v) that goes with it, its link."""

    q: int
    v: int
    link: Link
    component: int | None  # of a quaternion's vector part


def counts_all_ways(system: System) -> bool:
    """Whether equal ways to the same numbers are all built and counted: see `SMALL`."""
    return len(system.tree.v) <= SMALL


class Loops:
    """The closure of a system, J w = right side, solved for the joint rates that depend on the independent ones.

    One elimination, with the independent rates left over, serves rates, accelerations and Newton steps. Entries of w
    are in rad/s or m/s: rates v, with those of spherical motions in the axes before the motion.

    Args:
        system: at its present nodes q, v.
        independent: labels of q, one per freedom; default: the platform's own coordinates where it hangs on one
            joint with rotations, else the drives, as far as the pivots allow.
        closure: the rows that are solved, by default the first of `closures`.

    Raises:
        DescriptionError: `independent` are no labels of q, or do not determine all others.
    """

    def __init__(
        self, system: System, independent: Sequence[str] | None = None, closure: Closure | None = None
    ) -> None:
        self.system = system
        self.closure = closure or next(closures(system))
        self.rows = self.closure.rows
        tree = system.tree
        n = len(tree.v)

        def eliminated(preferred: Sequence[int], *, yielding: bool) -> Elimination:
            given = self.closure
            return eliminate(
                system.tape, self.rows, given.unknowns, given.scales,
                last=preferred, yielding=yielding, defined=given.defined,
            )  # fmt: skip

        preferred = self._named(independent) if independent else self._preferred()
        self.elimination = eliminated(preferred, yielding=False)
        if not independent and self.elimination.vanishes and self.undetermined_reference:
            self.elimination = eliminated(preferred, yielding=True)
        if not independent and set(self.elimination.free) != set(preferred):
            # The same pivots as if the choice had been named.
            preferred = sorted(self.elimination.free)
            self.elimination = eliminated(preferred, yielding=False)
        free = sorted(self.elimination.free)
        if independent and set(free) != set(preferred):
            names = ", ".join(tree.q[i.q].label for i in self._entries(free))
            raise DescriptionError(
                f"independent coordinates: expected {len(free)} that determine all others, got "
                f"{', '.join(independent)}; a possible choice is {names}"
            )
        order = {k: i for i, k in enumerate(preferred)}
        self.free = sorted(free, key=lambda k: order.get(k, n + k)) if independent else free
        self.entries = self._entries(self.free)
        self.small = self._quaternion_elimination()
        self.answers: dict[Hashable, tuple[object, Any]] = {}  # what was asked of these loops before
        for _, column, pivot, factors in self.elimination.steps:
            name = self.label(column)
            named_entries([pivot], "pivot", [name])
            named_entries(factors.values(), "factor", [f"{name}|{row}" for row in factors])

    def label(self, column: Column) -> str:
        """What an unknown is called: a rate of the tree, or a component of the velocity of a cut joint's point."""
        if isinstance(column, int):
            return self.system.tree.v[column].label
        return ".".join(str(part) for part in column[1:])

    # -- choice ------------------------------------------------------------------------------------------

    def _entries(self, free: Sequence[int]) -> list[Independent]:
        entries = []
        for k in free:
            link = next(link for link in self.system.tree.links[1:] if link.v.start <= k < link.v.stop)
            component = k - link.v.start if link.motion.spherical else None
            q = link.q.start + (1 + component if component is not None else 0)
            entries.append(Independent(q, k, link, component))
        return entries

    def _named(self, labels: Sequence[str]) -> list[int]:
        known = {entry_label: k for k, entry_label in enumerate(self._labels())}
        chosen = []
        for label in labels:
            try:
                chosen.append(known[tree_label(self.system.mechanism, known, label)])
            except DescriptionError as error:
                raise DescriptionError(f"independent coordinates: {error}") from error
        return chosen

    def _labels(self) -> list[str]:
        """Label of the entry of q that goes with each entry of v."""
        return [self.system.tree.q[entry.q].label for entry in self._entries(range(len(self.system.tree.v)))]

    def _preferred(self) -> list[int]:
        """The platform's own coordinates where it hangs on one joint with rotations, else the drives."""
        tree, platform = self.system.tree, self.system.mechanism.platform
        if platform is not None and platform in tree.link_of_body:
            path = tree.path(tree.link_of_body[platform])
            joints = {tree.links[i].joint for i in path}
            if len(joints) == 1 and any(tree.links[i].motion.spherical for i in path):
                return [k for i in sorted(path) for k in range(tree.links[i].v.start, tree.links[i].v.stop)]
        return list(self.system.drive_rows())

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of the independent coordinates y."""
        return tuple(self.system.tree.q[entry.q].label for entry in self.entries)

    def inputs(self, prefix: str) -> tuple[Node, ...]:
        """Input nodes of the independent coordinates: prefix "y", "ydot" or "yddot"."""
        what = {"y": "coordinate", "ydot": "rate of coordinate", "yddot": "second rate of coordinate"}[prefix]
        suffix = {"y": "", "ydot": "/s", "yddot": "/s^2"}[prefix]
        q = self.system.tree.q
        names = identifiers(c.label for c in q)
        check_apart(self.system.mechanism, (f"{prefix}_{names[q[e.q].label]}" for e in self.entries))
        return tuple(
            self.system.tape.symbol(f"{prefix}_{names[q[e.q].label]}", q[e.q].unit + suffix, f"{what} {q[e.q].label}")
            for e in self.entries
        )

    def cost(self, nodes: Sequence[Node]) -> int:
        """What it takes to compute nodes: see `Closure.cost`."""
        return self.closure.cost(nodes)

    # -- linear solutions --------------------------------------------------------------------------------

    def dependent(self, right: Sequence[Node], free: Sequence[Node]) -> list[Node]:
        """All joint rates w with J w = right and the given free ones.

        The free ones as part of the right side or by their own columns, whichever takes fewer operations.
        """
        zero = self.system.tape.zero
        known = dict(zip(self.free, free, strict=True))
        given = {k: value for k, value in known.items() if value is not zero}
        values = [*right, *[zero] * (len(self.rows) - len(right))]
        moved = list(values)
        for i, row in enumerate(self.rows):
            for k, value in given.items():
                if k in row:
                    moved[i] = moved[i] - row[k] * value
        ways = [{**self.elimination.solve(moved), **known}]
        if counts_all_ways(self.system):
            ways.append(self.elimination.solve(values, known))
        found = [[solution.get(k, zero) for k in range(len(self.system.tree.v))] for solution in ways]
        if found[0] == found[-1] and not self.closure.mode:  # in a mode a cost leaves its nodes on the tape
            return found[0]
        return min(found, key=self.cost)

    def _called(self, values: list[Node], quantity: str, by: str = "") -> list[Node]:
        """Values per joint rate, called so."""
        named_entries(values, quantity, [f"{c.label}|{by}" for c in self.system.tree.v])
        return values

    def with_rates(self, particular: Sequence[Node], wanted: Sequence[Node]) -> list[Node]:
        """w = particular + N f, with f such that the independent coordinates change at the wanted rates.

        `particular` solves J w = right with the free rates zero.
        """
        tape = self.system.tape
        zero_right = [tape.zero] * len(self.system.jacobian)
        free = list(wanted)
        if self.small.steps:
            right = [
                rate - self.quaternion_rate(entry, particular) if entry.component is not None else rate
                for rate, entry in zip(wanted, self.entries, strict=True)
            ]
            solution = self.small.solve(right)
            free = [solution.get(j, tape.zero) for j in range(len(self.free))]
        if all(p is tape.zero for p in particular):
            return self.dependent(zero_right, free)
        moved = self.dependent(zero_right, free)
        return [p + m for p, m in zip(particular, moved, strict=True)]

    def _quaternion_elimination(self) -> Elimination:
        """From rates of the independent coordinates to free joint rates, where some are quaternion components."""
        tape, count = self.system.tape, len(self.free)
        if all(entry.component is None for entry in self.entries):
            return Elimination()
        zero_right = [tape.zero] * len(self.system.jacobian)
        unit = [[tape.one if i == j else tape.zero for j in range(count)] for i in range(count)]
        columns = [self.dependent(zero_right, unit[j]) for j in range(count)]
        rows = []
        for i, entry in enumerate(self.entries):
            rates = unit[i] if entry.component is None else [self.quaternion_rate(entry, c) for c in columns]
            rows.append({j: rate for j, rate in enumerate(rates) if rate is not tape.zero})
        return pair(tape, rows, (1.0, 1.0)) or eliminate(tape, rows, dict.fromkeys(range(count), 1.0), [1.0] * count)

    def quaternion(self, link: Link) -> tuple[Node, Vector]:
        """Scalar and vector part of a spherical link's quaternion, of unit length."""
        w, x, y, z = unit_quaternion(self.system.inputs.q[link.q])
        return w, (x, y, z)

    def quaternion_rate(self, entry: Independent, w: Sequence[Node]) -> Node:
        """Rate of a component of the vector part: half of (q_w w + w x q_v)."""
        scalar, vector = self.quaternion(entry.link)
        x, y, z = w[entry.link.v]
        rate = add(scale(scalar, (x, y, z)), cross((x, y, z), vector))
        half = self.system.tape.reciprocal(self.system.tape.node(2))
        assert entry.component is not None
        result: Node = half * rate[entry.component]
        return result

    # -- solutions for the functions of the model --------------------------------------------------------------

    def rates_from(self, y_dot: Sequence[Node]) -> list[Node]:
        """w from the rates of the independent coordinates."""
        unit = all(y.value is not None for y in y_dot)
        w = self.with_rates([self.system.tape.zero] * len(self.system.tree.v), y_dot)
        by = "_".join(label for label, y in zip(self.labels, y_dot, strict=True) if y.value != 0) if unit else ""
        return self._called(w, "null_space" if unit else "joint_rate", by)

    def accelerations_from(
        self, y_ddot: Sequence[Node], bias: Sequence[Node], w: Sequence[Node] | None = None
    ) -> list[Node]:
        """dw/dt from the second rates of the independent coordinates; `bias` is (dJ/dt) w per row.

        `w` are the present joint rates (default: those of the input v).
        """
        system = self.system
        zeros = [system.tape.zero] * len(self.free)
        if not self.small.steps:
            return self._called(self.dependent([-b for b in bias], y_ddot), "joint_acceleration")
        particular = self.dependent([-b for b in bias], zeros)
        w = system.joint_rates(system.inputs.v) if w is None else w
        wanted = [
            second - self._quaternion_bias(entry, w) if entry.component is not None else second
            for entry, second in zip(self.entries, y_ddot, strict=True)
        ]
        return self._called(self.with_rates(particular, wanted), "joint_acceleration")

    def second_rates(self, free: Sequence[Node], w_dot: Sequence[Node], w: Sequence[Node]) -> list[Node]:
        """Second rates of y from the free joint accelerations; w, w_dot: rates and accelerations of all joints."""
        return [
            self.quaternion_rate(entry, w_dot) + self._quaternion_bias(entry, w) if entry.component is not None else z
            for entry, z in zip(self.entries, free, strict=True)
        ]

    def _quaternion_bias(self, entry: Independent, w: Sequence[Node]) -> Node:
        """Second rate of a quaternion component at dw/dt = 0."""
        half = self.system.tape.reciprocal(self.system.tape.node(2))
        scalar, vector = self.quaternion(entry.link)
        x, y, z = w[entry.link.v]
        turn = (x, y, z)
        scalar_rate = -half * dot(turn, vector)
        vector_rate = scale(half, add(scale(scalar, turn), cross(turn, vector)))
        assert entry.component is not None
        result: Node = half * add(scale(scalar_rate, turn), cross(turn, vector_rate))[entry.component]
        return result

    def newton_step(self, y: Sequence[Node]) -> list[Node]:
        """The step in joint rates that closes the loops to first order and moves y to the wanted values."""
        system = self.system
        particular = self.dependent([-g for g in system.residual], [system.tape.zero] * len(self.free))
        missing = [wanted - system.inputs.q[entry.q] for wanted, entry in zip(y, self.entries, strict=True)]
        return self.with_rates(particular, missing)

    def bias(self, moving: System) -> list[Node]:
        """(dJ/dt) v per row, for the system with rates that keep the loops closed."""
        return self.closure.bias(moving)

    @property
    def rank(self) -> int:
        """How many constraint rows are independent."""
        return len(self.system.tree.v) - len(self.elimination.free)

    @property
    def pivots(self) -> tuple[Node, ...]:
        """All pivots: their product is, up to sign, the determinant of the dependent part."""
        return tuple(pivot for _, _, pivot, _ in (*self.elimination.steps, *self.small.steps))

    @property
    def guards(self) -> tuple[Guard, ...]:
        """Pivots to watch."""
        return (*self.elimination.guards, *self.small.guards)

    @property
    def singular_reference(self) -> bool:
        """Whether the closure has a smaller rank in the reference configuration than near it."""
        return bool(self.system.cuts) and self._rank(self.system.reference) < self.rank

    @property
    def undetermined_reference(self) -> bool:
        """Whether others would determine all in the reference configuration, and the independent coordinates do not."""
        dependent = [k for k in range(len(self.system.tree.v)) if k not in self.elimination.free]
        undetermined = bool(self.system.cuts) and self._rank(self.system.reference, dependent) < self.rank
        return undetermined and not self.singular_reference

    def keep_to_one_branch(self) -> bool:
        """Whether some samples lay on branches where the independent coordinates do not determine the others.

        Branches meet in singular references. What is chosen by samples must be chosen on those branches that functions
        of these coordinates are for: equations of others are none here, and ours are none there. Samples of ours take
        the places of the others, after which loops are to be made anew.
        """
        if not self.system.cuts:
            return False
        dependent = [k for k in range(len(self.system.tree.v)) if k not in self.elimination.free]
        q = self.system.sample_states[0]
        regular = np.array([self._rank(state, dependent) == len(dependent) for state in q])
        mixed = bool(regular[1:].any() and not regular[1:].all())
        if mixed:
            self.system.samples.keep(regular)
        return mixed

    @property
    def shaky(self) -> bool:
        """Whether the closure has a smaller rank in all sample states than off them, as at double zeros."""
        q = self.system.sample_states[0]
        return bool(self.system.cuts) and all(self._rank(state, small=DOUBLE) < self.rank for state in q)

    def _rank(self, q: np.ndarray, rates: Sequence[int] | None = None, *, small: float = NEGLIGIBLE) -> int:
        """The rank of the closure's columns of all or some joint rates in a configuration."""
        system = self.system
        matrix = system.numeric(system.closure.dense(), (system.inputs.q, q[None, :]))
        columns = matrix.reshape(-1, len(system.scales)) * system.scales
        values = np.linalg.svd(columns if rates is None else columns[:, list(rates)], compute_uv=False)
        return int((values > small * max(values, default=0.0)).sum())

    @property
    def redundant(self) -> tuple[str, ...]:
        """Labels of the constraint rows that depend on the others on the closure manifold.

        Of the system's own rows: those of rods are others, and a mode adds rows.
        """
        assert self.closure.of_system and not self.closure.mode
        labels = [row.label for cut in self.system.cuts for row in cut.rows]
        return tuple(labels[i] for i in self.elimination.redundant)

"""Dynamic functions: mass matrix, bias, inverse dynamics with redundant drives, all joint reactions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

from symscrew.algebra import ZERO, Guard, Node, Vector, cost, count_operations, named_entries
from symscrew.dynamics import (
    Balance,
    DriveSolution,
    Reactions,
    Rod,
    RodSettings,
    Setting,
    Wrench,
    balance,
    balances,
    carried_wrenches,
    generalised_forces,
    joint_wrenches,
    mass_matrix,
    numeric_multipliers,
    solve_drives,
    solve_reactions,
    thin_rods,
)
from symscrew.effects import Acting, Effect, Estimate
from symscrew.functions.closing import guarded
from symscrew.functions.ports import (
    WRENCH_LABELS,
    WRENCH_UNITS,
    a_port,
    columns_port,
    drive_label,
    function,
    q_port,
    u_port,
    v_port,
    y_port,
)
from symscrew.kinematics import Inertia, Link, System, identifiers
from symscrew.loops import Loops, counts_all_ways
from symscrew.program import Function, Port

NO_DRIVE = "carry no drive"  # of a note: some freedoms


WORTH = 0.95
"""Reactions for given drives take more pivots than those of which drives follow where they cost less than this of it: a
delta's took 0.5 % fewer operations with four divisions more, and 3 % more time; a 6-RUS saves 11 %."""


PIVOT = 9
"""Operations that a pivot of the drives counts for beside those that it takes: its division keeps a vector unit busy
for so long. A head on six rods takes three divisions in place of six."""


FEWER, LONGER = 1 / 2, 1.08
"""Drives with half of the pivots or fewer may take so much longer than those of fewest operations, if `PIVOT` says so.
Of a delta eight states take 0.9 of the time with 857 operations and two pivots, beside 802 and six; of a planar 3-RRR,
where 31 operations would be given for three pivots, one state took 1.04 of it."""


class Equations:
    """Equilibrium of a system under effects, eliminated once for all dynamic functions."""

    def __init__(
        self,
        system: System,
        effects: Sequence[Effect],
        loads: Estimate | None = None,
        *,
        unloaded: bool = False,
        given: Sequence[Node] | None = None,
        cost: Callable[[Sequence[Node]], int] = cost,
    ) -> None:
        """Equations at the system's present nodes; `cost` of nodes is what is kept low.

        `loads` are what load-dependent effects read; by default what the same equations give without these effects
        (`unloaded`). `given`: forces and torques of the drives, where only reactions are asked for.
        """
        self.system, self.given, self.cost = system, given, cost
        self.forces = Acting(system, effects, loads)
        if self.forces.needs_reactions and loads is None and not unloaded:
            before = Equations(system, effects, unloaded=True)
            for _ in range(self.forces.passes - 1):
                before = Equations(system, effects, before.estimate(before.reactions(before.solution.u)))
            self.forces = Acting(system, effects, before.estimate(before.reactions(before.solution.u)))
        self.setting = Setting(
            system.tape,
            system.tree,
            system.frames,
            system.placed,
            system.cuts,
            system.drive_rows(),
            system.cut_drives(),
            system.length,
            system.structure.virtual_directions(),
            self.forces.known_forces(system.inputs.a),
        )
        self.inertia = self.forces.lean_inertia()
        self.rates = self.forces.link_rates(system.inputs.a)

    @cached_property
    def balance(self) -> Balance:
        """Multipliers and the equations at the hub, in the order of elimination that takes fewer operations.

        With given drives the multipliers count alone, where that is worth more pivots (`WORTH`).
        """
        both = self._fewest(self._plain_ways, self._all_of)
        given = self.given
        if given is None:
            return both

        def found(way: Balance) -> list[Node]:
            known = numeric_multipliers(self.setting, way, given).values()
            return [*(entry for affine in known for entry in affine.values()), *(guard.pivot for guard in way.guards)]

        least = self._fewest(self._plain_ways, found)
        worth = 1.0 if len(least.guards) <= len(both.guards) else WORTH
        return least if self.cost(found(least)) < worth * self.cost(found(both)) else both

    def _all_of(self, way: Balance) -> list[Node]:
        return [
            *self._drives_and_pivots(way),
            *(entry for affine in way.multipliers.values() for entry in affine.values()),
        ]

    @cached_property
    def solution(self) -> DriveSolution:
        """The drives of smallest sum of squares."""
        return self.drives(self.balance)

    @cached_property
    def lean_balance(self) -> Balance:
        """The equations at the hub for drives alone, with thin rods as masses at their ends where that is shorter.

        The cost weighs divisions that wait. Beyond what is shared with reactions, or is there without a seat of the
        hub, operations are given for fewer pivots where those are few (`FEWER`, `LONGER`).
        """
        rods, found = thin_rods(self.system, self.forces), self._drives_and_pivots
        unseated, seated = self._ways_with_bars(rods) if rods else ([], [])
        unseated = [*self._plain_ways, *unseated]
        limit = min(self._size(self.balance), self._size(self._fewest(unseated, found)))
        ways = [(way, self._size(way)) for way in (*unseated, *seated)]

        def weighed(way: Balance) -> int:
            return self.cost(found(way)) + PIVOT * len(way.guards)

        least = min((way for way, size in ways if size <= limit), key=weighed)
        most = FEWER * len(least.guards)
        few = (way for way, size in ways if len(way.guards) <= most and size <= LONGER * limit)
        return min((least, *few), key=weighed)

    @cached_property
    def lean_solution(self) -> DriveSolution:
        """The drives of smallest sum of squares, without what only reactions need."""
        return self.drives(self.lean_balance)

    @cached_property
    def _plain_ways(self) -> list[Balance]:
        return self._tried(self.setting, self.inertial_wrenches(self.inertia), self.forces.loads)

    def _ways_with_bars(self, rods: Mapping[int, Rod]) -> tuple[list[Balance], list[Balance]]:
        """Balances with the hub where its coordinates put it; with it on seats, rods by their ends and by angles."""
        stated = RodSettings(self.system, self.forces, self.setting, self.rates, rods)
        unseated = self._tried(*stated.unseated)
        if len(unseated) == 1:
            return unseated, []
        return unseated, [way for one in (*stated.by_ends(), *stated.by_angles()) for way in self._tried(*one)]

    def inertial_wrenches(self, inertia: Sequence[Inertia]) -> Callable[[Link], Wrench]:
        """Inertial wrenches of links with these inertias: those of the bodies as given (`forces.inertia`), which are
        right everywhere, or the regrouped ones, which are for drives and cut joints but not inside the tree."""

        def wrench(link: Link) -> Wrench:
            return self.forces.inertial_wrench(link.index, inertia[link.index], self.rates)

        return wrench

    def _tried(self, setting: Setting, wrench: Callable[[Link], Wrench], loads: Mapping[int, Wrench]) -> list[Balance]:
        """The balance with the rows of the drives in their places or last.

        Links that carry whole loops supply what cancels inside these, or the inertia that they carry alone.
        """
        if not (setting.drives and setting.cuts and counts_all_ways(self.system)):
            return [balance(setting, wrench, loads)]
        carried = carried_wrenches(setting, wrench, loads)
        return [
            way
            for known in ({}, carried)[: 2 if carried else 1]
            for last in (False, True)
            for way in balances(setting, wrench, loads, drives_last=last, carried=known)
        ]

    def _fewest(self, ways: Sequence[Balance], found: Callable[[Balance], Sequence[Node]]) -> Balance:
        return min(ways, key=lambda way: self.cost(found(way))) if len(ways) > 1 else ways[0]

    def _size(self, way: Balance) -> int:
        """Operations of the drives, with those that watch the pivots: magnitude, comparison, sum of what is finite."""
        found = self._drives_and_pivots(way)
        return count_operations(found) + 3 * (len(found) - len(self.system.drives))

    def _drives_and_pivots(self, way: Balance) -> list[Node]:
        solution = self.drives(way)
        return [*solution.u, *(guard.pivot for guard in (*way.guards, *solution.guards))]

    def reactions(self, forces: Sequence[Node]) -> Reactions:
        """Reactions of all joints for given forces and torques of the drives on their joints."""
        multipliers = numeric_multipliers(self.setting, self.balance, forces)
        found = joint_wrenches(
            self.setting,
            self.system.pose,
            wrench=self.inertial_wrenches(self.forces.inertia),
            loads=self.forces.loads,
            multipliers=multipliers,
            u=forces,
        )
        return solve_reactions(self.system, self.setting, found, self.balance.free)

    def estimate(self, found: Reactions) -> Estimate:
        """What load-dependent effects read of these equations and their reactions."""
        return Estimate(found.wrenches, self.rates)

    def command(self, solution: DriveSolution) -> tuple[Port, tuple[Node, ...]]:
        """The output u: what the drives are given, on the motors' side of their transmissions."""
        return self.forces.drive_port(u_port(self.system)), self.forces.drive_commands(solution.u)

    @property
    def lean_guards(self) -> tuple[Guard, ...]:
        """Pivots of the drives alone."""
        return (*self.lean_balance.guards, *self.lean_solution.guards)

    def drives(
        self, way: Balance, weights: Sequence[Node] | None = None, preload: Sequence[Node] | None = None
    ) -> DriveSolution:
        """Drives from the equations at the hub."""
        found = solve_drives(self.system.tape, way.finals, self.setting.drive_scales, weights=weights, preload=preload)
        named_entries(found.u, "drive", u_port(self.system).labels)
        return found

    @property
    def notes(self) -> tuple[str, ...]:
        """What a user of the drives must know."""
        notes = []
        if self.solution.redundancy:
            notes.append(
                f"{self.solution.redundancy} more drives than freedoms: the drives of smallest sum of squares; "
                "inverse_dynamics_preload takes weights and an internal preload"
            )
        passive = len(self.balance.unbalanced) + self.solution.unreachable
        if passive:
            notes.append(f"{passive} freedom{'s' * (passive > 1)} {NO_DRIVE}: the motion must obey their own equations")
        return tuple(notes)


def dynamic_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """Mass matrix, bias and, where there are drives, inverse dynamics and reactions."""
    equations = Equations(system, effects, cost=loops.cost)
    functions = [_mass_matrix(system, equations.forces), _bias(system, effects)]
    if system.drives:
        functions.append(_inverse_dynamics(equations))
        functions.append(_from_independent(system, effects, loops))
        if equations.solution.redundancy:
            functions.append(_with_preload(equations))
    functions.append(_joint_reactions(equations))
    return functions


def reactions_inputs(equations: Equations) -> list[tuple[Port, Sequence[Node]]]:
    """The inputs of functions of a consistent state: q, v, a and those of what acts."""
    system = equations.system
    state = [
        (q_port(system), system.inputs.q),
        (v_port(system), system.inputs.v),
        (a_port(system), system.inputs.a),
    ]
    return [*state, *equations.forces.inputs]


def _inverse_dynamics(equations: Equations) -> Function:
    system = equations.system
    text = "Drives from a consistent state of the tree, by the rates of the momentum screws."
    return function(
        system,
        "inverse_dynamics",
        text,
        inputs=reactions_inputs(equations),
        outputs=[equations.command(equations.lean_solution)],
        guards=guarded(equations.lean_guards),
        notes=equations.notes,
    )


def _from_independent(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    """Inverse dynamics with rates and accelerations of the tree solved from the independent coordinates'."""
    y_dot, y_ddot = loops.inputs("ydot"), loops.inputs("yddot")
    v = system.tree_rates(loops.rates_from(y_dot))
    moving = system.at(system.inputs.q, {}, v)
    a = system.tree_rates(loops.accelerations_from(y_ddot, loops.bias(moving), moving.joint_rates(v)))
    equations = Equations(system.at(system.inputs.q, {}, v, a), effects, cost=loops.cost)
    inputs = [
        (q_port(system), system.inputs.q),
        (y_port(loops, "y_dot", 1), y_dot),
        (y_port(loops, "y_ddot", 2), y_ddot),
        *equations.forces.inputs,
    ]
    guards = guarded((*loops.guards, *equations.lean_guards))
    text = "Drives from the configuration and the rates and second rates of the independent coordinates."
    output = [equations.command(equations.lean_solution)]
    return function(
        system,
        "inverse_dynamics_independent",
        text,
        inputs=inputs,
        outputs=output,
        guards=guards,
        notes=equations.notes,
    )


def _with_preload(equations: Equations) -> Function:
    system = equations.system
    count = len(system.drives)
    names = identifiers(drive_label(system, k) for k in range(count))
    weights, preload = (
        tuple(
            system.tape.symbol(f"{name}_{names[drive_label(system, k)]}", unit, f"{what} of drive {k + 1}")
            for k in range(count)
        )
        for name, unit, what in (("weight", "1", "weight"), ("preload", "N", "preload"))
    )
    solution = equations.drives(equations.lean_balance, weights, preload)
    labels = tuple(drive_label(system, k) for k in range(count))
    units = u_port(system).units
    inputs = [
        *reactions_inputs(equations),
        (Port("weights", (count,), ("1",) * count, labels, "positive weights of the squares"), weights),
        (
            Port("preload", (count,), units, labels, "drives to stay close to: their internal part is kept"),
            preload,
        ),
    ]
    text = "Drives that minimise sum w_j (u_j - preload_j)^2: any internal preload by its drives."
    guards = guarded((*equations.lean_balance.guards, *solution.guards))
    guards += [(weight, 0.0) for weight in weights]  # a weight of 0, NaN or infinity is an error, not a choice
    return function(
        system,
        "inverse_dynamics_preload",
        text,
        inputs=inputs,
        outputs=[equations.command(solution)],
        guards=guards,
        notes=equations.notes,
    )


def _joint_reactions(equations: Equations) -> Function:
    system, u = equations.system, equations.solution.u
    port, values, more, notes = all_reactions(equations, u)
    outputs: list[tuple[Port, Sequence[object]]] = [(port, values)]
    if system.drives:
        outputs.insert(0, equations.command(equations.solution))
    guards = guarded((*equations.balance.guards, *equations.solution.guards, *more))
    text = "Drives and all joint reactions at once, at O in absolute axes."
    every = (*equations.notes, *notes)
    return function(
        system, "joint_reactions", text, inputs=reactions_inputs(equations), outputs=outputs, guards=guards, notes=every
    )


def all_reactions(equations: Equations, u: Sequence[Node]) -> tuple[Port, list[object], tuple[Guard, ...], list[str]]:
    """Reactions (f ; m_O) of all joints, from parent on child, absolute axes, for given drives [N, N m].

    Returns the output's port, six values per joint of the description, guarded pivots, and notes on what is not unique.
    """
    system, reactions = equations.system, equations.reactions(u)
    notes = []
    if reactions.free:
        loads = f"{reactions.free} internal load{'s' * (reactions.free != 1)}"
        notes.append(
            f"overconstrained: {loads} undetermined, minimum-norm values are taken (moments divided by the "
            f"characteristic length {system.length!r} m); not unique: {_by_component(reactions.not_unique)}"
        )
    return reactions_port(system), in_order(system, reactions.wrenches), reactions.guards, notes


def _by_component(labels: Sequence[str]) -> str:
    """Components of reactions, joints that share theirs together: "fy, mx of A, B; fz of C"."""
    of_joint: dict[str, list[str]] = {}
    for joint, _, component in (label.rpartition(".") for label in labels):
        of_joint.setdefault(joint, []).append(component)
    alike: dict[str, list[str]] = {}
    for joint, components in of_joint.items():
        alike.setdefault(", ".join(components), []).append(joint)
    return "; ".join(f"{components} of {', '.join(joints)}" for components, joints in alike.items())


def reactions_port(system: System) -> Port:
    """Wrenches of all joints, in the order of the description."""
    text = "wrench (f ; m_O) from parent on child without the drive's share"
    return columns_port("reactions", list(system.mechanism.joints), WRENCH_LABELS, WRENCH_UNITS, description=text)


def in_order(system: System, wrenches: Mapping[str, tuple[Vector, Vector]]) -> list[object]:
    """Six entries per joint of the description; zeros for joints without a wrench."""
    pairs = [wrenches.get(name, (ZERO, ZERO)) for name in system.mechanism.joints]
    return [entry for force, moment in pairs for entry in (*force, *moment)]


def _bias(system: System, effects: Sequence[Effect]) -> Function:
    acting = Acting(system, effects)
    values = generalised_forces(system, acting, [system.tape.zero] * len(system.tree.v))
    units = tuple("N" if c.kind == "length" else "N m" for c in system.tree.v)
    port = Port("bias", (len(values),), units, tuple(c.label for c in system.tree.v), "generalised forces at a = 0")
    inputs = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), *acting.inputs]
    text = "Generalised forces of the tree at zero acceleration: M a + bias = forces on the freedoms + J^T multipliers."
    return function(system, "bias", text, inputs=inputs, outputs=[(port, values)])


def _mass_matrix(system: System, acting: Acting) -> Function:
    matrix = mass_matrix(system, acting.added_inertia)
    n = len(matrix)
    labels = tuple(f"{a.label}|{b.label}" for b in system.tree.v for a in system.tree.v)
    kinds = [c.kind == "length" for c in system.tree.v]
    units = tuple(("kg m^2", "kg m", "kg")[int(a) + int(b)] for b in kinds for a in kinds)
    port = Port("mass_matrix", (n, n), units, labels, "symmetric; kinetic energy = v.M.v / 2")
    text = "Mass matrix of the tree (cut joints open)."
    values = [matrix[i][j] for j in range(n) for i in range(n)]
    inputs = [(q_port(system), system.inputs.q), *(acting.inputs_of(values) if acting.bendings else [])]
    return function(system, "mass_matrix", text, inputs=inputs, outputs=[(port, values)])

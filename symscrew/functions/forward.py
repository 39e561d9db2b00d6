"""Forward dynamics: accelerations, and with them all reactions, from configuration, rates and drives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from symscrew.algebra import ZERO, Guard, Node, TapeMark, scale
from symscrew.dynamics import (
    ONE,
    Admissible,
    about_point,
    at_origin,
    generalised_forces,
    joint_wrenches,
    mass_matrix,
)
from symscrew.effects import Acting, Effect, Estimate
from symscrew.functions.closing import THRESHOLD, guarded, jacobian_in_v, moved_by, opening
from symscrew.functions.dynamic import Equations, all_reactions, in_order, reactions_port
from symscrew.functions.ports import a_port, function, q_port, u_port, v_port, y_port
from symscrew.kinematics import System, check_apart, identifiers
from symscrew.loops import Loops
from symscrew.program import SWITCH, Function, Port, Program, RankRevealing, lower


@dataclass(frozen=True)
class SecondPath:
    """The functions and unit scales of a rank-revealing path: see `symscrew.program.rank_revealing.RankRevealing`."""

    dense: Function
    wrenches: Function | None
    rates: tuple[float, ...]
    rows: tuple[float, ...]
    regular: int

    def behind(self, first: Program, mark: TapeMark | None = None) -> Program:
        """The program with this second path, or alone where no pivot could ask for it; `mark` as for `lower`.

        Pivots that are numbers, as of loops that gears alone close, ask for nothing.
        """
        if not first.guards:
            return first
        wrenches = lower(self.wrenches, mark) if self.wrenches else None
        return RankRevealing(**vars(first), dense=lower(self.dense, mark), wrenches=wrenches, rates=self.rates,
                             rows=self.rows, regular=self.regular)  # fmt: skip


MASSLESS_NOTE = "a motion that the loops allow moves no mass: forward dynamics is left out; give its bodies inertia"
SINGULAR_NOTE = (
    "all bodies have mass and inertia, but near the reference configuration the loops are too near to losing rank to "
    "find the motions that they allow: forward dynamics is left out; describe the mechanism in another configuration"
)
REASONS = (MASSLESS_NOTE, SINGULAR_NOTE)
"""Why a model has no forward dynamics, as its notes say it."""
State = list[tuple[Port, Sequence[Node]]]


def forward_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """Forward dynamics from the tree and from the independent coordinates."""
    if not accelerates(system, effects, loops):
        return []
    return [
        _forward_dynamics(system, effects, loops),
        _from_independent(system, effects, loops),
        _with_reactions(system, effects, loops),
    ]


def closing_functions(system: System, loops: Loops) -> list[Function]:
    """`close_position` and `close_velocity`, nearest states on the closure; none for trees."""
    return [_close_position(system, loops), _close_velocity(system, loops)] if system.cuts else []


def accelerates(system: System, effects: Sequence[Effect], loops: Loops) -> bool:
    """Whether accelerations follow from forces: not without mass, not in a quasi-static scene."""
    return Acting(system, effects).keeps_motion and moves_mass(system, effects, loops)


def moves_mass(system: System, effects: Sequence[Effect], loops: Loops) -> bool:
    """Whether every motion that the loops allow moves mass: else accelerations do not follow from forces."""
    return Admissible(system, loops, Acting(system, effects).added_inertia).moves_mass()


def left_out(system: System) -> str:
    """Why there is no forward dynamics where `moves_mass` says no: a body without inertia, or the reference."""
    mechanism = system.structure.mechanism  # with the inertias that effects leave
    bodies = [body for name, body in mechanism.bodies.items() if name != mechanism.ground]
    given = [(mechanism.number(b.mass or 0), b.inertia or ()) for b in bodies]
    heavy = all(mass > 0 and any(entry != 0 for row in rows for entry in row) for mass, rows in given)
    return SINGULAR_NOTE if heavy else MASSLESS_NOTE


def driven(system: System, effects: Sequence[Effect], loads: Estimate | None = None) -> tuple[Acting, State]:
    """What acts with the drives as inputs u [N, N m], and their port with its nodes (none without drives).

    `loads`: what load-dependent effects read.
    """
    acting = Acting(system, effects, loads)
    port = acting.drive_port(u_port(system))
    names = identifiers(port.labels)
    check_apart(system.mechanism, (f"u_{name}" for name in names.values()))
    nodes = tuple(
        system.tape.symbol(f"u_{names[label]}", unit, f"drive of {label}")
        for label, unit in zip(port.labels, port.units, strict=True)
    )
    for k, ((joint, freedom), node) in enumerate(zip(system.drives, nodes, strict=True)):
        acting.drive(joint, freedom, acting.drive_force(k, node))
    return acting, [(port, nodes)] if nodes else []


@dataclass(frozen=True)
class Solved:
    """What acts, the drives' input, free joint accelerations, accelerations of the tree, guarded pivots, reactions
    for load-dependent effects."""

    acting: Acting
    drives: State
    free: list[Node]
    a: list[Node]
    guards: tuple[Guard, ...]
    loads: Estimate | None = None

    @property
    def forces(self) -> tuple[Node, ...]:
        """Forces and torques of the drives on their joints."""
        nodes = self.drives[0][1] if self.drives else ()
        return tuple(self.acting.drive_force(k, node) for k, node in enumerate(nodes))


def solved(system: System, effects: Sequence[Effect], loops: Loops) -> Solved:
    """Accelerations from the drives; again where effects depend on the reactions, which the time before gives.

    The loops keep the answer: it is asked for when they are chosen, and by two functions.
    """
    key = (system, *map(id, effects))
    if key not in loops.answers:
        loops.answers[key] = effects, _solved(system, effects, loops)
    found: Solved = loops.answers[key][1]
    return found


def _solved(system: System, effects: Sequence[Effect], loops: Loops) -> Solved:
    result = _once(system, effects, loops, None)
    for _ in range(result.acting.passes if result.acting.needs_reactions else 0):
        at = system.at(system.inputs.q, {}, system.inputs.v, result.a)
        before = Equations(at, effects, result.loads, unloaded=result.loads is None)
        found = before.reactions(result.forces)
        again = _once(system, effects, loops, before.estimate(found))
        result = replace(again, guards=(*again.guards, *result.guards, *before.balance.guards, *found.guards))
    return result


def _once(system: System, effects: Sequence[Effect], loops: Loops, loads: Estimate | None) -> Solved:
    acting, drives = driven(system, effects, loads)
    free, a, guards = Admissible(system, loops, acting.added_inertia).accelerations(acting)
    return Solved(acting, drives, free, a, tuple(guards), loads)


def second_paths(system: System, effects: Sequence[Effect], loops: Loops) -> dict[str, SecondPath]:
    """What solves forward dynamics again where a pivot of its straight-line code is small, by the function's name.

    The tree's mass matrix and forces with the closure's Jacobian and bias, dense: a factorisation that reveals the rank
    takes them at run time. None for trees and for effects that depend on reactions.
    """
    if not system.cuts or Acting(system, effects).needs_reactions or not accelerates(system, effects, loops):
        return {}
    regular = loops.rank
    rows = tuple(1.0 / system.length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows)
    dense = _dense(system, effects)
    return {
        "forward_dynamics": SecondPath(dense, None, tuple(_scales(system)), rows, regular),
        "forward_dynamics_reactions": SecondPath(
            dense, _wrenches(system, effects), tuple(_scales(system)), rows, regular
        ),
    }


def _dense(system: System, effects: Sequence[Effect]) -> Function:
    """Mass matrix, forces, closure Jacobian and its bias for the tree's rates v."""
    acting, drives = driven(system, effects)
    n, m = len(system.tree.v), len(system.jacobian)
    force = [-value for value in generalised_forces(system, acting, [system.tape.zero] * n)]
    matrix, columns = mass_matrix(system, acting.added_inertia), jacobian_in_v(system)
    still = system.bias(system.rates([system.tape.zero] * n))
    outputs = [
        (_plain("inertia", n * n), [matrix[i][j] for j in range(n) for i in range(n)]),
        (_plain("load", n), force),
        (_plain("closure", n * m), [entry for column in columns for entry in column]),
        (_plain("curvature", m), still),
    ]
    inputs = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), *drives, *acting.inputs]
    return function(system, "dense", "What the second path solves.", inputs=inputs, outputs=outputs)


def _wrenches(system: System, effects: Sequence[Effect]) -> Function:
    """Reactions for given accelerations and multipliers, and the same without units at the joints' points."""
    equations = Equations(system, effects)
    acting, drives = driven(system, effects)
    u = Solved(acting, drives, [], [], ()).forces
    setting, tape = equations.setting, system.tape
    labels = list(setting.multipliers())
    units = ["N" if row.unit == "N" else "N m" for cut in system.cuts for row in cut.rows]
    symbols = [tape.symbol(f"multiplier_{i}", unit, f"multiplier {i + 1}") for i, unit in enumerate(units)]
    known = {label: {ONE: symbol} for label, symbol in zip(labels, symbols, strict=True)}
    found = joint_wrenches(
        setting,
        system.pose,
        wrench=equations.inertial_wrenches(equations.forces.inertia),
        loads=equations.forces.loads,
        multipliers=known,
        u=u,
    )
    at_points = {joint.joint: joint.columns.get(ONE, (ZERO, ZERO)) for joint in found}
    absolute = {joint.joint: at_origin(joint.pose, *at_points[joint.joint]) for joint in found}
    shorter = tape.constant(1.0 / system.length)
    about = {joint.joint: about_point(system, joint, *at_points[joint.joint]) for joint in found}
    sized = {name: (force, scale(shorter, moment)) for name, (force, moment) in about.items()}
    inputs = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), *drives, *acting.inputs]
    further = [(a_port(system), system.inputs.a), (_plain("multipliers", len(symbols)), symbols)]
    count = 6 * len(system.mechanism.joints)
    outputs = [(reactions_port(system), in_order(system, absolute)), (_plain("sized", count), in_order(system, sized))]
    text = "Reactions for given accelerations and multipliers."
    return function(system, "wrenches", text, inputs=inputs, outputs=outputs, further=further)


def _plain(name: str, size: int) -> Port:
    return Port(name, (size,), ("1",) * size, (), name)


def _forward_dynamics(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    found = solved(system, effects, loops)
    text = "Accelerations of the tree from a consistent state and the drives."
    every = guarded((*loops.elimination.guards, *found.guards), SWITCH if system.cuts else THRESHOLD)
    return function(
        system,
        "forward_dynamics",
        text,
        inputs=_inputs(system, found),
        outputs=[(a_port(system), found.a)],
        guards=every,
    )


def _inputs(system: System, found: Solved) -> State:
    state = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)]
    return [*state, *found.drives, *found.acting.inputs]


def _with_reactions(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    """Accelerations first, then the equilibrium of all links with the drives put in."""
    found = solved(system, effects, loops)
    at = system.at(system.inputs.q, {}, system.inputs.v, found.a)
    equations = Equations(at, effects, found.loads, given=found.forces)
    port, values, more, notes = all_reactions(equations, found.forces)
    text = (
        "Accelerations of the tree and all joint reactions, at O in absolute axes, from a consistent state and drives."
    )
    guards = (*loops.elimination.guards, *found.guards, *equations.balance.guards, *more)
    every = guarded(guards, SWITCH if system.cuts else THRESHOLD)
    outputs: list[tuple[Port, Sequence[object]]] = [(a_port(system), found.a), (port, values)]
    return function(
        system,
        "forward_dynamics_reactions",
        text,
        inputs=_inputs(system, found),
        outputs=outputs,
        guards=every,
        notes=notes,
    )


def _from_independent(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    """Second rates of the independent coordinates from their rates and the drives."""
    y_dot = loops.inputs("ydot")
    w = loops.rates_from(y_dot)
    moving = system.at(system.inputs.q, {}, system.tree_rates(w))
    found = solved(moving, effects, loops)
    y_ddot = loops.second_rates(found.free, system.joint_rates(found.a), w)
    state = [(q_port(system), system.inputs.q), (y_port(loops, "y_dot", 1), y_dot)]
    inputs = [*state, *found.drives, *found.acting.inputs]
    text = "Second rates of the independent coordinates from the configuration, their rates and the drives."
    every = guarded((*loops.guards, *found.guards))
    output = [(y_port(loops, "y_ddot", 2), y_ddot)]
    return function(system, "forward_dynamics_independent", text, inputs=inputs, outputs=output, guards=every)


def _scales(system: System) -> list[float]:
    return [float(scale) for scale in system.scales]


def _close_position(system: System, loops: Loops) -> Function:
    """A Newton step back onto the closure, as short as possible (lengths divided by the characteristic length)."""
    tape = system.tape
    admissible = Admissible(system, loops)
    particular = loops.dependent([-g for g in system.residual], [tape.zero] * len(loops.free))
    along, guards = admissible.nearest(particular, _scales(system))
    step = [p - n for p, n in zip(particular, along, strict=True)]
    single = Port("residual", (1,), ("1",), ("residual",), "opening of the loops at q, without units")
    return function(
        system,
        "close_position",
        "The shortest Newton step onto the closure: q_next closes the loops to second order in their opening at q.",
        inputs=[(q_port(system), system.inputs.q)],
        outputs=[(q_port(system, "q_next"), moved_by(system, step)), (single, [opening(system)])],
        guards=guarded((*loops.elimination.guards, *guards)),
    )


def _close_velocity(system: System, loops: Loops) -> Function:
    """The nearest rates that keep the loops closed."""
    w = system.joint_rates(system.inputs.v)
    closed, guards = Admissible(system, loops).nearest(w, _scales(system))
    return function(
        system,
        "close_velocity",
        "The consistent rates nearest to v (lengths divided by the characteristic length).",
        inputs=[(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)],
        outputs=[(v_port(system, "v_next", "consistent rates of the tree"), system.tree_rates(closed))],
        guards=guarded((*loops.elimination.guards, *guards)),
    )

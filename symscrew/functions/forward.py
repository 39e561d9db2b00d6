"""Forward dynamics: accelerations, and with them all reactions, from configuration, rates and drives."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.admissible import Admissible
from symscrew.effects import Acting, Effect
from symscrew.functions.closure import guarded, moved_by, opening
from symscrew.functions.dynamics import Equations, all_reactions
from symscrew.functions.ports import a_port, function, q_port, u_port, v_port, y_port
from symscrew.loops import Loops
from symscrew.program import Function, Port
from symscrew.system import System
from symscrew.tape import Node

State = list[tuple[Port, Sequence[Node]]]


def forward_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """Forward dynamics from the tree and from the independent coordinates, and projections onto the closure."""
    functions = [
        _forward_dynamics(system, effects, loops),
        _from_independent(system, effects, loops),
        _with_reactions(system, effects, loops),
    ]
    if system.cuts:
        functions += [_close_position(system, loops), _close_velocity(system, loops)]
    return functions


def driven(system: System, effects: Sequence[Effect]) -> tuple[Acting, State]:
    """What acts, drives included, and the drives' input."""
    acting = Acting(system, effects)
    port = u_port(system)
    nodes = tuple(
        system.tape.symbol(f"u_{label.replace('.', '_')}", unit, f"drive of {label}")
        for label, unit in zip(port.labels, port.units, strict=True)
    )
    for (joint, freedom), node in zip(system.drives, nodes, strict=True):
        acting.drive(joint, freedom, node)
    return acting, [(port, nodes)] if nodes else []


def _forward_dynamics(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    acting, drives = driven(system, effects)
    _, a, guards = Admissible(system, loops).accelerations(acting)
    inputs = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), *drives, *acting.inputs]
    text = "Accelerations of the tree from a consistent state and the drives."
    every = guarded((*loops.guards, *guards))
    return function(system, "forward_dynamics", text, inputs, [(a_port(system), a)], every)


def _with_reactions(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    """Accelerations first, then the equilibrium of all links with the drives put in."""
    acting, drives = driven(system, effects)
    _, a, guards = Admissible(system, loops).accelerations(acting)
    equations = Equations(system.at(system.inputs.q, {}, system.inputs.v, a), effects)
    u = drives[0][1] if drives else ()
    port, values, more, notes = all_reactions(equations, u)
    inputs = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), *drives, *acting.inputs]
    text = (
        "Accelerations of the tree and all joint reactions, at O in absolute axes, from a consistent state and drives."
    )
    every = guarded((*loops.guards, *guards, *equations.balance.guards, *more))
    outputs: list[tuple[Port, Sequence[object]]] = [(a_port(system), a), (port, values)]
    return function(system, "forward_dynamics_reactions", text, inputs, outputs, every, notes)


def _from_independent(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    """Second rates of the independent coordinates from their rates and the drives."""
    y_dot = loops.inputs("ydot")
    w = loops.rates_from(y_dot)
    moving = system.at(system.inputs.q, {}, system.tree_rates(w))
    acting, drives = driven(moving, effects)
    free, a, guards = Admissible(moving, loops).accelerations(acting)
    y_ddot = loops.second_rates(free, system.joint_rates(a), w)
    inputs = [(q_port(system), system.inputs.q), (y_port(loops, "y_dot", 1), y_dot), *drives, *acting.inputs]
    text = "Second rates of the independent coordinates from the configuration, their rates and the drives."
    every = guarded((*loops.guards, *guards))
    output = [(y_port(loops, "y_ddot", 2), y_ddot)]
    return function(system, "forward_dynamics_independent", text, inputs, output, every)


def _scales(system: System) -> list[float]:
    return [system.length if c.kind == "length" else 1.0 for c in system.tree.v]


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
        [(q_port(system), system.inputs.q)],
        [(q_port(system, "q_next"), moved_by(system, step)), (single, [opening(system)])],
        guarded((*loops.guards, *guards)),
    )


def _close_velocity(system: System, loops: Loops) -> Function:
    """The nearest rates that keep the loops closed."""
    w = system.joint_rates(system.inputs.v)
    closed, guards = Admissible(system, loops).nearest(w, _scales(system))
    return function(
        system,
        "close_velocity",
        "The consistent rates nearest to v (lengths divided by the characteristic length).",
        [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)],
        [(v_port(system, "v_next", "consistent rates of the tree"), system.tree_rates(closed))],
        guarded((*loops.guards, *guards)),
    )

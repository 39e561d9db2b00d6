"""Functions of the platform's own motion, where its limbs have closed forms: inverse kinematics and dynamics."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.closure import closure_rate
from symscrew.effects import Effect
from symscrew.elimination import Elimination, eliminate
from symscrew.functions.closure import guarded
from symscrew.functions.dynamics import Equations
from symscrew.functions.ports import a_port, function, q_port, v_port
from symscrew.limb_solutions import closed_limbs, hub_links, limb_coordinates
from symscrew.program import Function, Port
from symscrew.system import System
from symscrew.tape import Node


def platform_functions(system: System, effects: Sequence[Effect]) -> list[Function]:
    """`inverse_kinematics`, `inverse_velocity`, `inverse_dynamics_platform`; none without closed forms."""
    limbs, hub = closed_limbs(system), hub_links(system)
    if limbs is None or hub is None:
        return []
    q_at = [k for link in hub for k in range(link.q.start, link.q.stop)]
    v_at = [k for link in hub for k in range(link.v.start, link.v.stop)]
    pose = _part(q_port(system), "pose", q_at, "coordinates of the platform's joint, consistent")
    rate = _part(v_port(system), "rate", v_at, "rates of the platform's joint, consistent")
    gain = _part(a_port(system), "gain", v_at, "accelerations of the platform's joint, consistent")
    q_in, v_in, a_in = (
        [nodes[k] for k in at]
        for nodes, at in ((system.inputs.q, q_at), (system.inputs.v, v_at), (system.inputs.a, v_at))
    )
    found = limb_coordinates(system, limbs, dict(zip(q_at, q_in, strict=True)))
    placed = system.at(found.q, found.turns)
    solver, guards = _limb_elimination(placed, set(v_at))
    hub_v = {k: system.inputs.v[k] for k in v_at}
    hub_a = {k: system.inputs.a[k] for k in v_at}
    alone = system.at(found.q, found.turns, _filled(system, hub_v))
    opening = [value for cut in alone.cuts for value in closure_rate(cut, alone.tree, alone.placed, alone.twist)]
    v = _all_rates(placed, solver, hub_v, opening)
    moving = system.at(found.q, found.turns, v)
    a = _all_rates(placed, solver, hub_a, moving.bias(moving.rates(_filled(system, hub_a))))
    result = [
        function(
            system,
            "inverse_kinematics",
            "Configuration of the tree from the platform's own coordinates, limbs in closed form.",
            [(pose, q_in)],
            [(q_port(system), found.q)],
        ),
        function(
            system,
            "inverse_velocity",
            "Rates of the tree from the platform's own, limbs in closed form.",
            [(pose, q_in), (rate, v_in)],
            [(v_port(system), v)],
            guards,
        ),
    ]
    if system.drives:
        equations = Equations(system.at(found.q, found.turns, v, a), effects)
        inputs = [(pose, q_in), (rate, v_in), (gain, a_in), *equations.forces.inputs]
        every = [*guards, *guarded(equations.lean_guards)]
        text = "Drives from the platform's own coordinates, rates and accelerations, limbs in closed form."
        output = [equations.command(equations.lean_solution)]
        result.append(function(system, "inverse_dynamics_platform", text, inputs, output, every, equations.notes))
    return result


def _part(port: Port, name: str, entries: Sequence[int], description: str) -> Port:
    """A port with some entries of another."""
    units, labels = (tuple(values[k] for k in entries) for values in (port.units, port.labels))
    return Port(name, (len(entries),), units, labels, description)


def _limb_elimination(system: System, hub: set[int]) -> tuple[Elimination, list[tuple[Node, float]]]:
    """The closure solved for the limbs' rates, the platform's being given."""
    unknowns = {k: system.length if c.kind == "length" else 1.0 for k, c in enumerate(system.tree.v) if k not in hub}
    scales = [1.0 / system.length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows]
    solver = eliminate(system.tape, system.jacobian, unknowns, scales)
    return solver, guarded(solver.guards)


def _filled(system: System, hub: dict[int, Node]) -> list[Node]:
    """v (or a) with the platform's entries and zeros for the limbs."""
    return [hub.get(k, system.tape.zero) for k in range(len(system.tree.v))]


def _all_rates(system: System, solver: Elimination, hub: dict[int, Node], opening: Sequence[Node]) -> list[Node]:
    """v (or a) of the whole tree: the limbs take back how the platform alone would open the loops."""
    solution = solver.solve([-value for value in opening])
    return [hub[k] if k in hub else solution.get(k, system.tape.zero) for k in range(len(system.tree.v))]

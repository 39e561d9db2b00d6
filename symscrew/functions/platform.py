"""Functions of the platform's own motion, where its limbs have closed forms: inverse kinematics and dynamics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace
from types import MappingProxyType

from symscrew.algebra import Elimination, Node, divides, eliminate, named_entries, needed
from symscrew.effects import Effect
from symscrew.functions.checked import SUFFIX, motion_size
from symscrew.functions.closing import closed, guarded
from symscrew.functions.dynamic import Equations
from symscrew.functions.ports import a_port, function, q_port, u_port, v_port
from symscrew.kinematics import Row, System, Turn, cut_displacement, tree_displacement
from symscrew.loops import (
    CrankLimb,
    LengthRow,
    LimbForm,
    Loops,
    closed_limbs,
    hub_links,
    length_rows,
    limb_coordinates,
    met_rows,
    reference_nodes,
)
from symscrew.program import OUT_OF_REACH, Function, NodeLimit, Port, roots_of


def platform_functions(
    system: System, effects: Sequence[Effect], loops: Loops, *, checked: bool = False
) -> list[Function]:
    """`inverse_kinematics`, `drive_positions`, `inverse_velocity`, `inverse_dynamics_platform`; only by closed forms.

    The pose is always looked at. `checked`: also variants of the others that look at rates and accelerations.
    """
    limbs, hub = closed_limbs(system), hub_links(system)
    if limbs is None or hub is None:
        return []
    q_at = [k for link in hub for k in range(link.q.start, link.q.stop)]
    v_at = [k for link in hub for k in range(link.v.start, link.v.stop)]
    pose = _part(q_port(system), "pose", q_at, "coordinates of the platform's joint, consistent")
    rate = _part(v_port(system), "rate", v_at, "rates of the platform's joint, consistent")
    gain = _part(a_port(system), "acceleration", v_at, "accelerations of the platform's joint, consistent")
    q_in, v_in, a_in = (
        [nodes[k] for k in at]
        for nodes, at in ((system.inputs.q, q_at), (system.inputs.v, v_at), (system.inputs.a, v_at))
    )
    found = limb_coordinates(system, limbs, dict(zip(q_at, q_in, strict=True)))
    placed = system.at(found.q, found.turns)
    cranks = [limb for limb in limbs if isinstance(limb, CrankLimb)]
    choices = [(), length_rows(placed, cranks, reference_nodes(system))] if cranks else [()]
    hub_v, hub_a = ({k: nodes[k] for k in v_at} for nodes in (system.inputs.v, system.inputs.a))
    ways = [
        _motion(placed, found.turns, hub[-1].index, hub_v=hub_v, hub_a=hub_a, lengths=lengths) for lengths in choices
    ]
    shortest = min(ways, key=lambda way: loops.cost([*way.v, *(pivot for pivot, _ in way.guards)]))
    result = [
        function(
            system,
            "inverse_kinematics",
            "Configuration of the tree from the platform's own coordinates, limbs in closed form.",
            inputs=[(pose, q_in)],
            outputs=[(q_port(system), found.q)],
        ),
        *_drive_positions(placed, (pose, q_in)),
        function(
            system,
            "inverse_velocity",
            "Rates of the tree from the platform's own, limbs in closed form.",
            inputs=[(pose, q_in), (rate, v_in)],
            outputs=[(v_port(system), shortest.v)],
            guards=shortest.guards,
        ),
    ]
    if system.drives:
        inputs = [(pose, q_in), (rate, v_in), (gain, a_in)]
        dynamics = [
            _drives(
                Equations(system.at(found.q, found.turns, way.v, way.a), effects, cost=loops.cost), inputs, way.guards
            )
            for way in ways
        ]
        result.append(min(dynamics, key=lambda way: loops.cost(roots_of(way))))
    rows = left_open(placed, limbs, found.openings)
    result = _limited(result, found.reach, closed(system, rows))
    moving = placed.at(found.q, found.turns, shortest.v, shortest.a)
    moves = [f for f in result if any(port.name == "rate" for port in f.inputs)]
    return [*result, *(_looking(f, moving, rows, second=len(f.inputs) > 2) for f in moves if checked)]


def _drive_positions(placed: System, pose: tuple[Port, list[Node]]) -> list[Function]:
    """What the motors are to be at for a pose: their coordinates alone, in the order of the drives."""
    values = []
    for joint, freedom in placed.drives:
        if joint in placed.tree.joints:
            values.append(tree_displacement(placed, placed.mechanism.joints[joint])[freedom])
        else:
            cut = next(cut for cut in placed.cuts if cut.joint.name == joint)
            values.append(cut_displacement(placed, cut)[freedom])
    if not values:
        return []
    force = u_port(placed)
    units = tuple("m" if unit == "N" else "rad" for unit in force.units)
    port = Port("positions", force.shape, units, force.labels, "coordinates of the driven freedoms")
    text = "Coordinates of the drives from the platform's own, limbs in closed form."
    return [function(placed, "drive_positions", text, inputs=[pose], outputs=[(port, values)])]


def _limited(
    functions: Sequence[Function], reach: Sequence[tuple[str, Node]], on_mechanism: Sequence[NodeLimit]
) -> list[Function]:
    """The functions for poses within reach of all limbs and on the mechanism."""
    names = tuple(dict.fromkeys(name for name, _ in reach))
    within = [(radicand, 0.0, None, OUT_OF_REACH + names.index(name)) for name, radicand in reach]
    return [replace(f, limits=(*f.limits, *within, *on_mechanism), reach=names) for f in functions]


def _looking(function: Function, moving: System, rows: Sequence[tuple[Node, Row]], *, second: bool = False) -> Function:
    """The variant that looks whether a motion keeps the loops closed, to first order or to second, too."""
    kept = {row.label for _, row in rows}
    every = [row for cut in moving.cuts for row in cut.rows]
    limits = closed(moving, _of(moving.opening_rates, every, kept), motion_size(moving))
    if second:
        openings = moving.bias(moving.rates(moving.inputs.a), moving.inputs.a)
        limits += closed(moving, _of(openings, every, kept), motion_size(moving, second=True))
    return replace(function, name=function.name + SUFFIX, limits=(*function.limits, *limits))


def _of(values: Sequence[Node], rows: Sequence[Row], kept: Set[str]) -> list[tuple[Node, Row]]:
    """How fast the rows that are left open."""
    return [(value, row) for value, row in zip(values, rows, strict=True) if row.label in kept]


def left_open(
    placed: System, limbs: Sequence[LimbForm], known: Mapping[str, Node] = MappingProxyType({})
) -> list[tuple[Node, Row]]:
    """How far the loops are open in rows that do not hold for all poses of the platform; its limbs are placed.

    `known`: by label, what limbs know of their rows themselves.
    """
    met = met_rows(limbs)
    rows = [row for cut in placed.cuts for row in cut.rows]
    values = zip(rows, placed.residual, strict=True)
    return [(known.get(row.label, value), row) for row, value in values if row.label not in met]


@dataclass(frozen=True)
class _Motion:
    """Rates and accelerations of the tree, and the guarded pivots of the closure."""

    v: Sequence[Node]
    a: Sequence[Node]
    guards: list[tuple[Node, float]]


def _motion(
    placed: System,
    turns: dict[int, Turn],
    hub: int,
    *,
    hub_v: dict[int, Node],
    hub_a: dict[int, Node],
    lengths: Sequence[LengthRow],
) -> _Motion:
    """v and a of the tree from those of the platform, link `hub`, with rows of rods' lengths in place of others."""
    solver, guards = _limb_elimination(placed, set(hub_v), lengths)
    alone = placed.at(placed.inputs.q, turns, _filled(placed, hub_v))
    opening = alone.opening_rates
    for row in lengths:
        opening[row.index] = row.opening(alone)
    v = _all_rates(placed, solver, hub_v, opening)
    moving = placed.at(placed.inputs.q, turns, v)
    rates = moving.rates(_filled(placed, hub_a))
    bias = moving.bias(rates, _filled(placed, hub_a))
    for row in lengths:
        bias[row.index] = row.bias(moving, rates[hub])
    return _Motion(v, _all_rates(placed, solver, hub_a, bias), guards)


def _drives(
    equations: Equations, inputs: list[tuple[Port, list[Node]]], guards: Sequence[tuple[Node, float]]
) -> Function:
    """`inverse_dynamics_platform` of a system that moves as the platform asks."""
    port, drives = equations.command(equations.lean_solution)
    used = needed(drives)  # thin rods' own rates are not
    every = [*(guard for guard in guards if divides(guard[0], used)), *guarded(equations.lean_guards)]
    text = "Drives from the platform's own coordinates, rates and accelerations, limbs in closed form."
    ports = [*inputs, *equations.forces.inputs]
    return function(
        equations.system,
        "inverse_dynamics_platform",
        text,
        inputs=ports,
        outputs=[(port, drives)],
        guards=every,
        notes=equations.notes,
    )


def _part(port: Port, name: str, entries: Sequence[int], description: str) -> Port:
    """A port with some entries of another."""
    units, labels = (tuple(values[k] for k in entries) for values in (port.units, port.labels))
    return Port(name, (len(entries),), units, labels, description, tuple(port.forms[k] for k in entries if port.forms))


def _limb_elimination(
    system: System, hub: set[int], lengths: Sequence[LengthRow]
) -> tuple[Elimination, list[tuple[Node, float]]]:
    """The closure solved for the limbs' rates, the platform's being given."""
    unknowns = {k: float(scale) for k, scale in enumerate(system.scales) if k not in hub}
    scales = [1.0 / system.length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows]
    rows = list(system.jacobian)
    for row in lengths:
        rows[row.index], scales[row.index] = {row.column: row.entry}, scales[row.index] / system.length
    solver = eliminate(system.tape, rows, unknowns, scales)
    for _, column, pivot, _ in solver.steps:
        named_entries([pivot], "pivot", [system.tree.v[column].label])
    return solver, guarded(solver.guards)


def _filled(system: System, hub: dict[int, Node]) -> list[Node]:
    """v (or a) with the platform's entries and zeros for the limbs."""
    return [hub.get(k, system.tape.zero) for k in range(len(system.tree.v))]


def _all_rates(system: System, solver: Elimination, hub: dict[int, Node], opening: Sequence[Node]) -> list[Node]:
    """v (or a) of the whole tree: the limbs take back how the platform alone would open the loops."""
    solution = solver.solve([-value for value in opening])
    return [hub[k] if k in hub else solution.get(k, system.tape.zero) for k in range(len(system.tree.v))]

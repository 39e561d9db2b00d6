"""Derivatives of the dynamic functions: along the tree, along the independent directions, by the parameters.

The program of a function is differentiated (`symscrew.algebra.differentiation`); here is what it is differentiated
along. A configuration changes along the directions of v, never along the four components of a quaternion:
column k of `d.../dq` is the derivative for dq = v_k dt, for a spherical joint a rotation vector in the child's
axes. Along the independent coordinates the whole tree moves on the closure manifold, dq = null_space dy, and
with it the null space, the rates and the accelerations: the columns are the derivatives of the function
(y, y_dot, y_ddot) -> u, not the tree's columns projected.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from symscrew.algebra import Node, Tape, Vector, add, cost, cross, differentiate, dot, scale, substitute
from symscrew.dynamics import Admissible
from symscrew.effects import Acting, Effect
from symscrew.functions import closed_derivative, tree_derivative
from symscrew.functions.closing import guarded
from symscrew.functions.forward import driven
from symscrew.kinematics import System, squared_length
from symscrew.loops import Loops
from symscrew.program import Function, Port

Seeds = dict[Node, dict[str, Node]]
TREE_TEXT = "spherical joints: per rotation vector in the child's axes"
LOSING = 2e-5
"""Pivots of the closure below this, without units, fail: derivatives lose the square of it, ten digits at least."""


@dataclass(frozen=True)
class Directions:
    """A group of directions: name of what changes, label and unit of each, and how nodes change along them.

    Attributes:
        name: what the derivative is taken by, as in du_d<name>.
        labels: one per direction.
        units: units of the steps.
        seeds: node -> {direction: derivative}; directions are `<name>|<label>`.
        text: what a step is, for the port.
    """

    name: str
    labels: tuple[str, ...]
    units: tuple[str, ...]
    seeds: Seeds = field(repr=False)
    text: str = ""

    @property
    def keys(self) -> tuple[str, ...]:
        """The directions."""
        return tuple(f"{self.name}|{label}" for label in self.labels)


def derivative_functions(
    system: System, effects: Sequence[Effect], loops: Loops, functions: Sequence[Function]
) -> list[Function]:
    """Derivatives of inverse and forward dynamics, of the tree and along the independent coordinates."""
    found = {f.name: f for f in functions}
    closed = guarded(loops.guards, LOSING)
    lean = closed_derivative.covers(system, Acting(system, effects))
    result = []
    for name in ("inverse_dynamics", "inverse_dynamics_independent"):
        independent = name.endswith("independent")
        if name in found and (loops.free or not independent):  # where nothing moves, there is no direction
            groups = _groups(system, loops, found[name], independent=independent)
            text = "along the independent coordinates, all loops held closed" if independent else _tree_text(system)
            text = f"Derivatives of the drives {text}."
            known = closed_derivative.inverse_derivatives(system, effects, loops) if independent and lean else None
            if known is not None:
                result.append(_given(found[name], f"{name}_derivatives", groups, text=text, known=known, guards=closed))
                continue
            guards = closed if independent else ()
            straight = differentiated(found[name], f"{name}_derivatives", groups, text, guards=guards)
            result.append(min(straight, _of_tree(system, effects, loops, straight=straight, groups=groups), key=_size))
    result += forward_derivatives(system, effects, loops, found)
    if system.parameters:
        result += _by_parameters(system, loops, found)
    return result


def _tree_text(system: System) -> str:
    text = "along the tree"
    if system.cuts:
        text += (
            ". The loops are not held closed: only columns combined along consistent changes of (q, v, a) have a "
            "meaning of their own; see inverse_dynamics_independent_derivatives"
        )
    return text


def _of_tree(
    system: System, effects: Sequence[Effect], loops: Loops, *, straight: Function, groups: Sequence[Directions]
) -> Function:
    """The derivatives of inverse dynamics from the equations of motion where no loop closes, else as they are."""
    v, a = system.inputs.v, system.inputs.a
    if groups[0].name == "y":
        v, a = (tuple(system.tree_rates(loops.rates_from(loops.inputs(x)))) for x in ("ydot", "yddot"))
    acting = Acting(system.at(system.inputs.q, {}, v, a), effects)
    drives = system.drive_rows()
    turning = any(k in drives for _, first in system.tree.spheres for k in range(first, first + 3))
    if turning or loops.small.steps or not tree_derivative.covers(acting):
        return straight
    rows = sorted(drives, key=drives.__getitem__)
    found = iter(_force_changes(loops, acting, a, groups))
    return replace(
        straight, results=tuple(tuple(c[k] for c in [next(found) for _ in g.keys] for k in rows) for g in groups)
    )


def _force_changes(loops: Loops, acting: Acting, a: Sequence[Node], groups: Sequence[Directions]) -> list[list[Node]]:
    """Changes of the generalised forces (for v) of a tree along all directions."""
    system = acting.system
    steps = null_space(system, loops) if groups[0].name == "y" else _units(system.tape, len(a))
    keys = [key for group in groups for key in group.keys]
    return tree_derivative.force_changes(acting, a, directions=keys, steps=steps, seeds=merged(groups))


def _groups(system: System, loops: Loops, function: Function, *, independent: bool) -> list[Directions]:
    """The configuration, then every further input of the function's own state (not loads, not parameters)."""
    first = independent_directions(system, loops) if independent else tree_directions(system)
    state = ("v", "a", "y_dot", "y_ddot", "u")
    inputs = zip(function.inputs, function.arguments, strict=True)
    return [first, *(plain_directions(p.name, p, nodes) for p, nodes in inputs if p.name in state)]


def _by_parameters(system: System, loops: Loops, found: Mapping[str, Function]) -> list[Function]:
    """Derivatives by the run-time parameters: of the tree at a fixed state, else at fixed y and its rates."""
    result = []
    for name in ("inverse_dynamics", "inverse_dynamics_independent", "forward_dynamics_independent"):
        if name not in found:
            continue
        independent = name.endswith("independent")
        group = closed_parameter_directions(system, loops) if independent else parameter_directions(system)
        fixed = "independent coordinates and rates, all loops held closed" if independent else "state of the tree"
        text = f"Derivatives by the run-time parameters at fixed {fixed}."
        guards = guarded(loops.guards, LOSING) if independent else ()
        result.append(differentiated(found[name], f"{name}_parameters", [group], text, guards=guards))
    return result


def forward_derivatives(
    system: System, effects: Sequence[Effect], loops: Loops, found: Mapping[str, Function]
) -> list[Function]:
    """Derivatives of forward dynamics and the linearisation; of the tree only where nothing closes it."""
    result = []
    if not system.cuts and "forward_dynamics" in found:
        function = found["forward_dynamics"]
        groups = _groups(system, loops, function, independent=False)
        straight = differentiated(function, "forward_dynamics_derivatives", groups, "Derivatives of the accelerations.")
        implicit = _implicit(system, effects, loops, straight=straight, groups=groups, independent=False)
        result.append(min(straight, implicit, key=_size))
    if "forward_dynamics_independent" in found and loops.free:
        function = found["forward_dynamics_independent"]
        groups = _groups(system, loops, function, independent=True)
        text = "Derivatives of the second rates of the independent coordinates, all loops held closed."
        guards = guarded(loops.guards, LOSING)
        if closed_derivative.covers(system, Acting(system, effects)):
            name, known = "forward_dynamics_independent_derivatives", closed_derivative.forward_derivatives
            lean = _given(function, name, groups, text=text, known=known(system, effects, loops), guards=guards)
            return [*result, lean, _linearisation(system, loops, lean)]
        straight = differentiated(function, "forward_dynamics_independent_derivatives", groups, text, guards=guards)
        implicit = _implicit(system, effects, loops, straight=straight, groups=groups, independent=True)
        chosen = min(straight, implicit, key=_size)
        result += [chosen, _linearisation(system, loops, chosen)]
    return result


def _size(function: Function) -> int:
    return cost([n for nodes in function.results for n in nodes])


def _implicit(
    system: System,
    effects: Sequence[Effect],
    loops: Loops,
    *,
    straight: Function,
    groups: Sequence[Directions],
    independent: bool,
) -> Function:
    """The same derivatives from the equations of motion instead of their solution.

    With z' the free joint accelerations that solve r(q, v, z', u) = N^T (generalised forces) = 0, all else held,
    N^T M N dz' = -dr: inverse dynamics is differentiated, not the mass matrix and its factors.
    """
    tape = system.tape
    w = loops.rates_from(loops.inputs("ydot")) if independent else system.joint_rates(system.inputs.v)
    moving = system.at(system.inputs.q, {}, system.tree_rates(w))
    acting, _ = driven(moving, effects)
    if acting.needs_reactions:  # the forces depend on the solution: no equations without it
        return straight
    admissible = Admissible(moving, loops, acting.added_inertia)
    free, _, _ = admissible.accelerations(acting)
    held = [tape.symbol(f"held_{k}", "1", f"free joint acceleration {k + 1}, held") for k in range(len(free))]
    a = system.tree_rates(admissible.moved(admissible.curvature(), held))
    changes = [column for group in _columns(admissible.residual(a, acting), groups) for column in group]
    if tree_derivative.covers(acting):
        forces = _force_changes(loops, acting, a, groups)
        others = [[closed_derivative.inner(w, column) for w in admissible.tree_columns] for column in forces]
        changes = min(changes, others, key=lambda columns: cost([n for column in columns for n in column]))
    put = dict(zip(held, free, strict=True))
    solved = [admissible.solve([-c for c in substitute(tape, column, put)])[0] for column in changes]
    values = loops.second_rates(held, system.joint_rates(a), w) if independent else a
    keys = [key for group in groups for key in group.keys]
    seeds = merged(groups)
    for k, node in enumerate(held):
        seeds[node] = {key: column[k] for key, column in zip(keys, solved, strict=True)}
    rows = [substitute(tape, row, put) for row in differentiate(tape, values, seeds, keys)]
    results, start = [], 0
    for group in groups:
        end = start + len(group.keys)
        results.append(tuple(row[k] for k in range(start, end) for row in rows))
        start = end
    return replace(straight, results=tuple(results))


def _linearisation(system: System, loops: Loops, derivatives: Function) -> Function:
    """A and B of x = (y, y_dot), d(x_dot) = A dx + B du, from the derivatives of forward dynamics."""
    tape, n = system.tape, len(loops.entries)
    zero, one = tape.zero, tape.one
    by_y, by_rate = derivatives.results[:2]
    state, units = _state(system, loops)
    top = [[one if j == n + i else zero for j in range(2 * n)] for i in range(n)]
    bottom = [[(by_y if j < n else by_rate)[(j % n) * n + i] for j in range(2 * n)] for i in range(n)]
    rows = [*top, *bottom]
    outputs = [
        Port(
            "A",
            (2 * n, 2 * n),
            tuple(f"({a}/s)/({b})" if a != b else "1/s" for b in units for a in units),
            tuple(f"{a}|{b}" for b in state for a in state),
            "d(x_dot)/dx of the state x = (y, y_dot)",
        )
    ]
    results = [tuple(rows[i][j] for j in range(2 * n) for i in range(2 * n))]
    if len(derivatives.outputs) > 2:
        by_u, labels = derivatives.outputs[2], [c.split("|", 1)[1] for c in derivatives.outputs[2].labels[::n]]
        count = by_u.shape[1]
        b_units = tuple(u for k in range(count) for u in (*("0",) * n, *by_u.units[k * n : (k + 1) * n]))
        names = tuple(f"{a}|{b}" for b in labels for a in state)
        outputs.append(Port("B", (2 * n, count), b_units, names, "d(x_dot)/du, u the drives"))
        values = derivatives.results[2]
        results.append(tuple(v for k in range(count) for v in (*(zero,) * n, *values[k * n : (k + 1) * n])))
    text = "Linearisation of the motion about a state: d(x_dot) = A dx + B du, x = (y, y_dot)."
    return replace(derivatives, name="linearisation", description=text, outputs=tuple(outputs), results=tuple(results))


def _state(system: System, loops: Loops) -> tuple[list[str], list[str]]:
    units = [system.tree.q[e.q].unit for e in loops.entries]
    return [*loops.labels, *(f"{label}_dot" for label in loops.labels)], [*units, *(f"{u}/s" for u in units)]


def differentiated(
    function: Function,
    name: str,
    groups: Sequence[Directions],
    text: str,
    *,
    guards: Sequence[tuple[Node, float]] = (),
) -> Function:
    """The derivatives of a function's first output by each group: outputs d<output>_d<group>."""
    port = function.outputs[0]
    columns = _columns(function.results[0], groups)
    outputs = tuple(derivative_port(port, group) for group in groups)
    results = tuple(tuple(n for column in found for n in column) for found in columns)
    return replace(
        function, name=name, description=text, outputs=outputs, results=results, guards=(*function.guards, *guards)
    )


def _given(
    function: Function,
    name: str,
    groups: Sequence[Directions],
    *,
    text: str,
    known: closed_derivative.Derivatives,
    guards: Sequence[tuple[Node, float]],
) -> Function:
    """The derivatives of a function's first output by each group, which are known."""
    outputs = tuple(derivative_port(function.outputs[0], group) for group in groups)
    results = tuple(tuple(node for column in found for node in column) for found in known.groups[: len(groups)])
    every = (*guards, *guarded(known.guards))
    return replace(function, name=name, description=text, outputs=outputs, results=results, guards=every)


def _columns(outputs: Sequence[Node], groups: Sequence[Directions]) -> list[list[list[Node]]]:
    """Per group and direction the derivatives of all outputs."""
    seeds = merged(groups)
    tape = next(iter(seeds)).tape
    keys = [key for group in groups for key in group.keys]
    rows = differentiate(tape, outputs, seeds, keys)
    columns = iter([[row[k] for row in rows] for k in range(len(keys))])
    return [[next(columns) for _ in group.keys] for group in groups]


def merged(groups: Sequence[Directions]) -> Seeds:
    """How nodes change along the directions of all groups."""
    seeds: Seeds = {}
    for group in groups:
        for node, changes in group.seeds.items():
            seeds[node] = {**seeds.get(node, {}), **changes}
    return seeds


def derivative_port(port: Port, group: Directions) -> Port:
    """A matrix output | direction, column-major."""
    units = tuple(quotient(a, b) for b in group.units for a in port.units)
    labels = tuple(f"{a}|{b}" for b in group.labels for a in port.labels)
    text = f"rows: {port.name}; columns: {group.text}"
    return Port(f"d{port.name}_d{group.name}", (port.size, len(group.labels)), units, labels, text)


def quotient(unit: str, by: str) -> str:
    """The unit of a derivative."""
    if by == "1":
        return unit
    numerator = f"({unit})" if "/" in unit or " " in unit else unit
    return f"{numerator}/({by})" if "/" in by or " " in by else f"{numerator}/{by}"


# -- groups of directions ---------------------------------------------------------------------------------------


def plain_directions(name: str, port: Port, nodes: Sequence[Node]) -> Directions:
    """One direction per entry of an input."""
    seeds = {node: {f"{name}|{label}": node.tape.one} for node, label in zip(nodes, port.labels, strict=True)}
    return Directions(name, port.labels, port.units, seeds, port.description)


def tree_directions(system: System) -> Directions:
    """One direction of the configuration per entry of v."""
    tape, tree = system.tape, system.tree
    labels = tuple(c.label for c in tree.v)
    seeds = configuration_seeds(system, "q", labels, _units(tape, len(labels)))
    units = tuple("m" if c.kind == "length" else "rad" for c in tree.v)
    return Directions("q", labels, units, seeds, _text(system))


def _units(tape: Tape, count: int) -> list[list[Node]]:
    return [[tape.one if i == k else tape.zero for i in range(count)] for k in range(count)]


def _text(system: System) -> str:
    return "steps of q along the entries of v" + (f" ({TREE_TEXT})" if system.tree.spheres else "")


def independent_directions(system: System, loops: Loops) -> Directions:
    """One direction per independent coordinate: the whole tree moves with it, q_dot from null_space dy."""
    units = tuple(system.tree.q[e.q].unit for e in loops.entries)
    seeds = configuration_seeds(system, "y", loops.labels, null_space(system, loops))
    return Directions("y", loops.labels, units, seeds, "independent coordinates, the loops held closed")


def null_space(system: System, loops: Loops) -> list[list[Node]]:
    """Columns: v for a unit rate of each independent coordinate."""
    return [system.tree_rates(loops.rates_from(rates)) for rates in _units(system.tape, len(loops.entries))]


def parameter_directions(system: System) -> Directions:
    """One direction per run-time parameter, nothing else changing."""
    (port,), _ = system.parameter_ports()
    return plain_directions("p", port, system.parameters)


def closed_parameter_directions(system: System, loops: Loops) -> Directions:
    """One direction per run-time parameter: the tree follows, y held fixed.

    From the closure, residual(q, p) = 0: J dq = -d residual / dp with dy = 0.
    """
    tape = system.tape
    plain = parameter_directions(system)
    if not system.cuts:
        return plain
    rows = differentiate(tape, system.residual, plain.seeds, plain.keys)
    columns = []
    for k in range(len(plain.labels)):
        zeros = [tape.zero] * len(loops.free)
        particular = loops.dependent([-row[k] for row in rows], zeros)
        columns.append(system.tree_rates(loops.with_rates(particular, zeros)))
    seeds = {**plain.seeds, **configuration_seeds(system, "p", plain.labels, columns)}
    return replace(plain, seeds=seeds, text="run-time parameters, y and its rates fixed, the loops held closed")


def configuration_seeds(system: System, name: str, labels: Sequence[str], columns: Sequence[Sequence[Node]]) -> Seeds:
    """How the entries of q change when the tree moves with the rates v of each column.

    A quaternion (w, r) with the angular velocity v in the child's axes: w_dot = -r . v / 2 and
    r_dot = (w v + r x v) / 2.
    """
    tape, q = system.tape, system.inputs.q
    half = tape.reciprocal(tape.node(2))
    seeds: Seeds = {node: {} for node in q}
    for label, v in zip(labels, columns, strict=True):
        key = f"{name}|{label}"
        for link in system.tree.links[1:]:
            entries, rates = list(q[link.q]), tuple(v[link.v])
            if len(entries) == 4:
                seeds[squared_length(entries)] = {}  # which no motion changes
                w, r = entries[0], (entries[1], entries[2], entries[3])
                turn: Vector = scale(half, (rates[0], rates[1], rates[2]))
                rates = (-dot(r, turn), *add(scale(w, turn), cross(r, turn)))
            for node, rate in zip(entries, rates, strict=True):
                if tape.node(rate) is not tape.zero:
                    seeds[node][key] = tape.node(rate)
    return seeds

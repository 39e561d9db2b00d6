"""Derivatives of the dynamic functions: along the tree, along the independent directions, by the parameters.

The program of a function is differentiated (`symscrew.differentiation`); here is what it is differentiated
along. A configuration changes along the directions of v, never along the four components of a quaternion:
column k of `d.../dq` is the derivative for dq = v_k dt, for a spherical joint a rotation vector in the child's
axes. Along the independent coordinates the whole tree moves on the closure manifold, dq = null_space dy, and
with it the null space, the rates and the accelerations: the columns are the derivatives of the function
(y, y_dot, y_ddot) -> u, not the tree's columns projected.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from symscrew.differentiation import differentiate
from symscrew.functions.closure import guarded
from symscrew.loops import Loops
from symscrew.program import Function, Port
from symscrew.screws import Vector, add, cross, dot, scale
from symscrew.system import System
from symscrew.tape import Node

Seeds = dict[Node, dict[str, Node]]
TREE_TEXT = "spherical joints: per rotation vector in the child's axes"


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


def derivative_functions(system: System, loops: Loops, functions: Sequence[Function]) -> list[Function]:
    """Derivatives of inverse dynamics, of the tree and along the independent coordinates."""
    found = {f.name: f for f in functions}
    result = []
    if "inverse_dynamics" in found:
        result.append(_of_tree(system, found["inverse_dynamics"]))
    if "inverse_dynamics_independent" in found:
        result += _of_independent(system, loops, found["inverse_dynamics_independent"])
    if "inverse_dynamics" in found and system.parameters:
        groups = [parameter_directions(system)]
        text = "Derivatives by the run-time parameters at fixed q, v, a."
        result.append(differentiated(found["inverse_dynamics"], "inverse_dynamics_parameters", groups, text))
    return result


def _of_tree(system: System, function: Function) -> Function:
    groups = [
        tree_directions(system),
        plain_directions("v", function.inputs[1], function.arguments[1]),
        plain_directions("a", function.inputs[2], function.arguments[2]),
    ]
    text = "Derivatives by configuration, rates and accelerations of the tree."
    if system.cuts:
        text += (
            " The loops are not held closed: only combinations of columns along consistent changes of (q, v, a) "
            "have a meaning of their own; see inverse_dynamics_independent_derivatives."
        )
    return differentiated(function, "inverse_dynamics_derivatives", groups, text)


def _of_independent(system: System, loops: Loops, function: Function) -> list[Function]:
    rates = [
        plain_directions("y_dot", function.inputs[1], function.arguments[1]),
        plain_directions("y_ddot", function.inputs[2], function.arguments[2]),
    ]
    groups = [independent_directions(system, loops), *rates]
    text = "Derivatives by the independent coordinates and their rates, all loops held closed."
    result = [
        differentiated(function, "inverse_dynamics_independent_derivatives", groups, text, guards=guarded(loops.guards))
    ]
    if system.parameters:
        text = "Derivatives by the run-time parameters at fixed y, y_dot, y_ddot, all loops held closed."
        result.append(
            differentiated(
                function,
                "inverse_dynamics_independent_parameters",
                [closed_parameter_directions(system, loops)],
                text,
                guards=guarded(loops.guards),
            )
        )
    return result


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


def _columns(outputs: Sequence[Node], groups: Sequence[Directions]) -> list[list[list[Node]]]:
    """Per group and direction the derivatives of all outputs."""
    tape = next(node.tape for group in groups for node in group.seeds)
    seeds: Seeds = {}
    for group in groups:
        for node, changes in group.seeds.items():
            seeds[node] = {**seeds.get(node, {}), **changes}
    keys = [key for group in groups for key in group.keys]
    rows = differentiate(tape, outputs, seeds, keys)
    columns = iter([[row[k] for row in rows] for k in range(len(keys))])
    return [[next(columns) for _ in group.keys] for group in groups]


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
    one = nodes[0].tape.one if nodes else None
    seeds: Seeds = {n: {f"{name}|{label}": one} for n, label in zip(nodes, port.labels, strict=True)}  # type: ignore[dict-item]
    return Directions(name, port.labels, port.units, seeds, port.description)


def tree_directions(system: System) -> Directions:
    """One direction of the configuration per entry of v."""
    tape, tree = system.tape, system.tree
    labels = tuple(c.label for c in tree.v)
    columns = [[tape.one if i == k else tape.zero for i in range(len(labels))] for k in range(len(labels))]
    units = tuple("m" if c.kind == "length" else "rad" for c in tree.v)
    return Directions("q", labels, units, configuration_seeds(system, "q", labels, columns), _text(system))


def _text(system: System) -> str:
    spherical = any(link.motion.kind == "S" for link in system.tree.links[1:])
    return "steps of q along the entries of v" + (f" ({TREE_TEXT})" if spherical else "")


def independent_directions(system: System, loops: Loops) -> Directions:
    """One direction per independent coordinate: the whole tree moves with it, q_dot from null_space dy."""
    units = tuple(system.tree.q[e.q].unit for e in loops.entries)
    seeds = configuration_seeds(system, "y", loops.labels, null_space(system, loops))
    return Directions("y", loops.labels, units, seeds, "independent coordinates, the loops held closed")


def null_space(system: System, loops: Loops) -> list[list[Node]]:
    """Columns: v for a unit rate of each independent coordinate."""
    tape, count = system.tape, len(loops.entries)
    unit = [[tape.one if i == k else tape.zero for i in range(count)] for k in range(count)]
    return [system.tree_rates(loops.rates_from(rates)) for rates in unit]


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
                w, r = entries[0], (entries[1], entries[2], entries[3])
                turn: Vector = scale(half, (rates[0], rates[1], rates[2]))
                rates = (-dot(r, turn), *add(scale(w, turn), cross(r, turn)))
            for node, rate in zip(entries, rates, strict=True):
                if tape.node(rate) is not tape.zero:
                    seeds[node][key] = tape.node(rate)
    return seeds

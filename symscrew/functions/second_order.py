"""Second derivatives of drives, accelerations, closure and margins: products with the Hessian, and the Hessian itself.

With weights w (multipliers of an optimiser) the gradient of w . f along a group of directions comes from the recursion
by one sweep in reverse, its change along a direction by one more sweep forwards: so a product costs a small multiple of
f itself, however many inputs there are. Along the independent coordinates the tree moves on the closure manifold, and
the null space with it: the Hessian is that of the function of (y, y_dot, ...), as an optimiser in y needs it.

A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, sec. 5.1 (second-order adjoints).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from symscrew.algebra import Node, differentiate
from symscrew.functions.closing import guarded
from symscrew.functions.derivative import (
    LOSING,
    Directions,
    independent_directions,
    merged,
    plain_directions,
    quotient,
)
from symscrew.kinematics import System
from symscrew.loops import Loops
from symscrew.program import Function, Port

PRODUCT, HESSIAN = "_hessian_product", "_hessian"
ALONG_Y = (
    "inverse_dynamics_independent", "forward_dynamics_independent", "limb_margins", "constraint_margin",
    "actuation_margins",
)  # fmt: skip
STATE = ("y_dot", "y_ddot", "u")  # inputs beside the configuration that second derivatives are taken by


@dataclass(frozen=True)
class _Weighted:
    """The weighted sum of a function's first output, its gradient along the directions of the groups."""

    function: Function
    weights: tuple[Port, tuple[Node, ...]]
    groups: tuple[Directions, ...]
    gradient: list[Node]
    guards: tuple[tuple[Node, float], ...]

    @property
    def keys(self) -> list[str]:
        """All directions."""
        return [key for group in self.groups for key in group.keys]


def second_order_functions(system: System, loops: Loops, functions: Sequence[Function]) -> list[Function]:
    """`<function>_hessian_product` and `<function>_hessian` of what an optimiser asks for.

    Drives and accelerations along (y, y_dot, y_ddot or u), margins along y, the closure by the entries of q.
    """
    found = {f.name: f for f in functions}
    result = []
    for name in (*ALONG_Y, "closure"):
        if name in found and found[name].results[0]:
            weighted = _weighted(system, loops, found[name])
            if weighted.groups:  # a mechanism without freedoms has nothing to go along
                result += [_product(weighted), _hessian(weighted)]
    return result


def _weighted(system: System, loops: Loops, function: Function) -> _Weighted:
    tape, port = system.tape, function.outputs[0]
    inputs = list(zip(function.inputs, function.arguments, strict=True))
    plain = [plain_directions(p.name, p, nodes) for p, nodes in inputs if p.name in STATE]
    along_y = function.name in ALONG_Y
    first = independent_directions(system, loops) if along_y else plain_directions("q", *inputs[0])
    groups = tuple(group for group in (first, *plain) if group.labels)
    units = tuple(quotient("1", unit) for unit in port.units)
    nodes = tuple(
        tape.symbol(f"weight_{k}", unit, f"weight of {label}")
        for k, (unit, label) in enumerate(zip(units, port.labels, strict=True))
    )
    weights = Port("weights", (port.size,), units, port.labels, f"weights of the entries of {port.name}: multipliers")
    total = sum((w * f for w, f in zip(nodes, function.results[0], strict=True)), start=tape.zero)
    keys = [key for group in groups for key in group.keys]
    (gradient,) = differentiate(tape, [total], merged(groups), keys, order="reverse")
    guards = (*function.guards, *(guarded(loops.guards, LOSING) if along_y else ()))
    return _Weighted(function, (weights, nodes), groups, gradient, guards)


def _product(of: _Weighted) -> Function:
    """The change of the gradient along one direction."""
    function, tape = of.function, of.gradient[0].tape
    steps: dict[str, Node] = {}
    ports, nodes = [], []
    for group in of.groups:
        made = tuple(
            tape.symbol(f"step_{group.name}_{k}", unit, f"step of {label}")
            for k, (unit, label) in enumerate(zip(group.units, group.labels, strict=True))
        )
        text = f"the direction: steps of {group.text}"
        ports.append(Port(f"step_{group.name}", (len(made),), group.units, group.labels, text))
        nodes.append(made)
        steps |= dict(zip(group.keys, made, strict=True))
    seeds = {
        node: {"step": sum((slope * steps[key] for key, slope in changes.items()), start=tape.zero)} if changes else {}
        for node, changes in merged(of.groups).items()
    }
    moved = iter([row[0] for row in differentiate(tape, of.gradient, seeds, ["step"], order="forward")])
    name = function.outputs[0].name
    outputs = []
    for group in of.groups:
        text = f"rows of the Hessian of weights . {name} for {group.text}, times the direction"
        units = tuple(quotient("1", unit) for unit in group.units)
        outputs.append(Port(f"product_{group.name}", (len(group.keys),), units, group.labels, text))
    results = tuple(tuple(next(moved) for _ in group.keys) for group in of.groups)
    weights, symbols = of.weights
    return replace(
        function,
        name=f"{function.name}{PRODUCT}",
        description=f"The Hessian of weights . {name} times a direction{_where(of)}.",
        inputs=(*function.inputs, weights, *ports),
        arguments=(*function.arguments, symbols, *nodes),
        outputs=tuple(outputs),
        results=results,
        guards=of.guards,
    )


def _hessian(of: _Weighted) -> Function:
    """The entries of the upper blocks that are not zero at every state."""
    function, tape, keys = of.function, of.gradient[0].tape, of.keys
    rows = differentiate(tape, of.gradient, merged(of.groups), keys, order="forward")
    outputs, results = [], []
    start = {group.name: keys.index(group.keys[0]) for group in of.groups}
    for i, one in enumerate(of.groups):
        for other in of.groups[i:]:
            entries = [
                (r, c, rows[start[one.name] + r][start[other.name] + c])
                for c in range(len(other.keys))
                for r in range(len(one.keys))
                if one is not other or r <= c
            ]
            kept = [(r, c, node) for r, c, node in entries if node is not tape.zero]
            if kept:
                outputs.append(_block(one, other, [(r, c) for r, c, _ in kept]))
                results.append(tuple(node for _, _, node in kept))
    weights, symbols = of.weights
    return replace(
        function,
        name=f"{function.name}{HESSIAN}",
        description=f"The Hessian of weights . {function.outputs[0].name}{_where(of)}.",
        inputs=(*function.inputs, weights),
        arguments=(*function.arguments, symbols),
        outputs=tuple(outputs),
        results=tuple(results),
        guards=of.guards,
    )


def _block(one: Directions, other: Directions, entries: Sequence[tuple[int, int]]) -> Port:
    labels = tuple(f"{one.labels[r]}|{other.labels[c]}" for r, c in entries)
    units = tuple(quotient(quotient("1", one.units[r]), other.units[c]) for r, c in entries)
    half = ", of the upper triangle" if one is other else ""
    text = f"rows: {one.text}; columns: {other.text}; entries that are not zero{half}, column by column"
    return Port(f"hessian_{one.name}_{other.name}", (len(entries),), units, labels, text)


def _where(of: _Weighted) -> str:
    return " along the independent coordinates, all loops held closed" if of.function.name in ALONG_Y else ""

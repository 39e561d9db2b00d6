"""The Jacobian of any straight-line function by all of its inputs, as a program.

Unlike the derivatives of `symscrew.functions.derivative`, which follow the motions of the mechanism, these
are the plain partial derivatives by every entry of every input array: what a numerical solver asks for. The
entries that are zero at every input are left out.

An iteration is differentiated by its step: where Newton's method has converged, q_next(q, y, p) does not depend
on q, and its derivatives by y and p are those of the solution (the implicit function theorem).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symscrew.algebra import ARITHMETIC, Node, Tape, differentiate
from symscrew.program.lowering import Function, lower
from symscrew.program.straight_line import Iteration, Port, Program

Entries = tuple[int, int, tuple[int, ...], tuple[int, ...]]


@dataclass(frozen=True)
class Jacobian:
    """The derivatives of `source`: `program` gives the entries that are not zero, an output per block.

    `blocks[output of program]` are (output, input, rows, columns) in the source's numbering, column by column; a
    block without entries has none. The program's inputs are the source's; for an iteration they are those of its
    step, which start with the solution q.
    """

    source: Program | Iteration
    program: Program
    blocks: Mapping[str, Entries]


def jacobian(source: Program | Iteration) -> Jacobian:
    """The derivatives of all outputs of a function by all of its inputs."""
    program = source.step if isinstance(source, Iteration) else source
    outputs = program.outputs[:1] if isinstance(source, Iteration) else program.outputs
    tape = Tape()
    arguments = tuple(
        tuple(tape.symbol(f"{port.name}_{k}", port.units[k], port.description) for k in range(port.size))
        for port in program.inputs
    )
    entries = [node for nodes in arguments for node in nodes]
    results, tested, compared = _nodes(tape, program, entries)
    keys = [str(k) for k in range(len(entries))]
    seeds = {node: {key: tape.one} for node, key in zip(entries, keys, strict=True)}
    if isinstance(source, Iteration):
        # A step is limited by its length, which at the solution is zero: not limited, but sqrt has no slope there.
        seeds |= {node: {} for node in compared if node.op == "sqrt"}
    blocks: dict[str, Entries] = {}
    ports: list[Port] = []
    values: list[tuple[Node, ...]] = []
    rows = differentiate(tape, [n for nodes in results[: len(outputs)] for n in nodes], seeds, keys)
    row = 0
    for o, output in enumerate(outputs):
        column = 0
        for i, given in enumerate(program.inputs):
            found = [
                (r, c, rows[row + r][column + c])
                for c in range(given.size)
                for r in range(output.size)
                if rows[row + r][column + c] is not tape.zero
            ]
            column += given.size
            place = _place(source, i)
            if not found or place is None:
                continue
            port = _port(output, given, [(r, c) for r, c, _ in found])
            blocks[port.name] = (o, place, tuple(r for r, _, _ in found), tuple(c for _, c, _ in found))
            ports.append(port)
            values.append(tuple(n for _, _, n in found))
        row += output.size
    text = f"Partial derivatives of {source.name} by the entries of its inputs."
    pivots, bounded = tested[: len(program.guards)], tested[len(program.guards) :]
    bounds = [limit[1:] for limit in program.limits]
    function = Function(
        f"{source.name}_jacobian",
        text,
        program.inputs,
        tuple(ports),
        arguments,
        tuple(values),
        guards=tuple((node, threshold) for node, (_, threshold) in zip(pivots, program.guards, strict=True)),
        notes=program.notes,
        limits=tuple((node, *rest) for node, rest in zip(bounded, bounds, strict=True)),
        reach=program.reach,
    )
    return Jacobian(source, lower(function), blocks)


def adjoint(source: Program) -> Program:
    """Gradients by every input of the sum of weights . outputs: one sweep in reverse, whatever the inputs are.

    Inputs are those of the source, then a weight for every entry of its outputs (adj_<output>); outputs adj_<input>.
    """
    tape = Tape()
    weights = tuple(
        Port(
            f"adj_{p.name}",
            p.shape,
            tuple(f"1/({u})" for u in p.units),
            p.labels,
            f"weights of the entries of {p.name}",
        )
        for p in source.outputs
    )
    arguments = tuple(
        tuple(tape.symbol(f"{port.name}_{k}", port.units[k], port.description) for k in range(port.size))
        for port in (*source.inputs, *weights)
    )
    own = arguments[: len(source.inputs)]
    entries = [node for nodes in own for node in nodes]
    results, tested, _ = _nodes(tape, source, entries)
    terms = [
        (w, f) for at, out in zip(arguments[len(own) :], results, strict=True) for w, f in zip(at, out, strict=True)
    ]
    total = sum((w * f for w, f in terms), start=tape.zero)
    keys = [str(k) for k in range(len(entries))]
    seeds = {node: {key: tape.one} for node, key in zip(entries, keys, strict=True)}
    (gradient,) = differentiate(tape, [total], seeds, keys, order="reverse")
    found = iter(gradient)
    ports = tuple(
        Port(
            f"adj_{p.name}", p.shape, tuple(f"1/({u})" for u in p.units), p.labels, f"slopes by the entries of {p.name}"
        )
        for p in source.inputs
    )
    pivots, bounded = tested[: len(source.guards)], tested[len(source.guards) :]
    function = Function(
        f"{source.name}_adjoint",
        f"Gradients of the weighted sum of the results of {source.name}.",
        (*source.inputs, *weights),
        ports,
        arguments,
        tuple(tuple(next(found) for _ in range(port.size)) for port in ports),
        guards=tuple((node, threshold) for node, (_, threshold) in zip(pivots, source.guards, strict=True)),
        notes=source.notes,
        limits=tuple((node, *limit[1:]) for node, limit in zip(bounded, source.limits, strict=True)),
        reach=source.reach,
    )
    return lower(function)


def _place(source: Program | Iteration, index: int) -> int | None:
    """Which input of the source an input of the differentiated program is: an iteration's are y, guess, p."""
    if not isinstance(source, Iteration):
        return index
    return {0: None, 1: 0}.get(index, index)


def _port(output: Port, given: Port, entries: list[tuple[int, int]]) -> Port:
    labels = tuple(f"{output.labels[r]}|{given.labels[c]}" for r, c in entries)
    units = tuple(f"({output.units[r]})/({given.units[c]})" for r, c in entries)
    text = f"entries of d {output.name} / d {given.name} that are not zero, column by column"
    return Port(f"d_{output.name}_d_{given.name}", (len(entries),), units, labels, text)


def _nodes(tape: Tape, program: Program, entries: list[Node]) -> tuple[list[tuple[Node, ...]], list[Node], list[Node]]:
    """The results of a program on a tape, what decides its status, and the nodes that are compared with a limit."""
    slots: dict[int, Node] = dict(enumerate(entries))
    compared: list[Node] = []

    def value(operand: int | float) -> Node:
        return slots[operand] if isinstance(operand, int) else tape.node(operand)

    for instruction in program.instructions:
        args = [value(a) for a in instruction.args]
        compared += args[:1] if instruction.op == "less" else []
        slots[instruction.target] = _applied(tape, instruction.op, args)
    results = [tuple(value(slot) for slot in slots_) for slots_ in program.results]
    return results, [value(slot) for slot in program.tested], compared


def _applied(tape: Tape, op: str, args: list[Node]) -> Node:
    if op in ARITHMETIC:
        made: Node = ARITHMETIC[op](*args)
        return made
    if op == "reciprocal":
        return tape.reciprocal(args[0])
    return tape.function(op, *args)

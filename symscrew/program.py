"""Straight-line programs: what a function of the model computes, free of any target language.

A program is a slice of the tape: the instructions that its outputs need, in an order of evaluation, with
quotients, signs and common factors put into the form that costs least. It knows its inputs and outputs by
name, shape, unit and label, its operation count and its hash. Printers in `symscrew.export` contain no
algebra.
"""

from __future__ import annotations

import hashlib
import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from symscrew.tape import Node, Tape, apply_numpy

COUNTED = {
    "add": "add",
    "sub": "add",
    "neg": "add",
    "mul": "mul",
    "div": "div",
    "reciprocal": "div",
    "sqrt": "sqrt",
    "sin": "trig",
    "cos": "trig",
    "tan": "trig",
    "atan2": "trig",
    "abs": "compare",
    "less": "compare",
    "select": "compare",
}
CLASSES = ("add", "mul", "div", "sqrt", "trig", "compare")


@dataclass(frozen=True)
class Port:
    """An input or output array: column-major entries with a name, shape, units and labels."""

    name: str
    shape: tuple[int, ...]
    units: tuple[str, ...]
    labels: tuple[str, ...]
    description: str

    @property
    def size(self) -> int:
        """Number of entries."""
        return int(np.prod(self.shape)) if self.shape else 1


@dataclass(frozen=True)
class Function:
    """A function of the model before lowering: ports and the nodes behind them.

    `guards`: (node, threshold): the function fails where |node| is not above the threshold.
    """

    name: str
    description: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    arguments: tuple[tuple[Node, ...], ...]
    results: tuple[tuple[Node, ...], ...]
    guards: tuple[tuple[Node, float], ...] = ()
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Instruction:
    """`target` = op(args); an arg is a slot number, or a float constant."""

    target: int
    op: str
    args: tuple[int | float, ...]


@dataclass(frozen=True)
class Program:
    """A lowered function. Slots 0 ... n-1 are the entries of all inputs in order."""

    name: str
    description: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    instructions: tuple[Instruction, ...]
    results: tuple[tuple[int | float, ...], ...]
    guards: tuple[tuple[int, float], ...]
    notes: tuple[str, ...] = ()
    slots: int = field(default=0)

    @property
    def operations(self) -> dict[str, int]:
        """Operations that the printed function executes: each counts 1; the status checks are included."""
        count = dict.fromkeys(CLASSES, 0)
        for instruction in self.instructions:
            count[COUNTED[instruction.op]] += 1
        if self.guards:
            checked = sum(port.size for port in self.outputs)
            count["compare"] += 2 * len(self.guards) + 1
            count["add"] += checked
        count["total"] = sum(count.values())
        return count

    @property
    def hash(self) -> str:
        """SHA-256 of everything that determines the printed code, 16 hex digits."""
        text = repr((self.name, self.inputs, self.outputs, self.instructions, self.results, self.guards))
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def __call__(self, *arguments: object) -> tuple[np.ndarray, ...]:
        """Evaluate on NumPy arrays of shape (*batch, size) or the port's shape; see `evaluate`."""
        return evaluate(self, arguments)


def lower(function: Function) -> Program:
    """The program of a function: dead code gone, quotients and signs where they cost least."""
    return _Lowering(_factored(function)).program()


def _uses(roots: Sequence[Node]) -> dict[int, int]:
    """How often each node that the roots need is an operand or a root."""
    uses: dict[int, int] = {}
    seen: set[int] = set()
    stack = list(roots)
    for root in roots:
        uses[root.index] = uses.get(root.index, 0) + 1
    while stack:
        node = stack.pop()
        if node.index in seen or node.op in ("symbol", "const"):
            continue
        seen.add(node.index)
        for arg in node.args:
            uses[arg.index] = uses.get(arg.index, 0) + 1
            stack.append(arg)
    return uses


def _factored(function: Function) -> Function:
    """The function with a b + a c written as a (b + c) wherever neither product serves anything else."""
    roots = [n for nodes in function.results for n in nodes] + [g for g, _ in function.guards]
    uses = _uses(roots)
    if not roots:
        return function
    tape = roots[0].tape
    new: dict[int, Node] = {}
    needed = sorted((i for i in uses), key=int)
    for index in needed:
        node = tape.nodes[index]
        if node.op in ("symbol", "const"):
            new[index] = node
            continue
        args = tuple(new[a.index] for a in node.args)
        if node.op in ("add", "sub"):
            new[index] = _factor(tape, node, args, uses)
        elif args == node.args:
            new[index] = node
        else:
            new[index] = _remake(tape, node.op, args)
    results = tuple(tuple(new[n.index] for n in nodes) for nodes in function.results)
    guards = tuple((new[g.index], threshold) for g, threshold in function.guards)
    return replace(function, results=results, guards=guards)


def _remake(tape: Tape, op: str, args: tuple[Node, ...]) -> Node:
    if op == "mul":
        return tape.mul(*args)
    if op == "neg":
        return tape.neg(*args)
    if op == "reciprocal":
        return tape.reciprocal(*args)
    return tape.function(op, *args)


def _factor(tape: Tape, node: Node, args: tuple[Node, ...], uses: Mapping[int, int]) -> Node:
    x, y = args
    single = all(uses[old.index] == 1 for old in node.args)
    if single and x.op == "mul" and y.op == "mul":
        for common in x.args:
            if common in y.args:
                rest = [next((a for a in product.args if a is not common), common) for product in (x, y)]
                inner = tape.add(rest[0], rest[1] if node.op == "add" else tape.neg(rest[1]))
                return tape.mul(common, inner)
    return tape.add(x, y if node.op == "add" else tape.neg(y))


class _Lowering:
    def __init__(self, function: Function) -> None:
        self.function = function
        self.slot: dict[int, int] = {}
        self.instructions: list[Instruction] = []
        self.made: dict[tuple, int] = {}
        self.next = itertools.count()
        for node in itertools.chain.from_iterable(function.arguments):
            self.slot[node.index] = next(self.next)
        self.roots = [n for nodes in function.results for n in nodes] + [g for g, _ in function.guards]
        self.uses = _uses(self.roots)

    def program(self) -> Program:
        results = tuple(tuple(self.value(n) for n in nodes) for nodes in self.function.results)
        guards = []
        for node, threshold in self.function.guards:
            inner = node.args[0] if node.op == "neg" else node
            slot = self.value(inner)
            if isinstance(slot, int):
                guards.append((slot, threshold))
        f = self.function
        unique = tuple(dict.fromkeys(guards))
        return Program(
            f.name, f.description, f.inputs, f.outputs, tuple(self.instructions), results, unique, f.notes, next(self.next)
        )

    def value(self, root: Node) -> int | float:
        """Slot or constant of a node, emitting what it needs first (without recursion in depth)."""
        stack = [root]
        while stack:
            node = stack[-1]
            if node.value is not None or node.index in self.slot:
                stack.pop()
                continue
            if node.op == "symbol":
                raise ValueError(
                    f"function {self.function.name} uses {node.args[0].name}, which is not among its inputs "
                    f"({', '.join(p.name for p in self.function.inputs)})"
                )
            op, args = self._form(node)
            missing = [a for a in args if a.value is None and a.index not in self.slot]
            if missing:
                stack.extend(reversed(missing))
                continue
            stack.pop()
            self.slot[node.index] = self._emit(op, tuple(self._ready(a) for a in args))
        return self._ready(root)

    def _ready(self, node: Node) -> int | float:
        return float(node.value) if node.value is not None else self.slot[node.index]

    def _single(self, node: Node) -> bool:
        return self.uses.get(node.index, 0) == 1 and node.index not in self.slot

    def _form(self, node: Node) -> tuple[str, tuple[Node, ...]]:
        """The cheapest way to print a node: x * (1/y) with y's reciprocal used once is a quotient."""
        op, args = node.op, node.args
        if op == "mul":
            x, y = args
            for a, b in ((x, y), (y, x)):
                if b.op == "reciprocal" and self._single(b) and a.op != "reciprocal":
                    return "div", (a, b.args[0])
        if op == "neg":
            inner = args[0]
            if inner.op == "sub" and self._single(inner):
                return "sub", (inner.args[1], inner.args[0])
        return op, args

    def _emit(self, op: str, args: tuple[int | float, ...]) -> int:
        key = (op, args)
        if key not in self.made:
            target = next(self.next)
            self.made[key] = target
            self.instructions.append(Instruction(target, op, args))
        return self.made[key]


def evaluate(program: Program, arguments: Sequence[object]) -> tuple[np.ndarray, ...]:
    """Run a program on NumPy: arguments of shape (*batch, size) or (size,); results (*batch, size).

    All states of a batch go through each instruction at once.
    """
    if len(arguments) != len(program.inputs):
        names = ", ".join(p.name for p in program.inputs)
        raise TypeError(f"{program.name} expects {len(program.inputs)} inputs ({names}), got {len(arguments)}")
    values: list = [None] * program.slots
    slot, batch = 0, ()
    for port, argument in zip(program.inputs, arguments, strict=True):
        array = np.asarray(argument, dtype=float)
        if array.shape[-1:] != (port.size,) and port.size != 1:
            raise ValueError(f"{program.name}: {port.name} has {port.size} entries, got an array of shape {array.shape}")
        if port.size == 1 and array.shape[-1:] != (1,):
            array = array[..., None]
        batch = np.broadcast_shapes(batch, array.shape[:-1])
        for k in range(port.size):
            values[slot] = array[..., k]
            slot += 1
    with np.errstate(all="ignore"):
        for instruction in program.instructions:
            args = [values[a] if isinstance(a, int) else a for a in instruction.args]
            values[instruction.target] = apply_numpy(instruction.op, args)
        results = []
        for slots in program.results:
            columns = [values[s] if isinstance(s, int) else s for s in slots]
            results.append(np.stack([np.broadcast_to(c, batch) for c in columns], axis=-1) if columns else np.zeros((*batch, 0)))
        if program.guards:
            bad = np.zeros(batch, dtype=bool)
            for guard, threshold in program.guards:
                bad |= ~(np.abs(values[guard]) > threshold)
            for result in results:
                result[bad] = np.nan
    return tuple(results)


def sample_inputs(tape: Tape, function: Function, values: Mapping[str, np.ndarray]) -> dict[Node, np.ndarray]:
    """Sample values of a function's input nodes from arrays (samples, size) by port name."""
    return {
        node: np.asarray(values[port.name])[:, k]
        for port, nodes in zip(function.inputs, function.arguments, strict=True)
        for k, node in enumerate(nodes)
    }

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
from functools import cached_property

import numpy as np

from symscrew.algebra import Node, apply_numpy
from symscrew.program.common_factors import factored
from symscrew.program.reciprocals import shared_reciprocals

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
    "exp": "trig",
    "abs": "compare",
    "less": "compare",
    "select": "compare",
}
CLASSES = ("add", "mul", "div", "sqrt", "trig", "compare")
PASSING = {"add": 2, "sub": 2, "mul": 2, "neg": 1, "div": 1, "sqrt": 1, "sin": 1, "cos": 1, "tan": 1, "abs": 1}
"""How many first operands an operation has whose NaN or infinity is one of its result, whatever the others are."""


@dataclass(frozen=True)
class Port:
    """An input or output array: column-major entries with a name, shape, units and labels.

    `forms`: of margins, what each entry is (`symscrew.mobility.margins.FORMS`); empty elsewhere. It does not
    change the code.
    """

    name: str
    shape: tuple[int, ...]
    units: tuple[str, ...]
    labels: tuple[str, ...]
    description: str
    forms: tuple[str, ...] = field(default=(), repr=False)

    @property
    def size(self) -> int:
        """Number of entries."""
        return int(np.prod(self.shape)) if self.shape else 1


@dataclass(frozen=True)
class Function:
    """A function of the model before lowering: ports and the nodes behind them.

    `guards`: (node, threshold): the function fails with status 1 where |node| <= threshold.
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
        # each guard costs an absolute value and a comparison; the sum of what is checked is tested for NaN and Inf
        count["compare"] += 2 * len(self.guards) + bool(self.checked)
        count["add"] += max(0, len(self.checked) - 1)
        count["total"] = sum(count.values())
        return count

    @cached_property
    def checked(self) -> tuple[int, ...]:
        """The slots whose sum must be finite, so that all outputs, guarded pivots and inputs are.

        Not those in front of another one through operations that pass a NaN or an infinity on: it shows there. Pivots
        are among them because an infinite one would make its quotients 0. Of a pivot that is a comparison it is what
        is compared.
        """
        results = {s for slots in self.results for s in slots if isinstance(s, int)}
        watched = results | {slot for slot, _ in self.guards}
        seen: set[int] = set()
        found = []
        for instruction in reversed(self.instructions):
            if instruction.op == "less" and instruction.target in watched and instruction.target not in results:
                watched |= {arg for arg in instruction.args if isinstance(arg, int)}
            elif instruction.target in watched and instruction.target not in seen:
                found.append(instruction.target)
            elif instruction.target not in seen:
                continue
            seen |= {arg for arg in instruction.args[: PASSING.get(instruction.op, 0)] if isinstance(arg, int)}
        return (*found[::-1], *(slot for slot in range(sum(port.size for port in self.inputs)) if slot not in seen))

    @cached_property
    def hash(self) -> str:
        """SHA-256 of everything that determines the printed code, 16 hex digits."""
        # the text of repr(self.instructions), which takes three times as long
        body = ", ".join(f"Instruction(target={i.target}, op={i.op!r}, args={i.args!r})" for i in self.instructions)
        body = f"({body},)" if len(self.instructions) == 1 else f"({body})"
        before, after = repr((self.name, self.inputs, self.outputs)), repr((self.results, self.guards))
        return hashlib.sha256(f"{before[:-1]}, {body}, {after[1:]}".encode()).hexdigest()[:16]

    def __call__(self, *arguments: object) -> tuple[np.ndarray, ...]:
        """Results only; see `evaluate`."""
        return evaluate(self, arguments)[0]


@dataclass(frozen=True)
class Iteration:
    """A function that repeats a straight-line step: assembly of the loops from independent coordinates.

    Inputs are y (the independent coordinates), guess (a configuration q) and the run-time parameters if there
    are any; the output is q. `step` takes (q, y, parameters) and gives (q_next, residual, step, orientation):
    one guarded Newton step, the largest loop opening without units at q, the size of the step without units,
    and a number whose sign tells the assembly branch (the determinant of the dependent part of the closure).

    How to run it: y0 = guess[independent]. For n = 1, 2, 4, ... max_substeps: start at guess; for k = 1 ... n
    take y_k = y0 + (y - y0) k / n and repeat the step until residual and step are below `tolerance`, at most
    `max_steps` times; give up this n if the step fails, does not converge, or if the sign of the orientation
    differs from that at the guess. The first n that succeeds is the answer. Status 0 success, 3 not converged,
    4 converged, but on another branch than the guess.
    """

    name: str
    description: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    step: Program
    independent: tuple[int, ...]
    tolerance: float = 1e-13
    max_steps: int = 25
    max_substeps: int = 64
    notes: tuple[str, ...] = ()

    @property
    def operations(self) -> dict[str, int]:
        """Operations of one step; the number of steps depends on the guess."""
        return self.step.operations

    @property
    def hash(self) -> str:
        """SHA-256 of everything that determines the printed code, 16 hex digits."""
        text = repr((self.name, self.step.hash, self.independent, self.tolerance, self.max_steps, self.max_substeps))
        return hashlib.sha256(text.encode()).hexdigest()[:16]


STATUS = {
    -2: "success where the loops lose rank: by the rank-revealing path, with the freedoms that open there",
    -1: "success near a small pivot: by the rank-revealing path, at full rank",
    0: "success",
    1: "near-singular: a pivot of the elimination fell below its threshold; all outputs are NaN",
    2: "not finite: an input was NaN or infinite, or an output overflowed; all outputs are NaN",
    3: "not converged: the loops could not be closed from this guess; all outputs are NaN",
    4: "other branch: the loops close only on another assembly branch than the guess; all outputs are NaN",
}


def lower(function: Function) -> Program:
    """The program of a function: dead code gone, quotients and signs where they cost least."""
    fewer = with_roots(function, shared_reciprocals(roots_of(function)))
    found, uses = factored(roots_of(fewer))
    return _Lowering(with_roots(fewer, found), uses).program()


def roots_of(function: Function) -> list[Node]:
    """All results, then the guarded pivots."""
    return [n for nodes in function.results for n in nodes] + [g for g, _ in function.guards]


def with_roots(function: Function, roots: Sequence[Node]) -> Function:
    """The function with other results and guarded pivots, in the order of `roots_of`."""
    left = iter(roots)
    results = tuple(tuple(next(left) for _ in nodes) for nodes in function.results)
    return replace(function, results=results, guards=tuple((next(left), t) for _, t in function.guards))


class _Lowering:
    def __init__(self, function: Function, uses: Mapping[int, int]) -> None:
        self.function, self.uses = function, uses
        self.slot: dict[int, int | float] = {}  # of a node; for a constant, its value
        self.instructions: list[Instruction] = []
        self.made: dict[tuple, int] = {}
        self.next = itertools.count()
        for node in itertools.chain.from_iterable(function.arguments):
            self.slot[node.index] = next(self.next)

    def program(self) -> Program:
        results = tuple(tuple(self.value(n) for n in nodes) for nodes in self.function.results)
        guards: dict[int, float] = {}
        for node, threshold in self.function.guards:
            inner = node.args[0] if node.op == "neg" else node
            slot = self.value(inner)
            if isinstance(slot, int):  # of several thresholds for one pivot the largest says it all
                guards[slot] = max(threshold, guards.get(slot, threshold))
        f = self.function
        return Program(
            f.name,
            f.description,
            f.inputs,
            f.outputs,
            tuple(self.instructions),
            results,
            tuple(_strongest(guards, self.instructions).items()),
            f.notes,
            next(self.next),
        )

    def value(self, root: Node) -> int | float:
        """Slot or constant of a node, emitting what it needs first (without recursion in depth)."""
        slot = self.slot
        stack = [root]
        while stack:
            node = stack[-1]
            if node.index in slot:
                stack.pop()
                continue
            if node.value is not None:
                slot[node.index] = float(node.value)
                stack.pop()
                continue
            if node.op == "symbol":
                raise ValueError(
                    f"function {self.function.name} uses {node.args[0].name}, which is not among its inputs "
                    f"({', '.join(p.name for p in self.function.inputs)})"
                )
            op, args = self._form(node)
            ready = True
            for arg in args[::-1]:
                if arg.index not in slot:
                    stack.append(arg)
                    ready = False
            if ready:
                stack.pop()
                slot[node.index] = self._emit(op, tuple([slot[a.index] for a in args]))
        return slot[root.index]

    def _single(self, node: Node) -> bool:
        return self.uses.get(node.index, 0) == 1 and node.index not in self.slot

    def _form(self, node: Node) -> tuple[str, tuple[Node, ...]]:
        """The cheapest way to print a node: x * (1/y) with y's reciprocal used once is a quotient."""
        op, args = node.op, node.args
        if op == "mul":
            x, y = args
            if y.op == "reciprocal" and x.op != "reciprocal" and self._single(y):
                return "div", (x, y.args[0])
            if x.op == "reciprocal" and y.op != "reciprocal" and self._single(x):
                return "div", (y, x.args[0])
        elif op == "neg":
            inner = args[0]
            if inner.op == "sub" and self._single(inner):
                return "sub", (inner.args[1], inner.args[0])
        return op, args

    def _emit(self, op: str, args: tuple[int | float, ...]) -> int:
        # slot 2 and the constant 2.0 are equal, and not the same
        key = (op, args, tuple(map(type, args))) if float in map(type, args) else (op, args)
        target = self.made.get(key)
        if target is None:
            self.made[key] = target = next(self.next)
            self.instructions.append(Instruction(target, op, args))
        return target


def _strongest(guards: Mapping[int, float], instructions: Sequence[Instruction]) -> dict[int, float]:
    """Guards without those that follow from others: |c g| > t with a cosine or sine c says that |g| > t."""
    turns = {i.target for i in instructions if i.op in ("sin", "cos")}
    found = dict(guards)
    for instruction in reversed(instructions):
        if instruction.op != "mul" or instruction.target not in found:
            continue
        one, other = instruction.args
        if isinstance(one, float) or isinstance(other, float):  # the constant 2.0 is not slot 2
            continue
        for factor, pivot in ((one, other), (other, one)):
            if factor in turns and pivot in found:
                found[instruction.target] = max(found[instruction.target], found.pop(pivot))
    return found


def evaluate(program: Program, arguments: Sequence[object]) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """Run a program on NumPy: arguments of shape (*batch, size) or (size,); results (*batch, size), status (*batch).

    All states of a batch go through each instruction at once. Where the status is not 0 the results are NaN.
    """
    if len(arguments) != len(program.inputs):
        names = ", ".join(p.name for p in program.inputs)
        raise TypeError(f"{program.name} expects {len(program.inputs)} inputs ({names}), got {len(arguments)}")
    values: list = [None] * program.slots
    slot, batch = 0, ()
    for port, argument in zip(program.inputs, arguments, strict=True):
        array = np.asarray(argument, dtype=float)
        if array.shape[-1:] != (port.size,) and port.size != 1:
            raise ValueError(
                f"{program.name}: {port.name} has {port.size} entries, got an array of shape {array.shape}"
            )
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
        results = [_entries(values, slots, batch) for slots in program.results]
        status = np.zeros(batch, dtype=int)
        for guard, threshold in program.guards:
            status = np.where((status == 0) & (np.abs(values[guard]) <= threshold), 1, status)
        total = sum((values[slot] for slot in program.checked), start=np.zeros(batch))
        status = np.where((status == 0) & ~np.isfinite(total), 2, status)
        for result in results:
            result[status != 0] = np.nan
    return tuple(results), status


def _entries(values: Sequence, slots: Sequence[int | float], batch: tuple[int, ...]) -> np.ndarray:
    """An output (*batch, size) from the values of its slots, and its constants."""
    result = np.empty((*batch, len(slots)))
    result[...] = [0.0 if isinstance(s, int) else s for s in slots]
    for k, slot in enumerate(slots):
        if isinstance(slot, int):
            result[..., k] = values[slot]
    return result


def evaluate_iteration(iteration: Iteration, arguments: Sequence[object]) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """Run an iteration as its docstring says, state by state; results (*batch, size) and status (*batch)."""
    arrays = [np.atleast_1d(np.asarray(a, dtype=float)) for a in arguments]
    batch = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
    count = int(np.prod(batch))
    full = [np.broadcast_to(a, (*batch, a.shape[-1])).reshape(count, a.shape[-1]) for a in arrays]
    q = np.empty_like(full[1], dtype=float)
    status = np.empty(len(q), dtype=int)
    for i in range(len(q)):
        if not all(np.isfinite(a[i]).all() for a in full):
            q[i], status[i] = full[1][i], 2
            continue
        q[i], status[i] = _iterate(iteration, full[0][i], full[1][i], [a[i] for a in full[2:]])
    q[status != 0] = np.nan
    return (q.reshape(*batch, q.shape[-1]),), status.reshape(batch)


def _iterate(
    iteration: Iteration, y: np.ndarray, guess: np.ndarray, parameters: Sequence[np.ndarray]
) -> tuple[np.ndarray, int]:
    start = guess[list(iteration.independent)]
    (_, _, _, sign), _ = evaluate(iteration.step, [guess, start, *parameters])
    substeps, outcome = 1, 3
    while substeps <= iteration.max_substeps:
        q, outcome = np.array(guess), 0
        for k in range(1, substeps + 1):
            target = start + (y - start) * (k / substeps)
            q, outcome = _newton(iteration, q, target, parameters, float(sign[0]))
            if outcome:
                break
        if outcome == 0:
            return q, 0
        substeps *= 2
    return np.array(guess), outcome


def _newton(
    iteration: Iteration, q: np.ndarray, y: np.ndarray, parameters: Sequence[np.ndarray], sign: float
) -> tuple[np.ndarray, int]:
    for _ in range(iteration.max_steps):
        (q, residual, step, orientation), status = evaluate(iteration.step, [q, y, *parameters])
        if status:
            return q, 3
        if residual[0] < iteration.tolerance and step[0] < iteration.tolerance:
            return q, 0 if orientation[0] * sign > 0 else 4
    return q, 3

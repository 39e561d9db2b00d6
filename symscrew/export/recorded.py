"""Straight-line programs that differentiate and transpose themselves; printed into modules for JAX.

    listing(op, entries) --record--> Recorded --tangent, adjoint--> Recorded --table--> runs of rows

A listing is called once with `Value`s in place of numbers, which remember what is done to them. A `Recorded` program is
a function of inputs of which the last ones may enter linearly: such are tangents, (x, dx) -> f'(x) dx, and their
transposes, (x, c) -> f'(x)^T c. Both are programs of the same kind, so that derivatives have derivatives.
Its `table` is the program as rows of a memory: a loop runs it that does not grow with it.
"""

from __future__ import annotations

import heapq
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

ARITHMETIC = ("add", "sub", "mul")  # done in one loop, by a number; all else takes a choice of branches
LARGEST = 1e38  # a finite number in every precision: what is larger counts as infinite
INPUT, CONSTANT = "input", "constant"


class Value:
    """A node of a tape that remembers what is done to it."""

    __slots__ = ("node", "tape")

    def __init__(self, tape: Nodes, node: int) -> None:
        self.tape, self.node = tape, node

    def _with(self, op: str, other: Value | float, *, swapped: bool = False) -> Value:
        first, second = self.node, other.node if isinstance(other, Value) else self.tape.constant(other)
        return Value(self.tape, self.tape.put(op, *((second, first) if swapped else (first, second))))

    def __add__(self, other: Value | float) -> Value:
        return self._with("add", other)

    def __radd__(self, other: Value | float) -> Value:
        return self._with("add", other, swapped=True)

    def __sub__(self, other: Value | float) -> Value:
        return self._with("sub", other)

    def __rsub__(self, other: Value | float) -> Value:
        return self._with("sub", other, swapped=True)

    def __mul__(self, other: Value | float) -> Value:
        return self._with("mul", other)

    def __rmul__(self, other: Value | float) -> Value:
        return self._with("mul", other, swapped=True)

    def __truediv__(self, other: Value | float) -> Value:
        return self._with("div", other)

    def __rtruediv__(self, other: Value | float) -> Value:
        return self._with("div", other, swapped=True)

    def __neg__(self) -> Value:
        return Value(self.tape, self.tape.put("neg", self.node))


class Functions:
    """What a listing calls as `op.sin(x)`: every operation without a sign of its own."""

    def __init__(self, tape: Nodes) -> None:
        self._tape = tape

    def __getattr__(self, name: str) -> Callable[..., Value]:
        tape = self._tape

        def applied(*values: Value | float) -> Value:
            nodes = [x.node if isinstance(x, Value) else tape.constant(x) for x in values]
            return Value(tape, tape.put(name, *nodes))

        return applied


class Nodes:
    """Operations in order, each on earlier ones; equal ones are there once, and 0 and 1 are seen."""

    def __init__(self, inputs: int) -> None:
        self.ops: list[tuple[Any, ...]] = []
        self.known: dict[tuple[Any, ...], int] = {}
        for k in range(inputs):
            self._node(INPUT, k)

    def _node(self, *key: Any) -> int:
        if key not in self.known:
            self.known[key] = len(self.ops)
            self.ops.append(key)
        return self.known[key]

    def constant(self, value: float) -> int:
        """The node of a number."""
        return self._node(CONSTANT, float(value))

    def number(self, node: int) -> float | None:
        """The number of a constant, None of any other node."""
        return self.ops[node][1] if self.ops[node][0] == CONSTANT else None

    def put(self, op: str, *args: int) -> int:
        """The node of an operation, or what it comes to without rounding: x + 0, 1 x."""
        first, second = (*(self.number(a) for a in args[:2]), None)[:2]
        if op in ("add", "sub") and second == 0.0:
            return args[0]
        if op == "add" and first == 0.0:
            return args[1]
        if op == "sub" and first == 0.0:
            return self.put("neg", args[1])
        if op in ("mul", "div") and second == 1.0:
            return args[0]
        if op == "mul" and first == 1.0:
            return args[1]
        if op == "neg" and first is not None:
            return self.constant(-first)
        if op == "reciprocal":
            return self.put("div", self.constant(1.0), args[0])
        return self._node(op, *args)

    def times(self, factor: int, change: int | None) -> int | None:
        """A change times a factor, None where nothing changes."""
        return None if change is None else self.put("mul", factor, change)

    def plus(self, one: int | None, another: int | None) -> int | None:
        """The sum of two changes, each of which may be None."""
        if one is None or another is None:
            return another if one is None else one
        return self.put("add", one, another)


class Recorded:
    """A program of `size` inputs, the last `linear` of which it is linear in; `results` are nodes, None is zero.

    `frozen`: nodes that are taken not to change.
    """

    def __init__(
        self,
        nodes: Nodes,
        size: int,
        results: Sequence[int | None],
        *,
        linear: int = 0,
        frozen: frozenset[int] = frozenset(),
    ) -> None:
        self.nodes, self.size, self.linear, self.frozen = nodes, size, linear, frozen
        self.results = tuple(nodes.constant(0.0) if r is None else r for r in results)

    @lru_cache  # noqa: B019 - a program lives as long as its module
    def tangent(self, active: tuple[int, ...] | None = None, count: int | None = None) -> Recorded:
        """(x, dx) -> the first `count` results' change along dx, of the inputs in `active` (all)."""
        active = tuple(range(self.size)) if active is None else active
        nodes = Nodes(self.size + len(active))
        changes = {k: self.size + j for j, k in enumerate(active)}
        there: dict[int, int] = {}
        moved: dict[int, int | None] = {}
        for node in self.needed(self.results[:count]):
            op, *args = self.nodes.ops[node]
            if op == INPUT:
                there[node], moved[node] = args[0], changes.get(args[0])
            elif op == CONSTANT:
                there[node], moved[node] = nodes.constant(args[0]), None
            else:
                there[node] = nodes.put(op, *(there[a] for a in args))
                moving = node not in self.frozen and any(moved[a] is not None for a in args)
                own, change = [there[a] for a in args], [moved[a] for a in args]
                moved[node] = _change(nodes, op, there[node], args=own, moved=change) if moving else None
        size = self.size + len(active)
        return Recorded(nodes, size, [moved[r] for r in self.results[:count]], linear=len(active))

    @cached_property
    def adjoint(self) -> Recorded:
        """(x, c) -> the sum of c times what the results are linear in: the transpose of a linear program."""
        before = self.size - self.linear
        nodes = Nodes(before + len(self.results))
        order = self.needed(self.results)
        there: dict[int, int] = {}
        back: dict[int, int] = {}
        linear: set[int] = set()
        for node in order:
            op, *args = self.nodes.ops[node]
            if op == INPUT:
                if args[0] >= before:
                    linear.add(node)
                else:
                    there[node] = args[0]
            elif op == CONSTANT:
                there[node] = nodes.constant(args[0])
            elif any(a in linear for a in args):
                linear.add(node)
            else:
                there[node] = nodes.put(op, *(there[a] for a in args))
        for k, result in enumerate(self.results):
            if result in linear:
                back[result] = before + k if result not in back else nodes.put("add", back[result], before + k)
        chosen: set[int] = (
            set()
        )  # weights that are 0 where a choice fell on something else, whose slopes may be infinite
        found: list[int | None] = [None] * self.linear
        for node in reversed(order):
            if node not in linear or node not in back:
                continue
            op, *args = self.nodes.ops[node]
            own = back[node]
            if op == INPUT:
                found[args[0] - before] = own
                continue
            masked = own in chosen
            for arg, share in _shares(nodes, op, args, weight=own, there=there):
                if arg in linear:
                    weight = _unless_nothing(nodes, own, share) if masked and op in ("mul", "div") else share
                    masked_before = back.get(arg) in chosen
                    back[arg] = weight if arg not in back else nodes.put("add", back[arg], weight)
                    chosen |= {back[arg]} if masked or masked_before or op == "select" else set()
        return Recorded(nodes, before + len(self.results), found, linear=len(self.results))

    def needed(self, results: Sequence[int]) -> list[int]:
        """The nodes behind some results, in order."""
        needed = set(results)
        for node in range(max(needed, default=-1), -1, -1):
            op, *args = self.nodes.ops[node]
            if node in needed and op not in (INPUT, CONSTANT):
                needed.update(args)
        return sorted(needed)

    @cached_property
    def at_rest(self) -> Recorded:
        """The same with lengths of steps that do not change: where an iteration has converged they are 0."""
        ops = self.nodes.ops
        compared = {args[0] for op, *args in ops if op == "less"}
        frozen = frozenset(n for n in compared if ops[n][0] == "sqrt")
        return Recorded(self.nodes, self.size, self.results, linear=self.linear, frozen=frozen)

    @cached_property
    def table(self) -> Table:
        """The program as rows."""
        return Table(self)


def _change(nodes: Nodes, op: str, value: int, *, args: Sequence[int], moved: Sequence[int | None]) -> int | None:
    """The change of an operation's value by those of its operands (None: none)."""
    one, minus = nodes.constant(1.0), nodes.constant(-1.0)
    a, b = (*args, args[0])[:2]
    da, db = (*moved, None)[:2]
    if op == "add":
        return nodes.plus(da, db)
    if op == "sub":
        return nodes.put("sub", da, db) if da is not None and db is not None else nodes.plus(da, nodes.times(minus, db))
    if op == "neg":
        return nodes.times(minus, da)
    if op == "mul":
        return nodes.plus(nodes.times(b, da), nodes.times(a, db))
    if op == "div":
        whole = nodes.plus(da, nodes.times(nodes.put("neg", value), db))
        return nodes.times(nodes.put("div", one, b), whole)
    if op == "atan2":
        square = nodes.put("add", nodes.put("mul", a, a), nodes.put("mul", b, b))
        slopes = nodes.put("div", b, square), nodes.put("neg", nodes.put("div", a, square))
        return nodes.plus(nodes.times(slopes[0], da), nodes.times(slopes[1], db))
    if op == "select":
        zero = nodes.constant(0.0)
        chosen = [zero if d is None else d for d in moved[1:]]
        return None if moved[1] is None and moved[2] is None else nodes.put("select", a, *chosen)
    if op == "less":
        return None
    return nodes.times(_slope(nodes, op, value, a), da)


def _slope(nodes: Nodes, op: str, value: int, a: int) -> int:
    """The derivative of a function of one number."""
    one = nodes.constant(1.0)
    if op == "sin":
        return nodes.put("cos", a)
    if op == "cos":
        return nodes.put("neg", nodes.put("sin", a))
    if op == "tan":
        return nodes.put("add", one, nodes.put("mul", value, value))
    if op == "exp":
        return value
    if op == "sqrt":
        return nodes.put("div", nodes.constant(0.5), value)
    if op == "abs":
        return nodes.put("select", nodes.put("less", a, nodes.constant(0.0)), nodes.constant(-1.0), one)
    raise ValueError(f"{op} has no derivative")


def _unless_nothing(nodes: Nodes, weight: int, share: int) -> int:
    """A product with a weight, 0 where the weight is 0 and the product not finite; else its slopes stay."""
    zero = nodes.constant(0.0)
    finite = nodes.put("less", nodes.put("abs", share), nodes.constant(LARGEST))
    return nodes.put("select", finite, share, nodes.put("select", weight, share, zero))


def _shares(
    nodes: Nodes, op: str, args: Sequence[int], *, weight: int, there: Mapping[int, int]
) -> list[tuple[int, int]]:
    """What the weight of an operation's value comes to at its operands, where it is linear in them."""
    if op == "add":
        return [(args[0], weight), (args[1], weight)]
    if op == "sub":
        return [(args[0], weight), (args[1], nodes.put("neg", weight))]
    if op == "neg":
        return [(args[0], nodes.put("neg", weight))]
    if op == "mul":
        return [(x, nodes.put("mul", there[y], weight)) for x, y in (args, args[::-1]) if y in there]
    if op == "div":
        return [(args[0], nodes.put("div", weight, there[args[1]]))]
    if op == "select":
        zero, chosen = nodes.constant(0.0), there[args[0]]
        return [
            (args[1], nodes.put("select", chosen, weight, zero)),
            (args[2], nodes.put("select", chosen, zero, weight)),
        ]
    raise ValueError(f"{op} is not linear")


def record(listing: Callable[..., Sequence[Value | float]], size: int) -> Recorded:
    """The program of a listing: a function of `op` and as many values, which returns a tuple of some."""
    nodes = Nodes(size)
    found = listing(Functions(nodes), [Value(nodes, k) for k in range(size)])
    return Recorded(nodes, size, [x.node if isinstance(x, Value) else nodes.constant(x) for x in found])


class Table:
    """A program as instructions on rows of a memory, those of one value after its last use those of another.

    Rows are the inputs, then `constants`, then what is computed; `rows` is how many there are. `runs` are
    (operations, codes, places): instruction k does operations[codes[k]] on the rows places[k, :3] and writes row
    places[k, 3]. `results` are rows.
    """

    def __init__(self, program: Recorded) -> None:
        ops = program.nodes.ops
        needed = program.needed(program.results)
        numbers = dict.fromkeys(ops[n][1] for n in needed if ops[n][0] == CONSTANT)
        numbers |= {-1.0: None} if any(ops[n][0] == "neg" for n in needed) else {}
        self.constants = np.array([*numbers], dtype=float)
        places = {number: program.size + k for k, number in enumerate(numbers)}
        row = {n: ops[n][1] for n in needed if ops[n][0] == INPUT}
        row |= {n: places[ops[n][1]] for n in needed if ops[n][0] == CONSTANT}
        work = {}  # a negative is a product, exactly
        for n in needed:
            op, *args = ops[n]
            if op not in (INPUT, CONSTANT):
                work[n] = ("mul", args[0], None) if op == "neg" else (op, *args)
        uses = Counter(a for _, *args in work.values() for a in args if a is not None)
        uses.update(program.results)
        free: list[int] = []
        self.rows = program.size + len(numbers)
        self.runs: list[tuple[tuple[str, ...], np.ndarray, np.ndarray]] = []
        for run in _in_runs(work):
            operations: list[str] = []
            codes: list[int] = []
            lines: list[list[int]] = []
            for n in run:
                op, *args = work[n]
                read = [places[-1.0] if a is None else row[a] for a in args]
                for a in {*args} - {None}:
                    uses[a] -= args.count(a)
                    if not uses[a] and a in work:
                        heapq.heappush(free, row[a])
                row[n] = heapq.heappop(free) if free else self.rows
                self.rows = max(self.rows, row[n] + 1)
                operations += [] if op in operations else [op]
                codes.append(operations.index(op))
                lines.append([*(read + 2 * read[:1])[:3], row[n]])
            self.runs.append((tuple(operations), np.array(codes, np.int32), np.array(lines, np.int32)))
        self.results = np.array([row[n] for n in program.results], np.int32)


def _in_runs(work: Mapping[int, tuple[Any, ...]]) -> Iterator[list[int]]:
    """The operations in an order of evaluation with few changes between arithmetic and all else."""
    users: dict[int, list[int]] = defaultdict(list)
    missing: dict[int, int] = {}
    ready: tuple[list[int], list[int]] = ([], [])
    for n, (op, *args) in work.items():
        before = {a for a in args if a in work}
        missing[n] = len(before)
        for a in before:
            users[a].append(n)
        if not before:
            heapq.heappush(ready[op in ARITHMETIC], n)
    kind = 0
    while any(ready):
        kind = kind if ready[kind] else 1 - kind
        run = []
        while ready[kind]:
            n = heapq.heappop(ready[kind])
            run.append(n)
            for user in users[n]:
                missing[user] -= 1
                if not missing[user]:
                    heapq.heappush(ready[work[user][0] in ARITHMETIC], user)
        yield run

"""Lowering: from nodes of the tape to a straight-line program.

    Function (ports, nodes) --passes--> other nodes for the same values --Lowering--> Program (instructions on slots)

What no result needs is never reached, so it costs nothing. Equal instructions are one; a product with a reciprocal
that nothing else reads is a quotient, the negative of a difference is the difference the other way round.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from symscrew.algebra import Node, Origin, Tape, TapeMark, tape_as_at, tape_mark, uses
from symscrew.program.equal_limbs import NO_LIMBS, Limbs
from symscrew.program.passes import PASSES
from symscrew.program.straight_line import Instruction, Port, Program, signature

FORMED = frozenset(("mul", "neg"))  # operations that may be printed as others: see `_Lowering._form`
NodeLimit = tuple[Node, float | None, float | None, int]


@dataclass(frozen=True)
class Function:
    """A function of the model before lowering: ports and the nodes behind them.

    `arguments` and `results` are the nodes of each input and output, `size` of them. `guards`: (node, threshold):
    the function fails with status 1 where |node| <= threshold. `limits`: (node, low, high, status): it fails with this
    status where the node is not within low ... high (None: no limit); `reach`: see `Program`. `limbs` says which parts
    of the mechanism are equal.
    """

    name: str
    description: str
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    arguments: tuple[tuple[Node, ...], ...]
    results: tuple[tuple[Node, ...], ...]
    guards: tuple[tuple[Node, float], ...] = ()
    notes: tuple[str, ...] = ()
    limbs: Limbs = NO_LIMBS
    limits: tuple[NodeLimit, ...] = ()
    reach: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"Function({signature(self.name, self.inputs, self.outputs)})"


def lower(function: Function, mark: TapeMark | None = None) -> Program:
    """The program of a function: all passes in their order, then instructions.

    What the passes make is for this function alone: the tape is as before afterwards. With the `mark` at which all
    functions of a model had their nodes, the program is the same whenever it is asked for.

    Raises:
        ValueError: a result depends on an input of the model that is not among the function's.
    """
    roots = roots_of(function)
    tape = next((node.tape for node in (*roots, *itertools.chain(*function.arguments))), Tape())
    mark = mark or tape_mark(tape)
    with tape_as_at(tape, mark):
        for rewritten in PASSES:
            roots = rewritten(roots)
        return _Lowering(with_roots(function, roots), uses(roots), mark.nodes).program()


def roots_of(function: Function) -> list[Node]:
    """All results, then the guarded pivots, then what has limits."""
    results = [n for nodes in function.results for n in nodes]
    return [*results, *(pivot for pivot, _ in function.guards), *(node for node, *_ in function.limits)]


def with_roots(function: Function, roots: Sequence[Node]) -> Function:
    """The function with other results and guarded pivots, in the order of `roots_of`."""
    left = iter(roots)
    results = tuple(tuple(next(left) for _ in nodes) for nodes in function.results)
    guards = tuple((next(left), t) for _, t in function.guards)
    limits = tuple((next(left), low, high, status) for _, low, high, status in function.limits)
    return replace(function, results=results, guards=guards, limits=limits)


class _Lowering:
    """Gives slots to nodes and writes their instructions, each once; `uses` says how often a node is read.

    `shared`: the index of the first node that is not every function's, but made by the passes.
    """

    def __init__(self, function: Function, uses: Mapping[int, int], shared: int) -> None:
        self.function, self.uses, self.shared = function, uses, shared
        self.folded: dict[Node, None] = {}  # constants of the passes, which stay on no tape
        self.slot: dict[int, int | float] = {}  # of a node; for a constant, its value
        self.instructions: list[Instruction] = []
        self.made: dict[tuple[object, ...], int] = {}
        self.negatives: list[Node] = []
        self.next = itertools.count()
        for node in itertools.chain.from_iterable(function.arguments):
            self.slot[node.index] = next(self.next)

    def program(self) -> Program:
        """All results first, then the guards that are not among what these need."""
        results = tuple(tuple(self.value(n) for n in nodes) for nodes in self.function.results)
        guards: dict[int, float] = {}
        for node, threshold in self.function.guards:
            inner = node.args[0] if node.op == "neg" else node  # |-x| = |x|
            slot = self.value(inner)
            if isinstance(slot, int):  # of several thresholds for one pivot the largest says it all
                guards[slot] = max(threshold, guards.get(slot, threshold))
        tested = [(self.value(limit[0]), limit[1:]) for limit in self.function.limits]
        limits = tuple((slot, *rest) for slot, rest in tested if isinstance(slot, int))
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
            self.origins(),
            f.limbs,
            limits,
            f.reach,
            tuple(self.folded),
        )

    def origins(self) -> dict[int, Origin]:
        """Where slots come from: inputs by their ports, results too that have no name of the theory."""
        function = self.function
        found: dict[int, Origin] = {}
        for port, nodes in zip(function.inputs, function.arguments, strict=True):
            found |= {self.slot[n.index]: _at_port(port, k) for k, n in enumerate(nodes)}  # type: ignore[misc]
        every = (n for nodes in (*function.arguments, *function.results) for n in nodes)
        tape = next((n.tape for n in every), Tape())
        slots, known = self.slot, tape.origins
        for index in [index for index in slots if index in known]:
            found.setdefault(slots[index], known[index])  # type: ignore[arg-type]
        for node in self.negatives:
            origin = known.get(node.args[0].index)
            if origin is not None:
                found.setdefault(slots[node.index], origin.opposite)  # type: ignore[arg-type]
        for port, nodes in zip(function.outputs, function.results, strict=True):
            for k, node in enumerate(nodes):
                slot = self.slot[node.index]
                if isinstance(slot, int):
                    found.setdefault(slot, _at_port(port, k))
        return found

    def value(self, root: Node) -> int | float:
        """Slot or constant of a node, emitting what it needs first (without recursion in depth)."""
        slot, emit = self.slot, self._emit
        stack: list[Node | tuple[int, str, tuple[Node, ...]]] = [root]  # to come to; or operands are there, to emit
        while stack:
            item = stack.pop()
            if type(item) is tuple:
                index, op, args = item
                slot[index] = emit(op, _slots(slot, args))
                continue
            node: Node = item  # type: ignore[assignment]
            if node.index in slot:
                continue
            if node.value is not None:
                slot[node.index] = node.tape.double(node)
                if node.index >= self.shared:
                    self.folded[node.args[0] if node.op == "neg" else node] = None
                continue
            if node.op == "symbol":
                raise ValueError(
                    f"function {self.function.name} uses {node.args[0].name}, which is not among its inputs "
                    f"({', '.join(p.name for p in self.function.inputs)})"
                )
            op, args = self._form(node) if node.op in FORMED else (node.op, node.args)
            missing = [arg for arg in args if arg.index not in slot]
            if missing:
                stack.append((node.index, op, args))
                stack += missing[::-1]
            else:
                slot[node.index] = emit(op, _slots(slot, args))
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
            self.negatives.append(node)
            return self._turned(args[0]) or (op, args)
        return op, args

    def _turned(self, node: Node) -> tuple[str, tuple[Node, ...]] | None:
        """The negative of a node in place of it, if that takes no operation more: -(x (y - z) + w) is x (z - y) - w."""
        if not self._turns(node):
            return None
        x, y = node.args
        if node.op == "sub":
            return "sub", (y, x)
        first = x.value is not None or self._turns(x)
        minus, other = (node.tape.neg(x), y) if first else (node.tape.neg(y), x)
        return ("sub" if node.op == "add" else "mul"), (minus, other)

    def _turns(self, node: Node) -> bool:
        """Whether a difference that nothing else reads can be the other way round for the negative of a node."""
        waiting = [node]
        while waiting:
            here = waiting.pop()
            if self._single(here):
                if here.op == "sub" or (here.op == "mul" and here.args[0].value is not None):
                    return True
                if here.op in ("add", "mul"):
                    waiting += here.args[::-1]
        return False

    def _emit(self, op: str, args: tuple[int | float, ...]) -> int:
        # slot 2 and the constant 2.0 are equal, and not the same
        key = (op, args, tuple(map(type, args))) if float in map(type, args) else (op, args)
        target = self.made.get(key)
        if target is None:
            self.made[key] = target = next(self.next)
            self.instructions.append(Instruction(target, op, args))
        return target


def _slots(slot: Mapping[int, int | float], args: tuple[Node, ...]) -> tuple[int | float, ...]:
    """The slots of operands, of which there are two nearly everywhere."""
    if len(args) == 2:
        x, y = args
        return slot[x.index], slot[y.index]
    return tuple([slot[a.index] for a in args])


def _at_port(port: Port, k: int) -> Origin:
    """Entry k of a port: labels are `part`, `part.component` or, of coefficients, `...|by`."""
    label, _, by = (port.labels[k] if k < len(port.labels) else "").partition("|")
    part, _, component = label.partition(".")
    return Origin(port.name, part, component if port.labels else str(k), by)


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

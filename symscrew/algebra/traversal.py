"""What stands behind nodes: their operations in order, inputs, counts; the same expressions over other nodes.

outputs --walk over arguments--> operations, inputs     outputs, {node: other} --substitute--> outputs over others
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.algebra.naming import handed_on
from symscrew.algebra.nodes import Node, Tape

TURNS = frozenset(("sin", "cos"))
LEAVES = frozenset(("symbol", "const"))  # nodes that read no others
# Operations that a machine does while a division waits for another one: a division or root takes 13 to 20 cycles, and
# about every second one finds something else to do. With 0, `cost` would prefer few operations in one long chain.
WAIT = 8
# Operations that a sine and a cosine of one angle take in a vector of four. With 0, `cost` would prefer ways that read
# angles which others do not need at all, as rods by their ends do not.
ANGLE = 10


def evaluation_order(outputs: Sequence[Node], given: Mapping[int, object]) -> list[Node]:
    """Nodes behind the outputs, constants apart, down to the given ones (by index); arguments come first."""
    found: dict[int, Node] = {}
    stack = list(outputs)
    while stack:
        node = stack.pop()
        if node.index not in found and node.value is None:
            found[node.index] = node
            if node.index not in given and node.op != "symbol":
                stack.extend(node.args)
    return [found[index] for index in sorted(found)]


def needed(results: Sequence[Node]) -> set[Node]:
    """Operations that the results need, themselves included."""
    return {node for node in _reached(results) if node.value is None and node.op != "symbol"}


def inputs_of(results: Sequence[Node]) -> set[Node]:
    """Inputs on which the results depend."""
    return {node for node in _reached(results) if node.op == "symbol"}


def _reached(results: Sequence[Node]) -> set[Node]:
    found = set(results)
    waiting = list(found)
    for node in waiting:  # which grows meanwhile
        if node.value is None and node.op != "symbol":
            for arg in node.args:
                if arg not in found:
                    found.add(arg)
                    waiting.append(arg)
    return found


def count_operations(results: Sequence[Node]) -> int:
    """How many operations the results take."""
    return len(needed(results))


def cost(results: Sequence[Node]) -> int:
    """What results take, in operations: the one measure by which equal ways to the same numbers are compared.

    Operations, `WAIT` for each division or root in the longest chain of them, and `ANGLE` for each angle.
    """
    seen = set(results)
    found = [node for node in seen if node.value is None and node.op != "symbol"]
    for node in found:  # which grows meanwhile
        for arg in node.args:
            if arg not in seen:
                seen.add(arg)
                if arg.value is None and arg.op != "symbol":
                    found.append(arg)
    longest = max((node.chain for node in results), default=0)
    angles = {node.args[0] for node in found if node.op in TURNS}
    return len(found) + WAIT * longest + ANGLE * len(angles)


def uses(roots: Sequence[Node]) -> Mapping[int, int]:
    """How often each node that the roots need, by index, is an operand or a root; in the order of the tape.

    The tape keeps the last answer: passes that change nothing hand on the same roots.
    """
    if not roots:
        return {}
    tape, asked = roots[0].tape, tuple(roots)
    if tape.counted is not None and tape.counted[0] == asked:
        return tape.counted[1]
    found: dict[int, int] = {}
    waiting: list[Node] = []
    read: Sequence[Node] = asked
    following = iter(waiting)
    while True:
        for node in read:
            index = node.index
            if index in found:
                found[index] += 1
            else:
                found[index] = 1
                if node.op not in LEAVES:
                    waiting.append(node)
        further = next(following, None)
        if further is None:
            tape.counted = asked, dict(sorted(found.items()))
            return tape.counted[1]
        read = further.args


def substitute(tape: Tape, nodes: Sequence[Node], replaced: Mapping[Node, Node]) -> list[Node]:
    """The nodes with some nodes behind them replaced by others, all that reads these folded anew."""
    done = {node.index: other for node, other in replaced.items()}
    stack = list(nodes)
    while stack:
        node = stack[-1]
        if node.index in done:
            stack.pop()
            continue
        args = () if node.value is not None or node.op == "symbol" else node.args
        missing = [a for a in args if a.index not in done]
        if missing:
            stack.extend(missing)
        else:
            new = [done[a.index] for a in args]
            same = all(a is b for a, b in zip(args, new, strict=True))
            done[node.index] = node if same else handed_on(node, remade(tape, node.op, new))
    return [done[node.index] for node in nodes]


def remade(tape: Tape, op: str, args: Sequence[Node]) -> Node:
    """An operation on other arguments, folded anew."""
    if op == "sub":
        return args[0] - args[1]
    if op in ("add", "mul", "neg", "reciprocal"):
        made: Node = getattr(tape, op)(*args)
        return made
    return tape.function(op, *args)

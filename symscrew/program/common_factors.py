"""Common factors: a b + a c becomes a (b + c) where neither product serves anything else."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.algebra import Node, remade


def factored(roots: Sequence[Node]) -> tuple[list[Node], dict[int, int]]:
    """The same expressions with common factors taken out, and how often each node is then an operand or a root."""
    uses = _uses(roots)
    new: dict[int, Node] = {}  # what is written in another way
    for index in sorted(uses):
        node = roots[0].tape.nodes[index]
        if node.op in ("add", "sub"):
            made = _factor(node, uses, new)
        elif node.op not in ("symbol", "const") and any(a.index in new for a in node.args):
            made = remade(node.tape, node.op, [new.get(a.index, a) for a in node.args])
        else:
            continue
        if made is not node:
            new[index] = made
    if not new:
        return list(roots), uses
    found = [new.get(root.index, root) for root in roots]
    return found, _uses(found)


def _uses(roots: Sequence[Node]) -> dict[int, int]:
    """How often each node that the roots need is an operand or a root."""
    uses: dict[int, int] = {}
    stack: list[Node] = []
    needed: Sequence[Node] = roots
    while True:
        for node in needed:
            index = node.index
            if index in uses:
                uses[index] += 1
            else:
                uses[index] = 1
                if node.op not in ("symbol", "const"):
                    stack.append(node)
        if not stack:
            return uses
        needed = stack.pop().args


def _factor(node: Node, uses: Mapping[int, int], new: Mapping[int, Node]) -> Node:
    """A sum or difference; of two products that nothing else needs, with a common factor, as one product."""
    tape = node.tape
    x, y = (new.get(a.index, a) for a in node.args)
    if x.op == "mul" and y.op == "mul" and all(uses[old.index] == 1 for old in node.args):
        for common in x.args:
            if common in y.args:
                rest = [next((a for a in product.args if a is not common), common) for product in (x, y)]
                inner = tape.add(rest[0], rest[1] if node.op == "add" else tape.neg(rest[1]))
                return tape.mul(common, inner)
    if (x, y) == node.args:
        return node
    return tape.add(x, y if node.op == "add" else tape.neg(y))

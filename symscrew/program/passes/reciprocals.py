"""Divisions that follow from others: where 1 / (x y) is needed anyway, 1 / x is y times that.

A division takes as long as four to eight products. The pivots of a limb are often products of each other: the length
of a leg, and its length times the cosine of its lean. A division per leg goes in 30 functions of the seed and 14 of
the Stewart platform, for 0 to 3 products each.

Left out, single calls take this much more (+) or less time, limb by limb / with limbs in lanes: seed drives +11 / +1 %,
reactions +5 / +16 %, forward dynamics -2 / -1 %; 6-UPS drives +8 / -1 %, reactions +2 / +6 %, forward dynamics
-5 / -5 %, where the divisions do not wait for each other.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import LEAVES, Node, handed_on, remade, uses

INVERTED = frozenset(("reciprocal", "mul"))


def shared_reciprocals(roots: Sequence[Node]) -> list[Node]:
    """The same expressions with fewer divisions."""
    if not any(root.chain for root in roots):
        return list(roots)  # none has a division
    nodes = roots[0].tape.nodes
    order = [node for node in map(nodes.__getitem__, uses(roots)) if node.op in INVERTED]
    inverted = {node.args[0].index for node in order if node.op == "reciprocal"}
    replaced: dict[int, tuple[Node, Node]] = {}  # reciprocal of x -> (y, 1 / (x y))
    for product in (node for node in order if node.op == "mul" and node.index in inverted):
        for x, y in (product.args, product.args[::-1]):
            if x.index in inverted and y.value is None:
                single = x.tape.reciprocal(x)
                whole = x.tape.reciprocal(product)
                if single.index not in replaced and not _depends(whole, single, replaced):
                    replaced[single.index] = (y, whole)
    if not replaced:
        return list(roots)
    return _rebuilt(roots, replaced)


def _depends(node: Node, on: Node, replaced: dict[int, tuple[Node, Node]]) -> bool:
    """Whether `on` stands behind a node once reciprocals are replaced."""
    stack, seen = [node], set()
    while stack:
        here = stack.pop()
        if here is on:
            return True
        if here.index not in seen and here.op not in LEAVES:
            seen.add(here.index)
            stack += replaced.get(here.index, here.args)
    return False


def _rebuilt(roots: Sequence[Node], replaced: dict[int, tuple[Node, Node]]) -> list[Node]:
    """The roots with their reciprocals replaced; arguments first, in an order of their own."""
    nodes, new = roots[0].tape.nodes, dict[int, Node]()
    for index in uses(roots):  # arguments come first
        node = nodes[index]
        if index not in replaced and (node.op in LEAVES or all(arg.index in new for arg in node.args)):
            new[index] = node  # nothing behind it is replaced
    stack = list(roots)
    while stack:
        node = stack[-1]
        if node.index in new:
            stack.pop()
            continue
        if node.op in LEAVES:
            new[node.index] = node
            continue
        needed = replaced.get(node.index, node.args)
        missing = [arg for arg in needed if arg.index not in new]
        if missing:
            stack += missing
            continue
        args = tuple(new[arg.index] for arg in needed)
        if node.index in replaced:
            new[node.index] = handed_on(node, node.tape.mul(*args))
        else:
            new[node.index] = node if args == node.args else handed_on(node, remade(node.tape, node.op, args))
    return [new[root.index] for root in roots]

"""Small differences of squares: c - k cos(x)^2 becomes (c - k) + k sin(x)^2, where c is at least k.

Both take as many operations where the sine is needed anyway. The first loses the digits that c and k cos(x)^2 have in
common: a light cart under a pole has the inertia (m + M) - M cos(x)^2, and where the pole is upright six digits of it
are lost with a cart of a millionth of the pole's mass. A sum of positive numbers loses none.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.algebra import Node, substitute, uses

OTHER = {"cos": "sin", "sin": "cos"}


def complemented(roots: Sequence[Node]) -> list[Node]:
    """The same expressions without differences that lose digits."""
    read, nodes = uses(roots), roots[0].tape.nodes if roots else []
    tried = [node for node in map(nodes.__getitem__, read) if node.op == "sub" and node.args[0].value is not None]
    tried = [node for node in tried if read[node.args[1].index] == 1]
    if not tried:
        return list(roots)
    turned = (node for node in map(nodes.__getitem__, read) if node.op in OTHER)
    functions = {(node.op, node.args[0].index): node for node in turned}
    found: dict[Node, Node] = {}
    for node in tried:  # in the order of the tape, the same on every run
        made = _complement(node, functions, read)
        if made is not None:
            found[node] = made
    return substitute(roots[0].tape, roots, found) if found else list(roots)


def _complement(node: Node, functions: Mapping[tuple[str, int], Node], read: Mapping[int, int]) -> Node | None:
    """(c - k) + k s^2 for c - k f^2, where the other function s of f's angle is there."""
    tape, (whole, product) = node.tape, node.args
    factors = _factors(product, read)
    constants = [x for x in factors if x.value is not None]
    rest = [x for x in factors if x.value is None]
    if len(rest) != 2 or rest[0] is not rest[1] or rest[0].op not in OTHER or len(constants) > 1:
        return None
    other = functions.get((OTHER[rest[0].op], rest[0].args[0].index))
    part = constants[0] if constants else tape.node(1)
    if other is None or not whole.value >= part.value > 0:
        return None
    return tape.add(whole - part, part * (other * other))


def _factors(product: Node, read: Mapping[int, int]) -> list[Node]:
    """What is multiplied, down to what something else reads too."""
    if product.op != "mul":
        return [product]
    return [y for x in product.args for y in (_factors(x, read) if read.get(x.index) == 1 else [x])]

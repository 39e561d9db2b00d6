"""Common factors: a b + a c becomes a (b + c) where neither product serves anything else.

One product fewer each time. Sums and products are looked at as a whole, down to what something else reads too: so
x (y v) + u (z v) becomes v (x y + u z) wherever in a sum the two stand, and x (y z) + y (x z), as derivatives of
products are, one product twice.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra import LEAVES, Node, handed_on, needed, remade, uses

SUMS = frozenset(("add", "sub"))
LONG = 8
"""Factors of products that are compared as a whole: of more, products of products that others read grow without end."""


@dataclass(frozen=True)
class _Product:
    """A term of a sum: the number of its place, whether it is subtracted, and its factors.

    `factors`: down to what something else reads too; `whole`: all of them, by index, None of many.
    """

    place: int
    negative: bool
    factors: tuple[Node, ...]
    whole: tuple[int, ...] | None = None

    @property
    def node(self) -> Node:
        """The product, without its sign: divided in the end, by one after the other."""
        divisors = [factor for factor in self.factors if factor.op == "reciprocal"]
        made, *others = [factor for factor in self.factors if factor.op != "reciprocal"][::-1] + divisors
        for factor in others:
            made = factor * made
        return made


def factored(roots: Sequence[Node]) -> list[Node]:
    """The same expressions with common factors taken out, if operations become fewer by it.

    A factored result may be the negative of what the tape holds, which is one operation more where nothing reads it.
    """
    found = _factored(roots)
    return found if found != roots and len(needed(found)) < len(needed(roots)) else list(roots)


def _factored(roots: Sequence[Node]) -> list[Node]:
    read = uses(roots)
    nodes = roots[0].tape.nodes if roots else []
    sums = [node for node in map(nodes.__getitem__, read) if node.op in SUMS]
    inner = {a.index for node in sums for a in node.args if a.op in SUMS and read[a.index] == 1}
    new: dict[int, Node] = {}  # what is written in another way
    for index in read:  # arguments come first on the tape
        node = nodes[index]
        if node.op in SUMS:
            if index in inner:  # part of a sum that comes later
                continue
            made = _Sum(node, read, new).made()
        elif new and node.op not in LEAVES and any(a.index in new for a in node.args):
            made = remade(node.tape, node.op, [new.get(a.index, a) for a in node.args])
        else:
            continue
        if made is not node:
            new[index] = handed_on(node, made)
    return [new.get(root.index, root) for root in roots]


class _Sum:
    """A sum with the sums in it that nothing else reads."""

    def __init__(self, root: Node, read: Mapping[int, int], new: Mapping[int, Node]) -> None:
        self.root, self.read, self.new = root, read, new
        self.terms: list[tuple[Node, bool]] = []  # and whether they are subtracted, in their order
        stack = [(root, False)]
        while stack:
            node, negative = stack.pop()
            if self._goes_on(node):
                x, y = node.args
                stack += [(y, negative != (node.op == "sub")), (x, negative)]
            else:
                self.terms.append((node, negative))

    def _goes_on(self, node: Node) -> bool:
        return node.op in SUMS and (node is self.root or self.read[node.index] == 1)

    def made(self) -> Node:
        """The sum with common factors taken out, the other terms where they were."""
        terms = [self.new.get(node.index, node) for node, _ in self.terms]
        for place, product in self._joined().items():
            if product is None:
                terms[place] = self.root.tape.zero
            else:
                negated = product.negative != self.terms[place][1]
                terms[place] = -product.node if negated else product.node
        return self._with(iter(terms))

    def _with(self, terms: Iterator[Node]) -> Node:
        """The sum of other terms, in the same order."""
        stack: list[tuple[Node, bool]] = [(self.root, False)]  # and whether its operands are there
        made: list[Node] = []
        while stack:
            node, there = stack.pop()
            if there:
                y, x = made.pop(), made.pop()
                made.append(node if (x, y) == node.args else x + y if node.op == "add" else x - y)
            elif self._goes_on(node):
                stack += [(node, True), (node.args[1], False), (node.args[0], False)]
            else:
                made.append(next(terms))
        return made[0]

    def _joined(self) -> dict[int, _Product | None]:
        """Products by the place of a term that they take; None: its place is empty."""
        products = [self._product(n, *term) for n, term in enumerate(self.terms) if term[0].op == "mul"]
        if not _something_twice(products):
            return {}
        joined: dict[int, _Product | None] = {}
        while True:
            pairs = [(i, j) for j in range(len(products)) for i in range(j)]
            gain, i, j = max(((_gain(products[i], products[j]), -i, -j) for i, j in pairs), default=(0, 0, 0))
            if not gain:
                return joined
            one, other = products[-i], products.pop(-j)
            joined[other.place] = None
            joined[one.place] = products[-i] = _together(one, other)

    def _product(self, place: int, node: Node, negative: bool) -> _Product:
        factors: list[Node] = []
        stack = [node]
        while stack:
            here = stack.pop()
            if here.op == "mul" and self.read[here.index] == 1:
                stack += here.args[::-1]
                continue
            here = self.new.get(here.index, here)
            if here.op == "neg":
                here, negative = here.args[0], not negative
            factors.append(here)
        return _Product(place, negative, tuple(factors), _whole(factors))


def _whole(factors: Sequence[Node]) -> tuple[int, ...] | None:
    found: list[int] = []
    stack = list(factors)
    while stack and len(found) + len(stack) <= LONG:
        here = stack.pop()
        if here.op == "mul":
            stack += here.args
        else:
            found.append(here.index)
    return None if stack else tuple(sorted(found))


def _something_twice(products: Sequence[_Product]) -> bool:
    """Whether any two have something in common at all."""
    if len(products) < 2:
        return False
    factors = [factor for product in products for factor in set(product.factors)]
    wholes = [product.whole for product in products if product.whole is not None]
    return len(set(factors)) < len(factors) or len(set(wholes)) < len(wholes)


def _gain(one: _Product, other: _Product) -> int:
    """Operations fewer where two products are one."""
    if one.whole is not None and one.whole == other.whole:
        return max(len(one.factors), len(other.factors))
    common, left, right = _common(one.factors, other.factors)
    return len(common) if left and right else 0


def _together(one: _Product, other: _Product) -> _Product:
    """Two products as one."""
    tape, alike = one.factors[0].tape, one.negative == other.negative
    if one.whole is not None and one.whole == other.whole:
        shorter = min(one.factors, other.factors, key=len)
        return _Product(one.place, one.negative, (tape.node(2) if alike else tape.zero, *shorter))
    common, left, right = _common(one.factors, other.factors)
    x, y = _Product(0, False, left).node, _Product(0, False, right).node
    rest, negative = (x + y if alike else x - y), one.negative
    if rest.op == "neg":
        rest, negative = rest.args[0], not negative
    return _Product(one.place, negative, (*common, rest))


def _common(one: Sequence[Node], other: Sequence[Node]) -> tuple[tuple[Node, ...], tuple[Node, ...], tuple[Node, ...]]:
    """Factors of both, and what each has besides."""
    common, left, right = [], [], list(other)
    for factor in one:
        if factor in right:
            right.remove(factor)
            common.append(factor)
        else:
            left.append(factor)
    return tuple(common), tuple(left), tuple(right)

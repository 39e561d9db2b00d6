"""Common factors: a b + a c becomes a (b + c) where neither product serves anything else.

One product fewer each time. Sums and products are looked at as a whole, down to what something else reads too: so
x (y v) + u (z v) becomes v (x y + u z) wherever in a sum the two stand, and x (y z) + y (x z), as derivatives of
products are, one product twice.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra import LEAVES, Node, handed_on, remade, uses

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
    before = uses(roots)
    found = _factored(roots, before)
    return found if found != roots and _operations(found, uses(found)) < _operations(roots, before) else list(roots)


def _operations(roots: Sequence[Node], read: Mapping[int, int]) -> int:
    """How many operations the roots take, of what they need by index."""
    nodes = roots[0].tape.nodes
    return sum(nodes[index].value is None and nodes[index].op != "symbol" for index in read)


def _factored(roots: Sequence[Node], read: Mapping[int, int]) -> list[Node]:
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
        joined, new = self._joined(), self.new
        if not joined and not any(node.index in new for node, _ in self.terms):
            return self.root  # as most sums are
        terms = [new.get(node.index, node) for node, _ in self.terms]
        for place, product in joined.items():
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
        found = [(n, *self._factors(*term)) for n, term in enumerate(self.terms) if term[0].op == "mul"]
        if not _something_twice([factors for _, _, factors in found]):
            return {}
        products = [_Product(*product, _whole(product[2])) for product in found]
        joined: dict[int, _Product | None] = {}
        pairs = _Pairs(products)
        while (best := pairs.best()) is not None:
            one, other = (products[k] for k in best)
            joined[other.place] = None
            joined[one.place] = products[best[0]] = _together(one, other)
            pairs.join(*best)
        return joined

    def _factors(self, node: Node, negative: bool) -> tuple[bool, tuple[Node, ...]]:
        """Whether a product is subtracted, and its factors, down to what something else reads too."""
        factors: list[Node] = []
        stack, read, new = [node], self.read, self.new
        while stack:
            here = stack.pop()
            if here.op == "mul" and read[here.index] == 1:
                stack += here.args[::-1]
                continue
            here = new.get(here.index, here)
            if here.op == "neg":
                here, negative = here.args[0], not negative
            factors.append(here)
        return negative, tuple(factors)


class _Pairs:
    """Pairs of products by what is gained where they are one; only those with something in common are looked at.

    A sum of hundreds of products, as the energy of a long chain is, has ten thousands of pairs.
    """

    def __init__(self, products: list[_Product]) -> None:
        self.products = products
        self.joins = [0] * len(products)  # of each: what was said of it before the last is no longer true
        self.alive = [True] * len(products)
        self.having: dict[Node | tuple[int, ...], list[int]] = {}
        self.heap: list[tuple[int, int, int, int, int]] = []  # -gain, i < j, and how often each was joined
        for k in range(len(products)):
            self._add(k)

    def best(self) -> tuple[int, int] | None:
        """The pair with the largest gain, the first of several; None where none gains."""
        while self.heap:
            _, i, j, first, second = heapq.heappop(self.heap)
            if self.alive[i] and self.alive[j] and (first, second) == (self.joins[i], self.joins[j]):
                return i, j
        return None

    def join(self, i: int, j: int) -> None:
        """Product j is in product i now, which is another one."""
        self.alive[j] = False
        self.joins[i] += 1
        self._add(i)

    def _add(self, k: int) -> None:
        product = self.products[k]
        keys = dict.fromkeys((*product.factors, *((product.whole,) if product.whole is not None else ())))
        for other in sorted({n for key in keys for n in self.having.get(key, ()) if self.alive[n] and n != k}):
            i, j = min(k, other), max(k, other)
            gain = _gain(self.products[i], self.products[j])
            if gain:
                heapq.heappush(self.heap, (-gain, i, j, self.joins[i], self.joins[j]))
        for key in keys:
            self.having.setdefault(key, []).append(k)


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


def _something_twice(products: Sequence[tuple[Node, ...]]) -> bool:
    """Whether any two products, given by their factors, have something in common at all."""
    if len(products) < 2:
        return False
    factors = [factor for product in products for factor in set(product)]
    if len(set(factors)) < len(factors):
        return True
    if not any(factor.op == "mul" for factor in factors):
        return False  # as a whole they are their factors
    wholes = [whole for whole in map(_whole, products) if whole is not None]
    return len(set(wholes)) < len(wholes)


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

"""Derivatives on the tape: the chain rule as elimination of vertices from the linearised program.

The nodes between the seeds and the outputs make a graph whose edges carry local partial derivatives. Taking
out a vertex joins each of its predecessors with each of its successors by the product of the two edges,
added to the edge that may be there; when only seed directions and outputs are left, the edges between
them are the derivatives (Griewank and Walther, Evaluating Derivatives, 2008, sec. 9.2). Taking vertices out
in order of evaluation is forward mode, in the opposite order reverse mode, and cheapest vertex first
(Markowitz) often shares what both repeat. The order with the fewest operations is used; all give the same.

Zeros are never edges, signs and ones cost nothing, and equal products are one node, as everywhere on the tape.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from symscrew.algebra.nodes import Node, Tape
from symscrew.algebra.traversal import count_operations, evaluation_order

Direction = str
Vertex = int | tuple[str, int | Direction]
Edges = dict[Vertex, Node]
Readers = dict[Vertex, None]  # in order, which sets have by hashes of texts: they differ from run to run
ORDERS = ("forward", "reverse", "markowitz")
# The rough count of an order does not see that equal products are one node, which saves up to a quarter. An order is
# built and counted exactly if its rough count is within this factor of the best; one beyond is never built.
PROMISING = 1.3


@dataclass
class Graph:
    """The linearised program: edges by predecessor and by successor, and its vertices in order of evaluation."""

    into: dict[Vertex, Edges]
    out: dict[Vertex, Readers]
    order: list[int]


def differentiate(
    tape: Tape,
    outputs: Sequence[Node],
    seeds: Mapping[Node, Mapping[Direction, Node]],
    directions: Sequence[Direction],
    *,
    order: str | None = None,
) -> list[list[Node]]:
    """d outputs[i] / d directions[j] as nodes, shape [outputs][directions].

    Args:
        tape: the tape of all nodes.
        outputs: what to differentiate.
        seeds: per node its derivative along each direction (zeros left out). A node given here is taken as
            an independent variable: what stands behind it is not looked at, so an empty mapping holds it fixed.
        directions: the columns of the result.
        order: "forward", "reverse" or "markowitz"; default: the one with the fewest operations.

    Raises:
        ValueError: no such order, or an operation whose derivative is not known.
    """
    if order is not None and order not in ORDERS:
        raise ValueError(f"expected an order of elimination among {', '.join(ORDERS)}, got {order!r}")
    graph = linearise(tape, outputs, seeds)
    names = (order,) if order else _promising(graph)
    best: list[list[Node]] = []
    fewest = None
    for name in names:
        into = _eliminated(tape, graph, name)
        found = [[into["output", i].get(("direction", d), tape.zero) for d in directions] for i in range(len(outputs))]
        operations = count_operations([n for row in found for n in row]) if len(names) > 1 else 0
        if fewest is None or operations < fewest:
            best, fewest = found, operations
    return best


def linearise(tape: Tape, outputs: Sequence[Node], seeds: Mapping[Node, Mapping[Direction, Node]]) -> Graph:
    """The graph of local derivatives between seed directions and outputs, without what no seed reaches."""
    given = {node.index: columns for node, columns in seeds.items()}
    into: dict[Vertex, Edges] = {}
    order: list[int] = []
    for node in evaluation_order(outputs, given):
        if node.index in given:
            edges: Edges = {("direction", d): w for d, w in given[node.index].items() if w is not tape.zero}
        else:
            edges = {}
            for arg, weight in _partials(tape, node):
                if arg.index in into and weight is not tape.zero:
                    edges[arg.index] = edges[arg.index] + weight if arg.index in edges else weight
        if edges:
            into[node.index] = edges
            order.append(node.index)
    for i, node in enumerate(outputs):
        into["output", i] = {node.index: tape.one} if node.index in into else {}
    graph = Graph(into, _successors(into), order)
    _remove_dead(graph)
    return graph


def _successors(into: Mapping[Vertex, Edges]) -> dict[Vertex, Readers]:
    out: dict[Vertex, Readers] = {}
    for vertex, edges in into.items():
        for before in edges:
            out.setdefault(before, {})[vertex] = None
    return out


def _remove_dead(graph: Graph) -> None:
    """Take out vertices that reach no output."""
    for vertex in reversed(graph.order):
        if not graph.out.get(vertex):
            for before in graph.into.pop(vertex):
                graph.out[before].pop(vertex, None)
    graph.order = [vertex for vertex in graph.order if vertex in graph.into]


def _partials(tape: Tape, node: Node) -> Sequence[tuple[Node, Node]]:
    """(argument, partial derivative) of one operation."""
    if node.op not in PARTIALS:
        raise ValueError(f"no derivative is known of the operation {node.op!r}")
    return PARTIALS[node.op](tape, node, *(node.args if node.op != "symbol" else ()))


def _of_angle(tape: Tape, node: Node, y: Node, x: Node) -> Sequence[tuple[Node, Node]]:
    """d atan2(y, x) = (x dy - y dx) / (x^2 + y^2)."""
    scale = 1 / (x * x + y * y)
    return ((y, x * scale), (x, -(y * scale)))


def _of_choice(tape: Tape, node: Node, *args: Node) -> Sequence[tuple[Node, Node]]:
    """What is not chosen has the derivative 0; there is none by the condition."""
    condition, one, other = args
    chosen = tape.function("select", condition, 1, 0)
    return ((one, chosen), (other, tape.function("select", condition, 0, 1)))


PARTIALS: dict[
    str, Callable[..., Sequence[tuple[Node, Node]]]
] = {  # (tape, node, its arguments) to arguments, partials
    "symbol": lambda tape, node: (),
    "add": lambda tape, node, x, y: ((x, tape.one), (y, tape.one)),
    "sub": lambda tape, node, x, y: ((x, tape.one), (y, -tape.one)),
    "neg": lambda tape, node, x: ((x, -tape.one),),
    "mul": lambda tape, node, x, y: ((x, y), (y, x)),
    "reciprocal": lambda tape, node, x: ((x, -(node * node)),),
    "sqrt": lambda tape, node, x: ((x, 1 / (2 * node)),),
    "exp": lambda tape, node, x: ((x, node),),
    "sin": lambda tape, node, x: ((x, tape.function("cos", x)),),
    "cos": lambda tape, node, x: ((x, -tape.function("sin", x)),),
    "tan": lambda tape, node, x: ((x, 1 + node * node),),
    "atan2": _of_angle,
    "abs": lambda tape, node, x: ((x, tape.function("select", tape.function("less", x, 0), -tape.one, 1)),),
    "less": lambda tape, node, x, y: (),  # constant where it is differentiable
    "select": _of_choice,
}


# -- elimination ---------------------------------------------------------------------------------------------


def _eliminated(tape: Tape, graph: Graph, name: str) -> dict[Vertex, Edges]:
    """Edges into the outputs when all vertices are taken out."""
    into = {vertex: dict(edges) for vertex, edges in graph.into.items()}
    out = {vertex: dict(after) for vertex, after in graph.out.items()}
    for vertex in _sequence(graph, name):
        before = into.pop(vertex)
        for following in out.pop(vertex):
            edges = into[following]
            weight = edges.pop(vertex)
            for source, inner in before.items():
                product = weight * inner
                total = edges[source] + product if source in edges else product
                if total is tape.zero:
                    edges.pop(source, None)
                    out[source].pop(following, None)
                else:
                    edges[source] = total
                    out[source][following] = None
        for source in before:
            out[source].pop(vertex, None)
    return into


def _sequence(graph: Graph, name: str) -> Sequence[int]:
    """The vertices in the order in which they are taken out."""
    if name == "forward":
        return graph.order
    if name == "reverse":
        return graph.order[::-1]
    return _simulate(graph, None)[0]


def _promising(graph: Graph) -> list[str]:
    """Orders whose operations, counted without what equal nodes save, are not far above the fewest."""
    counts = {name: _simulate(graph, None if name == "markowitz" else _sequence(graph, name))[1] for name in ORDERS}
    return [name for name in ORDERS if counts[name] <= PROMISING * min(counts.values())]


def _simulate(graph: Graph, fixed: Sequence[int] | None) -> tuple[list[int], int]:
    """The order of elimination (the fixed one, or cheapest vertex first) and its operations.

    Edges are known here by whether a product with them costs an operation: signs and ones do not.
    """
    into: dict[Vertex, dict[Vertex, bool]] = {
        v: {p: not _is_sign(w) for p, w in edges.items()} for v, edges in graph.into.items()
    }
    out = {vertex: dict(after) for vertex, after in graph.out.items()}
    place = {vertex: i for i, vertex in enumerate(graph.order)}

    def price(vertex: int) -> int:
        before, plain = into[vertex], 0
        for costs in before.values():
            plain += costs
        total = 0
        for following in out[vertex]:
            edges = into[following]
            total += plain if edges[vertex] else 0
            for source in before:
                total += source in edges
        return total

    def take(vertex: int) -> set[Vertex]:
        before, after = into.pop(vertex), out.pop(vertex)
        for following in after:
            edges = into[following]
            weight = edges.pop(vertex)
            for source, costs in before.items():
                edges[source] = source in edges or weight or costs
                out[source][following] = None
        for source in before:
            out[source].pop(vertex, None)
        return {*before, *after}

    operations = 0
    if fixed is not None:
        for vertex in fixed:
            operations += price(vertex)
            take(vertex)
        return list(fixed), operations
    sequence: list[int] = []
    current = {vertex: price(vertex) for vertex in graph.order}
    queue = [(cost, place[vertex], vertex) for vertex, cost in current.items()]
    heapq.heapify(queue)
    while queue:
        cost, _, vertex = heapq.heappop(queue)
        if current.get(vertex) != cost:
            continue
        del current[vertex]
        operations += cost
        sequence.append(vertex)
        for near in take(vertex):
            if near in current:
                now = price(near)
                if now != current[near]:
                    current[near] = now
                    heapq.heappush(queue, (now, place[near], near))
    return sequence, operations


def _is_sign(weight: Node) -> bool:
    return weight.value is not None and abs(weight.value) == 1

"""The mechanism with some freedoms held: bodies that move together, and the free motions between them.

Network, held columns --one edge for each elementary motion--> edges --union over held ones--> clusters
                      --concurrent axes on a body between two others--> runs: turn, slide, hook (2), ball (3)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from symscrew.algebra import cross, dot, subtract
from symscrew.assembly.linked_columns import Link
from symscrew.mobility import Network, NotAlgebraicError

Point = tuple[Any, Any, Any]

MEET = 1e-12
"""Distance of axes, in units of the mechanism's size, that meet: descriptions give 14 digits or more."""
FREEDOMS = {"turn": 1, "slide": 1, "hook": 2, "ball": 3}


@dataclass(frozen=True)
class Edge:
    """An elementary motion from `parent` to `child`: kind, columns among the mechanism's freedoms, axis in 60 digits.

    `axis` is of length one; none of a ball.
    """

    joint: str
    kind: str
    columns: tuple[int, ...]
    parent: str
    child: str
    point: Point
    axis: Point | None


@dataclass(frozen=True)
class Run:
    """Free motions between two clusters, in order from `near` to `far`, that turn about one point or are one edge."""

    kind: str
    edges: tuple[Edge, ...]
    near: str
    far: str

    @property
    def freedoms(self) -> int:
        """How many independent ones."""
        return FREEDOMS[self.kind]

    def reversed(self) -> Run:
        """From the other end."""
        return Run(self.kind, self.edges[::-1], self.far, self.near)


@dataclass(frozen=True)
class HeldGraph:
    """Edges by what they do; body -> its cluster; runs; the axis of a planar mechanism.

    `spherical`: whether all joints turn about axes through one point, so that no closure is about places. `links`:
    what couplings tie of what is free.
    """

    ground: str
    edges: tuple[Edge, ...]
    held: tuple[Edge, ...]
    cluster: Mapping[str, str]
    runs: tuple[Run, ...]
    idle: tuple[Run, ...]
    axis: Point | None
    spherical: bool = False
    links: tuple[Link, ...] = ()

    def tied(self, run: Run) -> bool:
        """Whether a coupling ties a motion of the run to others that are free, so that it is an unknown."""
        return _tied(run, self.links)


def elementary_edges(network: Network) -> list[Edge]:
    """One edge for each elementary motion; bodies between the motions of a joint are `joint:1` and so on."""
    result = []
    for edge in network.edges.values():
        ends = [edge.parent, *(f"{edge.name}:{k}" for k in range(1, len(edge.motions))), edge.child]
        if not edge.motions:
            result.append(Edge(edge.name, "held", (), edge.parent, edge.child, edge.point, None))
        for (motion, start), parent, child in zip(edge.motions, ends[:-1], ends[1:], strict=True):
            columns = tuple(range(start, start + motion.freedom))
            screw = edge.screws[start - edge.start] if columns else None
            if motion.helical:
                raise NotAlgebraicError(f"the screw joint {edge.name} is not algebraic")
            kind = "held" if motion.fixed else "ball" if motion.spherical else "slide" if motion.prismatic else "turn"
            axis = None
            if screw is not None and kind in ("turn", "slide"):
                x, y, z = screw[:3] if kind == "turn" else screw[3:]
                axis = (x, y, z)
            result.append(Edge(edge.name, kind, columns, parent, child, edge.point, axis))
    return result


def held_graph(network: Network, held: Iterable[int], platform: str | None, links: Sequence[Link] = ()) -> HeldGraph:
    """Clusters and runs with these columns held, and free ones tied by couplings.

    Raises:
        NotAlgebraicError: screw joints, or spherical joints of which single coordinates are held.
    """
    columns = set(held)
    edges = elementary_edges(network)
    fixed, free = list[Edge](), list[Edge]()
    for edge in edges:
        count = len(columns & set(edge.columns))
        if count not in (0, len(edge.columns)):
            raise NotAlgebraicError(f"a single coordinate of the spherical joint {edge.joint} is held")
        (free if edge.columns and not count else fixed).append(edge)
    cluster = _clusters(network.ground, edges, fixed)
    axis = _planar_axis(edges)
    runs = [Run(e.kind, (e,), cluster[e.parent], cluster[e.child]) for e in free]
    if any(run.near == run.far for run in runs):
        raise NotAlgebraicError("a joint is free between bodies that what is held joins already")
    looped, idle = _looped(runs, cluster[network.ground], links)
    keep = {cluster[network.ground], cluster.get(platform or "", "")}
    spherical = axis is None and _spherical([e for e in edges if e.columns])
    return HeldGraph(
        cluster[network.ground], tuple(edges), tuple(fixed), cluster,
        tuple(looped if spherical or axis is not None else _gathered(looped, keep, links)), tuple(idle), axis,
        spherical, tuple(links),
    )  # fmt: skip


def _clusters(ground: str, edges: Sequence[Edge], fixed: Sequence[Edge]) -> dict[str, str]:
    cluster = {body: body for edge in edges for body in (edge.parent, edge.child)}
    cluster.setdefault(ground, ground)
    for edge in fixed:
        one, two = cluster[edge.parent], cluster[edge.child]
        stays, goes = (two, one) if two == ground else (one, two)
        cluster = {body: stays if home == goes else home for body, home in cluster.items()}
    return cluster


def _planar_axis(edges: Sequence[Edge]) -> Point | None:
    """The common direction of all hinges, where all else slides across it; None of spatial mechanisms."""
    hinges = [e.axis for e in edges if e.kind == "turn" and e.axis is not None]
    slides = [e.axis for e in edges if e.kind == "slide" and e.axis is not None]
    if not hinges or any(e.kind == "ball" for e in edges):
        return None
    axis = hinges[0]
    if any(_size(cross(axis, a)) > MEET for a in hinges) or any(abs(float(dot(axis, a))) > MEET for a in slides):
        return None
    return axis


def _spherical(edges: Sequence[Edge]) -> bool:
    """Whether all motions are turns about axes, not all parallel, through one point."""
    if any(e.kind != "turn" for e in edges):
        return False
    place = next((p for e in edges[1:] if (p := meeting_point(edges[0], e)) is not None), None)
    return place is not None and all(_off(e, place) <= MEET for e in edges)


def _size(vector: Point) -> float:
    return float(float(dot(vector, vector)) ** 0.5)


def _tied(run: Run, links: Sequence[Link]) -> bool:
    return any(c in link.factors for edge in run.edges for c in edge.columns for link in links)


def _looped(runs: Sequence[Run], ground: str, links: Sequence[Link]) -> tuple[list[Run], list[Run]]:
    """(runs on loops, runs that nothing closes), by taking ends away until none is left; bridges stay.

    What a coupling ties is closed by it.
    """
    left = list(runs)
    while True:
        count: dict[str, int] = {ground: 2}
        for run in left:
            for end in (run.near, run.far):
                count[end] = count.get(end, 0) + 1
        kept = [run for run in left if _tied(run, links) or (count[run.near] > 1 and count[run.far] > 1)]
        if len(kept) == len(left):
            return left, [run for run in runs if run not in left]
        left = kept


def _gathered(runs: Sequence[Run], keep: set[str], links: Sequence[Link]) -> list[Run]:
    """Turns about axes that meet on a body between two others become hooks and balls about that point."""
    result = list(runs)
    while True:
        pair = next((found for found in _between(result, keep, links) if found is not None), None)
        if pair is None:
            return result
        one, two, made = pair
        result = [made if run is one else run for run in result if run is not two]


def _between(runs: Sequence[Run], keep: set[str], links: Sequence[Link]) -> Iterable[tuple[Run, Run, Run] | None]:
    for body in dict.fromkeys(end for run in runs for end in (run.near, run.far)):
        at = [run for run in runs if body in (run.near, run.far)]
        if body in keep or len(at) != 2 or any(run.kind == "slide" or _tied(run, links) for run in at):
            continue
        one = at[0] if at[0].far == body else at[0].reversed()
        two = at[1] if at[1].near == body else at[1].reversed()
        made = _about_one_point(one, two)
        if made is not None and one.near != two.far:
            yield at[0], at[1], made


def _about_one_point(one: Run, two: Run) -> Run | None:
    """Both after another, where all axes go through one point and no two next to each other are parallel."""
    a, b = one.edges[-1], two.edges[0]
    if not {a.parent, a.child} & {b.parent, b.child}:  # what is held between them moves one axis against the other
        return None
    freedoms = one.freedoms + two.freedoms
    if freedoms > FREEDOMS["ball"]:
        return None
    place = meeting_point(a, b)
    if place is None or any(_off(edge, place) > MEET for edge in (*one.edges, *two.edges)):
        return None
    kind = "ball" if freedoms == FREEDOMS["ball"] else "hook"
    return Run(kind, tuple(replace(e, point=place) for e in (*one.edges, *two.edges)), one.near, two.far)


def _off(edge: Edge, place: Point) -> float:
    """Distance of a point from an edge's axis or centre."""
    way = subtract(place, edge.point)
    return _size(way if edge.axis is None else cross(way, edge.axis))


def meeting_point(a: Edge, b: Edge) -> Point | None:
    """Where two axes meet, if they do and are not parallel."""
    if a.axis is None or b.axis is None:
        return a.point if a.axis is None else b.point
    normal = cross(a.axis, b.axis)
    square = dot(normal, normal)
    way = subtract(b.point, a.point)
    if float(square) ** 0.5 < MEET or abs(float(dot(way, normal))) > MEET * float(square) ** 0.5:
        return None
    along = dot(cross(way, b.axis), normal) / square
    x, y, z = (p + along * c for p, c in zip(a.point, a.axis, strict=True))
    return x, y, z

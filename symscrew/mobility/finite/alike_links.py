"""What the numbers of links nearly agree in: lengths, angles and offsets that are equal, axes and points in line.

    Network --points and axes that every link carries--> lengths, angles, offsets [`Measure`]
    measures within a tolerance of each other or of zero --alike--> relations meant --> conditions on the geometry

Where kinds of linkages that move cross each other, as parallelograms and kites do in the rhombus, the conditions of
motion have no slope, so that steps along slopes do not lead there. What the designer meant is one of those kinds, and
it is plain to see in the links: equal ones. Measures of links do not depend on the configuration.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, combinations, product

import numpy as np

from symscrew.mobility.finite.joint_changes import PITCH, PLACE, Slots
from symscrew.mobility.finite.variety import Array
from symscrew.mobility.joint_network import Edge, Network

SLANTED = 1e-2
"""Sine of the angle from which on two axes have feet of a common normal, as for `aligned_axes.CROSSING`."""
NO_SLOPE = 1e-9
"""A measure that hardly changes with any number is the same for all of them, such as the distance of axes that meet by
construction; those that do change have slopes of the order of lengths of the mechanism, which is 1."""
USUAL = 10.0
"""Of numbers rounded alike none is off by more than this times the median: what is agrees by chance. Of numbers drawn
evenly from a range one in twenty is below a tenth of the median, and none above twice it."""
LEAST_OFF = 1e-15
"""What is off by less is so by rounding of the doubles in which measures are compared."""
STEP = 1e-30
"""Imaginary step of derivatives: they are exact to rounding, as nothing is subtracted."""
MOST_POINTS = 8
"""Links with more points or axes than this are measured by pairs alone: triples of them would be hundreds."""

Place = tuple[str, int]
"""(joint, slot): its point [`PLACE`] or one of its axes."""
_Pair = tuple[int, int | None, int]
"""(measure, another or None for zero, sign): they are meant to be equal."""


def _dot(a: Array, b: Array) -> Array:
    return np.asarray((a * b).sum(axis=-1))


def _cross(a: Array, b: Array) -> Array:
    (x, y, z), (u, v, w) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
    return np.stack([y * w - z * v, z * u - x * w, x * v - y * u], axis=-1)


def _foot(p: Array, a: Array, q: Array, b: Array) -> Array:
    """Where along the axis a through p, from p on, it is closest to the axis b through q."""
    normal = _cross(a, b)
    return np.asarray(_dot(_cross(q - p, b), normal) / _dot(normal, normal))


MEASURES: dict[str, Callable[..., Array]] = {
    "angle": _dot,
    "moment": lambda p, a, q, b: _dot(p - q, _cross(a, b)),
    "apart": lambda p, q: _dot(p - q, p - q),
    "across": lambda p, q, a: _dot(_cross(p - q, a), _cross(p - q, a)),
    "offset": lambda p, a, q, b, r, c: _foot(p, a, q, b) - _foot(p, a, r, c),
    "step": lambda p, a, q, b, r, s, c: _dot(p - r, a) + _foot(p, a, q, b) - _foot(r, a, s, c),
    "along": lambda p, q, a: _dot(p - q, a),
    "in one plane": lambda p, q, r, a: _dot(_cross(q - p, r - p), a),
    "along one plane": lambda a, b, c: _dot(_cross(a, b), c),
    "coplanar": lambda p, q, r, s: _dot(_cross(q - p, r - p), s - p),
}
"""Measures of a link, one number each, of its points p, q, r, s and axes a, b, c: the cosine of an angle, a distance
times its sine, a squared distance of points, that of a point from an axis, the offset on a through p from the foot of
the normal to b to that to c, the same on two parallel axes, a distance along an axis, volumes."""
VANISHING: dict[str, Callable[..., Array]] = {
    "parallel": _cross,
    "on the axis": lambda p, q, a: _cross(p - q, a),
    "in line": lambda p, q, r: _cross(q - p, r - p),
    "parallel bars": lambda p, q, r, s: _cross(q - p, s - r),
}
"""Vectors that are meant to vanish where they nearly do. Measures that say the same have no slope there."""


@dataclass(frozen=True)
class _Kind:
    """All measures of one kind: `places`, N x arguments."""

    function: Callable[..., Array]
    places: Sequence[tuple[Place, ...]]

    def values(self, network: Network) -> Array:
        """N, or N x 3, in 60 digits."""
        given = np.array([[_vector(network, place) for place in places] for places in self.places], dtype=object)
        return self.function(*np.moveaxis(given, 1, 0))

    def slopes(self, network: Network) -> Array:
        """Derivatives by what moves points and turns axes: N x (1 or 3) x arguments x 3, in doubles."""
        given = np.array([[_vector(network, place) for place in places] for places in self.places], dtype=float)
        count, arguments, _ = given.shape
        parts = []
        for k in range(arguments):
            turned = np.array([[place[k][1] != PLACE] for place in self.places])
            for axis in np.eye(3):
                moved = np.where(turned, np.cross(axis, given[:, k]), axis)
                stepped = given.astype(complex)
                stepped[:, k] += 1j * STEP * moved
                parts.append(self.function(*np.moveaxis(stepped, 1, 0)).imag.reshape(count, -1) / STEP)
        return np.stack(parts, axis=-1).reshape(count, -1, arguments, 3)


def _vector(network: Network, place: Place) -> tuple[object, ...]:
    name, slot = place
    edge = network.edges[name]
    return edge.point if slot == PLACE else edge.axis(slot)


@dataclass(frozen=True)
class Alike:
    """Relations that are meant: differences of measures, of every kind, that are to vanish.

    `off`: how far points [1] and axes [rad] as typed are off the relation that they satisfy worst.
    """

    kinds: Sequence[_Kind]
    differences: Sequence[Sequence[_Pair]]
    off: float

    def residual(self, network: Network) -> Array:
        """What is left of all relations."""
        parts = []
        for kind, pairs in zip(self.kinds, self.differences, strict=True):
            values = kind.values(network).reshape(len(kind.places), -1)
            parts += [values[i] - (0 if k is None else sign * values[k]) for i, k, sign in pairs]
        return np.concatenate(parts).astype(float)

    def rates(self, network: Network, slots: Slots) -> Array:
        """d(residual)/dz in doubles."""
        parts = []
        start = starts_of(slots)
        count = sum(1 if slot == PITCH else 3 for own in slots.values() for slot in own)
        for kind, pairs in zip(self.kinds, self.differences, strict=True):
            slopes = kind.slopes(network)
            for i, k, sign in pairs:
                row = np.zeros((slopes.shape[1], count))
                for which, factor in ((i, 1), (k, -sign)):
                    if which is not None:
                        for argument, place in enumerate(kind.places[which]):
                            row[:, start[place] : start[place] + 3] += factor * slopes[which, :, argument]
                parts.append(row)
        return np.concatenate(parts)


def starts_of(slots: Slots) -> dict[Place, int]:
    """(joint, slot) -> where its numbers begin among the numbers z."""
    result, start = {}, 0
    for name, own in slots.items():
        for slot in own:
            result[name, slot] = start
            start += 1 if slot == PITCH else 3
    return result


def alike(network: Network, tolerance: float) -> Alike | None:
    """The relations that the numbers of links nearly satisfy; None where there are none.

    Args:
        network: lengths in units of its size.
        tolerance: a change of points [1] and axes [rad] below this is rounding.
    """
    measures: dict[str, list[tuple[Place, ...]]] = {}
    for name, places in _measures(network):
        measures.setdefault(name, []).append(places)
    every = [_Measured.of(name, list(dict.fromkeys(found)), network) for name, found in measures.items()]
    off = [size for one in every for _, size in one.pairs(tolerance) if size > LEAST_OFF]
    if off:
        tolerance = min(tolerance, USUAL * float(np.median(off)))
    found = [(one.kind, list(one.pairs(tolerance))) for one in every]
    meant = [(kind, pairs) for kind, pairs in found if pairs]
    if not meant:
        return None
    worst = max(size for _, pairs in meant for _, size in pairs)
    return Alike([kind for kind, _ in meant], [[pair for pair, _ in pairs] for _, pairs in meant], worst)


@dataclass(frozen=True)
class _Measured:
    """Measures of one kind of what was typed. `sizes`: how much each changes with points and axes."""

    kind: _Kind
    vanishing: bool
    values: Array
    sizes: Array

    @classmethod
    def of(cls, name: str, places: Sequence[tuple[Place, ...]], network: Network) -> _Measured:
        kind = _Kind({**MEASURES, **VANISHING}[name], places)
        slopes = kind.slopes(network)
        values = np.abs(kind.values(network).astype(float)) if name in VANISHING else kind.values(network).astype(float)
        sizes = np.linalg.norm(slopes.reshape(len(slopes), -1), axis=1)
        if name in VANISHING:
            values = np.linalg.norm(values, axis=1)
        return cls(kind, name in VANISHING, values, sizes)

    def pairs(self, tolerance: float) -> Iterator[tuple[_Pair, float]]:
        """What is meant to be equal within the tolerance, and how far points and axes are off it.

        Signs are left open, which follow the directions of axes.
        """
        first: int | None = None
        last = 0.0
        for k in map(int, np.argsort(np.abs(self.values))):
            value, size = abs(self.values[k]), self.sizes[k]
            if size <= NO_SLOPE:
                continue
            if value <= tolerance * size:
                yield (k, None, 1), value / size
            elif first is not None and value - last <= tolerance * size:
                sign = 1 if self.values[k] * self.values[first] > 0 else -1
                yield (k, first, sign), (value - last) / size
                last = value
            elif not self.vanishing:
                first, last = k, value


@dataclass(frozen=True)
class _Link:
    """What a link carries: points that joints turn about, axes that they turn about, further directions."""

    points: tuple[Place, ...]
    lines: tuple[Place, ...]
    directions: tuple[Place, ...]


def _links(network: Network) -> dict[str, _Link]:
    links = {}
    for body in network.bodies:
        points: list[Place] = []
        lines: list[Place] = []
        directions: list[Place] = []
        for edge in network.edges.values():
            if body not in (edge.parent, edge.child) or not edge.motions:
                continue
            motion = edge.motions[0 if body == edge.parent else -1][0]
            if _has_centre(edge):
                points.append((edge.name, PLACE))
            slot = edge.slot(motion) if motion.single else None
            if slot is not None:
                (lines if motion.turns and edge.plane is None else directions).append((edge.name, slot))
        links[body] = _Link(tuple(points), tuple(lines), tuple(directions))
    return links


def _has_centre(edge: Edge) -> bool:
    """Whether its point matters in all directions: of a hinge any point of its axis will do."""
    turning = [motion for motion, _ in edge.motions if motion.turns]
    return any(motion.spherical for motion in turning) or (len(turning) > 1 and edge.plane is None)


def _measures(network: Network) -> Iterator[tuple[str, tuple[Place, ...]]]:
    links = _links(network)
    axes = {place: np.array([float(c) for c in network.edges[place[0]].axis(place[1])])
            for link in links.values() for place in (*link.lines, *link.directions)}  # fmt: skip

    def slanted(a: Place, b: Place) -> bool:
        return bool(np.linalg.norm(np.cross(axes[a], axes[b])) > SLANTED)

    for edge in network.edges.values():
        for a, b in zip(edge.slots, edge.slots[1:], strict=False):
            yield "angle", ((edge.name, a), (edge.name, b))
    for link in links.values():
        yield from _between_axes(link, slanted)
        yield from _of_points(link)
    yield from _along_axes(links, network, slanted)
    every = list(axes)
    yield from (("parallel", pair) for pair in combinations(every, 2) if not slanted(*pair))
    yield from (("along one plane", three) for three in combinations(_different(every, slanted), 3))
    bars = [link.points for link in links.values() if len(link.points) == 2]
    for first, second in combinations(bars, 2):
        yield "parallel bars", (*first, *second)


def _different(axes: Sequence[Place], slanted: Callable[[Place, Place], bool]) -> list[Place]:
    """One axis of each direction; none where there are more than `MOST_POINTS`."""
    result: list[Place] = []
    for axis in axes:
        if all(slanted(axis, other) for other in result):
            result.append(axis)
    return result if len(result) <= MOST_POINTS else []


def _between_axes(link: _Link, slanted: Callable[[Place, Place], bool]) -> Iterator[tuple[str, tuple[Place, ...]]]:
    for a, b in combinations((*link.lines, *link.directions), 2):
        if slanted(a, b):
            yield "angle", (a, b)
    for a, b in combinations(link.lines, 2):
        if slanted(a, b):
            yield "moment", (_point(a), a, _point(b), b)
        else:
            yield "across", (_point(b), _point(a), a)
            yield "on the axis", (_point(b), _point(a), a)
    if len(link.lines) <= MOST_POINTS:
        for a, b, c in combinations(link.lines, 3):
            if not (slanted(a, b) or slanted(a, c)):
                yield "in one plane", (_point(a), _point(b), _point(c), a)


def _of_points(link: _Link) -> Iterator[tuple[str, tuple[Place, ...]]]:
    yield from (("apart", pair) for pair in combinations(link.points, 2))
    for a in link.lines:
        for p in link.points:
            if p != _point(a):
                yield "across", (p, _point(a), a)
                yield "on the axis", (p, _point(a), a)
    for a in link.directions:
        yield from (("along", (p, q, a)) for p, q in combinations(link.points, 2))
    if len(link.points) <= MOST_POINTS:
        yield from (("in line", three) for three in combinations(link.points, 3))
        yield from (("coplanar", four) for four in combinations(link.points, 4))


def _along_axes(
    links: dict[str, _Link], network: Network, slanted: Callable[[Place, Place], bool]
) -> Iterator[tuple[str, tuple[Place, ...]]]:
    """Offsets along axes, within a link and from one to the next, which the joint between them keeps."""
    crossing: dict[Place, tuple[Place, ...]] = {}
    for a in dict.fromkeys(chain.from_iterable(link.lines for link in links.values())):
        edge = network.edges[a[0]]
        own = [links[body] for body in (edge.parent, edge.child) if a in links[body].lines]
        if len(edge.motions) == 1 and edge.motions[0][0].slides:
            own = own[:1]  # a screw's offset changes
        others = dict.fromkeys(b for link in own for b in link.lines if b[0] != a[0] and slanted(a, b))
        crossing[a] = tuple(others) if len(others) <= MOST_POINTS else ()
        for b, c in combinations(crossing[a], 2):
            yield "offset", (_point(a), a, _point(b), b, _point(c), c)
        points = dict.fromkeys(p for link in own for p in link.points if p[0] != a[0])
        yield from (("along", (p, q, a)) for p, q in combinations(points, 2))
        if _has_centre(edge):
            yield from (("along", (p, _point(a), a)) for p in points)
    for a, e in chain.from_iterable(combinations(link.lines, 2) for link in links.values()):
        if not slanted(a, e):
            for b, c in product(crossing[a], crossing[e]):
                yield "step", (_point(a), a, _point(b), b, _point(e), _point(c), c)


def _point(line: Place) -> Place:
    return line[0], PLACE

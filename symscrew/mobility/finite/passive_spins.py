"""Passive spins split off: a chain of links between two spherical joints turns about the line of their centres.

    S --links with two joints each-- S   =>   one spin about the line of centres + the network without it

The spin acts freely on the configuration space near the reference, so the space is locally the product of a line
and of the space without the spin, with the same dimension of the rest, branches and smooth points. Without spins
there are fewer unknowns. The spherical joint at one end keeps the two rotations across the line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.algebra import CONTEXT, IDENTITY, Vector, cross, dot, revolute, scale, subtract
from symscrew.description import rotation
from symscrew.mobility.finite.independent_parts import shifted
from symscrew.mobility.finite.variety import Array
from symscrew.mobility.joint_network import Edge, Network
from symscrew.mobility.screw_systems import Real, eliminate, null_space, unit_rows

COINCIDE = CONTEXT.mpf(10) ** -12
"""Two spherical joints closer together than this, in units of the mechanism's size, have no line of centres to spin
about; the links between them keep all their freedoms, which is right and costs unknowns only."""

GROUPS = ("R", "P", "H", "C", "S", "E")
"""Joint types whose motions are a group of displacements: seen from either body, their screws stay where they are."""


def without_spins(network: Network) -> tuple[Network, int]:
    """(the network with one freedom less for every passive spin, number of spins)."""
    spins = _spins(network)
    if not spins:
        return network, 0
    edges: dict[str, Edge] = {}
    start = 0
    for name, edge in network.edges.items():
        edges[name] = _across(edge, spins[name][0], start) if name in spins else shifted(edge, start)
        start += len(edges[name].screws)
    return replace(network, edges=edges, driven=()), len(spins)


def named_spins(network: Network) -> tuple[tuple[str, str], ...]:
    """The spherical joints at both ends of every chain of links that spins about the line between them."""
    return tuple((name, end) for name, (_, end) in _spins(network).items())


@dataclass(frozen=True)
class LoneMotion:
    """Links that move alone between two joints while all others rest: the joints, and rates of all columns."""

    joints: tuple[str, str]
    rates: tuple[Real, ...]


def passive_freedoms(network: Network) -> int:
    """In how many ways links move alone, each between its two joints, while all others rest (zeta)."""
    return _rank([motion.rates for motion in lone_motions(network)], network.freedoms)


def undriven_freedoms(network: Network) -> int:
    """In how many ways links move alone with all drives locked."""
    rates = [motion.rates for motion in lone_motions(network)]
    driven = [[rate[column] for column in network.driven] for rate in rates]
    return _rank(rates, network.freedoms) - _rank(driven, len(network.driven))


def lone_pairs(network: Network) -> tuple[tuple[str, str], ...]:
    """The joints between which links move alone, balls at the ends of a chain of links among them; each pair once."""
    pairs = {frozenset(motion.joints): motion.joints for motion in reversed(lone_motions(network))}
    return tuple(reversed(pairs.values()))


def lone_motions(network: Network) -> tuple[LoneMotion, ...]:
    """Of every link, or chain of links between two balls, that moves alone; such of one chain may depend on others.

    Both joints of a link have a motion in common, as seen from the link: two hinges about one line, a hinge whose axis
    goes through a ball, two slides along one direction, two balls. What they have in common now they have for good,
    for joints move in groups of displacements; of universal joints only the axis that the link carries does.
    """
    at, found = _joints_of(network), list[LoneMotion]()
    for body, edges in at.items():
        if body != network.ground and len(edges) == 2:
            one, other = (_carried(edge, body) for edge in edges)
            # as seen from the neighbours: the link moves by the one joint as by the other
            same = (edges[0].child == body) == (edges[1].child == body)
            sides = [*one, *((k, [-c if same else c for c in screw]) for k, screw in other)]
            rows = [[screw[i] for _, screw in sides] for i in range(6)]
            for motion in null_space(rows, len(sides)).basis:
                rates = dict(zip((k for k, _ in sides), motion, strict=True))
                found.append(_lone(network, (edges[0].name, edges[1].name), rates))
    for name, (line, end) in _spins(network).items():
        links = _links_between(network, at, network.edges[name], end)
        rates = {}
        for edge in (network.edges[name], network.edges[end]):
            rates |= {k: c if edge.child in links else -c for k, c in zip(edge.columns, line, strict=True)}
        found.append(_lone(network, (name, end), rates))
    return tuple(found)


def _lone(network: Network, joints: tuple[str, str], rates: Mapping[int, Real]) -> LoneMotion:
    return LoneMotion(joints, tuple(rates.get(k, CONTEXT.zero) for k in range(network.freedoms)))


def _rank(rows: Sequence[Sequence[Real]], columns: int) -> int:
    there = unit_rows(rows)
    return eliminate(there, columns).rank if there else 0


def _links_between(network: Network, at: dict[str, list[Edge]], edge: Edge, end: str) -> set[str]:
    """The links between two spherical joints that spin together."""
    found = (_other_end(network, at, edge, body) for body in (edge.parent, edge.child))
    return next(passed for other, passed in found if other is not None and other.name == end)


def _carried(edge: Edge, body: str) -> list[tuple[int, Sequence[Real]]]:
    """(column, screw) of the motions of a joint that stay where they are on a body: of a cross only its own axis."""
    own = edge.motions
    if edge.type not in GROUPS:
        own = own[-1:] if edge.child == body else own[:1]
    return [(k, edge.screws[k - edge.start]) for motion, start in own for k in range(start, start + motion.freedom)]


def rotation_vector(edge: Edge, angles: Array) -> Array:
    """The rotation vector of a ball joint that turns by two angles, one after the other, across its line of spin."""
    w, vector = 1.0, np.zeros(3)
    for screw, angle in zip(edge.screws, angles, strict=True):
        axis = np.sin(angle / 2) * np.array([float(c) for c in screw[:3]])
        c = np.cos(angle / 2)
        w, vector = w * c - vector @ axis, w * axis + c * vector + np.cross(vector, axis)
    size = float(np.linalg.norm(vector))
    return np.asarray(vector * (2 * np.arctan2(size, w) / size) if size else vector)


def _spins(network: Network) -> dict[str, tuple[Vector, str]]:
    """Spherical joint -> direction of the line about which the chain of links behind it spins, joint at its end."""
    at = _joints_of(network)
    spins: dict[str, tuple[Vector, str]] = {}
    done: set[str] = set()
    for edge in network.edges.values():
        if not _spherical(edge):
            continue
        for body in (edge.parent, edge.child):
            end, passed = _other_end(network, at, edge, body)
            if end is None or passed & done or {edge.name, end.name} & set(spins):
                continue
            line = subtract(end.point, edge.point)
            size = CONTEXT.sqrt(dot(line, line))
            if size > COINCIDE:
                spins[edge.name] = scale(1 / size, line), end.name
                done |= passed
    return spins


def _joints_of(network: Network) -> dict[str, list[Edge]]:
    at: dict[str, list[Edge]] = {body: [] for body in network.bodies}
    for edge in network.edges.values():
        at[edge.parent].append(edge)
        at[edge.child].append(edge)
    return at


def _other_end(network: Network, at: dict[str, list[Edge]], edge: Edge, body: str) -> tuple[Edge | None, set[str]]:
    """The spherical joint at the other end of a chain of links with two joints each, and the links."""
    passed: set[str] = set()
    while body != network.ground and body not in passed and len(at[body]) == 2:
        passed.add(body)
        edge = next(other for other in at[body] if other.name != edge.name)
        if _spherical(edge):
            return edge, passed
        body = edge.child if edge.parent == body else edge.parent
    return None, passed


def _spherical(edge: Edge) -> bool:
    return [motion.spherical for motion, _ in edge.motions] == [True]


def _across(edge: Edge, line: Vector, start: int) -> Edge:
    """The two rotations across the line; which side of them the spin was on does not matter in a group."""
    nearest = IDENTITY[min(range(3), key=lambda k: abs(line[k]))]
    first = subtract(nearest, scale(dot(nearest, line), line))
    first = scale(1 / CONTEXT.sqrt(dot(first, first)), first)
    screws = tuple(
        tuple(CONTEXT.mpf(c) for c in revolute(axis, edge.point).components) for axis in (first, cross(line, first))
    )
    return replace(edge, motions=((rotation(), start), (rotation(), start + 1)), screws=screws, start=start)

"""Small changes of joints: places moved and axes turned, what they do to screws and to the closure.

    numbers z, three a place and three an axis --changed--> Network
    displaced configuration, z --closure_rates, screw_rates--> derivatives of the residual and of the screws

A place moved by d or an axis turned by t about its point p is the joint carried by the small twist xi = (0 ; d) or
(t ; p x t). Its screws change by the bracket [xi, S]; in a displaced configuration the closure changes by what xi is
before the joint less what it is after it, carried there by the bodies: (Ad_before - Ad_after) xi.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from symscrew.algebra import CONTEXT, IDENTITY, Vector, cross, dot, scale
from symscrew.mobility.finite.variety import Array, ClosureVariety
from symscrew.mobility.joint_network import Edge, Network
from symscrew.mobility.screw_systems import Screw

PLACE = -1
"""Slot of a joint's place; the others are the numbers of its axes."""
Slots = Mapping[str, tuple[int, ...]]


def slots_of(network: Network) -> Slots:
    """Joint -> what is changed of it, three numbers each: its place, its axes."""
    result = {}
    for name, edge in network.edges.items():
        axes = sorted({motion.axis or 0 for motion, _ in edge.motions if motion.single})
        result[name] = (PLACE, *axes)
    return result


def count_of(slots: Slots) -> int:
    """How many numbers z there are."""
    return sum(3 * len(own) for own in slots.values())


def changed(network: Network, slots: Slots, z: Array) -> Network:
    """The network with its joints changed by z, in 60 digits; axes keep their unit length."""
    edges, start = {}, 0
    for name, edge in network.edges.items():
        given = {slot: z[start + 3 * i : start + 3 * i + 3] for i, slot in enumerate(slots[name])}
        start += 3 * len(slots[name])
        edges[name] = _changed_edge(edge, given)
    return replace(network, edges=edges)


def sizes(before: Network, after: Network) -> tuple[tuple[str, float], ...]:
    """Joint -> the larger of how far its place has moved and its axes have turned, the largest first."""
    found = []
    for name, edge in before.edges.items():
        other = after.edges[name]
        size = max(abs(a - b) for a, b in zip(edge.point, other.point, strict=True))
        for motion, column in edge.motions:
            if motion.single:
                part = slice(0, 3) if motion.turns else slice(3, 6)
                a, b = (e.screws[column - edge.start][part] for e in (edge, other))
                size = max(size, *(abs(c - d) for c, d in zip(a, b, strict=True)))
        found.append((name, float(size)))
    return tuple(sorted(found, key=lambda pair: -pair[1]))


def screw_rates(network: Network, slots: Slots, centre: Array) -> Array:
    """d(screws about the centre)/dz in doubles: z x freedoms x 6, in the reference configuration."""
    result = np.zeros((count_of(slots), network.freedoms, 6))
    row = 0
    for name, edge in network.edges.items():
        point = np.array([float(c) for c in edge.point]) - centre
        for slot in slots[name]:
            for xi in _carriers(slot, point):
                for motion, column in edge.motions:
                    if slot in (PLACE, motion.axis or 0):
                        for k in range(column, column + motion.freedom):
                            screw = about(edge.screws[k - edge.start], centre)
                            result[row, k] = np.concatenate(_bracket(xi, screw))
                row += 1
    return result


def closure_rates(variety: ClosureVariety, slots: Slots, q: Array) -> Array:
    """d(residual)/dz in doubles at the displacements q, N x columns: N x rows x z."""
    network = variety.network
    centre = np.array([float(c) for c in variety.centre])
    stations = variety.stations(q)
    by_joint = {}
    for name, edge in network.edges.items():
        point = np.array([float(c) for c in edge.point]) - centre
        carried = [_adjoint(*pose) for pose in stations[name]]
        parts = []
        for slot in slots[name]:
            moved = [k for k, (motion, _) in enumerate(edge.motions) if slot in (PLACE, motion.axis or 0)]
            # a fixed joint moves nothing, wherever it is
            across = sum((carried[k] - carried[k + 1] for k in moved), start=np.zeros_like(carried[0]))
            parts.append(across @ np.array(_carriers(slot, point)).T)
        by_joint[name] = np.concatenate(parts, axis=2)
    zero = {name: np.zeros_like(part) for name, part in by_joint.items()}
    rows = []
    for loop in network.loops():
        signs = dict(loop)
        parts = [signs[name] * by_joint[name] if name in signs else zero[name] for name in network.edges]
        rows.append(np.concatenate(parts, axis=2))
    return np.concatenate(rows, axis=1)


def about(screw: Screw, centre: Array) -> Array:
    """A screw in doubles, with its velocity at the centre: v - r x omega, subtracted in 60 digits."""
    w, v, r = screw[:3], screw[3:], [CONTEXT.mpf(c) for c in centre]
    moved = [a - b for a, b in zip(v, cross((r[0], r[1], r[2]), (w[0], w[1], w[2])), strict=True)]
    return np.array([float(c) for c in (*w, *moved)])


def _carriers(slot: int, point: Array) -> list[Array]:
    """The small twists of one slot."""
    axes = np.eye(3)
    if slot == PLACE:
        return [np.concatenate([np.zeros(3), axis]) for axis in axes]
    return [np.concatenate([axis, np.cross(point, axis)]) for axis in axes]


def _bracket(a: Array, b: Array) -> tuple[Array, Array]:
    return np.cross(a[:3], b[:3]), np.cross(a[:3], b[3:]) + np.cross(a[3:], b[:3])


def _adjoint(rotation: Array, translation: Array) -> Array:
    """N x 6 x 6: what carries a twist (omega ; v) by displacements."""
    result = np.zeros((len(rotation), 6, 6))
    result[:, :3, :3] = result[:, 3:, 3:] = rotation
    result[:, 3:, :3] = np.cross(translation[:, None, :], np.swapaxes(rotation, 1, 2)).swapaxes(1, 2)
    return result


def _changed_edge(edge: Edge, given: Mapping[int, Array]) -> Edge:
    if not any(any(part) for part in given.values()):
        return edge
    x, y, z = (a + b for a, b in zip(edge.point, given[PLACE], strict=True))
    point: Vector = (x, y, z)
    screws: list[Screw] = []
    for motion, column in edge.motions:
        own = edge.screws[column - edge.start : column - edge.start + motion.freedom]
        if motion.spherical:
            screws += [(*axis, *cross(point, axis)) for axis in IDENTITY]
            continue
        turned = own[0][:3] if motion.turns else own[0][3:]
        axis: Vector = (turned[0], turned[1], turned[2])
        turn = given[motion.axis or 0]
        u, v, w = (a + b for a, b in zip(axis, cross((turn[0], turn[1], turn[2]), axis), strict=True))
        axis = scale(1 / CONTEXT.sqrt(dot((u, v, w), (u, v, w))), (u, v, w))
        if not motion.turns:
            screws.append((CONTEXT.zero, CONTEXT.zero, CONTEXT.zero, *axis))
            continue
        pitch = dot((own[0][0], own[0][1], own[0][2]), (own[0][3], own[0][4], own[0][5]))
        moment = cross(point, axis)
        screws.append((*axis, *(m + pitch * a for m, a in zip(moment, axis, strict=True))))
    return replace(edge, point=point, screws=tuple(tuple(CONTEXT.mpf(c) for c in s) for s in screws))

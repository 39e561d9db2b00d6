"""Small changes of joints: places moved, axes turned, pitches, what they do to screws and to the closure.

    numbers z, three a place, three an axis, one a pitch --changed--> Network
    displaced configuration, z --closure_rates, screw_rates--> derivatives of the residual and of the screws

A place moved by d or an axis turned by t about its point p is the joint carried by the small twist xi = (0 ; d) or
(t ; p x t). Its screws change by the bracket [xi, S]; in a displaced configuration the closure changes by what xi is
before the joint less what it is after it, carried there by the bodies: (Ad_before - Ad_after) xi. A pitch that is
larger by h adds (0 ; h e) to the screw along e, and Ad_before (0 ; h q e) to the closure after a turn by q.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from symscrew.algebra import CONTEXT, IDENTITY, Vector, add, cross, dot, scale, subtract
from symscrew.mobility.finite.variety import Array, ClosureVariety
from symscrew.mobility.joint_network import Edge, Network
from symscrew.mobility.screw_systems import Screw

PLACE = -1
"""Slot of a joint's place; the others are its pitch's, and the numbers of its axes."""
PITCH = -2
"""Slot of a screw joint's pitch."""
PITCH_CHANGE = 0.1
"""Of a pitch: far more than rounding of files does to it (0.0001 m/rad in six decimals is off by half a hundredth), and
far less than the whole, without which a fine screw is a hinge."""
Slots = Mapping[str, tuple[int, ...]]


def slots_of(network: Network) -> Slots:
    """Joint -> what is changed of it: its place and its axes, three numbers each, its pitch, one."""
    result = {}
    for name, edge in network.edges.items():
        pitched = any(motion.helical for motion, _ in edge.motions)
        result[name] = (PLACE, *edge.slots, *([PITCH] if pitched else []))
    return result


def count_of(slots: Slots) -> int:
    """How many numbers z there are."""
    return sum(map(_width, _flat(slots)))


def numbers_of(slots: Slots, name: str, slot: int) -> slice:
    """Where among the numbers z those of one slot of a joint are."""
    before = list(slots)[: list(slots).index(name)]
    own = slots[name][: slots[name].index(slot)]
    start = sum(map(_width, (*(s for other in before for s in slots[other]), *own)))
    return slice(start, start + _width(slot))


def _flat(slots: Slots) -> list[int]:
    return [slot for own in slots.values() for slot in own]


def _width(slot: int) -> int:
    return 1 if slot == PITCH else 3


def changed(network: Network, slots: Slots, z: Array) -> Network:
    """The network with its joints changed by z, in 60 digits; axes keep their unit length."""
    edges, start = {}, 0
    for name, edge in network.edges.items():
        given = {}
        for slot in slots[name]:
            given[slot] = z[start : start + _width(slot)]
            start += _width(slot)
        edges[name] = _changed_edge(edge, given)
    return replace(network, edges=edges)


def sizes(before: Network, after: Network) -> tuple[tuple[str, float], ...]:
    """Joint -> the largest of what its place has moved, its axes have turned, its pitch has changed; largest first."""
    found = []
    for name, edge in before.edges.items():
        other = after.edges[name]
        size = max(abs(a - b) for a, b in zip(edge.point, other.point, strict=True))
        for motion, column in edge.motions:
            if motion.single:
                part = slice(0, 3) if motion.turns else slice(3, 6)
                a, b = (e.screws[column - edge.start][part] for e in (edge, other))
                size = max(size, *(abs(c - d) for c, d in zip(a, b, strict=True)))
            if motion.helical:
                size = max(size, abs(edge.pitch(column) - other.pitch(column)))
        found.append((name, float(size)))
    return tuple(sorted(found, key=lambda pair: -pair[1]))


def loses_a_pitch(before: Network, after: Network) -> bool:
    """Whether a screw joint's pitch has changed by more than `PITCH_CHANGE` of itself: it is another joint then."""
    return any(
        abs(after.edges[name].pitch(column) - edge.pitch(column)) > PITCH_CHANGE * abs(edge.pitch(column))
        for name, edge in before.edges.items()
        for motion, column in edge.motions
        if motion.helical
    )


def screw_rates(network: Network, slots: Slots, centre: Array) -> Array:
    """d(screws about the centre)/dz in doubles: z x freedoms x 6, in the reference configuration."""
    result = np.zeros((count_of(slots), network.freedoms, 6))
    row = 0
    for name, edge in network.edges.items():
        point = np.array([float(c) for c in edge.point]) - centre
        own = np.array([about(screw, centre) for screw in edge.screws])
        for slot in slots[name]:
            if slot == PITCH:
                for k in _turning(edge):
                    result[row, k, 3:] = [float(c) for c in edge.screws[k - edge.start][:3]]
                row += 1
                continue
            moved = [k for motion, column in edge.motions if slot in (PLACE, edge.slot(motion))
                     for k in range(column, column + motion.freedom)]  # fmt: skip
            if moved:
                carriers = np.array(_carriers(slot, point))[:, None, :]
                result[row : row + 3, moved] = _bracket(carriers, own[[k - edge.start for k in moved]])
            row += 3
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
            if slot == PITCH:
                parts.append(_by_pitch(edge, carried, q))
                continue
            moved = [k for k, (motion, _) in enumerate(edge.motions) if slot in (PLACE, edge.slot(motion))]
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


def _by_pitch(edge: Edge, carried: Sequence[Array], q: Array) -> Array:
    """What a pitch that is larger by one adds to the closure after the turns: N x 6 x 1."""
    result = np.zeros((len(q), 6, 1))
    for k, (motion, column) in enumerate(edge.motions):
        if motion.helical:
            along = np.array([0.0, 0.0, 0.0, *(float(c) for c in edge.screws[column - edge.start][:3])])
            result[:, :, 0] += q[:, column, None] * (carried[k] @ along)
    return result


def _turning(edge: Edge) -> list[int]:
    """Columns of a joint's screw motions."""
    return [column for motion, column in edge.motions if motion.helical]


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


def _bracket(a: Array, b: Array) -> Array:
    """The brackets [a, b] of twists in the last axis."""
    linear = np.cross(a[..., :3], b[..., 3:]) + np.cross(a[..., 3:], b[..., :3])
    return np.concatenate([np.cross(a[..., :3], b[..., :3]), linear], axis=-1)


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
    axes = _turned(edge, given)
    screws: list[Screw] = []
    for motion, column in edge.motions:
        if motion.spherical:
            screws += [(*axis, *cross(point, axis)) for axis in IDENTITY]
            continue
        axis = axes[motion.axis or 0]
        if not motion.turns:
            screws.append((CONTEXT.zero, CONTEXT.zero, CONTEXT.zero, *axis))
            continue
        pitch = edge.pitch(column) + (given[PITCH][0] if motion.helical else 0)
        moment = cross(point, axis)
        screws.append((*axis, *(m + pitch * a for m, a in zip(moment, axis, strict=True))))
    return replace(edge, point=point, screws=tuple(tuple(CONTEXT.mpf(c) for c in s) for s in screws))


def _turned(edge: Edge, given: Mapping[int, Array]) -> dict[int, Vector]:
    """All axes of the joint after the change; of a planar joint they stay at right angles to each other."""
    axes = {motion.axis or 0: edge.axis(motion.axis or 0) for motion, _ in edge.motions if motion.single}
    for slot in edge.slots:
        x, y, z = given[slot]
        carried = {k: add(axis, cross((x, y, z), axis)) for k, axis in axes.items() if slot in (k, edge.plane)}
        axes[slot] = normal = _unit(carried[slot])
        if slot == edge.plane:
            first, second = sorted(carried.keys() - {slot})
            axes[first] = _unit(subtract(carried[first], scale(dot(carried[first], normal), normal)))
            axes[second] = cross(normal, axes[first])
    return axes


def _unit(axis: Vector) -> Vector:
    return scale(1 / CONTEXT.sqrt(dot(axis, axis)), axis)

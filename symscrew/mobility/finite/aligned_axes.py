"""Axes that are almost parallel, coaxial or through one point, made so: special geometry that rounding hides.

    network --directions within a tolerance--> parallel axes --lines within it--> common lines and points --> network

Directions rounded one by one are the daily case: three hinges of a Sarrus linkage. Conditions of motion have no slope
there, for hinges tilted against each other keep them to first order, so that steps along slopes do not lead to what is
meant. It is plain to see, though: it is made here, and judged as any other mechanism.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from symscrew.algebra import CONTEXT, Vector, cross, dot, scale
from symscrew.mobility.finite.joint_changes import PITCH, PLACE, changed, count_of, numbers_of, slots_of
from symscrew.mobility.finite.variety import Array
from symscrew.mobility.joint_network import Edge, Network

MEETING = 3
"""Lines close to one point that are led through it: what two that meet mean is left to the conditions of motion."""
CROSSING = 1e-2
"""Sine of the angle from which on two lines that are close have a place where they are closest: below, it is anywhere
along them."""
WIDER = 3.0
"""Lines count as led through the common point of two others within so many tolerances: all three are off."""

SAME_DIRECTION = CONTEXT.mpf(10) ** -40
"""Components of the product of two unit axes below this are rounding of 60 digits: the axes are parallel."""


@dataclass(frozen=True)
class _Line:
    """An axis of a joint, in doubles to be compared; `to`: the direction it is given, exact."""

    edge: Edge
    slot: int
    turns: bool
    point: Array
    direction: Array
    to: Vector


def aligned(network: Network, tolerance: float) -> Network | None:
    """The network with directions and lines within the tolerance made one; None where nothing changes.

    Args:
        network: lengths in units of its size.
        tolerance: angles [rad] and distances [1] below it are rounding.
    """
    slots = slots_of(network)
    lines = _parallel([line for edge in network.edges.values() for line in _lines(edge)], tolerance)
    z = np.array([CONTEXT.zero] * count_of(slots), dtype=object)
    for line in lines:
        z[numbers_of(slots, line.edge.name, line.slot)] = _turn(line)
    for name, shift in _shifts(lines, tolerance).items():
        z[numbers_of(slots, name, PLACE)] = shift
    return changed(network, slots, z) if any(z) else None


def turned_together(network: Network) -> Array:
    """Columns of the numbers z of `changed` with which axes that are parallel stay so: they turn alike."""
    slots = slots_of(network)
    lines = [line for edge in network.edges.values() for line in _lines(edge)]
    alone = np.eye(count_of(slots))
    parallel = _groups(len(lines), lambda i, k: _across_each_other(lines[i], lines[k]) < SAME_DIRECTION)
    numbers = [[numbers_of(slots, lines[k].edge.name, lines[k].slot) for k in group] for group in parallel]
    places = [
        alone[:, numbers_of(slots, name, slot)] for name in slots for slot in (PLACE, PITCH) if slot in slots[name]
    ]
    return np.concatenate([*places, *(sum(alone[:, own] for own in group) for group in numbers)], axis=1)


def _across_each_other(a: _Line, b: _Line) -> object:
    return max(abs(c) for c in cross(a.to, b.to))


def _lines(edge: Edge) -> Iterator[_Line]:
    point = np.array([float(c) for c in edge.point])
    for motion, column in edge.motions:
        if motion.single:
            screw = edge.screws[column - edge.start]
            x, y, z = screw[:3] if motion.turns else screw[3:]
            direction = np.array([float(x), float(y), float(z)])
            yield _Line(edge, motion.axis or 0, motion.turns, point, direction, (x, y, z))


def _turn(line: _Line) -> Array:
    """What `changed` takes for the axis a to become b: t with a + t x a along b."""
    screw = next(s for (motion, _), s in zip(line.edge.motions, _firsts(line.edge), strict=True)
                 if motion.single and (motion.axis or 0) == line.slot)  # fmt: skip
    x, y, z = screw[:3] if line.turns else screw[3:]
    across = cross((x, y, z), line.to)
    size = dot((x, y, z), line.to)
    return np.array([c / size for c in across], dtype=object)


def _firsts(edge: Edge) -> list[tuple[object, ...]]:
    return [edge.screws[column - edge.start] for _, column in edge.motions]


def _parallel(lines: Sequence[_Line], tolerance: float) -> list[_Line]:
    """The lines with directions within the tolerance made one, their mean."""
    result = list(lines)
    for group in _groups(len(lines), lambda i, k: _sine(lines[i], lines[k]) < tolerance):
        first = lines[group[0]].direction
        signs = [1 if lines[k].direction @ first > 0 else -1 for k in group]
        mean = _exact(np.sum([sign * lines[k].direction for sign, k in zip(signs, group, strict=True)], axis=0))
        mean = scale(1 / CONTEXT.sqrt(dot(mean, mean)), mean)
        if len({tuple(sign * c for c in lines[k].to) for sign, k in zip(signs, group, strict=True)}) > 1:
            for sign, k in zip(signs, group, strict=True):
                result[k] = replace(lines[k], to=scale(CONTEXT.mpf(sign), mean))
    return result


def _shifts(lines: Sequence[_Line], tolerance: float) -> dict[str, Array]:
    """Joint -> how its place is moved so that its axes are coaxial with others, or go through a common point."""
    turning = [line for line in lines if line.turns]
    to: dict[str, list[Array]] = {}
    for group in _groups(len(turning), lambda i, k: _coaxial(turning[i], turning[k], tolerance)):
        if len(group) > 1:
            place = turning[group[0]].point
            for k in group:
                to.setdefault(turning[k].edge.name, []).append(place)
    for place, through in _meetings(turning, tolerance):
        for k in through:
            to.setdefault(turning[k].edge.name, []).append(place)
    shifts = {}
    for name, places in to.items():
        own = [line for line in turning if line.edge.name == name]
        if len(places) == len(own) == 1:
            shifts[name] = _across(own[0], places[0])
        elif len(places) > 1 and all((place == places[0]).all() for place in places) and len(places) == len(own):
            shifts[name] = _exact_array(places[0]) - np.array(own[0].edge.point, dtype=object)
    return shifts


def _across(line: _Line, place: Array) -> Array:
    """The shortest shift of a line through a place."""
    shift = _exact_array(place) - np.array(line.edge.point, dtype=object)
    axis = np.array(line.to, dtype=object)
    return np.asarray(shift - axis * (shift @ axis))


def _meetings(lines: Sequence[_Line], tolerance: float) -> Iterator[tuple[Array, tuple[int, ...]]]:
    """(place, lines through it) where three or more of different directions nearly meet."""
    seen = set[tuple[int, ...]]()
    for i, k in combinations(range(len(lines)), 2):
        place = _closest(lines[i], lines[k], tolerance)
        if place is None:
            continue
        group = tuple(m for m, line in enumerate(lines) if _distance(line, place) < WIDER * tolerance)
        if len({lines[m].edge.name for m in group}) >= MEETING and group not in seen:
            seen.add(group)
            yield _middle([lines[m] for m in group]), group


def _middle(lines: Sequence[_Line]) -> Array:
    """The place nearest to all the lines."""
    across = [np.eye(3) - np.outer(line.direction, line.direction) for line in lines]
    right = sum(part @ line.point for part, line in zip(across, lines, strict=True))
    return np.asarray(np.linalg.lstsq(sum(across), right, rcond=None)[0])


def _closest(a: _Line, b: _Line, tolerance: float) -> Array | None:
    """Where two lines of different directions meet within the tolerance; None where they do not."""
    normal = np.cross(a.direction, b.direction)
    size = float(np.linalg.norm(normal))
    if size < CROSSING or abs((b.point - a.point) @ normal) > tolerance * size:
        return None
    return _middle([a, b])


def _distance(line: _Line, place: Array) -> float:
    return float(np.linalg.norm(np.cross(place - line.point, line.direction)))


def _sine(a: _Line, b: _Line) -> float:
    return float(np.linalg.norm(np.cross(a.direction, b.direction)))


def _coaxial(a: _Line, b: _Line, tolerance: float) -> bool:
    return _sine(a, b) < tolerance and _distance(a, b.point) < tolerance


def _groups(count: int, alike: Callable[[int, int], bool]) -> list[list[int]]:
    """Numbers in groups: what is alike to one of a group is in it."""
    groups: list[list[int]] = []
    for k in range(count):
        near = [group for group in groups if any(alike(i, k) for i in group)]
        groups = [group for group in groups if group not in near]
        groups.append(sorted([k, *(i for group in near for i in group)]))
    return groups


def _exact(vector: Array) -> Vector:
    x, y, z = (CONTEXT.mpf(float(c)) for c in vector)
    return x, y, z


def _exact_array(vector: Array) -> Array:
    return np.array(_exact(vector), dtype=object)

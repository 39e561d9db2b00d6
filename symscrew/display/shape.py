"""What a mechanism looks like, from its description alone: points of bodies, bars and plates."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.description import Mechanism, Vector

Array = np.ndarray

FLAT = 1e-9  # [m] and [m^2]: points nearer than this are one, corners flatter than this are none
PLANE = 1e-6  # relative: triangles flatter than this span no plane; [m]: points nearer than this lie in it


def numbers(mechanism: Mechanism, vector: Vector) -> Array:
    """A vector of the description as numbers, shape (3,)."""
    return np.array([float(mechanism.number(c)) for c in vector])


def body_points(mechanism: Mechanism) -> dict[str, Array]:
    """Joint points and named points of every body [m], without repetition: arrays (n, 3)."""
    found: dict[str, list[Array]] = {name: [] for name in (mechanism.ground, *mechanism.bodies)}
    for joint in mechanism.joints.values():
        for body in (joint.parent, joint.child):
            found[body].append(numbers(mechanism, joint.point))
    for point in mechanism.points.values():
        found[point.body].append(numbers(mechanism, point.at))
    return {body: _distinct(places) for body, places in found.items()}


def drawn_points(mechanism: Mechanism) -> dict[str, Array]:
    """Points of every body (n, 3); of one with a single point, a pendulum's say, its centre of mass as well."""
    found = body_points(mechanism)
    for name, places in found.items():
        body = mechanism.bodies.get(name)
        if name != mechanism.ground and len(places) == 1 and body is not None and body.com is not None:
            com = numbers(mechanism, body.com)
            if np.linalg.norm(com - places[0]) > FLAT:
                found[name] = np.vstack([places, com])
    return found


def _distinct(places: Sequence[Array]) -> Array:
    kept: list[Array] = []
    for place in places:
        if all(np.linalg.norm(place - other) > FLAT for other in kept):
            kept.append(place)
    return np.array(kept).reshape(-1, 3)


def along(places: Array) -> Array:
    """Points (n, 3) of a bar in order along its longest direction."""
    if len(places) < 3:
        return places
    middle = places - places.mean(axis=0)
    direction = np.linalg.svd(middle)[2][0]
    return places[np.argsort(middle @ direction)]


def plate(places: Array) -> tuple[Array, Array] | None:
    """The plane that holds most of the points: which lie in it, and the corners of their hull, in order.

    None where all points (n, 3) are on a line.
    """
    best: tuple[int, Array, Array] | None = None
    for i in range(len(places)):
        for j in range(i):
            for k in range(j):
                normal = np.cross(places[j] - places[i], places[k] - places[i])
                size = np.linalg.norm(normal)
                if size < PLANE * np.ptp(places, axis=0).max() ** 2:
                    continue
                inside = np.abs((places - places[i]) @ (normal / size)) < PLANE
                if best is None or inside.sum() > best[0]:
                    best = (int(inside.sum()), inside, normal / size)
    if best is None:
        return None
    _, inside, normal = best
    flat = places[inside]
    first = flat[np.argmax(np.linalg.norm(flat - flat.mean(axis=0), axis=1))] - flat.mean(axis=0)
    second = np.cross(normal, first)
    plane = np.stack([(flat - flat.mean(axis=0)) @ first, (flat - flat.mean(axis=0)) @ second], axis=1)
    return inside, flat[_hull(plane)]


def _hull(points: Array) -> list[int]:
    """Indices of the corners of the convex hull of plane points, in order (Andrew's monotone chain)."""
    order = sorted(range(len(points)), key=lambda i: (points[i][0], points[i][1]))

    def half(indices: Sequence[int]) -> list[int]:
        chain: list[int] = []
        for i in indices:
            while len(chain) > 1 and _turn(points[chain[-2]], points[chain[-1]], points[i]) <= FLAT:
                chain.pop()
            chain.append(i)
        return chain[:-1]

    return half(order) + half(order[::-1])


def _turn(a: Array, b: Array, c: Array) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))

"""Inertias of the links about their origins, and the same with fewer numbers: base inertial parameters.

bodies --body_inertia--> m, s, Sigma of each --combined--> of each link --regrouped--> what the tree feels
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symscrew.algebra import ZERO, Matrix, Node, add, product, scale, subtract, transform, transpose
from symscrew.description import Body, Mechanism
from symscrew.kinematics.geometry_nodes import Geometry
from symscrew.kinematics.link_quantities import NO_SPREAD, Frame, Inertia
from symscrew.kinematics.tree import Tree


def link_inertias(mechanism: Mechanism, tree: Tree, frames: Sequence[Frame], geometry: Geometry) -> tuple[Inertia, ...]:
    """Inertia of every link: the sum over the bodies that it carries (massless: zeros)."""
    result = []
    for link, frame in zip(tree.links, frames, strict=True):
        total = Inertia(geometry.tape.zero, ZERO, NO_SPREAD)
        for name in link.bodies if link.index else ():
            total = combined(geometry, total, body_inertia(mechanism.bodies[name], frame, geometry))
        result.append(total)
    return tuple(result)


def body_inertia(body: Body, frame: Frame, geometry: Geometry) -> Inertia:
    """A body's inertia about the origin of its link, link axes."""
    if body.mass is None or body.com is None:
        return Inertia(geometry.tape.zero, ZERO, NO_SPREAD)
    mass = geometry.scalar(body.mass)
    away = subtract(geometry.vector(body.com), frame.origin)
    com = geometry.settle(transform(transpose(frame.axes), away))
    second: Matrix = NO_SPREAD
    if body.inertia is not None:
        rows = tuple(geometry.vector(row) for row in body.inertia)
        local = product(product(transpose(frame.axes), (rows[0], rows[1], rows[2])), frame.axes)
        trace = geometry.settle((local[0][0] + local[1][1] + local[2][2], 0, 0))[0]
        second = tuple(  # type: ignore[assignment]
            tuple((_half(geometry, trace) if i == j else 0) - local[i][j] for j in range(3)) for i in range(3)
        )
    spread = tuple(tuple(second[i][j] + mass * com[i] * com[j] for j in range(3)) for i in range(3))
    return Inertia(mass, geometry.settle(scale(mass, com)), geometry.settle_matrix(spread))  # type: ignore[arg-type]


def _half(geometry: Geometry, node: Node) -> Node:
    return node * geometry.tape.reciprocal(geometry.tape.node(2))


def combined(geometry: Geometry, a: Inertia, b: Inertia) -> Inertia:
    """The inertia of two bodies on one link, about the same origin."""
    second = tuple(add(x, y) for x, y in zip(a.second, b.second, strict=True))
    still = tuple(add(x, y) for x, y in zip(a.still, b.still, strict=True))
    first = geometry.settle(add(a.first, b.first))
    return Inertia(a.mass + b.mass, first, geometry.settle_matrix(second), geometry.settle_matrix(still))  # type: ignore[arg-type]


def without_gyroscopic_moment(own: Inertia, geometry: Geometry) -> Inertia:
    """The inertia of a link whose moment omega x J omega about its centre of mass is left out.

    A slender rod, without inertia about its line, keeps it: with n along the line both moments together are
    J n x n_ddot, whatever the spin about the line; J alpha alone would depend on this spin, which moves no mass.
    """
    if own.mass is geometry.tape.zero:
        return own
    spread = scale(1 / own.mass, own.first)
    rows = tuple(tuple(own.second[i][j] - own.first[i] * spread[j] for j in range(3)) for i in range(3))
    central = geometry.settle_matrix(rows)  # type: ignore[arg-type]
    sides = ((0, 1), (1, 2), (2, 0))
    minors = [central[i][k] * central[j][m] - central[i][m] * central[j][k] for i, j in sides for k, m in sides]
    slender = all(geometry.tape.settle(minor) is geometry.tape.zero for minor in minors)
    return own if slender else replace(own, still=central)


def regrouped(
    tree: Tree, frames: Sequence[Frame], inertia: Sequence[Inertia], geometry: Geometry
) -> tuple[Inertia, ...]:
    """Inertias with the same generalised forces of the tree and fewer numbers in them.

    What lies on a revolute joint's axis moves with the parent just as well: mass, first moment along the
    axis, and as much second moment along it as makes J_xx vanish. What a slider adds to its parent's angular
    inertia is the parent's. (Khalil and Dombre, Modeling, Identification and Control of Robots, 2002, sec. 9.4:
    base inertial parameters.) The drives and the multipliers of cut joints are unchanged; the reactions
    inside the tree are not, so they are computed from the inertias as given. Only constants are regrouped.
    Every function asks for the same ones, which the geometry keeps.
    """
    given = tuple(inertia)
    if given not in geometry.regrouped:
        geometry.regrouped[given] = _regrouped(tree, frames, given, geometry)
    return geometry.regrouped[given]


def _regrouped(
    tree: Tree, frames: Sequence[Frame], inertia: Sequence[Inertia], geometry: Geometry
) -> tuple[Inertia, ...]:
    result = list(inertia)
    for link in reversed(tree.links[1:]):
        own, frame = result[link.index], frames[link.index]
        if not _constant(geometry, own, frame) or not _constant(geometry, result[link.parent], frame):
            continue
        split = link.pair.base_inertia(geometry, frame, own)
        if split is None:
            continue
        result[link.index], moved = split
        result[link.parent] = combined(geometry, result[link.parent], moved)
    return tuple(result)


def _constant(geometry: Geometry, inertia: Inertia, frame: Frame) -> bool:
    values = (
        inertia.mass,
        *inertia.first,
        *(c for row in (*inertia.second, *inertia.still) for c in row),
        *frame.offset,
        *frame.axis,
    )
    return all(geometry.tape.node(v).value is not None for v in values)

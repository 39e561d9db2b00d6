"""Derivatives of a tree's inertial forces from composite bodies: one pass to the ground, then one product per pair.

Everything outboard of a joint is one body whose points at r, from the joint's origin, move with r_dot. Where its state
changes by (d_omega, d_alpha, d_origin), its points' accelerations change by d_origin + d_alpha x r + 2 d_omega x r_dot,
and the force and moment that it needs by

    m d_origin + d_alpha x s + d_omega x P,    s x d_origin + (tr Sigma - Sigma) d_alpha + D d_omega

with the moments m, s = sum m r, Sigma = sum m r r', P = 2 sum m r_dot, D = 2 sum m (r . r_dot - r_dot r'). Velocities
of the origin never enter. A unit of a freedom's rate, acceleration or coordinate is such a change for what is outboard
of it: its columns are carried towards the ground. What a joint's force takes of changes further inboard is a row,
carried towards the ground by the transposed rules. (Singh, Russell and Wensing, Efficient analytical derivatives of
rigid-body dynamics using spatial vector algebra, 2022; here about the joints' origins in links' axes.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import (
    ZERO,
    Matrix,
    Node,
    Scalar,
    Tape,
    Vector,
    add,
    cross,
    dot,
    product,
    scale,
    transform,
    transpose,
)
from symscrew.dynamics.tree_dynamics import moved_inertia
from symscrew.effects import Acting
from symscrew.kinematics import GROUND, Inertia, Link, Placement, Rates, System, acceleration_matrix, own_screws

NOTHING: Matrix = ((0, 0, 0),) * 3
Table = list[list[Node]]  # [row: freedom of v][column: direction of v]


@dataclass(frozen=True)
class Composite:
    """Everything outboard of a joint, about the link's origin in its axes; see the module."""

    inertia: Inertia
    momentum: Vector
    spreading: Matrix
    force: Vector
    moment: Vector

    def needed(self, change: Change) -> tuple[Vector, Vector]:
        """Force and moment that a change of the state takes."""
        mass, first, second = self.inertia.mass, self.inertia.first, self.inertia.second
        force = add(scale(mass, change.origin), cross(change.alpha, first))
        moment = add(cross(first, change.origin), _less_trace(second, change.alpha))
        return (
            add(force, cross(change.omega, self.momentum)),
            add(moment, transform(self.spreading, change.omega)),
        )

    def row(self, angular: Vector, linear: Vector) -> Change:
        """What a freedom's force takes of a change of the state."""
        mass, first, second = self.inertia.mass, self.inertia.first, self.inertia.second
        omega = add(transform(transpose(self.spreading), angular), cross(self.momentum, linear))
        alpha = add(_less_trace(second, angular), cross(first, linear))
        return Change(omega, alpha, add(scale(mass, linear), cross(angular, first)))

    def plus(self, other: Composite) -> Composite:
        """Both bodies together."""
        a, b = self.inertia, other.inertia
        return Composite(
            Inertia(a.mass + b.mass, add(a.first, b.first), _sum(a.second, b.second)),
            add(self.momentum, other.momentum),
            _sum(self.spreading, other.spreading),
            add(self.force, other.force),
            add(self.moment, other.moment),
        )

    def inwards(self, placed: Placement, twice: Vector) -> Composite:
        """The same about the parent's origin in its axes; `twice`: 2 d/dt of the offset, seen from the ground."""
        inertia, r = moved_inertia(placed, self.inertia), placed.offset
        momentum = placed.inwards(self.momentum)
        moved = _sum(_outer(momentum, r), _outer(twice, inertia.first))
        spreading = _sum(_turned(placed.rotation, _turned(placed.turn, self.spreading)), _around(moved))
        force = placed.inwards(self.force)
        moment = add(placed.inwards(self.moment), cross(r, force))
        return Composite(inertia, add(momentum, scale(inertia.mass, twice)), spreading, force, moment)


@dataclass(frozen=True)
class Change:
    """A change of the state of a composite body, or a linear function of it; link axes, about the link's origin."""

    omega: Vector
    alpha: Vector
    origin: Vector

    def of(self, other: Change) -> Scalar:
        """The function's value."""
        pairs = ((self.omega, other.omega), (self.alpha, other.alpha), (self.origin, other.origin))
        total: Scalar = sum((dot(x, y) for x, y in pairs), start=0)
        return total

    def inwards(self, placed: Placement, twice: Vector) -> Change:
        """A function of the parent's state instead."""
        omega, alpha, origin = (placed.inwards(x) for x in (self.omega, self.alpha, self.origin))
        return Change(add(omega, cross(twice, origin)), add(alpha, cross(placed.offset, origin)), origin)


@dataclass(frozen=True)
class _Freedom:
    """One freedom of a joint: its screw at the link's origin in link axes, changes by a unit of q, v and a."""

    angular: Vector
    linear: Vector
    changes: tuple[Change, Change, Change]


def inertial_derivatives(acting: Acting, a: Sequence[Node]) -> tuple[Table, Table, Table]:
    """Derivatives of the inertial generalised forces (for v) by steps of q, by v and by a: [freedom][direction].

    Steps of q are along the entries of v: rotation vectors in the child's axes for spherical motions.
    """
    system, tree, tape = acting.system, acting.system.tree, acting.system.tape
    moving, lean = acting.link_rates(a), acting.lean_inertia()
    bodies = [_own(inertia, rates) for inertia, rates in zip(lean, moving, strict=True)]
    wrenches = acting.inertial_wrenches(a)
    size = len(tree.v)
    tables = (_zeros(tape, size), _zeros(tape, size), _zeros(tape, size))
    freedoms = {link.index: _freedoms(system, link, moving) for link in tree.links[1:]}
    columns: dict[int, list[tuple[int, int, Vector, Vector]]] = {k: [] for k in range(len(tree.links))}
    rows: dict[int, list[tuple[int, Change]]] = {k: [] for k in range(len(tree.links))}
    for link in reversed(tree.links[1:]):
        k, frame, placed = link.index, system.frames[link.index], system.placed[link.index]
        force, moment = wrenches[k]
        body = bodies[k] = bodies[k].plus(Composite(_none(tape), ZERO, NOTHING, force, moment))
        for group, column, f, m in columns[k]:
            for row, value in enumerate(link.pair.powers(frame, f, m), start=link.v.start):
                tables[group][row][column] = tape.node(value)
        for row, function in rows[k]:
            for column, freedom in enumerate(freedoms[k], start=link.v.start):
                for table, change in zip(tables, freedom.changes, strict=True):
                    table[row][column] = tape.node(function.of(change))
        for column, freedom in enumerate(freedoms[k], start=link.v.start):
            for group, change in enumerate(freedom.changes):
                f, m = body.needed(change)
                for row, value in enumerate(link.pair.powers(frame, f, m), start=link.v.start):
                    tables[group][row][column] = tape.node(value)
                if group == 0:
                    f = add(f, cross(freedom.angular, body.force))
                    m = add(m, add(cross(freedom.angular, body.moment), cross(freedom.linear, body.force)))
                columns[k].append((group, column, f, m))
            rows[k].append((column, body.row(freedom.angular, freedom.linear)))
        if link.parent == GROUND:
            continue
        velocity = add(cross(moving[link.parent].omega, placed.offset), own_screws(link, frame, system.inputs.v).linear)
        twice = scale(2, velocity)
        bodies[link.parent] = bodies[link.parent].plus(body.inwards(placed, twice))
        for group, column, f, m in columns[k]:
            f, m = placed.inwards(f), placed.inwards(m)
            columns[link.parent].append((group, column, f, add(m, cross(placed.offset, f))))
        rows[link.parent] += [(row, function.inwards(placed, twice)) for row, function in rows[k]]
    return tables


def _freedoms(system: System, link: Link, moving: Sequence[Rates]) -> list[_Freedom]:
    frame, here, placed = system.frames[link.index], moving[link.index], system.placed[link.index]
    parent = moving[link.parent]
    before, matrix = placed.outwards(parent.omega), here.matrix  # of a single axis the product with U is the parent's
    if link.motion.spherical:
        matrix = acceleration_matrix(before, placed.outwards(parent.alpha))
    result = []
    for screw in link.pair.unit_screws(frame):
        e, s = screw.angular, screw.linear
        turned = cross(before, e)
        by_q = Change(turned, transform(matrix, e), add(cross(here.origin, e), transform(matrix, s)))
        rate = add(turned, cross(here.omega, e))
        by_v = Change(e, rate, cross(scale(2, before), s))
        result.append(_Freedom(e, s, (by_q, by_v, Change(ZERO, e, s))))
    return result


def _own(inertia: Inertia, rates: Rates) -> Composite:
    """One link, without the wrench it takes."""
    twice = scale(2, rates.omega)
    columns = [cross(column, twice) for column in transpose(inertia.second)]
    return Composite(inertia, cross(twice, inertia.first), transpose((columns[0], columns[1], columns[2])), ZERO, ZERO)


def _none(tape: Tape) -> Inertia:
    return Inertia(tape.zero, ZERO, NOTHING)


def _zeros(tape: Tape, size: int) -> Table:
    return [[tape.zero] * size for _ in range(size)]


def _less_trace(matrix: Matrix, vector: Vector) -> Vector:
    """(tr A - A) b."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = matrix
    x, y, z = vector
    return (
        (yy + zz) * x - xy * y - xz * z,
        (xx + zz) * y - yx * x - yz * z,
        (xx + yy) * z - zx * x - zy * y,
    )


def _around(matrix: Matrix) -> Matrix:
    """tr A - A."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = matrix
    return ((yy + zz, -xy, -xz), (-yx, xx + zz, -yz), (-zx, -zy, xx + yy))


def _turned(turn: Matrix, matrix: Matrix) -> Matrix:
    """A matrix in other axes.

    A turn about z keeps xx + yy and xy - yx: with t = c (xx - yy) - s (xy + yx) the new entries are yy + c t, xx - c t,
    xy + s t and yx + s t.
    """
    if turn[2] == (0, 0, 1):
        (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = matrix
        c, s = turn[0][0], turn[1][0]
        part = c * (xx - yy) - s * (xy + yx)
        along, across = c * part, s * part
        return (
            (yy + along, xy + across, c * xz - s * yz),
            (yx + across, xx - along, s * xz + c * yz),
            (c * zx - s * zy, s * zx + c * zy, zz),
        )
    return product(product(turn, matrix), transpose(turn))


def _outer(a: Vector, b: Vector) -> Matrix:
    return (scale(a[0], b), scale(a[1], b), scale(a[2], b))


def _sum(a: Matrix, b: Matrix) -> Matrix:
    return (add(a[0], b[0]), add(a[1], b[1]), add(a[2], b[2]))

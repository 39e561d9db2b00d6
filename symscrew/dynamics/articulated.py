"""Forward dynamics of trees in linear time: articulated-body inertias from the tips to the ground.

Seen from its joint, a link with everything outboard of it answers an acceleration of its origin (alpha ; a)
with the wrench (f ; m) = (A a + B alpha ; B^T a + D alpha) + bias (Featherstone 1983). Accelerations are
counted from those that the tree has at present with all joints steady, so that velocities enter the biases
only. All in link axes, about the link's origin.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import (
    ZERO,
    Guard,
    Matrix,
    Node,
    Tape,
    Twist,
    Vector,
    add,
    cross,
    dot,
    magnitude,
    named_entries,
    named_matrix,
    named_wrench,
    product,
    scale,
    subtract,
    transform,
    transpose,
)
from symscrew.effects import Acting
from symscrew.kinematics import GROUND, Inertia, Placement, System


@dataclass(frozen=True)
class Articulated:
    """How a link answers accelerations: force A a + B alpha, moment B^T a + D alpha; A and D symmetric."""

    linear: Matrix  # A
    mixed: Matrix  # B
    angular: Matrix  # D

    def wrench(self, screw: Twist) -> tuple[Vector, Vector]:
        """Force and moment for an acceleration screw (alpha ; a)."""
        alpha, a = screw.angular, screw.linear
        force = add(transform(self.linear, a), transform(self.mixed, alpha))
        return force, add(transform(transpose(self.mixed), a), transform(self.angular, alpha))

    def less(self, force: Vector, moment: Vector, factor: Node) -> Articulated:
        """What is left when a freedom yields: less factor times the dyad of the wrench (force ; moment)."""
        f, m = scale(factor, force), scale(factor, moment)
        return Articulated(
            _minus(self.linear, f, force, symmetric=True),
            _minus(self.mixed, f, moment),
            _minus(self.angular, m, moment, symmetric=True),
        )

    def plus(self, other: Articulated) -> Articulated:
        """Two at the same link."""
        return Articulated(*(_sum(x, y) for x, y in zip(self.parts, other.parts, strict=True)))

    @property
    def parts(self) -> tuple[Matrix, Matrix, Matrix]:
        """A, B, D."""
        return self.linear, self.mixed, self.angular

    def inwards(self, placed: Placement) -> Articulated:
        """The same in the parent's axes about the parent's origin."""
        a, b, d = (_turned(placed, part) for part in self.parts)
        r = placed.offset
        shift: Matrix = ((0, -r[2], r[1]), (r[2], 0, -r[0]), (-r[1], r[0], 0))
        # acceleration of this origin: a_parent + alpha x r, moment about the parent's: m + r x f
        carried = product(a, shift)
        mixed = _sum(b, _negative(carried))
        turned = _sum(product(shift, b), _negative(product(transpose(b), shift)))
        angular = _sum(_sum(d, turned), _negative(product(shift, carried)))
        return Articulated(a, mixed, angular)


@dataclass(frozen=True)
class _Yielded:
    """A freedom that yields: its unit screw, the wrench that answers it, 1 / its stiffness, its effort over that."""

    screw: Twist
    answer: tuple[Vector, Vector]
    inverse: Node
    effort: Node


def rigid(inertia: Inertia) -> Articulated:
    """A body by itself."""
    x, y, z = inertia.first
    mass, second = inertia.mass, inertia.second
    trace = second[0][0] + second[1][1] + second[2][2]
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = second
    return Articulated(
        ((mass, 0, 0), (0, mass, 0), (0, 0, mass)),
        ((0, z, -y), (-z, 0, x), (y, -x, 0)),
        ((trace - xx, 0 - xy, 0 - xz), (0 - yx, trace - yy, 0 - yz), (0 - zx, 0 - zy, trace - zz)),
    )


def articulated_accelerations(system: System, acting: Acting) -> tuple[list[Node], list[Guard]]:
    """Accelerations of a tree's joints (for v) under everything that acts, and the guarded pivots."""
    tape, tree = system.tape, system.tree
    zeros = [tape.zero] * len(tree.v)
    inertia = acting.lean_inertia()
    bodies = [rigid(one) for one in inertia]
    for bending in acting.bendings:
        bodies[bending.link] = bodies[bending.link].less(*bending.felt, 1 / bending.mass)
    biases = _biases(system, acting)
    forces = acting.known_forces(zeros)
    known = system.tree_rates([forces.get(k, tape.zero) for k in range(len(tree.v))])
    kept: list[list[_Yielded]] = [[] for _ in tree.links]
    guards: list[Guard] = []
    for link in reversed(tree.links[1:]):
        body, (force, moment) = bodies[link.index], biases[link.index]
        part = tree.part(link.index)
        for prefix, matrix in zip(("A_", "B_", "D_"), body.parts, strict=True):
            named_matrix(matrix, "articulated", part, prefix=prefix)
        named_wrench((force, moment), "force", part)
        for k, screw in enumerate(link.pair.unit_screws(system.frames[link.index])):
            answer = body.wrench(screw)
            stiffness = _pairing(tape, answer, screw) + acting.reflected_inertia.get(link.v.start + k, tape.zero)
            label = tree.v[link.v.start + k].label
            named_entries([stiffness], "stiffness", [label])
            named_wrench(answer, "answer", label)
            inverse = 1 / stiffness
            effort = inverse * (known[link.v.start + k] - _pairing(tape, (force, moment), screw))
            named_entries([effort], "effort", [label])
            body = body.less(*answer, inverse)
            force, moment = add(force, scale(effort, answer[0])), add(moment, scale(effort, answer[1]))
            kept[link.index].append(_Yielded(screw, answer, inverse, effort))
            guards.append(Guard(stiffness, 1.0 / max(1e-300, magnitude(tape, stiffness, 1.0)[1])))
        if link.parent != GROUND:
            placed = system.placed[link.index]
            bodies[link.parent] = bodies[link.parent].plus(body.inwards(placed))
            f, m = placed.inwards(force), placed.inwards(moment)
            waiting = biases[link.parent]
            biases[link.parent] = add(waiting[0], f), add(add(waiting[1], m), cross(placed.offset, f))
    return _outwards(system, kept), guards


def _biases(system: System, acting: Acting) -> list[tuple[Vector, Vector]]:
    """Wrench that every link needs with all joints steady, less the loads on it."""
    needed = acting.inertial_wrenches([system.tape.zero] * len(system.tree.v))
    result = []
    for link in system.tree.links:
        force, moment = needed.get(link.index, (ZERO, ZERO))
        if link.index in acting.loads:
            back = transpose(system.placed[link.index].turn)
            f, m = (transform(back, vector) for vector in acting.loads[link.index])
            force, moment = subtract(force, f), subtract(moment, m)
        result.append((force, moment))
    return result


def _outwards(system: System, kept: Sequence[Sequence[_Yielded]]) -> list[Node]:
    """Joint accelerations from the ground to the tips."""
    tape, tree = system.tape, system.tree
    result = [tape.zero] * len(tree.v)
    moving = [Twist(ZERO, ZERO)] * len(tree.links)
    for link in tree.links[1:]:
        placed, parent = system.placed[link.index], moving[link.parent]
        alpha = placed.outwards(parent.angular)
        a = placed.outwards(add(parent.linear, cross(parent.angular, placed.offset)))
        for k, freedom in reversed(list(enumerate(kept[link.index]))):
            value = freedom.effort - freedom.inverse * _pairing(tape, freedom.answer, Twist(alpha, a))
            result[link.v.start + k] = value
            named_entries([value], "joint_acceleration", [tree.v[link.v.start + k].label])
            alpha, a = add(alpha, scale(value, freedom.screw.angular)), add(a, scale(value, freedom.screw.linear))
        moving[link.index] = Twist(alpha, a)
    return result


def _pairing(tape: Tape, wrench: tuple[Vector, Vector], screw: Twist) -> Node:
    return tape.node(dot(wrench[0], screw.linear) + dot(wrench[1], screw.angular))


def _minus(matrix: Matrix, left: Vector, right: Vector, *, symmetric: bool = False) -> Matrix:
    """matrix - left right^T; a symmetric result is computed once."""
    rows = [[matrix[i][j] - left[i] * right[j] for j in range(3)] for i in range(3)]
    if symmetric:
        rows = [[rows[min(i, j)][max(i, j)] for j in range(3)] for i in range(3)]
    (a, b, c), (d, e, f), (g, h, i) = rows
    return ((a, b, c), (d, e, f), (g, h, i))


def _sum(x: Matrix, y: Matrix) -> Matrix:
    return (add(x[0], y[0]), add(x[1], y[1]), add(x[2], y[2]))


def _negative(x: Matrix) -> Matrix:
    return (scale(-1, x[0]), scale(-1, x[1]), scale(-1, x[2]))


def _turned(placed: Placement, matrix: Matrix) -> Matrix:
    """R matrix R^T with R from link axes to parent axes."""
    half = _inwards(placed, matrix)
    return transpose(_inwards(placed, transpose(half)))


def _inwards(placed: Placement, rows: Matrix) -> Matrix:
    return (placed.inwards(rows[0]), placed.inwards(rows[1]), placed.inwards(rows[2]))

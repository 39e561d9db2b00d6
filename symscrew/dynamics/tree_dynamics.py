"""The tree's own equations: mass matrix by composite bodies, generalised forces by one pass to the ground."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product as pairs_of

from symscrew.algebra import (
    ZERO,
    Matrix,
    Node,
    Vector,
    add,
    cross,
    dot,
    named_entries,
    named_matrix,
    named_vector,
    named_wrench,
    product,
    scale,
    transform,
    transpose,
)
from symscrew.dynamics.setting import accumulate
from symscrew.effects import Acting, AddedInertia
from symscrew.kinematics import (
    GROUND,
    Inertia,
    Link,
    Placement,
    Rates,
    System,
    acceleration_matrix,
    inertial_wrench,
    regrouped,
)


def generalised_forces(system: System, acting: Acting, a: Sequence[Node]) -> list[Node]:
    """M a + h - f: generalised forces (for v) [N, N m] that accelerations a of the open tree need, less what acts.

    One pass of Newton and Euler from the tips to the ground. Zero, but for multipliers of cut joints, for a motion.
    """
    return balanced_forces(system, acting, a, acting.inertial_wrenches(a))


def applied_forces(system: System, acting: Acting, a: Sequence[Node]) -> list[Node]:
    """f: what acts on the tree, as generalised forces (for v) [N, N m], at accelerations a where it depends on them."""
    return [-force for force in balanced_forces(system, acting, a, {})]


def balanced_forces(
    system: System, acting: Acting, a: Sequence[Node], waiting: dict[int, tuple[Vector, Vector]]
) -> list[Node]:
    """Generalised forces of wrenches of the links, own axes, less what acts."""
    loads = acting.loads
    tree, tape = system.tree, system.tape
    result = [tape.zero] * len(tree.v)
    for link in reversed(tree.links[1:]):
        placed, frame = system.placed[link.index], system.frames[link.index]
        if link.index not in waiting and link.index not in loads:
            continue
        force, moment = waiting.get(link.index, (ZERO, ZERO))
        if link.index in loads:
            f, m = loads[link.index]
            back = transpose(placed.turn)
            force, moment = (
                add(force, scale(-1, transform(back, f))),
                add(moment, scale(-1, transform(back, m))),
            )
        named_wrench((force, moment), "force", tree.part(link.index))
        for k, value in enumerate(link.pair.powers(frame, force, moment), start=link.v.start):
            result[k] = tape.node(value)
        if link.parent != GROUND:
            force, moment = placed.inwards(force), placed.inwards(moment)
            here = {"": waiting.get(link.parent, (ZERO, ZERO))}
            accumulate(here, "", force, add(moment, cross(placed.offset, force)))
            waiting[link.parent] = here[""]
    forces = acting.known_forces(a)
    known = [forces.get(k, tape.zero) for k in range(len(tree.v))]
    needed = [value - force for value, force in zip(result, system.tree_rates(known), strict=True)]
    named_entries(needed, "generalised_force", [c.label for c in tree.v])
    return needed


def mass_matrix(
    system: System, added: AddedInertia | None = None, inertia: Sequence[Inertia] | None = None
) -> list[list[Node]]:
    """M of the open tree, symmetric, with kinetic energy v . M v / 2: entries [kg, kg m, kg m^2].

    Composite rigid bodies (Walker and Orin 1982): the momentum of everything outboard of a joint per unit rate of the
    joint, projected on the joints inboard of it. Of what is `added`, inertias that move with one freedom only stand on
    the diagonal; a deflection yields, so that the mass that moves it counts less. `inertia` is what the links have in
    place of their own. The system keeps the answer for its own inertias: several functions ask for it.
    """
    known = added or AddedInertia()
    if inertia is not None or known.bendings:
        return _composite_bodies(system, known, inertia or system.inertia)
    key = ("mass_matrix", *((k, further.index) for k, further in known.freedoms.items()))
    if key not in system.answers:
        system.answers[key] = _composite_bodies(system, known, system.inertia)
    return [list(row) for row in system.answers[key]]


def _composite_bodies(system: System, known: AddedInertia, inertia: Sequence[Inertia]) -> list[list[Node]]:
    tree, tape = system.tree, system.tape
    composite: list[Inertia] = list(regrouped(tree, system.frames, known.grown(inertia), system.geometry))
    n = len(tree.v)
    matrix = [[tape.zero] * n for _ in range(n)]
    for link in reversed(tree.links[1:]):
        for k in range(link.v.start, link.v.stop):
            wrench = _unit_wrench(system, link, k - link.v.start, composite[link.index])
            for j, value in _pushed(system, link, wrench):
                matrix[j][k] = matrix[k][j] = value
                named_entries([value], "mass_matrix", [f"{tree.v[j].label}|{tree.v[k].label}"])
        if link.parent != GROUND:
            moved = moved_inertia(system.placed[link.index], composite[link.index])
            inner = composite[link.parent]
            (x, y, z), (u, v, w) = inner.second, moved.second
            second = (add(x, u), add(y, v), add(z, w))
            composite[link.parent] = Inertia(inner.mass + moved.mass, add(inner.first, moved.first), second)
            part = tree.part(link.parent)
            named_vector(composite[link.parent].first, "composite", part, prefix="first_")
            named_matrix(second, "composite", part, prefix="second_")
    for k, further in known.freedoms.items():
        matrix[k][k] = matrix[k][k] + further
    for bending in known.bendings:
        row, yields = _pushed(system, tree.links[bending.link], bending.felt), 1 / bending.mass
        for (j, one), (k, other) in pairs_of(row, row):
            matrix[j][k] = matrix[j][k] - yields * (one * other)
    return matrix


def in_joint_rates(system: System, inertia: Sequence[Sequence[Node]]) -> list[list[Node]]:
    """A mass matrix for v as one for joint rates w.

    A body's moment of inertia that is common to several axes needs no rotation: R (J - s 1) R^T + s 1.
    """
    matrix = [list(row) for row in inertia]
    commons: dict[int, Node] = {}
    for link in system.tree.links[1:]:
        if link.motion.spherical:
            places = range(link.v.start, link.v.stop)
            diagonal = [matrix[k][k] for k in places]
            common = max(diagonal, key=diagonal.count)
            for k in places:
                matrix[k][k] = matrix[k][k] - common
                commons[k] = common
    columns = [system.joint_rates(row) for row in matrix]
    turned = [system.joint_rates(column) for column in zip(*columns, strict=True)]
    for k, common in commons.items():
        turned[k][k] = turned[k][k] + common
    return turned


def _unit_wrench(system: System, link: Link, k: int, inertia: Inertia) -> tuple[Vector, Vector]:
    """Inertial wrench of a composite body at rest under a unit acceleration of one freedom of its joint."""
    screw = link.pair.unit_screws(system.frames[link.index])[k]
    return inertial_wrench(inertia, Rates(ZERO, screw.angular, screw.linear, acceleration_matrix(ZERO, screw.angular)))


def _pushed(system: System, link: Link, wrench: tuple[Vector, Vector]) -> list[tuple[int, Node]]:
    """Generalised forces of one wrench on its link, down to the ground."""
    force, moment = wrench
    result = []
    while True:
        for k, value in enumerate(link.pair.powers(system.frames[link.index], force, moment)):
            result.append((link.v.start + k, system.tape.node(value)))
        placed = system.placed[link.index]
        force, moment = placed.inwards(force), placed.inwards(moment)
        moment = add(moment, cross(placed.offset, force))
        if link.parent == GROUND:
            return result
        link = system.tree.links[link.parent]


def moved_inertia(placed: Placement, inertia: Inertia) -> Inertia:
    """A composite inertia in the parent's axes about the parent's origin."""
    mass, first, r = inertia.mass, placed.inwards(inertia.first), placed.offset
    moved = add(first, scale(mass, r))
    turned = _turned(placed.rotation, _turned(placed.turn, inertia.second))
    xx, yy, zz = (turned[i][i] + r[i] * (first[i] + moved[i]) for i in range(3))
    xy, xz, yz = (turned[i][j] + (r[i] * first[j] + moved[i] * r[j]) for i, j in ((0, 1), (0, 2), (1, 2)))
    return Inertia(mass, moved, ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))


def _turned(turn: Matrix, matrix: Matrix) -> Matrix:
    """A symmetric matrix in other axes.

    A turn about z keeps xx + yy, and its double angle costs three products: with t = c (xx - yy) - 2 s xy the new
    entries are yy + c t, xx - c t and xy + s t.
    """
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = matrix
    if turn[2] == (0, 0, 1):
        c, s = turn[0][0], turn[1][0]
        part = c * (xx - yy) - s * (2 * xy)
        along, across = c * part, xy + s * part
        x, y = c * xz - s * yz, s * xz + c * yz
        return ((yy + along, across, x), (across, xx - along, y), (x, y, zz))
    first, second, third = product(turn, matrix)
    xx, xy, xz = (dot(first, row) for row in turn)
    yy, yz = dot(second, turn[1]), dot(second, turn[2])
    return ((xx, xy, xz), (xy, yy, yz), (xz, yz, dot(third, turn[2])))

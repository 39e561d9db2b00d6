"""How the closure of accelerations, J a + (dJ/dt) v = 0, changes along directions of the state.

The hub's quantities are carried to the tip of each cut joint, as in
`symscrew.kinematics.cut_joints`. Those of a spherical hub are taken in the axes before its motion, where its rates w
stand and where several limbs share them.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Node, Vector, add, cross, differentiate, dot, scale, subtract, transform, transpose
from symscrew.dynamics.derivatives.motion_variations import (
    Direction,
    Variation,
    Varied,
    matrix_change,
    minus,
    plus,
    seed_rates,
    three,
    times,
    with_changes,
)
from symscrew.kinematics import GROUND, Cut, Rates, Relation, acceleration_matrix, closure_bias

Changes = Sequence[Sequence[Rates]]


def closure_changes(variation: Variation) -> list[list[Node]]:
    """Changes of J a + (dJ/dt) v along directions of the state, [direction][row of the system's closure].

    Where a direction displaces the tree they are right for motions that keep the loops closed only: there the two
    points of a cut joint have the same acceleration, and only one of them is carried to the other's axes.
    """
    system = variation.system
    moving = system.rates(system.inputs.a)
    changes = variation.rate_changes(moving)
    by: list[list[Node]] = [[] for _ in variation.directions]
    for cut in system.cuts:
        if cut.relation is not None:
            for column, direction in zip(by, variation.directions, strict=True):
                column.append(_tied(variation, cut.relation, direction))
            continue
        rows = (_sliding if cut.joint.kind.slides else _meeting)(variation, cut, moving, changes)
        for column, more in zip(by, rows, strict=True):
            column += more
    return by


def _tied(variation: Variation, relation: Relation, direction: Direction) -> Node:
    """Change of the second rate of a coupling along a direction; its coordinates are joint rates themselves."""
    total = variation.system.tape.zero
    for share in relation.shares:
        k, v, a = share.v, variation.w[share.v], variation.w_dot[share.v]
        total = total + share.slope() * direction.gain[k]
        total = total + share.slope(2) * (direction.step[k] * a + 2 * (v * direction.rate[k]))
        total = total + share.slope(3) * (direction.step[k] * (v * v))
    return total


def _sliding(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> list[list[Node]]:
    """Rows of a cut whose points slide on each other: by the tape, down to the rates of tip and hub."""
    system, seeds = variation.system, with_changes(variation.seeds)
    for name, change in zip(variation.names, changes, strict=True):
        for link in (cut.tip, cut.hub):
            seed_rates(seeds, name, moving[link], change[link])
    rows = closure_bias(cut, system.linkage, system.twist, moving, v=system.inputs.v)
    found = differentiate(system.tape, rows, seeds, variation.names, order="forward")
    return [[row[k] for row in found] for k in range(len(changes))]


def _meeting(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> list[list[Node]]:
    """Rows of a cut whose two points coincide."""
    tip = [moving[cut.tip], *(change[cut.tip] for change in changes)]
    at_tip: Varied = [rates.at(cut.tip_point) for rates in tip]
    # Along a consistent motion the hub's point has the acceleration of the tip's: one of them need not be carried.
    if _spins(variation, cut):
        at_hub = [at_tip[0], *_spun(variation, cut)]
    else:
        at_hub = _seen(variation, cut, _contact(variation, cut, moving, changes), at_tip[0])
    linear = minus(at_hub, at_tip)
    alpha: Varied = linear
    if any(row.unit != "N" for row in cut.rows) and not cut.joint.kind.universal:
        spin = [_seen(variation, cut, x) for x in _spin(variation, cut, moving, changes)]
        omega = minus(spin[0], [rates.omega for rates in tip])
        alpha = minus(spin[1], [rates.alpha for rates in tip])
        alpha = minus(alpha, times([rates.omega for rates in tip], omega))
    rows: list[list[Node]] = [[] for _ in changes]
    for row in cut.rows:
        if row.unit == "N":
            values = [dot(row.force, x) for x in linear[1:]]
        elif cut.joint.kind.universal:
            values = _axes_rows(variation, cut, moving, changes)
        else:
            values = [dot(row.couple, x) for x in alpha[1:]]
        for column, value in zip(rows, values, strict=True):
            column.append(-variation.system.tape.node(value))
    return rows


def _axes_rows(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> list[Node]:
    """Changes of the couple of a universal joint: of the second rate of e . h, e the tip's axis, h the hub's,

        e . U_hub h + h . U_tip e + 2 (omega_tip x e) . (omega_hub x h),    U = [alpha]x + [omega]x^2.

    What the links' turn against each other contributes is one scalar product.
    """
    system, tip, hub = variation.system, moving[cut.tip], moving[cut.hub]
    k = 0 if cut.tip_is_parent else 1
    e, h = cut.tip_axes[k], cut.hub_axes[1 - k]
    fixed = 2 * system.tape.settle(dot(cut.tip_axes[0], cut.tip_axes[1]))  # 2 e . h

    def to_tip(vector: Vector) -> Vector:
        return system.linkage.carry(cut.hub, cut.tip, vector)

    def to_hub(vector: Vector) -> Vector:
        return system.linkage.carry(cut.tip, cut.hub, vector)

    e_hub, h_tip, spin = to_hub(e), to_tip(h), to_tip(hub.omega)
    a, b, c, d = dot(e_hub, hub.omega), dot(h, hub.omega), dot(e, tip.omega), dot(h_tip, tip.omega)
    # e . U_hub h and so on are a b - 2 a d + c d - e . h (omega_hub - omega_tip)^2, beside the angular accelerations.
    relative = scale(fixed, subtract(spin, tip.omega))
    by_hub = subtract(add(scale(a, h), scale(b - 2 * d, e_hub)), to_hub(relative))
    by_tip = add(add(scale(d, e), scale(c - 2 * a, h_tip)), relative)
    by_turn = subtract(scale(c - 2 * a, cross(h_tip, tip.omega)), scale(b - 2 * d, cross(e, spin)))
    by_turn = add(by_turn, cross(h_tip, cross(tip.alpha, e)))
    by_turn = subtract(by_turn, cross(e, to_tip(cross(hub.alpha, h))))
    by_turn = add(by_turn, scale(fixed, cross(spin, tip.omega)))
    across_hub, across_tip, values = cross(h, e_hub), cross(e, h_tip), []
    for turn, change in zip(relative_turns(variation, cut), changes, strict=True):
        of_hub, of_tip = change[cut.hub], change[cut.tip]
        value = dot(by_turn, turn) + dot(by_hub, of_hub.omega) + dot(by_tip, of_tip.omega)
        values.append(value + dot(across_hub, of_hub.alpha) + dot(across_tip, of_tip.alpha))
    return [-value for value in values] if cut.tip_is_parent else values


def relative_turns(variation: Variation, cut: Cut) -> list[Vector]:
    """Virtual rotation of a cut joint's hub against its tip, tip axes, per direction."""
    system, before = variation.system, _before(variation, cut)
    turns = variation.turn(cut.hub)
    if before:
        turns = [add(m, n) for m, n in zip(variation.outer(cut.hub), variation.own_turn(cut.hub), strict=True)]
    carrier = system.linkage.carry_before if before else system.linkage.carry
    seen = (carrier(cut.hub, cut.tip, turn) for turn in turns)
    return [subtract(x, n) for x, n in zip(seen, variation.turn(cut.tip), strict=True)]


def _before(variation: Variation, cut: Cut) -> bool:
    """Whether the hub's quantities are taken in the axes before its motion."""
    return cut.hub != GROUND and variation.system.tree.links[cut.hub].motion.spherical


def _seen(variation: Variation, cut: Cut, varied: Varied, known: Vector | None = None) -> Varied:
    """A vector of the hub in tip axes; its changes are those of the equal vector `known`, if one is given."""
    system = variation.system
    before = _before(variation, cut)
    carrier = system.linkage.carry_before if before else system.linkage.carry

    def see(vector: Vector) -> Vector:
        return carrier(cut.hub, cut.tip, vector)

    value = see(varied[0])
    turned = value if known is None else known
    result = [value]
    outer = variation.outer(cut.hub) if before else variation.turn(cut.hub)
    for by, m, n in zip(varied[1:], outer, variation.turn(cut.tip), strict=True):
        result.append(subtract(see(add(by, cross(m, varied[0]))), cross(n, turned)))
    return result


def _contact(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> Varied:
    """Acceleration of the hub's point."""
    if not _before(variation, cut):
        return [rates[cut.hub].at(cut.contact) for rates in (moving, *changes)]
    here, parent = variation.system.placed[cut.hub], variation.system.tree.links[cut.hub].parent
    back = transpose(here.rotation)
    origin = [transform(back, rates[parent].at(here.offset)) for rates in (moving, *changes)]
    omega, alpha = _spin(variation, cut, moving, changes)
    matrix, arm = acceleration_matrix(omega[0], alpha[0]), here.before(cut.contact)
    result = [add(origin[0], transform(matrix, arm))]
    for k, n in enumerate(variation.own_turn(cut.hub), start=1):
        change = matrix_change(omega[0], omega[k], alpha[k])
        first, second, third = (add(x, cross(row, n)) for x, row in zip(change, matrix, strict=True))  # U (n x arm)
        result.append(add(origin[k], transform((first, second, third), arm)))
    return result


def _spins(variation: Variation, cut: Cut) -> bool:
    """Whether only rates vary, of a hub that spins about a point of the ground."""
    zero = variation.system.tape.zero
    steady = all(x is zero for d in variation.directions for x in (*d.step, *d.gain))
    return steady and _before(variation, cut) and variation.system.tree.links[cut.hub].parent == GROUND


def _spun(variation: Variation, cut: Cut) -> list[Vector]:
    """Changes of the acceleration of a point r of such a hub, tip axes.

    With the hub's angular velocity w it is w (w . r) - r (w . w), whose terms ask for no matrix, and for few
    components where few are needed. r is the way through the limb: in the tip's axes most of it is constant.
    """
    system, hub, here = variation.system, variation.system.tree.links[cut.hub], variation.system.placed[cut.hub]
    centre = system.linkage.carry_point(GROUND, cut.tip, here.offset)
    seen_arm = subtract(cut.tip_point, centre)

    def seen(vector: Vector) -> Vector:
        return system.linkage.carry_before(cut.hub, cut.tip, vector)

    omega, arm, result = three(variation.w, hub), here.before(cut.contact), []
    for change in (three(direction.rate, hub) for direction in variation.directions):
        along = add(scale(dot(change, arm), seen(omega)), scale(dot(omega, arm), seen(change)))
        result.append(subtract(along, scale(2 * dot(omega, change), seen_arm)))
    return result


def _spin(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> tuple[Varied, Varied]:
    """Angular velocity and acceleration of the hub."""
    every = (moving, *changes)
    if not _before(variation, cut):
        return [rates[cut.hub].omega for rates in every], [rates[cut.hub].alpha for rates in every]
    link, here = variation.system.tree.links[cut.hub], variation.system.placed[cut.hub]
    back = transpose(here.rotation)
    carried: Varied = [transform(back, rates[link.parent].omega) for rates in every]
    own: Varied = [three(variation.w, link), *(three(d.rate, link) for d in variation.directions)]
    gain: Varied = [three(variation.w_dot, link), *(three(d.gain, link) for d in variation.directions)]
    alpha: Varied = [transform(back, rates[link.parent].alpha) for rates in every]
    return plus(carried, own), plus(plus(alpha, times(carried, own)), gain)

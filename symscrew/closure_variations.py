"""How the closure of accelerations, J a + (dJ/dt) v = 0, changes along directions of the state.

The hub's quantities are carried to the tip of each cut joint, as in `symscrew.closure`. Those of a spherical hub
are taken in the axes before its motion, where its rates w stand and where several limbs share them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from symscrew.closure import Cut, carry, carry_before, closure_bias, universal_axes
from symscrew.differentiation import differentiate
from symscrew.joints import JOINT_TYPES
from symscrew.recursion import Rates, acceleration_matrix
from symscrew.screws import ZERO, Vector, add, cross, dot, subtract, transform, transpose
from symscrew.tape import Node
from symscrew.tree import GROUND
from symscrew.variations import (
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

Changes = Sequence[Sequence[Rates]]


def closure_rows(variation: Variation) -> tuple[list[Node], list[list[Node]]]:
    """J a + (dJ/dt) v per row at the system's nodes, and its changes: [direction][row].

    The changes hold where the motion is consistent or no direction displaces anything.
    """
    system = variation.system
    moving = system.rates(system.inputs.a)
    changes = variation.rate_changes(moving)
    values: list[Node] = []
    by: list[list[Node]] = [[] for _ in variation.directions]
    for cut in system.cuts:
        rows = (_sliding if slides(cut) else _meeting)(variation, cut, moving, changes)
        values += rows[0]
        for column, more in zip(by, rows[1:], strict=True):
            column += more
    return values, by


def _sliding(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> list[list[Node]]:
    """Rows of a cut whose points slide on each other: by the tape, down to the rates of tip and hub."""
    system, seeds = variation.system, with_changes(variation.seeds)
    for name, change in zip(variation.names, changes, strict=True):
        for link in (cut.tip, cut.hub):
            seed_rates(seeds, name, moving[link], change[link])
    rows = closure_bias(cut, system.tree, system.placed, system.twist, moving)
    found = differentiate(system.tape, rows, seeds, variation.names, order="forward")
    return [list(rows), *([row[k] for row in found] for k in range(len(changes)))]


def _meeting(variation: Variation, cut: Cut, moving: Sequence[Rates], changes: Changes) -> list[list[Node]]:
    """Rows of a cut whose two points coincide."""
    tip = [moving[cut.tip], *(change[cut.tip] for change in changes)]
    at_tip: Varied = [rates.at(cut.tip_point) for rates in tip]
    # Along a consistent motion the hub's point has the acceleration of the tip's: one of them need not be carried.
    linear = minus(_seen(variation, cut, _contact(variation, cut, moving, changes), at_tip[0]), at_tip)
    rows: list[list[Node]] = [[] for _ in tip]
    if any(row.unit != "N" for row in cut.rows):
        spin = [_seen(variation, cut, x) for x in _spin(variation, cut, moving, changes)]
        omega = minus(spin[0], [rates.omega for rates in tip])
        alpha = minus(spin[1], [rates.alpha for rates in tip])
        alpha = minus(alpha, times([rates.omega for rates in tip], omega))
    for row in cut.rows:
        if row.unit == "N":
            values = [dot(row.force, x) for x in linear]
        elif universal(cut):
            values = _axes_rows(variation, cut, omega, alpha)
        else:
            values = [dot(row.couple, x) for x in alpha]
        for column, value in zip(rows, values, strict=True):
            column.append(-variation.system.tape.node(value))
    return rows


def _axes_rows(variation: Variation, cut: Cut, omega: Varied, alpha: Varied) -> list[Node]:
    """The couple of a universal joint: the second rate of the product of its axes, seen from the tip.

    `omega`, `alpha`: of the hub against the tip, with which e . h, e the tip's axis, has the second rate e . U h.
    """
    first, second = universal_variation(variation, cut)
    (e, *_), h = (first, second) if cut.tip_is_parent else (second, first)
    sign = -1 if cut.tip_is_parent else 1
    matrix = acceleration_matrix(omega[0], alpha[0])
    values = [sign * dot(e, transform(matrix, h[0]))]
    for k in range(1, len(h)):
        change = transform(matrix_change(omega[0], omega[k], alpha[k]), h[0])
        values.append(sign * dot(e, add(change, transform(matrix, h[k]))))
    return values


def slides(cut: Cut) -> bool:
    """Whether the cut joint's points in tip and hub move against each other."""
    return any(m.kind in "PH" for m in JOINT_TYPES[cut.joint.type].motions)


def universal(cut: Cut) -> bool:
    """Whether a cut joint's couple stands on two axes, of which one turns with the hub."""
    return sum(m.kind == "R" for m in JOINT_TYPES[cut.joint.type].motions) == 2


def universal_variation(variation: Variation, cut: Cut) -> tuple[Varied, Varied]:
    """Present axes of a cut universal joint, tip axes: one is the tip's own, the other turns with the hub."""
    system = variation.system
    first, second = universal_axes(cut, system.tree, system.placed)
    carried = second if cut.tip_is_parent else first
    varied: Varied = [carried]
    for of_hub, of_tip in zip(variation.turn(cut.hub), variation.turn(cut.tip), strict=True):
        relative = subtract(carry(system.tree, system.placed, cut.hub, cut.tip, of_hub), of_tip)
        varied.append(cross(relative, carried))
    still: list[Vector] = [ZERO] * len(variation.directions)
    return ([first, *still], varied) if cut.tip_is_parent else (varied, [second, *still])


def _before(variation: Variation, cut: Cut) -> bool:
    """Whether the hub's quantities are taken in the axes before its motion."""
    return cut.hub != GROUND and variation.system.tree.links[cut.hub].motion.kind == "S"


def _seen(variation: Variation, cut: Cut, varied: Varied, known: Vector | None = None) -> Varied:
    """A vector of the hub in tip axes; its changes are those of the equal vector `known`, if one is given."""
    system = variation.system
    before = _before(variation, cut)
    carrier: Callable[..., Vector] = carry_before if before else carry

    def see(vector: Vector) -> Vector:
        return carrier(system.tree, system.placed, cut.hub, cut.tip, vector)

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

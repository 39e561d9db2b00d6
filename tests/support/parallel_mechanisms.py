"""Parallel and planar mechanisms whose operation modes are published, in exact numbers, a source each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy
from sympy import Rational, sqrt

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism

HALF = Rational(1, 2)
THIRDS = ((1, 0), (-HALF, sqrt(3) / 2), (-HALF, -sqrt(3) / 2))
QUARTERS = ((1, 0), (0, 1), (-1, 0), (0, -1))


def turned(vector: Sequence[Any], place: tuple[Any, Any]) -> list[Any]:
    """The vector turned about z to a place on the unit circle."""
    (x, y, z), (c, s) = vector, place
    return [sympy.nsimplify(c * x - s * y), sympy.nsimplify(s * x + c * y), z]


def three_upu(first: Sequence[Any], second: Sequence[Any]) -> Mechanism:
    """Three equal limbs between triangles of radius 5 and 2, four apart; axes of the first limb's universal joints."""
    builder = MechanismBuilder("three_upu", platform="plate").body("plate")
    for k, place in enumerate(THIRDS):
        outer, inner = turned(first, place), turned(second, place)
        foot, top = turned([5, 0, 0], place), turned([2, 0, 4], place)
        builder.body(f"low{k}").body(f"high{k}")
        builder.joint(f"A{k}", "U", parent="base", child=f"low{k}", point=foot, axes=[outer, inner])
        axis = turned([-Rational(3, 5), 0, Rational(4, 5)], place)
        builder.joint(f"P{k}", "P", parent=f"low{k}", child=f"high{k}", point=foot, axes=[axis], driven=True)
        builder.joint(f"C{k}", "U", parent=f"high{k}", child="plate", point=top, axes=[inner, outer])
        builder.limb(f"limb{k}", joints=[f"A{k}", f"P{k}", f"C{k}"])
    return builder.build()


def snu() -> Mechanism:
    """The 3-UPU of Seoul National University: outer axes meet in the centres of base and platform."""
    return three_upu([1, 0, 0], [0, 1, 0])


def four_ruu(limbs: int = 4, stand: Sequence[Sequence[Any]] = ((1, 0, 0), (0, 1, 0), (0, 0, 1))) -> Mechanism:
    """Limbs with vertical outer axes (Nurahmi, Caro, Wenger, Schadlbauer, Husty 2016); fewer than four, turned."""
    builder = MechanismBuilder("four_ruu", platform="plate").body("plate")

    def there(vector: Sequence[Any], place: tuple[Any, Any] = (1, 0)) -> list[Any]:
        return [sum(a * b for a, b in zip(row, turned(vector, place), strict=True)) for row in stand]

    vertical = there([0, 0, 1])
    for k, place in enumerate(QUARTERS[:limbs]):
        foot, knee, top = (there(p, place) for p in ([6, 0, 0], [6, 5, 0], [3, 1, 4]))
        inner = there([Rational(4, 5), -Rational(3, 5), 0], place)
        builder.body(f"low{k}").body(f"high{k}")
        builder.joint(f"A{k}", "R", parent="base", child=f"low{k}", point=foot, axes=[vertical], driven=True)
        builder.joint(f"B{k}", "U", parent=f"low{k}", child=f"high{k}", point=knee, axes=[vertical, inner])
        builder.joint(f"C{k}", "U", parent=f"high{k}", child="plate", point=top, axes=[inner, vertical])
        builder.limb(f"limb{k}", joints=[f"A{k}", f"B{k}", f"C{k}"])
    return builder.build()


def four_puu() -> Mechanism:
    """Four slides around the base, rods on universal joints whose outer axes are vertical."""
    builder = MechanismBuilder("four_puu", platform="plate").body("plate")
    for k, place in enumerate(QUARTERS):
        foot, top = turned([6, 1, 0], place), turned([3, 1, 4], place)
        along = turned([0, 1, 0], place)
        builder.body(f"low{k}").body(f"high{k}")
        builder.joint(f"A{k}", "P", parent="base", child=f"low{k}", point=foot, axes=[along], driven=True)
        builder.joint(f"B{k}", "U", parent=f"low{k}", child=f"high{k}", point=foot, axes=[[0, 0, 1], along])
        builder.joint(f"C{k}", "U", parent=f"high{k}", child="plate", point=top, axes=[along, [0, 0, 1]])
        builder.limb(f"limb{k}", joints=[f"A{k}", f"B{k}", f"C{k}"])
    return builder.build()


def double_parallelogram() -> Mechanism:
    """Two parallelograms side by side on one coupler: three equal parallel cranks (Hunt 1978, ch. 12)."""
    builder = MechanismBuilder("double_parallelogram", platform="coupler").body("coupler")
    for k, x in enumerate((0, 3, 5)):
        builder.body(f"crank{k}")
        builder.joint(f"A{k}", "R", parent="base", child=f"crank{k}", point=[x, 0, 0], axes=[[0, 0, 1]])
        builder.joint(f"B{k}", "R", parent=f"crank{k}", child="coupler", point=[x + HALF * 3, 2, 0], axes=[[0, 0, 1]])
    return builder.build()


def cells(count: int) -> Mechanism:
    """Parallelograms in a row, each on the coupler of the one before."""
    builder = MechanismBuilder("cells")
    for k in range(count):
        below = f"coupler{k - 1}" if k else "base"
        builder.body(f"coupler{k}")
        for i, x in enumerate((0, 3)):
            builder.body(f"crank{k}_{i}")
            foot, top = [x + k, 2 * k + i, 0], [x + k + 1, 2 * k + 2 + i, 0]
            builder.joint(f"A{k}_{i}", "R", parent=below, child=f"crank{k}_{i}", point=foot, axes=[[0, 0, 1]])
            builder.joint(f"B{k}_{i}", "R", parent=f"crank{k}_{i}", child=f"coupler{k}", point=top, axes=[[0, 0, 1]])
    return builder.build()


LIMBS: dict[str, tuple[tuple[tuple[str, Sequence[Any], Sequence[Sequence[Any]]], ...], ...]] = {
    # Kong and Gosselin 2002: cylinders along the axes of a frame, two hinges parallel to each
    "3-CRR": tuple(
        tuple((kind, [p[(i - k) % 3] for i in range(3)], [[int(i == k) for i in range(3)]])
              for kind, p in (("C", (0, 5, 1)), ("R", (0, 4, 3)), ("R", (1, 1, 2))))
        for k in range(3)
    ),
    # Zhao and Huang 2000: hinges tangential, the last with a slide
    "3-RRC": tuple(
        tuple((kind, turned(p, place), [turned([0, 1, 0], place)])
              for kind, p in (("R", [5, 0, 0]), ("R", [6, 0, 3]), ("C", [2, 0, 4])))
        for place in THIRDS
    ),
    # Richard, Gosselin and Kong 2007: slides, hinges and first axes of universal joints horizontal, the last vertical
    "quadrupteron": tuple(
        tuple((kind, turned(p, place), [turned(a, place) for a in axes])
              for kind, p, axes in (("P", [6, 0, 0], [[0, 1, 0]]), ("R", [6, 1, 0], [[0, 1, 0]]),
                                    ("R", [5, 1, 3], [[0, 1, 0]]), ("U", [2, 1, 4], [[0, 1, 0], [0, 0, 1]])))
        for place in QUARTERS
    ),
}  # fmt: skip
"""Mechanism -> its limbs, each joints (type, point, axes) from base to platform."""


def of_limbs(name: str) -> Mechanism:
    """The mechanism of `LIMBS`."""
    builder = MechanismBuilder("made_of_limbs", platform="plate").body("plate")
    for k, joints in enumerate(LIMBS[name]):
        bodies = ["base", *(f"b{k}_{i}" for i in range(len(joints) - 1)), "plate"]
        for body in bodies[1:-1]:
            builder.body(body)
        for i, (kind, point, axes) in enumerate(joints):
            builder.joint(f"J{k}_{i}", kind, parent=bodies[i], child=bodies[i + 1], point=list(point),
                          axes=[list(a) for a in axes])  # fmt: skip
        builder.limb(f"limb{k}", joints=[f"J{k}_{i}" for i in range(len(joints))])
    return builder.build()

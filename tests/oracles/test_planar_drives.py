"""Drives of planar 3-limb mechanisms: three lines of force that meet in a point or are parallel lose their hold."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from typing import Any

import pytest
import sympy
from support.marks import slow
from sympy import Rational

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import analyse_mobility, mobility_markdown, mobility_text
from symscrew.mobility.symbols import actuation_loci

Place = tuple[Any, Any]
LIMBS = {"RRR": 0, "RPR": 1, "PRR": 0, "RPr": 0}
"""Joints from the base -> which is driven; of RPr the hinge at the base is."""
TIPS: tuple[Place, ...] = ((0, 0), (4, 0), (1, 3))


def limb_on(kind: str, tip: Place, along: Place) -> list[tuple[str, Place]]:
    """(joint, its point or direction), so that the limb's line of force runs through the tip along the direction."""
    (x, y), (a, b) = tip, along
    inner = (x + 2 * a, y + 2 * b)
    middle: Place = {"RPR": (a, b), "RPr": (-b, a)}.get(kind, inner)
    first: Place = {"RPR": inner, "PRR": (a - 3 * b, 3 * a + b)}.get(kind, (inner[0] + 3, inner[1] - 5))
    return list(zip(kind.upper(), (first, middle, tip), strict=True))


def planar(kinds: Sequence[str], along: Sequence[Place], set_up: Callable[[MechanismBuilder], Any] = id) -> Mechanism:
    builder = MechanismBuilder("planar", platform="plate").body("plate")
    set_up(builder)
    for k, (kind, tip, direction) in enumerate(zip(kinds, TIPS, along, strict=True)):
        builder.body(f"low{k}").body(f"high{k}")
        chain = ["base", f"low{k}", f"high{k}", "plate"]
        for i, (letter, (x, y)) in enumerate(limb_on(kind, tip, direction)):
            point, axis = ([x, y, 0], [0, 0, 1]) if letter == "R" else ([0, 0, 0], [x, y, 0])
            length = sympy.sqrt(sum(sympy.sympify(c) ** 2 for c in axis))
            builder.joint(f"{letter}{k}{i}", letter, parent=chain[i], child=chain[i + 1], point=point,
                          axes=[[c / length for c in axis]], driven=i == LIMBS[kind])  # fmt: skip
        builder.limb(f"limb{k}", joints=[f"{letter}{k}{i}" for i, letter in enumerate(kind.upper())])
    return builder.build()


def towards(point: Place) -> list[Place]:
    return [(Rational(point[0] - x), Rational(point[1] - y)) for x, y in TIPS]


@pytest.mark.parametrize("seed", [0, slow(1), slow(2)])
def test_hold_is_lost_where_the_lines_meet_or_are_parallel(seed: int) -> None:
    rng = random.Random(seed)
    kinds = [rng.choice(list(LIMBS)) for _ in TIPS]
    meet = towards((rng.randint(5, 9), rng.randint(5, 9)))
    parallel = [(Rational(3), Rational(rng.randint(4, 9)))] * 3
    apart = [*meet[:2], (meet[2][0] + 1, meet[2][1] - 1)]
    for along, left in ((meet, 1), (parallel, 1), (apart, 0)):
        found = analyse_mobility(planar(kinds, along))
        assert found.dof_drives_locked == left
        assert "where three lines meet in a point or are parallel: of limb0 through" in mobility_markdown(found)


def test_the_locus_of_a_planar_3_rrr_is_one_determinant() -> None:
    s = sympy.Symbol("s", real=True)

    def shifted(builder: MechanismBuilder) -> None:
        builder.parameter("s", Rational(1, 3))

    first, second, (a, b) = towards((7, 6))
    mechanism = planar(["RRR"] * 3, [first, second, (a + s, b)], shifted)
    loci = actuation_loci(mechanism)
    assert loci.not_tried == ()
    (locus,) = loci.found
    (symbol,) = locus.expression.free_symbols
    assert sympy.solve(locus.expression, symbol) == [0]  # the third line meets the others in (7, 6)


def test_counts_are_mathematics_in_documents_and_typed_in_text() -> None:
    found = analyse_mobility(planar(["RRR"] * 3, towards((7, 6))))
    assert r"$M = \sum f - r = 3$" in mobility_markdown(found) and "$S_{G_i}$" in mobility_markdown(found)
    text = mobility_text(found)
    assert "M = sum f - r = 3," in text and "$" not in text
    assert "\nLimbs limb0, limb1, limb2\n" in text and "limb2: the screws of the limb become dependent where" in text

"""Linkages that move because their links are alike, typed with few digits: several kinds of them cross there."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy
from support.further_mechanisms import CASES, loop
from support.reposed import posed

from symscrew.algebra import CONTEXT
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import Mobility, analyse_mobility
from symscrew.mobility.finite import CLOSED, DIGITS_60, ClosureVariety, alike_links, local_at, near_geometry, refine
from symscrew.mobility.finite.joint_changes import changed, count_of, slots_of
from symscrew.mobility.finite.local_solutions import flatten
from symscrew.mobility.joint_network import network_of

Z = [0, 0, 1]


def typed(linkage: Mechanism, *, seed: int, digits: str) -> Mobility:
    joints = [{"point": list(j.point), "axes": [list(axis) for axis in j.axes]} for j in linkage.joints.values()]
    made = posed(joints, seed=seed, digits=digits, unit="m")
    return analyse_mobility(replace(linkage, joints={
        name: replace(joint, point=tuple(new["point"]), axes=tuple(map(tuple, new["axes"])))
        for (name, joint), new in zip(linkage.joints.items(), made, strict=True)
    }))  # fmt: skip


def about(radius: str, part: sympy.Rational) -> list[sympy.Expr]:
    """A point of the plane after this part of a turn, in 50 digits: no field is asked for here."""
    angle = 2 * CONTEXT.pi * CONTEXT.mpf(part.p) / part.q
    size = CONTEXT.mpf(sympy.Rational(radius).p) / sympy.Rational(radius).q
    return [*(sympy.Rational(CONTEXT.nstr(size * f(angle), 50)) for f in (CONTEXT.cos, CONTEXT.sin)), sympy.Integer(0)]


def hoberman(count: int) -> Mechanism:
    """Hoberman 1990: a ring of `count` pairs of angulated bars; both ends of a bar are as far from its pin."""
    builder = MechanismBuilder("ring")
    name = lambda bar: "base" if bar == "a0" else bar  # noqa: E731
    for bar in (f"{kind}{k}" for k in range(count) for kind in "ab"):
        if bar != "a0":
            builder.body(bar)
    inner, outer = "6/5", "2"
    pin = sympy.Rational(str(1.6 / math.cos(math.pi / count)))
    for k in range(count):
        ahead, part = (k + 1) % count, sympy.Rational(k, count)
        places = {
            f"M{k}": (f"a{k}", f"b{k}", about(str(pin), part + sympy.Rational(1, 2 * count))),
            f"Q{k}": (f"a{k}", f"b{ahead}", about(inner, sympy.Rational(ahead, count))),
            f"P{k}": (f"b{k}", f"a{ahead}", about(outer, sympy.Rational(ahead, count))),
        }
        for joint, (parent, child, place) in places.items():
            builder.joint(joint, "R", parent=name(parent), child=name(child), point=place, axes=[Z])
    return builder.build()


@pytest.mark.slow
def test_a_ring_of_angulated_bars_opens_as_meant() -> None:
    """Its rhombi are parallelograms and kites at once, so that conditions of motion have no slope there."""
    found = typed(hoberman(6), seed=0, digits="6")
    assert found.finite.dof == 0 and found.near is not None and not found.not_tried
    assert (found.near.meant.dof, found.near.meant.finite.dof, found.near.meant.overconstraints) == (1, 1, 25)
    assert found.near.distance < 1e-5


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hexapod, line-symmetric", "five legs, no circle"])
def test_platforms_on_legs_that_are_alike(name: str) -> None:
    """Base and platform of one shape, and equal legs: the ranks alone are those of platforms that move less."""
    found = typed(CASES[name].make(), seed=0, digits="9")
    dof, finite, branches, overconstraints = CASES[name].expected
    assert found.near is not None and found.near.distance < 1e-8 and found.finite.dof == 6
    meant = found.near.meant
    assert (meant.dof, meant.finite.dof, meant.finite.branches) == (dof, finite, branches)
    assert meant.overconstraints == overconstraints


def bars(*lengths: str) -> Mechanism:
    """A loop of ball joints with these lengths in turn, along x and y."""
    x, y, places = sympy.Integer(0), sympy.Integer(0), []
    for k, length in enumerate(lengths):
        places.append(("S", [x, y, sympy.Integer(0)], None))
        x, y = (x + sympy.Rational(length), y) if k % 2 else (x, y + sympy.Rational(length))
    return loop(*places)


@pytest.mark.parametrize("last, equal", [("1.00000035", 5), ("1.00001", 4)])
def test_what_is_equal_by_rounding_and_what_by_chance(last: str, equal: int) -> None:
    """All are within the tolerance; one that is off by fifty times what the others are is another length."""
    lengths = ["1", "1.0000002", "0.9999998", "1.0000001", "1.0000003", last]
    network = network_of(bars(*lengths, "3", "7"))
    found = alike_links.alike(network, 1e-4)
    assert found is not None
    (pairs,) = (pairs for kind, pairs in zip(found.kinds, found.differences, strict=True) if len(kind.places[0]) == 2)
    assert len(pairs) == equal and found.off < 1e-6


def test_relations_change_as_their_rates_say() -> None:
    network = network_of(CASES["bricard line-symmetric"].make())
    found = alike_links.alike(network, 1e-9)
    assert found is not None and abs(found.residual(network)).max() < 1e-40
    slots = slots_of(network)
    rates = found.rates(network, slots)
    for k in range(count_of(slots)):
        z = np.array([CONTEXT.zero] * count_of(slots), dtype=object)
        z[k] = CONTEXT.mpf(10) ** -12
        after = found.residual(changed(network, slots, z)) * 1e12
        assert after == pytest.approx(rates[:, k], abs=1e-10)


def test_zeros_that_close_as_typed_are_no_special_geometry() -> None:
    """Singular values of a branch are small near the configuration that it leaves: with them all, its loops close."""
    network = network_of(CASES["kite, collinear"].make())
    coarse, fine = ClosureVariety(network), ClosureVariety(network, DIGITS_60)
    here = local_at(coarse, np.zeros(coarse.columns))
    for direction in flatten(here.dof):
        q = 5e-5 * here.kernel @ direction
        for _ in range(20):  # to where loops close in doubles
            q = q - local_at(coarse, q, rank=here.rank + 1).inverse @ coarse.residual(q)
        assert refine(coarse, fine, q, here.rank)[1] > CLOSED, "with the rank of where branches meet they do not"
        assert near_geometry._open(network, coarse, [(q, here.rank)]) == []
        aside = q + 1e-6 * here.kernel @ np.array([1.0, 0.3])
        assert near_geometry._open(network, coarse, [(aside, here.rank)]) != []

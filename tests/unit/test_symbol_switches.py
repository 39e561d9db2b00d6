"""Sizes beyond which exact numbers and formulas are given up: both sides of each, and what the result says."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy
from support.limb_platforms import platform
from support.reference_mechanisms import ENTRIES, build
from sympy import cos, pi, sin, sqrt

from symscrew import catalogue
from symscrew.algebra import CONTEXT
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import analyse_mobility, mobility_markdown, mobility_text
from symscrew.mobility.symbols import drive_loci, exact_field, exact_ranks, generators, limb_poses, loop_motions
from symscrew.mobility.symbols.drive_loci import actuation_loci
from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import NotDecidableError
from symscrew.mobility.symbols.exact_ranks import EliminationTooLongError, exact_rank, rank_modulo
from symscrew.mobility.symbols.limb_poses import LimbPose, limb_pose
from symscrew.mobility.symbols.loop_motions import SymbolicLoops, symbolic_loops
from symscrew.mobility.symbols.polynomial_screws import SymbolicScrews

pytestmark = pytest.mark.slow

SEED = "three_ups_upu_s"


# -- exact numbers ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, least, expression, text",
    [("MOST_ROOTS", 2, sqrt(2) + sqrt(3) + sqrt(5), "more than 2 independent square roots"),
     ("HIGHEST_DEGREE", 2, cos(pi / 7) + sin(pi / 7), "has degree 6"),
     ("LONGEST_SQUARE", 1, sqrt(3 + cos(pi / 7)), "numbers that are too long")],
)  # fmt: skip
def test_fields_up_to_a_size(
    monkeypatch: pytest.MonkeyPatch, name: str, least: int, expression: sympy.Expr, text: str
) -> None:
    assert Field([expression]).read(expression)
    monkeypatch.setattr(exact_field, name, least)
    with pytest.raises(NotDecidableError, match=text):
        Field([expression]).read(expression)


@pytest.mark.parametrize("name, value", [("CERTAIN_NORM", 0), ("LARGEST_SQUARED", 2), ("WHOLE", CONTEXT.mpf("1e-40"))])
def test_shortcuts_of_roots_do_not_change_them(monkeypatch: pytest.MonkeyPatch, name: str, value: object) -> None:
    """With and without the test by the norm, with and without squares taken out, the same numbers are zero."""
    zeros = (sqrt(18) - 3 * sqrt(2), sqrt(1 + cos(pi / 9)) - sqrt(2) * cos(pi / 18), sqrt(2) * sqrt(3) - sqrt(6))
    for _ in range(2):
        for zero in zeros:
            assert not Field([zero]).read(zero) and Field([zero]).read(zero + 1)
        monkeypatch.setattr(exact_field, name, value)


def test_a_root_whose_coefficients_are_not_whole_is_not_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """cos(pi/7)^2 has the root cos(pi/7) in the field; where no coefficient passes for whole, a root is adjoined."""
    e = sqrt(cos(pi / 7) ** 2)
    field = Field([cos(pi / 7)])
    degree = field.degree
    field.sqrt(field.read(cos(pi / 7) ** 2))
    assert field.degree == degree
    monkeypatch.setattr(exact_field, "WHOLE", -1)
    field = Field([e])
    field.sqrt(field.read(cos(pi / 7) ** 2))
    assert field.degree == 2 * degree


SINGULAR = [[Fraction(1), Fraction(2)], [Fraction(2), Fraction(4)]]


@pytest.mark.parametrize("name, text", [("MOST_WORK", "is too long"), ("LONGEST", "grow too long")])
def test_elimination_up_to_a_size(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    """A rank that residues decide needs no elimination; one that falls short does."""
    regular = [[Fraction(1), Fraction(2)], [Fraction(2), Fraction(5)]]
    assert (exact_rank(SINGULAR, Field()), exact_rank(regular, Field())) == (1, 2)
    monkeypatch.setattr(exact_ranks, name, 0)
    assert exact_rank(regular, Field()) == 2
    with pytest.raises(EliminationTooLongError, match=text):
        exact_rank(SINGULAR, Field())


@pytest.mark.parametrize("start", [7, 2**61])
def test_residues_bound_ranks_from_below_whatever_the_primes(monkeypatch: pytest.MonkeyPatch, start: int) -> None:
    monkeypatch.setattr(exact_ranks, "FIRST_PRIME", start)
    assert rank_modulo(SINGULAR, Field()) == 1
    divisible = [[Fraction(11), Fraction(0)], [Fraction(0), Fraction(1)]]
    assert rank_modulo(divisible, Field()) <= exact_rank(divisible, Field()) == 2


@pytest.mark.parametrize("name, text", [("MOST_WORK", "is too long"), ("LONGEST", "grow too long")])
def test_a_rank_that_is_not_exact_says_why(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert analyse_mobility(catalogue.load("bennett")).method.startswith("exact: ")
    monkeypatch.setattr(exact_ranks, name, 0)
    found = analyse_mobility(catalogue.load("bennett"))
    assert found.dof == 1 and found.method.startswith("certified numeric: ")
    assert text in found.method and "rank of the closure" in found.method


# -- formulas ---------------------------------------------------------------------------------------------


def test_symbols_up_to_a_number_of_products(monkeypatch: pytest.MonkeyPatch) -> None:
    assert analyse_mobility(catalogue.load(SEED)).symbolic is not None
    monkeypatch.setattr(generators, "MOST_PRODUCTS", 10)
    found = analyse_mobility(catalogue.load(SEED))
    assert found.symbolic is None and "not of reasonable size" in str(found.without_symbols)
    assert "no symbols: the closed forms are not of reasonable size" in mobility_text(found)


def test_common_factors_on_the_circle_up_to_a_size(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without them a limb would be said to bear a couple where its screws are dependent: there are no symbols then."""
    mechanism = platform("PRS")
    pose = limb_pose(mechanism, "leg1")
    assert isinstance(pose, LimbPose) and [locus.kind for locus in pose.loci] == ["limb"]
    monkeypatch.setattr(generators, "MOST_FORMS", 10)
    assert limb_pose(mechanism, "leg1") == "no symbols: the closed forms are not of reasonable size"


def test_a_form_that_is_flat_vanishes_where_others_do_not(monkeypatch: pytest.MonkeyPatch) -> None:
    """x^2 + y^2 vanishes in no plane of real parameters, x^2 - y^2 in two."""
    mechanism = MechanismBuilder("two").parameter("x", 1, "1").parameter("y", 2, "1").body("b")
    mechanism.joint("J", "P", parent="base", child="b", point=[0, 0, 0], axes=[[1, 0, 0]])
    x, y = sympy.symbols("x y", real=True)
    ring = generators.Generators(mechanism.build(), [x, y])
    a, b = ring.read(x).numerator, ring.read(y).numerator
    round_form, saddle = a**2 + a * b + b**2, a**2 - 3 * a * b + b**2
    assert generators._definite(round_form) and not generators._definite(saddle)
    assert ring.factors(round_form) == [] and len(ring.factors(saddle)) == 1
    monkeypatch.setattr(generators, "FLAT", 2.0)
    assert not generators._definite(round_form)


@pytest.mark.parametrize(
    "name, value, text",
    [("MOST_TERMS", 0, "an intermediate polynomial has more than 0 terms"),
     ("MOST_WORK", 3, "more than 3 products of terms"), ("LARGEST_SHOWN", 0, "a component has")],
)  # fmt: skip
def test_rates_of_loops_up_to_a_size(monkeypatch: pytest.MonkeyPatch, name: str, value: int, text: str) -> None:
    mechanism = catalogue.load("four_bar")
    body = analyse_mobility(mechanism).platform.body
    assert isinstance(symbolic_loops(mechanism, body), SymbolicLoops)
    monkeypatch.setattr(loop_motions, name, value)
    found = symbolic_loops(mechanism, body)
    assert isinstance(found, str) and found.startswith("the closed form is not of reasonable size: ") and text in found


def parallelogram() -> Mechanism:
    """Four revolute joints about y; at h = 0 all of them lie on a line."""
    builder = MechanismBuilder("parallelogram").parameter("h", 1, "m").parameter("d", 2, "m")
    for body in ("crank", "coupler", "rocker"):
        builder.body(body)
    ends = ("base", "crank"), ("crank", "coupler"), ("coupler", "rocker"), ("rocker", "base")
    points = [0, 0, 0], [0, 0, "h"], ["d", 0, "h"], ["d", 0, 0]
    for name, (parent, child), point in zip("ABCD", ends, points, strict=True):
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 1, 0]])
    return builder.build()


def test_a_locus_that_was_not_looked_for_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = analyse_mobility(parallelogram())
    assert isinstance(whole.loops, SymbolicLoops) and whole.loops.loci and whole.not_tried == ()
    assert "What was not tried" not in mobility_markdown(whole)
    monkeypatch.setattr(loop_motions, "MOST_MINORS", 1)
    found = analyse_mobility(parallelogram())
    assert isinstance(found.loops, SymbolicLoops) and found.loops.loci == () and found.loops.rates == whole.loops.rates
    text = "locus where the closure loses rank: not looked for, 3 determinants are more than 1"
    assert found.not_tried == (text,)
    assert f"## What was not tried\n\n- {text}" in mobility_markdown(found)


def test_a_locus_that_is_too_long_to_be_shown_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = parallelogram()
    whole = symbolic_loops(mechanism, "coupler")
    assert isinstance(whole, SymbolicLoops) and whole.loci and not whole.not_tried
    monkeypatch.setattr(loop_motions, "_vector", lambda work, vector: ())
    monkeypatch.setattr(loop_motions, "LARGEST_SHOWN", 0)
    found = symbolic_loops(mechanism, "coupler")
    assert isinstance(found, SymbolicLoops) and found.loci == ()
    assert len(found.not_tried) == len(whole.loci) and "terms is not shown" in found.not_tried[0]


@pytest.mark.parametrize("most, symbols", [(3, 3), (2, 2), (1, 1)])
def test_symbols_of_a_limb_up_to_a_number(monkeypatch: pytest.MonkeyPatch, most: int, symbols: int) -> None:
    monkeypatch.setattr(limb_poses, "MOST_SYMBOLS", most)
    monkeypatch.setattr(limb_poses, "LARGEST_SHOWN", 100)
    found = limb_pose(catalogue.load(SEED), "limb1")
    assert isinstance(found, LimbPose) and len(found.displacements) == symbols
    resting = "limb1_U2 stays" if symbols == 2 else "limb1_P, limb1_U2 stay"
    assert (found.not_tried == ()) if symbols == 3 else found.not_tried[0].startswith(f"limb1: {resting}")
    assert symbols == 3 or f"without a symbol: more than {most} symbols" in found.not_tried[0]


def test_a_long_limb_says_which_joints_have_no_symbol() -> None:
    """The seed as it stands: with the fourth angle a component is too long, so it rests, and the result says so."""
    found = analyse_mobility(catalogue.load(SEED))
    _, text = found.not_tried
    assert text.startswith("limb1: limb1_U2 stays in the reference configuration, without a symbol: a component has ")


def test_nothing_is_left_of_a_limb_whose_components_are_all_too_long(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limb_poses, "LARGEST_SHOWN", 0)
    assert "the closed form is not of reasonable size: a component has" in str(limb_pose(catalogue.load(SEED), "limb1"))


# -- loci of drives ---------------------------------------------------------------------------------------


def test_loci_of_drives_up_to_a_number_of_determinants(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = catalogue.load(SEED)
    more = actuation_loci(mechanism)
    assert more.found and not any("determinants" in text for text in more.not_tried)
    monkeypatch.setattr(drive_loci, "MOST_MINORS", 6)
    less = actuation_loci(mechanism)
    assert [any(locus.where == "all drives" for locus in loci.found) for loci in (more, less)] == [True, False]
    assert any(text.endswith("determinants are more than 6") for text in less.not_tried)


def test_a_long_locus_of_drives_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = build(ENTRIES["stewart_6ups-actuation_sing"]) if "stewart_6ups-actuation_sing" in ENTRIES else (
        catalogue.load(SEED)
    )  # fmt: skip
    whole = actuation_loci(mechanism)
    shown = [locus for locus in whole.found if locus.expression != 0]
    monkeypatch.setattr(drive_loci, "LARGEST_LOCUS", 0)
    found = actuation_loci(mechanism)
    assert all(locus.expression == 0 for locus in found.found)
    assert (len([t for t in found.not_tried if "not shown" in t]) > 0) == bool(shown)


def test_products_of_the_loci_of_drives_may_be_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    def too_many(*given: object) -> object:
        raise generators.NotPolynomialError("the closed forms are not of reasonable size")

    monkeypatch.setattr(drive_loci, "_actuation_loci", too_many)
    found = actuation_loci(catalogue.load(SEED))
    assert found.found == () and found.not_tried == ("actuation loci: the closed forms are not of reasonable size",)


def test_what_limbs_cannot_carry_is_found_once_for_symbols_and_drives(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = list[str]()
    reciprocal = SymbolicScrews.reciprocal

    def counted(self: SymbolicScrews, screws: Sequence[Sequence[Any]]) -> Any:
        asked.append(str(screws))
        return reciprocal(self, screws)

    monkeypatch.setattr(SymbolicScrews, "reciprocal", counted)
    found = analyse_mobility(catalogue.load("planar_3rrr"))
    assert found.symbolic is not None and found.singularities.margins
    assert len(asked) == len(set(asked)) == 3 + 1 + 3  # limbs, their union, limbs with their drives locked


def test_the_place_in_general_position_is_always_the_same() -> None:
    first, second = (analyse_mobility(catalogue.load("sarrus")) for _ in range(2))
    assert first.symbolic == second.symbolic
    assert np.array_equal(first.first_order.motions, second.first_order.motions)

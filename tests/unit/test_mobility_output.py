"""What a researcher pastes: unit screws, short numbers, conditions without constants, whole texts of bounded length."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from xml.etree import ElementTree

import pytest
import sympy
from support.further_mechanisms import loop
from support.latex_text import faults
from support.marks import slow

from symscrew import catalogue
from symscrew.mobility import (
    Mobility,
    analyse_mobility,
    mobility_latex,
    mobility_markdown,
    mobility_page,
    mobility_text,
    mobility_values,
    sections,
)
from symscrew.mobility.findings.short_text import BEHIND, shortened
from symscrew.mobility.findings.typeset import presentable, shown
from symscrew.mobility.screw_text import text
from symscrew.mobility.symbols import Locus, condition, conditions

H, R, r = sympy.symbols("H R r", positive=True)


@cache
def found(name: str, *, at: tuple[tuple[str, str], ...] = ()) -> Mobility:
    return analyse_mobility(catalogue.load(name), at=dict(at))


@pytest.mark.parametrize(
    "expression, short",
    [
        (sympy.sqrt(3), None), (sympy.Integer(-7), None), (sympy.Integer(0), sympy.Integer(0)),
        (sympy.sqrt(3) * H, H), (-4 * H**2 / 5, H), (sympy.sqrt(3) * R - sympy.sqrt(3) * r, R - r),
        (H**2 - R * r + r**2, H**2 - R * r + r**2), (3 * H**2 * (R - r) ** 3, H * (R - r)),
    ],
)  # fmt: skip
def test_a_condition_has_no_factor_that_cannot_vanish(expression: sympy.Expr, short: sympy.Expr | None) -> None:
    made = condition(expression)
    assert made == short if short is None else sympy.expand(made - short) == 0


def test_conditions_that_never_hold_or_were_said_are_left_out() -> None:
    loci = [Locus("limb", "limb1", e, "dependent") for e in (sympy.sqrt(3), 2 * H, sympy.sqrt(5) * H)]
    assert [locus.expression for locus in conditions(loci)] == [H]


def test_equal_limbs_are_named_once() -> None:
    (lines,) = [lines for heading, lines in sections(found("three_ups_upu_s")) if heading == "Where it degenerates"]
    assert "$H = 0$ (limb2, limb3, limb4): the screws of the limb become dependent" in lines
    (always,) = [line for line in lines if line.startswith("always")]
    assert "(limb1_P limb3_P; limb2_P limb4_P)" in always and "one of these sets" in always
    assert len(lines) == len({line.partition(" (")[0] + line.partition("): ")[2] for line in lines})


def test_screws_of_constant_length_are_unit_and_those_of_parameters_have_no_poles() -> None:
    three, zero = sympy.Integer(3), sympy.Integer(0)
    assert shown((three, three, zero, zero, zero, 3 * H)) == (
        sympy.sqrt(2) / 2, sympy.sqrt(2) / 2, 0, 0, 0, sympy.sqrt(2) * H / 2,
    )  # fmt: skip
    assert shown((zero, zero, zero, zero, sympy.Integer(-5), zero)) == (0, 0, 0, 0, -1, 0)
    assert shown((R - r, zero, zero, zero, zero, H)) == (R - r, 0, 0, 0, 0, H)


def test_numbers_that_nobody_reads_are_decimals() -> None:
    long = sympy.Rational(10**40 + 1, 3 * 10**40)
    assert str(presentable(long * H)) == "0.333333*H" and str(presentable(long)) == "0.333333"
    assert presentable(sympy.Rational(1, 3) * H) == H / 3


@cache
def of_many_digits() -> Mobility:
    digits = "0." + "1234567891" * 4
    return analyse_mobility(loop(*(("R", [k, digits, 0], [0, 0, 1]) for k in range(4))))


@pytest.mark.parametrize("form", [mobility_text, mobility_markdown, mobility_page, mobility_latex])
def test_no_output_has_a_number_of_many_digits(form: Callable[[Mobility], str]) -> None:
    """A Bennett loop whose numbers have forty digits: its exact screws are products of them."""
    assert re.findall(r"\d{20,}", form(of_many_digits())) == []


def test_rounding_beside_a_large_component_is_zero() -> None:
    assert text((1, 5.8e-62, -3)) == "1, 0, -3" and text((0, 0, 0)) == "0, 0, 0"
    assert text((1e-20, 0, 2e-20)) == "1e-20, 0, 2e-20"


def test_no_heading_stands_alone() -> None:
    assert all(lines for name in ("three_ups_upu_s", "four_bar") for _, lines in sections(found(name)))
    joints = [("R", [k, k * k, 0], [0, 0, 1]) for k in range(3)]
    assert all(lines for _, lines in sections(analyse_mobility(loop(*joints))))


def test_what_was_not_tried_stands_in_the_text() -> None:
    told = found("three_ups_upu_s")
    assert told.not_tried and all(line in mobility_text(told) for line in told.not_tried)


@pytest.mark.parametrize(
    "name, at",
    [("four_bar", ()), ("four_bar", (("A", "0.1"),)), slow("ur5", (("d1", "0.45"), ("elbow_joint", "-0.1")))],
)
def test_every_output_names_the_configuration(name: str, at: tuple[tuple[str, str], ...]) -> None:
    told = found(name, at=at)
    wanted = [f"{key} = {value}" for key, value in at] or ["in the reference configuration"]
    for form in (Mobility.report, mobility_markdown, mobility_page):
        assert all(part in form(told) for part in wanted)
    assert all(part.replace("_", r"\_") in mobility_latex(told) for part in wanted)
    values = mobility_values(told)["configuration"]
    assert {**values["coordinates"], **values["parameters"]} == dict(at)
    assert all(part in values["in_words"] for part in wanted)


@pytest.mark.parametrize("name", [slow("three_ups_upu_s"), slow("four_bar"), "bennett"])
def test_latex_is_well_formed(name: str) -> None:
    assert faults(mobility_latex(found(name))) == []


@pytest.mark.parametrize(
    "text", ["{", "$x", "a_b", r"\begin{itemize}", r"\unknown", "$\\left( x$", "50 % of it", r"\end{itemize}", "a & b"]
)
def test_the_parser_of_latex_says_no(text: str) -> None:
    assert faults(text) != []


def test_brackets_of_a_page_stretch() -> None:
    page = mobility_page(found("three_ups_upu_s"))
    brackets = re.findall(r"<mo([^>]*)>[()]</mo>", page)
    assert brackets and all("form=" in b and ('fence="true"' in b) == ('stretchy="true"' in b) for b in brackets)
    for formula in re.findall(r"<math>.*?</math>", page, re.S):
        assert 'stretchy="false"' not in formula or not re.search("<mfrac|<mtable|<msqrt|<msup", formula)
        ElementTree.fromstring(formula.replace("&InvisibleTimes;", "").replace("&ApplyFunction;", ""))


def test_the_short_text_has_the_answer_whole_and_says_what_it_leaves_out() -> None:
    told = found("three_ups_upu_s")
    short, whole = mobility_text(told, full=False), mobility_text(told)
    assert len(short.encode()) < 5000 - 300 < len(whole.encode())  # 300: head and last line of the command
    assert BEHIND in short and BEHIND not in whole
    assert all(line in short.splitlines() for line in whole.split("\nLimb")[0].splitlines())


@pytest.mark.parametrize("sizes", [(60, 20, 30), (8, 700, 5), (400, 2, 2), (3, 3, 3)])
def test_a_short_text_says_what_it_leaves_out(sizes: tuple[int, int, int]) -> None:
    lines, letters, headings = sizes
    said = [("Mobility", ["1 freedom"]), *((f"Limb {k}", ["word " * (letters // 5)] * lines) for k in range(headings))]
    cut = shortened(said)
    assert cut[:2] == ["Mobility", "    1 freedom"]
    size = sum(len(line) + 1 for line in cut)
    whole = lines * letters * headings < 4000
    assert size < 5000 and (BEHIND in "\n".join(cut)) != whole

"""Folded constants of generated C: named once, and made of what their line says."""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest
from support import handmade
from support.model_states import model

from symscrew.description import parse
from symscrew.export.c import print_source
from symscrew.export.c_constants import SILENT, Constants, common
from symscrew.export.c_names import TAKEN
from symscrew.export.c_precision import DOUBLE

LINE = re.compile(r"^    (\w+) = ([\d.e+-]+)[,;] /\* (.*?) \*/$", re.M | re.S)


OTHER = re.compile(r"^   (\w+) = ([\d.e+-]+) (.*?)(?=\n   \w| \*/)", re.M | re.S)


@cache
def printed(name: str) -> str:
    return print_source(model(name))


def block(source: str) -> dict[str, tuple[float, str]]:
    text = source[source.index("/* Constants:") :]
    text = text[: text.index("\n\n")]
    found = [*LINE.findall(text), *OTHER.findall(text.partition("which no statement reads:\n")[2])]
    return {name: (float(number), " ".join(told.split())) for name, number, told in found}


@pytest.mark.parametrize("name", ["four_bar", "slider_crank"])
def test_a_constant_is_what_its_formula_says(name: str) -> None:
    """Each formula, of constants that have lines themselves, gives the number to rounding."""
    found = block(printed(name))
    assert len(found) > 5
    checked = 0
    for value, told in found.values():
        formula = told.partition("; also ")[0].rpartition(": ")[2].rpartition("] ")[2]
        if words(formula) <= set(found) and re.search(r"[\d*+-]", formula):
            numbers = {word: found[word][0] for word in words(formula)}
            assert valued(formula, numbers) == pytest.approx(value, rel=1e-12), (told, formula)
            checked += 1
    assert checked > len(found) / 2


FUNCTIONS = {"sqrt", "pi", "atan2"}
# How many times as large numbers are where a metre is a third and a kilogram a seventh of what it is.
SCALES = {"1": 1.0, "m": 3.0, "kg": 7.0, "s": 1.0, "rad": 1.0, "N": 21.0}


def readings(line: str) -> dict[str, str]:
    """What a line says that its constant is: formulas, or words, by unit."""
    told = [text for text in line.split("; also ") if text.startswith("[")]
    return {text[1:].partition("] ")[0]: text.rpartition(": ")[2].rpartition("] ")[2] for text in told}


def words(formula: str) -> set[str]:
    return set(re.findall(r"(?<![\d.])\b[A-Za-z_]\w*", formula)) - FUNCTIONS


def valued(formula: str, numbers: Mapping[str, float]) -> float:
    return float(
        parse(re.sub(r"\b[A-Za-z_]\w*\b", lambda m: f"({numbers[m[0]]!r})" if m[0] in numbers else m[0], formula))
    )


def scale(unit: str) -> float:
    above, _, below = unit.partition("/")
    split = [[word.partition("^") for word in part.strip("()").split()] for part in (above, below)]
    factors = [[SCALES[name] ** int(power or 1) for name, _, power in part] for part in split]
    return float(np.prod(factors[0]) / np.prod(factors[1]))


@pytest.mark.parametrize("name", ["gear_train", "four_bar", "planar_3rrr"])
def test_formulas_hold_in_other_units(name: str) -> None:
    """A mass is no difference of lengths that is as large by chance: a formula has the unit that stands beside it."""
    found = block(printed(name))
    units = {constant: readings(line) for constant, (_, line) in found.items()}
    checked = 0
    for constant, unit, formula in ((c, u, f) for c, each in units.items() for u, f in each.items()):
        bare = {float(text) for text in re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?:e[+-]\d+)?", formula)}
        if not words(formula) or not words(formula) <= set(found) or not bare <= SILENT:
            continue  # a bare number may have any unit
        ways = itertools.product(*([(word, found[word][0] * scale(u)) for u in units[word]] for word in words(formula)))
        values = [valued(formula, dict(way)) for way in ways]
        assert any(v == pytest.approx(found[constant][0] * scale(unit), rel=1e-12) for v in values), (constant, formula)
        checked += 1
    assert checked > 5


@pytest.mark.parametrize("name", ["gear_train", "four_bar"])
def test_every_name_in_a_formula_has_a_line(name: str) -> None:
    found = block(printed(name))
    formulas = [f for _, line in found.values() for f in readings(line).values() if re.search("[*/+]", f)]
    assert formulas and all(words(formula) <= set(found) for formula in formulas)


def test_two_numbers_of_one_name_have_a_line_each() -> None:
    """As a length and its negative may, which formulas mention and no statement reads."""
    four_bar = model("four_bar")
    constants = Constants(four_bar, DOUBLE)
    size, other = list(constants.names)[:2]
    constants.text(other)  # a statement reads it
    node = constants._nodes[size]
    assert constants._called(node) == constants._called(-node) == constants.names[size]
    told = [line for line in constants.lines() if line.startswith(f"   {constants.names[size]} = ")]
    assert 1 <= len(told) <= 2


def test_a_number_that_is_two_things_is_called_by_neither() -> None:
    """0.075 is a length of the 3-RRR, and a first moment."""
    lines = block(printed("planar_3rrr"))
    (name,) = [name for name, (value, _) in lines.items() if value == 0.075]
    assert re.fullmatch(r"k\d+", name) and {"m", "kg m"} <= set(readings(lines[name][1]))


def test_numbers_of_the_description_have_its_names_and_units() -> None:
    found = block(printed("four_bar"))
    mechanism = model("four_bar").mechanism
    masses = {float(mechanism.number(body.mass)): name for name, body in mechanism.bodies.items() if body.mass}
    told = dict(found.values())
    named = [text for value, text in told.items() if value in masses and text.startswith("[kg] mass of ")]
    assert named and all(name in " ".join(named) for value, name in masses.items() if value in told)
    assert any(text.startswith("[m/s^2] acceleration of the effect of gravity") for text in told.values())


def test_every_number_of_a_statement_has_a_name_or_says_nothing() -> None:
    source = printed("four_bar")
    bodies = "".join(re.findall(r"^BODY\(.*?^\}", source, re.M | re.S))
    code = re.sub(r"/\*.*?\*/|SMALL\([^)]*\)", "", bodies)
    numbers = {abs(float(text)) for text in re.findall(r"(?<![\w.])\d+\.\d+(?:e[+-]\d+)?", code)}
    assert {number for number in numbers if number > 1e-6} <= SILENT


def test_no_name_is_taken_twice_and_none_is_a_local_variable() -> None:
    source = printed("four_bar")
    names = list(block(source))
    assert len(set(names)) == len(names) and not set(names) & TAKEN
    mentioned = set(re.findall(r"^   (\w+) = ", source, re.M))
    for name in names:
        assert not re.search(rf"(const|double|REAL|\*restrict) {name}\b", source)
        assert name in mentioned or len(re.findall(rf"\b{name}\b", re.sub(r"/\*.*?\*/", "", source, flags=re.S))) > 1, (
            f"{name} is not used"
        )


def test_names_of_parts_that_differ_in_digits_become_one() -> None:
    assert common(["limb1_upper", "limb2_upper"]) == "limb_upper"
    assert common(["limb1_upper", "platform"]) == "limb1_upper"
    assert common(["rod1a", "rod2a", "rod3a"]) == "roda"


def test_without_a_mechanism_numbers_stay_numbers() -> None:
    source = print_source(handmade.model())
    assert "/* Constants:" not in source and "1.0e-05" in source

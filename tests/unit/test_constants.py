"""Folded constants of generated C: named once, and made of what their line says."""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest
from support import handmade
from support.model_states import model

from symscrew.description import MechanismBuilder, parse
from symscrew.export import print_javascript, print_jax, print_numpy, print_rust, print_structured_text
from symscrew.export.c import print_source
from symscrew.export.c_names import TAKEN
from symscrew.export.c_precision import DOUBLE
from symscrew.export.c_printed import Shared
from symscrew.export.constant_formulas import SILENT
from symscrew.export.constants import common
from symscrew.export.structured_text import RESERVED
from symscrew.model import Model, derive

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
    constants = Shared(four_bar, DOUBLE).constants
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


def in_another_language(text: str) -> dict[str, float]:
    """Names and numbers of blocks of constants, and of what these are made of, in whatever language."""
    found = {}
    for part in text.split("Constants: numbers of the description")[1:]:
        block = re.split(r"\n\s*(?:\n|END_VAR)", part)[0]
        for name, number in re.findall(r"(\w+)(?: ?: \w+)? :?= (\d[\d.eE+-]*)", block):
            found[name] = float(number)
    return found


PRINTERS = {
    "numpy": print_numpy, "jax": print_jax, "javascript": print_javascript, "rust": print_rust,
    "structured text": print_structured_text,
}  # fmt: skip


@cache
def in_target(target: str) -> str:
    return max(PRINTERS[target](model("four_bar")).values(), key=len)


@pytest.mark.parametrize("target", PRINTERS)
def test_every_target_calls_constants_as_the_c_does(target: str) -> None:
    wanted = {name: number for name, (number, _) in block(printed("four_bar")).items()}
    found = in_another_language(in_target(target))
    assert len(found) > 20 and found == {name: wanted[name] for name in found}


@pytest.mark.parametrize("target", PRINTERS)
def test_no_target_has_numbers_that_say_nothing(target: str) -> None:
    """In a statement that computes something: limits of pivots, tolerances and the block itself are others."""
    text = in_target(target)
    names = set(in_another_language(text))
    lines = [line for line in text.splitlines() if re.match(r" *(let |const )?\w+ :?= .*[-+*/(]", line)]
    lines = [re.sub(r"(//|#|\(\*).*", "", line) for line in lines if not {*re.findall(r"\w+", line)[:1]} & names]
    read = [line for line in lines if "settings" not in line and set(re.findall(r"\w+", line)) & names]
    numbers = {float(n) for line in read for n in re.findall(r"(?<![\w.])\d+\.\d+(?:[eE][+-]?\d+)?", line)}
    assert len(read) > 50 and numbers <= SILENT


CLASHES = ("inverse_dynamics", "second_path", "internal_load", "row_scale", "linear_part", "date_and_time")


@cache
def hostile() -> Model:
    """Sliders whose masses are called like what functions, runtimes and languages have."""
    building = MechanismBuilder("clashes")
    for k, name in enumerate(CLASHES):
        building.parameter(name, f"{k + 8}/7", unit="kg", description="a mass")
        building.body(f"link_{k}", mass=name, com=(0, 0, 0), inertia=("1/11", "1/11", "1/11"))
        place = {"parent": "base", "child": f"link_{k}", "point": (0, 0, 0), "axes": [(0, 0, 1)]}
        building.joint(f"slide_{k}", "P", **place, driven=True)
    return derive(building.build()).only(["inverse_dynamics"])


@pytest.mark.parametrize("target", PRINTERS)
def test_no_constant_takes_a_name_from_a_function_or_the_language(target: str) -> None:
    text = max(PRINTERS[target](hostile()).values(), key=len)
    names = in_another_language(text)
    assert all(any(number == pytest.approx((k + 8) / 7) for number in names.values()) for k in range(len(CLASHES)))
    for name in names:
        assert not re.search(rf"\b(def|fn|function|let|let mut|class) {name}\b", text), name
        assert target != "structured text" or name.lower() not in RESERVED


def test_a_module_whose_functions_and_constants_would_have_one_name_works() -> None:
    found = hostile()
    module: dict[str, Any] = {"__name__": "clashes"}
    exec(compile(print_numpy(found)["clashes_numpy.py"], "clashes", "exec"), module)  # our own text
    wanted, status = found("inverse_dynamics", *found.test_inputs["inverse_dynamics"])
    made, reached = module["inverse_dynamics"](*found.test_inputs["inverse_dynamics"])
    np.testing.assert_array_equal(reached, status)
    np.testing.assert_allclose(made[0], wanted[0], rtol=1e-12)

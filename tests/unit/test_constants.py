"""Folded constants of generated C: named once, and made of what their line says."""

from __future__ import annotations

import re

import pytest
from support import handmade
from support.model_states import model

from symscrew.description import parse
from symscrew.export.c import print_source
from symscrew.export.c_constants import SILENT, common
from symscrew.export.c_names import TAKEN

LINE = re.compile(r"^    (\w+) = ([\d.e+-]+)[,;] /\* (.*?) \*/$", re.M | re.S)


def block(source: str) -> dict[str, tuple[float, str]]:
    text = source[source.index("/* Constants:") :]
    text = text[: re.search(r";[^;]*?\*/\n", text).end()]  # type: ignore[union-attr]
    return {name: (float(number), " ".join(told.split())) for name, number, told in LINE.findall(text)}


@pytest.mark.parametrize("name", ["four_bar", "slider_crank"])
def test_a_constant_is_what_its_formula_says(name: str) -> None:
    """Each formula, of constants that have lines themselves, gives the number to rounding."""
    found = block(print_source(model(name)))
    assert len(found) > 5
    checked = 0
    for value, told in found.values():
        formula = told.rpartition(": ")[2].rpartition("] ")[2]
        words = set(re.findall(r"[A-Za-z_]\w*", formula)) - {"sqrt", "pi", "atan2"}
        if words <= set(found) and re.search(r"[\d*+-]", formula):
            text = re.sub(r"\b[A-Za-z_]\w*\b", lambda m: f"({found[m[0]][0]!r})" if m[0] in found else m[0], formula)
            assert float(parse(text)) == pytest.approx(value, rel=1e-12), (told, text)
            checked += 1
    assert checked > len(found) / 2


def test_numbers_of_the_description_have_its_names_and_units() -> None:
    found = block(print_source(model("four_bar")))
    mechanism = model("four_bar").mechanism
    masses = {float(mechanism.number(body.mass)): name for name, body in mechanism.bodies.items() if body.mass}
    told = dict(found.values())
    named = [text for value, text in told.items() if value in masses and text.startswith("[kg] mass of ")]
    assert named and all(name in " ".join(named) for value, name in masses.items() if value in told)
    assert any(text.startswith("[m/s^2] acceleration of the effect of gravity") for text in told.values())


def test_every_number_of_a_statement_has_a_name_or_says_nothing() -> None:
    source = print_source(model("four_bar"))
    bodies = "".join(re.findall(r"^BODY\(.*?^\}", source, re.M | re.S))
    code = re.sub(r"/\*.*?\*/|SMALL\([^)]*\)", "", bodies)
    numbers = {abs(float(text)) for text in re.findall(r"(?<![\w.])\d+\.\d+(?:e[+-]\d+)?", code)}
    assert {number for number in numbers if number > 1e-6} <= SILENT


def test_no_name_is_taken_twice_and_none_is_a_local_variable() -> None:
    source = print_source(model("four_bar"))
    names = list(block(source))
    assert len(set(names)) == len(names) and not set(names) & TAKEN
    for name in names:
        assert not re.search(rf"(const|double|REAL|\*restrict) {name}\b", source)
        assert len(re.findall(rf"\b{name}\b", re.sub(r"/\*.*?\*/", "", source, flags=re.S))) > 1, f"{name} is not used"


def test_names_of_parts_that_differ_in_digits_become_one() -> None:
    assert common(["limb1_upper", "limb2_upper"]) == "limb_upper"
    assert common(["limb1_upper", "platform"]) == "limb1_upper"
    assert common(["rod1a", "rod2a", "rod3a"]) == "roda"


def test_without_a_mechanism_numbers_stay_numbers() -> None:
    source = print_source(handmade.model())
    assert "/* Constants:" not in source and "1.0e-05" in source

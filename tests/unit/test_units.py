"""Units of parameters: converted into SI, or refused; never taken for what they are not."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy

from symscrew.description import MechanismBuilder, parse_description, to_toml
from symscrew.description.units import in_si
from symscrew.errors import DescriptionError

R = sympy.Rational
BY_HAND = {
    "m": (1, "m"), "1": (1, "1"), "kg m^2": (1, "kg m^2"), "kg/(m s)": (1, "kg/(m s)"), "N*s/m": (1, "N*s/m"),
    "mm": (R(1, 1000), "m"), "mm^2": (R(1, 10**6), "m^2"), "g cm^2": (R(1, 10**7), "kg m^2"),
    "inch": (R(254, 10**4), "m"), "deg": (sympy.pi / 180, "rad"), "rpm": (sympy.pi / 30, "rad/s"),
    "N mm/deg": (9 / (50 * sympy.pi), "N m/rad"), "1/ms": (1000, "1/s"), "kN/mm": (10**6, "N/m"),
}  # fmt: skip


@pytest.mark.parametrize("unit", BY_HAND)
def test_units_are_those_of_si(unit: str) -> None:
    factor, text = in_si(unit, "unit")
    assert sympy.simplify(factor - BY_HAND[unit][0]) == 0 and text == BY_HAND[unit][1]
    assert in_si(text, "unit") == (1, text)


@pytest.mark.parametrize("unit", ["furlong", "", "m/s/s", "/s", "m | inch", "milimetre", "rpm^2", "mM", "m^", "m^99"])
def test_what_is_no_unit_is_refused(unit: str) -> None:
    with pytest.raises(DescriptionError, match=r"parameters\.a\.unit: ") as caught:
        MechanismBuilder("a").parameter("a", "0.5", unit=unit)
    assert "\n" not in str(caught.value)


def test_a_parameter_in_millimetres_is_one_in_metres() -> None:
    text = '[mechanism]\nname = "rod"\n[parameters.a]\nvalue = 500\nunit = "mm"\n[parameters.b]\nvalue = "2*a"\n'
    text += '[bodies.rod]\n[joints.pivot]\ntype = "P"\nparent = "base"\nchild = "rod"\npoint = [0, 0, "b"]\n'
    found = parse_description(text + "axes = [[1, 0, 0]]\n")
    assert found.parameters["a"].value == R(1, 2) and found.parameters["a"].unit == "m"
    assert found.parameters["b"].value == 1
    assert Decimal(1) / 3  # inexact, as others may have been in this process
    assert 'value = 0.5\nunit = "m"' in to_toml(found)
    with pytest.raises(DescriptionError, match=r"parameters\.b\.value: unknown name 'a'.* only a number is converted"):
        parse_description(text.replace('value = "2*a"', 'value = "2*a"\nunit = "mm"'))

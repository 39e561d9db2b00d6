"""Numbers of a description are doubles, and stay so when they are multiplied: looked at when it is read."""

from __future__ import annotations

import pytest

from symscrew.description import MechanismBuilder, to_toml
from symscrew.description.toml_file import parse_description
from symscrew.effects import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import derive

TOO_SMALL = ("1e-400", "1e-101", "1e-200*1e-150", "exp(-300)", "1e-60*k", "sin(1)^2+cos(1)^2-1", "sqrt(2)*1e-120")
TOO_LARGE = ("1e101", "exp(700)", "1e200*1e150", "1e60/k", "-1e300", "10^64*10^64")
FINE = (
    "0",
    "1e-99",
    "-1e-99",
    "1e99",
    "exp(-200)",
    "exp(200)",
    "sqrt(2)*sqrt(3)-sqrt(6)",
    "sin(pi)",
    "1e-55*k",
    "-0.0",
)
PLACES = ("mass", "com", "inertia", "point", "axis", "parameter")


def pendulum(place: str, number: str) -> MechanismBuilder:
    builder = MechanismBuilder("pendulum")
    builder.parameter("k", "1e-45")
    builder.parameter("other", number if place == "parameter" else "1", unit="m")
    inertia = number if place == "inertia" else "1"
    com = [0, 0, number if place == "com" else "-1"]
    builder.body("bob", mass=number if place == "mass" else "2", com=com, inertia=[inertia] * 3)
    point, axis = [0, number if place == "point" else "0", 0], [0, "1", number if place == "axis" else "0"]
    builder.joint("hinge", "R", parent="base", child="bob", point=point, axes=[axis], driven=True)
    return builder


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("number", TOO_SMALL + TOO_LARGE)
def test_numbers_that_code_cannot_hold_are_refused(place: str, number: str) -> None:
    with pytest.raises(
        DescriptionError, match=r"expected 0, or a size from 1e-100 to 1e100, .*write 0 where it is zero"
    ):
        pendulum(place, number).build()


@pytest.mark.parametrize("place", ("com", "point", "parameter"))
@pytest.mark.parametrize("number", FINE)
def test_what_is_accepted_can_be_written_and_read(place: str, number: str) -> None:
    made = pendulum(place, number).build()
    assert to_toml(parse_description(to_toml(made))) == to_toml(made)


@pytest.mark.parametrize("number", TOO_SMALL[:4] + TOO_SMALL[5:] + TOO_LARGE[:3] + TOO_LARGE[4:])
def test_numbers_of_effects_too(number: str) -> None:
    with pytest.raises(DescriptionError, match=r"gravity: expected finite numbers .* of a size from 1e-100 to 1e100"):
        derive(pendulum("none", "1").build(), [Gravity((0, 0, number))])

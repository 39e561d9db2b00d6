"""Both sides of every tolerance on a whole description: what passes, and what is refused or warned of."""

from __future__ import annotations

from typing import Any

import pytest

from symscrew import MechanismBuilder
from symscrew.description import validation
from symscrew.description.toml_file import parse_description
from symscrew.errors import DescriptionError


def pendulum(**options: Any) -> MechanismBuilder:
    body = {"mass": 1, "com": [0, 0, "-0.5"], "inertia": [1, 1, 1]} | options.pop("body", {})
    joint = {"point": [0, 0, 0], "axes": [[0, 1, 0]]} | options
    return MechanismBuilder("pendulum").body("rod", **body).joint("pivot", "R", parent="base", child="rod", **joint)


def universal(second: list[str]) -> MechanismBuilder:
    made = MechanismBuilder("cross").body("rod")
    axes = [["0", "0", "1"], second]
    return made.joint("pivot", "U", parent="base", child="rod", point=[0, 0, 0], axes=axes)


def axes_of_inertia(tilt: str) -> MechanismBuilder:
    axes = [[1, tilt, 0], [0, 1, 0], [0, 0, 1]]
    return pendulum(body={"inertia": {"principal": [1, 1, 1], "axes": axes}})


def gap(size: str) -> MechanismBuilder:
    return pendulum(point=[1, 0, 0], child_point=["1", size, "0"]).point("tip", body="rod", at=[0, 0, 0])


CASES = {
    "AXIS_TOLERANCE": (lambda x: pendulum(axes=[[0, f"1+{x}", 0]]), "0.9e-14", "1.2e-14", "unit vector"),
    "PARALLEL_AXES": (lambda x: universal(["0", x, f"1-{x}^2/2"]), "1.1e-12", "0.9e-12", "parallel"),
    "TRIAD_TOLERANCE": (axes_of_inertia, "0.9e-12", "1.1e-12", "three orthogonal unit vectors"),
    "CLOSURE_TOLERANCE": (gap, "0.9e-12", "1.1e-12", "does not close"),
    "INERTIA_TOLERANCE": (
        lambda x: pendulum(body={"inertia": ["1", "1", f"2+{x}"]}),
        "1.9e-12",
        "2.1e-12",
        "exceeds the sum",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_tolerance_passes_what_is_inside_and_refuses_what_is_outside(name: str) -> None:
    make, inside, outside, text = CASES[name]
    make(inside).build()
    with pytest.raises(DescriptionError, match=text):
        make(outside).build()


@pytest.mark.parametrize("name", CASES)
def test_the_tolerance_is_what_decides(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    make, _, outside, _ = CASES[name]
    wider = 0.1 if name == "PARALLEL_AXES" else 10.0
    monkeypatch.setattr(validation, name, wider * getattr(validation, name))
    make(outside).build()


def test_a_far_place_is_warned_of() -> None:
    def warnings(far: float) -> tuple[str, ...]:
        made = pendulum()
        for k, at in enumerate(([1, 0, 0], [0, 1, 0], [0, far, 0])):
            made.point(f"p{k}", body="rod", at=at)
        return made.build().warnings

    assert not any("is it in metres" in text for text in warnings(0.9 * validation.FAR))
    assert any("is it in metres" in text for text in warnings(1.6 * validation.FAR))


def test_an_axis_of_no_length_is_zero_and_no_unit_vector() -> None:
    with pytest.raises(DescriptionError, match="the axis is zero"):
        pendulum(axes=[[0, "0.9e-30", 0]]).build()
    with pytest.raises(DescriptionError, match=r"one of length 1\.1e-30; use"):
        pendulum(axes=[[0, "1.1e-30", 0]]).build()


@pytest.mark.parametrize("inside, outside", [("x = " + "[" * 40 + "]" * 40, "x = " + "[" * 41 + "]" * 41),
                                             (".".join("a" * 21) + " = 1", ".".join("a" * 22) + " = 1")])  # fmt: skip
def test_a_file_that_nests_or_dots_too_deep_is_refused(inside: str, outside: str) -> None:
    head = '[mechanism]\nname = "m"\n'
    with pytest.raises(DescriptionError, match="unknown key"):
        parse_description(head + inside)
    with pytest.raises(DescriptionError, match="nested more than 40 deep"):
        parse_description(head + outside)

"""A certificate is a proof of the mechanism that it names, and of no other: its equations are derived again."""

from __future__ import annotations

import copy
import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.studies.certificate import certify, check_certificate, proof_of_mechanism
from symscrew.studies.certificate.derived_again import OF_WALK
from symscrew.studies.workspace import Axis, Plan

pytestmark = pytest.mark.slow


@cache
def text() -> str:
    """Of a five-bar whose cranks are turned away from the reference: a way leads there."""
    axes = (Axis("base_left", 0.2, 0.3, 3), Axis("base_right", -0.3, -0.2, 3))
    found = certify(Plan(catalogue.load("five_bar"), (), axes, limits=(("elbow_left", -2.0, 2.0),)))
    assert found.ok and not found.summary["assumed"]
    return json.dumps(found.values)


def values() -> dict[str, Any]:
    return dict(json.loads(text()))


def constant_of(instructions: list[Any]) -> tuple[int, int]:
    """A constant of a program that has one."""
    return next((k, j) for k, i in enumerate(instructions) for j in range(2, len(i)) if isinstance(i[j], float))


def test_a_certificate_is_one_of_its_mechanism() -> None:
    found = proof_of_mechanism(values(), catalogue.load("five_bar"))
    assert found.ok and found.mechanism == "five_bar" and not found.left
    assert f"description {found.digest}" in str(found)
    assert "over base_left 0.2 to 0.3, base_right -0.3 to -0.2\n" in str(found)
    assert "within the limits elbow_left from -2.0 to 2.0" in str(found)


def test_an_equation_with_another_constant_proves_another_mechanism() -> None:
    """The checker alone takes it, as it knows of no mechanism: a length that is 1e-9 longer is as good to it."""
    spoiled = values()
    program = spoiled["equations"]["closure"]["instructions"]
    k, j = constant_of(program)
    program[k][j] *= 1 + 1e-9
    assert check_certificate(spoiled).holds
    found = proof_of_mechanism(spoiled)
    assert not found.ok and found.refused[0].startswith(f"equations.closure.instructions[{k}][{j}]: the mechanism has")


@pytest.mark.parametrize(
    ("path", "value", "why"),
    [
        (("mechanism", "name"), "other", "calls itself one of 'other'"),
        (("mechanism", "toml"), lambda toml: toml.replace('[0, 0, "3/5"]', '[0, 0, "4/5"]').replace("0.6]", "0.7]"),
         "equations.closure"),
        (("asked", "limits"), [["elbow_left", -2.0, 1.0]], "limits"),
        (("asked", "fixed"), {"nothing": 1.0}, "'nothing', which is no coordinate"),
        (("equations", "driven"), None, "equations.driven"),
        (("equations", "rows"), [0, 3], "equations.rows"),
        (("region", "names"), ["base_right", "base_left"], "equations.axes"),
        (("way", "equations", "driven"), None, "way.equations.driven"),
        (("asked", "fixed"), {"elbow_left": 0.5}, "says that 'elbow_left' is held"),
        (("start", "z"), [0.25, -0.25], "does not start at the point of its region that is nearest to the reference"),
        (("claims",), {}, "claims nothing"),
        (("way", "begin", "q"), lambda q: [-x - 1.0 for x in q], "an end of the way"),
    ],
)  # fmt: skip
def test_what_is_not_of_the_mechanism_is_refused(path: tuple[str, ...], value: Any, why: str) -> None:
    spoiled = copy.deepcopy(values())
    place: Any = spoiled
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value(place[path[-1]]) if callable(value) else value
    found = proof_of_mechanism(spoiled)
    assert not found.ok and any(why in reason for reason in (*found.refused, *found.verdict.refused)), str(found)


def test_without_a_way_it_is_said_that_a_walk_led_there() -> None:
    spoiled = values() | {"way": None}
    assert proof_of_mechanism(spoiled).left == (OF_WALK,)


def test_the_command_says_whose_proof_it_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "certificate.json"
    file.write_text(text())
    assert main(["check", str(file), "--mechanism", "five_bar", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["ok"]
    assert main(["check", str(file), "--mechanism", "four_bar"]) == 1
    assert "a proof of another mechanism: 'name = \"five_bar\"' where four_bar has" in capsys.readouterr().out
    file.write_text("{}")
    assert main(["check", str(file)]) == 2
    assert "expected a folder of generated code, or a certificate" in capsys.readouterr().err

"""The characteristic length: settable in the description and in `derive`, recorded, and of effect where it must be."""

from __future__ import annotations

import json

import numpy as np
import pytest
from support.model_states import output
from sympy import Rational

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description.builder import MechanismBuilder
from symscrew.description.toml_file import parse_description, to_toml
from symscrew.errors import DescriptionError
from symscrew.export.manifest_file import manifest
from symscrew.generation.folder import render
from symscrew.mobility import inverse_kinematics
from symscrew.model import derive
from symscrew.verification.regeneration import check

PAIR = """
[mechanism]
name = "pair"
{length}
[parameters.half]
value = "1/8"
unit = "m"
[parameters.changing]
value = 1
unit = "m"
run_time = true
[bodies.rod]
mass = 1
com = [{a}, 1, 0]
[bodies.tip]
mass = 1
com = [{b}, 1, 0]
[joints.first]
type = "R"
parent = "base"
child = "rod"
point = [{a}, 0, 0]
axes = [[0, 0, 1]]
[joints.second]
type = "R"
parent = "rod"
child = "tip"
point = [{b}, 0, 0]
axes = [[0, 0, 1]]
"""


def pair(length: str = "", a: float = 1.0, b: float = 3.0):
    return parse_description(PAIR.format(length=length, a=a, b=b))


def recorded(model) -> dict:
    return manifest(model, targets=[], files=[])["characteristic_length"]


def test_default_is_the_root_mean_square_distance_and_proportional_to_the_unit():
    assert recorded(derive(pair())) == {"value": 1.0, "unit": "m", "source": "default"}
    assert recorded(derive(pair(a=1000, b=3000)))["value"] == 1000.0
    assert recorded(derive(pair(a=-7, b=-5)))["value"] == 1.0  # moved


@pytest.mark.parametrize("off, at", [(1e-13, 0.0), (4e-8, 0.0), (3e-7, 7.0), (2e-6, 5000.0)])
def test_points_that_rounding_sets_apart_are_one(off, at):
    """As those of a spherical linkage: its size is not the rounding of its centre."""
    assert recorded(derive(pair(a=at, b=at + off)))["value"] == 1.0 == recorded(derive(pair(a=at, b=at)))["value"]


def test_far_away_and_small_mechanisms_keep_theirs():
    assert recorded(derive(pair(a=6.4e6, b=6.4e6 + 0.5)))["value"] == 0.25
    assert recorded(derive(pair(a=0, b=1e-4)))["value"] == 5e-5


def four_bar(size: str):
    """Of `size` [m], with masses of 1 kg."""
    scale = Rational(size)
    builder = MechanismBuilder("small")
    for body, x, y in (("crank", 0, 1), ("coupler", 2, 3), ("rocker", 5, 1)):
        builder.body(body, mass=1, com=[x * scale, y * scale, 0], inertia=[scale**2 / 10] * 3)
    chain = ("base", "crank", "coupler", "rocker", "base")
    for k, (x, y) in enumerate(((0, 0), (1, 3), (4, 2), (5, -1))):
        place = [x * scale, y * scale, 0]
        builder.joint(f"J{k}", "R", parent=chain[k], child=chain[k + 1], point=place, axes=[[0, 0, 1]], driven=k == 0)
    return builder.build()


@pytest.mark.parametrize("size", ["1e-9", "1e-11"])
def test_linkages_of_nanometres_move_as_those_of_metres(size):
    small, large = (derive(four_bar(length)) for length in (size, "1"))
    states = large.test_inputs["inverse_dynamics"]
    drive, expected = (output(model, "inverse_dynamics", "u", *states) for model in (small, large))
    assert np.allclose(drive / float(size) ** 2, expected, rtol=1e-9)  # moments of inertia alone: weight is across
    moved = inverse_kinematics(four_bar(size), {"J0": 0.1}).values
    assert moved == pytest.approx(inverse_kinematics(four_bar("1"), {"J0": 0.1}).values, rel=1e-12)


@pytest.mark.parametrize("off, one", [(1e-10, True), (1e-8, False)])
def test_points_and_centres_of_mass_in_one_place_are_held_against_radii_of_gyration(off, one):
    builder = MechanismBuilder("spherical")
    builder.body("inner", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.body("outer", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("first", "R", parent="base", child="inner", point=[0, 0, 0], axes=[[0, 0, 1]])
    builder.joint("second", "R", parent="inner", child="outer", point=[off, 0, 0], axes=[[1, 0, 0]])
    assert (recorded(derive(builder.build()))["value"] == 1.0) is one


def test_the_description_sets_it_exactly_and_keeps_it():
    mechanism = pair('characteristic_length = "2*half"')
    assert recorded(derive(mechanism)) == {"value": 0.25, "unit": "m", "source": "description"}
    assert parse_description(to_toml(mechanism)) == mechanism
    assert "characteristic_length" not in to_toml(pair())


def test_derive_sets_it_in_place_of_the_description():
    model = derive(pair("characteristic_length = 5"), length="half + 1")
    assert recorded(model) == {"value": 1.125, "unit": "m", "source": "description"}
    assert derive(parse_description(to_toml(model.mechanism))).system.length == 1.125


@pytest.mark.parametrize(
    "value, message",
    [
        ("0", "expected a length above 0 m, got 0"),
        ("-2", "expected a length above 0 m, got -2"),
        ('"half - 1/8"', "expected a length above 0 m, got 'half - 1/8'"),
        ('"changing"', "depends on the run-time parameter 'changing'"),
        ("true", "expected a number, got the truth value True"),
        ("nan", "characteristic_length"),
        ("[1]", "expected a number"),
        ('"unknown"', "unknown"),
    ],
)
def test_what_is_no_length_is_refused(value, message):
    with pytest.raises(DescriptionError, match=r"mechanism\.characteristic_length") as caught:
        pair(f"characteristic_length = {value}")
    assert message in str(caught.value)


def test_reactions_that_are_not_unique_follow_it_and_the_others_do_not():
    mechanism = catalogue.load("bennett")
    ours, other = (derive(mechanism, length=length) for length in (None, 20))
    inputs = ours.test_inputs["joint_reactions"]
    reactions, changed = (output(m, "joint_reactions", "reactions", *inputs) for m in (ours, other))
    assert np.abs(changed - reactions).max() > 1e-3 * np.abs(reactions).max()
    drives, same = (output(m, "joint_reactions", "u", *inputs) for m in (ours, other))
    assert np.allclose(drives, same, rtol=1e-9, atol=1e-12)


def test_generated_output_records_it_and_is_checked_with_it(tmp_path):
    assert main(["generate", "four_bar", "--length", "0.375", "--out", str(tmp_path), "--target", "numpy"]) == 0
    content = json.loads((tmp_path / "manifest.json").read_text())
    assert content["characteristic_length"] == {"value": 0.375, "unit": "m", "source": "description"}
    assert check(tmp_path).ok


def test_a_length_on_the_command_line_that_is_none_is_one_clear_error(tmp_path, capsys):
    assert main(["generate", "four_bar", "--length", "-1", "--out", str(tmp_path / "new")]) == 2
    error = capsys.readouterr().err
    assert error.count("error:") == 1 and "above 0 m" in error and "Traceback" not in error
    assert not (tmp_path / "new").exists()


def test_the_default_leaves_the_generated_files_as_they_were():
    files = render(derive(catalogue.load("four_bar")), ["numpy"])
    assert b"characteristic_length" not in files["mechanism.toml"]

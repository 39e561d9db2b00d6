"""Configurations asked for by what the package itself calls independent, by a platform's pose, by a rotation."""

from __future__ import annotations

import json

import numpy as np
import pytest
import sympy
from scipy.spatial.transform import Rotation
from support import model_states

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinematics import virtual_joint
from symscrew.mobility import analyse_mobility, inverse_kinematics
from symscrew.mobility.configuration import Reached, with_parameters
from symscrew.mobility.joint_network import network_of

SEED = "three_ups_upu_s"


def placed(mechanism: Mechanism, at: dict[str, str]) -> Reached:
    """Where `analyse_mobility(mechanism, at=at)` looks at the mechanism, without the analysis."""
    found = inverse_kinematics(mechanism, at).reached
    assert found is not None
    return found


def screws(mechanism: Mechanism, at: dict[str, str]) -> np.ndarray:
    return np.array([[float(c) for c in screw] for screw in placed(mechanism, at).network.screws])


@pytest.mark.parametrize("name", ["four_bar", pytest.param(SEED, marks=pytest.mark.slow)])
def test_every_coordinate_that_the_package_calls_independent_can_be_given(name: str) -> None:
    port = model_states.model(name).programs["assemble"].inputs[0]
    assert port.description == "independent coordinates"
    for label in port.labels:
        there = placed(catalogue.load(name), {label: "-1/10"})
        assert there.closed_to < 1e-26
        if not label.startswith("limb5_S.q"):
            assert there.values[label] == pytest.approx(-0.1, abs=1e-15)


def test_mobility_is_analysed_at_a_coordinate_that_is_given() -> None:
    found = analyse_mobility(catalogue.load("four_bar"), at={"A": "-1/10"})
    assert found.dof == 1 and found.closed_to < 1e-26 and "at A = -1/10" in found.report()
    assert found.reached is not None and found.reached.values["A"] == -0.1


@pytest.mark.slow
@pytest.mark.parametrize("name", ["stewart_6ups", "delta"])
def test_the_joint_that_the_package_hangs_a_platform_on_can_be_given(name: str) -> None:
    """What `assemble` takes: the place of a point, absolute, and a quaternion. By hand the platform's joints are where
    that motion takes them."""
    mechanism = catalogue.load(name)
    labels = model_states.model(name).programs["assemble"].inputs[0].labels
    joint = virtual_joint(mechanism)
    assert joint is not None and all(label.startswith(f"{joint.name}.") for label in labels)
    point = np.array([float(mechanism.number(c)) for c in joint.point])
    step, vector = np.array([0.01, -0.02, 0.03]), np.array([0.02, 0.01, -0.03]) if len(labels) == 6 else np.zeros(3)
    given = [*(point + step), *vector][: len(labels)]
    there = placed(mechanism, {label: repr(float(y)) for label, y in zip(labels, given, strict=True)})
    hat = np.array([[0, -vector[2], vector[1]], [vector[2], 0, -vector[0]], [-vector[1], vector[0], 0]])
    turn = np.eye(3) + 2 * np.sqrt(1 - vector @ vector) * hat + 2 * hat @ hat
    before, after = network_of(mechanism), there.network
    for edge in (e for e in before.edges.values() if mechanism.platform in (e.parent, e.child)):
        old, new = (np.array([float(c * net.length) for c in net.edges[edge.name].point]) for net in (before, after))
        assert np.abs(new - (point + step + turn @ (old - point))).max() < 1e-14
    with pytest.raises(DescriptionError, match=r"expected platform_pose with \.0, \.1, \.2 or \.qx"):
        analyse_mobility(mechanism, at={f"{joint.name}.9": "1/10"})


@pytest.mark.slow
def test_a_pose_of_the_platform_is_that_of_the_joint_that_carries_it() -> None:
    """The seed's platform turns about the centre of limb5_S: for quaternions and for rotation vectors."""
    seed = catalogue.load(SEED)
    before = screws(seed, {})
    for kind in "qr":
        body, joint = (
            screws(seed, {f"{who}.{kind}x": "1/20", f"{who}.{kind}y": "-1/10"}) for who in ("platform", "limb5_S")
        )
        assert np.abs(body - before).max() > 0.05 and np.abs(body - joint).max() < 1e-14


def test_a_body_is_displaced_by_what_was_asked_for() -> None:
    """The Sarrus linkage lifts its platform along z: by 10 mm, wherever its joints go."""
    before, after = (
        placed(catalogue.load("sarrus"), at).network for at in ({}, {f"{catalogue.load('sarrus').platform}.z": "1/100"})
    )
    joint = next(e.name for e in before.edges.values() if e.child == catalogue.load("sarrus").platform)
    places = zip(before.edges[joint].point, after.edges[joint].point, strict=True)
    moved = [float((b - a) * before.length) for a, b in places]
    assert np.allclose(moved, [0, 0, 0.01], atol=1e-15)


def test_coordinates_that_are_none_are_refused_with_those_that_are() -> None:
    for name, text in (("platform.w", r"expected platform\.x"), ("limb5_S", r"\.qx, \.qy, \.qz of its quaternion"),
                       ("nothing.x", "no parameter, joint or body of this name")):  # fmt: skip
        with pytest.raises(DescriptionError, match=text):
            analyse_mobility(catalogue.load(SEED), at={name: "1/10"})


@pytest.mark.slow
def test_a_pose_in_degrees_and_millimetres_has_the_legs_that_geometry_gives() -> None:
    """The hexapod at a pose by roll, pitch and yaw: its legs' lengths by hand, from the points of both plates."""
    mechanism = catalogue.load("stewart_6ups")
    given = {"x": "10mm", "y": "-2cm", "z": "0.03", "roll": "5deg", "pitch": "-8deg", "yaw": "12deg"}
    values = placed(mechanism, given).values
    turn = Rotation.from_euler("xyz", [5, -8, 12], degrees=True)
    ends = {k: [np.array([float(mechanism.number(c)) for c in mechanism.joints[f"leg{k}_{letter}"].point])
                for letter in "US"] for k in range(1, 7)}  # fmt: skip
    middle = np.mean([top for _, top in ends.values()], axis=0)
    for k, (base, top) in ends.items():
        moved = turn.apply(top - middle) + middle + [0.01, -0.02, 0.03]
        start = float(mechanism.number(mechanism.joints[f"leg{k}_P"].reference[0]))
        longer = np.linalg.norm(moved - base) - np.linalg.norm(top - base)
        assert abs(values[f"leg{k}_P"] - start - longer) < 1e-14
    assert abs(np.degrees(values["platform.yaw"]) - 12) < 1e-12


def test_more_coordinates_than_are_free_are_refused() -> None:
    with pytest.raises(DescriptionError, match=r"2 numbers are given and 1 are free: leave some out"):
        analyse_mobility(catalogue.load("four_bar"), at={"A": "1/10", "D": "1/2"})


def test_the_report_lists_what_the_other_coordinates_are(capsys: pytest.CaptureFixture[str]) -> None:
    """Four-bar: the angles add up around the loop, in what is printed and in the JSON; bare angles draw a notice."""
    assert main(["mobility", "four_bar", "--at", "A=20deg", "--json"]) == 0
    made = capsys.readouterr()
    said = json.loads(made.out)["configuration"]
    assert not made.err and said["in_words"] == "at A = 20deg" and said["all"]["A"]["shown"] == "20deg"
    angles = {name: said["all"][name]["value"] for name in "ABCD"}
    assert abs(angles["A"] + angles["B"] + angles["C"] - angles["D"]) < 1e-12 and abs(angles["B"]) > 0.1
    assert main(["mobility", "four_bar", "--at", "A=7"]) == 0
    made = capsys.readouterr()
    assert "note: A is in rad: 7 are 401 degrees" in made.err
    assert "given: A = 7; all others follow" in made.out and "joints: A = 401.07deg, B = " in made.out
    assert main(["mobility", "four_bar", "--at", "rocker.tlt=7deg"]) == 2
    assert main(["mobility", "four_bar", "--at", "rockr.tilt=7deg"]) == 2
    assert "did you mean 'rocker.tilt'" in capsys.readouterr().err


def test_parameters_that_follow_one_that_is_given_follow_it() -> None:
    """The delta's depth is a formula of its rods: the loops close for other rods, given with a unit."""
    mechanism = catalogue.load("delta")
    derived = [p for p in mechanism.parameters.values() if p.formula is not None]
    changed, _ = with_parameters(mechanism, {"rods": "650mm"})
    assert derived and changed.parameters["rods"].value == sympy.Rational(13, 20)
    assert any(changed.parameters[p.name].value != p.value for p in derived)


@pytest.mark.parametrize("turn", [0.02, -0.02])
def test_no_pose_is_reached_by_whole_turns_of_joints(turn: float) -> None:
    """The turn of this ball joint about x is zero in all poses nearby; two turns of another joint away it is not."""
    mechanism = catalogue.load("three_ups_upu_s")
    with pytest.raises(DescriptionError, match="cannot be assembled there"):
        analyse_mobility(mechanism, at={"limb3_S.rx": turn})
    assert analyse_mobility(mechanism, at={"limb1_U.1": turn}).dof == 2

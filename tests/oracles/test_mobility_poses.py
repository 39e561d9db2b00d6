"""Configurations asked for by what the package itself calls independent, by a platform's pose, by a rotation."""

from __future__ import annotations

import numpy as np
import pytest
from support import model_states

from symscrew import catalogue
from symscrew.errors import DescriptionError
from symscrew.kinematics import virtual_joint
from symscrew.mobility import analyse_mobility
from symscrew.mobility.joint_network import Network

SEED = "three_ups_upu_s"


def screws(network: Network) -> np.ndarray:
    return np.array([[float(c) for c in screw] for screw in network.screws])


@pytest.mark.parametrize("name", ["four_bar", pytest.param(SEED, marks=pytest.mark.slow)])
def test_every_coordinate_that_the_package_calls_independent_can_be_given(name: str) -> None:
    port = model_states.model(name).programs["assemble"].inputs[0]
    assert port.description == "independent coordinates"
    freedoms = analyse_mobility(catalogue.load(name)).dof
    for label in port.labels:
        found = analyse_mobility(catalogue.load(name), at={label: "-1/10"})
        assert found.dof == freedoms and found.closed_to < 1e-26 and label in found.report()


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
    there = analyse_mobility(mechanism, at={label: repr(float(y)) for label, y in zip(labels, given, strict=True)})
    hat = np.array([[0, -vector[2], vector[1]], [vector[2], 0, -vector[0]], [-vector[1], vector[0], 0]])
    turn = np.eye(3) + 2 * np.sqrt(1 - vector @ vector) * hat + 2 * hat @ hat
    before, after = analyse_mobility(mechanism).network, there.network
    for edge in (e for e in before.edges.values() if mechanism.platform in (e.parent, e.child)):
        old, new = (np.array([float(c * net.length) for c in net.edges[edge.name].point]) for net in (before, after))
        assert np.abs(new - (point + step + turn @ (old - point))).max() < 1e-14
    with pytest.raises(DescriptionError, match=r"expected platform_pose with \.0, \.1, \.2 or \.qx"):
        analyse_mobility(mechanism, at={f"{joint.name}.9": "1/10"})


@pytest.mark.slow
def test_a_pose_of_the_platform_is_that_of_the_joint_that_carries_it() -> None:
    """The seed's platform turns about the centre of limb5_S: for quaternions and for rotation vectors."""
    seed = catalogue.load(SEED)
    before = screws(analyse_mobility(seed).network)
    for kind in "qr":
        body, joint = (
            screws(analyse_mobility(seed, at={f"{who}.{kind}x": "1/20", f"{who}.{kind}y": "-1/10"}).network)
            for who in ("platform", "limb5_S")
        )
        assert np.abs(body - before).max() > 0.05 and np.abs(body - joint).max() < 1e-14


def test_a_body_is_displaced_by_what_was_asked_for() -> None:
    """The Sarrus linkage lifts its platform along z: by 10 mm, wherever its joints go."""
    before, after = (
        analyse_mobility(catalogue.load("sarrus"), at=at).network
        for at in ({}, {f"{catalogue.load('sarrus').platform}.z": "1/100"})
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

"""Configurations asked for by what the package itself calls independent, by a platform's pose, by a rotation."""

from __future__ import annotations

import numpy as np
import pytest
from support import model_states

from symscrew import catalogue
from symscrew.errors import DescriptionError
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

"""Assembly modes and paths between them without a singularity, against publications; every path is walked again."""

from __future__ import annotations

import json

import numpy as np
import pytest
from support.reference_mechanisms import ENTRIES, build

from symscrew.cli.parser import main
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility.components import ModeConnections, assembly_connections
from symscrew.mobility.joint_network import Network, network_of

pytestmark = pytest.mark.slow


def platform() -> Mechanism:
    """The 3-RPR with six assembly modes, three of each sign; those of one sign lie in one aspect.

    C. Innocenti, V. Parenti-Castelli 1992; P. R. McAree, R. W. Daniel 1999; M. Zein, P. Wenger, D. Chablat 2006: base
    points (0, 0), (15.91, 0), (0, 10), sides of the platform 17.04, 16.54, 20.84, lengths of the legs 14.98, 15.38, 12.
    """
    one, two, three = 17.04, 16.54, 20.84
    along = (one**2 + three**2 - two**2) / (2 * one)
    corners = np.array([[0.0, 0.0], [one, 0.0], [along, np.sqrt(three**2 - along**2)]])
    feet, lengths = np.array([[0.0, 0.0], [15.91, 0.0], [0.0, 10.0]]), (14.98, 15.38, 12.0)
    pose = np.array([-13.41993901, -6.65624796, 0.58567278])  # one of the six, then to all digits
    for _ in range(5):
        c, s = np.cos(pose[2]), np.sin(pose[2])
        legs = pose[:2] + corners @ np.array([[c, s], [-s, c]]) - feet
        turned = corners @ np.array([[-s, c], [-c, -s]])
        slopes = np.column_stack([legs, (legs * turned).sum(axis=1)])
        pose = pose - np.linalg.solve(slopes, ((legs**2).sum(axis=1) - np.square(lengths)) / 2)
    builder = MechanismBuilder("platform", platform="plate").body("plate")
    for k, (foot, leg) in enumerate(zip(feet, legs, strict=True)):
        builder.body(f"low{k}").body(f"high{k}")
        near, far = [*map(float, foot), 0], [*map(float, foot + leg), 0]
        axis = [*map(float, leg / np.linalg.norm(leg)), 0]
        builder.joint(f"A{k}", "R", parent="base", child=f"low{k}", point=near, axes=[[0, 0, 1]])
        builder.joint(f"P{k}", "P", parent=f"low{k}", child=f"high{k}", point=near, axes=[axis], driven=True)
        builder.joint(f"B{k}", "R", parent=f"high{k}", child="plate", point=far, axes=[[0, 0, 1]])
    return builder.build()


def modes(network: Network, *drives: int) -> ModeConnections:
    found = assembly_connections(network, drives)
    assert isinstance(found, ModeConnections), found
    return found


def test_the_modes_of_a_driven_crank_are_apart() -> None:
    """Hunt 1978, ch. 4: the two closures of a crank-rocker, on either side of the stretched coupler and rocker."""
    network = network_of(build(ENTRIES["planar_4bar"]))
    found = modes(network, 0)
    assert sorted(m.sign for m in found.modes) == [-1, 1] and [m.corners is None for m in found.modes] == [False, True]


def test_what_has_no_modes_is_said() -> None:
    network = network_of(build(ENTRIES["kinematotropic_double_fold-transition"]))
    assert assembly_connections(network) == "not decided: no drives"
    assert str(assembly_connections(network, (0,))).startswith("not decided: with the drives locked")


def test_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mobility", "four_bar", "--connections", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)["assembly_modes"]
    assert values["decided"] and values["judgement"] == "sampled" and len(values["modes"]) == 2
    other = values["modes"][1]
    assert (other["to_reference"], other["to_reference_judgement"]) == ("separated", "certified")

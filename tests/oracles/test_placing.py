"""Configurations from some coordinates: parasitic motion as the literature has it, motors by geometry, and statuses."""

from __future__ import annotations

import math

import numpy as np
import pytest

import symscrew
from symscrew import catalogue
from symscrew.description import parse_description
from symscrew.description.template import description_text
from symscrew.errors import DescriptionError
from symscrew.kinematics import System

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("azimuth", [20, pytest.param(75, marks=pytest.mark.slow)])
def test_the_parasitic_motion_of_a_3_rps_is_that_of_the_literature(azimuth: int) -> None:
    """No torsion, and a shift of r (1 - cos tilt)/2: I. Bonev, PhD thesis, Laval 2002, for limbs in planes at 120 deg.

    The legs are as long as the distances between their ends, which turn and shift with the platform.
    """
    mechanism = parse_description(description_text("one", "3-RPS"))
    found = symscrew.inverse_kinematics(mechanism, z="30mm", tilt="25deg", azimuth=f"{azimuth}deg")
    assert found.ok and abs(found.pose["torsion"]) < 1e-14
    r, tilt = 0.25, math.radians(25)
    assert abs(math.hypot(found.pose["x"], found.pose["y"]) - r * (1 - math.cos(tilt)) / 2) < 1e-14
    at = math.radians(azimuth)
    axis, shift = np.array([math.cos(at), math.sin(at), 0]), [found.pose[c] for c in "xyz"]
    for k, (name, longer) in enumerate(found.drives.items()):
        angle = 2 * math.pi * k / 3
        radial = np.array([math.cos(angle), math.sin(angle), 0])
        turned = radial * math.cos(tilt) + np.cross(axis, radial) * math.sin(tilt)
        turned += axis * (axis @ radial) * (1 - math.cos(tilt))
        foot, head = 0.5 * radial, r * turned + [0, 0, 0.6] + shift
        start = np.linalg.norm([0.25, 0.6])
        assert name == f"limb{k + 1}_P2" and abs(np.linalg.norm(head - foot) - start - longer) < 1e-14


def test_where_there_is_no_configuration_a_status_says_why() -> None:
    mechanism = catalogue.load("delta")
    far = symscrew.inverse_kinematics(mechanism, z="-1")
    assert far.status == "out of reach" and far.limb.startswith("rod") and f"{far.limb} does not get there" in far.text
    turned = symscrew.inverse_kinematics(mechanism, z="-50mm", x=0, y=0, roll="3deg")
    assert turned.status == "not on the mechanism" and "platform.roll stays the same" in turned.text
    more = symscrew.inverse_kinematics(catalogue.load("four_bar"), {"A": 0.3, "B": 0.9})
    assert more.status == "not on the mechanism" and "2 numbers are given and 1 are free" in more.text
    for found in (far, turned, more):
        assert not found.ok and not found.values and not found.drives and np.isnan(found.q).all()
    with pytest.raises(DescriptionError, match=r"did you mean 'platform\.z'"):
        symscrew.inverse_kinematics(mechanism, {"platfrm.z": "1mm"})


def test_a_whole_pose_in_doubles_is_taken_where_it_fits() -> None:
    """Six numbers of a body with one freedom fit to their digits only; one that does not fit is refused."""
    mechanism = catalogue.load("bennett")
    there = symscrew.inverse_kinematics(mechanism, {"J1": 0.3})
    pose = {part: there.pose[part] for part in ("x", "y", "z", "rx", "ry", "rz")}
    again = symscrew.inverse_kinematics(mechanism, pose)
    assert again.ok and all(abs(again.values[key] - value) < 1e-9 for key, value in there.values.items())
    assert not symscrew.inverse_kinematics(mechanism, {**pose, "rx": pose["rx"] + 1e-9}).ok


def test_q_is_that_of_a_model_and_closes_its_loops() -> None:
    """The delta's arms by hand: a rod's ends are its length apart."""
    mechanism = catalogue.load("delta")
    found = symscrew.inverse_kinematics(mechanism, z="-50mm", x="30mm")
    system = System(mechanism)
    residual = system.numeric(system.residual, (system.inputs.q, found.q[None]))
    assert found.ok and np.abs(residual).max() < 1e-14
    values = {name: float(p.value) for name, p in mechanism.parameters.items()}
    depth = math.sqrt(values["rods"] ** 2 - values["inwards"] ** 2)
    for k, angle in enumerate(found.drives.values()):
        turn = 2 * math.pi * k / 3
        radial = np.array([math.cos(turn), math.sin(turn), 0])
        elbow = values["base_radius"] * radial + values["upper_arm"] * (
            math.cos(angle) * radial - math.sin(angle) * np.array([0, 0, 1])
        )
        end = values["platform_radius"] * radial + [found.pose[c] for c in "xyz"] - [0, 0, depth]
        assert abs(np.linalg.norm(end - elbow) - values["rods"]) < 1e-14


def test_what_no_motion_changes_is_not_out_of_reach() -> None:
    """A delta's platform does not turn: no limb is named for that; a height that is too low names one."""
    delta = symscrew.load_catalogue("delta")
    for asked in ({"tilt": "10deg", "azimuth": "40deg"}, {"z": "-10mm", "yaw": "3deg"}):
        found = symscrew.inverse_kinematics(delta, asked)
        assert (found.status, found.limb) == ("not on the mechanism", ""), asked
        turned = "tilt" if "tilt" in asked else "yaw"
        assert found.text.endswith(f"platform.{turned} stays the same in every motion sampled")
    low = symscrew.inverse_kinematics(delta, z="-2")
    assert low.status == "out of reach" and low.limb
    crank = symscrew.inverse_kinematics(symscrew.load_catalogue("four_bar"), x="9")
    assert crank.status == "out of reach"  # changes with the crank, though never so far
    assert "<caption>four_bar: out of reach" in crank._repr_html_()


def test_a_part_of_a_pose_that_is_mistyped_is_found() -> None:
    with pytest.raises(DescriptionError, match="did you mean 'z'"):
        symscrew.inverse_kinematics(symscrew.load_catalogue("four_bar"), zz="1mm")

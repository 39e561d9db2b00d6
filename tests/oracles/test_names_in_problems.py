"""Coordinates of problems by the names that `--at` takes: what the optimiser makes of them, against mobility's poses.

Configurations are placed by the optimiser's own equations in CasADi, and by the 60-digit assembly of mobility analysis:
two routes, which share the names and the definition of a pose, and no equation.
"""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.model_states import model

from symscrew.errors import DescriptionError
from symscrew.mobility import inverse_kinematics
from symscrew.optimisation.consistent_poses import Kinematics
from symscrew.optimisation.guess import default_parameters
from symscrew.optimisation.motion_coordinates import bounded, coordinate
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions, TrajectoryProblem
from symscrew.optimisation.problem_file import parse_problem
from symscrew.optimisation.solution import prepare, solve

RAD = math.radians
CASES = [
    ("planar_3rrr", {"x": 0.02, "platform.y": -0.03, "yaw": RAD(12)}),
    ("planar_3rrr", {"rz": RAD(-7), "platform.x": 0.01, "limb1_R1": 0.1}),
    *(
        pytest.param(name, given, marks=pytest.mark.slow)
        for name, given in [
            ("three_ups_upu_s", {"tilt": RAD(12), "azimuth": RAD(130)}),
            ("three_ups_upu_s", {"tilt": 0.0}),
            ("three_ups_upu_s", {"rx": RAD(9), "ry": RAD(-30)}),
            ("three_ups_upu_s", {"roll": RAD(9), "platform.pitch": RAD(-5)}),
            ("three_ups_upu_s", {"qx": 0.05, "limb5_S.ry": 0.03}),
            ("delta", {"z": -0.02, "x": 0.01, "rod1a.y": 0.005}),
        ]
    ),
]


@cache
def point_model(name: str) -> PointModel:
    return prepare(TrajectoryProblem(model(name).mechanism, ())).model


@pytest.mark.parametrize(("name", "given"), CASES)
def test_the_same_place_as_mobility_finds(name: str, given: dict[str, float]) -> None:
    """And every coordinate that has a name has the same value there, the platform's rotations in all their forms."""
    own = point_model(name)
    kinematics = Kinematics(own, default_parameters(own))
    placed = kinematics.place(Conditions(coordinates=given), "the end", own.system.reference)
    expected = inverse_kinematics(model(name).mechanism, given)
    assert placed.reached and expected.ok, (placed, expected)
    np.testing.assert_allclose(placed.q, expected.q, atol=1e-8)
    at = MotionQuantities(own, blocks := point_symbols(own, moving=False))
    names = [n for n in expected.values if not n.startswith("platform_pose.r")]
    wanted = dict(expected.values)
    for n in [n for n in names if n.endswith("_S.rx")]:  # of ball joints the quaternions as well
        vector = np.array([wanted[f"{n[:-1]}{c}"] for c in "xyz"])
        size = max(float(np.linalg.norm(vector)), 1e-300)
        wanted |= {f"{n[:-2]}q{c}": math.sin(size / 2) / size * x for c, x in zip("xyz", vector, strict=True)}
    names = list(wanted) if len(wanted) > len(expected.values) else names
    values = ca.vertcat(*[coordinate(at, n) for n in names])
    layout = own.equations.layout
    q = [placed.q[list(part)] for part in (layout.y, layout.z)]
    found = np.array(ca.Function("all", [blocks["y"], blocks["z"]], [values])(*q)).ravel()
    upright = expected.values.get("platform.tilt", 1.0) < 1e-6  # then every azimuth is as good
    for n, a in zip(names, found, strict=True):
        if not (upright and n.endswith(".azimuth")):
            assert a == pytest.approx(wanted[n], abs=1e-8), n


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, 0.6435, 0.65, 2.0, 3.0])
def test_rotation_vectors_at_every_angle(angle: float) -> None:
    """Where the series takes over from the arc sine nothing jumps; with a slope where there is no angle, too."""
    from symscrew.optimisation.motion_coordinates import _rotation_vector

    turn = ca.SX.sym("turn", 3, 3)
    vector = ca.vertcat(*_rotation_vector([[turn[i, k] for k in range(3)] for i in range(3)]))
    function = ca.Function("vector", [turn], [vector, ca.jacobian(vector, ca.vec(turn))])
    axis = np.array([0.6, 0.0, -0.8])
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    rotation = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    found, slope = function(rotation)
    np.testing.assert_allclose(np.array(found).ravel(), angle * axis, atol=1e-14 if angle < 2 else 1e-12)
    assert np.isfinite(np.array(slope)).all()


def test_bounds_of_a_tilt_are_smooth_and_the_same() -> None:
    own = point_model("planar_3rrr")
    at = MotionQuantities(own, point_symbols(own, moving=False))
    for low, high in [(0.0, 0.2), (-0.2, 0.2), (0.1, 3.0), (0.3, 4.0)]:
        _, risen, size = bounded(at, "tilt", (low, high))
        least, most = risen((low, high))
        inside = [tilt for tilt in np.linspace(0, math.pi, 500) if least <= 1 - math.cos(tilt) <= most]
        assert min(inside) == pytest.approx(max(low, 0.0), abs=0.01) and size is not None and size > 0
        assert max(inside) == pytest.approx(min(high, math.pi), abs=0.01)
    for name in ("azimuth", "turn"):
        with pytest.raises(DescriptionError, match=f"{name} cannot be bounded"):
            bounded(at, name, (0.0, 1.0))


def problem(text: str) -> TrajectoryProblem:
    return parse_problem(f'[problem]\nmechanism = "planar_3rrr"\nduration = 1\n{text}')


def test_files_take_the_names_with_units() -> None:
    found = problem(
        '[start]\ncoordinates = { x = "20mm", platform.yaw = "30deg", limb1_R1 = 40 }\n'
        '[end]\ncoordinates = { turn = "90deg about 0,0,2", platform = { y = "1 cm" } }\n'
        '[bounds]\njoints = { yaw = "45deg", platform.x = ["-5cm", 0.1] }\nspeeds = { limb1_R1 = "90deg/s" }'
    )
    assert found.start.coordinates == pytest.approx({"x": 0.02, "platform.yaw": RAD(30), "limb1_R1": 40.0})
    end = found.end.coordinates
    assert end["platform.rz"] == pytest.approx(RAD(90)) and end["platform.y"] == pytest.approx(0.01)
    assert found.bounds.joints == {"yaw": pytest.approx((-RAD(45), RAD(45))), "platform.x": (-0.05, 0.1)}
    assert found.bounds.speeds["limb1_R1"] == pytest.approx((-RAD(90), RAD(90)))
    assert [n for n in found.notices if "40 are 2292 degrees; 40deg are 40 degrees" in n] and len(found.notices) == 1


@pytest.mark.parametrize(("given", "said"), [
    ('coordinates = { x = "20deg" }', r"start.coordinates.x: expected a length \[m, mm\]"),
    ('coordinates = { yaww = 1 }', "unknown name 'yaww'; did you mean 'yaw'"),
    ('coordinates = { "platform x" = 1 }', "did you mean 'platform.x'"),
    ('coordinates = { x = 1, platform.x = 2 }', "x and platform.x are the same coordinate; leave one out"),
    ('coordinates = { azimuth = 1 }', "give the tilt too"),
    ('coordinates = { tilt = 4 }', "tilt: expected less than half a turn"),
    ('coordinates = { turn = "30deg" }', "expected an angle about an axis such as '30deg about 1,1,0'"),
])  # fmt: skip
def test_what_cannot_be_meant_is_said(given: str, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        prepare(problem(f"[start]\n{given}"))


@pytest.mark.slow
def test_a_bounded_tilt_is_kept_along_the_motion() -> None:
    """From 8 degrees one way to 8 degrees the other way round, never upright and never above 9."""
    folder = Path(__file__).parent
    text = (
        '[problem]\nmechanism = "three_ups_upu_s"\nduration = 1\n'
        '[start]\ncoordinates = { tilt = "8deg" }\nat_rest = true\n'
        '[end]\ncoordinates = { tilt = "8deg", azimuth = "120deg" }\nat_rest = true\n'
        '[bounds]\njoints = { tilt = ["6deg", "9deg"], rx = "30deg" }\n[transcription]\nintervals = 10\n'
    )
    found = solve(parse_problem(text, folder=folder))
    assert found.ok, found.status
    y = found.arrays["y"]
    turns = 2 * np.arcsin(np.linalg.norm(y, axis=1))  # entries of a quaternion about axes in the plane: the tilt
    assert RAD(6) - 1e-6 < turns.min() < RAD(7) and turns.max() < RAD(9) + 1e-6

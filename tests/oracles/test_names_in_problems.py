"""Coordinates of problems by the names that `--at` takes: what the optimiser makes of them, against mobility's poses.

Configurations are placed by the optimiser's own equations in CasADi, and by the 60-digit assembly of mobility analysis:
two routes, which share the names and the definition of a pose, and no equation.
"""

from __future__ import annotations

import math
from dataclasses import replace
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
from symscrew.optimisation.motion_coordinates import bounded, coordinate, coordinate_rate
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions, TrajectoryProblem
from symscrew.optimisation.problem_file import parse_problem
from symscrew.optimisation.solution import prepare, solve
from symscrew.scene import parse_scene
from symscrew.simulation.initial import initial_state

pytestmark = pytest.mark.slow

RAD = math.radians
CASES = [
    ("planar_3rrr", {"x": 0.02, "platform.y": -0.03, "yaw": RAD(12)}),
    ("planar_3rrr", {"rz": RAD(-7), "platform.x": 0.01, "limb1_R1": 0.1}),
    *(
        pytest.param(name, given, marks=pytest.mark.slow)
        for name, given in [
            ("three_ups_upu_s", {"tilt": RAD(12), "azimuth": RAD(130)}),
            ("three_ups_upu_s", {"tilt": 0.0}),
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


def test_rates_of_poses_are_those_of_the_configurations_that_follow() -> None:
    """Central differences of what mobility analysis assembles, of every part that has a rate."""
    given, step = {"x": 0.02, "platform.y": -0.03, "yaw": RAD(12)}, 1e-5
    rates = {"x": 0.4, "platform.y": -0.1, "yaw": 2.0}
    own = point_model("planar_3rrr")
    at = MotionQuantities(own, blocks := point_symbols(own, moving=True))
    names = ["x", "y", "z", "rx", "rz", "roll", "yaw", "torsion", "qz", "limb2_R1", "limb3_R3"]
    values = ca.vertcat(*[coordinate_rate(at, name) for name in names])
    layout = own.equations.layout
    before, now, after = (
        inverse_kinematics(model("planar_3rrr").mechanism, {n: given[n] + k * step * rates[n] for n in given})
        for k in (-1, 0, 1)
    )
    y = [c.q[list(layout.y)] for c in (before, now, after)]
    put = [y[1], (y[2] - y[0]) / (2 * step), now.q[list(layout.z)]]
    found = np.array(ca.Function("rates", [blocks["y"], blocks["y_1"], blocks["z"]], [values])(*put)).ravel()
    for name, rate in zip(names, found, strict=True):
        if name != "qz":
            full = name if name in now.values else f"platform.{name}"
            assert rate == pytest.approx((after.values[full] - before.values[full]) / (2 * step), abs=1e-7), name
    assert found[names.index("qz")] == pytest.approx(math.cos(RAD(6)), abs=1e-7)  # d sin(yaw / 2), at 2 rad/s


def problem(text: str) -> TrajectoryProblem:
    return parse_problem(f'[problem]\nmechanism = "planar_3rrr"\nduration = 1\n{text}')


def test_files_take_the_names_with_units() -> None:
    found = problem(
        '[start]\ncoordinates = { x = "20mm", platform.yaw = "30deg", limb1_R1 = 40 }\n'
        '[end]\ncoordinates = { turn = "90deg about 0,0,2", platform = { y = "1 cm" } }\n'
        '[bounds]\njoints = { yaw = "45deg", platform.x = ["-5cm", 0.1] }\nspeeds = { limb1_R1 = "90deg/s" }\n'
        '[guess]\nx = ["1cm", 0.02]\nturn = ["9deg about 0,0,1", "18deg about 0,0,1"]'
    )
    assert found.guess["x"] == (0.01, 0.02) and found.guess["platform.rz"] == pytest.approx((RAD(9), RAD(18)))
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
    ('coordinates = { xx = "2mm" }', "start.coordinates: unknown name 'xx'; did you mean 'x'"),
    ('rates = { tilt = 1 }', "start.rates: tilt has no rate here; expected rates of x, y, z"),
    ('rates = { yaww = 1 }', "start.rates: unknown name 'yaww'; did you mean 'yaw'"),
    ('[bounds]\nspeeds = { azimuth = 1 }', "bounds.speeds: azimuth has no rate here"),
    ('[guess]\nyaww = [1, 2]', "guess, value 1: unknown name 'yaww'|guess: unknown name 'yaww'; did you mean 'yaw'"),
    ('[guess]\nx = [0, 0.1]\ny = [0, 0.1, 0]', "as many values of every coordinate, at least two; got x 2, y 3"),
    ('coordinates = { turn = "30deg" }', "expected an angle about an axis such as '30deg about 1,1,0'"),
])  # fmt: skip
def test_what_cannot_be_meant_is_said(given: str, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        prepare(problem(given if given.startswith("[") else f"[start]\n{given}"))


MOVED = """[start]
coordinates = { x = 0, y = 0, rz = 0 }
at_rest = true
[end]
coordinates = { x = "30mm", y = "10mm", yaw = "5deg" }
rates = { x = "2cm/s", y = 0, platform.rz = "10deg/s" }
[bounds]
speeds = { yaw = "8deg/s", x = "0.2m/s" }
[transcription]
intervals = 5
degree = 2
[guess]
x = [0, "10mm", "30mm"]
"""


@pytest.mark.parametrize("independent", [pytest.param("", marks=pytest.mark.slow), '["platform.x", "y", "rz"]'])
def test_rates_guesses_and_independent_coordinates_by_names_of_poses(independent: str) -> None:
    """The end is reached at its rates; the same motion by drives and by the platform's coordinates as unknowns."""
    text = MOVED.replace('"8deg/s"', '"12deg/s"')
    made = problem(f"independent = {independent}\n{text}" if independent else text)
    found = solve(replace(made, accuracy=None))
    assert found.solved, found.status
    labels = ("limb1_R1", "limb2_R1", "limb3_R1") if not independent else tuple(f"platform_pose.{k}" for k in range(3))
    assert found.model.equations.labels == labels
    y, at = found.arrays["y"], [inverse_kinematics(made.mechanism, given) for given in (
        {"x": 0.03 - 0.02e-5, "y": 0.01, "yaw": RAD(5 - 10e-5)}, {"x": 0.03, "y": 0.01, "yaw": RAD(5)},
    )]  # fmt: skip
    entries = list(found.model.equations.layout.y)
    slope = (at[1].q - at[0].q)[entries] / 1e-5
    np.testing.assert_allclose(y[-1], at[1].q[entries], atol=1e-8)
    np.testing.assert_allclose(found.arrays["y_1"][-1] / found.duration, slope, atol=1e-5)


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


STARTS = [
    ("planar_3rrr", {"x": 0.02, "y": -0.03, "yaw": RAD(12)}, {"limb2_R3": 0.4, "platform.x": -0.1, "torsion": 2.0}),
    ("three_ups_upu_s", {"tilt": 0.1, "azimuth": 0.4}, {"tilt": 0.3, "azimuth": -1.0}),
]


@pytest.mark.parametrize(("name", "given", "rates"), STARTS)
def test_a_scene_starts_at_rates_of_any_names(name: str, given: dict[str, float], rates: dict[str, float]) -> None:
    """Every named coordinate then changes at its rate: by central differences of configurations along the motion."""
    made, step = model(name), 1e-6
    text = f'[scene]\nmechanism = "{name}"\nduration = 1\n'
    scene = parse_scene(text)
    scene = replace(scene, initial=replace(scene.initial, coordinates=given, rates=rates))
    q, v = initial_state(scene, made, made.system.parameter_values)
    at = made.system.inputs
    turned = np.asarray(made.system.numeric(made.system.joint_rates(at.v), (at.q, q[None]), (at.v, v[None])))
    placed = []
    for sign in (-1, 1):
        moved = made.system.advance(q[None], sign * step * turned)[0]
        tree = {c.label: float(x) for c, x in zip(made.system.tree.q, moved, strict=True)}
        own = made.programs["assemble"].inputs[0].labels if "assemble" in made.programs else ()
        free = {label: tree[label] for label in own if not label.endswith(".qw")}
        placed.append(inverse_kinematics(made.mechanism, free))
    assert all(one.ok for one in placed), placed
    for typed, rate in rates.items():
        full = typed if typed in placed[0].values else f"{made.mechanism.platform}.{typed}"
        slope = (placed[1].values[full] - placed[0].values[full]) / (2 * step)
        assert slope == pytest.approx(rate, abs=1e-6), typed


def test_rates_that_a_scene_cannot_have_are_said() -> None:
    for text, said in (
        ("yaww = 1", "no 'yaww'; did you mean 'yaw'"), ("tilt = 1", "tilt has no rate here"),
        ("z = 1", "the loops do not allow z = 1"), ('x = "1deg/s"', "expected a value in m/s"),
    ):  # fmt: skip
        with pytest.raises(DescriptionError, match=said):
            scene = parse_scene(f'[scene]\nmechanism = "planar_3rrr"\nduration = 1\n[initial]\nrates = {{ {text} }}')
            initial_state(scene, model("planar_3rrr"), np.zeros(0))

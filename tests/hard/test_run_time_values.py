"""Run-time parameters at values that the description does not have: a run is that of a description with these numbers,
or is refused as that one is."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.marks import slow

from symscrew.description import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import Effect, effect_from_table
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.scene import parse_scene
from symscrew.scene.contents import Initial, Scene
from symscrew.simulation import simulate, simulate_many
from symscrew.simulation.motion import Run

pytestmark = pytest.mark.slow

Values = Mapping[str, tuple[Any, Any]]
"""Parameter -> its value in the description, and in the run."""
GRAVITY = {"type": "gravity", "acceleration": [0, 0, "-9.81"]}
INERTIA = [["1/10", 0, 0], [0, "1/8", 0], [0, 0, "1/6"]]


def started(name: str, values: Values, *, run_time: bool, platform: str | None = None) -> MechanismBuilder:
    builder = MechanismBuilder(name, platform=platform)
    for parameter, (described, run) in values.items():
        builder.parameter(parameter, described if run_time else run, run_time=run_time)
    return builder


def arm(values: Values, *, run_time: bool, **body: Any) -> Mechanism:
    """A pendulum about y."""
    builder = started("arm", values, run_time=run_time)
    builder.body("arm", **{"mass": 1, "com": [0, 0, "-1/2"], "inertia": INERTIA, **body})
    builder.joint("A", "R", parent="base", child="arm", point=[0, 0, 0], axes=[[0, 1, 0]])
    builder.point("tip", body="arm", at=[0, 0, -1]).point("road", body="base", at=[0, 0, "-21/20"])
    return builder.build()


def swung(mechanism: Mechanism, tables: list[dict[str, Any]], values: Values, *, run_time: bool) -> Run:
    effects = tuple(effect_from_table(table) for table in (GRAVITY, *tables))
    chosen = {name: float(run) for name, (_, run) in values.items()} if run_time else {}
    start = Initial({"A": 0.3})
    return simulate(Scene("swung", mechanism, effects, 0.02, 100.0, start, parameters=chosen), backend="numpy")


STATES = {
    "current": {
        "type": "dc_motor", "joint": "A", "torque_constant": 1, "resistance": 1, "inductance": 1, "current": "P",
    },
    "play": {"type": "backlash", "joint": "A", "play": 1, "stiffness": 9, "inertia": 1, "initial": "P"},
    "roll": {
        "type": "rolling_contact", "wheel": "tip", "ground": "road", "radius": "1/10", "stiffness": 9, "grip": 9,
        "grip_damping": 1, "initial": ["P", 0],
    },
}  # fmt: skip


@pytest.mark.parametrize("which", STATES)
def test_states_begin_where_the_run_says(which: str) -> None:
    """They began where the description's value put them, completed."""
    values = {"P": (0, 0.25)}
    runs = [swung(arm(values, run_time=r), [STATES[which]], values, run_time=r) for r in (True, False)]
    assert 0.25 in runs[0].x[0]
    for one, other in zip((runs[0].q, runs[0].x), (runs[1].q, runs[1].x), strict=True):
        assert np.abs(one - other).max() < 1e-9


REFUSED = {
    "stiffness: expected a number at least 0, got 'P', which is -3": {
        "type": "joint_spring", "joint": "A", "stiffness": "P",
    },
    "mass above 0 kg": {"type": "payload", "body": "arm", "mass": "P", "com": [0, 0, -1]},
    "inductance: expected a number above 0": {
        "type": "dc_motor", "joint": "A", "torque_constant": 1, "resistance": 1, "inductance": "P",
    },
    "expected lower < upper, got 0 and -3": {
        "type": "end_stop", "joint": "A", "lower": 0, "upper": "P", "stiffness": 9,
    },
    "expected a restitution from 0 to 1": {
        "type": "end_stop", "joint": "A", "lower": 0, "mode": "impact", "restitution": "P/2",
    },
    "expected static >= coulomb": {
        "type": "dry_friction", "joint": "A", "coulomb": "1/2 - P/9", "static": "1/2", "mode": "event",
    },
    "limit: expected a number above -2": {
        "type": "position_servo", "joint": "A", "stiffness": 1, "limit": "P", "lowest": -2,
    },
    "axis other than 0": {
        "type": "joint_clearance", "hole": "road", "pin": "tip", "axis": ["P + 3", 0, 0], "clearance": "1/100",
        "stiffness": 9,
    },
}  # fmt: skip


@pytest.mark.parametrize("text", REFUSED)
def test_what_an_effect_refuses_it_refuses_at_the_values_of_a_run(text: str) -> None:
    """A spring of -3 N m/rad, a payload of -3 kg, an end below the other: each ran, and completed."""
    values = {"P": (1, -3)}
    for run_time in (True, False):
        with pytest.raises(DescriptionError, match=text.replace("(", r"\(")):
            swung(arm(values, run_time=run_time), [REFUSED[text]], values, run_time=run_time)


def test_a_body_has_no_inertia_below_zero() -> None:
    values = {"P": (1, -3)}
    for key, given in (("mass", "P"), ("inertia", [["P", 0, 0], [0, 1, 0], [0, 0, 1]])):
        with pytest.raises(DescriptionError, match=f"bodies.arm.{key}: expected"):
            swung(arm(values, run_time=True, **{key: given}), [], values, run_time=True)


def test_nor_in_one_of_many_runs() -> None:
    spring = effect_from_table({"type": "joint_spring", "joint": "A", "stiffness": "P"})
    scene = Scene("swung", arm({"P": (1, 1)}, run_time=True), (spring,), 0.1, 20.0)
    runs = simulate_many(scene, {"parameters.P": np.array([2.0, -3.0])})
    assert runs.ok.tolist() == [True, False]
    assert "which is -3" in runs.status[1]


def test_one_without_accelerations_does_not_end_the_others() -> None:
    """Contacts asked for what forces do where there is nothing that moves: an error of NumPy ended all runs."""
    values: Values = {"P": (1, 1)}
    massless = arm(values, run_time=True, mass="P", inertia=[["P", 0, 0], [0, "P", 0], [0, 0, "P"]])
    stop = {"type": "end_stop", "joint": "A", "lower": 0, "mode": "impact"}
    rough = {"type": "dry_friction", "joint": "A", "coulomb": "P", "mode": "event"}
    effects = tuple(effect_from_table(table) for table in (GRAVITY, stop, rough))
    runs = simulate_many(Scene("s", massless, effects, 0.1, 20.0), {"parameters.P": np.array([1.0, 0.0])})
    assert runs.ok.tolist() == [True, False]
    assert runs.status[1].startswith("stopped at t = 0 s: the accelerations are not defined")


SIZED = {"A": (0, 0), "B": (0, "7/10"), "C": ("3/2", "3/2"), "D": (2, 0)}
"""A crank-rocker; all lengths are times P."""


def crank_rocker(values: Values, *, run_time: bool) -> Mechanism:
    builder = started("sized", values, run_time=run_time)
    for body, com in (("crank", (0, "1/3")), ("coupler", ("4/5", 1)), ("follower", ("7/4", "3/4"))):
        turning = [["P^2/9" if i == j else 0 for i in range(3)] for j in range(3)]
        builder.body(body, mass=1, com=[f"{x}*P" for x in com] + [0], inertia=turning)
    ends = (("base", "crank"), ("crank", "coupler"), ("coupler", "follower"), ("base", "follower"))
    for (joint, place), (parent, child) in zip(SIZED.items(), ends, strict=True):
        point = [f"{x}*P" for x in place] + [0]
        builder.joint(joint, "R", parent=parent, child=child, point=point, axes=[[0, 0, 1]])
    return builder.build()


def sized(described: float, size: float, *, run_time: bool) -> Scene:
    spring = effect_from_table({"type": "joint_spring", "joint": "C", "stiffness": "3*P^2"})
    mechanism = crank_rocker({"P": (described, size)}, run_time=run_time)
    start = Initial({"A": 0.3}, {"A": 4.0})
    return Scene("s", mechanism, (spring,), 0.2, 10.0, start, parameters={"P": size} if run_time else {})


@pytest.mark.parametrize("size", [1e-3, slow(1e5)])
def test_a_run_may_be_of_any_size_beside_its_description(size: float) -> None:
    """Lengths in mm beside those in m: pivots counted for none, or the loops could not be closed at the start."""
    runs = [simulate(sized(1.0, size, run_time=r)) for r in (True, False)]
    assert runs[0].accurate
    assert np.abs(runs[0].q - runs[1].q).max() < 1e-12
    assert np.ptp(runs[0].q[:, 0]) > 0.5


def test_one_of_many_runs_is_told_that_it_is_of_another_size() -> None:
    """They share what was derived for the scene's own values."""
    runs = simulate_many(sized(1.0, 1.0, run_time=True), {"parameters.P": np.array([1.0, 0.3, 1e-3])})
    assert runs.ok.tolist() == [True, True, False]
    assert "the parameters make sized 0.001 times as large as what it was derived for" in runs.status[2]
    scene = sized(1.0, 1e-3, run_time=True)
    assert simulate_many(scene, {"parameters.P": np.array([2e-3])}).all_ok


def test_what_decides_the_code_is_no_run_time_parameter() -> None:
    stop = {"type": "end_stop", "joint": "A", "lower": 0, "stiffness": 9, "exponent": "P"}
    with pytest.raises(DescriptionError, match="exponent: expected a number that is known when the code is written"):
        derive(arm({"P": (1, 2)}, run_time=True), [effect_from_table(stop)])


def spatial(values: Values, *, run_time: bool) -> Mechanism:
    """Three bodies whose axes and offsets leave their special places with the parameters."""
    builder = started("spatial", values, run_time=run_time)
    builder.body("a", mass=1, com=["P", 0, "1/2"], inertia=INERTIA)
    builder.body("b", mass=1, com=["P", "R", "3/2"], inertia=INERTIA)
    builder.body("c", mass="1/2", com=[0, "R", 2], inertia=INERTIA)
    builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 1, 0]])
    builder.joint("B", "R", parent="a", child="b", point=["P", "R", 1], axes=[["sin(S)", "cos(S)", 0]])
    builder.joint("C", "S", parent="b", child="c", point=[0, "P", 2])
    return builder.build()


def plane(values: Values, *, run_time: bool) -> Mechanism:
    """A plate on three legs of hinges, in a plane that turns about y with a parameter."""
    builder = started("plane", values, run_time=run_time, platform="plate")
    builder.body("plate", mass=2, com=[2, 2, 0], inertia=INERTIA)
    corners = ([0, 0], [1, 1], [2, 1]), ([5, 0], [4, 2], [3, 1]), ([2, 6], [3, 5], ["5/2", 3])
    for k, places in enumerate(corners):
        for body in (f"a{k}", f"b{k}"):
            builder.body(body, mass=1, com=[2, 2, 0], inertia=INERTIA)
        ends = ("base", f"a{k}", f"b{k}", "plate")
        for i, (x, y) in enumerate(places):
            point, axis = [f"({x})*cos(S)", y, f"-({x})*sin(S)"], ["sin(S)", 0, "cos(S)"]
            builder.joint(f"J{k}{i}", "R", parent=ends[i], child=ends[i + 1], point=point, axes=[axis])
    return builder.build()


def accelerations(found: Model, states: tuple[np.ndarray, ...], values: np.ndarray) -> np.ndarray:
    known = dict(zip("qv", states, strict=False)) | {"p": np.repeat(values[None], len(states[0]), 0)}
    program = found.programs["forward_dynamics"]
    arrays = [known.get(port.name, np.zeros((len(states[0]), port.size))) for port in program.inputs]
    (a, *_), status = found("forward_dynamics", *arrays)
    assert (status <= 0).all()
    given = [k for k, c in enumerate(found.system.tree.v) if c.joint in found.mechanism.joints]
    return np.asarray(a)[:, given]  # which way a hub's x points is the model's own choice


@pytest.mark.parametrize("made", [spatial, slow(plane)])
def test_zeros_of_the_description_are_no_zeros_of_a_run(made: Any) -> None:
    """The frame of a link on the axis (sin S, cos S, 0) took a component for zero that is so at S = 0 only; a hub in a
    plane kept the description's plane."""
    values: Values = {"P": (0, "1/7"), "R": (0, "-1/5"), "S": (0, "3/10")}
    effects: list[Effect] = [effect_from_table(GRAVITY)]
    numbers = derive(made(values, run_time=False), effects)
    states = numbers.system.sample_states
    expected = accelerations(numbers, states, np.zeros(0))
    got = accelerations(derive(made(values, run_time=True), effects), states, np.array([1 / 7, -1 / 5, 3 / 10]))
    assert np.abs(got - expected).max() < 1e-10 * np.abs(expected).max()


def test_a_box_of_fluid_drag_turns_with_its_parameters() -> None:
    values: Values = {"P": (0, 0.5)}
    drag = {
        "type": "fluid_drag", "body": "arm", "sides": [1, "1/2", "1/5"], "density": 2,
        "axes": [["P", 1, 0], [-1, "P", 0], [0, 0, 1]],
    }  # fmt: skip
    runs = [swung(arm(values, run_time=r), [drag], values, run_time=r) for r in (True, False)]
    assert np.abs(runs[0].q - runs[1].q).max() < 1e-9


def test_the_ground_of_a_wheel_may_turn_with_a_parameter() -> None:
    """Its size was looked at with the states of the tape taken away, which ended in a KeyError."""
    values: Values = {"P": (0, 0.3)}
    wheel = {**STATES["roll"], "axis": ["sin(P)", "cos(P)", 0], "normal": ["sin(P)", 0, "cos(P)"], "initial": [0, 0]}
    runs = [swung(arm(values, run_time=r), [wheel], values, run_time=r) for r in (True, False)]
    assert np.abs(runs[0].q - runs[1].q).max() < 1e-9


def test_a_run_begins_at_its_own_reference() -> None:
    """Coordinates of the reference configuration may be parameters: it began at the description's, another pose."""
    values: Values = {"P": (0, "1/3"), "R": (0, "1/5")}
    ends = []
    for run_time in (True, False):
        builder = started("slide", values, run_time=run_time)
        builder.body("a", mass=1, com=[0, 0, "1/2"], inertia=INERTIA)
        builder.body("b", mass=1, com=["1/2", 0, 1], inertia=INERTIA)
        builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 1, 0]], reference="P")
        builder.joint("B", "P", parent="a", child="b", point=[0, 0, 1], axes=[[1, 0, 0]], reference="R")
        chosen = {"P": 1 / 3, "R": 1 / 5} if run_time else {}
        scene = Scene("slide", builder.build(), (effect_from_table(GRAVITY),), 0.2, 10.0, parameters=chosen)
        ends.append(simulate(scene, backend="numpy").q)
    assert ends[0][0] == pytest.approx([1 / 3, 1 / 5])
    assert np.abs(ends[0] - ends[1]).max() < 1e-12


def test_frames_that_are_none_at_the_values_of_a_run_are_named() -> None:
    """Axes that are parallel at S = 0 alone, by which the frame of a loop's link was chosen: it ended in an error of
    NumPy's, deep within."""
    builder = started("bent", {"S": ("1/10", 0)}, run_time=True)
    for body, com in (("a", [0, 0, "1/2"]), ("b", ["1/2", 0, "1/2"]), ("c", [1, 0, "1/2"])):
        builder.body(body, mass=1, com=com, inertia=INERTIA)
    tilted, y = ["sin(S)", "cos(S)", 0], [0, 1, 0]
    joints = (("base", "a", [0, 0, 0], y), ("a", "b", [0, 0, 1], tilted), ("b", "c", ["3/2", 0, "5/4"], y))
    for k, (parent, child, point, axis) in enumerate((*joints, ("base", "c", [1, 0, 0], y))):
        builder.joint(f"J{k}", "R", parent=parent, child=child, point=point, axes=[axis])
    scene = Scene("bent", builder.build(), (effect_from_table(GRAVITY),), 0.1, 20.0, parameters={"S": 0.0})
    with pytest.raises(DescriptionError, match="at S = 0 a direction vanishes that the frames of bent stand on"):
        simulate(scene)


@pytest.mark.parametrize(("given", "reach"), [("'200 mm'", 0.2), ("'0.2 m'", 0.2), ("'2*reach'", 0.3), ("200", None)])
def test_a_parameter_in_millimetres_takes_no_bare_number(given: str, reach: float | None, tmp_path: Path) -> None:
    """200 beside a description's 150 mm was 200 m, completed; 30 beside its 10 deg 30 rad."""
    text = '[mechanism]\nname = "arm"\nground = "base"\n[parameters.reach]\nvalue = 150\nunit = "mm"\nrun_time = true\n'
    text += '[bodies.arm]\nmass = 1\ncom = ["reach", 0, 0]\n[joints.A]\ntype = "R"\nparent = "base"\nchild = "arm"\n'
    (tmp_path / "arm.toml").write_text(text + "point = [0, 0, 0]\naxes = [[0, 1, 0]]\n")
    scene = f'[scene]\nname = "s"\nmechanism = "arm.toml"\nduration = 1\n[parameters]\nreach = {given}\n'
    if reach is None:
        with pytest.raises(DescriptionError, match=r"reach: expected a number with its unit.*'200 mm', or one in m"):
            parse_scene(scene, folder=tmp_path)
    else:
        assert parse_scene(scene, folder=tmp_path).parameters == {"reach": pytest.approx(reach)}


def test_what_an_effect_says_of_a_motion_is_of_the_values_of_the_run() -> None:
    """A rod of 2 N m^2 in the description and 1/50 in the run: its buckling load was that of the former."""
    said = []
    for run_time in (True, False):
        values: Values = {"E": (2, "1/50")}
        builder = started("rod", values, run_time=run_time)
        builder.body("rod", mass=2, com=["1/2", 0, 0], inertia=[["1/10", 0, 0], [0, "1/2", 0], [0, 0, "1/2"]])
        builder.joint("A", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 0, 1]])
        builder.point("near", body="rod", at=[0, 0, 0]).point("far", body="rod", at=[1, 0, 0])
        bends = {"type": "flexible_link", "start": "near", "end": "far", "axis": [0, 0, 1], "line_density": "1/2"}
        bends |= {"bending_stiffness": "E", "modes": 1}
        chosen = {"E": 0.02} if run_time else {}
        start = Initial(rates={"A": 3.0})
        scene = Scene("rod", builder.build(), (effect_from_table(bends),), 0.02, 100.0, start, parameters=chosen)
        said.append(simulate(scene, backend="numpy").events)
    assert said[0] == said[1]
    assert "of its buckling load" in said[0][0]

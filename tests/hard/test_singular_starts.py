"""Rates at a singular start: those of a branch are taken, what belongs to none is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy
from support.four_bars_in_a_row import n_four_bar
from support.marks import slow

from symscrew.catalogue import load as load_catalogue
from symscrew.description import MechanismBuilder, parse_description, to_toml
from symscrew.description.toml_tables import from_file
from symscrew.errors import DescriptionError
from symscrew.fmu import build_unit
from symscrew.functions.forward import MASSLESS_NOTE, SINGULAR_NOTE, left_out
from symscrew.kinematics import System
from symscrew.model import Model, derive
from symscrew.runtime import find_compiler
from symscrew.scene import Integrator, Scene, load_scene, parse_scene
from symscrew.simulation import fine_start, prepare, simulate
from symscrew.simulation.initial import initial_state
from symscrew.simulation.native import integrate_natively
from symscrew.simulation.recording import shown_time
from symscrew.simulation.scene_functions import PlantFunctions, RunError
from symscrew.simulation.start_branch import leaves_every_branch
from symscrew.simulation.state_programs import Plant

SQUARE = """
[scene]
mechanism = "four_bar"
duration = 1
"""


@pytest.fixture(scope="module")
def row() -> Model:
    """Two square four-bars in a row, whose flat positions are singular."""
    return derive(n_four_bar(2), [])


def started(model: Model, angle: float, rates: dict[str, float]) -> np.ndarray:
    """Rates at the start with the cranks at an angle."""
    scene = parse_scene(SQUARE)
    initial = replace(scene.initial, coordinates={"A0": angle}, rates=rates)
    _, v = initial_state(replace(scene, mechanism=model.mechanism, initial=initial), model, np.zeros(0))
    labels = [c.label for c in model.system.tree.v]
    return np.array([v[labels.index(name)] for name in labels])


@pytest.mark.parametrize("rate", [-4.8877397639399747404, 1e-3, 30.0])
def test_rates_of_no_branch_are_refused(row: Model, rate: float) -> None:
    with pytest.raises(DescriptionError, match=r"branches of the motion meet, and A0 = .* belongs to none of them"):
        started(row, -np.pi / 2, {"A0": rate})


@pytest.mark.parametrize("rate", [-4.8877397639399747404, 1e-3])
def test_rates_of_a_branch_are_taken_and_zero_rates_too(row: Model, rate: float) -> None:
    """All cranks turn alike: the branch on which the couplers stay level."""
    labels = [c.label for c in row.system.tree.v]
    wanted = {name: rate if name[0] == "A" else -rate for name in labels if name[0] in "AB"}
    given = started(row, -np.pi / 2, wanted)
    assert given == pytest.approx([wanted.get(n, given[labels.index(n)]) for n in labels], abs=1e-12 * abs(rate))
    assert not started(row, -np.pi / 2, {}).any()


@pytest.mark.parametrize("angle", [-np.pi / 2 + 1e-3, -1.0, 0.5])
def test_one_rate_is_enough_beside_a_singular_position(row: Model, angle: float) -> None:
    labels = [c.label for c in row.system.tree.v]
    found = dict(zip(labels, started(row, angle, {"A0": 2.0}), strict=True))
    assert all(found[name] == pytest.approx(2.0) for name in labels if name[0] == "A")


@pytest.mark.parametrize("beside", [1e-4, -1e-7, 1e-9, 1e-10])
def test_one_rate_is_enough_as_near_as_the_others_follow(row: Model, beside: float) -> None:
    """In doubles alone the others follow to rounding over the distance: 3e-8 at 1e-7, and no motion at 1e-9."""
    labels = [c.label for c in row.system.tree.v]
    found = dict(zip(labels, started(row, beside - np.pi / 2, {"A0": 3.0}), strict=True))
    assert all(found[name] == pytest.approx(3.0, rel=1e-15) for name in labels if name[0] == "A")


@pytest.fixture(scope="module")
def equal_slider() -> Model:
    """A slider-crank with a crank as long as its rod, along a line that is turned by 0.3 rad: s = 2 cos A - 2."""
    c, s = sympy.cos(sympy.Rational(3, 10)), sympy.sin(sympy.Rational(3, 10))
    builder = MechanismBuilder("equal")
    for k, name in enumerate(("crank", "rod", "block")):
        x = sympy.Rational(min(2 * k + 1, 4), 2)
        builder.body(name, mass=1, com=[x * c, x * s, 0], inertia=[0, 0, "1/12"])
    before = "base"
    for k, (joint, body) in enumerate(zip("ABC", ("crank", "rod", "block"), strict=True)):
        builder.joint(joint, "R", parent=before, child=body, point=[k * c, k * s, 0], axes=[[0, 0, 1]])
        before = body
    builder.joint("D", "P", parent="base", child="block", point=[2 * c, 2 * s, 0], axes=[[c, s, 0]])
    return derive(builder.build(), [])


@pytest.mark.parametrize("beside", [1e-3, -1e-6, 1e-9, -1e-10])
def test_a_crank_as_long_as_its_rod_keeps_its_branch(equal_slider: Model, beside: float) -> None:
    """Loops closed to 1e-13 leave the slider 4e-7 free where the rod may turn with the crank, and its rate free."""
    scene = parse_scene(SQUARE.replace("duration = 1", "duration = 0.1"))
    angle = np.pi / 2 - beside
    initial = replace(scene.initial, coordinates={"A": angle}, rates={"A": 3.0})
    scene = replace(scene, mechanism=equal_slider.mechanism, initial=initial)
    q, v = initial_state(scene, equal_slider, np.zeros(0))
    crank, block = ([c.label for c in equal_slider.system.tree.q].index(name) for name in "AD")
    assert q[block] == pytest.approx(2 * np.cos(angle) - 2, abs=1e-14)
    assert v[block] == pytest.approx(-6 * np.sin(angle), abs=1e-12)
    run = simulate(scene)
    assert run.accurate and np.abs(run.q[:, block] - 2 * np.cos(run.q[:, crank]) + 2).max() < 1e-13


def beside_equal(model: Model, beside: float) -> tuple[Scene, Plant, np.ndarray, np.ndarray]:
    """A scene of the slider-crank that much before its singular position, its programs, and where it starts."""
    scene = parse_scene(SQUARE.replace("duration = 1", "duration = 0.01"))
    initial = replace(scene.initial, coordinates={"A": np.pi / 2 - beside}, rates={"A": 3.0})
    scene = replace(scene, mechanism=model.mechanism, initial=initial)
    _, programs = prepare(scene)
    return scene, programs, *initial_state(scene, model, np.zeros(0))


@pytest.mark.parametrize("beside", [1e-3, -1e-5, 1e-8])
def test_libraries_begin_where_they_were_put(equal_slider: Model, beside: float) -> None:
    """A step onto the loops by what rounding leaves moved the rates by rounding over the distance."""
    _, programs, q, v = beside_equal(equal_slider, beside)
    functions = PlantFunctions(programs, [], compiled=False)
    for kept, given in zip(functions.settled_start(q, v), (q, v), strict=True):
        np.testing.assert_array_equal(kept, given)


@pytest.mark.parametrize(("beside", "found"), [(1e-5, True), (1e-7, True), (-1e-8, False)])
def test_other_names_beside_a_singular_position(equal_slider: Model, beside: float, found: bool) -> None:
    """By a cut joint's name a start is exact, its rates too (in doubles they were off by rounding over the distance:
    1e-9 at 1e-7), or refused for what it is: not 'out of reach'."""
    scene, angle = parse_scene(SQUARE), np.pi / 2 - beside
    initial = replace(scene.initial, coordinates={"C": angle}, rates={"C": 2.0})
    scene = replace(scene, mechanism=equal_slider.mechanism, initial=initial)
    if found:
        q, v = initial_state(scene, equal_slider, np.zeros(0))
        at = [c.label for c in equal_slider.system.tree.q].index("D")
        assert q[at] == pytest.approx(2 * np.cos(angle) - 2, abs=1e-14)
        assert v[at] == pytest.approx(-4 * np.sin(angle), abs=1e-14)
        return
    with pytest.raises(DescriptionError, match=r"or so near a singular configuration .* give other coordinates"):
        initial_state(scene, equal_slider, np.zeros(0))


def test_a_start_off_a_dead_point_says_so(equal_slider: Model) -> None:
    """The slider's place alone, from the stretched reference: two ways lead there, and neither is meant."""
    scene = replace(parse_scene(SQUARE), mechanism=equal_slider.mechanism)
    for given, cure in (({"D": -0.1}, "changes D at first, a dead point: give others"), ({"A": 0.1, "D": 1}, "check")):
        scene = replace(scene, initial=replace(scene.initial, coordinates=given, rates={}))
        with pytest.raises(DescriptionError, match=cure):
            initial_state(scene, equal_slider, np.zeros(0))


@pytest.mark.parametrize(("beside", "taken"), [(0.1, True), (1e-6, False)])
def test_few_digits_beside_a_singular_position_are_refused(equal_slider: Model, beside: float, taken: bool) -> None:
    """Nine digits say where a motion begins, but not beside a singular position: it went on from another place."""
    scene, programs, q, v = beside_equal(equal_slider, beside)
    start = (np.round(q, 9), v, np.zeros(0))
    functions = PlantFunctions(programs, [], compiled=False)
    run = integrate_natively(scene, programs, (*start[:2], np.zeros(len(programs.x_labels))))
    assert run.ok == taken
    if taken:
        assert np.abs(functions.settled_start(*start[:2])[0] - q).max() < 1e-8
    else:
        assert run.status.startswith(
            "stopped at t = 0 s: the start is beside a singular configuration and off the loops"
        )
        with pytest.raises(RunError, match="give coordinates and rates with all digits"):
            functions.settled_start(*start[:2])


@pytest.mark.slow
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler: units have no binary")
@pytest.mark.parametrize("version", [2, 3])
def test_units_begin_as_exactly_and_go_on(equal_slider: Model, tmp_path: Path, version: int) -> None:
    """Their own start took the step that compiled runs do not take; nine digits of q are refused by name."""
    fmpy = pytest.importorskip("fmpy")
    scene, _, q, v = beside_equal(equal_slider, 1e-8)
    unit = tmp_path / "equal.fmu"
    build_unit(replace(scene, name="equal", integrator=Integrator("rk4", step=1e-3)), unit, version=version)
    names = [f"q.{c.label}" for c in equal_slider.system.tree.q] + [f"v.{c.label}" for c in equal_slider.system.tree.v]
    how = {"fmi_type": "CoSimulation", "stop_time": 0.01, "output_interval": 0.001}
    found = fmpy.simulate_fmu(str(unit), output=names, **how)
    assert [found[name][0] for name in names] == [*q, *v]
    assert np.abs(found["q.D"] - 2 * np.cos(found["q.A"]) + 2).max() < 1e-14
    said: list[str] = []
    with pytest.raises(Exception, match=rf"fmi{version}ExitInitializationMode"):
        values = dict(zip(names, [*np.round(q, 9), *v], strict=True))
        fmpy.simulate_fmu(
            str(unit), start_values=values, debug_logging=True, logger=lambda *given: said.append(str(given[-1])), **how
        )
    assert any("give q and v with all digits" in text for text in said)


@pytest.mark.parametrize("parameters", [[], ["rb"]])
def test_balls_turn_in_sixty_digits_as_in_doubles(monkeypatch: pytest.MonkeyPatch, parameters: list[str]) -> None:
    """Where doubles suffice, too, they agree: on balls of the tree, with run-time parameters."""
    model = derive(parse_description(to_toml(load_catalogue("stewart_6ups")), run_time=parameters), [])
    scene = parse_scene(SQUARE)
    given = {"platform_pose.0": 0.05, "platform_pose.1": -0.02}
    initial = replace(scene.initial, coordinates=given, rates={"leg1_P": 0.3})
    scene = replace(scene, mechanism=model.mechanism, initial=initial)
    values = np.array([0.9] * len(parameters))
    q, v = initial_state(scene, model, values)
    monkeypatch.setattr(fine_start, "BESIDE", 2.0)
    fine_q, fine_v = initial_state(scene, model, values)
    assert not np.array_equal(q, fine_q) and np.abs(v).max() > 0.1 and np.abs(q[-3:]).max() > 1e-4
    assert np.abs(q - fine_q).max() < 1e-12 and np.abs(v - fine_v).max() < 1e-12


@pytest.mark.parametrize("beside", [1e-9, slow(1e-5)])
def test_a_run_begins_where_it_was_put_beside_a_singular_position(row: Model, beside: float) -> None:
    """A correction of what rounding leaves open took it 1e-7 away, with the angle that was given: couplers turned."""
    scene = parse_scene(SQUARE.replace("duration = 1", "duration = 0.05"))
    labels = [c.label for c in row.system.tree.q]
    rates = {name: 3.0 if name[0] == "A" else -3.0 for name in labels if name[0] in "AB"}
    initial = replace(scene.initial, coordinates={"A0": beside - np.pi / 2}, rates=rates)
    run = simulate(replace(scene, mechanism=row.mechanism, initial=initial))
    angles = dict(zip(labels, run.q.T, strict=True))
    assert run.accurate and len(run.t) > 3
    assert angles["A0"][0] == beside - np.pi / 2
    for name in labels:
        if name[0] == "A":
            assert np.abs(angles[name] - beside + np.pi / 2 - 3.0 * run.t).max() < 1e-12


def test_a_lost_row_is_one_below_its_threshold() -> None:
    """On either side of `LOST`, and whatever the size of the rates."""
    for speed in (1e-3, 1.0, 1e3):
        bias, rates = np.array([0.0, speed * speed]), np.array([speed, 0.0])
        assert leaves_every_branch(np.diag([1.0, 1e-8]), bias, rates)
        assert not leaves_every_branch(np.diag([1.0, 1e-6]), bias, rates)
        assert not leaves_every_branch(np.diag([1.0, 0.0]), bias * 1e-8, rates)
    assert not leaves_every_branch(np.diag([1.0, 0.0]), np.ones(2), np.zeros(2))


def arm(inertia: list[object], axis: list[object]) -> MechanismBuilder:
    builder = MechanismBuilder("arm").body("a", mass=1, com=[1, 0, 0], inertia=inertia)
    return builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[axis], driven=True)


def test_a_planar_body_may_have_the_moment_about_the_normal_alone() -> None:
    mechanism = arm([0, 0, "1/12"], [0, 0, 1]).build()
    model = derive(mechanism, [])
    (u,), _ = model("inverse_dynamics", np.zeros(1), np.zeros(1), np.ones(1))
    assert u[0] == pytest.approx(1 + 1 / 12, rel=1e-15)
    for wrong in ([0, "1/12", 0], [0, "1/100", "1/12"]):
        with pytest.raises(DescriptionError, match="no body has the principal moments"):
            arm(wrong, [0, 0, 1]).build()
    in_space = arm([0, 0, "1/12"], [0, 0, 1]).body("b", mass=1, com=[1, 0, 0], inertia=[0, 0, 0])
    in_space.joint("B", "R", parent="a", child="b", point=[1, 0, 0], axes=[[1, 0, 0]])
    with pytest.raises(DescriptionError, match="no body has the principal moments"):
        in_space.build()


def test_why_forward_dynamics_is_left_out() -> None:
    """The words about missing inertia only where inertia is missing."""
    assert left_out(System(arm([0, 1, 1], [0, 0, 1]).build())) == SINGULAR_NOTE
    bare = MechanismBuilder("bare").body("a")
    bare.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 0, 1]])
    assert left_out(System(bare.build())) == MASSLESS_NOTE


@pytest.mark.parametrize(
    ("inertia", "effect", "why"),
    [([0, 1, 1], "", "too near to losing rank"), ([0, 0, 0], "", "moves no mass"),
     ([1, 1, 1], "quasi_static", "with quasi_static")],
)  # fmt: skip
def test_why_there_is_nothing_to_simulate(tmp_path: Path, inertia: list[int], effect: str, why: str) -> None:
    builder = MechanismBuilder("arm").body("a", mass=int(any(inertia)), com=[0, 0, 0], inertia=inertia)
    builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    (tmp_path / "arm.toml").write_text(to_toml(builder.build()))
    named = f'[[effects]]\ntype = "{effect}"\n' if effect else ""
    (tmp_path / "scene.toml").write_text(f'[scene]\nmechanism = "arm.toml"\nduration = 1\n{named}')
    with pytest.raises(DescriptionError, match=rf"nothing to simulate: .*{why}"):
        prepare(load_scene(tmp_path / "scene.toml"))


def test_a_step_longer_than_the_time_between_outputs_says_what_it_becomes(tmp_path: Path) -> None:
    text = '[scene]\nmechanism = "four_bar"\nduration = 0.04\nrate = {}\n[integrator]\nmethod = "rk4"\nstep = 0.03\n'
    for rate, said in ((100, True), (25, False)):
        (tmp_path / "scene.toml").write_text(text.format(rate))
        run = simulate(load_scene(tmp_path / "scene.toml"))
        wanted = "the step of 0.03 s is longer than the 0.01 s between two outputs: steps of 0.01 s are taken"
        assert any(event.startswith(wanted) for event in run.events) == said
        assert run.counters["steps"] == (4 if said else 2)


def test_times_of_events_have_all_digits_that_are_meant() -> None:
    assert [shown_time(t) for t in (3.127450400377123, 2.5, 0.1 + 0.2, 1e-3 / 3)] == [
        "3.127450400377", "2.5", "0.3", "0.0003333333333"
    ]  # fmt: skip


def test_an_error_in_a_mechanism_file_names_that_file_once(tmp_path: Path) -> None:
    joint = '{ type = "Q", parent = "base", child = "a", point = [0, 0, 0] }'
    (tmp_path / "wrong.toml").write_text(f'[mechanism]\nname = "w"\n[bodies]\na = {{}}\n[joints]\nA = {joint}\n')
    (tmp_path / "scene.toml").write_text('[scene]\nmechanism = "wrong.toml"\nduration = 1\n')
    with pytest.raises(DescriptionError, match=r"^wrong\.toml: joints\.A"):
        load_scene(tmp_path / "scene.toml")
    (tmp_path / "other.toml").write_text('[scene]\nmechanism = "four_bar"\nduration = -1\n')
    with pytest.raises(DescriptionError, match=r"^other\.toml: scene\.duration"):
        from_file(tmp_path / "other.toml", parse_scene)


def test_a_coordinate_with_the_name_of_a_parameter_is_no_parameter(tmp_path: Path) -> None:
    """Both were taken by name: with an assembly mode a joint L began at 0, and the length L was its angle."""
    text = '[mechanism]\nname = "fb"\nground = "base"\n[parameters.L]\nvalue = 1\nrun_time = true\n'
    for body, com in (("a", '[0, "L/2", 0]'), ("c", '["L", "L", 0]'), ("b", '["2*L", "L/2", 0]')):
        text += f"[bodies.{body}]\nmass = 1\ncom = {com}\ninertia = [1, 1, 1]\n"
    ends = (("L", "base", "a", "[0, 0, 0]"), ("B", "a", "c", '[0, "L", 0]'), ("C", "c", "b", '["2*L", "L", 0]'))
    for name, parent, child, point in (*ends, ("D", "b", "base", '["2*L", "L/10", 0]')):
        text += f'[joints.{name}]\ntype = "R"\nparent = "{parent}"\nchild = "{child}"\npoint = {point}\n'
        text += "axes = [[0, 0, 1]]\n" + "driven = true\n" * (name == "L")
    (tmp_path / "fb.toml").write_text(text)
    scene = '[scene]\nname = "s"\nmechanism = "fb.toml"\nduration = 0.01\nrate = 100\n[initial]\nmode = "home"\n'
    scene += "coordinates = { L = 0.3 }\n"
    with pytest.raises(DescriptionError, match="L is a parameter of fb, too"):
        simulate(parse_scene(scene, folder=tmp_path), backend="numpy")
    free = parse_scene(scene.replace('mode = "home"\n', ""), folder=tmp_path)
    assert simulate(free, backend="numpy").q[0, 0] == pytest.approx(0.3, abs=1e-15)

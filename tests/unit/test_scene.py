"""Scenes: what is read, and that whatever cannot work is refused with its place and a cure."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.mobility import inverse_kinematics
from symscrew.scene.contents import Table
from symscrew.scene.scene_file import load_scene, parse_scene
from symscrew.simulation.initial import initial_state
from symscrew.simulation.motion import prepare

EXAMPLES = Path(__file__).parents[2] / "examples"
FOUR_BAR = """
[scene]
mechanism = "four_bar"
duration = 0.1
rate = 100
"""


def with_lines(text: str) -> str:
    return FOUR_BAR + text


def test_a_scene_is_read_with_expressions_of_the_mechanisms_parameters() -> None:
    scene = parse_scene(
        """
        [scene]
        mechanism = "delta"
        duration = "upper_arm"
        [initial.coordinates]
        arm1_R = "pi/10"
        [[effects]]
        type = "gravity"
        """
    )
    assert scene.duration == 0.3
    assert scene.initial.coordinates == {"arm1_R": pytest.approx(np.pi / 10)}
    assert len(scene.times) == 31
    assert scene.times[-1] == scene.duration


@pytest.mark.parametrize("path", sorted(EXAMPLES.rglob("benchmarks/*.toml")), ids=lambda p: p.stem)
def test_benchmark_scenes_are_read(path: Path) -> None:
    from symscrew.scene.scene_file import load_scene

    assert load_scene(path).duration > 0


@pytest.mark.parametrize(
    "text, message",
    [
        (FOUR_BAR.replace("0.1", "0"), "duration: expected a number above 0"),
        (FOUR_BAR.replace("0.1", "nan"), "finite"),
        (FOUR_BAR.replace("0.1", '"1/0"'), "division by zero"),
        (FOUR_BAR.replace("duration = 0.1", ""), "'duration' is missing"),
        (FOUR_BAR.replace('"four_bar"', '"five"'), "neither a mechanism of the catalogue nor"),
        (FOUR_BAR.replace("rate", "rates"), "did you mean 'rate'"),
        (with_lines('[[effects]]\ntype = "gravty"'), "unknown effect 'gravty'; did you mean 'gravity'"),
        (
            with_lines('[[effects]]\ntype = "viscous_friction"\njoint = "A"\ncoefficient = -1'),
            "viscous friction in joint 'A': coefficient",
        ),
        (with_lines("[integrator]\nmethod = 'rk5'"), "unknown method 'rk5'"),
        (with_lines("[integrator]\nmethod = 'rk4'"), "needs the key 'step'"),
        (with_lines("[integrator]\nmethod = 'rk4'\nstep = 0"), "step: expected a number above 0"),
        (with_lines("[integrator]\ntolerance = 0"), "tolerance: expected a number above 0"),
        (with_lines("[integrator]\nstep = 1e-3"), "dop853 chooses its steps"),
        (with_lines("[tables.f]\ntimes = [0, 1, 1]\nvalues = [0, 1, 2]"), "ascending times, got 1 after 1"),
        (with_lines("[tables.f]\ntimes = [0, 1]\nvalues = [0]"), "as many values as times"),
        (with_lines("[signals]\nt = 1"), "the name 't' is taken"),
        (with_lines("[initial]\ncoordinates = 3"), "a table of labels"),
        (with_lines("[parameters]\nfoo = 1"), "no run-time parameter"),
        (with_lines("[initial.coordinates]\nB_ = '30deg'"), "'B_' is no coordinate with a unit, did you mean 'B'"),
        ("[scene]\nmechanism = 3\nduration = 1", "expected a name or a file"),
        ("effects = 3\n" + FOUR_BAR, "expected tables [[effects]]"),
    ],
)
def test_what_cannot_work_is_refused(text: str, message: str) -> None:
    with pytest.raises(DescriptionError) as error:
        parse_scene(text)
    assert message in str(error.value)


@pytest.mark.parametrize(
    "text, message",
    [
        ("[drives]\nB = 1", "joint 'B' is passive here; driven are A"),
        ("[drives]\nX = 1", "no drive is called 'X'"),
        ('[drives]\nA = "q_AA"', "unknown name 'q_AA'"),
        ('[drives]\nA = "exp(t) + asin(2"', "expected ')'"),
        ("[inputs]\nload_E = [1, 2]", "no effect of this scene has the input 'load_E'"),
        ("[initial.coordinates]\nnope = 1", "there is no 'nope'"),
        ("[initial.coordinates]\nrockr.pitch = 1", "did you mean 'rocker.pitch'"),
        ('[initial.coordinates]\nrocker.pitch = "170deg"', "out of reach: "),
        ("[initial.coordinates]\nA = 0.3\nD = 3", "the loops of four_bar cannot be closed with A = 0.3, D = 3"),
        ("[initial.rates]\nA = 1\nD = 7", "the loops do not allow A = 1, D = 7"),
    ],
)
def test_a_scene_that_does_not_fit_its_mechanism_is_refused(text: str, message: str) -> None:
    scene = parse_scene(with_lines(text))
    with pytest.raises(DescriptionError) as error:
        model, plant = prepare(scene)
        initial_state(scene, model, plant.parameters)
    assert message in str(error.value)


def test_the_start_is_assembled_from_what_is_given() -> None:
    scene = parse_scene(with_lines("[initial.coordinates]\nA = 0.3\n[initial.rates]\nA = 1.5"))
    model, plant = prepare(scene)
    q, v = initial_state(scene, model, plant.parameters)
    labels = [c.label for c in model.system.tree.q]
    assert q[labels.index("A")] == pytest.approx(0.3, abs=1e-13)
    assert v[labels.index("A")] == pytest.approx(1.5, abs=1e-13)
    (residual,), _ = model("closure", q)
    (jacobian,), _ = model("closure_jacobian", q)
    assert np.abs(residual).max() < 1e-13
    assert np.abs(jacobian.reshape(len(v), -1).T @ v).max() < 1e-13


@pytest.mark.parametrize("name", ["C", "rocker.pitch"])
def test_a_start_by_any_coordinate_is_the_start_by_the_crank(name: str) -> None:
    """Passive joints, the one that closes the loop, the rocker's pose; in degrees as in rad."""
    crank = parse_scene(with_lines('[initial.coordinates]\nA = "20deg"'))
    model, plant = prepare(crank)
    q, _ = initial_state(crank, model, plant.parameters)
    labels = [c.label for c in model.system.tree.q]
    assert q[labels.index("A")] == pytest.approx(np.radians(20), abs=1e-13) and not crank.initial.notices
    there = inverse_kinematics(crank.mechanism, A="20deg").values[name]
    text = f'[initial.coordinates]\n"{name}" = "{np.degrees(there):.15g} deg"\n[initial.rates]\nA = "1deg/s"'
    other, v = initial_state(parse_scene(with_lines(text)), model, plant.parameters)
    assert np.abs(other - q).max() < 1e-12 and v[labels.index("A")] == pytest.approx(np.radians(1), abs=1e-13)


def test_units_of_a_start_are_those_of_its_coordinates() -> None:
    assert parse_scene(with_lines("[initial.coordinates]\nA = 30")).initial.notices == (
        "initial.coordinates.A is in rad: 30 are 1719 degrees; 30deg are 30 degrees",
    )
    for text in ('coordinates]\nA = "30mm"', 'rates]\nA = "30deg"', 'coordinates]\nrocker.z = "3deg"'):
        with pytest.raises(DescriptionError, match="got one in"):
            parse_scene(with_lines(f"[initial.{text}"))


def test_tables_interpolate_and_stay_constant_outside() -> None:
    linear = Table("f", (0.0, 1.0, 3.0), (0.0, 2.0, 1.0))
    assert linear([-1.0, 0.5, 2.0, 9.0]).tolist() == [0.0, 1.0, 1.5, 1.0]
    t = np.linspace(0, 2, 41)
    cubic = Table("g", tuple(t), tuple(np.sin(t)), "cubic")
    at = np.linspace(0.1, 1.4, 500)
    assert np.abs(cubic(at) - np.sin(at)).max() < 1e-4
    steps = Table("h", (0.0, 1.0, 2.0, 3.0), (0.0, 0.0, 1.0, 1.0), "cubic")
    values = steps(np.linspace(0, 3, 301))
    assert values.min() >= 0.0
    assert values.max() <= 1.0  # no overshoot


def test_the_command_line_refuses_and_writes_nothing(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(FOUR_BAR.replace("0.1", "-1"))
    out = tmp_path / "run.npz"
    assert main(["simulate", str(scene), "--out", str(out)]) == 2
    error = capsys.readouterr().err
    assert "scene.toml: scene.duration: expected a number above 0, got -1" in error
    assert len(error.splitlines()) == 1
    assert list(tmp_path.iterdir()) == [scene]
    scene.write_text(FOUR_BAR)
    assert main(["simulate", str(scene), "--out", str(tmp_path / "run.txt")]) == 2
    assert main(["simulate", str(scene), "--out", str(tmp_path / "no" / "run.npz")]) == 2
    assert main(["simulate", str(tmp_path / "none.toml"), "--json"]) == 2
    assert list(tmp_path.iterdir()) == [scene]


@pytest.mark.parametrize("mass, wrong", [("-1", "m.toml: bodies.b.mass: "), ("1", "s.toml: scene.rate: ")])
def test_an_error_names_the_file_that_it_is_in_and_no_other(tmp_path: Path, mass: str, wrong: str) -> None:
    joint = '{ type = "P", parent = "base", child = "b", point = [0, 0, 0], axes = [[0, 0, 1]] }'
    body = f"b = {{ mass = {mass}, com = [0, 0, 0], inertia = [1, 1, 1] }}"
    (tmp_path / "m.toml").write_text(f'[mechanism]\nname = "m"\n[bodies]\n{body}\n[joints]\nj = {joint}\n')
    (tmp_path / "s.toml").write_text('[scene]\nmechanism = "m.toml"\nduration = 1\nrate = -1\n')
    with pytest.raises(DescriptionError) as found:
        load_scene(tmp_path / "s.toml")
    assert str(found.value).startswith(wrong) and str(found.value).count(".toml") == 1

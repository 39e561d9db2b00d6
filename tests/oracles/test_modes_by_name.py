"""Scenes, maps and plans that say in which assembly mode they are: there by the closure, and named in results."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import symscrew
from symscrew.assembly import configuration_in_mode
from symscrew.assembly.configurations_in_modes import tree_coordinates
from symscrew.cli.parser import main
from symscrew.kinematics import System

FALL = """
[scene]
mechanism = "four_bar"
duration = 0.1
rate = 100
[initial]
coordinates = {{ A = 0.2 }}
{mode}
[integrator]
method = "dop853"
[[effects]]
type = "gravity"
"""


@pytest.fixture(scope="module")
def four_bar() -> symscrew.Mechanism:
    return symscrew.load_catalogue("four_bar")


def scene(folder: Path, mode: str) -> symscrew.simulation.Run:
    path = folder / "fall.toml"
    path.write_text(FALL.format(mode=f'mode = "{mode}"' if mode else ""))
    return symscrew.simulate(symscrew.load_scene(path))


def test_a_scene_starts_in_the_mode_that_it_names(tmp_path, four_bar):
    usual, home, other = (scene(tmp_path, mode) for mode in ("", "home", "-1"))
    assert np.abs(usual.q - home.q).max() < 1e-9 and (usual.mode, home.mode, other.mode) == ("", "home", "-1")
    found = symscrew.assembly_modes(four_bar, {"A": 0.2})
    labels = [c.label for c in other.model.system.tree.q]
    for run, name in ((home, "home"), (other, "-1")):
        values = found.mode(name).values
        start = dict(zip(labels, run.q[0], strict=True))
        assert all(abs(np.sin((start[k] - values[k]) / 2)) < 1e-9 for k in labels)
        assert run.ok and run.closure_error.max() < 1e-9
    assert home.modes[0] != other.modes[0]


def test_a_mode_that_is_not_there_is_refused_by_name(tmp_path):
    with pytest.raises(symscrew.DescriptionError, match=r"initial.mode: four_bar has no mode '\+7'.*it has home, -1"):
        scene(tmp_path, "+7")


def test_configurations_in_modes_close_the_loops_of_the_model():
    model = symscrew.derive(symscrew.load_catalogue("five_bar")).only(["closure"])
    system = System(model.mechanism)
    found = symscrew.assembly_modes(model)
    assert np.array_equal(configuration_in_mode(system, "home", {}, "here"), system.reference)
    for mode in found.modes:
        q = tree_coordinates(found, mode, system, "here")
        (opening,), _ = model("closure", q)
        assert np.abs(opening).max() < 1e-12


@pytest.mark.slow
def test_a_map_in_a_mode_is_on_it_and_says_so():
    mechanism = symscrew.load_catalogue("five_bar")
    maps = {
        mode: symscrew.workspace(mechanism, {"base_left": "-0.2:0.2:3"}, effects=(), mode=mode, processes=1)
        for mode in ("", "home", "-1")
    }
    assert np.array_equal(maps[""]["margin"], maps["home"]["margin"], equal_nan=True)
    assert maps["-1"].summary["mode"] == "-1" and "mode" not in maps[""].summary
    assert maps["-1"].summary["regular"] == maps["home"].summary["regular"] == 3
    for value, left, right in zip((-0.2, 0.0, 0.2), maps["home"]["elbow_left"], maps["-1"]["elbow_left"], strict=True):
        found = symscrew.assembly_modes(mechanism, {"base_left": value})
        elbows = {m.name: m.values["elbow_left"] for m in found.modes}
        assert abs(np.sin((elbows["home"] - left) / 2)) < 1e-9 and abs(np.sin((elbows["-1"] - right) / 2)) < 1e-9


@pytest.mark.slow
def test_a_plan_starts_in_the_mode_that_it_names(tmp_path, four_bar):
    path = tmp_path / "swing.toml"
    path.write_text(
        '[problem]\nmechanism = "four_bar"\nduration = 1\n[start]\nmode = "-1"\ncoordinates = { A = 0 }\n'
        'at_rest = true\n[end]\nmode = "-1"\ncoordinates = { A = 0.3 }\nat_rest = true\n'
        '[transcription]\nintervals = 4\n[[effects]]\ntype = "gravity"\n'
    )
    assert main(["optimise", str(path), "--out", str(tmp_path / "swing.npz")]) == 0
    with np.load(tmp_path / "swing.npz") as plan:
        q, labels = plan["q"], [str(label) for label in plan["q_labels"]]
    for row, value in ((0, 0.0), (-1, 0.3)):
        known = symscrew.assembly_modes(four_bar, {"A": value}).mode("-1").values
        assert all(abs(np.sin((q[row][k] - known[label]) / 2)) < 1e-6 for k, label in enumerate(labels))


def goal_in(folder: Path, mode: str) -> symscrew.optimisation.Trajectory:
    path = folder / f"swing{mode}.toml"
    path.write_text(
        f'[problem]\nmechanism = "four_bar"\nduration = 1\n[start]\ncoordinates = {{ A = 0 }}\nat_rest = true\n'
        f'[end]\nmode = "{mode}"\ncoordinates = {{ A = 0.3 }}\nat_rest = true\n[transcription]\nintervals = 4\n'
        '[[effects]]\ntype = "gravity"\n'
    )
    return symscrew.optimise(symscrew.optimisation.load_problem(path))


@pytest.mark.slow
def test_a_plan_to_a_goal_in_another_mode_is_no_success_and_says_so(tmp_path):
    refused = goal_in(tmp_path, "-1")  # no way leads there: a singularity lies between
    assert not refused.ok and refused.status != "optimal"


def test_a_goal_whose_mode_is_not_there_or_stands_alone_is_refused(tmp_path):
    with pytest.raises(symscrew.DescriptionError, match=r"end.mode: four_bar has no mode '\+7'.*it has home, -1"):
        goal_in(tmp_path, "+7")
    with pytest.raises(symscrew.DescriptionError, match=r"end\.mode: expected conditions beside it"):
        problem = (
            '[problem]\nmechanism = "four_bar"\nduration = 1\n[start]\ncoordinates = { A = 0 }\n[end]\nmode = "-1"\n'
        )
        (tmp_path / "alone.toml").write_text(problem)
        symscrew.optimise(symscrew.optimisation.load_problem(tmp_path / "alone.toml"))

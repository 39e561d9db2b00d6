"""Many runs of one scene: each is what `simulate` makes of it alone, to the bit; files, exit codes, bad input."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from support.runs import EXAMPLES

from symscrew.array_archives import read_archive
from symscrew.catalogue import load as load_catalogue
from symscrew.cli.parser import main
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Parameter
from symscrew.effects import DryFriction, EndStop, Gravity, JointSpring
from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.scene.scene_file import load_scene
from symscrew.simulation import many_runs
from symscrew.simulation.many_runs import Runs, simulate_many
from symscrew.simulation.motion import Run, prepare, simulate
from symscrew.simulation.state_programs import Plant

pytestmark = [
    pytest.mark.slow,
    pytest.mark.short_runs,
    pytest.mark.skipif(find_compiler() is None, reason="needs a C compiler"),
]
RECORDED = ("q", "v", "u", "x", "energy", "closure_error", "energy_balance")


@cache
def swing() -> tuple[Scene, tuple[Model, Plant]]:
    """A slider-crank with a drive that brakes and a spring whose stiffness is a run-time parameter."""
    stiffness = Parameter("k", sympy.Integer(2), "N m/rad", "of a spring at the crank", run_time=True)
    mechanism = replace(load_catalogue("slider_crank"), parameters={"k": stiffness})
    effects = (Gravity(), JointSpring("crank_R", stiffness="k"))
    scene = Scene(
        "swing", mechanism, effects, 0.2, 20.0, Initial(rates={"crank_R": 1.0}), integrator=Integrator(tolerance=1e-8),
        drives={"crank_R": "-0.3*v_crank_R"},
    )  # fmt: skip
    return scene, prepare(scene)


def alone(scene: Scene, prepared: tuple[Model, Plant], starts: Mapping[str, np.ndarray], k: int) -> Run:
    """Run k by itself, from a scene that says its start."""

    def those(begin: str) -> dict[str, float]:
        return {n.removeprefix(begin): float(a[k]) for n, a in starts.items() if n.startswith(begin)}

    initial = replace(
        scene.initial,
        coordinates={**scene.initial.coordinates, **those("initial.coordinates.")},
        rates={**scene.initial.rates, **those("initial.rates.")},
    )
    own = replace(scene, initial=initial, parameters={**scene.parameters, **those("parameters.")})
    return simulate(own, prepared=prepare(own) if own.parameters != scene.parameters else prepared)


def same(runs: Runs, k: int, run: Run) -> None:
    """Every number and every word that both have."""
    count = len(run.t) if run.ok else len(run.t) - 1
    for name in RECORDED:
        np.testing.assert_array_equal(getattr(runs, name)[k, :count], getattr(run, name)[:count], err_msg=name)
        assert np.isnan(getattr(runs, name)[k, count:]).all()
    assert runs.status[k] == run.verdict and runs.ok[k] == (run.ok and run.accurate)
    assert run.estimate is not None
    np.testing.assert_array_equal(runs.estimated_error[k], run.estimate.error)
    assert runs.modes[k] == run.modes and runs.end[k] == run.t[-1]
    assert runs.crossings[k] == tuple(c.t for c in run.crossings)
    assert {runs.counters[name][k] == run.counters[name] for name in runs.counters} == {True}


def drawn(count: int, seed: int = 3) -> dict[str, np.ndarray]:
    random = np.random.default_rng(seed)
    return {
        "initial.coordinates.crank_R": random.uniform(-0.5, 0.5, count),
        "initial.rates.crank_R": random.uniform(-2, 2, count),
        "parameters.k": random.uniform(1.0, 3.0, count),
    }


def test_every_run_is_that_of_its_scene_alone_to_the_bit() -> None:
    """Coordinates, rates and parameters; whatever the threads, the order and the runs beside it."""
    scene, prepared = swing()
    starts = drawn(5)
    runs = simulate_many(scene, starts, prepared=prepared, threads=3)
    assert runs.all_ok and len(runs) == 5 and runs.backend == "c" and runs.threads == 3
    assert simulate_many(scene, {n: a[:2] for n, a in starts.items()}, prepared=prepared, threads=99_999).threads == 2
    for k in (0, 3):
        same(runs, k, alone(scene, prepared, starts, k))
    order = np.array([4, 0, 3])
    others = simulate_many(scene, {n: a[order] for n, a in starts.items()}, prepared=prepared, threads=1)
    for name in (*RECORDED, "estimated_error", "parameters"):
        np.testing.assert_array_equal(getattr(others, name), getattr(runs, name)[order], err_msg=name)
    columns = runs.columns(3)
    np.testing.assert_array_equal(columns["q.crank_R"], runs.q[3, :, 0])


def test_whole_states_go_on_where_runs_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    """From the last samples, in blocks of two."""
    scene, prepared = swing()
    first = simulate_many(scene, drawn(3), prepared=prepared)
    monkeypatch.setattr(many_runs, "BLOCK", 2)
    done: list[int] = []
    whole = {"q": first.q[:, 2], "v": first.v[:, 2], "parameters.k": first.parameters[:, 0]}
    runs = simulate_many(scene, whole, prepared=prepared, progress=done.append)
    assert done == [2, 3] and runs.all_ok
    np.testing.assert_allclose(runs.q[:, 0], first.q[:, 2], atol=1e-13)
    np.testing.assert_allclose(runs.q[:, 2], first.q[:, 4], atol=1e-8)
    whole["q"] = whole["q"] + np.array([[0], [1e-3], [0]])
    whole["v"] = whole["v"] + np.eye(len(whole["v"]), whole["v"].shape[1])[::-1] * [[0], [0], [0.1]]
    lost = simulate_many(scene, whole, prepared=prepared)
    assert lost.ok.tolist() == [True, False, False] and np.isnan(lost.q[1]).all()
    assert "not started: the loops are open by" in lost.status[1] or "slides" in lost.status[1]
    assert "not started: the loops do not allow these rates" in lost.status[2]


def test_contacts_have_modes_and_numbers_of_their_own() -> None:
    """Blocks on springs with friction and a stop, whose level and place are parameters: events beside each other."""
    builder = MechanismBuilder("block")
    builder.parameter("level", "3", "N", run_time=True)
    builder.parameter("wall", "0.6", "m", run_time=True)
    builder.body("block", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("slide", "P", parent="base", child="block", point=[0, 0, 0], axes=[[1, 0, 0]])
    effects = (
        JointSpring("slide", stiffness=50),
        DryFriction("slide", coulomb="level", mode="event"),
        EndStop("slide", upper="wall", mode="impact", restitution="0.5"),
    )
    scene = Scene(
        "contact", builder.build(), effects, 1.2, 10.0, Initial({"slide": 0.5}), integrator=Integrator(tolerance=1e-8)
    )
    starts = {
        "initial.rates.slide": np.array([0.0, 4.0, 0.0, 4.0]),
        "parameters.level": np.array([3.0, 1.0, 20.0, 3.0]),
        "parameters.wall": np.array([0.6, 0.55, 0.6, 0.7]),
    }
    prepared = prepare(scene)
    runs = simulate_many(scene, starts, prepared=prepared, threads=2)
    for k in range(4):
        run = alone(scene, prepared, starts, k)
        same(runs, k, run)
        assert runs.events[k] == run.events and run.events
    assert len(set(runs.events)) == 4
    for k in (1, 3):  # 2 s'' = -50 s - level from s = 0.5 m at 4 m/s, until it is at the wall
        still, when = -starts["parameters.level"][k] / 50, float(runs.events[k][0].split()[2])
        met = still + (0.5 - still) * np.cos(5 * when) + 0.8 * np.sin(5 * when)
        assert met == pytest.approx(starts["parameters.wall"][k], abs=1e-8)


def test_what_ends_early_or_cannot_start_is_told_and_has_no_numbers_behind(tmp_path: Path) -> None:
    scene, prepared = swing()
    hasty = replace(scene, integrator=replace(scene.integrator, most_steps=12))
    starts = {"initial.coordinates.crank_R": np.array([0.1, 0.2, 0.1]), "initial.coordinates.slider_P": np.zeros(3)}
    starts["initial.coordinates.slider_P"][:] = np.nan
    with pytest.raises(DescriptionError, match=r"slider_P`: expected finite numbers, got nan in run 0"):
        simulate_many(scene, starts, prepared=prepared)
    still, by_name = replace(scene, initial=Initial()), {"initial.rates.slider.x": np.array([0.1, 0.2])}
    same(simulate_many(still, by_name, prepared=prepared), 1, alone(still, prepared, by_name, 1))
    rates = {"initial.rates.crank_R": np.array([1e-3, 60.0])}
    runs = simulate_many(hasty, rates, prepared=prepared)
    same(runs, 1, alone(hasty, prepared, rates, 1))
    assert not runs.ok[1] and "more steps than most_steps allows" in runs.status[1] and runs.end[1] < 0.2
    far = {"initial.coordinates.slider_P": np.array([runs.columns(0)["q.slider_P"][0], 50.0])}
    apart = simulate_many(scene, far, prepared=prepared)
    assert apart.ok.tolist() == [True, False] and np.isnan(apart.end[1]) and np.isnan(apart.q[1]).all()
    assert apart.status[1].startswith("not started: initial.coordinates: the loops of slider_crank cannot be closed")
    with pytest.raises(DescriptionError, match="none of 1 runs can start; the first: not started: initial"):
        simulate_many(scene, {"initial.coordinates.slider_P": np.array([50.0])}, prepared=prepared)


BAD: list[tuple[dict[str, Any], str]] = [
    ({}, "expected arrays such as initial.coordinates.crank_R, got none"),
    ({"initial.coordinates.crank": [1.0]}, "there is no coordinate 'crank'"),
    ({"initial.rates.crank": [1.0]}, "there is no rate 'crank'; did you mean"),
    ({"parameters.nothing": [1.0]}, "no use for an array 'parameters.nothing'"),
    ({"energy": [1.0]}, "no use for an array 'energy'"),
    ({"initial.rates.crank_R": [[1.0]]}, r"expected an array \(runs,\), got one of \(1, 1\)"),
    ({"initial.rates.crank_R": 1.0}, r"expected an array \(runs,\), got one of \(\)"),
    ({"initial.rates.crank_R": ["1"]}, "expected real numbers, got '<U1'"),
    ({"initial.rates.crank_R": [1j]}, "expected real numbers, got 'complex128'"),
    ({"initial.rates.crank_R": []}, "expected at least one run, got none"),
    ({"initial.rates.crank_R": [1.0, np.inf]}, "expected finite numbers, got inf in run 1"),
    ({"initial.rates.crank_R": [1.0], "initial.coordinates.crank_R": [1.0, 2.0]}, "expected 1 runs as in"),
    ({"q": [[0.0]]}, r"`q`: expected an array \(runs, \d\), got one of \(1, 1\)"),
    ({"q": "whole"}, "`q` is there without `v`"),
    ({"q": "whole", "v": "whole", "initial.rates.crank_R": [1.0]}, "leave `initial.rates.crank_R` out"),
    ({"x": [[]]}, "no use for an array 'x'|`x` goes with whole states|expected an array"),
]


@pytest.mark.parametrize(("arrays", "said"), BAD, ids=[said[:30] for _, said in BAD])
def test_arrays_that_do_not_fit_are_refused(arrays: dict[str, Any], said: str) -> None:
    scene, prepared = swing()
    sizes = {"q": prepared[1].sizes["q"], "v": prepared[1].sizes["v"]}
    given = {n: np.zeros((1, sizes[n])) if isinstance(a, str) else np.array(a) for n, a in arrays.items()}
    with pytest.raises(DescriptionError, match=said):
        simulate_many(scene, given, prepared=prepared)


def test_more_than_a_file_holds_is_refused_before_anything_runs() -> None:
    scene, prepared = swing()
    fast = replace(scene, rate=1e5)
    with pytest.raises(DescriptionError, match=r"100000 runs of 20001 outputs are .* take a lower \[scene\] rate"):
        simulate_many(fast, {"initial.rates.crank_R": np.zeros(100_000)}, prepared=prepared)
    with pytest.raises(ValueError, match="threads: expected at least one"):
        simulate_many(scene, {}, prepared=prepared, threads=0)
    with pytest.raises(ValueError, match="backend 'c' or 'numpy'"):
        simulate_many(scene, {}, prepared=prepared, backend="fortran")


@pytest.mark.slow
def test_singular_configurations_are_passed_in_extended_precision_with_own_parameters() -> None:
    """Two four-bars in a row, whose loops lose rank on the way: the second library has the run's parameters, too."""
    scene = load_scene(EXAMPLES / "benchmarks" / "n_four_bar.toml")
    stiffness = Parameter("k", sympy.Integer(1), "N m/rad", "of a spring at the first joint", run_time=True)
    mechanism = replace(scene.mechanism, parameters={**scene.mechanism.parameters, "k": stiffness})
    effects = (*scene.effects, JointSpring("A0", stiffness="k"))
    scene = replace(scene, mechanism=mechanism, effects=effects, duration=2.0)
    prepared = prepare(scene)
    starts = {"initial.rates.A0": np.array([-1.0, -2.0, -1.5]), "parameters.k": np.array([0.5, 1.5, 1.0])}
    runs = simulate_many(scene, starts, prepared=prepared, threads=2)
    assert all(runs.crossings) and runs.counters["careful"].all()
    for k in (0, 1):
        same(runs, k, alone(scene, prepared, starts, k))


@pytest.mark.slow
def test_without_the_compiled_loop_runs_go_one_after_the_other() -> None:
    """SciPy's radau, and NumPy's evaluation: as `simulate` alone."""
    scene, prepared = swing()
    starts = {"initial.rates.crank_R": np.array([0.5, 1.0])}
    for other, backend in ((replace(scene, integrator=Integrator("radau", 1e-5)), None), (scene, "numpy")):
        short = replace(other, duration=0.05)
        runs = simulate_many(short, starts, prepared=prepared, backend=backend)
        own = replace(short, initial=replace(scene.initial, rates={"crank_R": 0.5}))
        same_run = simulate(own, prepared=prepared, backend=backend)
        np.testing.assert_array_equal(runs.q[0], same_run.q)
        assert runs.backend == "library" and runs.threads == 1 and runs.all_ok


SCENE = """
[scene]
name = "turned"
mechanism = "slider_crank"
duration = 0.2
rate = 20
reactions = true
[drives]
crank_R = "0.1"
"""


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Keys of the file, what is printed, exit codes 0, 1, 2, nothing written where the input is refused."""
    (tmp_path / "turned.toml").write_text(SCENE)
    starts, out = tmp_path / "starts.npz", tmp_path / "runs.npz"
    np.savez(starts, **{"initial.coordinates.crank_R": [0.1, 0.2, 0.3]})
    command = ["simulate", str(tmp_path / "turned.toml"), "--many", str(starts), "--out", str(out)]
    assert main([*command, "--json", "--threads", "2"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["runs"] == told["good"] == told["started"] == 3 and told["ok"] and not told["not_good"]
    assert told["threads"] == 2 and told["closure_error"] < 1e-12
    found = read_archive(out)
    assert found["t"].tolist() == pytest.approx([0, 0.05, 0.1, 0.15, 0.2])
    assert found["q"].shape == (3, 5, len(found["q_labels"])) and found["u"].shape == (3, 5, 1)
    assert found["reactions"].shape == (3, 5, 6 * len(found["joint_names"]))
    assert found["statuses"][found["status"]].tolist() == ["completed"] * 3
    np.testing.assert_allclose(found["q"][:, 0, 0], [0.1, 0.2, 0.3], rtol=1e-14)
    assert found["ok"].all()
    place = found["q"][0, 0, [*found["q_labels"]].index("slider_P")]
    np.savez(starts, **{"initial.coordinates.slider_P": [place, 9.0]})
    assert main([*command[:-2], "--threads", "1"]) == 1
    said = capsys.readouterr().out
    assert "turned: 1 of 2 runs completed as accurately as asked for" in said and "run 1: not started" in said
    out.unlink()
    np.savez(starts, rates=[0.1])
    assert main(command) == 2
    (tmp_path / "no.npz").write_text("no archive")
    assert main([*command[:3], str(tmp_path / "no.npz")]) == 2
    for more in (["--plot", "a.png"], ["--emit-c", "loop"], ["--threads", "0"]):
        assert main([*command, *more]) == 2
    assert main([*command[:2], "--threads", "2"]) == 2
    assert main([*command[:-1], str(tmp_path / "runs.csv")]) == 2
    assert not out.exists() and "Traceback" not in capsys.readouterr().err

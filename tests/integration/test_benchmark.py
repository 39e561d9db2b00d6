"""`symscrew benchmark`: what it times has been compared before, what it cannot compare is named."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.formats import by_suffix
from symscrew.model import derive
from symscrew.program.numpy_evaluation import evaluate
from symscrew.runtime.compiled import CompileError, find_compiler
from symscrew.studies.benchmark import function_times, peers
from symscrew.studies.benchmark.function_times import batch, single, throughput, time_functions
from symscrew.studies.benchmark.timed_code import Compiled, states
from symscrew.studies.timing import quartiles

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]


def test_what_is_timed_is_right() -> None:
    compiled = Compiled(model("four_bar"), ["inverse_dynamics"])
    (expected,), _ = evaluate(
        compiled.model.programs["inverse_dynamics"], states(compiled.model, "inverse_dynamics", 30)
    )
    for measure, (got,) in (
        single(compiled, "inverse_dynamics", 30),
        batch(compiled, "inverse_dynamics", 30, columns=False),
        batch(compiled, "inverse_dynamics", 30, columns=True),
    ):
        assert np.abs(got - expected).max() < 1e-12
        got[:] = np.nan
        assert measure() > 0 and np.abs(got - expected).max() < 1e-12  # what is timed writes the results


def test_rows_and_notes_for_a_closed_chain() -> None:
    rows, notes = time_functions(model("four_bar"), ["inverse_dynamics", "mass_matrix"], ["mujoco"], repeats=2)
    assert [row.function for row in rows] == ["inverse_dynamics"] * 3 + ["mass_matrix"] * 3
    assert all(row.agreement < 1e-12 and 0 < row.times.least <= row.times.median <= row.times.upper for row in rows)
    assert len(notes) == 2 and all("no function of this kind; expected forward_dynamics" in note for note in notes)


def test_closed_chains_in_pinocchio_agree_before_they_are_timed() -> None:
    pytest.importorskip("pinocchio")
    rows, notes = time_functions(model("three_ups_upu_s_physical"), ["forward_dynamics"], ["pinocchio"], repeats=1)
    (row,) = (row for row in rows if row.variant.startswith("pinocchio"))
    assert not notes and "constraintDynamics" in row.variant and 0 < row.agreement < 1e-6
    _, notes = time_functions(model("four_bar"), ["forward_dynamics"], ["pinocchio"], repeats=1)
    assert "platforms on limbs" in notes[0] and "joint C" in notes[0]


def test_closed_chains_in_mujoco_are_soft_and_said_to_be() -> None:
    """The deviation stands in the row; constraints made a hundred times as stiff deviate a hundred times less."""
    rows, notes = time_functions(model("four_bar"), ["forward_dynamics"], ["mujoco"], repeats=1)
    (row,) = (row for row in rows if row.variant.startswith("mujoco"))
    assert not notes and row.variant.endswith("soft constraints") and 1e-3 < row.agreement < 0.1
    found = Compiled(model("four_bar"), ["forward_dynamics"])
    (accelerations,), _ = model("four_bar")("forward_dynamics", *states(found.model, "forward_dynamics", 6))
    made = mujoco.MjModel.from_xml_string(by_suffix.text_of(found.model.mechanism, ".xml"))
    made.opt.timestep, made.eq_solref[:], made.eq_solimp[:, :2] = 1e-4, (2e-4, 1.0), 0.9999
    (position, rate, _), wanted = peers._closed_in_mujoco(made, found, accelerations)
    data, got = mujoco.MjData(made), []
    for q, v, u in zip(position, rate, states(found.model, "forward_dynamics", 6)[2], strict=True):
        data.qpos[:], data.qvel[:], data.ctrl[:] = q, v, u
        mujoco.mj_forward(made, data)
        got.append(data.qacc.copy())
    assert np.abs(np.array(got) - wanted).max() < 1e-3 * np.abs(wanted).max()


def test_another_library_agrees_before_it_is_timed() -> None:
    rows, notes = time_functions(model("ur5"), ["inverse_dynamics", "forward_dynamics"], ["mujoco"], repeats=2)
    assert not notes
    others = [row for row in rows if row.variant.startswith("mujoco")]
    assert [row.variant for row in others] == ["mujoco: mj_inverse from C", "mujoco: mj_forward from C"]
    assert all(0 < row.agreement < 1e-9 for row in others)


FLOATING = """<mujoco><worldbody><body name="trunk" pos="0.1 0 2" euler="0 30 0"><freejoint name="root"/>
<inertial pos="0.1 0 0.2" mass="3" diaginertia="0.2 0.3 0.4"/>{0}</body></worldbody><actuator><motor joint="a"/>
<motor joint="b"/></actuator></mujoco>"""
LEG = """<body pos="0.2 0 0"><joint name="{0}" type="{1}" axis="0.6 0 0.8"/><inertial pos="0 0.1 0" mass="1"
diaginertia="0.01 0.02 0.02"/>{2}</body>"""


@pytest.mark.parametrize("peer", ["pinocchio", "mujoco"])
def test_trees_on_a_free_base_agree_before_they_are_timed(tmp_path: Path, peer: str) -> None:
    pytest.importorskip(peer)
    path = tmp_path / "floating.xml"
    path.write_text(FLOATING.format(LEG.format("a", "hinge", LEG.format("b", "slide", ""))))
    functions = ["inverse_dynamics", "forward_dynamics", *(["mass_matrix"] if peer == "pinocchio" else [])]
    rows, notes = time_functions(derive(by_suffix.load_format(path)), functions, [peer], repeats=1)
    assert not notes and [row.function for row in rows if row.variant.startswith(peer)] == functions


def test_results_that_differ_are_not_timed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(function_times, "evaluate", lambda program, given: ((np.full((len(given[0]), 1), 1e3),), None))
    with pytest.raises(CompileError, match="results differ, nothing is timed"):
        time_functions(model("four_bar"), ["inverse_dynamics"], repeats=1)


@pytest.mark.slow
def test_parameters_at_run_time_beside_those_in_the_code() -> None:
    rows, _ = time_functions(model("three_ups_upu_s"), ["inverse_dynamics"], repeats=1, run_time=True)
    row = next(row for row in rows if row.variant == "one state, parameters at run time")
    assert row.operations is not None and row.operations >= rows[0].operations and row.agreement < 1e-12
    with pytest.raises(DescriptionError, match="no parameters"):
        time_functions(model("four_bar"), ["inverse_dynamics"], repeats=1, run_time=True)


def test_throughput_of_every_count() -> None:
    found = throughput(model("four_bar"), "inverse_dynamics", counts=(1, 8, 100), repeats=1)
    assert [entry["states"] for entry in found] == [1, 8, 100]
    assert all(times["median"] > 0 for entry in found for key, times in entry.items() if key != "states")


def test_a_missing_library_is_named_with_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(peers.importlib.util, "find_spec", lambda name: None)
    _, notes = time_functions(model("four_bar"), ["inverse_dynamics"], ["pinocchio"], repeats=1)
    assert notes == ["inverse_dynamics, pinocchio: not installed: pip install 'symscrew[benchmark]'"]


def test_other_effects_are_not_compared() -> None:
    bare = replace(model("ur5"), effects=())
    _, notes = time_functions(bare, ["inverse_dynamics"], ["mujoco"], repeats=1)
    assert "usual gravity" in notes[0]


def test_quartiles() -> None:
    times = quartiles([4.0, 1.0, 2.0, 3.0, 5.0])
    assert (times.least, times.lower, times.median, times.upper, times.repeats) == (1.0, 2.0, 3.0, 4.0, 5)


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    picture = tmp_path / "times.png"
    arguments = ["benchmark", "four_bar", "--function", "inverse_dynamics", "--repeats", "2"]
    assert main([*arguments, "--plot", str(picture), "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["mechanism"] == "four_bar" and len(content["rows"]) == 3
    assert picture.read_bytes()[:4] == b"\x89PNG" and [p.name for p in tmp_path.iterdir()] == ["times.png"]
    for bad, text in (
        (["--function", "inverse"], "no function 'inverse'"),
        (["--repeats", "0"], "positive number"),
        (["--plot", "x.pdf"], "ends in .png"),
    ):
        assert main(["benchmark", "four_bar", *bad]) == 2
        assert text in capsys.readouterr().err
    with pytest.raises(DescriptionError, match="no function"):
        time_functions(model("four_bar"), ["nothing"])

"""Where functions were undefined on a solver's way is counted and named; whatever else is written goes on."""

from __future__ import annotations

import io
import json
import sys
import threading
from contextlib import redirect_stderr
from dataclasses import replace
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from support.optimal_problems import pendulum, rest_to_rest

from symscrew.cli.parser import main
from symscrew.description import to_toml
from symscrew.errors import DescriptionError
from symscrew.optimisation.problem import Bounds, Objective, TrajectoryProblem, Transcription
from symscrew.optimisation.solution import solve
from symscrew.optimisation.solver_warnings import SolverWarnings

LABELS = ("sum", "root, row 1")


def undefined_at_times(offset: float) -> ca.Function:
    """A solver that must leave where a root is real to go downhill."""
    x = ca.MX.sym("x", 2)
    nlp: dict[str, Any] = {
        "x": x,
        "f": (x[0] - 3) ** 2 + x[1] ** 2,
        "g": ca.vertcat(x[0] + x[1], ca.sqrt(offset - x[0])),
    }
    own: dict[str, Any] = {"print_level": 0, "sb": "yes", "max_iter": 30}
    options: dict[str, Any] = {"show_eval_warnings": True, "print_time": False, "ipopt": own}
    return ca.nlpsol("trial", "ipopt", nlp, options)


@pytest.mark.parametrize("offset", np.random.default_rng(5).uniform(0.2, 2.5, 4).tolist())
def test_as_many_as_the_solver_says(offset: float) -> None:
    solver, raw = undefined_at_times(offset), io.StringIO()
    bounds = {"x0": [0.1, 0.1], "lbg": [-10, -1e9], "ubg": [10, 1e9]}
    with redirect_stderr(raw):
        solver(**bounds)
    kept = io.StringIO()
    with redirect_stderr(kept), SolverWarnings(LABELS) as told:
        solver(**bounds)
    said = raw.getvalue().count("WARNING")
    assert said > 0 and told.counts == {"root": said} and kept.getvalue().strip() == ""


def test_what_others_write_goes_on_and_lines_come_in_pieces() -> None:
    line = 'CasADi - 2026 WARNING("s:nlp_%s failed: %s detected for output %s, at %s(row %d, col 0).") [file:1]\n'
    text = (
        line % ("jac_g", "Inf", "jac_g_x", "nonzero index 7 ", 0) + "a note\n" + line % ("g", "NaN", "g", "", 1)
        + line % ("grad_f", "NaN", "grad_f_x", "", 0) + line % ("hess_l", "NaN", "triu_hess_gamma_x_x", "", 1)
        + line % ("f", "NaN", "f", "", 0) + 'CasADi - 2026 WARNING("KeyboardInterruptException") [file:1]\n' + "the end"
    )  # fmt: skip
    for size in (1, 7, 100, len(text)):
        kept = io.StringIO()
        with redirect_stderr(kept), SolverWarnings(LABELS) as told:
            for k in range(0, len(text), size):
                sys.stderr.write(text[k : k + size])
        assert kept.getvalue().split() == ["a", "note", "the", "end"]
        assert told.counts == {"cost": 2, "sum": 1, "root": 1, "second derivatives": 1}


def test_other_threads_leave_the_standard_error_alone() -> None:
    before, found = sys.stderr, []

    def look() -> None:
        with SolverWarnings(LABELS) as told:
            found.append((told.heard, sys.stderr is before))

    thread = threading.Thread(target=look)
    thread.start()
    thread.join()
    assert found == [(False, True)]


def test_an_optimum_says_where_it_was_undefined_on_the_way(capsys: pytest.CaptureFixture[str]) -> None:
    text = "sqrt(1.05 - q_hinge)"
    usual = {**rest_to_rest({"hinge": 0.0}, {"hinge": 1.0}), "accuracy": None, "duration": (0.1, 10)}
    found = solve(TrajectoryProblem(
        pendulum(), **usual, bounds=Bounds(expressions={text: (0, 5)}), objectives=(Objective("time"),),
        transcription=Transcription(degree=2, intervals=4),
    ))  # fmt: skip
    assert found.solved and list(found.statistics.undefined) == [text] and not capsys.readouterr().err


PROBLEM = """[problem]
mechanism = "pendulum.toml"
duration = 1
accuracy = [1e-3, 1e-3]
[start]
coordinates = { hinge = 0.1 }
[end]
coordinates = { hinge = 0.3 }
[transcription]
intervals = 2
degree = 2
[bounds.expressions]
"sqrt(0.2 - q_hinge)" = [0, 1]
"""


def test_the_command_names_them(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given, out = tmp_path / "problem.toml", tmp_path / "motion.npz"
    given.write_text(PROBLEM)
    (tmp_path / "pendulum.toml").write_text(to_toml(pendulum()))
    assert main(["optimise", str(given), "--out", str(out)]) == 1
    said = capsys.readouterr()
    assert "warnings of the solver" in said.out and "sqrt(0.2 - q_hinge) (1)" in said.out
    assert "WARNING" not in said.err
    assert main(["optimise", str(given), "--out", str(out), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["warnings"] == {"sqrt(0.2 - q_hinge)": 1}


def test_all_guesses_name_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("os.cpu_count", lambda: 1)  # processes of their own say the same, and take a second each
    text = "sqrt(1.05 - q_hinge)"
    usual = {**rest_to_rest({"hinge": 0.0}, {"hinge": 1.0}), "accuracy": None, "duration": (0.1, 10)}
    problem = TrajectoryProblem(
        pendulum(), **usual, bounds=Bounds(expressions={text: (0, 5)}), objectives=(Objective("time"),),
        transcription=Transcription(degree=2, intervals=4),
    )  # fmt: skip
    many = solve(replace(problem, starts=3, seed=4))
    assert many.search is not None and [dict(a.undefined) for a in many.search.attempts] == [{text: 1}] * 3
    assert many.statistics.undefined == {text: 4}  # the best one is solved once more


def test_a_solver_that_fails_altogether_is_told_in_one_line() -> None:
    """CasADi's error of many lines: which file of its own it called, and then what is wrong."""
    text = "Error in Function::call at .../function.cpp:1655:\n.../os.cpp:335: failed:\nno library 'x'\n(\n"
    with pytest.raises(DescriptionError, match=r"solver: it fails: no library 'x'$"), SolverWarnings(LABELS):
        raise RuntimeError(text)


def test_what_solvers_print_is_no_part_of_the_result(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """`--json` is read by programs: a solver's own lines go to the standard error."""
    (tmp_path / "hinge.toml").write_text(to_toml(pendulum()), encoding="utf-8")
    file = tmp_path / "swing.toml"
    file.write_text(
        '[problem]\nmechanism = "hinge.toml"\nduration = 1\naccuracy = [1e-2, 1]\n[start]\ncoordinates.hinge = 0\n'
        "at_rest = true\n[end]\ncoordinates = { hinge = 0.3 }\nat_rest = true\n[transcription]\nintervals = 3\n"
        '[solver]\nname = "sqpmethod"\n',
        encoding="utf-8",
    )
    code = main(["optimise", str(file), "--out", str(tmp_path / "swing.npz"), "--json", "--no-cache"])
    out, err = capfd.readouterr()
    assert code == 0 and json.loads(out)["ok"] and "qpOASES" in err

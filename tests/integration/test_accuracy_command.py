"""`symscrew accuracy`: files, what is left out and why, bad input."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.accuracy_studies import EXAMPLES, QUIET, least_error, needs_compiler

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.model import derive
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.accuracy.states import Subject
from symscrew.studies.timing import quartiles


@pytest.mark.slow
@needs_compiler
def test_command_leaves_json_table_and_plots(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "120")  # no word of the table is folded
    out = tmp_path / "new" / "folder"
    assert main(["accuracy", "four_bar", "--study", "precision", "--out", str(out)]) == 0
    assert {p.name for p in out.iterdir()} == {"accuracy.json", "accuracy.md", "precision.png", "precision.svg"}
    content = json.loads((out / "accuracy.json").read_text())
    assert content["machine"]["processor"]
    assert "-O2" in content["machine"]["flags"]
    (study,) = content["studies"]
    assert study["points"][0]["cost"]["repeats"] >= 3
    assert study["reference_error"] < 1e-15
    shown = capsys.readouterr().out
    assert shown.startswith("| study")
    assert "inverse dynamics" in shown


def test_studies_that_a_scene_does_not_have_are_named_in_what_is_left(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """`--study all` of a scene: the studies that it has (here one, given), and why it has not the others."""
    from symscrew.studies.accuracy import every_study

    points = (Point("a", "", 0.5, quartiles([1.0])), Point("b", "", None, None, "a pivot is small"))
    given = Study(
        "forward",
        "A study",
        points,
        error_label="error",
        cost_label="time",
        cost_unit="ms",
        reference="none",
        reference_error=None,
    )
    usual = every_study.study_of

    def function(name: str, *arguments: object, full: bool):  # type: ignore[no-untyped-def]
        fails = name in ("kinematics", "momentum", "claims", "modes")
        return usual(name, *arguments, full=full) if fails else lambda *_, **__: given

    monkeypatch.setattr(every_study, "study_of", function)
    monkeypatch.setattr("symscrew.studies.accuracy.study_plots.save_study_plots", lambda *_: [])
    assert main(["accuracy", str(EXAMPLES / "simple_pendulum.toml"), "--study", "all", "--out", str(tmp_path)]) == 0
    content, table = (json.loads((tmp_path / "accuracy.json").read_text()), (tmp_path / "accuracy.md").read_text())
    assert [reason.split(":")[0] for reason in content["left_out"]] == ["kinematics", "momentum", "claims", "modes"]
    assert [len(study["points"]) for study in content["studies"]] == [2, 2, 2, 2]
    for text in (*content["left_out"], "failed: a pivot is small"):
        assert text in table
    shown = capsys.readouterr().out
    assert all(f"left out: {reason}" in shown for reason in content["left_out"])


@pytest.mark.slow
@needs_compiler
def test_command_on_a_folder_of_problems(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Error and time at the stated accuracy in a row; a scene without a reference is none of the problems."""
    monkeypatch.setenv("COLUMNS", "200")
    folder = tmp_path / "problems"
    (folder / "mechanisms").mkdir(parents=True)
    for name in ("simple_pendulum.toml", "simple_pendulum.reference.json", "mechanisms/simple_pendulum.toml"):
        (folder / name).write_bytes((EXAMPLES / name).read_bytes())
    (folder / "other.toml").write_bytes((EXAMPLES / "simple_pendulum.toml").read_bytes())
    reference = folder / "simple_pendulum.reference.json"
    content = json.loads(reference.read_text())
    published = {"text": "an engine: 0.5 s", "error": 1e-9, "seconds": 0.5}
    peers = {"mujoco RK4": {"1e-06": 0.1}, "generatedC proj": {"1e-08": 0.001, "1e-10": 0.002}}
    reference.write_text(json.dumps({**content, "published": [published], "peers": peers}))
    assert main(["accuracy", str(folder), "--out", str(tmp_path / "out")]) == 0
    (row,) = [line for line in capsys.readouterr().out.splitlines() if line.startswith("| simple_pendulum ")]
    cells = [cell.strip() for cell in row.strip("|").split("|")]
    assert float(cells[1]) == 1e-8 and float(cells[2]) <= 1e-8 and float(cells[3]) > 0
    assert cells[5:] == ["published an engine, 1e-09", "500", "1"]  # those who reach it, and are fastest
    assert main(["accuracy", str(folder), "--study", "momentum", "--out", str(tmp_path / "other")]) == 2
    assert "a folder is one of problems" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments, text",
    [
        (["four_bar", "--study", "momentums"], "did you mean 'momentum'"),
        (["four_bear"], "four_bar"),
        (["four_bar", "--study", "kinematics"], "section 5"),
        (["four_bar", "--study", "growth"], "n_four_bar.toml"),
        (["four_bar", "--problems", "no_such_folder"], "expected a folder of benchmark problems, got 'no_such_folder'"),
    ],
)
def test_bad_input_ends_with_one_line_and_no_files(
    arguments: list[str], text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert main(["accuracy", *arguments, "--out", str(out)]) == 2
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert error.startswith("symscrew: error:")
    assert text in error
    assert not out.exists()


def test_without_a_compiler_curves_of_c_are_left_out_and_named(monkeypatch: pytest.MonkeyPatch) -> None:
    from symscrew.studies.accuracy import momentum_study

    monkeypatch.setattr(momentum_study, "find_compiler", lambda: None)
    study = momentum_study.study(Subject(derive(catalogue.load("ur5"))), QUIET, repeats=1, seconds=0.1)
    assert "C compiler" in study.left_out[0]
    assert set(study.curves) == {"first-order difference, NumPy", "analytic, NumPy"}
    assert least_error(study, "analytic, NumPy") < 1e-11


def test_an_empty_study_says_why_and_what_to_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from symscrew.studies.accuracy import precision_study

    monkeypatch.setattr(precision_study, "find_compiler", lambda: None)
    assert main(["accuracy", "four_bar", "--study", "precision", "--out", str(tmp_path / "out")]) == 1
    shown = capsys.readouterr().out
    assert "left out: precision: all curves" in shown and "no C compiler; apt install gcc" in shown
    assert "| study" not in shown  # a table without rows says nothing

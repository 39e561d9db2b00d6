"""A study is one file, named in one table: it can be asked for by its name, and the command line knows it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path

import pytest

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.display import Progress
from symscrew.model import derive
from symscrew.studies import accuracy
from symscrew.studies.accuracy.every_study import STUDIES, StudyFile, problem_study, studies_of_a_mechanism, study_of
from symscrew.studies.accuracy.measuring import Study
from symscrew.studies.accuracy.states import Subject

STUDY = """
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.timing import quartiles


def study(subject, progress, *, repeats, seconds, **files):
    count = subject.model.programs["velocity"].operations["total"]
    point = Point("counting", str(files), 0.0, quartiles([seconds] * repeats), "", {"operations": count})
    labels = {"error_label": "error", "cost_label": "time", "cost_unit": "s"}
    return Study("counting", "Counting", (point,), **labels, reference="none", reference_error=0.0)
"""


@pytest.fixture
def another(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A further study: one file, one line of the table."""
    (tmp_path / "counting_study.py").write_text(STUDY)
    monkeypatch.setattr(accuracy, "__path__", [*accuracy.__path__, str(tmp_path)])
    monkeypatch.setitem(STUDIES, "counting", StudyFile("counting_study", "mechanism"))
    yield
    sys.modules.pop("symscrew.studies.accuracy.counting_study", None)


@pytest.mark.usefixtures("another")
def test_a_further_study_runs_by_its_name() -> None:
    subject = Subject(derive(catalogue.load("four_bar")))
    found = study_of("counting", subject, None, full=False)(Progress(quiet=True), repeats=3, seconds=0.5)
    assert isinstance(found, Study) and found.name == "counting"
    (point,) = found.points
    assert point.cost is not None and (point.cost.median, point.cost.repeats) == (0.5, 3)
    assert point.facts["operations"] == subject.model.programs["velocity"].operations["total"] > 0
    assert point.setting == "{}"  # files are for those who read them
    assert studies_of_a_mechanism()[-1] == "counting"


def test_studies_that_read_files_are_given_them(another: None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(STUDIES, "counting", StudyFile("counting_study", "mechanism", reads_files=True))
    subject = Subject(derive(catalogue.load("four_bar")))
    found = study_of("counting", subject, Path("scene.toml"), full=True)(Progress(quiet=True), repeats=1, seconds=1.0)
    assert found.points[0].setting == str({"path": Path("scene.toml"), "full": True})


@pytest.mark.usefixtures("another")
def test_the_command_line_knows_a_further_study(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["accuracy", "--help"])
    assert "counting or all of these" in " ".join(capsys.readouterr().out.split())
    assert main(["accuracy", "four_bar", "--study", "countin", "--out", str(tmp_path)]) == 2
    assert "did you mean 'counting'?" in capsys.readouterr().err


def test_every_study_of_the_table_is_a_file() -> None:
    folder = Path(accuracy.__path__[0])
    named = {entry.file for entry in STUDIES.values()}
    assert named == {path.stem for path in folder.glob("*_study.py")} - {"every_study"}
    for name in named:
        assert "\ndef study(" in (folder / f"{name}.py").read_text()


def test_a_study_of_a_problem_says_what_it_has(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from symscrew.studies.accuracy.transcription_study import Solve, TranscriptionStudy

    given = TranscriptionStudy("swing", 2.0, 1e-9, (Solve("Gauss 2", 5, 0.1, 7, 2.1, 0.1, 0.3),), ("Radau 2: no",))
    monkeypatch.setattr("symscrew.studies.accuracy.transcription_study.study", lambda problem, full: given)
    found = problem_study("transcription", None, full=False)  # type: ignore[arg-type]
    assert found is given and repr(found) == "TranscriptionStudy(swing: 1 solves, 1 left out)"
    assert "| Gauss 2 " in found.markdown() and found.markdown().endswith("left out: Radau 2: no\n")
    assert asdict(given)["points"][0]["cost"] == 2.1

"""The studies by name. A further one is a file of this folder with a function `study`, and a line in `STUDIES`.

    name --STUDIES--> file --study(subject, progress)--> Study          of a mechanism, a scene, a folder of problems
                           --study(problem)-----------> ProblemStudy    of an optimisation problem

Files are imported when their study is asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol, cast

if TYPE_CHECKING:
    from symscrew.display import Progress
    from symscrew.optimisation import TrajectoryProblem
    from symscrew.studies.accuracy.measuring import Study
    from symscrew.studies.accuracy.states import Subject


@dataclass(frozen=True)
class StudyFile:
    """Where a study is, and what it is a study of.

    `file`: a module of this folder. `of`: what `symscrew accuracy` needs to be given; all studies of a mechanism make
    up `--study all`. `reads_files`: its function takes `path`, of the scene or of the folder, and `full` as well.
    `note`: what the help says beside its name.
    """

    file: str
    of: Literal["mechanism", "scene", "folder", "problem"]
    reads_files: bool = False
    note: str = ""


STUDIES: dict[str, StudyFile] = {
    "kinematics": StudyFile("pose_study", "mechanism", reads_files=True),
    "momentum": StudyFile("momentum_study", "mechanism"),
    "forward": StudyFile("forward_study", "mechanism", reads_files=True),
    "precision": StudyFile("precision_study", "mechanism"),
    "digits": StudyFile("digits_study", "mechanism", note="single against double"),
    "effects": StudyFile("effects_study", "mechanism"),
    "claims": StudyFile("claims_study", "mechanism"),
    "modes": StudyFile("modes_study", "mechanism"),
    "growth": StudyFile("growth_study", "scene", reads_files=True, note="over the number of loops"),
    "problems": StudyFile("problems_study", "folder", reads_files=True),
    "transcription": StudyFile("transcription_study", "problem"),
}


class Measuring(Protocol):
    """A study that is ready to run: `repeats` interleaved repeats within about `seconds` [s]."""

    def __call__(self, progress: Progress, *, repeats: int, seconds: float) -> Study:
        """Run the study."""


class ProblemStudy(Protocol):
    """The result of a study of an optimisation problem: its solves, its text, its own files."""

    @property
    def points(self) -> Sequence[object]:
        """What was solved; none where nothing was."""

    def markdown(self) -> str:
        """The study as Markdown."""

    def write(self, directory: Path) -> list[Path]:
        """Write it into a folder that is there."""


def studies_of_a_mechanism() -> tuple[str, ...]:
    """The studies that any mechanism can be asked for: those of `--study all`."""
    return tuple(name for name, entry in STUDIES.items() if entry.of == "mechanism")


def study_of(name: str, subject: Subject | None, path: Path | None, *, full: bool) -> Measuring:
    """The study of this name (a key of STUDIES, not of a problem) on a model, ready to run.

    Args:
        name: of the study; its file is imported now.
        subject: the model, with its scene; None for a folder of problems.
        path: of the scene or the folder.
        full: whether it may take long.
    """
    entry = STUDIES[name]
    extra: dict[str, Any] = {"path": path, "full": full} if entry.reads_files else {}
    return cast(Measuring, partial(_function(entry), subject, **extra))


def problem_study(name: str, problem: TrajectoryProblem, *, full: bool) -> ProblemStudy:
    """Run the study of this name (a key of STUDIES, of a problem).

    Raises:
        DescriptionError: the problem has no solution to compare with.
    """
    return cast(ProblemStudy, _function(STUDIES[name])(problem, full=full))


def _function(entry: StudyFile) -> Any:
    return import_module(f"symscrew.studies.accuracy.{entry.file}").study

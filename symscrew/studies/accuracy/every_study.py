"""The studies by name. A further one is a file with a function `study`, named here."""

from __future__ import annotations

from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Protocol

from symscrew.display import Progress
from symscrew.studies.accuracy.measuring import Study
from symscrew.studies.accuracy.states import Subject

STUDIES = {
    "kinematics": "pose_study",
    "momentum": "momentum_study",
    "forward": "forward_study",
    "precision": "precision_study",
    "effects": "effects_study",
    "claims": "claims_study",
    "growth": "growth_study",
    "problems": "problems_study",
}
OF_A_MECHANISM = ("kinematics", "momentum", "forward", "precision", "effects", "claims")
TAKES_A_PATH = ("forward", "kinematics", "growth", "problems")  # of the scene or the folder of problems


class Measuring(Protocol):
    """A study that is ready to run: `repeats` interleaved repeats within about `seconds` [s]."""

    def __call__(self, progress: Progress, *, repeats: int, seconds: float) -> Study:
        """Run the study."""


def study_of(name: str, subject: Subject | None, path: Path | None, *, full: bool) -> Measuring:
    """The study of this name (a key of STUDIES) on a model, ready to run; its module is imported now."""
    found = import_module(f"symscrew.studies.accuracy.{STUDIES[name]}").study
    extra = {"path": path, "full": full} if name in TAKES_A_PATH else {}
    return partial(found, subject, **extra)

"""Accuracy against time of transcriptions: `symscrew accuracy PROBLEM.toml --study transcription`.

The cost of the same problem by several transcriptions, degrees and mesh sizes, against a reference of high degree on
a fine mesh whose own error is the change under refinement; and what each takes: the time in transcription and
solver by the processor's clock, the equations being derived once and shared.
"""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

from symscrew.description import markdown_text
from symscrew.display import aligned_table, save_figure
from symscrew.errors import DescriptionError
from symscrew.optimisation import Prepared, TrajectoryProblem, Transcription, prepare, solve
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.accuracy.study_plots import work_precision
from symscrew.studies.timing import quartiles
from symscrew.whole_files import write_text

MESHES, FULL_MESHES = (5, 10, 20, 40), (5, 10, 20, 40, 80, 160)  # doubled: an order shows as a constant ratio
FULL_REPEATS = 3  # the fastest counts: a solve takes seconds, and a disturbance makes it longer only
REFERENCE = (6, 40)  # degree and intervals; solved on twice as many too, the difference is the reference's own error
SCHEMES: tuple[tuple[str, Transcription], ...] = (
    ("Gauss 2, second order", Transcription("gauss", 2)),
    ("Gauss 3, second order", Transcription("gauss", 3)),
    ("Gauss 3, first order", Transcription("gauss", 3, second_order=False)),
    ("Radau 2, second order", Transcription("radau", 2)),
    ("Radau 3, second order", Transcription("radau", 3)),
    ("Radau 3, first order", Transcription("radau", 3, second_order=False)),
    ("Radau 5, second order", Transcription("radau", 5)),
    ("Gauss 3, forward dynamics", Transcription("gauss", 3, formulation="forward")),
    ("shooting", Transcription("shooting", 1)),
)


@dataclass(frozen=True)
class Solve:
    """One solve: the scheme, its intervals, processor time [s], iterations, cost, its error, error of the dynamics."""

    scheme: str
    intervals: int
    seconds: float
    iterations: int
    cost: float
    error: float
    dynamic: float


@dataclass(frozen=True)
class TranscriptionStudy:
    """All solves; `reference` is the cost they are compared with, `reference_error` its own error."""

    problem: str
    reference: float
    reference_error: float
    points: tuple[Solve, ...]
    left_out: tuple[str, ...]

    def __repr__(self) -> str:
        return f"TranscriptionStudy({self.problem}: {len(self.points)} solves, {len(self.left_out)} left out)"

    def markdown(self) -> str:
        """The study as Markdown."""
        rows = [
            [p.scheme, str(p.intervals), f"{p.seconds:.3f}", str(p.iterations), f"{p.cost:.10g}", f"{p.error:.1e}",
             f"{p.dynamic:.1e}"]
            for p in self.points
        ]  # fmt: skip
        header = (
            "transcription",
            "intervals",
            "time [s]",
            "iterations",
            "cost",
            "error of the cost",
            "dynamic [1/s^2]",
        )
        lines = [
            f"# Transcriptions of {markdown_text(self.problem)}",
            "",
            f"Reference: Gauss {REFERENCE[0]} on {2 * REFERENCE[1]} intervals, cost {self.reference:.12g}, "
            f"own error {self.reference_error:.1e}.",
            "",
            aligned_table(header, rows),
            *(f"\nleft out: {markdown_text(reason)}" for reason in self.left_out),
        ]
        return "\n".join(lines) + "\n"

    def as_study(self) -> Study:
        """The solves as points, for pictures in the style of all studies."""
        points = tuple(
            Point(p.scheme, f"{p.intervals} intervals", p.error, quartiles([p.seconds])) for p in self.points
        )
        return Study(
            "transcription", f"Transcriptions of {self.problem}", points, error_label="error of the cost",
            cost_label="processor time of a solve", cost_unit="s", reference="a high degree on a fine mesh",
            reference_error=self.reference_error,
        )  # fmt: skip

    def write(self, directory: Path) -> list[Path]:
        """Write `<problem>_transcription` .json, .md and .png into a folder that is there."""
        stem = f"{self.problem}_transcription"
        return [
            write_text(directory / f"{stem}.json", json.dumps(asdict(self), indent=1)),
            write_text(directory / f"{stem}.md", self.markdown()),
            save_figure(work_precision(self.as_study()), directory / f"{stem}.png", tight=True),
        ]


def study(
    problem: TrajectoryProblem, *, meshes: Sequence[int] = (), repeats: int = 0, full: bool = False
) -> TranscriptionStudy:
    """Solve a problem by all transcriptions on all meshes; the fastest of `repeats` solves counts.

    Meshes and repeats that are not given are those of a short study, or of a `full` one.

    Raises:
        DescriptionError: the problem has no reference solution.
    """
    meshes = meshes or (FULL_MESHES if full else MESHES)
    repeats = repeats or (FULL_REPEATS if full else 1)
    problem = replace(problem, accuracy=None)
    prepared = prepare(problem)
    reference, error = _reference(problem, prepared)
    points, left_out = [], []
    for name, scheme in SCHEMES:
        for n in meshes:
            given = replace(problem, transcription=replace(scheme, intervals=n, mesh=()))
            try:
                points.append(_timed(given, prepared, name, reference=reference, repeats=repeats))
            except (DescriptionError, ArithmeticError) as reason:
                left_out.append(f"{name}, {n} intervals: {reason}")
    return TranscriptionStudy(problem.name, reference, error, tuple(points), tuple(left_out))


def _reference(problem: TrajectoryProblem, prepared: Prepared) -> tuple[float, float]:
    degree, n = REFERENCE
    costs = []
    for count in (n, 2 * n):
        given = replace(problem, transcription=Transcription("gauss", degree, count))
        found = solve(given, prepared=prepared)
        if not found.ok:
            raise DescriptionError(f"the study needs a solution to compare with, but: {found.status}")
        costs.append(found.cost)
    return costs[1], abs(costs[1] - costs[0])


def _timed(problem: TrajectoryProblem, prepared: Prepared, name: str, *, reference: float, repeats: int) -> Solve:
    least, found = np.inf, None
    for _ in range(repeats):
        began = time.process_time()
        found = solve(problem, prepared=prepared)
        least = min(least, time.process_time() - began)
    assert found is not None
    if not found.ok:
        raise ArithmeticError(found.status)
    n = len(found.mesh) - 1
    error = abs(found.cost - reference)
    return Solve(name, n, least, found.statistics.iterations, found.cost, error, found.errors.dynamic)

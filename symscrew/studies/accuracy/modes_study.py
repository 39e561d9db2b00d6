"""Study "modes": how many assembly modes each way to solve the closure finds, how well, in what time.

Newton's method from random guesses, paths from a general mechanism in doubles, the same with certificates, and the C of
target `modes`. Reference: certified zeros, refined in integers of 200 bits.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.assembly import WaysToSolve, compiled_modes, modes_model, print_modes
from symscrew.display import Progress
from symscrew.errors import DescriptionError
from symscrew.runtime import find_compiler
from symscrew.studies.accuracy.measuring import Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.states import Subject

Array = np.ndarray[Any, Any]
GUESSES = (1, 10, 100)  # of Newton's method: a guess, some, as many as take about the time of the paths
SEED = 3  # of the guesses


class _Way:
    """A way to solve: what it found last."""

    def __init__(self, solve: Callable[[], Array], count: int) -> None:
        self.solve, self.zeros, self.facts = solve, np.zeros((0, 1)), dict[str, Any]()
        self.count = count

    def run(self) -> float:
        """Seconds."""
        start = time.perf_counter()
        self.zeros = self.solve()
        taken = time.perf_counter() - start
        self.facts["modes"] = f"{len(self.zeros)} of {self.count}"
        return taken

    def error(self, ways: WaysToSolve, known: Array) -> float:
        """Of the zeros that were found last."""
        return ways.distance(self.zeros, known)


def study(subject: Subject, progress: Progress, *, repeats: int, seconds: float) -> Study:
    """Errors of the coordinates of the closure, groups of length one, against time of a whole search."""
    mechanism, watch = subject.model.mechanism, Stopwatch()
    ways = watch("start system", WaysToSolve, mechanism)
    if not ways.square:
        raise DescriptionError(
            f"--study modes: {mechanism.name} has no loops whose equations are as many as their unknowns; use a "
            "mechanism such as stewart_6ups"
        )
    with progress.step("modes: certified"):
        known = ways.by_paths_and_boxes()
    made = {("Newton from guesses", f"{n}"): _Way(partial(ways.by_newton, n, SEED), len(known)) for n in GUESSES}
    made["paths in double", "NumPy"] = _Way(ways.by_paths, len(known))
    made["paths and certificates", "integers"] = _Way(ways.by_paths_and_boxes, len(known))
    left_out: tuple[str, ...] = ()
    with tempfile.TemporaryDirectory() as folder:
        try:
            made["paths and certificates", "C"] = _Way(_in_c(subject, Path(folder), watch), len(known))
        except DescriptionError as error:
            left_out = (f"C: {error}",)
        setups = [
            Setup(curve, setting, way.run, partial(way.error, ways, known), facts=way.facts)
            for (curve, setting), way in made.items()
        ]
        points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="modes")
    rows = [[curve, setting, str(way.facts.get("modes", ""))] for (curve, setting), way in made.items()]
    return Study(
        "modes",
        f"Assembly modes of {mechanism.name} at its reference",
        points,
        error_label="largest error of a zero found",
        cost_label="time of a search",
        cost_unit="ms",
        reference="zeros certified by Krawczyk's test and refined in integers of 200 bits, then rounded",
        reference_error=float(np.finfo(float).eps),
        preparation=watch.seconds,
        left_out=left_out,
        notes=(
            f"{len(known)} real zeros; limbs that hold one pose in several ways count once where the platform's does.",
            "An error says nothing of zeros that were not found: the table of modes does.",
        ),
        tables={"Modes found": (("way", "setting", "modes"), rows)},
    )


def _in_c(subject: Subject, folder: Path, watch: Stopwatch) -> Callable[[], Array]:
    """The search in C; raises DescriptionError where there is none."""
    if find_compiler() is None:
        raise DescriptionError("there is no C compiler")
    model = modes_model(subject.model.mechanism)
    for file, text in print_modes(model).items():
        (folder / file).write_text(text)
    compiled = watch("compile", compiled_modes, model, folder)
    drives: Sequence[float] = [reference for _, reference, _, _ in model.drives]

    def solve() -> Array:
        _, modes = compiled.modes(drives)
        return np.array([list(mode.z) for mode in modes]).reshape(-1, model.equations.width)

    return solve

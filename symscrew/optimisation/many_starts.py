"""Many guesses for one problem, on all cores: which optima there are, and how often each was found.

problem --usual guess, random ones--> attempts on the first mesh, in processes --> best guess, `Search`
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_EXCEPTION, wait
from dataclasses import dataclass, field, replace

import numpy as np

from symscrew.optimisation.consistent_poses import Kinematics
from symscrew.optimisation.guess import Guess, default_parameters
from symscrew.optimisation.guess_path import Path
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.workers import pool

Values = Mapping[str, Sequence[float]]
VALUES = 9  # of a random guess: three waves and the way between them
WAVES = 3  # sines that end with the motion, of falling size: what a motion swings back and forth more often is rare
LEAST_SWING = 1.0  # [rad, the mechanism's length] a coordinate that ends where it starts is varied by so much
MOST_HALVINGS = 6  # of a random way that leaves the reach of the loops: a swing of a radian becomes one of a degree
CHUNK = 2  # guesses a process takes at a time, for which it derives the equations once
SAME_COST = 1e-4  # relative: optima on one mesh are alike to 1e-8 of their cost, so what differs more is another


@dataclass(frozen=True)
class Attempt:
    """What came of a guess (None: the usual one): whether it is a motion, its cost, the solver's sentence.

    `undefined`: equation -> evaluations in which it was not finite, see `symscrew.optimisation.result.Statistics`.
    """

    guess: Values | None
    ok: bool
    cost: float
    status: str
    undefined: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class Search:
    """All attempts of a problem; `optima`: (cost, how often found), the least first."""

    attempts: tuple[Attempt, ...]

    @property
    def optima(self) -> list[tuple[float, int]]:
        """Costs that were found, and how often."""
        found: list[tuple[float, int]] = []
        for cost in sorted(a.cost for a in self.attempts if a.ok):
            if found and abs(cost - found[-1][0]) <= SAME_COST * max(abs(cost), abs(found[-1][0])):
                found[-1] = found[-1][0], found[-1][1] + 1
            else:
                found.append((cost, 1))
        return found

    @property
    def best(self) -> Attempt | None:
        """The attempt of least cost; None where none is a motion."""
        return min((a for a in self.attempts if a.ok), key=lambda a: a.cost, default=None)

    @property
    def undefined(self) -> Counter[str]:
        """Equation -> evaluations of all attempts in which it was not finite."""
        return sum((Counter(a.undefined) for a in self.attempts), Counter[str]())

    @property
    def share(self) -> float:
        """Share of the guesses that led to the best cost."""
        return self.optima[0][1] / len(self.attempts) if self.optima else 0.0

    def __str__(self) -> str:
        """In words."""
        parts = [f"{cost:.6g} by {count}" for cost, count in self.optima[:SHOWN]]
        more = sum(count for _, count in self.optima[SHOWN:])
        parts += [f"others by {more}"] if more else []
        none = sum(not a.ok for a in self.attempts)
        return f"of {len(self.attempts)} guesses: cost " + ", ".join([*parts, f"no motion by {none}"])


SHOWN = 4  # optima that are named
Attempts = Callable[[TrajectoryProblem, Sequence[Values | None]], list[Attempt]]


def searched(problem: TrajectoryProblem, model: PointModel, guess: Guess, attempts: Attempts) -> Search:
    """Solve a problem from its `starts` guesses; `attempts` is a function at the top of a file, for processes."""
    every: list[Values | None] = [None, *random_guesses(problem, model, guess)]
    one = replace(problem, starts=1, seed=1, accuracy=None)
    chunks = [every[k : k + CHUNK] for k in range(0, len(every), CHUNK)]
    count = min(os.cpu_count() or 1, len(chunks))
    if count == 1:
        return Search(tuple(attempts(one, every)))
    with pool(count, "spawn") as processes:
        jobs = [processes.submit(attempts, one, chunk) for chunk in chunks]
        try:
            wait(jobs, return_when=FIRST_EXCEPTION)
            return Search(tuple(attempt for job in jobs for attempt in job.result()))
        finally:  # interrupted: what has not begun is not begun
            processes.shutdown(wait=False, cancel_futures=True)


def random_guesses(problem: TrajectoryProblem, model: PointModel, guess: Guess) -> list[Values]:
    """Ways around that of the usual guess: (starts - 1) times values of all y at equal times, by the problem's seed.

    What leaves the reach of closed loops is drawn nearer to the usual way: no solver starts from there.
    """
    random = np.random.default_rng(problem.seed)
    part = np.linspace(0.0, 1.0, VALUES)
    way = guess.path(part)[0]
    entries = model.equations.layout.y
    length = model.system.length
    units = np.array([length if model.system.tree.q[k].kind == "length" else 1.0 for k in entries])
    swing = np.maximum(np.ptp(way, axis=0), LEAST_SWING * units)
    waves = np.sin(np.pi * part[:, None] * np.arange(1, WAVES + 1)) / np.arange(1, WAVES + 1)
    kinematics = Kinematics(model, default_parameters(model))
    found: list[Values] = []
    for _ in range(problem.starts - 1):
        beside = waves @ random.standard_normal((WAVES, len(entries))) * swing
        for halving in range(MOST_HALVINGS):
            path = Path(part, way + beside, np.gradient(way + beside, part, axis=0))
            if kinematics.assemble_all(path(guess.tau)[0], guess.q)[1].all():
                beside = beside / 2 if halving else beside  # not just within reach, where drives are endless
                break
            beside = beside / 2
        values = way + beside
        found.append({label: values[:, k].tolist() for k, label in enumerate(model.equations.labels)})
    return found

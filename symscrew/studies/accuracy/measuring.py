"""The measuring harness: every setup of a study in interleaved repeats, medians and quartiles, failures kept."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field
from typing import Any

import numpy as np

from symscrew.display import Progress
from symscrew.studies.timing import Times, quartiles

CACHES_DO_NOT_MATTER = 0.2  # s: a first run that takes longer counts, caches and pages are a small part of it
LEAST_ROUNDS = 3  # of every setup, however long it takes: below, there are no quartiles


@dataclass(frozen=True)
class Setup:
    """One way to compute something: a curve's name, its setting (the step, the tolerance), and how it runs.

    `run` computes once and returns the seconds that the computation itself took; it is called many times. `error`
    gives the error of the last run. Both may raise ArithmeticError or ValueError: the point then stays as failed.
    `share` divides the seconds: states evaluated, or simulated seconds.
    """

    curve: str
    setting: str
    run: Callable[[], float]
    error: Callable[[], float]
    share: float = 1.0
    facts: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Point:
    """What a setup gave: its error and its cost per share [s], or the reason why it failed."""

    curve: str
    setting: str
    error: float | None
    cost: Times | None
    failure: str = ""
    facts: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Study:
    """The result of a study: points, what their axes are, the reference with its own error, what was left out.

    `cost_label` names the abscissa and `cost_unit` its unit in tables and plots ("ns": costs are multiplied by 1e9;
    "operations": the abscissa is the fact of that name). `preparation`: seconds by step (derive, print, compile), apart
    from all costs.
    """

    name: str
    title: str
    points: tuple[Point, ...]
    _: KW_ONLY
    error_label: str
    cost_label: str
    cost_unit: str
    reference: str
    reference_error: float | None
    preparation: Mapping[str, float] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    tables: Mapping[str, tuple[Sequence[str], Sequence[Sequence[str]]]] = field(default_factory=dict)

    def __repr__(self) -> str:
        failed = sum(point.error is None for point in self.points)
        return f"Study({self.name}: {len(self.points)} points on {len(self.curves)} curves, {failed} failed)"

    @property
    def curves(self) -> dict[str, list[Point]]:
        """Points by curve, in order."""
        found: dict[str, list[Point]] = {}
        for point in self.points:
            found.setdefault(point.curve, []).append(point)
        return found


def measured(
    setups: Sequence[Setup],
    *,
    repeats: int,
    seconds: float,
    progress: Progress | None = None,
    text: str = "",
    longest: float = math.inf,
) -> tuple[Point, ...]:
    """Every setup once, then A B C A B C ... until each has `repeats` repeats or `seconds` are over.

    A disturbance so meets all of them. Each has at least three repeats; from then on those that take longest are
    left out first, when the time is over. The first run of a setup counts for its error alone: caches and pages are
    not there yet. After a first run of more than `longest` seconds the later settings of its curve are not run, and
    stay in the table as such.
    """
    shown = progress or Progress(quiet=True)
    start = time.perf_counter()
    laps: list[list[float]] = [[] for _ in setups]
    errors: list[float | None] = [None] * len(setups)
    failures = [""] * len(setups)
    slow_curves: dict[str, float] = {}
    for k in shown.bar(range(len(setups)), f"{text}: first runs"):
        if setups[k].curve in slow_curves:
            failures[k] = f"not run: the setting before took {slow_curves[setups[k].curve]:.1f} s"
            continue
        begin, first = time.thread_time(), None
        try:
            first = setups[k].run()
            errors[k] = float(setups[k].error())
            if not math.isfinite(errors[k] or 0.0):
                errors[k], failures[k] = None, "the result is not finite"
            if first > CACHES_DO_NOT_MATTER:
                laps[k].append(first)
        except (ArithmeticError, ValueError, np.linalg.LinAlgError) as error:
            failures[k] = str(error) or type(error).__name__
        taken = time.thread_time() - begin if first is None else first
        if taken > longest:
            slow_curves[setups[k].curve] = taken
    for done in shown.bar(range(repeats), f"{text}: repeats"):
        over = time.perf_counter() - start > seconds
        if over and done >= LEAST_ROUNDS:
            break
        for k, setup in enumerate(setups):
            slow = over and len(laps[k]) >= LEAST_ROUNDS
            if not failures[k] and len(laps[k]) < repeats and not slow:
                laps[k].append(setup.run())
    return tuple(
        Point(s.curve, s.setting, errors[k], _cost(laps[k], s.share), failures[k], s.facts)
        for k, s in enumerate(setups)
    )


def _cost(laps: Sequence[float], share: float) -> Times | None:
    return quartiles([lap / share for lap in laps]) if laps else None


class Stopwatch:
    """Seconds of the steps of a preparation, added up by name."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}

    def __call__(self, name: str, function: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        """Result of the call; its seconds are added to those of `name`."""
        start = time.perf_counter()
        result = function(*arguments, **named)
        self.seconds[name] = self.seconds.get(name, 0.0) + time.perf_counter() - start
        return result

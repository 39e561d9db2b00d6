"""Runs of equal instructions one after the other: joint after joint of a chain, loop after loop, row after row.

Two instructions are alike if they do the same operation on operands of the same kind. What was computed a few
instructions before is of the same kind if it is equally far back; anything else is as its source says: a constant,
an entry of the same array, or an earlier value.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.program import Instruction

NEAR = 60  # operands from so many instructions back must be equally far back; from farther they wait in an array
WINDOW = 6  # instructions that are compared to find how far apart equal ones are: fewer are alike everywhere
# Longest period, more than a joint or a row of a matrix takes; what repeats farther apart is written out.
FARTHEST = 3000
# A run becomes a loop if it saves so many instructions and has so many iterations: arrays and indices of a shorter one
# take as much text and time as they save. Shorter runs are written out.
SAVED = 60
SEVERAL = 3


@dataclass(frozen=True)
class Run:
    """`count` times `period` instructions from `start` on, alike time after time."""

    start: int
    period: int
    count: int

    @property
    def saved(self) -> int:
        """Instructions that need not be printed."""
        return self.period * (self.count - 1)

    @property
    def end(self) -> int:
        """The first instruction behind."""
        return self.start + self.period * self.count


def runs(instructions: Sequence[Instruction], kind: Callable[[int | float], object]) -> list[Run]:
    """Runs that do not overlap, in order, those that save most first served.

    `kind` tells what matters of an operand that the instructions do not compute, and of a target where it goes.
    """
    kinds = _kinds(instructions, kind)
    waiting = [(-run.saved, run.start, run.period, run.count) for p in _periods(kinds) for run in _alike(kinds, p)]
    heapq.heapify(waiting)
    free = np.ones(len(kinds), dtype=bool)
    found: list[Run] = []
    while waiting:
        _, start, period, count = heapq.heappop(waiting)
        run = Run(start, period, count)
        if free[run.start : run.end].all():
            found.append(run)
            free[run.start : run.end] = False
            continue
        taken = np.flatnonzero(~free[run.start : run.end])
        edges = np.concatenate([[-1], taken, [run.end - run.start]]) + run.start
        for before, after in zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True):
            rest = Run(before + 1, period, (after - before - 1) // period)
            if _worthwhile(rest):
                heapq.heappush(waiting, (-rest.saved, rest.start, rest.period, rest.count))
    return sorted(found, key=lambda run: run.start)


def _worthwhile(run: Run) -> bool:
    return run.count >= SEVERAL and run.saved >= SAVED


def _kinds(instructions: Sequence[Instruction], kind: Callable[[int | float], object]) -> np.ndarray:
    """A number per instruction, the same for those that are alike."""
    position = {instruction.target: k for k, instruction in enumerate(instructions)}
    numbers: dict[object, int] = {}
    known: dict[int, object] = {}  # kinds of slots from elsewhere
    result = []
    for k, (target, op, args) in enumerate(instructions):
        label: list[object] = [op]
        for a in args:
            if type(a) is not int:
                label.append(kind(a))
                continue
            at = position.get(a)
            if at is not None:
                label.append(k - at if k - at <= NEAR else "earlier")
                continue
            if a not in known:
                known[a] = kind(a)
            label.append(known[a])
        label.append(kind(target))
        result.append(numbers.setdefault(tuple(label), len(numbers)))
    return np.array(result, dtype=np.int64)


def _periods(kinds: np.ndarray) -> list[int]:
    """Distances at which equal windows follow each other often enough."""
    if len(kinds) < WINDOW + 1:
        return []
    windows = np.zeros(len(kinds) - WINDOW + 1, dtype=np.uint64)
    for k in range(WINDOW):
        windows = windows * np.uint64(1_000_003) + kinds[k : k + len(windows)].astype(np.uint64)
    order = np.argsort(windows, kind="stable")
    same = windows[order][1:] == windows[order][:-1]
    apart = np.diff(order)[same]
    often = np.bincount(apart[apart <= FARTHEST], minlength=1)
    return [int(p) for p in np.flatnonzero(often >= SAVED)]


def _alike(kinds: np.ndarray, period: int) -> list[Run]:
    """The longest runs of a period."""
    differs = np.flatnonzero(kinds[:-period] != kinds[period:])
    edges = np.concatenate([[-1], differs, [len(kinds) - period]])
    lengths = np.diff(edges) - 1
    found = (Run(int(edges[k]) + 1, period, int(lengths[k]) // period + 1) for k in np.flatnonzero(lengths >= period))
    return [run for run in found if _worthwhile(run)]

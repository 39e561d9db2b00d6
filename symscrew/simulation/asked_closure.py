"""What a start asks of the loops, and the answers: of many starts at once, in the same numbers as of one.

    questions of many starts --by kind, one evaluation each--> residual and Jacobian, (dJ/dt) v, q moved by a step

Rows and rates have no units: lengths are divided by the mechanism's.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np

from symscrew.model import Model

Found = TypeVar("Found")
Asking = Generator["Question", Any, Found]
"""A start that asks, is sent the answers, and returns what it found."""


class At(NamedTuple):
    """Asks for residual and Jacobian of the loops at q."""

    q: np.ndarray


class Bias(NamedTuple):
    """Asks for (dJ/dt) v at q."""

    q: np.ndarray
    v: np.ndarray


class Moved(NamedTuple):
    """Asks for q moved by a step in rates (nv,)."""

    q: np.ndarray
    step: np.ndarray


Question = At | Bias | Moved


class Closure:
    """Residual and Jacobian of the loops without units; columns are rates v divided by their unit."""

    def __init__(self, model: Model) -> None:
        system = model.system
        self.model, self.system = model, system
        self.rows = np.array([1 / system.length if r.unit == "N" else 1.0 for cut in system.cuts for r in cut.rows])
        self.units = np.array([system.length if c.kind == "length" else 1.0 for c in system.tree.v])
        self.of_places = np.array([row.holonomic for cut in system.cuts for row in cut.rows], dtype=bool)

    def of_coordinates(self, residual: np.ndarray, matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The rows that coordinates must obey: rolling may get a wheel anywhere."""
        return residual[self.of_places], matrix[self.of_places]

    def answers(self, questions: Mapping[int, Question], parameters: Sequence[np.ndarray]) -> Iterator[tuple[int, Any]]:
        """The answer of every question, each kind evaluated at once; `parameters` by the number of the start."""
        kinds: tuple[tuple[type, Callable[..., Iterator[Any]]], ...] = (
            (At, self.at), (Bias, self.bias), (Moved, self.moved),
        )  # fmt: skip
        for kind, answer in kinds:
            mine = [k for k, question in questions.items() if isinstance(question, kind)]
            if mine:
                arrays = [np.array(values) for values in zip(*(questions[k] for k in mine), strict=True)]
                p = np.array([parameters[k] for k in mine])
                yield from zip(mine, answer(*arrays, *([p] if p.shape[1] and kind is not Moved else ())), strict=True)

    def at(self, q: np.ndarray, *p: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Residual (rows,) and Jacobian (rows, nv) of every state."""
        n = len(self.units)
        if not len(self.rows):
            yield from [(np.zeros(0), np.zeros((0, n)))] * len(q)
            return
        (residual,), _ = self.model("closure", q, *p)
        (jacobian,), _ = self.model("closure_jacobian", q, *p)
        for r, j in zip(residual, jacobian.reshape(len(q), -1), strict=True):
            yield r * self.rows, j.reshape(n, len(self.rows)).T * self.rows[:, None] * self.units

    def bias(self, q: np.ndarray, v: np.ndarray, *p: np.ndarray) -> Iterator[np.ndarray]:
        """(dJ/dt) v of every state, without units."""
        (found,), _ = self.model("closure_bias", q, v, *p)
        yield from found * self.rows

    def moved(self, q: np.ndarray, step: np.ndarray) -> Iterator[np.ndarray]:
        """q of every state after its step."""
        yield from self.system.moved(q, step)

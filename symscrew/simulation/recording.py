"""What an integrator takes and hands over: a state; samples, what it met, how it ended.

State (q, v, x) --native, portable or sundials--> History
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np


@dataclass(frozen=True)
class Estimate:
    """`error`: largest difference of a coordinate [rad, characteristic lengths] to the other run; NaN: there is none,
    infinite: it did not come to its end, and `stopped` says where and why.

    `other`: what the other run has, in words. `growth`: by how much the differences grew from the first tenth of the
    run to its end. `part`: the largest error of a coordinate by its own way from where it starts.
    """

    error: float = np.nan
    growth: float = np.nan
    part: float = np.nan
    stopped: str = "stopped"
    other: str = "another tolerance"


State = tuple[np.ndarray, np.ndarray, np.ndarray]  # q (nq,), v (nv,), x (nx,) at one time


class Instant(NamedTuple):
    """A state with its time [s]."""

    t: float
    q: np.ndarray
    v: np.ndarray
    x: np.ndarray


@dataclass(frozen=True)
class Passage:
    """A singular configuration on the way: `rows` are indices of the closure rows that lose their independence."""

    t: float
    q: np.ndarray
    pivot: float
    lost: int
    rows: tuple[int, ...]


@dataclass(frozen=True)
class History:
    """Samples t (n,), q (n, nq), v (n, nv), x (n, nx); u (n, drives) where they came from outside.

    `passing`: steps of a fixed length that are longer than what the scene's inputs do within them.
    `contact_forces` (n, contacts): inputs of effects that the integrator determined itself. `losses`: time [s], joint
    and energy [J] of every impact. `doubts`: what the integrator met that it has no treatment of, in words. `fastest`:
    the state with the greatest rates at the end of a step, which all samples may miss.
    """

    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    x: np.ndarray
    ok: bool
    status: str
    backend: str
    crossings: tuple[Passage, ...] = ()
    events: tuple[str, ...] = ()
    counters: Mapping[str, float] = field(default_factory=dict)
    u: np.ndarray | None = None
    contact_forces: np.ndarray | None = None
    losses: tuple[tuple[float, str, float], ...] = ()
    estimate: Estimate | None = None
    doubts: tuple[str, ...] = ()
    fastest: Instant | None = None
    passing: bool = False

    @property
    def forces(self) -> np.ndarray:
        """Contact forces (n, contacts), of no columns where there are none."""
        return np.zeros((len(self.t), 0)) if self.contact_forces is None else self.contact_forces


def faster(known: Instant | None, other: Instant, units: np.ndarray) -> Instant | None:
    """Whichever has the greater rates, divided by their units; None where nothing moves."""
    sizes = [0.0 if at is None else float(np.sum((at.v / units) ** 2)) for at in (known, other)]
    return other if sizes[1] > sizes[0] else known


def shown_time(t: float) -> str:
    """A time [s] with all digits that are meant: those of the double, at most to 1e-12 s, below 1 ms ten of them."""
    return f"{round(t, 12):.15g}" if not 0 < abs(t) < 1e-3 else f"{t:.10g}"

"""What a scene is, as immutable data.

mechanism + effects + start + drives (expressions of t, q, v, states, tables) + integrator = Scene
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.effects import Effect

INTERPOLATIONS = ("linear", "cubic")  # words of scene files


@dataclass(frozen=True)
class Table:
    """A function of time by its values at `times` [s], ascending; constant outside."""

    name: str
    times: tuple[float, ...]
    values: tuple[float, ...]
    interpolation: str = "linear"

    def pieces(self) -> np.ndarray:
        """Coefficients (n-1, 4) of the polynomial c0 + c1 d + c2 d^2 + c3 d^3 of each piece, d = t - times[k].

        "cubic": piecewise cubic with the slopes of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5, 1984, 300):
        once differentiable, and never outside the values between two neighbours.
        """
        t, y = np.array(self.times), np.array(self.values)
        h = np.diff(t)
        slope = np.diff(y) / h
        zero = np.zeros_like(slope)
        if self.interpolation == "linear" or len(t) == 2:
            return np.stack([y[:-1], slope, zero, zero], axis=1)
        d = np.zeros_like(y)
        left, right = slope[:-1], slope[1:]
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (h[:-1] + 2 * h[1:]) / (3 * (h[:-1] + h[1:]))
            inner = left * right / (part * right + (1 - part) * left)
        d[1:-1] = np.where(left * right > 0, inner, 0.0)
        d[0], d[-1] = slope[0], slope[-1]
        return np.stack([y[:-1], d[:-1], (3 * slope - 2 * d[:-1] - d[1:]) / h, (d[:-1] + d[1:] - 2 * slope) / h**2], 1)

    def __call__(self, t: object) -> np.ndarray:
        """Values at times t [s], any shape."""
        at = np.clip(np.asarray(t, dtype=float), self.times[0], self.times[-1])
        piece = np.clip(np.searchsorted(self.times, at, side="right") - 1, 0, len(self.times) - 2)
        c = self.pieces()[piece]
        d = at - np.array(self.times)[piece]
        return np.asarray(c[..., 0] + d * (c[..., 1] + d * (c[..., 2] + d * c[..., 3])))


@dataclass(frozen=True)
class Initial:
    """Where a run begins: values of coordinates and rates by label; all others follow from the closure.

    Coordinates that are not given stay as near to the reference configuration as the loops allow; rates that are
    not given are the smallest that the loops allow. Values that the loops contradict are refused, unless `hold` names
    the coordinates that are sure: these keep their values and rates, the other given ones are changed by as little as
    closes the loops, and the run's events say from what to what. `notices`: of bare angles that look like degrees.
    `mode`: name of an assembly mode (`symscrew assemble` lists them) in place of that of the reference.
    """

    coordinates: Mapping[str, float] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    hold: tuple[str, ...] | None = None
    notices: tuple[str, ...] = ()
    mode: str = ""


@dataclass(frozen=True)
class Integrator:
    """How to integrate: `method` is one of `symscrew.scene.INTEGRATION_METHODS`.

    `tolerance` is the error aimed at in the result: local errors are held to a thousandth of it, lengths divided by
    the characteristic length. `step` [s] belongs to the fixed-step methods. `longest_step` [s] bounds adaptive
    ones, `most_steps` all.
    """

    method: str = "dop853"
    tolerance: float = 1e-8
    step: float | None = None
    longest_step: float | None = None
    most_steps: int = 10_000_000


@dataclass(frozen=True, repr=False)
class Scene:
    """A scene. Texts with expressions are kept as they were written, to be read against the model's names.

    `drives`: expression per driven freedom by its label in u; the others are not driven. `signals`: named
    expressions for use in others, in order. `states`: name -> (expression of the rate, value at the start): states
    of the controller. `inputs`: port of an effect -> expressions of its entries. `parameters`: run-time parameters.
    """

    name: str
    mechanism: Mechanism
    effects: tuple[Effect, ...]
    duration: float
    rate: float
    initial: Initial = Initial()
    drives: Mapping[str, str] = field(default_factory=dict)
    signals: Mapping[str, str] = field(default_factory=dict)
    tables: Mapping[str, Table] = field(default_factory=dict)
    states: Mapping[str, tuple[str, float]] = field(default_factory=dict)
    inputs: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    parameters: Mapping[str, float] = field(default_factory=dict)
    integrator: Integrator = Integrator()
    reactions: bool = False
    description: str = ""
    text: str = ""
    further: Mapping[str, Any] = field(default_factory=dict)

    def __repr__(self) -> str:
        return (
            f"<Scene {self.name}: {self.mechanism.name}, {self.duration:g} s by {self.integrator.method}, "
            f"{len(self.effects)} effect{'s' * (len(self.effects) != 1)}, "
            f"{len(self.drives)} drive{'s' * (len(self.drives) != 1)}>"
        )

    @property
    def times(self) -> np.ndarray:
        """Times of the outputs [s]: every 1/rate from 0, and the end."""
        count = int(np.floor(self.duration * self.rate * (1 + 1e-12)))
        times = np.arange(count + 1) / self.rate
        if self.duration - times[-1] > 1e-9 / self.rate:  # else rounding alone separates the end from an output
            times = np.append(times, self.duration)
        times[-1] = self.duration
        return times

"""Steps of a given length, of slopes that are called from Python.

slopes, state --formula of the method--> state a step later
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.simulation.recording import State

Slopes = Callable[[float, np.ndarray], np.ndarray]


class Stepped(Protocol):
    """What a step asks of a run: slopes of y = (q, v, x), its parts, and steps on the manifold."""

    f: Any

    def slopes(self, t: float, y: np.ndarray) -> np.ndarray:
        """Rates of y."""

    def parts(self, y: np.ndarray) -> State:
        """q, v, x."""


def euler(run: Stepped, t: float, y: np.ndarray, h: float) -> np.ndarray:
    """The slope at the start, all the way."""
    q, v, x = run.parts(y)
    rates = run.slopes(t, y)
    _, a, x_dot = run.parts(rates)
    return np.concatenate([run.f.moved(q, h * v), v + h * a, x + h * x_dot])


def semi_implicit(run: Stepped, t: float, y: np.ndarray, h: float) -> np.ndarray:
    """Rates first, then places with the new rates."""
    q, v, x = run.parts(y)
    _, a, x_dot = run.parts(run.slopes(t, y))
    v = v + h * a
    return np.concatenate([run.f.moved(q, h * v), v, x + h * x_dot])


def rk4(run: Stepped, t: float, y: np.ndarray, h: float) -> np.ndarray:
    """Runge and Kutta's formula of order 4."""
    k1 = run.slopes(t, y)
    k2 = run.slopes(t + h / 2, y + h / 2 * k1)
    k3 = run.slopes(t + h / 2, y + h / 2 * k2)
    k4 = run.slopes(t + h, y + h * k3)
    return np.asarray(y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))


def rk8(run: Stepped, t: float, y: np.ndarray, h: float) -> np.ndarray:
    """Dormand and Prince's formula of order 8."""
    rule = scipy_integrate().DOP853
    k = np.zeros((12, len(y)))
    for stage in range(12):
        k[stage] = run.slopes(t + rule.C[stage] * h, y + h * (rule.A[stage, :stage] @ k[:stage]))
    return np.asarray(y + h * (rule.B @ k))


def scipy_integrate() -> Any:
    """SciPy's integrators."""
    try:
        import scipy.integrate
    except ImportError as error:
        raise DescriptionError(
            'this integrator needs SciPy, which is not installed: pip install "symscrew[simulation]"'
        ) from error
    return scipy.integrate


def cubic(
    slopes: Slopes, start: tuple[float, np.ndarray], stop: tuple[float, np.ndarray]
) -> Callable[[float], np.ndarray]:
    """States within a step between a time and a state, and another one: Hermite's cubic, exact at both ends."""
    (t, y), (end, after) = start, stop
    h = end - t
    first, last = h * slopes(t, y), h * slopes(end, after)

    def within(time: float) -> np.ndarray:
        part = (time - t) / h
        rest = 1 - part
        if part >= 1:
            return after
        return np.asarray(
            rest * rest * ((1 + 2 * part) * y + part * first) + part * part * ((1 + 2 * rest) * after - rest * last)
        )

    return within


FIXED_STEPS: Mapping[str, Callable[[Any, float, np.ndarray, float], np.ndarray]] = {
    "euler": euler,
    "semi_implicit_euler": semi_implicit,
    "rk4": rk4,
    "rk8": rk8,
}

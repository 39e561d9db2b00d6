"""States where a pivot of an elimination vanishes, or a value meets its limit: searched for, not waited for.

    values on random lines --a sign changes--> brackets, divided until doubles end --> states on both sides
    those that were found  --roundings beside-->                                       the best of them
                           --still none-->     lines through the best, closer and closer --> where it is least

Only where the checks before it say nothing does a check decide: of a pivot that is not found small at such a state, the
least size there is told, beside its limit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from symscrew.export import Precision
from symscrew.program import QUATERNION, Port, Program, evaluate

SCALES = (2.0, 2.0, 2.0, 0.2, 0.2, 0.02) * 3  # of random lines: whole turns, and lengths of small machines
POINTS = 65  # on a line: a sign change of two zeros that are closer is not seen on it, perhaps on another
BRACKETS = 3  # states per value: another condition may stand before it on one
PARTS, ROUNDS = 32, 13  # into which a bracket is divided, and how often: 2^-65 of it, where doubles end
ROUNDINGS = 64  # states some roundings beside one, of which the best is taken: a value need not be 0 at a double
DESCENTS, RAYS, STEPS = 40, 6, 16  # rounds of looking for the least size, lines through the best, points on each half
CLOSER = 0.3  # by which lines shorten where none was better; thirty times so and they are 1e-16 of the first


@dataclass(frozen=True)
class Found:
    """States, each an array per input, and per guard of the program the least size that any of them gave it."""

    states: list[list[np.ndarray]]
    least: tuple[float, ...]


def pivot_states(step: Program, own: Sequence[np.ndarray], rng: np.random.Generator, real: Precision) -> Found:
    """Where each guard and limit of a program is met.

    Args:
        step: the program.
        own: ordinary states, an array (states, size) per input; the lines begin at them.
        rng: of the lines.
        real: the precision, by which the limits of pivots are.
    """
    checks = tuple(
        _Check(slot, sign, bound)
        for slot, low, high, _ in step.limits
        for sign, bound in ((1.0, low), (-1.0, high))
        if bound is not None
    )
    checks += tuple(_Check(slot, 0.0, limit**real.digits) for slot, limit in step.guards)
    if not checks or not own or not sum(port.size for port in step.inputs):
        return Found([], tuple(np.inf for _ in step.guards))
    space = _Space(step, tuple(own), checks)
    starts = np.array([space.own[k % len(space.own)] for k in range(len(SCALES))])
    along = rng.normal(size=starts.shape) * np.array(SCALES)[:, None]
    line = np.linspace(-1.0, 1.0, POINTS)
    points = (starts[:, None] + line[:, None] * along[:, None]).reshape(-1, starts.shape[1])
    seen = space.values(points).reshape(len(starts), POINTS, -1)
    states: list[np.ndarray] = []
    least = []
    for k, check in enumerate(checks):
        found = space.crossings(k, _Lines(starts, along, line, seen))
        size = min([np.inf, *(space.sizes(k, np.array(found)) if found else ())])
        if size > check.limit and states:
            found += [space.beside(k, np.array(states), rng)]
            size = min(size, space.sizes(k, found[-1][None])[0])
        if size > check.limit:
            own_sizes = space.sizes(k, points)
            start = points[own_sizes.argmin()] if own_sizes.min() < size or not found else found[-1]
            found += [space.least(k, start, rng)]
            size = min(size, space.sizes(k, found[-1][None])[0])
        states += found
        least.append(float(size))
    return Found([space.split(x) for x in states], tuple(least[len(checks) - len(step.guards) :]))


@dataclass(frozen=True)
class _Check:
    """A value of which a program wants sign * value >= sign * bound; of sign 0 that its size is more than bound."""

    slot: int
    sign: float
    bound: float

    @property
    def limit(self) -> float:
        return 0.0 if self.sign else self.bound

    def left(self, value: np.ndarray) -> np.ndarray:
        """How far from where it says no: a size, or the sign's distance, negative beyond."""
        return self.sign * (value - self.bound) if self.sign else np.abs(value)


@dataclass(frozen=True)
class _Lines:
    """Lines, the parts of them that are points, and the values there (line, part, check)."""

    starts: np.ndarray
    along: np.ndarray
    parts: np.ndarray
    seen: np.ndarray


@dataclass(frozen=True)
class _Space:
    """All inputs of a program as one array, quaternions at length 1, and its checks in the order of the code."""

    step: Program
    inputs: tuple[np.ndarray, ...]
    checks: tuple[_Check, ...]

    @property
    def own(self) -> np.ndarray:
        return np.hstack([np.atleast_2d(x).astype(float) for x in self.inputs])

    def split(self, x: np.ndarray) -> list[np.ndarray]:
        """An array per input, of points (..., size)."""
        ends = np.cumsum([port.size for port in self.step.inputs])[:-1]
        return np.split(self.turned(x), ends, axis=-1)

    def turned(self, x: np.ndarray) -> np.ndarray:
        forms = [form for port in self.step.inputs for form in (port.forms or [""] * port.size)]
        x = x.copy()
        for k in [k for k, form in enumerate(forms) if form == QUATERNION][::4]:
            x[..., k : k + 4] /= np.linalg.norm(x[..., k : k + 4], axis=-1, keepdims=True)
        return x

    @cached_property
    def parts(self) -> list[Program]:
        """Up to each check, what it and those before it need of the program; the last one has all."""
        found = []
        for k in range(len(self.checks)):
            slots = tuple((check.slot,) for check in self.checks[: k + 1])
            ports = tuple(Port(f"value{i}", (1,), ("1",), ("",), "") for i in range(k + 1))
            part = replace(self.step, outputs=ports, results=slots, guards=(), limits=())
            found.append(replace(part, instructions=tuple(part.live[0])))
        return found

    def values(self, points: np.ndarray, k: int = -1) -> np.ndarray:
        """Of the checks up to one (points, k + 1)."""
        return np.hstack(evaluate(self.parts[k], self.split(points))[0])

    def sizes(self, k: int, points: np.ndarray) -> np.ndarray:
        """How far each point is from where check k says no; infinite where one before it does, or nothing is known."""
        values = self.values(points, k)
        here = np.maximum(self.checks[k].left(values[:, k]), 0.0)
        if self.checks[k].sign:  # at the bound itself it still says yes
            here = np.where(self.checks[k].left(values[:, k]) < 0, 0.0, np.maximum(here, np.finfo(float).tiny))
        for check, value in zip(self.checks[:k], values.T, strict=False):
            here = np.where(check.left(value) >= check.limit * (1 if check.sign else 1 + 1e-9), here, np.inf)
        return np.where(np.isfinite(here), here, np.inf)

    def crossings(self, k: int, lines: _Lines) -> list[np.ndarray]:
        """Points on both sides of changes of sign of check k, those first where the other limits are kept."""
        starts, along, line = lines.starts, lines.along, lines.parts
        check, seen = self.checks[k], lines.seen
        off = check.bound if check.sign else 0.0
        value = seen[..., k] - off
        changes = (value[:, :-1] * value[:, 1:] < 0).astype(int)
        kept = np.ones(changes.shape, dtype=bool)
        for other, values in zip(self.checks, np.moveaxis(seen, -1, 0), strict=True):
            if other.sign and other is not check:
                kept &= (other.left(values) >= 0)[:, :-1] & (other.left(values) >= 0)[:, 1:]
        changes += changes * kept
        best = np.argsort(-changes.max(axis=1), kind="stable")[:BRACKETS]
        best = best[changes[best].max(axis=1) > 0]
        if not len(best):
            return []
        places = changes[best].argmax(axis=1)
        low, high = line[places], line[places + 1]
        sign, rows = np.sign(value[best, places])[:, None], np.arange(len(best))
        for _ in range(ROUNDS):
            parts = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, PARTS + 1)
            points = starts[best][:, None] + parts[..., None] * along[best][:, None]
            now = self.values(points.reshape(-1, points.shape[-1]), k)[:, k].reshape(parts.shape) - off
            at = np.maximum((np.sign(now) * sign <= 0).argmax(axis=1), 1)
            low, high = parts[rows, at - 1], parts[rows, at]
        return [*np.vstack([starts[best] + t[:, None] * along[best] for t in (low, high)])]

    def beside(self, k: int, near: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        """The best of points some roundings away from others, for check k."""
        factors = 1.0 + np.finfo(float).eps * rng.integers(-8, 9, (ROUNDINGS, *near.shape))
        points = np.vstack([near, (near * factors).reshape(-1, near.shape[1])])
        best: np.ndarray = points[self.sizes(k, points).argmin()]
        return best

    def least(self, k: int, x: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        """A point of least size of check k, looked for along random lines through the best, and along the slope."""
        best, size, scale = x, self.sizes(k, x[None])[0], SCALES[0]
        steps = np.geomspace(1e-4, 1.0, STEPS)
        for _ in range(DESCENTS):
            if size <= self.checks[k].limit:
                break
            along = np.vstack([rng.normal(size=(RAYS, len(x))) * scale, self.down(k, best, size)])
            points = (best + np.concatenate([steps, -steps])[:, None, None] * along).reshape(-1, len(x))
            sizes = self.sizes(k, points)
            at = sizes.argmin()
            scale *= 1.0 if sizes[at] < 0.9 * size else CLOSER
            if sizes[at] < size:
                best, size = points[at], sizes[at]
        return best

    def down(self, k: int, x: np.ndarray, size: float) -> np.ndarray:
        """Newton's step to where the size of check k is zero, by differences; no step where there is no slope."""
        step = 1e-3 * min(1.0, size)
        beside = self.sizes(k, np.vstack([x + step * np.eye(len(x)), x - step * np.eye(len(x))]))
        slope = (beside[: len(x)] - beside[len(x) :]) / (2.0 * step)
        square = slope @ slope
        return -size * slope / square if np.isfinite(square) and square > 0 else np.zeros(len(x))

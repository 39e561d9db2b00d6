"""Measured times: rounds that go through all candidates in turn, quartiles, compiled functions on batches."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass

import numpy as np

from symscrew.model import Model
from symscrew.runtime import CompiledFunction, CompiledModel

BATCH = 64  # states per call, the same for all functions: enough for lanes, and all arrays stay in the cache
ROUNDS, WARM = 41, 3  # counted, and before them not: pages, caches and the clock of the processor come up


@dataclass(frozen=True)
class Times:
    """Least, quartiles and median of repeated measurements, in the unit of the measurement."""

    least: float
    lower: float
    median: float
    upper: float
    repeats: int

    @property
    def text(self) -> str:
        """The median with the quartiles."""
        return f"{self.median:.3g} ({self.lower:.3g} ... {self.upper:.3g})"

    def as_json(self) -> dict[str, float]:
        """Plain numbers."""
        return asdict(self)


def quartiles(values: Sequence[float]) -> Times:
    """Summary of measurements."""
    least, lower, median, upper = np.percentile(values, [0, 25, 50, 75])
    return Times(float(least), float(lower), float(median), float(upper), len(values))


def interleaved(measures: Mapping[str, Callable[[], float]], repeats: int) -> dict[str, Times]:
    """A B C A B C ...: one value of each measure per round, so that a disturbance meets all of them."""
    values: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(repeats):
        for name, measure in measures.items():
            values[name].append(measure())
    return {name: quartiles(found) for name, found in values.items()}


def nanoseconds_per_state(function: CompiledFunction, inputs: Mapping[str, np.ndarray]) -> Callable[[], float]:
    """A measure: one call of a function on many states at once, in ns per state.

    With many states Python's share of a call vanishes.

    Args:
        function: a function of a compiled model.
        inputs: (states, size) of every input of the function, by name.
    """
    arrays = [np.ascontiguousarray(inputs[port.name]) for port in function.inputs]
    count = len(arrays[0])
    results = [np.empty((count, port.size)) for port in function.outputs]
    status = np.zeros(count, dtype=np.intc)

    def measure() -> float:
        start = time.perf_counter_ns()
        function.evaluator(arrays, results, status)
        return (time.perf_counter_ns() - start) / count

    return measure


def time_every_function(model: Model, compiled: CompiledModel) -> dict[str, Times]:
    """Nanoseconds per state of every function of a model, timed in turns on batches of the model's sample states."""
    measures = {}
    for name, states in model.test_inputs.items():
        ports = model.programs[name].inputs
        inputs = {p.name: np.resize(x, (BATCH, p.size)) for p, x in zip(ports, states, strict=True)}
        measures[name] = nanoseconds_per_state(compiled[name], inputs)
    interleaved(measures, WARM)
    return interleaved(measures, ROUNDS)

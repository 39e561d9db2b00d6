"""Time per call of compiled functions: median and quartiles over interleaved rounds."""

from __future__ import annotations

import time
from collections.abc import Mapping

import numpy as np

from symscrew.compiled import CompiledModel
from symscrew.console import Progress
from symscrew.model import Model

BATCH, ROUNDS, WARM = 64, 41, 3


def times(model: Model, compiled: CompiledModel, progress: Progress) -> Mapping[str, tuple[float, float, float]]:
    """Function -> quartiles (25, 50, 75 %) of nanoseconds per call, on the sample states; empty without compiled C.

    A call is one state of a batch of 64 in compiled C. Rounds go through all functions in turn, so that a busy
    machine disturbs all of them alike.
    """
    if compiled.backend != "c":
        return {}
    with progress.step("time"):
        calls = {name: _call(compiled, model, name) for name in model.programs}
        samples: dict[str, list[float]] = {name: [] for name in calls}
        for round_ in range(ROUNDS + WARM):
            for name, call in calls.items():
                taken = call()
                if round_ >= WARM:
                    samples[name].append(taken)
    return {name: tuple(np.percentile(s, (25, 50, 75)).tolist()) for name, s in samples.items()}


def _call(compiled: CompiledModel, model: Model, name: str):  # type: ignore[no-untyped-def]
    function = compiled[name]
    arrays = [np.ascontiguousarray(np.resize(a, (BATCH, a.shape[1]))) for a in model.test_inputs[name]]
    results = [np.empty((BATCH, port.size)) for port in function.outputs]
    status = np.zeros(BATCH, dtype=np.intc)

    def run() -> float:
        start = time.perf_counter_ns()
        function.evaluator(arrays, results, status)
        return (time.perf_counter_ns() - start) / BATCH

    return run

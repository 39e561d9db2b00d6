"""Time of generated functions: single calls, batches in both layouts, and other libraries on the same states.

All variants of a function are timed in turns, so that a disturbance of the machine meets all of them. A peer
is timed after its results agree; one that cannot be compared is named with the reason.
"""

from __future__ import annotations

import contextlib
import ctypes
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.program import Iteration, evaluate
from symscrew.runtime import CompileError
from symscrew.studies.benchmark.peers import PEERS
from symscrew.studies.benchmark.timed_code import MOST_ARRAYS, Compiled, Measure, difference, pointer, pointers, states
from symscrew.studies.timing import Times, interleaved

USUAL_FUNCTIONS = (
    "inverse_dynamics",
    "inverse_dynamics_platform",
    "joint_reactions",
    "mass_matrix",
    "forward_dynamics",
    "forward_dynamics_independent",
)
STATES = 256  # that a loop goes through: caches hold them, and no branch predictor learns them by heart
COUNTS = (1, 8, 1000, 1_000_000)  # of a batch: one call's overhead, one pack of lanes, in the cache, out of it
AGREEMENT = 1e-9  # largest relative difference from the reference evaluator at which a time means something


@dataclass(frozen=True)
class Row:
    """One variant of a function: ns per state, and the relative difference from the reference evaluator or ours."""

    function: str
    variant: str
    operations: int | None
    times: Times
    agreement: float

    def as_json(self) -> dict[str, Any]:
        """Plain values."""
        return {**self.__dict__, "times": self.times.as_json()}


def single(compiled: Compiled, name: str, count: int = STATES, *, rounds: int = 20) -> tuple[Measure, list[np.ndarray]]:
    """ns per single call, in `rounds` loops over states, and its results."""
    program = compiled.model.programs[name]
    ports = (*program.inputs, *program.outputs)
    if len(ports) > MOST_ARRAYS:
        raise DescriptionError(f"{name}: expected at most {MOST_ARRAYS} arrays to be timed, got {len(ports)}")
    results = [np.full((count, max(p.size, 1)), np.nan) for p in program.outputs]
    arrays = [*states(compiled.model, name, count), *results]
    sizes = (ctypes.c_size_t * MOST_ARRAYS)(*[p.size for p in ports])
    places, function = pointers(arrays), compiled.function(name)

    def measure(kept: Sequence[np.ndarray] = arrays) -> float:
        nanoseconds: float = compiled.loops.time_single(
            function, ctypes.c_size_t(rounds), ctypes.c_size_t(count), sizes, places
        )
        return nanoseconds

    measure()
    return measure, results


def batch(compiled: Compiled, name: str, count: int, *, columns: bool) -> tuple[Measure, list[np.ndarray]]:
    """ns per state of one call of a batch function, and its results (states, size)."""
    import time

    program = compiled.model.programs[name]
    given = states(compiled.model, name, count)
    results = [np.full((count, p.size), np.nan) for p in program.outputs]
    if columns:
        given, results = [np.ascontiguousarray(x.T) for x in given], [np.ascontiguousarray(x.T) for x in results]
    function = compiled.function(name, "_batch_soa" if columns else "_batch")
    places = [pointer(a) for a in (*given, *results)]
    counts = [ctypes.c_size_t(count)] * (2 if columns else 1)
    rounds = max(1, 20_000 // count)

    def measure(kept: Sequence[np.ndarray] = (*given, *results)) -> float:
        start = time.perf_counter()
        for _ in range(rounds):
            function(*counts, *places, None)
        return (time.perf_counter() - start) * 1e9 / (rounds * count)

    measure()
    return measure, [r.T for r in results] if columns else results


def time_functions(
    model: Model, functions: Sequence[str], peers: Sequence[str] = (), *, repeats: int = 25, run_time: bool = False
) -> tuple[list[Row], list[str]]:
    """Rows of all variants of all functions, and what could not be compared.

    With `run_time` also the code that reads all parameters of the mechanism at run time, beside that which holds them.

    Raises:
        DescriptionError: no such function.
        CompileError: no compiler, or it refused the code, or results differ, so that times mean nothing.
    """
    known = [name for name, program in model.programs.items() if not isinstance(program, Iteration)]
    unknown = [name for name in functions if name not in known]
    if unknown:
        raise DescriptionError(f"{model.name} has no function {unknown[0]!r}; it has {', '.join(known)}")
    compiled, rows, notes = Compiled(model, functions), [], []
    read = Compiled(at_run_time(model), functions) if run_time else None
    for name in functions:
        program = model.programs[name]
        assert not isinstance(program, Iteration)
        expected, _ = evaluate(program, states(model, name, STATES))
        measures: dict[str, Measure] = {}
        agreement: dict[str, float] = {}
        operations: dict[str, int] = {}
        limits: dict[str, float | None] = {}
        for variant in ("one state", "batch, one after the other", "batch, side by side"):
            columns = variant.endswith("side")
            made = single(compiled, name) if variant == "one state" else batch(compiled, name, STATES, columns=columns)
            measures[variant] = made[0]
            agreement[variant] = max(
                (difference(a, b) for a, b, p in zip(expected, made[1], program.outputs, strict=True) if p.size),
                default=0.0,
            )
        if read is not None:
            variant = "one state, parameters at run time"
            measures[variant], got = single(read, name)
            operations[variant] = read.model.programs[name].operations["total"]
            agreement[variant] = max(map(difference, expected, got), default=0.0)
        for peer in peers:
            found = PEERS[peer](compiled, name, expected)
            if isinstance(found, str):
                notes.append(f"{name}, {peer}: {found}")
                continue
            for variant, other in found.items():
                measures[variant], agreement[variant] = other.measure, difference(other.expected, other.results)
                limits[variant] = other.limit
        bad = {v: e for v, e in agreement.items() if (limit := limits.get(v, AGREEMENT)) and not e < limit}
        if bad:
            raise CompileError(f"{name}: results differ, nothing is timed: {bad}")
        times = interleaved(measures, repeats)
        total = program.operations["total"]
        counted = {v: None if ":" in v else operations.get(v, total) for v in times}
        rows += [Row(name, v, counted[v], t, agreement[v]) for v, t in times.items()]
    return rows, notes


def at_run_time(model: Model) -> Model:
    """The same model with every parameter an input, at the same test states.

    Raises:
        DescriptionError: the mechanism has no parameters, or one decides about its structure.
    """
    parameters = model.mechanism.parameters
    if not parameters:
        raise DescriptionError(f"{model.name} has no parameters to read at run time; leave the option out")
    changed = {name: replace(parameter, run_time=True) for name, parameter in parameters.items()}
    made = derive(replace(model.mechanism, parameters=changed), model.effects)
    values = made.system.parameter_values
    inputs = {
        name: (*given, np.repeat(values[None], len(given[0]), axis=0))
        for name, given in model.test_inputs.items()
        if name in made.programs and len(made.programs[name].inputs) == len(given) + 1
    }
    return replace(made, test_inputs={**made.test_inputs, **inputs})


def throughput(
    model: Model, function: str, *, counts: Sequence[int] = COUNTS, repeats: int = 5
) -> list[dict[str, Any]]:
    """ns per state of batches of 1, 8, 1e3 and 1e6 states in both layouts, on one thread and on all.

    Beside them single calls over the same states in a loop in C.
    """
    found: list[dict[str, Any]] = []
    libraries = {"one thread": Compiled(model, [function])}
    with contextlib.suppress(CompileError):  # without OpenMP there is one thread
        libraries["threads"] = Compiled(model, [function], threads=True)
    for count in counts:
        entry: dict[str, Any] = {"states": count}
        calls = single(libraries["one thread"], function, count, rounds=max(1, 20_000 // count))[0]
        measures = {"single calls in C": calls}
        measures |= {
            f"{layout}, {how}": batch(library, function, count, columns=layout == "side by side")[0]
            for how, library in libraries.items()
            for layout in ("one after the other", "side by side")
        }
        entry |= {variant: t.as_json() for variant, t in interleaved(measures, repeats).items()}
        found.append(entry)
    return found

"""Arrays of many states from Python beside the direct call of the same C, in every memory order, in pairs.

The direct call is that of a caller who has prepared everything: `<function>_batch` on arrays one state after the other
or `<function>_batch_soa` on arrays side by side, results and statuses in arrays that are there already, pointers known.
It is a function of the same library, since the same code at another place takes up to a third longer. Arrays of other
orders are compared with `<function>_batch` on copies made beforehand. Python gets arrays and returns new ones. Both are
timed in turns; the ratio is the median over the pairs. Of one thread it is processor time, which other processes of a
busy machine do not enter; several threads are there to save time by the clock.
"""

from __future__ import annotations

import ctypes
import os
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.model import Model, derive
from symscrew.runtime import CompiledFunction, load
from symscrew.studies.benchmark.timed_code import difference, pointer, states
from symscrew.studies.timing import quartiles

from .tables import table

CASES = (
    ("panda", "inverse_dynamics"),
    ("panda", "forward_dynamics"),
    ("three_ups_upu_s_physical", "inverse_dynamics"),
    ("three_ups_upu_s_physical", "inverse_dynamics_platform"),
    ("four_bar", "inverse_dynamics"),
)
COUNTS = (1, 64, 512, 4096, 60000)  # the last not a power of two: columns would evict each other from the caches
SAMPLE = 2e-3  # seconds of one measurement: some thousand times what a clock resolves
AGREEMENT = 1e-9
THREADS = (2, 4)
Array = np.ndarray
Order = Callable[[Array], Array]


@dataclass(frozen=True)
class Direct:
    """A model and its compiled functions, to be called without anything between."""

    model: Model
    library: ctypes.CDLL


def _thinned(x: Array) -> Array:
    """Every second state of an array of twice as many."""
    return np.repeat(x, 2, axis=0)[::2]


ORDERS: dict[str, tuple[Order, ...]] = {  # of the inputs in turn; the last one for all that are left
    "states along the first axis (C)": (np.ascontiguousarray,),
    "states side by side (Fortran)": (np.asfortranarray,),
    "every second state": (_thinned,),
    "last state first": (lambda x: x[::-1],),
    "first input Fortran, others C": (np.asfortranarray, np.ascontiguousarray),
}
BROADCAST = "last input the same for all states"
ALL = (*ORDERS, BROADCAST)


def run(*, repeats: int = 25) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    rows, raw = [], []
    for name, function in CASES:
        model = derive(catalogue.load(name)).only([function])
        with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
            compiled = load(model, backend="c", build_dir=folder)[function]
            direct = Direct(model, ctypes.CDLL(f"{folder}/lib{model.name}.so"))  # the one that is loaded already
        for count in COUNTS:
            for order in ALL if count > 1 else ALL[:1]:
                for threads in (1, *THREADS) if count == COUNTS[-1] and order in ALL[:2] else (1,):
                    found = _pair(direct, compiled, order=order, count=count, threads=threads, repeats=repeats)
                    raw.append({"mechanism": name, "function": function, **found})
                    beside = "" if threads == 1 else f", {threads} threads"
                    rows.append([name, function, count, order + beside, *(f"{found[k]:.3g}" for k in ("c", "python"))])
                    rows[-1] += [f"{found['ratio']:.2f} ({found['lower']:.2f} ... {found['upper']:.2f})"]
    header = ["mechanism", "function", "states", "arrays", "C ns", "Python ns", "ratio (quartiles)"]
    text = f"ns per state, {repeats} pairs each; {os.cpu_count()} processors.\n\n{table(header, rows)}"
    worst = max(r["ratio"] for r in raw if r["states"] >= 512 and r["threads"] == 1)
    return f"{text}\n\nLargest ratio of one thread from 512 states on: {worst:.2f}", {"rows": raw}


def _pair(
    direct: Direct, compiled: CompiledFunction, *, order: str, count: int, threads: int, repeats: int
) -> dict[str, Any]:
    """Medians of both, and of their ratio."""
    given = _ordered(states(direct.model, compiled.name, count), order)
    call, results = _direct(direct, compiled.name, [np.broadcast_to(x, (count, x.shape[-1])) for x in given], order)
    python = partial(compiled, *given, check=False, threads=threads)
    *got, _ = python()
    call()
    worst = max((difference(a, b) for a, b in zip(results, got, strict=True) if a.size), default=0.0)
    if not worst < AGREEMENT:
        raise RuntimeError(f"{compiled.name}, {order}: results differ by {worst:.1e}; nothing to compare")
    clock = time.process_time if threads == 1 else time.perf_counter
    rounds = max(1, round(SAMPLE / _seconds(call, 3, clock)))
    pairs = [(_seconds(call, rounds, clock), _seconds(python, rounds, clock)) for _ in range(repeats)]
    one, other, ratio = (quartiles(x) for x in (*zip(*pairs, strict=True), [b / a for a, b in pairs]))
    scale = 1e9 / count
    return {
        "states": count, "order": order, "threads": threads, "c": one.median * scale, "python": other.median * scale,
        "ratio": ratio.median, "lower": ratio.lower, "upper": ratio.upper,
    }  # fmt: skip


def _ordered(arrays: Sequence[Array], order: str) -> list[Array]:
    if order == BROADCAST:
        return [*arrays[:-1], arrays[-1][0]]
    orders = ORDERS[order]
    return [orders[min(k, len(orders) - 1)](x) for k, x in enumerate(arrays)]


def _direct(direct: Direct, name: str, given: Sequence[Array], order: str) -> tuple[Callable[[], object], list[Array]]:
    """The call of the C, with all that it needs at hand, and its results (states, entries)."""
    program, count = direct.model.programs[name], len(given[0])
    columns = order.endswith("(Fortran)")
    arrays = [np.ascontiguousarray(x.T if columns else x) for x in given]
    results = [np.empty((p.size, count) if columns else (count, p.size)) for p in program.outputs]
    status = np.zeros(count, dtype=np.intc)
    held = [*arrays, *results, status]
    call = getattr(direct.library, f"{direct.model.name}_{name}_batch{'_soa' if columns else ''}")
    counts = [ctypes.c_size_t(count)] * (2 if columns else 1)
    made = partial(_called, call, (*counts, *map(pointer, held)), held)
    return made, [r.T for r in results] if columns else results


def _called(call: Any, arguments: Sequence[Any], held: Sequence[Array]) -> object:
    return call(*arguments)


def _seconds(call: Callable[[], object], rounds: int, clock: Callable[[], float]) -> float:
    start = clock()
    for _ in range(rounds):
        call()
    return (clock() - start) / rounds

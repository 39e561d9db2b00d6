"""Study "digits": single against double precision, function by function: how many digits are lost, where, in what time.

functions --C, CUDA's file as C++, the device where one is--> results in float and double --evaluator--> digits, places
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.display import Progress
from symscrew.model import Model
from symscrew.runtime import CompileError, find_compiler, load, load_cuda, load_cuda_as_cpp
from symscrew.studies.accuracy.measuring import Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.states import Subject, inputs_of

Array = np.ndarray
FUNCTIONS = (
    "assemble", "inverse_kinematics", "velocity", "acceleration", "drive_rates", "inverse_dynamics",
    "inverse_dynamics_platform", "joint_reactions", "mass_matrix", "bias", "forward_dynamics", "energy",
)  # fmt: skip
HALF_UNIT = 2.0**-24  # of float: what rounding a number to it may change, relative
PASSES = 20  # over all states per measurement: some milliseconds, which the clock sees
Results = tuple[tuple[Array, ...], Array]  # outputs (states, size), status (states,)


@dataclass(frozen=True)
class _Way:
    """How functions are computed: its name, whether in float, and a call (function, inputs) -> outputs, status."""

    name: str
    single: bool
    call: Callable[[str, Sequence[Array]], Results]


def study(subject: Subject, progress: Progress, *, repeats: int, seconds: float) -> Study:
    """Largest error over the largest entry of its output, against time a state; a table of digits lost, and where."""
    model, watch, left_out = subject.model, Stopwatch(), list[str]()
    names = [name for name in FUNCTIONS if name in model.programs]
    small = model.only(names)
    given = {name: inputs_of(model, name, subject.states) for name in names}
    exact = {name: _evaluated(model, name, given[name]) for name in names}
    ways = watch("print and compile", _ways, small, left_out)
    setups = [_setup(way, name, given[name], exact[name]) for way in ways for name in names]
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="digits")
    rows = [_row(small, ways, name, given[name], exact=exact[name]) for name in names]
    lost = ("digits that float loses", "inputs rounded alone", "worst at")
    head = ["function", "operations", *(way.name for way in ways), *lost]
    notes = [
        f"States: {subject.states.text}; {PASSES} times over, in one call of all.",
        "Digits are those of the largest entry of an output that are right, over all states; float can hold 7.2. What "
        "rounding the inputs alone does is the evaluator's result in double at inputs rounded to float: where that "
        "leaves as few digits as float, the function is sensitive, and float's own operations are not to blame.",
    ]
    return Study(
        "digits",
        f"Single against double precision, functions of {model.name}",
        points,
        error_label="largest error / largest entry of the output",
        cost_label="time a state",
        cost_unit="ns",
        reference="the evaluator in double precision, operation by operation",
        reference_error=None,
        preparation=watch.seconds,
        left_out=tuple(left_out),
        notes=tuple(notes),
        tables={"Digits that are right": (head, rows)},
    )


def _evaluated(model: Model, name: str, inputs: Sequence[Array]) -> Results:
    results, status = model(name, *inputs)
    return tuple(np.asarray(r) for r in results), np.broadcast_to(np.asarray(status), (len(inputs[0]),))


def _ways(model: Model, left_out: list[str]) -> list[_Way]:
    """What can be had here; of the others `left_out` says why."""
    ways: list[_Way] = []
    for kind, single in (("float64", False), ("float32", True)):
        precision = "single" if single else "double"
        if find_compiler() is None:
            left_out.append(f"C, {kind}: there is no C compiler")
        else:
            ways.append(_Way(f"C, {kind}", single, _by_c(load(model, backend="c", precision=precision))))
        for told, made in (("CUDA as C++", load_cuda_as_cpp), ("CUDA", load_cuda)):
            try:
                ways.append(_Way(f"{told}, {kind}", single, _by_cuda(made(model, precision=precision))))
            except CompileError as error:
                left_out.append(f"{told}, {kind}: {error}")
    return ways


def _by_c(compiled: Any) -> Callable[[str, Sequence[Array]], Results]:
    def call(name: str, inputs: Sequence[Array]) -> Results:
        *found, status = compiled[name](*inputs, check=False)
        flat = [r.reshape(len(r), -1) if r.ndim < 3 else np.moveaxis(r, 2, 1).reshape(len(r), -1) for r in found]
        return tuple(flat), np.asarray(status)

    return call


def _by_cuda(kernels: Any) -> Callable[[str, Sequence[Array]], Results]:
    """Of a file as C++, or on the device: arrays go there and back, which counts as time."""
    library = kernels.library

    def call(name: str, inputs: Sequence[Array]) -> Results:
        *found, status = getattr(kernels, name)(*(library.asarray(x.T, dtype=kernels.real) for x in inputs))
        here = [x.get() if hasattr(x, "get") else x for x in (*found, status)]
        return tuple(np.asarray(x, dtype=float).T for x in here[:-1]), here[-1]

    return call


def _setup(way: _Way, name: str, inputs: Sequence[Array], exact: Results) -> Setup:
    many = [np.tile(x, (PASSES, 1)) for x in inputs]

    def run() -> float:
        begin = time.perf_counter()
        way.call(name, many)
        return time.perf_counter() - begin

    def error() -> float:
        return _worst(way.call(name, inputs), exact)[0]

    return Setup(way.name, name, run, error, len(many[0]), {"function": name})


def _worst(found: Results, exact: Results) -> tuple[float, int, int, int]:
    """The largest error by the largest entry of its output; which output, state and entry have it."""
    sound = (np.asarray(found[1]) <= 0) & (np.asarray(exact[1]) <= 0)
    if not sound.any():
        raise ArithmeticError("no state has a result")
    worst = (0.0, 0, 0, 0)
    for k, (one, other) in enumerate(zip(found[0], exact[0], strict=True)):
        size = float(np.abs(other[sound]).max(initial=0.0))
        apart = np.where(sound[:, None], np.abs(one - other), 0.0) / (size or 1.0)
        if apart.size and not apart.max() <= worst[0]:
            state, entry = np.unravel_index(int(np.nanargmax(apart)), apart.shape)
            worst = (float(apart[state, entry]), k, int(state), int(entry))
    return worst


def _digits(error: float) -> str:
    return f"{-math.log10(error):.1f}" if error > 0 else "all"


def _row(model: Model, ways: Sequence[_Way], name: str, inputs: Sequence[Array], *, exact: Results) -> list[str]:
    """A function's digits by every way, what float loses, and where."""
    errors: dict[bool, tuple[float, int, int, int]] = {}
    cells = []
    for way in ways:
        try:
            found = _worst(way.call(name, inputs), exact)
        except ArithmeticError as error:
            cells.append(str(error))
            continue
        cells.append(_digits(found[0]))
        errors[way.single] = max(errors.get(way.single, found), found)
    rounded = [np.asarray(np.float32(x), dtype=float) for x in inputs]
    alone = _worst(_evaluated(model, name, rounded), exact)[0]
    operations = str(model.programs[name].operations["total"])
    if True not in errors:
        return [name, operations, *cells, "", _digits(alone), ""]
    largest, output, state, entry = errors[True]
    labels = model.programs[name].outputs[output].labels
    label = labels[entry] if entry < len(labels) else str(entry)
    lost = math.log10(max(largest, HALF_UNIT) / HALF_UNIT)
    where = f"{model.programs[name].outputs[output].name} {label.replace('|', ', ')}, state {state}"
    return [name, operations, *cells, f"{lost:.1f}", _digits(alone), where]

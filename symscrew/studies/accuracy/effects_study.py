"""Study "effects": what simplifications cost in accuracy and save in operations.

Drives and accelerations of the mechanism with massless limbs, without gyroscopic terms, quasi-static, and with
pairs of these, against those of the whole model.
"""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Sequence

import numpy as np

from symscrew.display import Progress
from symscrew.effects import Effect, simplifications
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.program import Program
from symscrew.reference import newton_euler
from symscrew.runtime import find_compiler
from symscrew.studies.accuracy.compiled_loops import caller, compiled, loop_code, one_file
from symscrew.studies.accuracy.measuring import Point, Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.states import States, Subject, body_states_of, inputs_of

FUNCTIONS = {"inverse_dynamics": "drives", "forward_dynamics": "accelerations"}
PASSES = 20  # over all states per measurement: some milliseconds, which the clock sees


def study(subject: Subject, progress: Progress, *, repeats: int, seconds: float) -> Study:
    """Errors of drives and accelerations against operations and time."""
    watch, model, states = Stopwatch(), subject.model, subject.states
    known = simplifications()
    variants: dict[str, tuple[Effect, ...]] = {"whole model": ()}
    for count in (1, 2):
        for names in itertools.combinations(known, count):
            variants[" + ".join(names)] = tuple(known[name] for name in names)
    setups: list[Setup] = []
    failed: list[Point] = []
    for text, chosen in progress.bar(list(variants.items()), "effects: derive"):
        try:
            made = watch("derive", derive, model.mechanism, (*model.effects, *chosen)) if chosen else model
        except DescriptionError as error:
            failed.append(Point("drives", text, None, None, str(error)))
            continue
        for function, what in FUNCTIONS.items():
            if function not in model.programs:
                continue
            if function not in made.programs:
                failed.append(Point(what, text, None, None, "no forward dynamics: without inertia none is defined"))
                continue
            setups.append(_setup(model, made, function, states, curve=what, setting=text, watch=watch))
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="effects")
    timed = "generated C, one state at a time" if find_compiler() else "NumPy over all states at once: no C compiler"
    return Study(
        "effects",
        f"Simplifications of {model.name}",
        (*points, *failed),
        error_label="root mean square error / root mean square of the whole model's",
        cost_label="operations of the function",
        cost_unit="operations",
        reference="the whole model's own drives and accelerations; checked: drives against Newton-Euler in maximal "
        "coordinates",
        reference_error=_check(model, states),
        preparation=watch.seconds,
        left_out=(),
        notes=(f"States: {states.text}. Times: {timed}. Lengths are divided by the characteristic length.",),
    )


def _setup(
    model: Model, made: Model, function: str, states: States, *, curve: str, setting: str, watch: Stopwatch
) -> Setup:
    """A function of a simplified model `made`, held against the same function of the whole one."""
    whole = model(function, *inputs_of(model, function, states))[0][0]
    inputs = inputs_of(made, function, states)
    program = made.programs[function]
    assert isinstance(program, Program)
    scale = _scales(model, function)

    def error_of(value: np.ndarray) -> float:
        if not np.isfinite(value).all():
            raise ArithmeticError("not defined: freedoms that move massless bodies only")
        return float(np.sqrt(np.mean(((value - whole) / scale) ** 2)) / np.sqrt(np.mean((whole / scale) ** 2)))

    facts = {"operations": program.operations["total"], "function": function}
    if find_compiler() is None:
        run, error = _numpy_run(made, function, inputs, error_of)
        return Setup(curve, setting, run, error, len(inputs[0]), facts)
    symbol, count = f"{made.name}_{function}", len(inputs[0])
    text = watch("print", one_file, made, {function: program})
    library = watch("compile", compiled, text + loop_code(symbol, program.inputs, program.outputs, "double"))
    given = [np.ascontiguousarray(np.tile(a, (PASSES, 1))) for a in inputs]
    results = [np.zeros((count * PASSES, p.size)) for p in program.outputs]
    run = caller(library, symbol, given, results)
    return Setup(curve, setting, run, lambda: error_of(results[0][:count]), count * PASSES, facts)


def _numpy_run(
    made: Model, function: str, inputs: Sequence[np.ndarray], error_of: Callable[[np.ndarray], float]
) -> tuple[Callable[[], float], Callable[[], float]]:
    def run() -> float:
        start = time.thread_time()
        made(function, *inputs)
        return time.thread_time() - start

    return run, lambda: error_of(made(function, *inputs)[0][0])


def _scales(model: Model, function: str) -> np.ndarray:
    system = model.system
    if function == "forward_dynamics":
        return system.scales
    units = model.programs[function].outputs[0].units
    return np.array([1.0 if unit == "N" else system.length for unit in units])


def _check(model: Model, states: States) -> float | None:
    """Relative difference of the drives to method B, where gravity alone acts."""
    if "inverse_dynamics" not in model.programs or len(model.effects) != 1 or model.system.parameters:
        return None
    drives = model("inverse_dynamics", *inputs_of(model, "inverse_dynamics", states))[0][0]
    other = newton_euler(model.mechanism, body_states_of(model, states)).drives
    return float(np.abs(drives - other).max() / np.abs(other).max())

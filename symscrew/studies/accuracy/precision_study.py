"""Study "precision": one generated function in single and double precision, plain and with fast-math.

Reference: the same program in long double at the same inputs; its own error by arithmetic of 60 digits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from symscrew.display import Progress
from symscrew.export import DOUBLE, SINGLE
from symscrew.model import Model
from symscrew.program import Iteration, Program
from symscrew.runtime import find_compiler
from symscrew.studies.accuracy.compiled_loops import caller, compiled, loop_code, one_file
from symscrew.studies.accuracy.measuring import Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.states import Subject, inputs_of
from symscrew.studies.accuracy.typed_code import LONG_DOUBLE, as_floats, in_digits, typed_function

FUNCTIONS = ("inverse_dynamics", "forward_dynamics")
# What -ffast-math permits but for NaN and infinity. Not by that name: a library linked with it makes all of the process
# flush denormals, the other curves too.
FAST = ("-fno-signed-zeros", "-fno-trapping-math", "-fassociative-math", "-freciprocal-math")
CHECKED = 5  # states in 60 digits, which are slow
PASSES = 40  # over all states per measurement: some milliseconds, which the clock sees


def study(subject: Subject, progress: Progress, *, repeats: int, seconds: float) -> Study:
    """Errors relative to the largest output of all states, against time per evaluation."""
    model, watch, setups, notes, left_out = subject.model, Stopwatch(), [], [], []
    states = subject.states
    own = 0.0
    if find_compiler() is None:
        left_out.append("all curves: they are of generated C, and there is no C compiler")
    for name in FUNCTIONS if find_compiler() else ():
        program = model.programs.get(name)
        if not isinstance(program, Program) or isinstance(program, Iteration):
            left_out.append(f"{name}: {model.name} has no such function")
            continue
        inputs = inputs_of(model, name, states)
        made, error = _function(model, program, inputs, watch)
        setups += made
        own = max(own, error)
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="precision")
    notes.append(f"States: {states.text}. Calls one state at a time, in a loop in C.")
    notes.append(f"fast-math: {' '.join(FAST)} (NaN and denormals stay); float32 has its inputs rounded too.")
    return Study(
        "precision",
        f"Precision of the generated functions of {model.name}",
        points,
        error_label="largest error / largest output",
        cost_label="time per evaluation",
        cost_unit="ns",
        reference="the same program in long double (64-bit mantissa) at the same inputs, without guards; its own error "
        f"against arithmetic of 60 digits at {CHECKED} states",
        reference_error=own,
        preparation=watch.seconds,
        left_out=tuple(left_out),
        notes=tuple(notes),
    )


def _function(
    model: Model, program: Program, inputs: Sequence[np.ndarray], watch: Stopwatch
) -> tuple[list[Setup], float]:
    name, count = program.name, len(inputs[0])
    plain = Program(
        name, program.description, program.inputs, program.outputs, program.instructions, program.results, (), (),
        program.slots,
    )  # fmt: skip
    symbol = f"{model.name}_{name}"
    ports = (program.inputs, program.outputs)
    text = watch("print", one_file, model, {name: program})
    single = watch("print", one_file, model, {name: program}, SINGLE)
    long_text = "#include <math.h>\n#include <stddef.h>\n" + typed_function(plain, symbol, LONG_DOUBLE)
    long_text += loop_code(symbol, *ports, "long double", result="void")
    setups: list[Setup] = []
    reference: list[np.ndarray] = []
    sources = {
        "long double": (long_text, np.longdouble, ()),
        "float64": (text + loop_code(symbol, *ports, DOUBLE.real), np.float64, ()),
        "float64, fast-math": (text + loop_code(symbol, *ports, DOUBLE.real), np.float64, FAST),
        "float32": (single + loop_code(symbol, *ports, SINGLE.real), np.float32, ()),
    }
    for kind, (source, number, flags) in sources.items():
        library = watch("compile", compiled, source, flags)
        given = [np.ascontiguousarray(np.tile(a, (PASSES, 1)), dtype=number) for a in inputs]
        results = [np.zeros((count * PASSES, p.size), dtype=number) for p in program.outputs]
        run = caller(library, symbol, given, results)
        if kind == "long double":
            run()
            reference = [r[:count].copy() for r in results]
            continue
        facts = {"operations": program.operations["total"], "function": name}
        error = _error(results, reference, count)
        setups.append(Setup(name.replace("_", " "), kind, run, error, count * PASSES, facts))
    return setups, _own_error(plain, inputs, reference)


def _error(results: Sequence[np.ndarray], reference: Sequence[np.ndarray], count: int) -> Callable[[], float]:
    size = max(float(np.abs(r).max()) for r in reference)

    def error() -> float:
        return max(float(np.abs(a[:count] - b).max()) for a, b in zip(results, reference, strict=True)) / size

    return error


def _own_error(program: Program, inputs: Sequence[np.ndarray], reference: Sequence[np.ndarray]) -> float:
    """Largest difference of long double to many digits, relative to the largest output (not below half an ulp of double
    of the values compared, which is how far this comparison sees)."""
    worst, size = 0.0, max(float(np.abs(r).max()) for r in reference)
    for k in np.linspace(0, len(inputs[0]) - 1, CHECKED).astype(int):
        exact = in_digits(program, [a[k] for a in inputs])
        for row, value in zip(exact, reference, strict=True):
            low = as_floats([[x - _exact(y) for x, y in zip(row, value[k], strict=True)]])[0]
            worst = max(worst, float(np.abs(low).max()))
    return worst / size


def _exact(number: np.longdouble) -> Any:  # an mpf of mpmath, which has no types
    """A long double as the sum of two doubles in many digits."""
    import mpmath

    context = mpmath.mp.clone()
    context.dps = 60
    high = float(number)
    return context.mpf(high) + context.mpf(float(number - np.longdouble(high)))

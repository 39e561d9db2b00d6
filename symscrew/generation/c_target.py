"""Target "c": C99 of type double or float, its C++17 header, an example and a CMake file.

Compiled with every warning as an error, without contracted multiply-adds, its numbers are those of the evaluator; of
type float, they differ from double by errors of the size that the header states.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import runtime
from symscrew.export import (
    DOUBLE,
    library_sources,
    print_c,
    print_cmake,
    print_cpp,
    print_example,
    readable_sources,
    rounded,
    single_errors,
)
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Evaluate, Results, compare_values, evaluated, relative_difference
from symscrew.model import Model
from symscrew.program import Iteration, Program

QUICK = "-O1"
"""Level at which code is compared: of a delta gcc takes 23 s, and 34 s at the level at which it is loaded."""
STRICT = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Werror")
SINGLE_FACTOR = 8.0  # times the stated error: sines, roundings and contractions differ by compiler, a mistake by more
SMALLEST_ERROR = 1e-6  # a stated error below it counts as this, some units in the last place of a float


def files(order: Order) -> Mapping[str, str]:
    """<name>.h, its sources, <name>.hpp, example.c, CMakeLists.txt."""
    model, precision, form = order.model, order.precision, order.form
    printed = print_c(
        _noted(model, order.measured),
        precision=precision,
        batches=form.batches,
        several=not form.one_file,
        processes=order.processes,
    )
    sources = library_sources(printed, model.name)
    example = print_example(model, precision, sources)
    return {
        **printed,
        **print_cpp(model, precision),
        "example.c": example,
        "CMakeLists.txt": print_cmake(model, sources),
    }


def section(order: Order) -> Sequence[str]:
    """What to say to the compiler of a microcontroller, of code that has no functions of many states."""
    if order.form.batches:
        return []
    sources = "*.c" if order.form.one_file else f"{order.model.name}_*.c"
    return [
        "## On a microcontroller",
        "",
        f"`arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -Os -c {sources}`",
        "",
        "`-Os` for the least flash, `-O2 -ffp-contract=fast` for the least time. Nothing but `math.h` is needed; the",
        "stack of a call is what `symscrew embedded` measures. There are no functions of many states; functions of",
        "closed loops are for the operation mode of the reference configuration, and return 1 elsewhere.",
    ]


def _noted(model: Model, measured: Sequence[Mapping[str, Any]]) -> Model:
    """The model with what its functions cost on microcontrollers among their notes."""
    programs: dict[str, Program | Iteration] = dict(model.programs)
    for found in measured:
        where = f"{found['core']}, {' '.join(found['compiler'].split()[:2])} -O2"
        for name, entry in found["functions"].items():
            if name in programs:
                stack = f"{entry['stack']} of stack (own frames at most {entry['frame']})"
                size = f"{entry['flash']} bytes of flash, {stack}"
                note = f"{where}: {size}, {entry['instructions']} instructions"
                programs[name] = replace(programs[name], notes=(*programs[name].notes, note))
    return replace(model, programs=programs)


def compare(case: Case) -> Iterator[Finding]:
    """Compiles without a warning, header as C++ too, and agrees by number."""
    yield from _compile(case.fresh, case.model.name)
    if runtime.find_compiler():
        # what the folder has no batches of is called by those of the same bodies
        source = case.fresh if case.form.batches else case.model
        if case.precision is DOUBLE:
            yield compare_values("C", case.model, case.expected, _results(source))
        else:
            yield _compare_single(source, case.model)


def _results(source: Path | Model) -> Evaluate:
    compiled = runtime.load(source, backend="c", flags=("-ffp-contract=off", QUICK, *STRICT), trusted=True)

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        function = compiled[name]
        return evaluated(function.evaluator, [p.size for p in function.outputs], inputs)

    return evaluate


def _compare_single(source: Path | Model, model: Model) -> Finding:
    """C of type float against double on the same numbers: errors of the size that the header states."""
    compiled, worst, where = runtime.load(source, backend="c", precision="single", trusted=True), 0.0, ""
    for name, (_, stated) in single_errors(model).items():
        inputs = [rounded(np.atleast_2d(x)) for x in model.test_inputs[name]]
        exact, status = model(name, *inputs)
        got = evaluated(compiled[name].evaluator, [p.size for p in compiled[name].outputs], inputs)
        sound = (np.atleast_1d(status) == 0) & (got[1] == 0)
        if not sound.any():
            return False, f"C in single precision: no state of {name} has the status 0"
        for port, a, b, error in zip(model.programs[name].outputs, exact, got[0], stated, strict=True):
            factor = relative_difference(a[sound], b[sound]) / max(error, SMALLEST_ERROR)
            if not factor <= worst:
                worst, where = factor, f"{name}, {port.name}"
    text = f"C in single precision differs from double by at most {worst:.1f} times what the header states ({where})"
    return worst <= SINGLE_FACTOR, f"{text}, limit {SINGLE_FACTOR:.0f}"


def _compile(directory: Path, name: str) -> Iterator[Finding]:
    """Library and example read with all warnings as errors, and the header as C++."""
    compilers = [path for path in map(shutil.which, ("gcc", "clang")) if path]
    if not compilers:
        compilers = [path for path in [shutil.which("cc")] if path]
    if not compilers:
        yield True, "no C compiler here (apt install gcc): C neither compiled nor run"
    for compiler in compilers:  # what warnings need of an optimiser, they get where the library is compiled
        sources = readable_sources((path.name for path in directory.iterdir()), name)
        yield _run([compiler, *STRICT, "-fsyntax-only", *sources], directory, "reads it without warnings")
    plus = next((path for path in map(shutil.which, ("g++", "clang++")) if path), None)
    if plus:
        flags = ["-std=c++11", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++"]
        yield _run([plus, *flags, f"{name}.h"], directory, "accepts the header as C++")
        flags[0] = "-std=c++17"
        yield _run([plus, *flags, "-Wconversion", f"{name}.hpp"], directory, "accepts the C++17 header")


def _run(command: Sequence[str], directory: Path, what: str) -> Finding:
    compiler = Path(command[0]).name
    try:
        outcome, said = runtime.run_tool(command, directory.name, folder=directory)
    except runtime.CompileError as error:
        return False, str(error)
    if outcome == 0:
        return True, f"{compiler} {what}"
    first = next((line for line in said.splitlines() if "error" in line), said[:200])
    return False, f"{compiler} refuses: {first.strip()}"

"""Generated C under sanitizers and valgrind, across compilers and levels, in float, with denormals, by the million.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import ctypes
import dataclasses
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from hard import case
from model_states import model as catalogued
from model_states import relative
from runs import prepared

from symscrew import catalogue
from symscrew.export.c import print_c
from symscrew.export.casadi_external import jacobians_model
from symscrew.model import Model, derive
from symscrew.runtime.compiled import CompileError, find_compiler, load

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these cases are of compiled code")
FUNCTIONS = (
    "inverse_dynamics",
    "forward_dynamics",
    "joint_reactions",
    "forward_dynamics_reactions",
    "closure",
    "assemble",
)
MODELS = (
    pytest.param("four_bar", FUNCTIONS, marks=pytest.mark.slow),
    ("three_ups_upu_s", ("inverse_dynamics", "closure", "inverse_kinematics")),
)
BASE = ("-std=c99", "-fno-math-errno", "-shared", "-fPIC")


def tool(name: str) -> str:
    """Path of a tool, or the test is skipped by its name."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed")
    return path


def some(name: str, functions: Sequence[str] = FUNCTIONS) -> Model:
    """A catalogue model with the functions of this file only."""
    found = catalogued(name)
    return dataclasses.replace(found, programs={f: p for f, p in found.programs.items() if f in functions})


def written(found: Model, folder: Path) -> Path:
    for file, text in print_c(found).items():
        (folder / file).write_text(text)
    return folder / f"{found.name}.c"


def results_of(found: Model, source: Path, compiler: str, flags: Sequence[str]) -> dict[str, np.ndarray]:
    """All outputs and the status of single calls at the test states, by function: rows of numbers."""
    library = source.with_name(f"{Path(compiler).name}{abs(hash(tuple(flags)))}.so")
    command = [compiler, *BASE, f"-D{found.name.upper()}_SCALAR", *flags, str(source), "-o", str(library), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    loaded, answers = ctypes.CDLL(str(library)), {}
    for function, program in found.programs.items():
        call = getattr(loaded, f"{found.name}_{function}")
        rows = []
        for state in range(len(found.test_inputs[function][0])):
            inputs = [np.ascontiguousarray(np.atleast_2d(x)[state], dtype=float) for x in found.test_inputs[function]]
            outputs = [np.zeros(max(port.size, 1)) for port in program.outputs]
            status = call(*[ctypes.c_void_p(a.ctypes.data) for a in (*inputs, *outputs)])
            rows.append(np.concatenate([*outputs, [float(status)]]))
        answers[function] = np.array(rows)
    return answers


@pytest.mark.parametrize("name, functions", MODELS)
def test_levels_of_optimisation(name: str, functions: Sequence[str], tmp_path: Path) -> None:
    """-O0 and -O3 give the same bits without contraction of multiply-add, with it 1e-13 of the output's norm."""
    found, compiler = some(name, functions), find_compiler()
    assert compiler
    source = written(found, tmp_path)
    plain = results_of(found, source, compiler, ("-O0", "-ffp-contract=off"))
    fast = results_of(found, source, compiler, ("-O3", "-ffp-contract=off"))
    native_code = results_of(found, source, compiler, ("-O3", "-march=native", "-ffp-contract=fast"))
    for function, expected in plain.items():
        assert expected.tobytes() == fast[function].tobytes(), function
        assert relative(native_code[function], expected) < 1e-13, function


@pytest.mark.tools
@pytest.mark.parametrize("name, functions", MODELS)
def test_gcc_and_clang(name: str, functions: Sequence[str], tmp_path: Path) -> None:
    """The same bits from both without contraction, with it 1e-13 of the output's norm."""
    found = some(name, functions)
    source = written(found, tmp_path)
    gcc, clang = tool("gcc"), tool("clang")
    expected = results_of(found, source, gcc, ("-O2", "-ffp-contract=off"))
    for level in ("-O0", "-O3"):
        same = results_of(found, source, clang, (level, "-ffp-contract=off"))
        near = results_of(found, source, clang, (level, "-march=native", "-ffp-contract=fast"))
        for function, values in expected.items():
            assert values.tobytes() == same[function].tobytes(), (function, level)
            assert relative(near[function], values) < 1e-13, (function, level)


def program_of(found: Model, states: Sequence[Sequence[np.ndarray]]) -> str:
    """A C program that calls every function at given states, good and bad, and prints how many statuses differ.

    Single calls, and batches of both layouts over all states and over all but three, so that blocks are left
    over. Arrays are exactly as large as documented: one entry beyond is an error.
    """
    lines = [
        f'#include "{found.name}.h"',
        "#include <math.h>",
        "#include <stdio.h>",
        "#include <stdlib.h>",
        "int main(void)",
        "{",
    ]
    for function, program in found.programs.items():
        symbol, arrays = f"{found.name}_{function}", states[list(found.programs).index(function)]
        count = len(arrays[0])
        lines.append("    {")
        for k, array in enumerate(arrays):
            values = ", ".join(
                "NAN" if np.isnan(x) else "INFINITY" if np.isinf(x) else repr(float(x)) for x in array.ravel()
            )
            lines.append(f"        static const double in{k}[] = {{{values or '0.0'}}};")
            lines.append(f"        double *side{k} = malloc(sizeof(in{k}));")
            wide = max(array.shape[1], 1)
            lines.append(f"        for (int i = 0; i < {array.size}; ++i) {{")
            lines.append(f"            side{k}[i % {wide} * {count} + i / {wide}] = in{k}[i];")
            lines.append("        }")
        for k, port in enumerate(program.outputs):
            lines.append(f"        double *out{k} = malloc({count} * {port.size} * sizeof(double) + !{port.size});")
        lines.append(f"        int *status = malloc({count} * sizeof(int)), *other = malloc({count} * sizeof(int));")
        lines.append("        int total = 0;")
        sides = [f"side{k}" for k in range(len(arrays))]
        ins = [f"in{k}" for k in range(len(arrays))]
        outs = [f"out{k}" for k in range(len(program.outputs))]
        for some_states in (count - 3, count):
            lines.append(f"        {symbol}_batch_soa({some_states}, {count}, {', '.join([*sides, *outs])}, other);")
            lines.append(f"        {symbol}_batch({some_states}, {', '.join([*ins, *outs])}, status);")
        lines.append(f"        for (int i = 0; i < {count}; ++i) {{")
        single = [f"in{k} + i * {array.shape[1]}" for k, array in enumerate(arrays)]
        single += [f"out{k} + i * {port.size}" for k, port in enumerate(program.outputs)]
        lines.append(f"            const int one = {symbol}({', '.join(single)});")
        lines.append("            total += (status[i] != one) + (other[i] != one);")
        lines += ["        }", f'        printf("{function} %d\\n", total);']
        lines += [f"        free({name});" for name in (*outs, *sides, "status", "other")] + ["    }"]
    return "\n".join([*lines, "    return 0;", "}", ""])


def good_and_bad(found: Model) -> list[list[np.ndarray]]:
    """The test states, the same with NaN, infinity, huge and denormal entries, and zeros."""
    states = []
    for function in found.programs:
        rows = [np.atleast_2d(np.asarray(x, dtype=float)) for x in found.test_inputs[function]]
        spoilt = [[x, x * 1e-310, x * 0.0, x * 1e200, np.where(np.arange(x.shape[1]) == 0, np.nan, x),
                   np.where(np.arange(x.shape[1]) == x.shape[1] - 1, np.inf, x)] for x in rows]  # fmt: skip
        states.append([np.concatenate(parts) for parts in spoilt])
    return states


def run_program(found: Model, folder: Path, compile_with: Sequence[str], run_with: Sequence[str] = ()) -> None:
    source = written(found, folder)
    (folder / "main.c").write_text(program_of(found, good_and_bad(found)))
    command = [*compile_with, "-std=c99", "main.c", source.name, "-o", "checked", "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
    assert done.returncode == 0, done.stderr[-2000:]
    done = subprocess.run([*run_with, "./checked"], capture_output=True, text=True, check=False, cwd=folder)
    assert done.returncode == 0, done.stderr[-3000:]
    assert done.stdout.split() == [word for function in found.programs for word in (function, "0")]
    assert "runtime error" not in done.stderr and "ERROR" not in done.stderr.replace("ERROR SUMMARY: 0", "")


SANITIZED = (
    "four_bar",
    "pendulum",
    "ur5",
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("three_ups_upu_s", "delta", "stewart_6ups")),
)
SANITIZE = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")


@pytest.mark.tools
@pytest.mark.parametrize("name", SANITIZED)
def test_address_and_undefined_behaviour_sanitizers(name: str, tmp_path: Path) -> None:
    """All functions clean, at good states and bad ones, by single calls and by batches; statuses are the same."""
    run_program(catalogued(name), tmp_path, (tool("gcc"), "-O0", *SANITIZE))


@pytest.mark.tools
@pytest.mark.parametrize("name", ["four_bar", pytest.param("ur5", marks=pytest.mark.slow)])
def test_derivatives_and_jacobians_under_sanitizers(name: str, tmp_path: Path) -> None:
    """So are derivatives, regressors, and the Jacobians of CasADi's external functions."""
    further = derive(catalogue.load(name), derivatives=True, regressor=True)
    new = [function for function in further.programs if function not in catalogued(name).programs]
    assert len(new) > 4
    for folder, found in (("derivatives", further.only(new)), ("jacobians", jacobians_model(catalogued(name))[0])):
        (tmp_path / folder).mkdir()
        run_program(found, tmp_path / folder, (tool("gcc"), "-O0", *SANITIZE))


@pytest.mark.tools
def test_the_sanitizers_see_an_array_that_is_too_short(tmp_path: Path) -> None:
    """The guard of the test above taken out: an output array one entry too short is noticed."""
    found = some("four_bar", ("inverse_dynamics",))
    text = program_of(found, good_and_bad(found))
    source = written(found, tmp_path)
    (tmp_path / "main.c").write_text(text.replace("* sizeof(double) + !", "* sizeof(double) - 8 + !", 1))
    command = [tool("gcc"), "-O1", *SANITIZE, "-std=c99", "main.c", source.name, "-o", "checked", "-lm"]
    assert subprocess.run(command, capture_output=True, check=False, cwd=tmp_path).returncode == 0
    done = subprocess.run(["./checked"], capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode != 0 and "heap-buffer-overflow" in done.stderr


@pytest.mark.tools
def test_valgrind(tmp_path: Path) -> None:
    """No invalid access, nothing uninitialised, nothing leaked."""
    options = ("--error-exitcode=9", "--leak-check=full", "--quiet")
    run_program(some("four_bar"), tmp_path, (tool("gcc"), "-g", "-O1"), (tool("valgrind"), *options))


@pytest.mark.slow
def test_a_million_random_states_against_casadi() -> None:
    """Inverse dynamics of the four-bar: batch function and CasADi at 1e6 states, anywhere in q, v, a."""
    pytest.importorskip("casadi")
    found = catalogued("four_bar")
    found = dataclasses.replace(found, programs={"inverse_dynamics": found.programs["inverse_dynamics"]})
    random = np.random.default_rng(12)
    q, v, a = random.uniform(-np.pi, np.pi, (1_000_000, 3)), *random.uniform(-10, 10, (2, 1_000_000, 3))
    fast, slow = load(found, backend="c"), load(found, backend="casadi")
    u, first = fast.inverse_dynamics(q, v, a, check=False)  # type: ignore[misc]
    expected, second = slow.inverse_dynamics(q, v, a, check=False)  # type: ignore[misc]
    assert (first == second).all() and (first == 0).mean() > 0.99
    good = first == 0
    usual = np.median(np.abs(expected[good]))
    scale = np.maximum(np.abs(expected[good]), usual)
    error = np.abs(u[good] - expected[good]) / scale
    # near a singular position a value grows with 1/pivot, and so does what a rounding of the pivot means
    assert (error / (scale / usual)).max() < 1e-12
    assert np.median(error) < 1e-15


FAST_MATH = ("-ffast-math", "-fno-finite-math-only")
FLUSHED = """
import sys
from dataclasses import replace
import numpy as np
sys.path.insert(0, {tests!r})
from runs import compiled, error_of, run_of, scene_of
from symscrew.scene import Initial
from symscrew.simulation import native

native.NATIVE_FLAGS = (*native.NATIVE_FLAGS, "-O1")
model, plant, _ = compiled("bricard")
flags = (*native.NATIVE_FLAGS, *{flags!r})
other = native.Library(plant, "", flags)
scene = replace(scene_of("bricard", tolerance=1e-9), initial=Initial(rates={{"R1": 1e-310}}))
first, second = run_of("bricard", scene), run_of("bricard", scene, other)
small = np.float64(1e-310) * np.float64(0.5) == 0.0
print(first.ok, second.ok, np.abs(first.q - second.q).max() < 1e-12, error_of("bricard", second) < 1e-9, small)
"""


def test_denormal_rates() -> None:
    """A04 with rates of 1e-310: the accelerations of rest, bit for bit. (Times are not asserted in tests.)"""
    found, _ = prepared("bricard")
    forward = {"forward_dynamics": found.programs["forward_dynamics"]}
    calls = load(dataclasses.replace(found, programs=forward), backend="c")
    q = found.system.reference
    rest, first = calls.forward_dynamics(q, np.zeros(5), check=False)  # type: ignore[misc]
    tiny, second = calls.forward_dynamics(q, np.full(5, 1e-310), check=False)  # type: ignore[misc]
    assert first == second <= 0 and (rest == tiny).all()


@pytest.mark.slow
def test_fast_math_and_flushed_denormals() -> None:
    """A04 for 10 s from rates of 1e-310, compiled with -ffast-math: the same run to 1e-12, while denormals are flushed.

    In a process of its own: such a library makes all of its process flush denormals (with gcc, seen by the last
    word). With -ffinite-math-only, which would drop the checks for NaN, the code refuses to compile (checked).
    """
    assert "same trajectory to 1e-12" in case(38)["pass_criterion"]
    script = FLUSHED.format(tests=str(Path(__file__).parent), flags=FAST_MATH)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    *same, flushed = done.stdout.split()
    assert same == ["True"] * 4, done.stdout
    assert flushed == "True" or "gcc" not in str(find_compiler())
    with pytest.raises(CompileError, match="the checks for NaN would vanish"):
        load(some("four_bar", ("closure",)), backend="c", flags=("-ffast-math",))

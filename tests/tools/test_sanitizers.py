"""Generated C under clang, sanitizers and valgrind: the same bits, nothing invalid, uninitialised or leaked."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from support.compiled_c import MODELS, results_of, some, tool, written
from support.marks import slow
from support.model_states import model as catalogued
from support.model_states import relative

from symscrew.export.casadi_external import jacobians_model
from symscrew.model import Model, derive


@pytest.mark.parametrize("name, functions", MODELS)
def test_gcc_and_clang(name: str, functions: Sequence[str], tmp_path: Path) -> None:
    """The same bits from both without contraction, with it 1e-13 of the output's norm."""
    found = some(name, functions)
    source = written(found, tmp_path)
    gcc, clang = tool("gcc"), tool("clang")
    expected = results_of(found, source, gcc, ("-O2", "-ffp-contract=off"))
    for level in ("-O0", "-O3"):
        same = results_of(found, source, clang, (level, "-ffp-contract=off"))
        for function, values in expected.items():
            assert values.tobytes() == same[function].tobytes(), (function, level)
    near = results_of(found, source, clang, ("-O2", "-march=native", "-ffp-contract=fast"))
    assert all(relative(near[function], values) < 1e-13 for function, values in expected.items())


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


LIMBS = ("velocity", "inverse_dynamics", "momentum_screws", "inverse_kinematics")
SANITIZED = (
    ("four_bar", None),
    ("pendulum", ("inverse_dynamics", "mass_matrix", "forward_dynamics")),
    slow("planar_3rrr", LIMBS),  # what is printed for limbs, lanes and loops
)


SANITIZE = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")


@pytest.mark.parametrize(("name", "functions"), SANITIZED)
def test_address_and_undefined_behaviour_sanitizers(name: str, functions: Sequence[str] | None, tmp_path: Path) -> None:
    """All functions clean, at good states and bad ones, by single calls and by batches; statuses are the same."""
    found = some(name, functions) if functions else catalogued(name)
    run_program(found, tmp_path, (tool("gcc"), "-O0", *SANITIZE))


def test_derivatives_and_jacobians_under_sanitizers(tmp_path: Path) -> None:
    """So are derivatives, regressors, and the Jacobians of CasADi's external functions."""
    further = derive(catalogued("four_bar").mechanism, derivatives=True, regressor=True)
    new = [function for function in further.programs if function not in catalogued("four_bar").programs]
    assert len(new) > 4
    chosen = some("four_bar", ("assemble", "forward_dynamics", "inverse_dynamics"))
    for folder, found in (("derivatives", further.only(new)), ("jacobians", jacobians_model(chosen)[0])):
        (tmp_path / folder).mkdir()
        run_program(found, tmp_path / folder, (tool("gcc"), "-O0", *SANITIZE))


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


def test_valgrind(tmp_path: Path) -> None:
    """No invalid access, nothing uninitialised, nothing leaked."""
    options = ("--error-exitcode=9", "--leak-check=full", "--quiet")
    run_program(some("four_bar"), tmp_path, (tool("gcc"), "-g", "-O1"), (tool("valgrind"), *options))

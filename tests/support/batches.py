"""Batches beside single calls, and what their machine code must hold."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np

from support.model_states import relative
from symscrew.export.c import print_c, straight_line
from symscrew.export.c_precision import DOUBLE
from symscrew.export.c_printed import Printed
from symscrew.model import Model
from symscrew.runtime.compiled import FLAGS, CompiledModel

NAME = "four_bar"


EXACT = ("-ffp-contract=off",)


def only(found: Model, *names: str) -> Model:
    """A model with some of the functions, which compiles faster."""
    return replace(found, programs={name: found.programs[name] for name in names})


def inputs(found: Model, function: str, count: int) -> list[np.ndarray]:
    given = [np.atleast_2d(x) for x in found.test_inputs[function]]
    return [np.resize(x, (count, x.shape[1])).copy() for x in given]


def difference(expected: np.ndarray, got: np.ndarray) -> float:
    """Largest relative difference; infinite where NaN does not meet NaN."""
    lost = np.isnan(expected)
    if expected.shape != got.shape or not np.array_equal(lost, np.isnan(got)):
        return np.inf
    return relative(got[~lost], expected[~lost])


def check_layouts(found: Model, vectorised: CompiledModel, single: CompiledModel) -> None:
    """Counts that leave every remainder of a block of eight; bit for bit, as nothing is contracted.

    Only the sine of an angle that remains alone in its group of four is not the vector function's in a single call.
    """
    for function, program in found.programs.items():
        angles = Printed(NAME, function, straight_line(program), DOUBLE).angles.gathered
        limit = 1e-14 if len(angles) % DOUBLE.group == 1 else 0.0
        for count in (1, 2, 7, 8, 19):
            arrays = inputs(found, function, count)
            states = [vectorised[function](*[x[i] for x in arrays], check=False) for i in range(count)]
            expected = [np.stack(parts) for parts in zip(*states, strict=True)]
            rows = vectorised[function](*arrays, check=False)
            columns = vectorised[function](*[np.asfortranarray(x) for x in arrays], check=False)
            plain = single[function](*arrays, check=False)
            for a, b, c, d in zip(expected, rows, columns, plain, strict=True):
                assert all(difference(a, x) <= limit for x in (b, c, d)), (function, count)
        assert len(expected) == len(program.outputs) + 1


MACHINES = ("x86-64", "x86-64-v3", "x86-64-v4")


def check_vector_code(found: Model, tmp_path: Path, compiler: str, machine: str) -> None:
    """No number of a block is computed on its own, with checks or without, and products meet their sums."""
    names = ("closure_bias", "velocity", "inverse_dynamics", "forward_dynamics")
    for file, text in print_c(only(found, *names)).items():
        (tmp_path / file).write_text(text)
    command = [compiler, *FLAGS, f"-march={machine}", "-S", f"{NAME}.c", "-o", "code.s"]
    subprocess.run(command, capture_output=True, check=True, cwd=tmp_path)
    code = (tmp_path / "code.s").read_text()
    for name in names:
        body = re.split(rf"\n{NAME}_{name}_wide[.\w]*:", code)[1].split("\n\t.size\t")[0]
        arithmetic = re.findall(r"\tv?(?:fn?m(?:add|sub)\d*|add|sub|mul|div)([sp])d\b", body)
        assert arithmetic.count("p") > 10 and arithmetic.count("s") == 0, name
        assert ("fmadd" in body or "fmsub" in body or "fnmadd" in body) == (machine != "x86-64")
        widest = next(width for width in ("zmm", "ymm", "xmm") if width in body)
        half = compiler == "clang"  # which has two vectors of half the size
        assert widest == {"x86-64": "xmm", "x86-64-v3": "ymm", "x86-64-v4": "ymm" if half else "zmm"}[machine]

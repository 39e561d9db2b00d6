"""Generated C written, compiled and called by the tests themselves."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from support.model_states import model as catalogued
from symscrew.export.c import print_c
from symscrew.model import Model

FUNCTIONS = ("inverse_dynamics", "forward_dynamics_reactions", "closure", "assemble")  # of each form one


MODELS = (
    pytest.param("four_bar", FUNCTIONS, marks=pytest.mark.slow),
    ("planar_3rrr", ("inverse_dynamics", "closure", "inverse_kinematics")),
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
    return found.only(functions)


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

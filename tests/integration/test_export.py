"""Printers on programs made by hand: same numbers, same statuses, same bytes, clean compilation."""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support import handmade

from symscrew.export.c_form import library_sources
from symscrew.generation.c_target import STRICT
from symscrew.generation.folder import generate
from symscrew.generation.value_comparison import relative_difference
from symscrew.model import Model
from symscrew.runtime.compiled import CompileError, EvaluationError, compile_c, find_compiler, load

COMPILERS = [path for path in map(shutil.which, ("gcc", "clang")) if path]


@pytest.fixture(scope="module")
def model():
    return handmade.model()


@pytest.fixture(scope="module")
def generated(model, tmp_path_factory) -> Path:
    directory = tmp_path_factory.mktemp("export") / "handmade"
    generate(model, directory)
    return directory


def numpy_module(directory: Path):
    spec = importlib.util.spec_from_file_location("handmade_numpy", directory / "handmade_numpy.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def evaluators(model: Model, directory: Path) -> dict:
    """Target name to f(function, arrays (states, size)) -> (outputs (states, size), status)."""
    compiled = {"c": load(directory, trusted=True), "casadi": load(model, backend="casadi")}

    def run(backend: str):
        def call(name: str, inputs):
            function = compiled[backend][name]
            outputs = [np.empty((len(inputs[0]), port.size)) for port in function.outputs]
            status = np.zeros(len(inputs[0]), dtype=np.intc)
            function.evaluator([np.ascontiguousarray(x) for x in inputs], outputs, status)
            return outputs, status

        return call

    module = numpy_module(directory)
    return {"c": run("c"), "casadi": run("casadi"), "numpy": lambda name, x: getattr(module, name)(*x)}


@pytest.fixture(scope="module")
def targets(model, generated) -> dict:
    return evaluators(model, generated)


# -- the same operations in every language -----------------------------------------------------------


@pytest.mark.parametrize("target", ["c", "casadi", "numpy"])
@pytest.mark.parametrize("name", ["every_operation", "guarded", "assemble"])
def test_targets_agree_with_the_evaluator(model, targets, target, name):
    expected, status = model(name, *model.test_inputs[name])
    got, got_status = targets[target](name, model.test_inputs[name])
    assert np.array_equal(status, got_status)
    assert max(relative_difference(a, b) for a, b in zip(expected, got, strict=True)) <= 1e-14


@pytest.mark.parametrize("target", ["c", "casadi", "numpy"])
def test_statuses(targets, target):
    states = np.array([[1.0, 2.0], [0.0, 1.0], [1e-10, 1.0], [-2.0, np.nan], [-2.0, np.inf], [-1e-8, 1.0]])
    _, status = targets[target]("guarded", [states])
    assert status.tolist() == [0, 1, 1, 2, 2, 0]
    x = np.array([[1.0, 2.0, 3.0], [np.nan, 2.0, 3.0], [1.0, 2.0, np.inf], [1.0, 1e200, 1e200]])
    _, status = targets[target]("every_operation", [x, np.zeros((4, 2))])
    assert status.tolist() == [0, 2, 2, 2]


@pytest.mark.parametrize("target", ["c", "casadi", "numpy"])
def test_statuses_of_an_iteration(targets, target):
    up, down = [0.0, 1.0], [0.0, -1.0]
    y = np.array([[0.6], [0.6], [1.2], [np.nan], [0.6], [0.6]])
    guess = np.array([up, down, up, up, [np.inf, 1.0], [0.0, 0.0]])
    (q,), status = targets[target]("assemble", [y, guess, np.ones((6, 1))])
    assert status.tolist() == [0, 0, 3, 2, 2, 3]
    assert q[:2] == pytest.approx(np.array([[0.6, 0.8], [0.6, -0.8]]), abs=1e-12)


@pytest.mark.parametrize("target", ["c", "numpy"])
def test_all_outputs_are_nan_after_a_failure(targets, target):
    outputs, status = targets[target]("every_operation", [np.full((1, 3), np.nan), np.zeros((1, 2))])
    assert status.tolist() == [2]
    assert all(np.isnan(output).all() for output in outputs)


@pytest.mark.parametrize("target", ["c", "casadi", "numpy"])
def test_substeps_reach_what_newton_alone_does_not(tmp_path, target):
    """From far away Newton diverges, small steps do not."""
    far = handmade.model(assemble=handmade.far_target())
    generate(far, tmp_path / "out")
    y, guess = np.array([[0.1], [1.0], [-0.7], [100.0]]), np.zeros((4, 2))
    direct = handmade.model(assemble=replace(handmade.far_target(), max_substeps=1))
    assert direct("assemble", y, guess)[1].tolist() == [0, 3, 3, 3]
    (q,), status = evaluators(far, tmp_path / "out")[target]("assemble", [y, guess])
    assert status.tolist() == [0, 0, 0, 3]
    assert q[:3, 1] == pytest.approx(10 * y[:3, 0], abs=1e-12)


# -- C -----------------------------------------------------------------------------------------------


def test_a_c_compiler_is_present():
    assert COMPILERS and find_compiler()


@pytest.mark.parametrize("compiler", COMPILERS, ids=lambda path: Path(path).name)
@pytest.mark.parametrize("level", ["-O0", "-O2"])
def test_c_compiles_without_warnings(generated, tmp_path, compiler, level):
    command = [compiler, *STRICT, "-Wshadow", level, "-o", str(tmp_path / "example")]
    sources = sorted(map(str, generated.glob("*.c")))
    result = subprocess.run([*command, *sources, "-lm"], capture_output=True, text=True, check=False)
    assert (result.stderr, result.returncode) == ("", 0)
    printed = subprocess.run([str(tmp_path / "example")], capture_output=True, text=True, check=True).stdout
    assert "handmade_assemble: status 0, success" in printed
    assert re.search(r"q 0 \[m\] +0\.1\b", printed)


def test_header_can_be_used_from_cpp(generated, tmp_path):
    compiler = shutil.which("g++") or shutil.which("clang++") or shutil.which("c++")
    assert compiler
    (tmp_path / "use.cpp").write_text(
        '#include "handmade.h"\n#include <cstdio>\n'
        "int main() { double x[HANDMADE_GUARDED_X_SIZE] = {2.0, 0.0}, y[HANDMADE_GUARDED_Y_SIZE];\n"
        'int status = handmade_guarded(x, y); std::printf("%d %g\\n", status, y[0]); return status; }\n'
    )
    library = tmp_path / "libhandmade.so"
    first, *others = library_sources((path.name for path in generated.iterdir()), "handmade")
    compile_c(generated / first, library, flags=[str(generated / other) for other in others])
    flags = [
        "-Wall",
        "-Wextra",
        "-pedantic",
        "-Werror",
        f"-I{generated}",
        str(tmp_path / "use.cpp"),
        str(library),
    ]
    subprocess.run([compiler, *flags, "-o", str(tmp_path / "use")], check=True)
    printed = subprocess.run([str(tmp_path / "use")], capture_output=True, text=True, check=True).stdout
    assert printed == "0 0.5\n"


def test_names_that_the_code_needs_itself():
    twice = handmade.program(
        "twice",
        {"sin": 1, "x1": 1, "total": 1},
        {"status_": lambda t, s, x, n: [t.function("sin", s[0]) + x[0] * n[0]]},
    )
    compiled = load(handmade.model(twice=twice))
    assert compiled.twice([0.5], [2.0], [3.0]) == pytest.approx([np.sin(0.5) + 6])


def test_ports_without_entries(tmp_path):
    hollow = handmade.program("hollow", {"x": 1, "none": 0}, {"y": lambda t, x, n: [x[0] + 1], "z": lambda t, x, n: []})
    model = handmade.model(hollow=hollow)
    generate(model, tmp_path / "out")
    for target, call in evaluators(model, tmp_path / "out").items():
        (y, z), status = call("hollow", [np.array([[1.0], [2.0]]), np.zeros((2, 0))])
        assert (y.tolist(), z.shape, status.tolist()) == ([[2.0], [3.0]], (2, 0), [0, 0]), target
    command = [
        COMPILERS[0],
        *STRICT,
        "-r",
        *map(str, sorted((tmp_path / "out").glob("handmade_*.c"))),
        "-o",
        str(tmp_path / "hollow.o"),
    ]
    subprocess.run(command, check=True)


# -- calling it from Python ----------------------------------------------------------------------------


@pytest.mark.parametrize("backend", ["c", "casadi"])
def test_batch_equals_single_calls(model, backend):
    compiled = load(model, backend=backend)
    assert compiled.backend == backend
    x = np.random.default_rng(0).normal(size=(4, 3, 3))
    scalars, matrix = compiled.every_operation(x, np.zeros(2))
    assert scalars.shape == (4, 3, 15)
    assert matrix.shape == (4, 3, 2, 3)
    one_scalars, one_matrix = compiled.every_operation(unused=np.zeros(2), x=x[2, 1])
    assert np.array_equal(scalars[2, 1], one_scalars)
    assert np.array_equal(matrix[2, 1], one_matrix)
    assert matrix[2, 1, 1, 0] == x[2, 1, 1] ** 2 + 1  # second entry of the first column


def test_failures_raise_or_are_returned(generated):
    compiled = load(generated, trusted=True)
    x = np.array([[1.0, 1.0], [0.0, 1.0]])
    with pytest.raises(EvaluationError, match=r"guarded: 1 of 2 states failed; the first is state \(1,\): near-sing"):
        compiled.guarded(x)
    with pytest.raises(EvaluationError, match="not finite"):
        compiled.guarded([1.0, np.nan])
    y, status = compiled.guarded(x, check=False)
    assert status.tolist() == [0, 1]
    assert np.isnan(y[1]).all()
    assert y[0, 0] == 1.0


def test_wrong_calls_say_what_was_expected(generated):
    compiled = load(generated, trusted=True)
    with pytest.raises(ValueError, match=r"guarded expects x of shape \(2,\).*got \(3,\)"):
        compiled.guarded(np.zeros(3))
    with pytest.raises(TypeError, match=r"expects \(x, unused\)"):
        compiled.every_operation(np.zeros(3))
    with pytest.raises(AttributeError, match="guarded"):
        _ = compiled.missing


def test_without_a_compiler_casadi_takes_over(model, monkeypatch):
    monkeypatch.setattr("symscrew.runtime.compiled.find_compiler", lambda: None)
    monkeypatch.setattr("symscrew.runtime.compilers.find_compiler", lambda: None)
    compiled = load(model)
    assert compiled.backend == "casadi"
    assert compiled.guarded([2.0, 0.0]) == pytest.approx([0.5, 0.0])
    with pytest.raises(CompileError, match="no C compiler"):
        load(model, backend="c")


def test_casadi_files_load_without_symscrew(generated):
    code = (
        "import sys, casadi; f = casadi.Function.load(sys.argv[1]); r = f(x=[2, 0.5]);"
        "print(f.name_in(), f.name_out(), float(r['y'][0]), float(r['status']), 'symscrew' in sys.modules)"
    )
    command = [sys.executable, "-I", "-c", code, str(generated / "guarded.casadi")]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert printed == "['x'] ['y', 'status'] 0.5 0.0 False\n"


def test_numpy_module_depends_on_numpy_only(generated):
    imports = re.findall(r"^[ \t]*(?:import|from) .*", (generated / "handmade_numpy.py").read_text(), re.MULTILINE)
    assert imports == ["from __future__ import annotations", "import numpy as np"]


# -- files ---------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_equal_input_gives_equal_bytes_in_every_process():
    """Derivatives too: of a value that is a result, often, and read by others, no hash of a text says who is first."""
    code = (
        "import hashlib; from support import handmade; from symscrew.generation.folder import render;"
        "print({k: hashlib.sha256(v).hexdigest() for k, v in sorted(render(handmade.model()).items())});"
        "from symscrew.algebra import Tape, differentiate; tape = Tape(); keys = [str(k) for k in range(12)];"
        "x = [tape.symbol('x' + key, '1', 'input') for key in keys]; s = tape.function('sin', x[0]);"
        "outputs = [*(s * other for other in x[1:]), *[s] * 12];"
        "seeds = {node: {key: tape.one} for key, node in zip(keys, x)};"
        "differentiate(tape, outputs, seeds, keys, order='markowitz'); print(tape.nodes)"
    )
    printed = in_processes(code)
    assert len(printed) == 1
    assert "handmade_support.c" in (said := printed.pop()) and "Node(mul" in said


def in_processes(code: str) -> set[str]:
    """What Python code prints in processes whose hashes of texts differ."""
    root, printed = Path(__file__).parents[2], set()
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": f"{root}{os.pathsep}{root / 'tests'}"}
        command = [sys.executable, "-c", code]
        printed.add(subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout)
    return printed

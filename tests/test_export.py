"""Printers on programs made by hand: same numbers, same statuses, same bytes, clean compilation."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import handmade
import numpy as np
import pytest

from symscrew.description.builder import MechanismBuilder
from symscrew.export import c, casadi, listing
from symscrew.export import numpy as numpy_printer
from symscrew.export.manifest_file import OutputError, effect_from_json, effect_to_json
from symscrew.generation.c_target import STRICT
from symscrew.generation.folder import generate, render
from symscrew.generation.value_comparison import relative_difference
from symscrew.model import derive
from symscrew.program.straight_line import COUNTED, Instruction
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


def evaluators(directory: Path) -> dict:
    """Target name to f(function, arrays (states, size)) -> (outputs (states, size), status)."""
    compiled = {backend: load(directory, backend=backend) for backend in ("c", "casadi")}

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
def targets(generated) -> dict:
    return evaluators(generated)


# -- the same operations in every language -----------------------------------------------------------


def test_every_printer_knows_every_operation_and_the_test_program_uses_them_all():
    for table in (c.TABLE, casadi.TABLE, numpy_printer.TABLE):
        assert set(table) == set(COUNTED)
    used = {i.op for i in handmade.every_operation().instructions}
    assert used == set(COUNTED)


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
    (q,), status = evaluators(tmp_path / "out")[target]("assemble", [y, guess])
    assert status.tolist() == [0, 0, 0, 3]
    assert q[:3, 1] == pytest.approx(10 * y[:3, 0], abs=1e-12)


# -- C -----------------------------------------------------------------------------------------------


def test_a_c_compiler_is_present():
    assert COMPILERS and find_compiler()


@pytest.mark.parametrize("compiler", COMPILERS, ids=lambda path: Path(path).name)
@pytest.mark.parametrize("level", ["-O0", "-O2"])
def test_c_compiles_without_warnings(generated, tmp_path, compiler, level):
    command = [compiler, *STRICT, "-Wshadow", level, "-o", str(tmp_path / "example")]
    sources = [str(generated / "handmade.c"), str(generated / "example.c")]
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
    compile_c(generated / "handmade.c", library)
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


def test_header_says_all_that_a_user_must_know(model):
    header = c.print_header(model)
    about = header[header.index(" * handmade_guarded:") : header.index("int handmade_guarded(")]
    total = model.programs["guarded"].operations["total"]
    for text in ("x[2] [m]: test array x", "0 x 0; 1 x 1", "1 near-singular", f"Operations: {total}"):
        assert text in about
    assert "matrix[6] (2x3, column by column)" in header


def test_no_storage_of_its_own(model):
    source = c.print_source(model)
    assert not re.search(r"\b(malloc|calloc|free|alloca|pow)\s*\(", source)
    assert not re.search(r"^static (?!void|int|inline)|^[ \t]+static", source, re.MULTILINE)


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
    for target, call in evaluators(tmp_path / "out").items():
        (y, z), status = call("hollow", [np.array([[1.0], [2.0]]), np.zeros((2, 0))])
        assert (y.tolist(), z.shape, status.tolist()) == ([[2.0], [3.0]], (2, 0), [0, 0]), target
    command = [
        COMPILERS[0],
        *STRICT,
        "-c",
        str(tmp_path / "out/handmade.c"),
        "-o",
        str(tmp_path / "hollow.o"),
    ]
    subprocess.run(command, check=True)


def test_a_constant_is_no_slot_of_the_same_number():
    """The middle entry of a rotation about y is 1; slot 1 is the cosine of the only coordinate, slot 0."""
    builder = MechanismBuilder("hinge")
    builder.body("flap", mass=1, com=[1, 0, 0])
    builder.joint("pin", "R", parent="base", child="flap", point=[0, 0, 0], axes=[[0, 1, 0]])
    text = c.print_c(derive(builder.build()))["hinge.c"]
    lane = text[text.index("hinge_body_poses_lane(") :]
    assert re.search(r"poses\[4\] = 1\.0;", lane[: lane.index("\n}")])


def test_constants_read_back_exactly():
    for value in (0.1, 1e-5, -2.5, 1e300, 5e-324, 1.0, 123456789012345680.0):
        text = listing.decimal(value)
        assert float(text.strip("()")) == value
        assert "." in text
    with pytest.raises(ValueError, match="finite"):
        listing.decimal(float("nan"))


@pytest.mark.parametrize("name", ["a b", "int", "../x", 'a"', "a\nb"])
def test_bad_names_are_refused(model, name):
    with pytest.raises(ValueError, match="name"):
        c.print_c(replace(model, name=name))


# -- calling it from Python ----------------------------------------------------------------------------


@pytest.mark.parametrize("backend", ["c", "casadi"])
def test_batch_equals_single_calls(model, generated, backend):
    compiled = load(generated, backend=backend)
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
    compiled = load(generated)
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
    compiled = load(generated)
    with pytest.raises(ValueError, match=r"guarded expects x of shape \(2,\).*got \(3,\)"):
        compiled.guarded(np.zeros(3))
    with pytest.raises(TypeError, match=r"expects \(x, unused\)"):
        compiled.every_operation(np.zeros(3))
    with pytest.raises(AttributeError, match="guarded"):
        _ = compiled.missing


def test_without_a_compiler_casadi_takes_over(generated, monkeypatch):
    monkeypatch.setattr("symscrew.runtime.compiled.find_compiler", lambda: None)
    compiled = load(generated)
    assert compiled.backend == "casadi"
    assert compiled.guarded([2.0, 0.0]) == pytest.approx([0.5, 0.0])
    with pytest.raises(CompileError, match="no C compiler"):
        load(generated, backend="c")


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


def test_python_code_is_never_evaluated():
    package = Path(listing.__file__).parents[1]
    for path in package.rglob("*.py"):
        assert not re.search(r"(?<![\w.])(eval|exec|compile)\(", path.read_text(encoding="utf-8")), path


# -- files ---------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_equal_input_gives_equal_bytes_in_every_process():
    code = (
        "import hashlib, handmade; from symscrew.generation.folder import render;"
        "print({k: hashlib.sha256(v).hexdigest() for k, v in sorted(render(handmade.model()).items())})"
    )
    root = Path(__file__).parents[1]
    printed = set()
    for seed in ("1", "2"):
        environment = {
            **os.environ,
            "PYTHONHASHSEED": seed,
            "PYTHONPATH": f"{root}{os.pathsep}{root / 'tests'}",
        }
        command = [sys.executable, "-c", code]
        printed.add(subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout)
    assert len(printed) == 1
    assert "handmade.c" in printed.pop()


def test_no_place_or_time_in_the_output(generated):
    home = str(Path(__file__).parents[1])
    for path in generated.iterdir():
        content = path.read_bytes()
        assert home.encode() not in content, path
        assert not re.search(rb"\b20\d\d-\d\d-\d\d\b", content), path


def test_generating_again_changes_nothing_and_removes_what_is_stale(model, tmp_path):
    directory = tmp_path / "out"
    generate(model, directory)
    (directory / "build").mkdir()
    (directory / "notes.txt").write_text("mine")
    before = {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}
    generate(model, directory)
    assert before == {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}
    generate(model, directory, targets=("c",))
    names = {path.name for path in directory.iterdir()}
    assert "handmade_numpy.py" not in names
    assert {"handmade.c", "notes.txt", "build"} <= names


def test_files_of_others_are_not_overwritten(model, tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full/thesis.tex").write_text("all I have")
    with pytest.raises(OutputError, match="did not write"):
        generate(model, tmp_path / "full")
    assert [path.name for path in tmp_path.rglob("*")] == ["full", "thesis.tex"]
    generate(model, tmp_path / "out", targets=("numpy",))
    (tmp_path / "out/handmade.c").write_text("/* by hand */")
    with pytest.raises(OutputError, match=r"handmade\.c was not written by this tool"):
        generate(model, tmp_path / "out")
    assert (tmp_path / "out/handmade.c").read_text() == "/* by hand */"


def test_what_is_no_manifest_any_more_has_a_way_out(model, tmp_path):
    (tmp_path / "manifest.json").write_text("torn")
    with pytest.raises(OutputError, match=r"not valid JSON.*; remove the directory, or use another one"):
        generate(model, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["manifest.json"]


def test_a_manifest_cannot_name_files_elsewhere(model, tmp_path):
    generate(model, tmp_path / "out")
    (tmp_path / "precious.txt").write_text("keep")
    manifest = json.loads((tmp_path / "out/manifest.json").read_text())
    manifest["files"] += ["../precious.txt", "/precious.txt"]
    (tmp_path / "out/manifest.json").write_text(json.dumps(manifest))
    generate(model, tmp_path / "out")
    assert (tmp_path / "precious.txt").read_text() == "keep"


def test_nothing_is_half_written(model, tmp_path, monkeypatch):
    broken = handmade.guarded()
    broken = replace(broken, instructions=(*broken.instructions[:-1], Instruction(4, "mul", (1, float("inf")))))
    with pytest.raises(ValueError, match="finite"):
        generate(handmade.model(broken=broken), tmp_path / "out")
    assert list(tmp_path.iterdir()) == []
    write, written = Path.write_bytes, []

    def full_disk(path: Path, data: bytes) -> int:
        written.append(path)
        if len(written) > 4:
            raise OSError("no space left")
        return write(path, data)

    monkeypatch.setattr(Path, "write_bytes", full_disk)
    with pytest.raises(OutputError, match=r"out: cannot be written \(no space left\); nothing was, use another place"):
        generate(model, tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_operations_are_what_is_printed(model):
    """Count the operations in the text of the C function itself and of the lane that it runs."""
    source = c.print_source(model, batches=False)
    body = source[source.index("handmade_guarded_lane(\n") : source.index("handmade_assemble_step_lane(\n")]
    lines = (line for line in body.splitlines() if "=" in line or "return x" in line or "return (" in line)
    code = re.sub(r"= (co)?sine\[", "sin(", "\n".join(lines))
    code = re.sub(r"e[+-]\d+|x\d+ =|\[[^]]*\]|const double", " ", code)
    count = sum(code.count(sign) for sign in (" + ", " - ", " * ", " / ", "sin(", "fabs(", " <= ", "isfinite("))
    operations = json.loads(render(model, ("c",))["ops.json"])["guarded"]
    assert count == operations["total"]
    assert operations["total"] == sum(n for key, n in operations.items() if key != "total")


def test_effects_survive_the_manifest():
    from symscrew.effects.external_wrench import ExternalWrench
    from symscrew.effects.gravity import Gravity

    for effect in (Gravity(), Gravity((0, "-1/3", 0.5)), ExternalWrench("tool")):
        again = effect_from_json(json.loads(json.dumps(effect_to_json(effect))))
        assert again == effect
    for bad in ({"type": "Effect"}, {"type": "os"}, {"type": "Gravity", "field": 1}, None):
        with pytest.raises(OutputError):
            effect_from_json(bad)


def test_latex_in_the_notation_of_the_paper():
    import sympy

    from symscrew.export.latex import markdown, matrix_latex, screw_latex

    theta, radius, length = sympy.symbols("theta R L")
    wrench = sympy.Matrix([0, 1, 0, 0, 0, -radius + length / sympy.sin(theta)])
    text = screw_latex(wrench, {theta: r"\vartheta"})
    assert (
        text == r"\begin{pmatrix} 0 & 1 & 0 & ; & 0 & 0 & \frac{L}{\sin{\left(\vartheta \right)}} - R \end{pmatrix}^{T}"
    )
    block = markdown("W", matrix_latex(sympy.Matrix.hstack(wrench, 2 * wrench)))
    assert block.startswith("$$\nW = \\left(\\begin{array}{cc}\n0 & 0 \\\\\n1 & 2 \\\\\n0 & 0 \\\\ \\hline\n")
    with pytest.raises(ValueError, match="6 entries"):
        screw_latex(sympy.eye(2))

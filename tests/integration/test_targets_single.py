"""C of type float: no double in it, errors as stated, at the command line and back through `check`."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.export.c import print_c
from symscrew.export.c_form import library_sources
from symscrew.export.c_precision import SINGLE
from symscrew.export.c_single import single_errors, single_inputs
from symscrew.generation.c_target import STRICT
from symscrew.runtime.compiled import find_compiler, load
from symscrew.verification.regeneration import check

COMPILER = find_compiler()
compiled_code = pytest.mark.skipif(COMPILER is None, reason="no C compiler")
STATED = ("forward_kinematics", "inverse_dynamics", "forward_dynamics", "mass_matrix", "energy", "joint_reactions")
"""Functions whose stated errors are looked at: poses, forces, accelerations, a matrix, sums, screws."""


def code(text: str) -> str:
    """Without comments and texts."""
    return re.sub(r'/\*.*?\*/|"[^"]*"', "", text, flags=re.DOTALL)


@pytest.mark.parametrize("name", ["four_bar", "ur5", slow("three_ups_upu_s_physical")])
def test_everything_is_float(name: str) -> None:
    found = model(name)
    if name == "three_ups_upu_s_physical":
        found = found.only(["inverse_dynamics_platform", "forward_dynamics", "inverse_kinematics", "limb_margins"])
    for text in print_c(found, precision=SINGLE).values():
        assert not re.search(r"\bdouble\b", code(text))
        assert not re.search(r"\b(sin|cos|tan|sqrt|exp|atan2|fabs)\(", code(text))
        assert not re.search(r"(?<![\w.])\d+\.\d*(e[+-]?\d+)?(?![\w.])", code(text)), "a constant without suffix"


@pytest.mark.slow
@compiled_code
def test_no_promotion_to_double(tmp_path: Path) -> None:
    """Also with vectors and without: four_bar has every kind of function, a second path and an iteration among them."""
    some = model("four_bar").only([*STATED, "assemble"])
    for file, text in print_c(some, precision=SINGLE).items():
        (tmp_path / file).write_text(text)
    for flags in ((), ("-DFOUR_BAR_SCALAR",), ("-march=native", "-fopenmp")):
        command = [COMPILER, *STRICT, "-O0", *flags, "-c", "four_bar.c", "-o", "code.o"]
        done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path)
        assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.slow
@compiled_code
@pytest.mark.parametrize("name", ["four_bar", "ur5"])
def test_errors_are_those_of_the_header(name: str, tmp_path: Path) -> None:
    found = model(name).only(STATED)
    compiled = load(found, backend="c", precision="single", build_dir=tmp_path)  # all at once
    header = print_c(found, precision=SINGLE)[f"{name}.h"]
    given = single_inputs(found)
    for function, (states, stated) in single_errors(found).items():
        assert 250 <= states <= 256 and f"at {states} states" in header
        inputs = given[function]
        exact, _ = found(function, *inputs)
        *got, status = compiled[function](*inputs, check=False)
        assert (status == 0).sum() == states, function
        for port, a, b, error in zip(found.programs[function].outputs, exact, got, stated, strict=True):
            flat = b if b.ndim == 2 else np.swapaxes(b, 1, 2).reshape(len(b), -1)
            largest = max(np.abs(a).max(initial=0.0), 1e-3)
            assert np.abs(a - flat).max(initial=0.0) / largest <= 8 * max(error, 1e-6), (function, port.name)
            assert f"{port.name} {error:.0e}" in re.sub(r"\s*\n \*\s*", " ", header) or not port.size
        assert max(stated, default=0.0) < 1e-3


@pytest.mark.slow
@compiled_code
def test_assembly_in_single_precision() -> None:
    found = model("four_bar")
    compiled = load(found, backend="c", precision="single")
    y, guess = found.test_inputs["assemble"]
    q = compiled.assemble(y, guess)
    (expected,), _ = found("assemble", y, guess)
    assert np.abs(q - expected).max() < 1e-5


def test_constants_read_back_exactly() -> None:
    for value in (0.1, -1e-5, 1.0, 123456792.0, 3.4e38, 1e-40):
        text = SINGLE.number(value)
        assert text.strip("()").endswith("f") and "." in text
        assert np.float32(text.strip("()f")) == np.float32(value)
    with pytest.raises(ValueError, match="too large for float"):
        SINGLE.number(1e39)


def _compile_readme(out: Path) -> None:
    """The examples in C and C++ are of type float too: no warning, the drive to seven digits."""
    text = (out / "README.md").read_text()
    (u,), _ = model("four_bar")("inverse_dynamics", *(x[:1] for x in model("four_bar").test_inputs["inverse_dynamics"]))
    sources = library_sources((path.name for path in out.iterdir()), "four_bar")
    objects = [COMPILER, *STRICT, "-O0", "-r", *sources, "-o", "four_bar.o"]
    c = [COMPILER, *STRICT, "-O0", "main.c", "four_bar.o", "-o", "main", "-lm"]
    cpp = [
        "c++",
        *(flag for flag in STRICT if flag != "-std=c99"),
        "-O0",
        "main.cpp",
        "four_bar.o",
        "-o",
        "main",
        "-lm",
    ]
    for language, commands in (("c", [objects, c]), ("cpp", [cpp])):
        code = re.search(rf"```{language}\n(.*?)```", text, re.DOTALL)
        assert code
        (out / f"main.{language}").write_text(code[1])
        for command in commands:
            done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=out)
            assert (done.returncode, done.stderr) == (0, ""), language
        printed = subprocess.run([out / "main"], capture_output=True, text=True, check=True).stdout
        assert float(printed.removeprefix("success: ")) == pytest.approx(float(u[0, 0]), rel=1e-5)


@pytest.mark.slow
def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    out = tmp_path / "single"
    some = ["--functions", "inverse_dynamics", "assemble"]
    assert main(["generate", "four_bar", "--precision", "single", *some, "--out", str(out)]) == 0
    assert json.loads((out / "manifest.json").read_text())["precision"] == "single"
    assert not list(out.glob("*.casadi")) and not list(out.glob("*.py"))
    result = check(out)
    assert result.ok, result.lines
    if COMPILER:
        assert any("single precision differs" in line for line in result.lines)
        done = subprocess.run(
            [COMPILER, *STRICT, "-O0", *sorted(path.name for path in out.glob("*.c")), "-o", "example", "-lm"],
            capture_output=True, text=True, check=False, cwd=out,
        )  # fmt: skip
        assert (done.returncode, done.stderr) == (0, "")
        assert "status 0" in subprocess.run([out / "example"], capture_output=True, text=True, check=True).stdout
        _compile_readme(out)
        q, v, a = (np.atleast_2d(x) for x in model("four_bar").test_inputs["inverse_dynamics"])
        u = load(out).inverse_dynamics(q, v, a)
        assert u.dtype == np.float64 and np.abs(u - model("four_bar")("inverse_dynamics", q, v, a)[0][0]).max() < 1e-5
    capsys.readouterr()
    bad = ["generate", "four_bar", "--precision", "single", "--target", "casadi", "--out", str(tmp_path / "no")]
    assert main(bad) == 2
    assert "casadi is double only" in capsys.readouterr().err and not (tmp_path / "no").exists()

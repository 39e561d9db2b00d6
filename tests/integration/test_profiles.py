"""Forms of the C of a folder: in one file, and for a microcontroller; each is checked and loaded as what it is."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from support.documentation import DOCS
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.export import Form, OutputError
from symscrew.generation import generate
from symscrew.runtime import find_compiler, load
from symscrew.verification import check

FEW = ["velocity", "inverse_dynamics"]
compiled_code = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


def command(out: Path, *more: str) -> int:
    return main(["generate", "four_bar", "--out", str(out), "--target", "c", "--functions", *FEW, *more])


def test_one_file(tmp_path: Path) -> None:
    generate(model("four_bar").only(FEW), tmp_path / "made", ["c"], form=Form(one_file=True))
    assert sorted(path.name for path in (tmp_path / "made").glob("four_bar*")) == [
        "four_bar.c", "four_bar.h", "four_bar.hpp"]  # fmt: skip
    assert json.loads((tmp_path / "made/manifest.json").read_text())["one_file"] is True
    for file in ("example.c", "CMakeLists.txt", "README.md"):
        text = (tmp_path / "made" / file).read_text()
        assert "four_bar.c" in text and "_support" not in text


@pytest.mark.slow
@compiled_code
@pytest.mark.parametrize("more", [("--one-file",), ("--profile", "microcontroller"), ()])
def test_folders_are_checked_and_loaded_as_what_they_are(tmp_path: Path, more: tuple[str, ...]) -> None:
    out = tmp_path / "made"
    assert command(out, *more) == 0
    result = check(out)
    assert result.ok, result.lines
    assert any(re.search(r"\bC\b.*(differs|agree)", line) for line in result.lines), result.lines
    states = [np.atleast_2d(x) for x in model("four_bar").test_inputs["velocity"]]
    (expected,), _ = model("four_bar")("velocity", *states)
    assert np.allclose(load(out, backend="c").velocity(*states), expected, rtol=1e-4)


@compiled_code
def test_a_microcontroller_gets_one_state_of_type_float(tmp_path: Path) -> None:
    """No double, no functions of many states, no include of its own files by a file."""
    generate(model("four_bar").only(FEW), tmp_path / "made", ["c"], precision="single", form=Form(batches=False))
    files = {path.name: path.read_text() for path in (tmp_path / "made").glob("*.[ch]")}
    assert sorted(files) == [
        "example.c", "four_bar.h", "four_bar_inverse_dynamics.c", "four_bar_loops.c", "four_bar_support.c",
        "four_bar_support.h",
    ]  # fmt: skip
    text = "".join(text for file, text in files.items() if file != "example.c")
    code = re.sub(r"/\*.*?\*/|\"[^\"]*\"", "", text, flags=re.S)
    assert "_batch" not in code and "VECTORS" not in code and not re.search(r"\bdouble\b", code)
    assert "-std=c99 -Os -c four_bar_*.c" in (tmp_path / "made/README.md").read_text()
    with pytest.raises(OutputError, match="no functions of many states"):
        load(tmp_path / "made", trusted=True)


def test_what_goes_against_a_profile_is_one_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command(tmp_path / "made", "--profile", "microcontroller", "--precision", "double") == 2
    assert "--profile microcontroller is of single precision" in capsys.readouterr().err
    assert not (tmp_path / "made").exists()


@pytest.mark.tools
@pytest.mark.slow
def test_two_functions_of_a_delta_are_small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the page on microcontrollers shows, on a Cortex-M4F with -Os, without the mathematical library."""
    compiler = shutil.which("arm-none-eabi-gcc")
    if compiler is None:
        pytest.fail("this test needs arm-none-eabi-gcc: apt-get install gcc-arm-none-eabi")
    (line,) = re.findall(r"^symscrew (generate .*)", (DOCS / "how_to" / "microcontroller.md").read_text(), re.M)
    words, out = line.split(), tmp_path / "small"
    assert set(words) >= {"delta", "microcontroller", "inverse_dynamics_platform", "inverse_kinematics"}
    monkeypatch.chdir(tmp_path)
    assert main(words) == 0
    machine = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-ffreestanding"]
    sources = sorted(path.name for path in out.glob("delta_*.c"))
    subprocess.run([compiler, "-std=c99", "-Os", *machine, "-c", *sources], cwd=out, check=True)
    objects = sorted(path.name for path in out.glob("*.o"))
    told = subprocess.run(["arm-none-eabi-size", *objects], cwd=out, capture_output=True, text=True, check=True).stdout
    total = sum(int(line.split()[0]) + int(line.split()[1]) for line in told.splitlines()[1:])
    assert total < 8900, told  # what took four options to reach before there was a profile

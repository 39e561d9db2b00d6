"""The generated CMake project."""

from __future__ import annotations

import shutil
import subprocess

import pytest
from support.model_states import model

from symscrew.generation.folder import generate


@pytest.mark.skipif(shutil.which("cmake") is None, reason="needs CMake")
def test_cmake_builds_library_and_example(tmp_path):
    output, cmake = tmp_path / "four_bar", shutil.which("cmake")
    generate(model("four_bar").only(["inverse_dynamics"]), output, targets=("c",))
    build = output / "build"
    for command in ([cmake, "-S", str(output), "-B", str(build)], [cmake, "--build", str(build)]):
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stderr
    printed = subprocess.run([str(build / "four_bar_example")], capture_output=True, text=True, check=True).stdout
    assert "four_bar_inverse_dynamics: status 0, success" in printed
    assert "A [N m]" in printed

"""Code for one operation mode, compiled, generated and checked."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.operation_modes import PARALLELOGRAM, models, states

from symscrew.cli.parser import main
from symscrew.runtime.compiled import load


@pytest.mark.slow
def test_compiled_code_agrees() -> None:
    _, alone = models("delta")
    names = ["inverse_dynamics", "velocity", "forward_dynamics"]
    compiled = load(alone.only(names), flags=("-O1",))
    for name in names:
        inputs = states(alone, name)
        (expected,), status = alone(name, *inputs)
        found, same = compiled[name](*inputs, check=False)
        assert np.array_equal(status, same)
        assert np.allclose(found, expected, rtol=1e-9, atol=1e-9)


@pytest.mark.slow
def test_generate_and_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, out = tmp_path / "parallelogram.toml", tmp_path / "out"
    source.write_text(PARALLELOGRAM, encoding="utf-8")
    some = ["--target", "c", "--functions", "velocity", "inverse_dynamics", "forward_dynamics"]
    assert main(["generate", str(source), "--one-mode", *some, "--out", str(out)]) == 0
    assert '"one_mode": true' in (out / "manifest.json").read_text(encoding="utf-8")
    assert main(["check", str(out)]) == 0
    assert "operation mode" in (out / "parallelogram.h").read_text(encoding="utf-8")
    capsys.readouterr()

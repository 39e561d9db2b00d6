"""Derivatives and regressors are generated on request, and checked."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from symscrew.cli.parser import main


@pytest.mark.slow
def test_generated_on_request_and_checked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The command writes them when it is asked only, and `check` derives them again."""
    wanted = {"linearisation", "regressor", "regressor_independent", "regressor_drives"}
    asked = ["--derivatives", "--regressor"]
    for options in (["numpy"], ["numpy", *asked], ["c", "--functions", *sorted(wanted), *asked]):
        place = tmp_path / f"out{len(options)}"
        assert main(["generate", "four_bar", "--out", str(place), "--target", *options]) == 0
        functions = set(json.loads((place / "manifest.json").read_text())["functions"])
        assert wanted <= functions if "--regressor" in options else not wanted & functions
        if "--regressor" in options:
            assert main(["check", str(place)]) == 0
            assert "all checks passed" in capsys.readouterr().out

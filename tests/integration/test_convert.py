"""`symscrew convert`: what a user wrote is kept."""

from __future__ import annotations

from pathlib import Path

import pytest

from symscrew.cli.parser import main

TEXT = """
# our slider, measured on the machine
[mechanism]
name = "slider"
description = "a block on a rail"

[parameters.rail]
value = "0.45"  # by the drawing
unit = "m"

[parameters.half]
value = "(rail - 0.05) / 2"

[bodies.block]
mass = 1.20
com = ["half*sqrt(1/3)", "rail * 1", 0]
inertia = [1.5e-3, 0.0015, 0.002]

[joints.slide]
type = "P"
parent = "base"
child = "block"
point = [0, 0, 0]
axes = [[1, 0, 0]]
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "slider.toml"
    path.write_text(TEXT)
    return path


def test_a_file_is_not_overwritten(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["convert", str(file), "--out", str(file)]) == 2
    assert "exists and is left as it is" in capsys.readouterr().err
    assert file.read_text() == TEXT and list(file.parent.iterdir()) == [file]
    assert main(["convert", str(file), "--out", str(file), "--replace"]) == 0
    assert file.read_text() != TEXT


def test_formulas_and_numbers_are_written_as_they_were_given(file: Path) -> None:
    once, twice = file.with_name("once.toml"), file.with_name("twice.toml")
    assert main(["convert", str(file), "--out", str(once)]) == 0
    written = once.read_text()
    for kept in ("value = 0.45\n", 'value = "(rail - 0.05) / 2"', 'com = ["half*sqrt(1/3)", "rail * 1", 0]', "1.20"):
        assert kept in written
    assert "inertia = [[0.0015, 0, 0], [0, 0.0015, 0], [0, 0, 0.002]]" in written
    assert main(["convert", str(once), "--out", str(twice)]) == 0
    assert twice.read_text() == written

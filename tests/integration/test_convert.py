"""`symscrew convert`: what a user wrote is kept."""

from __future__ import annotations

from pathlib import Path

import pytest

from symscrew.cli.parser import main
from symscrew.description import load_description

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
    assert file.read_text() != TEXT and "# by the drawing" in file.read_text()


def test_comments_stay_where_a_file_is_changed(file: Path) -> None:
    """Above the file, above sections, beside values with and without a # of their own; the mechanism is the same."""
    before = load_description(file)
    said = "# mine\n" + TEXT.replace("[joints.", "# carries\n# the block\n[joints.", 1).replace(
        "axes = [[1, 0, 0]]", "axes = [[1, 0, 0]]  # along the rail"
    )
    file.write_text(said)
    assert main(["convert", str(file), "--out", str(file), "--replace"]) == 0
    written = file.read_text()
    assert written.count("# mine\n") == 1 and "# carries\n# the block\n[joints." in written
    assert "axes = [[1, 0, 0]]  # along the rail\n" in written
    assert load_description(file) == before
    assert main(["convert", str(file), "--out", str(file), "--replace"]) == 0 and file.read_text() == written


def test_formulas_and_numbers_are_written_as_they_were_given(file: Path) -> None:
    once, twice = file.with_name("once.toml"), file.with_name("twice.toml")
    assert main(["convert", str(file), "--out", str(once)]) == 0
    written = once.read_text()
    for kept in (
        "value = 0.45  # by the drawing\n",
        'value = "(rail - 0.05) / 2"',
        'com = ["half*sqrt(1/3)", "rail * 1", 0]',
        "1.20",
    ):
        assert kept in written
    assert "inertia = [[0.0015, 0, 0], [0, 0.0015, 0], [0, 0, 0.002]]" in written
    assert main(["convert", str(once), "--out", str(twice)]) == 0
    assert twice.read_text() == written


def test_a_scene_is_not_overwritten_either(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot, scene = tmp_path / "robot.xml", tmp_path / "scene.toml"
    robot.write_text('<mujoco><worldbody><body><joint name="j"/><geom size="0.1"/></body></worldbody></mujoco>')
    scene.write_text("mine")
    for out, given, message in (("a.toml", "scene.toml", "scene.toml exists"), ("a.toml", "a.toml", "another file")):
        arguments = ["convert", str(robot), "--out", str(tmp_path / out), "--scene", str(tmp_path / given)]
        assert main(arguments) == 2 and message in capsys.readouterr().err
    assert scene.read_text() == "mine" and {p.name for p in tmp_path.iterdir()} == {"robot.xml", "scene.toml"}

"""`symscrew simulate`: files, reports, exit codes."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from support.runs import EXAMPLES

from symscrew.cli.parser import main
from symscrew.description import toml_file
from symscrew.scene.scene_file import parse_scene

SCENE = """
[scene]
mechanism = "four_bar"
duration = 0.2
rate = 50
reactions = true
[initial.rates]
A = 1
[drives]
A = "-0.1*v_A"
[[effects]]
type = "gravity"
"""


@pytest.mark.slow
def test_archive_table_and_picture(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    scene = tmp_path / "swing.toml"
    scene.write_text(SCENE)
    names = [tmp_path / n for n in ("a.npz", "b.npz", "a.csv")]
    for name, more in zip(names, ([], ["--no-cache"], []), strict=True):
        assert main(["simulate", str(scene), "--out", str(name), *more]) == 0
    text = capsys.readouterr().out
    assert "swing: completed" in text
    assert "loops open by at most" in text
    assert names[0].read_bytes() == names[1].read_bytes()
    with np.load(names[0]) as run:
        assert run["t"].tolist() == pytest.approx(np.arange(11) / 50)
        assert run["q"].shape == (11, len(run["q_labels"]))
        assert run["v"].shape == (11, len(run["v_labels"]))
        assert run["u"][:, 0] == pytest.approx(-0.1 * run["v"][:, list(run["v_labels"]).index("A")])
        assert run["reactions"].shape == (11, 6 * len(run["joint_names"]))
        assert run["closure_error"].max() < 1e-12
        assert np.abs(run["energy_balance"]).max() < 1e-8 * run["energy"][:, 0].max()
        assert str(run["status"]) == "completed"
        assert toml_file.parse_description(str(run["mechanism"])).name == "four_bar"
        assert parse_scene(str(run["scene"])).duration == 0.2
        q = run["q"]
    table = np.genfromtxt(names[2], delimiter=",", names=True)
    assert np.array_equal(table["t"], np.arange(11) / 50)
    assert np.array_equal(table["qA"], q[:, 0])


@pytest.mark.slow
def test_a_run_that_ends_early_is_saved_and_exits_with_1(
    tmp_path: Path, capsys: pytest.CaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a picture nothing is imported for one: Matplotlib took a third of a short run's time."""
    monkeypatch.setitem(sys.modules, "symscrew.simulation.picture", None)
    scene = tmp_path / "early.toml"
    scene.write_text(SCENE + "[integrator]\nmost_steps = 3\n")
    out = tmp_path / "early.npz"
    assert main(["simulate", str(scene), "--out", str(out), "--json"]) == 1
    numbers = json.loads(capsys.readouterr().out)
    assert numbers["ok"] is False
    assert "more steps than most_steps allows" in numbers["status"]
    with np.load(out) as run:
        assert 0 < run["t"][-1] < 0.2
        assert np.isfinite(run["q"]).all()


@pytest.mark.slow
def test_the_picture_is_drawn(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    scene = tmp_path / "swing.toml"
    scene.write_text(SCENE)
    pictures = [tmp_path / "a.png", tmp_path / "b.png"]
    for picture in pictures:
        assert main(["simulate", str(scene), "--plot", str(picture)]) == 0
    assert pictures[0].read_bytes() == pictures[1].read_bytes()
    assert pictures[0].read_bytes()[:4] == b"\x89PNG"


def test_the_loop_for_real_time_is_written(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    scene = tmp_path / "swing.toml"
    scene.write_text(SCENE + '[integrator]\nmethod = "rk4"\nstep = 1e-3\n')
    assert main(["simulate", str(scene), "--emit-c", str(tmp_path / "loop")]) == 0
    assert sorted(p.name for p in (tmp_path / "loop").iterdir()) == ["swing_loop.c", "swing_loop.h"]
    assert "int swing_step(" in (tmp_path / "loop" / "swing_loop.h").read_text()
    assert main(["simulate", str(EXAMPLES / "benchmarks" / "bricard.toml"), "--emit-c", str(tmp_path)]) == 2


def test_without_a_file_for_the_motion_its_summary_is_printed(
    tmp_path: Path, capsys: pytest.CaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("scene.toml").write_text(SCENE)
    assert main(["simulate", "scene.toml"]) == 0
    assert "largest kinetic energy" in capsys.readouterr().out
    assert [path.name for path in tmp_path.iterdir()] == ["scene.toml"]

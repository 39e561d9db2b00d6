"""`symscrew mobility`."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from support.reference_mechanisms import ENTRIES, build

from symscrew.cli.parser import main
from symscrew.description.toml_file import to_toml

SEED = "three_ups_upu_s"
SHORT = str(Path(__file__).parents[1] / "data" / "short_five_bar.toml")


@pytest.mark.slow
def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mobility", "sarrus", "--json", "--expect", "1"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert (values["dof"], values["dof_finite"], values["kutzbach"], values["overconstraints"]) == (1, 1, 0, 1)
    assert values["platform"]["type"] == "1T" and values["branches"] is None and values["verified"]
    assert main(["mobility", "sarrus", "--expect", "2"]) == 1
    assert main(["mobility", SHORT, "--body", "distal_right", "--at", "rise=0.2"]) == 0
    assert "Freedoms of distal_right" in capsys.readouterr().out
    assert main(["mobility", SEED, "--at", "r"]) == 2
    assert main(["mobility", SEED, "--out", str(tmp_path / "x.doc")]) == 2
    for name, suffix, piece in (
        (SEED, ".md", "$R - r = 0$"), ("four_bar", ".html", "<math>"), ("four_bar", ".tex", r"\begin{itemize}"),
    ):  # fmt: skip
        path = tmp_path / f"written{suffix}"
        capsys.readouterr()
        assert main(["mobility", name, "--out", str(path)]) == 0
        assert piece in path.read_text()
        if name == SEED:
            out = capsys.readouterr().out
            assert "mobility 2" in out
            assert "(0, 1, 0; 0, 0, 0.4)" in out  # (13) at theta = 30 degrees, sign and scale aside
            assert "rotation about x through O" in out and "rotation about y through O" in out


def test_the_proof_file_of_a_command_is_judged_by_its_checker(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from symscrew.mobility.proofs import proof_checker

    path = tmp_path / "proof.json"
    assert main(["mobility", "four_bar", "--proof", str(path)]) == 0
    assert f"{path}: " in capsys.readouterr().err
    assert proof_checker.main([str(path)]) == 0
    assert "proved: finite mobility 1" in capsys.readouterr().out
    assert main(["mobility", "four_bar", "--proof", str(tmp_path / "no" / "proof.json")]) == 2
    assert "--proof" in capsys.readouterr().err


@pytest.mark.slow
def test_a_displaced_configuration_is_not_proved(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "proof.json"
    assert main(["mobility", "four_bar", "--at", "A=0.2", "--proof", str(path)]) == 0
    values = json.loads(path.read_text())
    assert all(entry["claim"].startswith("displaced") for entry in values["not proved"]) and values["not proved"]


def test_linear_algebra_runs_on_one_thread_unless_the_user_says_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MKL_NUM_THREADS", "3")
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    main(["mobility", "four_bar"])
    assert (os.environ["OPENBLAS_NUM_THREADS"], os.environ["MKL_NUM_THREADS"]) == ("1", "3")


def test_poses_of_screw_joints_are_not_told_apart_by_polynomials(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A smooth curve through the reference is one, whose poses satisfied other quadrics from each random start."""
    path = tmp_path / "screws.toml"
    path.write_text(to_toml(build(ENTRIES["delassus_4h"])), encoding="utf-8")
    assert main(["mobility", str(path), "--components", "--no-cache"]) == 0
    said = capsys.readouterr().out
    assert "a smooth point has one branch" in said and "operation modes not told apart" in said
    assert "the screw joint J1 is not algebraic" in said and "through the reference" not in said

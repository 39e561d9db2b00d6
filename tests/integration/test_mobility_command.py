"""`symscrew mobility`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from symscrew.cli.parser import main

SEED = "three_ups_upu_s"


@pytest.mark.slow
def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mobility", "sarrus", "--json", "--expect", "1"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert (values["dof"], values["dof_finite"], values["kutzbach"], values["overconstraints"]) == (1, 1, 0, 1)
    assert values["platform"]["type"] == "1T" and values["branches"] is None and values["verified"]
    assert main(["mobility", "sarrus", "--expect", "2"]) == 1
    assert main(["mobility", SEED, "--body", "limb1_lower", "--at", "r=0.45"]) == 0
    assert "Freedoms of limb1_lower" in capsys.readouterr().out
    assert main(["mobility", SEED, "--at", "r"]) == 2
    assert main(["mobility", SEED, "--out", str(tmp_path / "x.doc")]) == 2
    for name, suffix, piece in (
        (SEED, ".md", "$R - r = 0$"), ("sarrus", ".html", "<math>"), ("sarrus", ".tex", r"\begin{itemize}"),
    ):  # fmt: skip
        path = tmp_path / f"written{suffix}"
        assert main(["mobility", name, "--out", str(path)]) == 0
        assert piece in path.read_text()


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

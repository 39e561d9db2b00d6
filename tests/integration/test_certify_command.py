"""`symscrew workspace --certify`: what it writes, says and returns."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.studies.certificate import certify, check_certificate
from symscrew.studies.certificate.certificate_checker import main as check_file
from symscrew.studies.workspace import Axis, Plan

pytestmark = pytest.mark.slow

SHORT = str(Path(__file__).parents[1] / "data" / "short_five_bar.toml")


def test_a_proof_is_written_read_again_and_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["workspace", "five_bar", "--certify", "--over", "base_left=-20deg:0deg:5", "base_right=-20deg:20deg:9"]
    limit = ["--limit", "point tool.x=-60mm:60mm", "elbow_left=-60deg:"]
    assert main([*command, *limit, "--json", "--out", str(tmp_path / "proof")]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found == json.loads((tmp_path / "proof" / "summary.json").read_text())
    assert found["proved"] and found["boxes"] > 4 and 0.4 < found["share"] < 1
    assert sum(found["shares"].values()) == pytest.approx(1)
    assert found["shares"]["outside the limits"] > 0
    assert found["smallest"]["base_right"] == pytest.approx(np.radians(40) / 8)
    assert found["smallest"]["base_left"] == pytest.approx(np.radians(20) / 4)
    assert found["limits"]["elbow_left"] == [pytest.approx(-np.pi / 3), None]
    assert (tmp_path / "proof" / "certificate.png").read_bytes()[1:4] == b"PNG"
    file = tmp_path / "proof" / "certificate.json"
    assert check_file([str(file)]) == 0
    assert "every claim of the file is proved" in capsys.readouterr().out
    verdict = check_certificate(json.loads(file.read_text()))
    assert verdict.facts["boxes"] == found["boxes"]
    assert main([*command, "--out", str(tmp_path / "proof")]) == 2
    assert "is not empty" in capsys.readouterr().err


def test_nothing_proved_is_a_failure(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Boxes as wide as the region, which is too wide for one: no file, and exit code 1."""
    over = ["base_left=-100deg:100deg:2", "base_right=-100deg:100deg:2"]
    assert main(["workspace", "five_bar", "--certify", "--over", *over, "--out", str(tmp_path / "a.json")]) == 1
    said = capsys.readouterr()
    assert "nothing is proved" in said.out and "no file is written" in said.err
    assert not (tmp_path / "a.json").exists()


def test_a_singular_reference_is_not_left_out() -> None:
    """The wrist of the UR5 is stretched in its zero pose, whatever the elbow does; bent a little it is not."""
    elbow = Axis("elbow_joint", 0.5, 0.7, 3)
    found = certify(Plan(catalogue.load("ur5"), (), (elbow,)))
    assert not found.ok and found.summary["undecided"].keys() == {"limb arm"} and not found.summary["left_out"]
    bent = certify(Plan(catalogue.load("ur5"), (), (elbow, Axis("wrist_2_joint", 0.4, 0.5, 2))))
    assert bent.ok and bent.summary["whole"] and bent.summary["least_margins"]["limb arm"]["at_least"] > 0
    assert any("drives" in text for text in bent.summary["assumed"])


@pytest.mark.slow
def test_six_legs_over_three_of_six_coordinates() -> None:
    """Most dependent coordinates do not change to second order: tubes as thin as rounding are joined, too."""
    axes = tuple(Axis(f"platform_pose.{k}", x - 0.01, x + 0.01, 3) for k, x in enumerate((0, 0, 1)))
    found = certify(Plan(catalogue.load("stewart_6ups"), (), axes))
    assert found.ok and found.summary["whole"] and found.summary["fixed"] == {}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--over", "base_left=0:1", "--tolerance", "reach=1mm"], "no parameter 'reach'"),
        (["--over", "base_left=0:1", "--dask", "tcp://x:1"], "leave out --dask"),
        (["--over", "base_left=0:1", "--limit", "condition=:20"], "no bounds are known of 'condition'"),
        (["--over", "base_left=0:1", "--limit", "conditon=:20"], "no result 'conditon'"),
        (["--over", "base_left=0:0:1"], "nothing to certify"),
        (["--over", "elbow=0:1"], "neither a coordinate nor a parameter"),
        (["--over", "base_left=0:1", "--expect-tilt", "1deg"], "needs the axes tilt and azimuth"),
        (["--over", "base_left=1m:2m"], "is an angle"),
        (["--over", "elbow_left=0:1"], "over independent coordinates (base_left, base_right)"),
        (["--over", "base_left=-20deg:0deg:5", "--mode=-1"], "certificates begin in the reference configuration"),
        (["--over", "base_left=-20deg:0deg:5", "--engine", "c"], "--engine: certificates"),
        ([], "nothing to sweep"),
    ],
)  # fmt: skip
def test_what_cannot_be_certified_is_said(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["workspace", "five_bar", "--certify", *arguments, "--out", str(tmp_path / "a.json")]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert not list(tmp_path.iterdir())


def test_a_sweep_still_wants_its_counts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["workspace", "five_bar", "--over", "base_left=0:1", "--out", str(tmp_path / "a.csv")]) == 2
    assert "from:to:count" in capsys.readouterr().err


@pytest.mark.slow
def test_a_region_that_no_walk_reaches_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    over = ["--over", "base_left=-65deg:-55deg", "base_right=55deg:65deg"]
    assert main(["workspace", SHORT, "--certify", *over, "--out", str(tmp_path / "a.json")]) == 2
    assert "no configuration was found at" in capsys.readouterr().err


@pytest.mark.slow
def test_a_parameter_is_an_edge_like_any_other() -> None:
    """A five-bar with a height between two: proved for every height, so for each of them alone."""
    mechanism = catalogue.find(SHORT, run_time=("rise",))
    axes = (Axis("base_left", -0.05, 0.05, 3), Axis("rise", 0.17, 0.19, 3))
    found = certify(Plan(mechanism, (), axes, parameters=("rise",)))
    assert found.ok and found.summary["whole"]
    one = certify(Plan(mechanism, (), (axes[0], Axis("rise", 0.18, 0.18, 1)), parameters=("rise",)))
    assert one.summary["whole"] and one.summary["fixed"] == {"rise": 0.18}
    with pytest.raises(DescriptionError, match="no tolerances"):
        certify(Plan(mechanism, (), axes, tolerances=(("rise", 1e-3),), parameters=("rise",)))


def test_a_plan_in_another_mode_is_no_proof_of_the_reference_in_silence() -> None:
    with pytest.raises(DescriptionError, match="begin in the reference configuration"):
        certify(Plan(catalogue.load("five_bar"), (), (Axis("base_left", -0.1, 0.1, 3),), mode="-1"))


def test_no_tilt_is_proved_where_nothing_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It ended in a KeyError."""
    over = ["tilt=0:1deg:3", "azimuth=0:360deg", "--limit", "limb1_P=5:6", "--expect-tilt", "0deg"]
    assert main(["workspace", "three_ups_upu_s", "--certify", "--over", *over, "--out", str(tmp_path / "a.json")]) == 1
    assert "nothing is proved" in capsys.readouterr().out

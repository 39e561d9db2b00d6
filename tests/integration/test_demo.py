"""The demo computes what it says: both methods agree, the statics by hand, figures that are not blank."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest

from symscrew.cli.parser import main
from symscrew.studies import demo
from symscrew.studies.demo import paper_figures
from symscrew.studies.demo.paper_motion import SECTION_5, CircularTilt, Scene
from symscrew.studies.demo.paper_study import Demo, study_paper
from symscrew.studies.platform_motion import integrate

SHORT = Scene(CircularTilt(), 1.0, 200, "E", SECTION_5.load)


@cache
def short() -> Demo:
    return study_paper(scene=SHORT, backend="casadi")


@pytest.mark.slow
def test_drives_at_rest_are_those_by_hand() -> None:
    by_hand = 1000 / (2 * 0.8 * np.cos(np.radians(30)))
    assert np.abs(short().statics.drives - [0, by_hand, 0, -by_hand]).max() < 1e-9
    assert re.search(r"\(0\.000, 721\.688, 0\.000, -721\.688\) N", paper_figures.demo_facts(short()))


def test_both_methods_agree() -> None:
    for case in short().cases:
        assert case.drive_difference <= 1e-9 and case.reaction_difference <= 1e-9
    assert paper_figures.verdict(short()).startswith("Momentum screws and Newton-Euler agree")


def test_motion_is_consistent() -> None:
    case = short().cases[0]
    motion, wanted = case.motion, SHORT.motion
    assert np.abs(np.asarray(case.functions.closure(motion.q))).max() < 1e-13
    assert np.abs(motion.twist[:, :2] - wanted.rate(motion.t)).max() < 1e-14
    assert np.abs(motion.twist[:, 3:]).max() < 1e-14  # the platform turns about O
    step = motion.t[1] - motion.t[0]
    second = (motion.v[2:] - motion.v[:-2]) / (2 * step)
    assert np.abs(second - motion.a[1:-1]).max() < 1e-5
    # q follows v: rates of the sliders against differences of their lengths
    assert np.abs((motion.q[2:, 2] - motion.q[:-2, 2]) / (2 * step) - motion.v[1:-1, 2]).max() < 1e-6


@pytest.mark.slow
def test_integration_is_of_order_four() -> None:
    case = short().cases[0]

    def last(steps: int) -> np.ndarray:
        time = Scene(CircularTilt(), 1.0, steps, "E", SECTION_5.load).time
        return integrate(case.model, case.functions, CircularTilt(), time).q[-1]

    exact, coarse, fine = case.motion.q[-1], last(10), last(20)
    order = np.log2(np.abs(coarse - exact).max() / np.abs(fine - exact).max())
    assert 3.5 < order < 5.5


def test_spin_follows_from_the_constraint() -> None:
    demo = short()
    omega_z = np.abs(demo.cases[0].motion.twist[:, 2]).max()
    assert demo.assumption.shape == (30, 26)
    assert demo.assumption.exact_residual < 1e-14
    assert demo.assumption.residual.max() > 0.1 * omega_z > 1e-4


@pytest.mark.slow
def test_whole_demo_with_figures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """All of the motion of section 5, in steps of 10 ms: they change no figure that is looked at here."""
    from matplotlib import image

    assert (SECTION_5.steps, SECTION_5.duration) == (10_000, 10.0)
    with pytest.MonkeyPatch.context() as changed:  # models that other tests have derived serve
        changed.setattr(demo, "study_paper", partial(study_paper, scene=replace(SECTION_5, steps=1000)))
        assert main(["demo", "--out", str(tmp_path / "demo")]) == 0
    printed = capsys.readouterr().out
    assert "Motion of section 5: 1000 steps" in printed
    pictures = list((tmp_path / "demo").glob("*.png"))
    assert len(pictures) == 9
    for path in pictures:
        pixels = image.imread(path)[..., :3]
        assert pixels.std() > 0.04 and min(pixels.shape[:2]) > 400, path.name
    values = json.loads((tmp_path / "demo/summary.json").read_text())
    assert values["agrees"] and values["mobility"] == 2
    assert values["largest_omega_z"] == pytest.approx(0.020271, abs=1e-6)
    assert "| quantity" in (tmp_path / "demo/summary.md").read_text()
    # nearly periodic: a few milliradians off after a period
    assert re.search(r"platform is [23]\.\d+ mrad off", printed)


def test_numbers_of_the_seed_stand_in_its_description_only() -> None:
    """Masses, inertias and lengths of the paper must not be typed into the package's code."""
    package = Path(paper_figures.__file__).parent.parent
    for path in package.rglob("*.py"):
        text = path.read_text()
        for number in ("1.42", "2.87", "68.7", "92.1", "0.0556", "721.6"):
            assert not re.search(rf"(?<![\d.]){re.escape(number)}(?!\d)", text), (path.name, number)

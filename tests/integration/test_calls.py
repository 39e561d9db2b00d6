"""What commands do, as calls: configurations, sweeps, pictures and pages by name, and what they say to bad names."""

from __future__ import annotations

import html
import re
from pathlib import Path

import numpy as np
import pytest
from support.model_states import model

import symscrew
from symscrew import notebook
from symscrew.display import Page, Picture
from symscrew.display.shown import recorded
from symscrew.errors import DescriptionError, KindError
from symscrew.results import AssembledConfiguration, assemble

pytestmark = pytest.mark.slow


def test_a_configuration_by_hand() -> None:
    """A crank of 0.15 m and a rod of 0.37 m: where the slider is, by Pythagoras."""
    crank, turn = model("slider_crank"), 0.4
    found = assemble(crank, {"crank_R": turn})
    assert found.ok and found.status == "success" and found["crank_R"] == pytest.approx(turn, abs=1e-12)
    pin = np.array([0.09 * np.cos(turn) + 0.12 * np.sin(turn), -0.09 * np.sin(turn) + 0.12 * np.cos(turn)])  # x, z
    slider = pin[0] + np.sqrt(0.37**2 - pin[1] ** 2)
    points = dict(zip(crank.mechanism.joints, crank("joint_points", found.q)[0][0].reshape(-1, 3), strict=True))
    np.testing.assert_allclose(points["rod_R"], (pin[0], 0, pin[1]), atol=1e-12)
    np.testing.assert_allclose(points["slider_R"], (slider, 0, 0), atol=1e-12)


def test_coordinates_that_are_not_there_or_do_not_close() -> None:
    four_bar = model("four_bar")
    with pytest.raises(DescriptionError, match="one of the independent coordinates A beside a guess"):
        assemble(four_bar, {"B": 0.1}, guess=four_bar.system.reference)
    with pytest.raises(DescriptionError, match="known: "):
        assemble(four_bar, {"limb": 0.1})
    with pytest.raises(ValueError, match="shape"):
        assemble(four_bar, {"A": 0.1}, guess=[0.0])
    assert assemble(four_bar, {"A": "20deg"})["A"] == pytest.approx(np.radians(20), rel=1e-15)
    for wrong, said in (("20mm", "expected an angle"), ("twenty", "unknown name")):
        with pytest.raises(DescriptionError, match=f"A: .*{said}"):
            assemble(four_bar, {"A": wrong})
    with pytest.raises(KindError, match=r"y\['A'\]: expected a number or a text, got nan"):
        assemble(four_bar, {"A": np.nan})
    with pytest.raises(DescriptionError, match="label of a coordinate"):
        assemble(four_bar, {"A": 0.1})["limb"]


def test_coordinates_of_any_kind_give_the_others() -> None:
    """A joint that follows, the platform's pose; what cannot be reached is a status."""
    four_bar = model("four_bar")
    turned = assemble(four_bar, {"A": 0.3})
    again = assemble(four_bar, {"D": turned["D"]})
    assert again.ok and again.status == "success"
    np.testing.assert_allclose(again.q, turned.q, atol=1e-9)
    np.testing.assert_allclose(four_bar("closure", again.q)[0][0], 0.0, atol=1e-12)
    delta = model("delta")
    lowered = assemble(delta, {"platform.z": "-20mm"})
    height = lowered["platform_pose.2"] - delta.system.reference[list(lowered.labels).index("platform_pose.2")]
    assert lowered.ok and height == pytest.approx(-0.02, abs=1e-12)
    np.testing.assert_allclose(delta("closure", lowered.q)[0][0], 0.0, atol=1e-12)
    far, turned = assemble(delta, {"platform.z": "-5"}), assemble(delta, {"platform.tilt": "5deg"})
    assert (far.code, turned.code) == (11, 6) and not far.ok and np.isnan(turned.q).all()
    assert "out of reach" in far.status and "stays the same" in turned.status


def test_an_open_chain_has_nothing_to_close() -> None:
    arm = model("ur5")
    label = arm.system.tree.q[1].label
    found = assemble(arm, {label: -0.7})
    assert isinstance(found, AssembledConfiguration) and found.ok and found[label] == -0.7


@pytest.mark.slow  # compiles
def test_a_sweep_is_of_configurations() -> None:
    four_bar = model("four_bar").mechanism
    swept = symscrew.workspace(four_bar, {"A": "-20deg:20deg:3"}, processes=1)
    angles = np.radians([-20, 0, 20])
    expected = [assemble(model("four_bar"), {"A": angle})["D"] for angle in angles]
    np.testing.assert_allclose(swept["D"], expected, atol=1e-9)
    assert swept.summary["reached"] == 3 and "3 reached" in repr(swept)
    assert "3 are reached straight" in swept._repr_html_()
    with pytest.raises(DescriptionError, match="name of a result"):
        swept["E"]
    with pytest.raises(DescriptionError):
        symscrew.workspace(four_bar, {"nothing": "0:1:2"}, processes=1)


def test_pictures(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    picture = symscrew.draw(model("four_bar").mechanism)
    assert isinstance(picture, Picture) and "inches" in repr(picture)
    assert picture._repr_png_().startswith(b"\x89PNG")
    assert picture.save(tmp_path / "a.svg").read_bytes() == picture.save(tmp_path / "b.svg").read_bytes()
    with pytest.raises(DescriptionError, match=r"\.png, \.pdf, \.svg"):
        picture.save(tmp_path / "a.jpg")


def test_pages_stand_in_a_frame_that_reaches_nothing(tmp_path: Path) -> None:
    page = Page(model("four_bar"))
    shown = page._repr_html_()
    inside = re.search(r'srcdoc="([^"]*)"', shown)
    assert inside and html.unescape(inside[1]) == page.text == page.save(tmp_path / "page.html").read_text()
    assert 'sandbox="allow-scripts allow-downloads"' in shown and "same-origin" not in shown
    hostile = notebook.framed("<p>", '"><script>alert(1)</script>')
    assert "<script>" not in hostile


def test_a_motion_belongs_to_its_model() -> None:
    four_bar = model("four_bar")

    class Moved:
        model = four_bar
        t = np.array([0.0, 1.0])
        q = np.repeat(four_bar.system.reference[None], 2, 0)
        v = np.zeros_like(q)
        u = np.zeros((2, 1))
        reactions = np.zeros((2, 24))

    motion = recorded(Moved)
    motion.check(four_bar)
    assert motion.u_labels == ("A",) and "2 states" in repr(Page(four_bar, motion))
    with pytest.raises(DescriptionError, match="record the motion again"):
        motion.check(model("slider_crank"))

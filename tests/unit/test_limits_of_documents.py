"""Limits of pictures and pages, on both sides: what does not fit is left out, and the picture or its text says so."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from matplotlib.figure import Figure

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.display.shape import FLAT, body_points, plate
from symscrew.display.view.motion_file import RecordedMotion
from symscrew.effects import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.reporting import margin_maps, sections
from symscrew.reporting.blocks import Document, Picture, Section
from symscrew.studies.accuracy import study_plots
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.accuracy.study_tables import front
from symscrew.studies.benchmark import function_times, timed_code
from symscrew.studies.bill_of_effects import Bill, Item
from symscrew.studies.platform_motion import Motion
from symscrew.studies.timing import quartiles
from symscrew.studies.workspace import maps
from symscrew.studies.workspace.plan import Axis, Plan


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Figures of sweeps, caught before they are written."""
    found: list[Figure] = []
    monkeypatch.setattr(maps, "save_figure", lambda made, path: found.append(made) or path)
    return found


@pytest.mark.parametrize(("most", "frames", "text"), [(2, 2, None), (1, 1, "not drawn, but in the files: drive A")])
def test_a_sweep_with_more_results_than_frames_names_them(
    most: int, frames: int, text: str | None, drawn: list[Figure], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(maps, "MOST", most)
    plan = Plan(catalogue.load("four_bar"), (), (Axis("D", 0.0, 1.0, 5),))
    line = np.linspace(0.0, 1.0, 5)
    constant = np.ones(5) + 0.5 * maps.VANISHING * line
    results = {"D": line, "allowed": np.ones(5), "margin": line, "condition": constant, "drive A": 1 + line}
    maps.draw_maps(plan, results, {}, Path("unused.png"))
    (made,) = drawn
    assert len([axes for axes in made.axes if axes.get_visible()]) == frames
    assert (made._suptitle.get_text() if made._suptitle else None) == text  # type: ignore[attr-defined]


@pytest.mark.parametrize(("most", "said"), [(6, False), (0, True)])
def test_margins_of_more_coordinates_than_frames_are_named(
    most: int, said: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(margin_maps, "MOST", most)
    monkeypatch.setattr(margin_maps, "figure", lambda model, call: Figure())
    monkeypatch.setattr(sections, "svg", lambda figure: b"")
    model = derive(catalogue.load("four_bar"))
    made = sections._singularities(model, sections.analyse_mobility(model.mechanism), lambda *_: ((), np.zeros(0)))
    (picture,) = [block for block in made if isinstance(block, Picture)]
    label = model.programs["assemble"].inputs[0].labels[0]
    assert picture.caption.endswith(f" Not drawn: {label}.") == said


@pytest.mark.parametrize(("limit", "symbols"), [(10_000, True), (0, False)])
def test_a_long_screw_is_given_in_numbers(limit: int, symbols: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sections, "LONG_SCREW", limit)
    mechanism = catalogue.load("three_ups_upu_s")
    parameter = next(iter(mechanism.parameters.values()))
    latex, _ = sections._screw(sympy.Matrix([0, 0, 1, sympy.Symbol(parameter.name, real=True), 0, 0]), mechanism)
    assert (parameter.name in latex) == symbols


def peers(count: int) -> Study:
    """Points of settings of one engine, each a curve of its own, the fastest last."""
    points = tuple(
        Point(f"exudyn {k}", "h", 1e-3, quartiles([1.0 - 0.01 * k]), "", {"peer": True, "family": "peers"})
        for k in range(count)
    )
    labels = {"error_label": "error", "cost_label": "time", "cost_unit": "ms", "reference": "none"}
    return Study("forward", "Peers", points, **labels, reference_error=None)  # type: ignore[arg-type]


def test_more_curves_than_colours_become_the_best_of_their_engine() -> None:
    some, many = (study_plots._of_panel(peers(study_plots.MOST_CURVES + k), "") for k in (0, 1))
    assert len(some) == study_plots.MOST_CURVES and "Exudyn: 0" in some
    assert list(many) == ["Exudyn: best of all settings"]
    (best,) = many["Exudyn: best of all settings"]
    assert best.cost is not None and best.cost.median == pytest.approx(1.0 - 0.01 * study_plots.MOST_CURVES)


def test_times_that_differ_as_little_as_repeats_are_one() -> None:
    def point(error: float, time: float) -> Point:
        return Point("a", f"{error}", error, quartiles([time]))

    coarse = point(1e-3, 1.0)
    assert front([coarse, point(1e-6, 1.04)]) == [point(1e-6, 1.04)]
    assert front([coarse, point(1e-6, 1.06)]) == [coarse, point(1e-6, 1.06)]


def test_a_function_with_more_arrays_than_the_loops_pass_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(function_times, "MOST_ARRAYS", 3)

    class Compiled:
        model = derive(catalogue.load("four_bar"))

    with pytest.raises(DescriptionError, match="inverse_dynamics: expected at most 3 arrays to be timed, got 4"):
        function_times.single(Compiled(), "inverse_dynamics")  # type: ignore[arg-type]
    assert timed_code.MOST_ARRAYS == 8


def test_points_nearer_than_the_limit_are_one_and_flat_triangles_span_no_plate() -> None:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    assert plate(points) is not None
    assert plate(points * [1, 1e-7, 1]) is None
    assert all(
        np.linalg.norm(a - b) > FLAT
        for places in body_points(catalogue.load("delta")).values()
        for k, a in enumerate(places)
        for b in places[:k]
    )


@pytest.mark.parametrize(("samples", "code"), [("0", 2), ("1000001", 2)])
def test_numbers_of_samples_have_limits(samples: str, code: int, capsys: Any, tmp_path: Path) -> None:
    command = ["workspace", "three_ups_upu_s", "--tolerance", "R=1mm", "--out", str(tmp_path / "a.csv")]
    assert main([*command, "--samples", samples]) == code
    assert f"expected a number from 1 to 1000000, got {samples}" in capsys.readouterr().err


def test_what_users_meet_shows_itself_in_a_line() -> None:
    bill = Bill("fall", "ur5", "samples", (Item("gravity", {}, 0, {}, {}),), {"forward_dynamics": 7}, {})
    assert repr(bill) == "Bill(fall: 1 effects on ur5, forward_dynamics 7 operations)"
    assert repr(peers(2)) == "Study(forward: 2 points on 2 curves, 0 failed)"
    plan = Plan(catalogue.load("ur5"), (), (Axis("elbow", 0.0, 1.0, 5),), samples=2)
    assert repr(plan) == "Plan(ur5: 10 cases over elbow)"
    t, many = np.array([0.0, 0.5, 2.0]), np.zeros((3, 2))
    recorded = RecordedMotion(plan.mechanism, t, many, many, None, None, (), ())
    assert repr(recorded) == "RecordedMotion(ur5: 3 states from 0 s to 2 s)"
    assert repr(Motion(t, many, many, many, many, 1e-15, 0.0)) == "Motion(3 states to 2 s, loops open by 1.0e-15)"
    assert repr(Document("Mechanism a", "", (Section("Overview", ()),))) == "Document(Mechanism a: 1 section)"


def test_a_plan_is_known_by_every_number_of_its_effects() -> None:
    plans = [Plan(catalogue.load("ur5"), (Gravity((0, 0, g)),), ()) for g in ("-9.81", "-9.81", "-9.82")]
    assert plans[0].hash == plans[1].hash != plans[2].hash

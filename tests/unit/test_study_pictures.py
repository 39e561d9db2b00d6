"""Pictures of studies: names that cover none another, lines that end where time buys nothing, one recommended point."""

from __future__ import annotations

import numpy as np
import pytest

from symscrew.display.end_labels import levels_apart
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.accuracy.study_plots import MOST_NAMED, frames_of, work_precision
from symscrew.studies.timing import quartiles

LABELS = {"error_label": "error", "cost_label": "time", "cost_unit": "ms", "reference": "exact"}


def study(*points: tuple[str, float, float], own: float | None = None, panel: str = "") -> Study:
    made = [
        Point(name, f"n = {k}", error, quartiles([1e-3 * cost]), "", {"panel": panel} if panel else {})
        for k, (name, error, cost) in enumerate(points)
    ]
    return Study("forward", "A study", tuple(made), **LABELS, reference_error=own)  # type: ignore[arg-type]


@pytest.mark.parametrize("seed", range(8))
def test_names_stay_in_order_and_do_not_cover_each_other(seed: int) -> None:
    random = np.random.default_rng(seed)
    heights = random.uniform(0.02, 0.12, 8)
    wanted = np.sort(random.uniform(-0.1, 1.1, 8))[::-1]
    found = np.array(levels_apart(wanted, heights))
    assert ((found[:-1] - found[1:]) > (heights[:-1] + heights[1:]) / 2 - 1e-9).all()
    assert found[0] + heights[0] / 2 < 1 + 1e-9 and found[-1] - heights[-1] / 2 > -1e-9


def test_names_that_are_apart_stay_where_they_are() -> None:
    assert levels_apart([0.9, 0.5, 0.1], [0.1, 0.1, 0.1]) == [0.9, 0.5, 0.1]


def test_a_line_ends_where_time_buys_nothing() -> None:
    (frame,) = frames_of(study(("a", 1e-2, 1), ("a", 1e-6, 2), ("a", 1e-5, 3), ("a", 0.99e-6, 9)))
    assert [mark.x for mark in frame.methods[0].marks] == [1, 2]
    (frame,) = frames_of(study(("a", 1e-2, 1), ("a", 1e-6, 2), ("a", 1e-8, 9), own=1e-6))
    assert [mark.x for mark in frame.methods[0].marks] == [1, 2]  # beyond the reference's own error nothing is known


@pytest.mark.parametrize(("slow", "best"), [(1.9, 1e-7), (2.1, 1e-6)])
def test_a_decade_of_error_is_worth_twice_the_time(slow: float, best: float) -> None:
    (frame,) = frames_of(study(("a", 1e-6, 1.0), ("b", 1e-7, slow)))
    chosen = frame.recommended(0.0)
    assert chosen is not None and chosen[1].error == best


def test_the_picture_names_every_line_and_its_recommendation() -> None:
    figure = work_precision(study(("slow one", 1e-3, 9.0), ("fast one", 1e-9, 1.0), ("fast one", 1e-3, 0.5)))
    (axes,) = figure.axes
    assert {text.get_text().split("\n")[0] for text in axes.texts} == {"slow one", "fast one"}
    assert axes.get_title(loc="left") == "recommended (ring): fast one, n = 1: error 1e-09, 1 ms"
    assert axes.get_legend() is None and not figure.legends


def test_of_many_methods_the_best_are_named() -> None:
    many = [(f"m{k}", 1e-6, 1.0 + k) for k in range(MOST_NAMED + 3)]
    (axes,) = work_precision(study(*reversed(many))).axes
    assert {text.get_text().split("\n")[0] for text in axes.texts} == {f"m{k}" for k in range(MOST_NAMED)}
    assert axes.get_xlabel().endswith("grey: 3 more, in the table")


def test_panels_that_show_nothing_are_left_out() -> None:
    shown = study(("a", 1e-3, 1.0), panel="one").points
    failed = Point("b", "n", None, None, "failed", {"panel": "two"})
    both = Study("claims", "Two", (*shown, failed), **LABELS, reference_error=None)  # type: ignore[arg-type]
    assert [frame.title for frame in frames_of(both)] == ["one"] and len(work_precision(both).axes) == 1

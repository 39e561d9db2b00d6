"""Thresholds of the compiled run: what happens on either side, and what the run says of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow
from support.runs import compiled, error_of, run_of, scene_of

from symscrew.runtime.compiled import find_compiler
from symscrew.simulation import native, run_source

pytestmark = [
    pytest.mark.slow,
    pytest.mark.short_runs,
    pytest.mark.skipif(find_compiler() is None, reason="needs a C compiler"),
]


def test_crossings_beyond_the_most_are_not_recorded_but_told(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scene_of("n_four_bar")
    usual = run_of("n_four_bar", scene)
    assert len(usual.crossings) == 10 and not any("recorded" in text for text in usual.events)
    monkeypatch.setattr(native, "MOST_CROSSINGS", 3)
    short = run_of("n_four_bar", scene)
    assert short.ok and [c.t for c in short.crossings] == [c.t for c in usual.crossings[:3]]
    assert "3 singular configurations are recorded; later ones are not" in short.events
    assert (short.q == usual.q).all()  # the run itself goes on


def test_local_errors_are_a_part_of_the_error_aimed_at(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scene_of("heavy_top", until=1.0, tolerance=1e-6)
    usual = error_of("heavy_top", run_of("heavy_top", scene))
    monkeypatch.setattr(native, "LOCAL", 1.0)
    assert usual < 1e-6 and error_of("heavy_top", run_of("heavy_top", scene)) > 10 * usual


def test_tolerances_are_not_below_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scene_of("heavy_top", until=0.2, tolerance=1e-13)
    steps = run_of("heavy_top", scene).counters["steps"]
    monkeypatch.setattr(native, "LEAST", 1e-8)
    assert run_of("heavy_top", scene).counters["steps"] < steps / 2


@pytest.mark.slow
def test_a_run_that_stops_near_a_singularity_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    _, plant, _ = compiled("n_four_bar")
    monkeypatch.setitem(run_source.PIVOTS, "ZONE", 0.0)
    monkeypatch.setitem(run_source.PIVOTS, "CAREFUL", 0.0)
    monkeypatch.setattr(native.Library, "_offer_precision", lambda self: None)  # a step that is repeated finds its way
    careless = native.Library(plant, native.table_code([]))
    scene = scene_of("n_four_bar", tolerance=1e-10, most_steps=20_000)
    near = run_of("n_four_bar", scene, careless)
    assert not near.ok and "near-singular there" in near.status
    monkeypatch.setattr(native, "NEAR_SINGULAR", 0.0)
    assert "near-singular" not in run_of("n_four_bar", scene, careless).status


def test_what_counts_as_a_crossing(monkeypatch: pytest.MonkeyPatch) -> None:
    _, plant, _ = compiled("n_four_bar")
    monkeypatch.setitem(run_source.PIVOTS, "LOOK", 0.0)
    blind = native.Library(plant, native.table_code([]))
    scene = scene_of("n_four_bar")
    run = run_of("n_four_bar", scene, blind)
    assert run.ok and run.crossings == () and error_of("n_four_bar", run) < 1e-6


@pytest.mark.parametrize("name, value", [("STRIDE", 0.02), slow("REACH", 0.2)])
def test_distances_of_careful_steps_change_the_way_and_not_the_motion(
    name: str, value: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, plant, _ = compiled("n_four_bar")
    scene = scene_of("n_four_bar")
    usual = run_of("n_four_bar", scene)
    monkeypatch.setitem(run_source.THRESHOLDS, name, value)
    other = run_of("n_four_bar", scene, native.Library(plant, native.table_code([])))
    assert other.ok and len(other.crossings) == 10 and error_of("n_four_bar", other) < 1e-6
    assert other.counters != usual.counters


def test_places_too_close_together_do_not_bridge_a_singularity(monkeypatch: pytest.MonkeyPatch) -> None:
    _, plant, _ = compiled("n_four_bar")
    monkeypatch.setitem(run_source.THRESHOLDS, "SPACING", 0.002)
    run = run_of("n_four_bar", scene_of("n_four_bar"), native.Library(plant, native.table_code([])))
    assert not run.ok and "the step had to become too small" in run.status


def test_a_step_that_needs_many_corrections_is_repeated(monkeypatch: pytest.MonkeyPatch) -> None:
    """Coarse steps leave loops so far open that two corrections are too few: shorter ones take their place."""
    _, plant, _ = compiled("bricard")
    scene = scene_of("bricard", tolerance=1e-2)
    scene = replace(scene, rate=1 / scene.duration)
    usual = run_of("bricard", scene)
    monkeypatch.setattr(run_source, "MOST_CORRECTIONS", 2)
    run = run_of("bricard", scene, native.Library(plant, native.table_code([])))
    assert run.ok and np.abs(run.q[-1] - usual.q[-1]).max() < 1e-4
    assert run.counters["steps"] > usual.counters["steps"]

"""Asking for more never gives less: errors against tolerances and steps, over all benchmark problems and hard cases.

A tighter tolerance, or half a step, makes no result worse by more than a factor of two above what rounding leaves: the
spread of runs whose starts differ by one unit in the last place, or one such unit per step grown as the motion's errors
grow. What rounding leaves is small itself. What failed without: loops that are closed to a fixed 1e-14 are off by as
much, always to the same side; times that add up a rounded step; accelerations that lose digits under a light cart;
branches that are followed in double precision through change points, near which accelerations are rounding by the cube
of the distance: what a crossing left, 1e-12 to 1e-9, went by chance and not by the tolerance.
"""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.marks import slow
from support.problems import ROUNDING, compiled, five_bar, problems

from symscrew.runtime.compiled import find_compiler
from symscrew.simulation import native
from symscrew.simulation.initial import initial_state
from symscrew.simulation.motion import prepare

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these runs would take hours")
QUICK = ("light_cart_pole", "heavy_top", "change_point")
NAMES = [name if name in QUICK else slow(name) for name in problems()]
TOLERANCES = [10.0**-k for k in range(6, 13)]
EVALUATION = 16  # units in the last place that an evaluation of the accelerations is off, as measured in 113 bits


SMALL = 1e-10  # of what rounding may leave where a motion grows no errors: ten change points leave a hundredth of it


@cache
def growth(name: str) -> float:
    return compiled(name).growth()


def left_by_rounding(name: str, steps: float, noise: float) -> float:
    grown = EVALUATION * ROUNDING * growth(name) * np.sqrt(steps)
    assert noise < max(SMALL, 30 * grown), (noise, grown)
    return float(max(noise, grown))


def assert_no_growth(errors: list[float], floor: float) -> None:
    for before, error in itertools.pairwise(errors):
        assert error <= 2 * max(before, floor), (errors, floor)


@pytest.mark.parametrize("name", NAMES)
def test_a_tighter_tolerance_is_never_worse(name: str) -> None:
    case, errors, steps = compiled(name), [], 0.0
    for tolerance in TOLERANCES:
        found = case.run(tolerance=tolerance, most_steps=200_000)
        assert found.ok, (tolerance, found.status)
        errors.append(case.error(found.q))
        steps = found.counters["steps"]
    assert_no_growth(errors, left_by_rounding(name, steps, case.noise(tolerance=TOLERANCES[-1])))


@pytest.mark.slow
def test_near_singular_places_let_no_error_in() -> None:
    """The five-bar's first second, with places where its distal rods nearly align: 1.6e-13; ten times as much entered
    there while loops were closed to a fixed 1e-14."""
    scene, expected = five_bar(until=1.0)
    model, plant = prepare(scene)
    start = (*initial_state(scene, model, plant.parameters), np.zeros(len(plant.x_labels)))
    tight = replace(scene, integrator=replace(scene.integrator, tolerance=1e-12))
    found = native.run_natively(native.Library(plant), tight, start)
    assert np.abs(found.q - expected).max() < 6e-13


@pytest.mark.parametrize(
    "name, method",
    [
        *((n, m) for n in QUICK for m in ("rk4", "rk8")),
        *(slow(n, "rk8") for n in problems() if n not in QUICK),
    ],
)
def test_half_the_step_is_never_worse(name: str, method: str) -> None:
    """From the mean step of an adaptive run down; steps that are too long for the motion may stop a run."""
    case = compiled(name)
    scene = case.problem.scene
    longest = scene.duration / case.run(tolerance=1e-6).counters["steps"]
    chosen = [longest / 2**k for k in range(6)]
    runs = [case.run(method=method, step=step, most_steps=2_000_000) for step in chosen]
    errors = [case.error(run.q) if run.ok else np.inf for run in runs]
    if not runs[-1].ok:  # rates of microseconds: no such step is short enough, and every run says so
        assert all("the accelerations are not defined" in run.status for run in runs)
        return
    noise = case.noise(method=method, step=chosen[-1], most_steps=2_000_000)
    assert_no_growth(errors, left_by_rounding(name, runs[-1].counters["steps"], noise))

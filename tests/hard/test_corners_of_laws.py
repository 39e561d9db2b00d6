"""Corners of contact laws: a compliant stop that is touched for a moment, at every stiffness, depth and tolerance.

Solutions by hand: an oscillator of amplitude 1 with a linear stop near its turning point. Steps that passed such a
corner had errors that no estimate saw: 9e-3 at a tolerance of 1e-6, with a status of completed.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow
from support.problems import compiled

from hard.test_events_within_steps import block
from symscrew.effects import DryFriction, EndStop, Gravity, JointSpring
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation import landing, run_source
from symscrew.simulation.motion import prepare, simulate

pytestmark = pytest.mark.slow

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
ROUNDING = 1e-12  # of ten swings


def touching(stiffness: float, depth: float, duration: float = 10.0) -> Scene:
    """cos t from its lower turning point, and a stop that its upper one is beyond by `depth`."""
    stop = EndStop("z", upper=1 - depth, stiffness=stiffness, exponent=1)
    start = Initial(coordinates={"z": -1})
    return Scene("touching", block(), (JointSpring("z", stiffness=1), stop), duration, 20.0, start)


def by_hand(stiffness: float, depth: float, times: np.ndarray) -> np.ndarray:
    """The place of that block: free, on the stop, free."""
    end = 1 - depth
    met, speed = math.acos(-end), math.sqrt(1 - end * end)
    rate, middle = math.sqrt(1 + stiffness), stiffness * end / (1 + stiffness)
    left = met + 2 * math.atan2(speed / rate, end - middle) / rate
    now = np.mod(times, met + left)
    on = middle + (end - middle) * np.cos(rate * (now - met)) + speed / rate * np.sin(rate * (now - met))
    return np.where(now <= met, -np.cos(now), np.where(now <= left, on, -np.cos(met + left - now)))


def errors(stiffness: float, depth: float, tolerances: tuple[float, ...], backend: str) -> list[float]:
    scene, found = touching(stiffness, depth, 10.0 if backend == "c" else 4.0), []
    prepared = prepare(scene)
    for tolerance in tolerances:
        run = simulate(replace(scene, integrator=Integrator(tolerance=tolerance)), backend=backend, prepared=prepared)
        error = float(np.abs(run.q[:, 0] - by_hand(stiffness, depth, run.t)).max())
        assert run.accurate and error < tolerance, (tolerance, error, run.verdict)
        found.append(error)
    return found


@needs_compiler
@pytest.mark.parametrize(
    "stiffness, depth",
    [(1e4, 1e-4), *(slow(k, d) for k in (1e2, 1e4, 1e6) for d in (1e-4, 1e-3, 1e-2, 1e-1) if (k, d) != (1e4, 1e-4))],
)
def test_a_compliant_stop_is_not_stepped_over(stiffness: float, depth: float) -> None:
    found = errors(stiffness, depth, TOLERANCES, "c")
    for before, after in itertools.pairwise(found):
        assert after <= 2 * max(before, ROUNDING), found


@pytest.mark.parametrize("stiffness, depth", [(1e4, 1e-4), slow(1e6, 1e-3)])
def test_nor_by_the_integrators_of_a_library(stiffness: float, depth: float) -> None:
    errors(stiffness, depth, (1e-6,), "numpy")


@pytest.mark.parametrize("backend", [*(["c"] if find_compiler() else []), slow("numpy")])
def test_steps_of_fixed_length_end_at_corners(backend: str) -> None:
    """Of a twentieth of a second and order 8."""
    scene = replace(touching(1e4, 1e-4, 3.3), integrator=Integrator(method="rk8", step=0.05))
    found = simulate(scene, backend=backend)
    assert np.abs(found.q[:, 0] - by_hand(1e4, 1e-4, found.t)).max() < 2e-6


@needs_compiler
def test_those_that_pass_them_are_a_hundred_times_worse() -> None:
    passing = replace(touching(1e4, 1e-4, 3.3), integrator=Integrator(method="rk8", step=0.05))
    model, plant = prepare(passing)
    missed = simulate(passing, prepared=(model, replace(plant, switches=None)))
    assert np.abs(missed.q[:, 0] - by_hand(1e4, 1e-4, missed.t)).max() > 1e-4


@pytest.mark.parametrize("backend", [*(["c"] if find_compiler() else []), "numpy"])
def test_steps_that_are_not_looked_at_are_told(backend: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene = replace(touching(1e4, 1e-2, 3.0), integrator=Integrator(tolerance=1e-4))
    assert not simulate(scene, backend=backend).events
    text = run_source.kernel_text
    monkeypatch.setattr(landing, "CREDIT", 0)
    monkeypatch.setattr(
        run_source, "kernel_text", lambda name: text(name).replace("#define CREDIT 20", "#define CREDIT 0")
    )
    told = simulate(scene, backend=backend).events
    assert len(told) == 1 and "may have passed corners of a law of force unseen" in told[0]


@pytest.mark.slow
@needs_compiler
def test_errors_of_a_bearing_with_clearance_do_not_go_by_chance() -> None:
    """Starts that differ by one unit in the last place: one in fifty was off by 1.3e-10 at a tolerance of 1e-12, and
    the median at 1e-8 by 1e-9, where it is now 6e-12."""
    case = compiled("loose_crank")
    worst = [max(case.error(run.q) for run in case.runs(50, tolerance=1e-12)), case.usual_error(tolerance=1e-8)]
    assert worst[0] < 1e-11 and worst[1] < 1e-10, worst


@needs_compiler
@pytest.mark.parametrize("exponent, most", [(2, 11_000), slow(1.5, 20_000), slow(1, 70_000)])
def test_work_stays_bounded_where_a_block_comes_to_rest_on_a_stop(exponent: float, most: int) -> None:
    """Falls and bounces until it lies: hundreds of corners, ever nearer to each other."""
    stop = EndStop("z", lower=0, stiffness=1e5, exponent=exponent, damping="1/2")
    scene = Scene("falls", block(), (stop, Gravity((0, 0, "-9.81"))), 5.0, 20.0, Initial(coordinates={"z": 1}))
    run = simulate(scene)
    assert run.accurate, run.verdict
    assert run.counters["evaluations"] < most  # a tenth more than by steps that pass the corners
    assert np.abs(run.energy_balance).max() < 3e-10  # 9e-8 by those


def test_what_compares_nothing_watches_nothing() -> None:
    effects = (JointSpring("z", stiffness=1), DryFriction("z", coulomb="1/10", velocity="1/100"))
    assert prepare(Scene("smooth", block(), effects, 1.0, 20.0))[1].switches is None


@needs_compiler
@pytest.mark.parametrize("place, rate", [(0.0, 0.0), (1e-300, 0.0), (0.0, 1e-17)])
def test_rest_at_a_corner_is_no_chattering(place: float, rate: float) -> None:
    effects = (EndStop("z", upper=0, stiffness=1e4, exponent=1, damping="1/2"), JointSpring("z", stiffness=1))
    start = Initial(coordinates={"z": place}, rates={"z": rate})
    run = simulate(Scene("rests", block(), effects, 3.0, 20.0, start))
    assert run.accurate and np.ptp(run.q) < 1e-13 and run.counters["evaluations"] < 500

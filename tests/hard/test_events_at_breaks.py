"""Events at the instants at which inputs of time break, and breaks at the end of a run.

A step past the end took the force behind the last knot for that before it: a block slipped 3 ms late, 1e-5 off and
called completed. A stop met at a knot, found some roundings before it, stopped the run.
"""

from __future__ import annotations

import numpy as np
import pytest

from hard.test_events_within_steps import pushed_block
from symscrew.description.builder import MechanismBuilder
from symscrew.effects import DryFriction, EndStop
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene, Table
from symscrew.simulation.motion import Run, simulate

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: the compiled loop looks for events")


def moved(pull: str | Table, duration: float, rate: float, place: float, speed: float, *, rough: bool = False) -> Run:
    """1 kg on a rail between stops at +-1 m that throw it back as it comes; 1 N of friction where it is rough."""
    builder = MechanismBuilder("block")
    builder.body("block", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("z", "P", parent="base", child="block", point=[0, 0, 0], axes=[[0, 0, 1]], driven=[0])
    stop = EndStop("z", lower=-1, upper=1, mode="impact", restitution=1)
    effects = (stop, DryFriction("z", coulomb=1, mode="event")) if rough else (stop,)
    tables, drive = ({}, pull) if isinstance(pull, str) else ({pull.name: pull}, pull.name)
    start = Initial({"z": place}, {"z": speed})
    run = simulate(Scene("s", builder.build(), effects, duration, rate, start, drives={"z": drive}, tables=tables))
    assert run.ok and run.accurate, run.verdict
    return run


BEHIND = "3*(t - 0.5 + abs(t - 0.5)) - 30*(t - 1 + abs(t - 1))"


@pytest.mark.parametrize("how", ["table", "text"])
def test_a_break_at_the_end_bends_nothing_before_it(how: str) -> None:
    """Pulled by 6 (t - 1/2) N from 1/2 s on, the block slips at 2/3 s; the pull falls behind the end."""
    pull = Table("pull", (0.0, 0.5, 1.0, 1.1), (0.0, 0.0, 3.0, 0.0)) if how == "table" else BEHIND
    run = moved(pull, 1.0, 20.0, -1.0, 0.0, rough=True)
    assert [text.split(" s: ")[1] for text in run.events] == ["z leaves its stop", "z slips"]
    assert float(run.events[1].split()[2]) == pytest.approx(2 / 3, abs=1e-9)
    assert run.q[:, 0] == pytest.approx(-1 + np.maximum(run.t - 2 / 3, 0) ** 3, abs=1e-9)


@pytest.mark.parametrize("speed", [2.0, -1.0, 0.7, 1 / 3, 3.1])
@pytest.mark.parametrize("rate", [2.0, 700.0])
def test_a_stop_that_is_met_at_a_knot(speed: float, rate: float) -> None:
    """Nothing pulls until the stop is met, to the rounding; from there on -2 (t - knot) N towards the middle."""
    side, knot = np.sign(speed), 1.5 / abs(speed)
    table = Table("pull", (0.0, knot, 2 * knot), (0.0, 0.0, -2 * side * knot))
    run = moved(table, 1.2 * knot, rate / knot, -0.5 * side, speed)
    assert len(run.events) == 1 and float(run.events[0].split()[2]) == pytest.approx(knot, abs=1e-11)
    later = run.t > knot
    after = run.t[later] - knot
    assert side * run.q[~later, 0] == pytest.approx(-0.5 + abs(speed) * run.t[~later], abs=1e-11)
    assert side * run.q[later, 0] == pytest.approx(1 - abs(speed) * after - after**3 / 3, abs=1e-9)


@pytest.mark.parametrize("backend", [*(["c"] if find_compiler() else []), "numpy"])
@pytest.mark.parametrize("holds", ["friction", "stop"])
def test_what_is_held_lets_go_within_a_nanosecond(holds: str, backend: str) -> None:
    """A force of a table rises in 1e-9 s, half a million roundings of the time: at the instant found, its last digits
    say that the joint holds still, ten thousand times. 3 N for a millisecond against 1 N: 2e-3 m/s, and 2e-6 m till it
    rests by friction, or 3 N against nothing from a stop that 1 N pressed on."""
    for start in (9.393618378, 72.98856083787, 43.2):
        knots = (0.0, start, start + 1e-9, start + 1e-3, start + 1e-3 + 1e-9, 100.0)
        low = 0.0 if holds == "friction" else -1.0
        table = Table("f", knots, (low, low, 3.0, 3.0, 0.0, 0.0))
        stick, stop = DryFriction("z", coulomb=1, mode="event"), EndStop("z", lower=0, mode="impact")
        scene = Scene(
            "s", pushed_block(), (stick if holds == "friction" else stop,), start + 0.1, 1 / (start + 0.1),
            drives={"z": "f"}, tables={"f": table}, integrator=Integrator(tolerance=1e-8),
        )  # fmt: skip
        found = simulate(scene, backend=backend)
        assert found.accurate and len(found.events) == 1 + (holds == "friction"), (found.verdict, found.events[:4])
        way = 1e-6 + 2e-6 if holds == "friction" else 1.5e-6 + 3e-3 * (0.1 - 1e-3)
        assert found.q[-1, 0] == pytest.approx(way, rel=3e-6)

"""Stick and slip, stops, Coulomb friction at zero speed, saturated drives: events in time, nothing chatters or creeps.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq
from support.marks import slow

from hard import case
from hard.mechanisms import chain
from symscrew.description.mechanism import Mechanism
from symscrew.effects.dry_friction import DryFriction
from symscrew.effects.effect import Effect
from symscrew.effects.end_stop import EndStop
from symscrew.effects.gravity import Gravity
from symscrew.effects.position_servo import PositionServo
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation import mode_changes
from symscrew.simulation.motion import Run, simulate

pytestmark = pytest.mark.slow

FINE = Integrator(tolerance=1e-10)


def block(axis: object = (1, 0, 0), mass: str = "1") -> Mechanism:
    """A block on a slider along `axis`, driven."""
    body = {"mass": mass, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    return chain("block", ("x", "P", "base", "block", [0, 0, 0], [list(axis)]), driven="x", block=body)  # type: ignore[call-overload]


def moved(mechanism: Mechanism, effects: tuple[Effect, ...], duration: float, **keys: object) -> Run:
    rate = float(keys.pop("rate", 100.0))  # type: ignore[arg-type]
    run = simulate(Scene("scene", mechanism, effects, duration, rate, integrator=FINE, **keys))  # type: ignore[arg-type]
    assert run.ok, run.status
    return run


def times(run: Run, what: str) -> np.ndarray:
    """Times of the events whose text has `what` in it."""
    found = [re.match(r"t = (\S+) s: (.*)", event) for event in run.events]
    return np.array([float(m[1]) for m in found if m and what in m[2]])


# -- stick and slip -----------------------------------------------------------------------------------------


def test_stick_slip_of_a_block_pulled_by_a_spring() -> None:
    """First slip at 3.924 s, slips of 1.0945 s, period 5.0185 s, over ten periods.

    With the static level left out (a block that slips and sticks at the same level: the guard that keeps it stuck)
    there is one slip at 1.962 s and then steady sliding, no period at all (checked at the end).
    """
    assert "5.018526436663236" in case(14)["pass_criterion"]
    friction = DryFriction("x", coulomb="0.2*9.81", static="0.4*9.81", mode="event")
    run = moved(block(), (friction,), 55.0, rate=20.0, drives={"x": "10*(0.1*t - q_x)"})
    slips, sticks = times(run, "slips"), times(run, "sticks")
    assert len(slips) == 11 and len(sticks) == 10
    assert abs(slips[0] - 3.924) < 1e-6
    assert np.abs(sticks - slips[:10] - 1.094526436663236).max() < 1e-6
    assert np.abs(slips - (3.924 + 5.018526436663236 * np.arange(11))).max() < 1e-6
    assert np.abs(run.energy_balance).max() < 1e-8
    still = (run.t > sticks[0] + 1e-6) & (run.t < slips[1] - 1e-6)
    assert np.abs(run.v[still]).max() < 1e-12 and np.ptp(run.q[still]) < 1e-12  # it sticks, it does not creep
    same = DryFriction("x", coulomb="0.2*9.81", mode="event")
    other = moved(block(), (same,), 8.0, rate=20.0, drives={"x": "10*(0.1*t - q_x)"})
    assert len(times(other, "slips")) == 1 and abs(times(other, "slips")[0] - 1.962) < 1e-6


# -- Coulomb friction at zero speed ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "slope, holds", [slow("0.19", True), ("0.2 - 1e-9", True), ("0.2 + 1e-6", False), slow("0.25", False)]
)
def test_block_at_rest_on_a_slope(slope: str, holds: bool) -> None:
    """tan(slope) against mu = 0.2: below it the block stays to the last digit, above it slides off at once.

    Smooth friction, the alternative without stick, creeps: 1e-4 m in 1 s with v0 = 1e-3 m/s (checked).
    """
    value = float(eval_sum(slope))
    fall = Gravity((value * 9.81, 0, "-9.81"))  # mu m g against m g tan
    friction = DryFriction("x", coulomb="0.2*9.81", mode="event")
    run = moved(block(), (fall, friction), 1.0)
    if holds:
        assert np.abs(run.q).max() == 0.0 and np.abs(run.v).max() == 0.0
        smooth = moved(block(), (fall, DryFriction("x", coulomb="0.2*9.81", velocity="1e-3")), 1.0)
        assert np.abs(smooth.q).max() > 1e-4
    else:
        expected = (value - 0.2) * 9.81 * run.t**2 / 2
        assert np.abs(run.q[:, 0] - expected).max() < 1e-9 + 1e-6 * expected[-1]


def eval_sum(text: str) -> float:
    """a, a + b or a - b."""
    first, sign, second = (*text.split(), "+", "0")[:3]
    return float(first) + (1 if sign == "+" else -1) * float(second)


def test_block_comes_to_rest_and_stays() -> None:
    """v/(mu g) after v^2/(2 mu g), and not a step back. (Full friction at rest would drive it back.)"""
    friction = DryFriction("x", coulomb="0.2*9.81", mode="event")
    run = moved(block(), (friction,), 1.5, initial=Initial(rates={"x": 1.0}), drives={"x": "0"})
    stop, way = 1 / (0.2 * 9.81), 1 / (2 * 0.2 * 9.81)
    assert times(run, "sticks")[0] == pytest.approx(stop, abs=1e-8)
    rest = run.t > stop + 1e-9
    assert np.abs(run.q[rest] - way).max() < 1e-10 and np.abs(run.v[rest]).max() < 1e-12


def test_oscillator_with_dry_friction() -> None:
    """Half periods pi sqrt(m/k), amplitude less by 2 Fc/k each, until it sticks within Fc/k: closed form."""
    friction = DryFriction("x", coulomb="0.5", mode="event")
    run = moved(
        block(), (friction,), 3.0, rate=200.0, initial=Initial(coordinates={"x": 0.1033}), drives={"x": "-100*q_x"}
    )
    amplitude, t, ends = 0.1033, 0.0, []
    while amplitude > 0.005:
        amplitude, t = amplitude - 0.01, t + np.pi / 10
        ends.append((t, amplitude * (-1) ** (len(ends) + 1)))
    assert len(ends) == 10
    for at, place in ends[:9]:
        if at < 3.0:
            k = int(np.abs(run.t - at).argmin())
            early = run.t[k] - at
            assert run.q[k, 0] == pytest.approx(place, abs=100 * early**2 + 1e-9)
    assert np.abs(run.energy_balance).max() < 1e-9


# -- stops ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("restitution", [0.0, 0.3, 0.5])
def test_ball_on_a_stop(restitution: float) -> None:
    """Impacts at t0 (1 + 2 e + 2 e^2 ...), an infinity of them in finite time, then at rest on the stop.

    With `mode_changes.SOFT` at zero, which ends the bouncing, there is no end of impacts: see the test below.
    """
    stop = EndStop("z", lower=0, mode="impact", restitution=restitution)
    ball = chain(
        "ball",
        ("z", "P", "base", "ball", [0, 0, 0], [[0, 0, 1]]),
        ball={"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]},
    )
    run = moved(ball, (Gravity(), stop), 3.0, initial=Initial(coordinates={"z": 1.0}))
    first = np.sqrt(2 / 9.81)
    hits = times(run, "z")[: 8 if restitution else 1]
    expected = first * (
        1 + 2 * np.cumsum(restitution ** np.arange(1, len(hits) + 1)) - 2 * restitution ** np.arange(1, len(hits) + 1)
    )
    assert np.abs(hits - expected).max() < 1e-7
    over = first * (1 + 2 * restitution / (1 - restitution))
    rest = run.t > over + 1e-3
    assert rest.any() and np.abs(run.q[rest]).max() < 1e-11 and np.abs(run.v[rest]).max() < 1e-12
    assert run.q.min() > -1e-11  # no penetration
    assert len(run.events) < 60


@pytest.mark.slow
def test_without_an_end_of_the_bouncing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The guard taken out: `mode_changes.SOFT` = 0. More than the sixty impacts of a run that ends them."""
    monkeypatch.setattr(mode_changes, "SOFT", 0.0)
    stop = EndStop("z", lower=0, mode="impact", restitution=0.5)
    ball = chain(
        "ball",
        ("z", "P", "base", "ball", [0, 0, 0], [[0, 0, 1]]),
        ball={"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]},
    )
    settings = replace(FINE, most_steps=3000)
    run = simulate(
        Scene("ball", ball, (Gravity(), stop), 1.5, 100.0, Initial(coordinates={"z": 1.0}), integrator=settings)
    )
    assert not run.ok or len(run.events) > 60


def test_pressed_against_a_stop_and_released() -> None:
    """A force of 2 - 4 t N presses against an upper stop until it pulls: it leaves at 0.5 s and never sticks."""
    stop = EndStop("x", upper=0, mode="impact")
    run = moved(block(), (stop,), 1.0, drives={"x": "2 - 4*t"})
    late = np.maximum(run.t - 0.5, 0)
    assert np.abs(run.q[:, 0] + 4 * late**3 / 6).max() < 1e-9
    assert run.q.max() < 1e-12


def test_compliant_stop_at_speed_and_rested_on() -> None:
    """Hunt and Crossley: 2 m/s into a stop of 1e6 N/m^1.5, then at rest at (m g/k)^(2/3); energy only falls."""
    stop = EndStop("z", lower=0, stiffness=1e6, exponent=1.5, damping=0.1)
    ball = chain(
        "ball",
        ("z", "P", "base", "ball", [0, 0, 0], [[0, 0, 1]]),
        ball={"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]},
    )
    depth = (9.81 / 1e6) ** (2 / 3)
    fast = moved(ball, (Gravity(), stop), 0.5, initial=Initial(coordinates={"z": 0.01}, rates={"z": -2.0}), rate=1000.0)
    assert np.abs(fast.energy_balance).max() < 1e-8
    assert (np.diff(fast.energy.sum(axis=1)) < 1e-10).all()
    assert fast.q.min() < -1e-3 and fast.q[100:].max() > 0.02
    rest = moved(ball, (Gravity(), stop), 0.5, initial=Initial(coordinates={"z": -depth}))
    assert np.abs(rest.q + depth).max() < 1e-12


# -- saturation -------------------------------------------------------------------------------------------------


def test_servo_that_saturates() -> None:
    """Full force until the law asks for less, then a linear oscillator: in closed form, the corner at 1e-9 s."""
    servo = PositionServo("x", stiffness=40, damping=4, limit=3)
    run = moved(block(), (servo,), 4.0, inputs={"servo_x": ("1", "0")})
    corner = brentq(lambda t: 40 * (1 - 1.5 * t * t) - 4 * 3 * t - 3, 0, 1)
    state = np.array([1.5 * corner**2 - 1, 3 * corner])
    system = np.array([[0.0, 1.0], [-40.0, -4.0]])
    force = lambda y: -40 * y[0] - 4 * y[1]  # noqa: E731
    expected = []
    for t in run.t:
        if t <= corner:
            expected.append(1.5 * t * t)
            continue
        y = expm(system * (t - corner)) @ state
        if abs(force(y)) > 3 + 1e-9:
            break  # it saturates a second time, the other way: the closed form holds until then
        expected.append(1 + y[0])
    until = len(expected)
    assert 20 < until < len(run.t) and np.abs(run.q[:until, 0] - expected).max() < 1e-8
    again = simulate(
        Scene(
            "servo",
            block(),
            (servo,),
            4.0,
            100.0,
            inputs={"servo_x": ("1", "0")},
            integrator=Integrator("rk4", step=2.5e-5),
        )
    )
    if find_compiler():
        assert np.abs(again.q - run.q).max() < 1e-8
    assert abs(run.q[-1, 0] - 1) < 2e-2
    assert run.model.programs["forward_dynamics"].inputs[-1].name == "servo_x"

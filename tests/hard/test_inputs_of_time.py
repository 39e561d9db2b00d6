"""What inputs do in time is met wherever it is: pulses, knots, jumps, kinks; what cannot be bounded is named."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from support.marks import slow
from sympy import Integer

from hard.mechanisms import chain
from symscrew.description.mechanism import Parameter, Point
from symscrew.effects import BaseMotion, ExternalWrench
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene, Table
from symscrew.simulation.motion import Run, simulate

pytestmark = pytest.mark.slow

BACKENDS = [*(["c"] if find_compiler() else []), "numpy"]


def pushed(force: str, duration: float, *, tables: dict[str, Table] | None = None, **how: object) -> Run:
    """1 kg on a slider under a force: its speed is the integral of the force."""
    body = {"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    mechanism = chain("block", ("x", "P", "base", "block", [0, 0, 0], [[1, 0, 0]]), driven="x", block=body)
    backend = how.pop("backend", None)
    scene = Scene(
        "pushed", mechanism, (), duration, 10 / duration, drives={"x": force}, tables=tables or {},
        integrator=Integrator(**how),  # type: ignore[arg-type]
    )  # fmt: skip
    return simulate(scene, backend=backend)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "middle, width, backend",
    [
        (77.7, 1e-3, BACKENDS[0]), slow(50.0, 1e-1, BACKENDS[0]), slow(1.234, 1e-5, BACKENDS[0]),
        slow(77.7, 1e-5, "numpy"), slow(1.234, 1e-1, "numpy"),
    ],
)  # fmt: skip
def test_a_pulse_in_a_long_time(middle: float, width: float, backend: str) -> None:
    """A Gaussian anywhere in 100 s gives sqrt(pi) width; stepped over it gave 0."""
    run = pushed(f"exp(-((t - {middle})/{width})^2)", 100.0, backend=backend)
    assert run.v[-1, 0] == pytest.approx(np.sqrt(np.pi) * width, rel=1e-8)


@pytest.mark.parametrize("middle", [3.21])
def test_a_pulse_in_a_text_of_an_effect(middle: float) -> None:
    """A wrench, and a base that jerks: what effects say of the time was stepped over, completed and at rest."""
    body = {"mass": 2, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    mechanism = chain("block", ("x", "P", "base", "block", [0, 0, 0], [[1, 0, 0]]), block=body)
    bell = f"exp(-((t - {middle})/w)^2)"
    width = Parameter("w", Integer(1), "s", run_time=True)
    place = Point("place", "block", (Integer(0),) * 3)
    mechanism = replace(mechanism, parameters={"w": width}, points={"place": place})
    for effect, gained in (
        (ExternalWrench("place", wrench=(f"1000*{bell}", 0, 0, 0, 0, 0)), lambda run: run.v[-1, 0] / 500),
        (BaseMotion(twist=(0, 0, 0, bell, 0, 0)), lambda run: -run.q[-1, 0]),  # the block stays where it is
    ):
        run = simulate(Scene("pushed", mechanism, (effect,), 100.0, 0.1, parameters={"w": 1e-3}))
        assert gained(run) == pytest.approx(np.sqrt(np.pi) * 1e-3, rel=1e-7)


def test_a_base_whose_rate_has_kinks_is_landed_on() -> None:
    """The block stays where it is: against the base it goes back by the integral of |sin|; steps end at its kinks."""
    body = {"mass": 2, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    mechanism = chain("block", ("x", "P", "base", "block", [0, 0, 0], [[1, 0, 0]]), block=body)
    start = Initial(rates={"x": 0.0})
    run = simulate(Scene("kinks", mechanism, (BaseMotion(twist=(0, 0, 0, "abs(sin(t))", 0, 0)),), 10.0, 1.0, start))
    assert not run.events
    assert run.q[-1, 0] == pytest.approx(-(2 * 3 + 1 + np.cos(10.0)), abs=1e-9)


@pytest.mark.parametrize("method", ["cvodes", slow("lsoda")])
def test_nor_do_multistep_methods_step_over_it(method: str) -> None:
    """By cvodes it gave 0, completed; a jump is met as well, and what cannot be bounded is told."""
    run = pushed("exp(-((t - 77.7)/1e-3)^2)", 100.0, method=method, tolerance=1e-6)
    assert run.v[-1, 0] == pytest.approx(np.sqrt(np.pi) * 1e-3, abs=1e-6)
    run = pushed("(1 + abs(t - 1/3)/(t - 1/3))/2", 1.0, method=method, tolerance=1e-6)
    assert run.v[-1, 0] == pytest.approx(2 / 3, abs=1e-7)
    wild = "1/(1 + (1e4*(t + q_x - 77.7))^2)"
    run = pushed(wild, 100.0, method=method, tolerance=1e-6)
    assert "changes with time and the motion together" in run.events[0]


@pytest.mark.parametrize(
    "how, backend",
    [
        ({"tolerance": 1e-3}, BACKENDS[0]), ({"tolerance": 1e-10}, BACKENDS[0]),
        ({"method": "rk4", "step": 0.5}, BACKENDS[0]), slow({"method": "rk4", "step": 0.5}, "numpy"),
    ],
)  # fmt: skip
def test_a_push_in_a_table(how: dict, backend: str) -> None:
    """1000 N for 1 ms at 50 s: 1 m/s behind it, whatever the steps."""
    table = Table("f", (0, 50, 50.0000001, 50.001, 50.0010001, 100), (0, 0, 1000, 1000, 0, 0))
    run = pushed("f", 100.0, tables={"f": table}, backend=backend, **how)
    assert run.v[-1, 0] == pytest.approx(1.0, rel=1e-6)
    assert not run.events  # steps of any kind end at the knots


@pytest.mark.parametrize(
    "force, speed",
    [
        ("(1 + abs(t - 1/3)/(t - 1/3))/2", 2 / 3),  # a jump
        ("abs(t - 0.1234)", (0.1234**2 + 0.8766**2) / 2),
        ("abs(sin(7*t))", (4 + 1 - np.cos(7 - 2 * np.pi)) / 7),
        ("sqrt(t)", 2 / 3),
        ("sin(40*t)*t", np.sin(40) / 1600 - np.cos(40) / 40),
        ("atan(1000*(t - 0.5))", 0.0),
        ("1/(1 + (1000*(t - 0.5))^2)", np.arctan(500.0) / 500),
        ("tan(t)", -np.log(np.cos(1.0))),
    ],
)
def test_jumps_kinks_and_waves(force: str, speed: float) -> None:
    assert pushed(force, 1.0).v[-1, 0] == pytest.approx(speed, abs=2e-9)


@pytest.mark.slow
def test_kinks_without_a_compiler() -> None:
    expected = (4 + 1 - np.cos(7 - 2 * np.pi)) / 7
    assert pushed("abs(sin(7*t))", 1.0, backend="numpy").v[-1, 0] == pytest.approx(expected, abs=2e-9)


@pytest.mark.parametrize("force", ["sin(t*q_x)", "exp(-(t - q_x)^2)"])
def test_what_cannot_be_bounded_is_named(force: str) -> None:
    run = pushed(force, 0.1)
    assert any(text.startswith("drives.x: ") and "beforehand" in text for text in run.events)
    assert not pushed("3*sin(t)*q_x - t^2*v_x", 0.1).events


def test_what_changes_too_fast_is_named() -> None:
    run = pushed("1e-3*sin(1e9*t)", 1.0, most_steps=100)
    assert any("sin(1000000000*t)/1000 changes too fast" in text for text in run.events)


def test_a_step_longer_than_between_outputs_says_what_it_becomes() -> None:
    assert "steps of 0.1 s are taken" in pushed("1", 1.0, method="rk4", step=0.3).events[0]
    assert not pushed("1", 1.0, method="rk4", step=0.1).events


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("middle", [5.3, 5.3017])
def test_what_fixed_steps_may_pass_is_said(backend: str, middle: float) -> None:
    """A pulse shorter than they are; not one that is longer. Where no step and no half of one has an end in it, a block
    that a second of the pulse pushes was at rest, and completed."""
    how: dict[str, Any] = {"method": "rk4", "step": 0.01, "backend": backend}
    run = pushed(f"1e5*exp(-((t - {middle})/0.0001)^2) + 1", 10.0, **how)
    (text,) = run.events
    assert text.startswith("inputs change within") and f"at t = {middle - 1e-4:.4f}"[:12] in text
    assert not run.accurate and "with steps that pass nothing of its inputs the motion is" in run.verdict
    run = pushed(f"1e-9*exp(-((t - {middle})/0.0001)^2) + 1", 10.0, **how)
    assert run.accurate and len(run.events) == 1  # passed, and nothing by it
    run = pushed("exp(-(t - 5.3)^2)", 10.0, **how)
    assert run.accurate and not run.events

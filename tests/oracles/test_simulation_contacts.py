"""Stick and slip, impacts: against solutions by hand."""

from __future__ import annotations

import numpy as np
import pytest
from support.marks import slow

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import DryFriction, EndStop, JointSpring
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.motion import simulate

pytestmark = [pytest.mark.slow, pytest.mark.short_runs]


def block(axis: list) -> Mechanism:
    """2 kg on a slider."""
    builder = MechanismBuilder("block")
    builder.body("block", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("slide", "P", parent="base", child="block", point=[0, 0, 0], axes=[axis])
    return builder.build()


def scene(
    mechanism: Mechanism, *effects: object, duration: float, start: dict, rates: dict | None = None, **more: object
):  # type: ignore[no-untyped-def]
    return Scene(
        "contact", mechanism, tuple(effects), duration, 200.0, Initial(start, rates or {}),  # type: ignore[arg-type]
        integrator=Integrator(tolerance=1e-8), **more,  # type: ignore[arg-type]
    )  # fmt: skip


def test_a_block_on_a_spring_sticks_where_the_theory_says() -> None:
    """Coulomb's oscillator (k = 50 N/m, Fc = 3 N): each half swing loses 2 Fc/k; it sticks inside the dead zone."""
    effects = (JointSpring("slide", stiffness=50), DryFriction("slide", coulomb=3, mode="event"))
    run = simulate(scene(block([1, 0, 0]), *effects, duration=3.0, start={"slide": 0.5}))
    assert run.ok, run.status
    x0, x, loss = 0.5, [], 2 * 3 / 50
    while abs(x0) > 3 / 50:
        x0 = -(x0 - np.sign(x0) * loss)
        x.append(x0)
    assert run.q[-1, 0] == pytest.approx(x[-1], abs=1e-8)
    assert abs(run.v[-1, 0]) < 1e-9
    turns = [float(text.split()[2]) for text in run.events]
    assert turns == pytest.approx(np.pi * np.sqrt(2 / 50) * np.arange(1, len(x) + 1), abs=1e-8)
    assert "slide sticks" in run.events[-1]
    assert sum("turns back" in text for text in run.events) == len(x) - 1
    assert run.energy_error < 1e-8


def test_static_friction_holds_until_the_pull_exceeds_it() -> None:
    effects = (DryFriction("slide", coulomb=1, static=2, stribeck_velocity="1e-9", mode="event"),)
    mechanism = MechanismBuilder("block")
    mechanism.body("block", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    mechanism.joint("slide", "P", parent="base", child="block", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    run = simulate(scene(mechanism.build(), *effects, duration=0.5, start={}, drives={"slide": "5*t"}))
    assert run.events[0].startswith("t = 0.4 s: slide slips")
    before = run.t < 0.4
    assert np.abs(run.q[before]).max() < 1e-15
    s = run.t[-1] - 0.4  # 2 a = 5 t - 1: x = (2.5 + ...) integrated from 0.4 s
    assert run.q[-1, 0] == pytest.approx(((5 * 0.4 - 1) * s**2 / 2 + 5 * s**3 / 6) / 2, rel=3e-4)


def test_a_ball_bounces_by_newtons_law_and_comes_to_rest_on_the_stop() -> None:
    """Heights shrink by e^2, times by e; after the last bounce it lies still, held by m g."""
    e, height = 0.5, 1.0
    effects = (Gravity(), EndStop("slide", lower=0, mode="impact", restitution="0.5"))
    run = simulate(scene(block([0, 0, 1]), *effects, duration=2.0, start={"slide": height}))
    assert run.ok, run.status
    fall = np.sqrt(2 * height / 9.81)
    times = [float(text.split()[2]) for text in run.events]
    expected = fall * (1 + 2 * np.cumsum(e ** np.arange(1, 9)))
    assert times[:9] == pytest.approx([fall, *expected], abs=1e-8)
    assert run.q[-1, 0] == pytest.approx(0.0, abs=1e-7)
    assert run.q.min() > -1e-9  # never beyond the stop
    assert abs(run.v[-1, 0]) < 1e-9
    total = run.energy.sum(axis=1)
    assert np.diff(total).max() < 1e-9  # energy is never created
    end = fall * (1 + 2 * e / (1 - e))
    assert np.abs(run.q[run.t > end + 0.01, 0]).max() < 1e-7


def test_a_stop_in_a_closed_loop() -> None:
    """The crank of the four-bar falls onto a stop: no penetration, loops closed, energy only falls."""
    from symscrew import catalogue

    found = scene(
        catalogue.load("four_bar"), Gravity(), EndStop("A", lower="-0.5", mode="impact", restitution="0.3"),
        duration=1.0, start={}, rates={"A": 1.0},
    )  # fmt: skip
    run = simulate(found)
    assert run.ok, run.status
    labels = [c.label for c in run.model.system.tree.q]
    assert run.q[:, labels.index("A")].min() > -0.5 - 1e-9
    assert any("meets its lower stop" in text for text in run.events)
    assert run.closure_error.max() < 1e-12
    assert np.diff(run.energy.sum(axis=1)).max() < 1e-8


def test_a_stop_in_the_joint_at_which_a_loop_would_be_cut() -> None:
    """A rotor on a spring, whose C beside a lift would be cut, swings back from its stop after four turns; the rate at
    the start is given of the joint that is cut instead."""
    b = MechanismBuilder("lift")
    b.body("rotor", mass=1, com=[0, 0, 0], inertia=["0.5"] * 3)
    b.body("lift", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    line = {"point": [0, 0, 0], "axes": [[0, 0, 1]]}
    b.joint("spin", "R", parent="base", child="rotor", **line)
    b.joint("rise", "P", parent="base", child="lift", driven=True, **line)
    b.joint("both", "C", parent="rotor", child="lift", **line)
    effects = JointSpring("both", "0.01", freedom=1), EndStop("both", -25, freedom=1, mode="impact", restitution=1)
    run = simulate(scene(b.build(), *effects, duration=5.0, start={}, rates={"spin": 7.0}))
    assert run.ok and run.accurate, run.verdict
    omega = np.sqrt(0.02)
    met = np.arcsin(25 * omega / 7) / omega
    assert [text.split(": ")[1] for text in run.events] == ["both meets its lower stop"]
    assert float(run.events[0].split()[2]) == pytest.approx(met, abs=1e-8)
    turned = run.q[-1, [c.label for c in run.model.system.tree.q].index("both.1")]
    assert turned == pytest.approx(-7 / omega * np.sin(omega * (2 * met - 5)), abs=1e-7)


def test_what_contacts_cannot_do_is_refused() -> None:
    friction = DryFriction("slide", coulomb=1, load="0.1", mode="event")
    with pytest.raises(DescriptionError, match="friction with events takes no 'load'"):
        simulate(scene(block([1, 0, 0]), friction, duration=1.0, start={}))
    stop = EndStop("slide", lower=0, mode="impact")
    with pytest.raises(DescriptionError, match="lies beyond its stop at 0"):
        simulate(scene(block([1, 0, 0]), stop, duration=1.0, start={"slide": -0.1}))


@pytest.mark.parametrize(("friction", "last"), [slow(2, "slide sticks"), (5, "slide sticks")])
def test_a_slider_turns_back_at_the_dead_points_of_its_crank(friction: float, last: str) -> None:
    """No friction holds the slide where the crank's motion does not move it; later, away from them, it sticks."""
    from dataclasses import replace

    from support.runs import scene_of

    found = scene_of("spatial_slider_crank", until=2.5, tolerance=1e-6)
    run = simulate(replace(found, effects=(*found.effects, DryFriction("slide", coulomb=friction, mode="event"))))
    assert run.ok, run.status
    *turns, end = [text for text in run.events if "slide" in text]
    assert last in end
    assert all("turns back" in text for text in turns)
    assert run.energy_error < 1e-8
    assert run.closure_error.max() < 1e-12
    rates = run.v[:, [c.label for c in run.model.system.tree.v].index("slide")]
    assert abs(rates[-1]) < 1e-9

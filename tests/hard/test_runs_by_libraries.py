"""Runs without the compiled loop judge themselves too: by another run, and by singular configurations on their way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow
from support.runs import scene_of

from hard.mechanisms import four_bars
from symscrew.effects import Gravity
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.complementarity import UndecidedError, complementary
from symscrew.simulation.motion import simulate
from symscrew.simulation.scene_functions import RunError
from symscrew.simulation.singular_watch import SingularWatch


def falling_row(duration: float, **integrator: object) -> Scene:
    """A parallelogram that falls from upright and is flat after 0.69 s."""
    start = Initial(rates={"A0": -1.0})
    made = Integrator(**integrator)  # type: ignore[arg-type]
    return Scene("row", four_bars(1), (Gravity((0, "-9.81", 0)),), duration, 20.0, start, integrator=made)


@pytest.mark.parametrize(
    "how",
    [{"tolerance": 1e-6}, slow({"method": "radau", "tolerance": 1e-5}), slow({"method": "rk4", "step": 1e-2})],
)
def test_a_change_point_is_not_called_completed(how: dict[str, object]) -> None:
    """Through the flat parallelogram no library follows the branch: before it the run is good, behind it is doubted."""
    before = simulate(falling_row(0.5, **how), backend="numpy")
    assert before.ok and before.accurate and before.verdict == "completed"
    behind = simulate(falling_row(0.9, **how), backend="numpy")
    assert not behind.accurate and behind.verdict != "completed"
    if behind.ok:
        assert "does not follow the branches" in behind.verdict


@pytest.mark.slow
def test_errors_of_libraries_are_estimated() -> None:
    scene = scene_of("andrews", until=0.002, tolerance=1e-6)
    scene = replace(scene, integrator=replace(scene.integrator, method="radau", step=None))
    run = simulate(scene, backend="numpy")
    assert run.estimate is not None and 1e-13 < run.estimate.error < 1e-6 and run.accurate


@pytest.mark.parametrize("sign", [1, -1])
def test_the_watch_sees_what_lies_between_two_steps(sign: int) -> None:
    """|t - 1| by steps of 0.3 that never touch 1, in both directions of time's distance; a bend far away is none."""
    for start in np.linspace(0, 0.29, 7):
        watch = SingularWatch(1.0, 10.0)
        for t in start + 0.3 * np.arange(7):
            watch.seen(float(t), abs(t - 1) * (1 if sign > 0 else 2))
        assert watch.found is not None and abs(watch.found[0] - 1) < 0.5
        calm = SingularWatch(1.0, 10.0)
        for t in start + 0.3 * np.arange(7):
            calm.seen(float(t), 0.3 + 0.2 * (t - 1) ** 2)
        assert calm.found is None


def test_steps_that_lead_no_further_beside_a_singular_position_end() -> None:
    """Where noise makes steps shorter and shorter radau took ten thousand of them, for minutes."""
    through, stuck, outside = (SingularWatch(1.0, 10.0) for _ in range(3))
    for k in range(300):
        through.seen(2e-4 * k, 1e-3)
        outside.seen(1e-6 * k, 0.1)
    with pytest.raises(RunError, match=r"at t = 3\.333\d* s 100 steps led only .* further: this integrator does not"):
        for k in range(1, 300):
            stuck.seen(10 / 3 - 1e-3 / k**2, 1e-3)


def test_impulses_that_obey_no_law_are_refused() -> None:
    """Two contacts that only move each other, one pressed: no impulses >= 0 keep both from sinking in."""
    with pytest.raises(UndecidedError, match="impulses of 2 contacts that act at one instant were not found"):
        complementary(np.array([[1.0, -1.0], [-1.0, 1.0]]), np.array([-1.0, -1.0]))


def test_impulses_do_not_depend_on_units() -> None:
    """Millimetres beside radians: the same impulses, each in its unit."""
    random = np.random.default_rng(3)
    for _ in range(50):
        root, units = random.normal(size=(4, 3)), 10.0 ** random.integers(-6, 6, size=3)
        gain, offset = root.T @ root, random.normal(size=3)
        p = complementary(gain, offset)
        other = complementary(gain * np.outer(units, units), offset * units)
        assert other * units == pytest.approx(p, rel=1e-9, abs=1e-9 * p.max(initial=1.0))

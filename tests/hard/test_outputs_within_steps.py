"""Outputs between the ends of steps that hardly hold: the stages of their dense output may not be on the loops."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.invented_mechanisms import INVENTED, invented

from symscrew.effects import DryFriction, Gravity, JointSpring
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.motion import prepare, simulate

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: its loop puts stages onto loops"),
]


def test_a_step_without_states_in_its_middle_is_taken_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """A loop of R, R, E and S that turns at 70 rad/s: by large tolerances its runs stopped where an output lay in a
    step, "the loops could not be closed again", and went on where none did."""
    slanted = (
        ("R", "base", "a", [1, 1, 2], [[-3, 2, 3]]), ("R", "a", "b", [-3, 3, 2], [[-1, 0, 2]]),
        ("E", "b", "c", [3, -3, 1], [[0, -1, 2]]), ("S", "c", "base", [1, -1, 3], None),
    )  # fmt: skip
    monkeypatch.setitem(INVENTED, "m13", slanted)
    effects = (Gravity(), JointSpring("J0", stiffness=10), DryFriction("J1", coulomb=1, velocity="1/10"))
    start = Initial(rates={"J0": 1.0})
    scene = Scene("m13", invented("m13"), effects, 1.2, 20.0, start, integrator=Integrator(tolerance=1e-10))
    prepared = prepare(scene)
    exact = simulate(scene, prepared=prepared)
    assert exact.accurate
    for tolerance, rate in ((1e-4, 20.0), (1e-4, 100.0), (1e-6, 20.0)):
        choice = replace(scene, rate=rate, integrator=Integrator(tolerance=tolerance))
        run = simulate(choice, prepared=prepared)
        every = round(rate / 20.0)
        assert run.ok and np.abs(run.q[::every] - exact.q).max() < 20 * tolerance

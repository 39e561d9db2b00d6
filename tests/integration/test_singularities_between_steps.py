"""What a sweep calls regular where the way there passes a singularity twice within one step of the walk."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import symscrew
from symscrew.studies.workspace import Axis, Plan, evaluation
from symscrew.studies.workspace.configurations import _near_zero


@pytest.mark.parametrize("steps, seen", [(16, False), (600, True)])
def test_two_singularities_between_two_steps(steps: int, seen: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    axes = Axis("base_left", -4.6, -4.6, 1), Axis("base_right", 3.6, 3.6, 1)
    plan = Plan(symscrew.load_catalogue("five_bar"), (), axes, engine="casadi")
    assert evaluation.evaluate(plan, 0)["regular"][0] == 0.0  # looked at more closely
    monkeypatch.setattr(evaluation, "FINEST", 0)
    assert bool(evaluation.evaluate(replace(plan, steps=steps), 0)["regular"][0] == 0.0) is seen


def test_what_moves_slowly_far_from_zero_is_not_walked_again() -> None:
    ways = np.array([[1.0, 0.9, 0.8, 0.7], [1.0, 0.5, 0.4, 0.9], [1.0, 0.9, 0.08, 0.05]]).T
    assert _near_zero(ways).tolist() == [False, True, True]

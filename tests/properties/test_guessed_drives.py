"""Drives of the first guess where a direction is hardly moved by them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from symscrew.optimisation import guess
from symscrew.optimisation.problem_file import load_problem
from symscrew.optimisation.solution import prepare

EXAMPLES = Path(__file__).parents[2] / "examples" / "optimisation"


def test_directions_that_drives_hardly_move_are_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The five-bar: below `BALANCED` of the largest singular value a direction gets no drive, so drives are smaller."""
    given = load_problem(EXAMPLES / "five_bar_pick_and_place.toml")
    made = prepare(replace(given, independent=("base_left", "elbow_left")))  # the other drive moves both
    layout, tau = made.model.equations.layout, made.guess.tau
    at = guess.PointValues(tau, *made.guess.path(tau), made.guess.q[:, list(layout.z)])
    force, matrix = guess._balance(made.model, 0.5, at)
    u = guess.drives(made.model, 0.5, at)
    assert np.abs(force + np.einsum("nij,nj->ni", matrix, u)).max() < 1e-9 * np.abs(force).max()
    monkeypatch.setattr(guess, "BALANCED", 0.99)
    least = guess.drives(made.model, 0.5, at)
    assert (np.linalg.norm(least, axis=1) <= np.linalg.norm(u, axis=1) * (1 + 1e-9)).all()
    assert np.abs(least - u).max() > 0.1 * np.abs(u).max()

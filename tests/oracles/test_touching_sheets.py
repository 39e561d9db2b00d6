"""Two sheets of one equation by hand that touch where they are looked at: z = x^2 + y^2 and z = -(x^2 + y^2)."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from symscrew.mobility.finite import local_at
from symscrew.mobility.motions.sheets import on_one_sheet

RADIUS = 0.02


class Bowls:
    """z^2 = (x^2 + y^2)^2 with its slopes, as a closure of one row."""

    columns = 3

    def evaluate(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        x, y, z = q.T
        square = x * x + y * y
        return (z * z - square**2)[:, None], np.stack([-4 * x * square, -4 * y * square, 2 * z], axis=1)[:, None]

    def slopes(self, q: np.ndarray) -> np.ndarray:
        return self.evaluate(q)[1]


def place(angle: float, side: int) -> np.ndarray:
    """A point of the upper (1) or lower (-1) bowl."""
    return np.array([RADIUS * np.cos(angle), RADIUS * np.sin(angle), side * RADIUS**2])


@pytest.mark.parametrize("angle", [0.05, 1.0, np.pi / 2, 3.0, np.pi])
@pytest.mark.parametrize("side", [1, -1])
def test_points_of_one_bowl_are_joined_and_of_two_are_not(angle: float, side: int) -> None:
    """Opposite points, too, between which no arc is given: it goes through the tangent space."""
    variety: Any = Bowls()
    here = local_at(variety, np.zeros(3), rank=0)
    assert on_one_sheet(variety, here, place(0.3, side), place(0.3 + angle, side), rank=1)
    assert not on_one_sheet(variety, here, place(0.3, side), place(0.3 + angle, -side), rank=1)

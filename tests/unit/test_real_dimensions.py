"""Whether a component has as many real dimensions as complex ones, by real points about which it is smooth."""

from __future__ import annotations

import numpy as np
import pytest

from symscrew.mobility.components import ConfigurationSpace, Part, space_lines, space_values
from symscrew.mobility.components.all_components import _smooth

POINTS = np.array([[0.0, 0.0, 0.3], [0.0, 0.0, -2.0]])


@pytest.mark.parametrize(
    "polynomial, points, smooth",
    [
        ({(2, 0, 0): 1.0, (0, 2, 0): 1.0}, POINTS, 0),  # two complex planes, of which a line is real
        ({(1, 0, 0): 1.0, (0, 1, 0): 1.0}, POINTS, 2),  # a real plane
        (
            {(2, 0, 0): 1.0, (0, 2, 0): -1.0},
            np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
            1,
        ),  # two, and where they meet
    ],
)
def test_smooth_real_points_are_told_from_others(
    polynomial: dict[tuple[int, ...], float], points: np.ndarray, smooth: int
) -> None:
    part = Part(2, 2, ("p",), through=False, irreducible=True, polynomials=(polynomial,))
    assert _smooth(part, points, 2) == smooth
    found = ConfigurationSpace("a test", ("a", "b", "c"), "Q", (part,), "", 2, (2,), smooth=(smooth,))
    assert ("no real configuration was found about which" in space_lines(found)[1]) == (not smooth)
    assert space_values(found)["components"][0]["real_dimension_seen"] == bool(smooth)

"""The rank-revealing path on a problem that can be solved by hand: both sides of the rank's tolerance."""

from __future__ import annotations

import math

import numpy as np
import pytest

from symscrew.program import RANK, second_path


def solved(size: float, tolerance: float = RANK) -> tuple[np.ndarray, int]:
    """Two masses of 2 kg, pushed with 6 and 4 N; a rod holds the first one, and `size` of a rod the second one."""
    rows = np.diag([1.0, size])
    (a,), status = second_path(
        (2 * np.eye(2)).ravel(),
        np.array([6.0, 4.0]),
        rows.ravel(order="F"),
        np.zeros(2),
        rates=(1.0, 1.0),
        rows=(1.0, 1.0),
        regular=2,
        tolerance=tolerance,
        reactions=None,
    )
    return a, status


@pytest.mark.parametrize(
    ("size", "status", "second"),
    [(1.0, -1, 0.0), (2 * RANK, -1, 0.0), (0.5 * RANK, -2, 2.0), (0.0, -2, 2.0)],
)
def test_a_constraint_that_is_nearly_none_is_a_freedom(size: float, status: int, second: float) -> None:
    a, got = solved(size)
    assert got == status
    np.testing.assert_allclose(a, [0.0, second], atol=1e-12)


def test_numbers_that_are_not_finite_are_told() -> None:
    a, status = solved(math.nan)
    assert status == 2 and np.isnan(a).all()

"""Equal bytes on every machine: functions and least squares of plain sums and products, and what is generated."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from symscrew.algebra import elementary
from symscrew.algebra.least_squares import least_norm

RANDOM = np.random.default_rng(3)
ANGLES = np.concatenate(
    [
        RANDOM.uniform(-10, 10, 300),
        RANDOM.uniform(-5e5, 5e5, 100),
        10.0 ** RANDOM.uniform(-300, 300, 50),
        np.arange(-40, 40) * np.pi / 4,  # close to zeros, where the reduction loses digits
    ]
)


def units_in_last_place(name: str, got: np.ndarray, *arguments: np.ndarray) -> float:
    """The largest error against 400 digits."""
    worst = mpmath.mpf(0)
    with mpmath.workdps(400):
        for value, *given in zip(got, *arguments, strict=True):
            exact = getattr(mpmath, name)(*(mpmath.mpf(float(x)) for x in given))
            unit = mpmath.mpf(float(np.spacing(abs(float(exact)))))
            worst = max(worst, abs(mpmath.mpf(float(value)) - exact) / unit)
    return float(worst)


@pytest.mark.parametrize(
    "name, limit, given",
    [
        ("sin", 1.0, (ANGLES,)),
        ("cos", 1.0, (ANGLES,)),
        ("tan", 2.0, (ANGLES,)),
        ("exp", 1.0, (np.concatenate([RANDOM.uniform(-700, 700, 300), RANDOM.uniform(-1, 1, 200)]),)),
        ("atan2", 2.0, tuple(RANDOM.normal(size=(2, 500)) * 10.0 ** RANDOM.uniform(-5, 5, (2, 500)))),
    ],
)
def test_functions_are_as_good_as_those_of_the_library(name: str, limit: float, given: tuple) -> None:
    function = elementary.arctan2 if name == "atan2" else getattr(elementary, name)
    got = function(*given)
    assert units_in_last_place(name, got, *given) < limit
    one_by_one = [function(*row) for row in zip(*given, strict=True)]
    assert np.array_equal(got, one_by_one)  # a number alone gives the bits that it gives in an array


def test_functions_of_zeros_and_infinities_are_those_of_numpy() -> None:
    special = np.array(
        [0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan, 800.0, -800.0, 1e6]
    )  # and an angle of many digits
    y, x = (side.ravel() for side in np.meshgrid(special, special))
    with np.errstate(all="ignore"):
        for name in ("sin", "cos", "exp"):
            got, expected = getattr(elementary, name)(special), getattr(np, name)(special)
            assert np.allclose(got, expected, rtol=1e-15, atol=0, equal_nan=True), name
            assert np.array_equal(np.signbit(got)[expected == 0], np.signbit(expected)[expected == 0]), name
        got, expected = elementary.arctan2(y, x), np.arctan2(y, x)
    assert np.allclose(got, expected, rtol=1e-15, atol=0, equal_nan=True)
    assert np.array_equal(np.signbit(got)[expected == 0], np.signbit(expected)[expected == 0])


@pytest.mark.parametrize(
    "rows, columns, rank", [(6, 9, 6), (9, 6, 6), (20, 24, 15), (12, 12, 12), (3, 5, 0), (4, 0, 0)]
)
def test_least_squares_of_least_norm(rows: int, columns: int, rank: int) -> None:
    matrix = RANDOM.normal(size=(rows, rank)) @ RANDOM.normal(size=(rank, columns))
    right = RANDOM.normal(size=rows)
    expected = np.linalg.lstsq(matrix, right, rcond=1e-9)[0]
    assert np.abs(least_norm(matrix, right) - expected).max(initial=0.0) <= 1e-11 * np.abs(expected).max(initial=0.0)

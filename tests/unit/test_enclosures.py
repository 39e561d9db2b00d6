"""Enclosures against samples: they hold every value, and their excess falls with the width of the range."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from symscrew.optimisation.enclosures import Arithmetic, EnclosedFunction, bounds_of, polynomial

x = ca.SX.sym("x")
FUNCTIONS = {
    "products": ca.sin(x) * x**3 - ca.cos(3 * x) * x,
    "quotient": ca.sqrt(x + 2) / (x + 3),
    "angle": ca.atan2(x, 1 + x * x),
    "angle beyond a right one": ca.atan2(2 + x, -1 - x * x),
    "size": ca.fabs(x) + ca.fabs(x + 3),
    "powers": (x + 2) ** 2.5 + (x - 7) ** -3 + x**5,
    "tangent": ca.tan(x),
    "arcs": ca.asin(x / 3) * ca.acos(x / 3),
    "exponential": ca.exp(x) - ca.log(x + 5),
    "arctangent": ca.atan(2 * x) + 1 / (x + 4),
    "constant": 2 * ca.SX(3) ** 2 + 0 * x,
}
CENTRES = np.random.default_rng(0).uniform(-0.9, 0.9, 12)


def enclosed(value: ca.SX, width: float) -> tuple[np.ndarray, np.ndarray]:
    n = len(CENTRES)
    radius = np.full(n, width)
    given = polynomial(np.array([CENTRES, np.ones(n)]), radius)
    made = EnclosedFunction(ca.Function("f", [x], [value]))
    return bounds_of(made(Arithmetic(radius), [[given]])[0][0], n)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_value_is_enclosed_and_hardly_more(name: str) -> None:
    function = ca.Function("f", [x], [FUNCTIONS[name]])
    excess = []
    for width in (0.3, 0.03, 0.003):
        low, high = enclosed(FUNCTIONS[name], width)
        at = CENTRES[:, None] + np.linspace(-width, width, 41)
        seen = np.array(function.map(at.size)(at.reshape(1, -1))).reshape(at.shape)
        assert (low <= seen.min(axis=1) + 1e-13).all() and (seen.max(axis=1) - 1e-13 <= high).all()
        excess.append(float(((high - low) - np.ptp(seen, axis=1)).max()))
    assert excess[1] <= excess[0] / 30 + 1e-12 and excess[2] <= excess[1] / 30 + 1e-12


@pytest.mark.parametrize("value", [ca.fmax(x, x**2 - 0.1), ca.fmin(ca.fmax(2 * x, 0), 0.5), ca.fmax(x, 0) ** 2])
def test_kinks_are_enclosed(value: ca.SX) -> None:
    """Near a kink the excess falls with the width, elsewhere as usual."""
    function = ca.Function("f", [x], [value])
    for width in (0.3, 0.03, 0.003):
        low, high = enclosed(value, width)
        at = CENTRES[:, None] + np.linspace(-width, width, 41)
        seen = np.array(function.map(at.size)(at.reshape(1, -1))).reshape(at.shape)
        assert (low <= seen.min(axis=1) + 1e-13).all() and (seen.max(axis=1) - 1e-13 <= high).all()
        assert ((high - low) - np.ptp(seen, axis=1)).max() < 3 * width


def test_what_cannot_be_enclosed_is_everything() -> None:
    for value in (1 / x, ca.sqrt(x), ca.log(x), ca.atan2(x, -1 - x * x)):  # poles, ends, the cut of an angle
        low, high = enclosed(value, 2.0)
        assert np.isinf(low).all() or np.isinf(high).all()
    with pytest.raises(NotImplementedError, match="has no enclosure"):
        enclosed(ca.floor(x), 0.1)

"""Enclosures against samples: they hold every value, and their excess falls with the width of the range."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from symscrew.optimisation.enclosed_functions import EnclosedFunction
from symscrew.optimisation.enclosures import Arithmetic, bounds_of, polynomial

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


CHOICES = {  # value, and the most by which its enclosure may exceed what is seen, in widths
    "limited": (ca.if_else(x > 0.3, 0.3, ca.if_else(x < -0.2, -0.2, x)), 3),
    "one-sided spring of Hertz": (ca.if_else(x > 0, x, 0) * ca.sqrt(ca.if_else(x > 0, x, 0)), 3),
    "a jump": (ca.if_else(ca.logic_and(x > -0.4, x <= 0.1), 2 + x, ca.sin(x)), 3),
    "none of both": (ca.if_else(ca.logic_or(x < -0.5, x > 0.5), x * x, 1), 3),
    "sides that meet": (ca.if_else(ca.logic_not(x >= 0.25), 1 + x, 1.5 - x), 6),
    "unequal": (ca.if_else(x != 5, x**3, 7) + ca.if_else(x == 5, 9, 0), 3),
    "kept apart": (ca.if_else(x > 0, 2 + x, 0) + ca.if_else(x < 0.2, x, 0), 3),
    "varying powers": ((2 + x) ** x + 3**x, 1),
}


@pytest.mark.parametrize("name", CHOICES)
def test_choices_are_enclosed_and_narrowly(name: str) -> None:
    """Near a choice the excess falls with the width, save for values that lie on its sides."""
    value, most = CHOICES[name]
    function = ca.Function("f", [x], [value])
    for width in (0.3, 0.03, 0.003):
        low, high = enclosed(value, width)
        at = CENTRES[:, None] + np.linspace(-width, width, 41)
        seen = np.array(function.map(at.size)(at.reshape(1, -1))).reshape(at.shape)
        assert (low <= seen.min(axis=1) + 1e-13).all() and (seen.max(axis=1) - 1e-13 <= high).all()
        settled = (seen.min(axis=1) > -np.inf) & (np.ptp(seen, axis=1) < 10 * width)
        assert settled.any()
        assert ((high - low) - np.ptp(seen, axis=1))[settled].max() < most * width


def test_what_is_chosen_everywhere_is_as_narrow_as_without_a_choice() -> None:
    """A condition that holds in all of a range takes nothing from the third power."""
    plain, chosen = ca.sin(3 * x) * x, ca.if_else(x < 2, ca.sin(3 * x), 5) * x
    for width in (0.3, 0.003):
        assert np.array_equal(enclosed(plain, width), enclosed(chosen, width))


def test_what_cannot_be_enclosed_is_everything() -> None:
    for value in (1 / x, ca.sqrt(x), ca.log(x), ca.atan2(x, -1 - x * x)):  # poles, ends, the cut of an angle
        low, high = enclosed(value, 2.0)
        assert np.isinf(low).all() or np.isinf(high).all()
    for value in (ca.floor(x), ca.erf(x) + 1, ca.if_else(ca.floor(x) > 0, x, 2 * x) * ca.erf(x)):  # known to nobody
        low, high = enclosed(value, 0.1)
        assert np.isinf(low).all() and np.isinf(high).all()
    for value in ((x - 3) ** x, (-2) ** x, (x - 3) ** 2.5):  # no numbers
        low, high = enclosed(value, 0.1)
        assert np.isinf(low).all() and np.isinf(high).all()

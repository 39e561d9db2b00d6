"""When numbers of a target count as those of the evaluator: on both sides of the limit, and where nothing is finite."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from support import handmade
from support.model_states import model

from symscrew.generation.value_comparison import (
    FLOOR,
    ROUNDINGS,
    TOLERANCE,
    Results,
    compare_values,
    relative_difference,
)

NAN, INF = np.nan, np.inf


def compared(change: Callable[[np.ndarray], np.ndarray], code: int = 0) -> tuple[bool, str]:
    """The first output of inverse dynamics, changed, against itself."""
    made = model("four_bar").only(("inverse_dynamics",))
    expected = {"inverse_dynamics": made("inverse_dynamics", *made.test_inputs["inverse_dynamics"])}

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        (array,), status = made(name, *inputs)
        return (change(array),), status + code

    return compare_values("C", replace(made), expected, evaluate)


@pytest.mark.parametrize("factor, passes", [(0.9, True), (1.2, False)])
def test_both_sides_of_the_limit(factor: float, passes: bool) -> None:
    def changed(array: np.ndarray) -> np.ndarray:
        result = array.copy()
        result.flat[0] += factor * TOLERANCE * np.abs(array).max()
        return result

    passed, text = compared(changed)
    assert passed == passes and "inverse_dynamics, u" in text and "limit 1e-12" in text


def test_a_status_of_its_own_and_numbers_in_place_of_none_fail() -> None:
    passed, text = compared(lambda array: array, code=1)
    assert not passed and "status of inverse_dynamics is" in text
    assert not compared(lambda array: np.full_like(array, NAN))[0]
    assert not compared(lambda array: np.full_like(array, INF))[0]


@pytest.mark.parametrize(
    "expected, got, error",
    [
        ([2.0, 1.0], [2.0, 1.5], 0.25),
        ([FLOOR / 10], [FLOOR / 10 + 1e-15], 1e-12),  # below the floor errors count in absolute terms
        ([FLOOR * 10], [FLOOR * 10 + 1e-15], 1e-13),
        ([NAN, 1.0], [NAN, 1.0], 0.0),
        ([NAN, 1.0], [1.0, 1.0], INF),
        ([INF, 1.0], [INF, 1.0], 0.0),
        ([INF, 1.0], [INF, 1.25], 0.25),
        ([INF, 1.0], [2.0, 1.0], INF),
        ([1.0], [1.0, 1.0], INF),
        ([], [], 0.0),
    ],
)
def test_relative_difference(expected: list[float], got: list[float], error: float) -> None:
    with np.errstate(all="raise"):
        assert relative_difference(np.array(expected), np.array(got)) == pytest.approx(error, rel=1e-3)


def cancelling(size: float, off: float) -> tuple[bool, str]:
    """(x + size) - size, whose target is off by so many times the evaluator's own rounding."""
    of = {"y": lambda tape, x: [x[0] + x[1] - x[1] * x[2]]}
    made = handmade.model(cancelling=handmade.program("cancelling", {"x": 3}, of))
    at = np.array([[1 / 3, size, 1.0], [1 / 7, size, 1.0]])
    made = replace(made, test_inputs={"cancelling": (at,)})
    (array,), status = made("cancelling", at)
    moved = array + off * np.abs(array - at[:, :1]).max()
    return compare_values("C", made, {"cancelling": ((array,), status)}, lambda name, inputs: ((moved,), status))


@pytest.mark.parametrize(
    ("size", "off", "passes"),
    [(1e6, 0.9 * ROUNDINGS, True), (1e6, 1.1 * ROUNDINGS, False), (1e8, 0.9 * ROUNDINGS, True), (1e9, 0.1, False)],
)
def test_where_rounding_does_more_the_limit_is_what_it_does(size: float, off: float, passes: bool) -> None:
    """Of 1e6 rounding leaves 1e-10, of 1e8 1e-8, of 1e9 more than can tell a mistake."""
    passed, text = cancelling(size, off)
    assert passed == passes
    assert ("own roundings there" in text) == (size < 1e9)

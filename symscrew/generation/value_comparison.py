"""Do the numbers of a target agree with those of the reference evaluator, at the model's test states?

for every output array:   max |evaluator - target| / max(max |evaluator|, 1e-3)  <=  1e-12

Where a function is worse conditioned than that at these states, two right orders of its operations differ by more.
What rounding does to the evaluator is then measured, by its instructions with 60 digits; ten times it is the limit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from symscrew.model import Model
from symscrew.program import Iteration, exact_results

if TYPE_CHECKING:
    from symscrew.runtime import Evaluator

TOLERANCE = 1e-12  # rounding of up to some thousand operations; a term left out or a wrong sign is far above
ROUNDINGS = 10.0
"""Times the evaluator's own error by rounding: another order of the same operations errs as much, by luck some times
more or less, and a term left out or a wrong sign changes the first digits."""
ILL = 1e-7  # errors by rounding beyond it leave too little to compare: small terms of a function could be wrong unseen
FLOOR = 1e-3  # below it an array's errors count in absolute terms: of entries that ought to be 0, only rounding is left
Results = tuple[tuple[np.ndarray, ...], np.ndarray]  # outputs (states, size), and the status of every state
Evaluate = Callable[[str, Sequence[np.ndarray]], Results]  # (function, inputs (states, size)) -> its results


def compare_values(
    what: str,
    model: Model,
    expected: Mapping[str, Results],
    evaluate: Evaluate,
) -> tuple[bool, str]:
    """Largest difference per output array, relative to its largest entry (or to 1e-3 if all are smaller).

    Told, and judged, is the array that comes nearest to its limit or farthest beyond.
    """
    worst, limit, where = 0.0, TOLERANCE, ""
    for name, (arrays, status) in expected.items():
        got, got_status = evaluate(name, model.test_inputs[name])
        if not np.array_equal(np.ravel(status), np.ravel(got_status)):
            return False, f"{what}: status of {name} is {np.ravel(got_status)}, expected {np.ravel(status)}"
        errors = [relative_difference(a, b) for a, b in zip(arrays, got, strict=True)]
        allowed = [TOLERANCE] * len(errors)
        if any(TOLERANCE < error < np.inf for error in errors):
            allowed = [max(TOLERANCE, ROUNDINGS * own) for own in _own_roundings(model, name, arrays, status)]
        for port, error, most in zip(model.programs[name].outputs, errors, allowed, strict=True):
            if not error / most <= worst / limit:
                worst, limit, where = error, most, f"{name}, {port.name}"
    passed = worst <= limit
    place = f" ({where})" if where else ""
    why = "" if limit == TOLERANCE else f": {ROUNDINGS:g} times the evaluator's own roundings there"
    return passed, f"{what} agrees with the evaluator to {worst:.1e} relative{place}, limit {limit:.0e}{why}"


def _own_roundings(model: Model, name: str, arrays: Sequence[np.ndarray], status: np.ndarray) -> list[float]:
    """By how much the evaluator's arrays are off what 60 digits give, relative; 0 where that cannot be told."""
    program = model.programs[name]
    if isinstance(program, Iteration):
        return [0.0] * len(arrays)  # ends by its own tolerance, whatever the roundings on the way
    first = np.ravel(status) == 0
    exact = exact_results(program, [np.asarray(x)[first] for x in model.test_inputs[name]])
    off = [relative_difference(a[first], b) for a, b in zip(arrays, exact, strict=True)]
    return [own if own <= ILL else 0.0 for own in off]


def relative_difference(expected: np.ndarray, got: np.ndarray) -> float:
    """max |expected - got| over max |expected|, at least 1e-3; infinite if NaN does not meet NaN, infinity infinity."""
    if expected.shape != got.shape or not np.array_equal(np.isnan(expected), np.isnan(got)):
        return float("inf")
    # equal infinities would become NaN in their difference
    difference = np.subtract(expected, got, out=np.zeros(expected.shape), where=expected != got)
    largest = float(np.nanmax(np.abs(difference), initial=0.0))
    scale = max(float(np.abs(expected[np.isfinite(expected)]).max(initial=0.0)), FLOOR)
    return largest / scale


def first_path(arrays: tuple[np.ndarray, ...], status: np.ndarray) -> Results:
    """Results of code without a second path: near a small pivot NaN and status 1."""
    second = np.asarray(status) < 0
    return tuple(np.where(second[..., None], np.nan, array) for array in arrays), np.where(second, 1, status)


def evaluated(evaluator: Evaluator, sizes: Sequence[int], inputs: Sequence[np.ndarray]) -> Results:
    """Outputs of these sizes and statuses that an evaluator of `symscrew.runtime` writes for inputs (states, size)."""
    states = len(inputs[0]) if inputs else 1
    outputs = tuple(np.empty((states, size)) for size in sizes)
    status = np.zeros(states, dtype=np.intc)
    evaluator([np.ascontiguousarray(x, dtype=float) for x in inputs], outputs, status)
    return outputs, status

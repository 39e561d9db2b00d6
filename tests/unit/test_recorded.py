"""Programs that differentiate and transpose themselves, against complex steps and typed derivatives."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

from symscrew.export.recorded import ARITHMETIC, Recorded, record

NUMPY: dict[str, Callable[..., Any]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "sqrt": np.sqrt,
    "exp": np.exp,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "atan2": np.arctan2,
    "abs": np.abs,
    "less": lambda a, b: float(a < b),
    "select": lambda c, a, b: a if c != 0.0 else b,
}

OPERANDS = {"add": 2, "sub": 2, "mul": 2, "div": 2, "atan2": 2, "less": 2, "select": 3}


def run(program: Recorded, entries: Sequence[float]) -> np.ndarray:
    """A program by its table: the rows of the memory as a loop writes them."""
    table = program.table
    memory = np.full(table.rows, math.nan)
    memory[: len(entries)] = entries
    memory[len(entries) : len(entries) + len(table.constants)] = table.constants
    with np.errstate(all="ignore"):
        for operations, codes, places in table.runs:
            for code, (*rows, target) in zip(codes, places, strict=True):
                op = operations[code]
                memory[target] = NUMPY[op](*memory[rows[: OPERANDS.get(op, 1)]])
    return memory[table.results]


def everything(op: Any, entries: Any) -> tuple[Any, ...]:
    """A listing with every operation, in which all results depend on all inputs."""
    x, y, z = entries
    turned = op.atan2(y, x) + 0.5 * op.sin(z)
    root = op.sqrt(x * x + y * y + 1.0)
    chosen = op.select(op.less(x, y), root / (2.0 + op.cos(y)), op.abs(z) - x)
    return (turned * root, -chosen + op.tan(0.1 * z), op.exp(0.2 * x) - 1.0 / root, 3.0)


def typed(x: complex, y: complex, z: complex) -> np.ndarray:
    """The same, typed once more for complex numbers."""
    angle = complex(math.atan2(y.real, x.real), (x.real * y.imag - y.real * x.imag) / abs(complex(x.real, y.real)) ** 2)
    root = np.sqrt(x * x + y * y + 1)
    chosen = root / (2 + np.cos(y)) if x.real < y.real else (z if z.real >= 0 else -z) - x
    return np.array([(angle + 0.5 * np.sin(z)) * root, -chosen + np.tan(0.1 * z), np.exp(0.2 * x) - 1 / root, 3.0])


@pytest.mark.parametrize("state", [(0.3, 0.8, -1.2), (0.9, -0.4, 0.7), (-0.5, 0.2, 0.1)])
def test_values_tangents_and_transposes_of_every_operation(state: tuple[float, ...]) -> None:
    program, rng = record(everything, 3), np.random.default_rng(5)
    np.testing.assert_allclose(run(program, state), typed(*map(complex, state)).real, rtol=1e-14)
    direction, weights = rng.normal(size=3), rng.normal(size=4)
    exact = typed(*(complex(x, 1e-30 * d) for x, d in zip(state, direction, strict=True))).imag / 1e-30
    tangent = program.tangent()
    np.testing.assert_allclose(run(tangent, [*state, *direction]), exact, rtol=1e-13, atol=1e-14)
    back = run(tangent.adjoint, [*state, *weights])
    assert back @ direction == pytest.approx(weights @ exact, rel=1e-12)


def test_derivatives_have_derivatives() -> None:
    """d/dx of the gradient, along a direction, against the complex step of a typed gradient: x^2 y + sin z."""
    program = record(lambda op, e: (e[0] * e[0] * e[1] + op.sin(e[2]) * e[0],), 3)
    gradient = program.tangent().adjoint  # (x, y, z, c) -> c * gradient
    change = gradient.tangent(active=(0, 1, 2))
    x, y, z = 0.3, -0.7, 1.1
    hessian = [[2 * y, 2 * x, math.cos(z)], [2 * x, 0, 0], [math.cos(z), 0, -math.sin(z) * x]]
    direction = np.array([0.2, 0.5, -0.4])
    np.testing.assert_allclose(run(change, [x, y, z, 1.0, *direction]), np.array(hessian) @ direction, rtol=1e-14)


def test_what_is_not_chosen_does_not_spoil_a_gradient() -> None:
    """The slope of sqrt at 0 is infinite; where the choice falls on the other branch, it does not count."""
    program = record(lambda op, e: (op.select(op.less(e[0], 0.5), 2.0 * e[0], op.sqrt(e[0])),), 1)
    np.testing.assert_array_equal(run(program.tangent().adjoint, [0.0, 1.0]), [2.0])
    np.testing.assert_allclose(run(program.tangent().adjoint, [4.0, 1.0]), [0.25])
    chosen = record(lambda op, e: (op.select(op.less(e[0], 0.5), op.sqrt(e[0]), e[0]),), 1)
    assert not np.isfinite(run(chosen.tangent().adjoint, [0.0, 1.0])).all()  # where it does count, it is said


def test_rows_are_used_again_and_runs_are_few() -> None:
    """A long chain needs few rows; arithmetic stands in runs of its own."""

    def chain(op: Any, entries: Any) -> tuple[Any, ...]:
        x = entries[0]
        for k in range(200):
            x = x * entries[1] + float(k)
        return (op.sin(x),)

    table = record(chain, 2).table
    assert table.rows < 2 + 200 + 4
    assert sum(len(codes) for _, codes, _ in table.runs) == 400  # the first addition is of 0.0
    assert len(table.runs) == 2
    assert set(table.runs[0][0]) <= set(ARITHMETIC)


def test_what_has_no_derivative_is_refused() -> None:
    with pytest.raises(ValueError, match="frobnicate has no derivative"):
        record(lambda op, e: (op.frobnicate(e[0]),), 1).tangent()

"""Lowering: what is printed means what the tape says."""

from __future__ import annotations

import numpy as np

from symscrew.program import Function, Port, evaluate, lower
from symscrew.tape import Tape


def test_a_constant_is_not_the_input_of_that_number() -> None:
    """The constant 2.0 and the input in slot 2 are equal numbers in an instruction, and different operands."""
    tape = Tape()
    x = [tape.symbol(f"x{k}", "1", "input") for k in range(4)]
    ports = Port("x", (4,), ("1",) * 4, (), ""), Port("y", (4,), ("1",) * 4, (), "")
    results = (x[2] * x[3], 2 * x[3], x[3] + 2, x[3] + x[2])
    function = Function("both", "", ports[:1], ports[1:], (tuple(x),), (results,))
    (got,), _ = evaluate(lower(function), [np.array([0.0, 0.0, 5.0, 7.0])])
    assert got.tolist() == [35.0, 14.0, 9.0, 12.0]


def test_a_factor_cancels_its_reciprocal_inside_a_product() -> None:
    tape = Tape()
    x, y, z = (tape.symbol(name, "1", "input") for name in "xyz")
    assert x * (y / x) is y and (y / x) * x is y and (x * y) / x is y
    assert (-x) * (y / x) is tape.neg(y) and x / x is tape.one
    assert (y / x) * y is not y and (x * y) * z is not y
    ports = Port("x", (3,), ("1",) * 3, (), ""), Port("y", (1,), ("1",), (), "")
    function = Function("one", "", ports[:1], ports[1:], ((x, y, z),), ((x * (z * (y / x)),),), ((x, 1e-3), (x, 1e-6)))
    program = lower(function)
    assert program.guards == ((0, 1e-3),)  # of two thresholds the larger one
    (got,), status = evaluate(program, [np.array([[2.0, 3.0, 5.0], [1e-4, 3.0, 5.0]])])
    assert status.tolist() == [0, 1] and got[0].tolist() == [15.0]

"""Passes over programs: what is in the table, and no more, is done before instructions are written."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from symscrew.algebra import Node, Tape, needed, substitute
from symscrew.program import Function, Iteration, Port, Program, evaluate, lower, lowering
from symscrew.program.passes import PASSES


def roots_of_squares(roots: Sequence[Node]) -> list[Node]:
    """|x| as the root of x x: not what one wants, but easy to see."""
    found = {node: node.tape.sqrt(node.args[0] * node.args[0]) for node in needed(roots) if node.op == "abs"}
    return substitute(roots[0].tape, roots, found)


def function() -> Function:
    """|x - y| z and (x y + x z) |x - y|."""
    tape = Tape()
    x, y, z = (tape.symbol(name, "1", "input") for name in "xyz")
    size = tape.function("abs", x - y)
    ports = Port("x", (3,), ("1",) * 3, (), ""), Port("r", (2,), ("1",) * 2, (), "")
    return Function("sizes", "", ports[:1], ports[1:], ((x, y, z),), ((size * z, (x * y + x * z) * size),))


def operations(program: Program) -> list[str]:
    return sorted(i.op for i in program.instructions)


def test_a_pass_is_a_line_in_the_table(monkeypatch: pytest.MonkeyPatch) -> None:
    states = np.random.default_rng(5).normal(size=(7, 3))
    (expected,), _ = evaluate(lower(function()), [states])
    assert operations(lower(function())) == ["abs", "add", "mul", "mul", "mul", "sub"]
    monkeypatch.setattr(lowering, "PASSES", (*PASSES, roots_of_squares))
    program = lower(function())
    assert operations(program) == ["add", "mul", "mul", "mul", "mul", "sqrt", "sub"]
    (got,), status = evaluate(program, [states])
    assert (status == 0).all()
    np.testing.assert_allclose(got, expected, rtol=1e-15)


def test_without_passes_the_numbers_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    states = np.random.default_rng(6).normal(size=(7, 3))
    (expected,), _ = evaluate(lower(function()), [states])
    monkeypatch.setattr(lowering, "PASSES", ())
    program = lower(function())
    assert operations(program) == ["abs", "add", "mul", "mul", "mul", "mul", "sub"]  # x y and x z apart
    (got,), _ = evaluate(program, [states])
    np.testing.assert_allclose(got, expected, rtol=1e-14)


def test_programs_introduce_themselves_in_a_line() -> None:
    program = lower(function())
    assert repr(program) == "Program(sizes(x[3]) -> r[2], 8 operations)"
    ports = Port("y", (1,), ("1",), (), ""), Port("q", (3,), ("1",) * 3, (), "")
    iteration = Iteration("assemble", "", ports, ports[1:], program, (0,))
    assert repr(iteration) == "Iteration(assemble(y[1], q[3]) -> q[3], 8 operations per step)"


def test_small_differences_of_squares_keep_their_digits() -> None:
    """c - k cos(x)^2 with c = k + 1e-6: six digits are lost near x = 0 without the pass, none with it."""
    tape = Tape()
    x = tape.symbol("x", "rad", "input")
    sine, cosine = tape.function("sin", x), tape.function("cos", x)
    whole = tape.constant("2.000001")
    results = (whole - 2 * (cosine * cosine), sine)
    ports = Port("x", (1,), ("rad",), (), ""), Port("r", (2,), ("1",) * 2, (), "")
    program = lower(Function("f", "", ports[:1], ports[1:], ((x,),), (results,)))
    angles = np.geomspace(1e-6, 1.5, 50)[:, None]
    (got,), _ = evaluate(program, [angles])
    expected = 1e-6 + 2 * np.sin(angles[:, 0]) ** 2
    np.testing.assert_allclose(got[:, 0], expected, rtol=1e-15)
    assert sorted(operations(program)) == ["add", "mul", "mul", "sin"]  # no cosine at all

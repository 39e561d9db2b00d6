"""Passes over programs: what is in the table, and no more, is done before instructions are written."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from symscrew.algebra import Node, Tape, needed, substitute
from symscrew.program import Function, Iteration, Port, Program, evaluate, lower, lowering
from symscrew.program.passes import PASSES, common_factors


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


def nested(roots: Sequence[Node], inputs: Sequence[Node]) -> Program:
    ports = (
        Port("x", (len(inputs),), ("1",) * len(inputs), (), ""),
        Port("r", (len(roots),), ("1",) * len(roots), (), ""),
    )
    return lower(Function("sums", "", ports[:1], ports[1:], (tuple(inputs),), (tuple(roots),)))


def test_factors_are_common_wherever_they_stand_in_a_sum() -> None:
    tape = Tape()
    x, y, z, u = (tape.symbol(name, "1", "input") for name in "xyzu")
    found = {
        x * (y * u) + z - u * (z * z): 5,  # u (x y - z z) + z, and not 6 operations
        x * (y * z) + y * (x * z): 3,  # 2 x y z
        (x * y) * z + u - y * (x * z): 0,  # u
        0.5 * (x * x) - 0.5 * (z * u): 4,
    }
    states = np.random.default_rng(7).normal(size=(9, 4))
    a, b, c, d = states.T
    expected = (a * b * d + c - d * c * c, 2 * a * b * c, d, (a * a - c * d) / 2)
    for (root, operations_), values in zip(found.items(), expected, strict=True):
        program = nested([root], (x, y, z, u))
        (got,), _ = evaluate(program, [states])
        np.testing.assert_allclose(got[:, 0], values, rtol=1e-13, atol=1e-15)
        assert len(program.instructions) == operations_


def test_what_something_else_reads_stays_and_counts_twice_where_it_stands_twice() -> None:
    tape = Tape()
    x, y, z, u = (tape.symbol(name, "1", "input") for name in "xyzu")
    product = x * y
    program = nested([product * z + u * product, (product + z) + product, product], (x, y, z, u))
    states = np.random.default_rng(8).normal(size=(9, 4))
    (got,), _ = evaluate(program, [states])
    a, b, c, d = states.T
    np.testing.assert_allclose(got, np.column_stack([a * b * (c + d), 2 * a * b + c, a * b]), rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize("seed", range(4))
def test_random_sums_of_products_keep_their_values(seed: int) -> None:
    rng, tape = np.random.default_rng(seed), Tape()
    inputs = [tape.symbol(name, "1", "input") for name in "xyzuvw"]
    nodes = list(inputs)
    for _ in range(60):
        one, other = (nodes[k] for k in rng.integers(max(0, len(nodes) - 20), len(nodes), size=2))
        nodes.append([one + other, one - other, one * other, one * other, 0.5 * one * other][rng.integers(5)])
    roots = [node for node in nodes[-3:] if node.value is None]
    states = rng.uniform(0.2, 0.6, size=(5, 6))
    tape.set_samples(dict(zip(inputs, states.T, strict=True)))
    (got,), _ = evaluate(nested(roots, inputs), [states])
    expected = np.column_stack([tape.sample(root) for root in roots])
    np.testing.assert_allclose(got, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


def test_the_negative_of_what_has_a_difference_takes_no_operation() -> None:
    """-(x (y - z) + u) is x (z - y) - u, and so with a constant; of what something else reads it is one more."""
    tape = Tape()
    x, y, z, u = (tape.symbol(name, "1", "input") for name in "xyzu")
    states = np.random.default_rng(9).normal(size=(9, 4))
    a, b, c, d = states.T
    product = x * (y - z)
    cases = (
        ([-(product + u)], (-(a * (b - c) + d),), ["mul", "sub", "sub"]),
        ([-(0.5 * (x * y) + u)], (-(a * b / 2 + d),), ["mul", "mul", "sub"]),
        ([-(product + u), product], (-(a * (b - c) + d), a * (b - c)), ["add", "mul", "neg", "sub"]),
        ([-(x * y + u)], (-(a * b + d),), ["add", "mul", "neg"]),
    )
    for roots, values, expected in cases:
        program = nested(roots, (x, y, z, u))
        (got,), _ = evaluate(program, [states])
        np.testing.assert_allclose(got, np.column_stack(values), rtol=1e-13, atol=1e-15)
        assert operations(program) == expected


@pytest.mark.parametrize("length", [100, 400])
def test_only_products_that_share_something_are_compared(monkeypatch: pytest.MonkeyPatch, length: int) -> None:
    """All pairs of a sum, anew after each join, made the code of a chain of 100 joints take five times as long."""
    tape = Tape()
    x = [tape.symbol(f"x{k}", "1", "input") for k in range(2 * length)]
    total = tape.zero
    for k in range(length):
        total = total + x[2 * k] * x[2 * k + 1]
    looked: list[int] = []
    gain = common_factors._gain
    monkeypatch.setattr(common_factors, "_gain", lambda one, other: looked.append(1) or gain(one, other))
    (made,) = common_factors.factored([total + x[0] * x[3] + x[5] * x[6]])
    assert 0 < len(looked) < 12
    assert sum(node.op == "mul" for node in needed([made])) == length


def test_sums_that_share_nothing_are_left_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    """Most sums of a long chain: they are not made again, and their products are not written down by factors."""
    tape = Tape()
    x = [tape.symbol(f"x{k}", "1", "input") for k in range(6)]
    root, made = x[0] * x[1] + x[2] * x[3] - x[4] * x[5], common_factors._Product
    written: list[int] = []
    monkeypatch.setattr(common_factors, "_Product", lambda *given: written.append(1) or made(*given))
    before = len(tape.nodes)
    assert common_factors.factored([root])[0] is root and not written and len(tape.nodes) == before
    nested = x[0] * (x[1] * x[2]) + x[1] * (x[0] * x[2])  # no factor in common, but all of them as a whole
    (less,) = common_factors.factored([nested, x[1] * x[2], x[0] * x[2]])[:1]
    assert len(written) > 2 and sum(node.op == "add" for node in needed([less])) == 0

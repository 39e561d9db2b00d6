"""Both sides of every threshold of the algebra."""

from __future__ import annotations

import math
from math import comb

import mpmath
import numpy as np
import pytest
import sympy

from symscrew import catalogue
from symscrew.algebra import (
    CONTEXT,
    Node,
    Tape,
    TooLargeError,
    choose_pivot,
    cost,
    count_operations,
    differentiate,
    differentiation,
    elementary,
    eliminate,
    expression_node,
    magnitude,
    pair,
    rank_volumes,
    traversal,
    volume,
)
from symscrew.algebra.rank_volumes import determinant
from symscrew.description.builder import MechanismBuilder
from symscrew.dynamics import equilibrium
from symscrew.model import derive


def inputs(tape: Tape, *values: float) -> list[Node]:
    """Inputs with these values at three samples, nearly."""
    found = [tape.symbol(f"x{len(tape.symbols) + k}", "1", "input") for k in range(len(values))]
    tape.add_samples({node: value * np.array([1.0, 1.01, 0.99]) for node, value in zip(found, values, strict=True)})
    return found


def grid(tape: Tape, rows: int, columns: int) -> list[list[Node]]:
    random = np.random.default_rng(rows)
    entries = [[tape.symbol(f"e{i}_{j}", "1", "entry") for j in range(columns)] for i in range(rows)]
    tape.add_samples({e: random.uniform(1, 2, 4) for row in entries for e in row})
    return entries


def test_constants_below_a_bound_are_zero_and_near_ones_are_one() -> None:
    tape = Tape()
    one, tiny = CONTEXT.mpf(1), CONTEXT.mpf(10)
    assert tape.constant(tiny**-46) is tape.zero
    assert tape.constant(tiny**-44) is not tape.zero
    assert tape.constant(one / 3 + tiny**-50) is tape.constant(one / 3)
    assert tape.constant(one / 3 + tiny**-40) is not tape.constant(one / 3)


@pytest.mark.parametrize(("size", "redundant"), [(1e-10, [1]), (1e-8, [])])
def test_entries_below_a_bound_vanish_on_the_manifold(size: float, redundant: list[int]) -> None:
    tape = Tape()
    one, other, small = inputs(tape, 1.0, 1.0, size)
    found = eliminate(tape, [{0: one, 1: other}, {1: small}], {0: 1.0, 1: 1.0}, [1.0, 1.0])
    assert found.redundant == redundant and found.free == redundant


@pytest.mark.parametrize(("size", "chosen"), [(0.2, "cheap"), (0.05, "large")])
def test_a_pivot_may_be_smaller_if_it_saves_operations(size: float, chosen: str) -> None:
    tape = Tape()
    large, cheap = inputs(tape, 1.0, size)
    found = choose_pivot(tape, {"large": large, "cheap": cheap}, {"large": 1.0, "cheap": 1.0}, {"large": 3, "cheap": 1})
    assert found is not None and found.column == chosen


@pytest.mark.parametrize(("size", "place"), [(1e-3, 0), (1e-5, 2)])
def test_a_small_pivot_comes_last_though_its_row_has_no_better_one(size: float, place: int) -> None:
    """Row 1 has one entry and fills nothing; the others fill an entry of each other."""
    tape = Tape()
    a, b, c, d, small = inputs(tape, 1.0, 1.1, 1.2, 1.3, size)
    rows = [{0: a, 1: b}, {2: small}, {0: c, 1: d}]
    found = eliminate(tape, rows, dict.fromkeys(range(3), 1.0), [1.0] * 3)
    assert [row for row, *_ in found.steps].index(1) == place and not found.redundant


@pytest.mark.parametrize(("size", "at_once"), [(0.3, True), (1e-3, True), (1e-5, False)])
def test_two_unknowns_are_found_by_their_determinant_where_it_is_not_small(size: float, at_once: bool) -> None:
    """Rows (1, 1) and (1, 1 + size), whose determinant is size; equal to what NumPy solves at every sample."""
    tape = Tape()
    a, b, c, d, x, y = inputs(tape, 1.0, 1.0, 1.0, 1.0 + size, 0.7, -0.4)
    found = pair(tape, [{0: a, 1: b}, {0: c, 1: d}], (1.0, 1.0))
    assert (found is not None) == at_once
    if found:
        solution = found.solve([x, y])
        for k, (left, right) in enumerate(zip(*(tape.sample(n) for n in (solution[0], solution[1])), strict=True)):
            matrix = np.array([[tape.sample(a)[k], tape.sample(b)[k]], [tape.sample(c)[k], tape.sample(d)[k]]])
            np.testing.assert_allclose(
                np.linalg.solve(matrix, [tape.sample(x)[k], tape.sample(y)[k]]), [left, right], rtol=1e-12
            )
        assert len(found.guards) == 1 and found.guards[0].pivot is found.steps[0][2]


def test_two_unknowns_are_no_pair_if_a_row_lacks_one_or_another_row_is_there() -> None:
    tape = Tape()
    a, b, c = inputs(tape, 1.0, 0.5, 2.0)
    assert pair(tape, [{0: a, 1: b}, {1: c}], (1.0, 1.0)) is None
    assert pair(tape, [{0: a, 1: b}, {0: b, 1: c}, {0: c, 1: a}], (1.0, 1.0)) is None


@pytest.mark.parametrize("safe", [0.0, math.inf])
def test_pivots_of_limbs_that_wait_for_others_give_the_same_drives(
    safe: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = derive(catalogue.load("four_bar"))
    state = [np.atleast_2d(x)[0] for x in plain.test_inputs["inverse_dynamics"]]
    (expected,), _ = plain("inverse_dynamics", *state)
    monkeypatch.setattr(equilibrium, "SAFE", safe)
    (got,), status = derive(catalogue.load("four_bar"))("inverse_dynamics", *state)
    assert status == 0
    np.testing.assert_allclose(got, expected, rtol=1e-11)


def test_equations_of_drives_that_are_the_same_both_ways_are_not_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """In an open chain: counting what is behind each would grow squarely. Around a loop there is a choice."""
    counted: list[int] = []

    def count(nodes: list[Node]) -> int:
        counted.append(count_operations(nodes))
        return counted[-1]

    monkeypatch.setattr(equilibrium, "count_operations", count)
    builder = MechanismBuilder("arm", platform="link2")
    for k in (1, 2):
        builder.body(f"link{k}", mass=1, com=[k, "1/5", 0], inertia=[1, 1, 1])
        between = {"parent": "link1" if k == 2 else "base", "child": f"link{k}"}
        builder.joint(f"joint{k}", "R", **between, point=[k - 1, 0, 0], axes=[[0, 0, 1]], driven=True)
    derive(builder.build())
    assert not counted
    derive(catalogue.load("planar_3rrr"))
    assert counted


def test_orders_of_elimination_that_do_not_promise_are_not_built(monkeypatch: pytest.MonkeyPatch) -> None:
    def slopes(limit: float) -> tuple[int, np.ndarray]:
        monkeypatch.setattr(differentiation, "PROMISING", limit)
        tape = Tape()
        x = inputs(tape, *np.linspace(0.5, 1.5, 6))
        shared = tape.function("sin", x[0] * x[1] + x[2] * x[3])
        outputs = [shared * x[4] + x[0], shared * x[5] * x[1], tape.sqrt(shared * shared + 1)]
        seeds = {node: {str(k): tape.one} for k, node in enumerate(x)}
        rows = differentiate(tape, outputs, seeds, [str(k) for k in range(6)])
        entries = [n for row in rows for n in row]
        return count_operations(entries), np.array([np.broadcast_to(tape.sample(n), 3) for n in entries])

    (few, some), (least, every) = slopes(1.0), slopes(math.inf)
    assert least <= few  # all orders are built, and the shortest is taken
    np.testing.assert_allclose(some, every, rtol=1e-13)


def test_divisions_that_wait_for_each_other_cost_more(monkeypatch: pytest.MonkeyPatch) -> None:
    tape = Tape()
    x, y = inputs(tape, 1.0, 2.0)
    chain, beside = 1 / (1 / (x + 1) + 1), 1 / (x + 1) + 1 / (y + 1)
    assert cost([chain]) - cost([beside]) == count_operations([chain]) - count_operations([beside]) + traversal.WAIT
    monkeypatch.setattr(traversal, "WAIT", 0)
    assert cost([chain]) == count_operations([chain])


def test_many_minors_are_the_determinant_of_the_gram_matrix(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cauchy and Binet: both are the same number."""
    values = []
    for limit in (comb(7, 3) - 1, comb(7, 3)):
        monkeypatch.setattr(rank_volumes, "MOST_SQUARES", limit)
        tape = Tape()
        found = volume(tape, grid(tape, 7, 3), 3)
        values.append((count_operations([found.value]), tape.sample(found.value)))
        assert found.form == "squared"
    (gram, one), (squares, other) = values
    assert gram != squares
    np.testing.assert_allclose(one, other, rtol=1e-10)


def test_volumes_of_too_many_minors_are_not_derived(monkeypatch: pytest.MonkeyPatch) -> None:
    tape = Tape()
    square = grid(tape, 4, 4)
    monkeypatch.setattr(rank_volumes, "MOST_MINORS", 15)
    expected = [np.linalg.det([[tape.sample(e)[k] for e in row] for row in square]) for k in range(4)]
    np.testing.assert_allclose(tape.sample(determinant(tape, square)), expected, rtol=1e-10)
    monkeypatch.setattr(rank_volumes, "MOST_MINORS", 8)
    with pytest.raises(TooLargeError, match="more than 8 minors"):
        determinant(tape, square)
    tall = grid(tape, 5, 3)
    monkeypatch.setattr(rank_volumes, "MOST_SUMMED", comb(5, 2) * comb(3, 2))
    assert volume(tape, tall, 2).form == "squared"
    monkeypatch.setattr(rank_volumes, "MOST_SUMMED", comb(5, 2) * comb(3, 2) - 1)
    with pytest.raises(TooLargeError, match="30 minors of size 2"):
        volume(tape, tall, 2)


def test_blocks_of_many_columns_are_not_looked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two columns fill two rows of a tall grid: a signed factor, or part of the squares."""
    tape = Tape()
    entries = grid(tape, 6, 4)
    entries = [[tape.zero if i > 1 and j < 2 else e for j, e in enumerate(row)] for i, row in enumerate(entries)]
    split = volume(tape, entries, 4)
    monkeypatch.setattr(rank_volumes, "MOST_COLUMNS", 3)
    monkeypatch.setattr(rank_volumes, "SMALL_BLOCK", 1)
    whole = volume(tape, entries, 4)
    assert (split.form, whole.form) == ("mixed", "squared")
    signed = tape.sample(determinant(tape, [row[:2] for row in entries[:2]]))
    np.testing.assert_allclose(tape.sample(split.value) * signed, tape.sample(whole.value), rtol=1e-9)


def test_powers_are_written_out_up_to_a_bound() -> None:
    tape, length = Tape(), sympy.Symbol("length")
    (x,) = inputs(tape, 1.01)
    np.testing.assert_allclose(tape.sample(expression_node(tape, length**64, {length: x})), tape.sample(x) ** 64)
    with pytest.raises(ValueError, match="power up to 64 of a run-time parameter, got 65"):
        expression_node(tape, length**65, {length: x})


def test_large_angles_and_exponents() -> None:
    near = [elementary.LARGEST - 0.5, elementary.LARGEST, elementary.LARGEST + 0.5, 1e300]
    expected = [float(mpmath.mp.clone().sin(x)) if x < 1e6 else math.sin(x) for x in near]
    np.testing.assert_allclose(elementary.sin(np.array(near)), expected, rtol=1e-15)
    with np.errstate(over="ignore"):
        assert elementary.exp(elementary.BEYOND - 1) == elementary.exp(elementary.BEYOND + 1) == math.inf
    assert elementary.exp(-elementary.BEYOND - 1) == 0.0
    assert elementary.exp(700.0) == pytest.approx(math.exp(700.0), rel=1e-15)


def test_a_tape_introduces_itself_in_a_line() -> None:
    tape = Tape()
    x, y = inputs(tape, 1.0, 2.0)
    assert repr(tape) == f"Tape({len(tape.nodes)} nodes, 2 inputs)"
    assert repr(x * y) == f"Node(mul {x.index} {y.index})" and repr(x) == "Node(x0)"


def test_magnitudes_are_those_of_the_samples_at_hand() -> None:
    tape = Tape()
    x = tape.symbol("x", "1", "input")
    for values in ([1.0, -2.0], [3.0, 0.5]):
        tape.set_samples({x: np.array(values)})
        sizes = [abs(3 * v) for v in values]
        for _ in range(2):  # the second time it is known
            assert magnitude(tape, 3 * x, 1.0) == (min(sizes), max(sizes))
            assert magnitude(tape, 3 * x, 2.0) == (2 * min(sizes), 2 * max(sizes))


def test_structural_zeros_and_ones_make_no_nodes() -> None:
    tape = Tape()
    x = tape.symbol("x", "1", "input")
    count = len(tape.nodes)
    assert x + 0 is x and 0 + x is x and x * 1 is x and x * 0 is tape.zero and 0 * x is tape.zero
    assert len(tape.nodes) == count
    assert x * -1 is -x and x + 1 is tape.add(x, tape.one)


@pytest.mark.parametrize("small, finite", [(1e-8, True), (1e-10, False), (0.0, False)])
def test_one_over_rounding_at_a_sample_is_infinite(small: float, finite: bool) -> None:
    tape = Tape()
    x = tape.symbol("x", "1", "a pivot")
    tape.set_samples({x: np.array([small, 0.5, -1.0])})
    assert np.isfinite(tape.sample(1 / x)).tolist() == [finite, True, True]
    assert magnitude(tape, 1 / x, 1.0) == ((1.0, float(f"{1 / small:.4e}")) if finite else (1.0, 2.0))

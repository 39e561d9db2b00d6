"""Steps by stages: what they find meets the conditions of an optimum, checked by another hand in dense matrices."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from symscrew.optimisation.stage_order import Stages
from symscrew.optimisation.stage_steps import EQUATION, FAILED, FREE, StageBlocks

COUNT = 4  # stages that have controls


@dataclass
class Quadratic:
    """min x'Hx/2 + g'x, low <= x <= high, below <= Jx <= above; the unknowns and the rows in an order of no meaning."""

    stages: Stages
    hessian: np.ndarray
    gradient: np.ndarray
    jacobian: np.ndarray
    low: np.ndarray
    high: np.ndarray
    below: np.ndarray
    above: np.ndarray


def quadratic(seed: int, *, across: float = 0.0, bound: float = np.inf, repeated: bool = False) -> Quadratic:
    """Random: start and end held; `across`: what the cost loses across the paths; `bound` of the controls."""
    random = np.random.default_rng(seed)
    nx, nw, paths = int(random.integers(1, 4)), int(random.integers(5, 8)), int(random.integers(1, 4))
    states, controls = (nx,) * (COUNT + 1), (*(nw,) * COUNT, 0)
    path_counts = (*(paths + repeated,) * COUNT, 0)
    n = nx + nw
    size, rows = COUNT * n + nx, COUNT * (nx + paths + repeated)
    h, j = np.zeros((size, size)), np.zeros((rows, size))
    below, above = np.zeros(rows), np.zeros(rows)
    for k in range(COUNT + 1):
        here = slice(k * n, min((k + 1) * n, size))
        made = random.normal(size=(n, n))[: here.stop - here.start, : here.stop - here.start]
        h[here, here] = made @ made.T + 0.1 * np.eye(len(made))
        if k == COUNT:
            break
        first = k * (nx + paths + repeated)
        j[first : first + nx, here] = random.normal(size=(nx, n))
        j[first : first + nx, here.stop : here.stop + nx] = np.diag(random.uniform(0.5, 2.0, nx) * (-1) ** k)
        own = slice(first + nx, first + nx + paths)
        j[own, here] = random.normal(size=(paths, n))
        below[first : own.stop] = above[first : own.stop] = random.normal(size=own.stop - first)
        above[own.stop - 1] += 0.5 * (paths > 1)  # an inequality, where there is a path to spare
        h[here, here] -= across * j[own, here][: paths - (paths > 1)].T @ j[own, here][: paths - (paths > 1)]
        if repeated:
            j[own.stop], below[own.stop], above[own.stop] = (
                2 * j[first + nx],
                2 * below[first + nx],
                2 * above[first + nx],
            )
    low, high = np.full(size, -np.inf), np.full(size, np.inf)
    for k in range(COUNT):
        low[k * n + nx : (k + 1) * n], high[k * n + nx : (k + 1) * n] = -bound, bound
    low[:nx] = high[:nx] = random.normal(size=nx)
    low[-nx:] = high[-nx:] = random.normal(size=nx)
    unknowns, order = random.permutation(size), random.permutation(rows)
    places, at = np.argsort(unknowns), np.argsort(order)
    return Quadratic(
        Stages(unknowns, order, states, controls, path_counts), h[np.ix_(places, places)],
        random.normal(size=size)[places], j[np.ix_(at, places)], low[places], high[places], below[at], above[at],
    )  # fmt: skip


def solved(of: Quadratic) -> tuple[int, np.ndarray, np.ndarray, np.ndarray]:
    """Status, x, multipliers of the bounds and of the rows, from no guess at all."""
    upper, jacobian = (ca.sparsify(ca.DM(k)).sparsity() for k in (np.triu(of.hessian), of.jacobian))
    blocks = StageBlocks(of.stages, upper, jacobian)
    blocks.put_hessian(of.hessian[tuple(np.array(upper.get_triplet()))])
    blocks.put_first(of.gradient, of.jacobian[tuple(np.array(jacobian.get_triplet()))], -of.below)
    unknowns, paths = of.stages.unknowns, of.stages.rows[blocks.path]
    for places, low, high in (
        (blocks.of_unknowns, of.low[unknowns], of.high[unknowns]), (blocks.of_paths, of.below[paths], of.above[paths]),
    ):  # fmt: skip
        blocks.low[places], blocks.high[places] = low, high
        blocks.state[places] = np.where(low == high, EQUATION, FREE)
    said = blocks.solve()
    x, pressure, rows = (np.empty(len(k)) for k in (of.gradient, of.gradient, of.below))
    x[unknowns], pressure[unknowns] = blocks.z, blocks.multiplier[blocks.of_unknowns]
    rows[paths] = blocks.multiplier[blocks.of_paths]
    rows[of.stages.rows[blocks.joining]] = -blocks.costate / blocks.divisor[:-1]
    return said, x, pressure, rows


def check(of: Quadratic) -> int:
    """The conditions of an optimum of first and of second order; how many inequalities hold as equations."""
    said, x, pressure, rows = solved(of)
    assert said == 0, FAILED[said]
    values, near = of.jacobian @ x, 1e-8
    assert np.abs(of.hessian @ x + of.gradient + pressure + of.jacobian.T @ rows).max() < near
    active = []
    for value, low, high, multiplier in ((x, of.low, of.high, pressure), (values, of.below, of.above, rows)):
        assert (value >= low - near).all() and (value <= high + near).all()
        free = high > low
        assert (multiplier[free & (value > low + near)] > -near).all()
        assert (multiplier[free & (value < high - near)] < near).all()
        active.append((value <= low + near) | (value >= high - near))
    held = np.concatenate([np.eye(len(x))[active[0]], of.jacobian[active[1]]])
    _, sizes, vectors = np.linalg.svd(held)
    along = vectors[int((sizes > 1e-9).sum()) :]
    assert len(along) == 0 or np.linalg.eigvalsh(along @ of.hessian @ along.T).min() > 0
    return int((active[0] & (of.high > of.low)).sum() + (active[1] & (of.above > of.below)).sum())


def test_the_conditions_of_an_optimum_hold() -> None:
    assert sum(check(quadratic(seed)) for seed in range(15)) > 3


def test_bounds_that_hold_are_found_without_a_guess() -> None:
    """Or it is said that they were not: a problem may have no solution, and a guess may lead nowhere."""
    found = [quadratic(seed, bound=2.0) for seed in range(15)]
    held = [check(of) for of in found if solved(of)[0] == 0]
    assert len(held) >= 10 and sum(held) > 30


def test_a_cost_that_is_indefinite_across_the_equations_of_a_stage_does_no_harm() -> None:
    for seed in range(10):
        of = quadratic(seed, across=30.0)
        assert np.linalg.eigvalsh(of.hessian).min() < -1
        check(of)


def test_an_equation_that_is_there_twice_does_no_harm() -> None:
    for seed in range(5):
        check(quadratic(seed, repeated=True))


def test_what_has_no_optimum_is_told() -> None:
    of = quadratic(0)
    of.hessian -= 50 * np.eye(len(of.hessian))
    assert "not convex" in FAILED[solved(of)[0]]
    for twice in (quadratic(k, repeated=True) for k in range(3)):
        last = twice.stages.rows[-1]  # a row that was twice another one
        twice.below[last] += 0.1
        twice.above[last] += 0.1
        assert "contradict" in FAILED[solved(twice)[0]]

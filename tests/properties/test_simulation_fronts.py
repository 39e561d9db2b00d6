"""Fronts of the closure's rows: linear in the number of loops, and the same projections as by singular values."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hard.mechanisms import four_bars
from support.four_bars_in_a_row import crank_angle, crossing_times
from support.runs import run_of, scene_of

from symscrew.effects.gravity import Gravity
from symscrew.model import derive
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.fronts import front_pivots, fronts, layouts, paths, regular
from symscrew.simulation.motion import simulate
from symscrew.simulation.native import Library, RunLog
from symscrew.simulation.scene_functions import PlantFunctions
from symscrew.simulation.state_programs import plant

pytestmark = pytest.mark.short_runs

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


def pattern(loops: list[list[int]], rows: int = 2) -> tuple[list[list[int]], np.ndarray]:
    """Rows of every loop, and entries of dense rows over the columns given for each loop."""
    of_loops = [[rows * k + i for i in range(rows)] for k in range(len(loops))]
    entries = [(row, column) for own, columns in zip(of_loops, loops, strict=True) for row in own for column in columns]
    return of_loops, np.array(sorted(entries))


def chain(count: int) -> list[list[int]]:
    """Columns of the loops of a chain: two shared with the neighbours, one own."""
    return [[k, k + 1, count + 1 + k] for k in range(count)]


TREE = [[0, 1, 20], [1, 2, 21], [3, 4, 22], [4, 2, 23], [2, 5, 24], [5, 6, 25], [7, 8, 26]]  # two parts
RING = [[k, (k + 1) % 7, 7 + k] for k in range(7)]
STAR = [[0, 1, 2, 3 + 2 * k, 4 + 2 * k] for k in range(4)]


@pytest.mark.parametrize("loops", [chain(1), chain(2), chain(6), TREE, RING, STAR])
def test_pivots_and_paths(loops: list[list[int]]) -> None:
    """The product of all pivots is the volume that the rows span, whichever the order; every front has a way up."""
    of_loops, entries = pattern(loops)
    random = np.random.default_rng(3)
    matrix = np.zeros((entries[:, 0].max() + 1, entries[:, 1].max() + 1))
    matrix[entries[:, 0], entries[:, 1]] = random.uniform(-1, 1, len(entries))
    matrix = np.concatenate([matrix, np.zeros((1, matrix.shape[1]))])  # a row without entries belongs to no front
    found, _ = regular(fronts([*of_loops, [len(matrix) - 1]], entries), [matrix])
    rows = matrix[[row for front in found for row in front.rows]]
    assert len(rows) == len(matrix) - 1
    volume = np.sqrt(np.linalg.det(rows @ rows.T))
    assert np.prod(np.concatenate(front_pivots(matrix, found))) == pytest.approx(volume, rel=1e-9)
    assert [front.rank for front in found] == [len(front.rows) for front in found]
    columns = [column for front in found for column in front.columns]
    assert sorted(columns) == sorted({column for own in loops for column in own})
    assert all(front.parent == -1 or front.parent > k for k, front in enumerate(found))
    assert all(max(through, default=-1) < len(found) for through in paths(found, entries).values())
    tops = sum(at.width - front.rank for front, at in zip(found, layouts(found), strict=True) if front.parent < 0)
    assert tops == len(columns) - len(rows)  # what all rows leave free


def test_redundant_rows() -> None:
    """Rows that depend on others, in their own loop or in one before, do not count."""
    of_loops, entries = pattern(chain(5), rows=3)
    random = np.random.default_rng(4)
    matrix = np.zeros((15, 11))
    matrix[entries[:, 0], entries[:, 1]] = random.uniform(-1, 1, len(entries))
    matrix[2] = matrix[0] - 2 * matrix[1]  # the first loop's rows
    found, smallest = regular(fronts(of_loops, entries), [matrix, 1.5 * matrix, 2 * matrix])
    assert sum(front.rank for front in found) == np.linalg.matrix_rank(matrix) == 11
    assert next(front for front in found if 0 in front.rows).rank == 2
    assert smallest == pytest.approx(1.5 * min(own.min() for own in front_pivots(matrix, found) if len(own)))


def test_a_chain_costs_as_much_per_loop_however_long_it_is() -> None:
    """What the kernels store and go through: the same for every further loop. Over all rows at once it was cubic."""
    numbers = {}
    for count in (10, 20, 40):
        of_loops, entries = pattern(chain(count))
        found, _ = regular(fronts(of_loops, entries), [_filled(entries)])
        through = paths(found, entries)
        numbers[count] = np.array(
            [sum(at.width**2 for at in layouts(found)), sum(map(len, through.values())), len(found)]
        )
        assert max(at.width for at in layouts(found)) == 5  # two loops at the top share a rate
    assert (numbers[40] - numbers[20] == 2 * (numbers[20] - numbers[10])).all()
    star, _ = pattern(STAR)
    assert len(fronts(star, pattern(STAR)[1])) == 1  # loops that all share rates stay together


def _filled(entries: np.ndarray) -> np.ndarray:
    matrix = np.zeros(entries.max(axis=0) + 1)
    matrix[entries[:, 0], entries[:, 1]] = np.random.default_rng(5).uniform(-1, 1, len(entries))
    return matrix


@needs_compiler
@pytest.mark.slow
def test_the_projection_is_that_by_singular_values() -> None:
    """Three fronts: rates go back onto the closure by the shortest way, positions onto it, as NumPy does it."""
    model = derive(four_bars(4), (Gravity((0, "-9.81", 0)),))
    made = plant(model)
    assert len(made.fronts) == 3
    library = Library(made, flags=("-O0",))
    random = np.random.default_rng(6)
    oracle = PlantFunctions(made, [], compiled=False)
    on, v = model.system.sample_states[0][-1], random.uniform(-1, 1, made.sizes["v"])
    on, _, _ = oracle.settle(on, v)
    for away, allowed in ((0.0, 1e-13), (1e-6, 1e-6)):  # all goes by the rows of the first configuration
        q = on + random.uniform(-away, away, made.sizes["q"])
        outcome = library.start(0.0, q, v, np.zeros(0), method="rk4", h=1e-3, rtol=1, atol=1, longest=1, budget=1)
        _, (found_q, found_v, _), _ = library.report()
        expected_q, expected_v, _ = oracle.settle(q, v)
        assert outcome == 0
        assert np.abs(found_v - expected_v).max() < allowed
        assert np.abs(found_q - expected_q).max() < 1e-5 * away + 1e-13
        residual, jacobian = oracle.opening(found_q)
        assert np.abs(residual).max() < 1e-13 and np.abs(jacobian @ found_v).max() < 1e-13


@needs_compiler
@pytest.mark.slow
def test_all_crossings_of_a_longer_chain() -> None:
    """Ten four-bars in as many steps as two; every crossing found, with one row lost per loop.

    With rows in one order over all loops one of the ten was lost at this tolerance, two of twenty four-bars.
    """
    integrator = Integrator("dop853", tolerance=1e-9)
    scene = Scene("ten", four_bars(10), (Gravity((0, "-9.81", 0)),), 10.0, 20.0, Initial(rates={"A0": -1.0}))
    run = simulate(replace(scene, integrator=integrator))
    two = run_of("n_four_bar", scene_of("n_four_bar", tolerance=1e-9))
    assert run.ok and run.closure_error.max() < 1e-12
    angle = -run.q[:, [c.label for c in run.model.system.tree.q].index("A0")]
    assert np.abs(angle - crank_angle(10, run.t)).max() < 1e-7
    assert [c.t for c in run.crossings] == pytest.approx(crossing_times(10, 10.0), abs=1e-6)
    assert {c.lost for c in run.crossings} == {10}
    assert run.counters["steps"] < 1.1 * two.counters["steps"]


@needs_compiler
def test_rates_that_matter_no_more_are_zero() -> None:
    """A04 without weight at rates whose products are denormal numbers: at rest.

    Without DUST the rates stayed, and the run took 12 times as long.
    """
    model = derive(scene_of("bricard").mechanism, ())
    bare = plant(model)
    library = Library(bare, flags=("-O0",))
    oracle = PlantFunctions(bare, [], compiled=False)
    q = model.system.reference
    _, v, _ = oracle.settle(q, np.ones(bare.sizes["v"]))
    for rate in (1e-310, 1e-160, 1.0):
        log, x = RunLog.empty(library, np.array([0.0, 0.1])), np.zeros(bare.sizes["x"])
        library.start(0.0, q, rate * v, x, method="rk4", h=1e-2, rtol=1, atol=1, longest=1, budget=99)
        assert library.advance(99, log) == 0
        assert log.written[0] == 2 and log.v.any() == (rate == 1.0)

"""Sequential quadratic programming whose steps go stage by stage, for a motion that starts near an optimum.

Stages + functions of the program --nonzeros to places--> dense blocks of the stages --stage_steps.c--> a step

Full steps, with exact second derivatives: they converge near an optimum, and what they do not reach is left to others.
"""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Mapping
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from symscrew.optimisation.solution import clock
from symscrew.optimisation.sparse import NonlinearProgram
from symscrew.optimisation.stage_order import Stages
from symscrew.runtime import compile_c

# Guesses of the bounds that hold, in a step: from the last motion's one or two are needed. More often than not one that
# takes this many goes round in a circle.
MOST_GUESSES = 12
# Multipliers (of a cost near 1) below which a bound does not start as an equation: an interior-point method leaves some
# 1e-8 / distance on every bound.
INACTIVE = 1e-5
LOW, FREE, HIGH, EQUATION = -1, 0, 1, 2  # as in C
# Where a step made what is left this much smaller, the next one takes the same second derivatives: another step costs
# less than they do, and they are nearly those of the optimum.
NEAR = 0.01
FAILED = {
    1: "the cost is not convex along the constraints",
    2: "the constraints of a step contradict each other",
    3: "the bounds that hold did not settle",
}
DIVERGED = "steps do not come nearer"
FLAGS = ("-O3",)  # loops over rows of 10 to 100 numbers: vectors make the step twice as fast


@cache
def step_library() -> ctypes.CDLL:
    """The compiled steps, from the user's cache where they are there.

    Raises:
        CompileError: there is no compiler that takes them.
    """
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        source, library = Path(temporary, "stage_steps.c"), Path(temporary, "libsteps.so")
        source.write_bytes(resources.files("symscrew.optimisation").joinpath("stage_steps.c").read_bytes())
        compile_c(source, library, flags=FLAGS)
        return ctypes.CDLL(str(library))  # stays mapped when its file is gone


class StageBlocks:
    """A quadratic program in stages: where nonzeros of the Hessian and the Jacobian go, and its solution."""

    def __init__(self, stages: Stages, hessian: ca.Sparsity, jacobian: ca.Sparsity) -> None:
        """`hessian`: upper triangle, of one stage in each entry."""
        self.stages = stages
        self.n = np.array(stages.states) + np.array(stages.controls)
        following = np.array([*stages.states[1:], 0])
        paths = np.array(stages.paths)
        sizes = self.n * self.n + self.n + (following + paths) * self.n + following
        starts = np.concatenate([[0], np.cumsum(sizes)])
        rows = starts[:-1] + self.n * self.n + self.n  # where rows of a stage start
        self.data = np.zeros(starts[-1])
        self._number = np.repeat(np.arange(len(self.n)), self.n)  # stage of an unknown, and its place there
        self._local = np.arange(len(self._number)) - np.concatenate([[0], np.cumsum(self.n)])[self._number]
        self._gradient = starts[self._number] + (self.n**2)[self._number] + self._local
        self._place_hessian(hessian, starts)
        row_stage = np.repeat(np.arange(len(self.n)), following + paths)
        row_local = np.arange(len(row_stage)) - np.concatenate([[0], np.cumsum(following + paths)])[row_stage]
        joining = row_local < following[row_stage]
        self.joining, self.path = np.flatnonzero(joining), np.flatnonzero(~joining)  # in the order of the stages
        self._offset = (rows + (following + paths) * self.n)[row_stage[joining]] + row_local[joining]
        self._place_jacobian(jacobian, rows, (row_stage, row_local, joining))
        self._places(following, paths)

    def _place_hessian(self, pattern: ca.Sparsity, starts: np.ndarray) -> None:
        back = np.argsort(self.stages.unknowns)
        one, other = (back[np.array(k)] for k in pattern.get_triplet())
        at, n = starts[self._number[one]], self.n[self._number[one]]
        assert (self._number[one] == self._number[other]).all()  # `stages_of` sees to it
        self._hessian = at + self._local[one] * n + self._local[other]
        self._mirrored = at + self._local[other] * n + self._local[one]

    def _place_jacobian(self, pattern: ca.Sparsity, rows: np.ndarray, of_rows: tuple[np.ndarray, ...]) -> None:
        """Coefficients of the next states, which rows are divided by, stand apart."""
        stage, local, joining = of_rows
        r, c = (np.array(k) for k in pattern.get_triplet())
        r, c = np.argsort(self.stages.rows)[r], np.argsort(self.stages.unknowns)[c]
        behind = self._number[c] > stage[r]
        position = np.cumsum(joining) - 1  # of a joining row among these
        self._next = np.flatnonzero(behind)
        self._next_row = position[r[self._next]]
        self._inside = np.flatnonzero(~behind)
        r, c = r[self._inside], c[self._inside]
        self._entry = rows[stage[r]] + local[r] * self.n[stage[r]] + self._local[c]
        self._divided = np.where(joining[r], position[r], len(self.joining))  # the last divisor is -1

    def _places(self, following: np.ndarray, paths: np.ndarray) -> None:
        most, n = self.n + paths + following, self.n
        work = 3 * n * n + 3 * n + most + np.array(self.stages.states) + most * (n + 1 + most)
        count = n + paths
        starts = np.concatenate([[0], np.cumsum(count)])
        within = np.arange(starts[-1]) - np.repeat(starts[:-1], count)
        of_unknowns = within < np.repeat(n, count)
        self.of_unknowns, self.of_paths = np.flatnonzero(of_unknowns), np.flatnonzero(~of_unknowns)
        self._sizes = np.stack([self.stages.states, self.stages.controls, paths], axis=1).astype(np.intc).ravel()
        self._work = np.zeros(int(work.sum()))
        self._ints = np.zeros(int((2 * most + n).sum()), np.intc)
        self.low, self.high, self.multiplier = (np.zeros(starts[-1]) for _ in range(3))
        self.state = np.zeros(starts[-1], np.intc)
        self.z, self.costate = np.zeros(int(n.sum())), np.zeros(len(self.joining))
        self._library = step_library()
        self._described = np.zeros(self._library.stage_size() * len(n), np.uint8)
        arrays = (
            self._sizes, self.data, self.low, self.high, self.state, self.z, self.multiplier, self.costate, self._work,
            self._ints, self._described,
        )  # fmt: skip
        self._given = [ctypes.c_void_p(array.ctypes.data) for array in arrays]

    def put_hessian(self, nonzeros: np.ndarray) -> None:
        """Nonzeros of the upper triangle."""
        self.data[self._hessian] = nonzeros
        self.data[self._mirrored] = nonzeros

    def put_first(self, gradient: np.ndarray, nonzeros: np.ndarray, g: np.ndarray) -> None:
        """Gradient, nonzeros of the Jacobian, and how far the rows that join stages are off; all in program order."""
        self.data[self._gradient] = gradient[self.stages.unknowns]
        self.divisor = np.full(len(self.joining) + 1, -1.0)
        self.divisor[self._next_row] = nonzeros[self._next]
        self.data[self._entry] = -nonzeros[self._inside] / self.divisor[self._divided]
        self.data[self._offset] = -g[self.stages.rows[self.joining]] / self.divisor[:-1]

    def solve(self) -> int:
        """The step from `low`, `high` and the guess `state` to `z`, `multiplier`, `costate`; 0 or why not."""
        tries = ctypes.c_int(MOST_GUESSES)
        said: int = self._library.stage_step(len(self.n), *self._given, ctypes.byref(tries))
        return said


class StageSolver:
    """Called and answering as CasADi's solvers, in the order of the program."""

    def __init__(self, stages: Stages, program: NonlinearProgram, *, tolerance: float, steps: int) -> None:
        """`tolerance` of constraints and of the Lagrangian's gradient; `steps`: the most."""
        self.tolerance, self.steps = tolerance, steps
        x, p = program.x, program.p
        f, slope = program.gradient(x, p)
        g, jacobian = program.jacobian(x, p)
        self._first = _Evaluated(ca.Function("first", [x, p], [f, ca.densify(slope), ca.densify(g), jacobian]))
        self._second = _Evaluated(program.hessian)
        pattern = program.jacobian.sparsity_out(1)
        self.blocks = StageBlocks(stages, program.hessian.sparsity_out(0), pattern)
        self._rows, self._columns = (np.array(k) for k in pattern.get_triplet())
        self._stats: dict[str, Any] = {}

    def __call__(self, **given: Any) -> dict[str, Any]:
        """Solve from x0, lam_x0, lam_g0 between lbx, ubx, lbg, ubg with parameters p."""
        x, lam_x, lam_g = (np.array(given[k], dtype=float).ravel() for k in ("x0", "lam_x0", "lam_g0"))
        low, high = ((np.asarray(given[f"{k}x"]), np.asarray(given[f"{k}g"])) for k in ("lb", "ub"))
        p = np.asarray(given["p"], dtype=float)
        self._guess_bounds((low, high), (lam_x, lam_g))
        before = self._first.spent + self._second.spent
        offs: list[float] = []
        while True:
            f, slope, g, jacobian = self._first(x, p)
            lagrangian = slope + lam_x
            lagrangian += np.bincount(self._columns, weights=jacobian * lam_g[self._rows], minlength=len(x))
            left = (_outside(x, low[0], high[0]), _outside(g, low[1], high[1]), _largest(lagrangian), abs(f[0]) * 0.0)
            offs.append(float(np.max(left)))  # what is no number stays none, the cost's too
            solved = offs[-1] <= self.tolerance
            if solved or len(offs) > self.steps or not offs[-1] <= min(offs[-3:]) * (10 if len(offs) < 3 else 1):
                word = "Solve_Succeeded" if solved else DIVERGED
                break
            if len(offs) < 2 or offs[-1] > NEAR * offs[-2]:
                self.blocks.put_hessian(*self._second(x, p, np.ones(1), lam_g))
            said = self._step((slope, g, jacobian), (x, low, high))
            if said:
                word = FAILED[said]
                break
            x, lam_x, lam_g = self._moved(x, lam_g)
        wall, processor = self._first.spent + self._second.spent - before
        self._stats = {"success": solved, "return_status": word, "iter_count": len(offs) - 1, "residuals": offs}
        self._stats |= {"t_wall_nlp_all": wall, "t_proc_nlp_all": processor}
        return {"f": f[0], "x": x, "g": g.copy(), "lam_x": lam_x, "lam_g": lam_g}

    def stats(self) -> Mapping[str, Any]:
        """What CasADi's solvers tell of the last solve; `residuals` before every step."""
        return self._stats

    def _guess_bounds(self, bounds: Any, multipliers: tuple[np.ndarray, np.ndarray]) -> None:
        made, order = self.blocks, self._orders()
        for low, high, pressure, (at, places) in zip(*bounds, multipliers, order, strict=True):
            held = np.where((pressure > INACTIVE) & np.isfinite(high), HIGH, FREE)
            held[(pressure < -INACTIVE) & np.isfinite(low)] = LOW
            held[low == high] = EQUATION
            made.state[places] = held[at]

    def _orders(self) -> tuple[tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
        """Positions in the program and among the bounds of the stages: of unknowns, of path constraints."""
        made = self.blocks
        return (made.stages.unknowns, made.of_unknowns), (made.stages.rows[made.path], made.of_paths)

    def _step(self, derivatives: Any, at: Any) -> int:
        made = self.blocks
        slope, g, jacobian = derivatives
        x, low, high = at
        made.put_first(slope, jacobian, g - low[1])
        for below, above, value, (place, bounds) in zip(low, high, (x, g), self._orders(), strict=True):
            made.low[bounds] = (below - value)[place]
            made.high[bounds] = (above - value)[place]
        return made.solve()

    def _moved(self, x: np.ndarray, lam_g: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        made = self.blocks
        (unknowns, of_unknowns), (paths, of_paths) = self._orders()
        pressure, moved, rows = np.empty_like(x), x.copy(), np.empty_like(lam_g)
        moved[unknowns] += made.z
        pressure[unknowns] = made.multiplier[of_unknowns]
        rows[paths] = made.multiplier[of_paths]
        rows[made.stages.rows[made.joining]] = -made.costate / made.divisor[:-1]
        return moved, pressure, rows


class _Evaluated:
    """A CasADi function on arrays that stay where they are: nothing is converted."""

    def __init__(self, function: ca.Function) -> None:
        self.function, self.spent = function, np.zeros(2)
        self._given = [np.zeros(function.nnz_in(k)) for k in range(function.n_in())]
        self._found = [np.zeros(function.nnz_out(k)) for k in range(function.n_out())]
        made: Any = function.buffer()
        self._buffer, self._evaluate = made
        for k, array in enumerate(self._given):
            self._buffer.set_arg(k, memoryview(array.data))
        for k, array in enumerate(self._found):
            self._buffer.set_res(k, memoryview(array.data))

    def __call__(self, *given: np.ndarray) -> list[np.ndarray]:
        began = clock()
        for own, array in zip(self._given, given, strict=True):
            own[:] = array
        self._evaluate()
        self.spent += clock() - began
        return self._found


def _outside(value: np.ndarray, low: np.ndarray, high: np.ndarray) -> float:
    return max(_largest(np.maximum(low - value, 0.0)), _largest(np.maximum(value - high, 0.0)))


def _largest(array: np.ndarray) -> float:
    return float(np.abs(array).max(initial=0.0))

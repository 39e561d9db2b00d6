"""The order in which a solver that goes stage by stage wants a transcription: states, controls, states, controls ...

Transcribed + pattern of the Jacobian --> order of unknowns and rows, sizes of the stages;   none where something spans
more than two neighbours (a free duration, a peak, design parameters, rates of drives)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from symscrew.optimisation.sparse import NonlinearProgram
from symscrew.optimisation.transcription import Transcribed

STATES = ("y", "y_1", "x")  # unknowns at the ends of the intervals


@dataclass(frozen=True)
class Stages:
    """`unknowns`, `rows`: positions in the program, in order; states, controls and path constraints of every stage."""

    unknowns: np.ndarray
    rows: np.ndarray
    states: tuple[int, ...]
    controls: tuple[int, ...]
    paths: tuple[int, ...]

    @property
    def options(self) -> dict[str, Any]:
        """What solvers of CasADi that go by stages want to know."""
        sizes = {"nx": list(self.states), "nu": list(self.controls), "ng": list(self.paths)}
        return {"N": len(self.states) - 1, **sizes}


def stages_of(transcribed: Transcribed, program: NonlinearProgram) -> Stages | None:
    """The stages of a program, if it falls into such."""
    index, count = transcribed.unknowns.index, len(transcribed.mesh) - 1
    inside = [name for name, at in index.items() if name not in STATES and at.ndim == 3]
    if set(index) - set(STATES) - set(inside) or not all(len(index[name]) == count for name in inside):
        return None
    ends = [np.concatenate([index[name][k].ravel() for name in STATES]) for k in range(count + 1)]
    between = [np.concatenate([index[name][k].ravel() for name in inside]) for k in range(count)]
    between.append(np.zeros(0, int))
    stage = np.empty(transcribed.unknowns.size, int)
    for k, parts in enumerate(zip(ends, between, strict=True)):
        for part in parts:
            stage[part] = k
    pattern = program.jacobian.sparsity_out(1)
    rows, columns = (np.array(part) for part in pattern.get_triplet())
    first, last = np.full(pattern.size1(), count + 1), np.full(pattern.size1(), -1)
    np.minimum.at(first, rows, stage[columns])
    np.maximum.at(last, rows, stage[columns])
    if (last - first > 1).any() or (last < 0).any():
        return None
    order, paths = [], []
    for k in range(count + 1):
        path = np.flatnonzero((first == k) & (last == k))
        if k < count:
            spanning = np.flatnonzero((first == k) & (last == k + 1))
            joining = _joining(spanning, ends[k + 1], stage=stage, rows=rows, columns=columns)
            if joining is None:
                return None
            order.append(joining)
        order.append(path)
        paths.append(len(path))
    unknowns = np.concatenate([part for parts in zip(ends, between, strict=True) for part in parts])
    sizes = (tuple(map(len, ends)), tuple(map(len, between)))
    return Stages(unknowns, np.concatenate(order), *sizes, tuple(paths))


def _joining(
    spanning: np.ndarray, following: np.ndarray, *, stage: np.ndarray, rows: np.ndarray, columns: np.ndarray
) -> np.ndarray | None:
    """The rows that give each of the next states, in their order; None unless each has one of its own."""
    own = np.isin(rows, spanning) & (stage[columns] == (stage[following[0]] if len(following) else -1))
    pairs = dict(zip(columns[own].tolist(), rows[own].tolist(), strict=True))
    alone = own.sum() == len(following) == len(spanning) == len(set(pairs.values()))
    return np.array([pairs[column] for column in following.tolist()], int) if alone else None


class StagedSolver:
    """A solver of the program in the order of its stages, called and answering in the program's own."""

    def __init__(self, stages: Stages, program: NonlinearProgram, options: Mapping[str, Any]) -> None:
        """`options` of CasADi's sequential quadratic programming."""
        self.stages, self.program = stages, program
        n, m = len(stages.unknowns), len(stages.rows)
        x, p = ca.MX.sym("x", n), program.p
        back = np.argsort(stages.unknowns).tolist()
        here, unknowns, rows = x[back], stages.unknowns.tolist(), stages.rows.tolist()
        f, slope = program.gradient(here, p)
        g, jacobian = program.jacobian(here, p)
        sigma, lam = ca.MX.sym("sigma"), ca.MX.sym("lam", m)
        upper = program.hessian(here, p, sigma, lam[np.argsort(stages.rows).tolist()])
        bend = ca.triu2symm(upper)[unknowns, unknowns]
        value = ca.Function("value", [program.x, p], [program.f, program.g])
        objective, constraints = value(here, p)
        inputs = ["x", "p"]
        first = [f, slope[unknowns], g[rows], jacobian[rows, unknowns]]
        own = {
            "jac_fg": ca.Function("nlp_jac_fg", [x, p], first, inputs, ["f", "grad_f_x", "g", "jac_g_x"]),
            "hess_lag": ca.Function(
                "nlp_hess_l", [x, p, sigma, lam], [bend], [*inputs, "lam_f", "lam_g"], ["hess_gamma_x_x"]
            ),
        }
        nlp = {"x": x, "p": p, "f": objective, "g": constraints[rows]}
        self.solver = ca.nlpsol("staged", "sqpmethod", nlp, {**options, **own})

    def __call__(self, **given: Any) -> dict[str, Any]:
        """Solve with the arguments of CasADi's solvers."""
        columns, rows = self.stages.unknowns, self.stages.rows
        order = {
            "x0": columns,
            "lbx": columns,
            "ubx": columns,
            "lam_x0": columns,
            "lbg": rows,
            "ubg": rows,
            "lam_g0": rows,
        }
        put = {name: np.asarray(value)[order[name]] if name in order else value for name, value in given.items()}
        found = self.solver(**put)
        result: dict[str, Any] = {"f": found["f"]}
        for name, at in (("x", columns), ("lam_x", columns), ("g", rows), ("lam_g", rows)):
            result[name] = np.empty(len(at))
            result[name][at] = np.array(found[name]).ravel()
        return result

    def stats(self) -> Mapping[str, Any]:
        """What CasADi tells of the last solve."""
        told: Mapping[str, Any] = self.solver.stats()
        return told

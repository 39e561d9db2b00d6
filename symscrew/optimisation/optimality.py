"""Whether a solver's answer is an optimum, by slopes and by curvature, and a better motion where one is near.

unknowns, multipliers --slopes of the Lagrangian--> left;  --curvature along what is free--> way down --> better

An optimum has no slope of the Lagrangian L = f + lambda g + nu x, and L bends upwards along everything that the
constraints leave free. The second holds exactly where the matrix

    [ H + S   J^T ]        H second derivatives of L,  S = |nu| / (distance to the bound),  J rows that hold or press,
    [ J       -D  ]        D almost 0 of equations, (distance to the bound) / |lambda| of rows that press

has as many negative pivots as J has rows (Sylvester's law, on the complement of -D). A solver that starts on a
symmetric motion does not leave it, and takes a summit of the cost for its valley.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import casadi as ca
import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import SuperLU, splu

from symscrew.optimisation.sparse import NonlinearProgram
from symscrew.optimisation.unknowns import Unknowns

# Slope, scaled as IPOPT does, above which a motion is no optimum: a cost of size one may fall by a thousandth. IPOPT
# calls 1e-6 acceptable, so that only tolerances that a problem asked for itself come here.
SLOPE = 1e-3
# Curvature [cost, per mean square of the unknowns] below which the cost falls away from a summit. Motions that leave
# much open (least energy) have curvatures of -1e-6 from rounding alone; summits seen have -1e-3 and more.
CURVATURE = 1e-4
HARD = 1e-10  # D of an equation: curvature of size one across it counts as held
LEAST_GAP = 1e-12  # distance to a bound, scaled: active sets stand exactly on theirs
PRESSES = 1e-10  # multipliers below this press on nothing
MOST_CURVED = 1e6  # curvature above which the way down is not looked for any more
STEPS = (0.5, 0.1, 0.02, 0.004)  # root mean squares, scaled, of moves along the way down
BACK = 6  # Newton steps back onto the constraints
ON = 1e-7  # scaled: what is missed less is on the constraints, as a solver that succeeds leaves less than 1e-6
TURNS = 30  # of inverse iteration: its factor is at most 10 / 11 of a wrong direction, mostly far less
GAIN = 1e-8  # scaled cost: less of a gain is rounding


@dataclass(frozen=True)
class Look:
    """What came of a look: the largest slope (scaled); a better point, None where none was found, and its gain.

    `curved` is False where curvature could not be judged: pivots were exchanged.
    """

    slope: float
    better: np.ndarray | None = None
    gain: float = 0.0
    curved: bool = True

    @property
    def level(self) -> bool:
        """Whether slopes are those of an optimum."""
        return bool(self.slope <= SLOPE)


@dataclass(frozen=True)
class _At:
    """A point of a program: unknowns, cost and its slope, constraints and their Jacobian."""

    x: np.ndarray
    cost: float
    slope: np.ndarray
    rows: np.ndarray
    jacobian: sp.csc_matrix


def looked_at(
    program: NonlinearProgram,
    unknowns: Unknowns,
    answer: tuple[np.ndarray, np.ndarray, np.ndarray],
    parameters: np.ndarray | None = None,
) -> Look:
    """Slopes and curvature at a solver's answer (unknowns, multipliers of rows, of bounds), all scaled."""
    p = np.zeros(program.p.numel()) if parameters is None else parameters
    x, rows, pressure = answer
    at = _at(program, x, p)
    slope = _slope(program, unknowns, at, (rows, pressure))
    if not slope <= SLOPE:
        return Look(slope)
    free = np.flatnonzero(unknowns.lower < unknowns.upper)
    hessian = _matrix(program.hessian(x, p, 1.0, rows))
    stiff = _stiffness(x, unknowns.lower, unknowns.upper, pressure)
    curved = (hessian + sp.triu(hessian, 1).T + sp.diags(stiff))[free][:, free]
    presses = _stiffness(at.rows, program.lower, program.upper, rows)
    held = np.flatnonzero((program.lower == program.upper) | (presses > 0))
    equal = (program.lower == program.upper)[held]
    soft = np.where(equal, HARD, 1.0 / np.where(equal, 1.0, presses[held]))
    jacobian = at.jacobian[:, free].tocsr()[held]
    _, name, count = np.unique(np.array(unknowns.labels)[free], return_inverse=True, return_counts=True)
    mass = 1.0 / count[name]
    matrix = _Curvature(curved, jacobian, soft, mass)
    fall = matrix.negative(CURVATURE)
    if not fall:
        return Look(slope, curved=fall is not None)
    down = matrix.way_down()
    if down is None:
        return Look(slope, curved=False)
    way = np.zeros(len(x))
    way[free] = down
    for sign, step in ((sign, step) for step in STEPS for sign in (1.0, -1.0)):
        other = _back(program, unknowns, x + sign * step * way, p)
        if other is not None and (gain := at.cost - other.cost) > GAIN * max(1.0, abs(at.cost)):
            return Look(slope, other.x, gain)
    return Look(slope)


def _at(program: NonlinearProgram, x: np.ndarray, p: np.ndarray) -> _At:
    cost, slope = program.gradient(x, p)
    rows, jacobian = program.jacobian(x, p)
    return _At(x, float(cost), np.array(slope).ravel(), np.array(rows).ravel(), _matrix(jacobian))


def _matrix(values: ca.DM) -> sp.csc_matrix:
    pattern = values.sparsity()
    return sp.csc_matrix((np.array(values.nonzeros()), pattern.row(), pattern.colind()), shape=pattern.shape)


def _slope(program: NonlinearProgram, unknowns: Unknowns, at: _At, multipliers: tuple[np.ndarray, np.ndarray]) -> float:
    """Largest slope of the Lagrangian, and pressure on bounds that are not near, as IPOPT scales them."""
    rows, pressure = multipliers
    free = unknowns.lower < unknowns.upper
    slopes = (at.slope + at.jacobian.T @ rows + pressure)[free]
    loose = [
        np.abs(multiplier) * np.minimum(_gap(value, low, high, multiplier), 1.0)
        for value, low, high, multiplier in (
            (at.x, unknowns.lower, unknowns.upper, pressure), (at.rows, program.lower, program.upper, rows)
        )
    ]  # fmt: skip
    size = max(100.0, float(np.abs(np.concatenate([rows, pressure])).mean())) / 100.0
    largest = max(float(np.abs(part).max(initial=0.0)) for part in (slopes, *loose))
    return largest / size if np.isfinite(largest) else np.inf


def _gap(value: np.ndarray, low: np.ndarray, high: np.ndarray, multiplier: np.ndarray) -> np.ndarray:
    """Distance to the bound that a multiplier presses on; 0 of equations, which may press both ways."""
    away = np.where(multiplier > 0, high - value, value - low)
    return np.where((low == high) | (multiplier == 0), 0.0, np.maximum(away, 0.0))


def _stiffness(value: np.ndarray, low: np.ndarray, high: np.ndarray, multiplier: np.ndarray) -> np.ndarray:
    """Pressure over distance of bounds that are pressed on; 0 of others and of equations."""
    gap = np.maximum(_gap(value, low, high, multiplier), LEAST_GAP)
    return np.where((low < high) & (np.abs(multiplier) > PRESSES) & np.isfinite(gap), np.abs(multiplier) / gap, 0.0)


class _Curvature:
    """The matrix of the heading, with a multiple of the unknowns' mean square added."""

    def __init__(self, curved: sp.spmatrix, jacobian: sp.spmatrix, soft: np.ndarray, mass: np.ndarray) -> None:
        self.curved, self.jacobian, self.soft, self.mass = curved, jacobian, soft, mass

    def factors(self, added: float) -> SuperLU:
        """Factors without exchanges, as far as they go."""
        matrix = sp.bmat([
            [self.curved + added * sp.diags(self.mass), self.jacobian.T], [self.jacobian, -sp.diags(self.soft)]
        ]).tocsc()  # fmt: skip
        if not np.isfinite(matrix.data).all():
            raise RuntimeError("not finite")
        return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})

    def negative(self, added: float) -> int | None:
        """Directions in which curvature is below minus `added`; None where pivots do not tell."""
        try:
            found = self.factors(added)
        except RuntimeError:  # singular
            return None
        pivots = found.U.diagonal()
        if not (np.array_equal(found.perm_r, found.perm_c) and np.isfinite(pivots).all()):
            return None
        return max(int((pivots < 0).sum()) - len(self.soft), 0)

    def way_down(self) -> np.ndarray | None:
        """The direction of least curvature, of mean square one, by inverse iteration from beyond it; None without."""
        added = CURVATURE
        while self.negative(added) != 0:
            added *= 10.0
            if added > MOST_CURVED:
                return None
        factors = self.factors(added)
        way = np.random.default_rng(1).standard_normal(len(self.mass))
        for _ in range(TURNS):
            way = factors.solve(np.concatenate([self.mass * way, np.zeros(len(self.soft))]))[: len(way)]
            way /= np.sqrt(self.mass @ way**2)
        return np.asarray(way)


def _back(program: NonlinearProgram, unknowns: Unknowns, x: np.ndarray, p: np.ndarray) -> _At | None:
    """The point on the constraints near x by least changes; None where there is none in a few steps."""
    for at in _steps_back(program, unknowns, x, p):
        missed = np.maximum(np.maximum(program.lower - at.rows, at.rows - program.upper), 0.0)
        if not (np.isfinite(missed).all() and np.isfinite(at.cost) and np.isfinite(at.jacobian.data).all()):
            return None
        if missed.max(initial=0.0) <= ON:
            return at
    return None


def _steps_back(program: NonlinearProgram, unknowns: Unknowns, x: np.ndarray, p: np.ndarray) -> Iterator[_At]:
    free = np.flatnonzero(unknowns.lower < unknowns.upper)
    for _ in range(BACK):
        x = np.clip(x, unknowns.lower, unknowns.upper)
        at = _at(program, x, p)
        yield at
        goal = np.clip(at.rows, program.lower, program.upper)
        held = np.flatnonzero((program.lower == program.upper) | (goal != at.rows))
        jacobian = at.jacobian[:, free].tocsr()[held]
        matrix = sp.bmat([[sp.eye(len(free)), jacobian.T], [jacobian, -HARD * sp.eye(len(held))]]).tocsc()
        moved = splu(matrix).solve(np.concatenate([np.zeros(len(free)), (goal - at.rows)[held]]))
        x = x.copy()
        x[free] += moved[: len(free)]

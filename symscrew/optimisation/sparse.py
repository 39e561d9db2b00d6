"""A nonlinear program with exact sparse derivatives from one function of a point, repeated along linear maps.

The unknowns X of the program reach every point i by a constant sparse map, Z_i = L_i X + c_i. A family of points
shares one function Z -> (g, l): the constraints at the point, and what its cost integrates with weight w_i. So

    gradient  sum w_i L_i^T dl/dZ,    Jacobian rows  dg/dZ L_i,    Hessian  sum L_i^T (d2 / dZ2) L_i

are assembled by constant sparse matrices from the nonzeros of the point's derivatives, which CasADi makes
once, for one point.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.rows import PointFunction


@dataclass(frozen=True)
class SparseMap:
    """Rows of a sparse matrix, compressed: row r has `columns[start[r]:start[r + 1]]` with `values`."""

    start: np.ndarray
    columns: np.ndarray
    values: np.ndarray

    @staticmethod
    def of(rows: np.ndarray, columns: np.ndarray, values: np.ndarray, count: int) -> SparseMap:
        """The map with the given entries and `count` rows."""
        order = np.argsort(rows, kind="stable")
        start = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))])
        return SparseMap(start.astype(int), columns[order].astype(int), values[order])

    @property
    def rows(self) -> np.ndarray:
        """Row of every entry."""
        return np.repeat(np.arange(len(self.start) - 1), np.diff(self.start))

    def matrix(self, width: int) -> ca.DM:
        """As a CasADi matrix."""
        return triplet(self.rows, self.columns, self.values, (len(self.start) - 1, width))

    def expand(self, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """For each of the asked rows all its entries: position in `rows`, column, value."""
        counts = np.diff(self.start)[rows]
        source = np.repeat(np.arange(len(rows)), counts)
        first = np.repeat(self.start[rows], counts)
        within = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        return source, self.columns[first + within], self.values[first + within]


def triplet(rows: np.ndarray, columns: np.ndarray, values: np.ndarray, shape: tuple[int, int]) -> ca.DM:
    """A sparse CasADi matrix from entries, those at one place added."""
    key = columns.astype(np.int64) * shape[0] + rows
    unique, inverse = np.unique(key, return_inverse=True)
    total = np.bincount(inverse, weights=values, minlength=len(unique))
    pattern = _pattern(unique, shape)
    return ca.DM(pattern, total)


def _pattern(keys: np.ndarray, shape: tuple[int, int]) -> ca.Sparsity:
    """The sparsity of sorted keys column * rows + row."""
    columns, rows = np.divmod(keys, shape[0])
    start = np.concatenate([[0], np.cumsum(np.bincount(columns, minlength=shape[1]))])
    return ca.Sparsity(shape[0], shape[1], start.tolist(), rows.tolist())


@dataclass(frozen=True)
class Family:
    """`count` points with one function: `map` (count * arguments rows), `offset` c, cost weights, times tau."""

    name: str
    function: PointFunction
    count: int
    map: SparseMap
    offset: np.ndarray
    weights: np.ndarray
    tau: np.ndarray

    def repeated(self, values: Sequence[float]) -> np.ndarray:
        """What belongs to the rows of a point, for all points: (count * rows,)."""
        return np.tile(np.array(values, dtype=float), self.count)


@dataclass(frozen=True)
class Linear:
    """Constraints lower <= matrix X <= upper with a label per row and the time at which it stands."""

    map: SparseMap
    lower: np.ndarray
    upper: np.ndarray
    labels: tuple[str, ...]
    tau: np.ndarray


@dataclass(frozen=True)
class NonlinearProgram:
    """The nonlinear program in the solver's unknowns, with its functions and the meaning of every row.

    `p` are its parameters: the problem's numbers that stay symbols and the linear cost, or nothing.
    """

    x: ca.MX
    p: ca.MX
    f: ca.MX
    g: ca.MX
    gradient: ca.Function
    jacobian: ca.Function
    hessian: ca.Function
    lower: np.ndarray
    upper: np.ndarray
    labels: tuple[str, ...]
    tau: np.ndarray


@dataclass
class _Parts:
    """Contributions to a sparse matrix: where they stand, and from which source nonzero with which factor."""

    rows: list[np.ndarray] = field(default_factory=list)
    columns: list[np.ndarray] = field(default_factory=list)
    values: list[np.ndarray] = field(default_factory=list)
    sources: list[np.ndarray] = field(default_factory=list)
    nonzeros: list[Any] = field(default_factory=list)
    size: int = 0

    def add(self, rows: np.ndarray, columns: np.ndarray, values: np.ndarray, source: np.ndarray) -> None:
        self.rows.append(rows)
        self.columns.append(columns)
        self.values.append(values)
        self.sources.append(source + self.size)

    def source(self, nonzeros: Any) -> None:
        self.nonzeros.append(nonzeros)
        self.size += nonzeros.numel()

    def assembled(self, shape: tuple[int, int]) -> ca.MX:
        if not self.rows:
            return ca.MX(*shape)
        rows, columns, values, source = (
            np.concatenate(x) for x in (self.rows, self.columns, self.values, self.sources)
        )
        key = columns.astype(np.int64) * shape[0] + rows
        unique, inverse = np.unique(key, return_inverse=True)
        gather = triplet(inverse, source, values, (len(unique), self.size))
        nonzeros = ca.mtimes(ca.MX(gather), ca.vertcat(*self.nonzeros))
        return ca.MX(_pattern(unique, shape), nonzeros)


# "value", "slope", "jacobian", "hessian", of one point, or of all points of a family side by side
PointFunctions = Mapping[str, ca.Function]


def assemble(
    families: Sequence[Family],
    linear: Linear,
    cost: np.ndarray,
    cost_scale: float,
    *,
    points: Callable[[Family], PointFunctions] | None = None,
) -> NonlinearProgram:
    """The program of families, linear constraints, and a linear `cost` (n,) beside the families' integrals.

    The objective is divided by `cost_scale`. `points` gives the functions of a family's points (default: interpreted).
    Where they hold numbers of the problem, those and the linear cost are the program's parameters.
    """
    n = len(cost)
    x = ca.MX.sym("x", n)
    given = families[0].function.numbers.numel() if families else 0
    p = ca.MX.sym("p", given + (n if given else 0))
    numbers = p[:given]
    matrix = linear.map.matrix(n)
    count = sum(f.count * len(f.function.rows) for f in families) + len(linear.labels)
    lam, sigma = ca.MX.sym("lam", count), ca.MX.sym("sigma")
    gradient = p[given:] / cost_scale if given else ca.MX(ca.DM(cost / cost_scale))
    objective = ca.dot(gradient, x)
    values, jacobian, hessian = [], _Parts(), _Parts()
    row = 0
    for family in families:
        made = (points or point_functions)(family)
        size, m = family.function.arguments.numel(), len(family.function.rows)
        big = ca.MX(family.map.matrix(n))
        z = ca.reshape(ca.mtimes(big, x) + ca.DM(family.offset), size, family.count)
        weights = ca.DM(family.weights / cost_scale).T
        block = lam[row : row + m * family.count]
        g, cost_here = _at_points(made["value"], family.count, z, numbers)
        values.append(ca.vec(g))
        objective = objective + ca.dot(weights, cost_here)
        slope = _at_points(made["slope"], family.count, z, numbers)
        gradient = gradient + ca.mtimes(big.T, ca.vec(slope * ca.repmat(weights, size, 1)))
        _add_jacobian(jacobian, family, made["jacobian"], (z, numbers), first=row)
        at_points = (z, numbers, ca.reshape(block, m, family.count), sigma * weights)
        _add_hessian(hessian, family, made["hessian"], at_points)
        row += m * family.count
    values.append(ca.mtimes(ca.MX(matrix), x))
    jacobian.source(ca.MX(1))
    jacobian.add(linear.map.rows + row, linear.map.columns, linear.map.values, np.full(len(linear.map.values), -1))
    g = ca.vertcat(*values)
    names = ["x", "p"]
    return NonlinearProgram(
        x,
        p,
        objective,
        g,
        ca.Function("nlp_grad_f", [x, p], [objective, gradient], names, ["f", "grad_f_x"]),
        ca.Function("nlp_jac_g", [x, p], [g, jacobian.assembled((count, n))], names, ["g", "jac_g_x"]),
        ca.Function(
            "nlp_hess_l",
            [x, p, sigma, lam],
            [hessian.assembled((n, n))],
            [*names, "lam_f", "lam_g"],
            ["triu_hess_gamma_x_x"],
        ),
        *row_bounds(families, linear),
        (*(label for f in families for label in f.count * [r.label for r in f.function.rows]), *linear.labels),
        np.concatenate([*(np.repeat(f.tau, len(f.function.rows)) for f in families), linear.tau]),
    )


def row_bounds(
    families: Sequence[Family], linear: Linear, problem: TrajectoryProblem | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper bounds of all rows, scaled: those of the rows, or in another problem of the same shape."""
    lower, upper = [], []
    for family in families:
        ranges = [(r.lower, r.upper) if problem is None else r.range_in(problem) for r in family.function.rows]
        scaled = [(low / r.scale, high / r.scale) for (low, high), r in zip(ranges, family.function.rows, strict=True)]
        lower.append(family.repeated([low for low, _ in scaled]))
        upper.append(family.repeated([high for _, high in scaled]))
    return np.concatenate([*lower, linear.lower]), np.concatenate([*upper, linear.upper])


def cost_of(family: Family, x: np.ndarray) -> float:
    """What a family adds to the cost at the solver's unknowns x."""
    if family.function.integrand is None:
        return 0.0
    z = family.function.arguments
    function = ca.Function("integrand", [z], [ca.SX(family.function.integrand)]).map(family.count)
    entries = family.map.values * x[family.map.columns]
    places = np.bincount(family.map.rows, weights=entries, minlength=len(family.offset)) + family.offset
    values = np.array(function(places.reshape(family.count, z.numel()).T)).ravel()
    return float(values @ family.weights)


def point_functions(family: Family) -> PointFunctions:
    """Constraints and integrand of one point, slope of the integrand, Jacobian, Hessian of the Lagrangian."""
    z, numbers, rows = family.function.arguments, family.function.numbers, family.function.rows
    g = ca.vertcat(ca.SX(0, 1), *[r.value / r.scale for r in rows])
    integrand = ca.SX(family.function.integrand) if family.function.integrand is not None else ca.SX(0)
    lam, sigma = ca.SX.sym("lam", g.numel()), ca.SX.sym("sigma")
    jacobian = ca.jacobian(g, z)
    slope = ca.densify(ca.gradient(integrand, z))
    full, _ = ca.hessian(ca.dot(lam, g) + sigma * integrand, z)
    made = {
        "value": ([z, numbers], [g, integrand]),
        "slope": ([z, numbers], [slope]),
        "jacobian": ([z, numbers], [jacobian]),
        "hessian": ([z, numbers, lam, sigma], [full]),
    }
    return {kind: ca.Function(f"{family.name}_{kind}", *signature) for kind, signature in made.items()}


def _at_points(function: ca.Function, count: int, z: Any, numbers: Any, *more: Any) -> Any:
    """The function at all points, whose columns stand side by side; the numbers are those of all."""
    if function.size2_in(0) == count:
        return function(z, numbers, *more)
    return function.map("points", "serial", count, [1], [])(z, numbers, *more)


def _pattern_of_point(function: ca.Function, count: int) -> ca.Sparsity:
    pattern = function.sparsity_out(0)
    return ca.horzsplit(pattern, pattern.size2() // count)[0] if function.size2_in(0) == count > 1 else pattern


def _add_jacobian(
    parts: _Parts, family: Family, function: ca.Function, arguments: Sequence[Any], *, first: int
) -> None:
    pattern = _pattern_of_point(function, family.count)
    if pattern.nnz() == 0 or family.count == 0:
        return
    local_rows, local_columns = (np.array(k) for k in pattern.get_triplet())
    size, m, count = pattern.size2(), pattern.size1(), family.count
    at = np.arange(count)[:, None]
    source, columns, values = family.map.expand((at * size + local_columns).ravel())
    rows = (first + at * m + local_rows).ravel()[source]
    parts.add(rows, columns, values, source)
    parts.source(_stacked(function, count, arguments))


def _add_hessian(parts: _Parts, family: Family, function: ca.Function, arguments: Sequence[Any]) -> None:
    pattern = _pattern_of_point(function, family.count)
    if pattern.nnz() == 0 or family.count == 0:
        return
    local_rows, local_columns = (np.array(k) for k in pattern.get_triplet())
    size, count = pattern.size1(), family.count
    at = np.arange(count)[:, None]
    source, rows, left = family.map.expand((at * size + local_rows).ravel())
    again, columns, right = family.map.expand((at * size + local_columns).ravel()[source])
    rows, left, source = rows[again], left[again], source[again]
    upper = rows <= columns
    parts.add(rows[upper], columns[upper], (left * right)[upper], source[upper])
    parts.source(_stacked(function, count, arguments))


def _stacked(function: ca.Function, count: int, arguments: Sequence[Any]) -> Any:
    """Nonzeros of all points below each other."""
    found = _at_points(function, count, *arguments).nz[:]
    return found if found.size2() == 1 else found.T  # the nonzeros of a row come as a row

"""Direct collocation: the equations of motion hold at the nodes of a scheme in every interval.

Unknowns are y and y' at the ends of the intervals and y'' at the collocation points, all by relative time, and
per collocation point the dependent coordinates z, the drives and what else the point has. Everything between them
is linear with constant coefficients (see `symscrew.optimisation.tableau`); the equations of motion and the
closure stand at the collocation points. Between them the motion is y's polynomial, and the configuration is
assembled from it: so loops are closed at all times, not at the points alone.
"""

from __future__ import annotations

from symscrew.optimisation.linear_rows import LinearRows
from symscrew.optimisation.point import collocation_point
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.rows import PointFunction
from symscrew.optimisation.sparse import Family
from symscrew.optimisation.tableau import tableau
from symscrew.optimisation.time_grid import TimeGrid, mesh_of
from symscrew.optimisation.transcription import Discretisation, Placer
from symscrew.optimisation.unknowns import Terms


class Collocation(Discretisation):
    """Builds the collocation of a model on its mesh."""

    def __init__(self, model: PointModel) -> None:
        given = model.problem.transcription
        mesh = mesh_of(given)
        self.scheme = tableau(given.method, given.degree, given.second_order)
        super().__init__(model, TimeGrid(mesh, self.scheme))

    def point_function(self) -> PointFunction:
        """The constraints and the integrand at a collocation point."""
        return collocation_point(self.model)

    def family(self) -> Family:
        """All collocation points: y and y' there from y_0, y'_0 and the y'' of the interval, u from control points."""
        known, scheme, grid = self.unknowns, self.scheme, self.grid
        n, points = grid.point_tau.shape
        place = Placer(self.function, n * points)
        terms = Terms(known)
        rows = {name: at.reshape(n, points, -1) for name, at in place.rows.items()}
        h = grid.steps[:, None, None]
        y, y_1, x = (known.index[name][:-1, None] for name in ("y", "y_1", "x"))
        terms.add(rows["y"], y)
        terms.add(rows["y"], y_1, h * scheme.nodes[:, None])
        terms.add(rows["y_1"], y_1)
        if "x" in rows:
            terms.add(rows["x"], x)
        for j in range(points):
            second = known.index["y_2"][:, j : j + 1]
            terms.add(rows["y"], second, h**2 * scheme.position[:, j, None])
            terms.add(rows["y_1"], second, h * scheme.rate[:, j, None])
            if "x" in rows:
                terms.add(rows["x"], known.index["x_1"][:, j : j + 1], h * scheme.rate[:, j, None])
            if "y_3" in rows:
                terms.add(rows["y_3"], second, scheme.slope()[:, j, None] / h)
            if "u" in rows:
                terms.add(rows["u"], known.index["u"][:, j : j + 1], scheme.control[:, j, None])
        place.add(terms, [name for name in known.index if name not in ("y", "y_1", "x", "u", "T", "p")])
        place.add_common(terms)
        weights = (grid.steps[:, None] * scheme.weights).ravel()
        return place.family("collocation", terms, grid.point_tau.ravel(), weights)

    def add_continuity(self, rows: LinearRows) -> None:
        """y, y' and x at the end of an interval are those at the start of the next one."""
        model, scheme, index = self.model, self.scheme, self.unknowns.index
        h, s, mesh = self.grid.steps[:, None], model.scales, self.grid.mesh
        y = rows.new([f"continuity of {label}" for label in model.equations.labels], mesh[1:])
        y_1 = rows.new([f"continuity of the rate of {label}" for label in model.equations.labels], mesh[1:])
        size, rate = 1 / s.y, 0.5 / s.y
        terms = rows.terms
        terms.add(y, index["y"][1:], size)
        terms.add(y, index["y"][:-1], -size)
        terms.add(y, index["y_1"][:-1], -h * size)
        terms.add(y_1, index["y_1"][1:], rate)
        terms.add(y_1, index["y_1"][:-1], -rate)
        for j in range(scheme.degree):
            terms.add(y, index["y_2"][:, j], -(h**2) * scheme.end_position[j] * size)
            terms.add(y_1, index["y_2"][:, j], -h * scheme.end_rate[j] * rate)
        if model.states:
            x = rows.new([f"continuity of the state {name}" for name in model.states], mesh[1:])
            terms.add(x, index["x"][1:], 1 / s.x)
            terms.add(x, index["x"][:-1], -1 / s.x)
            for j in range(scheme.degree):
                terms.add(x, index["x_1"][:, j], -h * scheme.end_rate[j] / s.x)

"""Multiple shooting: intervals of the forward dynamics, integrated by Runge-Kutta steps, joined by constraints.

Drives are constant in an interval. The independent coordinates are integrated; at every stage the configuration
is assembled from them by Newton steps, so that the loops are closed along the whole interval.
"""

from __future__ import annotations

from typing import Any

import casadi as ca

from symscrew.errors import DescriptionError
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.constraints import bound_rows, closure_rows
from symscrew.optimisation.linear_rows import LinearRows
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.objectives import integrand, objectives_by_type
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.rows import PointFunction, Row
from symscrew.optimisation.sparse import Family
from symscrew.optimisation.time_grid import TimeGrid, mesh_of
from symscrew.optimisation.transcription import Discretisation, Placer
from symscrew.optimisation.unknowns import Terms

# Newton steps to the configuration of a stage, from that of the stage before: errors 1e-2, 1e-4, 1e-8, 1e-16. A fixed
# number, since the solver needs one expression; with too few the loops stay open, which `errors.closure` shows.
NEWTON = 3


class Shooting(Discretisation):
    """Builds multiple shooting of a model on its mesh."""

    def __init__(self, model: PointModel) -> None:
        fits = all(made.shooting for made, _ in objectives_by_type(model))
        if not fits or model.problem.drive_rule != "free" or model.problem.via:
            raise DescriptionError(
                "transcription.method: shooting takes neither via conditions, a rule for the drives, nor the "
                "objectives energy and jerk; use collocation"
            )
        super().__init__(model, TimeGrid(mesh_of(model.problem.transcription), None))

    # -- one interval -----------------------------------------------------------------------------------------

    def point_function(self) -> PointFunction:
        """Blocks of an interval: its start, its drives, its end; rows: closure, bounds at the start, defects."""
        model, scales = self.model, self.model.scales
        start = point_symbols(model, moving=True)
        for name in ("y_2", "x_1"):
            start.pop(name, None)
        blocks = {**start, "step": ca.SX.sym("step")}
        blocks |= {f"next_{name}": ca.SX.sym(f"next_{name}", start[name].numel()) for name in ("y", "y_1", "x")}
        at = MotionQuantities(model, {**start, "y_2": ca.SX.zeros(model.d)})
        rows = [*closure_rows(at), *bound_rows(at)]
        end, cost = self._integrated(start, blocks["step"], at.q)
        labels = model.equations.labels
        for name, size, what in (("y", scales.y, ""), ("y_1", 2 * scales.y, "rate of ")):
            defect = end[name] - blocks[f"next_{name}"]
            rows += [
                Row(f"continuity of {what}{label}", defect[k], scale=float(size[k])) for k, label in enumerate(labels)
            ]
        for k, name in enumerate(model.states):
            rows.append(
                Row(f"continuity of the state {name}", (end["x"] - blocks["next_x"])[k], scale=float(scales.x[k]))
            )
        return PointFunction(blocks, tuple(rows), cost)

    def _integrated(self, start: dict[str, ca.SX], step: ca.SX, q: ca.SX) -> tuple[dict[str, Any], Any]:
        """The end of an interval by Runge-Kutta steps of order 4, and the mean of the integrand."""
        count = self.problem.transcription.degree
        h = step / count
        now = {name: start[name] for name in ("y", "y_1", "x")}
        place, cost = q, ca.SX(0)
        for k in range(count):
            slopes: list[dict[str, Any]] = []
            for c, weight in ((0.0, 1), (0.5, 2), (0.5, 2), (1.0, 1)):
                moved = {name: now[name] + c * h * slopes[-1][name] for name in now} if c else now
                place = self._assembled(place, moved["y"]) if (k or c) else place
                tau = start["tau"] + (k + c) * h
                slope, value = self._slope(start, moved, place, tau)
                slopes.append(slope)
                cost = cost + weight / (6.0 * count) * value
            a, b, e, f = slopes
            now = {name: now[name] + h / 6 * (a[name] + 2 * b[name] + 2 * e[name] + f[name]) for name in now}
        return now, cost

    def _slope(self, start: dict[str, ca.SX], moved: dict[str, Any], q: Any, tau: Any) -> tuple[dict[str, Any], Any]:
        model = self.model
        blocks = {**start, **moved, "tau": tau, "y_2": ca.SX.zeros(model.d)}
        blocks["z"] = q[list(model.equations.layout.z)]
        at = MotionQuantities(model, blocks)
        found = symbolic_outputs(model.equations.forward, at.known)
        slope = {"y": moved["y_1"], "y_1": found["y_ddot"] * at.T**2, "x": found["x_dot"] * at.T}
        return slope, integrand(at)[0]  # those whose terms need rows of their own are refused above

    def _assembled(self, q: Any, y: Any) -> Any:
        model = self.model
        if not model.equations.layout.z:
            return y
        parameters = (
            MotionQuantities(model, point_symbols(model, moving=False)).known["p"] if not model.design else None
        )
        if parameters is None:
            raise DescriptionError("transcription.method: shooting takes no design parameters; use collocation")
        for _ in range(NEWTON):
            q = symbolic_outputs(model.equations.move, {"q": q, "y": y, "p": parameters})["q_next"]
        return q

    def family(self) -> Family:
        """All intervals: a point of the family is an interval with both its ends."""
        known, steps = self.unknowns, self.grid.steps
        place = Placer(self.function, len(steps))
        terms = Terms(known)
        for name in ("y", "y_1", "x"):
            if name in place.rows:
                terms.add(place.rows[name], known.index[name][:-1])
                terms.add(place.rows[f"next_{name}"], known.index[name][1:])
        place.add(terms, ("z", "u"))
        place.add_common(terms)
        family = place.family("shooting", terms, self.grid.mesh[:-1], steps)
        family.offset[place.rows["step"][:, 0]] = steps
        return family

    def add_continuity(self, rows: LinearRows) -> None:
        """None: continuity is not linear here and stands in the family."""

"""Multiple shooting: intervals of the forward dynamics, integrated by Runge-Kutta steps, joined by constraints.

Drives are constant in an interval. The independent coordinates are integrated; at every stage the configuration
is assembled from them by Newton steps, so that the loops are closed along the whole interval.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError
from symscrew.optimisation.casadi_graph import run
from symscrew.optimisation.layout import Terms
from symscrew.optimisation.point import PointModel
from symscrew.optimisation.rows import PointFunction, Row
from symscrew.optimisation.sparse import Family
from symscrew.optimisation.tableau import Tableau
from symscrew.optimisation.transcription import Collocation, LinearRows, Placer

if TYPE_CHECKING:
    from symscrew.optimisation.result import Trajectory

NEWTON = 3  # from the stage before, a step apart: errors 1e-2, 1e-4, 1e-8, 1e-16


class Shooting(Collocation):
    """Builds multiple shooting of a model on its mesh."""

    def __init__(self, model: PointModel) -> None:
        unfit = {"energy", "jerk"} & set(model.kinds)
        if unfit or model.problem.drive_rule != "free" or model.problem.via:
            raise DescriptionError(
                "transcription.method: shooting takes neither via conditions, a rule for the drives, nor the "
                "objectives energy and jerk; use collocation"
            )
        super().__init__(model)

    def _scheme(self) -> Tableau:
        return None  # type: ignore[return-value]

    def _linear_rows(self) -> LinearRows:
        return _ShootingRows(self)

    # -- one interval -----------------------------------------------------------------------------------------

    def _function(self) -> PointFunction:
        """Blocks of an interval: its start, its drives, its end; rows: closure, bounds at the start, defects."""
        model, scales = self.model, self.model.scales
        start = model.blocks(moving=True)
        for name in ("y_2", "x_1"):
            start.pop(name, None)
        blocks = {**start, "step": ca.SX.sym("step")}
        blocks |= {f"next_{name}": ca.SX.sym(f"next_{name}", start[name].numel()) for name in ("y", "y_1", "x")}
        at = model.state({**start, "y_2": ca.SX.zeros(model.d)})
        rows = [*at.closure_rows(), *at.bound_rows()]
        integrand_rows: list[Row] = []
        end, cost = self._integrated(start, blocks["step"], at.q, integrand_rows)
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

    def _integrated(
        self, start: dict[str, ca.SX], step: ca.SX, q: ca.SX, rows: list[Row]
    ) -> tuple[dict[str, Any], Any]:
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
                slope, value = self._slope(start, moved, place, tau, rows)
                slopes.append(slope)
                cost = cost + weight / (6.0 * count) * value
            a, b, e, f = slopes
            now = {name: now[name] + h / 6 * (a[name] + 2 * b[name] + 2 * e[name] + f[name]) for name in now}
        return now, cost

    def _slope(
        self, start: dict[str, ca.SX], moved: dict[str, Any], q: Any, tau: Any, rows: list[Row]
    ) -> tuple[dict[str, Any], Any]:
        model = self.model
        blocks = {**start, **moved, "tau": tau, "y_2": ca.SX.zeros(model.d)}
        blocks["z"] = q[list(model.equations.layout.z)]
        at = model.state(blocks)
        found = run(model.equations.forward, at.known)
        slope = {"y": moved["y_1"], "y_1": found["y_ddot"] * at.T**2, "x": found["x_dot"] * at.T}
        return slope, at.integrand(rows)

    def _assembled(self, q: Any, y: Any) -> Any:
        model = self.model
        if not model.equations.layout.z:
            return y
        parameters = model.state(model.blocks(moving=False)).known["p"] if not model.design else None
        if parameters is None:
            raise DescriptionError("transcription.method: shooting takes no design parameters; use collocation")
        for _ in range(NEWTON):
            q = run(model.equations.move, {"q": q, "y": y, "p": parameters})["q_next"]
        return q

    def _family(self) -> Family:
        known = self.unknowns
        place = Placer(self.function, len(self.steps))
        terms = Terms(known)
        for name in ("y", "y_1", "x"):
            if name in place.rows:
                terms.add(place.rows[name], known.index[name][:-1])
                terms.add(place.rows[f"next_{name}"], known.index[name][1:])
        for name in ("z", "u"):
            if name in place.rows:
                terms.add(place.rows[name], known.index[name][:, 0])
        place.common(terms)
        family = place.family("shooting", terms, self.mesh[:-1], self.steps)
        family.offset[place.rows["step"][:, 0]] = self.steps
        return family


class _ShootingRows(LinearRows):
    """The linear constraints of shooting: continuity stands in the intervals."""

    def _continuity(self) -> None:
        return


def dense(trajectory: Trajectory, k: np.ndarray, s: np.ndarray) -> dict[str, np.ndarray]:
    """Unknowns of points at parts s (n,) of the intervals k (n,): quintic through y, y', y'' at both ends."""
    arrays, mesh = trajectory.arrays, trajectory.transcribed.mesh
    h, s = np.diff(mesh)[k][:, None], s[:, None]
    left, right = _ends(trajectory)
    a, b = arrays["y_1"][k] * h, arrays["y_1"][k + 1] * h
    c, d = left[k] * h**2, right[k] * h**2
    rise = arrays["y"][k + 1] - arrays["y"][k]
    c3 = 10 * rise - 6 * a - 4 * b - 1.5 * c + 0.5 * d
    c4 = -15 * rise + 8 * a + 7 * b + 1.5 * c - d
    c5 = 6 * rise - 3 * (a + b) - 0.5 * c + 0.5 * d
    return {
        "y": arrays["y"][k] + s * (a + s * (c / 2 + s * (c3 + s * (c4 + s * c5)))),
        "y_1": (a + s * (c + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h,
        "y_2": (c + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / h**2,
        "u": arrays["u"][k, 0],
        "x": arrays["x"][k] + s * (arrays["x"][k + 1] - arrays["x"][k]),
        "x_1": (arrays["x"][k + 1] - arrays["x"][k]) / h,
    }


def _ends(trajectory: Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """y'' by forward dynamics at start and end of every interval, with its drives: (n, d) each."""
    cache = trajectory.__dict__.setdefault("_shooting_ends", {})
    if "ends" not in cache:
        model, arrays = trajectory.model, trajectory.arrays
        blocks = model.blocks(moving=True)
        at = model.state(blocks)
        order = ("y", "y_1", "z", "u", "x", "T", "p", "tau")
        function = ca.Function(
            "ends", [blocks[name] for name in order], [run(model.equations.forward, at.known)["y_ddot"] * at.T**2]
        )
        n, mesh = len(arrays["u"]), trajectory.transcribed.mesh
        layout = list(model.equations.layout.z)
        start_z = arrays["z"][:, 0]
        q0 = np.array(trajectory._closure(*trajectory._with_parameters(arrays["y"][:-1], start_z))[0]).T
        end_q, _ = zip(*[_next(trajectory, arrays["y"][j + 1], q0[j]) for j in range(n)], strict=True)
        ends = []
        for shift, z in ((0, start_z), (1, np.array(end_q)[:, layout])):
            T = np.full((1, n), trajectory.duration) if "T" in arrays else np.zeros((0, n))
            p = np.repeat(arrays["p"][:, None], n, 1) if "p" in arrays else np.zeros((0, n))
            pick = slice(shift, n + shift)
            values = [arrays["y"][pick].T, arrays["y_1"][pick].T, z.T, arrays["u"][:, 0].T, arrays["x"][pick].T]
            ends.append(np.array(function.map(n)(*values, T, p, mesh[pick][None])).T)
        cache["ends"] = tuple(ends)
    return cache["ends"]


def _next(trajectory: Trajectory, y: np.ndarray, near: np.ndarray) -> tuple[np.ndarray, bool]:
    found = trajectory.kinematics.assemble(y, near)
    return (near, False) if found is None else (found, True)

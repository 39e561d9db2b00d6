"""Direct collocation: from a problem at a point to a sparse nonlinear program.

Unknowns are y and y' at the ends of the intervals and y'' at the collocation points, all by relative time, and
per collocation point the dependent coordinates z, the drives and what else the point has. Everything between them
is linear with constant coefficients (see `symscrew.optimisation.tableau`); the equations of motion and the
closure stand at the collocation points. Between them the motion is y's polynomial, and the configuration is
assembled from it: so loops are closed at all times, not at the points alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.optimisation.layout import Terms, Unknowns
from symscrew.optimisation.point import collocation_point, observation_point
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions
from symscrew.optimisation.rows import PointFunction
from symscrew.optimisation.sparse import Family, Linear, SparseMap
from symscrew.optimisation.tableau import Tableau, tableau


@dataclass(frozen=True)
class Transcribed:
    """A problem as families of points, linear constraints and linear costs over named unknowns.

    `mesh` (n + 1,): ends of the intervals in relative time; `scheme`: the collocation, None for shooting.
    """

    unknowns: Unknowns
    families: tuple[Family, ...]
    linear: Linear
    cost: np.ndarray
    mesh: np.ndarray
    scheme: Tableau | None
    model: PointModel

    @property
    def point_tau(self) -> np.ndarray:
        """Times of the points at which drives are unknowns: (intervals, points), relative."""
        if self.scheme is None:
            return self.mesh[:-1, None]
        return self.mesh[:-1, None] + np.diff(self.mesh)[:, None] * self.scheme.nodes


def mesh_of(model: PointModel) -> np.ndarray:
    """Ends of the intervals as parts of the duration, 0 and 1 included."""
    given = model.problem.transcription
    if given.mesh:
        if abs(given.mesh[-1] - 1.0) > 1e-12 or given.mesh[0] <= 0:
            raise DescriptionError("transcription.mesh: expected ends of intervals above 0, the last one 1")
        return np.array([0.0, *given.mesh])
    return np.linspace(0.0, 1.0, given.intervals + 1)


class Collocation:
    """Builds the collocation of a model on its mesh."""

    def __init__(self, model: PointModel) -> None:
        self.model, self.problem = model, model.problem
        self.mesh = mesh_of(model)
        self.steps = np.diff(self.mesh)
        self.unknowns = Unknowns()
        self.scheme = self._scheme()
        nodes = self.scheme.nodes if self.scheme else np.zeros(1)  # shooting has no scheme
        self.point_tau = self.mesh[:-1, None] + self.steps[:, None] * nodes
        self.function = self._function()

    def transcribed(self) -> Transcribed:
        """The transcription."""
        self._unknowns()
        families = (self._family(), *self._observation_families())
        linear = self._linear_rows().linear()
        return Transcribed(self.unknowns, families, linear, self.linear_cost(), self.mesh, self.scheme, self.model)

    def _scheme(self) -> Tableau:
        given = self.problem.transcription
        return tableau(given.method, given.degree, given.second_order)

    def _function(self) -> PointFunction:
        return collocation_point(self.model)

    def _linear_rows(self) -> LinearRows:
        return LinearRows(self)

    def linear_cost(self) -> np.ndarray:
        """What objectives add to the cost linearly in the unknowns: duration, peak."""
        cost = np.zeros(self.unknowns.size)
        for objective in self.problem.objectives:
            if objective.type == "time":
                at = self.unknowns.index["T"][0]
                cost[at] += objective.weight * self.unknowns.scale[at]
            if objective.type == "peak":
                at = self.unknowns.index["peak"][0]
                cost[at] += objective.weight * self.unknowns.scale[at]
        return cost

    # -- unknowns --------------------------------------------------------------------------------------------

    def _unknowns(self) -> None:
        model, s, known = self.model, self.model.scales, self.unknowns
        labels = list(model.equations.labels)
        size = {"y_2": 4 * s.y, "z": s.z, "u": s.u, "positive_power": s.u * model.system.length / s.duration,
                "distribution": np.ones(model.d), "x_1": s.x}  # fmt: skip
        names = {
            "y_2": [f"second rate of {label}" for label in labels],
            "z": [f"coordinate {model.system.tree.q[k].label}" for k in model.equations.layout.z],
            "u": [f"drive {label}" for label in model.drive_labels],
            "positive_power": [f"positive power of {label}" for label in model.drive_labels],
            "distribution": [f"distribution of drives {k + 1}" for k in range(model.d)],
            "x_1": [f"rate of the state {name}" for name in model.states],
        }
        known.add("y", self.mesh, [f"coordinate {label}" for label in labels], s.y)
        known.add("y_1", self.mesh, [f"rate of {label}" for label in labels], 2 * s.y)
        known.add("x", self.mesh, [f"state {name}" for name in model.states], s.x)
        for name in names:
            if name in self.function.blocks:
                known.add(name, self.point_tau, names[name], size[name])
        self._bounds()
        self._global()

    def _bounds(self) -> None:
        model, known = self.model, self.unknowns
        for k, label in enumerate(model.drive_labels):
            known.bound(known.index["u"][..., k], *model.drive_range(label))
        if "positive_power" in known.index:
            known.bound(known.index["positive_power"], 0.0, np.inf)
        for name, tau, c in (("start", 0, self.problem.start), ("end", -1, self.problem.end)):
            for k, label in enumerate(model.equations.labels):
                if label in c.coordinates:
                    value = c.coordinates[label]
                    low, high = self.problem.bounds.joints.get(label, (-np.inf, np.inf))
                    if not low <= value <= high:
                        raise DescriptionError(
                            f"{name}.coordinates: {label} = {value:g} contradicts its bounds {low:g} to {high:g}"
                        )
                    known.bound(known.index["y"][tau, k], value, value)
                if c.at_rest or c.rates.get(label) == 0.0:
                    known.bound(known.index["y_1"][tau, k], 0.0, 0.0)
        if model.states and not self.problem.periodic:
            for k, state in enumerate(model.equations.acting.states):
                known.bound(known.index["x"][0, k], state.initial, state.initial)

    def _global(self) -> None:
        model, known, problem = self.model, self.unknowns, self.problem
        if isinstance(problem.duration, tuple):
            known.add("T", np.zeros(()), ["duration"], np.array([model.scales.duration]))
            known.bound(known.index["T"], *problem.duration)
        if model.design:
            values = {p.name: float(p.value) for p in model.system.mechanism.parameters.values()}
            sizes = [max(abs(values[n]), max(map(abs, problem.design[n])) * 1e-3) or 1.0 for n in model.design]
            known.add("p", np.zeros(()), [f"parameter {n}" for n in model.design], np.array(sizes))
            for k, name in enumerate(model.design):
                known.bound(known.index["p"][k], *problem.design[name])
        if "peak" in model.kinds:
            weights = next(o for o in problem.objectives if o.type == "peak").weights
            largest = max(
                s / weights.get(label, 1.0) for label, s in zip(model.drive_labels, model.scales.u, strict=True)
            )
            known.add("peak", np.zeros(()), ["peak of the drives"], np.array([largest]))

    # -- families ----------------------------------------------------------------------------------------------

    def _family(self) -> Family:
        known, scheme = self.unknowns, self.scheme
        n, points = self.point_tau.shape
        place = Placer(self.function, n * points)
        terms = Terms(known)
        rows = {name: at.reshape(n, points, -1) for name, at in place.rows.items()}
        h = self.steps[:, None, None]
        y, y_1, x = known.index["y"][:-1, None], known.index["y_1"][:-1, None], known.index["x"][:-1, None]
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
        for name in ("y_2", "z", "positive_power", "distribution", "x_1"):
            if name in rows:
                terms.add(rows[name], known.index[name])
        place.common(terms)
        weights = (self.steps[:, None] * scheme.weights).ravel()
        return place.family("collocation", terms, self.point_tau.ravel(), weights)

    def _observation_families(self) -> list[Family]:
        linear = set(self.model.equations.labels)
        found = []
        given = [("the start", 0.0, self.problem.start), ("the end", 1.0, self.problem.end)]
        given += [(f"via point {k + 1}", float(c.time or 0), c) for k, c in enumerate(self.problem.via)]
        for k, (where, tau, c) in enumerate(given):
            placed = (c.platform_normal, c.platform_position, c.platform_rotation)
            if set(c.coordinates) <= linear and set(c.rates) <= linear and not c.points and placed == (None,) * 3:
                continue
            found.append(self._observation(observation_point(self.model, c, where), tau, f"observed_{k}", where))
        return found

    def _observation(self, function: PointFunction, tau: float, name: str, where: str) -> Family:
        known, model = self.unknowns, self.model
        labels = [f"coordinate {model.system.tree.q[k].label} at {where}" for k in model.equations.layout.z]
        known.add(name, np.array([tau]), labels, model.scales.z)
        place, terms = Placer(function, 1), Terms(known)
        for block, order in (("y", 0), ("y_1", 1)):
            self.interpolated(terms, place.rows[block][0], tau, order)
        terms.add(place.rows["z"], known.index[name])
        place.common(terms)
        return place.family(name, terms, np.array([tau]), np.zeros(1))

    def interpolated(self, terms: Terms, rows: np.ndarray, tau: float, order: int) -> None:
        """Add y (order 0) or y' (order 1) at a relative time to `rows`."""
        known, scheme = self.unknowns, self.scheme
        k = min(int(np.searchsorted(self.mesh, tau, side="right")) - 1, len(self.steps) - 1)
        h = self.steps[k]
        s = np.array([(tau - self.mesh[k]) / h])
        if tau <= 0.0 or tau >= 1.0:
            terms.add(rows, known.index["y" if order == 0 else "y_1"][0 if tau <= 0.0 else -1])
            return
        if order == 0:
            terms.add(rows, known.index["y"][k])
            terms.add(rows, known.index["y_1"][k], h * s[0])
            factors = h**2 * scheme.position_at(s)[0]
        else:
            terms.add(rows, known.index["y_1"][k])
            factors = h * scheme.rate_at(s)[0]
        for j, factor in enumerate(factors):
            terms.add(rows, known.index["y_2"][k, j], factor)


class Placer:
    """Rows of a family's map, block by block, for a number of points."""

    def __init__(self, function: PointFunction, count: int) -> None:
        self.function, self.count = function, count
        self.size = function.arguments.numel()
        self.rows: dict[str, np.ndarray] = {}
        at = 0
        for name, symbol in function.blocks.items():
            width = symbol.numel()
            if width:
                self.rows[name] = np.arange(count)[:, None] * self.size + at + np.arange(width)
            elif name == "z":
                self.rows[name] = np.zeros((count, 0), int)
            at += width

    def common(self, terms: Terms) -> None:
        """Duration and parameters."""
        for name in ("T", "p"):
            if name in self.rows:
                terms.add(self.rows[name], terms.unknowns.index[name])

    def family(self, name: str, terms: Terms, tau: np.ndarray, weights: np.ndarray) -> Family:
        """The family with its map."""
        offset = np.zeros(self.count * self.size)
        offset[self.rows["tau"][:, 0]] = tau
        entries = SparseMap.of(*terms.entries(), self.count * self.size)
        return Family(name, self.function, self.count, entries, offset, weights, tau)


class LinearRows:
    """Collects the linear constraints: continuity, conditions on y, rates of drives, peaks, periodicity."""

    def __init__(self, collocation: Collocation) -> None:
        self.of, self.known = collocation, collocation.unknowns
        self.terms = Terms(self.known)
        self.lower: list[np.ndarray] = []
        self.upper: list[np.ndarray] = []
        self.labels: list[str] = []
        self.tau: list[np.ndarray] = []
        self.count = 0

    def new(
        self, labels: Sequence[str], tau: np.ndarray | float, lower: object = 0.0, upper: object = 0.0
    ) -> np.ndarray:
        """Row numbers (times, labels) of new constraints."""
        times = np.atleast_1d(np.asarray(tau, dtype=float))
        shape = (len(times), len(labels))
        rows = self.count + np.arange(shape[0] * shape[1]).reshape(shape)
        self.count += rows.size
        for store, value in ((self.lower, lower), (self.upper, upper)):
            store.append(np.broadcast_to(np.asarray(value, dtype=float), shape).ravel())
        self.labels += list(labels) * len(times)
        self.tau.append(np.repeat(times, len(labels)))
        return rows

    def linear(self) -> Linear:
        """All of them."""
        self._continuity()
        self._conditions()
        self._drive_rates()
        self._peak()
        self._jerk()
        if self.of.problem.periodic:
            self._periodic()
        rows, columns, values = self.terms.entries()
        none = [np.zeros(0)]
        return Linear(
            SparseMap.of(rows, columns, values, self.count),
            np.concatenate([*none, *self.lower]),
            np.concatenate([*none, *self.upper]),
            tuple(self.labels),
            np.concatenate([*none, *self.tau]),
        )

    def _continuity(self) -> None:
        of, index, scheme = self.of, self.known.index, self.of.scheme
        h, s = of.steps[:, None], of.model.scales
        labels = of.model.equations.labels
        y = self.new([f"continuity of {label}" for label in labels], of.mesh[1:])
        y_1 = self.new([f"continuity of the rate of {label}" for label in labels], of.mesh[1:])
        size, rate = 1 / s.y, 0.5 / s.y
        self.terms.add(y, index["y"][1:], size)
        self.terms.add(y, index["y"][:-1], -size)
        self.terms.add(y, index["y_1"][:-1], -h * size)
        self.terms.add(y_1, index["y_1"][1:], rate)
        self.terms.add(y_1, index["y_1"][:-1], -rate)
        for j in range(scheme.degree):
            self.terms.add(y, index["y_2"][:, j], -(h**2) * scheme.end_position[j] * size)
            self.terms.add(y_1, index["y_2"][:, j], -h * scheme.end_rate[j] * rate)
        if of.model.states:
            x = self.new([f"continuity of the state {name}" for name in of.model.states], of.mesh[1:])
            self.terms.add(x, index["x"][1:], 1 / s.x)
            self.terms.add(x, index["x"][:-1], -1 / s.x)
            for j in range(scheme.degree):
                self.terms.add(x, index["x_1"][:, j], -h * scheme.end_rate[j] / s.x)

    def _conditions(self) -> None:
        of, problem = self.of, self.of.problem
        given: list[tuple[str, float, Conditions]] = [("the start", 0.0, problem.start), ("the end", 1.0, problem.end)]
        given += [(f"via point {k + 1}", float(c.time or 0), c) for k, c in enumerate(problem.via)]
        for where, tau, c in given:
            inside = 0 < tau < 1
            for k, label in enumerate(of.model.equations.labels):
                pick = slice(k, k + 1)
                if inside and label in c.coordinates:
                    row = self.new([f"{label} at {where}"], tau, c.coordinates[label], c.coordinates[label])
                    self._at(row, pick, tau, 0)
                value = 0.0 if c.at_rest else c.rates.get(label)
                if value is not None and (inside or value != 0.0):
                    self._rate_condition(label, where, pick, tau, value)

    def _rate_condition(self, label: str, where: str, pick: slice, tau: float, value: float) -> None:
        """y' - value T = 0."""
        duration = self.of.problem.duration
        fixed = value * duration if not isinstance(duration, tuple) else 0.0
        row = self.new([f"rate of {label} at {where}"], tau, fixed, fixed)
        self._at(row, pick, tau, 1)
        if isinstance(duration, tuple) and value:
            self.terms.add(row, self.known.index["T"], -value)

    def _at(self, row: np.ndarray, pick: slice, tau: float, order: int) -> None:
        every = Terms(self.known)
        count = self.of.model.d
        self.of.interpolated(every, np.arange(count), tau, order)
        rows, columns, values = every.entries()
        chosen = rows == pick.start
        self.terms.rows.append(np.full(int(chosen.sum()), int(row[0, 0])))
        self.terms.columns.append(columns[chosen])
        self.terms.values.append(values[chosen])

    def _drive_rates(self) -> None:
        """Rates of the drives' polynomials by their control points; no jumps between intervals."""
        model, scheme = self.of.model, self.of.scheme
        for k, label in enumerate(model.drive_labels):
            if label not in self.of.problem.bounds.drive_rates:
                continue
            u = self.known.index["u"][..., k]
            if scheme is None or scheme.degree == 1:
                gaps = np.diff(self.of.point_tau[:, 0])
                self._steps(label, u[:-1, 0], u[1:, 0], gaps, self.of.point_tau[1:, 0], model.scales.u[k])
                continue
            for j in range(scheme.degree - 1):
                gaps = self.of.steps / (scheme.degree - 1)
                self._steps(label, u[:, j], u[:, j + 1], gaps, self.of.point_tau[:, j + 1], model.scales.u[k])
            row = self.new([f"no jump of drive {label}"], self.of.mesh[1:-1])
            self.terms.add(row[:, 0], u[1:, 0], 1 / model.scales.u[k])
            self.terms.add(row[:, 0], u[:-1, -1], -1 / model.scales.u[k])

    def _steps(
        self, label: str, first: np.ndarray, last: np.ndarray, gaps: np.ndarray, tau: np.ndarray, size: float
    ) -> None:
        """lower gap T <= last - first <= upper gap T."""
        duration = self.of.problem.duration
        for sign, limit in zip((1, -1), self.of.problem.bounds.drive_rates[label], strict=True):
            if not np.isfinite(limit):
                continue
            fixed = 0.0 if isinstance(duration, tuple) else (limit * gaps * duration / size)[:, None]
            low, high = (fixed, np.inf) if sign > 0 else (-np.inf, fixed)
            row = self.new([f"rate of drive {label}"], tau, low, high)
            self.terms.add(row[:, 0], last, 1 / size)
            self.terms.add(row[:, 0], first, -1 / size)
            if isinstance(duration, tuple):
                self.terms.add(row[:, 0], self.known.index["T"][0], -limit * gaps / size)

    def _peak(self) -> None:
        model = self.of.model
        if "peak" not in self.known.index:
            return
        weights = next(o for o in self.of.problem.objectives if o.type == "peak").weights
        tau = self.of.point_tau.ravel()
        for k, label in enumerate(model.drive_labels):
            u, size = self.known.index["u"][..., k].ravel(), 1.0 / model.scales.u[k]
            weight = weights.get(label, 1.0)
            for sign in (1.0, -1.0):
                row = self.new([f"peak of drive {label}"], tau, 0.0, np.inf)
                self.terms.add(row, self.known.index["peak"], weight * size)
                self.terms.add(row[:, 0], u, -sign * size)

    def _jerk(self) -> None:
        """Continuous second rates, where their slope is what the cost looks at."""
        if "jerk" not in self.of.model.kinds:
            return
        scheme, y_2 = self.of.scheme, self.known.index["y_2"]
        at = scheme.basis(np.array([0.0, 1.0]))
        labels = [f"continuity of the second rate of {label}" for label in self.of.model.equations.labels]
        rows = self.new(labels, self.of.mesh[1:-1])
        for j in range(scheme.degree):
            self.terms.add(rows, y_2[:-1, j], at[1, j] / (4 * self.of.model.scales.y))
            self.terms.add(rows, y_2[1:, j], -at[0, j] / (4 * self.of.model.scales.y))

    def _periodic(self) -> None:
        index, model = self.known.index, self.of.model
        for name, what in (("y", ""), ("y_1", "rate of ")):
            rows = self.new([f"periodicity of {what}{label}" for label in model.equations.labels], 1.0)
            self.terms.add(rows[0], index[name][-1])
            self.terms.add(rows[0], index[name][0], -1.0)
        if model.states:
            rows = self.new([f"periodicity of the state {name}" for name in model.states], 1.0)
            self.terms.add(rows[0], index["x"][-1])
            self.terms.add(rows[0], index["x"][0], -1.0)

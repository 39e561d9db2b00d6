"""From a problem at a point to a sparse nonlinear program: what all transcriptions share.

    PointModel + TimeGrid --> unknowns, a family of points with the dynamics, families where conditions are observed,
    linear constraints, linear cost

A transcription says what its main family of points is (`symscrew.optimisation.collocation`,
`symscrew.optimisation.shooting`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.optimisation.linear_constraints import add_conditions, add_drive_rates, add_periodicity
from symscrew.optimisation.linear_rows import LinearRows
from symscrew.optimisation.objectives import objectives_by_type
from symscrew.optimisation.point import observation_point
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import TrajectoryProblem, fixed_duration
from symscrew.optimisation.rows import PointFunction
from symscrew.optimisation.sparse import Family, Linear, SparseMap
from symscrew.optimisation.tableau import Tableau
from symscrew.optimisation.time_grid import TimeGrid
from symscrew.optimisation.unknowns import Terms, UnknownGroup, Unknowns

# IPOPT widens bounds by 1e-8 of their size, or of a scaled unknown's, and may stop there; a tenth more is for rounding.
RELAXED = 1.1e-8


@dataclass(frozen=True)
class Transcribed:
    """A problem as families of points, linear constraints and linear costs over named unknowns; dynamics come first.

    `cost` (unknowns,) is what objectives count linearly, in the solver's unknowns; `free` are the unknowns without the
    bounds of the problem; `numbers` are the values of the symbols in the families' functions, mostly none.
    """

    unknowns: Unknowns
    free: Unknowns
    families: tuple[Family, ...]
    linear: Linear
    cost: np.ndarray
    grid: TimeGrid
    model: PointModel
    numbers: np.ndarray

    def settled(self) -> Transcribed:
        """The same with the problem's numbers put into the functions of the points."""
        families = tuple(replace(f, function=f.function.settled(self.numbers.tolist())) for f in self.families)
        return replace(self, families=families, numbers=np.zeros(0)) if len(self.numbers) else self

    @property
    def mesh(self) -> np.ndarray:
        """Ends of the intervals in relative time: (intervals + 1,)."""
        return self.grid.mesh

    @property
    def scheme(self) -> Tableau | None:
        """The collocation, None for shooting."""
        return self.grid.scheme

    @property
    def point_tau(self) -> np.ndarray:
        """Times of the points at which drives are unknowns: (intervals, points), relative."""
        return self.grid.point_tau


class Discretisation(ABC):
    """Builds a transcription of a model on a grid; `function` is what holds at a point of the main family."""

    def __init__(self, model: PointModel, grid: TimeGrid) -> None:
        self.model, self.problem, self.grid = model, model.problem, grid
        self.unknowns = Unknowns()
        self.function = self.point_function()

    @abstractmethod
    def point_function(self) -> PointFunction:
        """What holds at every point of the main family."""

    @abstractmethod
    def family(self) -> Family:
        """The points at which the dynamics hold."""

    @abstractmethod
    def add_continuity(self, rows: LinearRows) -> None:
        """Linear constraints that join the intervals; none where they stand in the family."""

    def transcribed(self) -> Transcribed:
        """The transcription."""
        self._add_unknowns()
        families = (self.family(), *self._observation_families())
        free = self.unknowns.copy()
        bound_by_problem(self.unknowns, self.model, self.problem)
        rows = LinearRows(self.model, self.grid, self.unknowns)
        self.add_continuity(rows)
        add_conditions(rows)
        add_drive_rates(rows)
        for made, objective in objectives_by_type(self.model):
            made.linear(rows, objective)
        add_periodicity(rows)
        numbers = self.model.numbers
        values = np.zeros(0)
        if numbers is not None:  # all have been asked for by now
            values, symbols = numbers.values(self.problem), numbers.vector
            families = tuple(replace(f, function=replace(f.function, numbers=symbols)) for f in families)
        cost = linear_cost(self.unknowns, self.model, self.problem)
        return Transcribed(self.unknowns, free, families, rows.linear(), cost, self.grid, self.model, values)

    # -- unknowns --------------------------------------------------------------------------------------------

    def _add_unknowns(self) -> None:
        model, known, mesh = self.model, self.unknowns, self.grid.mesh
        labels = model.equations.labels
        known.add("y", mesh, [f"coordinate {label}" for label in labels], model.scales.y)
        known.add("y_1", mesh, [f"rate of {label}" for label in labels], 2 * model.scales.y)
        known.add("x", mesh, [f"state {name}" for name in model.states], model.scales.x)
        for group in self._groups():
            if group.name in self.function.blocks:
                known.add(group.name, self.grid.point_tau, group.labels, group.size)
                known.bound(known.index[group.name], group.lower, group.upper)
        self._add_whole_unknowns()

    def _groups(self) -> list[UnknownGroup]:
        """What may be unknown at the points; what is depends on the blocks of the point's function."""
        model, s = self.model, self.model.scales
        labels, tree = model.equations.labels, model.system.tree
        return [
            # a motion through its span and back in the duration has second rates of some four times the span
            UnknownGroup("y_2", [f"second rate of {label}" for label in labels], 4 * s.y),
            UnknownGroup("z", [f"coordinate {tree.q[k].label}" for k in model.equations.layout.z], s.z),
            UnknownGroup("u", [f"drive {label}" for label in model.drive_labels], s.u),
            *(group for made, _ in objectives_by_type(model) for group in made.unknowns(model)),
            UnknownGroup("distribution", [f"distribution of drives {k + 1}" for k in range(model.d)], np.ones(model.d)),
            UnknownGroup("x_1", [f"rate of the state {name}" for name in model.states], s.x),
        ]

    def _add_whole_unknowns(self) -> None:
        model, known, problem = self.model, self.unknowns, self.problem
        once = np.zeros(())
        if isinstance(problem.duration, tuple):
            known.add("T", once, ["duration"], np.array([model.scales.duration]))
        if model.design:
            values = {p.name: float(p.value) for p in model.system.mechanism.parameters.values()}
            sizes = [max(abs(values[n]), max(map(abs, problem.design[n])) * 1e-3) or 1.0 for n in model.design]
            known.add("p", once, [f"parameter {n}" for n in model.design], np.array(sizes))
        for made, objective in objectives_by_type(model):
            if made.whole:
                known.add(made.whole.name, once, [made.whole.label], np.array([made.whole.size(model, objective)]))

    # -- where conditions are observed -------------------------------------------------------------------------

    def _observation_families(self) -> list[Family]:
        linear = set(self.model.equations.labels)
        found = []
        given = [("the start", 0.0, self.problem.start), ("the end", 1.0, self.problem.end)]
        given += [(f"via point {k + 1}", float(c.time or 0), c) for k, c in enumerate(self.problem.via)]
        for k, (where, tau, c) in enumerate(given):
            placed = (c.platform_normal, c.platform_position, c.platform_rotation)
            starting = k == 0 and starts_with_motion(self.model, self.problem)
            plain = set(c.coordinates) <= linear and set(c.rates) <= linear and not c.points
            if plain and placed == (None,) * 3 and not starting:
                continue  # linear constraints and bounds say it all
            function = observation_point(self.model, c, where, starting=starting)
            found.append(self._observation(function, tau, f"observed_{k}", where))
        return found

    def _observation(self, function: PointFunction, tau: float, name: str, where: str) -> Family:
        known, model = self.unknowns, self.model
        if tau == 1.0 and self.grid.scheme is not None and self.grid.scheme.nodes[-1] == 1.0:
            entries = known.index["z"][-1, -1][None]  # the last point stands there: its configuration is the one
        else:
            labels = [f"coordinate {model.system.tree.q[k].label} at {where}" for k in model.equations.layout.z]
            entries = known.add(name, np.array([tau]), labels, model.scales.z)
        place, terms = Placer(function, 1), Terms(known)
        for block, order in (("y", 0), ("y_1", 1)):
            self.grid.add_interpolated(terms, place.rows[block][0], tau, order=order)
        terms.add(place.rows["z"], entries)
        if "x" in place.rows:
            terms.add(place.rows["x"], known.index["x"][:1])
        place.add_common(terms)
        return place.family(name, terms, np.array([tau]), np.zeros(1))


def starts_with_motion(model: PointModel, problem: TrajectoryProblem) -> bool:
    """Whether the motion at the start gives states a value: it is none where the start is at rest."""
    carried = any(state.carried is not None for state in model.equations.acting.states)
    return carried and not problem.periodic and not problem.start.at_rest


def bound_by_problem(known: Unknowns, model: PointModel, problem: TrajectoryProblem) -> None:
    """Narrow the unknowns to a problem: drives' control points, y and y' at both ends, states at the start, duration,
    design."""
    for k, label in enumerate(model.drive_labels):
        known.bound(known.index["u"][..., k], *problem.bounds.drives.get(label, (-np.inf, np.inf)))
    for name, tau, c in (("start", 0, problem.start), ("end", -1, problem.end)):
        for k, label in enumerate(model.equations.labels):
            if label in c.coordinates:
                value = c.coordinates[label]
                low, high = problem.bounds.joints.get(label, (-np.inf, np.inf))
                if not low <= value <= high:
                    raise DescriptionError(
                        f"{name}.coordinates: {label} = {value:g} contradicts its bounds {low:g} to {high:g}"
                    )
                known.bound(known.index["y"][tau, k], value, value)
            rate = 0.0 if c.at_rest else c.rates.get(label)
            if rate is not None and (rate == 0.0 or not isinstance(problem.duration, tuple)):
                value = rate * fixed_duration(problem) if rate else 0.0
                known.bound(known.index["y_1"][tau, k], value, value)
    if model.states and not problem.periodic:
        for k, state in enumerate(model.equations.acting.states):
            if state.carried is not None and starts_with_motion(model, problem):
                continue  # of the coordinates and rates there too: a row of the start's family
            known.bound(known.index["x"][0, k], model.initials[k], model.initials[k])
    if isinstance(problem.duration, tuple):
        _bound_inside(known, known.index["T"], *problem.duration)
    for k, name in enumerate(model.design):
        _bound_inside(known, known.index["p"][k], *problem.design[name])


def _bound_inside(known: Unknowns, entry: np.ndarray, low: float, high: float) -> None:
    """Bounds that a solver which widens them keeps: a range of durations or of a design means what it says."""
    size = float(np.max(known.scale[entry]))
    inner = low + RELAXED * max(abs(low), size), high - RELAXED * max(abs(high), size)
    known.bound(entry, *(inner if inner[0] < inner[1] else (low, high)))


def linear_cost(known: Unknowns, model: PointModel, problem: TrajectoryProblem) -> np.ndarray:
    """What objectives add to the cost linearly in the unknowns: duration, peak."""
    cost = np.zeros(known.size)
    every = {objective.type: made for made, objective in objectives_by_type(model)}
    for objective in problem.objectives:
        name = every[objective.type].cost_on
        if name:
            at = known.index[name][0]
            cost[at] += objective.weight * known.scale[at]
    return cost


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

    def add(self, terms: Terms, names: Sequence[str]) -> None:
        """Blocks that are unknowns of the points themselves."""
        for name in names:
            if name in self.rows:
                terms.add(self.rows[name], terms.unknowns.index[name].reshape(self.count, -1))

    def add_common(self, terms: Terms) -> None:
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

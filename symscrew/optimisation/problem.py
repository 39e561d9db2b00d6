"""What is to be optimised, in the words of optimal control.

A `TrajectoryProblem` is data: mechanism and effects, duration, conditions, bounds, objectives, design parameters,
transcription. Coordinates are named by labels of the tree's q or of any joint's freedom; numbers are SI units.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from symscrew.description import Mechanism
from symscrew.effects import Effect, Gravity
from symscrew.errors import DescriptionError, did_you_mean

Range = tuple[float, float]
INFINITY = float("inf")
# The words of problems. What each of them does: `objectives.OBJECTIVE_TYPES`, `solution.METHODS`,
# `constraints.FORMULATIONS`, `obstacles.SHAPES`.
OBJECTIVES = ("effort", "time", "energy", "electrical", "jerk", "peak", "preload", "expression")
METHODS = ("radau", "gauss", "shooting")
FORMULATIONS = ("inverse", "forward")
RULES = ("free", "least_squares")
SHAPE_TYPES = ("sphere", "plane", "capsule", "box")
# Half of what a replay may miss the goal by, for defects are of first order; opening of the loops without units.
ACCURACY = (5e-7, 1e-9)
# Of a bound between the points, as a part of its size: a hundredth of a millimetre for a length of a metre.
VIOLATION = 1e-5


@dataclass(frozen=True)
class Conditions:
    """What must hold at one time of the motion.

    `coordinates`: any name of `symscrew.kinematics.coordinate_names`, or label of q -> value [rad, m]; `rates`: label
    of q or of a joint's freedom -> rate. `points`: named
    point -> three coordinates [m], None where free. `platform_normal`: where the direction that was `z` in the
    reference configuration points; `platform_position`: displacement of the platform's body, in absolute axes,
    from the reference [m]; `platform_rotation`: its rotation vector from the reference [rad]. `at_rest`: all
    rates are zero. `time` is the part of the duration that has passed, 0 to 1 (of a via condition). `mode`: name of
    the assembly mode in which a motion starts, or ends; where empty that of the reference, or to which it leads.
    """

    coordinates: Mapping[str, float] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    points: Mapping[str, tuple[float | None, float | None, float | None]] = field(default_factory=dict)
    platform_normal: tuple[float, float, float] | None = None
    platform_position: tuple[float, float, float] | None = None
    platform_rotation: tuple[float, float, float] | None = None
    at_rest: bool = False
    time: float | None = None
    mode: str = ""

    @property
    def is_empty(self) -> bool:
        """Whether nothing is asked for."""
        placed = (self.platform_normal, self.platform_position, self.platform_rotation)
        return not (self.coordinates or self.rates or self.points or self.at_rest) and placed == (None, None, None)


@dataclass(frozen=True)
class Distance:
    """The distance of two named points stays within `range` [m]."""

    first: str
    second: str
    range: Range


@dataclass(frozen=True)
class Obstacle:
    """Named points, segments between two of them, and boxes, keep off a shape by at least `distance` [m].

    The distance counts from the shape's centre, segment, plane or box; bodies as capsules keep off each other by the
    sum of their radii.

    `type`: "sphere" about the point `at`; "plane" through the first of two points `at`, allowed is the side of the
    second; "capsule" about the segment between two; "box" from a corner to its three neighbours. The points `at` may
    stand on any body, fixed or moving; edges of a box are right-angled. `boxes` keep off as bodies: a corner and its
    three neighbours each.
    """

    type: str
    at: tuple[str, ...]
    points: tuple[str, ...]
    distance: float
    segments: tuple[tuple[str, str], ...] = ()
    boxes: tuple[tuple[str, ...], ...] = ()


@dataclass(frozen=True)
class Bounds:
    """Ranges (lower, upper) that hold during the whole motion; infinite where there is none.

    `drives` [N, N m] and `drive_rates` [N/s, N m/s] by labels of u; `joints` [m, rad] by names of coordinates, as in
    conditions; `speeds` [m/s, rad/s] by labels of joint freedoms, passive ones too; `reactions`: joint -> largest force
    [N] and largest moment about the joint's point [N m] (None: free);
    `margins`: name of a singularity margin -> range (see `symscrew.mobility.margins`); `points`: (point, 0 to 2) ->
    range of a coordinate [m]; `expressions`: text in t, T, the q_, v_, u_ of labels, points' coordinates (point_x) and
    parameters -> range, as in an objective of type "expression".
    """

    drives: Mapping[str, Range] = field(default_factory=dict)
    drive_rates: Mapping[str, Range] = field(default_factory=dict)
    joints: Mapping[str, Range] = field(default_factory=dict)
    speeds: Mapping[str, Range] = field(default_factory=dict)
    reactions: Mapping[str, tuple[float | None, float | None]] = field(default_factory=dict)
    margins: Mapping[str, Range] = field(default_factory=dict)
    points: Mapping[tuple[str, int], Range] = field(default_factory=dict)
    distances: Sequence[Distance] = ()
    obstacles: Sequence[Obstacle] = ()
    expressions: Mapping[str, Range] = field(default_factory=dict)


@dataclass(frozen=True)
class Objective:
    """A term of the cost, multiplied by `weight`.

    type: "effort" integral of sum w_j u_j^2; "time" the duration; "energy" integral of the drives' positive power
    [J] (nothing is recovered); "electrical" integral of sum (w_j u_j^2 + u_j rate_j) [J], w_j the copper loss per
    squared force [W/N^2]; "jerk" integral of the squared third rates of y; "peak" the largest |u_j / w_j|;
    "preload" integral of sum w_j (u_j - preload_j)^2; "expression" integral of `expression`.
    `weights` are the w_j by labels of u (default 1; of electrical 0).
    """

    type: str
    weight: float = 1.0
    weights: Mapping[str, float] = field(default_factory=dict)
    preload: Mapping[str, float] = field(default_factory=dict)
    expression: str = ""


@dataclass(frozen=True)
class Transcription:
    """How time is discretised.

    `method`: "radau" or "gauss" collocation of `degree`, or multiple "shooting" (Runge-Kutta of order 4, `degree`
    steps per interval, drives constant in an interval). `second_order` collocation keeps y' the derivative of y
    between the nodes. `formulation`: "inverse" (projected equations of motion as constraints, drives as algebraic
    variables) or "forward" (accelerations from forward dynamics). `mesh`: ends of the intervals as parts of the
    duration, in place of `intervals` equal ones.
    """

    method: str = "radau"
    degree: int = 3
    intervals: int = 50
    second_order: bool = True
    formulation: str = "inverse"
    mesh: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if self.method not in METHODS:
            raise DescriptionError(
                f"transcription.method: unknown method {self.method!r}; {did_you_mean(self.method, METHODS)}"
            )
        if self.formulation not in FORMULATIONS:
            raise DescriptionError(
                f"transcription.formulation: expected one of {', '.join(FORMULATIONS)}, got {self.formulation!r}"
            )
        if not 1 <= self.intervals <= 10_000:  # more is a slip of the pen: the program would fill the memory
            raise DescriptionError(f"transcription.intervals: expected 1 to 10000, got {self.intervals}")
        if self.mesh and any(b <= a for a, b in zip((0.0, *self.mesh), self.mesh, strict=False)):
            raise DescriptionError("transcription.mesh: expected ascending ends of intervals")


@dataclass(frozen=True)
class Solver:
    """Which solver of CasADi, its tolerance, the most iterations, and further options of its own.

    `time_limit` [s] of all that is solved for a problem, refinements included; IPOPT's.
    """

    name: str = "ipopt"
    tolerance: float = 1e-8
    iterations: int = 500
    time_limit: float = INFINITY
    options: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True, repr=False)
class TrajectoryProblem:
    """A motion to be found.

    `duration` [s] is a number, or a range (lower, upper) for a free one. `turns`: angle of y -> whole turns by which it
    ends further on in a periodic motion. `independent` names the independent
    coordinates y by labels of q. `design`: name of a parameter of the mechanism -> range in which it is chosen.
    `drive_rule`: "free" within the bounds, or "least_squares" distribution of redundant drives about `preload`.
    `inputs`: port of an effect -> its constant values. `accuracy`: (dynamic, kinematic) errors until which the mesh
    is refined: how far a replay ends off the plan [rad, m], opening of the loops between the points; None for no
    refinement and no judgement of either. `violation`: the most by which a bound may be broken between the points,
    as a part of its size. `starts`: guesses from which it is solved, the usual one and random ones by `seed`.
    `guess`: name of a coordinate of y -> values at equal times. `notices`: of bare angles that look like degrees.
    """

    mechanism: Mechanism
    effects: tuple[Effect, ...] = (Gravity(),)
    duration: float | Range = 1.0
    start: Conditions = Conditions()
    end: Conditions = Conditions()
    via: Sequence[Conditions] = ()
    periodic: bool = False
    turns: Mapping[str, int] = field(default_factory=dict)
    bounds: Bounds = Bounds()
    objectives: Sequence[Objective] = (Objective("effort"),)
    design: Mapping[str, Range] = field(default_factory=dict)
    parameters: Mapping[str, float] = field(default_factory=dict)
    independent: tuple[str, ...] | None = None
    drive_rule: str = "free"
    preload: Mapping[str, float] = field(default_factory=dict)
    inputs: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    guess: Mapping[str, Sequence[float]] = field(default_factory=dict)
    transcription: Transcription = Transcription()
    solver: Solver = Solver()
    accuracy: tuple[float, float] | None = ACCURACY
    violation: float = VIOLATION
    starts: int = 1
    seed: int = 1
    name: str = "trajectory"
    text: str = ""
    notices: tuple[str, ...] = ()

    def __repr__(self) -> str:
        duration = "{:g} to {:g}".format(*self.duration) if isinstance(self.duration, tuple) else f"{self.duration:g}"
        wanted = ", ".join(o.type for o in self.objectives)
        return f"<TrajectoryProblem {self.name}: {self.mechanism.name}, {duration} s, least {wanted}>"

    @property
    def free_duration(self) -> bool:
        """Whether the duration is chosen by the optimiser."""
        return isinstance(self.duration, tuple)

    @property
    def conditions(self) -> dict[str, Conditions]:
        """The conditions by where they hold, in words."""
        via = {f"via point {k + 1}": c for k, c in enumerate(self.via)}
        return {"the start": self.start, "the end": self.end, **via}

    def __post_init__(self) -> None:
        low, high = self.duration if isinstance(self.duration, tuple) else (self.duration, self.duration)
        if not (0 < low <= high and low < INFINITY):
            raise DescriptionError(
                "duration: expected a finite positive number, or a range (lower, upper) with 0 < lower <= upper, "
                f"got {self.duration!r}"
            )
        for objective in self.objectives:
            if objective.type not in OBJECTIVES:
                raise DescriptionError(
                    f"objective: unknown type {objective.type!r}; {did_you_mean(objective.type, OBJECTIVES)}"
                )
        if self.drive_rule not in RULES:
            raise DescriptionError(f"drive_rule: expected one of {', '.join(RULES)}, got {self.drive_rule!r}")
        if any(o.type == "time" for o in self.objectives) and not self.free_duration:
            raise DescriptionError(
                "objective: the time can be minimised only where the duration is free; give the duration as a range"
            )
        for via in self.via:
            if via.time is None or not 0 < via.time < 1:
                raise DescriptionError(f"via: expected a time between 0 and 1 (part of the duration), got {via.time!r}")
        for obstacle in self.bounds.obstacles:
            if obstacle.type not in SHAPE_TYPES:
                raise DescriptionError(
                    f"bounds.obstacles: unknown type {obstacle.type!r}; {did_you_mean(obstacle.type, SHAPE_TYPES)}"
                )
        check_ranges(self)


def fixed_duration(problem: TrajectoryProblem) -> float:
    """The duration [s] of a problem that does not leave it free."""
    assert not isinstance(problem.duration, tuple)
    return float(problem.duration)


def check_ranges(problem: TrajectoryProblem) -> None:
    """Refuse ranges that no value satisfies."""
    groups: dict[str, Mapping[str, Range] | Mapping[tuple[str, int], Range]] = {
        "bounds.drives": problem.bounds.drives,
        "bounds.drive_rates": problem.bounds.drive_rates,
        "bounds.joints": problem.bounds.joints,
        "bounds.speeds": problem.bounds.speeds,
        "bounds.margins": problem.bounds.margins,
        "bounds.points": problem.bounds.points,
        "bounds.distances": {f"{d.first}, {d.second}": d.range for d in problem.bounds.distances},
        "bounds.expressions": problem.bounds.expressions,
        "design": problem.design,
    }
    for where, ranges in groups.items():
        for name, (low, high) in ranges.items():
            if not low <= high:
                raise DescriptionError(
                    f"{where}: the bounds of {name} contradict each other: lower {low:g} is above upper {high:g}"
                )

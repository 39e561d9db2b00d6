"""What a problem says that could not count: contradictions, numbers that are none, values that nothing would read.

TrajectoryProblem --check_problem--> DescriptionError that names what would be left out, or nothing
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass

import numpy as np

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.optimisation.obstacles import SHAPES
from symscrew.optimisation.problem import Conditions, Objective, Obstacle, Solver, TrajectoryProblem, Transcription

# What an objective of a type reads besides its weight.
READ: Mapping[str, tuple[str, ...]] = {
    "effort": ("weights",), "time": (), "energy": (), "electrical": ("weights",), "jerk": (), "peak": ("weights",),
    "preload": ("weights", "preload"), "expression": ("expression",),
}  # fmt: skip
ONCE = ("time", "peak")  # objectives whose unknown a motion has once: a second one would count with the first's weights
UNBOUNDED = ("duration", "accuracy", "violation", "bounds", "design")  # where an infinite number says "no bound"
# Cosine up to which an angle is right: places that were typed with six digits.
SQUARE = 1e-5


def check_problem(problem: TrajectoryProblem) -> None:
    """Refuse a problem of which something would be ignored.

    Raises:
        DescriptionError: names what would not count, and the cure.
    """
    _check_numbers(problem)
    every = [("start", problem.start), ("end", problem.end), *((f"via[{k}]", c) for k, c in enumerate(problem.via))]
    for where, conditions in every:
        _check_conditions(where, conditions)
    for k, objective in enumerate(problem.objectives):
        _check_objective(f"objectives[{k}]", objective)
    for kind, count in Counter(o.type for o in problem.objectives).items():
        if count > 1 and kind in ONCE:
            raise DescriptionError(f"objectives: {kind!r} stands {count} times; give it once, with the sum of weights")
    if problem.turns and not problem.periodic:
        raise DescriptionError(f"problem.turns: those of {', '.join(problem.turns)} count in a periodic motion only")
    for label, count in problem.turns.items():
        if not float(count).is_integer():  # joints would end elsewhere, in a motion that calls itself periodic
            raise DescriptionError(f"turns.{label}: expected a whole number of turns, got {count:g}")
    for k, obstacle in enumerate(problem.bounds.obstacles):
        _check_obstacle(f"bounds.obstacles[{k}]", obstacle)
        for box in (*((obstacle.at,) if obstacle.type == "box" else ()), *obstacle.boxes):
            _check_box(f"bounds.obstacles[{k}]", problem.mechanism, box)
    _check_preload(problem)
    _check_starts(problem)
    _check_method(problem.transcription, problem.solver)
    for name, value in problem.parameters.items():
        low, high = problem.design.get(name, (-math.inf, math.inf))
        if not low <= value <= high:
            raise DescriptionError(
                f"parameters.{name}: {value:g} lies outside its range under 'design', {low:g} to {high:g}; "
                "as a first guess of the design it has to lie inside"
            )


def check_inputs(inputs: Mapping[str, Sequence[float]], ports: Mapping[str, int]) -> None:
    """Refuse inputs that no effect has, or of another size. `ports`: name -> number of values."""
    for name, values in inputs.items():
        if name not in ports:
            raise DescriptionError(f"inputs: no effect has an input {name!r}; {did_you_mean(name, ports)}")
        if len(values) != ports[name]:
            raise DescriptionError(f"inputs.{name}: expected {ports[name]} values, got {len(values)}")


def _check_numbers(problem: TrajectoryProblem) -> None:
    for where, number in _numbers(problem, ""):
        head = where.lstrip(".").split(".")[0].split("[")[0]
        unbounded = head in UNBOUNDED or where == ".solver.time_limit"
        if math.isnan(number) or (math.isinf(number) and not unbounded):
            raise DescriptionError(f"{where.lstrip('.')}: expected a finite number, got {number}")


def _numbers(value: object, where: str) -> Iterator[tuple[str, float]]:
    """All numbers of a problem, with the keys under which they stand; mechanism and effects have their own checks."""
    if isinstance(value, float):
        yield where, value
    elif is_dataclass(value):
        for part in fields(value):
            if part.name not in ("mechanism", "effects", "options"):
                yield from _numbers(getattr(value, part.name), f"{where}.{part.name}")
    elif isinstance(value, Mapping):
        for key, entry in value.items():
            yield from _numbers(entry, f"{where}.{key}")
    elif isinstance(value, list | tuple):
        for k, entry in enumerate(value):
            yield from _numbers(entry, f"{where}[{k}]")


def _check_conditions(where: str, given: Conditions) -> None:
    if given.at_rest and given.rates:
        raise DescriptionError(
            f"{where}: rates of {', '.join(given.rates)} stand beside at_rest = true, which makes all rates zero; "
            "leave one of the two out"
        )
    for name, place in given.points.items():
        if all(x is None for x in place):
            raise DescriptionError(f"{where}.points.{name}: all three coordinates are free; leave the point out")
    if given.time is not None and not where.startswith("via"):
        raise DescriptionError(f"{where}.time: only via conditions have a time; the {where} has its own")
    if where.startswith("via") and given.is_empty:
        raise DescriptionError(f"{where}: nothing is asked for; give coordinates, rates, points, a pose, or at_rest")


def _check_objective(where: str, given: Objective) -> None:
    read = READ[given.type]
    for name in ("weights", "preload", "expression"):
        if getattr(given, name) and name not in read:
            takers = " and ".join(kind for kind, names in READ.items() if name in names)
            raise DescriptionError(f"{where}.{name}: an objective {given.type!r} takes none; {takers} do")
    if given.type == "expression" and not given.expression:
        raise DescriptionError(f"{where}.expression: expected a text in t, q_, v_, u_ of labels, got none")
    if given.type == "peak" and any(not w > 0 for w in given.weights.values()):
        raise DescriptionError(f"{where}.weights: expected positive numbers, the drives are divided by them")


def _check_obstacle(where: str, given: Obstacle) -> None:
    wanted = SHAPES[given.type].points
    if len(given.at) != len(wanted):
        raise DescriptionError(f"{where}.at: a {given.type} has {len(wanted)} points ({', '.join(wanted)}), got "
                               f"{len(given.at)}")  # fmt: skip
    if not given.points and not given.segments and not given.boxes:
        raise DescriptionError(
            f"{where}.points: expected names of points that keep off, or segments, or boxes, got none"
        )
    for box in given.boxes:
        if len(box) != 4 or len(set(box)) != 4:
            raise DescriptionError(
                f"{where}.boxes: expected a corner and its three neighbours, got {', '.join(box) or 'none'}"
            )
        if set(box) == set(given.at):
            raise DescriptionError(f"{where}.boxes: the box at {', '.join(box)} is the obstacle itself")
    for pair in given.segments:
        if len(pair) != 2 or pair[0] == pair[1]:
            raise DescriptionError(f"{where}.segments: expected pairs of different points, got {list(pair)}")
        if given.type == "capsule" and set(pair) & set(given.at):
            shared = sorted(set(pair) & set(given.at))
            raise DescriptionError(
                f"{where}.segments: {shared[0]} is an end of both capsules, which touch there always"
            )
    flat = given.type == "plane"
    if not (given.distance > 0 or (flat and given.distance == 0)):
        raise DescriptionError(f"{where}.distance: expected a length above 0, got {given.distance:g}")


def _check_box(where: str, mechanism: Mechanism, names: Sequence[str]) -> None:
    """Its edges are at right angles, in the reference configuration: another solid would be taken for a box."""
    if not set(names) <= set(mechanism.points):
        return  # which is told with the names that there are
    corner, *others = (np.array([float(mechanism.number(c)) for c in mechanism.points[n].at]) for n in names)
    edges = {name: other - corner for name, other in zip(names[1:], others, strict=True)}
    for name, edge in edges.items():
        if not np.linalg.norm(edge) > 0:
            raise DescriptionError(f"{where}: the box at {', '.join(names)} has no edge from {names[0]} to {name}")
    for (one, a), (other, b) in itertools.combinations(edges.items(), 2):
        if abs(a @ b) > SQUARE * np.linalg.norm(a) * np.linalg.norm(b):
            angle = np.degrees(np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b)))
            raise DescriptionError(
                f"{where}: expected a box with right angles, got {angle:.4g} degrees at {names[0]} between {one} and "
                f"{other}"
            )


def _check_preload(problem: TrajectoryProblem) -> None:
    """[preload] is read by the rule of drives, and by objectives "preload" for labels that they do not give."""
    asked = [o for o in problem.objectives if o.type == "preload"]
    if problem.drive_rule == "least_squares":
        return
    for label in problem.preload:
        if all(label in o.preload for o in asked):  # of none as well
            raise DescriptionError(
                f"preload.{label}: nothing reads it; it takes drive_rule = 'least_squares', or an objective 'preload' "
                "without a value of its own"
            )


def _check_starts(problem: TrajectoryProblem) -> None:
    if problem.starts < 1 or problem.seed < 0:
        raise DescriptionError(
            f"problem: expected at least one of starts and a seed from 0, got {problem.starts} and {problem.seed}"
        )
    if problem.seed != 1 and problem.starts == 1:
        raise DescriptionError("problem.seed: random guesses take starts above 1; leave the seed out, or give starts")


def _check_method(given: Transcription, solver: Solver) -> None:
    if given.method == "shooting" and not given.second_order:
        raise DescriptionError("transcription.second_order: shooting has no such choice; leave it out")
    usual = Solver()
    if solver.name != "ipopt" and solver.tolerance != usual.tolerance:
        raise DescriptionError(
            f"solver.tolerance: it is IPOPT's; give that of {solver.name} under solver.options by its own name"
        )
    if solver.name not in ("ipopt", "sqpmethod") and solver.iterations != usual.iterations:
        raise DescriptionError(
            f"solver.iterations: it is IPOPT's and sqpmethod's; give that of {solver.name} under solver.options"
        )
    if solver.name != "ipopt" and not math.isinf(solver.time_limit):
        raise DescriptionError(f"solver.time_limit: only IPOPT looks at the clock; {solver.name} does not")
    if not solver.time_limit > 0:
        raise DescriptionError(f"solver.time_limit: expected seconds above 0, got {solver.time_limit:g}")
    if not solver.tolerance > 0 or solver.iterations < 1:
        raise DescriptionError(
            f"solver: expected a positive tolerance and at least one iteration, got {solver.tolerance:g} and "
            f"{solver.iterations}"
        )

"""What a problem keeps while its numbers change: a program with parameters is built for one shape.

(built, wanted) --> what differs in more than numbers, in words, or nothing
"""

from __future__ import annotations

from collections.abc import Iterator

from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions, TrajectoryProblem


def other_shape(built: TrajectoryProblem, wanted: TrajectoryProblem, model: PointModel) -> str:
    """Why a program built for one problem does not do for another one, or nothing."""
    shapes = (_shape(problem, set(model.equations.labels)) for problem in (built, wanted))
    for (name, made), (_, other) in zip(*shapes, strict=False):
        if made != other:
            return f"{name}: the problem was built with {made}, got {other}"
    unknown = sorted(set(wanted.parameters) - set(model.parameter_names))
    if unknown:
        known = ", ".join(model.parameter_names) or "none"
        return f"parameters: {', '.join(unknown)} became numbers when the equations were derived (known: {known})"
    return ""


def _shape(problem: TrajectoryProblem, independent: set[str]) -> Iterator[tuple[str, object]]:
    yield "duration", "a free one" if problem.free_duration else "a fixed one"
    for where, c in problem.conditions.items():
        for what, kind in _kind(c, independent if c.time is None else set(), free=problem.free_duration):
            yield f"{what} at {where}", kind
    b = problem.bounds
    yield "bounds.drive_rates", dict(b.drive_rates)
    if b.drive_rates or any(c.rates for c in problem.via):
        yield "duration, beside rates that it scales", problem.duration
    for name in ("joints", "speeds", "margins", "points", "expressions"):
        yield f"bounds.{name}", sorted(map(str, getattr(b, name)))
    yield "bounds.distances", [(d.first, d.second) for d in b.distances]
    yield "bounds.obstacles", [(o.type, o.at, o.points, o.segments, o.boxes) for o in b.obstacles]
    limits = {name: (force is not None, moment is not None) for name, (force, moment) in b.reactions.items()}
    yield "bounds.reactions (force, moment)", limits
    yield "types of the objectives", [(o.type, o.expression) for o in problem.objectives]
    yield "weights of the peak's drives", [dict(o.weights) for o in problem.objectives if o.type == "peak"]
    yield "inputs", sorted(problem.inputs)


def _kind(c: Conditions, bounded: set[str], *, free: bool) -> Iterator[tuple[str, object]]:
    """What conditions look at, and their values where those stand in the functions themselves.

    Coordinates of y at the ends, and their rates, are `bounded` unknowns: any of them may be given or not, except that
    a rate times a free duration is a coefficient.
    """
    coefficients = sorted((label, rate) for label, rate in c.rates.items() if free and rate != 0.0)
    yield "coordinates", sorted(set(c.coordinates) - bounded)
    yield "rates", sorted(set(c.rates) - bounded)
    yield "rates beside a free duration", coefficients
    yield "points", sorted((name, [x is not None for x in at]) for name, at in c.points.items())
    yield "platform_normal", c.platform_normal
    yield "platform_position", "given" if c.platform_position is not None else "none"
    yield "platform_rotation", c.platform_rotation
    yield "time, rest on the way", (c.time, c.at_rest and c.time is not None)

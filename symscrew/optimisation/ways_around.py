"""A way for the first guess that keeps clear of obstacles: through the middle of one, no side is the nearer one.

path of y --distances along it--> as it is where all are kept;  else bent to one side, by as little as keeps them

A solver goes downhill from its guess. In the middle of an obstacle the slopes of the distance vanish or point along the
way: it jumps through between two points, creeps around in hundreds of steps, or gives up. Bends are tried in a fixed
order (small ones first, then by coordinate, then forwards and back), so that the same problem has the same guess.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import casadi as ca
import numpy as np

from symscrew.optimisation.consistent_poses import Kinematics
from symscrew.optimisation.constraints import bound_rows
from symscrew.optimisation.guess_path import Path
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Bounds

LOOKED_AT = 121  # places of a way: an obstacle that fits between them is passed by every solver as well
# Sizes of bends, of the longer of the way and a radian (the mechanism's length): doubling, from hardly off the way to
# as far as it is long.
SIZES = tuple(2.0**-k for k in range(6, -1, -1))
KNOTS = 4  # pieces of a bend between two stops: quintics through as many places are as good as the sine itself
FREE = 1e-9  # of an obstacle's size: a way along its surface is kept


def led_around(model: PointModel, kinematics: Kinematics, path: Path, start: np.ndarray) -> Path:
    """The path, or a bent one where it leads through an obstacle; where none is clear the one that is broken least."""
    problem = model.problem
    kept = Bounds(distances=problem.bounds.distances, obstacles=problem.bounds.obstacles)
    if not (kept.distances or kept.obstacles):
        return path
    broken = _broken(model.of(replace(problem, bounds=kept)), kinematics)
    tau = np.linspace(0.0, 1.0, LOOKED_AT)
    q = kinematics.follow(path(tau)[0], start)
    best, least = path, broken(path(tau)[0], q, tau)
    if least <= FREE:
        return path
    for bent in _bends(model, path):
        y = bent(tau)[0]
        found, there = kinematics.assemble_all(y, q)
        size = broken(y, found, tau) if there.all() else np.inf
        if size <= FREE:
            return bent
        if size < least:
            best, least = bent, size
    return best


def _broken(model: PointModel, kinematics: Kinematics) -> Callable[[np.ndarray, np.ndarray, np.ndarray], float]:
    """(y, q, tau) -> the most by which a distance is missed along them, as a part of its size."""
    blocks = point_symbols(model, moving=False)
    rows = bound_rows(MotionQuantities(model, blocks))
    values = ca.vertcat(*[row.value / (row.measure or row.scale) for row in rows])
    low, high = (np.array([[getattr(r, n) / (r.measure or r.scale)] for r in rows]) for n in ("lower", "upper"))
    names = ("y", "z", "y_1", "y_2", "T", "p", "tau")
    function = ca.Function("kept", [blocks[name] for name in names], [values])
    p = np.array([kinematics.parameters[model.parameter_names.index(name)] for name in model.design])

    def broken(y: np.ndarray, q: np.ndarray, tau: np.ndarray) -> float:
        n = len(tau)
        given = [
            y.T, q[:, list(model.equations.layout.z)].T, 0 * y.T, np.zeros((blocks["y_2"].numel(), n)),
            np.ones((blocks["T"].numel(), n)), np.repeat(p[:, None], n, 1), tau[None],
        ]  # fmt: skip
        found = np.array(function.map(n)(*given))
        return float(np.nan_to_num(np.maximum(low - found, found - high), nan=np.inf).max(initial=0.0))

    return broken


def _bends(model: PointModel, path: Path) -> Iterator[Path]:
    """The path with a bend of one coordinate between every two stops, which leaves the stops and their rates."""
    entries, length = model.equations.layout.y, model.system.length
    units = np.array([length if model.system.tree.q[k].kind == "length" else 1.0 for k in entries])
    long = max(1.0, float((np.ptp(path.values, axis=0) / units).max(initial=0.0)))
    part = np.arange(KNOTS) / KNOTS
    times = np.append((path.times[:-1, None] + np.diff(path.times)[:, None] * part).ravel(), path.times[-1])
    values, slopes, _ = path(times)
    legs = np.append(np.repeat(np.diff(path.times), KNOTS), 1.0)
    at = np.append(np.tile(part, len(path.times) - 1), 0.0)
    bend, rise = np.sin(np.pi * at) ** 2, np.pi * np.sin(2 * np.pi * at) / legs
    for size in SIZES:
        for k in range(len(entries)):
            for side in (size * long * units[k], -size * long * units[k]):
                beside, faster = np.zeros_like(values), np.zeros_like(values)
                beside[:, k], faster[:, k] = side * bend, side * rise
                yield Path(times, values + beside, slopes + faster)

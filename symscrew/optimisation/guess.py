"""The first guess: interpolate between the conditions on the closure manifold, around obstacles; drives by dynamics.

It gives the scales of the unknowns as well: typical magnitudes along the guess.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.consistent_poses import Kinematics, beginning, ending
from symscrew.optimisation.guess_path import Path
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.objectives import objectives_by_type
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions
from symscrew.optimisation.rows import Scales
from symscrew.optimisation.ways_around import led_around

# Steps in which configurations are followed along the guess; with fewer Newton's method may lose the assembly branch.
FINEST = 60
# Smallest pivot of the closure, without units, below which no motion can start: the loops cannot be solved for y.
SINGULAR = 1e-5
LONGEST = 100.0  # [s] a free duration is looked for up to here; a longer one is found by the solver, from here
# Durations tried, in equal ratios: neighbours differ by less than a factor of two in ranges of up to 1 : 8e6.
TRIALS = 24
SAME = 1e-6  # [rad, m]: configurations that both close to 1e-12 are one; branches apart differ by far more
BALANCED = 1e-6  # of the largest singular value: directions that the drives move less are left out of the guess


@dataclass(frozen=True)
class PointValues:
    """A motion at relative times tau (n,): y, y', y'' (n, d) by relative time, z (n, nz)."""

    tau: np.ndarray
    y: np.ndarray
    y_1: np.ndarray
    y_2: np.ndarray
    z: np.ndarray

    def every(self, stride: int) -> PointValues:
        """Each stride-th of them."""
        return PointValues(*(part[::stride] for part in (self.tau, self.y, self.y_1, self.y_2, self.z)))


@dataclass(frozen=True)
class Guess:
    """Path, configurations q (n, nq) at `tau` (n,), duration, and the scales of the problem.

    `trouble` says why no motion can start from here: a condition out of reach, a singular start; else empty.
    `stops`: configurations that meet the conditions at via points and the end; `parted`: the path of y does not lead
    to the last of them on the assembly mode of the start.
    """

    path: Path
    tau: np.ndarray
    q: np.ndarray
    duration: float
    scales: Scales
    trouble: str = ""
    stops: tuple[np.ndarray, ...] = ()
    parted: bool = False

    def arrays(self, model: PointModel, mesh: np.ndarray, points: np.ndarray) -> dict[str, np.ndarray]:
        """Values of a transcription's unknowns: mesh (n + 1,), points (n, K)."""
        kinematics = Kinematics(model, default_parameters(model))
        y, y_1, _ = self.path(mesh)
        flat = points.ravel()
        at, rate, second = self.path(flat)
        nearest = np.abs(flat[:, None] - self.tau).argmin(axis=1)
        q, _ = kinematics.assemble_all(at, self.q[nearest])
        q[:, list(model.equations.layout.y)] = at  # also where nothing was found
        z = q[:, list(model.equations.layout.z)]
        u = drives(model, self.duration, PointValues(flat, at, rate, second, z))
        ranges = [model.drive_range(label) for label in model.drive_labels]
        for k, (low, high) in enumerate(ranges):
            u[:, k] = np.clip(u[:, k], low, high)
        result = {"y": y, "y_1": y_1, "y_2": second, "z": z, "u": u, "T": np.array([self.duration])}
        states = np.array(model.initials)
        result["x"] = np.repeat(states[None], len(mesh), 0)
        for made, objective in objectives_by_type(model):
            if made.whole:
                result[made.whole.name] = np.array([made.whole.start(model, objective, u)])
        names = model.parameter_names
        result["p"] = np.array([kinematics.parameters[names.index(n)] for n in model.design])
        for k, (tau, _) in enumerate(observed(model)):
            here = self.path(np.array([tau]))[0][0]
            near = self.q[int(np.argmin(np.abs(self.tau - tau)))]
            place = kinematics.assemble(here, near)
            result[f"observed_{k}"] = (near if place is None else place)[list(model.equations.layout.z)]
        return result


def observed(model: PointModel) -> list[tuple[float, Conditions]]:
    """Times and conditions of start, end and via points."""
    problem = model.problem
    return [(0.0, problem.start), (1.0, problem.end), *((float(c.time or 0), c) for c in problem.via)]


def default_parameters(model: PointModel) -> np.ndarray:
    """Values of the run-time parameters: the problem's, else the description's, inside the range of a design."""
    values = []
    for name in model.parameter_names:
        value = model.problem.parameters.get(name, float(model.system.mechanism.parameters[name].value))
        if name in model.problem.design:
            value = float(np.clip(value, *model.problem.design[name]))
        values.append(value)
    return np.array(values)


def first_guess(model: PointModel) -> Guess:
    """The guess of a problem; where a condition is out of reach it leads to the nearest configuration found."""
    kinematics = Kinematics(model, default_parameters(model))
    places = _Places(model, kinematics)
    path, start, stops = _path(model, places)
    if not model.problem.guess:
        path = led_around(model, kinematics, path, start)
    tau = np.linspace(0.0, 1.0, FINEST + 1)
    y, y_1, y_2 = path(tau)
    q = kinematics.follow(y, start)
    at = PointValues(tau, y, y_1, y_2, q[:, list(model.equations.layout.z)])
    duration = _duration(model, at)
    scales = _scales(model, duration, at, drives(model, duration, at))
    parted = bool(stops) and not same_place(model, q[-1], stops[-1])
    trouble = places.trouble or _singular_start(kinematics, start)
    return Guess(path, tau, q, duration, scales, trouble, stops, parted)


def same_place(model: PointModel, q: np.ndarray, other: np.ndarray) -> bool:
    """Whether two configurations are one, whole turns of joints aside."""
    apart = np.abs(q - other)
    turns = np.array([c.kind == "angle" for c in model.system.tree.q])
    apart = np.where(turns, np.abs((apart + np.pi) % (2 * np.pi) - np.pi), apart)
    return bool((apart < SAME).all())


def _singular_start(kinematics: Kinematics, start: np.ndarray) -> str:
    pivot = float(kinematics.pivots(start)[0]) if kinematics.system.cuts else 1.0
    if pivot > SINGULAR:
        return ""
    names = ", ".join(kinematics.model.equations.labels)
    return (
        f"the start is singular: the loops cannot be solved for the coordinates {names} there (smallest pivot "
        f"{pivot:.1e}); start elsewhere, or name other coordinates under 'independent'"
    )


class _Places:
    """Configurations that meet conditions, and what could not be met."""

    def __init__(self, model: PointModel, kinematics: Kinematics) -> None:
        self.model, self.kinematics, self.trouble = model, kinematics, ""

    def __call__(self, conditions: Conditions, where: str, near: np.ndarray) -> np.ndarray:
        found = self.kinematics.place(conditions, where, near)
        if not found.reached and not self.trouble:
            self.trouble = (
                f"{where} is out of reach: the nearest configuration found misses {found.worst} by {found.error:.3g} "
                "(without units); does it lie inside the workspace, on this assembly branch?"
            )
        return found.q


def _path(model: PointModel, place: _Places) -> tuple[Path, np.ndarray, tuple[np.ndarray, ...]]:
    """The path of y, the start's configuration, those of via points and the end (none where values are given)."""
    given, entries = model.problem.guess, list(model.equations.layout.y)
    start = place(model.problem.start, "the start", beginning(model.system, model.problem.start))
    if given:
        values = _given_values(model, place, start)
        times = np.linspace(0.0, 1.0, len(values))
        return Path(times, values, np.gradient(values, times, axis=0)), start, ()
    stamps, places, q = [0.0], [start[entries]], start
    found: list[np.ndarray] = []
    stops = sorted(model.problem.via, key=lambda c: float(c.time or 0))
    for k, c in enumerate(stops):
        q = place(c, f"via point {k + 1}", q)
        stamps.append(float(c.time or 0))
        places.append(q[entries])
        found.append(q)
    end = model.problem.end
    if end.mode and end.is_empty:
        raise DescriptionError("end.mode: expected conditions beside it, such as end.coordinates: it is none by itself")
    last = start if model.problem.periodic and end.is_empty else q
    turned = np.array([2 * np.pi * model.problem.turns.get(label, 0) for label in model.equations.labels])
    if not end.is_empty:
        last = place(end, "the goal", ending(model.system, end, q))
        found.append(last)
    stamps.append(1.0)
    places.append(last[entries] + (turned if end.is_empty else 0.0))
    points = np.array(places)
    slopes = np.zeros_like(points)
    if len(points) > 2:
        slopes[1:-1] = (points[2:] - points[:-2]) / (np.array(stamps)[2:] - np.array(stamps)[:-2])[:, None]
    for k, c in enumerate(stops):
        if c.at_rest:
            slopes[1 + k] = 0.0
    return Path(np.array(stamps), points, slopes), start, tuple(found)


def _given_values(model: PointModel, place: _Places, start: np.ndarray) -> np.ndarray:
    """y (n, d) at equal times of a guess: as it is given, or of the configurations that have the given coordinates.

    Raises:
        DescriptionError: other numbers of values, or fewer than two.
    """
    given, labels = model.problem.guess, model.equations.labels
    counts = {name: len(values) for name, values in given.items()}
    if min(counts.values()) < 2 or len(set(counts.values())) > 1:
        said = ", ".join(f"{name} {count}" for name, count in counts.items())
        raise DescriptionError(f"guess: expected as many values of every coordinate, at least two; got {said}")
    if set(given) == set(labels):
        return np.array([list(given[label]) for label in labels], dtype=float).T
    q, found = start, []
    for k in range(next(iter(counts.values()))):
        at = Conditions(coordinates={name: float(values[k]) for name, values in given.items()})
        q = place(at, f"value {k + 1} of the guess", q)
        found.append(q[list(model.equations.layout.y)])
    return np.array(found)


def _dynamics(model: PointModel) -> tuple[ca.Function, int]:
    """(T, tau, y, y_1, y_2, z) -> residual at u = 0 and its matrix by u."""
    blocks = point_symbols(model, moving=True)
    duration = ca.SX.sym("duration")
    at = MotionQuantities(model, {**blocks, "T": duration} if model.problem.free_duration else blocks)
    found = symbolic_outputs(model.equations.dynamics, at.known)["residual"]
    slope = ca.jacobian(found, blocks["u"])
    states = ca.DM(model.initials)
    fixed = ca.substitute([found, slope], [blocks["u"], blocks["x"]], [ca.DM.zeros(blocks["u"].numel()), states])
    inputs = [duration, blocks["tau"], blocks["y"], blocks["y_1"], blocks["y_2"], blocks["z"], blocks["p"]]
    return ca.Function("balance", inputs, [fixed[0], ca.densify(fixed[1])]), blocks["u"].numel()


def _balance(model: PointModel, duration: float, at: PointValues) -> tuple[np.ndarray, np.ndarray]:
    """Residual (n, d) without drives, and the drives' matrix (n, d, nu)."""
    function, count = _dynamics(model)
    names, n = model.parameter_names, len(at.tau)
    p = np.array([default_parameters(model)[names.index(name)] for name in model.design])
    arguments = [
        np.full((1, n), duration),
        at.tau[None],
        at.y.T,
        at.y_1.T,
        at.y_2.T,
        at.z.T,
        np.repeat(p[:, None], n, 1),
    ]
    force, matrix = (np.array(m) for m in function.map(n)(*arguments))
    return force.T, matrix.reshape(model.d, n, count).transpose(1, 0, 2)


def drives(model: PointModel, duration: float, at: PointValues) -> np.ndarray:
    """Drives of smallest sum of squares that come closest to the motion: (n, nu) [N, N m]."""
    force, matrix = _balance(model, duration, at)
    u = np.zeros((len(at.tau), matrix.shape[2]))
    for k in range(len(at.tau)):
        if np.isfinite(force[k]).all() and np.isfinite(matrix[k]).all() and matrix.shape[2]:
            u[k] = -np.linalg.lstsq(matrix[k], force[k], rcond=BALANCED)[0]
    return u


def _duration(model: PointModel, at: PointValues) -> float:
    """The given duration, or the shortest of a free one for which drives and speeds of the guess keep their bounds."""
    duration = model.problem.duration
    if not isinstance(duration, tuple):
        return float(duration)
    low, high = max(duration[0], 1e-3), min(duration[1], LONGEST)
    if high <= low:
        return low
    coarse = at.every(3)
    for trial in np.geomspace(low, high, TRIALS):
        u = drives(model, trial, coarse)
        if _within(model, u) and _slow_enough(model, trial, at.y_1):
            return float(trial)
    return float(min(high, max(low, 1.0)))


def _within(model: PointModel, u: np.ndarray) -> bool:
    for k, label in enumerate(model.drive_labels):
        low, high = model.drive_range(label)
        if (u[:, k] > high).any() or (u[:, k] < low).any():
            return False
    return True


def _slow_enough(model: PointModel, duration: float, y_1: np.ndarray) -> bool:
    for k, label in enumerate(model.equations.labels):
        low, high = model.problem.bounds.speeds.get(label, (-np.inf, np.inf))
        rate = y_1[:, k] / duration
        if (rate > high).any() or (rate < low).any():
            return False
    return True


def _scales(model: PointModel, duration: float, at: PointValues, u: np.ndarray) -> Scales:
    tree, length = model.system.tree.q, model.system.length

    def unit(entries: Sequence[int]) -> np.ndarray:
        return np.array([length if tree[k].kind == "length" else 1.0 for k in entries])

    layout = model.equations.layout
    span = np.ptp(at.y, axis=0)
    sized_y = np.clip(span, 0.1 * unit(layout.y), None)
    force = np.abs(_balance(model, duration, at)[0])
    level = force.max(initial=0.0, where=np.isfinite(force))
    sizes = []
    for k, label in enumerate(model.drive_labels):
        bound = max((abs(b) for b in model.drive_range(label) if np.isfinite(b)), default=0.0)
        largest = np.abs(u[:, k]).max(initial=0.0)
        sizes.append(min(bound, 4 * largest) if bound and largest else bound or largest)
    usual = max(sizes, default=1.0) or 1.0
    sized_u = np.array([max(size, 1e-2 * usual) for size in sizes])
    states = np.array([max(abs(initial), 1e-2) for initial in model.initials])
    return Scales(sized_y, unit(layout.z), sized_u, duration, np.full(model.d, level or 1.0), states)


def unit_scales(d: int, nz: int, nu: int, nx: int) -> Scales:
    """Scales before there is a guess."""
    return Scales(np.ones(d), np.ones(nz), np.ones(nu), 1.0, np.ones(d), np.ones(nx))

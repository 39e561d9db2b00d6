"""Passages: other independent coordinates by which a goal on another assembly mode can be reached.

Where the loops cannot be solved for y, branches meet; a motion may pass there with momentum, and coordinates that stay
regular describe it. A way on the closure manifold from the start to the goal is walked,

    w <- w + P (goal - w), P the projection onto the directions that the loops leave free, then back onto the manifold,

and those entries of w become y for which the free directions are furthest from singular all along it.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, islice

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.guess import Guess, default_parameters
from symscrew.optimisation.motion_equations import PointEquations
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import TrajectoryProblem

STEP = 0.05  # of a way, angles in rad, lengths by the mechanism's: a branch turns over some tenths
MOST_STEPS = 600  # a way of thirty radians: longer ones are no passage
STUCK = 1e-3  # part of the way to the goal that lies in free directions: with less the walk stands still
CLOSED, NEWTON_STEPS = 1e-11, 8  # of the way's configurations, from a step away: errors 1e-2, 1e-4, 1e-8, 1e-16
# Sets of coordinates that are compared; with more only the first are, those of the tree's first joints.
MOST_SETS = 3_000
REGULAR = 0.05  # smallest singular value of free directions by coordinates along the way; below, branches are near
SHOWN = 21  # values of the way as a guess: what lies between them is near the way itself


def passages(model: PointModel, guess: Guess) -> list[TrajectoryProblem]:
    """The problem in coordinates that are regular on a way through all its stops, by two guesses, if any.

    The first guess is straight in the new coordinates, the second follows the way. Coordinates that a problem names
    itself are left as they are.
    """
    problem = model.problem
    if problem.independent is not None or not guess.stops or not model.equations.layout.z:
        return []
    manifold = _Manifold(model)
    way = [manifold.of(guess.q[0])]
    for stop in guess.stops:
        leg = manifold.walked(way[-1], manifold.of(stop))
        if leg is None:
            return []
        way += leg
    for labels in manifold.regular_sets(np.array(way)):
        try:
            PointEquations(problem.mechanism, problem.effects, labels)
        except DescriptionError:
            continue  # the loops cannot be solved for these in the reference configuration
        entries = [manifold.labels.index(label) for label in labels]
        part = np.linspace(0, 1, SHOWN)
        at = part**3 * (10 - 15 * part + 6 * part**2) * (len(way) - 1)  # at rest at both ends
        whole = np.array(way) * manifold.units
        values = {
            label: tuple(np.interp(at, np.arange(len(way)), whole[:, k]).tolist())
            for label, k in zip(labels, entries, strict=True)
        }
        straight = replace(problem, independent=labels, guess={})
        return [straight, replace(straight, guess=values)]
    return []


class _Manifold:
    """Configurations w (angles, lengths by the mechanism's, quaternions) on the closure of a problem."""

    def __init__(self, model: PointModel) -> None:
        equations, tree = model.equations, model.system.tree
        self.order = [*equations.layout.y, *equations.layout.z]
        self.labels = [tree.q[k].label for k in self.order]
        length = model.system.length
        self.units = np.array([length if tree.q[k].kind == "length" else 1.0 for k in self.order])
        self.angles = np.array([tree.q[k].kind == "angle" for k in self.order])
        asked = set(model.problem.end.coordinates)
        self.turning = self.angles & np.array([label not in asked for label in self.labels])
        w, d = ca.SX.sym("w", len(self.order)), model.d
        q = w * ca.DM(self.units)
        p = ca.DM(default_parameters(model))
        c = symbolic_outputs(equations.closure, {"y": q[:d], "z": q[d:], "p": p})["closure"]
        self.function = ca.Function("manifold", [w], [c, ca.densify(ca.jacobian(c, w))])
        self.d = d

    def of(self, q: np.ndarray) -> np.ndarray:
        """w of a configuration of the tree."""
        return np.asarray(q[self.order] / self.units)

    def free(self, w: np.ndarray) -> np.ndarray:
        """Orthonormal free directions (n, d)."""
        return np.asarray(np.linalg.svd(np.array(self.function(w)[1]))[2][-self.d :].T)

    def walked(self, start: np.ndarray, goal: np.ndarray) -> list[np.ndarray] | None:
        """Configurations from the start to the goal; None where the walk stands still on its way."""
        turns = np.round((goal - start) / (2 * np.pi))
        goal = np.where(self.turning, goal - 2 * np.pi * turns, goal)
        w, way = start, list[np.ndarray]()
        for _ in range(MOST_STEPS):
            left = goal - w
            if np.linalg.norm(left) <= STEP:
                return [*way, goal]
            free = self.free(w)
            step = free @ (free.T @ left)
            size = float(np.linalg.norm(step))
            if size < STUCK * np.linalg.norm(left):
                return None
            closed = self._closed(w + step * min(1.0, STEP / size))
            if closed is None:
                return None
            w = closed
            way.append(w)
        return None

    def _closed(self, w: np.ndarray) -> np.ndarray | None:
        for _ in range(NEWTON_STEPS):
            c, slope = (np.array(m) for m in self.function(w))
            if not (np.isfinite(c).all() and np.isfinite(slope).all()):
                return None
            step = np.linalg.lstsq(slope, c.ravel(), rcond=None)[0]
            w = w - step
            if np.abs(step).max(initial=0.0) < CLOSED:
                return w
        return None

    def regular_sets(self, way: np.ndarray) -> list[tuple[str, ...]]:
        """Sets of labels, those furthest from singular first."""
        every = [self.free(w) for w in way]
        found = []
        for chosen in islice(combinations(range(len(self.order)), self.d), MOST_SETS):
            least = min(float(np.linalg.svd(f[list(chosen)], compute_uv=False)[-1]) for f in every)
            if least > REGULAR:
                found.append((least, tuple(self.labels[k] for k in chosen)))
        return [labels for _, labels in sorted(found, key=lambda pair: -pair[0])]

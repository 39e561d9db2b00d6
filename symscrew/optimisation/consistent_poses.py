"""Configurations from independent coordinates, and configurations that meet conditions, by Newton's method.

y, a configuration near by --closed loops--> q;    conditions, a configuration near by --least squares--> q, miss
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from symscrew.assembly import configuration_in_mode
from symscrew.kinematics import System
from symscrew.optimisation.casadi_graph import numeric_function
from symscrew.optimisation.constraints import closure_rows, condition_rows
from symscrew.optimisation.motion_coordinates import poses_of
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import Conditions
from symscrew.optimisation.rows import Row

CLOSED = 1e-12  # step [1, rad, m] at which Newton's method ends: by its order the next one is below rounding
# Steps of all configurations at once; those that are not there after these are assembled one by one, with damping.
MOST_COMMON_STEPS, MOST_STEPS = 8, 40
LARGEST_STEP = 0.5  # [rad, m]: a longer one may lead to another assembly branch, so it is shortened
STRIDES = 8  # towards a pose by name, as at the start of a simulation: in one stride limbs may change their branch
REACHED = 1e-9  # without units: what conditions may be missed by; more is out of reach, and no solver is started
# Levenberg's damping of the least squares towards conditions: at first, least, and where it is given up.
DAMPING, LEAST_DAMPING, MOST_DAMPING = 1e-3, 1e-14, 1e8
MOST_DAMPED_STEPS = 200  # then the nearest configuration so far counts, and what it misses decides
# More for a far goal, a wheel's turns, a crane's rail: twice what shortened steps need, a second of them at most.
STEPS_OF_A_STEP, MOST_FAR_STEPS = 2, 20_000


@dataclass(frozen=True)
class Placement:
    """A configuration that meets conditions as well as possible: q, the largest miss, and where it is."""

    q: np.ndarray
    error: float
    worst: str

    @property
    def reached(self) -> bool:
        """Whether the conditions are met."""
        return self.error < REACHED


def beginning(system: System, start: Conditions) -> np.ndarray:
    """The configuration (nq,) near which a motion starts: the reference, or the start's assembly mode."""
    return ending(system, start, np.asarray(system.reference), "start")


def ending(system: System, conditions: Conditions, near: np.ndarray, where: str = "end") -> np.ndarray:
    """The configuration (nq,) near which conditions are met: in the mode that they name, else `near`."""
    if not conditions.mode:
        return near
    return configuration_in_mode(system, conditions.mode, conditions.coordinates, f"{where}.mode")


class Kinematics:
    """Numeric kinematics of a problem at given parameters p of the mechanism."""

    def __init__(self, model: PointModel, parameters: np.ndarray) -> None:
        self.model, self.parameters = model, parameters
        self.system = model.system
        self.layout = model.equations.layout

    @cached_property
    def _step(self) -> ca.Function:
        return numeric_function(self.model.equations.step)

    @cached_property
    def _move(self) -> ca.Function:
        return numeric_function(self.model.equations.move)

    @cached_property
    def _pivots(self) -> ca.Function:
        return numeric_function(self.model.equations.pivots)

    @cached_property
    def _closure(self) -> ca.Function:
        return numeric_function(self.model.equations.closure)

    def _with_parameters(self, *arguments: np.ndarray) -> list[np.ndarray]:
        return [*arguments, self.parameters] if len(self.parameters) else list(arguments)

    def columns(self, *arrays: np.ndarray) -> list[np.ndarray]:
        """Arrays (n, size) as CasADi takes them, a column per sample, the parameters after them."""
        many = [a.T for a in arrays]
        return [*many, np.repeat(self.parameters[:, None], len(arrays[0]), 1)] if len(self.parameters) else many

    def closure(self, y: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q (n, nq) from y (n, d) and z (n, nz) as they are, and by how much the loops are open (n, rows), no units."""
        q, *openings = self._closure(*self.columns(y, z))
        return np.array(q).T, np.vstack([np.array(opening) for opening in openings]).T

    def assemble(self, y: np.ndarray, guess: np.ndarray) -> np.ndarray | None:
        """q (nq,) with independent coordinates y near the guess; None where Newton's method finds none."""
        q = np.array(guess, dtype=float)
        if not self.system.cuts:
            q[list(self.layout.y)] = y
            if not self.layout.z:
                return q
        for _ in range(MOST_STEPS):
            moved = np.array(self._move(*self._with_parameters(q, y))).ravel()
            size = float(np.abs(moved - q).max(initial=0.0))
            if not np.isfinite(size):
                return None
            if size > LARGEST_STEP:
                step = np.array(self._step(*self._with_parameters(q, y))).ravel()
                moved = self.system.advance(q, step * (LARGEST_STEP / np.abs(step).max()))
            q = moved
            if size < CLOSED:
                return q
        return None

    def assemble_all(self, y: np.ndarray, guesses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q (n, nq) with independent coordinates y (n, d), each near its guess (n, nq), and where there is one (n,).

        Elsewhere q is the guess. All are moved at once; what does not converge fast is assembled with damped steps.
        """
        q, n = np.array(guesses, dtype=float), len(y)
        fine = np.ones(n, dtype=bool)
        if n == 0 or not (self.system.cuts or self.layout.z):
            q[:, list(self.layout.y)] = y
            return q, fine
        parameters = np.repeat(self.parameters[:, None], n, 1)
        function = self._move.map(n)
        for _ in range(MOST_COMMON_STEPS):
            moved = np.array(function(q.T, y.T, *([parameters] if len(parameters) else []))).T
            size = np.abs(moved - q).max(axis=1, initial=0.0)
            fine &= size <= LARGEST_STEP  # also false where it is not a number
            q = np.where(fine[:, None], moved, q)
            if (size[fine] < CLOSED).all():
                break
        for k in np.flatnonzero(~fine | ~(size < CLOSED)):
            found = self.assemble(y[k], guesses[k])
            fine[k] = found is not None
            q[k] = guesses[k] if found is None else found
        return q, fine

    def follow(self, y: np.ndarray, start: np.ndarray) -> np.ndarray:
        """q (n, nq) along y (n, d) from a configuration near the first; where none is found the last one with y."""
        q = np.repeat(start[None], len(y), 0)
        near = start
        for k, target in enumerate(y):
            here = self.assemble(target, near)
            if here is None:
                here = np.array(near)
                here[list(self.layout.y)] = target
            else:
                near = here
            q[k] = here
        return q

    def pivots(self, q: np.ndarray) -> np.ndarray:
        """Smallest pivot of the closure without units at q (n, nq): near 0 the coordinates y are singular."""
        q = np.atleast_2d(q)
        parameters = [np.repeat(self.parameters[:, None], len(q), 1)] if len(self.parameters) else []
        found = np.array(self._pivots.map(len(q))(q.T, *parameters))
        return np.asarray(np.abs(found).min(axis=0, initial=1.0))

    def place(self, conditions: Conditions, where: str, near: np.ndarray) -> Placement:
        """A configuration near another that meets conditions (rates left aside), by damped least squares."""
        blocks = point_symbols(self.model, moving=False)
        at = MotionQuantities(self.model, blocks)
        labels = self.model.equations.labels
        rows = [*closure_rows(at), *condition_rows(at, replace(conditions, rates={}, at_rest=False), where)]
        rows += [
            Row(f"{label} at {where}", blocks["y"][k], conditions.coordinates[label], conditions.coordinates[label])
            for k, label in enumerate(labels)
            if label in conditions.coordinates
        ]
        target = np.array([(row.lower + row.upper) / 2 / row.scale for row in rows])
        unknown = ca.vertcat(blocks["y"], blocks["z"])
        others = ca.vertcat(blocks["y_1"], blocks["T"], blocks["tau"])
        parameters = blocks["p"]
        values = ca.vertcat(ca.SX(0, 1), *[row.value / row.scale for row in rows])
        function = ca.Function("place", [unknown, others, parameters], [values, ca.jacobian(values, unknown)])
        fixed = np.ones(others.numel())
        p = np.array([self.parameters[self.model.parameter_names.index(n)] for n in self.model.design])
        order = [*self.layout.y, *self.layout.z]
        known = set(self.model.coordinate_labels)
        strides = STRIDES if poses_of(self.system.mechanism, conditions.coordinates, known) else 1
        x, begin = near[order], np.array(function(near[order], fixed, p)[0]).ravel()
        for k in range(1, strides + 1):
            x, error = _least_missed(lambda x: function(x, fixed, p), x, begin + (target - begin) * k / strides)
        q = np.array(near)
        q[order] = x
        worst = int(np.argmax(np.abs(error))) if len(error) else -1
        if self.layout.closed:
            q = self._with_limbs(q)
        return Placement(q, float(np.abs(error).max(initial=0.0)), rows[worst].label if rows else "")

    def _with_limbs(self, q: np.ndarray) -> np.ndarray:
        """q with the limbs' coordinates from their closed forms; as it is where a limb cannot reach so far."""
        found = self.closure(q[None, list(self.layout.y)], q[None, list(self.layout.z)])[0][0]
        if not np.isfinite(found).all():
            return q
        closed = self.assemble(found[list(self.layout.y)], found)
        return found if closed is None else closed


def _least_missed(
    function: Callable[[np.ndarray], Sequence[Any]], x: np.ndarray, target: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """x near the given one at which `function` (values, slope by x) comes closest to the target, and what it misses."""
    damping = DAMPING
    value, slope = (np.array(m) for m in function(x))
    error = value.ravel() - target
    far = np.nan_to_num(np.abs(error).max(initial=0.0), nan=0.0, posinf=0.0) / LARGEST_STEP
    for _ in range(MOST_DAMPED_STEPS + int(min(STEPS_OF_A_STEP * far, MOST_FAR_STEPS))):
        if np.abs(error).max(initial=0.0) < CLOSED or not np.isfinite(error).all():
            break
        normal = slope.T @ slope + damping * np.eye(len(x))
        step = -np.linalg.solve(normal, slope.T @ error)
        step *= min(1.0, LARGEST_STEP / max(np.abs(step).max(), 1e-300))
        value, new_slope = (np.array(m) for m in function(x + step))
        new = value.ravel() - target
        if np.isfinite(new).all() and new @ new < error @ error:
            x, error, slope, damping = x + step, new, new_slope, max(damping / 10, LEAST_DAMPING)
        else:
            damping *= 10
            if damping > MOST_DAMPING:
                break
    return x, error

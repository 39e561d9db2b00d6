"""A start beside a singular configuration: what follows from the given values, with 60 digits.

    q, v in doubles --steps with their inverse, residuals and J in 60 digits--> q with loops closed, v with J v = 0

At a distance d from where the loops lose rank, closed to a rounding e they determine the other coordinates, and rates
that are given determine the others, to no more than e / d. The same steps with exact residuals end at doubles that are
right in their last bits: each step gains the digits that e / d leaves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT, in_sixty_digits
from symscrew.functions import jacobian_in_v
from symscrew.kinematics import System

BESIDE = 1e-4
"""Part of the largest singular value: with all above it, doubles are right to a few of their last four digits."""
LOST = 1e-11
"""Part of the largest below which a singular value is of no row: there a start is at the singular configuration."""
MOST_STEPS, ENOUGH = 12, 1e-30
"""Steps, and the length without units at which they end; the farthest from `BESIDE` gain five digits each."""


def beside_singular(matrix: np.ndarray) -> bool:
    """Whether rows without units nearly depend on one another, and do not quite."""
    if not matrix.size:
        return False
    values = np.linalg.svd(matrix, compute_uv=False)
    return bool(((values < BESIDE * values[0]) & (values > LOST * values[0])).any())


class FineStart:
    """The loops of a mechanism with 60 digits, and steps that close them."""

    def __init__(self, system: System, parameters: np.ndarray, rows: np.ndarray, units: np.ndarray) -> None:
        """`rows`, `units`: what the closure's rows are multiplied by, and rates divided by, to have no units."""
        self.system, self.rows, self.units = system, rows, units
        self.columns = jacobian_in_v(system)
        self.known = {n.index: CONTEXT.mpf(x) for n, x in zip(system.parameters, parameters, strict=True)}
        self.q: list[Any] = []

    def coordinates(self, q: np.ndarray, given: Mapping[int, float], places: np.ndarray) -> np.ndarray:
        """q (nq,) with the given entries as they are and the loops closed; q itself where steps do not converge.

        `places`: which rows (rows,) coordinates must obey.
        """
        tree, self.q = self.system.tree, [CONTEXT.mpf(x) for x in q]
        plain = {k: column for k, column in tree.plain if k in given}
        held = [k for in_q, in_v in tree.spheres if in_q in given for k in range(in_v, in_v + 3)]
        pick = np.eye(len(self.units))[[*plain.values(), *held]]
        for k in plain:
            self.q[k] = CONTEXT.mpf(given[k])
        for _ in range(MOST_STEPS):
            residual, jacobian = self._loops()
            right = [(given[k] - self.q[k]) / self.units[column] for k, column in plain.items()]
            right += [CONTEXT.zero] * len(held) + [-r for r, place in zip(residual, places, strict=True) if place]
            step = _applied(_inverse(np.concatenate([pick, _doubles(jacobian)[places]])), right)
            self._move(step)
            if max(map(abs, step), default=0) < ENOUGH:
                return np.array([float(x) for x in self.q])
        self.q = [CONTEXT.mpf(x) for x in q]
        return q

    def rates(self, given: np.ndarray, values: np.ndarray, v: np.ndarray) -> np.ndarray:
        """v (nv,) without units with the given rows (n, nv) at their values and J v = 0, from v in doubles."""
        jacobian = self._loops()[1]
        inverse = _inverse(np.concatenate([given, _doubles(jacobian)]))
        rows = [[CONTEXT.mpf(x) for x in row] for row in given] + jacobian
        right = [CONTEXT.mpf(x) for x in values] + [CONTEXT.zero] * len(jacobian)
        found = [CONTEXT.mpf(x) for x in v]
        for _ in range(MOST_STEPS):
            left = [b - CONTEXT.fdot(row, found) for row, b in zip(rows, right, strict=True)]
            step = _applied(inverse, left)
            found = [a + b for a, b in zip(found, step, strict=True)]
            if max(map(abs, step), default=0) < ENOUGH * max(1.0, float(np.abs(v).max(initial=0.0))):
                return np.array([float(x) for x in found])
        return v  # they contradict one another, as those who ask will see

    def _loops(self) -> tuple[list[Any], list[list[Any]]]:
        """Residual and rows of the Jacobian at q, without units."""
        system, count = self.system, len(self.rows)
        at = self.known | {n.index: x for n, x in zip(system.inputs.q, self.q, strict=True)}
        entries = [node for column in self.columns for node in column]
        values = in_sixty_digits([*system.residual, *entries], at)
        rows = [CONTEXT.mpf(x) for x in self.rows]
        units = [CONTEXT.mpf(x) for x in self.units]
        residual = [r * x for r, x in zip(rows, values[:count], strict=True)]
        return residual, [
            [values[count + k * count + i] * rows[i] * u for k, u in enumerate(units)] for i in range(count)
        ]

    def _move(self, step: Sequence[Any]) -> None:
        """q after a small step in rates without units; rotations turn about the child's axes."""
        for k, column in self.system.tree.plain:
            self.q[k] += step[column] * self.units[column]
        for in_q, in_v in self.system.tree.spheres:
            w, x, y, z = self.q[in_q : in_q + 4]
            a, b, c = (half / 2 for half in step[in_v : in_v + 3])
            turned = [w - x * a - y * b - z * c, x + w * a + y * c - z * b, y + w * b + z * a - x * c,
                      z + w * c + x * b - y * a]  # fmt: skip
            size = CONTEXT.sqrt(CONTEXT.fdot(turned, turned))
            self.q[in_q : in_q + 4] = [entry / size for entry in turned]


def _doubles(rows: Sequence[Sequence[Any]]) -> np.ndarray:
    return np.array([[float(x) for x in row] for row in rows])


def _inverse(matrix: np.ndarray) -> np.ndarray:
    return np.linalg.pinv(matrix, rcond=LOST)


def _applied(matrix: np.ndarray, vector: Sequence[Any]) -> list[Any]:
    return [CONTEXT.fdot(map(float, row), vector) for row in matrix]

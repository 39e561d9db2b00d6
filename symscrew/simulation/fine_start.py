"""A start beside a singular configuration: what follows from the given values, with 60 digits.

    q, v in doubles --steps with their inverse, residuals and J in 60 digits--> q with loops closed, v with J v = 0

At a distance d from where the loops lose rank, closed to a rounding e they determine the other coordinates, and rates
that are given determine the others, to no more than e / d. The same steps with exact residuals end at doubles that are
right in their last bits: each step gains the digits that e / d leaves.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT, in_sixty_digits
from symscrew.functions import jacobian_in_v
from symscrew.kinematics import System

BESIDE = 1e-2
"""Part of the largest singular value: with all above it, rates in doubles are right to about 1e-12."""
LOST = 1e-11
"""Part of the largest below which a singular value is of no row: there a start is at the singular configuration, as
which of two solutions so near one another is meant is known to 1e-12."""
MOST_STEPS, ENOUGH = 30, 1e-30
"""Steps, and the length without units at which they end."""
BEFORE = tuple((k / 128, (-1) ** (k + 1) * math.comb(6, k)) for k in range(1, 7))
"""Places before the end of a way, in parts of it, and their weights in the polynomial's value at the end: it is off by
the sixth power of their distances, and by 64 times what doubles leave there, whichever branches meet at the end."""


def nearly_free(matrix: np.ndarray) -> np.ndarray:
    """Directions (k, nv) that rows without units nearly leave free, and do not quite; none where doubles suffice."""
    _, values, directions = np.linalg.svd(matrix, full_matrices=False)
    largest = values.max(initial=0.0)
    return np.asarray(directions[(values < BESIDE * largest) & (values > LOST * largest)])


def left_free(matrix: np.ndarray) -> np.ndarray:
    """Directions (n, nv) along which rows (k, nv) without units are zero."""
    _, values, directions = np.linalg.svd(matrix)
    return np.asarray(directions[int((values > LOST * values.max(initial=0.0)).sum()) :])


def leading(matrix: np.ndarray, among: Sequence[int] | None = None) -> list[int]:
    """Columns that determine all others best where the rows (k, nv) are zero: as many as these leave free, or fewer
    where those `among` which they are do not determine all.

    One after the other: the column that moves most along what the ones before leave free.
    """
    free, found = left_free(matrix), list[int]()
    asked = np.ones(matrix.shape[1]) if among is None else np.isin(np.arange(matrix.shape[1]), among)
    for _ in range(len(free)):
        moved = np.linalg.norm(free, axis=0) * asked
        if not moved.max() > LOST:
            break
        found.append(int(np.argmax(moved)))
        along = free[:, found[-1]] / moved[found[-1]]
        free = free - np.outer(along, along @ free)
    return found


class FineStart:
    """The loops of a mechanism with 60 digits, and steps that close them."""

    def __init__(self, system: System, parameters: np.ndarray, rows: np.ndarray, units: np.ndarray) -> None:
        """`rows`, `units`: what the closure's rows are multiplied by, and rates divided by, to have no units."""
        self.system, self.rows, self.units = system, rows, units
        self.columns = jacobian_in_v(system)
        self.known = {n.index: CONTEXT.mpf(x) for n, x in zip(system.parameters, parameters, strict=True)}
        self.q: list[Any] = []

    def coordinates(self, q: np.ndarray, given: Mapping[int, float], places: np.ndarray) -> np.ndarray:
        """q (nq,) with the given entries as they are and the loops closed, but along what closes none.

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
                break
        return np.array([float(x) for x in self.q])

    def step(self, q: np.ndarray, other: np.ndarray) -> np.ndarray:
        """The small step in rates without units from q to another configuration."""
        step = np.zeros(len(self.units))
        for k, column in self.system.tree.plain:
            step[column] = (other[k] - q[k]) / self.units[column]
        for in_q, in_v in self.system.tree.spheres:
            (w, *vector), (wo, *vo) = q[in_q : in_q + 4], other[in_q : in_q + 4]
            step[in_v : in_v + 3] = 2 * (w * np.array(vo) - wo * np.array(vector) - np.cross(vector, vo))
        return step

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

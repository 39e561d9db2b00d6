"""Whether rank is really lost near a pose of a line: the equations of the loss solved to 60 digits, or shown to fail.

    q near a loss, kind --M(q) v = 0 for one vector more than at regular poses, loops closed--> q in 60 digits, or none

On a line of poses a margin that dips to 1e-6 may be zero or not: pins 1e-12 out of line leave that much. The unknowns
are the pose and the null vectors, so that Newton's method converges where branches cross, too; where its steps end and
the equations stay open there is no loss as typed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.motions.coordinate_lines import Setting, Track
from symscrew.mobility.motions.seen_poses import body_twists
from symscrew.mobility.screw_systems import eliminate

Array = np.ndarray[Any, Any]

LOST = 1e-5
"""Relative singular value below which a vector counts as a null vector of the loss."""
DIFFERENCE = 1e-5
"""Half the step of differences of M along the joints: derivatives are right to 1e-10, so a step gains ten digits."""
IN_DOUBLES, ROUNDS = 6, 12
"""Steps in doubles, then at most so many with residuals of 60 digits."""
SOLVED = 1e-30
"""Largest residual of equations that hold, in units of the mechanism's size."""
OPEN = 1e-26
"""Least residual of equations that do not."""
ENDED = 1e-7
"""Steps below this part of the residual have ended: what is left is perpendicular to all that unknowns can change."""
REGULAR = 1e-6
"""Relative singular value of the equations' Jacobian above which unknowns are told: below it nothing is concluded."""
NEARBY = 1e-2
"""A solution farther from a refined pose than this is of another one."""


@dataclass(frozen=True, eq=False)
class Loss:
    """A margin next to zero.

    Attributes:
        kind: of the margin.
        real: rank is lost at `q`, where the equations close to 60 digits; False: it is not; None: neither was shown.
        q: the pose; where rank is really lost in 60 digits.
        left: by how much the equations of the loss stay open where it is not real [rad, the mechanism's size].
    """

    kind: str
    real: bool | None
    q: Array
    left: float = 0.0

    @property
    def place(self) -> Array:
        """The pose in doubles."""
        return self.q.astype(float)


def decided(setting: Setting, line: Track, q: Array, kind: str, *, within: float = NEARBY) -> Loss:
    """Whether the margin of this kind is zero at a pose of the line next to q."""
    equations = _Equations(setting, line, kind)
    if equations.usual is None:
        return Loss(kind, None, q)
    return Loss(kind, *_solved(equations, q, within))


def at_pose(setting: Setting, line: Track, loss: Loss, known: Loss) -> Loss:
    """What was not told of a loss by itself, at the pose of another one, by the rank there in 60 digits."""
    equations = _Equations(setting, line, loss.kind)
    if equations.usual is None:
        return loss
    screws = equations.fine.displaced(known.q[None])[0]
    matrix = equations.matrix(equations.fine, screws, known.q)
    rank = eliminate(matrix.tolist(), matrix.shape[1]).rank
    lost = matrix.shape[1] - rank > equations.usual
    return replace(loss, real=True, q=known.q) if lost else loss


def freedoms_at(setting: Setting, q: Array, locked: Sequence[int] = ()) -> int:
    """Instantaneous freedoms at a pose of 60 digits, with the joint freedoms of some columns locked."""
    fine = setting.fine_with_spins
    slopes = np.delete(fine.slopes(q[None])[0], list(locked), axis=1)
    columns = int(slopes.shape[1])
    return columns - eliminate(slopes.tolist(), columns).rank


class _Equations:
    """Loops closed, held coordinates at rest, M(q) V = 0 with V = V0 + C W; unknowns q and W."""

    def __init__(self, setting: Setting, line: Track, kind: str) -> None:
        self.setting, self.held, self.kind, self.column = setting, line.held, kind, line.column
        self.coarse, self.fine = setting.variety, setting.fine
        self.turned = False
        self.usual = self._usual()
        rows = self.matrix(self.coarse, *self._reference()).shape
        if self.usual is not None and rows[0] - rows[1] + self.usual < self.usual:  # fewer vectors from the left
            self.turned, self.usual = True, rows[0] - rows[1] + self.usual

    def _reference(self) -> tuple[Array, Array]:
        origin = np.zeros(self.coarse.columns)
        return self.coarse.displaced(origin[None])[0], origin

    def _usual(self) -> int | None:
        """Null vectors of M at regular poses; None where that is not known."""
        dimension = self.setting.dimension
        if self.kind == "closure":
            return dimension if self.coarse.rows else None
        if self.kind == "platform":
            return dimension - self.setting.order
        if self.kind in ("drives", "coordinate"):
            return 0 if self.kind == "drives" or len(self.held) == dimension - 1 else None
        columns, rank = self.setting.limbs[self.kind]
        return len(columns) - rank

    def matrix(self, variety: ClosureVariety, screws: Array, q: Array) -> Array:
        """M at a pose, in the arithmetic of the variety, or its transpose where fewer vectors vanish on that side."""
        return np.asarray(self.matrices(variety, screws[None], q[None])[0])

    def matrices(self, variety: ClosureVariety, screws: Array, q: Array) -> Array:
        """The same at N poses."""
        found = self._matrices(variety, screws, q)
        return np.swapaxes(found, 1, 2) if self.turned else found

    def _matrices(self, variety: ClosureVariety, screws: Array, q: Array) -> Array:
        if self.kind in self.setting.limbs:
            return np.swapaxes(screws[:, list(self.setting.limbs[self.kind][0])], 1, 2)
        jacobians: Array = variety.jacobians(screws, q)
        if self.kind == "closure":
            return jacobians
        if self.kind == "platform":
            more = body_twists(self.setting.network, variety, screws, self.setting.body)
        else:
            picked = self.setting.drives if self.kind == "drives" else (*self.held, self.column)
            more = np.repeat(np.eye(self.coarse.columns)[None, list(picked)], len(q), axis=0)
        return np.concatenate([jacobians, more.astype(jacobians.dtype)], axis=1)

    def at(self, variety: ClosureVariety, q: Array, vectors: Array) -> Array:
        """What is left of the equations."""
        screws = variety.displaced(q[None])[0]
        loops = variety.residual(q) if self.coarse.rows else q[:0]
        return np.concatenate([loops, q[list(self.held)], _product(self.matrix(variety, screws, q), vectors).ravel()])

    def slopes(self, q: Array, vectors: Array, across: Array) -> Array:
        """Their Jacobian by q and W, in doubles."""
        count, width = len(q), vectors.shape[1]
        points = np.concatenate([q + DIFFERENCE * np.eye(count), q - DIFFERENCE * np.eye(count)])
        screws = self.coarse.displaced(points)
        values = self.matrices(self.coarse, screws, points) @ vectors
        bent = (values[:count] - values[count:]).reshape(count, -1).T / (2 * DIFFERENCE)
        here = self.coarse.displaced(q[None])
        loops = self.coarse.jacobians(here, q[None])[0]
        linear = np.kron(self.matrix(self.coarse, here[0], q) @ across, np.eye(width))
        top = np.concatenate([loops, np.eye(count)[list(self.held)]])
        empty = np.zeros((len(top), linear.shape[1]))
        return np.block([[top, empty], [bent, linear]])


def _product(matrix: Array, vectors: Array) -> Array:
    """Matrix times vectors; most entries of a matrix of 60 digits are zero, and left out."""
    if matrix.dtype != object:
        return np.asarray(matrix @ vectors)
    result = np.empty((len(matrix), vectors.shape[1]), dtype=object)
    for i, row in enumerate(matrix):
        columns = [j for j, c in enumerate(row) if c]
        for k in range(vectors.shape[1]):
            result[i, k] = CONTEXT.fdot(row[columns], vectors[columns, k])
    return result


def _solved(equations: _Equations, start: Array, within: float) -> tuple[bool | None, Array, float]:
    """(whether there is a solution next to the pose, it or the pose, what is left of the equations)."""
    screws = equations.coarse.displaced(start[None])[0]
    _, s, vt = np.linalg.svd(equations.matrix(equations.coarse, screws, start))
    size = len(vt)
    null = max(size - int((s > LOST * max(s[0], LOST)).sum()), (equations.usual or 0) + 1)
    null = min(null, size)
    vectors, across = vt[size - null :].T, vt[: size - null].T
    q, step = start, np.zeros(0)
    regular = False
    for _ in range(IN_DOUBLES):
        slopes = equations.slopes(q, vectors, across)
        u, values, rows = np.linalg.svd(slopes, full_matrices=False)
        kept = values > REGULAR * values[0]
        regular = len(slopes) >= slopes.shape[1] and bool(kept.all())
        inverse = (rows[kept].T / values[kept]) @ u[:, kept].T
        step = inverse @ equations.at(equations.coarse, q, vectors)
        q, vectors = q - step[: len(q)], vectors - across @ step[len(q) :].reshape(-1, null)
        if np.linalg.norm(q - start) > within:
            return None, start, 0.0
        if np.linalg.norm(step) < DIFFERENCE**2:
            break
    return _with_digits(equations, start, (q, vectors, across), inverse, regular=regular)


def _with_digits(
    equations: _Equations, start: Array, found: tuple[Array, Array, Array], inverse: Array, *, regular: bool
) -> tuple[bool | None, Array, float]:
    """The same with residuals of 60 digits, the inverse in doubles: each step gains about ten."""
    q, vectors, across = (np.vectorize(CONTEXT.mpf, otypes=[object])(part) for part in found)
    coarse = found[2]
    best = np.inf
    for _ in range(ROUNDS):
        left = equations.at(equations.fine, q, vectors).astype(float)
        size = float(np.linalg.norm(left))
        if size < SOLVED:
            return True, q, size
        step = inverse @ left
        if regular and size > OPEN and np.linalg.norm(step) < ENDED * size:
            return False, q.astype(float), size
        if size > best:
            break
        best = size
        q = q - step[: len(q)]
        vectors = vectors - across @ step[len(q) :].reshape(coarse.shape[1], -1)
    return None, start, 0.0

"""The equations of a structure for many points at once, in complex doubles, along a way between two sets of numbers.

    numbers in the slots, a function of s --interpolation--> coefficients(s), polynomials
    coefficients, z [paths x coordinates] --products of dual quaternions--> F [paths x rows], dF/dz

Coordinates z are homogeneous in each group. Rows: the forms of all loops, Study's quadric of free bodies.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from symscrew.assembly import dual_forms as forms
from symscrew.assembly.closure_structure import WIDTH, Loop, Structure
from symscrew.assembly.slot_numbers import matrices, spins_of

Array = np.ndarray[Any, Any]

PRODUCT = forms.PRODUCT.astype(float)
CONJUGATE = forms.CONJUGATE.astype(float)
LEFT = PRODUCT.transpose(1, 0, 2).reshape(forms.SIZE, -1)
"""a -> the matrix of multiplication with a from the left, in rows."""
RIGHT = PRODUCT.transpose(2, 0, 1).reshape(forms.SIZE, -1)
"""a -> the matrix of multiplication with a from the right, in rows."""


def _times(table: Array, a: Array) -> Array:
    """The matrices N x 8 x 8 of multiplication with N dual quaternions."""
    return np.asarray((a @ table).reshape(len(a), forms.SIZE, forms.SIZE))


@dataclass(frozen=True)
class _Factor:
    """A group in the way around a loop; `back`: passed towards the ground.

    `motion`: the place of its displacement, first those of the groups, then those of what couplings tie.
    """

    group: int
    back: bool
    motion: int


class BatchEquations:
    """F and dF/dz of a structure. `parts`: the coordinates of each group."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        starts = np.cumsum([0, *(WIDTH[g.kind] for g in structure.groups)])
        self.parts = [slice(int(a), int(b)) for a, b in pairwise(starts)]
        self.width = int(starts[-1])
        self.free = [k for k, g in enumerate(structure.groups) if g.kind == "free"]
        self.spins = [m.astype(complex)[None] for m in spins_of(structure)]
        self.made_of = [*self.parts, *(self.parts[spin.group] for spin in structure.spins)]
        self.ways = [self._way(loop) for loop in structure.loops]
        sample = matrices(structure, [1.0 if s.kind in ("number", "distance") else np.ones(3) for s in structure.slots])
        self.shapes = [m.shape for m in sample[0]], [(q.shape, l.shape) for q, l in sample[1]]
        self.sizes = [m.size for m in sample[0]] + [n for q, l in sample[1] for n in (q.size, l.size)]
        self.ends = np.cumsum([0, *self.sizes])
        self.rows = sum(q[0] + l[0] for q, l in self.shapes[1]) + len(self.free)

    def _way(self, loop: Loop) -> tuple[_Factor, ...]:
        count, spins = len(self.parts), self.structure.spins
        if loop.spins:
            return tuple(_Factor(spins[k].group, back, count + k) for k, back in loop.spins)
        one, two = self.structure.chains[loop.base], self.structure.chains[loop.body]
        common = 0
        while common < min(len(one), len(two)) and one[common] == two[common]:
            common += 1
        return (*(_Factor(k, True, k) for k in reversed(one[common:])), *(_Factor(k, False, k) for k in two[common:]))

    def coefficients(self, slots: Sequence[Any]) -> Array:
        """All entries of all matrices in a row."""
        motions, loops = matrices(self.structure, slots)
        parts = [m.astype(complex).ravel() for m in motions]
        parts += [a.astype(complex).ravel() for loop in loops for a in loop]
        return np.concatenate(parts)

    def evaluate(self, z: Array, c: Array) -> tuple[Array, Array]:
        """(F N x rows, dF/dz N x rows x width) at points N x width with coefficients N x all, or one row for all."""
        values = np.zeros((len(z), self.rows), dtype=complex)
        slopes = np.zeros((len(z), self.rows, self.width), dtype=complex)
        motions, loops = self._matrices(c)
        made = self._made(motions, z)
        row = 0
        for way, loop in zip(self.ways, loops, strict=True):
            g, along = self._product(way, made, motions)
            both, values[:, row : row + self._size(loop)] = self._forms(loop, g)
            for factor, slope in along:
                slopes[:, row : row + self._size(loop), self.parts[factor.group]] += both @ slope
            row += self._size(loop)
        for k in self.free:
            x = z[:, self.parts[k]]
            values[:, row] = (x[:, :4] * x[:, 4:]).sum(axis=1)
            slopes[:, row, self.parts[k]] = np.concatenate([x[:, 4:], x[:, :4]], axis=1)
            row += 1
        return values, slopes

    def values(self, z: Array, c: Array) -> Array:
        """F alone, N x rows, as `evaluate` gives it: a third of its time."""
        values = np.zeros((len(z), self.rows), dtype=complex)
        motions, loops = self._matrices(c)
        made = self._made(motions, z)
        row = 0
        for way, loop in zip(self.ways, loops, strict=True):
            g = self._passed(way, made)[1][-1]
            values[:, row : row + self._size(loop)] = self._forms(loop, g)[1]
            row += self._size(loop)
        for k in self.free:
            x = z[:, self.parts[k]]
            values[:, row] = (x[:, :4] * x[:, 4:]).sum(axis=1)
            row += 1
        return values

    def _matrices(self, c: Array) -> tuple[list[Array], list[tuple[Array, Array]]]:
        """(of each group's motion, (quadratic forms, linear forms) of each loop) out of coefficients in a row."""
        pieces = [c[:, a:b] for a, b in pairwise(self.ends)]
        motions = [p.reshape(len(c), *shape) for p, shape in zip(pieces, self.shapes[0], strict=False)]
        rest = iter(pieces[len(motions) :])
        loops = [(next(rest).reshape(len(c), *q), next(rest).reshape(len(c), *l)) for q, l in self.shapes[1]]
        return [*motions, *self.spins], loops

    def _made(self, motions: Sequence[Array], z: Array) -> list[Array]:
        """The displacement that each group makes, and what couplings tie, N x 8."""
        return [(m @ z[:, part, None])[..., 0] for m, part in zip(motions, self.made_of, strict=True)]

    @staticmethod
    def _size(loop: tuple[Array, Array]) -> int:
        """Rows of a loop."""
        return len(loop[0][0]) + len(loop[1][0])

    @staticmethod
    def _forms(loop: tuple[Array, Array], g: Array) -> tuple[Array, Array]:
        """(the derivative of a loop's forms by the displacement around it, the forms themselves)."""
        square, linear = loop
        steep = (square @ g[:, None, :, None])[..., 0]
        both = np.concatenate([steep, np.broadcast_to(linear, (len(g), *linear.shape[1:]))], axis=1)
        values = (both @ g[..., None])[..., 0]
        values[:, : steep.shape[1]] *= 0.5
        return both, values

    @staticmethod
    def _passed(way: Sequence[_Factor], made: Sequence[Array]) -> tuple[list[Array], list[Array]]:
        """(the displacements on the way around a loop, the product of those up to each)."""
        turned = [made[f.motion] * CONJUGATE if f.back else made[f.motion] for f in way]
        before = [turned[0]]
        for factor in turned[1:]:
            before.append((_times(LEFT, before[-1]) @ factor[..., None])[..., 0])
        return turned, before

    def _product(
        self, way: Sequence[_Factor], made: Sequence[Array], motions: Sequence[Array]
    ) -> tuple[Array, list[tuple[_Factor, Array]]]:
        """(g, its derivative by each group on the way)."""
        turned, before = self._passed(way, made)
        slopes = [motions[f.motion] * CONJUGATE[:, None] if f.back else motions[f.motion] for f in way]
        result: list[tuple[_Factor, Array]] = []
        behind = None
        for k in range(len(way) - 1, -1, -1):
            slope = slopes[k]
            if k:
                slope = _times(LEFT, before[k - 1]) @ slope
            if behind is not None:
                slope = _times(RIGHT, behind) @ slope
            result.append((way[k], slope))
            behind = turned[k] if behind is None else (_times(LEFT, turned[k]) @ behind[..., None])[..., 0]
        return before[-1], result

    def patches(self, z: Array) -> Array:
        """Rows that keep each group across itself: a step along a group is none."""
        rows = np.zeros((len(z), len(self.parts), self.width), dtype=complex)
        for k, part in enumerate(self.parts):
            rows[:, k, part] = z[:, part].conj()
        return rows

    def scaled(self, z: Array) -> Array:
        """The same points with groups of length one."""
        result = z.copy()
        for part in self.parts:
            result[:, part] /= np.linalg.norm(z[:, part], axis=1, keepdims=True)
        return result

    def norms(self, z: Array) -> Array:
        """Of each group how far it is from no displacement at all: |x^2| of points of length one, N x groups."""
        result = np.ones((len(z), len(self.parts)))
        for k, (part, group) in enumerate(zip(self.parts, self.structure.groups, strict=True)):
            x = z[:, part]
            if group.kind == "slide":
                result[:, k] = np.abs(x[:, 0]) ** 2
            elif group.kind == "planar":
                result[:, k] = np.abs((x[:, :2] ** 2).sum(axis=1))
            elif group.kind == "turn":
                result[:, k] = np.abs((x**2).sum(axis=1))  # of an axis of length one
            else:
                result[:, k] = np.abs((x[:, :4] ** 2).sum(axis=1))
        return result


class Way:
    """Coefficients between two sets of numbers, s = 0 ... 1 (complex too), by interpolation at Chebyshev's points."""

    def __init__(self, equations: BatchEquations, slots: Callable[[complex], Sequence[Any]], degree: int) -> None:
        """`slots`: the numbers at s; `degree`: of the polynomials, 2 where slots are linear in s."""
        self.degree = degree
        nodes = np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))
        values = np.stack([equations.coefficients(slots((1 + x) / 2)) for x in nodes])
        self.table = np.linalg.solve(np.polynomial.chebyshev.chebvander(nodes, degree), values)

    def at(self, s: Array) -> Array:
        """Coefficients at s (N,): N x all."""
        x = 2 * np.asarray(s) - 1
        basis = [np.ones_like(x), x]
        for _ in range(2, self.degree + 1):
            basis.append(2 * x * basis[-1] - basis[-2])
        return np.asarray(np.stack(basis[: self.degree + 1], axis=1) @ self.table)


def straight(start: Sequence[Any], end: Sequence[Any]) -> Callable[[complex], list[Any]]:
    """Numbers on the straight line between two sets."""
    return lambda s: [(1 - s) * np.asarray(a) + s * np.asarray(b) for a, b in zip(start, end, strict=True)]

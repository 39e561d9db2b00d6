"""Motion along the admissible directions of the closure: v = N z, with z the free joint rates.

Every admissible motion of the tree is v = N z (columns of N: the rates that a unit free joint rate brings
about, all loops staying closed), every acceleration a = N z' + p, where p takes the loops' own curvature at
z' = 0. By virtual work along the columns of N the wrenches of cut joints drop out:

    N^T M N z' = N^T (f - M p),      f = generalised forces at a = 0, drives included

which needs no multipliers and no inverse of the tree's mass matrix. For a tree N is the identity.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.algebra import Guard, Node, magnitude, named_entries
from symscrew.dynamics.articulated import articulated_accelerations
from symscrew.dynamics.coriolis import still_forces
from symscrew.dynamics.drives import solve_symmetric
from symscrew.dynamics.projection import Projection
from symscrew.dynamics.rods import rod_forces, rod_matrix, thin_rods
from symscrew.dynamics.tree_dynamics import generalised_forces, in_joint_rates, mass_matrix
from symscrew.effects import Acting, AddedInertia
from symscrew.kinematics import System
from symscrew.loops import Loops, counts_all_ways

LONG = 10
"""Trees with more freedoms take fewer operations by articulated bodies, which grow with their number, than by the mass
matrix, which grows with its square and more: a chain of 10 revolute joints takes 2086 against 2059, one of 11 takes
2371 against 2488. Only the one way is built."""

MASSLESS = 1e-13
"""Least eigenvalue of an inertia whose diagonal is 1 that counts as mass: rounding leaves 1e-16 per operation of a
motion that moves none, and real bodies, whose masses differ by less than 1e10, are above. Below it forward dynamics is
left out with a note; above it is derived, and its guards tell where it is singular. So does a diagonal entry of
which this share is left of what its motion would move joint by joint: all of it cancels."""

NOTHING = 1e-26
"""Of the largest inertia of the tree's joints, lengths divided by the characteristic length: a link without mass has
the square of rounding, 1e-32, where mass on axes is handed on; grains of 1e-10 of the mass and 1e-4 of the length are
above."""

Matrix = Sequence[Sequence[Node]]
Accelerations = tuple[list[Node], list[Node], list[Guard]]


def by_articulated_bodies(system: System) -> bool:
    """Whether forward dynamics is that of articulated bodies: of long trees without loops, see `LONG`."""
    return not system.cuts and len(system.tree.v) > LONG


class Admissible:
    """The motions w = N z that the closure of a system allows at its nodes q, v, and the dynamics along them.

    Everything is for the free joint rates z of `loops`, in their order. `added` is inertia beside the bodies'.
    """

    def __init__(self, system: System, loops: Loops, added: AddedInertia | None = None) -> None:
        self.system, self.loops, self.added = system, loops, added

    @cached_property
    def columns(self) -> list[list[Node]]:
        """N in joint rates w, column by column."""
        tape, count = self.system.tape, len(self.loops.free)
        zero_right = [tape.zero] * len(self.system.jacobian)
        return [
            self._named(
                self.loops.dependent(zero_right, [tape.one if i == k else tape.zero for i in range(count)]),
                "null_space",
                self._labels[k],
            )
            for k in range(count)
        ]

    @cached_property
    def tree_columns(self) -> list[list[Node]]:
        """N in v."""
        return [self.system.tree_rates(column) for column in self.columns]

    def moved(self, start: Sequence[Node], amounts: Sequence[Node]) -> list[Node]:
        """start + N amounts, in joint rates w."""
        result = list(start)
        for column, amount in zip(self.columns, amounts, strict=True):
            result = [r + entry * amount for r, entry in zip(result, column, strict=True)]
        return result

    def curvature(self) -> list[Node]:
        """p in joint rates w: accelerations of the tree with all free joint rates steady."""
        still = [self.system.tape.zero] * len(self.loops.free)
        gains = self.loops.dependent([-b for b in self.loops.bias(self.system)], still)
        return self._named(gains, "joint_acceleration_still")

    def accelerations(self, acting: Acting) -> Accelerations:
        """z' (free joint accelerations) and a (tree) under everything that acts, and the guarded pivots.

        Of the `ways`, equal but for rounding, the one with the fewest operations.
        """
        return min(self.ways(acting), key=lambda way: self.loops.cost(way[1]))

    def ways(self, acting: Acting) -> list[Accelerations]:
        """By the columns of N and handed on from rate to rate; both again with thin rods as masses at their ends.

        Handed on, the forces at rest accelerations are those of each branch's shorter way, or all the recursion's: by
        branches alone these are shorter, but the recursion's share more with the rest of a Stewart platform.
        """
        if by_articulated_bodies(self.system):
            a, guards = articulated_accelerations(self.system, acting)
            gains = self.system.joint_rates(a)
            return [([gains[k] for k in self.loops.free], a, guards)]
        system, tree = self.system, mass_matrix(self.system, self.added)
        ways = [self._by_columns(tree, lambda a: generalised_forces(system, acting, a))]
        if system.cuts and counts_all_ways(system):
            still = [system.tape.zero] * len(system.tree.v)
            ways.append(self._handed_on(tree, still_forces(system, acting, tree)))
            rods = thin_rods(system, acting)
            if rods:
                lean = rod_matrix(system, rods, self.added)
                ways.append(self._by_columns(lean, lambda a: rod_forces(system, acting, rods, a)))
                ways.append(self._handed_on(lean, rod_forces(system, acting, rods, still)))
            ways.append(self._handed_on(tree, generalised_forces(system, acting, still)))
        return ways

    def _by_columns(self, tree: Matrix, forces: Callable[[Sequence[Node]], list[Node]]) -> Accelerations:
        """With the columns of N, and the forces (for v) that the tree of this mass matrix needs at accelerations p."""
        start = self.curvature()
        missing = forces(self.system.tree_rates(start))
        right = [-_inner(self.system, column, missing) for column in self.tree_columns]
        named_entries(right, "reduced_force", self._labels)
        free, guards = self._solved(self._projected(tree), right)
        gains = self._named(self.moved(start, free), "joint_acceleration")
        return free, self.system.tree_rates(gains), guards

    def _handed_on(self, tree: Matrix, still: Sequence[Node]) -> Accelerations:
        """With inertia and forces handed on from the dependent rates to the free ones, limb by limb."""
        system, free = self.system, self.loops.free
        missing, opening = system.joint_rates(still), self.loops.bias(system)
        projection = Projection(system.tape, self.loops.elimination, in_joint_rates(system, tree), self.loops.label)
        right = [-value for value in projection.forces(missing, opening, free)]
        named_entries(right, "reduced_force", self._labels)
        inertia = projection.inertia(free)
        for label, row in zip(self._labels, inertia, strict=True):
            named_entries(row, "reduced_inertia", [f"{label}|{by}" for by in self._labels])
        found, guards = self._solved(inertia, right)
        gains = projection.accelerations(dict(zip(free, found, strict=True)), opening)
        return found, system.tree_rates(self._named(gains, "joint_acceleration")), guards

    def residual(self, a: Sequence[Node], acting: Acting) -> list[Node]:
        """N^T (generalised forces of the tree at its accelerations a, less what acts): zero for a motion."""
        missing = generalised_forces(self.system, acting, a)
        return [_inner(self.system, column, missing) for column in self.tree_columns]

    @cached_property
    def inertia(self) -> list[list[Node]]:
        """N^T M N; only the lower half counts."""
        return self._projected(self._tree_inertia)

    @cached_property
    def _tree_inertia(self) -> Matrix:
        """M of the tree, in v."""
        return mass_matrix(self.system, self.added)

    def _projected(self, tree: Matrix) -> list[list[Node]]:
        system, rows = self.system, []
        sparse = [_entries(system, column) for column in self.tree_columns]
        labels = self._labels
        for k, column in enumerate(sparse):
            pushed = [_paired(system, column, row) for row in tree]
            rows.append([_paired(system, sparse[i], pushed) for i in range(k + 1)])
            named_entries(rows[-1], "reduced_inertia", [f"{labels[k]}|{by}" for by in labels[: k + 1]])
        return rows

    def _named(self, values: list[Node], quantity: str, by: str = "") -> list[Node]:
        """Values per joint rate, called so."""
        named_entries(values, quantity, [f"{c.label}|{by}" for c in self.system.tree.v])
        return values

    @property
    def _labels(self) -> list[str]:
        """What the free joint rates are called."""
        return [self.system.tree.v[k].label for k in self.loops.free]

    def solve(self, right: Sequence[Node]) -> tuple[list[Node], list[Guard]]:
        """z' from the projected equations; last columns first, so that branches of a tree stay apart."""
        return self._solved(self.inertia, right)

    def _solved(self, lower: Sequence[Sequence[Node]], right: Sequence[Node]) -> tuple[list[Node], list[Guard]]:
        n = len(lower)
        order = range(n)[::-1]
        full = [[lower[max(i, j)][min(i, j)] for j in order] for i in order]
        scales = [1.0 / max(1e-300, magnitude(self.system.tape, full[i][i], 1.0)[1]) for i in range(n)]
        solution, guards = solve_symmetric(self.system.tape, full, [right[i] for i in order], scales)
        return solution[::-1], list(guards)

    def moves_mass(self) -> bool:
        """Whether every admissible motion moves mass, at some sample state at least."""
        lower, tape = self.inertia, self.system.tape
        n = len(lower)
        entries = [tape.sample(lower[max(i, j)][min(i, j)]) for i in range(n) for j in range(n)]
        if not entries:
            return True
        inertia = np.stack(np.broadcast_arrays(np.zeros(1), *entries, *self._sizes()), axis=-1)[:, 1:]
        inertia = inertia[np.isfinite(inertia).all(axis=1)]  # not so where a reference is singular
        if not len(inertia):
            return True
        inertia, sizes = inertia[:, : n * n].reshape(-1, n, n), inertia[:, n * n :].max(axis=0)
        own = np.abs(np.einsum("kii->ki", inertia)).max(axis=0)
        scale = np.sqrt(own)
        return bool(
            (own > np.maximum(MASSLESS * sizes, self._least())).all()
            and any(_above(one / np.outer(scale, scale), MASSLESS) for one in inertia)
        )

    def _sizes(self) -> list[Any]:
        """Per column of N the inertia that its motion would move if no joint's share cancelled another's, sampled."""
        tape, tree = self.system.tape, self._tree_inertia
        return [
            sum(tape.sample(entry) ** 2 * np.abs(tape.sample(tree[k][k])) for k, entry in _entries(self.system, column))
            for column in self.tree_columns
        ]

    def _least(self) -> np.ndarray[Any, Any]:
        """Per column of N the inertia that is nothing."""
        tape, scales = self.system.tape, self.system.scales
        own = [np.nanmax(np.abs(tape.sample(row[k]))) for k, row in enumerate(self._tree_inertia)]
        largest: float = np.max(np.array(own) * scales**2)
        return NOTHING * largest / scales[self.loops.free] ** 2

    def nearest(self, w: Sequence[Node], scales: Sequence[float]) -> tuple[list[Node], list[Guard]]:
        """N c with the c that brings it closest to w; `scales` divide the entries of w before they are squared."""
        tape = self.system.tape
        weights = [tape.constant(1.0 / (s * s)) for s in scales]
        weighted = [[e * f for e, f in zip(column, weights, strict=True)] for column in self.columns]
        normal = [[_inner(self.system, a, b) for b in self.columns] for a in weighted]
        right = [_inner(self.system, column, w) for column in weighted]
        sizes = [1.0 / max(1e-300, magnitude(tape, normal[i][i], 1.0)[1]) for i in range(len(normal))]
        amounts, guards = solve_symmetric(tape, normal, right, sizes)
        return self.moved([tape.zero] * len(w), amounts), list(guards)


def _above(matrix: np.ndarray[Any, Any], least: float) -> bool:
    """Whether all eigenvalues of a symmetric matrix are above a number: the rest has a Cholesky factor then."""
    try:
        np.linalg.cholesky(matrix - least * np.eye(len(matrix)))
    except np.linalg.LinAlgError:
        return False
    return True


def _inner(system: System, x: Sequence[Node], y: Sequence[Node]) -> Node:
    return _paired(system, _entries(system, x), y)


def _entries(system: System, x: Sequence[Node]) -> list[tuple[int, Node]]:
    """The entries of a vector that are not always zero: of long trees and chains of loops these are few."""
    return [(k, entry) for k, entry in enumerate(x) if entry is not system.tape.zero]


def _paired(system: System, x: Sequence[tuple[int, Node]], y: Sequence[Node]) -> Node:
    total = system.tape.zero
    for k, entry in x:
        total = total + entry * y[k]
    return total

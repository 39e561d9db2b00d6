"""Numbers of a geometry with conditions on it: steps in doubles along their slopes, residuals in 60 digits.

    loops closed in configurations, vectors in null spaces, links alike --linearised--> least steps of Gauss-Newton

Conditions have unknowns of their own: the configuration in which loops close, the null vector of a rank that is lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.finite.alike_links import Alike
from symscrew.mobility.finite.almost_ranks import LEAST, RankClaim
from symscrew.mobility.finite.double_zeros import Conditions
from symscrew.mobility.finite.joint_changes import Slots, about, changed, closure_rates, count_of, screw_rates, slots_of
from symscrew.mobility.finite.local_solutions import local_at
from symscrew.mobility.finite.variety import DIGITS_60, Array, ClosureVariety
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Real

CLEARLY = 30.0
"""A singular value so many times the next smaller one stands clear of it: those that are rounding are within three of
each other, one that was not stood two hundred times above them."""


@dataclass(frozen=True)
class _Linear:
    """A condition linearised: `left` are the parts that its own unknowns cannot make vanish, `by_z` of the geometry."""

    left: Array
    inverse: Array
    by_z: Array


class _Closes:
    """The loops close in a configuration, which may change a little."""

    def __init__(self, q: Array, rank: int) -> None:
        self.q, self.rank = _fine(q), rank

    def residual(self, fine: ClosureVariety) -> Array:
        return fine.residual(self.q).astype(float)

    def step(self, change: Array) -> None:
        self.q = self.q - _fine(change)


class _Singular:
    """A vector stays in the null space of a claim's matrix; it may change a little across it."""

    def __init__(self, claim: RankClaim, rank: int, vector: Array) -> None:
        self.claim, self.rank, self.vector = claim, rank, _fine(vector)

    def residual(self, matrix: Sequence[Sequence[tuple[int, Real]]]) -> Array:
        """`matrix`: the claim's, the entries of every row that are not zero with their columns."""
        return np.array([float(CONTEXT.fdot((c, self.vector[j]) for j, c in row)) for row in matrix])

    def step(self, change: Array) -> None:
        self.vector = self.vector - _fine(change)


class _Meant:
    """Relations of links that hold; they have no unknowns of their own."""

    def __init__(self, alike: Alike) -> None:
        self.alike = alike

    def residual(self, network: Network) -> Array:
        return self.alike.residual(network)

    def step(self, change: Array) -> None:
        """Nothing of its own."""


_Conditions = tuple[list[_Closes], list[_Singular], list[_Meant]]


def _fine(values: Array) -> Array:
    return np.array([CONTEXT.mpf(float(c)) for c in values], dtype=object)


def _conditions(
    network: Network, points: Sequence[tuple[Array, int]], ranks: Sequence[tuple[RankClaim, int]], alike: Alike | None
) -> _Conditions:
    centre = np.array(ClosureVariety(network).centre, dtype=object)
    singular = []
    for claim, rank in ranks:
        vectors = np.linalg.svd(claim.matrix(network, centre).astype(float))[2][rank:]
        singular += [_Singular(claim, rank, vector) for vector in vectors]
    return [_Closes(q, rank) for q, rank in points], singular, [] if alike is None else [_Meant(alike)]


def _linear(network: Network, slots: Slots, conditions: _Conditions) -> list[_Linear]:
    """All conditions linearised about the geometry and their own unknowns, in doubles."""
    coarse = ClosureVariety(network)
    centre = np.array(coarse.centre, dtype=object)
    closes, singular, meant = conditions
    result = []
    if closes:
        batch = np.array([one.q.astype(float) for one in closes])
        for one, q, by_z in zip(closes, batch, closure_rates(coarse, slots, batch), strict=True):
            place = local_at(coarse, q, rank=one.rank)
            result.append(_Linear(place.stresses, place.inverse, by_z))
    rates = screw_rates(network, slots, centre.astype(float))
    screws = np.array([about(screw, centre) for edge in network.edges.values() for screw in edge.screws])
    decomposed = {}
    for vanishing in singular:
        claim, rank = vanishing.claim, vanishing.rank
        if claim.name not in decomposed:
            decomposed[claim.name] = np.linalg.svd(claim.in_doubles(network, screws))
        u, s, vt = decomposed[claim.name]
        inverse = vt[:rank].T @ ((u[:, :rank] / s[:rank]).T)
        pulled = claim.pulled(network, rates, vanishing.vector.astype(float))
        result.append(_Linear(u[:, rank:].T, inverse, pulled))
    for relations in meant:
        by_z = relations.alike.rates(network, slots)
        result.append(_Linear(np.eye(len(by_z)), np.zeros((0, len(by_z))), by_z))
    return result


class Search:
    """Numbers z of the geometry with conditions on it: steps in doubles, residuals in 60 digits."""

    def __init__(
        self,
        network: Network,
        points: Sequence[tuple[Array, int]],
        ranks: Sequence[tuple[RankClaim, int]],
        alike: Alike | None = None,
    ) -> None:
        self.network, self.slots = network, slots_of(network)
        self.conditions = _conditions(network, points, ranks, alike)
        self.z = np.array([CONTEXT.zero] * count_of(self.slots), dtype=object)
        self.after = network
        self.linear: list[_Linear] = []
        self.ways: Array | None = None
        """Columns of z along which it may change; None: all."""

    def residuals(self) -> list[Array]:
        """What is left of every condition."""
        fine, (closes, singular, meant) = ClosureVariety(self.after, DIGITS_60), self.conditions
        centre = np.array(fine.centre, dtype=object)
        matrices = {}  # of a claim one: a rank that is lost by three has three vectors
        for claim in {one.claim.name: one.claim for one in singular}.values():
            rows = claim.matrix(self.after, centre)
            matrices[claim.name] = [[(j, c) for j, c in enumerate(row) if c] for row in rows]
        own = [one.residual(matrices[one.claim.name]) for one in singular]
        return [*(one.residual(fine) for one in closes), *own, *(one.residual(self.after) for one in meant)]

    def linearise(self) -> None:
        """All conditions about the present numbers, which are then kept until this is asked for anew."""
        self.linear = _linear(self.after, self.slots, self.conditions)

    def step(self, residuals: Sequence[Array], cut: float) -> Array:
        """One step of Gauss-Newton with the least change, for singular values above `cut` of the largest: dz."""
        missing = np.concatenate([one.left @ r for one, r in zip(self.linear, residuals, strict=True)])
        dz = -self.along_ways(np.linalg.lstsq(self._along(self.matrix()), missing, rcond=cut)[0])
        self.move(dz, residuals)
        return dz

    def clear_below(self, cut: float) -> float | None:
        """The threshold in the widest gap among the relative singular values below `cut`; None: they are all alike."""
        values = np.linalg.svd(self._along(self.matrix()), compute_uv=False)
        small = np.maximum(values[values < cut * values[0]] / values[0], LEAST)
        gaps = small[:-1] / small[1:]
        if not len(gaps) or gaps.max() < CLEARLY:
            return None
        return float(np.sqrt(small[gaps.argmax()] * small[gaps.argmax() + 1]))

    def matrix(self) -> Array:
        """What the conditions change by z, their own unknowns following."""
        return np.concatenate([one.left @ one.by_z for one in self.linear])

    def move(self, dz: Array, residuals: Sequence[Array] | None = None) -> None:
        """The geometry moved by dz, the conditions' own unknowns after it."""
        self.z = self.z + _fine(dz)
        self.after = changed(self.network, self.slots, self.z)
        found = [0.0] * len(self.linear) if residuals is None else residuals
        every = [condition for part in self.conditions for condition in part]
        for condition, one, r in zip(every, self.linear, found, strict=True):
            condition.step(one.inverse @ (r + one.by_z @ dz))

    def moved(self, dz: Array) -> Search:
        """Another search at z + dz; its conditions' own unknowns follow to first order."""
        other = copy(self)
        closes, singular, meant = self.conditions
        other.conditions = ([copy(c) for c in closes], [copy(c) for c in singular], meant)
        if dz.size:
            other.move(dz)
        return other

    def settled(self) -> Search:
        """The conditions' own unknowns solved for once more."""
        self.move(np.zeros(len(self.z)), self.residuals())
        return self

    def without_slope(self, cut: float) -> Conditions:
        """The conditions about the present numbers, for the directions in which they vanish twice.

        Their numbers are factors of the `ways` where z may change along these alone.
        """

        def slopes(dw: Array) -> Array:
            if not dw.size:
                return self._along(self.matrix())
            other = self.moved(self.along_ways(dw))
            other.linearise()
            pairs = zip(self.linear, other.linear, strict=True)
            return self._along(np.concatenate([mine.left @ its.left.T @ its.left @ its.by_z for mine, its in pairs]))

        def values(dw: Array) -> Array:
            pairs = zip(self.linear, self.moved(self.along_ways(dw)).settled().residuals(), strict=True)
            return np.concatenate([one.left @ r for one, r in pairs])

        return Conditions(slopes, values, cut)

    def _along(self, matrix: Array) -> Array:
        return matrix if self.ways is None else np.asarray(matrix @ self.ways)

    def along_ways(self, dw: Array) -> Array:
        """The change of z by factors of the ways."""
        return dw if self.ways is None else np.asarray(self.ways @ dw)

"""Ranks that the geometry as typed almost loses: of the closure, of the platform with it, of drives, of limbs.

    Network, what is asked of it --rank_claims--> matrices of signed screws --low_ranks--> those near a lower rank

Every rank of a mobility result is that of such a matrix over the joint rates: columns are screws about the centre of
the mechanism, lengths in units of its size, so that neither place nor unit nor orientation matter.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.algebra import CONTEXT, cross
from symscrew.mobility.finite.variety import Array
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Real, Row, eliminate

NEAR = 1e-4
"""Relative singular values below this, which are not zero, are looked at: numbers of six digits leave 1e-6 of what
vanishes as meant. Above it nothing is said, and nothing is concluded."""
LEAST = 1e-17
"""What relative singular values below a tenth of the rounding of doubles count as: none is told from another."""
CLEAR = 1e-13
"""Relative singular values above this are not zero, which doubles tell; below it elimination in 60 digits does."""


@dataclass(frozen=True)
class RankClaim:
    """Whose rank; `blocks`: (signed joints, 3 or 6 rows) each; `held`: rates set to zero; `columns`: which rates."""

    name: str
    blocks: tuple[tuple[tuple[tuple[str, int], ...], int], ...]
    held: tuple[int, ...]
    columns: tuple[int, ...]

    def matrix(self, network: Network, centre: Array) -> Array:
        """The matrix in 60 digits."""
        own = {name for steps, _ in self.blocks for name, _ in steps}
        screws = {c: _about_centre(s, centre) for n in own for c, s in
                  zip(network.edges[n].columns, network.edges[n].screws, strict=True)}  # fmt: skip
        return self.assembled(network, screws)

    def assembled(self, network: Network, screws: Mapping[int, Sequence[Real]]) -> Array:
        """The matrix of the given six numbers a column, whatever they are: screws, or their derivatives."""
        rows = []
        for steps, count in self.blocks:
            block = np.array([[CONTEXT.zero] * network.freedoms for _ in range(count)], dtype=object)
            for name, sign in steps:
                for column in network.edges[name].columns:
                    for row, c in zip(block, screws[column][:count], strict=True):
                        row[column] += c if sign > 0 else -c
            rows.append(block)
        for column in self.held:
            row = np.array([[CONTEXT.zero] * network.freedoms], dtype=object)
            row[0, column] = CONTEXT.one
            rows.append(row)
        return np.asarray(np.concatenate(rows)[:, list(self.columns)])

    def in_doubles(self, network: Network, screws: Array) -> Array:
        """The matrix in doubles, of the screws about the centre, freedoms x 6."""
        rows = np.zeros((sum(count for _, count in self.blocks) + len(self.held), network.freedoms))
        first = 0
        for steps, count in self.blocks:
            for name, sign in steps:
                own = list(network.edges[name].columns)
                rows[first : first + count, own] += sign * screws[own, :count].T
            first += count
        rows[range(first, len(rows)), list(self.held)] = 1.0
        return rows[:, list(self.columns)]

    def pulled(self, network: Network, rates: Array, vector: Array) -> Array:
        """d(matrix)/dz times a vector of rates, in doubles: rows x z; `rates` of the screws by z."""
        parts = []
        full = np.zeros(network.freedoms)
        full[list(self.columns)] = vector
        for steps, count in self.blocks:
            signs = np.zeros(network.freedoms)
            for name, sign in steps:
                signs[list(network.edges[name].columns)] += sign
            parts.append(np.einsum("zcs,c->sz", rates, signs * full)[:count])
        parts.append(np.zeros((len(self.held), len(rates))))
        return np.concatenate(parts)


@dataclass(frozen=True)
class LowRank:
    """A claim whose rank is, or almost is, `rank`, which is not full; `size`: the largest value neglected.

    `almost`: as typed, in 60 digits, the rank is higher.
    """

    claim: RankClaim
    rank: int
    size: float
    almost: bool


def rank_claims(network: Network, body: str, limbs: Iterable[Sequence[str]]) -> tuple[RankClaim, ...]:
    """The matrices whose ranks a mobility result consists of; the first is the closure's."""
    every = tuple(range(network.freedoms))
    loops = tuple((loop, 6) for loop in network.loops())
    path = network.path(body)
    claims = [RankClaim("closure", loops, (), every)] if loops else []
    if path:
        claims.append(RankClaim(f"turning of {body}", (*loops, (path, 3)), (), every))
        claims.append(RankClaim(f"motion of {body}", (*loops, (path, 6)), (), every))
    if network.driven and loops:
        claims.append(RankClaim("drives", loops, network.driven, every))
    for joints in limbs:
        columns = tuple(c for name in joints for c in network.edges[name].columns)
        claims.append(RankClaim(" ".join(joints), ((tuple((name, 1) for name in joints), 6),), (), columns))
    return tuple(claims)


def low_ranks(network: Network, claims: Iterable[RankClaim], centre: Array, near: float = NEAR) -> tuple[LowRank, ...]:
    """The claims that do not have full rank, counting relative singular values above `near` only."""
    found = []
    for claim in claims:
        matrix = claim.matrix(network, centre)
        values = np.linalg.svd(matrix.astype(float), compute_uv=False)
        kept = int((values > near * values.max(initial=0.0)).sum())  # of no freedoms at all none
        if kept and kept < min(matrix.shape):
            clear = bool(values[kept] > CLEAR * values[0])
            almost = clear or eliminate(matrix.tolist(), matrix.shape[1]).rank > kept
            found.append(LowRank(claim, kept, float(values[kept]), almost))
    return tuple(found)


def nearer(network: Network, claims: Iterable[RankClaim], centre: Array, near: float) -> float | None:
    """The threshold in the widest gap among the closure's relative singular values below `near`; None where none is."""
    for claim in claims:
        if claim.name == "closure":
            values = np.linalg.svd(claim.matrix(network, centre).astype(float), compute_uv=False)
            small = np.maximum(values[values < near * values[0]] / values[0], LEAST)
            gaps = small[:-1] / small[1:]
            if len(gaps) and gaps.max() > 1.0:
                return float(np.sqrt(small[gaps.argmax()] * small[gaps.argmax() + 1]))
    return None


def _about_centre(screw: Sequence[Real], centre: Array) -> Row:
    w, v = screw[:3], screw[3:]
    shift = cross((centre[0], centre[1], centre[2]), (w[0], w[1], w[2]))
    return [*w, *(a - b for a, b in zip(v, shift, strict=True))]

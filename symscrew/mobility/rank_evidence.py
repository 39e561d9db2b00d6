"""How the ranks of a mobility result were decided: in an exact field, or certified numerically.

    ranks in 60 digits --the same rows over an exact field--> exact, or certified numeric and why not exact

The numeric ranks come with 60 digits. They are exact where a field is found in which zero is decidable and
elimination over it gives the same ranks. Descriptions with rounded decimals can differ there: then the numeric
decision stands, which takes numbers below 1e-27 for rounding, and the text says so.

The numeric certificate of a rank r: the r-th singular value s_r, and with the null vectors N found a bound for the
next, s_(r+1) <= |J N| / smallest singular value of N (Courant-Fischer).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import numpy as np

from symscrew.algebra import CONTEXT, Vector, cross, dot
from symscrew.description import Mechanism
from symscrew.mobility.instantaneous import BodyFreedoms, Instantaneous, LimbMobility
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import ScrewSystem, swapped
from symscrew.mobility.symbols import (
    Exact,
    ExactSystem,
    ExactTie,
    NotDecidableError,
    Row,
    exact_rank,
    exact_system,
    exact_ties,
    group_dimensions,
    loop_rows,
    null_vectors,
    tie_row,
)

NEARLY_PARALLEL = 1e-6
"""Sine of the angle [rad] below which axes that are not parallel are pointed out: probably meant to be, with rounded
decimals. They count as not parallel all the same."""
SAME_DIRECTION = CONTEXT.mpf(10) ** -27
"""Sine below which axes are parallel: as for ranks (`screw_systems.ZERO_BELOW`)."""
OF_CONSTRAINTS = "rank of the limbs' constraints"
MOST_PAIRS = 12
"""Pairs that are named; of more, only the number is."""


@dataclass(frozen=True)
class Decision:
    """A rank: whose, its value, the value over the exact field (None where none was found)."""

    claim: str
    numeric: int
    exact: int | None


@dataclass(frozen=True)
class Decisions:
    """All ranks of a result. `field`: in words, None without one; `reason`: why not exact, or empty.

    `singular_values`: (smallest kept, bound for the largest neglected) of the closure, in the units of the network;
    the first is infinite where there is no closure.
    """

    field: str | None
    ranks: tuple[Decision, ...]
    reason: str
    singular_values: tuple[float, float]
    groups: tuple[int, ...] | None = None
    """Dimension of the group of displacements in which each loop moves, over the field; None where not known."""

    def __repr__(self) -> str:
        exact = f"exact over {self.field}" if self.field else "by singular values alone"
        return f"Decisions({len(self.ranks)} ranks, {exact})"

    @property
    def closure_exact(self) -> bool:
        """The rank of the closure was decided in the field, and not differently from the numbers."""
        return bool(self.ranks) and self.ranks[0].exact == self.ranks[0].numeric

    @property
    def all_exact(self) -> bool:
        """All ranks were decided in the field, and not differently from the numbers."""
        return bool(self.ranks) and all(rank.exact == rank.numeric for rank in self.ranks)

    @property
    def exact(self) -> bool:
        """Every rank was decided in the field, and none differently from the numbers."""
        return not self.reason and all(d.exact == d.numeric for d in self.ranks)

    @property
    def method(self) -> str:
        """`exact: ...` or `certified numeric: ...`, with the evidence."""
        kept, neglected = self.singular_values
        gap = ""  # without loops there is no closure whose rank could be in doubt
        if np.isfinite(kept):
            gap = f"; closure singular values {kept:.2e} kept, at most {neglected:.0e} neglected"
        if self.exact:
            digits = " with 60 digits" if gap else ""
            return f"exact: {len(self.ranks)} ranks decided over the field {self.field}{gap}{digits}"
        return f"certified numeric: ranks decided with 60 digits{gap}; {self.why}"

    @property
    def why(self) -> str:
        """Why the result is not exact; empty where it is."""
        different = [d for d in self.ranks if d.exact not in (None, d.numeric)]
        if different:
            worst = different[0]
            return (
                f"not exact, because over {self.field} the decimals of the description, taken as exact, give "
                f"{worst.claim} {worst.exact} instead of {worst.numeric}: "
                "differences below 1e-27 are taken for rounding"
            )
        return f"not exact, because {self.reason}" if self.reason else ""


@dataclass(frozen=True)
class NumericRanks:
    """What was found with 60 digits, whose ranks are to be decided: see `symscrew.mobility.analysis.Mobility`."""

    network: Network
    first_order: Instantaneous
    platform: BodyFreedoms
    limbs: Sequence[LimbMobility]
    constraints: ScrewSystem | None


def decide(mechanism: Mechanism, given: NumericRanks, *, displaced: bool) -> Decisions:
    """The ranks of the result again over an exact field; `displaced` configurations have no exact coordinates."""
    values = singular_values(given.first_order)
    if displaced:
        if given.network.chords:
            reason = "the displaced configuration solves the closure equations in 60 digits"
        else:
            reason = "the joint coordinates were set in 60 digits"
        return Decisions(None, (), reason, values)
    try:
        system = exact_system(mechanism)
        couplings = exact_ties(mechanism, system)
    except NotDecidableError as error:
        return Decisions(None, (), str(error), values)
    found: list[Decision] = []
    reasons: list[str] = []
    for claim, numeric, work in _claims(given, system, couplings):
        try:
            found.append(Decision(claim, numeric, work()))
        except NotDecidableError as error:
            found.append(Decision(claim, numeric, None))
            reasons.append(f"{error} ({claim})")
    try:
        groups = None if couplings else group_dimensions(given.network, system)
    except NotDecidableError:  # the numbers grow too long: it is not known
        groups = None
    return Decisions(str(system.field), tuple(found), "; ".join(dict.fromkeys(reasons)), values, groups)


def _claims(
    given: NumericRanks, system: ExactSystem, couplings: Sequence[ExactTie]
) -> Iterator[tuple[str, int, Callable[[], int]]]:
    """(what, numeric rank, function that finds the exact one)."""
    network, first_order, platform, field = given.network, given.first_order, given.platform, system.field
    closure = [row for loop in network.loops() for row in loop_rows(network, system, loop)]
    closure += [tie_row(network, system, coupling) for coupling in couplings]
    body = loop_rows(network, system, network.path(platform.body))
    yield "rank of the closure", first_order.closure.rank, lambda: exact_rank(closure, field)
    rank = network.freedoms - first_order.dof
    above = rank + platform.dof
    yield f"rank of closure and {platform.body}", above, lambda: exact_rank([*closure, *body], field)
    turning = rank + platform.rotations
    yield f"rank of closure and turning of {platform.body}", turning, lambda: exact_rank([*closure, *body[:3]], field)
    if first_order.dof_drives_locked is not None:
        drives: list[Row] = [[Fraction(int(j == c)) for j in range(network.freedoms)] for c in network.driven]
        locked = network.freedoms - first_order.dof_drives_locked
        yield "rank of closure and drives", locked, lambda: exact_rank([*closure, *drives], field)
    chains = [[s for joint in limb.joints for s in system.screws[joint]] for limb in given.limbs]
    for limb, chain in zip(given.limbs, chains, strict=True):
        rows: list[Row] = [list(screw) for screw in chain]
        yield f"rank of {limb.name}", 6 - len(limb.constraints.basis), partial(exact_rank, rows, field)
    if given.constraints is not None:
        yield OF_CONSTRAINTS, given.constraints.rank, lambda: _union(chains, system)


def _union(chains: Sequence[Sequence[Sequence[Exact]]], system: ExactSystem) -> int:
    wrenches: list[Row] = []
    for chain in chains:
        wrenches += [list(w) for w in null_vectors([swapped(s) for s in chain], 6, system.field)]
    return exact_rank(wrenches, system.field)


def singular_values(first_order: Instantaneous) -> tuple[float, float]:
    """(smallest singular value that counts, bound for the largest that does not) of the closure."""
    rank = first_order.closure.rank
    rows = np.array([[float(c) for c in row] for row in first_order.rows])
    kept = float(np.linalg.svd(rows, compute_uv=False)[rank - 1]) if rank else float("inf")
    if not first_order.motions or not len(rows):
        return kept, 0.0
    square = sum(
        sum(a * b for a, b in zip(row, motion, strict=True) if a and b) ** 2
        for row in first_order.rows
        for motion in first_order.motions
    )
    basis = np.array([[float(c) for c in motion] for motion in first_order.motions])
    return kept, float(CONTEXT.sqrt(square)) / float(np.linalg.svd(basis, compute_uv=False)[-1])


def nearly_parallel(network: Network) -> tuple[str, ...]:
    """Pairs of joints whose axes are almost parallel, in words: they count as not parallel."""
    axes: list[tuple[str, Vector]] = []
    for edge in network.edges.values():
        for motion, column in edge.motions:
            if motion.single:
                screw = edge.screws[column - edge.start]
                x, y, z = screw[:3] if motion.turns else screw[3:]
                axes.append((edge.name, (x, y, z)))
    rough = np.array([[float(c) for c in axis] for _, axis in axes]).reshape(-1, 3)
    texts = {}
    for i in range(len(axes)):
        sines = np.linalg.norm(np.cross(rough[i], rough[i + 1 :]), axis=1)
        for j in np.flatnonzero(sines < NEARLY_PARALLEL) + i + 1:
            (a, first), (b, second) = axes[i], axes[int(j)]
            across = cross(first, second)
            sine = CONTEXT.sqrt(dot(across, across))
            if a != b and sine > SAME_DIRECTION:
                texts[a, b] = f"axes of joints {a} and {b} are {float(sine):.1e} rad apart: not parallel"
    found = tuple(texts.values())
    more = len(found) - MOST_PAIRS
    return found if more <= 0 else (*found[:MOST_PAIRS], f"and {more} more pairs")

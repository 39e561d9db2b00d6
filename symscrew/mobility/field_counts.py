"""The counts in which the field speaks of mobility: Kutzbach, modified Kutzbach, Gogu, Gruebler's groups, Waldron.

    Network, limbs --ranks of screws, brackets--> connectivity, spatiality, groups of loops --> formulas with numbers

K. Kutzbach, Maschinenbau 8 (1929) 710-716: M = 6 (n - g - 1) + sum f.
Z. Huang, Q. Li, H. Ding, Theory of Parallel Mechanisms (2013): M = d (n - g - 1) + sum f + nu - zeta,
d = 6 - lambda, with lambda common constraints, nu redundant ones beyond them, zeta isolated (passive) freedoms.
G. Gogu, Mech. Mach. Theory 40 (2005) 1068-1097, and Structural Synthesis of Parallel Robots 1 (2008): connectivity of
the limbs S_Gi and of the platform S_F, r = sum S_Gi - S_F + r_l, M = sum f - r, N = 6 q - r, T = M - S_F.
Groups of displacements of loops: J. M. Herve, Mech. Mach. Theory 13 (1978) 437-450: M = sum f - their dimensions.
K. J. Waldron, J. Mechanisms 1 (1966) 191-212: orders of the screw systems of the loops; M = f - order for one loop.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import CONTEXT, cross
from symscrew.mobility.finite import passive_freedoms
from symscrew.mobility.instantaneous import BodyFreedoms, Instantaneous, LimbMobility
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Row, Screw, ScrewSystem, combine, eliminate, span, unit_rows
from symscrew.mobility.screw_text import describe_type

GROUPS = {
    "1T": "T, translations along a line",
    "1R": "R, rotations about an axis",
    "1H": "H, screw motions about an axis",
    "2T": "T2, translations in a plane",
    "1R1T": "C, cylindrical",
    "3T": "T3, translations",
    "1R2T": "G, planar",
    "1H2T": "Y, planar with a pitch",
    "3R": "S, spherical",
    "1R3T": "X, Schoenflies",
    "3R3T": "D, all displacements",
}
"""Type of the freedoms -> name of the group of displacements, in J. M. Herve's letters."""

ROUNDING = CONTEXT.mpf(10) ** -27
"""Of the screws: what is smaller in a bracket is zero, as for ranks (`screw_systems.ZERO_BELOW`)."""

MOST_TERMS = 4
"""Loops whose numbers are added one by one; of more it is said how often each number occurs."""


@dataclass(frozen=True)
class LoopCount:
    """A loop: its closing joint, the order of its screw system, dimension and name of its group of displacements."""

    joint: str
    order: int
    dimension: int
    group: str


@dataclass(frozen=True)
class LimbCount:
    """A limb: sum of its joint freedoms f, connectivity S_Gi of its end as if alone; redundancy f - S_Gi."""

    name: str
    freedoms: int
    connectivity: int

    @property
    def redundancy(self) -> int:
        """Freedoms that move nothing at the limb's end."""
        return self.freedoms - self.connectivity


@dataclass(frozen=True)
class FieldCounts:
    """The numbers of all formulas; see the module's text for the letters.

    Attributes:
        links: n, with the frame.
        joints: g.
        freedoms: sum f.
        loops: the loops with their groups; q is their number.
        couplings: p, relations between coordinates (gears, belts): each takes one freedom as a loop takes six.
        rank: r of the closure, with the couplings.
        common: lambda, constraints that every joint satisfies.
        redundant: nu, redundant constraints beyond the common ones.
        isolated: zeta, freedoms in which links move alone, between two joints with a motion in common.
        limbs: connectivity of each limb.
        platform: S_F, connectivity of the platform in the mechanism.
        by_limbs: nu from the limbs' constraints; None where the mechanism is not made of limbs.
    """

    links: int
    joints: int
    freedoms: int
    loops: tuple[LoopCount, ...]
    couplings: int
    rank: int
    common: int
    redundant: int
    isolated: int
    limbs: tuple[LimbCount, ...]
    platform: int
    by_limbs: int | None

    @property
    def mobility(self) -> int:
        """M = sum f - r."""
        return self.freedoms - self.rank

    @property
    def order(self) -> int:
        """d = 6 - lambda."""
        return 6 - self.common

    @property
    def kutzbach(self) -> int:
        """6 (n - g - 1) + sum f - p."""
        return 6 * (self.links - self.joints - 1) + self.freedoms - self.couplings

    @property
    def modified(self) -> int:
        """d (n - g - 1) + sum f - p + nu - zeta: without the passive freedoms."""
        counted = self.order * (self.links - self.joints - 1) + self.freedoms - self.couplings
        return counted + self.redundant - self.isolated

    @property
    def overconstraint(self) -> int:
        """N = 6 q + p - r."""
        return 6 * len(self.loops) + self.couplings - self.rank

    @property
    def redundancy(self) -> int:
        """T = M - S_F."""
        return self.mobility - self.platform

    @property
    def by_groups(self) -> int:
        """sum f - p - sum of the dimensions of the loops' groups."""
        return self.freedoms - self.couplings - sum(loop.dimension for loop in self.loops)

    @property
    def by_orders(self) -> int:
        """Waldron, loop by loop: sum f - p - sum of the orders of the loops' screw systems; exact for one loop."""
        return self.freedoms - self.couplings - sum(loop.order for loop in self.loops)


def field_counts(
    network: Network, found: Instantaneous, platform: BodyFreedoms, limbs: Sequence[LimbMobility], *, carried: bool
) -> FieldCounts:
    """All counts of the configuration; ranks in 60 digits. `carried`: the limbs are all that carries the platform."""
    screws = unit_rows(_centred(network, [s for edge in network.edges.values() for s in edge.screws]))
    common = 6 - eliminate(screws, 6).rank if network.chords else 0
    rank = network.freedoms - found.dof
    redundant = (6 - common) * len(network.chords) + len(network.ties) - rank
    counts = tuple(LimbCount(m.name, len(m.screws), 6 - len(m.constraints.basis)) for m in limbs)
    made_of_limbs = carried and sorted(j for m in limbs for j in m.joints) == sorted(network.edges)
    by_limbs = None
    if made_of_limbs and not network.ties:
        wrenches = [(*w[:3], *(c / network.length for c in w[3:])) for m in limbs for w in m.constraints.basis]
        by_limbs = len(wrenches) - eliminate(unit_rows(wrenches), 6).rank - common * len(network.chords)
    return FieldCounts(
        len(network.bodies), len(network.edges), network.freedoms, _loops(network), len(network.ties), rank,
        common, redundant, passive_freedoms(network), counts, platform.dof, by_limbs,
    )  # fmt: skip


def _centred(network: Network, screws: Sequence[Screw]) -> list[Row]:
    """The screws about the centre of the joints, so that a far origin costs no digits."""
    edges = network.edges.values()
    x, y, z = (sum(edge.point[k] for edge in edges) / len(edges) for k in range(3))
    moved = []
    for w1, w2, w3, *v in screws:
        shift = cross((x, y, z), (w1, w2, w3))
        moved.append([w1, w2, w3, *(a - b for a, b in zip(v, shift, strict=True))])
    return moved


def _loops(network: Network) -> tuple[LoopCount, ...]:
    result = []
    for name, loop in zip(network.chords, network.loops(), strict=True):
        screws = [s for joint, _ in loop for s in network.edges[joint].screws]
        system = span(unit_rows(_centred(network, screws)), 6)
        group = _closed_under_brackets(system)
        dimension = len(group.basis)
        words = GROUPS.get(_group_type(group.basis), f"of dimension {dimension}")
        result.append(LoopCount(name, len(system.basis), dimension, words))
    return tuple(result)


def _group_type(basis: Sequence[Screw]) -> str:
    """The type of a group's freedoms. Groups with a pitch are H, and Y with its translations across the axis."""
    dimension, turning = len(basis), eliminate([s[:3] for s in basis], 3).rank
    turn, shift = basis[0][:3], basis[0][3:]  # an echelon basis begins with what turns
    pitched = turning == 1 and dimension in (1, 3) and bool(combine([turn], shift)[0])
    return describe_type(dimension, turning, int(pitched))


def _closed_under_brackets(system: ScrewSystem) -> ScrewSystem:
    """The smallest algebra of twists that contains the system: that of the group in which the loop moves."""
    while len(system.basis) < 6:
        brackets = [_bracket(a, b) for a in system.basis for b in system.basis if a is not b]
        larger = span(unit_rows([*system.basis, *brackets]), 6)
        if len(larger.basis) == len(system.basis):
            return system
        system = larger
    return system


def _bracket(a: Screw, b: Screw) -> Row:
    (a1, a2, a3, a4, a5, a6), (b1, b2, b3, b4, b5, b6) = a, b
    angular = cross((a1, a2, a3), (b1, b2, b3))
    first, second = cross((a1, a2, a3), (b4, b5, b6)), cross((a4, a5, a6), (b1, b2, b3))
    linear = [p + q for p, q in zip(first, second, strict=True)]
    largest = max(abs(c) for c in (*a, *b)) ** 2
    return [c if abs(c) > ROUNDING * largest else CONTEXT.zero for c in (*angular, *linear)]


def as_lines(counts: FieldCounts) -> list[str]:
    """The formulas with their numbers, a line each; typed between dollar signs, "sum f" and "S_Gi" being symbols."""
    n, g, f, q = counts.links, counts.joints, counts.freedoms, len(counts.loops)
    letter, p = (" - p", f" - {counts.couplings}") if counts.couplings else ("", "")
    lines = [f"Kutzbach: $6 (n - g - 1) + sum f{letter} = 6 ({n} - {g} - 1) + {f}{p} = {counts.kutzbach}$"]
    lines[0] += f", with $p = {counts.couplings}$ couplings" if counts.couplings else ""
    if not q:
        return lines
    d, more = counts.order, letter.replace("-", "+")
    lines.append(
        f"Modified Kutzbach: $d (n - g - 1) + sum f{letter} + nu - zeta = "
        f"{d} ({n} - {g} - 1) + {f}{p} + {counts.redundant} - "
        f"{counts.isolated} = {counts.modified}$, with $lambda = {counts.common}$ common constraints "
        f"($d = 6 - lambda$), $nu = {counts.redundant}$ redundant, $zeta = {counts.isolated}$ passive"
    )
    if counts.limbs:
        limbs = ", ".join(f"{m.name} {m.connectivity}" for m in counts.limbs)
        if len(counts.limbs) > 1 and len({m.connectivity for m in counts.limbs}) == 1:
            limbs = f"{counts.limbs[0].connectivity} each"
        lines.append(f"Connectivity of the limbs $S_Gi$: {limbs}")
    lines.append(
        f"Gogu: $r = {counts.rank}$, $M = sum f - r = {counts.mobility}$, connectivity of the platform $S_F = "
        f"{counts.platform}$, overconstraint $N = 6 q{more} - r = {counts.overconstraint}$, redundancy "
        f"$T = M - S_F = {counts.redundancy}$"
    )
    groups: dict[str, list[str]] = {}
    for loop in counts.loops:
        groups.setdefault(loop.group, []).append(loop.joint)
    named = "; ".join(f"{group} (closed by {', '.join(joints)})" for group, joints in groups.items())
    dimensions, orders = ([getattr(loop, of) for loop in counts.loops] for of in ("dimension", "order"))
    lines.append(
        f"Groups of the loops: {named}; less their dimensions "
        f"$sum f{letter} - {_total(dimensions)} = {f}{p} - {sum(dimensions)} = {counts.by_groups}$"
    )
    lines.append(
        f"Waldron: less the orders of the loops "
        f"$sum f{letter} - {_total(orders)} = {f}{p} - {sum(orders)} = {counts.by_orders}$"
    )
    return lines


def _total(numbers: Sequence[int]) -> str:
    """A sum of a few numbers, or of how often each occurs."""
    if len(numbers) == 1:
        return str(numbers[0])
    terms = [f"{k}" for k in numbers]
    if len(numbers) > MOST_TERMS:
        terms = [f"{numbers.count(k)} * {k}" for k in sorted(set(numbers), reverse=True)]
    return f"({' + '.join(terms)})"

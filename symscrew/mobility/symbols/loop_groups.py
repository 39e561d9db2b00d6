"""Smooth by groups: loops that move in a subgroup of the rigid displacements, decided over the exact field.

    screws of a loop --brackets--> their Lie algebra, dimension d_l;   rank of the closure = sum of d_l  =>  smooth

The closure map of a loop takes its values in the group that its screws generate (planar, spherical, Schoenflies ...),
so it has at most d_l independent equations, wherever the mechanism is. Where the rank reaches the sum of the d_l, the
map into the product of these groups has full rank, and the configuration space is smooth (implicit functions). This
is Gruebler's count with the group of each loop (K. H. Hunt, Kinematic Geometry of Mechanisms, 1978; J. M. Herve, Mech.
Mach. Theory 13, 1978, 437-450).
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import Exact
from symscrew.mobility.symbols.exact_ranks import exact_rank
from symscrew.mobility.symbols.exact_screws import ExactSystem, Row

LARGEST_DEGREE = 4
"""Of the field in which brackets are taken: two square roots. Beyond it numbers grow too long for what is gained, and
the motion is sampled, as the result then says."""


def group_dimensions(network: Network, system: ExactSystem) -> tuple[int, ...] | None:
    """Dimension of the Lie algebra of each loop's screws; None where the field is too large to ask."""
    if system.field.degree > LARGEST_DEGREE:
        return None
    screws = ([s for name, _ in loop for s in system.screws[name]] for loop in network.loops())
    return tuple(len(_algebra(own, system)) for own in screws)


def screw_algebra(screws: Sequence[Sequence[Exact]], system: ExactSystem) -> list[Row] | None:
    """A basis of the Lie algebra that screws generate; None where the field is too large to ask."""
    return _algebra(screws, system) if system.field.degree <= LARGEST_DEGREE else None


def _algebra(screws: Sequence[Sequence[Exact]], system: ExactSystem) -> list[Row]:
    basis = _independent([list(screw) for screw in screws], system.field)
    new = basis
    while new and len(basis) < 6:
        brackets = [_bracket(a, b) for a in new for b in basis]
        wider = _independent([*basis, *brackets], system.field)
        new = wider[len(basis) :]
        basis = wider
    return basis


def _independent(rows: Sequence[Row], field: Field) -> list[Row]:
    """The first rows that are independent."""
    chosen: list[Row] = []
    for row in rows:
        if any(row) and len(chosen) < 6 and exact_rank([*chosen, row], field) > len(chosen):
            chosen.append(row)
    return chosen


def _bracket(a: Sequence[Exact], b: Sequence[Exact]) -> Row:
    """[A, B] = (a x b ; a x b_O + a_O x b)."""
    linear = [x + y for x, y in zip(_cross(a[:3], b[3:]), _cross(a[3:], b[:3]), strict=True)]
    return [*_cross(a[:3], b[:3]), *linear]


def _cross(a: Sequence[Exact], b: Sequence[Exact]) -> Row:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

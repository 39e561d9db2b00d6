"""What is said where special geometry seems near but was not found: ranks that are almost lower as typed, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from symscrew.mobility.finite import FiniteMobility, NearGeometry
from symscrew.mobility.instantaneous import BodyFreedoms, Instantaneous
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import unit_rows
from symscrew.mobility.screw_text import describe_type

NEARLY_SINGULAR = 1e-4
"""Singular value of the closure below which its rank is said to be almost lost: numbers of six digits leave 1e-6 of
what vanishes as meant. The rank itself is what it is as typed."""


def almost_lower(network: Network, first_order: Instantaneous, platform: BodyFreedoms) -> tuple[str, ...]:
    """Ranks other than the closure's that are almost lower: of the platform's type, of the drives' hold."""
    texts = []
    length, basis = network.length, platform.freedoms.basis
    twists = np.array([[float(c) for c in (*t[:3], *(x / length for x in t[3:]))] for t in basis])
    if len(twists):
        turning = np.linalg.svd(np.linalg.qr(twists.T)[0].T[:, :3], compute_uv=False)
        clear = int((turning > NEARLY_SINGULAR).sum())
        if clear < platform.rotations:
            meant = describe_type(platform.dof, clear)
            texts.append(f"Type {platform.type} of {platform.body} is as typed; it is almost {meant}")
    if network.driven and first_order.dof:
        motions = np.array([[float(c) for c in row] for row in unit_rows(first_order.motions)])
        held = np.linalg.qr(motions.T)[0][list(network.driven)]
        almost = first_order.dof - int((np.linalg.svd(held, compute_uv=False) > NEARLY_SINGULAR).sum())
        if almost > (first_order.dof_drives_locked or 0):
            texts.append(f"With all drives locked {almost} freedoms are almost left: near an actuation singularity")
    return tuple(texts)


def almost_singular(network: Network, kept: float) -> str:
    """That the closure almost loses rank, by its smallest singular value."""
    return (
        f"That is as typed. The closure almost loses rank (singular value {kept:.1e}): special geometry or a "
        f"singular pose is near, about {kept * float(network.length):.0e} m to first order; what moves there "
        "is undecided"
    )


STALLED = (
    "special geometry that moves more next to what was typed: the loops nearly close along finite motions, but the "
    "search for geometry with which they close did not converge"
)
RANKS_ALONE = "the one named has the ranks alone, one that moves more may be near"
NOT_NAMED = "such geometry may be near, and is not named"


def left_open(
    searched: Sequence[NearGeometry] | str,
    beside: Sequence[tuple[FiniteMobility, NearGeometry]],
    typed: FiniteMobility,
    named: FiniteMobility | None,
    *,
    length: float,
) -> tuple[str, ...]:
    """What the search for special geometry did not find or does not name, in words, and why.

    `beside`: what it found, with the real motions of each; `named`: those of the one that is said to be near.
    """
    if isinstance(searched, str):
        return (searched,)
    farthest_first = sorted(beside, key=lambda pair: -pair[1].distance) if named is None else []
    # of several that move alike the nearest is told of
    texts = list({finite.dof: _not_named(one, finite, typed, length) for finite, one in farthest_first}.values())
    if any(one.stalled for one in searched) and (named is None or (named.dof or 0) <= (typed.dof or 0)):
        texts.append(f"{STALLED}; {NOT_NAMED if named is None else RANKS_ALONE}")
    freedoms = frozenset[int]().union(*(one.freedoms for one in searched))
    missing = freedoms - set(named.branches or (named.dof or 0,)) if named is not None else ()
    if missing:
        seen = " and ".join(str(count) for count in sorted(missing))
        texts.append(
            f"special geometry with further branches next to what was typed: configurations with {seen} freedoms in "
            "which the loops nearly close are on no branch of the one named, so another may have been meant"
        )
    return tuple(text for text in texts if text)


def _not_named(one: NearGeometry, finite: FiniteMobility, typed: FiniteMobility, length: float) -> str:
    """Why special geometry that was found is not said to be near; nothing where it moves as what was typed does."""
    most = ", ".join(name for name, size in one.changes if size > one.distance / 2)
    where = f"special geometry {one.distance * length:.1e} m from what was typed ({most}) has the almost low ranks"
    if finite.dof is None:
        return f"{where}; what moves there is undecided: {finite.evidence[0]}"
    if finite.dof < (typed.dof or 0):
        return (
            f"{where}, and moves less (finite mobility {finite.dof}): of so few digits rounding alone may stop it, so "
            "that it is not named as meant"
        )
    return ""

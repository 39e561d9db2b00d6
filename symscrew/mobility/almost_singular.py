"""What is said where special geometry seems near but was not found: ranks that are almost lower as typed, in words."""

from __future__ import annotations

import numpy as np

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

"""The lower pair of every elementary motion: what else a new motion needs is its line in the description's table."""

from __future__ import annotations

from symscrew.description import Motion
from symscrew.kinematics.pairs.helical_pair import Helical
from symscrew.kinematics.pairs.lower_pair import LowerPair
from symscrew.kinematics.pairs.prismatic_pair import Prismatic
from symscrew.kinematics.pairs.revolute_pair import Revolute
from symscrew.kinematics.pairs.rigid_pair import Rigid
from symscrew.kinematics.pairs.spherical_pair import Spherical

PAIRS: dict[str, LowerPair] = {
    "R": Revolute(),
    "P": Prismatic(),
    "H": Helical(),
    "S": Spherical(),
    "F": Rigid(),
}


def pair_of(motion: Motion) -> LowerPair:
    """The lower pair of a motion."""
    return PAIRS[motion.kind]

"""Lower pairs: what each elementary motion of a joint does with nodes, one file each.

frame, inertia  --lower_pair--> placement, twist, power of a wrench, unit screws, step of a state

`pair_table` names them by the letter of their motion in the description's table of joint types.
"""

from symscrew.kinematics.pairs.lower_pair import LowerPair, Site, Turn
from symscrew.kinematics.pairs.pair_table import PAIRS, pair_of
from symscrew.kinematics.pairs.spherical_pair import ROUNDED, quaternion_matrix, squared_length, unit_quaternion

__all__ = [
    "PAIRS",
    "ROUNDED",
    "LowerPair",
    "Site",
    "Turn",
    "pair_of",
    "quaternion_matrix",
    "squared_length",
    "unit_quaternion",
]

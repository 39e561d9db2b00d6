"""How far a configuration is from a singularity of each of three kinds: numbers of q that vanish exactly there.

    System --limb_volumes--> limb margins
           --closure_grids--> constraint margin, actuation margins (drives locked)

           --nearest_zeros--> the displacement of a joint to where one of them vanishes

What they are and where they come from stands in `three_kinds`.
"""

from symscrew.mobility.margins.nearest_zeros import Displaced, find_zeros, size_of
from symscrew.mobility.margins.three_kinds import (
    FORMS,
    Margin,
    Margins,
    actuation_margins,
    constraint_margins,
    drive_sets,
    limb_margins,
)

__all__ = [
    "FORMS",
    "Displaced",
    "Margin",
    "Margins",
    "actuation_margins",
    "constraint_margins",
    "drive_sets",
    "find_zeros",
    "limb_margins",
    "size_of",
]

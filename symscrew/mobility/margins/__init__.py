"""How far a configuration is from a singularity of each of three kinds: numbers of q that vanish exactly there.

    System --limb_volumes--> limb margins
           --closure_grids--> constraint margin, actuation margins (drives locked)

What they are and where they come from stands in `three_kinds`.
"""

from symscrew.mobility.margins.three_kinds import (
    FORMS,
    Margin,
    Margins,
    actuation_margins,
    constraint_margins,
    drive_sets,
    limb_margins,
)

__all__ = ["FORMS", "Margin", "Margins", "actuation_margins", "constraint_margins", "drive_sets", "limb_margins"]

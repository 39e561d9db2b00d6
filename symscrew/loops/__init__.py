"""Closed loops: the rows that cut joints contribute, and the rates that depend on the independent ones.

System --formulations--> rows of every cut joint --closure--> `Closure` --dependent_rates--> `Loops`
       --modes--> what holds in one operation mode --limbs--> joint positions in closed form
"""

from symscrew.loops.closure import Closure, closures
from symscrew.loops.dependent_rates import Loops, counts_all_ways
from symscrew.loops.limbs import (
    CrankLimb,
    LengthRow,
    LimbForm,
    any_rods,
    closed_limbs,
    hub_links,
    length_rows,
    limb_coordinates,
    met_rows,
    reference_nodes,
    rod_limb,
)
from symscrew.loops.modes import OFF, Mode, operation_mode

__all__ = [
    "OFF",
    "Closure",
    "CrankLimb",
    "LengthRow",
    "LimbForm",
    "Loops",
    "Mode",
    "any_rods",
    "closed_limbs",
    "closures",
    "counts_all_ways",
    "hub_links",
    "length_rows",
    "limb_coordinates",
    "met_rows",
    "operation_mode",
    "reference_nodes",
    "rod_limb",
]

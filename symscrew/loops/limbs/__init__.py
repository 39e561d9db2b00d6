"""Limbs whose joint coordinates follow from the platform's pose in closed form: one file for each class."""

from symscrew.loops.limbs.closed_forms import (
    any_rods,
    closed_limbs,
    hub_links,
    limb_coordinates,
    met_rows,
    reference_nodes,
)
from symscrew.loops.limbs.crank_limbs import CrankLimb, RodLimb, rod_limb
from symscrew.loops.limbs.crank_rates import LengthRow, length_rows
from symscrew.loops.limbs.limb_form import LimbForm

__all__ = [
    "CrankLimb",
    "LengthRow",
    "LimbForm",
    "RodLimb",
    "any_rods",
    "closed_limbs",
    "hub_links",
    "length_rows",
    "limb_coordinates",
    "met_rows",
    "reference_nodes",
    "rod_limb",
]

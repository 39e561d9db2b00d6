"""Lanes: equal limbs of a mechanism side by side in vectors.

Program with origins --limb_lanes, limb_neighbours, limb_rows--> Corresponding operations
Corresponding --pack_plan, lane_padding, lane_signs, packs--> Packing: vectors of lanes
Corresponding, or Packing --limb_stages, staged_rows--> LimbStages: what a limb does, limb after limb
"""

from symscrew.program.lanes.corresponding import Corresponding
from symscrew.program.lanes.limb_stages import SIGNLESS, stages_of_lanes, stages_of_limbs
from symscrew.program.lanes.packs import Pack, Packing, Vector, packed
from symscrew.program.lanes.staged_rows import LimbRow, LimbStages, Single

__all__ = [
    "SIGNLESS",
    "Corresponding",
    "LimbRow",
    "LimbStages",
    "Pack",
    "Packing",
    "Single",
    "Vector",
    "packed",
    "stages_of_lanes",
    "stages_of_limbs",
]

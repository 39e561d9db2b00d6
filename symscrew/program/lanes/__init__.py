"""Lanes: parts of a program that do the same with other data, such as equal limbs, side by side in vectors.

Program --correspondence--> classes --lane_padding, lane_signs--> equal parts --pack_plan, packs--> Packing
"""

from symscrew.program.lanes.packs import Pack, Packing, Vector, packed

__all__ = ["Pack", "Packing", "Vector", "packed"]

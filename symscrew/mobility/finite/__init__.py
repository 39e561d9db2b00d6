"""What really moves: finite displacements through a configuration, against the instantaneous ones.

    Network --independent_parts--> blocks --passive_spins--> fewer unknowns --finite_motion--> FiniteMobility

`finite_motion` decides, block by block, from cheap and proved to sampled:

    variety          joint displacements that close all loops, by exponentials of the screws
    closure_residual the same residual with 60 digits in fixed-point integers
    local_solutions  range, null space and self-stresses at one configuration
    tangent_cone     series of the loops in powers of t, by screw brackets only
    reduced_closure  the redundant equations g(u) = 0 that are left once the others are solved
    quadric_cone     directions in which g vanishes to second order: where branches are looked for
    branches         dimensions of the branches through a singular configuration
    almost_ranks     ranks of closure, platform, drives and limbs that are almost lower as typed
    joint_changes    places and axes of joints, changed a little
    aligned_axes     axes that are almost parallel, coaxial or through one point, made so
    alike_links      lengths, angles and offsets of links that are almost equal
    geometry_search  numbers of the geometry with conditions on it, and steps that meet them
    approach         these steps, until they have ended, with the least change
    near_geometry    the nearest geometry in which these ranks are lost and loops keep closed that almost do
    witnesses        what every claim rests on, checked again by another of these routes
"""

from symscrew.mobility.finite.almost_ranks import RankClaim, rank_claims
from symscrew.mobility.finite.approach import NearGeometry
from symscrew.mobility.finite.finite_motion import FiniteMobility, finite_mobility, kind_of, smooth_mobility
from symscrew.mobility.finite.independent_parts import blocks_of
from symscrew.mobility.finite.local_solutions import (
    CLOSED,
    Local,
    definite_stress,
    local_at,
    quadratic_forms,
    refine,
    solve_dependent,
)
from symscrew.mobility.finite.near_geometry import search_special
from symscrew.mobility.finite.passive_spins import (
    lone_pairs,
    named_spins,
    passive_freedoms,
    rotation_vector,
    undriven_freedoms,
    without_spins,
)
from symscrew.mobility.finite.quadric_cone import cone_directions
from symscrew.mobility.finite.reduced_closure import ReducedClosure, is_zero
from symscrew.mobility.finite.variety import DIGITS_60, DOUBLE, Arithmetic, Array, ClosureVariety, moved
from symscrew.mobility.finite.witnesses import Witness, recheck

__all__ = [
    "CLOSED",
    "DIGITS_60",
    "DOUBLE",
    "Arithmetic",
    "Array",
    "ClosureVariety",
    "FiniteMobility",
    "Local",
    "NearGeometry",
    "RankClaim",
    "ReducedClosure",
    "Witness",
    "blocks_of",
    "cone_directions",
    "definite_stress",
    "finite_mobility",
    "is_zero",
    "kind_of",
    "local_at",
    "lone_pairs",
    "moved",
    "named_spins",
    "passive_freedoms",
    "quadratic_forms",
    "rank_claims",
    "recheck",
    "refine",
    "rotation_vector",
    "search_special",
    "smooth_mobility",
    "solve_dependent",
    "undriven_freedoms",
    "without_spins",
]

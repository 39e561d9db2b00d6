"""What pivots are, and what it means that one vanishes: a sentence each, from where it comes in the theory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from symscrew.algebra import Origin
from symscrew.export.listing import plain
from symscrew.program import Program

# quantity -> where it vanishes; {part} is a body, joint or motion with its component, {by} what the pivot belongs to
VANISHES: Mapping[str, str] = {
    "lever": "where the reciprocal wrench {by} has no power along {part}, as in a stretched limb",
    "closure": "where {by} does not move the loop at {part}",
    "follows": "where {by} does not move the loop at {part}",
    "constraint": "where the reciprocal wrench {part} degenerates",
    "joint_force": "where {by} cannot balance {part}",
    "balance": "where {by} cannot balance {part}",
    "multiplier_part": "where {by} cannot balance {part}",
    "share": "where the drives do not hold a freedom",
    "reduced_inertia": "where {part} feels no inertia",
    "mass_matrix": "where {part} feels no inertia",
    "stiffness": "where {part} feels no inertia",
    "articulated": "where {part} feels no inertia",
    "null_space": "where the loops no longer tie {part}",
    "limb_length": "where the points of {part} coincide",
    "limb_target": "where the points of {part} coincide",
    "cos": "where {part} is at a quarter turn",
    "sin": "where {part} is at a half turn, or at none",
    "offset": "where {part} has no length",
}
WITH_PART: Mapping[str, str] = {
    "pivot": "where the loops no longer determine {part}",
    "determinant": "where the balance no longer determines what {part} transmits",
}
WITHOUT: Mapping[str, str] = {
    "pivot": "where step {component} of symmetric equations loses rank: of drives, inertia or internal loads",
    "determinant": "where equations that are solved at once lose rank, as drives do at a singularity",
}


SMALL = "status 1 where a pivot is smaller than its limit:"  # what stands over all pivots of a function


def pivot_text(origin: Origin | None) -> str:
    """Where a pivot vanishes, in words."""
    if origin is None:
        return "where the elimination meets a singularity"
    place = f"{origin.part}.{origin.component}".strip(".")
    if origin.quantity in ("lever", "closure", "follows"):  # a component of a wrench, not of a motion
        place = origin.part
    table = WITH_PART if origin.part else WITHOUT
    text = table.get(origin.quantity) or VANISHES.get(origin.quantity, f"where {origin.quantity} {{part}} vanishes")
    return text.format(part=place, by=origin.by or "nothing", component=origin.component)


def pivots_told(program: Program) -> Iterator[tuple[int, float, str]]:
    """Of every pivot its slot, its limit, and where it vanishes, in words for a comment."""
    for slot, limit in program.guards:
        yield slot, limit, plain(pivot_text(program.origins.get(slot)))

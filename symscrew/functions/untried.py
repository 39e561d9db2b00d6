"""What was not tried because a mechanism is large, in words for the notes of its model.

Functions are the same numbers by any way; what is said here is that there may be one with fewer operations.
"""

from __future__ import annotations

from symscrew.dynamics import by_articulated_bodies, long_branches
from symscrew.kinematics import System
from symscrew.loops import counts_all_ways


def untried_notes(system: System) -> tuple[str, ...]:
    """One sentence for each size beyond which some ways to a function are not built; none for small mechanisms."""
    count, notes = len(system.tree.v), []
    if by_articulated_bodies(system):
        notes.append(f"{count} freedoms: forward dynamics is by articulated bodies; by the mass matrix was not tried")
    if not system.cuts:
        return tuple(notes)
    if not counts_all_ways(system):
        notes.append(
            f"{count} freedoms of the tree: of the ways to write the loops, to order the elimination of forces and to "
            "solve for accelerations only the first was tried, others may take fewer operations"
        )
    elif long_branches(system):
        notes.append(
            f"{long_branches(system)} long branches on the ground: their forces at rest accelerations are by the "
            "recursion; by the derivatives of their mass matrix was not tried"
        )
    return tuple(notes)

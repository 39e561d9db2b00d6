"""Joints of which it is proved, not only seen, that they do not move near the configuration."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility

MOST_NAMED = 12
"""Joints that are named in a line; all are in the JSON."""


def resting_joints(found: Mobility) -> tuple[str, ...]:
    """Joints of loops that no branch was seen to move, and of which it is proved that none does."""
    rows = () if found.branches is None else found.branches.rows
    if not all(row.idle for row in rows) or found.motion_proof is None:  # a proof is looked for where it may be there
        return ()
    return found.motion_proof.resting


def resting_lines(found: Mobility) -> list[str]:
    """The same in words; nothing where there are none."""
    names = resting_joints(found)
    more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
    return [f"At rest near the configuration, proved: {', '.join(names[:MOST_NAMED])}{more}"] if names else []

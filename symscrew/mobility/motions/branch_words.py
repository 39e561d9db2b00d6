"""The branch table in words and as JSON values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.branch_table import BranchRow, BranchTable

MOST_NAMED = 6
"""Joints, axes and rates that are named in a line; of more, how many there are. All are in the JSON."""
SHOWN = 5e-4
"""Rates below this part of the largest are left out of a tangent in words: it is known to three digits."""


def branch_lines(table: BranchTable, network: Network) -> list[str]:
    """A line for each branch, and whether there are others."""
    lines = [f"{number}: {_line(row, table, network)}" for number, row in enumerate(table.rows, start=1)]
    if not table.rows:
        lines.append("no branch: the configuration is isolated")
    lines.append(f"Complete, proved: {table.complete}" if table.complete else f"Not proved complete: {table.open}")
    lines.append("Freedoms of the platform, joints at rest and axes: sampled at two points of each branch")
    return lines


def _line(row: BranchRow, table: BranchTable, network: Network) -> str:
    if row.platform is None:
        return f"dimension {row.dimension} ({table.judgement}); shaky all along, so that its tangents are not known"
    changing = "" if row.constant else f" {'here' if row.here else 'nearby'}, not constant"
    parts = [f"dimension {row.dimension} ({table.judgement})"]
    parts.append(f"{table.body} {row.platform.motion_type}, {row.platform}{changing}")
    if row.almost:
        parts.append(f"as typed; to seven digits {row.almost}")
    if row.axes:
        parts.append(f"can move {named_axes(row.axes)}")
    if row.internal:
        parts.append(f"{row.internal} internal")
    parts.append(f"at rest: {_named(row.idle)}" if row.idle else "all joints move")
    if row.cusp:
        parts.append("a cusp: it leaves to one side only")
    if row.dimension == 1 and len(row.tangent):
        parts.append(f"tangent {_rates(row, network)}")
    return "; ".join(parts)


def _named(names: tuple[str, ...]) -> str:
    more = len(names) - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def named_axes(axes: Sequence[str]) -> str:
    """Axes as `axis_name` names them, in few words: `about the axes of A, B, along the axis of C`."""
    shown, joints = axes[:MOST_NAMED], dict[str, list[str]]()
    for axis in shown:
        which, _, joint = axis.rpartition(" of ")
        joints.setdefault(which, []).append(joint)
    several = ((w.replace("axis", "axes") if len(names) > 1 else w, names) for w, names in joints.items())
    more = f" and {len(axes) - MOST_NAMED} more" if len(axes) > MOST_NAMED else ""
    return ", ".join(f"{which} of {', '.join(names)}" for which, names in several) + more


def freedom_names(network: Network) -> list[str]:
    """A name for every column: the joint, or joint.i."""
    names = []
    for edge in network.edges.values():
        count = len(edge.screws)
        names += [edge.name] if count == 1 else [f"{edge.name}.{i}" for i in range(count)]
    return names


def _rates(row: BranchRow, network: Network) -> str:
    rates = row.tangent[0] / np.abs(row.tangent[0]).max()
    named = [(n, r) for n, r in zip(freedom_names(network), rates, strict=True) if abs(r) > SHOWN]
    text = ", ".join(f"{name} {rate:.3g}" for name, rate in named[:MOST_NAMED])
    return text + (", ..." if len(named) > MOST_NAMED else "")


def branch_values(table: BranchTable, network: Network) -> dict[str, Any]:
    """The table as JSON values. Tangents: unit motions, one column a joint freedom, lengths over the length given."""
    return {
        "body": table.body,
        "judgement": table.judgement,
        "complete": bool(table.complete),
        "why": table.complete or table.open,
        "length": float(network.length),
        "columns": freedom_names(network),
        "branches": [
            {
                "dimension": row.dimension,
                "tangent": [[round(float(c), 6) for c in direction] for direction in row.tangent],
                "platform": row.platform
                and {
                    "type": row.platform.type,
                    "motion_type": row.platform.motion_type,
                    "dof": row.platform.order,
                    "class": row.platform.name,
                    "principal_pitches": list(row.platform.pitches),
                    "constant": row.constant,
                },
                "internal_freedoms": row.internal,
                "idle_joints": list(row.idle),
                "axes": list(row.axes),
                "cusp": row.cusp,
                "almost": row.almost,
            }
            for row in table.rows
        ],
    }

"""Invented mechanisms of all joint types against Gauss's principle and Newton-Euler in maximal coordinates."""

from __future__ import annotations

from dataclasses import asdict

from support.gauss_principle import differences
from support.invented_mechanisms import INVENTED, invented

from symscrew.effects import Gravity
from symscrew.model import derive

from .tables import table

DRIVE = 3.0  # N or N m, on the first freedom of the first joint


def run(*, repeats: int = 1) -> tuple[str, dict[str, object]]:
    """A row a mechanism: its joints, freedoms, redundant constraints, and the largest differences at three states."""
    rows, raw = [], {}
    for name, joints in INVENTED.items():
        found = derive(invented(name), [Gravity()])
        seen = differences(found, DRIVE)
        free = len(found.independent) or len(found.system.tree.v)
        kinds = " ".join(kind for kind, *_ in joints)
        rows.append([name, kinds, free, seen.open_rows, f"{seen.joints:.1e}", f"{seen.accelerations:.1e}",
                     f"{seen.drives:.1e}"])  # fmt: skip
        raw[name] = asdict(seen)
    header = ["mechanism", "joints", "freedoms", "redundant", "off its joints", "accelerations", "drives"]
    return table(header, rows), {"mechanisms": raw}

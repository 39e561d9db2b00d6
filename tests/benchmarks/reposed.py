"""How many mechanisms keep their verdict when they are turned at random and typed with few digits."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path
from typing import Any

from .tables import table

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.reposed import DIGITS, UNITS, every

VERDICTS = ("kept", "explained", "warned", "undecided", "wrong")


def run(*, repeats: int = 1, seed: int = 0) -> tuple[str, dict[str, Any]]:
    """Markdown and raw verdicts; `repeats` is of no use here, since nothing is timed. Another `seed`: other poses."""
    raw: dict[str, str] = {}
    counts: dict[tuple[str, str, str], Counter[str]] = {}
    for digits, unit, name, judge in every(seed=seed):
        verdict = judge().verdict
        raw[f"{digits} {unit} {name}"] = verdict
        kind = "generic" if name.startswith("generic") and name[7:].isdigit() else "special"
        counts.setdefault((digits, unit, kind), Counter())[verdict] += 1
    rows: list[list[object]] = [[*key, *(found[v] for v in VERDICTS)] for key, found in counts.items()]
    assert len(rows) == 2 * len(DIGITS) * len(UNITS)
    return table(["digits", "unit", "mechanisms", *VERDICTS], rows), raw

"""Processor time of `symscrew mobility` by command: every mechanism of the catalogue and of the literature, cold.

Every analysis has a process of its own, started from nothing, as a user's; processor seconds, since the machine may be
shared. The literature's are those of the tests: `data/mobility.json` and `support.further_mechanisms`.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

from support.further_mechanisms import CASES
from support.reference_mechanisms import ENTRIES, build

from symscrew import catalogue
from symscrew.description.toml_file import to_toml

from .mechanisms import hinged_octahedron
from .tables import table

SHOWN = 12
"""The dearest of each kind that have a line of their own; all are in the raw numbers."""
QUANTILES = (50, 95, 100)


def cases() -> Iterator[tuple[str, str, str]]:
    """(kind, name, a name of the catalogue or the text of a file)."""
    yield from (("catalogue", name, name) for name in catalogue.names())
    yield from (("literature", name, to_toml(build(entry))) for name, entry in ENTRIES.items())
    yield from (("literature", name, to_toml(case.make())) for name, case in CASES.items())
    yield "12 square roots", "hinged octahedron", to_toml(hinged_octahedron())


def seconds(mechanism: str, repeats: int) -> float:
    """Median processor time of the command [s]."""
    spent = []
    kept = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    for _ in range(repeats):
        command = [sys.executable, "-m", "symscrew", "mobility", "--no-cache", mechanism]
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said, env=kept)
            _, status, usage = os.wait4(process.pid, 0)
            said.seek(0)
            assert b"Traceback" not in said.read(), f"{mechanism}: the command ended in a traceback"
        process.returncode = os.waitstatus_to_exitcode(status)
        assert process.returncode in (0, 1), f"{mechanism}: the command ended with {process.returncode}"
        spent.append(usage.ru_utime + usage.ru_stime)
    return median(spent)


def run(*, repeats: int = 1) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers: quantiles of each kind, then the dearest."""
    raw: dict[str, dict[str, float]] = {}
    with tempfile.TemporaryDirectory() as folder:
        seconds("four_bar", 1)  # modules are compiled once, by an installation or a first run
        for k, (kind, name, text) in enumerate(cases()):
            path = Path(folder) / f"case{k}.toml"
            if "\n" in text:
                path.write_text(text, encoding="utf-8")
            raw.setdefault(kind, {})[name] = seconds(str(path) if "\n" in text else text, repeats)
    rows: list[list[object]] = []
    for kind, found in raw.items():
        ordered = sorted(found.values())
        at = [ordered[round((len(ordered) - 1) * q / 100)] for q in QUANTILES]
        rows.append([kind, len(found), *(f"{t:.2f}" for t in at)])
    dearest = sorted(((t, name) for found in raw.values() for name, t in found.items()), reverse=True)[:SHOWN]
    header = ["mechanisms", "number", "median [s]", "95 % [s]", "most [s]"]
    first = table(header, rows)
    second = table(["dearest", "[s]"], [[name, f"{t:.2f}"] for t, name in dearest])
    return f"{first}\n\n{second}", dict(raw)

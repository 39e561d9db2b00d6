"""What everything that is kept depends on beside its input: this package, file by file, and what it computes with."""

from __future__ import annotations

import os
import re
import sys
from contextlib import suppress
from functools import cache
from pathlib import Path

from symscrew import __version__

PACKAGE = Path(__file__).parents[1]


@cache
def version() -> str:
    """The package's version, its files with sizes and times, and the versions of Python and NumPy.

    What editors and tools leave among the files for a moment (`.name.swp`, `.nfs0123`) is none of them. Looked at once
    in a process: whatever changes later counts in those that start then.
    """
    facts = [__version__, sys.version, installed("numpy")]
    for folder, _, files in sorted(os.walk(PACKAGE)):
        if folder.endswith("__pycache__"):
            continue
        for file in sorted(name for name in files if not name.startswith(".")):
            with suppress(FileNotFoundError):  # gone by now
                found = os.stat(os.path.join(folder, file))
                facts.append(f"{folder}/{file} {found.st_size} {found.st_mtime_ns}")
    return "\n".join(facts)


def installed(library: str) -> str:
    """The version of a library that is found first where this Python looks; "" where none is.

    By the names of folders that installers make, as `importlib.metadata` has them, whose import takes as long as
    reading a simple description.
    """
    return _found().get(library, "")


@cache
def _found() -> dict[str, str]:
    """Versions of all that is installed, by names."""
    name = re.compile(r"([A-Za-z0-9_.]+)-(.+)\.(?:dist|egg)-info")
    found: dict[str, str] = {}
    for place in sys.path:
        with suppress(OSError), os.scandir(place or ".") as entries:
            for match in filter(None, (name.fullmatch(entry.name) for entry in entries)):
                found.setdefault(match[1], match[2])
    return found

"""What everything that is kept depends on beside its input: this package, file by file, and what it computes with."""

from __future__ import annotations

import os
import sys
from functools import cache
from importlib import metadata
from pathlib import Path

from symscrew import __version__

PACKAGE = Path(__file__).parents[1]


@cache
def version() -> str:
    """The package's version, its files with sizes and times, and the versions of Python and NumPy."""
    facts = [__version__, sys.version, installed("numpy")]
    for folder, _, files in sorted(os.walk(PACKAGE)):
        if not folder.endswith("__pycache__"):
            found = ((file, os.stat(os.path.join(folder, file))) for file in sorted(files))
            facts += [f"{folder}/{file} {facts.st_size} {facts.st_mtime_ns}" for file, facts in found]
    return "\n".join(facts)


def installed(library: str) -> str:
    """The version of a library that is installed; "" where none is. Nothing is imported for it."""
    try:
        return metadata.version(library)
    except metadata.PackageNotFoundError:
        return ""

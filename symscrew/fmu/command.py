"""`symscrew fmu`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from symscrew import catalogue, scene
from symscrew.effects import Gravity
from symscrew.errors import DescriptionError
from symscrew.fmu.archive import at_rest, build
from symscrew.scene import Scene


def run(options: argparse.Namespace) -> int:
    """Read, derive, print, compile, pack."""
    path = Path(options.out)
    if path.suffix != ".fmu":
        raise DescriptionError(f"--out: expected a file name that ends in .fmu, got {options.out!r}")
    if not path.parent.is_dir():
        raise DescriptionError(f"--out: expected a folder that exists, got {str(path.parent)!r}; make it first")
    for note in build(_scene(options.scene), path, version=options.fmi):
        print(f"note: {note}", file=sys.stderr)
    print(path)
    return 0


def _scene(name: str) -> Scene:
    """A scene file, or a mechanism at rest under its weight with the drives as inputs."""
    if name in catalogue.names():
        return at_rest(catalogue.load(name), (Gravity(),))
    return scene.load(name)

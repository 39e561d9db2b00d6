"""`symscrew fmu`."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

from symscrew import catalogue, scene
from symscrew.effects import Gravity
from symscrew.errors import DescriptionError
from symscrew.fmu import at_rest, build_unit
from symscrew.formats import READABLE
from symscrew.scene import Scene


def run(options: argparse.Namespace) -> int:
    """Read, derive, print, compile, pack."""
    path = Path(options.out)
    if path.suffix != ".fmu":
        raise DescriptionError(f"--out: expected a file name that ends in .fmu, got {options.out!r}")
    if not path.parent.is_dir():
        raise DescriptionError(f"--out: expected a folder that exists, got {str(path.parent)!r}; make it first")
    for note in build_unit(_scene(options.scene), path, version=options.fmi):
        print(f"note: {note}", file=sys.stderr)
    print(path)
    return 0


def _scene(name: str) -> Scene:
    """A scene file, or a mechanism at rest under its weight with the drives as inputs."""
    if name in catalogue.names() or Path(name).suffix in READABLE or _describes(Path(name)):
        return at_rest(catalogue.find(name), (Gravity(),))
    return scene.load_scene(name)


def _describes(path: Path) -> bool:
    """Whether a file has the section of a mechanism, which a scene only names."""
    if path.suffix != ".toml" or not path.is_file():
        return False
    return re.search(r"^\s*\[mechanism\]", path.read_text(encoding="utf-8", errors="replace"), re.MULTILINE) is not None

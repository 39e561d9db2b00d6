"""`symscrew fmu`: a scene, or a mechanism under its weight, as a functional mock-up unit."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE
from symscrew.cli.shared_options import add_no_cache, find_mechanism
from symscrew.whole_files import destination

if TYPE_CHECKING:
    from symscrew.scene import Scene

EXAMPLES = (
    "symscrew fmu examples/scenes/hanging_platform.toml --out platform.fmu",
    "symscrew fmu ur5 --out ur5.fmu --fmi 2",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew fmu`."""
    command.add_argument("scene", metavar="SCENE|NAME", help="a scene file, or a mechanism under its weight")
    command.add_argument("--out", metavar="FILE.fmu", required=True, help="the unit, C sources inside")
    command.add_argument("--fmi", type=int, choices=(2, 3), default=3, help="version of the standard; default: 3")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive, print, compile, pack."""
    from symscrew.fmu import build_unit

    path = destination(options.out, (".fmu",), "--out")
    for note in build_unit(_scene(options.scene), path, version=options.fmi):
        print(f"note: {note}", file=sys.stderr)
    print(path)
    return DONE


def _scene(name: str) -> Scene:
    """A scene file, or a mechanism at rest under its weight with the drives as inputs."""
    from symscrew import catalogue, scene
    from symscrew.effects import Gravity
    from symscrew.fmu import at_rest
    from symscrew.formats import READABLE

    if name in catalogue.names() or Path(name).suffix in READABLE or _describes(Path(name)):
        return at_rest(find_mechanism(name, acting=True), (Gravity(),))
    return scene.load_scene(name)


def _describes(path: Path) -> bool:
    """Whether a file has the section of a mechanism, which a scene only names."""
    from symscrew.description import read_text

    if path.suffix != ".toml" or not path.is_file():
        return False
    return re.search(r"^\s*\[mechanism\]", read_text(path), re.MULTILINE) is not None

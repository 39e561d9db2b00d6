"""`symscrew convert`: a description in another format."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import add_mechanism, writable_folder

EXAMPLES = ("symscrew convert robot.urdf --out robot.toml", "symscrew convert ur5 --out ur5.xml")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew convert`."""
    add_mechanism(command)
    command.add_argument("--out", metavar="FILE", required=True, help="a new file: .toml, .urdf, .xml or .mjcf (MJCF)")
    command.add_argument("--replace", action="store_true", help="write over a file that exists; its comments are lost")


def run(options: argparse.Namespace) -> int:
    """Read, write; what the format lost on the way in is noted on stderr."""
    from symscrew import catalogue
    from symscrew.formats import WRITERS, save_as

    path = Path(options.out)
    if path.suffix not in WRITERS:
        raise UsageError(f"--out: expected a name that ends in {', '.join(WRITERS)}, got {options.out!r}")
    if path.exists() and not options.replace:
        raise UsageError(f"--out: {path} exists and is left as it is; choose another name, or say --replace")
    mechanism = catalogue.find(options.mechanism)
    writable_folder(str(path.parent))
    save_as(mechanism, path)
    print(path)
    for note in mechanism.source.split("; ")[1:] if mechanism.source.startswith("imported from") else ():
        print(f"note: {note}", file=sys.stderr)
    return DONE

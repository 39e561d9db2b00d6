"""`symscrew assemble`: every assembly mode for given drives, certified, as text, JSON or a picture.

In Python that is `symscrew.assembly_modes`; `symscrew.assemble` gives the one configuration near a guess.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import (
    add_mechanism,
    check_expected,
    check_folder,
    find_mechanism,
    need_matplotlib,
    settings,
    writable_folder,
)
from symscrew.errors import shorten

if TYPE_CHECKING:
    from symscrew.assembly import AssemblyModes

EXAMPLES = (
    "symscrew assemble stewart_6ups",
    "symscrew assemble planar_3rrr --drives limb1_R1=0.2 --picture modes.png",
    "symscrew assemble four_bar --json --reachable",
)
FORMATS = (".png", ".pdf", ".svg")
IN_PYTHON = """In Python symscrew.assembly_modes(mechanism) gives them all, as this command does;
symscrew.assemble(model, {...}) is another thing: the one configuration near a guess."""


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew assemble`."""
    command.description = f"{command.description}\n{IN_PYTHON}"
    add_mechanism(command)
    command.add_argument(
        "--drives", nargs="+", default=[], metavar="KEY=VALUE",
        help="driven coordinates (joint, joint.i) [rad, m]; others are as in the reference",
    )  # fmt: skip
    command.add_argument(
        "--at", nargs="+", default=[], metavar="KEY=VALUE",
        help="parameters, or coordinates of joints that are held in place of the drives",
    )  # fmt: skip
    command.add_argument("--expect", type=int, metavar="N", help="exit 1 unless there are N modes, certified")
    command.add_argument(
        "--reachable", action="store_true",
        help="look for ways without a singularity from mode to mode, and prove them (seconds to a minute)",
    )  # fmt: skip
    command.add_argument("--json", action="store_true", help="as JSON")
    command.add_argument("--picture", metavar="FILE", help=f"all modes side by side: {', '.join(FORMATS)}")


def run(options: argparse.Namespace) -> int:
    """Solve, print, draw; 1 when a mode is neither certified nor singular, or there are others than expected."""
    from symscrew.assembly import assembly_modes, mode_lines, mode_values, reach_lines, reachable_modes
    from symscrew.display import print_text
    from symscrew.kinematics import angle_notices

    check_expected(options)
    picture = _picture(options.picture)
    drives, at = (settings(name, getattr(options, name)) for name in ("drives", "at"))
    mechanism = find_mechanism(options.mechanism)
    for notice in angle_notices(mechanism, {**drives, **at}):
        print(f"note: {notice}", file=sys.stderr)
    progress = _progress if sys.stderr.isatty() else lambda _: None
    found = assembly_modes(mechanism, drives, at=at, progress=progress)
    ways = reachable_modes(found, search=options.reachable, progress=progress)
    if options.json:
        print(json.dumps(mode_values(found, ways), indent=1))
    else:
        print_text("\n".join([*mode_lines(found), *reach_lines(found, ways, searched=options.reachable)]))
    if picture is not None:
        from symscrew.display import modes_figure, save_figure

        writable_folder(str(picture.parent))
        print(save_figure(modes_figure(found), picture, tight=True), file=sys.stderr)
    return DONE if _good(found, options.expect) else FAILED


def _good(found: AssemblyModes, expect: int | None) -> bool:
    """Whether what was found judges itself good: no path lost, every regular mode certified where it can be."""
    if expect is not None:
        return len(found.modes) == expect and all(mode.certified for mode in found.modes)
    certified = all(mode.certified or mode.paths > 1 or mode.curve for mode in found.modes)
    return not found.account.count("lost") and (certified or found.complete == "sampled")


def _picture(name: str | None) -> Path | None:
    if name is None:
        return None
    path = Path(name)
    if path.suffix not in FORMATS:
        raise UsageError(f"--picture: expected a file name that ends in {' or '.join(FORMATS)}, got {shorten(name)}")
    check_folder(path.parent, "--picture")
    need_matplotlib()
    return path


def _progress(text: str) -> None:
    print(text, file=sys.stderr)

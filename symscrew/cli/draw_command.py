"""`symscrew draw`: a picture of a mechanism."""

from __future__ import annotations

import argparse
from pathlib import Path

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import add_mechanism, check_folder, find_mechanism, need_matplotlib, writable_folder

EXAMPLES = ("symscrew draw three_ups_upu_s --out seed.png", "symscrew draw delta --out delta.pdf")
FORMATS = (".png", ".pdf", ".svg")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew draw`."""
    add_mechanism(command)
    command.add_argument("--out", metavar="FILE", required=True, help=f"the picture: {', '.join(FORMATS)}")


def run(options: argparse.Namespace) -> int:
    """Read, draw, print the place."""

    path = Path(options.out)
    if path.suffix not in FORMATS:
        raise UsageError(f"--out: expected a file name that ends in {' or '.join(FORMATS)}, got {options.out!r}")
    check_folder(path.parent)
    mechanism = find_mechanism(options.mechanism)
    writable_folder(str(path.parent))
    need_matplotlib()
    from symscrew.display import mechanism_figure, save_figure

    print(save_figure(mechanism_figure(mechanism), path, tight=True))
    return DONE

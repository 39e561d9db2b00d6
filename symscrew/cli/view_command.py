"""`symscrew view`: a page with a mechanism in 3-D."""

from __future__ import annotations

import argparse
from pathlib import Path

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import (
    add_gravity,
    add_independent,
    add_no_cache,
    check_folder,
    chosen_effects,
    writable_folder,
)

EXAMPLES = ("symscrew view three_ups_upu_s", "symscrew view run.npz --out run.html")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew view`."""
    command.add_argument("mechanism", metavar="NAME|FILE|RUN.npz", help="a mechanism, or a recorded motion to play")
    command.add_argument("--out", metavar="FILE.html", help="the page; without it the page is opened in the browser")
    add_gravity(command)
    add_independent(command)
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive, write or open, print the place."""
    from symscrew.display import Progress, open_page, read_mechanism_and_motion, write_page
    from symscrew.model import derive

    if options.out and Path(options.out).suffix != ".html":
        raise UsageError(f"--out: expected a file name that ends in .html, got {options.out!r}")
    if options.out:
        check_folder(Path(options.out).parent)
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism, motion = read_mechanism_and_motion(options.mechanism)
        effects = chosen_effects(options, mechanism)
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism, effects, independent=options.independent)
    if options.out is None:
        print(open_page(model, motion))
    else:
        writable_folder(str(Path(options.out).parent))
        print(write_page(model, options.out, motion))
    return DONE

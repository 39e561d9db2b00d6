"""`symscrew view`: a page with a mechanism in 3-D."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import (
    add_gravity,
    add_independent,
    add_no_cache,
    check_folder,
    chosen_effects,
    writable_folder,
)

if TYPE_CHECKING:
    from symscrew.description import Mechanism
    from symscrew.display import Progress, RecordedMotion
    from symscrew.effects import Effect

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
    from symscrew.display import Progress, open_made, read_mechanism_and_motion, write_made

    if options.out and Path(options.out).suffix != ".html":
        raise UsageError(f"--out: expected a file name that ends in .html, got {options.out!r}")
    if options.out:
        check_folder(Path(options.out).parent)
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism, motion = read_mechanism_and_motion(options.mechanism)
        effects = chosen_effects(options, mechanism)
    page = _page(mechanism, effects, options.independent, motion=motion, progress=progress)
    if options.out is None:
        print(open_made(page, mechanism.name))
    else:
        writable_folder(str(Path(options.out).parent))
        print(write_made(page, options.out))
    return DONE


def _page(
    mechanism: Mechanism,
    effects: Sequence[Effect],
    independent: Sequence[str] | None,
    *,
    motion: RecordedMotion | None,
    progress: Progress,
) -> str:
    """The page as text: that of the user's cache, if no motion is played in it and it was made before."""
    from symscrew.display import make_page
    from symscrew.model import derive
    from symscrew.runtime import entry, model_key

    with entry(model_key(mechanism, effects, independent, of=b"page") if motion is None else None) as kept:
        found = kept.read()
        if found is not None:
            return found.decode("utf-8")
        with progress.step(f"derive {mechanism.name}"):
            model = derive(mechanism, effects, independent=independent)
        page = make_page(model, motion)
        kept.write(page.encode("utf-8"))
        return page

"""`symscrew cost`: the bill of a scene's effects, as a table, as JSON, as a picture."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from symscrew.cli.help import DONE
from symscrew.cli.shared_options import add_no_cache, need_matplotlib
from symscrew.whole_files import destination

EXAMPLES = ("symscrew cost examples/scenes/falling_platform.toml", "symscrew cost scene.toml --plot bill.png")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew cost`."""
    command.add_argument("scene", metavar="SCENE", help="a scene file")
    command.add_argument("--json", action="store_true", help="as JSON")
    command.add_argument("--plot", metavar="FILE.png", help="the bill as a picture")
    command.add_argument("--no-timing", action="store_true", help="count only: nothing is compiled")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive with and without every effect, print, draw."""
    from symscrew.display import Progress, print_table, print_text
    from symscrew.scene import load_scene
    from symscrew.studies import bill_table, scene_bill

    path = _picture(options.plot) if options.plot else None
    found = scene_bill(load_scene(options.scene), timed=not options.no_timing, progress=Progress())
    if options.json:
        print(json.dumps(found.values(), indent=1, ensure_ascii=False))
    else:
        print_text(f"{found.name}: {found.mechanism}, {found.motion}")
        print_table(*bill_table(found))
        for note in found.notes:
            print_text(note)
        print_text(
            "operations, states and ns: with the effect less without it; drives, accelerations: change without it"
        )
        print_text("at most: operations of the effect's own program alone, its force screws and their projection")
    if path is not None:
        from symscrew.display import save_figure
        from symscrew.studies import bill_figure

        save_figure(bill_figure(found), path)
    return DONE


def _picture(name: str) -> Path:
    """Where `--plot` goes."""
    need_matplotlib()
    return destination(name, (".png",), "--plot")

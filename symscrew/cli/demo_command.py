"""`symscrew demo`: the source paper's mechanism from description to figures."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from symscrew.cli.help import DONE, FAILED
from symscrew.cli.shared_options import add_no_cache, check_folder, need_matplotlib

EXAMPLES = ("symscrew demo", "symscrew demo --out figures")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew demo`."""
    command.add_argument("--out", metavar="DIR", help="write figures and a summary here; nothing is written without it")
    command.add_argument("--json", action="store_true", help="numbers as JSON instead of the tables")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Compute, draw, print; 1 where a number is not the paper's."""
    from symscrew.display import Progress
    from symscrew.studies.demo import demo_facts, demo_summary, demo_values, study_paper, write_figures

    if options.out:
        need_matplotlib()
        check_folder(options.out)
    directory = Path(options.out) if options.out else None
    progress = Progress()
    result = study_paper(progress=progress)
    written = write_figures(result, directory, progress) if directory else []
    if options.json:
        print(json.dumps(demo_values(result), indent=1))
    else:
        print(demo_facts(result))
        print()
        print(demo_summary(result))
        if directory:
            print(f"Written to {directory}: " + ", ".join(path.name for path in written))
        else:
            print("No files were written; `symscrew demo --out DIR` draws figures 7, 8, 9 and 11 into DIR.")
    print(f"done in {progress.elapsed:.1f} s", file=sys.stderr)
    return DONE if result.agrees else FAILED

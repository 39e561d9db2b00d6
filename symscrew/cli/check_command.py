"""`symscrew check`: whether folders of generated code are what the tool would write today, and agree by number."""

from __future__ import annotations

import argparse
import json

from symscrew.cli.help import DONE, FAILED
from symscrew.cli.shared_options import add_no_cache

EXAMPLES = ("symscrew check seed", "symscrew check generated/")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew check`."""
    command.add_argument("directory", metavar="DIR", help="generated output, or a directory of such")
    command.add_argument("--json", action="store_true", help="as JSON")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Check, print; 1 where a check failed."""
    from symscrew.display import Progress, print_text
    from symscrew.verification import check

    progress = Progress()
    with progress.step(f"check {options.directory}"):
        result = check(options.directory)
    if options.json:
        told = {"ok": result.ok, "verdict": result.verdict, "skipped": result.skipped, "lines": result.lines}
        print(json.dumps(told, indent=1, ensure_ascii=False))
    else:
        print_text("\n".join([*result.lines, result.verdict]))
    return DONE if result.ok else FAILED

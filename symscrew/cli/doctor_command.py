"""`symscrew doctor`: what is installed, and what each part is for."""

from __future__ import annotations

import argparse
import json

from symscrew.cli.help import DONE

EXAMPLES = ("symscrew doctor", "symscrew doctor --json")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew doctor`."""
    command.add_argument("--json", action="store_true", help="as JSON")


def run(options: argparse.Namespace) -> int:
    """Look, print."""
    from symscrew.display import installation, print_table

    rows = installation()
    header = ("part", "found", "for", "to get it")
    if options.json:
        print(json.dumps([dict(zip(header, row, strict=True)) for row in rows], indent=1))
    else:
        print_table(header, rows)
    return DONE

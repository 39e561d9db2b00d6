"""`symscrew new`: a description to start from, of limbs in letters."""

from __future__ import annotations

import argparse

from symscrew.cli.help import DONE

EXAMPLES = (
    "symscrew new wrist --limbs 3-UPS+UPU+S",
    "symscrew new arm --limbs RRRRRR",
    "symscrew new table --limbs 3-RRR",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew new`."""
    command.add_argument("name", metavar="NAME", help="of the mechanism: letters, digits, underscores")
    command.add_argument(
        "--limbs", metavar="LIMBS", required=True, help="such as 3-UPS+UPU+S, 3-RRR or RRRRRR (an arm)"
    )
    command.add_argument("--out", metavar="FILE.toml", help="default: NAME.toml; a file that exists is left as it is")


def run(options: argparse.Namespace) -> int:
    """Write the file, print its place."""
    from symscrew.description import write_template

    print(write_template(options.name, options.limbs, options.out or f"{options.name}.toml"))
    return DONE

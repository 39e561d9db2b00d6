"""`symscrew formulas`: the formulas of a mechanism for a paper."""

from __future__ import annotations

import argparse
from pathlib import Path

from symscrew.cli.help import DONE
from symscrew.cli.shared_options import add_mechanism, find_mechanism
from symscrew.whole_files import destination

EXAMPLES = (
    "symscrew formulas three_ups_upu_s --out seed.tex",
    "symscrew formulas stewart_6ups --out stewart.tex --document",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew formulas`."""
    add_mechanism(command)
    command.add_argument("--out", metavar="FILE.tex", help=r"for \input in a paper; without it they are printed")
    command.add_argument("--document", action="store_true", help="a whole document, for pdflatex")


def run(options: argparse.Namespace) -> int:
    """Read, derive, print or write."""
    out: Path | None = destination(options.out, (".tex",), "--out") if options.out is not None else None
    from symscrew.paper_formulas import paper_formulas

    found = paper_formulas(find_mechanism(options.mechanism))
    if out is None:
        print(found.tex(document=options.document), end="")
    else:
        print(found.save(out, document=options.document))
    return DONE

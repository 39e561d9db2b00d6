"""`symscrew new`: a description to start from, of limbs in letters, of a named mechanism, of one of the catalogue."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.errors import did_you_mean, shorten

if TYPE_CHECKING:
    from symscrew.mobility import Mobility

EXAMPLES = (
    "symscrew new wrist --limbs 3-UPS+UPU+S",
    "symscrew new arm --limbs RRRRRR",
    "symscrew new robot --limbs 3-RRPaR",
    "symscrew new head --from tricept",
    "symscrew new picker --from delta",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew new`."""
    command.add_argument("name", metavar="NAME", help="of the mechanism: letters, digits, underscores")
    what = command.add_mutually_exclusive_group(required=True)
    what.add_argument(
        "--limbs",
        metavar="LIMBS",
        help="such as 3-UPS+UPU+S, 3-RRR, RRRRRR (an arm); ~UP: passive, Pa: a parallelogram",
    )
    what.add_argument(
        "--from", dest="source", metavar="NAME",
        help="a name of `symscrew list`, or of the field: tricept, exechon, 3-prs, 3-rps, 4-ruu, 4-prur, h4, "
        "orthoglide, agile-eye, hexaglide, gough",
    )  # fmt: skip
    command.add_argument("--out", metavar="FILE.toml", help="default: NAME.toml; a file that exists is left as it is")


def run(options: argparse.Namespace) -> int:
    """Write the file, print its place and how it moves; what its drives do not do is on stderr."""
    from symscrew import catalogue
    from symscrew.description import (
        ARCHITECTURES,
        architecture,
        load_description,
        renamed_text,
        write_new,
        write_template,
    )
    from symscrew.mobility import analyse_mobility

    out, promised = options.out or f"{options.name}.toml", architecture(options.source or options.limbs)
    if options.source in catalogue.names():
        path = write_new(renamed_text(options.name, catalogue.text(options.source)), out)
    elif options.source and promised is None:
        known = [*catalogue.names(), *ARCHITECTURES]
        raise UsageError(f"--from: no mechanism {shorten(options.source)}; {did_you_mean(options.source, known)}")
    else:
        path = write_template(options.name, options.source or options.limbs, out)
    print(path)
    found = analyse_mobility(load_description(path))
    for warning in found.mechanism.warnings:
        print(f"warning: {warning}", file=sys.stderr)
    print(_moves(found))
    if warning := _not_as_promised(found, path):
        print(f"warning: {warning}", file=sys.stderr)
    return DONE


def _moves(found: Mobility) -> str:
    drives = len(found.network.driven)
    return (
        f"mobility {found.finite.dof if found.finite.dof is not None else found.dof}, {found.platform.body} "
        f"{found.platform.type or 'at rest'}, {drives} drive{'s' * (drives != 1)}"
    )


def _not_as_promised(found: Mobility, path: Path) -> str:
    """What a reader of its limbs would not expect: drives and freedoms that are not as many."""
    drives, freedoms = len(found.network.driven), found.finite.dof if found.finite.dof is not None else found.dof
    look = f"symscrew mobility {path} says why; change axes and stars in the file"
    if not drives:
        return f"nothing is driven: put a star after a joint of a limb's type; {look}"
    if left := found.dof_drives_locked:
        return f"{left} freedom{'s' * (left > 1)} left with all drives locked; {look}"
    if drives > freedoms:
        few = f"{drives} drives for {freedoms} freedom{'s' * (freedoms != 1)}: driven redundantly"
        return f"{few}, as some are meant to be, or the axes are not those that the name means; {look}"
    return ""

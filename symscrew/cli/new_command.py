"""`symscrew new`: a description to start from: of letters, a named mechanism, the catalogue or a robot's file."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import rods_that_spin
from symscrew.errors import did_you_mean, shorten

if TYPE_CHECKING:
    from symscrew.cli.same_files import Outcome
    from symscrew.description import Mechanism
    from symscrew.mobility import Mobility
    from symscrew.scene import Robot

EXAMPLES = (
    "symscrew new wrist --limbs 3-UPS+UPU+S",
    "symscrew new arm --limbs RRRRRR",
    "symscrew new robot --limbs 3-RRPaR",
    "symscrew new head --from tricept",
    "symscrew new picker --from delta",
    "symscrew new arm --from robot.urdf --exact",
)
ROBOTS = (".urdf", ".xml")  # endings of files that are robots, not names
MOST_SHOWN = 20
"""Changes that the question shows: a screen of them; the rest is counted, and the file's `source` has them."""


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
        "--from", dest="source", metavar="NAME|FILE",
        help="a name of `symscrew list`, or of the field: tricept, exechon, 3-prs, 3-rps, 4-ruu, 4-prur, h4, "
        "orthoglide, agile-eye, hexaglide, gough; or a URDF or MJCF file, whose effects become NAME_scene",
    )  # fmt: skip
    command.add_argument(
        "--exact", action="store_true", help="with --from FILE: 1.5708 is pi/2; asked for where neither is said"
    )
    command.add_argument(
        "--bars", action="store_true", help="with --from FILE: rods between two balls do not spin; asked for, too"
    )
    command.add_argument(
        "--as-written", action="store_true", help="with --from FILE: digits and rods as the file has them"
    )
    command.add_argument("--out", metavar="FILE.toml", help="default: NAME.toml; a file that exists is left as it is")


def run(options: argparse.Namespace) -> int:
    """Write the file, print its place and how it moves; what its drives do not do is on stderr."""
    from symscrew import catalogue
    from symscrew.cli.kept_outcomes import once
    from symscrew.description import (
        ARCHITECTURES,
        architecture,
        load_description,
        renamed_text,
        write_new,
        write_template,
    )

    if options.source and Path(options.source).suffix in ROBOTS:
        return _from_file(options, Path(options.out or f"{options.name}.toml"))
    if options.exact or options.as_written or options.bars:
        raise UsageError(f"--exact, --bars and --as-written belong to --from with a file ({', '.join(ROBOTS)})")
    out, promised = options.out or f"{options.name}.toml", architecture(options.source or options.limbs)
    if options.source in catalogue.names():
        path = write_new(renamed_text(options.name, catalogue.text(options.source)), out)
    elif options.source and promised is None:
        known = [*catalogue.names(), *ARCHITECTURES]
        raise UsageError(f"--from: no mechanism {shorten(options.source)}; {did_you_mean(options.source, known)}")
    else:
        path = write_template(options.name, options.source or options.limbs, out)
    print(path)
    mechanism = load_description(path)
    for warning in mechanism.warnings:
        print(f"warning: {warning}", file=sys.stderr)
    found = once("new", (mechanism,), lambda: _analysed(mechanism))
    print(found.facts["moves"])
    if found.facts["warning"]:
        print(f"warning: {found.facts['warning'].replace(PLACE, str(path))}", file=sys.stderr)
    return DONE


PLACE = "\0"
"""Stands in what is kept for the place of the file: no mechanism has it in a name."""


def _analysed(mechanism: Mechanism) -> Outcome:
    from symscrew.cli.same_files import Outcome
    from symscrew.mobility import analyse_mobility

    found = analyse_mobility(mechanism)
    return Outcome({"moves": _moves(found), "warning": _not_as_promised(found)})


def _moves(found: Mobility) -> str:
    drives = len(found.network.driven)
    return (
        f"mobility {found.finite.dof if found.finite.dof is not None else found.dof}, {found.platform.body} "
        f"{found.platform.motion_type}, {drives} drive{'s' * (drives != 1)}"
    )


def _not_as_promised(found: Mobility) -> str:
    """What a reader of its limbs would not expect: drives and freedoms that are not as many."""
    drives, freedoms = len(found.network.driven), found.finite.dof if found.finite.dof is not None else found.dof
    look = f"symscrew mobility {PLACE} says why; change axes and stars in the file"
    if not drives:
        return f"nothing is driven: put a star after a joint of a limb's type; {look}"
    if left := found.dof_drives_locked:
        return f"{left} freedom{'s' * (left > 1)} left with all drives locked; {look}"
    if drives > freedoms:
        few = f"{drives} drives for {freedoms} freedom{'s' * (freedoms != 1)}: driven redundantly"
        return f"{few}, as some are meant to be, or the axes are not those that the name means; {look}"
    return ""


def _from_file(options: argparse.Namespace, out: Path) -> int:
    """A description and a scene of a robot's file, its digits as angles or as written."""
    from symscrew.description import check_name, to_toml
    from symscrew.errors import DescriptionError
    from symscrew.scene import scene_text
    from symscrew.whole_files import created

    check_name(options.name, "NAME")
    if options.as_written and (options.exact or options.bars):
        raise UsageError(f"expected {'--exact' if options.exact else '--bars'} or --as-written, got both")
    if out.suffix != ".toml":
        raise UsageError(f"--out: expected a name that ends in .toml, got {str(out)!r}")
    scene = out.with_name(f"{out.stem}_scene.toml")
    for path in (out, scene):
        if path.exists():
            raise DescriptionError(f"{path} is there already and is left as it is; use another name or --out")
    robot = _as_agreed(options, Path(options.source))
    robot = robot.named(options.name)
    texts = {out: to_toml(robot.mechanism), scene: scene_text(robot, out.name)}  # both, before any is written
    for path, text in texts.items():
        created(path, text)
    print(f"{out}\n{scene}")
    for line in robot.account.lines():
        print(line, file=sys.stderr)
    return DONE


def _as_agreed(options: argparse.Namespace, source: Path) -> Robot:
    """The file's robot, with digits and rods as the options or whoever is at the terminal say."""
    from symscrew.formats import ImportOptions
    from symscrew.scene import load_robot

    chosen = ImportOptions(exact=not options.as_written, bars=options.bars)
    robot = load_robot(source, chosen)
    meant = [line for line in robot.account.changed if " -> " in line]
    if not options.exact and not options.as_written and meant:
        if not sys.stdin.isatty():  # nobody is there: the options have to say
            raise UsageError(
                f"digits of the file mean an angle or a zero ({meant[0]}); say --exact to take them so, or --as-written"
            )
        if not _yes("Digits of the file that mean something:", meant, "Take them as that? The code gets shorter."):
            chosen = replace(chosen, exact=False)
            robot = load_robot(source, chosen)
    rods = robot.account.rods
    if not rods or options.as_written:
        return robot
    if not sys.stdin.isatty():
        print(f"note: {rods_that_spin(rods)}; --bars leaves that out", file=sys.stderr)
        return robot
    bars = load_robot(source, replace(chosen, bars=True, accept=True))
    changes = [line for line in bars.account.changed if line not in robot.account.changed]
    changes += [f"left out: {what}" for what in bars.account.influence]
    return bars if _yes(f"{rods_that_spin(rods)}:", changes, "Leave that out? The code gets shorter.") else robot


def _yes(what: str, changes: list[str], question: str) -> bool:
    """Whether somebody at the terminal wants these changes."""
    more = [f"... and {len(changes) - MOST_SHOWN} more"] if len(changes) > MOST_SHOWN else []
    print("\n".join([what, *changes[:MOST_SHOWN], *more]), file=sys.stderr)
    print(f"{question} [Y/n] ", end="", file=sys.stderr, flush=True)
    return sys.stdin.readline().strip().lower() in ("", "y", "yes")

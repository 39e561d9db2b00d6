"""`symscrew new`: a description to start from, of limbs in letters or of a robot's file."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from symscrew.cli.help import DONE, UsageError

EXAMPLES = (
    "symscrew new wrist --limbs 3-UPS+UPU+S",
    "symscrew new arm --limbs RRRRRR",
    "symscrew new table --limbs 3-RRR",
    "symscrew new arm --from robot.urdf --exact",
)
MOST_SHOWN = 20
"""Changes that the question shows: a screen of them; the rest is counted, and the file's `source` has them."""


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew new`."""
    command.add_argument("name", metavar="NAME", help="of the mechanism: letters, digits, underscores")
    command.add_argument("--limbs", metavar="LIMBS", help="such as 3-UPS+UPU+S, 3-RRR or RRRRRR (an arm)")
    command.add_argument(
        "--from", dest="robot", metavar="FILE", help="a URDF or MJCF file; its effects become NAME_scene"
    )
    command.add_argument(
        "--exact", action="store_true", help="with --from: 1.5708 is pi/2; asked for where neither is said"
    )
    command.add_argument("--as-written", action="store_true", help="with --from: every digit as the file has it")
    command.add_argument("--out", metavar="FILE.toml", help="default: NAME.toml; a file that exists is left as it is")


def run(options: argparse.Namespace) -> int:
    """Write the file, print its place."""
    from symscrew.description import write_template

    if (options.limbs is None) == (options.robot is None):
        raise UsageError("expected either --limbs, or --from with a URDF or MJCF file")
    out = Path(options.out or f"{options.name}.toml")
    if options.robot is not None:
        return _from_file(options, out)
    if options.exact or options.as_written:
        raise UsageError("--exact and --as-written belong to --from")
    print(write_template(options.name, options.limbs, out))
    return DONE


def _from_file(options: argparse.Namespace, out: Path) -> int:
    """A description and a scene of a robot's file, its digits as angles or as written."""
    from symscrew.description import check_name, to_toml
    from symscrew.errors import DescriptionError
    from symscrew.formats import ImportOptions
    from symscrew.scene import load_robot, scene_text
    from symscrew.whole_files import created

    check_name(options.name, "NAME")
    if options.exact and options.as_written:
        raise UsageError("expected --exact or --as-written, got both")
    if out.suffix != ".toml":
        raise UsageError(f"--out: expected a name that ends in .toml, got {str(out)!r}")
    scene = out.with_name(f"{out.stem}_scene.toml")
    for path in (out, scene):
        if path.exists():
            raise DescriptionError(f"{path} is there already and is left as it is; use another name or --out")
    source = Path(options.robot)
    robot = load_robot(source, ImportOptions(exact=not options.as_written))
    meant = [line for line in robot.account.changed if " -> " in line]
    if not options.exact and not options.as_written and meant and not _agreed(meant):
        robot = load_robot(source)
    robot = robot.named(options.name)
    created(out, to_toml(robot.mechanism))
    created(scene, scene_text(robot, out.name))
    print(f"{out}\n{scene}")
    for line in robot.account.lines():
        print(line, file=sys.stderr)
    return DONE


def _agreed(meant: list[str]) -> bool:
    """Whether somebody at the terminal wants these changes; where nobody is there, the options have to say."""
    if not sys.stdin.isatty():
        raise UsageError(
            f"digits of the file mean an angle or a zero ({meant[0]}); say --exact to take them so, or --as-written"
        )
    more = [f"... and {len(meant) - MOST_SHOWN} more"] if len(meant) > MOST_SHOWN else []
    print("\n".join(["Digits of the file that mean something:", *meant[:MOST_SHOWN], *more]), file=sys.stderr)
    print("Take them as that? The code gets shorter. [Y/n] ", end="", file=sys.stderr, flush=True)
    return sys.stdin.readline().strip().lower() in ("", "y", "yes")

"""`symscrew convert`: a description in another format."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import add_mechanism, check_folder, writable_folder

EXAMPLES = (
    "symscrew convert robot.urdf --out robot.toml",
    "symscrew convert robot.xml --out robot.toml --scene robot_scene.toml",
    "symscrew convert ur5 --out ur5.xml",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew convert`."""
    add_mechanism(command)
    command.add_argument("--out", metavar="FILE", required=True, help="a new file: .toml, .urdf, .xml or .mjcf (MJCF)")
    command.add_argument(
        "--replace",
        action="store_true",
        help="write over a file that exists; of a .toml comments stay with sections and keys",
    )
    command.add_argument(
        "--scene",
        metavar="FILE",
        help="also the effects that a URDF or MJCF file names, as a scene for it: a new .toml",
    )
    command.add_argument(
        "--snap", type=float, default=0.0, metavar="GAP", help="close loops that are open by up to GAP [m, rad]"
    )
    command.add_argument("--repair", action="store_true", help="the nearest possible inertia for one no body can have")
    command.add_argument("--accept", action="store_true", help="leave out what numbers depend on and is not read")
    command.add_argument("--floating", action="store_true", help="the root link of a URDF moves freely in space")
    command.add_argument(
        "--exact", action="store_true", help="digits that mean an angle or a zero are that: 1.5708 is pi/2"
    )


def run(options: argparse.Namespace) -> int:
    """Read, write; what became of all that the file says is on stderr."""
    from symscrew import catalogue
    from symscrew.description import read_text, with_comments
    from symscrew.formats import READABLE, WRITERS, ImportOptions, save_as, text_of
    from symscrew.scene import load_robot, scene_text
    from symscrew.whole_files import write_text

    path, source = Path(options.out), Path(options.mechanism)
    if path.suffix not in WRITERS:
        raise UsageError(f"--out: expected a name that ends in {', '.join(WRITERS)}, got {options.out!r}")
    if path.exists() and not options.replace:
        raise UsageError(f"--out: {path} exists and is left as it is; choose another name, or say --replace")
    for file, option in ((options.out, "--out"), (options.scene, "--scene")):
        if file:
            check_folder(Path(file).parent, option)
    foreign = source.suffix in READABLE and source.is_file()
    asked = (options.scene, options.snap, options.repair, options.accept, options.floating, options.exact)
    if not foreign and any(asked):
        raise UsageError("--scene, --snap, --repair, --accept, --floating and --exact belong to URDF and MJCF files")
    if not 0 <= options.snap < 1:
        raise UsageError(f"--snap: expected a gap from 0 to 1 [m, rad], got {options.snap}")
    if not foreign:
        mechanism = catalogue.find(options.mechanism)
        text = text_of(mechanism, path.suffix)
        if path.suffix == source.suffix == ".toml":
            text = with_comments(text, read_text(source))
        writable_folder(str(path.parent))
        write_text(path, text)
        print(path)
        return DONE
    chosen = ImportOptions(options.snap, options.repair, options.accept, options.floating, options.exact)
    robot = load_robot(source, chosen)
    writable_folder(str(path.parent))
    save_as(robot.mechanism, path)
    print(path)
    if options.scene:
        scene = Path(options.scene)
        writable_folder(str(scene.parent))
        write_text(scene, scene_text(robot, os.path.relpath(path, scene.parent)))
        print(scene)
    for line in robot.account.lines():
        print(line, file=sys.stderr)
    return DONE

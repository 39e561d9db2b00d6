"""`symscrew convert`: a description in another format."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import add_mechanism, check_folder, rods_that_spin, writable_folder

if TYPE_CHECKING:
    from symscrew.description import Mechanism
    from symscrew.effects import Effect
    from symscrew.formats import JointLimits

EXAMPLES = (
    "symscrew convert robot.urdf --out robot.toml",
    "symscrew convert robot.xml --out robot.toml --scene robot_scene.toml",
    "symscrew convert ur5 --out ur5.xml",
    "symscrew convert leg.toml --effects leg_scene.toml --out leg.xml",
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
    command.add_argument("--start", metavar="KEYFRAME", help="where the scene begins: a keyframe of an MJCF file")
    command.add_argument("--effects", metavar="FILE", help="a scene whose effects a .urdf or .xml is to have as well")
    command.add_argument("--bare", action="store_true", help="the mechanism alone, without the effects of its file")
    command.add_argument(
        "--snap", type=float, default=0.0, metavar="GAP", help="close loops that are open by up to GAP [m, rad]"
    )
    command.add_argument(
        "--loosen",
        action="store_true",
        help="what closes loops of a robot.yaml that close in no pose: 3d for 6d, balls",
    )
    command.add_argument("--repair", action="store_true", help="the nearest possible inertia for one no body can have")
    command.add_argument("--accept", action="store_true", help="leave out what numbers depend on and is not read")
    command.add_argument("--floating", action="store_true", help="the root link of a URDF moves freely in space")
    command.add_argument(
        "--folder", metavar="DIR", type=Path, help="below which files that an MJCF names may be; default: its own"
    )
    command.add_argument(
        "--exact", action="store_true", help="digits that mean an angle or a zero are that: 1.5708 is pi/2"
    )
    command.add_argument(
        "--bars", action="store_true", help="rods between two balls do not spin; their mass is on the line between"
    )


def run(options: argparse.Namespace) -> int:
    """Read, write; what became of all that the file says is on stderr."""
    from symscrew import catalogue
    from symscrew.description import read_text, with_comments
    from symscrew.effects import load_effects
    from symscrew.formats import READABLE, WRITERS, ImportOptions, text_of
    from symscrew.scene import load_robot, scene_text
    from symscrew.whole_files import write_text

    path, source = Path(options.out), Path(options.mechanism)
    if path.suffix not in WRITERS:
        raise UsageError(f"--out: expected a name that ends in {', '.join(WRITERS)}, got {options.out!r}")
    if options.scene and os.path.realpath(options.scene) == os.path.realpath(path):
        raise UsageError(f"--scene: expected another file than --out, got {options.scene!r} for both")
    for file, option in ((options.out, "--out"), (options.scene, "--scene")):
        if file and Path(file).exists() and not options.replace:
            raise UsageError(f"{option}: {file} exists and is left as it is; choose another name, or say --replace")
        if file:
            check_folder(Path(file).parent, option)
    foreign = source.suffix in READABLE and source.is_file()
    keys = ("scene", "snap", "repair", "floating", "exact", "bars", "loosen", "folder", "bare", "start")
    asked = [getattr(options, key) for key in keys]
    if not foreign and (any(asked) or (options.accept and not options.effects)):
        raise UsageError(
            "--scene, --snap, --loosen, --repair, --accept, --floating, --exact, --bars, --folder, --bare and --start "
            "belong to URDF and MJCF files"
        )
    if not 0 <= options.snap < 1:
        raise UsageError(f"--snap: expected a gap from 0 to 1 [m, rad], got {options.snap}")
    if not foreign:
        mechanism = catalogue.find(options.mechanism)
        effects = load_effects(options.effects) if options.effects else None
        writable_folder(str(path.parent))
        if path.suffix == source.suffix == ".toml":
            write_text(path, with_comments(text_of(mechanism, ".toml"), read_text(source)))
            print(path)
        else:
            _save(options, mechanism, effects, {})
        return DONE
    if options.start and not options.scene:
        raise UsageError("--start belongs to --scene: it says where the scene begins")
    if options.effects:
        raise UsageError("--effects belongs to descriptions; a URDF or MJCF file has its own")
    switches = (options.snap, options.repair, options.accept, options.floating, options.exact)
    chosen = ImportOptions(*switches, options.folder, options.bars, options.loosen)
    robot = load_robot(source, chosen)
    scene = Path(options.scene) if options.scene else None
    acts = scene_text(robot, os.path.relpath(path, scene.parent), options.start) if scene else ""
    writable_folder(str(path.parent))
    _save(options, robot.mechanism, None if options.bare else robot.effects, robot.limits)
    if scene:
        writable_folder(str(scene.parent))
        write_text(scene, acts)
        print(scene)
    for line in robot.account.lines():
        print(line, file=sys.stderr)
    if robot.account.rods:
        print(f"note: {rods_that_spin(robot.account.rods)}; --bars leaves that out", file=sys.stderr)
    return DONE


def _save(
    options: argparse.Namespace,
    mechanism: Mechanism,
    effects: Collection[Effect] | None,
    limits: Mapping[str, JointLimits],
) -> None:
    """Write the file, with effects in its own words where it can have any and there are any."""
    from symscrew.formats import save_as
    from symscrew.scene import save_robot

    path = Path(options.out)
    if effects is None or path.suffix == ".toml":
        left = save_as(mechanism, path)
    else:
        left = save_robot(mechanism, path, effects, limits=limits, accept=options.accept)
    for text in left:
        print(f"left out of {path.name}: {text}", file=sys.stderr)
    print(path)

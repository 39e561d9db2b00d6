"""`symscrew view`: a page with a mechanism in 3-D, or its motion as a film or a picture."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import (
    add_effects,
    add_independent,
    add_no_cache,
    check_folder,
    chosen_effects,
    need_matplotlib,
    writable_folder,
)
from symscrew.errors import shorten

if TYPE_CHECKING:
    from symscrew.description import Mechanism
    from symscrew.display import Limits, Pictures, Progress, RecordedMotion
    from symscrew.effects import Effect

EXAMPLES = (
    "symscrew view three_ups_upu_s",
    "symscrew view run.npz --out run.html --gif run.gif",
    "symscrew view delta --limit arm1_R=-20deg:45deg --out delta.html",
)
MOST_MISSING = 5  # meshes that could not be drawn and are named
FILES = {"out": ".html", "gif": ".gif", "mp4": ".mp4", "png": ".png"}  # option -> how its file's name ends


class Shown(NamedTuple):
    """What a page shows beside the mechanism; `modes`: a chooser of them."""

    motion: RecordedMotion | None
    limits: Limits
    pictures: Pictures
    modes: bool


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew view`."""
    command.add_argument("mechanism", metavar="NAME|FILE|RUN.npz", help="a mechanism, or a recorded motion to play")
    command.add_argument("--out", metavar="FILE.html", help="the page; without a file it is opened in the browser")
    command.add_argument("--gif", metavar="FILE.gif", help="the motion as a film, or a sweep of a mechanism")
    command.add_argument("--mp4", metavar="FILE.mp4", help="the same; needs ffmpeg")
    command.add_argument("--png", metavar="FILE.png", help="where the motion begins, as a picture")
    command.add_argument(
        "--limit", action="append", default=[], metavar="JOINT=LOW:HIGH",
        help="how far a joint may go, drawn and kept: limb1_P=-5cm:10cm, hip=-30deg:90deg; beside those of end stops "
        "and of URDF and MJCF files",
    )  # fmt: skip
    command.add_argument(
        "--frames",
        metavar="N|all",
        help="about how many states of a motion the page holds, all peaks among them; default: 4 MB",
    )
    command.add_argument("--modes", action="store_true", help="a chooser of all assembly modes at the reference")
    command.add_argument("--run-time", nargs="+", default=[], metavar="NAME", help="parameters that get a slider")
    command.add_argument(
        "--meshes",
        metavar="FILE",
        help="draw bodies as the meshes (STL, OBJ, MSH) of a URDF or MJCF file with their names",
    )
    command.add_argument(
        "--folder", metavar="DIR", type=Path, help="below which meshes and packages are; default: the file's own"
    )
    add_effects(command)
    add_independent(command)
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive, write or open, print the places."""
    from symscrew.display import Progress, open_made, write_made
    from symscrew.model import derive

    files = _files(options)
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism, motion = _mechanism(options)
        motion = _with_frames(motion, options.frames)
        effects = _acting(chosen_effects(options, mechanism), motion)
        limits = _limits(options, mechanism)
        pictures = _pictures(options, mechanism)
    if not files or "out" in files:
        shown = Shown(motion, limits, pictures, options.modes)
        page = _page(mechanism, effects, options.independent, shown=shown, progress=progress)
        if not files:
            print(open_made(page, mechanism.name))
            return DONE
        writable_folder(str(files["out"].parent))
        print(write_made(page, files["out"]))
    films = {name: path for name, path in files.items() if name != "out"}
    if films:
        from symscrew.display import write_film  # which needs matplotlib

        with progress.step(f"derive {mechanism.name}"):
            model = derive(mechanism, effects, independent=options.independent)
    for path in films.values():
        writable_folder(str(path.parent))
        with progress.step(f"draw {path}"):
            written = write_film(model, path, motion)
        print(written)
    return DONE


def _acting(chosen: Sequence[Effect], motion: RecordedMotion | None) -> Sequence[Effect]:
    """The chosen effects, or those of the motion's scene where it has the tree's coordinates under these alone."""
    from symscrew.effects import effects_of_text, system_under

    if motion is None or not motion.scene:
        return chosen

    def fits(effects: Sequence[Effect]) -> bool:
        tree = system_under(motion.mechanism, tuple(effects)).tree
        return motion.q_labels == tuple(coordinate.label for coordinate in tree.q)

    if fits(chosen):
        return chosen
    own = effects_of_text(motion.scene)
    return own if fits(own) else chosen


def _page(
    mechanism: Mechanism,
    effects: Sequence[Effect],
    independent: Sequence[str] | None,
    *,
    shown: Shown,
    progress: Progress,
) -> str:
    """The page as text: that of the user's cache, if it shows nothing beside the mechanism and was made before."""
    from symscrew.display import make_page, page_modes
    from symscrew.model import derive
    from symscrew.runtime import entry, model_key

    bare = shown.motion is None and not (shown.limits or shown.pictures or shown.modes)
    with entry(model_key(mechanism, effects, independent, of=b"page") if bare else None) as kept:
        found = kept.read()
        if found is not None:
            return found.decode("utf-8")
        with progress.step(f"derive {mechanism.name}"):
            model = derive(mechanism, effects, independent=independent)
        modes = page_modes(model) if shown.modes else None
        page = make_page(model, shown.motion, shown.limits, pictures=shown.pictures, modes=modes)
        kept.write(page.encode("utf-8"))
        return page


def _files(options: argparse.Namespace) -> dict[str, Path]:
    """Option -> the file that it names, after a look whether that can be written."""
    files = {name: Path(getattr(options, name)) for name in FILES if getattr(options, name)}
    for name, path in files.items():
        if path.suffix != FILES[name]:
            raise UsageError(f"--{name}: expected a file name that ends in {FILES[name]}, got {shorten(str(path))}")
        check_folder(path.parent, f"--{name}")
    if files.keys() - {"out"}:
        need_matplotlib("films and pictures need")
    return files


def _mechanism(options: argparse.Namespace):  # type: ignore[no-untyped-def]
    """The mechanism, with what is a run-time parameter, and its motion."""
    from symscrew import catalogue
    from symscrew.display import read_mechanism_and_motion

    if not options.run_time:
        return read_mechanism_and_motion(options.mechanism)
    if options.mechanism.endswith(".npz"):
        raise UsageError("--run-time: a recorded motion has its parameters; give a mechanism")
    return catalogue.find(options.mechanism, run_time=options.run_time), None


def _with_frames(motion: RecordedMotion | None, asked: str | None) -> RecordedMotion | None:
    """The motion with as many states for its page as are asked for."""
    if asked is None:
        return motion
    if motion is None:
        raise UsageError("--frames: a mechanism has no recorded states; give a motion, RUN.npz")
    if asked == "all":
        return replace(motion, frames=len(motion.t))
    if not asked.isdecimal() or int(asked) < 2:
        raise UsageError(f"--frames: expected at least 2, or all, got {shorten(asked)}")
    return replace(motion, frames=int(asked))


def _pictures(options: argparse.Namespace, mechanism: Mechanism) -> Pictures:
    """Triangles of bodies by name from the file of --meshes; what cannot be drawn is said."""
    from symscrew.formats import ImportOptions, mesh_pictures

    if options.meshes is None:
        if options.folder is not None:
            raise UsageError("--folder belongs to --meshes: it says where meshes are")
        return {}
    if not options.out and any(getattr(options, name) for name in FILES):
        raise UsageError("--meshes belongs to pages: films and other pictures have outlines")
    found = mesh_pictures(options.meshes, ImportOptions(accept=True, repair=True, loosen=True, folder=options.folder))
    of_bodies = {name: own for name, own in found.triangles.items() if name in {mechanism.ground, *mechanism.bodies}}
    for text in found.missing[:MOST_MISSING]:
        print(f"not drawn: {text}", file=sys.stderr)
    if len(found.missing) > MOST_MISSING:
        print(f"not drawn: {len(found.missing) - MOST_MISSING} meshes more", file=sys.stderr)
    if not of_bodies:
        bodies = ", ".join(list(mechanism.bodies)[:5])
        raise UsageError(f"--meshes: expected a file with meshes of {bodies} ..., found none in {options.meshes}")
    return of_bodies


def _limits(options: argparse.Namespace, mechanism: Mechanism) -> Limits:
    """Limits of joints by name: those of a robot's file, and those that are given."""
    from symscrew.description import given_value
    from symscrew.formats import READABLE, import_file

    found: dict[str, tuple[float | None, float | None]] = {}
    path = Path(options.mechanism)
    if path.suffix in READABLE and path.is_file():
        for name, limits in import_file(path).limits.items():
            if name in mechanism.joints and (limits.lower is not None or limits.upper is not None):
                found[name] = limits.lower, limits.upper
    for text in options.limit:
        name, equals, ends = text.partition("=")
        low, colon, high = ends.partition(":")
        if not equals or not colon or not (low.strip() or high.strip()):
            raise UsageError(f"--limit: expected JOINT=LOW:HIGH, either may be left out, got {shorten(text)}")
        joint = mechanism.joints.get(name.partition(".")[0])
        values: list[float | None] = []
        for end in (low, high):
            if not end.strip():
                values.append(None)
                continue
            unit = "m" if joint is not None and joint.kind.freedoms[0].prismatic else "rad"
            values.append(float(given_value(end, where=f"--limit {name}").measured_in(unit, f"--limit {name}")))
        found[name] = values[0], values[1]
    return found

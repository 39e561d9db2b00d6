"""Options that several commands share: the mechanism, what acts on it, independent coordinates, places to write to.

Each comes as a pair: `add_...` gives a command the options, and a function beside it reads them; all bad input ends
there, in a `UsageError` of one line.
"""

from __future__ import annotations

import argparse
import importlib
import os
import re
import sys
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import UsageError
from symscrew.errors import shorten

if TYPE_CHECKING:
    from symscrew.description import Mechanism
    from symscrew.effects import Effect
    from symscrew.formats import Imported


def add_mechanism(command: argparse.ArgumentParser) -> None:
    """The mechanism that a command is about; `catalogue.find` reads it."""
    text = "a name of `symscrew list`, or a .toml, .urdf or .xml (MJCF) file"
    command.add_argument("mechanism", metavar="NAME|FILE", help=text)


def add_described_mechanism(command: argparse.ArgumentParser) -> None:
    """As `add_mechanism`, in fewer words."""
    command.add_argument("mechanism", metavar="NAME|FILE", help="a name of `symscrew list`, or a description file")


def add_no_cache(command: argparse.ArgumentParser) -> None:
    """To go without the user's cache; `symscrew.cli.parser.main` reads it."""
    command.add_argument(
        "--no-cache", action="store_true", help="compile and derive anew, keep nothing (symscrew cache)"
    )


def find_mechanism(name: str, *, acting: bool = False) -> Mechanism:
    """As `catalogue.find`; on stderr what a robot's file has that the mechanism has otherwise or not.

    `acting`: the command is about forces, and those of the file are none of them.
    """
    from symscrew import catalogue

    def said(found: Imported) -> None:
        for text in found.account.changed:
            print(f"note: {text}", file=sys.stderr)
        if found.account.rods:
            print(
                f"note: {rods_that_spin(found.account.rods)}: symscrew new NAME --from {name} --bars leaves that out, "
                "and the code gets shorter",
                file=sys.stderr,
            )
        if acting and found.acting():
            print(
                f"note: beside the mechanism the file has {found.acting()}, which is left out here: symscrew convert "
                f"{name} --out NAME.toml --scene SCENE.toml writes both, and --effects SCENE.toml takes it",
                file=sys.stderr,
            )

    return catalogue.find(name, said=said)


def rods_that_spin(rods: Sequence[str]) -> str:
    """In words, which bodies of a file spin between two balls."""
    shown = [*rods[:MOST_RODS], *(["..."] if len(rods) > MOST_RODS else [])]
    return f"{len(rods)} rod{'s' * (len(rods) > 1)} between two balls, whose spin no drive holds ({', '.join(shown)})"


MOST_RODS = 6
"""Names of rods that a note shows: those of a hexapod."""
NEXT_SETTING = re.compile(r",\s*(?=[A-Za-z_][\w.]*\s*=)")
"""A comma before a further KEY=: "30deg about 1,1,0" has commas of its own."""


def add_independent(command: argparse.ArgumentParser) -> None:
    """Coordinates to take as independent, instead of those of the model's own choice."""
    command.add_argument("--independent", nargs="+", metavar="LABEL", help="coordinates of q to take as independent")


def add_gravity(command: argparse.ArgumentParser) -> None:
    """Gravity alone; `chosen_effects` reads it."""
    gravity = command.add_mutually_exclusive_group()
    gravity.add_argument("--no-gravity", action="store_true", help="no gravity (default: 9.81 m/s^2 along -z)")
    gravity.add_argument("--gravity", nargs=3, metavar=("GX", "GY", "GZ"), help="acceleration of free fall [m/s^2]")
    command.set_defaults(load=[], effects=None)


def add_effects(command: argparse.ArgumentParser) -> None:
    """Gravity, loads and effects of a file; `chosen_effects` reads them."""
    add_gravity(command)
    command.add_argument(
        "--load", action="append", default=[], metavar="POINT", help="force and moment at a named point as an input"
    )
    command.add_argument("--effects", metavar="FILE", help="the effects of a TOML file ([[effects]]), and no others")


def chosen_effects(options: argparse.Namespace, mechanism: Mechanism) -> list[Effect]:
    """The effects on a mechanism that the options of `add_effects` or `add_gravity` name."""
    from symscrew.effects import ExternalWrench, Gravity, load_effects
    from symscrew.errors import did_you_mean

    if options.effects:
        if options.load or options.gravity or options.no_gravity:
            raise UsageError("--effects: the file says all that acts; leave --gravity, --no-gravity and --load out")
        return list(load_effects(options.effects))
    effects: list[Effect] = []
    if not options.no_gravity:
        gravity = Gravity(tuple(options.gravity)) if options.gravity else Gravity()
        try:
            _ = gravity.exact
        except ValueError as error:
            raise UsageError(str(error)) from error
        effects.append(gravity)
    for point in dict.fromkeys(options.load):
        if point not in mechanism.points:
            raise UsageError(f"--load: no point {point!r} in {mechanism.name}; {did_you_mean(point, mechanism.points)}")
        effects.append(ExternalWrench(point))
    return effects


def writable_folder(directory: str) -> Path:
    """The directory, made if it is not there, in which a file can be created."""
    path = Path(directory)
    if "\0" in directory:
        raise UsageError("--out: a path must not contain a null character")
    path.mkdir(parents=True, exist_ok=True)
    if not os.access(path, os.W_OK | os.X_OK):
        raise UsageError(f"{directory}: no permission to write here")
    return path


def check_folder(directory: str | Path, option: str = "--out") -> None:
    """Before anything is derived: whether a folder can be written into, or can be made where it is not there yet."""
    path = Path(directory)
    if "\0" in str(directory):
        raise UsageError(f"{option}: a path must not contain a null character")
    there = next((p for p in (path, *path.absolute().parents) if os.path.lexists(p)), Path("/"))
    if there.is_symlink() and not there.exists():
        raise UsageError(f"{option}: a link that leads nowhere: {shorten(str(there), 200)}; remove it")
    if not there.is_dir():
        raise UsageError(f"{option}: expected a folder, found a file: {shorten(str(there), 200)}")
    if not os.access(there, os.W_OK | os.X_OK):
        raise UsageError(f"{option}: no permission to write into {shorten(str(there), 200)}")
    if there != path:
        try:  # some systems of files take nothing, whatever the permissions are
            os.rmdir(tempfile.mkdtemp(dir=there))
        except OSError as error:
            said = f"nothing can be made in {shorten(str(there), 200)} ({error.strerror}); use another place"
            raise UsageError(f"{option}: {said}") from error


def keep_inputs(written: Iterable[Path], read: Iterable[str], option: str = "--out") -> None:
    """Before the work: raises UsageError where a file that is read would be written over."""
    for name in read:
        for path in written:
            # of expressions, which may be longer than names of files, no error
            if os.path.isfile(name) and path.is_file() and path.samefile(name):
                raise UsageError(
                    f"{option}: {shorten(str(path), 200)} is what is read, and is left as it is; write somewhere else"
                )


def need_matplotlib(what: str = "figures need") -> None:
    """Say how to get matplotlib, where it is not installed, or is and cannot be imported."""
    if missing := no_matplotlib():
        raise UsageError(f"{what} matplotlib, which {missing}")


def no_matplotlib() -> str:
    """Why nothing can be drawn, and the cure: matplotlib is not installed, or was built for other packages; else empty.

    It is imported as the drawings do: whether it is there says nothing of what it links to.
    """
    try:
        importlib.import_module("matplotlib.figure")
    except ModuleNotFoundError as error:
        if error.name == "matplotlib":
            return 'is not installed: pip install "symscrew[plot]"'
        return f"cannot be imported ({shorten(str(error))}): pip install --force-reinstall matplotlib"
    except ImportError as error:
        return f"cannot be imported ({shorten(str(error))}): pip install --force-reinstall matplotlib"
    return ""


def check_expected(options: argparse.Namespace) -> None:
    """Raises UsageError where `--expect` says a number that nothing is."""
    if options.expect is not None and options.expect < 0:
        raise UsageError(f"--expect: expected a number from 0 on, got {options.expect}")


def settings(option: str, texts: Sequence[str]) -> dict[str, str]:
    """KEY -> VALUE of arguments KEY=VALUE, one or several in each, between commas.

    Raises:
        UsageError: no such pair, or a key that is given twice.
    """
    found: dict[str, str] = {}
    for text in texts:
        for item in NEXT_SETTING.split(text):
            name, mark, value = (part.strip() for part in item.partition("="))
            if not mark or not name or not value:
                raise UsageError(f"--{option}: expected KEY=VALUE, got {shorten(item)}")
            if name in found:
                raise UsageError(f"--{option}: {shorten(name)} is given twice")
            found[name] = value
    return found

"""The mechanisms that come with the package, each a TOML file beside this module."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

from symscrew import formats
from symscrew.description import Mechanism, load_description
from symscrew.errors import DescriptionError, did_you_mean, expect, shorten

_FOLDER = Path(__file__).parent


def names() -> tuple[str, ...]:
    """Names of the catalogue's mechanisms, sorted."""
    return tuple(sorted(file.stem for file in _FOLDER.glob("*.toml")))


def load(name: str) -> Mechanism:
    """The catalogue's mechanism `name`; raises DescriptionError with the nearest names.

    >>> load("four_bar").ground
    'base'
    """
    expect(name, str)
    if name not in names():
        raise DescriptionError(f"the catalogue has no mechanism {shorten(name)}; {did_you_mean(name, names())}")
    return _own(name)


@cache
def _own(name: str) -> Mechanism:
    """Read once in a process: exact numbers take tenths of a second, and nobody changes a mechanism."""
    return load_description(_FOLDER / f"{name}.toml")


def text(name: str) -> str:
    """The catalogue's description `name` as it was written, with its comments; raises DescriptionError."""
    if name not in names():
        raise DescriptionError(f"the catalogue has no mechanism {shorten(name)}; {did_you_mean(name, names())}")
    return (_FOLDER / f"{name}.toml").read_text(encoding="utf-8")


def find(
    name_or_path: str | Path,
    *,
    run_time: Sequence[str] = (),
    said: Callable[[formats.Imported], None] = lambda _: None,
) -> Mechanism:
    """A mechanism by its name in the catalogue or by the path of a .toml, .urdf, .xml or .mjcf file.

    `run_time`: parameters that become run-time inputs, whatever the description says. `said` is told what a robot's
    file has beside its mechanism.

    Raises:
        DescriptionError: neither, or the file does not describe a mechanism.
    """
    asked = str(name_or_path)
    if asked in names():
        return load_description(_FOLDER / f"{asked}.toml", run_time=run_time) if run_time else _own(asked)
    path, there = Path(asked), os.path.isfile(asked)  # not so, without an error, where a path is too long or holds NUL
    if "\0" not in asked and (path.suffix == ".toml" or path.suffix in formats.READABLE or there):
        if not there:
            raise DescriptionError(f"there is no file {shorten(asked, 200)}; expected a description of a mechanism")
        if path.suffix != ".toml" and path.suffix in formats.READABLE:
            if run_time:
                raise DescriptionError(f"{shorten(asked, 200)} has no parameters; convert it to .toml and add them")
            found = formats.import_file(path)
            said(found)
            return found.mechanism
        return load_description(path, run_time=run_time)
    raise DescriptionError(
        f"{shorten(asked)} is neither a mechanism of the catalogue nor a .toml, .urdf, .xml or .mjcf file; "
        f"{did_you_mean(asked, names())}"
    )

"""Places beside a file or folder, in which it is made before it is moved to its name in one step.

    .NAME.making-0123456789ab/    made and held by a process; gone when it is done

A process that is killed leaves its place. The lock on it is gone with the process, by which the next one that makes
the same thing knows, and removes it. Nothing is removed where locks are not to be had.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

from symscrew.whole_files.turns import hold, still

LONGEST = 40  # letters of the name in that of its place: with four bytes each, names of 255 bytes are not exceeded
_PLACE = re.compile(r"\..+\.making-[0-9a-f]{12}", re.ASCII | re.DOTALL)


def is_staging(name: str) -> bool:
    """Whether this is the name of such a place."""
    return _PLACE.fullmatch(name) is not None


@contextlib.contextmanager
def stage(target: Path) -> Iterator[Path]:
    """An empty folder beside `target`, on the same disk, held by this process and removed at the end.

    Raises:
        OSError: a place where nothing can be made.
    """
    remove_abandoned(target)
    place, held = _made(target)
    try:
        yield place
    finally:
        shutil.rmtree(place, ignore_errors=True)
        if held is not None:
            os.close(held)


def discard(folder: Path) -> None:
    """Remove a folder: it is gone in one step, and what a killed process leaves is removed by the next one."""
    with stage(folder) as place:
        os.replace(folder, place / "old")


def remove_abandoned(target: Path) -> None:
    """Remove what killed processes left beside `target`."""
    begin = _begin(target)
    try:
        left = [name for name in os.listdir(target.parent) if name.startswith(begin) and is_staging(name)]
    except OSError:
        return
    for name in left:
        with contextlib.suppress(FileNotFoundError):  # gone by itself
            held = hold(target.parent / name)  # not of links, and not while its process lives
            if held is not None:
                shutil.rmtree(target.parent / name, ignore_errors=True)
                os.close(held)


def _begin(target: Path) -> str:
    return f".{target.name[:LONGEST]}.making-"


def _made(target: Path) -> tuple[Path, int | None]:
    """A new place and the lock on it; another process may have found it between the two and removed it."""
    while True:
        place = target.parent / f"{_begin(target)}{os.urandom(6).hex()}"
        place.mkdir(mode=0o700)
        try:
            held = hold(place, wait=True)
        except FileNotFoundError:
            continue
        if held is None or still(place, held):
            return place, held
        os.close(held)

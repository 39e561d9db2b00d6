"""A file that is there whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Callable, Iterator
from pathlib import Path

from symscrew.errors import DescriptionError
from symscrew.whole_files.staging import stage


def destination(name: str, suffixes: tuple[str, ...], what: str) -> Path:
    """Where the option `what` says that a file goes.

    Raises:
        DescriptionError: an ending that is not one of `suffixes`, a folder that does not exist or
            cannot be written into, or a folder of this name: what would be lost after the work is said before it.
    """
    path = Path(name)
    if "\0" in name or path.suffix not in suffixes:
        raise DescriptionError(f"{what}: expected a file name that ends in {' or '.join(suffixes)}, got {name!r}")
    if not path.parent.is_dir():
        raise DescriptionError(f"{what}: there is no folder {path.parent}; make it first")
    if path.is_dir():
        raise DescriptionError(f"{what}: expected a file, found a folder: {name!r}")
    if not os.access(path.parent, os.W_OK | os.X_OK):
        raise DescriptionError(f"{what}: no permission to write into {str(path.parent)!r}")
    return path


def replaced(path: Path, make: Callable[[Path], object]) -> Path:
    """Make a file beside its place and move it there: what was there before stays if `make` fails.

    Raises:
        OSError: a place that cannot be written, or a folder, a device or a pipe of this name: a file in their place
            would end them.
    """
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    if path.exists() and not path.is_file():
        raise OSError(errno.EINVAL, "expected a file, found a device or a pipe", str(path))
    with of_file(path), stage(path) as place:
        make(place / path.name)
        os.replace(place / path.name, path)
    return path


@contextlib.contextmanager
def of_file(path: Path) -> Iterator[None]:
    """Errors name the file that was asked for, and no place beside it that nobody knows."""
    try:
        yield
    except OSError as error:
        if error.errno is None or (error.filename and ".making-" not in str(error.filename)):
            raise
        raise OSError(error.errno, error.strerror, str(path)) from error


def created(path: Path, text: str) -> Path:
    """Write a text in UTF-8 to a file that is not there yet, whole or not at all.

    Raises:
        FileExistsError: it is there.
        OSError: a place that cannot be written.
    """
    with of_file(path), stage(path) as place:
        part = place / path.name
        part.write_text(text, encoding="utf-8")
        try:
            os.link(part, path)  # which fails if there is one, unlike a move
        except FileExistsError:
            raise
        except OSError:  # a disk without links
            os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666))
            os.replace(part, path)
    return path


def write_text(path: Path, text: str) -> Path:
    """Write a text in UTF-8 to a file, whole or not at all; raises OSError like `replaced`."""
    return replaced(path, lambda part: part.write_text(text, encoding="utf-8"))

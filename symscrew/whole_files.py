"""Files that are there whole or not at all."""

from __future__ import annotations

import errno
import os
import secrets
from collections.abc import Callable
from pathlib import Path

from symscrew.errors import DescriptionError


def destination(name: str, suffixes: tuple[str, ...], what: str) -> Path:
    """Where the option `what` says that a file goes.

    Raises:
        DescriptionError: an ending that is not one of `suffixes`, or a folder that does not exist.
    """
    path = Path(name)
    if "\0" in name or path.suffix not in suffixes:
        raise DescriptionError(f"{what}: expected a file name that ends in {' or '.join(suffixes)}, got {name!r}")
    if not path.parent.is_dir():
        raise DescriptionError(f"{what}: there is no folder {path.parent}; make it first")
    return path


def replaced(path: Path, make: Callable[[Path], object]) -> Path:
    """Make a file beside its place and move it there: what was there before stays if `make` fails.

    Raises:
        OSError: a place that cannot be written, or a folder of this name.
    """
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    temporary = path.with_name(f".{path.stem}.{secrets.token_hex(6)}{path.suffix}")
    try:
        make(temporary)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
    return path


def write_text(path: Path, text: str) -> Path:
    """Write a text in UTF-8 to a file, whole or not at all; raises OSError like `replaced`."""
    return replaced(path, lambda part: part.write_text(text, encoding="utf-8"))

"""One process at a time on a folder: a lock that the system gives back when its process ends, however it ends."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

try:
    import fcntl
except ImportError:  # not on Windows: then two processes may work at the same time
    fcntl = None  # type: ignore[assignment]

# Seconds to wait for another process that writes in the same folder: writing takes less than one, the longest C file
# of the catalogue included; whoever holds a folder for longer does something else with it.
PATIENCE = 60.0
PAUSE = 0.05  # seconds between two looks


class LockedError(OSError):
    """Another process holds a folder for longer than anybody waits."""


def hold(folder: Path, *, wait: bool = False) -> int | None:
    """A lock on a folder, as an open file; None where it cannot be locked, or is held by another (unless `wait`).

    Raises:
        FileNotFoundError: there is no such folder.
    """
    if fcntl is None:
        return None
    try:
        file = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except FileNotFoundError:
        raise
    except OSError:
        return None
    try:
        fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
    except OSError:
        os.close(file)
        return None
    return file


@contextlib.contextmanager
def one_at_a_time(folder: Path, *, patience: float | None = PATIENCE, notice: str = "") -> Iterator[Callable[[], bool]]:
    """Hold a folder that is there; who comes later waits. Where folders cannot be locked, nobody waits.

    Gives a function that says whether the folder is still the one of its name: whoever held it may have moved it.

    Args:
        folder: what is held; it stays the same folder as long as anybody holds it.
        patience: seconds to wait; None: as long as it takes.
        notice: is told on stderr by who has to wait.

    Raises:
        LockedError: another process held it for longer than `patience`.
    """
    file, start = _opened(folder), time.monotonic()
    try:
        while file is not None and fcntl is not None:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError as error:
                if patience is not None and time.monotonic() - start > patience:
                    text = f"{folder}: another process has been writing here for {patience:.0f} s; end it, or wait"
                    raise LockedError(error.errno, text) from error
            except OSError:  # a file system without locks
                break
            if notice:
                print(notice, file=sys.stderr)
                notice = ""
            time.sleep(PAUSE)
        yield lambda: still(folder, file) if file is not None else folder.is_dir()
    finally:
        if file is not None:
            os.close(file)


def still(folder: Path, held: int) -> bool:
    """Whether a folder that was opened is the one that has its name now."""
    try:
        return os.path.samestat(os.stat(folder, follow_symlinks=False), os.fstat(held))
    except OSError:
        return False


def _opened(folder: Path) -> int | None:
    """The folder for locking, or None where that is not possible."""
    if fcntl is None:
        return None
    try:
        return os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    except OSError:
        return None

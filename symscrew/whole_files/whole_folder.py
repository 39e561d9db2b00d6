"""Files of a folder that are replaced together: whoever reads finds all of the old ones or all of the new ones.

    nothing there            files made beside --one rename--> the folder
    nothing else in it       files made beside --one exchange of both folders--> the folder
    a user's files in it,    files made inside --one rename--> PENDING --one by one--> their names, `last` at the end
    or it cannot be moved

A folder that holds a user's files too stays where it is, as one does that is a mount point, the current folder, or on a
system that cannot exchange folders. There, from the one rename on the new files count: who reads calls `finish` first,
which moves what a killed process has left to move.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import os
import shutil
import sys
from collections.abc import Callable, Collection, Mapping
from pathlib import Path

from symscrew.whole_files.one_file import of_file
from symscrew.whole_files.staging import remove_abandoned, stage
from symscrew.whole_files.turns import one_at_a_time

PENDING = ".pending"  # folder of files that count, and are still to be moved out of it
EXCHANGE = 2  # RENAME_EXCHANGE of <linux/fs.h> and RENAME_SWAP of <sys/stdio.h>: both names change places
HERE = -100  # AT_FDCWD of <fcntl.h>: names are relative to the current folder
UNABLE = (errno.ENOSYS, errno.EINVAL, errno.ENOTSUP, errno.EBUSY, errno.EXDEV, errno.EPERM, errno.EACCES, errno.EROFS)
Owned = Callable[[Path], Collection[str]]


def put_files(
    directory: Path, files: Mapping[str, bytes], *, last: str, owned: Owned, check: Callable[[], object] = lambda: None
) -> None:
    """Replace the files of a folder that are ours; it is made if it is not there. One process at a time.

    Args:
        directory: an absolute path.
        files: name to content of all that is ours from now on.
        last: the one of `files` that says which are ours.
        owned: of a folder, the names of files in it that are ours, as its `last` says; empty where it says nothing.
        check: raises an error of its own unless the folder, as it is in this moment, may be written.

    Raises:
        OSError: a place that cannot be written; the old files are there, then.
    """
    place = Path(os.path.realpath(directory))
    place.parent.mkdir(parents=True, exist_ok=True)
    with one_at_a_time(place.parent):
        finish(place, last=last, owned=owned)
        check()
        remove_abandoned(place)
        inside = place / PENDING
        if not place.exists() or _moves(place, owned(place)):
            with stage(place) as beside:
                made = _written(beside / place.name, files)
                if not place.exists():
                    os.rename(made, place)
                    return
                shutil.copymode(place, made)
                if _exchanged(made, place):
                    for name in set(os.listdir(made)) - set(owned(made)):  # somebody's, of this moment
                        os.rename(made / name, place / name)
                    return
        with stage(inside) as within:
            os.rename(_written(within / PENDING, files), inside)
        finish(place, last=last, owned=owned)


def made_together(directory: Path, make: Callable[[Path], object]) -> list[Path]:
    """Put what `make` makes in the folder that it is given into `directory`, when all of it is made; in order of names.

    A new folder is there in one step. Into one that is there the files are moved one after the other, at the end.

    Raises:
        OSError: a place that cannot be written.
    """
    place = Path(os.path.realpath(directory))
    place.parent.mkdir(parents=True, exist_ok=True)
    remove_abandoned(place)
    with of_file(directory), stage(place / "files" if place.is_dir() else place) as staged:
        made = staged / "made"
        made.mkdir()
        make(made)
        names = sorted(os.listdir(made))
        if not place.is_dir():
            os.rename(made, place)
        else:
            for name in names:
                os.replace(made / name, place / name)
    return [directory / name for name in names]


def finish(directory: Path, *, last: str, owned: Owned) -> None:
    """Move what a killed process left to be moved; nothing where there is nothing.

    Raises:
        OSError: it cannot be moved (no permission).
    """
    if (directory / PENDING).is_dir() and not (directory / PENDING).is_symlink():
        with one_at_a_time(directory):
            _move(directory, last=last, owned=owned)


def _written(folder: Path, files: Mapping[str, bytes]) -> Path:
    folder.mkdir()
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder


def _moves(place: Path, known: Collection[str]) -> bool:
    """Whether a folder can be exchanged as a whole, without anybody noticing but by its files."""
    if set(os.listdir(place)) - set(known) or os.path.ismount(place) or not os.access(place.parent, os.W_OK | os.X_OK):
        return False
    with contextlib.suppress(OSError):
        current = Path(os.path.realpath(os.getcwd()))
        return place != current and place not in current.parents
    return True


def _exchanged(one: Path, other: Path) -> bool:
    """Two folders have changed places, in one step; False where the system or the disk cannot do that."""
    library = ctypes.CDLL(None, use_errno=True) if os.name == "posix" else None
    names = (os.fsencode(one), os.fsencode(other))
    if sys.platform == "linux" and hasattr(library, "renameat2"):
        outcome = library.renameat2(HERE, names[0], HERE, names[1], EXCHANGE)  # type: ignore[union-attr]
    elif sys.platform == "darwin" and hasattr(library, "renamex_np"):
        outcome = library.renamex_np(*names, EXCHANGE)  # type: ignore[union-attr]
    else:
        return False
    if outcome == 0:
        return True
    code = ctypes.get_errno()
    if code not in UNABLE:
        raise OSError(code, os.strerror(code), str(other))
    return False


def _move(place: Path, *, last: str, owned: Owned) -> None:
    """Move the files of PENDING to their names, and remove those of ours that are no more; `last` at the end."""
    pending = place / PENDING
    if not pending.is_dir():
        return  # another process was faster
    left = sorted(os.listdir(pending), key=lambda name: (name == last, name))
    if last in left:
        for name in sorted(set(owned(place)) - set(owned(pending)) - {last}):
            (place / name).unlink(missing_ok=True)
    for name in left:
        os.replace(pending / name, place / name)
    pending.rmdir()

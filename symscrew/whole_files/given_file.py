"""Files that somebody names: read to their end, which pipes and devices need not have."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path


def only_file(path: Path) -> Path:
    """The path of a file, whatever links lead to it.

    Raises:
        OSError: nothing there, a folder, a pipe, a device: who reads from these may wait, or read, for ever.
    """
    kind = path.stat().st_mode
    if stat.S_ISDIR(kind):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    if not stat.S_ISREG(kind):
        raise OSError(errno.EINVAL, "expected a file, found a pipe or a device", str(path))
    return path

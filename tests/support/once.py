"""What is made once in a run of the tests, in all its processes: compiled libraries and generated folders.

Keyed by all that they are made from, so that what a test gets is what it would have made itself. Nothing outlasts the
run. (Models are made once in a process: `model_states.model` and its like.)
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any, ClassVar


class Libraries:
    """Stands for `subprocess` where C is compiled: the same sources with the same command are compiled once.

    `folder` is common to all processes of a run; who comes second waits for the first one. `levels` replaces levels of
    optimisation in the command, such as -O2 by -O0, which compiles in a quarter of the time.
    """

    levels: ClassVar[dict[str, str]] = {}

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(exist_ok=True)

    def run(self, command: Sequence[str], **options: Any) -> subprocess.CompletedProcess[str]:
        command = [self.levels.get(word, word) for word in command]
        library, kept = Path(command[command.index("-o") + 1]), self.folder / fingerprint(command)
        with Lock(kept.with_suffix(".lock")):
            if kept.is_file():
                shutil.copyfile(kept, library)
                return subprocess.CompletedProcess(command, 0, "", "")
            result: subprocess.CompletedProcess[str] = subprocess.run(command, **options)
            if result.returncode == 0:
                partial = kept.with_name(f"{kept.name}.{os.getpid()}")
                shutil.copyfile(library, partial)
                partial.replace(kept)
            return result


class Lock:
    """A file that one process at a time holds."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __enter__(self) -> None:
        self.file = self.path.open("w")
        if fcntl is not None:
            fcntl.flock(self.file, fcntl.LOCK_EX)

    def __exit__(self, *_: object) -> None:
        self.file.close()


try:
    import fcntl
except ImportError:  # not on Windows: then two processes may make the same thing at the same time
    fcntl = None  # type: ignore[assignment]


def fingerprint(command: Sequence[str]) -> str:
    """Of the command without the places of its files, and of the files that it may read beside its sources."""
    found = hashlib.sha256()
    for word in command:
        path = Path(word)
        found.update((path.name if path.is_absolute() and word != command[0] else word).encode() + b"\0")
        if path.suffix in (".c", ".cpp"):
            for beside in sorted(p for p in path.parent.iterdir() if p.suffix in (".c", ".h", ".hpp")):
                found.update(beside.name.encode() + b"\0" + beside.read_bytes())
    return found.hexdigest()

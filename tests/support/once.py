"""What is made once in a run of the tests, in all its processes: compiled libraries and generated folders.

Compiled libraries are in the package's own cache, in a folder of the run. (Models are made once in a process:
`model_states.model` and its like.)
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, ClassVar

import pytest

from symscrew.runtime import compilers

NATIVE = "-march=native"
Attempts = Callable[..., tuple[tuple[str, ...], ...]]


class Levels:
    """Levels of optimisation in the place of those that users get: -O0 compiles in a quarter of the time of -O2.

    Code for this processor is what a test compares that asks for it: none gets other code because that was refused.
    """

    instead: ClassVar[dict[str, str]] = {}

    def __init__(self, attempts: Attempts) -> None:
        """Of the options that a compiler is called with."""
        self.attempts = attempts

    def __call__(self, flags: Sequence[str], *, native: bool) -> tuple[tuple[str, ...], ...]:
        tried = [words for words in self.attempts(flags, native=native) if NATIVE in words or not native]
        return tuple(tuple(self.instead.get(word, word) for word in words) for words in tried)


def changes_package(item: pytest.Item | None) -> bool:
    """Whether a test has changed something by `monkeypatch`, but for the folder that it works in."""
    made = getattr(item, "funcargs", {}).get("monkeypatch")
    return made is not None and bool(made._setattr or made._setitem)


class TinyCompiler:
    """tcc, if it is there, in the place of the compiler of runs whose loops would be compiled at -O0.

    It takes a fiftieth of gcc's time for the same text: a run's file is plain scalar C. What it refuses (the loops in
    extended precision) the system's compiler gets. Not while a test changes the package, or the compilers.
    """

    RUN = "run.c"

    def __init__(self, compiled: Callable[..., None]) -> None:
        """In place of the function that calls a compiler."""
        self.compiled, self.item = compiled, None

    def begin(self, item: pytest.Item) -> None:
        self.item: pytest.Item | None = item

    def __call__(self, source: Path, library: Path, command: str, tried: Sequence[Sequence[str]]) -> None:
        levels = [word for word in tried[0] if word.startswith("-O")]
        quick = Levels.instead and levels[-1] == "-O0" and source.name == self.RUN and not changes_package(self.item)
        tiny = shutil.which("tcc") if quick else None
        if tiny is None or not self.made(tiny, source, library):
            self.compiled(source, library, command, tried)

    def made(self, tiny: str, source: Path, library: Path) -> bool:
        call = [tiny, "-std=c99", "-w", "-shared", str(source), "-o", str(library), "-lm"]
        done = subprocess.run(call, capture_output=True, check=False)
        return done.returncode == 0 and compilers.loadable(library.read_bytes())


tiny_compiler: Any = TinyCompiler(compilers._compile)


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

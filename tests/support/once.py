"""What is made once in a run of the tests, in all its processes: compiled libraries and generated folders.

Compiled libraries are in the package's own cache, in a folder of the run. (Models are made once in a process:
`model_states.model` and its like.)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import ClassVar

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

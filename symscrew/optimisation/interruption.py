"""Ctrl-C while a solver runs: solvers take it for a wish to stop and hand out what they have; here it ends the program.

with interruptible(): solver(...)  -->  KeyboardInterrupt after the solver's next iteration
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


@contextmanager
def interruptible() -> Iterator[None]:
    """Raise KeyboardInterrupt where an interruption came that the calls inside swallowed.

    Only the main thread may handle signals; in others nothing changes, and where somebody handles SIGINT their own
    way (or ignores it) neither.
    """
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or before is not signal.default_int_handler:
        yield
        return
    came: list[int] = []

    def note(number: int, frame: FrameType | None) -> None:
        came.append(number)
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if came:
        raise KeyboardInterrupt

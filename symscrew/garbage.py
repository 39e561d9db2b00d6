"""Times at which nobody searches for unused objects: of what is derived or printed nothing is a cycle to drop."""

from __future__ import annotations

import atexit
import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def nothing_to_collect() -> Iterator[None]:
    """No search for unused cycles: nodes belong to their tape, and what is printed is text.

    Searching takes a fifth of the time of deriving, and a fifth of that of printing. What was made meanwhile counts as
    old afterwards: the first search of the young would go through all of it, for a twentieth of that time again.
    """
    searching = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if searching:
            if not gc.get_freeze_count():  # else somebody keeps objects out of every search, and they stay there
                gc.freeze()
                gc.unfreeze()  # into the oldest generation
            gc.enable()


def none_at_the_end() -> None:
    """When this process ends nobody searches once more: its memory goes back as a whole.

    Searching all that was derived takes a fifth of a second then, for a simple mechanism too: more than reading it.
    """
    atexit.unregister(gc.freeze)  # once is enough, however often somebody asks
    atexit.register(gc.freeze)

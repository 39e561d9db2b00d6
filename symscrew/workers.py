"""Processes that work for this one, and end with it however it ends."""

from __future__ import annotations

import multiprocessing
import os
import threading
from concurrent.futures import ProcessPoolExecutor


def pool(count: int, method: str) -> ProcessPoolExecutor:
    """A pool of so many processes, started by "fork" or "spawn", none of which outlives this one."""
    return ProcessPoolExecutor(count, multiprocessing.get_context(method), initializer=_end_with_parent)


def _end_with_parent() -> None:
    """Watch the parent from a thread of its own: a process that is killed cannot tell its workers to end."""
    parent = multiprocessing.parent_process()
    if parent is None:  # run in the process itself
        return

    def watch() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=watch, name="symscrew parent", daemon=True).start()

"""Processes that work for this one, and end with it however it ends."""

from __future__ import annotations

import os
import pickle
import signal
import threading
import warnings
from array import array
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, BinaryIO, TypeVar

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

Result = TypeVar("Result")
Item = TypeVar("Item")


def pool(count: int, method: str) -> ProcessPoolExecutor:
    """A pool of so many processes, started by "fork" or "spawn", none of which outlives this one."""
    import multiprocessing  # as long to import as a fifth of this package, for nothing where no pool is asked for
    from concurrent.futures import ProcessPoolExecutor

    return ProcessPoolExecutor(count, multiprocessing.get_context(method), initializer=_end_with_parent)


def _end_with_parent() -> None:
    """Watch the parent from a thread of its own: a process that is killed cannot tell its workers to end."""
    import multiprocessing

    parent = multiprocessing.parent_process()
    if parent is None:  # run in the process itself
        return

    def watch() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=watch, name="symscrew parent", daemon=True).start()


@contextmanager
def beside(work: Callable[[], Result]) -> Iterator[Callable[[], Result]]:
    """Have something done by a copy of this process, while this one does something else.

    What is given waits for the result, which must be something that `pickle` takes. Where processes have no copies,
    or this one's did not get to its end, the work is done here when it is asked for.
    """
    found = _copied(work)
    if found is None:
        yield work
        return
    process, source = found
    ended = False

    def result() -> Result:
        nonlocal ended
        data = source.read()
        ended, status = True, os.waitpid(process, 0)[1]
        made: Result = pickle.loads(data) if status == 0 else work()  # the bytes are our own
        return made

    try:
        with source:
            yield result
    finally:
        if not ended:
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)


@contextmanager
def taken_once(items: Sequence[Item]) -> Iterator[Iterator[Item]]:
    """Items that this process and copies made meanwhile take one after the other: whoever is free has the next one.

    Each item comes to one process only; what a process took that did not get to its end comes to no other.
    """
    reading, writing = os.pipe()  # of the places that are left: what one process has read from it, no other does
    with open(reading, "rb", buffering=0) as left:
        with open(writing, "wb", buffering=0) as target:
            target.write(array("H", range(len(items))).tobytes())
        yield (items[array("H", place)[0]] for place in iter(lambda: left.read(array("H").itemsize), b""))


def _copied(work: Callable[[], object]) -> tuple[int, BinaryIO] | None:
    """A copy of this process that does some work and ends, and where its result is to be read; None without copies."""
    if not hasattr(os, "fork"):
        return None
    reading, writing = os.pipe()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # of threads: those of NumPy's BLAS, which expects it
            process = os.fork()
    except OSError:  # no room for a further process
        os.close(reading)
        os.close(writing)
        return None
    if process == 0:
        _send(work, writing)
    os.close(writing)
    return process, open(reading, "rb")


def _send(work: Callable[[], object], place: int) -> None:
    """Do the work, write its result and end, without anything else that a process does at its end."""
    status = 1
    try:
        with open(place, "wb") as target:
            target.write(pickle.dumps(work(), protocol=pickle.HIGHEST_PROTOCOL))
        status = 0
    finally:
        os._exit(status)

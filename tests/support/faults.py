"""What goes wrong around a program: it is killed at any step on the disk, the disk is full, somebody else is there.

Each runs something in a process of its own, which shares the memory of this one until it writes.
"""

from __future__ import annotations

import os
import resource
import signal
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

# Events of the interpreter (PEP 578) after which the disk is another: what stands between two of them is one state.
STEPS = frozenset(
    ("open", "os.rename", "os.remove", "os.rmdir", "os.mkdir", "os.link", "shutil.rmtree", "ctypes.dlsym")
)


def in_a_process(work: Callable[[], object], *, prepare: Callable[[], object] = lambda: None) -> int:
    """The exit status of a process that did this: 0 well, 1 an error, below 0 a signal."""
    child = os.fork()
    if child == 0:
        outcome = 1
        try:
            prepare()
            work()
            outcome = 0
        except Exception:
            traceback.print_exc()
        finally:
            os._exit(outcome)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def killed_at(work: Callable[[], object], step: int) -> bool:
    """Do this in a process that is killed before its step of this number on the disk; False: it has fewer."""
    left = [step]

    def watch(event: str, arguments: tuple[Any, ...]) -> None:
        if event in STEPS and not (event == "open" and not _writes(arguments)):
            left[0] -= 1
            if left[0] < 0:
                os.kill(os.getpid(), signal.SIGKILL)

    outcome = in_a_process(work, prepare=lambda: sys.addaudithook(watch))
    assert outcome in (0, -signal.SIGKILL), f"step {step}: {outcome}"
    return outcome != 0


def _writes(arguments: tuple[Any, ...]) -> bool:
    _, mode, flags = arguments
    return bool(set(mode or "") & set("wax+")) or bool((flags or 0) & (os.O_WRONLY | os.O_RDWR))


def with_files_up_to(size: int, work: Callable[[], object]) -> int:
    """Do this in a process whose files have at most `size` bytes, as on a disk that is full then."""

    def prepare() -> None:
        sys.dont_write_bytecode = True  # cut short, it would be read by every process that comes after
        os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return in_a_process(work, prepare=prepare)


def content(folder: Path) -> dict[str, bytes]:
    """Every file below a folder by its name."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}

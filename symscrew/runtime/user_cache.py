"""What was made once, kept in the user's cache folder by the hash of all that it was made from.

    key --entry--> read: the bytes that were written under this key, or None where they are not there whole and ours
                   write: for the next time

An entry is one file: a line with its key and the hash of what follows. It is written beside its place and moved there,
by one process at a time, so that it is there whole or not at all; what was spoiled afterwards is found by its hash and
made anew. The folder belongs to the user alone (mode 0700), entries are read only if they are plain files of this user,
and no symbolic link is followed: what somebody else put there is never used. Entries are bytes of libraries and texts;
nothing in them is deserialised.

SYMSCREW_CACHE names another folder, SYMSCREW_NO_CACHE=1 goes without. Where the folder cannot be used (a full disk,
somebody else's folder, no permission), everything is made anew each time; `state` says why.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import secrets
import stat
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

try:
    import fcntl
except ImportError:  # not on Windows: then two processes may make the same thing at the same time
    fcntl = None  # type: ignore[assignment]

FOLDER, WITHOUT = "SYMSCREW_CACHE", "SYMSCREW_NO_CACHE"  # variables of the environment
MAGIC = "symscrew-cache-1"  # first word of every entry: another number is another format, which is not read
ENTRY = re.compile(r"[0-9a-f]{64}(\.part-[0-9a-f]{12})?|lock-[0-9a-f]{2}", re.ASCII)  # names of our files
# Bytes of all entries: some hundreds of libraries. Above, the entries not used for longest go.
MOST = 1 << 30
PATIENCE = 60.0  # seconds for which another process may hold an entry: the largest library takes six to compile
LOOK_AGAIN = 0.02  # seconds between looks at it
LARGEST = 1 << 28  # bytes of one entry: longer ones would push out all others


@dataclass(frozen=True)
class CacheState:
    """Where the cache is, how many entries and bytes it holds, and why it is not used (None: it is)."""

    path: Path
    entries: int
    size: int
    unused: str | None


class Entry:
    """What is kept under a key; one process at a time holds it."""

    def __init__(self, folder: Path | None, key: str | None, *, keeps: bool = True) -> None:
        """Entry of a folder; without either, nothing is found and nothing is kept."""
        self._path = folder / key if folder is not None and key is not None else None
        self._keeps = keeps

    def read(self) -> bytes | None:
        """What was written, unless it is not there, not ours or not whole."""
        if self._path is None:
            return None
        try:
            with _opened(self._path) as file:
                found = os.fstat(file)
                if not stat.S_ISREG(found.st_mode) or not _own(found) or found.st_size > LARGEST:
                    return None
                with os.fdopen(os.dup(file), "rb") as stream:
                    head, _, content = stream.read().partition(b"\n")
                if head != _head(self._path.name, content):
                    return None
                with contextlib.suppress(OSError):
                    os.utime(file if os.utime in os.supports_fd else self._path)  # used now
                return content
        except OSError:
            return None

    def write(self, content: bytes) -> None:
        """Keep this; where that is not possible, nothing is kept."""
        if self._path is None or not self._keeps or len(content) > LARGEST:
            return
        part = self._path.with_name(f"{self._path.name}.part-{secrets.token_hex(6)}")
        try:
            for left in self._path.parent.glob(f"{self._path.name}.part-*"):  # of a killed process: this one holds it
                left.unlink()
            file = os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
            with os.fdopen(file, "wb") as stream:
                stream.write(_head(self._path.name, content) + b"\n" + content)
            os.replace(part, self._path)
            _shrink(self._path.parent)
        except OSError:
            with contextlib.suppress(OSError):
                part.unlink(missing_ok=True)


@contextlib.contextmanager
def entry(key: str | None) -> Iterator[Entry]:
    """The entry of a key (64 hexadecimal digits), held until the end; None: one that keeps nothing.

    Nor does the entry of whoever waited too long for another process.
    """
    folder, _ = _usable() if key is not None else (None, None)
    if folder is None or key is None:
        yield Entry(None, None)
        return
    with _held(folder / f"lock-{key[:2]}") as held:
        yield Entry(folder, key, keeps=held)


def key_of(*parts: bytes) -> str:
    """The key of what is made from these parts, in this order."""
    found = hashlib.sha256()
    for part in parts:
        found.update(len(part).to_bytes(8, "little") + part)
    return found.hexdigest()


def state() -> CacheState:
    """Where the cache is and what it holds; makes nothing."""
    path, why = _place(), None
    if os.environ.get(WITHOUT, "") not in ("", "0"):
        why = f"{WITHOUT} is set"
    elif path.is_symlink() or path.exists():
        why = _refused(path)
    found = [] if path.is_symlink() else _entries(path)
    return CacheState(path, len(found), sum(size for _, size, _ in found), why)


def clear() -> CacheState:
    """Remove all entries, and nothing else; what was there before."""
    before = state()
    if not before.path.is_symlink() and before.path.is_dir() and _own(before.path.lstat()):
        for name in os.listdir(before.path):
            if ENTRY.fullmatch(name):
                with contextlib.suppress(OSError):
                    (before.path / name).unlink(missing_ok=True)
    return before


@contextlib.contextmanager
def without() -> Iterator[None]:
    """Nothing is taken from the cache or kept, in this process and in those that it starts."""
    before = os.environ.get(WITHOUT)
    os.environ[WITHOUT] = "1"
    try:
        yield
    finally:
        del os.environ[WITHOUT]
        if before is not None:
            os.environ[WITHOUT] = before


def _place() -> Path:
    """The folder: SYMSCREW_CACHE, or where the system wants caches of users."""
    chosen = os.environ.get(FOLDER, "")
    if chosen:
        return Path(os.path.abspath(chosen))
    home = Path(os.path.expanduser("~"))
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local") / "symscrew" / "Cache"
    if sys.platform == "darwin":
        return home / "Library" / "Caches" / "symscrew"
    base = os.environ.get("XDG_CACHE_HOME", "")  # a relative one counts as none, says its specification
    return (Path(base) if os.path.isabs(base) else home / ".cache") / "symscrew"


def _usable() -> tuple[Path | None, str | None]:
    """The folder, made if it is not there, or why it cannot be used."""
    if os.environ.get(WITHOUT, "") not in ("", "0"):
        return None, f"{WITHOUT} is set"
    path = _place()
    try:
        if not path.is_absolute():  # no home
            return None, "there is no home folder"
        path.parent.mkdir(parents=True, exist_ok=True)
        with contextlib.suppress(FileExistsError):
            path.mkdir(mode=0o700)
    except OSError as error:
        return None, f"{error.strerror or error}"
    why = _refused(path)
    return (None, why) if why else (path, None)


def _refused(path: Path) -> str | None:
    """Why a folder that is there cannot be trusted, or None; one that others can only read is closed to them."""
    try:
        found = path.lstat()
        if not stat.S_ISDIR(found.st_mode):
            return "expected a folder, found a link or a file"
        if not _own(found):
            return "it belongs to another user"
        if hasattr(os, "getuid"):
            if found.st_mode & 0o022:
                return "others may write in it; remove it, or chmod 700"
            if found.st_mode & 0o077:
                path.chmod(0o700)
    except OSError as error:
        return f"{error.strerror or error}"
    return None


def _own(found: os.stat_result) -> bool:
    return not hasattr(os, "getuid") or found.st_uid == os.getuid()


@contextlib.contextmanager
def _opened(path: Path) -> Iterator[int]:
    """A file for reading, which is no symbolic link; opening something else (a pipe) does not wait."""
    flags = (getattr(os, name, 0) for name in ("O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC", "O_BINARY"))
    file = os.open(path, os.O_RDONLY | sum(flags))
    try:
        yield file
    finally:
        os.close(file)


@contextlib.contextmanager
def _held(path: Path) -> Iterator[bool]:
    """A file that one process (and one thread) at a time holds: whether it is; where files cannot be locked, it is.

    Whoever has waited for `PATIENCE` goes on without: the holder may be stopped, or at work on another entry.
    """
    try:
        flags = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)
        file = os.open(path, os.O_WRONLY | os.O_CREAT | flags, 0o600)
    except OSError:
        yield True
        return
    try:
        yield _locked(file)
    finally:
        os.close(file)


def _locked(file: int) -> bool:
    end = time.monotonic() + PATIENCE
    while fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            if time.monotonic() > end:
                return False
            time.sleep(LOOK_AGAIN)
        except OSError:
            break
        else:
            break
    return True


def _head(key: str, content: bytes) -> bytes:
    return f"{MAGIC} {key} {hashlib.sha256(content).hexdigest()}".encode("ascii")


def _entries(path: Path) -> list[tuple[float, int, Path]]:
    """Time of the last use, size and place of every entry and of what is left of interrupted ones."""
    found = []
    try:
        for place in os.scandir(path):
            if ENTRY.fullmatch(place.name) and not place.name.startswith("lock-") and not place.is_symlink():
                facts = place.stat(follow_symlinks=False)
                found.append((facts.st_mtime, facts.st_size, Path(place.path)))
    except OSError:
        return found
    return found


def _shrink(path: Path) -> None:
    """Remove what was not used for longest, until the rest is within its bound."""
    found = sorted(_entries(path))
    total = sum(size for _, size, _ in found)
    for _, size, place in found:
        if total <= MOST:
            return
        place.unlink(missing_ok=True)
        total -= size

"""The user's cache: what is read is what was written, whole, by this user; everything else is made anew."""

from __future__ import annotations

import os
import stat
import threading
import time
from pathlib import Path

import pytest

from symscrew.runtime import user_cache
from symscrew.runtime.user_cache import clear, entry, key_of, state, without

KEY, OTHER = key_of(b"one"), key_of(b"other")
CONTENT = bytes(range(256)) * 4
posix = pytest.mark.skipif(not hasattr(os, "getuid"), reason="no users and links of POSIX here")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SYMSCREW_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv("SYMSCREW_NO_CACHE", raising=False)
    return tmp_path / "cache"


def put(key: str = KEY, content: bytes = CONTENT) -> None:
    with entry(key) as kept:
        kept.write(content)


def got(key: str | None = KEY) -> bytes | None:
    with entry(key) as kept:
        return kept.read()


def test_what_was_written_is_read(folder: Path) -> None:
    assert got() is None
    for content in (CONTENT, b"", b"\n", CONTENT + b"more"):
        put(content=content)
        assert got() == content and got(OTHER) is None
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    assert all(stat.S_IMODE(path.stat().st_mode) == 0o600 for path in folder.iterdir())


def test_keys_tell_parts_apart() -> None:
    keys = [key_of(*parts) for parts in ((b"ab",), (b"a", b"b"), (b"", b"ab"), (b"ab", b""), (b"ba",), ())]
    assert len(set(keys)) == len(keys) and all(len(key) == 64 for key in keys)


@pytest.mark.parametrize("length", [0, 1, 60, 148, 200, len(CONTENT)])
def test_an_entry_that_is_cut_off_is_none(folder: Path, length: int) -> None:
    put()
    whole = (folder / KEY).read_bytes()
    (folder / KEY).write_bytes(whole[: min(length, len(whole) - 1)])
    assert got() is None
    put()
    assert got() == CONTENT


@pytest.mark.parametrize("place", [0, 20, 90, 200, -1])
def test_an_entry_with_one_other_bit_is_none(folder: Path, place: int) -> None:
    put()
    spoiled = bytearray((folder / KEY).read_bytes())
    spoiled[place] ^= 1
    (folder / KEY).write_bytes(spoiled)
    assert got() is None


def test_an_entry_of_another_key_is_none(folder: Path) -> None:
    put()
    os.replace(folder / KEY, folder / OTHER)
    assert got(OTHER) is None


@posix
def test_links_pipes_and_folders_are_not_followed(folder: Path, tmp_path: Path) -> None:
    put()
    os.replace(folder / KEY, tmp_path / "elsewhere")
    (folder / KEY).symlink_to(tmp_path / "elsewhere")
    assert got() is None
    (folder / KEY).unlink()
    os.mkfifo(folder / KEY)  # who opens it for reading waits for a writer
    assert got() is None
    (folder / KEY).unlink()
    (folder / KEY).mkdir()
    assert got() is None
    put()
    assert got() is None and not list(folder.glob("*.part-*"))


@posix
def test_a_folder_that_is_a_link_or_open_to_others_is_not_used(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "real").mkdir(mode=0o700)
    folder.symlink_to(tmp_path / "real")
    put()
    assert got() is None and not list((tmp_path / "real").iterdir()) and "link" in str(state().unused)
    folder.unlink()
    folder.mkdir()
    folder.chmod(0o777)
    put()
    assert not list(folder.iterdir()) and "others may write" in str(state().unused)
    folder.chmod(0o755)  # nobody else can have put something there
    put()
    assert got() == CONTENT and stat.S_IMODE(folder.stat().st_mode) == 0o700
    folder.chmod(0o770)
    assert got() is None


@posix
def test_what_belongs_to_another_user_is_not_used(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put()
    me = os.getuid()
    monkeypatch.setattr(user_cache.os, "getuid", lambda: me + 1)
    assert got() is None and "another user" in str(state().unused)
    assert clear().entries == 1
    monkeypatch.setattr(user_cache.os, "getuid", lambda: me)
    assert got() == CONTENT  # clearing touched nothing of somebody else


@posix
def test_an_entry_of_another_user_in_our_folder_is_none(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put()
    found = os.fstat
    changed = lambda file: os.stat_result((*found(file)[:4], os.getuid() + 1, *found(file)[5:]))  # noqa: E731
    monkeypatch.setattr(user_cache.os, "fstat", changed)
    assert got() is None


@pytest.mark.parametrize("place", ["file", "file/below", "/proc/nothing/here"])
def test_without_a_place_everything_is_made_anew(place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("SYMSCREW_CACHE", os.path.join(tmp_path, place))
    put()
    assert got() is None and (tmp_path / "file").read_text() == "in the way"


def test_a_full_disk_leaves_nothing_torn(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    put(OTHER)
    monkeypatch.setattr(user_cache.os, "replace", full)
    put()
    assert got() is None and got(OTHER) == CONTENT and not list(folder.glob("*.part-*"))


def test_going_without(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put()
    with without():
        assert got() is None and os.environ["SYMSCREW_NO_CACHE"] == "1"
        put(OTHER)
    assert got() == CONTENT and got(OTHER) is None and "SYMSCREW_NO_CACHE" not in os.environ
    monkeypatch.setenv("SYMSCREW_NO_CACHE", "1")
    assert got() is None and "SYMSCREW_NO_CACHE" in str(state().unused)
    assert got(None) is None


def test_the_place_by_the_rules_of_the_system(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("SYMSCREW_CACHE")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    monkeypatch.setattr(user_cache.sys, "platform", "linux")
    assert state().path == tmp_path / ".cache" / "symscrew"
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert state().path == tmp_path / "xdg" / "symscrew"
    monkeypatch.setattr(user_cache.sys, "platform", "darwin")
    assert state().path == tmp_path / "Library" / "Caches" / "symscrew"
    assert not (tmp_path / "xdg").exists()  # looking makes nothing


def test_clearing_removes_entries_and_nothing_else(folder: Path) -> None:
    put()
    put(OTHER)
    (folder / f"{KEY}.part-0123456789ab").write_bytes(b"of a process that was killed")
    (folder / "mine.txt").write_text("not an entry")
    before = state()
    assert before.entries == 3 and before.size > 2 * len(CONTENT)
    assert clear() == before and state().entries == 0
    assert [path.name for path in folder.iterdir()] == ["mine.txt"]


def test_what_was_not_used_for_longest_goes_first(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    keys = [key_of(str(k).encode()) for k in range(5)]
    monkeypatch.setattr(user_cache, "MOST", 4 * (len(CONTENT) + 200))
    for age, key in enumerate(keys[:4]):
        put(key)
        os.utime(folder / key, (1000 + age, 1000 + age))
    assert got(keys[0]) == CONTENT  # used now
    put(keys[4])
    assert [got(key) is not None for key in keys] == [True, False, True, True, True]


def test_two_at_once_make_it_once() -> None:
    made = []

    def work() -> None:
        with entry(KEY) as kept:
            if kept.read() is None:
                made.append(threading.get_ident())
                time.sleep(0.05)  # while the others wait
                kept.write(CONTENT)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(made) == 1 and got() == CONTENT


@posix
def test_nobody_waits_without_end_for_a_process_that_is_stopped(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is there is read; what is made meanwhile is not kept, since the holder may be about to write it."""
    put()
    monkeypatch.setattr(user_cache, "PATIENCE", 0.1)
    beside = KEY[:2] + OTHER[2:]  # another entry under the same lock
    with entry(KEY):
        assert got() == CONTENT
        put(beside)
    assert got(beside) is None
    put(beside)
    assert got(beside) == CONTENT

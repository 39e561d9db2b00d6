"""Files and folders are the old ones or the new ones, whichever step a process is killed at, whoever else is there."""

from __future__ import annotations

import os
import threading
import time
from functools import cache, partial
from pathlib import Path

import pytest
from support import handmade
from support.faults import content, in_a_process, killed_at, with_files_up_to
from support.samples import some_quickly

from symscrew.errors import DescriptionError
from symscrew.export import OutputError, read_manifest
from symscrew.generation import folder as generation
from symscrew.generation.folder import generate, render
from symscrew.model import Model
from symscrew.whole_files import made_together, whole_folder
from symscrew.whole_files.one_file import created, destination, replaced, write_text
from symscrew.whole_files.staging import discard, is_staging, stage
from symscrew.whole_files.turns import LockedError, one_at_a_time
from symscrew.whole_files.whole_folder import PENDING

MOST = 500  # steps of anything here: it must end
OLD, NEW, OTHER = ("numpy",), ("c",), ("javascript",)  # the last is as few files as the first
WAYS = ("alone", "nothing there", "current folder", "user's files", "cannot exchange")


@cache
def model() -> Model:
    return handmade.model()


@pytest.fixture(scope="module")
def rendered() -> dict[tuple[str, ...], dict[str, bytes]]:
    old = render(model(), OLD)
    made = {targets: render(model(), targets) for targets in (NEW, OTHER)}
    return {OLD: old} | {t: new | {n: data + b"\n" for n, data in new.items() if n in old} for t, new in made.items()}


@pytest.fixture
def written_at_once(rendered, monkeypatch: pytest.MonkeyPatch) -> None:
    """Printing is not what is tested, and takes most of the time."""
    monkeypatch.setattr(generation, "render", lambda model, targets, **_: rendered[tuple(targets)])


def prepared(way: str, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if way != "nothing there":
        generate(model(), place, OLD)
    if way == "user's files":
        (place / "build").mkdir()
        (place / "build" / "mine.o").write_text("mine")
        (place / "notes.txt").write_text("mine")
    if way == "current folder":
        monkeypatch.chdir(place)
    if way == "cannot exchange":
        monkeypatch.setattr(whole_folder, "_exchanged", lambda *_: False)


@pytest.mark.parametrize("way", some_quickly(WAYS, every=5))
def test_generate_is_killed_at_every_step(
    way: str, tmp_path: Path, rendered, written_at_once, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "out"
    prepared(way, place, monkeypatch)
    mine = {n: c for n, c in (content(place) if place.exists() else {}).items() if n.endswith(("mine.o", "notes.txt"))}
    moved = seen_old = seen_new = 0
    for step in range(MOST):
        was_killed = killed_at(partial(generate, model(), place, OTHER), step)
        if place.exists() and (any(place.iterdir())):
            moved += (place / PENDING).exists() or any(is_staging(p.name) for p in tmp_path.iterdir())
            at_once = {n for n in content(place) if not n.startswith(".")}
            if way in ("nothing there", "alone"):  # whoever looks, at any moment
                assert at_once in (set(rendered[OLD]), set(rendered[OTHER]))
            read_manifest(place)  # as every reader does
            found = {n: c for n, c in content(place).items() if not n.startswith(".")}
            assert found in (rendered[OLD] | mine, rendered[OTHER] | mine), f"step {step}"
            seen_old += found == rendered[OLD] | mine
            seen_new += found == rendered[OTHER] | mine
        if not was_killed:
            break
        generate(model(), place, OLD)  # the next run works, and cleans up
        assert content(place) == rendered[OLD] | mine
        assert [p.name for p in tmp_path.iterdir()] == ["out"]
        if way == "nothing there":
            discard(place)
    else:
        pytest.fail("does not end")
    assert content(place) == rendered[OTHER] | mine and step > 10 and seen_new
    assert moved and (seen_old > 5 or way == "nothing there")
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


def test_a_folder_alone_is_exchanged_and_one_with_a_users_files_stays(tmp_path: Path, written_at_once) -> None:
    generate(model(), tmp_path / "out", OLD)
    before = (tmp_path / "out").stat()
    generate(model(), tmp_path / "out", NEW)
    between = (tmp_path / "out").stat()
    assert between.st_ino != before.st_ino and between.st_mode == before.st_mode
    (tmp_path / "out" / "notes.txt").write_text("mine")
    generate(model(), tmp_path / "out", OLD)
    assert (tmp_path / "out").stat().st_ino == between.st_ino
    (tmp_path / "link").symlink_to("out")
    generate(model(), tmp_path / "link", NEW)
    assert (tmp_path / "link").is_symlink() and (tmp_path / "out" / "handmade.h").exists()


def test_two_at_once_are_one_after_the_other(tmp_path: Path, rendered, written_at_once) -> None:
    place, wrong, ended = tmp_path / "out", [], list[int]()

    def again(targets: tuple[str, ...]) -> None:
        for _ in range(6):
            generate(model(), place, targets)

    def ends(targets: tuple[str, ...]) -> None:
        ended.append(in_a_process(partial(again, targets)))

    workers = [threading.Thread(target=ends, args=(targets,)) for targets in (OLD, NEW)]
    for worker in workers:
        worker.start()
    while any(worker.is_alive() for worker in workers):
        time.sleep(0.0005)
        try:
            before = place.stat()
            names = {name for name in os.listdir(place) if not name.startswith(".")}
            same = os.path.samestat(before, place.stat())  # else the names may be of a folder that is being removed
        except FileNotFoundError:
            continue
        if same and names not in (set(rendered[OLD]), set(rendered[NEW])):
            wrong.append(names)
    assert wrong == [] and ended == [0, 0]
    assert content(place) in rendered.values() and [p.name for p in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("size", some_quickly([100, 1000, 2000, 3000], every=4))
def test_a_full_disk_leaves_what_was_there(size: int, tmp_path: Path, rendered, written_at_once) -> None:
    assert size < max(map(len, rendered[NEW].values()))
    generate(model(), tmp_path / "out", OLD)
    write_text(tmp_path / "report.md", "old")

    def work() -> None:
        with pytest.raises(OutputError, match=r"out: cannot be written \(File too large\); nothing was"):
            generate(model(), tmp_path / "out", NEW)
        with pytest.raises(OSError, match=r"File too large: '.*report\.md'"):
            write_text(tmp_path / "report.md", "new" * 1001)
        with pytest.raises(OSError, match="File too large"):
            created(tmp_path / "new.toml", "new" * 1001)

    assert with_files_up_to(size, work) == 0
    assert content(tmp_path) == {"report.md": b"old"} | {f"out/{n}": c for n, c in rendered[OLD].items()}


def test_a_file_is_killed_at_every_step(tmp_path: Path) -> None:
    write_text(tmp_path / "a.txt", "old")
    for step in range(MOST):
        was_killed = killed_at(lambda: write_text(tmp_path / "a.txt", "new"), step)
        there = (tmp_path / "a.txt").read_text()
        assert there in ("old", "new") and (was_killed or there == "new")
        write_text(tmp_path / "a.txt", "old")
        assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]
        if not was_killed:
            break
    assert step >= 3


def test_a_new_file_is_killed_at_every_step(tmp_path: Path) -> None:
    for step in range(MOST):
        was_killed = killed_at(lambda: created(tmp_path / "a.toml", "whole"), step)
        if (tmp_path / "a.toml").exists():
            assert (tmp_path / "a.toml").read_text() == "whole"
            with pytest.raises(FileExistsError):
                created(tmp_path / "a.toml", "other")
            (tmp_path / "a.toml").unlink()
        if not was_killed:
            break
    assert step >= 3


def test_a_place_in_use_is_not_removed(tmp_path: Path) -> None:
    with stage(tmp_path / "a.txt") as place:
        (place / "half").write_text("half")
        assert in_a_process(lambda: write_text(tmp_path / "a.txt", "other")) == 0
        assert (place / "half").exists()
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]


def test_names_as_long_as_a_disk_allows(tmp_path: Path) -> None:
    for letter in ("a", "é", "漢"):
        name = letter * (255 // len(letter.encode()))
        assert write_text(tmp_path / name, "whole").read_text() == "whole"


def test_only_own_places_are_removed(tmp_path: Path) -> None:
    (tmp_path / "precious").mkdir()
    (tmp_path / ".a.txt.making-0123456789ab").symlink_to("precious")
    for name in (".a.txt.making-", ".a.txt.making-0123456789abc", ".b.txt.making-0123456789ab", "a.txt.making-0123"):
        (tmp_path / name).mkdir()
    before = {p.name for p in tmp_path.iterdir()}
    write_text(tmp_path / "a.txt", "whole")
    assert {p.name for p in tmp_path.iterdir()} == before | {"a.txt"}
    (tmp_path / ".a.txt.making-fedcba987654").mkdir()
    write_text(tmp_path / "a.txt", "whole")
    assert {p.name for p in tmp_path.iterdir()} == before | {"a.txt"}


def test_who_waits_too_long_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with one_at_a_time(tmp_path) as same:
        assert same()
        said = "another process has been writing here for 0 s"
        with pytest.raises(LockedError, match=said), one_at_a_time(tmp_path, patience=0):
            pass
        assert capsys.readouterr().err == ""
        with pytest.raises(LockedError), one_at_a_time(tmp_path, patience=0.06, notice="waiting for it"):
            pass
    assert capsys.readouterr().err == "waiting for it\n"
    with one_at_a_time(tmp_path, patience=0), one_at_a_time(tmp_path / "none") as same:
        assert not same()


def test_a_pending_folder_cannot_reach_elsewhere(tmp_path: Path, written_at_once) -> None:
    """It comes with a folder by somebody else: its files stay in it."""
    place = tmp_path / "out"
    generate(model(), place, OLD)
    (tmp_path / "precious").mkdir()
    (tmp_path / "precious" / "a.txt").write_text("keep")
    (place / PENDING).symlink_to(tmp_path / "precious")
    read_manifest(place)
    assert (tmp_path / "precious" / "a.txt").read_text() == "keep"


def test_a_folder_nobody_may_write_in(tmp_path: Path, written_at_once) -> None:
    generate(model(), tmp_path / "out", OLD)
    (tmp_path / "out" / PENDING).mkdir()
    (tmp_path / "out" / PENDING / "handmade.h").write_text("new")
    before = content(tmp_path)

    def work() -> None:
        if os.getuid() == 0:
            os.setuid(65534)  # nobody
        with pytest.raises(OutputError, match=r"was being written, and cannot be \(Permission denied\)"):
            read_manifest(tmp_path / "out")
        with pytest.raises(OSError, match="Permission denied"):
            write_text(tmp_path / "a.txt", "new")

    for folder in (tmp_path / "out" / PENDING, tmp_path / "out", tmp_path, *list(tmp_path.parents)[:2]):
        folder.chmod(0o755)
    tmp_path.chmod(0o555)
    (tmp_path / "out").chmod(0o555)
    (tmp_path / "out" / PENDING).chmod(0o555)
    try:
        assert in_a_process(work) == 0
    finally:
        for folder in (tmp_path, tmp_path / "out", tmp_path / "out" / PENDING):
            folder.chmod(0o755)
    assert content(tmp_path) == before


def test_replaced_says_the_file_that_was_asked_for(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"No such file or directory: '.*/none/a\.txt'"):
        replaced(tmp_path / "none" / "a.txt", lambda part: part.write_text("a"))
    start = time.monotonic()
    with pytest.raises(IsADirectoryError):
        write_text(tmp_path, "a")
    assert time.monotonic() >= start


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
def test_pipes_and_devices_are_not_replaced_by_files(tmp_path: Path) -> None:
    """Who is allowed to write beside /dev/null would have lost it."""
    os.mkfifo(tmp_path / "pipe.txt")
    with pytest.raises(OSError, match=r"a device or a pipe: '.*/pipe\.txt'"):
        write_text(tmp_path / "pipe.txt", "a")
    assert (tmp_path / "pipe.txt").is_fifo()


def test_where_nothing_can_be_written_is_said_before_the_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A run of an hour is not lost at its end: the folder is asked first, and a folder of the file's name is none."""
    (tmp_path / "taken.npz").mkdir()
    with pytest.raises(DescriptionError, match="--out: expected a file, found a folder"):
        destination(str(tmp_path / "taken.npz"), (".npz",), "--out")
    monkeypatch.setattr("os.access", lambda path, mode: Path(path) != tmp_path)  # root may write everywhere
    with pytest.raises(DescriptionError, match="--out: no permission to write into"):
        destination(str(tmp_path / "run.npz"), (".npz",), "--out")


@pytest.mark.parametrize("there", [False, True])
def test_files_made_together_are_there_together(tmp_path: Path, there: bool) -> None:
    """Not one of them before the last is made; what else is in the folder stays."""
    folder = tmp_path / "deep" / "study"
    if there:
        folder.mkdir(parents=True)
        (folder / "notes").write_text("mine")
        (folder / "b").write_text("old")
    before = {path.name: path.read_text() for path in folder.iterdir()} if there else {}

    def failing(place: Path) -> None:
        (place / "a").write_text("new")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        made_together(folder, failing)
    assert ({path.name: path.read_text() for path in folder.iterdir()} if there else {}) == before
    assert folder.exists() == there

    def making(place: Path) -> None:
        for name in "ba":
            (place / name).write_text(f"new {name}")

    assert made_together(folder, making) == [folder / "a", folder / "b"]
    found = {path.name: path.read_text() for path in folder.iterdir()}
    assert found == {**before, "a": "new a", "b": "new b"} and [p.name for p in folder.parent.iterdir()] == ["study"]


def test_a_folder_made_at_once_is_killed_at_every_step(tmp_path: Path) -> None:
    """A new one holds all files or is not there; what is left beside is removed by the next that makes it."""

    def making(place: Path) -> None:
        for name in "ab":
            (place / name).write_text(name)

    for step in range(100):
        folder = tmp_path / f"study{step}"
        was_killed = killed_at(partial(made_together, folder, making), step)
        assert not folder.exists() or sorted(content(folder)) == ["a", "b"]
        if not was_killed:
            break
        made_together(folder, making)
        assert sorted(content(folder)) == ["a", "b"]
        assert not [p for p in tmp_path.iterdir() if p.name.startswith(f".study{step}.")]
    assert 5 < step < 100


def test_a_place_that_cannot_be_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError) as caught:
        made_together(tmp_path / "file", lambda place: (place / "a").write_text(""))
    assert caught.value.filename == str(tmp_path / "file")

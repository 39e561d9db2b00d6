"""Processes that work for another end with it, and two that want the same folder take turns."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import numpy as np
import pytest
from support.faults import content, killed_at, with_files_up_to
from support.model_states import pendulum
from support.samples import some_quickly

from symscrew import catalogue
from symscrew.array_archives import read_archive
from symscrew.cli.parser import main
from symscrew.description import to_toml
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.studies.workspace import store
from symscrew.studies.workspace.plan import Axis, Plan
from symscrew.studies.workspace.store import Store
from symscrew.whole_files.staging import discard, is_staging

ASLEEP = """
import os, sys, time
from symscrew.workers import pool
def work(_):
    os.write(1, b"%d\\n" % os.getpid())
    time.sleep(100)
if __name__ == "__main__":
    with pool(3, sys.argv[1]) as processes:
        list(processes.map(work, range(3)))
"""
PLAN = Plan(catalogue.load("four_bar"), (Gravity(),), (Axis("A", -0.5, 0.5, 12),), chunk=5)
PIECES = {
    k: {name: np.arange(float(len(PLAN.cases(k)))) for name in ("status", "reached", "regular", "allowed", "A")}
    for k in range(3)
}


def is_there(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def ended(processes: list[int]) -> bool:
    end = time.monotonic() + 30
    while any(map(is_there, processes)) and time.monotonic() < end:
        time.sleep(0.01)
    return not any(map(is_there, processes))


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="no /proc to look into")
@pytest.mark.parametrize("method", some_quickly(["fork", "spawn"], every=2))
def test_workers_end_with_their_parent(method: str, tmp_path: Path) -> None:
    (tmp_path / "asleep.py").write_text(ASLEEP)
    parent = subprocess.Popen([sys.executable, "asleep.py", method], cwd=tmp_path, stdout=subprocess.PIPE)
    assert parent.stdout is not None
    workers = [int(parent.stdout.readline()) for _ in range(3)]
    assert all(map(is_there, workers))
    parent.kill()
    parent.wait()
    assert ended(workers)


@pytest.mark.slow
def test_workers_of_a_sweep_end_with_it_and_two_take_turns(tmp_path: Path) -> None:
    (tmp_path / "pendulum.toml").write_text(to_toml(pendulum().mechanism))
    over = ["--over", "pivot=-0.5:0.5:30000", "--processes", "2", "--out", "map.npz"]

    def begun() -> int:
        """A process of its own that computes the sweep."""
        if (process := os.fork()) == 0:
            os.chdir(tmp_path)
            with (tmp_path / "said").open("a") as said, redirect_stdout(said), redirect_stderr(said):
                code = main(["workspace", "pendulum.toml", *over])
            os._exit(code)
        return process

    first, end = begun(), time.monotonic() + 60
    while not list(tmp_path.glob(".map.npz.pieces/piece_*")) and time.monotonic() < end:
        time.sleep(0.01)
    children = Path(f"/proc/{first}/task/{first}/children").read_text().split()
    os.kill(first, signal.SIGKILL)
    os.waitpid(first, 0)
    assert len(children) >= 2 and ended([int(child) for child in children])
    assert [os.waitpid(process, 0)[1] for process in [begun(), begun()]] == [0, 0]
    text = (tmp_path / "said").read_text()
    assert "Traceback" not in text and "pieces are there already" in text and text.count("wrote map.npz") == 2
    assert text.count("another process computes this sweep") <= 1
    assert np.array_equal(read_archive(tmp_path / "map.npz")["pivot"], np.linspace(-0.5, 0.5, 30000))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["map.npz", "pendulum.toml", "said"]


def filled(folder: Path) -> Store:
    kept = Store(folder, PLAN)
    for number, results in PIECES.items():
        kept.put(number, results)
    return kept


@pytest.mark.slow
def test_a_sweep_is_killed_at_every_step(tmp_path: Path) -> None:
    folder = tmp_path / "pieces"
    for step in range(200):
        was_killed = killed_at(lambda: filled(folder), step)
        done = Store(folder, PLAN).done()
        assert list(done) == list(range(len(done)))
        assert np.array_equal(filled(folder).whole()["A"], np.concatenate([p["A"] for p in PIECES.values()]))
        assert not any(is_staging(path.name) for path in folder.iterdir()) and len(content(folder)) == 4
        discard(folder)
        if not was_killed:
            break
    assert step > 10


def test_a_sweep_on_a_full_disk(tmp_path: Path) -> None:
    def work() -> None:
        with pytest.raises(OSError, match="File too large"):
            filled(tmp_path / "pieces")

    assert with_files_up_to(200, work) == 0
    assert [path.name for path in (tmp_path / "pieces").iterdir()] == ["manifest.json"]
    assert len(filled(tmp_path / "pieces").whole()["A"]) == 12


SPOILED = (
    ("manifest.json", b"[" * 100_000, "not a manifest of a sweep"),
    ("manifest.json", b"{}", "pieces of another sweep"),
    ("manifest.json", b"\xff\xfe", "UTF-8"),
    ("manifest.json", b"1" * 5000, "not a manifest of a sweep|another sweep"),
    ("piece_0000001_{}.npz", b"junk", "expected an archive of arrays"),
    ("piece_0000001_{}.npz", {"A": np.zeros(5)}, "not a piece of this sweep; remove it"),
    ("piece_0000001_{}.npz", PIECES[1] | {"A": np.zeros(4)}, "not a piece of this sweep"),
    ("piece_0000001_{}.npz", PIECES[1] | {"A": np.zeros(5, complex)}, "real numbers"),
    ("piece_0000001_{}.npz", PIECES[1] | {"A": np.zeros(500_000)}, "expected at most"),
    ("piece_0000001_{}.npz", PIECES[1] | {"B": np.zeros(5)}, "not a piece of this sweep"),
    ("piece_a_b.npz", b"junk", ""),
    ("piece_0000001_0000000000000000.npz", b"junk", ""),
    ("piece_9999999_{}.npz", b"junk", ""),
    ("piece_0000001_zzzzzzzzzzzzzzzz_1.npz", b"junk", ""),
)


@pytest.mark.parametrize("name, spoiled, said", SPOILED, ids=lambda value: str(value)[:24])
def test_spoiled_folders_of_sweeps_are_one_error_or_left_out(name: str, spoiled, said: str, tmp_path: Path) -> None:
    kept = filled(tmp_path)
    if said:
        kept.done()[1].unlink()
    part = tmp_path / "part.npz"
    np.savez(part, **spoiled) if isinstance(spoiled, dict) else part.write_bytes(spoiled)
    part.rename(tmp_path / name.format(store._digest(part)))
    (tmp_path / "piece_0000002_0123456789abcdef.npz").mkdir()
    if said:
        with pytest.raises(DescriptionError, match=said):
            Store(tmp_path, PLAN).whole()
    else:
        assert len(Store(tmp_path, PLAN).whole()["A"]) == 12


@pytest.mark.slow
def test_a_picture_on_a_full_disk_is_none(tmp_path: Path) -> None:
    """At most of its size; an attack of `support.attacks` has less room."""
    pytest.importorskip("matplotlib")
    (tmp_path / "a.png").write_bytes(b"old")

    def work() -> None:
        assert main(["draw", "four_bar", "--out", str(tmp_path / "a.png")]) == 2

    assert with_files_up_to(20_000, work) == 0
    assert content(tmp_path) == {"a.png": b"old"} and os.listdir(tmp_path) == ["a.png"]

"""Work that another process does beside this one: the same results, whatever becomes of that process."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Iterable

import pytest
from support.model_states import model

from symscrew import workers
from symscrew.export import c, c_pieces, c_printed, print_c
from symscrew.generation import folder
from symscrew.workers import beside, taken_once

pytestmark = pytest.mark.slow

DEATHS: tuple[Callable[[], object], ...] = (
    lambda: os.kill(os.getpid(), signal.SIGKILL),
    lambda: os._exit(3),
    lambda: 1 / 0,
)
LONG = 60.0  # s that a process takes for what nobody waits for


def test_another_process_does_it() -> None:
    with beside(os.getpid) as result:
        assert result() != os.getpid()


def test_it_is_done_here_where_processes_have_no_copies(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(os, "fork")
    with beside(os.getpid) as result:
        assert result() == os.getpid()


def test_it_is_done_here_where_there_is_no_room_for_a_process(monkeypatch: pytest.MonkeyPatch) -> None:
    def full() -> int:
        raise BlockingIOError

    before = len(os.listdir("/proc/self/fd"))
    monkeypatch.setattr(os, "fork", full)
    with beside(os.getpid) as result:
        assert result() == os.getpid()
    assert len(os.listdir("/proc/self/fd")) == before


@pytest.mark.parametrize("death", DEATHS)
def test_it_is_done_here_where_the_other_process_does_not_get_to_its_end(death: Callable[[], object]) -> None:
    here = os.getpid()

    def work() -> int:
        if os.getpid() != here:
            death()
        return os.getpid()

    with beside(work) as result:
        assert result() == here


def test_an_error_of_the_work_is_raised_here() -> None:
    def work() -> None:
        raise ValueError("no")

    with beside(work) as result, pytest.raises(ValueError, match="no"):
        result()


def test_nobody_waits_for_what_is_not_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    copies: list[int] = []
    fork = os.fork
    monkeypatch.setattr(os, "fork", lambda: copies.append(fork()) or copies[-1])
    start = time.monotonic()
    with pytest.raises(KeyError), beside(lambda: time.sleep(LONG)):
        raise KeyError
    assert time.monotonic() - start < LONG
    with pytest.raises(ProcessLookupError):
        os.kill(copies[0], 0)


def test_each_item_comes_to_one_process() -> None:
    items = [f"item {k}" for k in range(300)]
    with taken_once(items) as waiting:
        first = next(waiting)
        with beside(lambda: list(waiting)) as result:
            here = [first, *waiting]
            other = result()
    assert sorted(here + other) == sorted(items)


def test_what_a_process_took_that_died_is_printed_here(monkeypatch: pytest.MonkeyPatch) -> None:
    expected = print_c(model("four_bar"), several=True)
    here, share = os.getpid(), c_pieces.Pieces._share

    def dying(pieces: c_pieces.Pieces, functions: Iterable[str]) -> object:
        if os.getpid() != here:
            next(iter(functions))
            os.kill(os.getpid(), signal.SIGKILL)
        return share(pieces, functions)

    monkeypatch.setattr(c_pieces, "WORTH_A_PROCESS", 1)
    monkeypatch.setattr(c_pieces.Pieces, "_share", dying)
    assert print_c(model("four_bar"), several=True, processes=3) == expected


@pytest.mark.parametrize(("name", "long"), [("four_bar", 5500), ("planar_3rrr", 5500), ("four_bar", 60)])
def test_two_processes_print_what_one_does(name: str, long: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second mechanism has lanes and functions that share constants, the third functions in parts."""
    monkeypatch.setattr(c_printed, "LONG", long)
    made: list[object] = []
    copied = workers._copied
    monkeypatch.setattr(workers, "_copied", lambda work: made.append(copied(work)) or made[-1])
    monkeypatch.setattr(c_pieces, "WORTH_A_PROCESS", 1)
    begun: list[int] = []  # other processes when the header is printed
    header = c.print_header
    monkeypatch.setattr(c, "print_header", lambda *a, **k: begun.append(len(made)) or header(*a, **k))
    assert print_c(model(name), several=True, processes=2) == print_c(model(name), several=True)
    assert len(made) == 1 and made[0] is not None
    assert begun[0] == 1


def test_a_folder_is_the_same_whoever_evaluates_the_test_states(monkeypatch: pytest.MonkeyPatch) -> None:
    copies: list[object] = []
    copied = workers._copied
    monkeypatch.setattr(workers, "_copied", lambda work: copies.append(copied(work)) or copies[-1])
    monkeypatch.setattr(folder, "EVALUATED_BESIDE", 0)
    assert folder.render(model("four_bar"), ("c",), processes=2) == folder.render(model("four_bar"), ("c",))
    assert len(copies) == 1 and copies[0] is not None

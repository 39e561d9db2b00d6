"""Settings of all tests. What the folders hold and how they are run stands in README.md beside this file."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest
from support.derived_once import derived_once
from support.model_states import ALL, model
from support.once import Levels, Lock, tiny_compiler

import symscrew.model
from symscrew.generation.folder import USUAL, generate
from symscrew.runtime import compilers

# JAX's compiler, whose passes change no more than the last bits, takes a third less time without them.
os.environ.setdefault("XLA_FLAGS", "--xla_backend_optimization_level=0")
# There are as many processes of tests as processors: threads of linear algebra would only wait for one another.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
FUNCTIONS = {"-O1": "-O0", "-O2": "-O0", "-O3": "-O1"}
"""Levels in place of users': of functions that are called a few times, of loops of runs that take milliseconds."""
HARD = {"-O1": "-O0", "-O2": "-O0", "-O3": "-O0"}
"""The same in `hard` and for tests marked `short_runs`: by the hundred, compiling takes longer than running."""
RARELY = 100_000
"""Objects made between two searches for garbage: a process that holds many models is searched long (a twentieth of all
time with Python's 700), and what tests drop is mostly freed without."""


def pytest_collection_finish() -> None:
    """What importing has made is hardly garbage: it counts as old, which nobody searches here."""
    gc.freeze()
    gc.unfreeze()
    gc.set_threshold(RARELY, 20, 50)


def pytest_sessionfinish() -> None:
    """Nor is what is left at the end, which pytest would search five times."""
    gc.freeze()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The folder says it: whatever stands in `tools` needs a tool beyond Python and a C compiler.

    Tests of one mechanism stand together, so that one process derives it and not each of them. Tests that kill their
    own process come first: a process is copied for each kill, which takes a few times as long when it holds models.
    """
    for item in items:
        if item.path.parent.name == "tools":
            item.add_marker(pytest.mark.tools)
    items.sort(key=place_of)


def place_of(item: pytest.Item) -> int:
    """Where a test stands: first those that kill, then those of no mechanism, then by the mechanism that is named."""
    if hasattr(getattr(item, "module", None), "killed_at"):
        return -1
    parameters = item.callspec.params.values() if hasattr(item, "callspec") else ()
    named = [value for value in parameters if isinstance(value, str) and value in ALL]
    return 1 + ALL.index(named[0]) if named else 0


@pytest.fixture(scope="session")
def common(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that all processes of this run of the tests share."""
    own = tmp_path_factory.getbasetemp()
    return own.parent if "PYTEST_XDIST_WORKER" in os.environ else own


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Levels of optimisation change no results, as tests marked `optimised` hold, at the levels of users."""
    short = item.get_closest_marker("short_runs")
    quickly = HARD if item.path.parent.name == "hard" or (short and short.args != (False,)) else FUNCTIONS
    Levels.instead = {} if item.get_closest_marker("optimised") else quickly
    derived_once.begin(item)
    tiny_compiler.begin(item)


@pytest.fixture(scope="session", autouse=True)
def once(common: Path) -> Iterator[None]:
    with pytest.MonkeyPatch.context() as changed:
        changed.setenv("SYMSCREW_CACHE", str(common / "libraries"))
        changed.delenv("COLUMNS", raising=False)  # that of pytest's own workers: in a pipe nobody says how wide
        changed.setattr(compilers, "attempts", Levels(compilers.attempts))
        changed.setattr(compilers, "_compile", tiny_compiler)
        changed.setattr(symscrew.model, "_derived", derived_once)
        yield


@pytest.fixture(scope="session")
def generated(common: Path) -> Callable[..., Path]:
    """The folder that `generate` writes for a mechanism and targets, made once in a run. Copy what is to be changed."""

    def folder(name: str, targets: Sequence[str] = USUAL) -> Path:
        made = common / "generated" / "-".join([name, *targets])
        made.parent.mkdir(exist_ok=True)
        with Lock(made.with_suffix(".lock")):
            if not made.is_dir():
                generate(model(name), made, targets)
        return made

    return folder

"""Settings of all tests. What the folders hold and how they are run stands in README.md beside this file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.once import Libraries

from symscrew.runtime import compiled
from symscrew.simulation import native

UNOPTIMISED = ("-O0",)  # four times faster to compile than -O2, for functions that are called a few times
LOOPS = ("-O1",)  # three times faster than -O3, for runs that take milliseconds


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The folder says it: whatever stands in `tools` needs a tool beyond Python and a C compiler."""
    for item in items:
        if item.path.parent.name == "tools":
            item.add_marker(pytest.mark.tools)


@pytest.fixture(scope="session")
def common(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that all processes of this run of the tests share."""
    own = tmp_path_factory.getbasetemp()
    return own.parent if "PYTEST_XDIST_WORKER" in os.environ else own


@pytest.fixture(scope="session", autouse=True)
def compiled_once(common: Path) -> Iterator[None]:
    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(compiled, "subprocess", Libraries(common / "libraries"))
        yield


@pytest.fixture(scope="module", autouse=True)
def compiled_quickly(request: pytest.FixtureRequest, compiled_once: None) -> Iterator[None]:
    """Levels of optimisation do not change results, as modules marked `optimised` test, at the levels of users.

    Hard cases run for milliseconds, each with a loop of its own: that at -O0 takes half the time.
    """
    marks = getattr(request.module, "pytestmark", [])
    optimised = any(mark.name == "optimised" for mark in (marks if isinstance(marks, list) else [marks]))
    with pytest.MonkeyPatch.context() as changed:
        if not optimised:
            loops = UNOPTIMISED if request.path.parent.name == "hard" else LOOPS
            changed.setattr(compiled, "FLAGS", (*compiled.FLAGS, *UNOPTIMISED))
            changed.setattr(native, "NATIVE_FLAGS", (*native.NATIVE_FLAGS, *loops))
        yield

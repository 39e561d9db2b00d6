"""Settings of all tests."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from symscrew.simulation import native


@pytest.fixture(scope="session", autouse=True)
def compiled_quickly() -> Iterator[None]:
    """Loops of simulations are compiled with -O1: three times faster, for runs that take milliseconds.

    That levels of optimisation do not change results is what test_hard_generated_c tests.
    """
    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(native, "FLAGS", (*native.FLAGS, "-O1"))
        yield

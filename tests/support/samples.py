"""Cases of one class: some in every run of the tests, all of them in the slow one."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def some_quickly(values: Iterable[Any], *, every: int) -> list[Any]:
    """Parameters of a test: the first of every so many as they are, the others marked slow."""
    return [value if k % every == 0 else pytest.param(value, marks=pytest.mark.slow) for k, value in enumerate(values)]

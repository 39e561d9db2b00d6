"""Marks of single cases."""

from __future__ import annotations

from typing import Any

import pytest


def slow(*values: Any) -> Any:
    """A case that is not run by default, since quicker ones hold most of its claim."""
    return pytest.param(*values, marks=pytest.mark.slow)

"""What tests of the studies of accuracy share."""

from __future__ import annotations

from pathlib import Path

import pytest

from symscrew.display.terminal import Progress
from symscrew.runtime.compiled import find_compiler

QUIET = Progress(quiet=True)


EXAMPLES = Path(__file__).parents[2] / "examples" / "benchmarks"


needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: curves of generated C are left out")


def least_error(study, curve: str) -> float:  # type: ignore[no-untyped-def]
    return min(p.error for p in study.curves[curve] if p.error is not None)

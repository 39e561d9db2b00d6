"""A process that ends does not search its objects once more, where somebody asked for that."""

from __future__ import annotations

import subprocess
import sys

import pytest

CYCLE = """
import gc
from symscrew.garbage import none_at_the_end

class Cycle:
    def __del__(self):
        print("searched", flush=True)

gc.disable()
one = Cycle()
one.itself = one
del one
"""


@pytest.mark.parametrize(("asked", "said"), [("", "searched\n"), ("none_at_the_end()\n" * 2, "")])
def test_nobody_searches_at_the_end(asked: str, said: str) -> None:
    ended = subprocess.run(
        [sys.executable, "-c", CYCLE + asked], capture_output=True, text=True, check=True, timeout=60
    )
    assert ended.stdout == said

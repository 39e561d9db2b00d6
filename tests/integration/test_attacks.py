"""Every attack of the table is withstood (`python -m tests.benchmarks attacks` prints it)."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.attacks import ATTACKS, Attack, WorkedError, carry_out, four_bar
from support.samples import some_quickly

from symscrew.runtime import find_compiler

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


@pytest.mark.parametrize("one", some_quickly(ATTACKS, every=24), ids=lambda one: f"{one.target}: {one.name}"[:60])
def test_attacks_are_withstood(one: Attack) -> None:
    four_bar()  # once, of which each attack's process has a copy
    outcome = carry_out(one)
    assert outcome.withstood, outcome.text
    assert outcome.text


def worked(_: Path) -> str:
    raise WorkedError("it did")


def marked(place: Path) -> str:
    (place / "mark").touch()
    return "fine"


def crashed(_: Path) -> str:
    import ctypes

    return str(ctypes.string_at(0))


@pytest.mark.parametrize("work, said", [(worked, "WORKED: it did"), (marked, "ATTACKER RAN"), (crashed, "CRASHED")])
def test_an_attack_that_works_is_seen(work, said: str) -> None:
    outcome = carry_out(Attack("a", "b", work))
    assert not outcome.withstood and said in outcome.text

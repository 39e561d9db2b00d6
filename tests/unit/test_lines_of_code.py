"""Lines and order of printed code: short lines take no detour, instructions come in an order that suits registers."""

from __future__ import annotations

import random
import textwrap

import pytest

from symscrew.export.c_order import alive_along, short_lived, within
from symscrew.export.listing import plain, wrapped
from symscrew.program import Instruction


@pytest.mark.parametrize("width", [12, 40, 100])
def test_lines_that_fit_are_what_wrapping_gives(width: int) -> None:
    letters = random.Random(width)
    for _ in range(500):
        text = "".join(letters.choice('ab1  */\\?"\n\t-x') for _ in range(letters.randrange(2 * width)))
        wrapper = textwrap.TextWrapper(width, "  ", "      ", break_long_words=False, break_on_hyphens=False)
        assert wrapped(text, first="  ", later="      ", width=width) == (wrapper.wrap(plain(text)) or [""])


def program(numbers: random.Random, count: int) -> list[Instruction]:
    """Instructions on five inputs and on each other."""
    found = []
    for k in range(count):
        read = [*range(5), *range(100, 100 + k)]
        found.append(Instruction(100 + k, "add", (numbers.choice(read), numbers.choice([*read, 1.5]))))
    return found


def alive(instructions: list[Instruction]) -> int:
    """The sum over all instructions of how many computed values are read later."""
    at = {i.target: k for k, i in enumerate(instructions)}
    last = {a: k for k, i in enumerate(instructions) for a in i.args if a in at}
    return sum(k - at[int(a)] for a, k in last.items())


def test_values_live_shortly_and_are_there_when_they_are_read() -> None:
    numbers = random.Random(3)
    before = after = 0
    for _ in range(50):
        given = program(numbers, numbers.randrange(1, 60))
        found = short_lived(given)
        assert sorted(found, key=lambda i: i.target) == given
        known: set[int | float] = {*range(5), 1.5}
        for instruction in found:
            assert known.issuperset(instruction.args)
            known.add(instruction.target)
        before, after = before + alive(given), after + alive(found)
    assert after < 0.9 * before


def above(instructions: list[Instruction], most: int) -> int:
    """The sum over all instructions of values above `most` that are read later, inputs from their first use on."""
    total = 0
    for k in range(len(instructions)):
        begun = {a for i in instructions[: k + 1] for a in (i.target, *i.args) if type(a) is int}
        total += max(0, len(begun & {a for i in instructions[k + 1 :] for a in i.args}) - most)
    return total


def test_few_values_are_above_what_registers_hold() -> None:
    """Never more than in the usual order, and that order itself where nothing is above."""
    numbers, before, after = random.Random(4), 0, 0
    for _ in range(40):
        given, most = program(numbers, numbers.randrange(1, 60)), numbers.randrange(3, 12)
        usual, found = short_lived(given), within(given, most)
        assert sorted(found, key=lambda i: i.target) == given
        known: set[int | float] = {*range(5), 1.5}
        for instruction in found:
            assert known.issuperset(instruction.args)
            known.add(instruction.target)
        assert sum(max(0, n - most) for n in alive_along(found)) == above(found, most) <= above(usual, most)
        assert found == usual or above(found, most) < above(usual, most)
        before, after = before + above(usual, most), after + above(found, most)
    assert after < 0.95 * before


def test_limb_after_limb_is_worked_off() -> None:
    """Two limbs whose instructions are mixed: each limb's come together."""
    mixed = [Instruction(10 + k, "mul", (k % 2, 0) if k < 2 else (8 + k, 8 + k)) for k in range(8)]
    last = Instruction(18, "add", (16, 17))
    lanes = [i.target % 2 for i in short_lived([*mixed, last])[:-1]]
    assert lanes in ([0] * 4 + [1] * 4, [1] * 4 + [0] * 4)

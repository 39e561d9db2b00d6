"""Equal instructions one after the other: where a run begins and ends, and where a loop's operands come from."""

from __future__ import annotations

import itertools

from symscrew.export.c_loops import Carried, Local, Loop, Same, Various
from symscrew.export.c_repeats import Run, runs
from symscrew.program.straight_line import Instruction

INPUTS = 130


def recurrence(steps: int) -> list[Instruction]:
    """x <- c x + input[k], and y_k = x_(k-1) x_k: three instructions per step behind two odd ones."""
    count = itertools.count(INPUTS)
    x = next(count)
    made = [Instruction(x, "sqrt", (0,)), Instruction(next(count), "neg", (0,))]
    for k in range(steps):
        product, total, pair = (next(count) for _ in range(3))
        made.append(Instruction(product, "mul", (x, 0.5 + k)))
        made.append(Instruction(total, "add", (product, k)))
        made.append(Instruction(pair, "mul", (x, total)))
        x = total
    return made


def kind(slot: int | float) -> object:
    return "constant" if not isinstance(slot, int) else "input" if slot < INPUTS else "target"


def test_a_recurrence_is_one_run() -> None:
    assert runs(recurrence(39), kind) == [Run(2, 3, 39)]
    assert runs(recurrence(20), kind) == []  # saves less than a run must


def test_operands_of_a_loop_come_from_where_they_are() -> None:
    instructions = recurrence(39)
    loop = Loop(tuple(instructions[2:]), 3)
    (product, factor), (own, entry), (before, total) = loop.sources
    assert product == before == Carried(1, instructions[0].target)
    assert factor == Various(tuple(0.5 + k for k in range(39)))
    assert (own, total) == (Local(0), Local(1))
    assert entry == Various(tuple(range(39)))
    assert list(loop.read_from_arrays()) == []
    assert Loop(tuple(Instruction(k, "neg", (7,)) for k in range(50, 55)), 1).sources == [[Same(7)]]


def test_what_differs_by_kind_is_no_run() -> None:
    instructions = recurrence(120)
    middle = instructions[2 + 3 * 60 + 1]
    assert runs(instructions, kind) == [Run(2, 3, 120)]
    for odd in (
        Instruction(middle.target, "sub", middle.args),  # another operation
        Instruction(middle.target, "add", (middle.args[0], 0.25)),  # a constant for an input
    ):
        found = runs([odd if i is middle else i for i in instructions], kind)
        assert [run.period for run in found] == [3, 3]
        assert found[0].end <= 183 < found[1].start

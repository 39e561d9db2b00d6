"""Programs of a model are lowered when they are asked for, and are the same whichever is asked for first."""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from symscrew import catalogue, model
from symscrew.algebra import Tape, tape_as_at, tape_mark
from symscrew.functions import Assembly
from symscrew.model import Model, derive
from symscrew.program import Iteration, Program, lowering, roots_of
from symscrew.program.passes import PASSES
from symscrew.runtime.origin import origin_of

NAME = "differential"  # passes make the same nodes for several functions of it


def derived() -> Model:
    return derive(catalogue.load(NAME), derivatives=True)


def told(program: Program | Iteration) -> tuple[object, ...]:
    """All that is printed of a program."""
    line = program.step if isinstance(program, Iteration) else program
    return program.hash, line.origins, program.notes, [float(node.value) for node in line.folded]


def contents(tape: Tape) -> tuple[object, ...]:
    nodes = [(node.index, node.op, node.args) for node in tape.nodes]
    return nodes, [(name, list(table.items())) for name, table in tape.tables().items()]


def test_programs_are_the_same_in_any_order_and_whatever_is_on_the_tape_by_then() -> None:
    first, last, later = derived(), derived(), derived()
    names = list(first.programs)
    expected = {name: told(first.programs[name]) for name in names}
    assert {name: told(last.programs[name]) for name in names[::-1]} == expected
    for name in names:  # what passes make of some other functions stays
        declared = later.declared(name)
        roots = roots_of(declared.step if isinstance(declared, Assembly) else declared)[::-1]
        for rewritten in PASSES:
            roots = rewritten(roots)
    before = contents(later.system.tape)
    assert {name: told(later.programs[name]) for name in names[::-1]} == expected
    assert contents(later.system.tape) == before
    assert any(folded for *_, folded in expected.values())  # constants that only a pass has made are told of


def test_nothing_is_lowered_that_nobody_asks_for(monkeypatch: pytest.MonkeyPatch) -> None:
    lowered: list[str] = []

    def counting(function: lowering.Function, mark: object = None) -> Program:
        lowered.append(function.name)
        return lowering.lower(function, mark)

    monkeypatch.setattr(model, "lower", counting)
    found = derive(catalogue.load("four_bar"))
    few = found.only(["velocity", "energy", "rolling_forces"])
    ports = origin_of(found, None, trusted=False, lanes=False).ports
    assert list(few.programs) == ["velocity", "energy"] and ports.keys() == found.programs.keys()
    assert "rolling_forces" not in few.programs and "bias" not in few.programs and "bias" in found.programs
    assert found.test_inputs["bias"][0].shape[-1] == ports["bias"][0][0].size and not lowered
    assert few.programs["energy"] is found.programs["energy"] and lowered == ["energy"]


def test_a_tape_is_as_it_was_and_then_as_it_is() -> None:
    tape = Tape()
    x, y = tape.symbol("x", "1", ""), tape.symbol("y", "1", "")
    mark = tape_mark(tape)
    later = [x * y + 3, x - y, 7 / x]
    now = contents(tape)
    with pytest.raises(ZeroDivisionError), tape_as_at(tape, mark):
        again = x - y
        assert again.index == mark.nodes + 1 and again is not later[1]
        raise ZeroDivisionError  # whatever ends it
    assert contents(tape) == now and x * y + 3 is later[0] and x - y is later[1] and 7 / x is later[2]


def test_threads_may_ask_at_the_same_time() -> None:
    found = derived()
    expected = {name: told(program) for name, program in derived().programs.items()}
    names, before = list(found.programs), sys.getswitchinterval()
    orders = [names[k:] + names[:k] for k in range(0, len(names), len(names) // 4)]
    try:
        sys.setswitchinterval(1e-6)
        with ThreadPoolExecutor(len(orders)) as pool:
            every = list(pool.map(lambda order: {name: told(found.programs[name]) for name in order}, orders))
    finally:
        sys.setswitchinterval(before)
    assert all(programs == expected for programs in every)

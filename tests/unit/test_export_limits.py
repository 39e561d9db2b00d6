"""Both sides of every limit of the printers, seen in the text that they print."""

from __future__ import annotations

import pytest
from support import handmade

from symscrew.algebra import Tape
from symscrew.export import c_batch, c_function, c_parts, c_printed, c_repeats, listing, print_c
from symscrew.export.c_precision import DOUBLE
from symscrew.export.c_printed import RUN, Printed
from symscrew.export.c_repeats import Run, runs
from symscrew.export.c_unread import FOUR, fours
from symscrew.program import Function, Instruction, Port, Program, lower


def program(count: int = 12, zeros: int = 0) -> Program:
    """Sums and products of six inputs, `count` results, and zeros behind them."""
    tape = Tape()
    x = [tape.symbol(f"x{k}", "1", "input") for k in range(6)]
    results, value = [], x[0]
    for k in range(count):
        value = value * x[k % 6] + x[(k + 1) % 6]
        results.append(value)
    size = count + zeros
    ports = Port("x", (6,), ("1",) * 6, (), ""), Port("r", (size,), ("1",) * size, (), "")
    return lower(Function("many", "", ports[:1], ports[1:], (tuple(x),), ((*results, *[tape.zero] * zeros),)))


def source(of: Program) -> str:
    found = handmade.model(many=of)
    return print_c(found)[f"{found.name}.c"]


def test_long_functions_come_in_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    of = program()
    size = len(of.instructions) + c_printed.STORED * 12
    for limit, parts in ((size, 0), (size - 1, 1)):
        monkeypatch.setattr(c_printed, "LONG", limit)
        assert source(of).count("_many_part0(const") == parts
        assert ("_many_block)" in source(of)) == (not parts)
    monkeypatch.setattr(c_parts, "PART", 6)
    assert source(of).count("_many_part3(const") == 1
    monkeypatch.setattr(c_printed, "LONG", size)
    monkeypatch.setattr(c_printed, "STORED", c_printed.STORED + 1)
    assert source(of).count("_many_part0(const") == 1


def test_large_blocks_would_take_too_much_of_the_stack(monkeypatch: pytest.MonkeyPatch) -> None:
    of = program()
    for limit, printed in ((18, True), (17, False)):
        monkeypatch.setattr(c_batch, "MOST_ENTRIES", limit)
        assert ("_many_block)" in source(of)) == printed


def test_few_states_are_taken_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    assert f"if (some > {c_batch.FEW} &&" in source(program())
    monkeypatch.setattr(c_batch, "FEW", 5)
    assert "if (some > 5 &&" in source(program())


@pytest.mark.parametrize(("zeros", "loops"), [(RUN - 1, 0), (RUN, 1)])
def test_many_zeros_are_written_by_a_loop(zeros: int, loops: int) -> None:
    of = program(4, zeros)
    assert len(Printed("m", "m_many", of, DOUBLE).cleared) == loops
    assert source(of).count("handmade_zero(r + 4, ") == loops
    assert (f"WRITE(r, {3 + zeros}, CONSTANT(0.0));" in source(of)) == (not loops)


@pytest.mark.parametrize("zeros", [RUN - 1, RUN])
def test_an_output_of_zeros_that_are_there_already_is_not_read(zeros: int) -> None:
    """Rates of a closed chain without a freedom: the body has nothing to write, and compilers warn of that."""
    assert ("(void)r;" in source(program(0, zeros))) == (zeros == RUN)


def test_what_must_be_finite_is_summed_side_by_side(monkeypatch: pytest.MonkeyPatch) -> None:
    of = program()
    assert len(of.checked) < c_function.SUMS or "checked3" in source(of)
    monkeypatch.setattr(c_function, "SUMS", 1)
    assert "checked1" not in source(of)


@pytest.mark.parametrize(("size", "left_out"), [(listing.MAX_LABELS, False), (listing.MAX_LABELS + 1, True)])
def test_labels_of_long_ports_stand_in_the_manifest(size: int, left_out: bool) -> None:
    port = Port("x", (size,), ("m",) * size, tuple(f"l{k}" for k in range(size)), "entries")
    assert ("all labels are in manifest.json" in "\n".join(listing.port_lines(port))) == left_out


@pytest.mark.parametrize(("entries", "firsts"), [(2 * FOUR, 2), (2 * FOUR - 1, 0)])
def test_inputs_that_are_only_checked_come_in_several_fours(entries: int, firsts: int) -> None:
    found, others = fours({k: ("q", k) for k in range(entries)}, range(entries))
    assert len(found) == firsts and len(others) == entries - firsts * FOUR


def chain(count: int, period: int, back: int = 1) -> list[Instruction]:
    """`count` times a sum and products, each reading what stands `back` before it."""
    kinds = ["add", *["mul"] * (period - 1)]
    return [Instruction(1000 + k, kinds[k % period], (1000 + k - back, k % 7)) for k in range(count * period)]


def of_kind(slot: int | float) -> object:
    return "input" if isinstance(slot, int) and slot < 1000 else ""


@pytest.mark.parametrize(
    ("limit", "value", "found"),
    [
        ("SAVED", 100, True),
        ("SAVED", 300, False),
        ("SEVERAL", 29, True),
        ("SEVERAL", 31, False),
        ("FARTHEST", 10, True),
        ("FARTHEST", 9, False),
        ("WINDOW", 6, True),
        ("WINDOW", 400, False),
    ],
)
def test_short_runs_are_written_out(limit: str, value: int, found: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Thirty times ten instructions, the very first of which reads an input."""
    monkeypatch.setattr(c_repeats, limit, value)
    assert runs(chain(30, 10), of_kind) == ([Run(1, 10, 29)] if found else [])


def test_operands_from_far_back_need_not_be_equally_far(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twice as far back in every second iteration: alike only if both are beyond `NEAR`."""
    body = chain(40, 10)
    body = [
        Instruction(i.target, i.op, (i.args[0] - (10 + k // 10 % 2 * 10) if i.op == "add" else i.args[0], i.args[1]))
        for k, i in enumerate(body)
    ]
    periods = {}
    for near in (5, 60):
        monkeypatch.setattr(c_repeats, "NEAR", near)
        periods[near] = {run.period for run in runs(body, of_kind)}
    assert periods == {5: {10}, 60: {20}}

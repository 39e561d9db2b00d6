"""Limits of lanes: what they leave out is done one by one, and all numbers stay."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from support.packed_numbers import evaluated

from symscrew.algebra import Node, Tape
from symscrew.export import c_printed
from symscrew.export.c_precision import DOUBLE
from symscrew.export.c_printed import Printed
from symscrew.program import (
    Function,
    Instruction,
    Limb,
    Limbs,
    Packing,
    Port,
    Program,
    evaluate,
    lower,
    packed,
    stages_of_limbs,
)
from symscrew.program.lanes import lane_signs, limb_lanes, limb_rows, pack_plan, packs
from symscrew.program.lanes.corresponding import Corresponding
from symscrew.program.lanes.pack_plan import Plan
from symscrew.program.lanes.signed_operations import signed

LEGS = 4


def program(legs: int = LEGS) -> Program:
    """Legs that do the same with other data, mirrored, and what all of them say together."""
    tape = Tape()
    shared = [tape.symbol(f"s{k}", "1", "input") for k in range(3)]
    own = [[tape.symbol(f"x{k}_{n}", "1", "input") for n in range(4)] for k in range(legs)]
    total: Node = tape.zero
    for k, (a, b, c, d) in enumerate(own):
        sign = 1 if k % 2 else -1
        reach = [shared[0] + sign * a, shared[1] * b - sign * c, shared[2] + d * a]
        length = tape.sqrt(reach[0] * reach[0] + reach[1] * reach[1] + reach[2] * reach[2])
        along = [(r + sign * a * b) / length for r in reach]
        for _ in range(6):
            along = [along[1] * c + d, along[2] * b - a, along[0] * d + sign * b]
        total = total + along[0] * along[1] / (along[2] * length)
    flat = [*shared, *(x for leg in own for x in leg)]
    labels = (*(f"hub.{k}" for k in range(3)), *(f"leg{k}.{n}" for k in range(legs) for n in range(4)))
    ports = Port("q", (len(flat),), ("1",) * len(flat), labels, ""), Port("y", (1,), ("1",), (), "")
    equal = Limbs((tuple(Limb(f"leg{k}", {f"leg{k}": "link"}) for k in range(legs)),))
    return lower(Function("legs", "", ports[:1], ports[1:], (tuple(flat),), ((total,),), limbs=equal))


def found(of: Program) -> Packing | None:
    results = [s for s in of.results[0] if isinstance(s, int)]
    return packed(Corresponding(of.instructions, origins=of.origins, limbs=of.limbs), results, of.checked)


def check_numbers(of: Program, packing: Packing) -> None:
    state = np.random.default_rng(3).uniform(1, 2, of.inputs[0].size)
    (slot,) = of.results[0]
    assert isinstance(slot, int)
    (expected,), _ = evaluate(of, [state])
    assert evaluated([slot], packing, state.tolist()) == expected.tolist()


def test_legs_are_found() -> None:
    of = program()
    packing = found(of)
    assert packing is not None and packing.width == LEGS and len(packing.items) < 0.5 * len(of.instructions)
    check_numbers(of, packing)


@pytest.mark.parametrize(
    ("module", "name", "limit"),
    [
        (packs, "MOST_LANES", LEGS - 1),
        (packs, "HOPELESS", 0.0),
        (packs, "LIKELY", 0.0),
        (packs, "NEAR", 0.0),
        (packs, "ENOUGH", 0.0),
    ],
)
def test_beyond_a_limit_nothing_is_packed(
    module: ModuleType, name: str, limit: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, name, limit)
    assert found(program()) is None


@pytest.mark.parametrize(
    ("module", "name", "limit"),
    [
        (limb_lanes, "ROUNDS", 1),
        (limb_rows, "MOST_ALIKE", 1),
        (limb_rows, "ALONE", 1),
        (limb_rows, "AMONG", 1),
        (limb_rows, "HINT", 0),
        (packs, "HOPELESS", 9.0),
        (packs, "LIKELY", 9.0),
        (packs, "NEAR", 9.0),
        (packs, "HARDLY", 0.0),
        (packs, "HARDLY", 9.0),
        (pack_plan, "ROUNDS_OF_UNDOING", 0),
        (pack_plan, "GATHERED", 0.1),
        (pack_plan, "TAKEN_OUT", 9.0),
        (lane_signs, "ROUNDS", 0),
    ],
)
def test_with_other_limits_the_numbers_are_the_same(
    module: ModuleType, name: str, limit: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, name, limit)
    of = program()
    packing = found(of)
    assert packing is not None
    check_numbers(of, packing)


def families(*chosen: tuple[int, ...]) -> Corresponding:
    """The legs with these families of equal ones."""
    of = program()
    (legs,) = of.limbs.families
    limbs = Limbs(tuple(tuple(legs[k] for k in some) for some in chosen))
    return Corresponding(of.instructions, origins=of.origins, limbs=limbs)


def test_legs_that_cannot_save_as_much_as_others_are_not_looked_through() -> None:
    """Of two legs stages save one operation a row, of all four three: rows of two are too few, whatever they are."""
    found = families((0, 1), (0, 1, 2, 3))
    two, four = (next(r for r in found.readings(8) if len(r.family) == n) for n in (2, 4))
    stages = stages_of_limbs(found, [], {}, {})
    assert stages is not None and len(stages.limbs) == 4
    assert "rows" in four.__dict__ and "rows" not in two.__dict__
    assert 0 < len(two.whole) <= two.most < 3 * len(four.whole) <= 3 * four.most


@pytest.mark.parametrize("chosen", [((0, 1, 2, 3), (3, 2, 1, 0)), ((3, 2, 1, 0), (0, 1, 2, 3))])
def test_of_families_that_save_the_same_the_first_is_taken(chosen: tuple[tuple[int, ...], ...]) -> None:
    stages = stages_of_limbs(families(*chosen), [], {}, {})
    assert stages is not None
    assert [limb.name for limb in stages.limbs] == [f"leg{k}" for k in chosen[0]]


def moved(*, roots: bool) -> Program:
    """Legs between what a pose and a rate of the hub give: geometry, with a root of its own or without, then rates."""
    tape = Tape()
    pose, rates = ([tape.symbol(f"{name}{k}", "1", "input") for k in range(3)] for name in "pr")
    own = [[tape.symbol(f"x{k}_{n}", "1", "input") for n in range(3)] for k in range(LEGS)]
    at, speed = ([x * y for x, y in zip(some, some[1:] + some[:1], strict=True)] for some in (pose, rates))
    results: list[Node] = []
    for data in own:
        reach = [a + x for a, x in zip(at, data, strict=True)]
        square = reach[0] * reach[0] + reach[1] * reach[1] + reach[2] * reach[2]
        along = [r / (tape.sqrt(square) if roots else square) for r in reach]
        rate = [a + s * x for a, s, x in zip(along, speed, data, strict=True)]
        results += [rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2], (rate[0] * rate[1] + rate[2]) * along[0]]
    labels = (*(f"hub.{k}" for k in range(3)), *(f"leg{k}.{n}" for k in range(LEGS) for n in range(3)))
    told = {"pose": labels, "rate": labels[:3]}
    inputs = [Port(name, (len(some),), ("1",) * len(some), some, "") for name, some in told.items()]
    output = Port("y", (len(results),), ("1",) * len(results), (), "")
    given = (*pose, *(x for leg in own for x in leg)), tuple(rates)
    equal = Limbs((tuple(Limb(f"leg{k}", {f"leg{k}": "link"}) for k in range(LEGS)),))
    return lower(Function("legs", "", tuple(inputs), (output,), given, (tuple(results),), limbs=equal))


@pytest.mark.parametrize(("roots", "inputs", "early"), [(True, 2, True), (False, 2, False), (True, 1, False)])
def test_roots_of_all_limbs_begin_before_the_rates_of_the_first(roots: bool, inputs: int, early: bool) -> None:
    """Where limbs take roots, and the hub has more than coordinates, these come in a stage of their own."""
    of = moved(roots=roots)
    slots = [k for k, port in enumerate(of.inputs) for _ in range(port.size)]
    ports = {slot: min(k, inputs - 1) for slot, k in enumerate(slots)}
    found = Corresponding(of.instructions, origins=of.origins, limbs=of.limbs)
    stored = [s for s in of.results[0] if isinstance(s, int)]
    stages = stages_of_limbs(found, stored, {}, ports)
    assert stages is not None
    assert (stages.early, len(stages.stages)) == (early, 1 + early)
    with_roots = {row.stage for row in stages.rows if row.op == "sqrt"}
    assert with_roots == ({0} if roots else set())


def test_more_lanes_than_a_vector_holds_take_several() -> None:
    of = program(6)
    packing = found(of)
    assert packing is not None and packing.width in pack_plan.WIDTHS
    check_numbers(of, packing)


@pytest.mark.parametrize(("gathered", "kept"), [(0.0, 1), (0.2, 1), (0.4, 0), (1.5, 0)])
def test_packs_that_do_not_pay_are_undone(gathered: float, kept: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Four products of inputs: one in place of four operations, and eight entries to gather."""
    monkeypatch.setattr(pack_plan, "GATHERED", gathered)
    monkeypatch.setattr(pack_plan, "TAKEN_OUT", 0.0)
    operations, _ = signed([Instruction(8 + k, "mul", (k, 4 + k)) for k in range(4)])
    plan = Plan(pack_plan.Code(operations, set(operations)), (tuple(operations),))
    assert plan.cost == pytest.approx(1 + 8 * gathered)
    plan.improve()
    assert sum(plan.on) == kept and plan.cost == pytest.approx(min(1 + 8 * gathered, 4))


@pytest.mark.parametrize(
    ("name", "value"), [("PACKED", range(1, 100)), ("PACKED", range(5000, 6000)), ("PER_OUTPUT", 10**6)]
)
def test_functions_of_other_sizes_are_printed_one_by_one(
    name: str, value: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    of = program()
    assert len(of.instructions) in c_printed.PACKED
    assert Printed("model", "model_legs", of, DOUBLE, lanes=True).packing is not None
    monkeypatch.setattr(c_printed, name, value)
    assert Printed("model", "model_legs", of, DOUBLE, lanes=True).packing is None

"""Statements of generated code: what is folded into its reader, and what values are called."""

from __future__ import annotations

import keyword
import re
from collections import Counter
from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest
from support import handmade
from support.model_states import model

from symscrew.algebra import Origin, apply_numpy
from symscrew.export.c_names import TAKEN, TOGETHER, grouped
from symscrew.export.folding import OPERATIONS, WIDTH, folded
from symscrew.export.lane_names import vector_name
from symscrew.export.numpy import TABLE, print_numpy
from symscrew.export.value_names import LONGEST, identifier, value_names
from symscrew.program import Instruction, Iteration, Program

LOOSER = {"add": 1, "sub": 1, "mul": 2, "div": 2}


def printed(order: list[Instruction], results: tuple[int, ...], places: dict[int, str] | None = None) -> list[str]:
    """Statements, x7 for slot 7; results are read once more than instructions read them."""
    uses = Counter(a for i in order for a in i.args if isinstance(a, int))
    uses.update(results)
    read = {a for i in order for a in i.args}
    found = folded(
        order, uses, TABLE, name=lambda value: f"x{value}", places=places or {}, ends=lambda slot: slot not in read
    )
    return [f"{item.kind} x{item.slot} = {item.text}" for item in found]


@pytest.mark.parametrize("outer", LOOSER)
@pytest.mark.parametrize("inner", LOOSER)
def test_parentheses_keep_the_association(outer: str, inner: str) -> None:
    """a op (b op c) and (a op b) op c: parentheses wherever Python would take them together otherwise."""
    for position in (0, 1):
        args = (3, 2) if position == 0 else (2, 3)
        (text,) = printed([Instruction(3, inner, (0, 1)), Instruction(4, outer, args)], (4,))
        needed = LOOSER[inner] < LOOSER[outer] or (position == 1 and LOOSER[inner] == LOOSER[outer])
        assert ("(" in text) == needed, text


def test_neighbours_are_folded_and_nothing_moves_across_another_statement() -> None:
    a, b = Instruction(3, "mul", (0, 1)), Instruction(4, "mul", (1, 2))
    assert printed([a, b, Instruction(5, "add", (3, 4))], (5,)) == ["last x5 = x0 * x1 + x1 * x2"]
    twice = Instruction(6, "add", (0, 0))  # has two readers, so it is a statement between
    order = [a, twice, Instruction(7, "mul", (6, 6)), Instruction(8, "add", (3, 7))]
    assert printed(order, (8,)) == ["named x3 = x0 * x1", "named x6 = x0 + x0", "last x8 = x3 + x6 * x6"]


def test_what_is_read_once_is_read_in_place() -> None:
    order = [Instruction(3, "mul", (0, 1)), Instruction(4, "add", (3, 1))]
    places = {0: "q[0]", 1: "q[1]"}
    assert printed(order, (4,), places) == ["read x1 = ", "last x4 = q[0] * x1 + x1"]


def test_statements_stay_short() -> None:
    """A sum of products that are read once each: no statement of more operations, or wider, than fits a line."""
    order, last = [Instruction(100, "mul", (0, 1))], 100
    for k in range(60):
        order += [Instruction(2 * k + 101, "mul", (k % 3, 1)), Instruction(2 * k + 102, "add", (last, 2 * k + 101))]
        last = 2 * k + 102
    texts = [text.split(" = ")[1] for text in printed(order, (last,))]
    counts = [len(re.findall(r" [-+*/] ", text)) for text in texts]
    assert sum(counts) == len(order) and max(counts) <= OPERATIONS and len(texts) < len(order) / 3
    assert max(map(len, texts)) < WIDTH + 20


def of_evaluator(op: str, *operands: object) -> object:
    return apply_numpy(op, operands)


@pytest.mark.parametrize("found", [handmade.model(), model("four_bar")], ids=["handmade", "four_bar"])
def test_folded_statements_give_the_same_bits(found: object) -> None:
    """With the evaluator's own sines: those of NumPy differ in the last place."""
    module: dict[str, object] = {}
    (text,) = print_numpy(found).values()  # type: ignore[arg-type]
    exec(compile(text, "module", "exec"), module)
    own = {name: partial(of_evaluator, op) for op, name in (("sin", "sin"), ("cos", "cos"), ("tan", "tan"))}
    own |= {"arctan2": partial(of_evaluator, "atan2"), "exp": partial(of_evaluator, "exp")}
    module["np"] = SimpleNamespace(**{**vars(np), **own})
    for name, program in found.programs.items():  # type: ignore[attr-defined]
        if not isinstance(program, Iteration):
            states = found.test_inputs[name]  # type: ignore[attr-defined]
            got, expected = module[name](*states), found(name, *states)  # type: ignore[operator]
            assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(got[0], expected[0], strict=True)), name
            assert np.array_equal(got[1], np.atleast_1d(expected[1]))


def all_programs() -> list[Program]:
    programs = (*model("four_bar").programs.values(), *handmade.model().programs.values())
    return [p.step if isinstance(p, Iteration) else p for p in programs]


def test_names_are_identifiers_of_their_own() -> None:
    for program in all_programs():
        names = value_names(program, TAKEN)
        assert len(set(names.values())) == len(names)
        assert not set(names.values()) & TAKEN
        for name in names.values():
            assert re.fullmatch(r"[A-Za-z]\w*_\w*|t\d+", name, re.ASCII) and not keyword.iskeyword(name)


def test_names_say_what_a_value_is() -> None:
    assert identifier(Origin("omega", "limb1_arm", "x")) == "limb1_arm_omega_x"
    assert identifier(Origin("force", "platform", "force_z")) == "platform_force_z"
    assert identifier(Origin("force", "platform", "moment_z")) == "platform_moment_z"
    assert identifier(Origin("twist", "arm", "angular_x")) == "arm_twist_wx"
    assert identifier(Origin("momentum_rate", "arm", "moment_y")) == "arm_rate_my"
    assert identifier(Origin("momentum", "arm", "moment_y")) == "arm_momentum_Ly"
    assert identifier(Origin("cos", "limb1_U.0", negative=True)) == "minus_limb1_U_0_cos"
    assert identifier(Origin("balance", "hub", "wy", by="limb4_P")) == "hub_balance_wy_by_limb4_P"


@pytest.mark.parametrize("part", ["int", "lambda", "sin", "NAN", "0", "", "x-y", "é", "__", "t7"])
def test_odd_parts_become_names_all_the_same(part: str) -> None:
    assert re.fullmatch(r"[A-Za-z]\w*_\w*", identifier(Origin(part)), re.ASCII)
    assert re.fullmatch(r"[A-Za-z]\w*_\w*", identifier(Origin("u", part)), re.ASCII)


@pytest.mark.parametrize(("letters", "kept"), [(LONGEST - 8, True), (LONGEST - 7, False)])
def test_long_names_give_way(letters: int, kept: bool) -> None:
    program = next(p for p in all_programs() if p.instructions)
    slot = program.instructions[0].target
    program = replace(program, origins={slot: Origin("omega", "p" * letters, "x")})
    assert len(identifier(program.origins[slot])) == letters + 8
    assert (value_names(program, ())[slot][0] == "p") == kept


def test_declarations_of_one_type_are_one_statement_and_nothing_is_lost() -> None:
    reads = [f"const REAL a_{k} = READ(q, {k});" for k in range(9)]
    other = ["/* limb2 */", "REAL checked0 = a_1;", "const double c_1 = -pack3[1];", "RESULT(checked0, u, 0, a_1);"]
    said = "const REAL b_1 = (a_1 * (a_2 + a_3)); /* limb1 */"
    found = grouped([*reads, said, reads[0], *other, reads[1]])
    assert max(map(len, found)) <= TOGETHER + 1 and found[-5:-1] == other and found[-1] == reads[1]
    own = " ".join(found[:-5])
    assert own.count("const REAL") == 1 and own.endswith(";") and own.count(";") == 1
    assert found[-6].endswith("a_0 = READ(q, 0);") and found[-7].endswith(" /* limb1 */")  # nothing behind a comment
    parts = re.split(r", (?:/\* limb1 \*/)? *(?=[ab]_\d = )", own.removeprefix("const REAL ").removesuffix(";"))
    assert parts == [text[11:].partition(";")[0] for text in (*reads, said, reads[0])]


@pytest.mark.parametrize(
    ("lanes", "name"),
    [
        ([("limb1_arm_x", 1), ("limb2_arm_x", 1)], "limb_arm_x"),
        ([("minus_limb1_arm_x", -1), ("limb2_arm_x", 1)], "limb_arm_x"),
        ([("minus_limb1_arm_x", 1), ("limb2_arm_x", -1)], "minus_limb_arm_x"),
        ([("minus_limb1_arm_x", 1), ("limb2_arm_x", 1)], "signed_limb_arm_x"),
        ([("t4", 1), ("limb2_arm_x", 1), ("limb3_arm_y", 1)], "each_limb2_arm_x"),
        ([("t4", 1), ("t5", 1)], ""),
        ([("limb1_" + "p" * LONGEST, 1), ("limb2_" + "p" * LONGEST, 1)], ""),
        ([], ""),
    ],
)
def test_vectors_are_called_by_what_is_in_their_lanes(lanes: list[tuple[str, int]], name: str) -> None:
    assert vector_name(lanes) == name

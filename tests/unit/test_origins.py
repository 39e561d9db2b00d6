"""Where values come from: names that the derivation gives to nodes, and that passes and lowering hand on."""

from __future__ import annotations

from dataclasses import replace

import pytest
from support.model_states import model

from symscrew import catalogue
from symscrew.algebra import QUANTITIES, Node, Origin, Tape, handed_on, named, named_vector
from symscrew.algebra import substitute as substituted
from symscrew.description import MechanismBuilder
from symscrew.kinematics import spanning_tree
from symscrew.kinematics.limb_symmetry import equal_limbs
from symscrew.program import Function, Limbs, Port, Program, lower


def inputs(tape: Tape) -> tuple[Node, Node, Node]:
    x, y, z = (tape.symbol(name, "1", "input") for name in "xyz")
    return x, y, z


def function(tape: Tape, *results: Node) -> Function:
    labels = tuple(f"joint{k}" for k in range(len(results)))
    ports = Port("x", (3,), ("1",) * 3, ("a", "b.c", "d|e"), ""), Port("r", (len(results),), (), labels, "")
    return Function("f", "", ports[:1], ports[1:], (inputs(tape),), (results,))


def test_the_first_name_stays_and_a_negative_belongs_to_its_inner_node() -> None:
    tape = Tape()
    x, y, _ = inputs(tape)
    assert named(-(x * y), "omega", "arm", "z") is -(x * y)
    named(x * y, "alpha", "arm", "z")
    assert tape.origins == {(x * y).index: Origin("omega", "arm", "z", negative=True)}


def test_what_is_no_operation_of_a_tape_is_not_named() -> None:
    tape = Tape()
    x, *_ = inputs(tape)
    vector = (0, tape.constant(3), x + x)
    assert named_vector(vector, "offset", "arm") is vector
    assert tape.origins == {(x + x).index: Origin("offset", "arm", "z")}
    assert named(1.5, "offset") == 1.5


def test_a_node_that_stands_for_another_takes_its_name_with_the_sign() -> None:
    tape = Tape()
    x, y, z = inputs(tape)
    named(x + y, "omega", "arm")
    handed_on(x + y, -(x * z))
    assert tape.origins[(x * z).index] == Origin("omega", "arm", negative=True)
    handed_on(-(x + y), y * z)
    assert tape.origins[(y * z).index] == Origin("omega", "arm", negative=True)
    handed_on(z * z, x * x)
    assert (x * x).index not in tape.origins


def test_substitution_and_passes_hand_names_on() -> None:
    tape = Tape()
    x, y, z = inputs(tape)
    total = named(x * y + x * z, "force", "arm")
    (other,) = substituted(tape, [total], {z: x})
    assert tape.origins[other.index] == Origin("force", "arm")
    program = lower(function(tape, total))
    assert [(i.op, program.origins.get(i.target)) for i in program.instructions] == [
        ("add", None),
        ("mul", Origin("force", "arm")),  # x (y + z), one product fewer
    ]


def test_programs_know_inputs_and_results_by_their_ports_and_the_rest_by_the_theory() -> None:
    tape = Tape()
    x, y, z = inputs(tape)
    difference = named(x - y, "omega", "arm")
    program = lower(function(tape, -difference, difference * z))
    assert program.origins == {
        0: Origin("x", "a"),
        1: Origin("x", "b", "c"),
        2: Origin("x", "d", "", "e"),
        3: Origin("omega", "arm"),
        4: Origin("omega", "arm", negative=True),
        5: Origin("r", "joint1"),
    }
    # a name changes nothing: neither what is equal, nor what is printed of it
    plain = replace(program, origins={}, limbs=Limbs())
    assert plain == program and plain.hash == program.hash and repr(plain) == repr(program)


def longest_without_name(program: Program) -> int:
    """Operations in the longest chain of values that have no name."""
    length: dict[int | float, int] = {}
    for instruction in program.instructions:
        before = max((length.get(arg, 0) for arg in instruction.args), default=0)
        length[instruction.target] = 0 if instruction.target in program.origins else before + 1
    return max(length.values(), default=0)


@pytest.mark.parametrize(
    ("function", "share", "most"), [("inverse_dynamics", 0.35, 8), ("bias", 0.35, 8), ("body_twists", 0.5, 4)]
)
def test_names_are_close_together(function: str, share: float, most: int) -> None:
    program = model("four_bar").programs[function]
    assert isinstance(program, Program)
    named_ones = sum(i.target in program.origins for i in program.instructions)
    assert named_ones >= share * len(program.instructions)
    assert longest_without_name(program) <= most


def test_quantities_of_the_theory_are_in_the_vocabulary() -> None:
    tape = model("four_bar").system.tape
    assert {origin.quantity for origin in tape.origins.values()} <= set(QUANTITIES)


def test_parts_are_those_of_the_description() -> None:
    found = model("four_bar")
    mechanism = found.mechanism
    parts = {origin.part for origin in found.programs["inverse_dynamics"].origins.values()}
    assert {"crank", "coupler", "rocker"} <= parts <= {*mechanism.bodies, *mechanism.joints}


def limbs_of(name: str) -> Limbs:
    mechanism = catalogue.load(name)
    return equal_limbs(spanning_tree(mechanism), mechanism.platform)


def names(limbs: Limbs) -> list[list[str]]:
    return [[limb.name for limb in family] for family in limbs.families]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("three_ups_upu_s", [[f"limb{k}" for k in range(1, 5)]]),
        ("stewart_6ups", [[f"leg{k}" for k in range(1, 7)]]),
        ("planar_3rrr", [[f"limb{k}" for k in range(1, 4)]]),
        ("sarrus", [["l0", "l1"]]),
        ("delta", [["arm1", "arm2", "arm3"], [f"rod{k}{c}" for k in (1, 2, 3) for c in "ab"]]),
        ("ur5", []),
    ],
)
def test_limbs_are_found_from_the_tree(name: str, expected: list[list[str]]) -> None:
    assert names(limbs_of(name)) == expected


def test_corresponding_parts_have_one_role() -> None:
    first, *others = limbs_of("three_ups_upu_s").families[0]
    for other in others:
        assert sorted(other.parts.values()) == sorted(first.parts.values())
    assert first.parts["limb1_lower"] == others[2].parts["limb4_lower"] != first.parts["limb1_upper"]
    assert first.parts["limb1_U2"] == others[0].parts["limb2_S"]  # that limb 1 ends otherwise shows in its code
    limbs = limbs_of("three_ups_upu_s")
    assert limbs.limb_of("limb3_U") == others[1] and limbs.limb_of("platform") is None


def test_branches_inside_of_limbs_are_a_family_over_all_of_them() -> None:
    """A hand of three fingers on each of two arms, and a head that is alone."""
    builder = MechanismBuilder("twins")
    builder.body("head")
    builder.joint("neck", "S", parent="base", child="head", point=(0, 0, 1))
    for side, x in (("left", -1), ("right", 1)):
        builder.body(f"{side}_arm")
        arm, across = f"{side}_arm", [(0, 1, 0)]
        builder.joint(f"{side}_shoulder", "R", parent="base", child=arm, point=(x, 0, 0), axes=across)
        for k in range(3):
            builder.body(f"{side}_finger{k}")
            finger, point = f"{side}_finger{k}", (2 * x, k, 0)
            builder.joint(f"{side}_knuckle{k}", "R", parent=arm, child=finger, point=point, axes=across)
    limbs = equal_limbs(spanning_tree(builder.build()), None)
    assert names(limbs) == [["left", "right"], [f"{s}_finger{k}" for s in ("left", "right") for k in range(3)]]
    assert limbs.limb_of("right_finger1") is limbs.families[0][1]

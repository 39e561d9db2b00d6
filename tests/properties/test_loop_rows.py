"""Ways to the same rates and accelerations: whichever is printed, the others must give the same numbers."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest
from support.invented_mechanisms import invented
from support.marks import slow

from symscrew import catalogue
from symscrew.algebra.nodes import Node, Tape
from symscrew.algebra.traversal import count_operations
from symscrew.description import MechanismBuilder, toml_file
from symscrew.dynamics.coriolis import still_forces
from symscrew.dynamics.free_motion import Admissible
from symscrew.dynamics.tree_dynamics import generalised_forces, in_joint_rates, mass_matrix
from symscrew.effects import ViscousFriction
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.functions.forward import driven
from symscrew.kinematics.system import System
from symscrew.loops.closure import closure_by
from symscrew.loops.dependent_rates import Loops
from symscrew.loops.limbs.closed_forms import closed_limbs, hub_links, limb_coordinates
from symscrew.model import derive
from symscrew.program.passes.reciprocals import shared_reciprocals

pytestmark = pytest.mark.slow

FRICTION = {"ur5": "shoulder_pan_joint", "three_ups_upu_s_physical": "limb1_P"}
NAMES = ("three_ups_upu_s_physical", "stewart_6ups", "delta", "planar_3rrr", "sarrus", "andrews", "carried")


CARRIED = """
[mechanism]
name = "carried"
ground = "base"

[bodies]
head = {mass = 2, com = [0, 0, "1/10"], inertia = [["1/50", 0, 0], [0, "1/50", 0], [0, 0, "1/80"]]}
crank = {mass = "0.5", com = [0, 0, "3/40"], inertia = [["1/900", 0, 0], [0, "1/900", 0], [0, 0, "1/9000"]]}
coupler = {mass = "0.7", com = ["1/5", 0, "3/10"], inertia = [["1/90", 0, 0], [0, "1/40", 0], [0, 0, "1/60"]]}
rocker = {mass = "0.6", com = ["13/25", 0, "9/40"], inertia = [["1/50", 0, 0], [0, "1/40", 0], [0, 0, "1/90"]]}

[joints]
neck = {type = "S", parent = "base", child = "head", point = [0, 0, 0]}
A = {type = "R", parent = "head", child = "crank", point = [0, 0, 0], axes = [[0, 1, 0]], driven = true}
B = {type = "R", parent = "crank", child = "coupler", point = [0, 0, "3/20"], axes = [[0, 1, 0]]}
C = {type = "R", parent = "coupler", child = "rocker", point = ["2/5", 0, "9/20"], axes = [[0, 1, 0]]}
D = {type = "R", parent = "head", child = "rocker", point = ["16/25", 0, 0], axes = [[0, 1, 0]]}
"""
"""A four-bar on a head that turns about a point."""


@cache
def system_of(name: str) -> System:
    system = System(toml_file.parse_description(CARRIED) if name == "carried" else catalogue.load(name))
    system.use_samples()
    return system


@cache
def loops_of(name: str, by_contacts: bool) -> Loops:
    system = system_of(name)
    return Loops(
        system, closure=closure_by(system, ("seen", "contacts", "plain") if by_contacts else ("seen", "plain"))
    )


def sampled(system: System, nodes: Sequence[Node]) -> np.ndarray:
    """Values at the sample states, shape (nodes, states)."""
    count = len(system.sample_states[0])
    return np.array([np.broadcast_to(system.tape.sample(node), (count,)) for node in nodes])


def same(system: System, first: Sequence[Node], second: Sequence[Node], tolerance: float = 1e-11) -> None:
    """Equal at all samples where the reference is not singular, relative to the largest number."""
    x, y = sampled(system, first), sampled(system, second)
    good = np.isfinite(x).all(axis=0) & np.isfinite(y).all(axis=0)
    assert good[1:].all() and np.abs(x).max() > 0
    assert np.abs(x - y)[:, good].max() < tolerance * np.abs(x[:, good]).max()


def given_drives(system: System, effects: Sequence[Effect]):  # type: ignore[no-untyped-def]
    acting, drives = driven(system, effects)
    count = len(system.sample_states[0])
    nodes = drives[0][1] if drives else ()
    system.tape.add_samples({node: np.linspace(0.5, 2.0, count) * (k + 1) for k, node in enumerate(nodes)})
    return acting


@pytest.mark.parametrize("name", [slow(name) if name == "stewart_6ups" else name for name in NAMES])
def test_rates_and_bias_do_not_depend_on_the_form_of_the_rows(name: str) -> None:
    system, plain, contacts = system_of(name), loops_of(name, False), loops_of(name, True)
    assert plain.free == contacts.free and plain.rank == contacts.rank
    zero, free = [system.tape.zero] * len(system.jacobian), [system.inputs.v[k] for k in plain.free]
    same(system, plain.dependent(zero, free), contacts.dependent(zero, free))
    rates = system.bias(system.rates([system.tape.zero] * len(system.tree.v)))
    same(system, rates, plain.bias(system), 1e-9)
    same(system, rates, contacts.bias(system), 1e-9)


def test_the_rows_of_a_free_hub_s_limbs_ask_for_one_component_each() -> None:
    """Stewart platform: a leg's rate, and what its tip's velocity has along one axis of the leg."""
    rows = loops_of("stewart_6ups", True).rows[:18]
    assert all(len(row) == 2 for row in rows)
    assert all(len(row) > 5 for row in loops_of("stewart_6ups", False).rows[:18])


@pytest.mark.parametrize("by_contacts", [False, True])
def test_a_loop_on_a_moving_body_does_not_see_how_that_moves(by_contacts: bool) -> None:
    head = [k for k, c in enumerate(system_of("carried").tree.v) if c.joint == "neck"]
    rows = loops_of("carried", by_contacts).rows
    assert len(head) == 3 and not any(k in row for row in rows for k in head)


def test_a_leg_of_the_seed_sees_one_or_two_components() -> None:
    """UPS leg on a platform that turns about O: extension and second angle by one component, the first by two."""
    rows = loops_of("three_ups_upu_s_physical", False).rows
    for start in (4, 7, 10):
        assert sorted(len(row) for row in rows[start : start + 3]) == [2, 2, 3]


@pytest.mark.parametrize("by_contacts", [False, True])
@pytest.mark.parametrize("name", NAMES)
def test_all_ways_give_the_same_accelerations(name: str, by_contacts: bool) -> None:
    system, loops = system_of(name), loops_of(name, by_contacts)
    acting = given_drives(system, [Gravity()])
    admissible = Admissible(system, loops, acting.reflected_inertia)
    columns, *others = admissible.ways(acting)
    assert len(others) == (4 if name == "delta" else 2)  # rods as masses at their ends
    for other in others:
        same(system, columns[1], other[1], 1e-9)
        same(system, columns[0], other[0], 1e-9)
    chosen = admissible.accelerations(acting)
    assert count_operations(chosen[1]) == min(count_operations(way[1]) for way in (columns, *others))


@pytest.mark.parametrize("name", [*NAMES, "ur5", slow("panda")])
def test_christoffel_symbols_and_the_recursion_give_the_same_forces(name: str) -> None:
    system = system_of(name)
    acting = given_drives(system, [Gravity(), *([ViscousFriction(FRICTION[name], 0.3)] if name in FRICTION else [])])
    matrix = mass_matrix(system, acting.reflected_inertia)
    still = [system.tape.zero] * len(system.tree.v)
    same(system, generalised_forces(system, acting, still), still_forces(system, acting, matrix))


@pytest.mark.parametrize("name", ["three_ups_upu_s_physical", "stewart_6ups"])
def test_limbs_that_follow_from_the_platform_s_coordinates(name: str) -> None:
    """Their angles stand in cosines and sines only: nothing may be differentiated by the angles."""
    system = system_of(name)
    limbs, hub = closed_limbs(system), hub_links(system)
    assert limbs is not None and hub is not None
    known = {k: system.inputs.q[k] for link in hub for k in range(link.q.start, link.q.stop)}
    found = limb_coordinates(system, limbs, known)
    placed = system.at(found.q, found.turns, system.inputs.v)
    acting = given_drives(placed, [Gravity()])
    still = [system.tape.zero] * len(system.tree.v)
    matrix = mass_matrix(placed, acting.reflected_inertia)
    same(system, generalised_forces(placed, acting, still), still_forces(placed, acting, matrix))
    same(system, placed.bias(placed.rates(still)), Loops(placed).bias(placed), 1e-9)


@pytest.mark.parametrize("name", ["three_ups_upu_s_physical", "stewart_6ups"])
def test_mass_matrices_of_both_rates_are_the_same_energy(name: str) -> None:
    system = system_of(name)
    of_v = mass_matrix(system)
    of_w = in_joint_rates(system, of_v)
    v, w = list(system.inputs.v), system.joint_rates(system.inputs.v)

    def energy(matrix: Sequence[Sequence[Node]], x: Sequence[Node]) -> Node:
        total = system.tape.zero
        for row, a in zip(matrix, x, strict=True):
            for entry, b in zip(row, x, strict=True):
                total = total + a * entry * b
        return total

    same(system, [energy(of_v, v)], [energy(of_w, w)], 1e-13)


def reciprocals(nodes: Sequence[Node]) -> int:
    seen, stack = set(), list(nodes)
    while stack:
        node = stack.pop()
        if node.index not in seen and node.op not in ("symbol", "const"):
            seen.add(node.index)
            stack += node.args
    return sum(nodes[0].tape.nodes[k].op == "reciprocal" for k in seen)


def test_a_reciprocal_follows_from_that_of_a_product() -> None:
    tape = Tape()
    x, y, z = (tape.symbol(name, "1", name) for name in "xyz")
    tape.set_samples({x: np.array([1.7, -0.3]), y: np.array([0.2, 5.0]), z: np.array([3.0, -2.0])})
    roots = [1 / x + z, 1 / (x * y), 1 / (x * y * z) - 1 / z]
    found = shared_reciprocals(roots)
    assert (reciprocals(roots), reciprocals(found)) == (4, 1)
    for old, new in zip(roots, found, strict=True):
        assert np.allclose(tape.sample(old), tape.sample(new), rtol=1e-14)


def test_a_product_that_rests_on_the_reciprocal_is_left_alone() -> None:
    """1 / x cannot follow from 1 / (x y) if y needs 1 / x."""
    tape = Tape()
    x, u = (tape.symbol(name, "1", name) for name in "xu")
    tape.set_samples({x: np.array([1.7]), u: np.array([0.4])})
    y = 1 / x + u
    roots = [1 / (x * y), y]
    found = shared_reciprocals(roots)
    assert reciprocals(found) == 2
    assert np.allclose([tape.sample(n) for n in found], [tape.sample(n) for n in roots], rtol=1e-15)


def test_a_sum_less_one_of_its_terms_is_the_other() -> None:
    tape = Tape()
    a, b = tape.symbol("a", "1", "a"), tape.symbol("b", "1", "b")
    assert (a + b) - a is b and (a - b) - a is -b and a - (a - b) is b and (b - a) + a is b and -(a + b) + b is -a
    assert (a - b) - b is not a and (a + b) + a is not b


def test_coordinates_that_nobody_named_determine_the_others_in_the_reference_configuration() -> None:
    """The drive of this loop does not: its rate is zero there whatever moves. Named it is, with a note that says so."""
    mechanism = invented("thread_ball_cross")
    assert mechanism.joints["J0"].driven
    for independent, determined in ((None, True), (["J0"], False)):
        found = derive(mechanism, independent=independent)
        _, status = found("null_space", found.system.reference[None, :])
        assert (status[0] == 0) == determined
        assert any("do not determine the others" in note for note in found.notes) != determined
        assert (found.programs["velocity"].inputs[1].labels == ("J0",)) != determined


def test_a_mechanism_that_is_shaky_all_along_is_told_in_the_notes() -> None:
    """A bar on two balls that move in parallel planes, as far apart as the bar is long: its loop closes doubly."""
    builder = MechanismBuilder("shaky", platform="bar")
    builder.body("bar", mass=1, com=[0, 0, 1], inertia=["0.1", "0.1", "0.1"])
    for name, x in (("left", "-1/2"), ("right", "1/2")):
        builder.limb(
            name, "RPS", base="base", tip="bar", points=[[x, 0, 0], [x, 0, "1/2"], [x, 0, 1]],
            axes=[[[1, 0, 0]], [[0, 0, 1]], []],
        )  # fmt: skip
    told = [note for note in derive(builder.build()).notes if "shaky all along" in note or "is singular" in note]
    assert len(told) == 1 and "shaky" in told[0]
    assert not any("shaky" in note for note in derive(invented("thread_ball_cross")).notes)

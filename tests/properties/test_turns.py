"""A displacement is continuous over any number of turns, whichever joint of its loop is cut."""

from __future__ import annotations

import dataclasses
import itertools
import textwrap
import tomllib
from collections.abc import Sequence
from decimal import Decimal
from functools import cache
from typing import Any

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model as shared
from support.samples import some_quickly

import symscrew
from symscrew.effects import Acting, Effect, JointSpring
from symscrew.effects.registry import effect_from_table, known_effects
from symscrew.kinematics import System
from symscrew.scene.contents import Initial, Scene
from symscrew.simulation.initial import initial_state

pytestmark = pytest.mark.slow

PITCH = 0.001 / (2 * np.pi)
SCREW = {  # a lead screw: a nut on a guide
    "spin": {"type": "R", "parent": "base", "child": "screw"},
    "thread": {"type": "H", "parent": "screw", "child": "nut", "pitch": "0.001/(2*pi)"},
    "guide": {"type": "P", "parent": "base", "child": "nut"},
}
LENGTHS = (0.7, 1.9, 1.6, 2.0)  # crank, coupler, follower, ground: the crank turns fully
ROCKER = {
    "A": {"type": "R", "parent": "base", "child": "crank", "point": [0, 0, 0]},
    "B": {"type": "R", "parent": "crank", "child": "coupler", "point": [0, "0.7", 0]},
    "C": {"type": "R", "parent": "coupler", "child": "follower", "point": ["1.5", "1.5", 0]},
    "D": {"type": "R", "parent": "base", "child": "follower", "point": [2, 0, 0]},
}
SPATIAL = {  # freedoms 1 + 3 + 1 + 2: both R and H may close the loop, and the axis of H is no other's
    "turn": {"type": "R", "parent": "one", "child": "two", "point": [1, 0, 0], "axes": [["3/5", 0, "4/5"]]},
    "thread": {
        "type": "H",
        "parent": "two",
        "child": "three",
        "point": [1, 1, 0],
        "axes": [[0, "3/5", "4/5"]],
        "pitch": "1/50",
    },
    "ball": {"type": "S", "parent": "base", "child": "one", "point": [0, 0, 0]},
    "cross": {"type": "U", "parent": "base", "child": "three", "point": [0, 1, "0.5"], "axes": [[1, 0, 0], [0, 1, 0]]},
}


def mechanism(joints: dict[str, dict], order: Sequence[str], swapped: Sequence[str] = ()) -> symscrew.Mechanism:
    """The joints in an order, some with parent and child exchanged; bodies have unit inertias."""
    builder = symscrew.MechanismBuilder("loop")
    bodies = dict.fromkeys(j[end] for j in joints.values() for end in ("parent", "child"))
    for body in bodies:
        if body != "base":
            builder.body(body, mass=1, com=(0, 0, 0), inertia=(1, 1, 1))
    for name in order:
        given = {"point": [0, 0, 0], "axes": [[0, 0, 1]], **joints[name]}
        kind, parent, child = given.pop("type"), given.pop("parent"), given.pop("child")
        if kind == "S":
            del given["axes"]
        ends = (child, parent) if name in swapped else (parent, child)
        builder.joint(name, kind, parent=ends[0], child=ends[1], **given)
    return builder.build()


def displacements(model: symscrew.Model, steps: int, along: dict[str, float]) -> list[dict[str, np.ndarray]]:
    """All joints' displacements on the way: a tree's coordinates moved by `along` and closed, in equal steps."""
    system, found = model.system, []
    labels = [c.label for c in system.tree.q]
    y = list(model.independent)
    q = np.array(system.reference)
    for step in range(1, steps + 1):
        target = np.array([system.reference[labels.index(name)] + along[name] * step / steps for name in y])
        (q,), status = model("assemble", target, q)
        assert status == 0
        (values,), _ = model("joint_displacements", q)
        names = model.programs["joint_displacements"].outputs[0].labels
        found.append(dict(zip(names, values, strict=True)))
    return found


@pytest.mark.parametrize("order", some_quickly(itertools.permutations(SCREW), every=3))
def test_a_nut_follows_its_screw_over_any_number_of_turns(order: tuple[str, ...]) -> None:
    model = symscrew.derive(mechanism(SCREW, order), [])
    turns = {"spin": 20.0, "guide": -20 * PITCH, "thread": -20.0}
    at = displacements(model, 40, turns)[-1]
    for name, value in turns.items():
        assert at[name] == pytest.approx(value, abs=1e-12)


@pytest.mark.parametrize("order", [("A", "B", "C", "D"), slow(("D", "C", "B", "A")), slow(("B", "C", "A", "D"))])
@pytest.mark.parametrize("swapped", [(), slow(("C", "D")), slow(("B",))])
def test_angles_of_a_planar_loop_add_up(order: tuple[str, ...], swapped: tuple[str, ...]) -> None:
    """The turns around a planar loop add up to nothing, over several turns, and none of them jumps."""
    model = symscrew.derive(mechanism(ROCKER, order, swapped), [], independent=["A"])
    found = displacements(model, 120, {"A": 20.0})
    signs = {name: -1 if name in swapped else 1 for name in ROCKER}
    for at in found:
        right = {name: signs[name] * at[name] for name in ROCKER}
        assert right["A"] + right["B"] + right["C"] - right["D"] == pytest.approx(0, abs=1e-12)
    for before, after in itertools.pairwise(found):
        assert max(abs(after[name] - before[name]) for name in ROCKER) < 1.0


@pytest.mark.parametrize("joint", list(ROCKER))
def test_a_spring_pulls_back_as_far_as_its_joint_has_turned(joint: str) -> None:
    """A spring's energy is k s^2 / 2 with the displacement s that its joint has, cut or not."""
    spring = JointSpring(joint, stiffness=2)
    model = symscrew.derive(mechanism(ROCKER, ["D", "C", "B", "A"]), [spring], independent=["A"])
    q = np.array(model.system.reference)
    for angle in np.linspace(0.1, 15.0, 100):
        (q,), status = model("assemble", np.array([angle]), q)
        assert status == 0
    (moved,), _ = model("joint_displacements", q)
    s = moved[["D", "C", "B", "A"].index(joint)]
    assert abs(s) > (6 if joint in "AB" else 0)
    energies, _ = model("energy", q, np.zeros(3))
    potential = [p.name for p in model.programs["energy"].outputs]
    assert sum(float(np.sum(e)) for e in energies) == pytest.approx(s * s, rel=1e-12), potential


def kept(joints: dict[str, dict], order: Sequence[str], effects: Sequence[Effect] = ()) -> System:
    """The system under effects."""
    read = tuple(name for effect in effects for name in effect.reads)
    return System(mechanism(joints, order), read=read)


@pytest.mark.parametrize("order", some_quickly(itertools.permutations(SPATIAL), every=6))
def test_a_thread_in_space_is_never_cut(order: tuple[str, ...]) -> None:
    assert "thread" in kept(SPATIAL, order).tree.joints


@pytest.mark.parametrize("order", [("turn", "thread", "ball", "cross"), ("thread", "turn", "cross", "ball")])
def test_a_thread_in_space_moves_on_by_its_pitch(order: tuple[str, ...]) -> None:
    """Whatever is cut, the closure of the loop goes on over whole turns of the thread: no thread is slipped."""
    system = kept(SPATIAL, order)
    (link,) = system.tree.links_of("thread")
    q = np.array(system.reference)
    turned = np.array(q)
    turned[link.q] += 2 * np.pi
    residual = system.numeric(system.residual, (system.inputs.q, np.stack([q, turned])))
    assert np.abs(residual[0]).max() < 1e-14
    assert np.abs(residual[1]).max() > 0.05  # 2 pi 0.02 m of which most is across a row's direction


def test_a_joint_in_space_whose_displacement_an_effect_reads_is_not_cut() -> None:
    order = ["thread", "turn", "ball", "cross"]
    assert "turn" not in kept(SPATIAL, order).tree.joints
    system = kept(SPATIAL, order, [JointSpring("turn", stiffness=1)])
    assert {"turn", "thread"} <= set(system.tree.joints)
    assert {joint.name for joint in system.tree.cut} == {"ball"}


def test_an_effect_that_does_not_say_what_it_reads_is_refused_where_turns_are_lost() -> None:
    """Rather than a displacement that wraps."""
    system = kept(SPATIAL, ["thread", "turn", "ball", "cross"])
    assert "turn" not in system.tree.joints
    with pytest.raises(symscrew.DescriptionError, match="names the joint in its property 'reads'"):
        Acting(system, [JointSpring("turn", stiffness=1)])


def test_a_loop_of_which_no_joint_may_be_cut_is_refused() -> None:
    every = [JointSpring(name, stiffness=1) for name in ("A", "B", "C", "D")]
    axes = (["3/5", 0, "4/5"], [0, "3/5", "4/5"], [0, 0, 1], [1, 0, 0])
    skew = {name: {**ROCKER[name], "axes": [axis]} for name, axis in zip(ROCKER, axes, strict=True)}
    with pytest.raises(symscrew.DescriptionError, match="of which one has to be cut; divide one of them"):
        kept(skew, list(ROCKER), every)


CROSSED = {  # the crank-rocker with what it needs not to be overconstrained: both ends of the coupler are universal
    "A": ROCKER["A"],
    "B": {**ROCKER["B"], "type": "U", "axes": [[0, 0, 1], [1, 0, 0]]},
    "C": {**ROCKER["C"], "type": "U", "axes": [[0, 0, 1], [0, 1, 0]]},
    "D": {**ROCKER["D"], "type": "C"},
}


@pytest.mark.parametrize(
    "order, joint",
    [
        (("A", "B", "C", "D"), "C"),
        slow(("A", "B", "C", "D"), "B"),
        slow(("D", "C", "B", "A"), "B"),
        slow(("A", "D", "C", "B"), "C"),
    ],
)
def test_a_universal_joint_whose_displacement_an_effect_reads_is_not_cut(order: tuple[str, ...], joint: str) -> None:
    """The crank turns twice and a half: a spring about the universal joint's first axis is turned as far as that of the
    planar loop's revolute joint, also where one would cut the loop at it."""
    spring = JointSpring(joint, stiffness=2, freedom=0)
    model = symscrew.derive(mechanism(CROSSED, order), [spring], independent=["A"])
    plain = symscrew.derive(mechanism(ROCKER, order), [JointSpring(joint, stiffness=2)], independent=["A"])
    assert joint in model.system.tree.joints
    energies = []
    for found in (model, plain):
        q, stored = np.array(found.system.reference), []
        for angle in np.linspace(0.0, 15.0, 100):
            (q,), status = found("assemble", np.array([angle]), q)
            assert status == 0
            parts, _ = found("energy", q, np.zeros(len(found.system.tree.v)))
            stored.append(sum(float(np.sum(e)) for e in parts))
        energies.append(stored)
    assert energies[0] == pytest.approx(energies[1], rel=1e-9, abs=1e-12)
    assert max(energies[0]) > (36 if joint == "B" else 0)


def test_without_an_effect_that_reads_it_a_universal_joint_may_be_cut() -> None:
    assert any(joint.kind.universal for joint in kept(CROSSED, cutting()).tree.cut)


def on_a_joint(kind: type[Effect], joint: str) -> Effect:
    """An effect in a joint: the example of its documentation, there."""
    text = textwrap.dedent((kind.__doc__ or "").split("    [[effects]]")[1])
    lines = itertools.takewhile(lambda line: line.strip(), text.strip().splitlines())
    table = tomllib.loads("\n".join(lines), parse_float=Decimal)
    needed = {"velocity": "0.01"} if "velocity" in fields_of(kind) else {}
    return effect_from_table({**needed, **table, "joint": joint, "freedom": 0})


def fields_of(kind: type[Effect]) -> set[str]:
    return {field.name for field in dataclasses.fields(kind)}


IN_JOINTS = {name: kind for name, kind in known_effects().items() if {"joint", "freedom"} <= fields_of(kind)}


@cache
def cutting() -> tuple[str, ...]:
    """An order of the joints in which the universal joint C closes the loop, unless an effect reads it."""
    return next(order for order in itertools.permutations(CROSSED) if "C" not in kept(CROSSED, order).tree.joints)


def test_effects_in_joints_are_all_found() -> None:
    assert {"joint_spring", "end_stop", "position_servo", "backlash", "leg_compliance"} <= set(IN_JOINTS)


@pytest.mark.parametrize("name", IN_JOINTS)
def test_every_effect_says_which_displacements_it_reads(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever an effect asks for while it acts it has named, so that no loop is cut where turns of it would be lost.
    Here the joint is universal and closes the loop where nobody reads it; one that is driven is never cut."""
    effect, asked = on_a_joint(IN_JOINTS[name], "C"), set[str]()
    for method in ("displacement", "displacements"):
        usual = getattr(Acting, method)

        def recorded(self: Acting, joint: object, *more: object, usual: Any = usual) -> object:
            asked.add(joint if isinstance(joint, str) else joint.name)  # type: ignore[attr-defined]
            return usual(self, joint, *more)

        monkeypatch.setattr(Acting, method, recorded)
    try:
        system = kept(CROSSED, cutting(), [effect])
        Acting(system, [effect])
        assert ("C" in system.tree.joints) == bool(effect.reads)
    except symscrew.DescriptionError as error:
        if "expected a freedom that slides" in str(error):
            return  # it has no turns
        assert "expected a driven freedom" in str(error) or "expected a joint of the spanning tree" in str(error)
        driven = {**CROSSED, "C": {**CROSSED["C"], "driven": [0]}}
        Acting(System(mechanism(driven, cutting()), read=effect.reads), [effect])
    assert asked <= set(effect.reads)


def test_an_effect_that_reads_a_cut_universal_joint_unsaid_is_refused() -> None:
    with pytest.raises(symscrew.DescriptionError, match="names the joint in its property 'reads'"):
        Acting(kept(CROSSED, cutting()), [JointSpring("C", stiffness=1, freedom=0)])


def test_rates_at_the_start_may_be_given_of_any_joint() -> None:
    """Also of one that closes the loop: the same motion follows from the rate of each."""
    found = shared("four_bar")
    first = Scene("s", found.mechanism, (), 1.0, 1.0, Initial(coordinates={"A": 0.3}, rates={"A": 0.7}))
    q, v = initial_state(first, found, np.zeros(0))
    (rates,), _ = found("joint_rates", q[None], v[None])
    labels = found.programs["joint_rates"].outputs[0].labels
    assert not set(labels) <= {c.label for c in found.system.tree.v}
    for label, rate in zip(labels, rates[0], strict=True):
        scene = dataclasses.replace(first, initial=dataclasses.replace(first.initial, rates={label: float(rate)}))
        assert initial_state(scene, found, np.zeros(0))[1] == pytest.approx(v, rel=1e-12)
    scene = dataclasses.replace(first, initial=dataclasses.replace(first.initial, rates={"E": 1.0}))
    with pytest.raises(symscrew.DescriptionError, match="there is no 'E'"):
        initial_state(scene, found, np.zeros(0))

"""Names of coordinates in expressions and on tapes: every one its own, whatever joints are called."""

from __future__ import annotations

from symscrew import MechanismBuilder
from symscrew.kinematics import System, identifiers


def test_names_are_as_before_where_they_differ() -> None:
    assert identifiers(["a.0", "a.1", "b"]) == {"a.0": "a_0", "a.1": "a_1", "b": "b"}


def test_a_label_without_dots_keeps_its_name() -> None:
    found = identifiers(["a.0", "a_0", "a__0", "a.0"])
    assert found == {"a.0": "a___0", "a_0": "a_0", "a__0": "a__0"}


def test_inputs_of_joints_that_look_alike_are_apart() -> None:
    built = MechanismBuilder("m")
    for body in "pq":
        built.body(body, mass=1, com=(0.1, 0, 0), inertia=(0.1, 0.2, 0.3))
    built.joint("arm", "U", parent="base", child="p", point=(0, 0, 0), axes=[(1, 0, 0), (0, 1, 0)])
    built.joint("arm_1", "R", parent="p", child="q", point=(0.3, 0, 0), axes=[(0, 0, 1)])
    system = System(built.build())
    for nodes in (system.inputs.q, system.inputs.v, system.inputs.a):
        assert len(set(nodes)) == len(nodes) == 3
    assert "q_arm_1" in system.tape.symbols

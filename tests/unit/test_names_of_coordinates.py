"""Names of coordinates in expressions and on tapes: every one its own, whatever joints are called."""

from __future__ import annotations

import pytest

from symscrew import MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.kinematics import System, identifiers
from symscrew.model import derive


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


@pytest.mark.parametrize("name", ["q_arm", "v_arm", "a_arm", "u_arm"])
def test_a_parameter_that_is_an_input_is_not_called_like_another(name: str) -> None:
    """Its number was the coordinate's. One that is put in is no input, and may be called so."""
    for run_time in (True, False):
        built = MechanismBuilder("m")
        built.parameter(name, 1, unit="kg", run_time=run_time)
        built.body("p", mass=name, com=(0.1, 0, 0), inertia=(0.1, 0.2, 0.3))
        built.joint("arm", "R", parent="base", child="p", point=(0, 0, 0), axes=[(0, 1, 0)], driven=[0])
        if run_time:
            with pytest.raises(DescriptionError, match=f"parameters.{name}: .*give the parameter another name"):
                derive(built.build())
        else:
            assert derive(built.build()).programs

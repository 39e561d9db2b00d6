"""Derivatives of the generalised forces of a tree by composite bodies against the differentiated recursion."""

from __future__ import annotations

import numpy as np
import pytest
from support.model_states import differentiated, relative
from support.operation_counts import recorded
from support.trees import spatial_tree

from symscrew import catalogue
from symscrew import effects as known
from symscrew.algebra.differentiation import differentiate
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.dynamics.tree_dynamics import generalised_forces
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, transformed
from symscrew.effects.gravity import Gravity
from symscrew.functions.derivative import configuration_seeds
from symscrew.functions.tree_derivative import force_changes
from symscrew.kinematics.system import System
from symscrew.model import derive


def loaded(name: str) -> Mechanism:
    return spatial_tree() if name == "spatial_tree" else catalogue.load(name)


def arm_on_a_ball() -> Mechanism:
    """A spherical joint, a universal one and a screw, one after the other."""
    builder = MechanismBuilder("arm_on_a_ball")
    for k, name in enumerate(("ball", "cross", "nut")):
        builder.body(name, mass=1 + k, com=[k + 0.1, 0.2, 0.3], inertia=[0.3, 0.4, 0.5])
    builder.joint("socket", "S", parent="base", child="ball", point=[0, 0, 0], driven=[0, 1, 2])
    axes = [[1, 0, 0], [0, 0, 1]]
    builder.joint("cardan", "U", parent="ball", child="cross", point=[1, 0, 0], axes=axes, driven=[0, 1])
    axes = [["3/5", 0, "4/5"]]
    builder.joint("screw", "H", parent="cross", child="nut", point=[2, 0, 1], axes=axes, pitch=0.05, driven=True)
    return builder.build()


FORCES: tuple[Effect, ...] = (
    known.BaseMotion(),
    known.JointSpring("slide", stiffness=2, damping="0.3"),
    known.RotorInertia("screw", "0.4", 3),
    known.ViscousFriction("slide", 3),
)


@pytest.mark.parametrize(
    ("name", "effects"),
    [("ur5", (Gravity(),)), ("panda", ()), ("spatial_tree", (Gravity(),)), ("spatial_tree", (Gravity(), *FORCES))],
)
def test_changes_of_forces(name: str, effects: tuple[Effect, ...]) -> None:
    """All kinds of joints and a moving base, along steps of q and by v and a."""
    mechanism = loaded(name)
    system = System(mechanism, transformed(mechanism, effects))
    system.use_samples()
    acting, tape, count = Acting(system, effects), system.tape, len(system.tree.v)
    units = [[tape.one if i == k else tape.zero for i in range(count)] for k in range(count)]
    labels = [str(k) for k in range(count)]
    seeds = configuration_seeds(system, "q", labels, units)
    for group, nodes in (("v", system.inputs.v), ("a", system.inputs.a)):
        seeds.update({node: {f"{group}|{k}": tape.one} for k, node in enumerate(nodes)})
    keys = [f"{group}|{k}" for group in "qva" for k in labels]
    found = force_changes(acting, system.inputs.a, directions=keys, steps=units, seeds=seeds)
    forces = generalised_forces(system, acting, system.inputs.a)
    expected = differentiate(tape, forces, seeds, keys, order="forward")
    for k, column in enumerate(found):
        for got, row in zip(column, expected, strict=True):
            scale = max(1.0, np.abs(tape.sample(row[k])).max())
            assert np.abs(tape.sample(got) - tape.sample(row[k])).max() < 1e-11 * scale, keys[k]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "arm on a ball"])
def test_takes_fewer_operations_and_gives_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Inverse and forward dynamics of trees, by the equations of motion and by differentiating the programs."""
    found = differentiated(name) if name == "panda" else derive(arm_on_a_ball(), derivatives=True)
    monkeypatch.setattr("symscrew.functions.tree_derivative.covers", lambda acting: False)
    plain = derive(found.mechanism, derivatives=True)
    names = ("inverse_dynamics", "inverse_dynamics_independent") if name == "panda" else ()
    limits = recorded("derivatives", name) if name == "panda" else {}
    for function in (f"{each}_derivatives" for each in (*names, "forward_dynamics")):
        program, other = found.programs[function], plain.programs[function]
        assert program.operations["total"] <= limits.get(function, np.inf)
        assert program.operations["total"] < 0.9 * other.operations["total"]
        assert program.inputs == other.inputs and program.outputs == other.outputs
        given = found.test_inputs[function]
        (*got, status), (*expected, _) = found(function, *given), plain(function, *given)
        assert not status.any()
        for a, b in zip(got[0], expected[0], strict=True):
            assert relative(a, b) < 1e-11

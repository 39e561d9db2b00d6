"""Springs in ball joints over any number of turns, in joints of the tree and in such as close a loop."""

from __future__ import annotations

import numpy as np
import pytest
from support.marks import slow

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import JointSpring
from symscrew.effects.registry import check_effects
from symscrew.errors import DescriptionError
from symscrew.kinematics.joint_displacements import cut_displacement
from symscrew.kinematics.system import System
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.motion import Run, simulate

pytestmark = pytest.mark.slow

compiled = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: loops without one take minutes")
K, J = 0.3, 0.6
WAYS = (slow("tree"), slow("turned round"), slow("cut"), "cut, turned round")


def rotor(way: str, inertia: tuple[str, str, str]) -> Mechanism:
    """A rotor on a ball S at its centre; cut: S is between it and a carriage, and another ball beside S holds it."""
    b = MechanismBuilder("rotor")
    b.body("rotor", mass=1, com=[0, 0, 0], inertia=inertia)
    under = "base"
    if way.startswith("cut"):
        under = "carriage"
        b.body("carriage", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
        b.joint("B", "S", parent="base", child="rotor", point=[0, 0, 0])
        b.joint("P", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]])
    ends = ("rotor", under) if way.endswith("turned round") else (under, "rotor")
    b.joint("S", "S", parent=ends[0], child=ends[1], point=[0, 0, 0])
    return b.build()


def run(way: str, omega: np.ndarray, duration: float, inertia: tuple[str, str, str] = (str(J),) * 3) -> Run:
    """The rotor turned on at omega [rad/s], its spring at rest."""
    mechanism = rotor(way, inertia)
    assert {cut.name for cut in System(mechanism).tree.cut} == ({"S"} if way.startswith("cut") else set())
    joint = "B" if way.startswith("cut") else "S"
    sign = -1 if way == "turned round" else 1  # the coordinates of a joint of the tree are its own
    rates = {f"{joint}.w{c}": float(sign * w) for c, w in zip("xyz", omega, strict=True)}
    scene = Scene(
        "s", mechanism, (JointSpring("S", stiffness=str(K)),), duration, 20.0, Initial(rates=rates),
        integrator=Integrator(tolerance=1e-11),
    )  # fmt: skip
    found = simulate(scene)
    assert found.ok and found.unbalanced < 1e-9, found.verdict
    return found


def quaternions(found: Run) -> np.ndarray:
    """Of the rotor against the ground."""
    entries = [k for k, c in enumerate(found.model.system.tree.q) if c.kind == "quaternion"]
    return found.q[:, entries]


@compiled
@pytest.mark.parametrize("way", WAYS)
def test_a_ball_turns_on_and_back_as_a_hinge_does(way: str) -> None:
    """About one axis, phi = (|omega| sqrt(J/k) sin(sqrt(k/J) t)) along it: 2.7 turns to one side and back."""
    axis = np.array([0.36, 0.48, 0.8])
    found = run(way, 12.0 * axis, 6.0)
    phi = found.x[:, :3]
    angle = 12.0 * np.sqrt(J / K) * np.sin(np.sqrt(K / J) * found.t)
    assert np.abs(angle).max() > 2.7 * 2 * np.pi
    sign = -1 if way.endswith("turned round") else 1
    assert np.abs(phi - sign * angle[:, None] * axis).max() < 1e-7
    own = -axis if way == "turned round" else axis  # of the joint's own coordinates
    turned = np.column_stack([np.cos(angle / 2), np.outer(np.sin(angle / 2), own)])
    assert np.abs(np.abs((quaternions(found) * turned).sum(1)) - 1).max() < 1e-9


@compiled
@pytest.mark.parametrize("way", [slow("tree"), slow("cut, turned round")])
def test_the_state_is_the_turn_of_a_tumbling_body(way: str) -> None:
    """Beyond half a turn about no fixed axis: the rotation by phi is that of the pose all along."""
    found = run(way, np.array([3.0, 2.0, 9.0]), 5.0, ("0.4", "0.5", "0.6"))
    phi = found.x[:, :3]
    angle = np.linalg.norm(phi, axis=1)
    assert 1.5 * np.pi < angle.max() < 2 * np.pi
    turned = np.column_stack([np.cos(angle / 2), phi * (np.sinc(angle / 2 / np.pi) / 2)[:, None]])
    sign = [1, -1, -1, -1] if way == "cut, turned round" else [1, 1, 1, 1]
    assert np.abs(np.abs((turned * sign * quaternions(found)).sum(1)) - 1).max() < 1e-10


def test_displacements_are_exact_up_to_half_a_turn() -> None:
    """Of a ball that closes a loop, by its pose, where a spring's turns start: at any angle to half a turn, about any
    axis, and at none."""
    system = System(rotor("cut", ("1", "1", "1")))
    (cut,) = system.cuts
    random = np.random.default_rng(3)
    axes = [*random.normal(size=(20, 3)), *np.eye(3), *-np.eye(3)]
    for angle in (0.0, 1e-12, 1e-5, 0.1, 2.0, np.pi - 1e-7, np.pi - 1e-12, np.pi):
        for axis in axes:
            phi = angle * axis / np.linalg.norm(axis)
            q = [np.cos(angle / 2), *(np.sin(angle / 2) * axis / np.linalg.norm(axis)), 0]
            found = system.numeric(cut_displacement(system, cut), (system.inputs.q, np.array([q])))[0]
            near = min(np.abs(found - phi).max(), np.abs(found + phi).max() if angle > np.pi - 1e-10 else np.inf)
            assert near < 2e-15 * max(1.0, angle), (angle, axis)


def test_nearest_is_of_ball_joints_alone() -> None:
    b = MechanismBuilder("hinge")
    b.body("rotor", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    b.joint("A", "R", parent="base", child="rotor", point=[0, 0, 0], axes=[[0, 0, 1]])
    with pytest.raises(DescriptionError, match="'nearest' is of ball joints"):
        check_effects(b.build(), [JointSpring("A", stiffness=1, nearest=True)])


@compiled
@pytest.mark.slow
def test_with_nearest_the_spring_pulls_on_beyond_half_a_turn() -> None:
    """And needs no states."""
    spring = JointSpring("S", stiffness=str(K), nearest=True)
    scene = Scene("s", rotor("tree", (str(J),) * 3), (spring,), 2.0, 20.0, Initial(rates={"S.wz": 12.0}))
    found = simulate(scene)
    assert found.ok and found.x.shape[1] == 0 and found.v[:, 2].min() > 11.0

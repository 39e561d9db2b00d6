"""Rolling without sliding against solutions in closed form: on an incline, in a ring, a disc in steady precession.

The deflection where the wheel touches is set to what the force of the closed solution needs. Then the accelerations
are those of the ideal constraint, to rounding: what remains of the effect's elasticity is a transient.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import RollingContact
from symscrew.effects.gravity import Gravity
from symscrew.effects.registry import check_effects
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.scene.scene_file import load_scene
from symscrew.simulation.motion import simulate

EXAMPLES = Path(__file__).parents[2] / "examples" / "effects"
M, R, G = 2.0, 0.3, 9.81
K, KAPPA, SIGMA = 2e6, 500.0, 0.5


def rolling(**more: object) -> RollingContact:
    given = {"wheel": "hub", "ground": "road", "radius": str(R), "stiffness": K, "grip": KAPPA, "grip_damping": SIGMA}
    return RollingContact(**{**given, **more})  # type: ignore[arg-type]


def accelerations(found: Model, q: Sequence[float], v: Sequence[float], x: Sequence[float]) -> np.ndarray:
    given = {"q": [q], "v": [v], "x": [x]}
    results, status = found(
        "forward_dynamics", *[given[port.name] for port in found.programs["forward_dynamics"].inputs]
    )
    assert not status.any()
    return np.asarray(results[0][0])


def wheel_in_a_plane(inertia: float) -> Mechanism:
    """Moves along x and y and turns about z; its centre at O in the reference configuration."""
    b = MechanismBuilder("wheel")
    b.body("frame")
    b.body("carriage")
    b.body("wheel", mass=str(M), com=[0, 0, 0], inertia=[0, 0, str(inertia)])
    b.joint("X", "P", parent="base", child="frame", point=[0, 0, 0], axes=[[1, 0, 0]])
    b.joint("Y", "P", parent="frame", child="carriage", point=[0, 0, 0], axes=[[0, 1, 0]])
    b.joint("Z", "R", parent="carriage", child="wheel", point=[0, 0, 0], axes=[[0, 0, 1]])
    b.point("hub", body="wheel", at=[0, 0, 0])
    b.point("road", body="base", at=[0, 0, 0])
    return b.build()


def free_disc(axis: np.ndarray, transverse: float, axial: float) -> Mechanism:
    b = MechanismBuilder("disc")
    rows = transverse * np.eye(3) + (axial - transverse) * np.outer(axis, axis)
    b.body("disc", mass=str(M), com=[0, 0, 0], inertia=[[repr(float(c)) for c in row] for row in rows])
    b.joint("J", "free", parent="base", child="disc", point=[0, 0, 0])
    b.point("hub", body="disc", at=[0, 0, 0])
    b.point("road", body="base", at=[0, 0, 0])
    return b.build()


def pressed(force: float) -> float:
    """The depth at which the ground bears a force."""
    return float((force / K) ** (2 / 3))


@pytest.mark.parametrize("shape", [0.5, pytest.param(1.0, marks=pytest.mark.slow)])
def test_a_wheel_rolls_down_an_incline(shape: float) -> None:
    """a = g sin(alpha)/(1 + J/(m r^2)): 2/3 g sin(alpha) of a disc, 1/2 of a hoop; no state across the plane."""
    sine, cosine = 0.6, 0.8
    field = Gravity((str(G * sine), str(-G * cosine), 0))
    found = derive(wheel_in_a_plane(shape * M * R**2), [field, rolling(normal=(0, 1, 0), axis=(0, 0, -1))])
    labels = [label for p in found.programs["forward_dynamics"].inputs if p.name == "x" for label in p.labels]
    assert labels == ["roll_hub_1"]
    a, bears = G * sine / (1 + shape), M * G * cosine
    friction = M * a - M * G * sine  # along x, on the wheel
    state = [0, R - pressed(bears), 0], [1.5, 0, -1.5 / R]
    got = accelerations(found, *state, [-friction / (bears * KAPPA)])
    assert got == pytest.approx([a, 0, -a / R], rel=1e-9, abs=1e-9)
    lifted = accelerations(found, [0, R + 1e-6, 0], [1.5, 0, 0], [0.001])
    assert lifted == pytest.approx([G * sine, -G * cosine, 0], abs=1e-12)


@pytest.mark.parametrize("ring", [-1.0, 0.7])
def test_a_wheel_rolls_in_a_ring_and_on_another_wheel(ring: float) -> None:
    """(1 + J/(m r^2)) rho psi_ddot = g along the way of the centre, at the distance rho from the ring's centre."""
    shape, inside, psi, psi_dot = 0.5, ring < 0, 0.5, 0.6
    effects = [Gravity((0, str(-G), 0)), rolling(circle=str(ring), axis=(0, 0, 1))]
    found = derive(wheel_in_a_plane(shape * M * R**2), effects)
    out = np.array([np.sin(psi), -np.cos(psi)]) * (1 if inside else -1)  # from the ring's centre to the wheel's
    n, along = (-out if inside else out), np.array([-out[1], out[0]])
    rho = free = -ring - R if inside else ring + R
    for _ in range(50):  # it sinks in as deep as the ground bears
        bears = -M * rho * psi_dot**2 * (out @ n) + M * G * n[1]
        rho = free + pressed(bears) * (1 if inside else -1)
    gravity = -G * along[1]
    psi_ddot = gravity / (1 + shape) / rho
    friction = M * (rho * psi_ddot - gravity)  # along the way of the centre, on the wheel
    turn = -1 if inside else 1  # of the wheel per way of its centre, times r
    first = np.array([-n[1], n[0]])  # axis x normal
    deflection = -friction * (along @ first) / (bears * KAPPA)
    rates = [*(rho * psi_dot * along), turn * rho * psi_dot / R]
    got = accelerations(found, [*(rho * out), 0], rates, [deflection])
    centre = rho * (psi_ddot * along - psi_dot**2 * out)
    assert got == pytest.approx([*centre, turn * rho * psi_ddot / R], rel=1e-8, abs=1e-8)


def test_a_disc_rolls_in_steady_precession() -> None:
    """Omega n x H = arm x m (Omega n x v + g n), H of spin and precession (the moments about the centre)."""
    axis, n, omega = np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 1.0]), 3.0
    transverse, axial = M * R**2 / 4, M * R**2 / 2
    lean = axis @ n
    down = (lean * axis - n) / np.sqrt(1 - lean**2)
    arm = R * down

    def residual(spin: float) -> np.ndarray:
        turning = omega * n + spin * axis
        momentum = transverse * turning + (axial - transverse) * (turning @ axis) * axis
        force = M * np.cross(omega * n, -np.cross(turning, arm)) + M * G * n
        return omega * np.cross(n, momentum) - np.cross(arm, force)

    zero, one = residual(0.0), residual(1.0)
    spin = float(-(zero @ (one - zero)) / ((one - zero) @ (one - zero)))  # linear in the spin
    assert np.abs(residual(spin)).max() < 1e-12
    turning = omega * n + spin * axis
    velocity = -np.cross(turning, arm)
    centre, alpha = np.cross(omega * n, velocity), omega * spin * np.cross(n, axis)
    found = derive(free_disc(axis, transverse, axial), [Gravity((0, 0, str(-G))), rolling(axis=(3, 0, 4))])
    bears, height = M * G, R * np.sqrt(1 - lean**2)
    first = np.cross(axis, n) / np.linalg.norm(np.cross(axis, n))
    second = np.cross(n, first)
    held = [-(M * centre @ way) / (bears * KAPPA) for way in (first, second)]
    got = accelerations(found, [0, 0, height - pressed(bears), 1, 0, 0, 0], [*velocity, *turning], held)
    assert got == pytest.approx(np.concatenate([centre, alpha]), abs=1e-8)


@pytest.mark.slow
def test_the_scenes_of_the_examples_roll_as_the_ideal_constraint_does() -> None:
    """The wheel to rounding; the disc but for the elastic way of its grip: a stiffer one, a smaller way."""
    wheel = simulate(load_scene(EXAMPLES / "rolling_wheel.toml"))
    way = G * 0.6 / 1.5 * wheel.t**2 / 2
    assert wheel.ok and wheel.accurate, wheel.verdict
    assert np.abs(wheel.q - np.column_stack([way, np.full_like(way, wheel.q[0, 1]), -way / R])).max() < 1e-10
    scene, off = load_scene(EXAMPLES / "rolling_disc.toml"), []
    gravity, contact = scene.effects
    for grip in (2e4, 2e3):
        given = replace(contact, grip=grip, initial=(0, 1.8515 / (G * grip)))  # type: ignore[call-arg]
        disc = simulate(replace(scene, effects=(gravity, given)))
        assert disc.ok and disc.accurate, disc.verdict
        rho, turn = 0.92575 / 2, 2 * disc.t
        off.append(np.abs(disc.q[:, :2] - np.column_stack([rho * (np.cos(turn) - 1), rho * np.sin(turn)])).max())
    assert off[0] < 1e-5 and 5 < off[1] / off[0] < 20


REFUSED = [
    (rolling(load=1), "one of 'stiffness'"),
    (rolling(stiffness=None), "one of 'stiffness'"),
    (rolling(radius=0), "above 0"),
    (rolling(grip=0), "above 0"),
    (rolling(normal=(0, 0, 0)), "not all of them 0"),
    (rolling(circle=2), "'axis'"),
    (rolling(circle="-0.2", axis=(0, 0, 1)), "minus the wheel's"),
    (rolling(initial=(0,)), "2 entries"),
    (rolling(ground="hub"), "two bodies"),
    (rolling(wheel="hup"), "did you mean"),
]


@pytest.mark.parametrize(("effect", "text"), REFUSED)
def test_what_does_not_fit_is_refused(effect: RollingContact, text: str) -> None:
    with pytest.raises(DescriptionError, match=text):
        check_effects(wheel_in_a_plane(1.0), [effect])

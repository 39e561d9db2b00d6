"""Rolling as an ideal constraint against Newton's and Euler's laws with an unknown force where it touches, typed here:
at random states of discs and balls on planes, circles and a table that turns; and motions in closed form."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import IdealRolling
from symscrew.effects.gravity import Gravity
from symscrew.effects.registry import check_effects
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.initial import initial_state
from symscrew.simulation.motion import simulate

M, R, G = 2.0, 0.3, 9.81
TABLE = 0.7  # kg m^2, about its own axis


def body(centre: Sequence[float], inertia: np.ndarray, table: bool = False) -> Mechanism:
    """A body that is free, with its centre at a point; a table that turns about z at (0.2, -0.1, 0)."""
    b = MechanismBuilder("rolling")
    place = [repr(float(c)) for c in centre]
    b.body("wheel", mass=str(M), com=place, inertia=[[repr(float(c)) for c in row] for row in inertia])
    if table:
        b.body("table", mass=1, com=["0.2", "-0.1", 0], inertia=[1, 1, str(TABLE)])
        b.joint("T", "R", parent="base", child="table", point=["0.2", "-0.1", 0], axes=[[0, 0, 1]])
    b.joint("J", "free", parent="base", child="wheel", point=place)
    b.point("hub", body="wheel", at=place)
    b.point("road", body="table" if table else "base", at=[0, 0, 0])
    return b.build()


def motion(found: Model) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """At the sample states, absolute axes: rotation, place, velocity, spin, their rates by forward dynamics; forces."""
    q, v, _ = found.system.sample_states
    (a, *_), status = found("forward_dynamics", q, v)
    assert not status.any()
    bodies = [name for name in found.mechanism.bodies if name != "base"]
    k = bodies.index("wheel")
    (poses,), _ = found("body_poses", q)
    (twists,), _ = found("body_twists", q, v)
    (rates,), _ = found("body_twist_rates", q, v, a)
    (places, speeds, gains), _ = found("point_motion", q, v, a)
    hub = slice(0, 3)
    known = {
        "rotation": poses.reshape(len(q), -1, 12)[:, k, :9].reshape(-1, 3, 3).transpose(0, 2, 1),
        "w": places[:, hub], "v": speeds[:, hub], "a": gains[:, hub],
        "omega": twists.reshape(len(q), -1, 6)[:, k, :3], "alpha": rates.reshape(len(q), -1, 6)[:, k, :3],
    }  # fmt: skip
    if "table" in bodies:
        t = bodies.index("table")
        known |= {"turning": twists.reshape(len(q), -1, 6)[:, t, 2], "gain": rates.reshape(len(q), -1, 6)[:, t, 2]}
    (force, *_), status = found("rolling_forces", q, v, a)
    assert not status.any()
    return known, force


def skew(x: np.ndarray) -> np.ndarray:
    return np.array([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])


def expected(known: dict[str, np.ndarray], k: int, inertia: np.ndarray, gravity: np.ndarray, n: np.ndarray,
             axis: np.ndarray | None) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
    """Acceleration of the centre, angular acceleration and force on the wheel at state k, and the way it rolls.

    m a = m g + f, J alpha + omega x J omega = r x f, and the rate of v + omega x r - (the ground's velocity there).
    """
    rotation, omega = known["rotation"][k], known["omega"][k]
    j = rotation @ inertia @ rotation.T
    if axis is None:
        r, r_dot = -R * n, np.zeros(3)
        ahead = None
    else:
        axle = rotation @ axis
        axle_dot = np.cross(omega, axle)
        u = n - (n @ axle) * axle
        u_dot = -(n @ axle_dot) * axle - (n @ axle) * axle_dot
        size = np.sqrt(u @ u)
        r, r_dot = -R * u / size, -R * (u_dot / size - u * (u @ u_dot) / size**3)
        ahead = np.cross(axle, n) / np.linalg.norm(np.cross(axle, n))
    table = "turning" in known
    count = 10 if table else 9
    matrix, right = np.zeros((count, count)), np.zeros(count)
    matrix[0:3, 0:3], matrix[0:3, 6:9], right[0:3] = M * np.eye(3), -np.eye(3), M * gravity
    matrix[3:6, 3:6], matrix[3:6, 6:9], right[3:6] = j, -skew(r), -np.cross(omega, j @ omega)
    matrix[6:9, 0:3], matrix[6:9, 3:6], right[6:9] = np.eye(3), -skew(r), -np.cross(omega, r_dot)
    if table:
        away, z = known["w"][k] + r - np.array([0.2, -0.1, 0]), np.array([0, 0, 1.0])
        matrix[6:9, 9] = -np.cross(z, away)
        right[6:9] += known["turning"][k] * np.cross(z, known["v"][k] + r_dot)
        matrix[9, 9], matrix[9, 6:9] = TABLE, np.cross(z, away)
    found = np.linalg.solve(matrix, right)
    if table:
        assert known["gain"][k] == pytest.approx(found[9], abs=1e-9)
    return found[0:3], found[3:6], found[6:9], np.zeros(3) if ahead is None else ahead


LEAN = np.array([0.6, 0.0, 0.8])
CASES = {
    "disc": ((0, 0, 1), LEAN, False),
    "disc on an incline": ((-0.6, 0, 0.8), np.array([0.0, 1.0, 0.0]), False),
    "ball": ((0, 0.28, 0.96), None, False),
    "ball on a table": ((0, 0, 1), None, True),
    "disc on a table": ((0, 0, 1), np.array([0.28, 0.0, 0.96]), True),
}


@pytest.mark.parametrize(
    "name", ["disc on a table", "ball", *map(slow, ("disc", "disc on an incline", "ball on a table"))]
)
def test_accelerations_and_forces_are_those_of_newton_and_euler(name: str) -> None:
    up, axis, table = CASES[name]
    n = np.array(up, dtype=float)
    lean = 1.0 if axis is None else float(np.sqrt(1 - (axis @ n) ** 2))
    spread = np.array([[0.05, 0.004, 0], [0.004, 0.06, 0.003], [0, 0.003, 0.04]])
    inertia = spread if axis is None else M * R**2 / 4 * (np.eye(3) + np.outer(axis, axis))
    gravity = np.array([0.3, -0.2, -G])
    rolls = IdealRolling("hub", "road", str(R), normal=[repr(c) for c in up],
                         axis=() if axis is None else [repr(float(c)) for c in axis])  # fmt: skip
    found = derive(body(R * lean * n, inertia, table), [Gravity(tuple(map(str, gravity))), rolls])
    assert len(found.independent) == (4 if table else 3)
    known, forces = motion(found)
    if not table:  # a joint with six freedoms bears nothing, not even rounding, which a comparison would stumble over
        arrays, _ = found("forward_dynamics_reactions", *found.system.sample_states[:2])
        assert not arrays[-1].any()
    for k in range(len(forces)):
        a, alpha, force, ahead = expected(known, k, inertia, gravity, n, axis)
        assert known["a"][k] == pytest.approx(a, abs=1e-9 * max(1.0, np.abs(a).max()))
        assert known["alpha"][k] == pytest.approx(alpha, abs=1e-9 * max(1.0, np.abs(alpha).max()))
        assert forces[k, 2] == pytest.approx(force @ n, rel=1e-9)
        if axis is None:
            assert np.hypot(*forces[k, :2]) == pytest.approx(np.linalg.norm(force - (force @ n) * n), rel=1e-9)
        else:
            assert forces[k, 0] == pytest.approx(force @ ahead, abs=1e-8)
            assert forces[k, 1] == pytest.approx(force @ np.cross(n, ahead), abs=1e-8)


@pytest.mark.parametrize("ring", [-1.0, 0.7])
def test_a_wheel_in_a_ring_and_on_another_wheel(ring: float) -> None:
    """(1 + J/(m r^2)) rho psi_ddot = g along the way of the centre, at the distance rho from the ring's centre."""
    rho = -ring - R if ring < 0 else ring + R
    out, shape = np.array([0.6, -0.8]), 0.5
    b = MechanismBuilder("wheel")
    place = [repr(float(c)) for c in (*(rho * out), 0)]
    b.body("frame")
    b.body("carriage")
    b.body("wheel", mass=str(M), com=place, inertia=[0, 0, repr(shape * M * R**2)])
    for name, kind, parent, child, axis in (("X", "P", "base", "frame", [1, 0, 0]),
                                            ("Y", "P", "frame", "carriage", [0, 1, 0]),
                                            ("Z", "R", "carriage", "wheel", [0, 0, 1])):  # fmt: skip
        b.joint(name, kind, parent=parent, child=child, point=place, axes=[axis])
    b.point("hub", body="wheel", at=place)
    b.point("road", body="base", at=[0, 0, 0])
    rolls = IdealRolling("hub", "road", str(R), axis=(0, 0, 1), circle=str(ring))
    found = derive(b.build(), [Gravity((0, str(-G), 0)), rolls])
    along, psi_dot = np.array([-out[1], out[0]]), 0.6
    turn = -1 if ring < 0 else 1
    v = [*(rho * psi_dot * along), turn * rho * psi_dot / R]
    (a, *_), status = found("forward_dynamics", [0, 0, 0], v)
    psi_ddot = -G * along[1] / (1 + shape) / rho
    centre = rho * (psi_ddot * along - psi_dot**2 * out)
    assert not status.any()
    assert a == pytest.approx([*centre, turn * rho * psi_ddot / R], rel=1e-12, abs=1e-12)


def test_a_pinion_on_a_rack_whose_height_joints_hold() -> None:
    """m x_ddot (1 + J/(m r^2)) = m g_x, and x = -r phi for ever: without a row across the ground."""
    b = MechanismBuilder("pinion")
    b.body("carriage")
    b.body("wheel", mass=str(M), com=[0, str(R), 0], inertia=[0, 0, repr(M * R**2 / 2)])
    b.joint("X", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]])
    b.joint("Z", "R", parent="carriage", child="wheel", point=[0, str(R), 0], axes=[[0, 0, 1]])
    b.point("hub", body="wheel", at=[0, str(R), 0])
    b.point("road", body="base", at=[0, 0, 0])
    rolls = IdealRolling("hub", "road", str(R), normal=(0, 1, 0), axis=(0, 0, 1), holds=False)
    found = derive(b.build(), [Gravity((3, 0, 0)), rolls])
    (a, *_), status = found("forward_dynamics", [0.4, 2.0], [1.0, -1.0 / R])
    assert not status.any() and a == pytest.approx([2.0, -2.0 / R], rel=1e-12)


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler: the run without one takes minutes")
@pytest.mark.slow
def test_a_disc_in_steady_precession() -> None:
    """In closed form, at any tolerance to its order: the centre on a circle; energy kept; no way is slid."""
    axis, n, omega = LEAN, np.array([0, 0, 1.0]), 3.0
    inertia = M * R**2 / 4 * (np.eye(3) + np.outer(axis, axis))
    lean = axis @ n
    arm = R * (lean * axis - n) / np.sqrt(1 - lean**2)

    def residual(spin: float) -> np.ndarray:
        turning = omega * n + spin * axis
        force = M * np.cross(omega * n, -np.cross(turning, arm)) + M * G * n
        return omega * np.cross(n, inertia @ turning) - np.cross(arm, force)

    zero, one = residual(0.0), residual(1.0)
    spin = float(-(zero @ (one - zero)) / ((one - zero) @ (one - zero)))
    turning = omega * n + spin * axis
    velocity = -np.cross(turning, arm)
    rates = {**{f"J.{k}": float(c) for k, c in enumerate(velocity)},
             **{f"J.w{c}": float(w) for c, w in zip("xyz", turning, strict=True)}}  # fmt: skip
    effects = (Gravity((0, 0, str(-G))), IdealRolling("hub", "road", str(R), axis=[repr(float(c)) for c in axis]))
    centre = np.array([0, 0, R * np.sqrt(1 - lean**2)])
    errors = []
    for tolerance in (1e-6, 1e-9):
        scene = Scene("disc", body(centre, inertia), effects, 4.0, 20.0, Initial({}, rates),
                      integrator=Integrator(tolerance=tolerance))  # fmt: skip
        found = simulate(scene)
        assert found.ok and found.accurate and found.unbalanced < 10 * tolerance, found.verdict
        t = omega * found.t[:, None]
        way = (velocity / omega) * np.sin(t) + np.cross(n, velocity) / omega * (1 - np.cos(t))
        (places, *_), _ = found.model("forward_kinematics", found.q)
        errors.append(float(np.abs(places[:, :3] - centre - way).max()))
    assert errors[0] < 1e-4 and errors[1] < 1e-7, errors


REFUSED = [
    (IdealRolling("hup", "road", "0.3"), "did you mean"),
    (IdealRolling("hub", "hub", "0.3"), "points of two bodies"),
    (IdealRolling("road", "hub", "0.3"), "a wheel that moves"),
    (IdealRolling("hub", "road", 0), "above 0"),
    (IdealRolling("hub", "road", "0.31"), "m off"),
    (IdealRolling("hub", "road", "0.3", normal=(0, 0, 0)), "not all of them 0"),
    (IdealRolling("hub", "road", "0.3", normal=()), "not all of them 0, got none"),
    (IdealRolling("hub", "road", "0.3", axis=(0, 0, 1)), "lies flat"),
    (IdealRolling("hub", "road", "0.3", circle=2), "the key 'axis'"),
    (IdealRolling("hub", "road", "0.3", axis=(1, 0, 0), circle="-0.2"), "minus the wheel's"),
]


@pytest.mark.parametrize(("effect", "text"), REFUSED)
def test_what_does_not_fit_is_refused(effect: IdealRolling, text: str) -> None:
    with pytest.raises(DescriptionError, match=text):
        check_effects(body((0, 0, R), np.eye(3)), [effect])


def test_starts_anywhere_on_the_ground() -> None:
    """Coordinates and heading at will; a pose by name that is off the ground is refused, not put elsewhere."""
    effects = (IdealRolling("hub", "road", str(R), axis=(1, 0, 0)),)
    mechanism = replace(body((0, 0, R), np.eye(3)), platform="wheel")
    model = derive(mechanism, effects)
    half = {"J.qw": 0.8, "J.qx": 0.0, "J.qy": 0.0, "J.qz": 0.6}
    for coordinates in ({"J.0": 5.0, "J.1": -2.0, **half}, {"wheel.x": 0.5, "wheel.y": 0.1, "wheel.z": 0}):
        scene = Scene("s", mechanism, effects, 1.0, 10.0, Initial(coordinates))
        q, _ = initial_state(scene, model, model.system.parameter_values)
        labels = [c.label for c in model.system.tree.q]
        assert all(q[labels.index(k)] == pytest.approx(v, abs=1e-12) for k, v in coordinates.items() if k in labels)
        (residual,), _ = model("closure", q)
        assert np.abs(residual).max() < 1e-12
    scene = Scene("s", mechanism, effects, 1.0, 10.0, Initial({"wheel.x": 0.5, "wheel.z": 0.1}))
    with pytest.raises(DescriptionError, match="off their ground"):
        initial_state(scene, model, model.system.parameter_values)


def test_two_of_one_name_and_derivatives_are_refused() -> None:
    mechanism, rolls = body((0, 0, R), np.eye(3)), IdealRolling("hub", "road", str(R))
    with pytest.raises(DescriptionError, match="give one another name"):
        check_effects(mechanism, [rolls, rolls])
    with pytest.raises(DescriptionError, match="derive without them"):
        derive(mechanism, [rolls], derivatives=True)


def test_a_ball_that_rolls_on_two_bodies() -> None:
    """Between the ground and a plate that slides: it goes half as fast as the plate; in a groove of two planes that
    meet at a right angle it turns about a line r/sqrt(2) below its centre. Both leave an internal load open."""
    b = MechanismBuilder("plates")
    b.body("ball", mass="0.7", com=[0, 0, "0.1"], inertia=["2/5*0.7*0.1^2"] * 3)
    b.body("lid", mass=2, com=[0, 0, "0.2"], inertia=["0.01"] * 3)
    b.joint("F", "free", parent="base", child="ball", point=[0, 0, "0.1"])
    b.joint("X", "P", parent="base", child="lid", point=[0, 0, "0.2"], axes=[[1, 0, 0]])
    for name, body, z in (("hub", "ball", "0.1"), ("road", "base", 0), ("under", "lid", "0.2")):
        b.point(name, body=body, at=[0, 0, z])
    rolls = [
        IdealRolling("hub", "road", "0.1", name="low"),
        IdealRolling("hub", "under", "0.1", (0, 0, -1), name="high"),
    ]
    found = derive(b.build(), [Gravity((3, 0, "-9.81")), *rolls])
    q, v, _ = found.system.sample_states
    (a, *_), status = found("forward_dynamics", q, v)
    assert not status.any()
    slide = [c.label for c in found.system.tree.v].index("X")
    assert a[:, slide] == pytest.approx(3 * (2 + 0.7 / 2) / (2 + 0.7 / 4 + 2 / 5 * 0.7 / 4), rel=1e-12)

    b = MechanismBuilder("groove")
    b.body("ball", mass="0.7", com=[0, 0, 0], inertia=["2/5*0.7*0.1^2"] * 3)
    b.joint("F", "free", parent="base", child="ball", point=[0, 0, 0])
    b.point("hub", body="ball", at=[0, 0, 0])
    for name, y in (("left", "-0.1/sqrt(2)"), ("right", "0.1/sqrt(2)")):
        b.point(name, body="base", at=[0, y, "-0.1/sqrt(2)"])
    rolls = [IdealRolling("hub", side, "0.1", (0, y, 1), name=side) for side, y in (("left", 1), ("right", -1))]
    found = derive(b.build(), [Gravity((3, 0, "-9.81")), *rolls])
    q, v, _ = found.system.sample_states
    (a, *_), status = found("forward_dynamics", q, v)
    assert not status.any()
    assert a[:, :3] == pytest.approx(np.tile([3 / (1 + 2 / 5 * 2), 0, 0], (len(q), 1)), abs=1e-9)
    assert any("rolling_right" in note and "internal load" in note for note in found.notes)

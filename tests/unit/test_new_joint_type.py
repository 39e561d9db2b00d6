"""A new joint type that is made of known motions is a line in the table: used from the description to the dynamics."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest
import sympy

import symscrew
from symscrew.algebra import Node, Pose, Scalar, Tape, Twist, Vector
from symscrew.description.joints import JOINT_TYPES, Entry, JointType, Motion, rotation, translation
from symscrew.errors import DescriptionError
from symscrew.kinematics.link_quantities import Frame, Placement
from symscrew.kinematics.pairs import PAIRS, Turn
from symscrew.kinematics.pairs.prismatic_pair import Prismatic
from symscrew.program import evaluate

pytestmark = pytest.mark.slow

SLIDING_UNIVERSAL = JointType("Pa", "sliding universal", 3, (translation(0), rotation(1), rotation(2)))

MASS, COM, INERTIA = 1.5, (0.3, 0.1, -0.2), (0.02, 0.03, 0.04)

ARM = f"""
[mechanism]
name = "arm"
ground = "base"
platform = "hand"

[bodies.hand]
mass = {MASS}
com = {list(COM)}
inertia = {list(INERTIA)}

[joints.wrist]
type = "Pa"
parent = "base"
child = "hand"
point = [0, 0, 0]
axes = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]
driven = [0, 1, 2]
"""

LIMB = """
[bodies.low]
[bodies.high]

[joints.foot]
type = "U"
parent = "base"
child = "low"
point = [1, 0, -1]
axes = [[1, 0, 0], [0, 1, 0]]

[joints.leg]
type = "P"
parent = "low"
child = "high"
point = [1, 0, 0]
axes = [["-2/3", "1/3", "2/3"]]

[joints.ball]
type = "S"
parent = "high"
child = "hand"
point = [0, "1/2", 0]
"""


@pytest.fixture(autouse=True)
def with_the_type(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(JOINT_TYPES, "Pa", SLIDING_UNIVERSAL)


@cache
def lagrange() -> tuple[tuple[sympy.Expr, ...], sympy.Symbol, list[sympy.Expr]]:
    """Coordinates, the time, and Lagrange's equations of a body on a slide along z, then turned about x, about y."""
    t = sympy.Symbol("t")
    z, alpha, beta = (sympy.Function(name)(t) for name in ("z", "alpha", "beta"))
    rotation_x = sympy.Matrix(
        [[1, 0, 0], [0, sympy.cos(alpha), -sympy.sin(alpha)], [0, sympy.sin(alpha), sympy.cos(alpha)]]
    )
    rotation_y = sympy.Matrix(
        [[sympy.cos(beta), 0, sympy.sin(beta)], [0, 1, 0], [-sympy.sin(beta), 0, sympy.cos(beta)]]
    )
    turned = rotation_x * rotation_y
    place = sympy.Matrix([0, 0, z]) + turned * sympy.Matrix(COM)
    velocity = place.diff(t)
    spin = turned.T * turned.diff(t)
    omega = sympy.Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])
    kinetic = MASS * velocity.dot(velocity) / 2 + sum(j * w**2 for j, w in zip(INERTIA, omega, strict=True)) / 2
    lagrangian = kinetic - MASS * sympy.Float("9.81") * place[2]
    forces = [lagrangian.diff(x.diff(t)).diff(t) - lagrangian.diff(x) for x in (z, alpha, beta)]
    return (z, alpha, beta), t, forces


def by_hand(q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
    """Drives by these equations."""
    coordinates, t, forces = lagrange()
    values = {}
    for symbol, x, speed, gain in zip(coordinates, q, v, a, strict=True):
        values |= {symbol.diff(t, 2): gain, symbol.diff(t): speed, symbol: x}
    result = []
    for force in forces:
        for symbol in sorted(values, key=lambda s: -sympy.count_ops(s) - 10 * len(getattr(s, "variables", ()))):
            force = force.subs(symbol, values[symbol])
        result.append(float(force))
    return np.array(result)


def drives(text: str, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
    model = symscrew.derive(symscrew.description.parse_description(text))
    program = model.programs["inverse_dynamics"]
    known = {"q": q, "v": v, "a": a}
    return evaluate(program, [known[port.name][None] for port in program.inputs])[0][0][0]


def test_inverse_dynamics_of_an_arm_are_those_by_hand() -> None:
    q, v, a = np.array([0.2, 0.7, -0.4]), np.array([0.3, -1.1, 0.8]), np.array([0.5, 2.0, -1.5])
    found = drives(ARM, q, v, a)
    assert np.abs(found).min() > 0.01
    assert found == pytest.approx(by_hand(q, v, a), rel=1e-12)


def test_a_massless_limb_adds_a_loop_and_no_force() -> None:
    """Three freedoms on the joint, six on the limb, one loop: Pa in the tree, the ball cut."""
    mechanism = symscrew.description.parse_description(ARM + LIMB)
    found = symscrew.analyse_mobility(mechanism)
    assert found.dof == 3
    system = symscrew.derive(mechanism).system
    assert [cut.joint.name for cut in system.cuts] == ["ball"]
    assert [c.label for c in system.tree.q if c.joint == "wrist"] == ["wrist.0", "wrist.1", "wrist.2"]
    q, v, a = (array[2] for array in system.sample_states)
    own = [k for k, c in enumerate(system.tree.q) if c.joint == "wrist"]
    assert np.abs(q[own]).min() > 1e-3
    assert drives(ARM + LIMB, q, v, a) == pytest.approx(by_hand(q[own], v[own], a[own]), rel=1e-9)


def test_a_joint_type_whose_constraint_is_not_known_is_not_cut() -> None:
    """A hinge between the same bodies is cut, though it is driven; of two such joints one would have to be cut."""
    (cut,) = symscrew.derive(symscrew.description.parse_description(BOTH)).system.cuts
    assert cut.joint.name == "hinge"
    two = BOTH.replace('type = "R"', 'type = "Pa"').replace("axes = [[1, 0, 0]]\ndriven", f"axes = {AXES}\ndriven")
    with pytest.raises(DescriptionError, match=r"loop is cut at this joint.*sliding universal"):
        symscrew.derive(symscrew.description.parse_description(two))


AXES = "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]"
BOTH = """
[mechanism]
name = "both"
ground = "base"

[bodies.hand]
mass = 1
com = [0, 0, 1]

[joints.hinge]
type = "R"
parent = "base"
child = "hand"
point = [0, 0, 0]
axes = [[1, 0, 0]]
driven = true

[joints.wrist]
type = "Pa"
parent = "base"
child = "hand"
point = [0, 0, 0]
axes = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]
"""


class Geared(Prismatic):
    """A slide behind a gear: it moves two metres per metre of its coordinate."""

    def placement(self, tape: Tape, frame: Frame, q: Sequence[Node], turn: Turn | None = None) -> Placement:
        return super().placement(tape, frame, [2 * q[0]])

    def own_twist(self, frame: Frame, v: Sequence[Scalar]) -> Twist:
        return super().own_twist(frame, [2 * v[0]])

    def powers(self, frame: Frame, force: Vector, moment: Vector) -> tuple[Scalar, ...]:
        return (2 * super().powers(frame, force, moment)[0],)

    def unit_screws(self, frame: Frame) -> tuple[Twist, ...]:
        return tuple(screw * 2 for screw in super().unit_screws(frame))

    def absolute_screws(self, frame: Frame, placement: Placement, parent: Pose, own: Pose) -> tuple[Twist, ...]:
        return tuple(screw * 2 for screw in super().absolute_screws(frame, placement, parent, own))


def test_a_new_motion_is_a_lower_pair_and_its_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """A mass m on a geared slide, against gravity: u = 2 m (2 a + g), kinetic energy m (2 v)^2 / 2."""
    q, v = (Entry("", "length", "m"),), (Entry("", "length", "m/s"),)
    motion = Motion("G", 0, "geared translation", slides=True, q=q, v=v, parts=("",))
    monkeypatch.setitem(JOINT_TYPES, "G", JointType("G", "geared", 1, (motion,)))
    monkeypatch.setitem(PAIRS, "G", Geared())
    builder = symscrew.MechanismBuilder("lift").body("cage", mass=3, com=[0, 0, 1])
    builder.joint("gear", "G", parent="base", child="cage", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    model = symscrew.derive(builder.build())
    known = {"q": 0.3, "v": 0.5, "a": 0.7, "u": 60.0}

    def value(name: str) -> float:
        program = model.programs[name]
        return float(evaluate(program, [np.array([[known[port.name]]]) for port in program.inputs])[0][0][0, 0])

    assert value("inverse_dynamics") == pytest.approx(2 * 3 * (2 * 0.7 + 9.81), rel=1e-12)
    assert value("forward_dynamics") == pytest.approx((60.0 / 6 - 9.81) / 2, rel=1e-12)
    assert value("mass_matrix") == pytest.approx(12, rel=1e-12)

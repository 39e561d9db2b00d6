"""Thin rods as masses at their ends: drives equal to method B, and what makes a body no thin rod."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import sympy
from model_states import body_states, relative
from sympy import Matrix, Rational, cos, sin, sqrt

from symscrew import catalogue
from symscrew.algebra.elimination import solve_block
from symscrew.algebra.nodes import Tape
from symscrew.description import toml_file
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.dynamics.free_motion import Admissible
from symscrew.dynamics.rods import thin_rods
from symscrew.effects import NoGyroscopicTerms, Payload, ViscousFriction
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, transformed
from symscrew.effects.gravity import Gravity
from symscrew.functions.forward import driven
from symscrew.kinematics.system import System
from symscrew.loops.dependent_rates import Loops
from symscrew.model import Model, derive
from symscrew.reference.newton_euler_method import newton_euler

GRAVITY = (0.0, 0.0, -9.81)
PLACES = (0, 1, 4, 5, 8, 9)  # of the ends of rods on a circle, in twelfths


def rod(
    builder: MechanismBuilder, name: str, parent: str, near: Matrix, far: Matrix, thick: object = 0, across: object = 0
) -> None:
    """A rod with a universal and a spherical joint: 0.2 kg, centred at a third of its length, inertia `thick` about
    its axis; the centre of mass is `across` off it."""
    line = far - near
    axis = line / sqrt(line.dot(line))
    side = axis.cross(Matrix([0, 0, 1]))
    side = side / sqrt(side.dot(side))
    second = axis.cross(side)
    axes = [list(axis), list(side), list(second)]
    com = near + line / 3 + across * side
    builder.body(name, mass="1/5", com=list(com), inertia={"principal": [thick, "1/50", "1/50"], "axes": axes})
    builder.joint(f"{name}_U", "U", parent=parent, child=name, point=list(near), axes=[list(side), list(second)])
    builder.joint(f"{name}_S", "S", parent=name, child="top", point=list(far))


def circle(radius: object, twelfths: object, height: object) -> Matrix:
    angle = sympy.pi * Rational(twelfths, 6) if isinstance(twelfths, int) else sympy.pi * twelfths / 6
    return Matrix([radius * cos(angle), radius * sin(angle), height])


def rotary_hexapod(thick: object = 0, across: object = 0) -> Mechanism:
    """6-RUS: six driven cranks whose axes are tangents of a circle, six rods to a platform above them."""
    builder = MechanismBuilder("rotary_hexapod", platform="top")
    builder.body("top", mass=2, com=[0, 0, "2/5"], inertia=["1/50", "1/40", "1/30"])
    for k, place in enumerate(PLACES):
        foot, knee = circle(Rational(3, 10), place, 0), circle(Rational(2, 5), place, Rational(1, 20))
        tangent = circle(1, place + 3, 0)
        builder.body(f"crank{k}", mass="3/10", com=list((foot + knee) / 2), inertia=["1/2000", "1/1000", "1/1500"])
        builder.joint(f"R{k}", "R", parent="base", child=f"crank{k}", point=list(foot), axes=[list(tangent)],
                      driven=True)  # fmt: skip
        end = circle(Rational(1, 5), Rational(PLACES[k] + (1 if k % 2 else -1)), Rational(2, 5))
        rod(builder, f"rod{k}", f"crank{k}", knee, end, thick, across)
    return builder.build()


def hung_platform() -> Mechanism:
    """A platform on three rods from the ground and three driven legs."""
    builder = MechanismBuilder("hung_platform", platform="top")
    builder.body("top", mass=2, com=["1/50", 0, "2/5"], inertia=["1/50", "1/40", "1/30"])
    for k in range(3):
        rod(builder, f"rod{k}", "base", circle(Rational(2, 5), 4 * k, 0),
            circle(Rational(1, 5), Rational(4 * k + 1), Rational(2, 5)))  # fmt: skip
        foot, end = circle(Rational(3, 10), 4 * k + 2, 0), circle(Rational(1, 4), 4 * k + 3, Rational(2, 5))
        side = circle(1, 4 * k + 5, 0)
        line = end - foot
        side = side - line * side.dot(line) / line.dot(line)
        side = side / sqrt(side.dot(side))
        second = line.cross(side) / sqrt(line.dot(line))
        builder.limb(f"leg{k}", "UPS", base="base", tip="top", points=[list(foot), list(foot), list(end)],
                     axes=[[list(side), list(second)], [list(line / sqrt(line.dot(line)))], []],
                     mass=["1/2", "1/4"], com=[list(foot), list(end)], inertia=[["1/100"] * 3] * 2)  # fmt: skip
    return builder.build()


def braced_arm() -> Mechanism:
    """A chain of three links in space with a rod from the first to the third: a loop that does not hold the ground."""
    builder = MechanismBuilder("braced_arm", platform="top")
    places = [Matrix(p) for p in ([0, 0, 0], [0, Rational(1, 10), Rational(1, 2)], [Rational(3, 5), 0, Rational(3, 5)])]
    names = ("lower", "upper", "top")
    for k, (name, place) in enumerate(zip(names, places, strict=True)):
        builder.body(name, mass=k + 1, com=[Rational(k, 3), Rational(1, 10), Rational(k + 1, 4)],
                     inertia=["1/50", "1/40", "1/30"])  # fmt: skip
        axis = [[0, 0, 1], [0, 1, 0], [0, Rational(3, 5), Rational(4, 5)]][k]
        builder.joint(f"R{k}", "R", parent=("base", *names)[k], child=name, point=list(place), axes=[axis],
                      driven=k < 2)  # fmt: skip
    near, far = Matrix([Rational(1, 5), Rational(1, 5), Rational(1, 5)]), Matrix([Rational(9, 10), Rational(1, 3), 1])
    rod(builder, "brace", "lower", near, far)
    return builder.build()


def rods_of(mechanism: Mechanism, *effects: Effect) -> int:
    system = System(mechanism)
    system.use_samples()
    return len(thin_rods(system, Acting(system, (Gravity(), *effects))))


def compare(found: Model, tolerance: float = 1e-10) -> None:
    q, v, a = found.system.states(6, 11)
    (drives,), status = found("inverse_dynamics", q, v, a)
    assert np.all(status == 0)
    expected = newton_euler(found.mechanism, body_states(found, q, v, a), gravity=GRAVITY).drives
    assert relative(drives, expected) < tolerance


@pytest.mark.parametrize(("mechanism", "count"), [(rotary_hexapod, 6), (hung_platform, 3), (braced_arm, 1)])
def test_rod_mechanisms_by_method_b(mechanism: Callable[[], Mechanism], count: int) -> None:
    """Drives, and accelerations from them, by all ways."""
    built = mechanism()
    assert rods_of(built) == count
    found = derive(built)
    compare(found)
    q, v, a = found.system.states(6, 12)
    (u,), _ = found("inverse_dynamics", q, v, a)
    (back,), status = found("forward_dynamics", q, v, u)
    assert np.all(status == 0) and relative(back, a) < 1e-9


@pytest.mark.parametrize("mechanism", [rotary_hexapod, hung_platform, braced_arm])
def test_all_ways_to_accelerations_are_equal(mechanism: Callable[[], Mechanism]) -> None:
    system = System(mechanism())
    system.use_samples()
    loops = Loops(system)
    acting, drives = driven(system, [Gravity()])
    system.tape.add_samples({node: np.full(6, 0.3 + 0.1 * k) for k, node in enumerate(drives[0][1])})
    ways = Admissible(system, loops).ways(acting)
    first, *others = ([system.tape.sample(node) for node in way[1]] for way in ways)
    assert len(others) == 4
    for other in others:
        assert relative(np.array(other), np.array(first)) < 1e-9


def test_drives_of_the_delta_by_method_b() -> None:
    assert rods_of(catalogue.load("delta")) == 6
    compare(derive(catalogue.load("delta")))


def test_angles_of_thin_rods_are_not_read() -> None:
    found = derive(rotary_hexapod())
    q, v, a = found.system.states(3, 5)
    (before,), _ = found("inverse_dynamics", q, v, a)
    for k, coordinate in enumerate(found.system.tree.q):
        if coordinate.joint.startswith("rod"):
            q[:, k] += 0.3
    (after,), _ = found("inverse_dynamics", q, v, a)
    assert np.array_equal(before, after)
    assert found.programs["inverse_dynamics"].operations["trig"] == 12


def test_other_bodies_are_no_thin_rods_and_have_the_same_equations() -> None:
    for mechanism in (rotary_hexapod(thick=Rational(1, 500)), rotary_hexapod(across=Rational(1, 100))):
        assert rods_of(mechanism) == 0
        compare(derive(mechanism))


def test_what_acts_on_a_rod_makes_it_an_ordinary_body() -> None:
    delta = catalogue.load("delta")
    assert rods_of(delta, ViscousFriction("rod1a_U", 0.1)) == 5
    assert rods_of(delta, ViscousFriction("arm1_R", 0.1)) == 6
    assert rods_of(delta, NoGyroscopicTerms()) == 0
    assert rods_of(transformed(delta, (Payload("rod2b", 0.3, (0, 0, 0)),))) == 5


def test_run_time_parameters_of_rods() -> None:
    """Mass and spacing of the rods as parameters: equal to the model that has them baked."""
    text = (Path(catalogue.__file__).parent / "delta.toml").read_text(encoding="utf-8")
    baked, free = text, text
    for name, old, new in (("half_spacing", "0.04", "0.05"), ("m_rod", "0.1", "0.125")):
        head = f'[parameters.{name}]\nvalue = "{old}"\n'
        assert head in text
        baked = baked.replace(head, head.replace(old, new))
        free = free.replace(head, head + "run_time = true\n")
    other, found = derive(toml_file.parse_description(baked)), derive(toml_file.parse_description(free))
    q, v, a = other.system.states(4, 3)
    assert found.programs["inverse_dynamics"].inputs[-1].labels == ("half_spacing", "m_rod")
    (expected,), _ = other("inverse_dynamics", q, v, a)
    (got,), status = found("inverse_dynamics", q, v, a, np.array([[0.05, 0.125]] * len(q)))
    assert np.all(status == 0) and relative(got, expected) < 1e-11


POINTS = {"A": (0, 0), "B": ("-3/10", "2/5"), "E": ("1/10", "7/10"), "D": (1, "1/2"), "C": ("4/5", 0)}  # x, z
BODIES = {"crank": "AB", "coupler": "BE", "second": "DE", "arm": "CD"}


def five_bar() -> Mechanism:
    """Two driven cranks in a plane; the joint E of their couplers is the hub's."""
    builder = MechanismBuilder("two_cranks", platform="second")
    at = {name: Matrix([Rational(x), 0, Rational(z)]) for name, (x, z) in POINTS.items()}
    for k, (name, (near, far)) in enumerate(BODIES.items()):
        builder.body(name, mass=Rational(1, k + 2), com=list((at[near] + at[far]) / 2), inertia=["1/200"] * 3)
    for name, parent, child in (("A", "base", "crank"), ("B", "crank", "coupler"), ("C", "base", "arm"),
                                ("D", "arm", "second"), ("E", "coupler", "second")):  # fmt: skip
        builder.joint(name, "R", parent=parent, child=child, point=list(at[name]), axes=[[0, 1, 0]],
                      driven=name in "AC")  # fmt: skip
    return builder.build()


def stretched(found: Model) -> np.ndarray:
    """The configuration, shape (1, nq), with crank and coupler in line, E one metre from A."""
    old = {name: np.array([float(Rational(c)) for c in point]) for name, point in POINTS.items()}
    new = {**old, "E": np.array([0.6, 0.8]), "B": np.array([0.3, 0.4])}
    arm, second = (np.linalg.norm(old[far] - old[near]) for near, far in ("CD", "DE"))
    line = new["E"] - old["C"]
    size = np.linalg.norm(line)
    along = (arm**2 - second**2 + size**2) / (2 * size)
    side = np.array([line[1], -line[0]]) / size  # D stays on the right of C-E
    new["D"] = old["C"] + along * line / size + np.sqrt(arm**2 - along**2) * side
    angle = {"base": 0.0}
    for name, (near, far) in BODIES.items():
        before, after = old[far] - old[near], new[far] - new[near]
        angle[name] = np.arctan2(after[0], after[1]) - np.arctan2(before[0], before[1])  # about y
    joints = found.mechanism.joints
    return np.array([[angle[joints[c.joint].child] - angle[joints[c.joint].parent] for c in found.system.tree.q]])


def test_drives_at_a_stretched_limb_are_finite() -> None:
    """Crank and coupler in line: the crank's rate does not follow from the hub's there, but its torque is defined."""
    found = derive(five_bar())
    q = stretched(found)
    assert np.abs(found("closure", q)[0][0]).max() < 1e-14
    random = np.random.default_rng(2)
    jacobian = found("closure_jacobian", q)[0][0].reshape(len(q[0]), -1).T
    null = np.linalg.svd(jacobian)[2][np.linalg.matrix_rank(jacobian) :]
    v = (random.uniform(-1, 1, len(null)) @ null)[None, :]
    bias = found("closure_bias", q, v)[0][0][0]
    a = (-np.linalg.pinv(jacobian) @ bias + random.uniform(-1, 1, len(null)) @ null)[None, :]
    (drives,), status = found("inverse_dynamics", q, v, a)
    assert np.all(status == 0)
    expected = newton_euler(found.mechanism, body_states(found, q, v, a), gravity=GRAVITY).drives
    assert relative(drives, expected) < 1e-10


def test_two_and_three_unknowns_at_once() -> None:
    random = np.random.default_rng(4)
    for n in (2, 3):
        tape = Tape()
        values = random.uniform(-1, 1, (n, n + 2))
        nodes = [[tape.symbol(f"m{i}{j}", "1", "entry") for j in range(n + 2)] for i in range(n)]
        solutions, determinant = solve_block([dict(enumerate(row)) for row in nodes], list(range(n)))
        tape.set_samples({nodes[i][j]: values[i, j : j + 1] for i in range(n) for j in range(n + 2)})
        found = np.array([[tape.sample(solution[n + j])[0] for j in range(2)] for solution in solutions])
        assert np.allclose(found, -np.linalg.solve(values[:, :n], values[:, n:]), rtol=1e-12, atol=0)
        assert np.isclose(abs(tape.sample(determinant)[0]), abs(np.linalg.det(values[:, :n])), rtol=1e-12)

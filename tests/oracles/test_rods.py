"""Thin rods as masses at their ends: drives equal to method B, and what makes a body no thin rod."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.marks import slow
from support.model_states import body_states, relative
from support.rod_mechanisms import braced_arm, hung_platform, model, rotary_hexapod
from sympy import Matrix, Rational

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


@pytest.mark.parametrize(
    ("name", "count"),
    [slow("rotary_hexapod", 6), slow("hung_platform", 3), ("braced_arm", 1), slow("turning_hexapod", 6)],
)
def test_rod_mechanisms_by_method_b(name: str, count: int) -> None:
    """Drives, and accelerations from them, by all ways."""
    found = model(name)
    assert rods_of(found.mechanism) == count
    compare(found)
    q, v, a = found.system.states(6, 12)
    (u,), _ = found("inverse_dynamics", q, v, a)
    (back,), status = found("forward_dynamics", q, v, u)
    assert np.all(status == 0) and relative(back, a) < 1e-9


@pytest.mark.parametrize("mechanism", [slow(rotary_hexapod), slow(hung_platform), braced_arm])
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
    compare(model("delta"))


def test_angles_of_thin_rods_are_not_read() -> None:
    found = model("delta")
    q, v, a = found.system.states(3, 5)
    (before,), _ = found("inverse_dynamics", q, v, a)
    for k, coordinate in enumerate(found.system.tree.q):
        if coordinate.joint.startswith("rod"):
            q[:, k] += 0.3
    (after,), _ = found("inverse_dynamics", q, v, a)
    assert np.array_equal(before, after)
    assert found.programs["inverse_dynamics"].operations["trig"] == 6  # of the three cranks


@pytest.mark.parametrize("mechanism", [braced_arm, slow(rotary_hexapod)])
@pytest.mark.parametrize(("thick", "across"), [(Rational(1, 500), 0), (0, Rational(1, 100))])
def test_other_bodies_are_no_thin_rods_and_have_the_same_equations(
    mechanism: Callable[..., Mechanism], thick: object, across: object
) -> None:
    other = mechanism(thick=thick, across=across)
    assert rods_of(other) == 0
    compare(derive(other))


def test_what_acts_on_a_rod_makes_it_an_ordinary_body() -> None:
    delta = catalogue.load("delta")
    assert rods_of(delta, ViscousFriction("rod1a_U", 0.1)) == 5
    assert rods_of(delta, ViscousFriction("arm1_R", 0.1)) == 6
    assert rods_of(delta, NoGyroscopicTerms()) == 6  # a rod without inertia about itself has none to leave out
    assert rods_of(transformed(delta, (Payload("rod2b", 0.3, (0, 0, 0)),))) == 5


@pytest.mark.slow
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

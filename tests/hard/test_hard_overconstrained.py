"""Overconstrained and redundantly driven mechanisms: accelerations unique and right, internal loads named.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import dataclasses
from functools import cache

import numpy as np
import pytest
from support.model_states import body_states, relative
from support.model_states import model as catalogued
from support.runs import POINTS, error_of, prepared, run_of, scene_of

from hard import case, precise
from hard.mechanisms import benchmark_text, chain, changed, coupling
from symscrew.algebra import elimination
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects.dry_friction import DryFriction
from symscrew.effects.gravity import Gravity
from symscrew.model import Model, derive
from symscrew.reference.newton_euler_method import newton_euler
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.motion import Run, evaluated, simulate

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these runs would take minutes")
DOWN = (Gravity((0, "-9.81", 0)),)
ROD5 = '[bodies.rod5]\nmass = 1\ncom = [0, "-1/2", 1]\ninertia = ["across", "axial", "across"]'
VARIANTS = {
    "square": (),
    "massless_rod5": ((ROD5, "[bodies.rod5]"),),
    "slender": (('value = "(0.01 + 0.01)/12"', 'value = "0"'), ('value = "(1 + 0.01)/12"', 'value = "1/12"')),
}


def bricard(variant: str, *more: tuple[str, str]) -> Mechanism:
    return changed(benchmark_text("bricard"), *VARIANTS[variant], *more)


def backwards(mechanism: Mechanism) -> Mechanism:
    """The same loop with every joint the other way round and in the other order: another tree, another cut."""
    joints = {
        name: dataclasses.replace(joint, parent=joint.child, child=joint.parent)
        for name, joint in reversed(mechanism.joints.items())
    }
    return dataclasses.replace(mechanism, joints=joints)


def fallen(mechanism: Mechanism, tolerance: float = 1e-9) -> tuple[Run, np.ndarray]:
    """10 s from rest, and P3 (n, 3) along it."""
    run = simulate(Scene("bricard", mechanism, DOWN, 10.0, 10.0, integrator=Integrator(tolerance=tolerance)))
    assert run.ok, run.status
    positions = evaluated(run.model, "forward_kinematics", {"q": run.q})["positions"].reshape(len(run.t), -1, 3)
    return run, positions[:, list(mechanism.points).index(POINTS["bricard"])]


# -- Bricard ----------------------------------------------------------------------------------------------


@needs_compiler
def test_bricard_of_square_rods() -> None:
    """10 s against the 113-bit reference; the redundant row is found and named."""
    assert "|P3-ref| <= 1e-9" in case(4)["pass_criterion"]
    run = run_of("bricard", scene_of("bricard", tolerance=1e-9))
    assert run.ok and error_of("bricard", run) < 1e-9
    assert np.abs(run.energy_balance).max() < 1e-9
    forward = run.model.programs["forward_dynamics"]
    rows_of_closure = [row.label for cut in run.model.system.cuts for row in cut.rows]
    assert len(rows_of_closure) == 5 and forward.regular == 4
    assert any(note.startswith("redundant closure constraints") for note in run.model.notes)
    assert any("1 internal load undetermined" in note for note in run.model.notes)


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("number, variant", [(5, "massless_rod5"), (24, "slender")])
def test_bricard_with_a_rod_without_mass_or_without_axial_inertia(number: int, variant: str) -> None:
    """The mass matrix of the tree is singular; that of the admissible motions is not.

    The reference is the same loop backwards (another tree, cut and order of elimination) at a tolerance 100 times
    tighter. Its error, by its energy, is 3e-9 J of 25 J, and by runs at other tolerances 1e-11 m.
    """
    assert "|P3-ref|" in case(number)["pass_criterion"]
    mechanism = bricard(variant)
    first, points = fallen(mechanism)
    run, expected = fallen(backwards(mechanism), tolerance=1e-11)
    assert np.abs(points - expected).max() < 1e-9
    assert np.abs(first.energy_balance).max() < 1e-9
    assert np.abs(points - points[0]).max() > 0.1  # it moves
    (mass,), _ = run.model("mass_matrix", run.q[7])
    n = len(run.v[0])
    matrix = mass.reshape(n, n)
    if variant == "slender":
        assert np.linalg.eigvalsh(matrix)[0] > -1e-14
    forward = run.model.programs["forward_dynamics"]
    (a,), status = run.model("forward_dynamics", run.q[7], run.v[7])
    q = precise.settled(run.model, run.q[7], 4)
    assert status <= 0 and forward.regular == 4
    assert relative(a, precise.doubles(precise.accelerations(run.model, q, run.v[7], [], 4))) < 1e-10


def test_a_redundant_row_taken_as_a_pivot_is_what_the_samples_prevent(monkeypatch: pytest.MonkeyPatch) -> None:
    """The guard taken out: entries that vanish on the manifold may be pivots. Then a pivot is rounding noise.

    As seen: five pivots instead of four, no independent coordinate left, so that nothing can move any more.
    """
    assert len(prepared("bricard")[0].programs["velocity"].inputs[1].labels) == 1
    monkeypatch.setattr(elimination, "NEGLIGIBLE", 0.0)
    found = derive(bricard("square"), DOWN)
    assert found.programs["forward_dynamics"].regular == 5
    assert "independent coordinates y: none" in found.notes


def test_a_motor_on_each_of_six_joints_for_one_freedom() -> None:
    """Minimum-norm torques are those of the pseudo-inverse, power balances, five internal loads are reported."""
    assert "null space dimension 5" in case(6)["pass_criterion"]
    text = benchmark_text("bricard")
    for k in range(1, 7):
        text = text.replace(f"[joints.R{k}]\n", f"[joints.R{k}]\ndriven = true\n")
    found = derive(changed(text), DOWN)
    assert len(found.system.drives) == 6
    assert any("5 more drives than freedoms" in note for note in found.notes)
    q, v, a = (x[1:] for x in found.system.sample_states)
    (u,), status = found("inverse_dynamics", q, v, a)
    assert not status.any()
    (rates,), _ = found("drive_rates", q, v)
    for k in range(len(q)):
        direction = rates[k] / np.linalg.norm(rates[k])
        assert np.abs(u[k] - direction * (u[k] @ direction)).max() < 1e-10 * np.abs(u[k]).max()  # pinv of a row
        states = body_states(found, q[k : k + 1], v[k : k + 1], a[k : k + 1])
        expected = newton_euler(found.mechanism, states, gravity=(0, -9.81, 0))
        assert relative(u[k], expected.drives[0]) < 1e-10
        assert expected.drive_redundancy[0] == 5
    # power of the drives = rate of energy, by a difference of the energy along the motion in 50 digits
    h = precise.MP.mpf("1e-12")
    for k in range(2):
        ends = []
        for sign in (1, -1):
            at = [precise.MP.mpf(x) + sign * h * y + h * h / 2 * z for x, y, z in zip(q[k], v[k], a[k], strict=True)]
            rate = [precise.MP.mpf(y) + sign * h * z for y, z in zip(v[k], a[k], strict=True)]
            ends.append(precise.MP.fsum(precise.walked(found.programs["energy"], at, rate)[0]))
        power = float((ends[0] - ends[1]) / (2 * h))
        assert abs(power - u[k] @ rates[k]) < 1e-9  # W, of up to 4 W


# -- other overconstrained loops ---------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["bennett", "sarrus"])
def test_accelerations_are_unique_and_right(name: str) -> None:
    """At random drives: Newton-Euler in maximal coordinates needs just these drives for them.

    By the first and by the second path, whose choices differ: they agree, so nothing depends on the choice.
    """
    found = catalogued(name)
    q, v, _ = found.system.sample_states
    u = np.random.default_rng(6).uniform(-5, 5, (len(q), len(found.system.drives)))
    (a,), status = found("forward_dynamics", q, v, u)
    assert not status.any()
    solution = newton_euler(found.mechanism, body_states(found, q, v, a))
    assert relative(solution.drives, u) < 1e-10
    assert solution.residual.max() < 1e-10
    assert (solution.reaction_redundancy >= 1).all()  # overconstrained, yet the drives are unique
    assert not solution.drive_redundancy.any()
    rank = found.programs["forward_dynamics"].regular
    expected = [precise.doubles(precise.accelerations(found, q[k], v[k], u[k], rank)) for k in (1, 2)]
    assert relative(a[1:3], np.array(expected)) < 1e-11


@cache
def bent() -> Model:
    return derive(coupling("pi/3"), ())


@pytest.mark.parametrize("phi", [-2.5, 0.0, 0.4, 1.3, np.pi / 2, 3.0])
def test_spherical_four_bar(phi: float) -> None:
    """A universal joint as four axes through a point, bent by 60 degrees, against its closed form."""
    found = bent()
    rate, torque, names = 4.0, 0.9, [c.label for c in found.system.tree.q]
    q = found.system.reference
    for part in np.linspace(0, phi, 5)[1:]:
        (q,), status = found("assemble", [part], q)
        assert status == 0
    (v,), _ = found("velocity", q, [rate])
    (a,), status = found("forward_dynamics", q, v, [torque])
    floor = 1 - 0.75 * np.sin(phi) ** 2
    ratio, slope = 0.5 / floor, 0.5 * 2 * 0.75 * np.sin(phi) * np.cos(phi) / floor**2
    expected = (torque - 0.05 * ratio * slope * rate**2) / (0.02 + 0.05 * ratio**2)
    assert status == 0 and a[names.index("A")] == pytest.approx(expected, rel=1e-12, abs=1e-11)
    assert found.programs["forward_dynamics"].regular == 2  # of five rows


def hinged(*heights: str) -> Mechanism:
    """A door of 0.8 x 2 m and 20 kg on hinges along z at `heights`; with one hinge it is statically determined."""
    builder = MechanismBuilder("door")
    builder.body("door", mass=20, com=["2/5", 0, 1], inertia=["20*4/12", "20*4/12 + 20*0.64/12", "20*0.64/12"])
    for k, height in enumerate(heights):
        builder.joint(
            f"hinge{k}", "R", parent="base", child="door", point=[0, 0, height], axes=[[0, 0, 1]], driven=k == 0
        )
    return builder.build()


@pytest.mark.parametrize("heights", [("1",), ("1/4", "7/4"), ("1/4", "1", "7/4"), ("1/4", "1/4 + 1e-9", "7/4")])
def test_parallel_door_hinges(heights: tuple[str, ...]) -> None:
    """a = torque/J whatever the number of hinges, also where two of them nearly coincide; they share the weight."""
    found = derive(hinged(*heights))
    q, v, u = [0.7], [2.0], [3.0]
    (a, reactions), status = found("forward_dynamics_reactions", q, v, u)
    inertia = 20 * 0.64 / 12 + 20 * 0.16
    assert status <= 0 and a[0] == pytest.approx(3.0 / inertia, rel=1e-13)
    total = reactions.reshape(-1, 6).sum(axis=0)
    turn = np.array([[np.cos(0.7), -np.sin(0.7)], [np.sin(0.7), np.cos(0.7)]])
    radial = 20 * (turn @ [-0.4 * 4.0, 0.4 * a[0]])
    assert total[:3] == pytest.approx([*radial, 20 * 9.81], rel=1e-12)
    if len(heights) > 1:
        assert any(f"{5 * (len(heights) - 1)} internal loads" in note for note in found.notes)
        shares = reactions.reshape(-1, 6)[:, 2]
        assert shares == pytest.approx(np.full(len(heights), 20 * 9.81 / len(heights)), rel=1e-9)


@needs_compiler
def test_friction_on_two_collinear_guides() -> None:
    """How two guides share a load is not determined: the model takes the minimum norm and says so.

    Forces are in parallel, so their sizes add up to the weight and friction brakes with mu g (v0 << v).
    """
    assert "minimum norm AND says so" in case(16)["pass_criterion"]
    joints = [(f"guide{k}", "P", "base", "slider", [k, 0, 0], [[1, 0, 0]]) for k in (0, 1)]
    slider = chain("slider", *joints, slider={"mass": 2, "com": ["1/2", 0, 0], "inertia": [1, 1, 1]})
    effects = (Gravity(), *(DryFriction(f"guide{k}", load="0.2", velocity="1e-6") for k in (0, 1)))
    scene = Scene(
        "guides", slider, effects, 0.4, 100.0, Initial(rates={"guide0": 1.0}), integrator=Integrator(tolerance=1e-10)
    )
    run = simulate(scene)
    assert run.ok, run.status
    assert any("undetermined, minimum-norm values are taken" in note for note in run.model.notes)
    assert np.abs(run.energy_balance).max() < 1e-8
    lost = run.energy[0].sum() - run.energy.sum(axis=1)
    assert np.abs(lost - 0.2 * 2 * 9.81 * run.q[:, 0]).max() < 1e-8
    assert np.abs(run.v[:, 0] - (1 - 0.2 * 9.81 * run.t)).max() < 1e-8

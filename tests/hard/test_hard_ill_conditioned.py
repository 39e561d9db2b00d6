"""Ill-conditioned models: digits lost against 50-digit arithmetic, the same whatever the unit, the place and the scale.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest
from support.marks import slow
from support.model_states import relative
from support.runs import error_of, run_of, scene_of

from hard import case, precise
from hard.mechanisms import Z, benchmark_text, catalogue_text, chain, changed, four_bars
from symscrew import catalogue
from symscrew.algebra import elimination
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects.gravity import Gravity
from symscrew.effects.joint_spring import JointSpring
from symscrew.mobility.analysis import analyse_mobility
from symscrew.model import Model, derive
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.motion import Run, simulate

pytestmark = pytest.mark.slow

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these runs would take minutes")
DOWN = (Gravity((0, "-9.81", 0)),)


def lost(found: Model, q: np.ndarray, v: np.ndarray, u: Sequence[float], rank: int | None = None) -> float:
    """Relative error of forward dynamics against 50 digits at the same inputs; the status must be at most 0."""
    forward = found.programs["forward_dynamics"]
    given = [x for x, port in zip((q, v, u), ("q", "v", "u"), strict=True) if port in [p.name for p in forward.inputs]]
    (a,), status = found("forward_dynamics", *given)
    assert status <= 0
    expected = precise.doubles(
        precise.accelerations(found, *given, *([[]] * (3 - len(given))), rank=rank or forward.regular)
    )
    return relative(a, expected)


def states(found: Model, count: int = 2) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    q, v, _ = found.system.sample_states
    u = np.random.default_rng(9).uniform(-1, 1, (len(q), len(found.system.drives)))
    return [(q[k], v[k], u[k]) for k in range(1, count + 1)]


# -- masses ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ratio", ["1e-9", "1e-6", "1e-3", "1e3", "1e6", "1e9"])
def test_mass_ratios_in_a_loop(ratio: str) -> None:
    """The coupler of a general four-bar light or heavy: at most three of sixteen digits lost."""
    text = catalogue_text("four_bar")
    mass, com = 'mass = "1.2"', 'com = ["1/5", 0, "3/10"]'
    rows = [["9/1000", "0", "-3/250"], ["0", "1/40", "0"], ["-3/250", "0", "2/125"]]
    given = 'inertia = [["9/1000", 0, "-3/250"], [0, "1/40", 0], ["-3/250", 0, "2/125"]]'
    other = "inertia = [" + ", ".join("[" + ", ".join(f'"({e})*{ratio}"' for e in row) + "]" for row in rows) + "]"
    found = derive(changed(text, (f"{mass}\n{com}\n{given}", f'mass = "1.2*{ratio}"\n{com}\n{other}')))
    assert max(lost(found, *state) for state in states(found)) < 1e-13


@needs_compiler
@pytest.mark.parametrize("ratio", ["1e-9", "1e9"])
def test_mass_ratios_through_singular_positions(ratio: str) -> None:
    """A02 with N = 2 and couplers of 1e-9 ... 1e9 kg: 10 s through ten singular positions to 1e-8.

    The tolerance is the same for all; only at 1, 5 and 10 s are there references (50 digits).
    """
    assert "theta error <= 1e-8" in case(7)["pass_criterion"]
    mechanism = four_bars(2, coupler=ratio)
    scene = Scene(
        "ratio", mechanism, DOWN, 10.0, 1.0, Initial(rates={"A0": -1.0}), integrator=Integrator(tolerance=1e-11)
    )
    run = simulate(scene)
    assert run.ok, run.status
    column = [c.label for c in run.model.system.tree.q].index("A0")
    errors = []
    for time, angle, rate in case(7)["reference"][ratio]:
        k = int(np.abs(run.t - float(time)).argmin())
        errors.append(abs(-run.q[k, column] - float(angle)))
        assert abs(-run.v[k, column] - float(rate)) < 1e-7
    assert max(errors) < 1e-8, errors


@pytest.mark.slow
def test_nearly_massless_limbs() -> None:
    """Limbs of the seed with 1e-12 of their masses: no digit lost beyond the first four."""
    model = derive(_lighter(catalogue.load("three_ups_upu_s_physical"), "1e-12"))
    assert max(lost(model, *state) for state in states(model, 1)) < 1e-12


def _lighter(mechanism: Mechanism, factor: str) -> Mechanism:
    """The mechanism with all bodies but the platform lighter by a factor."""
    import sympy

    f = sympy.Rational(factor)
    bodies = {
        name: body if body.mass is None or name == mechanism.platform else dataclasses.replace(
            body, mass=body.mass * f, inertia=tuple(tuple(e * f for e in row) for row in body.inertia)
        )
        for name, body in mechanism.bodies.items()
    }  # fmt: skip
    return dataclasses.replace(mechanism, bodies=bodies)


@needs_compiler
def test_light_cart() -> None:
    """The mass matrix loses six digits where the pole hangs: right to 1e-6 over 10 s."""
    assert "1e-6 kg cart" in case(8)["name"]
    run = run_of("light_cart_pole", scene_of("light_cart_pole"))
    assert run.ok and error_of("light_cart_pole", run) < 1e-6


# -- scales, units and places -----------------------------------------------------------------------------------


def scaled(factor: str, shift: str = "0") -> Mechanism:
    """A four-bar of unequal links of about `factor` metres (masses 1 kg), with its origin `shift` metres away."""

    def at(x: str, y: str) -> list[str]:
        return [f"({x})*({factor}) + ({shift})", f"({y})*({factor}) - 2*({shift})", f"({shift})/3"]

    builder = MechanismBuilder("bar")
    inertia = f"({factor})^2/10"
    for name, com in (("crank", ("0", "1/5")), ("coupler", ("1/2", "3/4")), ("rocker", ("6/5", "1/2"))):
        builder.body(name, mass=1, com=at(*com), inertia=[inertia, inertia, inertia])
    links = (
        ("A", "base", "crank", "0", "0"),
        ("B", "crank", "coupler", "0", "2/5"),
        ("C", "coupler", "rocker", "1", "11/10"),
    )
    for name, parent, child, x, y in (*links, ("D", "base", "rocker", "7/5", "0")):
        builder.joint(name, "R", parent=parent, child=child, point=at(x, y), axes=[Z], driven=name == "A")
    return builder.build()


@cache
def of_size(factor: str, shift: str = "0") -> Model:
    return derive(scaled(factor, shift), ())


@pytest.mark.parametrize("factor", ["1e-6", "1e-3", "1e3", "1e6"])
def test_links_of_micrometres_and_of_a_thousand_kilometres(factor: str) -> None:
    """Angles do not know the unit: the same accelerations under torques in proportion to factor^2, the same status.

    Thresholds have no unit: divided by the characteristic length. At most two digits lost against 50 digits.
    """
    found, unit = of_size(factor), of_size("1")
    for q, v, u in states(unit):
        (expected,), _ = unit("forward_dynamics", q, v, u)
        (a,), status = found("forward_dynamics", q, v, u * float(factor) ** 2)
        assert status == 0 and relative(a, expected) < 1e-13
        assert lost(found, q, v, u * float(factor) ** 2) < 1e-14
    for function in ("constraint_margin", "actuation_margins"):
        (margin,), _ = found(function, unit.system.reference)
        (same,), _ = unit(function, unit.system.reference)
        assert relative(margin, same) < 1e-12


@pytest.mark.parametrize("shift, digits", [("1e3", 1e-12), ("1e5", 1e-10)])
def test_far_from_the_origin(shift: str, digits: float) -> None:
    """1e5 m from O, axes and origin of different size: accelerations as at O, five digits of closure fewer at most.

    Parts are placed against their joints, not against O, so that nearly nothing is lost; reactions at O, as wrenches
    (f ; m_O), do carry the arm of 1e5 m.
    """
    found, unit = of_size("1", shift), of_size("1")
    for q, v, u in states(unit):
        (expected,), _ = unit("forward_dynamics", q, v, u)
        (a,), status = found("forward_dynamics", q, v, u)
        assert status == 0 and relative(a, expected) < digits
        assert lost(found, q, v, u) < digits
        (residual,), _ = found("closure", q)
        assert np.abs(residual).max() < 1e-15 * float(shift) + 1e-14


def in_units(text: str, *, millimetres: bool, grams: bool) -> Mechanism:
    """Bricard's mechanism with lengths in mm or masses in g."""
    if millimetres:
        for old in ("1/2", "-1/2"):
            text = text.replace(f'"{old}"', f'"1000*({old})"')
        lines = []
        for line in text.splitlines():
            if line.startswith(("com", "point ", "at ")):
                head, values = line.split("=", 1)
                longer = re.sub(r"(?<=[ ,[])(-?)1(?=[],])", r"\g<1>1000", values)
                line = f"{head}={longer}"
            lines.append(line)
        text = "\n".join(lines)
        for old in ("(0.01 + 0.01)/12", "(1 + 0.01)/12"):
            text = text.replace(old, f"{old}*1e6")
    if grams:
        text = text.replace("mass = 1\n", "mass = 1000\n")
        text = text.replace('/12"', '/12*1000"').replace('/12*1e6"', '/12*1e9"')
    return changed(text)


def fallen(mechanism: Mechanism, gravity: str) -> Run:
    acting = (Gravity((0, gravity, 0)),)
    return simulate(Scene("units", mechanism, acting, 10.0, 5.0, integrator=Integrator(tolerance=1e-10)))


@cache
def in_metres() -> Run:
    return fallen(changed(benchmark_text("bricard")), "-9.81")


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("millimetres, grams", [(True, False), (False, True)])
def test_millimetres_and_grams(millimetres: bool, grams: bool) -> None:
    """The same run in other units: positions by 1000 equal to 1e-10, the same rank, the same independent coordinate.

    A threshold in metres would decide otherwise for lengths a thousand times larger.
    """
    assert "no tolerance in absolute metres" in case(9)["pass_criterion"]
    gravity = "-9810" if millimetres else "-9.81"
    runs = [in_metres(), fallen(in_units(benchmark_text("bricard"), millimetres=millimetres, grams=grams), gravity)]
    assert all(run.ok for run in runs)
    models = [run.model for run in runs]
    assert models[0].programs["forward_dynamics"].regular == models[1].programs["forward_dynamics"].regular == 4
    assert models[0].notes[0] == models[1].notes[0]
    assert models[1].system.length == pytest.approx(models[0].system.length * (1000 if millimetres else 1), rel=1e-6)
    assert np.abs(runs[0].q - runs[1].q).max() < 1e-10


@pytest.mark.slow
@needs_compiler
def test_millimetres_and_grams_through_singular_positions() -> None:
    """A02 with N = 2: the same angles to 1e-10 over two crossings, the same crossings with the same lost rows."""
    assert case(9)["scenario"].startswith("A02 N=2")
    falls = {"m": "-9.81", "mm": "-9810", "g": "-9.81"}
    bars = {"m": {}, "mm": {"width": "1000", "length": "1000"}, "g": {"link": "1000", "coupler": "1000"}}
    start, fine = Initial(rates={"A0": -1.0}), Integrator(tolerance=1e-11)
    runs = {
        unit: simulate(
            Scene(unit, four_bars(2, **bars[unit]), (Gravity((0, g, 0)),), 2.0, 10.0, start, integrator=fine)
        )
        for unit, g in falls.items()
    }
    for run in runs.values():
        assert run.ok and np.abs(run.q - runs["m"].q).max() < 1e-10
        assert run.model.programs["forward_dynamics"].regular == runs["m"].model.programs["forward_dynamics"].regular
        assert [c.rows for c in run.crossings] == [c.rows for c in runs["m"].crossings]
    assert len(runs["m"].crossings) == 2


# -- axes that are nearly parallel, drives that nearly coincide -----------------------------------------------------


def tilted_bar(angle: str) -> Mechanism:
    """A planar four-bar whose last axis is tilted by `angle` [rad] in its plane with x."""
    builder = MechanismBuilder("tilted")
    for name, com in (("crank", ("0", "1/5")), ("coupler", ("1/2", "3/4")), ("rocker", ("6/5", "1/2"))):
        builder.body(name, mass=1, com=[*com, 0], inertia=["1/10", "1/10", "1/10"])
    links = (
        ("A", "base", "crank", "0", "0"),
        ("B", "crank", "coupler", "0", "2/5"),
        ("C", "coupler", "rocker", "1", "11/10"),
    )
    for name, parent, child, x, y in (*links, ("D", "base", "rocker", "7/5", "0")):
        axis = [f"sin({angle})", 0, f"cos({angle})"] if name == "D" and angle != "0" else Z
        builder.joint(name, "R", parent=parent, child=child, point=[x, y, 0], axes=[axis])
    return builder.build()


@cache
def planar_bar() -> Model:
    assert analyse_mobility(tilted_bar("0")).dof == 1
    return derive(tilted_bar("0"), DOWN)


@pytest.mark.parametrize("angle", [slow("1e-3"), slow("1e-6"), slow("1e-9"), "1e-12"])
def test_one_axis_nearly_parallel_to_the_others(angle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Exactly, the loop is rigid for every angle > 0, and mobility says so with the smallest singular value.

    A model's samples decide by `elimination.NEGLIGIBLE`, 1e-9 of the largest entry: 0 freedoms down to 1e-9, 1 at
    1e-12, where the tilt drowns in the samples' rounding; its notes say which. Under a tolerance above the tilt the
    loop has its one freedom and the accelerations of the planar loop.
    """
    assert "0 dof for every eps > 0" in case(25)["pass_criterion"]
    tilt, planar = float(angle), planar_bar()
    analysis = analyse_mobility(tilted_bar(angle))
    assert analysis.dof == 0 and analysis.decisions.singular_values[0] == pytest.approx(0.18354 * tilt, rel=1e-3)
    found = derive(tilted_bar(angle), DOWN)
    _, jacobian = precise.closure(found, planar.system.reference)
    values = [float(x) for x in precise.singular_values(jacobian)]
    assert 0.01 * tilt < values[2] < 10 * tilt  # the smallest: exactly, three rates and rank three
    strict = "A" if angle == "1e-12" else "none"
    assert f"independent coordinates y: {strict}" in found.notes
    monkeypatch.setattr(elimination, "NEGLIGIBLE", 10 * tilt)
    loose = derive(tilted_bar(angle), DOWN)
    assert "independent coordinates y: A" in loose.notes
    q, v = planar.system.reference, np.array(planar.system.sample_states[1][0])
    (a,), status = loose("forward_dynamics", q, v)
    (expected,), _ = planar("forward_dynamics", q, v)
    assert status <= 0 and relative(a, expected) < 1e-6


def nearly_equal_legs(gap: str) -> Mechanism:
    """A slider pushed by two cylinders whose feet are `gap` metres apart: one freedom, two drives."""
    builder = MechanismBuilder("pushed", platform="slider")
    builder.body("slider", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("guide", "P", parent="base", child="slider", point=[0, 0, 0], axes=[[1, 0, 0]])
    for k, place in enumerate(("0", gap)):
        builder.body(f"tube{k}", mass=1, com=[-1, f"3/4 + {place}", 0], inertia=["1/10", "1/10", "1/10"])
        builder.body(f"rod{k}", mass=1, com=["-1/2", f"1/4 + {place}/2", 0], inertia=["1/10", "1/10", "1/10"])
        foot = [-1, f"1 + {place}", 0]
        along = [f"1/sqrt(1 + (1 + {place})^2)", f"-(1 + {place})/sqrt(1 + (1 + {place})^2)", 0]
        builder.joint(f"foot{k}", "R", parent="base", child=f"tube{k}", point=foot, axes=[Z])
        builder.joint(f"leg{k}", "P", parent=f"tube{k}", child=f"rod{k}", point=foot, axes=[along], driven=True)
        builder.joint(f"head{k}", "R", parent=f"rod{k}", child="slider", point=[0, 0, 0], axes=[Z])
    return builder.build()


@pytest.mark.parametrize("gap", ["1e-3", "1e-6", "1e-9", "1e-12"])
def test_redundant_drives_that_nearly_coincide(gap: str) -> None:
    """Two legs apart by 1e-3 ... 1e-12 m on one slider: forces of smallest sum of squares, nearly equal.

    Nothing is divided by the difference of the two: the forces stay those of the pseudo-inverse, and accelerations
    those of 50 digits, to twelve digits.
    """
    found = derive(nearly_equal_legs(gap))
    assert any("1 more drives than freedoms" in note for note in found.notes)
    q, v, a = (x[1:4] for x in found.system.sample_states)
    (u,), status = found("inverse_dynamics", q, v, a)
    (rates,), _ = found("drive_rates", q, v)
    assert not status.any() and np.abs(u).max() < 1e3
    for force, rate in zip(u, rates, strict=True):
        along = rate / np.linalg.norm(rate)
        assert np.abs(force - along * (along @ force)).max() < 1e-12 * np.abs(force).max()
    (again,), status = found("forward_dynamics", q, v, u)
    assert (status <= 0).all() and relative(again, a) < 1e-12
    assert max(lost(found, *state) for state in zip(q, v, u, strict=True)) < 1e-12


# -- stiffness ------------------------------------------------------------------------------------------------------


@needs_compiler
def test_stiff_governor() -> None:
    """A05: springs of 8e5 N/m with 4e4 N s/m for 10 s: s to 1e-6 by the explicit method, which is bound by stability.

    The run says so, and how long a stable step is: above it RK4 fails, below it does not, where accuracy would allow
    more. Runs that are not stiff say nothing of it.
    """
    assert "A05 |s-ref| <= 1e-6; explicit step limit reported" in case(19)["pass_criterion"]
    run = run_of("flyball_governor", scene_of("flyball_governor"))
    assert run.ok and error_of("flyball_governor", run) < 1e-6
    assert "are bound by the longest at which dop853 is stable" in run.events[-1]
    limit = run.counters["longest_stable_step"] * 2.785 / 6.39
    for part, stable in ((1.2, False), (0.8, True)):
        other = run_of("flyball_governor", scene_of("flyball_governor", until=0.2, method="rk4", step=part * limit))
        assert other.ok == stable
    assert not run_of("light_cart_pole", scene_of("light_cart_pole", until=1.0)).events


@needs_compiler
@pytest.mark.parametrize("stiffness", ["1e4", "1e8"])
def test_two_masses_joined_by_a_spring(stiffness: str) -> None:
    """k = 1e4 and 1e8 N/m, undamped: stretch -(1 - cos(sqrt(2 k) t)) N/k in closed form, to 1e-6 of itself, and the
    mean of both moves as one body; the ways are those of a rigid joint to twice the stretch.
    """
    run = simulate(pulled_pair(stiffness, Integrator(tolerance=1e-9), duration=0.1))
    assert run.ok, run.status
    k = float(stiffness)
    stretch = -(1 - np.cos(np.sqrt(2 * k) * run.t)) / k
    assert np.abs(run.q[:, 1] - stretch).max() < 1e-6 / k
    assert np.abs(run.q[:, 0] + stretch / 2 - run.t**2 / 2).max() < 1e-12
    assert np.abs(run.q[:, 0] - run.t**2 / 2).max() < 2 / k


def pulled_pair(stiffness: str, integrator: Integrator, duration: float = 1.0) -> Scene:
    """Two masses of 1 kg in a row, 2 N on the first, a spring between them."""
    bodies = {name: {"mass": 1, "com": [k, 0, 0], "inertia": [1, 1, 1]} for k, name in enumerate(("left", "right"))}
    pair = chain(
        "pair",
        ("slide", "P", "base", "left", [0, 0, 0], [[1, 0, 0]]),
        ("between", "P", "left", "right", [1, 0, 0], [[1, 0, 0]]),
        driven="slide",
        **bodies,
    )
    spring = JointSpring("between", stiffness=stiffness)
    return Scene("pair", pair, (spring,), duration, 10 / duration, drives={"slide": "2"}, integrator=integrator)


@pytest.mark.parametrize("stiffness", ["1e14", "1e20"])
def test_two_masses_joined_by_a_stiff_spring(stiffness: str) -> None:
    """k = 1e14 and 1e20 N/m by an implicit method: the motion is that of one rigid body, to 1e-6 of a metre in 1 s.

    The spring's deflection is a coordinate of its own: as a difference of two places it would be rounding times k.
    The explicit method's step is bound by 1/sqrt(k): with `most_steps` it stops and says so (checked at 1e20).
    """
    scene = pulled_pair(stiffness, Integrator("radau", tolerance=1e-6, most_steps=20_000))
    run = simulate(scene)
    assert run.ok, run.status
    stretch = 1.0 / float(stiffness)  # the force in the spring is 1 N, plus an oscillation of the same size
    assert np.abs(run.q[:, 0] - run.t**2 / 2).max() < 1e-6
    assert np.abs(run.q[:, 1]).max() < 1e-6 + 2 * stretch
    if stiffness == "1e20":
        explicit = simulate(dataclasses.replace(scene, integrator=Integrator(tolerance=1e-6, most_steps=20_000)))
        assert not explicit.ok and "steps" in explicit.status


# -- rows that nearly depend on each other ----------------------------------------------------------------------------


@cache
def straight_arm() -> Model:
    arm = chain(
        "arm",
        ("A", "R", "base", "one", [0, 0, 0], [Z]), ("B", "R", "one", "two", [1, 0, 0], [Z]),
        one={"mass": 1, "com": ["1/2", 0, 0], "inertia": [0, "1/12", "1/12"]},
        two={"mass": 1, "com": ["3/2", 0, 0], "inertia": [0, "1/12", "1/12"]},
    )  # fmt: skip
    return derive(arm, DOWN, derivatives=True)


@pytest.mark.parametrize("distance", ["1e-3", "1e-6", "1e-9"])
def test_derivatives_close_to_a_singular_configuration(distance: str) -> None:
    """Jacobian of forward dynamics of a pendulum chain that is 1e-9 from stretched, against 50-digit differences.

    Open chains are regular there: no digit may be lost.
    """
    found = straight_arm()
    program = found.programs["forward_dynamics_derivatives"]
    forward = found.programs["forward_dynamics"]
    q, v = np.array([0.7, float(distance)]), np.array([1.0, -2.0])
    results, status = found("forward_dynamics_derivatives", q, v)
    assert status == 0
    names = [port.name for port in program.outputs]
    h = precise.MP.mpf("1e-20")
    for name, which in (("da_dq", 0), ("da_dv", 1)):
        name = name if name in names else names[which]
        got = np.reshape(results[names.index(name)], (2, 2)).T
        for k in range(2):
            ends = []
            for sign in (1, -1):
                at = [[precise.MP.mpf(x) for x in q], [precise.MP.mpf(x) for x in v]]
                at[which][k] += sign * h
                ends.append(precise.walked(forward, *at)[0])
            expected = [float((b - a) / (2 * h)) for b, a in zip(*ends, strict=True)]
            assert relative(got[:, k], np.array(expected)) < 1e-13
    assert "near" in case(40)["pass_criterion"]

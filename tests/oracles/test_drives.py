"""Motions in, tables out: against statics and dynamics by hand, differences in time, and what cannot be."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.description import MechanismBuilder, parse_description
from symscrew.display.view import read_motion
from symscrew.effects import DcMotor, DryFriction
from symscrew.errors import DescriptionError
from symscrew.mobility import inverse_kinematics
from symscrew.reporting.motion_pages import motion_section
from symscrew.runtime import load
from symscrew.studies.given_motion import drives, load_motion, motion_of, study, study_json, study_text, write_study
from symscrew.studies.given_motion.goals import SMALL, goals_of, quaternion_of, turn_of_vector
from symscrew.studies.given_motion.wanted_motion import FEWER, NEIGHBOURS, WantedMotion, derivatives

Array = np.ndarray
ROD = """
[mechanism]
name = "rod"
platform = "rod"
[parameters]
l = { value = "0.5", unit = "m" }
[bodies.rod]
mass = 2
com = [0, 0, "-l"]
inertia = ["0.03", "0.03", 0]
[joints.pivot]
type = "R"
parent = "base"
child = "rod"
point = [0, 0, 0]
axes = [[0, 1, 0]]
driven = true
[points.tip]
body = "rod"
at = [0, 0, "-l"]
"""
MASS, LENGTH, INERTIA, FALL = 2.0, 0.5, 0.03 + 2 * 0.5**2, 9.81


@pytest.fixture(scope="module")
def rod() -> object:
    return parse_description(ROD)


def test_a_rod_that_swings_as_it_is_told(rod, tmp_path: Path) -> None:
    """phi = 0.3 sin 2t about y: moment J phi_ddot + m g l sin phi, and a force of 5 N along x at the tip taken off."""
    file = tmp_path / "swing.toml"
    file.write_text(
        '[motion]\nduration = 1.0\nrate = 40\n[coordinates]\npivot = "0.3*sin(2*t)"\n[loads.tip]\nfx = "5*t"\n'
    )
    found = drives(rod, file, backend="casadi")
    t = np.linspace(0, 1, 41)
    phi, gain = 0.3 * np.sin(2 * t), -1.2 * np.sin(2 * t)
    # tip at (-l sin phi, 0, -l cos phi): moment of (5t, 0, 0) about y is z fx
    load = 5 * t * -LENGTH * np.cos(phi)
    by_hand = INERTIA * gain + MASS * FALL * LENGTH * np.sin(phi) - load
    np.testing.assert_allclose(found.u[:, 0], by_hand, atol=1e-11)
    np.testing.assert_allclose(found.powers[:, 0], by_hand * 0.6 * np.cos(2 * t), atol=1e-11)
    rate = 0.6 * np.cos(2 * t)
    # acceleration of the tip, where the mass is: tangent (-cos, 0, sin) l, towards the pivot (sin, 0, cos) l
    along = LENGTH * (gain[:, None] * np.stack([-np.cos(phi), 0 * t, np.sin(phi)], 1)
                      + rate[:, None] ** 2 * np.stack([np.sin(phi), 0 * t, np.cos(phi)], 1))  # fmt: skip
    force = MASS * (along + np.array([0, 0, FALL])) - np.stack([5 * t, 0 * t, 0 * t], 1)
    np.testing.assert_allclose(found.wrenches["pivot"].force, force, atol=1e-11)
    assert found.ok and "agree" in found.status and found.difference is not None and found.difference < 1e-12
    told = study_json(found)
    assert told["drives"]["pivot"]["largest"] == pytest.approx(np.abs(by_hand).max(), rel=1e-12)
    assert "pivot" in study_text(found) and max(len(line) for line in study_text(found).splitlines()) < 120


@pytest.mark.slow  # seven models
def test_the_same_motion_by_other_names(rod, tmp_path: Path) -> None:
    """By the coordinate, the rotation vector, a quaternion's entry, the tip's place; by samples in either file."""
    angle = "0.3*sin(2*t)+0.2"
    first = drives(rod, {"pivot": angle}, duration=1, rate=60, backend="casadi")
    t = first.t
    phi = 0.3 * np.sin(2 * t) + 0.2
    for texts in (
        {"rod.rx": "0", "rod.ry": angle, "rod.rz": "0"},
        {"rod.qy": f"sin(({angle})/2)"},
        {"tip.x": f"-l*sin({angle})"},
        {"rod.qw": f"cos(({angle})/2)", "rod.qy": f"sin(({angle})/2)"},
    ):
        other = drives(rod, texts, duration=1, rate=60, backend="casadi")
        np.testing.assert_allclose(other.u, first.u, atol=1e-9, err_msg=str(texts))
    (tmp_path / "swing.csv").write_text(
        "t,pivot\n" + "\n".join(f"{a:.17g},{b:.17g}" for a, b in zip(t, phi, strict=True))
    )
    np.savez(tmp_path / "swing.npz", t=t + 7.0, pivot=phi)  # times may begin anywhere
    for name in ("swing.csv", "swing.npz"):
        other = drives(rod, tmp_path / name, backend="casadi")
        assert 0 < other.wanted.uncertain < 1e-4
        np.testing.assert_allclose(other.u, first.u, atol=2 * other.wanted.uncertain * np.abs(first.u).max())


@pytest.mark.parametrize(("noise", "told"), [(1e-6, True), (1e-2, False)])
def test_samples_that_tell_no_accelerations_are_no_motion_for_drives(
    rod, tmp_path: Path, noise: float, told: bool
) -> None:
    """Noise of so many radians on samples every 17 ms: divided by the square of that it is 0.003 or 30 rad/s^2 of 1.2.

    What is said of the accelerations holds against the sine's own.
    """
    t = np.linspace(0, 1, 61)
    samples = {"t": t, "pivot": 0.3 * np.sin(2 * t) + noise * np.random.default_rng(1).standard_normal(len(t))}
    np.savez(tmp_path / "swing.npz", **samples)
    found = drives(rod, tmp_path / "swing.npz", backend="casadi")
    off = np.abs(found.a[:, 0] + 1.2 * np.sin(2 * t)).max() / np.abs(found.a).max()
    assert found.ok == told == (off < 0.5)
    assert found.agree and (told or "DO NOT TELL" in found.status)
    assert off < 5 * found.wanted.uncertain


@pytest.mark.parametrize("name", ["four_bar", pytest.param("three_ups_upu_s", marks=pytest.mark.slow)])
def test_rates_of_goals_are_their_differences(name: str) -> None:
    """Of coordinates, quaternions' entries, places: along a motion by its Taylor polynomial, at random states."""
    found = model(name)
    body = found.mechanism.platform
    names = [*(c.label for c in found.system.tree.q), *(f"{body}.{k}" for k in ("x", "y", "z", "qw", "qx", "qy", "qz"))]
    names += [f"{p.name}.{k}" for p in found.mechanism.points.values() if p.body == body for k in "xz"][:2]
    empty = np.zeros((2, len(names)))
    used = ("body_poses", "body_twists", "body_twist_rates")
    functions = load(found.only(used), backend="casadi")
    goals, _ = goals_of(found, functions, WantedMotion(tuple(names), np.array([0.0, 1.0]), empty, empty, empty))
    q, v, a = (states[:4] for states in found.system.sample_states)
    rates, gains = goals.rates(q, v), goals.accelerations(q, v, a)
    np.testing.assert_allclose(goals.along(q, v[:, :, None])[:, :, 0], rates, atol=1e-12)
    steps = 1e-3 * np.array([-2.0, -1, 0, 1, 2])
    moved = np.stack([goals.values(_moved(found, q, v, a, h)) for h in steps])
    first = np.einsum("k,knm->nm", np.array([1, -8, 0, 8, -1]) / 12e-3, moved)
    second = np.einsum("k,knm->nm", np.array([-1, 16, -30, 16, -1]) / 12e-6, moved)
    scale = np.abs(v).max() ** 2 + np.abs(a).max()
    np.testing.assert_allclose(rates, first, atol=1e-7 * scale)
    np.testing.assert_allclose(gains, second, atol=1e-5 * scale)


def _moved(found: object, q: Array, v: Array, a: Array, h: float) -> Array:
    """q after h of the motion with rates v + a t, by the method of order 4."""
    from symscrew.studies.platform_motion import coordinate_rates

    def slope(state: Array, t: float) -> Array:
        return coordinate_rates(found, state, v + a * t)

    one = slope(q, 0.0)
    two = slope(q + h / 2 * one, h / 2)
    three = slope(q + h / 2 * two, h / 2)
    return q + h / 6 * (one + 2 * two + 2 * three + slope(q + h * three, h))


@pytest.mark.parametrize("size", [0.0, SMALL * 0.99, SMALL * 1.01, 1.0, 3.0])
def test_rotation_vectors_as_quaternions(size: float) -> None:
    """On both sides of the series: differences in time, and the quaternion of the matrix by Rodrigues' formula."""
    rng = np.random.default_rng(3)
    at, rate, gain = (rng.normal(size=3) for _ in range(3))
    at *= size / np.linalg.norm(at)

    def vector(t: float) -> Array:
        return at + rate * t + gain * t**2 / 2

    turn, first, second = turn_of_vector(at[None], rate[None], gain[None])
    h = 1e-3
    near = [turn_of_vector(vector(k * h)[None], rate[None], gain[None])[0][0] for k in range(-2, 3)]
    np.testing.assert_allclose(first[0], np.array([1, -8, 0, 8, -1]) @ near / (12 * h), atol=1e-9)
    np.testing.assert_allclose(second[0], np.array([-1, 16, -30, 16, -1]) @ near / (12 * h**2), atol=1e-7)
    x = float(np.linalg.norm(at))
    skew = np.array([[0, -at[2], at[1]], [at[2], 0, -at[0]], [-at[1], at[0], 0]])
    rotation = np.eye(3) + np.sinc(x / np.pi) * skew + np.sinc(x / 2 / np.pi) ** 2 / 2 * skew @ skew
    found = quaternion_of(rotation[None])[0]
    np.testing.assert_allclose(found, turn[0] * np.sign(turn[0, 0]), atol=1e-12)


def test_quaternions_of_half_turns() -> None:
    """Where the scalar part is zero, and where each of the other entries is the largest."""
    for axis in (*np.eye(3), np.array([1, 1, 1]) / np.sqrt(3)):
        rotation = 2 * np.outer(axis, axis) - np.eye(3)
        found = quaternion_of(rotation[None])[0]
        assert abs(found[0]) < 1e-12
        np.testing.assert_allclose(np.abs(found[1:]), np.abs(axis), atol=1e-12)


def test_derivatives_of_samples_are_exact_for_polynomials() -> None:
    rng = np.random.default_rng(11)
    t = np.cumsum(rng.uniform(0.01, 0.03, 30))
    for count in (FEWER, NEIGHBOURS):
        p = np.polynomial.Polynomial(rng.normal(size=count))
        first, second = derivatives(t, p(t)[:, None], count)
        np.testing.assert_allclose(first[:, 0], p.deriv()(t), atol=1e-8)
        np.testing.assert_allclose(second[:, 0], p.deriv(2)(t), atol=1e-6)


@pytest.mark.parametrize(
    ("texts", "message"),
    [
        ({"pivot": "0.1*t", "tip.x": "0.4"}, "does not get there"),
        ({"tip.x": "2"}, "does not get there"),
        ({"tip.y": "0"}, "leave 1 of them open"),
        ({"pivt": "0"}, r"did you mean 'pivot'"),
        ({"rod.rx": "0", "rod.ry": "t"}, r"rod\.rz: missing"),
        ({"pivot": "abs(t - 1/2)"}, "two derivatives"),
        ({"pivot": "sqrt(t)"}, "not finite, or without derivatives, at t = 0"),
        ({"pivot": "open('x')"}, "pivot"),
        ({"wx": "1"}, "determine its freedoms"),
    ],
)
def test_motions_that_cannot_be(rod, texts, message) -> None:
    with pytest.raises(DescriptionError, match=message):
        drives(rod, texts, duration=1, rate=10, backend="casadi")


@pytest.mark.parametrize(
    ("effect", "message"),
    [
        (DcMotor("pivot", 1, 1, 1), "voltage_pivot follow from no motion"),
        (DryFriction("pivot", coulomb=1, mode="event"), "friction_pivot follows from no motion"),
    ],
)
def test_effects_that_a_motion_does_not_tell(rod, effect, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        drives(rod, {"pivot": "t"}, effects=[effect], duration=1, rate=10, backend="casadi")


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.csv", "pivot\n1\n", "column t"),
        ("a.csv", "t,pivot\n0,1\n1,2\n", "at least 7 samples"),
        ("a.csv", "t,pivot\n0,1\n1,x\n", "row 3: expected numbers"),
        ("a.csv", "t,pivot\n0,1,2\n", "row 2: expected 2 numbers"),
        ("a.csv", "t,pivot\n" + "\n".join(f"{k % 3},0" for k in range(9)), "increasing times"),
        ("a.csv", "t,pivot\n" + "\n".join(f"{k},nan" for k in range(9)), "finite"),
        ("a.csv", "t,wx\n" + "\n".join(f"{k},0" for k in range(9)), "expressions of t"),
        ("a.csv", "", "column t"),
        ("a.toml", "[motion]\nrate = 1\n[coordinates]\npivot = 0\n", "duration is missing"),
        ("a.toml", "[motion]\nduration = 1\n", "either"),
        ("a.toml", '[motion]\nduration = 1\n[twist]\nwq = "1"\n', "no component 'wq'"),
        ("a.toml", "[motion]\nduration = -1.5\n[coordinates]\npivot = 0\n", "above 0"),
        ("a.toml", "[motion]\nduration = 1e9\n[coordinates]\npivot = 0\n", "lower the rate"),
        ("a.toml", "[motion]\nduration = 1\n[coordinates]\npivot = true\n", "expected an expression"),
        ("a.toml", "[motion]\nduration = 1\n[coordinates]\npivot = 0\n[loads.tip]\nfq = 1\n", "no component 'fq'"),
        ("a.xls", "", "ends in .toml"),
    ],
)
def test_files_that_say_nothing_of_use(rod, tmp_path: Path, name: str, content: str, message: str) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(DescriptionError, match=message):
        load_motion(tmp_path / name, rod)


def test_the_command(rod, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, out = tmp_path / "rod.toml", tmp_path / "out"
    file.write_text(ROD)
    words = ["drives", str(file), "--motion", "pivot=0.3*sin(2*t)", "--duration", "1", "--rate", "20"]
    assert main([*words, "--out", str(out), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["ok"] and told["states"] == 21
    assert json.loads((out / "summary.json").read_text()) == told
    motion = read_motion(out / "motion.npz")
    assert motion.mechanism.name == "rod" and motion.u is not None and motion.u.shape == (21, 1)
    rows = (out / "motion.csv").read_text().splitlines()
    assert rows[0].startswith("t,q.pivot,v.pivot,a.pivot,joint.pivot,rate.pivot,u.pivot,power.pivot,reactions.pivot.fx")
    table = np.array([[float(x) for x in row.split(",")] for row in rows[1:]])
    np.testing.assert_array_equal(table[:, 1], motion.q[:, 0])
    assert {p.suffix for p in out.iterdir()} == {".npz", ".csv", ".json", ".png"}
    for bad, said in (
        (["drives", str(file), "--motion", "pivot=t"], "--duration is missing"),
        (["drives", str(file), "--motion", "nothing.csv"], "cannot be read"),
        (["drives", str(file), "--motion", "a.csv", "b.csv"], "expected one file"),
        (["drives", str(file), "--motion", "a.csv", "--duration", "1"], "a file says its own"),
        ([*words, "--load", "tip"], r"loads.POINT"),
        ([*words[:4], "pivot=2", *words[4:]], "given twice"),
    ):
        assert main([*bad, "--out", str(tmp_path / "not")]) == 2, bad
        assert said in capsys.readouterr().err
    assert not (tmp_path / "not").exists()


@pytest.mark.slow
def test_section_5_of_the_paper() -> None:
    """The example is the paper's motion, as the demo reads it: the same drives."""
    from symscrew.studies.demo import SECTION_5
    from symscrew.studies.platform_motion import integrate

    seed = model("three_ups_upu_s")
    whole = load_motion(Path(__file__).parents[2] / "examples" / "motions" / "section_5.toml", seed.mechanism)
    np.testing.assert_allclose(whole.t, SECTION_5.time, atol=1e-12)
    first = {name: getattr(whole, name)[:201] for name in ("t", "values", "rates", "accelerations")}
    found = drives(seed.mechanism, replace(whole, **first), backend="casadi")
    used = ("null_space", "platform_jacobian", "acceleration", "assemble", "body_twist_rates", "body_twists", "closure")
    expected = integrate(seed, load(seed.only(used), backend="casadi"), SECTION_5.motion, SECTION_5.time[:201])
    np.testing.assert_allclose(found.q, expected.q, atol=1e-12)
    np.testing.assert_allclose(found.u, seed("inverse_dynamics", expected.q, expected.v, expected.a)[0][0], atol=1e-9)
    assert found.ok


PARTS_OF_POSES = [
    ("planar_3rrr", {"yaw": "0.2*sin(2*t)", "x": "0.01*t^2", "platform.y": "0.01"}),
    ("three_ups_upu_s", {"tilt": "0.2+0.05*t", "azimuth": "2*t"}),
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "texts"), PARTS_OF_POSES)
def test_poses_by_the_names_of_everywhere(name: str, texts: dict[str, str]) -> None:
    """The platform is where inverse kinematics says that these are, and rates are what differences of places give."""
    found = drives(model(name).mechanism, texts, duration=0.5, rate=100, backend="casadi")
    assert found.ok and found.difference is not None, found.status
    names = [k if "." in k else f"platform.{k}" for k in texts]
    for k in (0, 50):
        asked = {
            n: str(sympy.sympify(text).subs("t", found.t[k])) for n, text in zip(names, texts.values(), strict=True)
        }
        placed = inverse_kinematics(model(name).mechanism, asked)
        np.testing.assert_allclose(found.q[k], placed.q, atol=1e-8)
    tree, step = found.model.system.tree, found.t[1]
    q = found.q[:, [k for k, c in enumerate(tree.q) if c.kind != "quaternion"]]
    v, a = (x[:, [k for k, c in enumerate(tree.v) if c.kind != "rotation"]] for x in (found.v, found.a))
    for values, rates in ((q, v), (v, a)):
        between = (8 * (values[3:-1] - values[1:-3]) - (values[4:] - values[:-4])) / (12 * step)
        np.testing.assert_allclose(rates[2:-2], between, atol=1e-5 * max(1.0, np.abs(rates).max()))


def test_internal_loads_are_of_least_norm_and_hide_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """A plane mechanism under its weight is overconstrained: other internal loads and other reactions are both seen."""
    call, texts = study._difference, {"yaw": "0.1*sin(2*t)", "x": "0.01*t^2", "platform.y": "0.01"}
    seen: dict[str, float] = {}

    def compared(*given, reactions, **more):
        rng = np.random.default_rng(1)
        mechanism, states = given[0].mechanism, []
        solve = study.newton_euler
        monkeypatch.setattr(study, "newton_euler", lambda *a, **k: states.append(solve(*a, **k)) or states[-1])
        right = call(*given, reactions=reactions, **more)
        inside = np.stack([states[0].null_wrenches[n] for n in mechanism.joints], axis=-2)
        seen["inside"] = call(*given, reactions=reactions + 1e-3 * inside[..., 0], **more)
        seen["other"] = call(*given, reactions=reactions + 1e-3 * rng.normal(size=reactions.shape), **more)
        return right

    monkeypatch.setattr(study, "_difference", compared)
    found = drives(model("planar_3rrr").mechanism, texts, duration=0.5, rate=20, backend="casadi")
    assert found.ok and found.difference < 1e-11
    assert min(seen.values()) > 1e3 * study.AGREED, seen


def test_a_run_is_a_motion(tmp_path: Path) -> None:
    """Files of `simulate` and `drives` are read as they were written: their coordinates are the motion."""
    four_bar = model("four_bar").mechanism
    first = drives(four_bar, motion_of({"A": "0.3*sin(2*t)"}, four_bar, duration=1, rate=30), backend="casadi")
    written = write_study(first, tmp_path, drawn=False)
    for file in (p for p in written if p.suffix in (".csv", ".npz")):
        again = drives(four_bar, load_motion(file, four_bar), backend="casadi")
        assert again.ok and np.abs(again.q - first.q).max() < 1e-9, file
        assert np.abs(again.u - first.u).max() < 1e-3 * np.abs(first.u).max(), file
    assert {p.suffix for p in written} >= {".csv", ".npz"}
    text = "\n".join(["t,q.B,speed"] + [f"{k / 10},0,1" for k in range(12)])
    (tmp_path / "own.csv").write_text(text)
    with pytest.raises(DescriptionError, match="speed: expected a coordinate"):
        drives(four_bar, load_motion(tmp_path / "own.csv", four_bar))


@pytest.mark.parametrize("seed", range(4))
def test_what_lies_between_samples_is_told(rod, seed: int) -> None:
    """A swing of m half-waves a sample has the same angle at every one: its accelerations are in none of them."""
    random = np.random.default_rng(seed)
    rate, waves, size = float(random.uniform(20, 200)), int(random.integers(1, 4)), float(random.uniform(0.01, 0.3))
    text = f"{size!r}*sin({np.pi * rate * waves!r}*t)"
    blind = drives(rod, {"pivot": text}, duration=20 / rate, rate=rate, backend="casadi")
    assert blind.wanted.unseen > 0.9 and "too few samples" in study_text(blind)
    assert any("Too few samples" in getattr(block, "text", "") for block in motion_section(blind).blocks)
    seen = drives(rod, {"pivot": text}, duration=20 / rate, rate=40 * rate, backend="casadi")
    assert seen.wanted.unseen < 0.01 and "too few samples" not in study_text(seen)
    assert np.abs(seen.u).max() > 2 * np.abs(blind.u).max()


def test_a_file_of_a_spreadsheet_may_begin_with_a_mark(rod, tmp_path: Path) -> None:
    file = tmp_path / "swing.csv"
    rows = "\n".join(f"{0.01 * k:.17g},{np.sin(0.01 * k):.17g}" for k in range(20))
    file.write_text("\ufefft,pivot\n" + rows, encoding="utf-8")
    assert load_motion(file, rod).names == ("pivot",)


@pytest.mark.parametrize(("more", "compared"), [({}, True), ({"twice": {"terms": {"A": 2, "B": 4}}}, False)])
def test_drives_through_gears_are_compared_where_these_share_nothing(more: dict[str, object], compared: bool) -> None:
    builder = MechanismBuilder("gears")
    for k, name in enumerate("AB"):
        builder.body(f"wheel_{name}", mass=1, com=[k, "1/50", "1/100"], inertia=["1/1000", "1/500", "1/1000"])
        axis = [[0, f"{3 * k}/5", "4/5" if k else 1]]
        builder.joint(name, "R", parent="base", child=f"wheel_{name}", point=[k, 0, 0], axes=axis, driven=not k)
    for name, coupling in ({"gears": {"terms": {"A": 1, "B": 2}}} | more).items():
        builder.coupling(name, **coupling)
    found = drives(builder.build(), {"A": "0.4*sin(2*t)"}, duration=0.2)
    assert (found.difference is not None) == compared and found.ok
    assert not compared or found.difference < 1e-9

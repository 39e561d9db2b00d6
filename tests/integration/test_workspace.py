"""`symscrew workspace`: maps against closed forms, the same numbers however a sweep is cut, interrupted or spread."""

from __future__ import annotations

import json
import math
import os
import signal
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.model_states import pendulum

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.cli.workspace_command import sweep
from symscrew.description import Mechanism, MechanismBuilder, to_toml
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.studies.workspace import engine, workspace
from symscrew.studies.workspace.evaluation import evaluate, prepare_sweep
from symscrew.studies.workspace.map_summary import sweep_summary, tilt_reach
from symscrew.studies.workspace.plan import Axis, Plan, read_axis, read_limit, read_quantity
from symscrew.studies.workspace.store import Store

DEG = math.pi / 180


def plan_of(name: str, *axes: Axis, run_time: tuple[str, ...] = (), **options) -> Plan:
    return Plan(catalogue.find(name, run_time=run_time), (Gravity(),), axes, parameters=run_time, **options)


def whole(plan: Plan) -> dict[str, np.ndarray]:
    pieces = [evaluate(plan, k) for k in range(plan.chunks)]
    return {name: np.concatenate([p[name] for p in pieces]) for name in pieces[0]}


RADII = ("R", "r")  # of the seed, inputs of one model that two tests share
SEED = plan_of("three_ups_upu_s", Axis("tilt", 0.0, 10 * DEG, 6), Axis("azimuth", 0.0, 2 * math.pi, 25))


@pytest.mark.slow
def test_seed_swings_10_degrees_in_every_direction() -> None:
    """Section 3.2 of the source paper asks for it."""
    results = whole(SEED)
    reach = tilt_reach(SEED, results)
    assert reach is not None and reach[1].min() == pytest.approx(10 * DEG, abs=1e-12)
    # the platform's z-axis really is tilted by this angle: E lies on it, at H from O
    E = np.stack([results[f"point E.{c}"] for c in "xyz"], axis=1)
    height = 3 * math.sqrt(3) / 10
    assert np.linalg.norm(E, axis=1) == pytest.approx(height, abs=1e-12)
    assert np.arccos(np.clip(E[:, 2] / height, -1, 1)) == pytest.approx(results["tilt"], abs=1e-7)


@pytest.mark.slow
def test_edge_of_the_seeds_map_is_the_constraint_singularity() -> None:
    """Where the map about azimuth 270 degrees ends, against the scalar equation of the UPU limb, solved by itself.

    With e1 = x the first axis at the base, d = C1 - A1 and e4 the platform's y axis, the two universal joints of the
    limb demand f = e4 . (d (e1 . d) - e1 |d|^2) = 0: it gives the platform's turn about z for a tilt. The singularity
    is where df/dqz = 0; at azimuth 270 degrees it is |d| = R sin(theta), which the paper does not mention.
    """
    tilt, azimuth = Axis("tilt", 18 * DEG, 26 * DEG, 33), Axis("azimuth", 230 * DEG, 310 * DEG, 5)
    plan = plan_of("three_ups_upu_s", tilt, azimuth)
    allowed = whole(plan)["allowed"].reshape(33, 5) > 0
    limits = np.array([_singular_tilt(a) for a in azimuth.values])
    expected = tilt.values[:, None] < limits
    assert np.array_equal(allowed, expected)
    assert expected.any() and not expected.all()
    where, height = limits[2], 0.3 * math.sqrt(3)
    x, z = 0.8 - 0.5 * math.cos(where) - height * math.sin(where), height * math.cos(where) - 0.5 * math.sin(where)
    assert x**2 + z**2 == pytest.approx(0.8 * x, abs=5e-4)


def _singular_tilt(azimuth: float) -> float:
    """Tilt [rad] at which df/dqz changes its sign on the branch through the reference configuration."""
    c = (-0.5, 0.0, 0.3 * math.sqrt(3))  # C1 in the platform; A1 is (-0.8, 0, 0)

    def f(s: float, qz: float) -> float:
        x, y, z = s * math.cos(azimuth), s * math.sin(azimuth), qz
        w = math.sqrt(1 - x * x - y * y - z * z)
        first = (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y))  # the platform's axes
        second = (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x))
        third = (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))
        d = [c[0] * a + c[1] * b + c[2] * e for a, b, e in zip(first, second, third, strict=True)]
        d[0] += 0.8
        square = d[0] ** 2 + d[1] ** 2 + d[2] ** 2
        return d[0] * sum(a * b for a, b in zip(second, d, strict=True)) - second[0] * square

    def slope(s: float, qz: float) -> float:
        return (f(s, qz + 1e-6) - f(s, qz - 1e-6)) / 2e-6

    qz, before, step = 0.0, slope(0.0, 0.0), 0.05 * DEG
    for k in range(1, 900):
        s = math.sin(k * step / 2)
        for _ in range(4):
            qz -= f(s, qz) / slope(s, qz)
        if slope(s, qz) * before < 0:
            return (k - 0.5) * step
    return math.inf


@pytest.mark.slow
def test_strokes_are_distances_of_the_leg_ends() -> None:
    """Displacement of a slider = distance A C now, less that in the reference (0.6 m), plus 0.3 m there."""
    results = whole(SEED)
    A = {1: (-0.8, 0, 0), 2: (0, -0.8, 0), 3: (0.8, 0, 0), 4: (0, 0.8, 0)}
    for k, base in A.items():
        C = np.stack([results[f"point C{k}.{c}"] for c in "xyz"], axis=1)
        length = np.linalg.norm(C - np.array(base), axis=1)
        assert results[f"limb{k}_P"] == pytest.approx(length - 0.3, abs=1e-12)


@pytest.mark.slow
def test_drives_at_rest_balance_the_weight() -> None:
    """Virtual work: over the map, u . d(strokes) = d(potential energy) along the tilt, by differences."""
    step = 1e-4
    plan = plan_of("three_ups_upu_s", Axis("limb5_S.qx", -step, step, 3))
    results = whole(plan)
    mechanism = plan.mechanism
    model = prepare_sweep(plan).model
    strokes = np.stack([results[f"limb{k}_P"] for k in range(1, 5)], axis=1)
    u = np.array([results[f"drive limb{k}_P"][1] for k in range(1, 5)])
    from symscrew.model import derive

    energy = derive(mechanism, (Gravity(),))
    q = []
    for value in (-step, step):
        y = np.array([[value, 0.0]])
        guess = model.system.reference[None, :]
        q.append(energy("assemble", y, guess)[0][0])
    v = np.zeros((2, len(model.system.tree.v)))
    potential = energy("energy", np.concatenate(q), v)[0][0][:, 1]
    assert u @ (strokes[2] - strokes[0]) == pytest.approx(potential[1] - potential[0], abs=1e-9)


@pytest.mark.slow
def test_condition_number_and_stiffness_of_an_arm() -> None:
    """From the singular values of its Jacobian with lengths divided by the characteristic length."""
    labels = prepare_sweep(plan_of("ur5")).labels
    plan = plan_of("ur5", Axis(labels[2], 0.5, 1.5, 3), Axis(labels[4], 1.0, 1.0, 1))
    results = whole(plan)
    assert np.all(results["reached"] == 1)
    model = prepare_sweep(plan).model
    q = np.repeat(model.system.reference[None, :], 3, 0)
    q[:, 2], q[:, 4] = plan.axes[0].values, 1.0
    jacobian = model("platform_jacobian", q)[0][0].reshape(3, 6, 6).transpose(0, 2, 1).copy()
    flange = np.stack([results[f"point flange.{c}"] for c in "xyz"], axis=1)  # v_P = v_O + omega x P
    jacobian[:, 3:] += np.cross(jacobian[:, :3], flange[:, :, None], axis=1)
    jacobian[:, 3:] /= model.system.length
    expected = np.linalg.cond(jacobian)
    assert results["condition"] == pytest.approx(expected, rel=1e-9)
    least = (np.linalg.svd(jacobian, compute_uv=False)[:, 0] ** -2) * plan.stiffness * model.system.length**2
    assert results["stiffness least"] == pytest.approx(least, rel=1e-9)


def five_bar(x: float, z: float, *, tool: bool) -> Mechanism:
    """A five-bar somewhere in its plane."""
    made = MechanismBuilder("five_bar", platform="left")
    for name, place in {"arm_left": -0.2, "left": -0.15, "arm_right": 0.2, "right": 0.15}.items():
        made.body(name, mass=1, com=[x + place, 0, z + 0.2])
    for name, parent, child, at in (
        ("A", "base", "arm_left", (-0.15, 0)), ("B", "arm_left", "left", (-0.3, 0.2)),
        ("D", "base", "arm_right", (0.15, 0)), ("E", "arm_right", "right", (0.3, 0.2)),
        ("C", "right", "left", (0, 0.6)),
    ):  # fmt: skip
        here = [x + at[0], 0, z + at[1]]
        made.joint(name, "R", parent=parent, child=child, point=here, axes=[[0, 1, 0]], driven=name in "AD")
    made.point("fixed", body="base", at=[x, 0, z + 1]).parameter("l", 0.5, unit="m")
    return (made.point("tool", body="left", at=[x, 0, z + 0.6]) if tool else made).build()


@pytest.mark.parametrize("tool", [True, False])
def test_condition_and_stiffness_do_not_depend_on_the_place(tool: bool) -> None:
    """With twists at O they did: the farther from O, the worse the same mechanism was."""
    axes = (Axis("A", -0.4, 0.4, 3), Axis("D", -0.4, 0.3, 2))
    here, there = (whole(Plan(five_bar(*at, tool=tool), (Gravity(),), axes, engine="casadi"))
                   for at in ((0.0, 0.0), (12.5, -7.25)))  # fmt: skip
    for name in ("condition", "stiffness least", "stiffness largest", "margin"):
        assert there[name] == pytest.approx(here[name], rel=1e-9)
    assert np.ptp(here["condition"]) > 0.01


def without(mechanism: Mechanism, what: str) -> Mechanism:
    if what == "drives":
        return replace(mechanism, joints={n: replace(j, driven=()) for n, j in mechanism.joints.items()})
    if what == "masses":
        empty = {n: replace(b, mass=None, com=None, inertia=None) for n, b in mechanism.bodies.items()}
        return replace(mechanism, bodies=empty)
    return replace(mechanism, platform=None) if what == "platform" else mechanism


@pytest.mark.parametrize("lacking", ["nothing", "platform", "drives", "masses"])
def test_what_a_case_has_can_be_limited_and_nothing_else(lacking: str) -> None:
    """A limit of a fixed point, of a parameter or tilt without an axis, of a condition without platform crashed."""
    mechanism = without(five_bar(0.0, 0.0, tool=True), lacking)
    axis = Axis("A", -0.01, 0.01, 2)
    plan = Plan(mechanism, (Gravity(),), (axis,), engine="casadi")
    found = whole(plan)
    assert set(prepare_sweep(plan).units) == set(found)
    limited = whole(replace(plan, limits=tuple((name, -math.inf, math.inf) for name in found if name != "allowed")))
    assert (limited["allowed"] == np.min([~np.isnan(found[n]) for n in found], axis=0) * found["allowed"]).all()
    for name in ("tilt", "l", "point fixed.x", "allowed", *({"platform": ["condition"]}.get(lacking, []))):
        with pytest.raises(DescriptionError, match=f"--limit: no result '{name}'; "):
            prepare_sweep(replace(plan, limits=((name, 0.0, 1.0),)))


@pytest.mark.slow
def test_pieces_do_not_matter() -> None:
    cut = plan_of("four_bar", Axis("A", -0.5, 0.5, 37), chunk=5)
    one = plan_of("four_bar", cut.axes[0], chunk=1000)
    first, second = whole(cut), whole(one)
    assert all(np.array_equal(first[n], second[n], equal_nan=True) for n in second)


@pytest.mark.slow
def test_limits_and_summary() -> None:
    limit = ("limb1_P", 0.28, 0.32)
    plan = plan_of("three_ups_upu_s", *SEED.axes, limits=(limit,))
    results = whole(plan)
    inside = (results["limb1_P"] >= 0.28) & (results["limb1_P"] <= 0.32)
    assert np.array_equal(results["allowed"] > 0, inside & (results["reached"] > 0))
    found = sweep_summary(plan, results, prepare_sweep(plan).units)
    assert found["allowed"] == int(inside.sum()) < found["reached"] == plan.count
    assert found["ranges"]["limb1_P"]["least"] >= 0.28 and found["ranges"]["limb1_P"]["unit"] == "m"
    assert found["tilt"]["every_direction"] < 10 * DEG


@pytest.mark.slow
def test_parameters_of_a_design_study_follow_another_description() -> None:
    """A leg's stroke with R = 0.9 m as a run-time parameter equals that of a description with R = 0.9 m."""
    study = plan_of("three_ups_upu_s", Axis("R", 0.7, 0.9, 3), Axis("tilt", 0.1, 0.1, 1), run_time=RADII)
    results = whole(study)
    for k, radius in enumerate(study.axes[0].values):
        C = np.array([results[f"point C3.{c}"][k] for c in "xyz"])
        start = math.hypot(radius - 0.5, 3 * math.sqrt(3) / 10)
        assert results["limb3_P"][k] - 0.3 == pytest.approx(np.linalg.norm(C - (radius, 0, 0)) - start, abs=1e-11)


@pytest.mark.slow
def test_tolerances_propagate_to_first_order() -> None:
    """Normal deviations of r move C3.x of the resting seed by as much, one to one."""
    plan = plan_of("three_ups_upu_s", run_time=RADII, tolerances=(("r", 1e-3),), samples=2000, chunk=512)
    results = whole(plan)
    found = sweep_summary(plan, results, prepare_sweep(plan).units)["tolerance"]
    assert found["point C3.x"]["deviation"] == pytest.approx(1e-3, rel=0.05)
    assert found["point E.z"]["deviation"] == pytest.approx(0.0, abs=1e-12)
    again = evaluate(plan, 3)
    assert np.array_equal(again["r"], results["r"][3 * 512 : 4 * 512])
    assert len(np.unique(results["r"])) == 2000


@pytest.mark.slow
def test_local_pool_gives_the_same(tmp_path: Path) -> None:
    plan = plan_of("four_bar", Axis("A", -0.5, 0.5, 37), chunk=5)
    kept = Store(tmp_path / "pieces", plan)
    sweep(plan, kept, processes=2)
    expected = whole(plan)
    assert all(np.array_equal(v, expected[n], equal_nan=True) for n, v in kept.whole().items())


@pytest.mark.slow
def test_store_refuses_another_sweep_and_drops_broken_pieces(tmp_path: Path) -> None:
    plan = plan_of("four_bar", Axis("A", -0.5, 0.5, 12), chunk=5)
    kept = Store(tmp_path / "pieces", plan)
    sweep(plan, kept, processes=1)
    file = kept.done()[1]
    file.write_bytes(file.read_bytes()[:-10])
    assert sorted(Store(tmp_path / "pieces", plan).done()) == [0, 2]
    with pytest.raises(DescriptionError, match="1 of 3 pieces are missing"):
        kept.whole()
    with pytest.raises(DescriptionError, match="another sweep"):
        Store(tmp_path / "pieces", plan_of("four_bar", Axis("A", -0.5, 0.5, 13), chunk=5))


@pytest.mark.slow
def test_killed_sweep_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "pendulum.toml").write_text(to_toml(pendulum().mechanism))
    command = ["workspace", str(tmp_path / "pendulum.toml"), "--over", "pivot=-0.5:0.5:30000"]
    command += ["--out", str(tmp_path / "map.npz")]
    if (process := os.fork()) == 0:
        os.setpgid(0, 0)
        os._exit(main(command))
    pieces = tmp_path / ".map.npz.pieces"
    end = time.monotonic() + 60
    while len(list(pieces.glob("piece_*.npz"))) < 3 and time.monotonic() < end:
        time.sleep(0.005)
    os.killpg(process, signal.SIGKILL)
    os.waitpid(process, 0)
    there = len(list(pieces.glob("piece_*.npz")))
    assert 3 <= there < 30 and not (tmp_path / "map.npz").exists()
    capsys.readouterr()
    assert main(command) == 0
    assert f"{there} of 30 pieces are there already" in capsys.readouterr().err
    with np.load(tmp_path / "map.npz") as archive:
        assert np.array_equal(archive["pivot"], np.linspace(-0.5, 0.5, 30000))
    assert not pieces.exists()


@pytest.mark.slow
def test_dask_gives_the_same_though_a_worker_is_killed(tmp_path: Path) -> None:
    """By CasADi: workers, processes of their own, would compile with other options than tests do."""
    distributed = pytest.importorskip("distributed", reason="Dask is not installed: pip install symscrew[dask]")
    plan = Plan(pendulum().mechanism, (Gravity(),), (Axis("pivot", -0.5, 0.5, 60),), chunk=2, engine="casadi")
    settings = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None, "processes": True}
    with distributed.LocalCluster(**settings) as cluster:
        counted: list[int] = []
        kept = Store(tmp_path / "pieces", plan)
        for number, results in engine.run_on_dask(plan, range(plan.chunks), cluster.scheduler_address):
            counted.append(number)
            kept.put(number, results)
            if len(counted) == 10:
                victim = next(iter(cluster.workers.values()))
                os.kill(victim.process.process.pid, signal.SIGKILL)
    assert sorted(counted) == list(range(plan.chunks))
    expected = whole(plan)
    assert all(np.array_equal(v, expected[n], equal_nan=True) for n, v in kept.whole().items())


@pytest.mark.slow
def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    over = ["--over", "tilt=0:20deg:5", "azimuth=0:360deg:9"]
    assert (
        main(["workspace", "three_ups_upu_s", *over, "--expect-tilt", "10deg", "--out", "map", "--processes", "1"]) == 0
    )
    assert "reached in every direction" in capsys.readouterr().out
    names = sorted(p.name for p in (tmp_path / "map").iterdir())
    assert names == ["summary.json", "workspace.csv", "workspace.npz", "workspace.png"]
    found = json.loads((tmp_path / "map" / "summary.json").read_text())
    table = np.genfromtxt(tmp_path / "map" / "workspace.csv", delimiter=",", skip_header=1)
    assert len(table) == found["cases"] == 45
    with np.load(tmp_path / "map" / "workspace.npz") as archive:
        assert np.array_equal(archive["limb1_P"], table[:, archive.files.index("limb1_P")])
    over = ["--over", "tilt=0:10deg:2", "azimuth=0:360deg:4"]
    assert main(["workspace", "three_ups_upu_s", *over, "--expect-tilt", "70deg", "--out", "b.csv"]) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "arguments, text",
    [
        (["--over", "tild=0:1:3"], "did you mean 'tilt'?"),
        (["--over", "tilt=0:1"], "COORDINATE=from:to:count"),
        (["--over", "tilt=1:1:3"], "from below to"),
        (["--over", "tilt=0:1ft:3"], "tilt is an angle [rad, deg]"),
        (["--over", "tilt=0:1furlong:3"], "perhaps with a unit such as mm"),
        (["--over", "platform_tilt=0:1:3"], "did you mean 'platform.tilt'?"),
        (["--over", "tilt=0:x:3"], "expected a number"),
        (["--over", "azimuth=0:1:3"], "azimuth needs tilt"),
        (["--over", "tilt=0:1:3", "tilt=0:1:3"], "given twice"),
        (["--over", "tilt=0:1:3", "limb5_S.qx=0:1:3"], "already say"),
        (["--over", "tilt=0:1:3", "--limit", "limb1_Q=0:1"], "did you mean"),
        (["--over", "tilt=0:1:3", "--limit", "limb1_P=0"], "RESULT=least:largest"),
        (["--over", "tilt=0:1:3", "--expect-tilt", "10deg"], "needs the axes tilt and azimuth"),
        (["--tolerance", "Q=1mm"], "no parameter 'Q'"),
        (["--tolerance", "R=-1"], "above 0"),
        ([], "nothing to sweep"),
        (["--over", "tilt=0:1:3", "azimuth=0:1:3", "--processes", "0"], "--processes: expected a number above 0"),
        (["--over", "tilt=0:1:3", "azimuth=0:1:3", "--stiffness=-1"], "--stiffness: expected a number above 0"),
        (["--over", "tilt=0:1:3", "azimuth=0:1:3", "--seed", "-1"], "--seed: expected a number from 0"),
        (["--over", "tilt=0:1:100000", "azimuth=0:1:100000"], "at most 50 million"),
    ],
)  # fmt: skip
def test_bad_input(arguments: list[str], text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["workspace", "three_ups_upu_s", *arguments, "--out", str(tmp_path / "map")]) == 2
    assert text in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_poses_and_passive_joints_are_axes_like_independent_coordinates() -> None:
    """The configurations of a crank's map, asked for by the other joints and by the rocker's pose."""
    crank = whole(plan_of("four_bar", Axis("A", -20 * DEG, 20 * DEG, 5)))
    for name, like in (("B", "B"), ("C", "C"), ("D", "D"), ("rocker.pitch", "D")):
        first, last = crank[like][[0, -1]]
        found = whole(plan_of("four_bar", Axis(name, min(first, last), max(first, last), 2)))
        assert found["reached"].all() and np.allclose(np.sort(found["A"]), [-20 * DEG, 20 * DEG], atol=1e-9)
    beyond = whole(plan_of("four_bar", Axis("rocker.pitch", 0.0, 2.0, 2)))
    assert beyond["reached"].tolist() == [1.0, 0.0] and np.isnan(beyond["A"][1])


def test_reading() -> None:
    assert read_axis("tilt=0:90deg:3").values == pytest.approx([0, math.pi / 4, math.pi / 2])
    assert read_limit("limb1_P=-5mm:") == (("limb1_P", -0.005, math.inf), "m")
    assert read_limit("condition=3:3")[0] == ("condition", 3.0, 3.0)
    with pytest.raises(DescriptionError, match=r"--limit: expected the least first, .* got 'condition=3:2'"):
        read_limit("condition=3:2")


@pytest.mark.slow
def test_units_of_axes_are_those_of_what_they_move(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A bare number beyond a turn draws a notice; lengths for angles, and ends in two units, are refused."""
    out = ["--out", str(tmp_path / "map.csv")]
    some = ["--over", "A=0:30deg:3"]
    for typed, said in (
        (["--over", "A=0:30mm:3"], "A is an angle [rad, deg]; its values are given in m"),
        (["--over", "A=-20:20deg:3"], "expected both ends in one unit"),
        ([*some, "--limit", "B=-5cm:5cm"], "--limit: B is an angle [rad, deg]; its values are given in m"),
        ([*some, "--limit", "condition=:20deg"], "condition is a plain number; its values are given in rad"),
        ([*some, "--limit", "drive A=-5N:5N"], "--limit: drive A is in N m; its values are given in N"),
        ([*some, "--limit", "B=-1:20deg"], "expected both ends in one unit"),
        ([*some, "--limit", "B=-1furlong:"], "perhaps with a unit such as mm"),
        ([*some, "--stiffness", "5mm"], "--stiffness: expected a number in N/m"),
        ([*some, "--expect-tilt", "5mm"], "--expect-tilt: expected a number in rad"),
    ):
        assert main(["workspace", "four_bar", *typed, *out]) == 2
        assert said in capsys.readouterr().err and not list(tmp_path.iterdir())
    assert main(["workspace", "four_bar", "--over", "A=0:30:3", *out]) == 0
    assert "note: A is in rad: 30 are 1719 degrees; 30deg are 30 degrees" in capsys.readouterr().err
    assert main(["workspace", "four_bar", *some, "--limit", "drive A=-5Nm:900Nmm", "B=-0.2rev:", *out]) == 0
    assert "note:" not in capsys.readouterr().err


def test_tolerances_are_in_units_of_their_parameter(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    short, out = str(Path(__file__).parents[1] / "data" / "short_five_bar.toml"), str(tmp_path / "map.csv")
    assert main(["workspace", short, "--tolerance", "rise=1deg", "--out", out]) == 2
    assert "--tolerance: rise is a length [m, mm]; its values are given in rad" in capsys.readouterr().err


@pytest.mark.parametrize("text, value", [("5mm", 0.005), ("2 in", 0.0508), ("0.5rev", math.pi), ("3 N mm", 0.003)])
def test_quantities_are_read_as_descriptions_are(text: str, value: float) -> None:
    assert read_quantity(text, "here")[0] == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("text", ["m", "3*m - 1"])
def test_maps_over_masses_that_no_body_can_have_are_refused(text: str) -> None:
    """Drives that hold a mass of -2 kg came with reached, regular and allowed."""
    made = MechanismBuilder("weighed", platform="mass").parameter("m", 1, "kg")
    made.body("mass", mass=text, com=[0, 0, -1])
    made.joint("hinge", "R", parent="base", child="mass", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    mechanism = made.build()
    hinge = {"hinge": "0:1:2"}
    assert workspace(
        mechanism, {**hinge, "m": "0.5:2:2"}, tolerances={"m": "0.01"}, samples=3, processes=1, engine="casadi"
    )
    with pytest.raises(DescriptionError, match=r"--over: m = -2: bodies\.mass\.mass: expected a mass"):
        workspace(mechanism, {**hinge, "m": "-2:2:3"}, engine="casadi")
    with pytest.raises(DescriptionError, match=r"--tolerance: values of m reach -\d.*bodies\.mass\.mass"):
        workspace(mechanism, hinge, tolerances={"m": "2"}, samples=20, engine="casadi")

"""Rods of files as bars: what moves and what it weighs is as with the rods, and what is left out is said."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest

from symscrew.cli import main
from symscrew.description import load_description
from symscrew.dynamics import mass_matrix, thin_rods
from symscrew.effects import Acting, system_under
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file
from symscrew.functions.closing import jacobian_in_v
from symscrew.scene import load_robot

LEG = """<body name="crank{k}" pos="{x} 0 0"><joint name="motor{k}" axis="{axis}"/>
<inertial pos="0.05 0.02 0.01" mass="0.4" diaginertia="2e-4 3e-4 4e-4"/>
<body name="rod{k}" pos="{arm}"><joint name="ball{k}" type="ball" {ball}/>{rod}<site name="tip{k}" pos="{tip}"/></body>
</body>"""
LINE = np.array([0.3, -0.2, 0.6])
ACROSS = "0.2 0.6 0.1"  # at right angles to the line


def robot(
    folder: Path, *, legs: int = 1, beside: float = 0.0, spin: float = 0.0, ball: str = "", axis: str = "0.1 1 0.3"
) -> Path:
    """Cranks with rods between balls; of a rod its spin's inertia and its centre's place beside the line [m]."""
    n = LINE / np.linalg.norm(LINE)
    across = np.cross(n, [1, 0, 0]) / np.linalg.norm(np.cross(n, [1, 0, 0]))
    inertia = 2e-3 * (np.eye(3) - np.outer(n, n)) + spin * np.outer(n, n)
    six = " ".join(repr(float(inertia[i, j])) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
    centre = " ".join(repr(float(c)) for c in 0.4 * LINE + beside * across)
    rod = f'<inertial pos="{centre}" mass="0.3" fullinertia="{six}"/>'
    tip = " ".join(repr(float(c)) for c in LINE)
    bodies, closed, meeting = "", "", ""
    for k in range(legs):
        x = 0.5 * k
        bodies += LEG.format(k=k, x=x, axis=axis, arm="0.1 0 0.02", ball=ball, rod=rod, tip=tip)
        place = " ".join(repr(float(c)) for c in LINE + np.array([x + 0.1, 0, 0.02]))
        meeting += f'<site name="end{k}" pos="{place}"/>'
        closed += f'<connect site1="tip{k}" site2="end{k}"/>'
    joint = '<joint name="rocker" axis="1 0.2 0"/>' if legs == 1 else "<freejoint/>"
    weight = '<inertial pos="0.2 -0.1 0.4" mass="1" diaginertia="0.01 0.02 0.025"/>'
    path = folder / "robot.xml"
    path.write_text(
        f'<mujoco><worldbody>{bodies}<body name="plate">{joint}{weight}{meeting}</body></worldbody>'
        f"<equality>{closed}</equality></mujoco>"
    )
    return path


def least_mass(path: Path, options: ImportOptions | None = None) -> float:
    """Inertia against a unit rate of the crank, its rods free to spin as they like."""
    robot = load_robot(path, options)
    system = system_under(robot.mechanism, robot.effects)
    at = (system.inputs.q, system.reference[None])
    rows = mass_matrix(system, Acting(system, robot.effects).added_inertia)
    mass = system.numeric([x for row in rows for x in row], at).reshape(len(rows), -1)
    columns = jacobian_in_v(system)
    jacobian = system.numeric([x for c in columns for x in c], at).reshape(len(columns), -1).T
    _, s, vt = np.linalg.svd(jacobian)
    free = vt[int((s > 1e-9 * s[0]).sum()) :].T
    crank = free[[c.label for c in system.tree.v].index("motor0")]
    inverse = np.linalg.pinv(free.T @ mass @ free, rcond=1e-12)
    return float(1 / (crank @ inverse @ crank))


def test_a_symmetric_rod_weighs_what_its_bar_weighs(tmp_path: Path) -> None:
    """Spin and all: its rate is free, so the least energy of a motion has none about the line."""
    path = robot(tmp_path, spin=3e-5)
    found = import_file(path, ImportOptions(bars=True))
    assert sorted(joint.type for joint in found.mechanism.joints.values()) == ["R", "R", "S", "U"]
    assert least_mass(path, ImportOptions(bars=True)) == pytest.approx(least_mass(path), rel=1e-12)
    assert "rod0: a bar; its spin is left out, of its inertia 3e-05 kg m^2 (0.12 %)" in found.account.changed[-1]


def test_a_rotor_in_the_ball_weighs_the_same_in_the_bar(tmp_path: Path) -> None:
    """The rod has no inertia about its line, so the least energy has no turn of its ball about that: two axes are all
    that is left, at right angles."""
    path = robot(tmp_path, ball='armature="0.05"', axis=ACROSS)
    rods, bars = least_mass(path), least_mass(path, ImportOptions(bars=True))
    assert bars == pytest.approx(rods, rel=1e-9) and abs(rods / least_mass(robot(tmp_path, axis=ACROSS)) - 1) > 0.01
    path = robot(tmp_path, ball='armature="0.05"', axis="1 0 1")  # leans: the universal joint turns the bar along, too
    assert abs(least_mass(path, ImportOptions(bars=True)) / least_mass(path) - 1) > 1e-3
    changed = import_file(path, ImportOptions(bars=True)).account.changed
    assert (
        "ball0: armature about the axes of the bar's universal joint, at 24.6 deg to the bar and across it" in changed
    )


def test_damping_and_friction_of_a_ball_are_those_of_the_bar(tmp_path: Path) -> None:
    """What damping of the ball takes at a rate of the crank, with the spin at rest in the ball, and by axis."""
    path = robot(tmp_path, ball='damping="0.2" frictionloss="0.03"', axis=ACROSS)
    found = import_file(path, ImportOptions(bars=True))
    joint = {force["kind"]: force["joint"] for force in found.forces}
    assert joint == {"damping": "ball0", "friction": "ball0"} and not found.account.influence
    assert [force["freedom"] for force in found.forces if force["kind"] == "friction"] == [0, 1]
    said = "ball0: damping, friction about the axes of the bar's universal joint, at 90 deg to the bar and across it"
    assert said in found.account.changed
    power = []
    for options in (None, ImportOptions(bars=True)):
        given = load_robot(path, options, without=["dry_friction"])
        system = system_under(given.mechanism, given.effects)
        labels, tree = [c.label for c in system.tree.v], jacobian_in_v(system)
        jacobian = system.numeric([x for c in tree for x in c], (system.inputs.q, system.reference[None]))
        _, s, vt = np.linalg.svd(jacobian.reshape(len(tree), -1).T)
        free = vt[int((s > 1e-9 * s[0]).sum()) :].T
        ball = [labels.index(label) for label in labels if label.startswith("ball0")]
        turns = free[ball]  # of the ball, by the free motions
        rate = np.linalg.lstsq(np.vstack([free[labels.index("motor0")], turns]), np.eye(1 + len(ball))[0], rcond=None)
        least = turns @ rate[0] / (free[labels.index("motor0")] @ rate[0])
        power.append(0.2 * float(least @ least))
    assert power[1] == pytest.approx(power[0], rel=1e-9)


def test_what_a_bar_leaves_out_is_as_large_as_it_says(tmp_path: Path) -> None:
    """A centre beside the line: the inertia changes, by no more than the share that is said of the rod's."""
    path = robot(tmp_path, beside=2e-3)
    rods, bars = least_mass(path), least_mass(path, ImportOptions(bars=True))
    assert 1e-6 < abs(bars / rods - 1) < 1e-2
    assert "0.002 m beside the line" in import_file(path, ImportOptions(bars=True)).account.changed[-1]


def test_what_bars_cannot_have_is_not_dropped_unasked(tmp_path: Path) -> None:
    path = robot(tmp_path, ball='stiffness="0.1" damping="0.2"')
    with pytest.raises(DescriptionError, match="left out: spring of the rod's ball ball0; accept"):
        import_file(path, ImportOptions(bars=True))
    found = import_file(path, ImportOptions(bars=True, accept=True))
    assert [force["kind"] for force in found.forces] == ["damping"]
    assert found.account.influence == {"spring of the rod's ball ball0": 1}
    path.write_text(path.read_text().replace('type="ball"', 'type="hinge"'))
    with pytest.raises(DescriptionError, match="--bars: expected a rod between two balls"):
        import_file(path, ImportOptions(bars=True))


@pytest.mark.parametrize("axis", ["1 -3.7e-14 1.6e-27", "0.1 3e-23 1", "1e-15 1 2e-30", "0.3 0.4 1e-24", "0.1 1 0.3"])
def test_axes_with_rounding_of_zero_make_no_rod_another(tmp_path: Path, axis: str) -> None:
    """What of an axis is rounding of zero goes before the next one is put across it: all rods are masses at ends."""
    mechanism = import_file(robot(tmp_path, legs=3, axis=axis), ImportOptions(bars=True)).mechanism
    system = system_under(mechanism, [])
    assert len(thin_rods(system, Acting(system, []))) == 3


@pytest.mark.parametrize("bars", [False, True])
def test_the_platform_of_three_legs_is_found(tmp_path: Path, bars: bool) -> None:
    found = import_file(robot(tmp_path, legs=3), ImportOptions(bars=bars)).mechanism
    assert found.platform == "plate" and sum(joint.type == "U" for joint in found.joints.values()) == 3 * bars
    assert import_file(robot(tmp_path, legs=2)).mechanism.platform is None


@pytest.mark.parametrize(("answer", "bars"), [("y", True), ("n", False)])
def test_new_from_a_file_finds_the_rods_and_asks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], answer: str, bars: bool
) -> None:
    path, terminal = robot(tmp_path, legs=3, ball='stiffness="0.1"', axis=ACROSS), io.StringIO(f"{answer}\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", terminal)
    monkeypatch.setattr(terminal, "isatty", lambda: True, raising=False)
    assert main(["new", "made", "--from", str(path), "--exact"]) == 0
    said = capsys.readouterr().err
    assert "3 rods between two balls, whose spin no drive holds (rod0, rod1, rod2)" in said
    assert "rod2: a bar" in said and "left out: spring of the rod's ball ball0" in said
    types = [joint.type for joint in load_description(tmp_path / "made.toml").joints.values()]
    assert types.count("U") == 3 * bars
    monkeypatch.setattr(terminal, "isatty", lambda: False, raising=False)
    assert (
        main(["new", "told", "--from", str(path), "--exact"]) == 0
        and "--bars leaves that out" in capsys.readouterr().err
    )
    assert main(["new", "taken", "--from", str(path), "--exact", "--bars"]) == 2  # a spring of a ball: not unasked
    assert main(["mobility", str(path)]) == 0 and "--bars leaves that out" in capsys.readouterr().err

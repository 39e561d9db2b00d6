"""Rods of files as bars: what moves and what it weighs is as with the rods, and what is left out is said."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from symscrew.dynamics import mass_matrix, thin_rods
from symscrew.effects import Acting, system_under
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file
from symscrew.functions.closing import jacobian_in_v
from symscrew.kinematics import System

LEG = """<body name="crank{k}" pos="{x} 0 0"><joint name="motor{k}" axis="{axis}"/>
<inertial pos="0.05 0.02 0.01" mass="0.4" diaginertia="2e-4 3e-4 4e-4"/>
<body name="rod{k}" pos="{arm}"><joint name="ball{k}" type="ball" {ball}/>{rod}<site name="tip{k}" pos="{tip}"/></body>
</body>"""
LINE = np.array([0.3, -0.2, 0.6])


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
    system = System(import_file(path, options).mechanism)
    at = (system.inputs.q, system.reference[None])
    rows = mass_matrix(system, None)
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


def test_what_a_bar_leaves_out_is_as_large_as_it_says(tmp_path: Path) -> None:
    """A centre beside the line: the inertia changes, by no more than the share that is said of the rod's."""
    path = robot(tmp_path, beside=2e-3)
    rods, bars = least_mass(path), least_mass(path, ImportOptions(bars=True))
    assert 1e-6 < abs(bars / rods - 1) < 1e-2
    assert "0.002 m beside the line" in import_file(path, ImportOptions(bars=True)).account.changed[-1]


def test_what_bars_cannot_have_is_not_dropped_unasked(tmp_path: Path) -> None:
    path = robot(tmp_path, ball='damping="0.1"')
    with pytest.raises(DescriptionError, match="left out: damping of the rod's ball ball0; accept"):
        import_file(path, ImportOptions(bars=True))
    found = import_file(path, ImportOptions(bars=True, accept=True))
    assert not found.forces and found.account.influence == {"damping of the rod's ball ball0": 1}
    path.write_text(path.read_text().replace('type="ball"', 'type="hinge"'))
    with pytest.raises(DescriptionError, match="--bars: expected a rod between two balls"):
        import_file(path, ImportOptions(bars=True))


@pytest.mark.parametrize("axis", ["1 -3.7e-14 1.6e-27", "0.1 3e-23 1", "1e-15 1 2e-30", "0.3 0.4 1e-24", "0.1 1 0.3"])
def test_axes_with_rounding_of_zero_make_no_rod_another(tmp_path: Path, axis: str) -> None:
    """What of an axis is rounding of zero goes before the next one is put across it: all rods are masses at ends."""
    mechanism = import_file(robot(tmp_path, legs=3, axis=axis), ImportOptions(bars=True)).mechanism
    system = system_under(mechanism, [])
    assert len(thin_rods(system, Acting(system, []))) == 3


def test_the_platform_of_three_legs_is_found(tmp_path: Path) -> None:
    found = import_file(robot(tmp_path, legs=3), ImportOptions(bars=True)).mechanism
    assert found.platform == "plate" and sum(joint.type == "U" for joint in found.joints.values()) == 3

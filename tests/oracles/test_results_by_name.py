"""Results by name against statics by hand, and against the arrays of the generated functions."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from support.model_states import model

from symscrew.array_archives import read_archive
from symscrew.description import parse_description
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.results import Columns, JointWrenches, joint_wrenches
from symscrew.simulation.run_columns import wrenches_along

ARM = """
[mechanism]
name = "arm"
[bodies.arm]
mass = 2
com = ["3/2", 0, 0]
[joints.pivot]
type = "R"
parent = "base"
child = "arm"
point = [1, 0, 0]
axes = [[0, 1, 0]]
driven = true
"""
WEIGHT = 2 * 9.81


def test_a_beam_on_a_pivot_by_hand() -> None:
    """A beam of 2 kg whose centre is 0.5 m off its pivot, turned by 30 degrees about y: statics on paper."""
    turn = np.radians(30)
    arm = derive(parse_description(ARM))
    wrench = joint_wrenches(arm, [turn], [0.0], [0.0])["pivot"]
    np.testing.assert_allclose(wrench.force, (0, 0, WEIGHT), atol=1e-12)
    # the pivot at (1, 0, 0) holds the weight; the drive, not the joint, holds its moment about the pivot
    np.testing.assert_allclose(wrench.moment, (0, -WEIGHT * 1.0, 0), atol=1e-12)
    about = wrench.about_joint()
    np.testing.assert_allclose(about.moment, 0, atol=1e-12)
    # body axes after a turn of +30 degrees about y: x_b = (cos, 0, -sin), z_b = (sin, 0, cos)
    np.testing.assert_allclose(about.in_body_axes().force, WEIGHT * np.array([-0.5, 0, np.sqrt(3) / 2]), atol=1e-12)
    assert "about joint" in repr(about) and "body axes" in repr(about.in_body_axes())


@pytest.fixture(scope="module")
def wrenches() -> JointWrenches:
    """Reactions of the seed in several states, on NumPy."""
    seed = model("three_ups_upu_s")
    q, v, a = seed.system.sample_states
    called = {"joint_reactions": (6, (q, v, a)), "joint_points": (3, (q,)), "body_poses": (12, (q,))}
    shaped = {
        name: np.swapaxes(seed(name, *state)[0][-1].reshape(len(q), -1, rows), 1, 2)
        for name, (rows, state) in called.items()
    }
    return JointWrenches(
        seed.mechanism, reactions=shaped["joint_reactions"], points=shaped["joint_points"], poses=shaped["body_poses"]
    )


def test_points_and_axes_there_and_back(wrenches: JointWrenches) -> None:
    assert list(wrenches) == list(model("three_ups_upu_s").mechanism.joints)
    for wrench in wrenches.values():
        moved = wrench.in_body_axes().about_joint()
        back = moved.in_absolute_axes().about_origin()
        scale = np.abs(wrench.screw).max()
        np.testing.assert_allclose(back.screw, wrench.screw, atol=1e-12 * scale)
        other_order = wrench.about_joint().in_body_axes()
        np.testing.assert_allclose(moved.screw, other_order.screw, atol=1e-12 * scale)
        size = np.linalg.norm(wrench.force, axis=-1)
        np.testing.assert_allclose(np.linalg.norm(moved.force, axis=-1), size, rtol=1e-12, atol=1e-12 * scale)


def test_joints_transmit_no_moment_about_themselves_where_they_turn(wrenches: JointWrenches) -> None:
    """A ball transmits none; a universal joint none about either of its axes, which are its child's axes in part."""
    for name, wrench in wrenches.items():
        size = np.abs(wrench.screw).max()
        if name.endswith("_S"):
            assert np.abs(wrench.about_joint().moment).max() < 1e-10 * size, name
            assert np.abs(wrench.moment).max() > 1e-6 * size or name == "limb5_S", "about O it is another"


def test_a_recorded_run_gives_the_same(wrenches: JointWrenches) -> None:
    seed = model("three_ups_upu_s")
    q, v, a = seed.system.sample_states
    flat = seed("joint_reactions", q, v, a)[0][-1].reshape(len(q), -1)
    again = wrenches_along(seed, q, flat, np.zeros(0))
    for name, wrench in wrenches.items():
        np.testing.assert_array_equal(again[name].in_body_axes().screw, wrench.in_body_axes().screw)
    with pytest.raises(DescriptionError, match="reactions = true"):
        wrenches_along(seed, q, None, np.zeros(0))


def test_names_that_are_not_there_are_refused_with_the_nearest(wrenches: JointWrenches) -> None:
    with pytest.raises(DescriptionError, match="'limb2_S'"):
        wrenches["limb2_S3"]
    with pytest.raises(DescriptionError, match=r"did you mean 'q\.A'"):
        Columns("run", np.zeros(1), {"q.A": np.zeros(1)}, {"q.A": "rad"})["q.a"]


def test_wrenches_of_one_configuration_at_many_rates() -> None:
    """What q alone says is the same for all of them; states that are none are refused."""
    crank = model("slider_crank")
    q, rates = crank.system.reference, np.array([[0.0, 0.0, 0.0], [1.0, -1.0, 0.5]])
    together = joint_wrenches(crank, q, rates, np.zeros(3))["crank_R"].about_joint().in_body_axes()
    apart = [joint_wrenches(crank, q, v, np.zeros(3))["crank_R"].about_joint().in_body_axes() for v in rates]
    np.testing.assert_allclose(together.force, [w.force for w in apart], rtol=1e-12)
    np.testing.assert_allclose(together.moment, [w.moment for w in apart], rtol=1e-12)
    for wrong, said in (("x", "expects an array of real numbers, got"), ([0, 0], "expects q of shape")):
        with pytest.raises(DescriptionError, match=said):
            joint_wrenches(crank, wrong, rates[0], rates[0])


def test_columns_in_files_are_what_they_were(tmp_path: Path) -> None:
    t, values = np.linspace(0, 1, 5), np.random.default_rng(5).normal(size=(2, 5))
    columns = Columns("run", t, {"q.A": values[0], "u.A": values[1]}, {"q.A": "rad", "u.A": "N m"})
    lines = columns.save(tmp_path / "run.csv").read_text().splitlines()
    assert lines[0] == "t,q.A,u.A"
    np.testing.assert_array_equal(np.array([[float(x) for x in s.split(",")] for s in lines[1:]]).T, [t, *values])
    read = read_archive(columns.save(tmp_path / "run.npz"))
    assert read["columns"].tolist() == ["q.A", "u.A"] and read["units"].tolist() == ["rad", "N m"]
    np.testing.assert_array_equal([read["q.A"], read["u.A"]], values)
    with pytest.raises(DescriptionError, match=r"csv or \.npz"):
        columns.save(tmp_path / "run.xls")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["run.csv", "run.npz"]


def test_pandas_and_xarray_are_asked_for_when_they_are_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is handed to them, by stand-ins that hold what they are given; and the cure where they are missing."""
    columns = Columns("run", np.arange(3.0), {"q.A": np.ones(3)}, {"q.A": "rad"})
    asked: list[str] = []

    def missing(name: str) -> SimpleNamespace:
        asked.append(name)
        raise ImportError(name)

    monkeypatch.setattr("importlib.import_module", missing)
    for call in (columns.pandas, columns.xarray):
        with pytest.raises(ImportError, match=r"symscrew\[tables\]"):
            call()
    assert asked == ["pandas", "xarray"]


def test_pandas_frame() -> None:
    pandas = pytest.importorskip("pandas")
    frame = Columns("run", np.arange(3.0), {"q.A": np.array([1.0, 2, 4])}, {"q.A": "rad"}).pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.index.name == "t"
    assert frame["q.A"].loc[2.0] == 4 and frame.attrs["units"] == {"q.A": "rad"}


def test_xarray_set() -> None:
    pytest.importorskip("xarray")
    found = Columns("run", np.arange(3.0), {"q.A": np.array([1.0, 2, 4])}, {"q.A": "rad"}).xarray()
    assert float(found["q.A"].sel(t=2.0)) == 4 and found["q.A"].attrs["units"] == "rad"

"""Which tree and which frames are chosen changes the code, and no drive."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import symscrew
from symscrew import catalogue
from symscrew.description import MechanismBuilder
from symscrew.kinematics import tree
from symscrew.kinematics.pairs import revolute_pair
from symscrew.program import evaluate


def test_the_tree_on_either_side_gives_the_same_drives(monkeypatch: pytest.MonkeyPatch) -> None:
    described = catalogue.load("planar_3rrr")
    effects = (symscrew.Gravity(("0", "-9.81", "0")),)
    on_hub = symscrew.derive(described, effects)
    monkeypatch.setattr(tree, "LIMBS_OF_HUB", 4)
    on_limb = symscrew.derive(described, effects)

    def at_rest(model: symscrew.Model) -> np.ndarray:
        program = model.programs["inverse_dynamics"]
        values = {"q": model.system.reference}
        return evaluate(program, [values.get(p.name, np.zeros(p.size))[None] for p in program.inputs])[0][0][0]

    assert np.abs(at_rest(on_hub)).max() > 1e-3
    assert at_rest(on_limb) == pytest.approx(at_rest(on_hub), rel=1e-9)


@pytest.mark.parametrize("limit", [0.0, 10.0])
def test_where_x_of_a_revolute_link_points_changes_no_drive(limit: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """With a limit of 10 every direction counts as along the axis; with 0 only exact ones do."""
    plain = symscrew.derive(catalogue.load("ur5"))
    q, v, a = plain.system.states(3, 1)
    monkeypatch.setattr(revolute_pair, "ALONG", limit)
    other = symscrew.derive(catalogue.load("ur5"))
    if limit:
        assert any(x.axes != y.axes for x, y in zip(plain.system.frames, other.system.frames, strict=True))
    drives = [evaluate(m.programs["inverse_dynamics"], [q, v, a])[0][0] for m in (plain, other)]
    assert drives[1] == pytest.approx(drives[0], rel=1e-10, abs=1e-10)


def test_of_a_ball_that_is_reached_by_its_child_the_notes_say_what_its_coordinates_are() -> None:
    """A bob whose ball is declared from it to the base: the quaternion turns the bob's axes into the base's."""
    quaternion = np.array([[0.5, -0.1, 0.7, 0.5]])
    poses = []
    for parent, child in (("base", "bob"), ("bob", "base")):
        builder = MechanismBuilder("bob_on_a_ball")
        builder.body("bob", mass=1, com=[0, 0, -1], inertia=["0.1", "0.12", "0.14"])
        builder.joint("ball", "S", parent=parent, child=child, point=[0, 0, 0])
        found = symscrew.derive(builder.build())
        assert any("reached by their child: ball" in note for note in found.notes) == (child == "base")
        poses.append(found("body_poses", quaternion)[0][0])
        rate = found("joint_rates", quaternion, np.array([[1.0, 2.0, 3.0]]))[0][0]
        screws = found("joint_screws", quaternion)[0][0].reshape(3, 6)
        turning = found("body_twists", quaternion, np.array([[1.0, 2.0, 3.0]]))[0][0][0, :3]
        assert rate[0] @ screws[:, :3] == pytest.approx(turning if child == "bob" else -turning)
    assert np.array_equal(*poses)
    assert Rotation.from_quat(np.roll(quaternion[0], -1)).as_matrix().T.ravel() == pytest.approx(poses[0][0, :9])

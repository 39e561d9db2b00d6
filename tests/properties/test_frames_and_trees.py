"""Which tree and which frames are chosen changes the code, and no drive."""

from __future__ import annotations

import numpy as np
import pytest

import symscrew
from symscrew import catalogue
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

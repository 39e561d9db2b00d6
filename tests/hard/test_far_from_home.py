"""Loops whose coordinates are thousands of lengths: closing them leaves more rounding than in a mechanism near home."""

from __future__ import annotations

import numpy as np
import pytest

from symscrew.description.builder import MechanismBuilder
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Scene
from symscrew.simulation.motion import simulate

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: the compiled loop is meant")


@pytest.mark.parametrize("speed", [1.0, 300.0, 1000.0])
def test_what_rounding_leaves_open_does_not_stop_a_run(speed: float) -> None:
    """A block on a rail, and the same place by two rails at right angles: the loop is open by rounding of places
    that are up to 5,000 lengths away, from 1e-16 to 1e-12."""
    builder = MechanismBuilder("far")
    for name in ("a", "m", "b"):
        builder.body(name, mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    up, down = ["3/5", "4/5", 0], ["4/5", "-3/5", 0]
    for name, parent, child, axis in (
        ("rail", "base", "a", [1, 0, 0]),
        ("up", "base", "m", up),
        ("down", "m", "b", down),
    ):
        builder.joint(name, "P", parent=parent, child=child, point=[0, 0, 0], axes=[axis])
    builder.joint("pin", "R", parent="a", child="b", point=[0, 0, "1/2"], axes=[[0, 0, 1]])
    found = simulate(Scene("far", builder.build(), (), 2.0, 10.0, Initial(rates={"rail": speed})))
    assert found.ok, found.status
    at = [c.label for c in found.model.system.tree.q].index("rail")
    assert np.abs(found.q[:, at] - speed * found.t).max() < 1e-11 * speed

"""Two components of a velocity that are seen from turned axes: handed on together, or one by one."""

from __future__ import annotations

import numpy as np
import pytest
from test_loop_rows import given_drives, same, system_of

from symscrew.algebra.traversal import count_operations
from symscrew.dynamics import projection
from symscrew.dynamics.free_motion import Admissible
from symscrew.effects.gravity import Gravity
from symscrew.loops.closure import closure_by
from symscrew.loops.dependent_rates import Loops


@pytest.mark.slow
def test_both_are_equal_and_together_takes_fewer_operations(monkeypatch: pytest.MonkeyPatch) -> None:
    system = system_of("stewart_6ups")
    loops = Loops(system, closure=closure_by(system, ("seen", "contacts", "plain")))
    acting = given_drives(system, [Gravity()])
    together = Admissible(system, loops, acting.reflected_inertia).accelerations(acting)
    monkeypatch.setattr(projection, "UNIT", -1.0)
    apart = Admissible(system, loops, acting.reflected_inertia).accelerations(acting)
    same(system, together[1], apart[1], 1e-9)
    assert count_operations(together[1]) < 0.96 * count_operations(apart[1])
    assert np.isfinite([system.tape.sample(node)[1:] for node in together[1]]).all()

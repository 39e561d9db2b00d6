"""The same machine in microseconds and in months: what holds, bounces and slips is slow or fast beside its own motion.

Rebounds below 1e-6 a second stayed closed, and rates below 1e-9 counted as zero: a tracker of the sun lost them, 1.5e-3
off and called completed. What stops answer to a unit force was rounding beside what accelerates a micromachine.
"""

from __future__ import annotations

import numpy as np
import pytest
from support.marks import slow

from symscrew.description.builder import MechanismBuilder
from symscrew.effects import DryFriction, EndStop, JointSpring
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Scene
from symscrew.simulation.motion import Run, simulate

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: minutes on NumPy")


def moved(unit: float, backend: str | None = None) -> Run:
    """A sledge pulled to and fro on a rail with friction, and a rider between two stops on it, whose spring presses it
    onto one of them; times in this unit [s]."""
    builder = MechanismBuilder("paced")
    builder.body("sledge", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.body("rider", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("A", "P", parent="base", child="sledge", point=[0, 0, 0], axes=[[1, 0, 0]], driven=[0])
    builder.joint("B", "P", parent="sledge", child="rider", point=[0, 0, 0], axes=[[1, 0, 0]])
    force = 1 / unit**2
    effects = (
        DryFriction("A", coulomb=repr(4 * force), static=repr(6 * force), mode="event"),
        EndStop("B", lower="-1/20", upper="1/4", mode="impact", restitution="0.4"),
        JointSpring("B", stiffness=repr(30 * force), rest="-1/6"),
    )
    drive = {"A": f"{force!r}*30*sin(3*t/{unit!r})"}
    scene = Scene("paced", builder.build(), effects, 3 * unit, 10 / unit, Initial(rates={"B": 2 / unit}), drives=drive)
    run = simulate(scene, backend=backend)
    assert run.ok and run.accurate, run.verdict
    return run


@pytest.mark.parametrize(("unit", "backend"), [(1e-6, "c"), (3e6, "c"), slow(1e-3, "numpy"), slow(3e6, "numpy")])
def test_contacts_do_not_know_the_second(unit: float, backend: str) -> None:
    """By libraries, which hold errors of rates to so much a second, the first of each series of impacts."""
    usual, other = moved(1.0), moved(unit, backend)
    count = len(usual.events) if backend == "c" else 10
    assert count >= 10
    events = [run.events[:count] for run in (usual, other)]
    assert [text.split(" s: ")[1] for text in events[0]] == [text.split(" s: ")[1] for text in events[1]]
    times = np.array([[float(text.split()[2]) for text in texts] for texts in events])
    assert times[1] / unit == pytest.approx(times[0], rel=1e-8)
    assert np.abs(other.q - usual.q).max() < 2e-8
    assert np.abs(other.v * unit - usual.v).max() < 1e-6

"""Singular configurations crossed in motion: the branch is kept, every crossing is reported.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import numpy as np
import pytest
from support.runs import compiled, error_of, run_of, scene_of

from hard import case
from hard.mechanisms import four_bars, swung
from symscrew.effects.gravity import Gravity
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Scene
from symscrew.simulation.motion import Run, simulate

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: crossings are the compiled loop's"),
]
FALL = (Gravity((0, "-9.81", 0)),)


def columns(run: Run) -> dict[str, int]:
    """Index of every coordinate in q by its label."""
    return {c.label: k for k, c in enumerate(run.model.system.tree.q)}


def swinging(name: str, **bars: str) -> Run:
    scene = Scene(name, four_bars(1, **bars), FALL, 10.0, 20.0, Initial(rates={"A0": -1.0}))
    return simulate(scene)


@pytest.mark.parametrize(
    "name, bars, inertia, moment",
    [("equal_links", {}, 2 / 3 + 1, 2), ("parallelogram", {"width": "2", "coupler": "3"}, 2 / 3 + 3, 1 + 3)],
)
def test_change_points_at_speed(name: str, bars: dict, inertia: float, moment: float) -> None:
    """Ten times through the flat position: the coupler stays parallel, every crossing is reported.

    Without the steps that follow a branch (kernels/branch.c) see the test of the crossings without them.
    """
    assert "1e-8" in case(3)["pass_criterion"]
    run = swinging(name, **bars)
    assert run.ok
    at = columns(run)
    assert np.abs(run.q[:, at["A0"]] + run.q[:, at["B0"]]).max() < 1e-8
    assert np.abs(-run.q[:, at["A0"]] - swung(inertia, moment * 9.81, 1.0, run.t)).max() < 5e-8
    assert len(run.crossings) == 10 and {c.lost for c in run.crossings} == {1}
    for crossing in run.crossings:
        assert np.abs(np.cos(crossing.q[at["A0"]])) < 1e-6


@pytest.mark.parametrize(
    "integrator", [{"method": "rk4", "step": 1e-3}, *({"tolerance": 10.0**-k} for k in range(6, 13))]
)
def test_singular_positions_crossed_in_motion(integrator: dict) -> None:
    """A02, N = 2: right to 1e-6 for a fixed step and for every tolerance from 1e-6 down."""
    assert case(1)["scenario"].startswith("A02 N=2")
    run = run_of("n_four_bar", scene_of("n_four_bar", **integrator))
    assert run.ok and len(run.crossings) == 10
    assert error_of("n_four_bar", run) < 1e-6
    labels = columns(run)
    assert np.abs(run.q[:, labels["A0"]] - run.q[:, labels["A1"]]).max() < 1e-6  # no change of branch


@pytest.mark.slow
def test_without_following_the_branch_the_crossings_go_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    """The guard taken out, in all of its places: no step begins with care (CAREFUL), and a step that was repeated with
    care finds no zone to step over (ZONE), in double precision. Each alone does: a step whose error is too large is
    repeated so, and with more digits a branch is followed as near as that.

    As seen: at 1e-10 the run gets stuck in the first crossing; at 1e-8 and in steps of 4 ms three of ten crossings
    are reported, the latter with an error of 3e-6.
    """
    from symscrew.simulation import native, run_source

    constants = run_source.constants

    def careless(plant):  # type: ignore[no-untyped-def]
        switched = ("#define ZONE ", "#define CAREFUL ")
        lines = [
            f"{line.rsplit(' ', 1)[0]} 0.0" if line.startswith(switched) else line
            for line in constants(plant).splitlines()
        ]
        return "\n".join([*lines, ""])

    _, plant, _ = compiled("n_four_bar")
    monkeypatch.setattr(run_source, "constants", careless)
    library = native.Library(plant, native.table_code([]))
    monkeypatch.setattr(library, "_offer_precision", lambda: None)
    for integrator in ({"tolerance": 1e-8}, {"tolerance": 1e-10}, {"method": "rk4", "step": 4e-3}):
        run = run_of("n_four_bar", scene_of("n_four_bar", most_steps=20_000, **integrator), library)
        assert not run.ok or error_of("n_four_bar", run) > 1e-6 or len(run.crossings) < 10, integrator
        kept = run_of("n_four_bar", scene_of("n_four_bar", most_steps=20_000, **integrator))
        assert kept.ok and error_of("n_four_bar", kept) < 1e-6 and len(kept.crossings) == 10, integrator

"""What the studies "kinematics", "effects" and "claims" find: orders, floors and counts, never times."""

from __future__ import annotations

from functools import cache

import pytest

from symscrew import catalogue
from symscrew.display.terminal import Progress
from symscrew.model import derive
from symscrew.runtime.compiled import find_compiler
from symscrew.studies.accuracy import claims_study, effects_study, pose_study
from symscrew.studies.accuracy.measuring import Stopwatch
from symscrew.studies.accuracy.states import Subject

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these studies are of generated C")
QUIET = Progress(quiet=True)


@cache
def subject(name: str) -> Subject:
    return Subject(derive(catalogue.load(name)))


@pytest.mark.slow
def test_kinematics_of_the_seed_have_their_orders_and_floors() -> None:
    """Euler of order 1, Runge-Kutta of order 4, the closed form exact; omega_z = 0 costs 0.1 rad at every step."""
    model = subject("three_ups_upu_s").model
    motion = pose_study._reference(model)
    setups = pose_study._numpy_setups(motion)
    setups += pose_study._compiled_setups(model, motion, Stopwatch(), full=False)
    setups += pose_study._closed_form(model, motion, Stopwatch())
    errors: dict[str, dict[float, float]] = {}
    for setup in setups:
        step = float(setup.facts.get("dt", 0.0))
        if step == 0.0 or step >= (1e-2 if "NumPy" in setup.curve else 1e-3):
            assert setup.run() > 0
            errors.setdefault(setup.curve, {})[step] = setup.error()
    own = pose_study._own_error(model, motion)
    assert own is not None and own < 1e-14
    assert errors["closed form of the pose: C"][0.0] < 1e-14
    paper = "forward Euler, least squares, omega_z = 0: "
    for step, error in errors[f"{paper}NumPy (the paper's)"].items():
        assert errors[f"{paper}C (the paper's)"][step] == pytest.approx(error, rel=1e-9)  # one algorithm
    assert min(errors[f"{paper}C (the paper's)"].values()) > 0.09
    for kind in ("least squares: C", "least squares, projection: C"):
        euler, runge = errors[f"forward Euler, {kind}"], errors[f"Runge-Kutta 4, {kind}"]
        assert euler[1e-2] / euler[1e-3] == pytest.approx(10, rel=0.02)
        assert runge[1e-1] / runge[5e-2] == pytest.approx(16, rel=0.05)
        assert runge[1e-3] < 1e-13


@pytest.mark.slow
def test_simplifications_cost_accuracy_and_save_operations() -> None:
    found = effects_study.study(subject("four_bar"), QUIET, repeats=1, seconds=0.1)
    assert found.reference_error is not None and found.reference_error < 1e-12
    drives = {p.setting: p for p in found.curves["drives"]}
    assert len(drives) == 7  # none, three, and three pairs
    whole = drives.pop("whole model")
    assert whole.error == pytest.approx(0.0, abs=1e-13)
    for setting, point in drives.items():
        assert point.error is not None and point.facts["operations"] <= whole.facts["operations"], setting
    for setting in ("quasi-static", "massless limbs"):
        assert (drives[setting].error or 0.0) > 1e-3
        assert drives[setting].facts["operations"] < whole.facts["operations"]
    assert any(p.failure for p in found.curves["accelerations"])  # without inertia there are none: said, and kept


@pytest.mark.slow
def test_claims_at_equal_accuracy() -> None:
    """Analytic momentum rates and Newton-Euler are exact; differences are not, at fewer operations. The impulse form is
    of order 2, the differential form at a step's start of order 1.
    """
    found = claims_study.study(subject("four_bar"), QUIET, repeats=1, seconds=0.1)
    errors = {(p.curve, p.facts.get("h")): p.error for p in found.points}
    operations = {p.curve: p.facts["operations"] for p in found.points}
    instant = f"{claims_study.INSTANT}, "
    newton, momentum = f"{instant}Newton-Euler with accelerations", f"{instant}momentum screws, analytic rates"
    difference = f"{instant}momentum screws, first-order difference (the paper's)"
    assert errors[newton, None] < 1e-13 and errors[momentum, None] < 1e-13
    assert errors[difference, 1e-2] / errors[difference, 1e-3] == pytest.approx(10, rel=0.1)
    assert operations[difference] < operations[momentum]
    for curve, order in (("impulse form, eqs. (36)-(38)", 2), ("differential form, start of the step", 1)):
        at = {h: errors[f"{claims_study.OVER_STEP}, {curve}", h] for h in (1e-2, 1e-3)}
        assert at[1e-2] / at[1e-3] == pytest.approx(10**order, rel=0.15), curve
    assert "sharing of the load" in found.left_out[0]

"""A run that came to its end says whether it is as accurate as asked for; energy taken by impacts has a name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.marks import slow
from support.runs import error_of, scene_of

from hard.mechanisms import chain
from hard.test_events_within_steps import pushed_block
from symscrew.cli.parser import main
from symscrew.description import load_description
from symscrew.effects import Gravity, JointSpring
from symscrew.runtime.compiled import find_compiler
from symscrew.scene import load_scene, parse_scene
from symscrew.scene.contents import Initial, Integrator, Scene, Table
from symscrew.simulation import native
from symscrew.simulation.initial import initial_state
from symscrew.simulation.motion import judged, prepare, simulate
from symscrew.simulation.recording import Estimate
from symscrew.simulation.verdict import verdict

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: runs are compared in the compiled loop"),
]
FIVE_BAR = Path(__file__).parents[1] / "data" / "short_five_bar.toml"


@pytest.mark.parametrize("name", ["andrews", "bricard", "n_four_bar"])
def test_the_estimate_bounds_the_error(name: str) -> None:
    """At least a third of the error that the reference shows, and not thousands of times as much."""
    run = simulate(scene_of(name, tolerance=1e-7))
    assert run.estimate is not None and run.accurate and run.verdict == "completed"
    assert error_of(name, run) / 3 < run.estimate.error < 1e-7


@pytest.mark.parametrize("tolerance", [1e-13, 1e-12, 1e-11])
def test_at_the_tightest_tolerances_runs_are_compared_with_other_ones(tolerance: float) -> None:
    """Below 3e-12 local tolerances are those of rounding: two such runs are one and the same, and say nothing."""
    run = simulate(scene_of("heavy_top", tolerance=tolerance))
    assert run.estimate is not None and 1e-15 < run.estimate.error < 1e-10


def five_bar(duration: float, rates: tuple[float, float]) -> Scene:
    """The five-bar that passes places where its distal rods align, again and again."""
    start = Initial(rates={"base_left": rates[0], "base_right": rates[1]})
    return Scene("five_bar", load_description(FIVE_BAR), (Gravity(),), duration, 50.0, start)


def test_a_chaotic_motion_says_so_with_a_number() -> None:
    run = simulate(five_bar(6.0, (0.5, 0.2)))
    assert run.ok and not run.accurate
    assert run.verdict.startswith("completed, accuracy not reached: an error of about")
    assert "differences grew by a factor of" in run.verdict


def test_tightening_and_halving_do_not_bring_errors_in() -> None:
    """Adaptive and fixed steps agree to what the motion makes of rounding. With the pivots' own threshold (1e-5) errors
    of 1e-8 to 1e-5 came in wherever a step ended near a zero of the elimination, whatever its length."""
    scene = five_bar(2.0, (3.0, -2.5))
    model, plant = prepare(scene)
    library = native.Library(plant)
    start = (*initial_state(scene, model, plant.parameters), np.zeros(len(plant.x_labels)))

    def end(**how: object) -> np.ndarray:
        integrator = replace(scene.integrator, **how)  # type: ignore[arg-type]
        found = native.run_natively(library, replace(scene, integrator=integrator), start)
        assert found.ok and found.counters["steps"] < 25_000
        return found.q

    tight = [end(tolerance=10.0**-k) for k in range(9, 14)]
    fixed = [end(method="rk8", step=step) for step in (1e-3, 5e-4, 2e-4, 1e-4)]
    middle = np.median([*tight, *fixed], axis=0)
    assert max(np.abs(q - middle).max() for q in (*tight, *fixed)) < 3e-9


def test_what_decides() -> None:
    scene = five_bar(1.0, (0.0, 0.0))
    good = Estimate(1e-9, 10.0)
    assert verdict(scene, good, 1e-13, 1e-12) == (True, "completed")
    assert verdict(scene, good, 1e-8, 1e-12)[1].startswith("failed: the loops are open")
    assert verdict(scene, good, 1e-13, 0.2)[1].startswith("failed: the energy is out of balance")
    assert verdict(scene, good, 1e-13, 1e-4)[1].startswith("completed, accuracy not reached: the energy")
    assert not verdict(scene, Estimate(2e-8, 1e6), 1e-13, 1e-12)[0]
    assert verdict(scene, Estimate(float("inf"), stopped="stopped at t = 3 s"), 1e-13, 1e-12) == (
        False, "completed, accuracy not reached: the run with another tolerance to compare it with stopped at t = 3 s"
    )  # fmt: skip
    fixed = replace(scene, integrator=Integrator(method="rk4", step=0.01))
    assert verdict(fixed, Estimate(0.1, 10.0, 0.05), 1e-13, 0.2) == (True, "completed")
    assert "the run with half the step" in verdict(fixed, Estimate(float("inf"), other="half the step"), 1e-13, 0.2)[1]
    assert verdict(fixed, Estimate(0.1, 10.0, 0.2, other="half the step"), 1e-13, 0.2)[1].startswith(
        "completed, accuracy not reached: with half"
    )


@pytest.mark.parametrize("knots", [0, 10])
def test_steps_that_end_sooner_are_halved_too(knots: int) -> None:
    """A spring that turns by 1.5 rad between two outputs, or knots of a table, at which steps end: half of a longer
    step were the same steps, and a motion that is off by half of its way was called completed."""
    table = {"f": Table("f", tuple(np.linspace(0, 1, knots + 1)), (1.0,) * (knots + 1))} if knots else {}
    for step, good in ((1.0, False), (1e-3, True)):
        scene = Scene(
            "s", pushed_block(), (JointSpring("z", stiffness=225),), 1.0, 10.0 if not knots else 1.0,
            drives={"z": "f" if knots else "1"}, tables=table, integrator=Integrator(method="rk4", step=step),
        )  # fmt: skip
        found = simulate(scene)
        assert found.ok and found.accurate == good, found.verdict


@pytest.mark.parametrize(("step", "way", "good"), [(0.1, 0.5, False), (1e-2, 0.5, True), (0.1, 1e-3, True)])
def test_what_turns_on_does_not_hide_what_swings(step: float, way: float, good: bool) -> None:
    """A wheel of 80 turns a second beside a spring of 2 Hz, whose phase is off by a rad: that is a small part of the
    wheel's way, and was completed. Of a way of a millimetre it is none that counts."""
    body = {"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    two = [(joint, "R", "base", name, [0, 0, 0], [[0, 0, 1]]) for joint, name in (("on", "wheel"), ("back", "arm"))]
    start = Initial(coordinates={"back": way}, rates={"on": 500.0})
    scene = Scene(
        "s", chain("two", *two, wheel=body, arm=body), (JointSpring("back", stiffness=225),), 2.0, 10.0, start,
        integrator=Integrator(method="rk4", step=step),
    )  # fmt: skip
    found = simulate(scene)
    assert found.accurate == good, found.verdict
    assert ("accuracy not reached" in found.verdict) != good


def test_the_exit_code_follows(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "five_bar.toml").write_text(FIVE_BAR.read_text(encoding="utf-8"), encoding="utf-8")
    text = (
        "[scene]\nmechanism = 'five_bar.toml'\nduration = {}\n[initial.rates]\nbase_left = 0.5\n"
        "[[effects]]\ntype = 'gravity'\n"
    )
    for duration, code in ((0.2, 0), (6, 1)):
        (tmp_path / "scene.toml").write_text(text.format(duration), encoding="utf-8")
        assert main(["simulate", str(tmp_path / "scene.toml")]) == code
        assert ("accuracy not reached" in capsys.readouterr().out) == bool(code)


@pytest.mark.parametrize(
    "force, twice, rate",
    [
        ("(1-t)^3", lambda t: (1 - t) ** 5 / 20, -1 / 4),
        slow("1+(t-1)^3", lambda t: t**2 / 2 + (t - 1) ** 5 / 20, 1 / 4),
        slow("(t-1)^5", lambda t: (t - 1) ** 7 / 42, 1 / 6),
        slow("t^7", lambda t: t**9 / 72, 0.0),
        slow("exp(-t)", lambda t: np.exp(-t), -1.0),
    ],
)
@pytest.mark.parametrize("tolerance", [1e-4, 1e-8, 1e-11])
def test_the_work_of_drives_is_as_good_as_the_motion(
    force: str, twice: Callable[[np.ndarray], np.ndarray], rate: float, tolerance: float
) -> None:
    """Forces that are polynomials of time leave no error of the motion, so that steps grow without end: the work, of a
    higher degree, was off by 2e-3 of it, and a run that was right to rounding was called inaccurate."""
    scene = Scene("s", pushed_block(), (), 2.0, 20.0, drives={"z": force}, integrator=Integrator(tolerance=tolerance))
    found = simulate(scene)
    expected = twice(found.t) - twice(np.array([0.0])) - rate * found.t
    assert np.abs(found.q[:, 0] - expected).max() < max(tolerance, 1e-13)
    assert found.accurate and found.unbalanced < max(tolerance, 1e-13), (found.verdict, found.unbalanced)


@pytest.mark.slow
def test_the_shipped_fall_through_singular_places_asks_for_what_is_reachable() -> None:
    """For 5 s, as it was, differences grow half a million times: its verdict was right, at every tolerance."""
    scene = load_scene(Path(__file__).parents[2] / "examples" / "scenes" / "falling_platform.toml")
    found = simulate(scene)
    assert found.accurate and len(found.crossings) == 3, found.verdict


def test_a_rod_on_its_head_rests() -> None:
    """What rounding leaves of its weight's energy is more than moves; it was a failed run."""
    body = {"mass": 1, "com": [0, 0, "1/2"], "inertia": [["1/10", 0, 0], [0, "1/10", 0], [0, 0, "1/10"]]}
    rod = chain("rod", ("A", "R", "base", "rod", [0, 0, 0], [["3/5", "4/5", 0]]), rod=body)
    run = simulate(Scene("rests", rod, (Gravity((0, 0, "-9.81")),), 0.5, 20.0), backend="numpy")
    rounded = replace(run, energy_balance=run.energy_balance + 3.6e-15, energy=run.energy + 1e-30)
    assert judged(rounded).accurate, judged(rounded).verdict
    assert not judged(replace(rounded, energy_balance=run.energy_balance + 1e-12)).accurate


OSCILLATOR = """
[mechanism]
name = "oscillator"
platform = "bob"
[bodies]
bob = { mass = 1, com = [0, 0, 0] }
[joints]
rail = { type = "P", parent = "base", child = "bob", point = [0, 0, 0], axes = [[1, 0, 0]] }
"""


@pytest.mark.parametrize("method", ["dop853", "radau", "cvodes"])
def test_outputs_at_turning_points_alone_show_no_energy(method: str, tmp_path: Path) -> None:
    """A motion of one period between two outputs rests at each: what was moved is seen between them."""
    (tmp_path / "oscillator.toml").write_text(OSCILLATOR)
    text = f"""
[scene]
mechanism = "oscillator.toml"
duration = 5
rate = 1
[initial.coordinates]
rail = 1
[[effects]]
type = "joint_spring"
joint = "rail"
stiffness = "4*pi^2"
[integrator]
method = "{method}"
tolerance = 1e-6
"""
    run = simulate(parse_scene(text, folder=tmp_path))
    assert run.accurate and run.verdict == "completed" and np.abs(run.q[:, 0] - 1).max() < 1e-6
    assert run.energy[:, 0].max() < 1e-9 and run.moved[0] > 2, "half of 4 pi^2 where it is fastest"
    wrong = replace(run, energy_balance=run.energy_balance + 0.04 * sum(run.moved))
    assert judged(wrong).verdict.startswith("failed: the energy is out of balance by 0.0")


@pytest.mark.parametrize(("backend", "size"), [("c", "1e-5"), ("numpy", "1e-5")])
def test_a_pulse_of_the_base_between_two_outputs(backend: str, size: str) -> None:
    """The ground goes away and comes back: all that was moved is gone at the next output."""
    text = f"""
[scene]
mechanism = "slider_crank"
duration = 0.3
rate = 10
[[effects]]
type = "base_motion"
pose = ["{size}*exp(-((t-0.155)/0.005)^2)", 0, 0, 0, 0, 0]
[integrator]
tolerance = 1e-6
"""
    run = simulate(parse_scene(text), backend=backend)
    assert run.accurate and run.verdict == "completed"
    assert run.moved[0] > 1e3 * run.energy.max() and run.unbalanced < 1e-6

"""Thresholds of scenes and of their simulation without a compiler: what happens on either side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import DryFriction, EndStop, JointSpring
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.scene import INTEGRATION_METHODS, scene_file
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.scene.scene_file import parse_scene
from symscrew.simulation import contacts, fronts, initial, portable, run_source, scene_functions, stability
from symscrew.simulation.motion import Run, prepare, simulate
from symscrew.simulation.native import NATIVE_METHODS
from symscrew.simulation.real_time_loop import REAL_TIME
from symscrew.simulation.scene_functions import PlantFunctions, RunError
from symscrew.simulation.state_programs import plant

pytestmark = pytest.mark.slow


def block() -> Mechanism:
    """2 kg on a slide."""
    builder = MechanismBuilder("block")
    builder.body("block", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("slide", "P", parent="base", child="block", point=[0, 0, 0], axes=[[1, 0, 0]])
    return builder.build()


def sliding(*effects: object, start: float = 0.0, rate: float = 0.0, duration: float = 1.0, **how: object) -> Run:
    """The block's run by NumPy and SciPy."""
    scene = Scene(
        "sliding", block(), tuple(effects), duration, 50.0,  # type: ignore[arg-type]
        Initial({"slide": start}, {"slide": rate}), integrator=Integrator(**how),  # type: ignore[arg-type]
    )  # fmt: skip
    return simulate(scene, backend="numpy")


def four_bar(angle: float = 0.5, **how: object) -> Scene:
    """The four-bar falling."""
    mechanism = catalogue.load("four_bar")
    return Scene("falling", mechanism, (Gravity(),), 0.1, 50.0, Initial({"A": angle}), integrator=Integrator(**how))  # type: ignore[arg-type]


def start_of(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    model, programs = prepare(scene)
    return initial.initial_state(scene, model, programs.parameters)


# -- methods ---------------------------------------------------------------------------------------------------


def test_every_method_is_carried_out_somewhere() -> None:
    for name, method in INTEGRATION_METHODS.items():
        assert method.marching in {*portable.MARCHES, "sundials"}, name
        assert method.fixed_step == (name in portable.FIXED_STEPS)
        assert bool(method.library) == (method.marching in ("projected", "restarted"))
        assert (method.stable is None) == (name in ("radau", "bdf", "lsoda", "cvodes"))
    assert NATIVE_METHODS == {"euler": 0, "semi_implicit_euler": 1, "rk4": 2, "rk8": 3, "dop853": 4}
    assert REAL_TIME == ("euler", "semi_implicit_euler", "rk4", "rk8")


def test_one_line_of_a_scene_its_programs_and_its_run() -> None:
    scene = four_bar()
    model, programs = prepare(scene)
    assert repr(scene) == "<Scene falling: four_bar, 0.1 s by dop853, 1 effect, 0 drives>"
    assert repr(programs).startswith("<Plant four_bar: 3 coordinates, 5 rows of the closure, slopes in ")
    run = simulate(scene, backend="numpy", prepared=(model, programs))
    assert repr(run) == "<Run falling: 6 outputs to t = 0.1 s, completed>"


# -- scenes ----------------------------------------------------------------------------------------------------

TEXT = "[scene]\nmechanism = 'four_bar'\nduration = 2\n[tables.a]\ntimes = [0, 1, 2]\nvalues = [0, 1, 0]\n"


def test_more_outputs_or_longer_tables_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    assert len(parse_scene(TEXT).times) == 201
    monkeypatch.setattr(scene_file, "MOST_OUTPUTS", 199)
    with pytest.raises(DescriptionError, match="200 outputs; at most 199 are written"):
        parse_scene(TEXT)
    monkeypatch.setattr(scene_file, "MOST_OUTPUTS", 200)
    monkeypatch.setattr(scene_file, "LONGEST_TABLE", 2)
    with pytest.raises(DescriptionError, match="expected at most 2 numbers, got 3"):
        parse_scene(TEXT)


@pytest.mark.parametrize("tolerance, fine", [("1e-13", True), ("0.9e-13", False), ("0.1", True), ("0.11", False)])
def test_the_range_of_tolerances(tolerance: str, fine: bool) -> None:
    text = f"{TEXT}[integrator]\ntolerance = {tolerance}\n"
    if fine:
        assert parse_scene(text).integrator.tolerance == float(tolerance)
    else:
        with pytest.raises(DescriptionError, match=r"expected 1e-13 to 0\.1"):
            parse_scene(text)


# -- start -----------------------------------------------------------------------------------------------------


def test_strides_to_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    """More strides find the same configuration, with their Newton steps shortened too; where all fail it is said."""
    q, _ = start_of(four_bar(2.8))
    monkeypatch.setattr(initial, "STRIDES", (64,))
    monkeypatch.setattr(initial, "LARGEST_STEP", 0.02)
    assert np.abs(start_of(four_bar(2.8))[0] - q).max() < 1e-12
    monkeypatch.setattr(initial, "STRIDES", (1,))
    with pytest.raises(DescriptionError, match="cannot be closed"):  # 2.8 rad are more than forty such steps
        start_of(four_bar(2.8))


def test_few_newton_steps_do_not_close_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(initial, "MOST_STEPS", 1)
    with pytest.raises(DescriptionError, match="cannot be closed"):
        start_of(four_bar())


def test_where_newton_steps_at_the_start_end(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(DescriptionError, match="cannot be closed"):
        start_of(replace(four_bar(), initial=Initial({"A": 0.5, "B": 2.0})))  # the loops contradict these
    q, _ = start_of(four_bar())
    with monkeypatch.context() as changed:
        changed.setattr(initial, "CLOSED", 0.0)  # never: steps go on until nothing moves
        assert np.abs(start_of(four_bar())[0] - q).max() < 1e-13
        for bound in ("STALLED", "FOLLOWED"):
            with monkeypatch.context() as stricter:
                stricter.setattr(initial, bound, 0.0)
                with pytest.raises(DescriptionError, match="cannot be closed"):
                    start_of(four_bar())
    monkeypatch.setattr(initial, "CLOSED", 1e3)  # at once: no step is made
    assert start_of(four_bar())[0] == pytest.approx(derive(four_bar().mechanism).system.reference)


def test_rates_along_what_the_loops_do_not_determine(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = replace(four_bar(), initial=Initial({"A": 0.5}, {"A": 1.0}))
    assert start_of(scene)[1][0] == pytest.approx(1.0)
    monkeypatch.setattr(initial, "RATE_RANK", 0.9)  # every direction but the largest counts as undetermined
    with pytest.raises(DescriptionError, match="the loops do not allow A = 1"):
        start_of(scene)


def test_steps_along_what_the_loops_do_not_determine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(initial, "STEP_RANK", 0.9)
    with pytest.raises(DescriptionError, match="cannot be closed"):
        start_of(four_bar(2.8))


# -- contacts --------------------------------------------------------------------------------------------------


def test_what_counts_as_still(monkeypatch: pytest.MonkeyPatch) -> None:
    friction = DryFriction("slide", coulomb=1, mode="event")
    slipping = sliding(friction, rate=0.5, duration=0.2)
    assert slipping.q[-1, 0] == pytest.approx(0.5 * 0.2 - 0.25 * 0.2**2, abs=1e-9)
    monkeypatch.setattr(contacts, "STILL", 1.0)
    stuck = sliding(friction, rate=0.5, duration=0.2)
    assert stuck.v[-1, 0] == pytest.approx(0.5, abs=1e-9)  # held at the rate that it has: not what a block does


def test_two_frictions_share_what_holds_a_joint(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two contacts in one joint: the least forces share the pull equally."""
    model = derive(block(), (DryFriction("slide", coulomb=3, mode="event"),))
    law = contacts.laws(model, [c for e in model.effects for c in e.contacts()])[0]
    at = contacts.ContactState(
        (law, law), np.zeros(1), np.zeros(1), np.ones(1), lambda _, f: np.array([1.0 + 0.5 * f.sum()])
    )
    assert contacts.forces(at, contacts.Modes((0, 0))) == pytest.approx([-1.0, -1.0], abs=1e-12)
    uneven = replace(at, answers=lambda _, f: np.array([1.0 + 0.5 * f[0] + 0.5 * (1 + 1e-9) * f[1]]))
    monkeypatch.setattr(contacts, "SHARED", 0.0)
    assert contacts.forces(uneven, contacts.Modes((0, 0))).sum() == pytest.approx(-2.0, abs=1e-6)


@pytest.mark.parametrize(("pull", "mode"), [(-1e-13, 1), (-1e-9, 0), (1e-9, 1)])
def test_rounding_does_not_let_go(pull: float, mode: int) -> None:
    """A joint whose friction has just reached its level lies on its stop, which holds nothing yet: it was let go by a
    pull of the last digits, met again and so on, ten thousand times."""
    model = derive(block(), (DryFriction("slide", coulomb=3, mode="event"), EndStop("slide", upper=0, mode="impact")))
    laws = contacts.laws(model, [c for e in model.effects for c in e.contacts()])
    at = contacts.ContactState(
        laws, np.zeros(1), np.zeros(1), np.ones(1), lambda _, f: np.array([3.0 + pull + f[0] + f[1]])
    )
    assert contacts.released(at, contacts.Modes((1, 1))).values == (1, mode)


def test_a_joint_that_friction_cannot_hold_slips(monkeypatch: pytest.MonkeyPatch) -> None:
    model = derive(block(), (DryFriction("slide", coulomb=3, mode="event"),))
    law = contacts.laws(model, [c for e in model.effects for c in e.contacts()])[0]
    dead = contacts.ContactState(  # its own force moves it by 1e-7 of what it does to another freedom
        (replace(law, v=0),), np.zeros(2), np.zeros(2), np.ones(2), lambda _, f: np.array([0.5 + 1e-7 * f[0], f[0]])
    )
    assert contacts.released(dead, contacts.Modes((0,))).values == (1,)
    monkeypatch.setattr(contacts, "HELD", 1e-9)
    held = contacts.forces(dead, contacts.Modes((0,)))
    assert abs(held[0]) > 1e6  # what would be asked of it


def test_a_run_with_too_many_changes_of_contact_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    effects = (JointSpring("slide", stiffness=50), DryFriction("slide", coulomb=3, mode="event"))
    usual = sliding(*effects, start=0.5, duration=3.0)
    assert usual.ok and len(usual.events) > 2
    monkeypatch.setattr(portable, "MOST_EVENTS", 2)
    stopped = sliding(*effects, start=0.5, duration=3.0)
    assert not stopped.ok and "more than 2 changes of contact" in stopped.status


@pytest.mark.parametrize("chosen", [{}, {"reach": 0.15}, {"reach": 0.2, "grip": 0.5}])
def test_laws_of_contacts_follow_the_parameters_of_the_run(chosen: dict[str, float]) -> None:
    """A stop at twice `reach`, and friction `grip`, both of run time: met where s = v t - F t^2 / 2m is there."""
    made = MechanismBuilder("block")
    made.parameter("reach", "0.1", unit="m", run_time=True)
    made.parameter("end", "2*reach", unit="m")
    made.parameter("grip", "0.2", unit="N", run_time=True)
    made.body("block", mass=2, com=[0, 0, 0], inertia=[1, 1, 1])
    made.joint("slide", "P", parent="base", child="block", point=[0, 0, 0], axes=[[1, 0, 0]])
    effects = (
        EndStop("slide", upper="end", mode="impact", restitution=1), DryFriction("slide", coulomb="grip", mode="event"),
    )  # fmt: skip
    scene = Scene("stopped", made.build(), effects, 1.0, 50.0, Initial({}, {"slide": 1.0}), parameters=chosen)
    run = simulate(scene, backend="numpy")
    values = {"reach": 0.1, "grip": 0.2, **chosen}
    slowing = values["grip"] / 2
    when = (1 - np.sqrt(1 - 2 * slowing * 2 * values["reach"])) / slowing
    assert run.ok and float(run.events[0].split()[2]) == pytest.approx(when, abs=1e-6)
    assert run.q.max() <= 2 * values["reach"] + 1e-9
    found = [c for effect in effects for c in effect.contacts()]
    plant = prepare(scene)[1]
    rules = contacts.laws(run.model, found, np.array([values["reach"], values["grip"]]))
    assert rules[0].upper == 2 * values["reach"] and rules[1].coulomb == values["grip"]
    assert run_source.rules_of(plant) == rules  # whose numbers are put into the compiled loop; one serves all values
    assert run_source.sources(plant) == run_source.sources(replace(plant, parameters=np.array([1.0, 2.0])))


# -- integration -----------------------------------------------------------------------------------------------


def test_local_errors_are_a_part_of_the_error_aimed_at(monkeypatch: pytest.MonkeyPatch) -> None:
    spring = JointSpring("slide", stiffness=50)
    errors = []
    for part in (portable.LOCAL, 1.0):
        monkeypatch.setattr(portable, "LOCAL", part)
        run = sliding(spring, start=0.5, tolerance=1e-4, duration=3.0)
        errors.append(float(np.abs(run.q[:, 0] - 0.5 * np.cos(5 * run.t)).max()))
    assert errors[0] < 1e-4 and errors[1] > 10 * errors[0]


def test_tolerances_are_not_below_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    spring = JointSpring("slide", stiffness=50)
    steps = sliding(spring, start=0.5, tolerance=1e-13).counters["steps"]
    monkeypatch.setattr(portable, "LEAST_ABSOLUTE", 1e-6)
    monkeypatch.setattr(portable, "LEAST_RELATIVE", 1e-6)
    assert sliding(spring, start=0.5, tolerance=1e-13).counters["steps"] < steps / 2


@pytest.fixture(scope="module")
def falling() -> tuple[PlantFunctions, np.ndarray, np.ndarray]:
    """Functions of the four-bar and a state whose loop is open by some 1e-3."""
    model = derive(catalogue.load("four_bar"), (Gravity(),))
    functions = PlantFunctions(plant(model), [], compiled=False)
    return functions, model.system.sample_states[0][0] + 1e-3, np.ones(3)


def test_the_loops_are_closed_by_newton_steps(
    falling: tuple[PlantFunctions, np.ndarray, np.ndarray], monkeypatch: pytest.MonkeyPatch
) -> None:
    functions, q, v = falling
    closed, rates, _ = functions.settle(q, v)
    residual, jacobian = functions.opening(closed)
    assert np.abs(residual).max() < scene_functions.GOOD and np.abs(jacobian @ rates).max() < 1e-14
    monkeypatch.setattr(scene_functions, "MOST_STEPS", 1)
    with pytest.raises(RunError, match="could not be closed"):
        functions.settle(q, v)
    monkeypatch.setattr(scene_functions, "GOOD", 1.0)  # taken as closed, open as it is
    left, _, _ = functions.settle(q, v)
    assert np.abs(functions.opening(left)[0]).max() > 1e-9
    monkeypatch.setattr(scene_functions, "MOST_STEPS", 12)
    monkeypatch.setattr(scene_functions, "CLOSED", 1.0)
    untouched, _, _ = functions.settle(q, v)
    assert np.abs(untouched - q).max() < 1e-15


def test_long_steps_onto_the_loops_are_no_steps(
    falling: tuple[PlantFunctions, np.ndarray, np.ndarray], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scene_functions, "LARGEST_STEP", 1e-6)
    with pytest.raises(RunError, match="could not be closed"):
        falling[0].settle(*falling[1:])


def test_directions_that_the_loops_do_not_hold(
    falling: tuple[PlantFunctions, np.ndarray, np.ndarray], monkeypatch: pytest.MonkeyPatch
) -> None:
    functions, q, v = falling
    monkeypatch.setattr(scene_functions, "RANK", 0.99)  # but the first direction none counts
    monkeypatch.setattr(scene_functions, "GOOD", 1.0)
    closed, rates, _ = functions.settle(q, v)
    assert np.abs(functions.opening(closed)[1] @ rates).max() > 1e-3


@pytest.mark.slow
def test_steps_bound_by_stability(monkeypatch: pytest.MonkeyPatch) -> None:
    stiff = four_bar(method="rk4", step=1e-3)

    def bound() -> bool:
        return any("at which rk4 is stable" in text for text in simulate(stiff, backend="numpy").events)

    damped = JointSpring("A", stiffness=0, damping=50)
    stiff = replace(
        stiff, effects=(Gravity(), damped), duration=0.002, rate=500.0, integrator=Integrator("rk4", step=1e-4)
    )
    counters = simulate(stiff, backend="numpy").counters
    part = 1e-4 / counters["longest_stable_step"]
    monkeypatch.setattr(stability, "CLOSE", 1.01 * part)
    assert not bound()
    monkeypatch.setattr(stability, "CLOSE", 0.99 * part)
    assert bound()
    monkeypatch.setattr(stability, "STEP", 1e-5)  # of differences: another one, the same rate
    again = simulate(stiff, backend="numpy").counters["longest_stable_step"]
    assert again == pytest.approx(counters["longest_stable_step"], rel=1e-3)


# -- fronts ----------------------------------------------------------------------------------------------------


def test_rows_that_depend_on_others_do_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    front = (fronts.Front((0, 1), (0, 1), -1),)
    matrix = np.array([[1.0, 0.0], [1.0, 1e-9]])
    assert fronts.regular(front, [matrix])[0][0].rank == 1
    monkeypatch.setattr(fronts, "DEPENDENT", 1e-12)
    assert fronts.regular(front, [matrix])[0][0].rank == 2
    assert len(fronts.front_pivots(matrix, front)[0]) == 2
    monkeypatch.setattr(fronts, "NOTHING_LEFT", 1e-6)
    assert len(fronts.front_pivots(matrix, front)[0]) == 1

"""The studies of accuracy against time: what they state is checked by other means; nothing is said about times."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.accuracy_studies import EXAMPLES, QUIET, least_error, needs_compiler

from symscrew import catalogue
from symscrew.mobility.analysis import analyse_mobility
from symscrew.model import Model, derive
from symscrew.program.numpy_evaluation import evaluate
from symscrew.reference.newton_euler_method import newton_euler
from symscrew.simulation.motion import simulate
from symscrew.studies.accuracy import states as accuracy_states
from symscrew.studies.accuracy.claims_study import newton_euler_program
from symscrew.studies.accuracy.load_sharing import evaluated, loaded, redundancy, sharing, without_limbs
from symscrew.studies.accuracy.measuring import Point, Setup, measured
from symscrew.studies.accuracy.momentum_study import drive_map, drives_of, momenta_of, neighbour, reference_rates
from symscrew.studies.accuracy.run_history import read_reference
from symscrew.studies.accuracy.serial_formulas import Chains, least_squares
from symscrew.studies.accuracy.states import States, Subject, body_states_of, paper_states, random_states
from symscrew.studies.accuracy.study_tables import front
from symscrew.studies.accuracy.typed_code import COMPLEX, as_floats, in_digits, only, typed_function
from symscrew.studies.timing import quartiles


@cache
def seed() -> Model:
    return derive(catalogue.load("three_ups_upu_s"))


@cache
def states() -> States:
    return random_states(seed(), 12)


# -- the harness --------------------------------------------------------------------------------------


def test_setups_are_run_in_turn_and_failures_stay() -> None:
    order: list[str] = []

    def run(name: str, seconds: float):  # type: ignore[no-untyped-def]
        def once() -> float:
            order.append(name)
            return seconds

        return once

    def fails() -> float:
        raise ArithmeticError("a pivot is small")

    setups = [
        Setup("a", "1", run("a", 2e-3), lambda: 0.5, 2.0),
        Setup("b", "1", fails, lambda: 0.0),
        Setup("c", "1", run("c", 1e-3), lambda: float("nan")),
        Setup("d", "1", run("d", 3e-3), lambda: 0.25),
    ]
    a, b, c, d = measured(setups, repeats=5, seconds=60.0)
    assert order == ["a", "c", "d", *["a", "d"] * 5]  # the first for the error, then in turn
    assert a.cost == quartiles([1e-3] * 5)  # by the share
    assert (a.error, d.error) == (0.5, 0.25)
    assert (b.error, b.cost, b.failure) == (None, None, "a pivot is small")
    assert (c.error, c.failure) == (None, "the result is not finite")


def test_quartiles_are_those_of_the_laps() -> None:
    laps = iter([9.0, 1.0, 2.0, 3.0, 4.0, 5.0])  # the first run takes long and counts
    (point,) = measured([Setup("a", "", lambda: next(laps), lambda: 1.0)], repeats=5, seconds=60.0)
    assert point.cost is not None
    assert point.cost.median == np.median([9, 1, 2, 3, 4])
    assert point.cost.repeats == 5


def test_a_front_has_no_point_that_another_beats() -> None:
    def point(error: float, seconds: float) -> Point:
        return Point("a", "", error, quartiles([seconds]))

    good, beaten = [point(1e-2, 1.0), point(1e-4, 2.0)], point(1e-3, 3.0)
    assert front([*good, beaten]) == good


# -- kinematics ---------------------------------------------------------------------------------------


def test_serial_chains_have_the_screws_of_the_generated_code_and_the_papers_matrix() -> None:
    chains = Chains(seed().mechanism)
    matrix = chains.matrix(chains.start())
    assert matrix.shape == (30, 26)
    screws = seed()("joint_screws", seed().system.reference)[0][0].reshape(26, 6).T
    total = sum(matrix[6 * k : 6 * k + 6] for k in range(5))
    assert np.abs(total - screws).max() < 1e-15


def test_least_squares_step_in_c_is_that_of_numpy() -> None:
    from symscrew.functions.kinematic import Motion, kinematic_functions
    from symscrew.studies.accuracy.pose_study import least_squares_program

    system = seed().system
    functions = {f.name: f for f in kinematic_functions(system, Motion(system))}
    labels = functions["joint_rates"].outputs[0].labels
    limbs = [
        [k for k, label in enumerate(labels) if label.split(".")[0] in limb.joints]
        for limb in seed().mechanism.limbs.values()
    ]
    program = least_squares_program(system, functions["joint_screws"].results[0], labels, limbs)
    chains = Chains(seed().mechanism)
    twist = np.array([0.1, -0.2, 0.05, 0.0, 0.0, 0.0])
    expected = least_squares(chains.matrix(chains.start()), twist)
    (got,), _ = evaluate(program, [system.reference, twist])
    assert np.abs(got - expected).max() < 1e-12


# -- momentum -----------------------------------------------------------------------------------------


def test_reference_rates_and_drive_map_are_right_by_newton_euler() -> None:
    found = states()
    exact = reference_rates(seed(), States(found.q[:3], found.v[:3], found.a[:3], ""))
    analytic = seed()("momentum_rates", found.q[:3], found.v[:3], found.a[:3])[0][0]
    assert np.abs(exact - analytic).max() < 1e-13 * np.abs(analytic).max()
    to_drives = drive_map(seed(), found)
    inertial = np.einsum("nij,nj->ni", to_drives, seed()("momentum_rates", found.q, found.v, found.a)[0][0])
    other = newton_euler(seed().mechanism, body_states_of(seed(), found), gravity=(0.0, 0.0, 0.0)).drives
    assert np.abs(inertial - other).max() < 1e-12 * np.abs(other).max()
    weight = newton_euler(seed().mechanism, body_states_of(seed(), found)).drives
    assert np.abs(drives_of(seed(), found) - weight).max() < 1e-12 * np.abs(weight).max()


@pytest.mark.parametrize("order, steps", [(1, (1e-3, 1e-4)), (2, (1e-2, 1e-3))])
def test_differences_have_their_order(order: int, steps: tuple[float, float]) -> None:
    found = states()
    exact = seed()("momentum_rates", found.q, found.v, found.a)[0][0]
    errors = []
    for h in steps:
        after = momenta_of(seed(), *neighbour(seed(), found, h))
        before = momenta_of(seed(), *neighbour(seed(), found, 0.0 if order == 1 else -h))
        errors.append(np.abs((after - before) / (h * order) - exact).max())
    assert np.log10(errors[0] / errors[1]) / np.log10(steps[0] / steps[1]) == pytest.approx(order, abs=0.02)


def test_programs_for_other_number_types() -> None:
    program = only(seed().programs["momentum_screws"], ("momenta",))  # type: ignore[arg-type]
    found = states()
    (expected,), _ = evaluate(program, [found.q[0], found.v[0]])
    (digits,) = as_floats(in_digits(program, [found.q[0], found.v[0]]))
    assert np.abs(digits - expected).max() < 1e-14 * np.abs(expected).max()
    text = typed_function(program, "screws", COMPLEX)
    assert "csin(" in text
    assert "double complex *out0" in text


@needs_compiler
def test_study_of_momentum_shows_the_floors() -> None:
    from symscrew.studies.accuracy import momentum_study

    study = momentum_study.study(Subject(derive(catalogue.load("four_bar"))), QUIET, repeats=1, seconds=0.1)
    floors = {name: least_error(study, name) for name in study.curves}
    assert study.reference_error is not None
    assert study.reference_error < 1e-11
    assert floors["analytic"] < 1e-12
    assert floors["complex step"] < 1e-12
    assert floors["Richardson"] < floors["central difference"] < floors["first-order difference"]
    first = study.curves["first-order difference"]
    errors = [p.error for p in first if p.error is not None]
    assert 0 < int(np.argmin(errors)) < len(errors) - 1  # rounding grows below the best step
    analytic = study.curves["analytic"][0]
    assert analytic.cost is not None
    assert analytic.cost.median > 0


# -- precision, claims --------------------------------------------------------------------------------


@needs_compiler
def test_study_of_precision() -> None:
    from symscrew.studies.accuracy import precision_study

    study = precision_study.study(Subject(derive(catalogue.load("ur5"))), QUIET, repeats=1, seconds=0.1)
    errors = {(p.curve, p.setting): p.error for p in study.points}
    assert study.reference_error is not None
    assert study.reference_error < 1e-16
    for name in ("inverse dynamics", "forward dynamics"):
        assert 1e-17 < errors[name, "float64"] < 1e-13
        assert 1e-17 < errors[name, "float64, fast-math"] < 1e-13
        assert 1e-9 < errors[name, "float32"] < 1e-3
    assert np.float64(1e-310) / 2 > 0  # -ffast-math would flush denormals in all of this process (seen: IPOPT fails)


@needs_compiler
@pytest.mark.slow
def test_study_of_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Float keeps its seven digits less what a function loses; who subtracts nearly equal numbers loses more."""
    from symscrew.studies.accuracy import digits_study

    monkeypatch.setattr(digits_study, "FUNCTIONS", ("inverse_dynamics", "drive_rates"))
    study = digits_study.study(Subject(derive(catalogue.load("four_bar"))), QUIET, repeats=1, seconds=0.1)
    ((head, rows),) = study.tables.values()
    ways = [name for name in head if "float" in name and "loses" not in name]
    assert "C, float32" in ways and ("CUDA as C++, float32" in ways or any("C++" in text for text in study.left_out))
    assert any("CUDA, float64" in text or "CUDA, float32" in text for text in study.left_out)  # no device is here
    for row in rows:
        told = dict(zip(head, row, strict=True))
        for way in ways:
            digits = 17.0 if told[way] == "all" else float(told[way])
            assert 5.0 < digits < 9.0 if "32" in way and told[way] != "all" else digits > 13.0
    errors = {(p.curve, p.setting): p.error for p in study.points}
    assert all(0 <= error < 1e-13 for (way, _), error in errors.items() if "64" in way)
    assert 1e-9 < errors["C, float32", "inverse_dynamics"] < 1e-4
    exact = (np.array([[1.0, 2.0], [3.0, 4.0]]),), np.array([0, 0])
    spoiled = (np.array([[1.0, 2.0], [3.0 + 1e-3, 4.0]]),), np.array([0, 0])
    assert digits_study._worst(spoiled, exact)[1:] == (0, 1, 0)
    assert digits_study._worst(spoiled, exact)[0] == pytest.approx(1e-3 / 4)
    failed = (np.array([[1.0, 2.0], [np.nan, np.nan]]),), np.array([0, 2])
    assert digits_study._worst(failed, exact)[0] == 0.0


def test_newton_euler_program_gives_the_rates_of_the_momentum_screws() -> None:
    found = states()
    (wrenches,), _ = evaluate(newton_euler_program(seed().system), [found.q, found.v, found.a])
    rates = seed()("momentum_rates", found.q, found.v, found.a)[0][0]
    assert np.abs(wrenches - rates).max() < 1e-13 * np.abs(rates).max()


def test_limbs_share_the_whole_load() -> None:
    model = loaded(seed().mechanism)
    _, rows = sharing(model, states())
    assert [row[0] for row in rows] == ["limb1", "limb2", "limb3", "limb4", "limb5", "sum"]
    assert rows[-1][2] == rows[-1][4] == "100.0 %"
    assert float(rows[-1][1]) == 1000.0


def test_mechanism_without_two_limbs_keeps_its_freedoms() -> None:
    reduced = without_limbs(seed().mechanism, ("limb2", "limb3"))
    assert analyse_mobility(reduced).dof == 2
    assert len(reduced.bodies) == len(seed().mechanism.bodies) - 4


@pytest.mark.slow
def test_additional_limbs_lower_the_peak_drive_and_a_singular_choice_fails() -> None:
    reduced = without_limbs(seed().mechanism, ("limb2", "limb3"))
    with pytest.MonkeyPatch.context() as coarse:
        coarse.setattr(accuracy_states, "MOTION_STEPS", 100)  # of the motion that states are taken from, then closed
        _, rows = redundancy(loaded(seed().mechanism), paper_states(seed(), 3))
        found = paper_states(loaded(reduced), 3)
    by_name = {row[0]: row for row in rows}
    whole, fourth = by_name["all limbs"], by_name["only limb4 of the UPS limbs"]
    assert (whole[1], fourth[1]) == ("4", "2")
    assert float(fourth[3]) > float(whole[3])
    assert "singular" in by_name["only limb3 of the UPS limbs"][4]  # in line with limb 1: no drive about x
    balanced = evaluated(loaded(reduced), "inverse_dynamics", found, np.zeros(6))[0]
    assert np.abs(balanced - drives_of(derive(reduced), found)).max() < 1e-9


# -- forward, benchmark problems ------------------------------------------------------------------------


@pytest.mark.slow
@needs_compiler
def test_study_of_formulations_on_andrews() -> None:
    from symscrew.scene.scene_file import load_scene
    from symscrew.studies.accuracy import forward_study

    path = EXAMPLES / "andrews.toml"
    scene = load_scene(path)
    subject = Subject(derive(scene.mechanism, scene.effects), scene)
    with pytest.MonkeyPatch.context() as few:  # the settings that are looked at below; stiff libraries have their test
        few.setattr(forward_study, "SUBSTEPS", (32, 64, 128))
        few.setattr(forward_study, "TOLERANCES", (1e-4, 1e-8, 1e-12))
        few.setattr(forward_study, "OURS", (1e-4, 1e-8, 1e-12))
        few.setattr(forward_study, "stiff_setups", lambda *_, **__: ([], []))
        study = forward_study.study(subject, QUIET, repeats=1, seconds=0.1, path=path)
    for kind in ("projection", "stabilised (Gear-Gupta-Leimkuhler)", "no stabilisation", "minimal coordinates"):
        assert least_error(study, f"DOP853, {kind}") < 1e-8, kind
        steps = [p.error for p in study.curves[f"RK4, {kind}"]]
        assert steps[0] / steps[2] > 40, kind  # order 4 at two halvings: 256
    assert least_error(study, "DOP853, penalty") < 1e-3
    assert least_error(study, "symscrew simulate: DOP853, projection") < 1e-9
    header, rows = next(table for table in study.tables.values() if "ours [ms]" in table[0])
    stated = next(row for row in rows if "stated" in row[0])
    assert float(stated[header.index("ours [ms]")]) > 0
    assert any(p.facts.get("peer") for p in study.points)


LONG = {"stewart": 5}
"""Benchmark -> into how many parts it is cut, of which the first is simulated."""
BENCHMARKS = sorted(path.name.removesuffix(".reference.json") for path in EXAMPLES.glob("*.reference.json"))
CLOSER = {"bricard", "delta", "flyball_governor", "heavy_top", "spatial_slider_crank"}
"""Those that `test_simulation.test_reference_histories` holds to the same histories, nearer than they state."""


def test_reference_histories_state_their_errors() -> None:
    assert len(BENCHMARKS) >= 11
    for name in BENCHMARKS:
        reference = read_reference(EXAMPLES / f"{name}.toml")
        assert reference is not None
        assert np.allclose(np.diff(reference.times), reference.times[1], rtol=1e-9)
        assert reference.stated is not None
        assert reference.own_error is not None
        assert reference.own_error < reference.stated


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("name", [name for name in BENCHMARKS if name not in CLOSER])
def test_benchmarks_are_solved_to_their_stated_accuracy(name: str) -> None:
    from symscrew.scene.scene_file import load_scene

    path = EXAMPLES / f"{name}.toml"
    scene, reference = load_scene(path), read_reference(path)
    assert reference is not None and reference.stated is not None
    assert reference.times[-1] >= scene.duration * (1 - 1e-12)
    count = 1 + (len(reference.times) - 1) // LONG.get(name, 1)
    reference = replace(reference, times=reference.times[:count], values=reference.values[:count])
    tight = replace(scene.integrator, method="dop853", step=None, tolerance=1e-11)
    run = simulate(replace(scene, rate=1 / reference.times[1], duration=reference.times[-1], integrator=tight))
    assert run.ok
    assert reference.error_of(run.model)(run.q) < reference.stated


@needs_compiler
def test_stiff_libraries_converge() -> None:
    """Each of them on the pendulum: tighter tolerances, smaller errors; set-up is not part of the run's time."""
    from symscrew.scene.scene_file import load_scene
    from symscrew.simulation.motion import prepare
    from symscrew.studies.accuracy.forward_study import beginning
    from symscrew.studies.accuracy.measuring import Stopwatch
    from symscrew.studies.accuracy.stiff import stiff_setups

    path = EXAMPLES / "simple_pendulum.toml"
    reference = read_reference(path)
    assert reference is not None
    times = reference.times[:4]
    scene = replace(load_scene(path), rate=1 / times[1], duration=times[-1])
    found, plant = prepare(scene)
    few = replace(reference, times=times, values=reference.values[:4])
    setups, missing = stiff_setups(scene, plant, beginning(scene, found, plant), few.error_of(found), watch=Stopwatch())
    assert not missing
    assert {setup.curve.split()[0] for setup in setups} == {"Radau", "BDF", "CVODES"}
    errors: dict[str, list[float]] = {}
    for setup in setups:
        assert setup.run() > 0
        errors.setdefault(setup.curve, []).append(setup.error())
    for curve, values in errors.items():
        assert values[-1] < 1e-6, curve
        assert values[-1] < 1e-2 * values[0], curve


@needs_compiler
def test_chain_of_loops_falls_as_one_pendulum_and_its_operations_are_linear() -> None:
    from symscrew.studies.accuracy import growth_study

    models = {n: derive(growth_study.four_bars(n), (growth_study.Gravity((0, "-9.81", 0)),)) for n in (1, 2, 3)}
    for name in growth_study.FUNCTIONS:
        one, two, three = (models[n].programs[name].operations["total"] for n in (1, 2, 3))
        assert three - two == two - one, name
    setup = growth_study._setup(models[2], 2, growth_study.Stopwatch())
    setup.run()
    assert setup.error() < 1e-5  # through about ten singular positions


# -- the command ----------------------------------------------------------------------------------------

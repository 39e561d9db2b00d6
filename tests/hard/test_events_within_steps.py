"""Rigid stops: met between two steps, several at once, moved into at the start, slid along through a change point.

Every claim is of a class: random amplitudes, tolerances, units; solutions by hand.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from support.marks import slow
from support.samples import some_quickly

from hard.mechanisms import chain, four_bars
from symscrew.catalogue import load
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects import DryFriction, EndStop, Gravity, JointSpring
from symscrew.effects.effect import Effect
from symscrew.effects.records import Contact
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation import mode_ends
from symscrew.simulation.complementarity import complementary
from symscrew.simulation.contacts import ContactState, Law, Modes, forces, released
from symscrew.simulation.motion import Run, simulate

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: the compiled loop looks for events"),
]


def block() -> Mechanism:
    """1 kg on a slider along z."""
    body = {"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    return chain("block", ("z", "P", "base", "block", [0, 0, 0], [[0, 0, 1]]), block=body)


def pushed_block() -> Mechanism:
    """The same with a drive."""
    body = {"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1]}
    return chain("block", ("z", "P", "base", "block", [0, 0, 0], [[0, 0, 1]]), driven="z", block=body)


def run(mechanism: Mechanism, effects: tuple[Effect, ...], duration: float, tolerance: float, **initial: object) -> Run:
    integrator = Integrator(tolerance=tolerance)
    found = simulate(Scene("s", mechanism, effects, duration, 20.0, Initial(**initial), integrator=integrator))  # type: ignore[arg-type]
    assert found.ok, found.status
    return found


@pytest.mark.parametrize("tolerance", some_quickly([1e-2, 1e-5, 1e-8, 1e-12], every=3))
@pytest.mark.parametrize("short", [1e-1, 1e-3, 1e-5, 1e-7])
def test_a_stop_that_is_passed_for_a_moment(tolerance: float, short: float) -> None:
    """cos t and a stop at 1 - short: passed for sqrt(8 short) seconds, which no step hits. Looked at in four places
    of a step only, half of these were missed."""
    spring, stop = JointSpring("z", stiffness=1), EndStop("z", upper=1 - short, mode="impact", restitution="0.5")
    found = run(block(), (spring, stop), 4.0, tolerance, coordinates={"z": -1})
    free = run(block(), (spring,), 4.0, tolerance, coordinates={"z": -1})
    reached = float(np.hypot(free.q[55:70], free.v[55:70]).min())  # around pi: what the integrator left of the 1
    assert abs(reached - 1) < max(1e-2 * tolerance, 1e-13)  # as far off as a place may be, below
    if reached < 1 - short:  # the computed motion turns back before the stop
        assert not found.events and short < 1e-2 * tolerance
        return
    when = float(found.events[0].split()[2])
    assert "z meets its upper stop" in found.events[0]
    error = tolerance / np.sqrt(2 * short) + 1e-7  # an error of place by the speed at the stop
    assert abs(when - np.arccos(-(1 - short))) < error
    assert found.q.max() < 1 - short + 1e-2 * tolerance + 1e-11


@pytest.mark.parametrize("short, method", [(1e-2, "dop853"), (1e-4, "dop853"), (1e-5, "dop853"), slow(1e-4, "radau")])
def test_such_a_stop_is_met_by_the_integrators_of_a_library(short: float, method: str) -> None:
    """Looked at in five places of a step, that of 1e-4 was missed at a tolerance of 1e-8, and called completed."""
    spring, stop = JointSpring("z", stiffness=1), EndStop("z", upper=1 - short, mode="impact", restitution="0.5")
    start = Initial(coordinates={"z": -1})
    scene = Scene("s", block(), (spring, stop), 4.0, 20.0, start, integrator=Integrator(method=method, tolerance=1e-7))
    found = simulate(scene, backend="numpy")
    assert len(found.events) == 1 and "z meets its upper stop" in found.events[0]
    assert abs(float(found.events[0].split()[2]) - np.arccos(-(1 - short))) < 1e-6
    speed = 0.5 * np.sqrt(short * (2 - short))  # behind the stop: half of that before
    behind = found.t > 3.2
    later = found.t[behind] - np.arccos(-(1 - short))
    by_hand = (1 - short) * np.cos(later) - speed * np.sin(later)
    assert np.abs(found.q[behind, 0] - by_hand).max() < 1e-6
    assert np.abs(found.energy_balance).max() < 1e-7


def test_zeros_of_a_step_are_found_however_short_what_lies_behind_them() -> None:
    """Polynomials with known zeros: pairs that are 1e-1 to 1e-7 apart, and none."""
    random = np.random.default_rng(2)
    for apart in np.repeat([1e-1, 1e-3, 1e-5, 1e-7], 25):
        first = random.uniform(0.01, 0.8)
        outside = random.uniform(1.1, 3.0, 3) * random.choice([-1, 1], 3)
        p = np.polynomial.Polynomial.fromroots([first, first + apart, *outside])
        c = np.zeros(mode_ends.DEGREE + 1)
        c[: len(p.coef)] = p.coef * np.sign(p(0.0))
        assert abs(mode_ends.end_of(c, 1e-16, np.zeros(9)) - first) < 1e-15 / apart + 1e-12, (first, apart)
        c[0] += 1.1 * np.abs(p(np.linspace(first, first + apart, 201))).max() + 1e-15
        assert mode_ends.end_of(c, 1e-16, np.zeros(9)) > 1  # it turns back before


def test_roundings_of_a_step_in_which_nothing_moves_are_no_event() -> None:
    """A stop that is left begins at rest; without what roundings make of coefficients it was met again without end."""
    random = np.random.default_rng(5)
    unit = mode_ends._powers()
    noise = mode_ends.ROUNDINGS * mode_ends._growth()
    met = 0
    for _ in range(200):
        values = np.finfo(float).eps * random.integers(-1, 2, 9)  # of an angle of about one
        met += mode_ends.end_of(unit @ values, 1e-11, np.zeros(9)) <= 1
        assert mode_ends.end_of(unit @ values, 1e-11, noise) > 1
        falling = values - 1e-6 * mode_ends.places()
        assert mode_ends.end_of(unit @ falling, 1e-11, noise) == 0.0
    assert met > 50


@pytest.mark.parametrize("speed", [1e-6, 1.0, 30.0])
def test_started_on_a_stop_and_moving_into_it(speed: float) -> None:
    """At once thrown back with e times the speed; half of the block's energy is booked by the joint's name."""
    stop = EndStop("z", lower=0, mode="impact", restitution="0.5")
    found = run(block(), (stop,), 1.0, 1e-8, rates={"z": -speed})
    assert found.events[0] == "t = 0 s: z meets its lower stop"
    after = 0.5 * speed  # nothing turns it back, however slow it is
    assert found.v[-1, 0] == pytest.approx(after, abs=1e-12) and found.q.min() >= 0
    assert found.losses["z"] == pytest.approx(0.5 * speed**2 - 0.5 * after**2, rel=1e-9)


def test_two_stops_met_at_one_instant() -> None:
    """Two equal blocks, one carried by the other's slider: both meet their stops at 1 s, each by its own law."""
    builder = MechanismBuilder("two")
    for name, axis in (("x", [1, 0, 0]), ("y", [0, 1, 0])):
        builder.body(f"block_{name}", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
        builder.joint(name, "P", parent="base", child=f"block_{name}", point=[0, 0, 0], axes=[axis])
    stops = tuple(EndStop(n, upper=1, mode="impact", restitution=e) for n, e in (("x", "0.5"), ("y", "0.25")))
    found = run(builder.build(), stops, 2.0, 1e-8, rates={"x": 1, "y": 1})
    assert [text.split(" s: ")[0] for text in found.events] == ["t = 1", "t = 1"]
    assert sorted(found.v[-1]) == pytest.approx([-0.5, -0.25], abs=1e-9)
    assert found.losses == pytest.approx({"x": 0.5 - 0.125, "y": 0.5 - 0.03125})
    assert np.abs(found.energy_balance).max() < 1e-9


def test_an_output_at_the_instant_of_an_impact_is_of_that_instant() -> None:
    """Between two stops at 3 m/s: 150 impacts in 100 s, some of them at an output's time to the last digit, where what
    was written is the state at the end of the step whose rest the impact had cut off, 298 m away."""
    found = run(block(), (EndStop("z", lower=-1, upper=1, mode="impact", restitution=1),), 100.0, 1e-8, rates={"z": 3})
    way = np.mod(3 * found.t + 1, 4)
    assert len(found.events) == 150
    assert np.abs(found.q[:, 0] - np.where(way < 2, way - 1, 3 - way)).max() < 1e-11


@pytest.mark.parametrize("often", [0.01, 1.0, 7.3])
def test_a_stop_that_is_left_as_the_force_on_it_fades(often: float) -> None:
    """Pressed by sin t until pi, and off: once. It was met again at once and left again, ten thousand times, by the
    sign of a second derivative that is zero but for rounding."""
    end, rate = 4.5 / often, 20 * often / 4.5
    stop = EndStop("z", upper=0, mode="impact", restitution="0.3")
    scene = Scene("s", pushed_block(), (stop,), end, rate, drives={"z": f"3*sin({often}*t)"})
    found = simulate(scene)
    assert found.accurate and [text.split(" s: ")[1] for text in found.events] == ["z leaves its stop"]
    assert found.q[-1, 0] * often**2 == pytest.approx(-3 * (np.sin(4.5) + 4.5 - np.pi), abs=1e-8)


@pytest.mark.parametrize(("backend", "level"), [("c", 0.8), ("c", 7.0), ("numpy", 0.8)])
def test_a_joint_that_rubs_leaves_its_stop_and_sticks(backend: str, level: float) -> None:
    """A force that falls by 4 N/s lets the stop go at the friction's level, and moves the block at minus this level:
    between, it sticks. At the level it was said to slip on and turned back, ten thousand times in an instant."""
    force = {"z": f"{2.5 * level} - {4 * level}*t"}
    rubs = DryFriction("z", coulomb=str(level), mode="event"), EndStop("z", upper="1/2", mode="impact")
    start = Initial(coordinates={"z": 0.5}, rates={"z": 0.1})
    scene = Scene("s", pushed_block(), rubs, 1.5, 20.0, start, drives=force, integrator=Integrator(tolerance=1e-9))
    found = simulate(scene, backend=backend)
    slips = 3.5 / 4
    moved = np.where(found.t > slips, -4 * level / 6 * (found.t - slips) ** 3, 0.0)
    assert found.accurate and np.abs(found.q[:, 0] - 0.5 - moved).max() < 1e-9 * level
    assert [text.partition(": ")[2] for text in found.events] == [
        "z meets its upper stop", "z leaves its stop", "z sticks", "z slips"
    ]  # fmt: skip


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_friction_of_a_crank_that_a_stop_of_its_slider_holds(backend: str) -> None:
    """Rounding of the crank's rate turned its friction back ten thousand times, as long as the slider was pressed onto
    its stop. The stop lets go as the torque falls to the friction's level, and what sticks then slips at minus it."""
    rubs = DryFriction("crank_R", coulomb="1/2", mode="event"), EndStop("slider_P", upper=0, mode="impact")
    scene = Scene("s", load("slider_crank"), rubs, 0.7, 20.0, drives={"crank_R": "30*t - 20"})
    found = simulate(scene, backend=backend)
    assert found.accurate
    said = [text.removeprefix("t = ").split(" s: ") for text in found.events[-3:]]
    assert [what for _, what in said] == ["slider_P leaves its stop", "crank_R sticks", "crank_R slips"]
    assert [float(t) for t, _ in said] == pytest.approx([19.5 / 30, 19.5 / 30, 20.5 / 30], abs=1e-6)


def test_what_hardly_moves_is_judged_by_the_tolerance() -> None:
    """A force that reaches the friction's level as it turns back: the block slips for 2e-8 s, by 1e-25 m. The energy
    that this takes was called out of balance by 1e24 of what moved."""
    friction = DryFriction("z", coulomb=1, mode="event")
    found = simulate(Scene("s", pushed_block(), (friction,), 2.0, 20.0, drives={"z": "1 - (1 - t)^2"}))
    assert found.accurate and np.abs(found.q).max() < 1e-20


def test_impulses_only_push() -> None:
    """Random stops of one body: p >= 0, w >= 0, p w = 0, also where stops depend on each other."""
    random = np.random.default_rng(7)
    for _ in range(200):
        root = random.normal(size=(3, 5))
        gain, offset = root.T @ root, root.T @ random.normal(size=3)  # five stops on three freedoms
        p = complementary(gain, offset)
        w = gain @ p + offset
        assert p.min() >= 0 and w.min() > -1e-9 and abs(p @ w) < 1e-9


@pytest.mark.parametrize("static", [1.0, 1.5])
def test_what_rests_lets_go_together(static: float) -> None:
    """Random joints at rest that rub or are on stops, with masses that couple them: who slips speeds up along its slip
    and is held by its level, who is held needs no more than its level, stops push only and let nothing sink in. Ended
    one after the other by what each needs while all are held, a stop that was let go sank in, in two of 150 arms with
    three stops: ten thousand changes in an instant, and no end for minutes."""
    random = np.random.default_rng(11)
    for trial in range(150):
        n = int(random.integers(2, 5))
        turned = np.linalg.qr(random.normal(size=(n, n)))[0]
        mobility = turned @ np.diag(np.logspace(0, -2, n)) @ turned.T
        pull = random.normal(size=n) * np.exp(random.normal(size=n))
        rubs, ends = random.random(n) < trial % 3 / 2, random.choice([-1, 1], n)
        level = np.where(rubs, np.abs(random.normal(size=n)) / 2, 0.0)
        rules = [
            Law(
                Contact("friction" if rub else "stop", f"p{k}", f"j{k}", 0), k, k, c, static * c, np.inf,
                -np.inf if rub or end > 0 else 0.0, np.inf if rub or end < 0 else 0.0, 0.0,
            )
            for k, (rub, c, end) in enumerate(zip(rubs, level, ends, strict=True))
        ]  # fmt: skip
        at = ContactState(rules, np.zeros(n), np.zeros(n), np.ones(n), lambda _, f, m=mobility, p=pull: m @ (p + f))
        modes = released(at, Modes(tuple(np.where(rubs, 0, ends).tolist())))
        force = forces(at, modes)
        a = at.accelerations(force)
        sign, small = np.array(modes.values), 1e-9 * np.abs(a).max() + 1e-13
        assert (np.abs(force[rubs]) <= np.where(sign == 0, static * level, level * (1 + 1e-12))[rubs]).all()
        assert (sign * a >= -small)[rubs].all()
        assert (ends * force <= 0)[~rubs].all() and (ends * a <= small)[~rubs].all()
        assert (np.abs(a) < small)[rubs & (sign == 0)].all()


def test_a_stop_that_is_never_met_changes_nothing() -> None:
    """The parallelogram keeps its branch through the change points, with a stop as without; and ends soon."""
    bars = four_bars(1, width="2", coupler="3")
    fall, start = Gravity((0, "-9.81", 0)), {"rates": {"A0": -1.0}}
    stop = EndStop("A0", lower="-1e4", mode="impact")
    free, stopped = (run(bars, effects, 3.0, 1e-8, **start) for effects in ((fall,), (fall, stop)))
    assert len(stopped.crossings) == len(free.crossings) > 0
    assert np.abs(stopped.q - free.q).max() < 1e-12
    assert stopped.counters["evaluations"] < 1.1 * free.counters["evaluations"]


def parallelogram(base: str) -> Mechanism:
    """On the ground, "base", or on a carriage on a rail along x."""
    builder = MechanismBuilder("carried")
    rod = {"mass": 1, "inertia": ["1/12", "1/12", "1/12"]}
    if base != "base":
        builder.body(base, mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.body("crank0", com=[0, "1/2", 0], **rod)
    builder.body("crank1", com=[2, "1/2", 0], **rod)
    builder.body("coupler", mass=3, com=[1, 1, 0], inertia=[1, 1, 1])
    if base != "base":
        builder.joint("rail", "P", parent="base", child=base, point=[0, 0, 0], axes=[[1, 0, 0]])
    z = [[0, 0, 1]]
    builder.joint("A0", "R", parent=base, child="crank0", point=[0, 0, 0], axes=z)
    builder.joint("B0", "R", parent="crank0", child="coupler", point=[0, 1, 0], axes=z)
    builder.joint("A1", "R", parent=base, child="crank1", point=[2, 0, 0], axes=z)
    builder.joint("B1", "R", parent="crank1", child="coupler", point=[2, 1, 0], axes=z)
    return builder.build()


def test_slid_along_a_stop_through_a_change_point() -> None:
    """A parallelogram on a carriage that is pressed against its stop: the crank turns on through the flat position as
    it does on the ground, to the tolerance, and the stop bears what the carriage would be thrown about by."""
    pressed, start = Gravity((-200, 0, 0)), {"rates": {"A0": 5.0}}
    ground = run(parallelogram("base"), (pressed,), 1.0, 1e-13, **start)
    expected = ground.q[:, [c.label for c in ground.model.system.tree.q].index("A0")]
    for tolerance in (1e-5, 1e-8, 1e-12):
        effects = (EndStop("rail", lower=0, mode="impact"), pressed)
        found = run(parallelogram("carriage"), effects, 1.0, tolerance, **start)
        at = {c.label: k for k, c in enumerate(found.model.system.tree.q)}
        assert np.abs(found.q[:, at["rail"]]).max() < 1e-13 and not found.events
        assert len(found.crossings) == len(ground.crossings) > 3
        assert np.abs(found.q[:, at["A0"]] - expected).max() < 0.02 * tolerance + 1e-14


@pytest.mark.parametrize("gap", [slow(1e-3), 3e-6, slow(1e-9)])
def test_between_two_stops_however_near_they_are(gap: float) -> None:
    """A block at 1 m/s strikes one after the other; what would be met behind the end of the run is not told. Where both
    were nearer than a fresh contact may be moved, the other one counted as met at once, ten thousand times."""
    stop = EndStop("z", lower=repr(-gap), upper=repr(gap), mode="impact", restitution=1)
    found = run(block(), (stop,), 12.5 * gap, 1e-8, rates={"z": 1.0})
    times = [float(text.split()[2]) for text in found.events]
    assert times == pytest.approx([gap * (2 * k + 1) for k in range(6)], rel=1e-6)
    assert found.q[-1, 0] == pytest.approx(0.5 * gap, rel=1e-6)
    assert [text.split()[-2] for text in found.events] == ["upper", "lower"] * 3


def stretched_crank() -> Mechanism:
    """Crank and rod in line: the slider neither moves nor answers its friction. The rod has no mass."""
    body = {"mass": 2, "com": [3, 0, 0], "inertia": [1, 1, 1]}
    crank = {"mass": 1, "com": [0, 0, 0], "inertia": ["1/10", "1/10", "1/10"]}
    return chain(
        "stretched",
        ("A", "R", "base", "crank", [0, 0, 0], [[0, 0, 1]]),
        ("S", "P", "base", "slider", [3, 0, 0], [[1, 0, 0]]),
        ("B", "R", "crank", "rod", [1, 0, 0], [[0, 0, 1]]),
        ("C", "R", "rod", "slider", [3, 0, 0], [[0, 0, 1]]),
        driven="A", crank=crank, rod={}, slider=body,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("method", "backend", "torque"),
    [("dop853", "c", 2.0), ("dop853", "c", -2.0), slow("radau", "c", -2.0), slow("dop853", "numpy", 2.0)],
)
def test_stuck_at_a_dead_point_at_rest(method: str, backend: str, torque: float) -> None:
    """The law of friction says nothing there. It was asked again and again, ten thousand times, at the same instant."""
    friction, choice = DryFriction("S", coulomb="0.5", mode="event"), Integrator(method=method, tolerance=1e-7)
    scene = Scene("s", stretched_crank(), (friction,), 0.4, 10.0, drives={"A": str(torque)}, integrator=choice)
    found = simulate(scene, backend=backend)
    assert found.accurate and len(found.events) <= 2

    def slopes(_: float, y: np.ndarray) -> list[float]:  # of the crank's angle, by hand
        c, s, root = np.cos(y[0]), np.sin(y[0]), np.sqrt(4 - np.sin(y[0]) ** 2)
        way = -s * (1 + c / root)
        bend = -c - (c * c - s * s) / root - (s * c) ** 2 / root**3
        force = -0.5 * np.sign(way * y[1])
        return [y[1], (torque + way * force - 2 * way * bend * y[1] ** 2) / (0.1 + 2 * way**2)]

    end = solve_ivp(slopes, (0, 0.4), [0, 0], method="DOP853", rtol=1e-11, atol=1e-13).y[0, -1]
    angle = [c.label for c in found.model.system.tree.q].index("A")
    assert abs(end) > 0.5 and found.q[-1, angle] == pytest.approx(end, abs=1e-8)


def test_a_stop_met_at_a_change_point_is_refused() -> None:
    """Where a parallelogram is flat, a stop of its crank holds the crank alone: the law of impact leaves its other
    joints turning, which no motion of the linkage does."""
    stop = EndStop("A0", lower=repr(float(-np.pi / 2)), mode="impact")
    bars, fall = four_bars(1, width="2", coupler="3"), Gravity((0, "-9.81", 0))
    found = simulate(Scene("s", bars, (fall, stop), 1.2, 20.0, Initial(rates={"A0": -1.0})))
    assert not found.ok and "belongs to none of them" in found.events[0], found.status
    beside = EndStop("A0", lower=repr(float(-np.pi / 2 + 1e-6)), restitution="0.5", mode="impact")
    assert simulate(Scene("s", bars, (fall, beside), 1.2, 20.0, Initial(rates={"A0": -1.0}))).accurate


@pytest.mark.slow  # a thousand steps, each looked at with care
def test_a_run_that_crawls_ends() -> None:
    """A rhombus, whose coupler and other crank may turn on where it is flat, about one point: steps of 1e-14 s."""
    stop = EndStop("A0", lower=repr(float(-np.pi / 2)), mode="impact")
    fall, start = Gravity((0, "-9.81", 0)), Initial(rates={"A0": -1.0})
    stopped = simulate(Scene("s", four_bars(1), (fall, stop), 1.2, 20.0, start))
    assert "the step had to become too small" in stopped.status and stopped.counters["steps"] < 2000

"""Backlash of a drive and clearance of a bearing against equations typed by hand, integrated by SciPy.

The slider-crank has the data of P. Flores, J. Ambrosio, J.C.P. Claro, H.M. Lankarani, "Influence of the contact-impact
force model on the dynamic response of multi-body systems", Proc. IMechE K 220, 2006, 21-34: crank 0.05 m, rod 0.12 m,
radial clearance 0.5 mm between rod and slider, steel.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from symscrew.description.mechanism import Mechanism
from symscrew.description.toml_file import load_description
from symscrew.effects import Backlash, JointClearance
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.scene.scene_file import load_scene
from symscrew.simulation.motion import simulate

EXAMPLES = Path(__file__).parents[2] / "examples" / "effects"
L1, L2 = 0.05, 0.12
M1, M2, M3, J1, J2 = 0.30, 0.21, 0.14, 1e-5, 2.5e-5
CLEARANCE, STIFFNESS, DAMPING = 5e-4, 6.61e10, 0.285  # 3 (1 - 0.9^2)/(4 * 0.5 m/s)
MU, FADE, RADIUS, G = 0.1, 0.01, 0.0095, 9.81


def call(found: Model, function: str, **given: np.ndarray) -> np.ndarray:
    """The first output of a function, at inputs by name."""
    results, status = found(function, *[given[port.name] for port in found.programs[function].inputs])
    assert not status.any()
    return results[0]


@cache
def slider_crank() -> Mechanism:
    """In the plane x-y, stretched in the reference configuration, open between rod and slider."""
    return load_description(EXAMPLES / "mechanisms" / "loose_crank.toml")


def clearance(**more: object) -> JointClearance:
    rubs = {"friction": str(MU), "velocity": str(FADE), "radius": str(RADIUS)}
    given = {"hole": "hole", "pin": "pin", "clearance": str(CLEARANCE), "stiffness": STIFFNESS, "damping": str(DAMPING)}
    return JointClearance(**{**given, **rubs, **more})  # type: ignore[arg-type]


def by_hand(y: np.ndarray) -> np.ndarray:
    """Accelerations of crank, rod (absolute angles) and slider from angles, place and their rates."""
    th, ph, x, thd, phd, xd = y
    pin = np.array([L1 * np.cos(th) + L2 * np.cos(ph), L1 * np.sin(th) + L2 * np.sin(ph)])
    moves = np.array([-L1 * thd * np.sin(th) - L2 * phd * np.sin(ph), L1 * thd * np.cos(th) + L2 * phd * np.cos(ph)])
    e, ed = pin - [x, 0.0], moves - [xd, 0.0]
    size, force, couple = np.hypot(*e), np.zeros(2), 0.0
    if size > CLEARANCE:
        n = e / size
        f = STIFFNESS * (size - CLEARANCE) ** 1.5 * max(0.0, 1 + DAMPING * (n @ ed))
        t = np.array([-n[1], n[0]])
        slide = t @ ed + phd * RADIUS  # the slider does not turn
        rub = -MU * f * slide / np.hypot(slide, FADE)
        force, couple = -f * n + rub * t, rub * RADIUS
    c, s = np.cos(th - ph), np.sin(th - ph)
    m12 = M2 * L1 * L2 / 2 * c
    mass = np.array([[M1 * L1**2 / 4 + J1 + M2 * L1**2, m12], [m12, M2 * L2**2 / 4 + J2]])
    right = np.array([-M2 * L1 * L2 / 2 * s * phd**2 - (M1 / 2 + M2) * G * L1 * np.cos(th),
                      M2 * L1 * L2 / 2 * s * thd**2 - M2 * G * L2 / 2 * np.cos(ph) + couple])  # fmt: skip
    right += [L1 * (-np.sin(th) * force[0] + np.cos(th) * force[1]),
              L2 * (-np.sin(ph) * force[0] + np.cos(ph) * force[1])]  # fmt: skip
    return np.array([*np.linalg.solve(mass, right), -force[0] / M3])


def states(count: int) -> np.ndarray:
    """Angles, place and rates with the pin in, at and beyond the wall."""
    random = np.random.default_rng(2)
    th = random.uniform(0, 2 * np.pi, count)
    r, way = CLEARANCE * random.uniform(0, 1.2, count), random.uniform(0, 2 * np.pi, count)
    ph = np.arcsin((r * np.sin(way) - L1 * np.sin(th)) / L2)
    x = L1 * np.cos(th) + L2 * np.cos(ph) - r * np.cos(way)
    return np.column_stack([th, ph, x, *(random.uniform(-1, 1, (3, count)) * [[50], [50], [2]])])


@cache
def loose(*axis: int) -> Model:
    return derive(slider_crank(), [Gravity((0, "-9.81", 0)), clearance(axis=axis)])


@pytest.mark.parametrize("axis", [(), pytest.param((0, 0, -2), marks=pytest.mark.slow)])
def test_a_loose_pin_is_pushed_as_typed_by_hand(axis: tuple[int, ...]) -> None:
    found, y = loose(*axis), states(60)
    q = np.column_stack([y[:, 0], y[:, 1] - y[:, 0], y[:, 2] - L1 - L2])
    v = np.column_stack([y[:, 3], y[:, 4] - y[:, 3], y[:, 5]])
    expected = np.array([by_hand(one) for one in y])
    size = np.abs(expected).max(axis=1)
    touching = size > 1e5
    assert touching.any() and not touching.all()
    a = call(found, "forward_dynamics", q=q, v=v)
    got = np.column_stack([a[:, 0], a[:, 0] + a[:, 1], a[:, 2]])
    # a depth has 1e-16 of a length of 0.1 m, of 1e-4 m: 1e-12
    assert (np.abs(got - expected).max(axis=1) < 1e-9 * size).all()
    power = call(found, "effect_power", q=q, v=v)
    assert power.max() <= 0 and power.min() < 0


def solved(slopes: Callable[[float, np.ndarray], np.ndarray], start: Sequence[float], times: np.ndarray) -> np.ndarray:
    """States (times, entries) of equations typed by hand."""
    from scipy.integrate import solve_ivp

    longest = times[-1] / 1000
    return solve_ivp(slopes, (0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-13, max_step=longest).y.T


def stored(name: str) -> np.ndarray:
    """The reference history of an example's scene."""
    return np.array(json.loads((EXAMPLES / f"{name}.reference.json").read_text())["values"])


@pytest.mark.slow
def test_a_loose_pin_strikes_the_wall_as_scipy_integrates_it() -> None:
    """The first impacts within 3 ms of a crank at 5000 rpm; the verdict keeps the books."""
    scene = load_scene(EXAMPLES / "loose_crank.toml")
    run = simulate(scene)
    assert run.ok and run.accurate, run.verdict
    places, rates = scene.initial.coordinates, scene.initial.rates
    (a, b, c), (da, db, dc) = (tuple(float(given[joint]) for joint in "ABC") for given in (places, rates))
    start = [a, a + b, c + L1 + L2, da, da + db, dc]
    y = solved(lambda _, y: np.concatenate([y[3:], by_hand(y)]), start, run.t)
    pin = np.hypot(L1 * np.cos(y[:, 0]) + L2 * np.cos(y[:, 1]) - y[:, 2], L1 * np.sin(y[:, 0]) + L2 * np.sin(y[:, 1]))
    assert (pin > CLEARANCE).any() and (pin < 0.9 * CLEARANCE).any()
    typed = np.column_stack([y[:, 0], y[:, 1] - y[:, 0], y[:, 2] - L1 - L2])
    assert np.abs(stored("loose_crank") - typed).max() < 1e-9
    assert np.abs(run.q - typed).max() < 1e-7


# -- backlash of a drive ----------------------------------------------------------------------------------------------

PLAY, FLANK, INERTIA = 0.02, 4e3, 0.01


@cache
def pendulum() -> Mechanism:
    return load_description(EXAMPLES / "mechanisms" / "pendulum.toml")


def geared(exponent: object, damping: object) -> tuple[Gravity, Backlash]:
    lash = Backlash("A", str(PLAY), FLANK, str(INERTIA), exponent=exponent, damping=damping)  # type: ignore[arg-type]
    return Gravity((0, "-9.81", 0)), lash


def lashed(y: np.ndarray, push: float, exponent: float, damping: float) -> np.ndarray:
    """Slopes of angle, rate, place in the play and the actuator's rate."""
    angle, rate, apart, moving = y
    depth = abs(apart) - PLAY / 2
    sign, opening = np.sign(apart), moving - rate
    force = sign * FLANK * depth**exponent * max(0.0, 1 + damping * sign * opening) if depth > 0 else 0.0
    return np.array(
        [rate, (force - 2 * 9.81 * 0.3 * np.cos(angle)) / (0.05 + 2 * 0.09), opening, (push - force) / INERTIA]
    )


@pytest.mark.parametrize(("exponent", "damping"), [(1, 0), ("1.5", 3), (2, "0.4")])
def test_backlash_pushes_on_its_flanks_alone(exponent: object, damping: object) -> None:
    found = derive(pendulum(), geared(exponent, damping))
    random = np.random.default_rng(5)
    y = random.uniform(-1, 1, (40, 4)) * [3, 2, 0.03, 2]
    given = {"q": y[:, :1], "v": y[:, 1:2], "x": y[:, 2:], "actuator_A": np.full((40, 1), 0.7)}
    expected = np.array([lashed(one, 0.7, float(exponent), float(damping)) for one in y])  # type: ignore[arg-type]
    assert {0.0} < set(np.abs(np.minimum(0, np.abs(y[:, 2]) - PLAY / 2)))
    assert np.allclose(call(found, "forward_dynamics", **given)[:, 0], expected[:, 1], rtol=1e-12, atol=1e-12)
    assert np.allclose(call(found, "effect_state_rates", **given), expected[:, 2:], rtol=1e-12, atol=1e-12)


@pytest.mark.slow
def test_a_drive_with_backlash_hammers_as_scipy_integrates_it() -> None:
    run = simulate(load_scene(EXAMPLES / "geared_pendulum.toml"))
    assert run.ok and run.accurate, run.verdict
    y = solved(lambda t, y: lashed(y, 8 * np.cos(9 * t), 1.5, 3.0), [0.3, 0, 0, 0], run.t)
    assert y[:, 2].max() > PLAY / 2 and y[:, 2].min() < -PLAY / 2
    assert np.abs(stored("geared_pendulum")[:, 0] - y[:, 0]).max() < 1e-9
    assert np.abs(run.q[:, 0] - y[:, 0]).max() < 1e-6


# -- what does not fit ------------------------------------------------------------------------------------------------

REFUSED = [
    (clearance(clearance=0), "above 0"),
    (clearance(stiffness=-1), "above 0"),
    (clearance(velocity=None), "'velocity'"),
    (clearance(axis=(0, 0, 0)), "other than 0"),
    (clearance(axis=(0, 1)), "3 entries"),
    (clearance(pin="hole"), "two bodies"),
    (clearance(exponent=3), "1, 1.5 or 2"),
    (Backlash("A", 0, 1, 1), "above 0"),
    (Backlash("A", "0.1", 1, 0), "above 0"),
    (Backlash("D", "0.1", 1, 1), "a joint of the mechanism"),
]


@pytest.mark.parametrize(("effect", "text"), REFUSED)
def test_what_does_not_fit_is_refused(effect: object, text: str) -> None:
    from symscrew.effects.registry import check_effects

    with pytest.raises(DescriptionError, match=text):
        check_effects(slider_crank(), [effect])  # type: ignore[list-item]

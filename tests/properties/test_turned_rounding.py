"""Small pivots: which accelerations are believed follows from their own rounding, not from how small a pivot is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.four_bars_in_a_row import n_four_bar

from symscrew.description.builder import MechanismBuilder
from symscrew.effects.gravity import Gravity
from symscrew.model import Model, derive
from symscrew.program import Program, evaluate, exact_results
from symscrew.scene import Scene, load_scene
from symscrew.simulation.initial import initial_state
from symscrew.simulation.motion import prepare
from symscrew.simulation.run_source import source
from symscrew.simulation.state_programs import Plant, plant
from symscrew.simulation.turned_rounding import APART, Trial, trial, turned

DELTA = "examples/scenes/hanging_delta.toml"


def judged(made: Plant, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of states: the least pivot by its threshold, by how much roundings differ by what is believed, and the true error
    of the first path by what is usual."""
    found = trial(made)
    assert isinstance(found, Trial)
    inputs = [
        np.zeros((len(q), p.size)) if p.name not in "qv" else {"q": q, "v": v}[p.name] for p in made.slopes.inputs
    ]
    (a, _, pivots), _ = evaluate(replace(found.slopes, guards=()), inputs)
    (other,), _ = evaluate(found.turned, inputs)
    size = (np.abs(a) / made.units).max(axis=1)
    limit = np.maximum(found.apart, found.part * size)
    off = (np.abs(a - exact_results(found.slopes, inputs)[0]) / made.units).max(axis=1)
    least = (np.abs(pivots) / found.pivots).min(axis=1)
    return least, (np.abs(a - other) / made.units).max(axis=1) / limit, off / (limit / APART)


@pytest.fixture(scope="module")
def bars() -> Model:
    """A square four-bar: flat, where its cranks lie, it may go on in two ways."""
    return derive(n_four_bar(1), [Gravity((0, "-9.81", 0))])


def test_other_roundings_are_units_in_the_last_place(bars: Model) -> None:
    """Every product is rounded otherwise, the values stay, and what no acceleration reads is left out."""
    program = bars.programs["forward_dynamics"]
    assert isinstance(program, Program)
    other = turned(program, "other")
    count = {op: sum(o == op for _, o, _ in program.instructions) for op in ("add", "sub", "mul", "sin", "cos")}
    assert sum(op == "mul" for _, op, _ in other.instructions) > count["mul"]
    given = bars.test_inputs["forward_dynamics"]
    (a, *_), _ = evaluate(replace(program, guards=()), given)
    (b,), _ = evaluate(other, given)
    apart = np.abs(a - b).max(axis=1)
    assert (apart > 0).any() and (apart < 1e-13 * (1 + np.abs(a).max(axis=1))).all()


def test_near_singular_places_the_second_path_stays(bars: Model) -> None:
    """Towards the place where the pivot is zero roundings grow, what is off is refused, the rest is believed."""
    made = plant(bars)
    turn = {"A0": 1.0, "B0": -1.0, "A1": 1.0}
    away = 10.0 ** -np.arange(0.5, 9.0, 0.5)
    q = np.array([[turn[c.joint] * (np.pi / 2 - d) for c in bars.system.tree.q] for d in away])
    least, apart, off = judged(made, q, np.array([[turn[c.joint] for c in bars.system.tree.v]] * len(q)))
    assert least[0] > 1 and apart[0] < 1 and least[3] < 1 and apart[3] < 1  # a small pivot, and no worse for it
    assert (off[apart < 1] < APART).all()
    assert off.max() > 1e3 * APART and (apart[away < 1e-4] > 1).all()
    assert np.all(apart[away < 1e-3] * away[away < 1e-3] > 1e-4)  # as the inverse of the distance, and no luck


def test_a_run_asks_both_roundings(bars: Model) -> None:
    """The C of a run with a second path has the trial; one without loops has nothing of it."""
    assert "slopes_turned" in source(plant(bars)) and "as_usual(a, turned)" in source(plant(bars))
    builder = MechanismBuilder("swing")
    builder.body("bob", mass=1, com=[1, 0, 0], inertia=[0, "1/12", "1/12"])
    builder.joint("A", "R", parent="base", child="bob", point=[0, 0, 0], axes=[[0, 0, 1]])
    open_chain = plant(derive(builder.build(), [Gravity((0, "-9.81", 0))]))
    assert trial(open_chain) is None and "as_usual" not in source(open_chain)


@pytest.mark.slow
def test_small_pivots_are_believed_where_they_are_sound() -> None:
    """A delta that hangs: its pivots are a hundredth of the usual, and the accelerations as good as elsewhere."""
    scene = load_scene(DELTA)
    model, made = prepare(scene)
    arms = [(1.6731, 1.72342, 1.6731), (1.705, 1.71, 1.7)]
    states = [initial_state(_start(scene, angles), model, made.parameters) for angles in arms]
    q, v = (np.array([state[k] for state in states]) for k in range(2))
    least, apart, off = judged(made, q, v)
    assert (least < 1).all()  # by the size of the pivots alone all of them would go to the second path
    assert (apart[1:] < 0.5).all() and (off[1:] < 5).all()  # and only some of them should
    assert apart[0] > 1 and off[0] > APART


def _start(scene: Scene, arms: tuple[float, ...]) -> Scene:
    names = ("arm1_R", "arm2_R", "arm3_R")
    rates = dict(zip(names, (0.3, -0.1, 0.3), strict=True))
    return replace(scene, initial=replace(scene.initial, coordinates=dict(zip(names, arms, strict=True)), rates=rates))

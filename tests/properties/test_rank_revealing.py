"""The second path of forward dynamics: right where a pivot of the first one vanishes, and honest where rank is lost."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from support.model_states import model, relative
from support.second_path import FUNCTIONS, LIMIT, always_second, states

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.model import derive
from symscrew.program.numpy_evaluation import evaluate

pytestmark = pytest.mark.slow

NAMES = ("four_bar", "bennett", "sarrus", "three_ups_upu_s", "delta", "stewart_6ups", "andrews", "five_bar")


@pytest.mark.parametrize("name", NAMES)
def test_both_paths_agree(name: str) -> None:
    """Minimum-norm reactions of overconstrained mechanisms included: two ways to the same numbers."""
    found = model(name)
    inputs = states(found)
    for function in FUNCTIONS:
        first, status = found(function, *inputs)
        second, other = always_second(found)(function, *inputs)
        assert not status.any() and (other == -1).all()
        assert all(relative(b, a) < LIMIT for a, b in zip(first, second, strict=True)), function


def test_a_bad_choice_of_coordinates_costs_no_accuracy() -> None:
    """At the rocker's turning point the crank is no function of the rocker, yet the motion is regular."""
    mechanism = catalogue.load("four_bar")
    good = derive(mechanism)
    tree = good.system.tree
    rocker = "D"
    bad = derive(mechanism, independent=[rocker])

    def speed(angle: float) -> float:
        """Rate of the rocker per unit rate of the crank; zero at the turning point."""
        (q,), status = good("assemble", [angle], good.system.reference)
        assert not status
        (v,), _ = good("velocity", q, [1.0])
        return float(v[[c.label for c in tree.v].index(rocker)])

    start = float(good.system.reference[good.programs["assemble"].independent[0]])
    angles = np.linspace(start, start + 2 * np.pi, 200)
    values = [speed(x) for x in angles]
    k = next(i for i in range(199) if values[i] * values[i + 1] < 0)
    low, high = angles[k], angles[k + 1]
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if speed(middle) * speed(low) > 0 else (low, middle)
    (q,), _ = good("assemble", [low], good.system.reference)
    (v,), _ = good("velocity", q, [2.0])
    (expected,), status = good("forward_dynamics", q, v, [3.0])
    assert status == 0
    (got,), status = bad("forward_dynamics", q, v, [3.0])
    assert status == -1 and relative(got, expected) < 1e-10
    without = dataclasses.replace(bad.programs["forward_dynamics"], guards=())
    (lost,), _ = evaluate(without, [q, v, [3.0]])
    assert not relative(lost, expected) < 1e-6  # what the guard is for


def parallelogram() -> Mechanism:
    builder = MechanismBuilder("parallelogram", platform="rocker")
    for name, com in (("crank", [0, 0, 0.5]), ("coupler", [0.5, 0, 1]), ("rocker", [1, 0, 0.5])):
        builder.body(name, mass=1, com=com, inertia=[0.1, 0.1, 0.1])
    links = (("A", "base", "crank", 0, 0), ("B", "crank", "coupler", 0, 1), ("C", "coupler", "rocker", 1, 1))
    for name, parent, child, x, z in (*links, ("D", "base", "rocker", 1, 0)):
        builder.joint(name, "R", parent=parent, child=child, point=[x, 0, z], axes=[[0, 1, 0]], driven=name == "A")
    return builder.build()


def test_lost_rank_is_reported() -> None:
    """A parallelogram laid flat: the closure loses rank, which the status says, and nothing is NaN."""
    found = derive(parallelogram())
    turns = {"A": np.pi / 2, "B": -np.pi / 2, "C": np.pi / 2, "D": np.pi / 2}
    q = np.array([turns[c.label] for c in found.system.tree.q])
    (opening, *_), _ = found("closure", q)
    assert np.abs(opening).max() < 1e-15
    still = np.zeros(len(found.system.tree.v))
    for function in FUNCTIONS:
        results, status = found(function, q, still, [1.0])
        assert status == -2 and all(np.isfinite(x).all() for x in results)
        results, status = found(function, q, np.full(len(still), np.nan), [1.0])
        assert status == 2 and all(np.isnan(x).all() for x in results)
    (a,), status = found(
        "forward_dynamics", q - 1e-4 * np.array([turns[c.label] for c in found.system.tree.q]), still, [1.0]
    )
    assert status <= 0 and np.isfinite(a).all()

"""Every way to the accelerations of a closed chain gives the same: by columns of the null space and handed on."""

from __future__ import annotations

import numpy as np
import pytest
import sympy
from support.gauss_principle import at, gauss
from support.model_states import body_states

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.dynamics import Admissible
from symscrew.effects import Acting, Gravity
from symscrew.effects.effect import system_under
from symscrew.functions.loop_choice import fewest_operations
from symscrew.model import derive
from symscrew.reference.maximal_coordinates import numeric

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
SLANT = ("3/5", 0, "4/5")
LIMBS = {
    "PUS": ([(1, 0, 0), ("11/10", "-1/10", "3/10"), ("1/2", "1/10", "11/10")], [[X], [Y, Z], []]),
    "URS": ([(1, 0, 0), ("9/8", "1/8", "3/10"), ("1/2", "1/10", "11/10")], [[X, Z], [Y], []]),
    "URU": ([(1, 0, 0), ("13/10", 0, "1/2"), ("1/2", 0, 1)], [[Z, Y], [Y], [Y, Z]]),
    "RUU": ([(1, 0, 0), ("13/10", "1/10", "1/2"), ("1/2", 0, 1)], [[Y], [Y, SLANT], [Y, SLANT]]),
}


def on_three(kind: str) -> Mechanism:
    """A platform on three equal limbs, a third of a turn apart, with bodies that are symmetric about nothing."""
    points, axes = LIMBS[kind]
    builder = MechanismBuilder(f"three_{kind.lower()}", platform="top")
    builder.body("top", mass=3, com=[0, "1/7", 1], inertia=["1/10", "1/9", "1/5"])
    for k in range(3):
        c, s = sympy.cos(2 * sympy.pi * k / 3), sympy.sin(2 * sympy.pi * k / 3)
        places, turned = ([_about_z(p, c, s) for p in points], [[_about_z(a, c, s) for a in own] for own in axes])
        builder.limb(
            f"leg{k + 1}", kind, base="base", tip="top", points=places, axes=turned, mass=[1, 1],
            com=[[x + sympy.Rational(1, 10) for x in place] for place in places[:2]],
            inertia=[["1/100", "1/90", "1/80"]] * 2,
        )  # fmt: skip
    return builder.build()


def _about_z(given: tuple, c: sympy.Expr, s: sympy.Expr) -> list[sympy.Expr]:
    x, y, z = (sympy.Rational(str(value)) for value in given)
    return [x * c - y * s, x * s + y * c, z]


@pytest.mark.parametrize("kind", LIMBS)
def test_all_ways_agree(kind: str) -> None:
    """Without: what came to a velocity component that waited for its partner was lost, and the shorter way, which a
    model takes, was off by 1e-3 to 1e-2."""
    effects = (Gravity(),)
    system = system_under(on_three(kind), effects)
    system.use_samples()
    acting, loops = Acting(system, effects), fewest_operations(system, effects, None).dynamics
    q, v, _ = system.sample_states
    inputs = (system.inputs.q, q), (system.inputs.v, v)
    ways = [system.numeric(a, *inputs) for _, a, _ in Admissible(system, loops, acting.added_inertia).ways(acting)]
    assert len(ways) > 1
    for way in ways[1:]:
        assert np.abs(way - ways[0]).max() < 1e-10 * np.abs(ways[0]).max()


@pytest.mark.parametrize("kind", ["PUS", "URU"])
def test_accelerations_are_those_of_maximal_coordinates(kind: str) -> None:
    found = derive(on_three(kind), [Gravity()])
    q, v, _ = found.system.sample_states
    inputs = {"q": q, "v": v, "u": np.zeros((len(q), len(found.system.drives)))}
    (a,), status = found("forward_dynamics", *[inputs[p.name] for p in found.programs["forward_dynamics"].inputs])
    assert not status.any()
    state = at(body_states(found, q, v, a), 1)
    for body, rate in gauss(numeric(found.mechanism), state, 0.0).items():
        assert np.abs(state[body].twist_rate - rate).max() < 1e-9

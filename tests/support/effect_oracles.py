"""Effects as loads on bodies, for method B: joint forces, point forces and inertial forces by hand formulas.

Everything is taken from the states of the bodies, nothing from the derivation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from support.model_states import body_states, relative
from symscrew import catalogue
from symscrew import effects as known
from symscrew.description.mechanism import Mechanism
from symscrew.effects.effect import Effect, transformed
from symscrew.functions.dynamic import Equations
from symscrew.functions.ports import a_port, function, q_port, v_port
from symscrew.kinematics.system import System
from symscrew.model import Model, derive
from symscrew.program.lowering import lower
from symscrew.reference.joint_motion import joint_displacements, joint_rates
from symscrew.reference.maximal_coordinates import BodyState, cross, joint_screws, numeric, stack_states
from symscrew.reference.newton_euler_method import newton_euler

Loads = dict[str, np.ndarray]
EXACT = 1e-10
G = (0.0, 0.0, -9.81)
CRANK = "slider_crank"  # crank_R drives, slider_P slides, slider_R closes the loop


class Oracle:
    """States of a model's bodies and what method B makes of them under further loads."""

    def __init__(self, found: Model, states: Mapping[str, BodyState] | None = None) -> None:
        self.mechanism = found.mechanism
        self.q, self.v, self.a = found.system.sample_states
        self.states = states or body_states(found, self.q, self.v, self.a)
        self.numbers = numeric(found.mechanism)
        self.screws = joint_screws(self.numbers, stack_states(self.numbers, self.states))

    def displacement(self, joint: str, freedom: int = 0) -> np.ndarray:
        return joint_displacements(self.numbers, self.states)[joint][:, freedom]

    def rate(self, joint: str, freedom: int = 0) -> np.ndarray:
        return joint_rates(self.numbers, self.states)[joint][:, freedom]

    def along(self, joint: str, force: np.ndarray, freedom: int = 0) -> Loads:
        """A force on a joint's freedom as wrenches on its two bodies."""
        j = self.numbers.joints.index(joint)
        index = self.numbers.freedoms[j][freedom]
        axis, point = self.screws.axis[:, index], self.screws.point[:, j]
        along = axis * np.broadcast_to(force, len(axis))[:, None]
        still = np.zeros_like(along)
        turning = self.numbers.turns[index] > 0
        wrench = np.concatenate([still, along] if turning else [along, cross(point, along)], axis=-1)
        given = self.mechanism.joints[joint]
        return {given.child: wrench, given.parent: -wrench}

    def place(self, point: str) -> np.ndarray:
        given = self.mechanism.points[point]
        at = np.array([float(self.mechanism.number(c)) for c in given.at])
        if given.body not in self.states:
            return np.broadcast_to(at, (len(self.q), 3))
        state = self.states[given.body]
        return state.rotation @ at + state.translation

    def velocity(self, point: str) -> np.ndarray:
        body = self.mechanism.points[point].body
        if body not in self.states:
            return np.zeros((len(self.q), 3))
        return self.states[body].velocity_at(self.place(point))

    def at(self, point: str, force: np.ndarray, moment: np.ndarray | float = 0.0) -> Loads:
        """A force and a moment at a named point, absolute axes."""
        force = np.broadcast_to(force, (len(self.q), 3))
        wrench = np.concatenate([force, cross(self.place(point), force) + moment], axis=-1)
        return {self.mechanism.points[point].body: wrench}

    def inertial(self, body: str, mass: float, com: np.ndarray, inertia: np.ndarray, gravity=(0, 0, 0)) -> Loads:
        """Inertial force, gyroscopic couple and weight of a mass that is fixed to a body, acting on the body."""
        state = self.states[body]
        place = state.rotation @ np.asarray(com) + state.translation
        turned = state.rotation @ np.asarray(inertia) @ np.swapaxes(state.rotation, -1, -2)
        omega, alpha = state.twist[:, :3], state.twist_rate[:, :3]
        spun = np.einsum("nij,nj->ni", turned, omega)
        force = -mass * (state.acceleration_at(place) - np.asarray(gravity))
        moment = -np.einsum("nij,nj->ni", turned, alpha) - cross(omega, spun)
        return {body: np.concatenate([force, cross(place, force) + moment], axis=-1)}

    def solve(self, *loads: Loads, gravity=(0, 0, 0), states: Mapping[str, BodyState] | None = None):
        """Method B under all these loads."""
        total: Loads = {}
        for some in loads:
            for body, wrench in some.items():
                if body != self.mechanism.ground:
                    total[body] = total.get(body, 0) + wrench
        return newton_euler(self.numbers, states or self.states, gravity=gravity, loads=total)


def at_rest(states: Mapping[str, BodyState]) -> dict[str, BodyState]:
    return {b: replace(s, twist=0 * s.twist, twist_rate=0 * s.twist_rate) for b, s in states.items()}


def inputs(found: Model, function: str, **given: object) -> list[np.ndarray]:
    """The test inputs of a function with some of them replaced."""
    ports = [p.name for p in found.programs[function].inputs]
    assert set(given) <= set(ports), (set(given) - set(ports), ports)
    arrays = dict(zip(ports, found.test_inputs[function], strict=True))
    for name, value in given.items():
        arrays[name] = np.broadcast_to(np.asarray(value, dtype=float), arrays[name].shape)
    return [arrays[name] for name in ports]


def call(found: Model, function: str, **given: object) -> np.ndarray:
    """The first output of a function at its test inputs, some of them replaced; every status is 0."""
    results, status = found(function, *inputs(found, function, **given))
    assert np.all(status == 0), status
    return results[0]


def input_of(found: Model, function: str, name: str) -> np.ndarray:
    """A test input of a function."""
    ports = [p.name for p in found.programs[function].inputs]
    return found.test_inputs[function][ports.index(name)]


def inverse_only(mechanism: Mechanism, effects: Sequence[Effect]) -> Model:
    """A model with inverse dynamics only: a tenth of the time of all functions."""
    system = System(mechanism, transformed(mechanism, tuple(effects)))
    system.use_samples()
    equations = Equations(system, effects)
    q, v, a = system.sample_states
    state = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), (a_port(system), system.inputs.a)]
    ports = [*state, *equations.forces.inputs]
    program = lower(
        function(system, "inverse_dynamics", "", inputs=ports, outputs=[equations.command(equations.solution)])
    )
    random = np.random.default_rng(7)
    arrays = [q, v, a, *(random.uniform(-1, 1.5, (len(q), p.size)) for p in program.inputs[3:])]
    given = {"p": np.repeat(system.parameter_values[None, :], len(q), 0)}
    arrays = [given.get(p.name, x) for p, x in zip(program.inputs, arrays, strict=True)]
    return Model(
        mechanism.name, mechanism, tuple(effects), {program.name: program}, {program.name: tuple(arrays)}, system
    )


__all__ = ["Oracle", "at_rest", "call", "input_of", "inputs", "inverse_only", "relative"]


def effect(name: str, *args: object, **fields: object) -> Effect:
    return getattr(known, name)(*args, **fields)


@cache
def with_effects(mechanism: str, *effects: Effect) -> Model:
    return derive(catalogue.load(mechanism), effects)


@cache
def oracle(mechanism: str) -> Oracle:
    return Oracle(with_effects(mechanism))


@cache
def inverse(mechanism: str, *effects: Effect) -> Model:
    return inverse_only(catalogue.load(mechanism), effects)


def drives(found: Model, **given: object) -> np.ndarray:
    return call(found, "inverse_dynamics", **given)

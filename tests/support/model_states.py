"""Models of all test mechanisms and their states in the form of method B."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
from oracles import mechanisms

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.model import Model, derive
from symscrew.reference.maximal_coordinates import BodyState

HAND_TYPED = {"spatial_loop": mechanisms.spatial_loop, "mixed_loop": mechanisms.mixed_loop}
ALL = (*catalogue.names(), *HAND_TYPED)


@cache
def model(name: str) -> Model:
    if name == "pendulum":
        return pendulum()
    return derive(HAND_TYPED[name]() if name in HAND_TYPED else catalogue.load(name))


@cache
def pendulum() -> Model:
    """A rod of mass 1.5 kg and length 0.5 m, both run-time parameters, about y; u = m g l/2 sin(q) at rest."""
    builder = MechanismBuilder("pendulum")
    builder.parameter("length", "0.5", unit="m", description="length of the rod", run_time=True)
    builder.parameter("mass", "1.5", unit="kg", run_time=True)
    builder.body("rod", mass="mass", com=[0, 0, "-length/2"], inertia=["mass*length^2/12", "mass*length^2/12", 0])
    builder.joint("pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    return derive(builder.build())


@cache
def differentiated(name: str) -> Model:
    """The model with derivatives."""
    return derive(HAND_TYPED[name]() if name in HAND_TYPED else catalogue.load(name), derivatives=True)


def run(name: str, function: str, *arguments: np.ndarray) -> np.ndarray:
    """The first output of a function; every status must be 0."""
    results, status = model(name)(function, *arguments)
    assert np.all(status == 0), f"{name}.{function}: status {status}"
    return results[0]


def output(found: Model, function: str, port: str, *arguments: np.ndarray) -> np.ndarray:
    """A named output of a function; every status must be 0."""
    results, status = found(function, *arguments)
    assert np.all(status == 0)
    names = [p.name for p in found.programs[function].outputs]
    return results[names.index(port)]


def body_states(found: Model, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> dict[str, BodyState]:
    """States of all bodies from the model's poses, twists and twist rates."""
    bodies = [b for b in found.mechanism.bodies if b != found.mechanism.ground]
    poses = output(found, "body_poses", "poses", q).reshape(len(q), -1, 12)
    twists = output(found, "body_twists", "twists", q, v).reshape(len(q), -1, 6)
    rates = output(found, "body_twist_rates", "twist_rates", q, v, a).reshape(len(q), -1, 6)
    return {
        body: BodyState(
            poses[:, k, :9].reshape(-1, 3, 3).transpose(0, 2, 1), poses[:, k, 9:], twists[:, k], rates[:, k]
        )
        for k, body in enumerate(bodies)
    }


def relative(got: np.ndarray, expected: np.ndarray) -> float:
    """Largest difference relative to the largest expected magnitude."""
    return float(np.abs(got - expected).max(initial=0.0) / max(np.abs(expected).max(initial=0.0), 1e-30))


def by_joint(port_values: np.ndarray, names: list[str]) -> Mapping[str, np.ndarray]:
    return {name: port_values[:, 6 * k : 6 * k + 6] for k, name in enumerate(names)}
